// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/hdf5/hdf5_reader.h"

TAN_PLUGIN(tetra::Hdf5Reader, tetra::Reader)
