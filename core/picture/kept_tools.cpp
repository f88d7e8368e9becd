// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/kept_tools.h"

#include "core/picture/annotations/axis_ticks.h"

#include <utility>

namespace tetra {

ToolNumbers numbersOf(const AnnotationLanguage& language)
{
    return [signs = language.numbers](double number, int digits) { return shortNumber(number, signs, digits); };
}

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
                                      const Camera& camera, const Size& size, const AnnotationLanguage& language)
{
    std::vector<ToolDrawing> drawings;
    for (const Provided<Tool>& tool : tools) {
        const auto kept = view.tools.find(tool.id);
        if (kept == view.tools.end())
            continue;
        ToolDrawing drawing = tool.plugin->drawing({.view = view,
                                                    .model = model,
                                                    .value = kept->second,
                                                    .parameters = parameters,
                                                    .camera = camera,
                                                    .width = size.width,
                                                    .height = size.height,
                                                    .number = numbersOf(language)});
        drawing.handles.clear();
        if (!drawing.lines.empty() || !drawing.points.empty() || !drawing.texts.empty())
            drawings.push_back(std::move(drawing));
    }
    return drawings;
}

} // namespace tetra
