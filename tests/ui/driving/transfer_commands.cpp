// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the editor of transfer functions are driven: its menus and its presets.
#include "plugins/widgets/curves/joined_function.h"
#include "plugins/widgets/curves/moving.h"
#include "tests/ui/driving/driver.h"

#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>

namespace tetra {
namespace {

const TransferFunction& transferOf(const DrivenWindow& window)
{
    return window.session().view().appearance.transfer;
}

/// Points in no order of values or opacities, so that each edit has something to do.
void beginUneven(DrivenWindow& window)
{
    window.choose("volume");
    JoinedFunction uneven = joined(transferOf(window));
    for (std::size_t i = 0; i < uneven.points.size(); ++i)
        uneven.points[i].opacity = 0.1F + 0.07F * static_cast<float>((i * 5) % 9);
    if (uneven.points.size() > 3)
        uneven.points[1].value += 0.3 * (uneven.points[2].value - uneven.points[1].value);
    window.session().setTransfer(separated(uneven));
    window.raise("dock.transfer");
}

void selectAll(DrivenWindow& window)
{
    beginUneven(window);
    window.press("transfer.canvas", Qt::Key_A, Qt::ControlModifier);
}

/// Two points that lie one after the other.
void selectTwo(DrivenWindow& window)
{
    beginUneven(window);
    auto& table = window.find<QAbstractButton>("transfer.table.show");
    if (!table.isChecked())
        table.click();
    for (int row = 0; row < 3; ++row)
        window.press("transfer.table", Qt::Key_Down);
    window.press("transfer.table", Qt::Key_Down, Qt::ShiftModifier);
}

Driver change(const QString& name, const Driver::Step& prepare)
{
    return {"transfer.change." + name,
            [](const DrivenWindow& window) { return transferOf(window) != window.before().appearance.transfer; },
            prepare};
}

Drivers changes()
{
    Drivers drivers;
    for (const char* name : {"denser", "thinner", "mirror", "widen", "narrow", "peak", "mask"})
        drivers.push_back(change(name, &beginUneven));
    for (const char* name : {"delete", "duplicate", "distribute", "flip", "invert", "ramp", "align.first", "align.mean",
                             "align.least", "align.largest", "logarithm"})
        drivers.push_back(change(name, &selectAll));
    drivers.push_back(change("align.values", &selectTwo));
    drivers.push_back(change("spread", [](DrivenWindow& window) {
        beginUneven(window);
        window.trigger("transfer.change.narrow");
    }));
    drivers.push_back(change("simplify", [](DrivenWindow& window) { // of a smooth function, not of one that is uneven
        window.choose("volume");
        window.raise("dock.transfer");
        window.press("transfer.canvas", Qt::Key_A, Qt::ControlModifier);
    }));
    drivers.push_back(change("paste", [](DrivenWindow& window) {
        selectAll(window);
        window.trigger("transfer.change.copy");
    }));
    return drivers;
}

/// What a group holds is what its keys select, so that making and choosing are seen by what removing them leaves.
Drivers groups()
{
    Drivers drivers;
    for (int group = 0; group <= largestTransferGroup; ++group) {
        const QString number = QString::number(group);
        drivers.push_back(change("group.assign." + number, &selectAll));
        drivers.push_back(showing(
            "transfer.change.group.select." + number,
            [](const DrivenWindow& window) { return window.find<QAction>("transfer.change.delete").isEnabled(); },
            [number](DrivenWindow& window) {
                selectAll(window);
                window.trigger("transfer.change.group.assign." + number);
                window.press("transfer.canvas", Qt::Key_Escape);
            }));
    }
    drivers.push_back(change("group.none", [](DrivenWindow& window) {
        selectAll(window);
        window.trigger("transfer.change.group.assign.3");
    }));
    return drivers;
}

/// A choice of several: it is taken, and was not before.
Driver choice(const QString& name, const QString& other)
{
    return showing(
        name, [name](const DrivenWindow& window) { return window.find<QAction>(name).isChecked(); },
        [other](DrivenWindow& window) {
            beginUneven(window);
            window.trigger(other);
        });
}

QImage plotOf(const DrivenWindow& window)
{
    return window.find<QWidget>("transfer.canvas").grab().toImage();
}

/// What is seen of the plot is the only trace of a zoom.
Driver zoom(const QString& name, const Driver::Step& prepare)
{
    const auto picture = std::make_shared<QImage>();
    return showing(
        "transfer.zoom." + name, [picture](const DrivenWindow& window) { return plotOf(window) != *picture; },
        [picture, prepare](DrivenWindow& window) {
            prepare(window);
            QCoreApplication::processEvents();
            *picture = plotOf(window);
        });
}

void zoomIn(DrivenWindow& window)
{
    beginUneven(window);
    window.press("transfer.canvas", Qt::Key_Plus);
}

} // namespace

Drivers transferCommands()
{
    const Drivers others{
        showing(
            "transfer.change.selectAll",
            [](const DrivenWindow& window) { return window.find<QAction>("transfer.change.simplify").isEnabled(); },
            &beginUneven),
        showing(
            "transfer.change.copy",
            [](const DrivenWindow&) { return QGuiApplication::clipboard()->text().contains("opacities"); },
            [](DrivenWindow& window) {
                QGuiApplication::clipboard()->clear();
                selectAll(window);
            }),
        {"transfer.change.addIsovalue",
         [](const DrivenWindow& window) { return window.session().view().isovalues.size() == 2; }, &beginUneven},
        choice("transfer.change.rule.stop", "transfer.change.rule.push"),
        choice("transfer.change.rule.push", "transfer.change.rule.pass"),
        choice("transfer.change.rule.pass", "transfer.change.rule.stop"),
        choice("transfer.axis.linear", "transfer.axis.logarithmic"),
        choice("transfer.axis.squareRoot", "transfer.axis.linear"),
        choice("transfer.axis.logarithmic", "transfer.axis.linear"),
        choice("transfer.valueAxis.linear", "transfer.valueAxis.logarithmic"),
        choice("transfer.valueAxis.logarithmic", "transfer.valueAxis.linear"),
        zoom("selection", &selectTwo),
        zoom("data", &zoomIn),
        zoom("all", &zoomIn),
        opening("transfer.save.paraview", "transferParaviewDialog", &beginUneven),
        {"transfer.preset.*",
         [](const DrivenWindow& window) { return transferOf(window) != window.before().appearance.transfer; },
         &beginUneven},
        {"transfer.colours.*",
         [](const DrivenWindow& window) { return transferOf(window) != window.before().appearance.transfer; },
         &beginUneven},
    };
    return allOf({changes(), groups(), others});
}

} // namespace tetra
