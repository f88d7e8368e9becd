// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/tool.h"

#include <stdexcept>

/// Throws at each click.
class FailingTool : public tetra::Tool {
public:
    tetra::ToolDrawing drawing(const tetra::ToolSurroundings&) const override { return {}; }
    tetra::ToolAnswer clicked(const tetra::ToolSurroundings&, const tetra::ToolPointer&) const override
    {
        throw std::runtime_error("no ink left");
    }
    tetra::ToolAnswer moved(const tetra::ToolSurroundings&, const tetra::HandleMove&) const override { return {}; }
};

TAN_PLUGIN(FailingTool, tetra::Tool)
