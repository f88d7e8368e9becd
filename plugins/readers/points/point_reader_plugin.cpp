// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/points/point_reader.h"

TAN_PLUGIN(tetra::PointReader, tetra::Reader)
