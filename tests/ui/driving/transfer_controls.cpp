// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the dock Transfer are driven, and what each changes (R18).
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/whole_function.h"
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QInputDialog>
#include <QListWidget>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

void begin(DrivenWindow& window)
{
    window.choose("volume");
    window.raise("dock.transfer");
}

void beginAtPoint(DrivenWindow& window)
{
    begin(window);
    window.addTransferPoint();
}

void beginInTable(DrivenWindow& window)
{
    begin(window);
    auto& button = window.find<QToolButton>("transfer.table.show");
    if (!button.isChecked())
        button.click();
    window.press("transfer.canvas", Qt::Key_Escape);
}

void openPresets(DrivenWindow& window)
{
    begin(window);
    window.find<QComboBox>("transfer.presetPopup.part").setCurrentIndex(0);
    window.find<QToolButton>("transfer.presets").click();
}

int presetsSeen(const DrivenWindow& window)
{
    const auto& list = window.find<QListWidget>("transfer.presetPopup.list");
    int seen = 0;
    for (int row = 0; row < list.count(); ++row)
        seen += list.item(row)->isHidden() ? 0 : 1;
    return seen;
}

/// Those that are seen are those with the text in their names or words, and are not all.
bool presetsAreFiltered(const DrivenWindow& window)
{
    const auto& list = window.find<QListWidget>("transfer.presetPopup.list");
    const auto wanted = list.findItems("vi", Qt::MatchContains);
    return presetsSeen(window) >= wanted.size() && presetsSeen(window) < list.count() &&
           std::ranges::none_of(wanted, &QListWidgetItem::isHidden);
}

/// Presets that are colours alone have no opacities to be taken.
bool hasPresetsWithOpacities(const DrivenWindow& window)
{
    const auto& list = window.find<QListWidget>("transfer.presetPopup.list");
    return presetsSeen(window) == list.count() - static_cast<int>(colourMaps().size());
}

bool hasNoOwnPreset(const DrivenWindow& window)
{
    return window.find<QListWidget>("transfer.presetPopup.list").findItems("driven", Qt::MatchExactly).isEmpty();
}

/// One of the user's own, chosen in the list.
void keepPreset(DrivenWindow& window)
{
    openPresets(window);
    window.press("transfer.presetPopup.save", Qt::Key_Space);
    auto& dialog = window.find<QInputDialog>("transfer.presetName");
    dialog.setTextValue("driven");
    dialog.accept();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    openPresets(window);
    if (!waitFor([&window] { return !hasNoOwnPreset(window); }))
        qFatal("the preset is not kept");
    window.find<QListWidget>("transfer.presetPopup.list").setCurrentRow(0);
}

/// The last one is the last of the colour maps.
TransferFunction withLastPreset(const TransferFunction& function, const DrivenWindow& window)
{
    return withColourMap(function, colourMaps().back(), rangeOf(window));
}

Drivers popupControls()
{
    return {
        showing(
            "transfer.presetPopup.search", &presetsAreFiltered, &openPresets,
            [](DrivenWindow& window) { QTest::keyClicks(&window.find<QWidget>("transfer.presetPopup.search"), "vi"); }),
        showing("transfer.presetPopup.part", &hasPresetsWithOpacities, &openPresets,
                [](DrivenWindow& window) { window.press("transfer.presetPopup.part", Qt::Key_End); }),
        edit("transfer.presetPopup.list", transfer(&withLastPreset), &openPresets,
             [](DrivenWindow& window) {
                 window.press("transfer.presetPopup.list", Qt::Key_End);
                 window.press("transfer.presetPopup.list", Qt::Key_Return);
             }),
        opening("transfer.presetPopup.save", "transfer.presetName", &openPresets),
        showing("transfer.presetPopup.delete", &hasNoOwnPreset, &keepPreset),
    };
}

/// An edit of the point that was added last.
using AddedPointEdit =
    std::function<JoinedFunction(const JoinedFunction& function, std::size_t point, const DrivenWindow&)>;

Driver ofPoint(const QString& name, const AddedPointEdit& edited, Driver::Step use = {})
{
    return edit("transfer." + name, transfer([edited](const TransferFunction& function, const DrivenWindow& window) {
                    return separated(edited(joined(function), window.addedPoint(), window));
                }),
                &beginAtPoint, std::move(use));
}

/// A number box of the editor steps by a hundredth of what it goes over.
JoinedFunction withSteppedValue(const JoinedFunction& function, std::size_t point, const DrivenWindow& window)
{
    const TransferLimits range = rangeOf(window);
    const double value = function.points[point].value + (range.largest - range.least) / 100;
    return withValue(function, {point}, value, NeighbourRule::Stop, range).function;
}

JoinedFunction withSteppedOpacity(const JoinedFunction& function, std::size_t point, const DrivenWindow&)
{
    const double percent = std::round(1e4 * function.points[point].opacity) / 100; // as it is shown
    return withOpacity(function, {point}, (percent + 1) / 100).function;
}

