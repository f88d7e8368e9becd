// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/accuracy_scale.h"

#include <tan/view.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tetra {
namespace {

/// The least that a region may measure, as a part of the diagonal: less cannot be seen or grabbed.
constexpr double leastRegionPart = 1e-3;
/// Errors that the budget makes larger are no less than this before it does, %: it is finer than what 16 bits resolve,
/// and what is looked at grows with what is asked for.
constexpr double finestWithBudget = 1e-3;
/// A mesh that varies is never much better anywhere than the uniform one of the same size: this is room enough.
constexpr double roomForScale = 4;

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

/// A further region of a focus, as it is if it is one.
MovableRegion corrected(const MovableRegion& region, const FocusState& usual, const Model& model)
{
    constexpr double slack = 1e-9; // of what was corrected and written
    const double diagonal = model.diagonal();
    const double least = leastRegionPart * diagonal;
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const Eigen::Vector3d around = Eigen::Vector3d::Constant(slack * diagonal);
    FocusState place = usual.movedTo(region);
    const auto fits = [&](double length, double most) {
        return length >= least - around[0] && length <= most + around[0];
    };
    const bool isSphere = std::holds_alternative<Sphere>(region);
    if (Eigen::AlignedBox3d(bounds.min() - around, bounds.max() + around).contains(place.centre) &&
        (isSphere ? fits(place.radius, diagonal)
                  : fits(place.size.minCoeff(), 2 * diagonal) && fits(place.size.maxCoeff(), 2 * diagonal)))
        return region;
    place.centre = numbersOr(place.centre, usual.centre).cwiseMax(bounds.min()).cwiseMin(bounds.max());
    place.size = numbersOr(place.size, usual.size).cwiseMax(least).cwiseMin(2 * diagonal);
    place.radius = std::clamp(numberOr(place.radius, usual.radius), least, diagonal);
    place.shape = isSphere ? FocusState::Shape::Sphere : FocusState::Shape::Box;
    return place.region();
}

FocusState corrected(FocusState focus, const FocusState& before, const Model& model)
{
    const Eigen::AlignedBox3d& bounds = model.description().bounds;
    const double diagonal = model.diagonal();
    focus.centre = numbersOr(focus.centre, before.centre).cwiseMax(bounds.min()).cwiseMin(bounds.max());
    focus.size = numbersOr(focus.size, before.size).cwiseMax(leastRegionPart * diagonal).cwiseMin(2 * diagonal);
    focus.radius = std::clamp(numberOr(focus.radius, before.radius), leastRegionPart * diagonal, diagonal);
    focus.error = std::clamp(numberOr(focus.error, before.error), 0.0, 100.0);
    focus.falloff = std::clamp(numberOr(focus.falloff, before.falloff), 0.0, diagonal);
    focus.distance = std::clamp(numberOr(focus.distance, before.distance), leastRegionPart * diagonal, diagonal);
    const double extent = model.description().range.extent();
    focus.valueFalloff =
        std::clamp(numberOr(focus.valueFalloff, before.valueFalloff), leastRegionPart * extent, extent);
    focus.others.resize(std::min(focus.others.size(), mostFocusRegions - 1), Sphere());
    for (MovableRegion& region : focus.others)
        region = corrected(region, focus, model);
    focus.number = std::min(focus.number, static_cast<std::uint32_t>(focus.others.size()));
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
    const Eigen::Vector3d thickness = Eigen::Vector3d::Constant(leastRegionPart * model.diagonal());
    const Eigen::Vector3d end = largest.cwiseMax(least + thickness).cwiseMin(bounds.max());
    return {least.cwiseMin(end - thickness).cwiseMax(bounds.min()), end};
}

ValueFilter corrected(const ValueFilter& values, const ValueFilter& before, const ValueRange& range)
{
    const double one = std::clamp(numberOr(values.least, before.least), range.minimum, range.maximum);
    const double other = std::clamp(numberOr(values.largest, before.largest), range.minimum, range.maximum);
    return {values.enabled, std::min(one, other), std::max(one, other)};
}

RangeState corrected(RangeState range, const RangeState& before)
{
    const auto bring = [](double& percent, double otherwise) {
        percent = std::clamp(numberOr(percent, otherwise), 0.0, 100.0);
    };
    bring(range.fine, before.fine);
    bring(range.coarse, before.coarse);
    bring(range.bornAbove, before.bornAbove);
    bring(range.bornTo, before.bornTo);
    bring(range.diedFrom, before.diedFrom);
    bring(range.diedTo, before.diedTo);
    // The end that was moved pushes the other one.
    const auto order = [](double& least, double& largest, bool leastMoved) {
        if (least > largest)
            (leastMoved ? largest : least) = leastMoved ? least : largest;
    };
    order(range.fine, range.coarse, range.fine != before.fine);
    order(range.bornAbove, range.bornTo, range.bornAbove != before.bornAbove);
    order(range.diedFrom, range.diedTo, range.diedFrom != before.diedFrom);
    return range;
}

/// What the error varies with; in the same way whatever the numbers are.
ErrorField focusField(const FocusState& focus, double inner, double outer, const Model& model,
                      const PresentView& present)
{
    switch (focus.shape) {
    case FocusState::Shape::None: break;
    case FocusState::Shape::Isovalues:
        return ErrorField::nearValues(present.isovalues, inner, outer, focus.valueFalloff);
    case FocusState::Shape::Opacity: return ErrorField::byOpacity(present.opacity, inner, outer);
    case FocusState::Shape::View:
        if (present.eye)
            return SpaceRamp{Sphere{*present.eye, model.description().bounds.exteriorDistance(*present.eye)}, inner,
                             outer, focus.distance};
        break;
    case FocusState::Shape::Box:
    case FocusState::Shape::Sphere: {
        std::optional<ErrorField> field;
        for (const MovableRegion& region : focus.regions()) {
            const Region place = std::visit([](const auto& shape) { return Region(shape); }, region);
            const ErrorField ramp = SpaceRamp{place, inner, outer, focus.falloff};
            field = field ? smallerOf(*field, ramp) : ramp;
        }
        return *field;
    }
    }
    return outer;
}

/// Of many meshes in place of one.
LifeRange lifeRange(const RangeState& range, const WarpingChoice& warping)
{
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const auto least = [](double percent) { return percent > 0 ? percent : -unlimited; };
    const auto most = [](double percent) { return percent < 100 ? percent : unlimited; };
    return {warping.with(range.fine),
            warping.with(range.coarse),
            {least(range.bornAbove), most(range.bornTo)},
            {least(range.diedFrom), most(range.diedTo)}};
}

} // namespace

