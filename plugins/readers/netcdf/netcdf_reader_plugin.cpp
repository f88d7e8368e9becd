// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/netcdf/netcdf_reader.h"

TAN_PLUGIN(tetra::NetCdfReader, tetra::Reader)
