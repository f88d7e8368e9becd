// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/meshio/meshio_reader.h"

TAN_PLUGIN(tetra::MeshioReader, tetra::Reader)
