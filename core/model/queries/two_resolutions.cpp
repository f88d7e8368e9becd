// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/two_resolutions.h"

namespace tetra {
namespace {

Box grownBox(const std::variant<Box, Sphere>& region, double margin)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return {box->least.array() - margin, box->largest.array() + margin};
    const Sphere& ball = std::get<Sphere>(region);
    return {ball.centre.array() - (ball.radius + margin), ball.centre.array() + (ball.radius + margin)};
}

/// What a field is far from the ramp, and in its region; the field itself if it is no ramp.
ErrorField outer(const ErrorField& field)
{
    const SpaceRamp* const ramp = field.asSpaceRamp();
    return ramp != nullptr ? ErrorField(ramp->outer) : field;
}
ErrorField inner(const ErrorField& field)
{
    const SpaceRamp* const ramp = field.asSpaceRamp();
    return ramp != nullptr ? ErrorField(ramp->inner) : field;
}

} // namespace

std::optional<TwoResolutions> twoResolutions(const MeshQuery& query)
{
    const SpaceRamp* const ramp = query.error.asSpaceRamp();
    if (ramp == nullptr || std::holds_alternative<HalfSpace>(ramp->region) || query.budget)
        return std::nullopt;
    TwoResolutions result;
    if (const Box* const box = std::get_if<Box>(&ramp->region))
        result.region = *box;
    else
        result.region = std::get<Sphere>(ramp->region);
    result.border = ramp->falloff;
    result.outside = result.inside = query;
    result.outside.error = outer(query.error);
    result.outside.warping = outer(query.warping);
    result.inside.error = inner(query.error);
    result.inside.warping = inner(query.warping);
    Box box = grownBox(result.region, result.border);
    if (query.window) {
        box.least = box.least.cwiseMax(query.window->box.least);
        box.largest = box.largest.cwiseMin(query.window->box.largest).cwiseMax(box.least);
    }
    result.inside.window = Window{box, query.window ? query.window->border : WindowBorder::Intersecting};
    return result;
}

} // namespace tetra