JoinedFunction withPointAfter(const JoinedFunction& function, std::size_t point, const DrivenWindow&)
{
    const double middle = std::midpoint(function.points[point].value, function.points[point + 1].value);
    return withPoint(function, middle)->function;
}

JoinedFunction coloured(const JoinedFunction& function, std::size_t point, const DrivenWindow&)
{
    const auto [red, green, blue] = paletteColour(3);
    return withColour(function, {point}, {red, green, blue}).function;
}

Drivers pointControls()
{
    return {
        ofPoint("value", &withSteppedValue),
        ofPoint("opacity", &withSteppedOpacity),
        ofPoint("step", [](const JoinedFunction& function, std::size_t point,
                           const DrivenWindow&) { return withStep(function, point).function; }),
        ofPoint("add", &withPointAfter),
        ofPoint("remove", [](const JoinedFunction& function, std::size_t point,
                             const DrivenWindow&) { return withoutSelected(function, {point}).function; }),
        ofPoint("colour", &coloured,
                [](DrivenWindow& window) {
                    chooseInMenu(window.find<QToolButton>("transfer.colour"), "transfer.colour.3");
                }),
    };
}

/// The box steps the second digit.
TransferFunction withSteppedUnit(const TransferFunction& function, const DrivenWindow&)
{
    const double step = std::pow(10, std::floor(std::log10(function.unitDistance)) - 1);
    return withUnitDistance(function, function.unitDistance + step);
}

TransferFunction masked(const TransferFunction& function, const DrivenWindow& window)
{
    const TransferLimits range = rangeOf(window);
    const double inset = 0.1 * (range.largest - range.least);
    return withMask(function, {range.least + inset, range.largest - inset});
}

TransferFunction withPointInTheMiddle(const TransferFunction& function, const DrivenWindow& window)
{
    const TransferLimits range = rangeOf(window);
    return separated(withPoint(joined(function), std::midpoint(range.least, range.largest))->function);
}

Drivers wholeControls()
{
    return {
        edit("transfer.unitDistance", transfer(&withSteppedUnit), &begin),
        edit("transfer.mask", transfer(&masked), &begin),
        edit("transfer.canvas", transfer(&withPointInTheMiddle), &begin,
             [](DrivenWindow& window) { window.press("transfer.canvas", Qt::Key_Insert); }),
        edit("transfer.edits", transfer([](const TransferFunction& function, const DrivenWindow&) {
                 return withScaledOpacity(function, 1.25);
             }),
             &begin,
             [](DrivenWindow& window) {
                 chooseInMenu(window.find<QToolButton>("transfer.edits"), "transfer.change.denser");
             }),
    };
}

} // namespace

Drivers transferControls()
{
    const auto plot = std::make_shared<QImage>();
    const auto unitDistance = std::make_shared<double>(); // which differs from function to function
    const auto shownUnitDistance = [](const DrivenWindow& window) {
        return window.find<QDoubleSpinBox>("transfer.unitDistance").value();
    };
    const Drivers others{
        showing(
            "transfer.function", [=](const DrivenWindow& window) { return shownUnitDistance(window) != *unitDistance; },
            [=](DrivenWindow& window) {
                window.choose("example.two-functions");
                window.raise("dock.transfer");
                *unitDistance = shownUnitDistance(window);
            }),
        showing(
            "transfer.logarithmic",
            [plot](const DrivenWindow& window) {
                return window.find<QWidget>("transfer.canvas").grab().toImage() != *plot;
            },
            [plot](DrivenWindow& window) {
                begin(window);
                window.waitForPicture();
                *plot = window.find<QWidget>("transfer.canvas").grab().toImage();
            }),
        opening("transfer.presets", "transfer.presetPopup", &begin),
        showing(
            "transfer.view",
            [](const DrivenWindow& window) { return window.find<QAction>("transfer.axis.linear").isChecked(); },
            [](DrivenWindow& window) {
                begin(window);
                window.trigger("transfer.axis.squareRoot");
            },
            [](DrivenWindow& window) {
                chooseInMenu(window.find<QToolButton>("transfer.view"), "transfer.axis.linear");
            }),
        showing(
            "transfer.table.show", [](const DrivenWindow& window) { return window.isOpen("transfer.table"); },
            [](DrivenWindow& window) {
                begin(window);
                window.find<QToolButton>("transfer.table.show").setChecked(false);
            }),
        showing(
            "transfer.table",
            [](const DrivenWindow& window) { return window.find<QAction>("transfer.change.delete").isEnabled(); },
            &beginInTable),
        opening("transfer.load", "transferDialog", &begin),
        opening("transfer.save", "transferSaveDialog", &begin),
    };
    return allOf({pointControls(), wholeControls(), others, popupControls()});
}

} // namespace tetra
