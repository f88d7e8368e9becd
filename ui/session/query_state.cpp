// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/query_state.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {
namespace {

/// The least that a region may measure, as a part of the diagonal: less cannot be seen or grabbed.
constexpr double leastPart = 1e-3;
/// Errors that the budget makes larger are no less than this before it does, %: it is finer than what 16 bits resolve,
/// and what is looked at grows with what is asked for.
constexpr double finestWithBudget = 1e-3;
/// A mesh that varies is never much better anywhere than the uniform one of the same size: this is room enough.
constexpr double roomForScale = 4;
/// The round numbers of a decade.
constexpr std::array<double, 6> roundAccuracies{1, 1.5, 2, 3, 5, 7};

double numberOr(double value, double otherwise)
{
    return std::isfinite(value) ? value : otherwise;
}

Eigen::Vector3d numbersOr(const Eigen::Vector3d& values, const Eigen::Vector3d& otherwise)
{
    Eigen::Vector3d result;
    for (int axis = 0; axis < 3; ++axis)
        result[axis] = numberOr(values[axis], otherwise[axis]);
    return result;
}

FocusState corrected(FocusState focus, const FocusState& before, const Model& model)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const double diagonal = model.diagonal();
    focus.centre = numbersOr(focus.centre, before.centre).cwiseMax(bounds.min()).cwiseMin(bounds.max());
    focus.size = numbersOr(focus.size, before.size).cwiseMax(leastPart * diagonal).cwiseMin(2 * diagonal);
    focus.radius = std::clamp(numberOr(focus.radius, before.radius), leastPart * diagonal, diagonal);
    focus.error = std::clamp(numberOr(focus.error, before.error), 0.0, 100.0);
    focus.falloff = std::clamp(numberOr(focus.falloff, before.falloff), 0.0, diagonal);
    return focus;
}

/// Within the bounds, its sides in order, and not flat.
Box corrected(const Box& box, const Box& before, const Model& model)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const Eigen::Vector3d one = numbersOr(box.least, before.least);
    const Eigen::Vector3d other = numbersOr(box.largest, before.largest);
    const Eigen::Vector3d least = one.cwiseMin(other).cwiseMax(bounds.min()).cwiseMin(bounds.max());
    const Eigen::Vector3d largest = one.cwiseMax(other).cwiseMax(bounds.min()).cwiseMin(bounds.max());
    const Eigen::Vector3d thickness = Eigen::Vector3d::Constant(leastPart * model.diagonal());
    const Eigen::Vector3d end = largest.cwiseMax(least + thickness).cwiseMin(bounds.max());
    return {least.cwiseMin(end - thickness).cwiseMax(bounds.min()), end};
}

ValueFilter corrected(const ValueFilter& values, const ValueFilter& before, const ValueRange& range)
{
    const double one = std::clamp(numberOr(values.least, before.least), range.minimum, range.maximum);
    const double other = std::clamp(numberOr(values.largest, before.largest), range.minimum, range.maximum);
    return {values.enabled, std::min(one, other), std::max(one, other)};
}

Region regionOf(const FocusState& focus)
{
    return std::visit([](const auto& region) { return Region(region); }, focus.region());
}

} // namespace

MovableRegion FocusState::region() const
{
    if (shape == Shape::Sphere)
        return Sphere{centre, radius};
    return Box{centre - size / 2, centre + size / 2};
}

FocusState FocusState::movedTo(const MovableRegion& region) const
{
    FocusState result = *this;
    if (const auto* sphere = std::get_if<Sphere>(&region)) {
        result.centre = sphere->centre;
        result.radius = sphere->radius;
    } else {
        const Box& box = std::get<Box>(region);
        result.centre = (box.least + box.largest) / 2;
        result.size = box.largest - box.least;
    }
    return result;
}

bool QueryState::has(RegionKind kind) const noexcept
{
    return (kind == RegionKind::Focus && focus.isOn()) || (kind == RegionKind::Window && window.enabled);
}

MovableRegion QueryState::place(RegionKind kind) const
{
    return kind == RegionKind::Window ? MovableRegion(window.window.box) : focus.region();
}

QueryState QueryState::moved(RegionKind kind, const MovableRegion& place) const
{
    QueryState result = *this;
    if (kind == RegionKind::Focus)
        result.focus = focus.movedTo(place);
    else if (kind == RegionKind::Window)
        result.window.window.box = std::get<Box>(place);
    return result;
}

QueryState QueryState::without(RegionKind kind) const
{
    QueryState result = *this;
    if (kind == RegionKind::Focus)
        result.focus.shape = FocusState::Shape::None;
    else if (kind == RegionKind::Window)
        result.window.enabled = false;
    return result;
}

