// SPDX-License-Identifier: GPL-3.0-or-later

#include <tan/query.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

bool sameRange(const ValueRange& one, const ValueRange& other)
{
    return one.minimum == other.minimum && one.maximum == other.maximum;
}

bool sameAccuracy(const Accuracy& one, const Accuracy& other)
{
    return one.error == other.error && one.warping == other.warping;
}

} // namespace

bool operator==(const LifeRange& first, const LifeRange& second)
{
    return sameAccuracy(first.one, second.one) && sameAccuracy(first.other, second.other) &&
           sameRange(first.births, second.births) && sameRange(first.deaths, second.deaths);
}

bool operator==(const MeshQuery& first, const MeshQuery& second)
{
    return first.error == second.error && first.warping == second.warping && first.budget == second.budget &&
           std::ranges::equal(first.values, second.values, sameRange) && first.window == second.window &&
           first.method == second.method && first.range == second.range;
}

namespace {

Error wrong(const Message& text)
{
    return {ErrorKind::WrongUsage, text};
}

Status checkWindow(const Box& box)
{
    constexpr std::array<const char*, 3> axes = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis)
        if (!(box.least[axis] <= box.largest[axis]))
            return wrong(Message::say("The smallest %1 of the crop box, %2, is larger than its largest, %3. Swap them.",
                                      axes[static_cast<std::size_t>(axis)], formatNumber(box.least[axis]),
                                      formatNumber(box.largest[axis])));
    return {};
}

Status checkRange(const MeshQuery& query)
{
    const LifeRange& range = *query.range;
    for (const Accuracy& end : {range.one, range.other})
        if (std::isnan(end.error) || std::isnan(end.warping))
            return wrong(Message::say("An end of the range of accuracies is not a number. Give both in percent."));
    for (const ValueRange& lives : {range.births, range.deaths})
        if (!(lives.minimum <= lives.maximum))
            return wrong(Message::say("A range of births or deaths goes from a smaller error to a larger one: %1 and "
                                      "%2 do not.",
                                      formatNumber(lives.minimum), formatNumber(lives.maximum)));
    if (query.budget)
        return wrong(Message::say("A budget is for one mesh, and a range of accuracies has many. Leave one of the two "
                                  "out."));
    if (query.window && query.window->border == WindowBorder::Clipped)
        return wrong(Message::say("Meshes of several accuracies cannot be cut at a window: what is cut has no life of "
                                  "its own. Ask for the tetrahedra that intersect the window, or that it contains."));
    return {};
}

Status checkField(const ErrorField& field, const Message& refusal)
{
    const ValueRange bounds = field.bounds();
    if (std::isnan(bounds.minimum) || std::isnan(bounds.maximum))
        return wrong(refusal);
    return {};
}

} // namespace

Status checkQuery(const Model& model, const MeshQuery& query)
{
    const Status error = checkField(
        query.error, Message::say("The largest error is not a number somewhere. Give it in percent everywhere."));
    if (!error)
        return error;
    const Status warping = checkField(
        query.warping, Message::say("The largest warping is not a number somewhere. Give it in percent everywhere."));
    if (!warping)
        return warping;
    if (query.budget == 0)
        return wrong(Message::say("A budget of no tetrahedra allows no mesh of '%1'.", model.path().string()));
    for (const ValueRange& range : query.values)
        if (!(range.minimum <= range.maximum))
            return wrong(Message::say("A range of values goes from a smaller number to a larger one: %1 and %2 do not.",
                                      formatNumber(range.minimum), formatNumber(range.maximum)));
    if (const Status range = query.range ? checkRange(query) : Status(); !range)
        return range;
    return query.window ? checkWindow(query.window->box) : Status();
}

double scaleReached(const MeshSize& size, const Accuracy& asked)
{
    const auto over = [](double reached, double wanted) {
        if (reached <= wanted || std::isnan(wanted))
            return 1.0;
        return std::max(1 + std::numeric_limits<double>::epsilon(), reached / std::max(wanted, leastScaledPercent));
    };
    return std::max(over(size.error, asked.error), over(size.warping, asked.warping));
}

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
    if (ramp == nullptr || std::holds_alternative<HalfSpace>(ramp->region) || query.budget || query.range)
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
