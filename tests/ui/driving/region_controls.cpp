// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Focus and Region are driven, and what each changes (R14, R24, R25, S17).
#include "tests/ui/driving/driver.h"

namespace tetra {
namespace {

using Shape = FocusState::Shape;

/// With a focus that is not where it is at first.
Driver::Step withFocus(Shape shape)
{
    return [shape](DrivenWindow& window) {
        FocusState focus = window.session().view().query.focus;
        focus.shape = shape;
        focus.centre *= 0.5;
        window.session().setFocus(focus);
        window.raise("dock.focus");
    };
}

/// A part of the focus, with a focus of this shape.
Driver ofFocus(const QString& name, Shape shape, const std::function<void(FocusState&)>& change)
{
    return edit(
        "focus." + name, [change](ViewValue& view, const DrivenWindow&) { change(view.query.focus); },
        withFocus(shape));
}

Driver toShape(const QString& name, Shape before, Shape after)
{
    return ofFocus(name, before, [after](FocusState& focus) { focus.shape = after; });
}

template <class Reach> Driver steps(const QString& name, const Driver::Step& prepare, Reach reach, const Ends& ends)
{
    return edit(name, moves(reach, stepOfBox(name, hundredthOf(ends))), prepare);
}

template <class Reach> Driver slides(const QString& name, const Driver::Step& prepare, Reach reach, const Ends& ends)
{
    return edit(name, moves(reach, stepOfSlider(ends)), prepare);
}

/// The three number boxes of a place or a size, which go over `parts` of the domain.
template <class Reach>
Drivers vectorControls(const QString& name, const Driver::Step& prepare, Reach reach, double parts = 1)
{
    Drivers drivers;
    for (int axis = 0; axis < 3; ++axis) {
        const Ends ends = [axis, parts](const DrivenWindow& window) -> TransferLimits {
            return {0, parts * window.session().model()->description().bounds.sizes()[axis]};
        };
        drivers.push_back(steps(
            name + '.' + QChar('x' + axis), prepare,
            [reach, axis](ViewValue& view) -> double& { return reach(view)[axis]; }, ends));
    }
    return drivers;
}

TransferLimits halfDiagonal(const DrivenWindow& window)
{
    return {0, window.session().model()->diagonal() / 2};
}

/// Place, size, error and fall-off of a model that was just opened.
void resetFocus(ViewValue& view, const DrivenWindow& window)
{
    const Shape shape = view.query.focus.shape;
    view.query.focus = window.atFirst().query.focus;
    view.query.focus.shape = shape;
}

void moveFocusToView(ViewValue& view, const DrivenWindow&)
{
    view.query.focus.centre = view.camera.target;
}

/// With two regions, the second of which is edited.
void withTwoRegions(DrivenWindow& window)
{
    withFocus(Shape::Sphere)(window);
    window.session().setFocus(window.session().view().query.focus.added());
}

/// What the accuracy varies with besides regions (C3), and several of these.
Drivers otherFocusControls()
{
    const auto distance = [](ViewValue& view) -> double& { return view.query.focus.distance; };
    const auto values = [](ViewValue& view) -> double& { return view.query.focus.valueFalloff; };
    const Ends diagonal = [](const DrivenWindow& window) -> TransferLimits {
        return {0, window.session().model()->diagonal()};
    };
    const Ends extent = [](const DrivenWindow& window) -> TransferLimits {
        return {0, window.session().range().extent()};
    };
    const auto regions = [](const QString& name, const Driver::Step& prepare, const auto& change) {
        return edit(
            "focus." + name,
            [change](ViewValue& view, const DrivenWindow&) { view.query.focus = change(view.query.focus); }, prepare);
    };
    return {
        toShape("view", Shape::None, Shape::View),
        toShape("isovalues", Shape::None, Shape::Isovalues),
        toShape("opacity", Shape::None, Shape::Opacity),
        slides("focus.distance.slider", withFocus(Shape::View), distance, diagonal),
        steps("focus.distance.box", withFocus(Shape::View), distance, diagonal),
        slides("focus.valueFalloff.slider", withFocus(Shape::Isovalues), values, extent),
        steps("focus.valueFalloff.box", withFocus(Shape::Isovalues), values, extent),
        regions("add", withFocus(Shape::Box), [](const FocusState& focus) { return focus.added(); }),
        regions("remove", &withTwoRegions, [](const FocusState& focus) { return focus.removed(); }),
        regions("region", &withTwoRegions, [](const FocusState& focus) { return focus.selected(0); }),
    };
}

/// The lens (C5).
Drivers lensControls()
{
    const auto withLens = [](LensState::Shape shape) {
        return [shape](DrivenWindow& window) {
            LensState lens = window.session().view().lens;
            lens.shape = shape;
            window.session().setLens(lens);
            window.raise("dock.focus");
        };
    };
    const auto ofLens = [](const QString& name, const Driver::Step& prepare, const auto& change) {
        return edit(
            "lens." + name, [change](ViewValue& view, const DrivenWindow&) { change(view.lens); }, prepare);
    };
    const auto toLens = [&](const QString& name, LensState::Shape before, LensState::Shape after) {
        return ofLens(name, withLens(before), [after](LensState& lens) { lens.shape = after; });
    };
    const Driver::Step circle = withLens(LensState::Shape::Circle);
    const auto magnification = [](ViewValue& view) -> double& { return view.lens.magnification; };
    const auto radius = [](ViewValue& view) -> double& { return view.lens.radius; };
    const Ends magnifications = [](const DrivenWindow&) -> TransferLimits {
        return {leastMagnification, largestMagnification};
    };
    // The box shows percent.
    const Distance radiusStep = [](const DrivenWindow&) { return (largestLensRadius - leastLensRadius) / 100; };
    const auto stepsRadius = [&](const QString& name) {
        return edit(name,
                    moves(radius,
                          [radiusStep](const DrivenWindow& window, double before) {
                              return Aim{before + radiusStep(window), 0.002};
                          }),
                    circle);
    };
    return {
        toLens("none", LensState::Shape::Square, LensState::Shape::None),
        toLens("circle", LensState::Shape::None, LensState::Shape::Circle),
        toLens("square", LensState::Shape::Circle, LensState::Shape::Square),
        slides("lens.magnification.slider", circle, magnification, magnifications),
        steps("lens.magnification.box", circle, magnification, magnifications),
        stepsRadius("lens.radius.slider"),
        stepsRadius("lens.radius.box"),
        ofLens("error.slider", circle, [](LensState& lens) { lens.error = 0.2; }), // the next finer one
        ofLens("error.box", circle, [](LensState& lens) { lens.error = 0.3; }),
    };
}

Drivers focusControls()
{
    const Driver::Step box = withFocus(Shape::Box);
    const Driver::Step sphere = withFocus(Shape::Sphere);
    const auto centre = [](ViewValue& view) -> Eigen::Vector3d& { return view.query.focus.centre; };
    const auto size = [](ViewValue& view) -> Eigen::Vector3d& { return view.query.focus.size; };
    const auto radius = [](ViewValue& view) -> double& { return view.query.focus.radius; };
    const auto falloff = [](ViewValue& view) -> double& { return view.query.focus.falloff; };
    const Drivers others{
        toShape("box", Shape::None, Shape::Box),
        toShape("sphere", Shape::None, Shape::Sphere),
        toShape("none", Shape::Box, Shape::None),
        ofFocus("error.slider", Shape::Box, [](FocusState& focus) { focus.error = 0.15; }), // the next finer one
        ofFocus("error.box", Shape::Box, [](FocusState& focus) { focus.error = 0.25; }),
        slides("focus.falloff.slider", box, falloff, &halfDiagonal),
        steps("focus.falloff.box", box, falloff, &halfDiagonal),
        slides("focus.radius.slider", sphere, radius, &halfDiagonal),
        steps("focus.radius.box", sphere, radius, &halfDiagonal),
        edit("focus.toView", &moveFocusToView, box),
        edit("focus.reset", &resetFocus, box),
    };
    return allOf({others, otherFocusControls(), lensControls(), vectorControls("focus.centre", box, centre),
                  vectorControls("focus.size", box, size, 2)});
}

/// A window and a range of values, smaller than all there is.
void beginInRegion(DrivenWindow& window)
{
    QueryState query = window.session().view().query;
    query.window.enabled = true;
    query.window.window.box.least += 0.2 * (query.window.window.box.largest - query.window.window.box.least);
    const ValueRange range = window.session().range();
    query.values = {true, range.minimum + 0.2 * range.extent(), range.maximum - 0.2 * range.extent()};
    window.session().setQuery(query);
    window.raise("dock.region");
}

/// Changes what of the query is about regions.
Driver ofQuery(const QString& name, const std::function<void(QueryState&, const DrivenWindow&)>& change,
               const Driver::Step& prepare)
{
    return edit(
        "region." + name, [change](ViewValue& view, const DrivenWindow& window) { change(view.query, window); },
        prepare);
}

/// What lived in a range of errors (C2): by the arrows from 1.5 %, the slider to a finer one, the box to a coarser one.
Drivers rangeControls()
{
    const auto begin = [](double RangeState::*percent) {
        return [percent](DrivenWindow& window) {
            RangeState range = window.session().view().query.range;
            range.enabled = true;
            range.*percent = 1.5;
            window.session().setRange(range);
            window.raise("dock.region");
        };
    };
    Drivers drivers{ofQuery(
        "range", [](QueryState& query, const DrivenWindow&) { query.range.enabled = true; }, inDock("dock.region"))};
    for (const auto& [name, percent] : {std::pair{"fine", &RangeState::fine},
                                        {"coarse", &RangeState::coarse},
                                        {"bornAbove", &RangeState::bornAbove},
                                        {"bornTo", &RangeState::bornTo},
                                        {"diedFrom", &RangeState::diedFrom},
                                        {"diedTo", &RangeState::diedTo}})
        for (const auto& [part, to] : {std::pair{".slider", 1.2}, {".box", 2.0}})
            drivers.push_back(ofQuery(
                QString(name) + part,
                [member = percent, to = to](QueryState& query, const DrivenWindow&) { query.range.*member = to; },
                begin(percent)));
    return drivers;
}

} // namespace

Drivers regionControls()
{
    const Driver::Step begin = &beginInRegion;
    const auto from = [](ViewValue& view) -> Eigen::Vector3d& { return view.query.window.window.box.least; };
    const auto to = [](ViewValue& view) -> Eigen::Vector3d& { return view.query.window.window.box.largest; };
    const auto least = [](ViewValue& view) -> double& { return view.query.values.least; };
    const auto largest = [](ViewValue& view) -> double& { return view.query.values.largest; };
    const Drivers others{
        ofQuery(
            "window", [](QueryState& query, const DrivenWindow&) { query.window.enabled = true; },
            inDock("dock.region")),
        ofQuery(
            "values", [](QueryState& query, const DrivenWindow&) { query.values.enabled = true; },
            inDock("dock.region")),
        ofQuery(
            "border",
            [](QueryState& query, const DrivenWindow&) { query.window.window.border = WindowBorder::Intersecting; },
            begin),
        ofQuery(
            "reset",
            [](QueryState& query, const DrivenWindow& window) {
                const Eigen::AlignedBox3d& bounds = window.session().model()->description().bounds;
                query.window.window.box = {bounds.min(), bounds.max()};
            },
            begin),
        slides("region.least.slider", begin, least, &rangeOf),
        steps("region.least.box", begin, least, &rangeOf),
        slides("region.largest.slider", begin, largest, &rangeOf),
        steps("region.largest.box", begin, largest, &rangeOf),
    };
    return allOf({focusControls(), others, rangeControls(), vectorControls("region.from", begin, from),
                  vectorControls("region.to", begin, to)});
}

} // namespace tetra
