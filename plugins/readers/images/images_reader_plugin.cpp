// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/readers/images/images_reader.h"

TAN_PLUGIN(tetra::ImagesReader, tetra::Reader)
