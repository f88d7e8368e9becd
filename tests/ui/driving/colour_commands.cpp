// SPDX-License-Identifier: GPL-3.0-or-later
// How the menus of the colour buttons are driven.
#include "tests/ui/driving/driver.h"

#include <QMenu>
#include <QToolButton>

namespace tetra {
namespace {

constexpr int paletteSize = 7;

/// The menu is filled when it opens.
void openMenu(DrivenWindow& window, const QString& button)
{
    emit window.find<QToolButton>(button).menu()->aboutToShow();
}

Drivers coloursOf(const QString& button, const Driver::Condition& done, const Driver::Step& prepare)
{
    const Driver::Step open = [=](DrivenWindow& window) {
        prepare(window);
        openMenu(window, button);
    };
    Drivers drivers{opening(button + ".other", "colourDialog", open)};
    for (int index = 0; index < paletteSize; ++index)
        drivers.push_back({QString("%1.%2").arg(button).arg(index), done, open});
    return drivers;
}

/// In a colour that is not in the palette.
void makeIsovalueGrey(DrivenWindow& window)
{
    Isovalue isovalue = window.session().view().isovalues.front();
    isovalue.red = isovalue.green = isovalue.blue = 0.5F;
    window.session().setIsovalue(0, isovalue);
}

void selectPoint(DrivenWindow& window)
{
    window.choose("volume");
    window.addTransferPoint();
}

} // namespace

Drivers colourCommands()
{
    return allOf({coloursOf("isovalue.0.colour", changes(&ViewValue::isovalues), &makeIsovalueGrey),
                  coloursOf("view.background", changes(&ViewValue::background), inDock("dock.view")),
                  coloursOf("transfer.colour", changes(&ViewValue::appearance), &selectPoint)});
}

} // namespace tetra
