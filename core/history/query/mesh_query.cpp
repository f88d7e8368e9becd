// SPDX-License-Identifier: GPL-3.0-or-later

#include <tan/query.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>
#include <vector>

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
            return wrong(Message::say("A range of errors at which tetrahedra appear or disappear goes from a smaller "
                                      "error to a larger one: %1 and %2 do not.",
                                      formatNumber(lives.minimum), formatNumber(lives.maximum)));
    if (query.budget)
        return wrong(Message::say("A budget is for one mesh, and a range of accuracies has many. Leave one of the two "
                                  "out."));
    if (query.window && query.window->border == WindowBorder::Clipped)
        return wrong(Message::say("Clip exactly is not available for meshes of several accuracies. Choose the "
                                  "tetrahedra that intersect the crop box, or those it contains."));
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
        query.error, Message::say("The largest error is not a number everywhere. Give it in percent at every place."));
    if (!error)
        return error;
    const Status warping =
        checkField(query.warping,
                   Message::say("The largest warping is not a number everywhere. Give it in percent at every place."));
    if (!warping)
        return warping;
    if (query.budget == 0)
        return wrong(Message::say("A budget of zero tetrahedra allows no mesh of '%1'.", model.path().string()));
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

Box grownBox(const Region& region, double margin)
{
    if (const Box* const box = std::get_if<Box>(&region))
        return {box->least.array() - margin, box->largest.array() + margin};
    const Sphere& ball = std::get<Sphere>(region);
    return {ball.centre.array() - (ball.radius + margin), ball.centre.array() + (ball.radius + margin)};
}

Region grown(const Region& region, double margin)
{
    const auto* ball = std::get_if<Sphere>(&region);
    return ball != nullptr ? Region(Sphere{ball->centre, ball->radius + margin}) : Region(grownBox(region, margin));
}

/// Adds the ramps of a field that is the smallest of some around boxes and balls; false if it is not.
bool collectRamps(const ErrorField& field, std::vector<SpaceRamp>& ramps)
{
    if (const SpaceRamp* const ramp = field.asSpaceRamp()) {
        ramps.push_back(*ramp);
        return !std::holds_alternative<HalfSpace>(ramp->region);
    }
    const auto* pair = std::get_if<ErrorField::Node::Pair>(&field.root().content);
    return pair != nullptr && pair->operation == FieldOperation::Smaller && collectRamps(pair->first, ramps) &&
           collectRamps(pair->second, ramps);
}

/// The ramps if they are one number far away; else none.
std::vector<SpaceRamp> rampsOf(const ErrorField& field)
{
    std::vector<SpaceRamp> ramps;
    const bool isMade = collectRamps(field, ramps);
    const bool fits =
        isMade && std::ranges::all_of(ramps, [&](const SpaceRamp& ramp) { return ramp.outer == ramps.front().outer; });
    return fits ? ramps : std::vector<SpaceRamp>();
}

/// What a field is far from its ramps, and what it is in their regions and borders: of one region the number that it is
/// there, of several a field, so that what lies between them is no finer than outside. The field itself if it is not
/// made of ramps.
ErrorField outer(const ErrorField& field)
{
    const auto ramps = rampsOf(field);
    return ramps.empty() ? field : ErrorField(ramps.front().outer);
}
ErrorField inner(const ErrorField& field)
{
    const auto ramps = rampsOf(field);
    if (ramps.empty())
        return field;
    if (ramps.size() == 1)
        return ramps.front().inner;
    ErrorField all = ramps.front().outer;
    for (const SpaceRamp& ramp : ramps)
        all = smallerOf(all, SpaceRamp{grown(ramp.region, ramp.falloff), ramp.inner, ramp.outer, 0});
    return all;
}

} // namespace

std::optional<TwoResolutions> twoResolutions(const MeshQuery& query)
{
    const std::vector<SpaceRamp> ramps = rampsOf(query.error);
    if (ramps.empty() || query.budget || query.range)
        return std::nullopt;
    TwoResolutions result;
    Eigen::AlignedBox3d bounds;
    for (const SpaceRamp& ramp : ramps) {
        const auto* ball = std::get_if<Sphere>(&ramp.region);
        using Shape = std::variant<Box, Sphere>;
        result.regions.push_back({ball != nullptr ? Shape(*ball) : Shape(std::get<Box>(ramp.region)), ramp.falloff});
        const Box box = grownBox(ramp.region, ramp.falloff);
        bounds.extend(box.least);
        bounds.extend(box.largest);
    }
    result.outside = result.inside = query;
    result.outside.error = outer(query.error);
    result.outside.warping = outer(query.warping);
    result.inside.error = inner(query.error);
    result.inside.warping = inner(query.warping);
    Box box{bounds.min(), bounds.max()};
    if (query.window) {
        box.least = box.least.cwiseMax(query.window->box.least);
        box.largest = box.largest.cwiseMin(query.window->box.largest).cwiseMax(box.least);
    }
    result.inside.window = Window{box, query.window ? query.window->border : WindowBorder::Intersecting};
    return result;
}

} // namespace tetra
