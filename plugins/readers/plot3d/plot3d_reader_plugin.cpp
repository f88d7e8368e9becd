// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/plot3d/plot3d_reader.h"

TAN_PLUGIN(tetra::Plot3dReader, tetra::Reader)
