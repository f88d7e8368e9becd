// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/zarr/zarr_reader.h"

TAN_PLUGIN(tetra::ZarrReader, tetra::Reader)
