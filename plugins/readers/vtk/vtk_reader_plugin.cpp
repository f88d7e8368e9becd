// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/vtk/vtk_reader.h"

TAN_PLUGIN(tetra::VtkReader, tetra::Reader)
