// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the dock Transfer are driven.
#include "tests/ui/driving/driver.h"
#include "tests/waiting.h"

#include <QComboBox>
#include <QInputDialog>
#include <QListWidget>
#include <QToolButton>

namespace tetra {
namespace {

bool hasOtherFunction(const DrivenWindow& window)
{
    return window.session().view().appearance.transfer != window.before().appearance.transfer;
}

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

void showTable(DrivenWindow& window)
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

Driver::Condition fewerPresets()
{
    return [](const DrivenWindow& window) {
        return presetsSeen(window) < window.find<QListWidget>("transfer.presetPopup.list").count();
    };
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

Drivers popupControls()
{
    return {
        showing(
            "transfer.presetPopup.search", fewerPresets(), &openPresets,
            [](DrivenWindow& window) { QTest::keyClicks(&window.find<QWidget>("transfer.presetPopup.search"), "vi"); }),
        showing("transfer.presetPopup.part", fewerPresets(), &openPresets,
                [](DrivenWindow& window) { window.press("transfer.presetPopup.part", Qt::Key_End); }),
        {"transfer.presetPopup.list", &hasOtherFunction, &openPresets,
         [](DrivenWindow& window) {
             window.press("transfer.presetPopup.list", Qt::Key_End);
             window.press("transfer.presetPopup.list", Qt::Key_Return);
         }},
        opening("transfer.presetPopup.save", "transfer.presetName", &openPresets),
        showing("transfer.presetPopup.delete", &hasNoOwnPreset, &keepPreset),
    };
}

Drivers pointControls()
{
    Drivers drivers;
    for (const char* name : {"value", "opacity", "step", "add", "remove"})
        drivers.push_back({QString("transfer.") + name, &hasOtherFunction, &beginAtPoint});
    for (const char* name : {"unitDistance", "mask"})
        drivers.push_back({QString("transfer.") + name, &hasOtherFunction, &begin});
    drivers.push_back({"transfer.canvas", &hasOtherFunction, &begin,
                       [](DrivenWindow& window) { window.press("transfer.canvas", Qt::Key_Insert); }});
    drivers.push_back({"transfer.colour", &hasOtherFunction, &beginAtPoint, [](DrivenWindow& window) {
                           chooseInMenu(window.find<QToolButton>("transfer.colour"), "transfer.colour.3");
                       }});
    return drivers;
}

} // namespace

Drivers transferControls()
{
    const auto plot = std::make_shared<QImage>();
    const Drivers others{
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
        {"transfer.edits", &hasOtherFunction, &begin,
         [](DrivenWindow& window) {
             chooseInMenu(window.find<QToolButton>("transfer.edits"), "transfer.change.denser");
         }},
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
            &showTable),
        opening("transfer.load", "transferDialog", &begin),
        opening("transfer.save", "transferSaveDialog", &begin),
    };
    return allOf({pointControls(), others, popupControls()});
}

} // namespace tetra
