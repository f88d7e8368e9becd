// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions are driven that are about the value picked in the picture.
#include "core/view/appearance.h"
#include "plugins/widgets/curves/joined_function.h"
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"
#include "ui/viewport/value_pick.h"

#include <tan/view.h>

namespace tetra {
namespace {

bool isPicked(const DrivenWindow& window)
{
    return window.find<ValuePick>("viewport.pick").picked().has_value();
}

void showVolume(DrivenWindow& window)
{
    window.choose("volume");
    window.raise("dock.transfer");
    window.waitForPicture();
}

void pickInTheMiddle(DrivenWindow& window)
{
    showVolume(window);
    window.trigger("action.pickValue");
    if (!waitFor([&] { return isPicked(window); }))
        qFatal("nothing is seen in the middle of the picture");
}

double pickedValue(const DrivenWindow& window)
{
    return window.find<ValuePick>("viewport.pick").picked()->value;
}

void addIsovalueThere(ViewValue& view, const DrivenWindow& window)
{
    Isovalue isovalue = nextIsovalue(view.isovalues, window.session().range());
    isovalue.value = pickedValue(window);
    view.isovalues.push_back(isovalue);
}

TransferFunction withPointThere(const TransferFunction& function, const DrivenWindow& window)
{
    return separated(withPoint(joined(function), pickedValue(window))->function);
}

} // namespace

Drivers pickCommands()
{
    const Driver::Condition isForgotten = [](const DrivenWindow& window) { return !isPicked(window); };
    return {
        showing("action.pickValue", &isPicked, &showVolume),
        edit("action.isovalueHere", &addIsovalueThere, &pickInTheMiddle),
        edit("action.pointHere", transfer(&withPointThere), &pickInTheMiddle),
        showing("action.forgetPicked", isForgotten, &pickInTheMiddle),
        edit("transfer.change.picked.isovalue", &addIsovalueThere, &pickInTheMiddle),
        edit("transfer.change.picked.point", transfer(&withPointThere), &pickInTheMiddle),
        showing("transfer.change.picked.forget", isForgotten, &pickInTheMiddle),
    };
}

} // namespace tetra
