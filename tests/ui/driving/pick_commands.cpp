// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions are driven that are about the value picked in the picture.
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"
#include "ui/viewport/value_pick.h"

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

} // namespace

Drivers pickCommands()
{
    const Driver::Condition hasTwoIsovalues = [](const DrivenWindow& window) {
        return window.session().view().isovalues.size() == 2;
    };
    const Driver::Condition isForgotten = [](const DrivenWindow& window) { return !isPicked(window); };
    return {
        showing("action.pickValue", &isPicked, &showVolume),
        {"action.isovalueHere", hasTwoIsovalues, &pickInTheMiddle},
        {"action.pointHere", changes(&ViewValue::appearance), &pickInTheMiddle},
        showing("action.forgetPicked", isForgotten, &pickInTheMiddle),
        {"transfer.change.picked.isovalue", hasTwoIsovalues, &pickInTheMiddle},
        {"transfer.change.picked.point", changes(&ViewValue::appearance), &pickInTheMiddle},
        showing("transfer.change.picked.forget", isForgotten, &pickInTheMiddle),
    };
}

} // namespace tetra
