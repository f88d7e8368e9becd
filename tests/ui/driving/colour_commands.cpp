// SPDX-License-Identifier: GPL-3.0-or-later
// How the menus of the colour buttons are driven, and what each colour changes.
#include "plugins/widgets/curves/selection.h"
#include "tests/ui/driving/driver.h"

#include <QMenu>
#include <QToolButton>

namespace tetra {
namespace {

/// The menu is filled when it opens.
void openMenu(DrivenWindow& window, const QString& button)
{
    emit window.find<QToolButton>(button).menu()->aboutToShow();
}

using ColourChange = std::function<Driver::Change(const Colour& colour)>;

Drivers coloursOf(const QString& button, const ColourChange& changed, const Driver::Step& prepare)
{
    const Driver::Step open = [=](DrivenWindow& window) {
        prepare(window);
        openMenu(window, button);
    };
    Drivers drivers{opening(button + ".other", "colourDialog", open)};
    for (int index = 0; index < paletteSize; ++index)
        drivers.push_back(edit(QString("%1.%2").arg(button).arg(index), changed(paletteColour(index)), open));
    return drivers;
}

Driver::Change colourOfIsovalue(const Colour& colour)
{
    return [colour](ViewValue& view, const DrivenWindow&) {
        view.isovalues.front().red = colour.red;
        view.isovalues.front().green = colour.green;
        view.isovalues.front().blue = colour.blue;
    };
}

Driver::Change colourOfBackground(const Colour& colour)
{
    return [colour](ViewValue& view, const DrivenWindow&) { view.background = colour; };
}

Driver::Change colourOfPoint(const Colour& colour)
{
    return transfer([colour](const TransferFunction& function, const DrivenWindow& window) {
        const JoinedFunction points = joined(function);
        return separated(withColour(points, {window.addedPoint()}, {colour.red, colour.green, colour.blue}).function);
    });
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
    return allOf({coloursOf("isovalue.0.colour", &colourOfIsovalue, &makeIsovalueGrey),
                  coloursOf("view.background", &colourOfBackground, inDock("dock.view")),
                  coloursOf("transfer.colour", &colourOfPoint, &selectPoint)});
}

} // namespace tetra
