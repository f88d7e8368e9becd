// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/builders/decimation/decimation_builder.h"

TAN_PLUGIN(tetra::DecimationBuilder, tetra::Builder)