std::vector<MovableRegion> FocusState::regions() const
{
    if (!isRegion())
        return {};
    std::vector<MovableRegion> all = others;
    all.insert(all.begin() + std::min<std::ptrdiff_t>(number, std::ssize(all)), region());
    return all;
}

FocusState FocusState::selected(std::uint32_t other) const
{
    std::vector<MovableRegion> all = regions();
    if (other >= all.size() || other == number)
        return *this;
    FocusState result = *this;
    result.shape = std::holds_alternative<Sphere>(all[other]) ? Shape::Sphere : Shape::Box;
    result = result.movedTo(all[other]);
    all.erase(all.begin() + other);
    result.others = std::move(all);
    result.number = other;
    return result;
}

FocusState FocusState::added() const
{
    if (!isRegion() || others.size() + 1 >= mostFocusRegions)
        return *this;
    FocusState result = *this;
    result.others = regions();
    result.number = static_cast<std::uint32_t>(result.others.size());
    result.centre.x() += shape == Shape::Sphere ? radius : size.x() / 2; // so that both are seen
    return result;
}

FocusState FocusState::removed() const
{
    FocusState result = *this;
    if (!isRegion() || others.empty()) {
        result.shape = Shape::None;
        return result;
    }
    const std::uint32_t gone = number;
    result = selected(gone == 0 ? 1 : gone - 1);
    result.others.erase(result.others.begin() + (gone == 0 ? 0 : gone - 1));
    result.number = gone == 0 ? 0 : gone - 1;
    return result;
}

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
    return (kind == RegionKind::Focus && focus.isRegion()) || (kind == RegionKind::Window && window.enabled);
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
        result.focus = focus.removed();
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
    query.focus.distance = model.diagonal() / 2;
    query.focus.valueFalloff = range.extent() / 10;
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
    query.range = corrected(query.range, before.range);
    return query;
}

double focusErrorOf(const QueryState& query)
{
    return std::min(query.focus.error, query.error);
}

MeshQuery meshQuery(const QueryState& query, const Model& model, const PresentView& present)
{
    MeshQuery result;
    if (query.window.enabled)
        result.window = query.window.window;
    if (query.values.enabled)
        result.values = {{query.values.least, query.values.largest}};
    if (query.range.enabled) {
        result.range = lifeRange(query.range, query.warping);
        if (result.window && result.window->border == WindowBorder::Clipped)
            result.window->border = WindowBorder::Intersecting; // what is cut has no life
        return result;
    }
    double inner = focusErrorOf(query);
    double outer = query.error;
    WarpingChoice warping = query.warping;
    if (query.byBudget) {
        result.budget = query.budget;
        const double larger = std::max({query.focus.isOn() ? inner : 0, outer, finestWithBudget});
        const double factor = errorWithin(model, query.budget) / roomForScale / larger;
        inner = std::max(inner * factor, finestWithBudget);
        outer = std::max(outer * factor, finestWithBudget);
        warping.percent = std::max(warping.percent * factor, finestWithBudget);
    }
    const auto fieldOf = [&](double within, double elsewhere) {
        return within < elsewhere ? focusField(query.focus, within, elsewhere, model, present) : ErrorField(elsewhere);
    };
    result.error = focusField(query.focus, inner, outer, model, present);
    if (model.description().warpingWeight > 0)
        result.warping = warping.limit == WarpingLimit::AsError ? result.error
                         : warping.limit == WarpingLimit::None
                             ? ErrorField(anyWarping)
                             : fieldOf(std::min(inner, warping.percent), warping.percent);
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

} // namespace tetra
