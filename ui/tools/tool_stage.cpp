// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_stage.h"

#include "core/picture/kept_tools.h"
#include "core/view/view_value.h"
#include "ui/session/annotation_language.h"

#include <utility>

namespace tetra {

ToolStage::ToolStage(std::string tool, const Session& session, std::vector<Parameter> parameters)
    : tool_(std::move(tool)), model_(session.model()), view_(session.view()), parameters_(std::move(parameters))
{
    if (const auto kept = view_.tools.find(tool_); kept != view_.tools.end())
        value_ = kept->second;
}

ToolSurroundings ToolStage::surroundings(const Camera& camera, QSizeF size) const
{
    return {.view = view_,
            .model = model_->description(),
            .value = value_,
            .parameters = parameters_,
            .camera = camera,
            .width = size.width(),
            .height = size.height(),
            .number = numbersOf(annotationLanguage())};
}

std::optional<ViewValue> ToolStage::after(const ToolAnswer& answer, const ViewValue& present) const
{
    if (!answer.view && !answer.value)
        return std::nullopt;
    ViewValue view = present;
    if (answer.view)
        view = PartialView(*answer.view, differingParts(view_, *answer.view)).putInto(std::move(view));
    if (answer.value)
        view.tools[tool_] = *answer.value;
    return view;
}

ViewValue ToolStage::before(const ViewValue& present) const
{
    const ViewParts changed = differingParts(view_, present) & ~ViewParts(ViewPart::Camera);
    return PartialView(view_, changed).putInto(present);
}

Eigen::Vector3d inPlaneThrough(const Eigen::Vector3d& place, const ViewProjection& projection, QPointF pixel)
{
    const PickingRay line = projection.pickingRay(pixel);
    const Eigen::Vector3d normal = projection.towardsViewer();
    const double along = line.direction.dot(normal); // not zero: less than a right angle off
    return line.at((place - line.origin).dot(normal) / along);
}

ToolPointer pointerAt(const ViewProjection& projection, const Camera& camera, QPointF pixel)
{
    const PickingRay line = projection.pickingRay(pixel);
    ToolPointer pointer;
    pointer.pixel = {pixel.x(), pixel.y()};
    pointer.origin = line.origin;
    pointer.direction = line.direction;
    pointer.place = inPlaneThrough(camera.target, projection, pixel);
    return pointer;
}

ToolPointer withSeen(ToolPointer pointer, const SeenThere& seen)
{
    pointer.place = seen.place;
    pointer.seen = seen;
    return pointer;
}

} // namespace tetra
