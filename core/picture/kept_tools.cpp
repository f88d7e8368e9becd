// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/kept_tools.h"

namespace tetra {

std::vector<Provided<Tool>> keptTools(PluginHost& host, const ViewValue& view)
{
    std::vector<Provided<Tool>> tools;
    for (const auto& [id, value] : view.tools)
        if (const auto tool = host.tool(id))
            tools.push_back(*tool);
    return tools;
}

std::vector<ToolDrawing> keptDrawings(const std::vector<Provided<Tool>>& tools, const ModelDescription& model,
                                      const std::vector<Parameter>& parameters, const ViewValue& view,
                                      const Camera& camera, const Size& size)
{
    std::vector<ToolDrawing> drawings;
    for (const Provided<Tool>& tool : tools) {
        const auto kept = view.tools.find(tool.id);
        if (kept == view.tools.end())
            continue;
        drawings.push_back(tool.plugin->drawing({.view = view,
                                                 .model = model,
                                                 .value = kept->second,
                                                 .parameters = parameters,
                                                 .camera = camera,
                                                 .width = size.width,
                                                 .height = size.height}));
        drawings.back().handles.clear();
    }
    return drawings;
}

} // namespace tetra
