// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Focus and Region are driven.
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

Driver ofFocus(const QString& name, Shape shape)
{
    return {"focus." + name,
            [](const DrivenWindow& window) {
                return window.session().view().query.focus != window.before().query.focus && window.settled();
            },
            withFocus(shape)};
}

Drivers focusControls()
{
    Drivers drivers;
    for (const char* name : {"box", "sphere"})
        drivers.push_back(ofFocus(name, Shape::None));
    for (const char* name : {"none", "centre.x", "centre.y", "centre.z", "size.x", "size.y", "size.z", "error.slider",
                             "error.box", "falloff.slider", "falloff.box", "toView", "reset"})
        drivers.push_back(ofFocus(name, Shape::Box));
    for (const char* name : {"radius.slider", "radius.box"})
        drivers.push_back(ofFocus(name, Shape::Sphere));
    return drivers;
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

Driver ofRegion(const QString& name, const Driver::Step& prepare = &beginInRegion)
{
    return {"region." + name,
            [](const DrivenWindow& window) {
                return window.session().view().query != window.before().query && window.settled();
            },
            prepare};
}

} // namespace

Drivers regionControls()
{
    Drivers drivers{ofRegion("window", inDock("dock.region")), ofRegion("values", inDock("dock.region"))};
    for (const char* name : {"from.x", "from.y", "from.z", "to.x", "to.y", "to.z", "border", "reset", "least.slider",
                             "least.box", "largest.slider", "largest.box"})
        drivers.push_back(ofRegion(name));
    return allOf({focusControls(), drivers});
}

} // namespace tetra
