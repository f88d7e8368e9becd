// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/tools/plane/plane_tool.h"

TAN_PLUGIN(tetra::PlaneTool, tetra::Tool)
