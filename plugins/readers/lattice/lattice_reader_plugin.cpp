// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/lattice/lattice_reader.h"

TAN_PLUGIN(tetra::LatticeReader, tetra::Reader)
