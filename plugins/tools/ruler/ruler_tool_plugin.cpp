// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/tools/ruler/ruler_tool.h"

TAN_PLUGIN(tetra::RulerTool, tetra::Tool)
