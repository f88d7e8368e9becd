// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/cells/cells_reader.h"

TAN_PLUGIN(tetra::CellsReader, tetra::Reader)