QueryState startingQuery(const Model& model, double error)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const ValueRange& range = model.description().range;
    QueryState query;
    query.error = error;
    query.focus.centre = bounds.center();
    query.focus.size = bounds.sizes() / 5;
    query.focus.radius = model.diagonal() / 16;
    query.focus.falloff = 0; // the fewest tetrahedra
    // The finest preset that is not more than a quarter: a difference that is seen.
    query.focus.error = 0;
    for (const double preset : accuracyPresets)
        if (preset <= error / 4)
            query.focus.error = std::max(query.focus.error, preset);
    query.window.window.box = {bounds.center() - bounds.sizes() / 4, bounds.center() + bounds.sizes() / 4};
    query.window.window.border = WindowBorder::Clipped;
    query.values = {false, range.minimum, range.maximum};
    return corrected(query, query, model);
}

QueryState corrected(QueryState query, const QueryState& before, const Model& model)
{
    query.error = std::clamp(numberOr(query.error, before.error), 0.0, 100.0);
    query.warping.percent = std::clamp(numberOr(query.warping.percent, before.warping.percent), 0.0, anyWarping);
    query.budget = std::max(query.budget, meshSizeAt(model, bothWithin(100)).tetrahedra);
    query.focus = corrected(query.focus, before.focus, model);
    query.window.window.box = corrected(query.window.window.box, before.window.window.box, model);
    query.values = corrected(query.values, before.values, model.description().range);
    return query;
}

double focusErrorOf(const QueryState& query)
{
    return std::min(query.focus.error, query.error);
}

MeshQuery meshQuery(const QueryState& query, const Model& model)
{
    double inner = focusErrorOf(query);
    double outer = query.error;
    WarpingChoice warping = query.warping;
    MeshQuery result;
    if (query.byBudget) {
        result.budget = query.budget;
        const double larger = std::max({query.focus.isOn() ? inner : 0, outer, finestWithBudget});
        const double factor = errorWithin(model, query.budget) / roomForScale / larger;
        inner = std::max(inner * factor, finestWithBudget);
        outer = std::max(outer * factor, finestWithBudget);
        warping.percent = std::max(warping.percent * factor, finestWithBudget);
    }
    const auto fieldOf = [&query](double within, double elsewhere) {
        return query.focus.isOn() && within < elsewhere
                   ? ErrorField(SpaceRamp{regionOf(query.focus), within, elsewhere, query.focus.falloff})
                   : ErrorField(elsewhere);
    };
    result.error = query.focus.isOn() ? ErrorField(SpaceRamp{regionOf(query.focus), inner, outer, query.focus.falloff})
                                      : ErrorField(outer);
    if (model.description().warpingWeight > 0)
        result.warping = warping.limit == WarpingLimit::AsError ? result.error
                         : warping.limit == WarpingLimit::None
                             ? ErrorField(anyWarping)
                             : fieldOf(std::min(inner, warping.percent), warping.percent);
    if (query.window.enabled)
        result.window = query.window.window;
    if (query.values.enabled)
        result.values = {{query.values.least, query.values.largest}};
    return result;
}

double errorWithin(const Model& model, std::uint64_t budget)
{
    const auto fits = [&](double error) { return meshSizeAt(model, bothWithin(error)).tetrahedra <= budget; };
    if (fits(0))
        return 0;
    double tooFine = finestWithBudget / 10;
    double fine = 100;
    if (fits(tooFine))
        return tooFine;
    while (fine > 1.0001 * tooFine) {
        const double middle = std::sqrt(fine * tooFine);
        (fits(middle) ? fine : tooFine) = middle;
    }
    return fine;
}

MeshSize plannedSize(const QueryState& query, const Model& model)
{
    return meshSizeAt(model,
                      query.byBudget ? bothWithin(errorWithin(model, query.budget)) : query.warping.with(query.error));
}

std::uint64_t steppedBudget(std::uint64_t budget, int steps)
{
    std::vector<double> ladder;
    for (double decade = 1000; decade < 1e10; decade *= 10)
        for (const double number : roundAccuracies)
            ladder.push_back(number * decade);
    const auto count = static_cast<double>(budget);
    auto index = std::ranges::lower_bound(ladder, count) - ladder.begin();
    // Between two round numbers the first step up goes to the next one, not past it.
    if (steps > 0 && index < std::ssize(ladder) && ladder[static_cast<std::size_t>(index)] > count)
        --steps;
    index = std::clamp<std::ptrdiff_t>(index + steps, 0, std::ssize(ladder) - 1);
    return static_cast<std::uint64_t>(ladder[static_cast<std::size_t>(index)]);
}

} // namespace tetra
