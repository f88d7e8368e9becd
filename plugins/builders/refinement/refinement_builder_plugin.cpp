// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/builders/refinement/refinement_builder.h"

TAN_PLUGIN(tetra::RefinementBuilder, tetra::Builder)
