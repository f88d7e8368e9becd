// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the editor of transfer functions are driven, its menus and its presets, and what each changes
// (R18). What an edit makes of a function is the matter of tests/plugins/widgets/curves; here it is which edit, of
// which points, by how much.
#include "core/view/appearance.h"
#include "plugins/editors/transferfunction/preset.h"
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/copying.h"
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/reshaping.h"
#include "plugins/widgets/curves/whole_function.h"
#include "tests/ui/driving/driver.h"

#include <tan/view.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QGuiApplication>
#include <QTableView>

#include <algorithm>
#include <cmath>

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

/// In the table, which is shown; the next key down chooses its first row.
void selectNothing(DrivenWindow& window)
{
    auto& shown = window.find<QAbstractButton>("transfer.table.show");
    if (!shown.isChecked())
        shown.click();
    auto& table = window.find<QTableView>("transfer.table");
    table.setFocus(); // which makes the first row the current one, if none is; so before that is cleared
    table.selectionModel()->clear();
}

const TransferSelection twoSelected{2, 3};

/// Two points that lie one after the other.
void selectTwo(DrivenWindow& window)
{
    beginUneven(window);
    selectNothing(window);
    for (int row = 0; row < 3; ++row)
        window.press("transfer.table", Qt::Key_Down);
    window.press("transfer.table", Qt::Key_Down, Qt::ShiftModifier);
}

double lengthOf(const TransferLimits& limits)
{
    return limits.largest - limits.least;
}

double middleOf(const TransferLimits& limits)
{
    return limits.least + lengthOf(limits) / 2;
}

/// An edit of the whole function.
Driver whole(const QString& name, const TransferEdit& edited, const Driver::Step& prepare = &beginUneven)
{
    return edit("transfer.change." + name, transfer(edited), prepare);
}

/// An edit of the points that are selected; the plot shows the range of the data.
using PointEdit =
    std::function<EditedSelection(const JoinedFunction&, const TransferSelection&, const TransferLimits&)>;

Driver ofPoints(const QString& name, const PointEdit& edited, const Driver::Step& prepare = &selectAll)
{
    return whole(
        name,
        [edited](const TransferFunction& function, const DrivenWindow& window) {
            const JoinedFunction points = joined(function);
            return separated(edited(points, allPoints(points), rangeOf(window)).function);
        },
        prepare);
}

Drivers wholeChanges()
{
    const auto scaled = [](double factor) {
        return [factor](const TransferFunction& old, const DrivenWindow&) { return withScaledOpacity(old, factor); };
    };
    const auto wider = [](double factor) {
        return [factor](const TransferFunction& old, const DrivenWindow&) {
            return widened(old, middleOf(*extentOf(old)), factor);
        };
    };
    return {
        whole("denser", scaled(1.25)),
        whole("thinner", scaled(0.8)),
        whole("mirror",
              [](const TransferFunction& old, const DrivenWindow& window) { return mirrored(old, rangeOf(window)); }),
        whole("widen", wider(1.25)),
        whole("narrow", wider(0.8)),
        whole(
            "spread",
            [](const TransferFunction& old, const DrivenWindow& window) { return spreadOver(old, rangeOf(window)); },
            [](DrivenWindow& window) {
                beginUneven(window);
                window.trigger("transfer.change.narrow");
            }),
        whole(
            "spread.shown",
            [](const TransferFunction& old, const DrivenWindow& window) {
                const TransferLimits range = rangeOf(window);
                const double inset = 0.1 * lengthOf(range); // a step of zoom leaves 0.8 of it
                return spreadOver(old, {range.least + inset, range.largest - inset});
            },
            [](DrivenWindow& window) {
                beginUneven(window);
                window.press("transfer.canvas", Qt::Key_Plus);
            }),
        whole("mask",
              [](const TransferFunction& old, const DrivenWindow& window) {
                  const TransferLimits range = rangeOf(window);
                  const double inset = 0.1 * lengthOf(range);
                  return withMask(old, {range.least + inset, range.largest - inset});
              }),
        whole("peak",
              [](const TransferFunction& old, const DrivenWindow& window) {
                  const TransferLimits range = rangeOf(window);
                  const double middle = middleOf(range);
                  const double present = -std::expm1(-evaluateUnmasked(old, middle).extinction * old.unitDistance);
                  const OpacityPeak peak{middle, 0.1 * lengthOf(range), std::max(0.5, present)};
                  return separated(withPeak(joined(old), peak, range).function);
              }),
    };
}

Drivers pointChanges()
{
    using Function = const JoinedFunction&;
    using Selection = const TransferSelection&;
    using Limits = const TransferLimits&;
    const auto align = [](const QString& name, Alignment alignment) {
        return ofPoints("align." + name,
                        [alignment](Function f, Selection s, Limits) { return alignOpacities(f, s, alignment); });
    };
    return {
        ofPoints("delete", [](Function f, Selection s, Limits) { return withoutSelected(f, s); }),
        ofPoints("duplicate",
                 [](Function f, Selection s, Limits l) { return duplicated(f, s, 0.05 * lengthOf(l), l); }),
        ofPoints("distribute", [](Function f, Selection s, Limits l) { return distributeValues(f, s, l); }),
        ofPoints("flip", [](Function f, Selection s, Limits l) { return flipValues(f, s, l); }),
        ofPoints("invert", [](Function f, Selection s, Limits) { return invertOpacities(f, s); }),
        ofPoints("ramp", [](Function f, Selection s, Limits) { return rampOpacities(f, s); }),
        ofPoints("logarithm", [](Function f, Selection s, Limits) { return withLogarithmicCourse(f, s, {}); }),
        align("first", Alignment::First),
        align("mean", Alignment::Mean),
        align("least", Alignment::Least),
        align("largest", Alignment::Largest),
        ofPoints(
            "align.values", [](Function f, Selection, Limits) { return alignValues(f, twoSelected, Alignment::Mean); },
            &selectTwo),
        ofPoints(
            "simplify", [](Function f, Selection s, Limits) { return simplified(f, s, {}); },
            [](DrivenWindow& window) { // of a smooth function, not of one that is uneven
                window.choose("volume");
                window.raise("dock.transfer");
                window.press("transfer.canvas", Qt::Key_A, Qt::ControlModifier);
            }),
        ofPoints(
            "paste",
            [](Function f, Selection s, Limits l) { return *pasted(f, copyOfSelected(f, s), std::nullopt, l); },
            [](DrivenWindow& window) {
                selectAll(window);
                window.trigger("transfer.change.copy");
            }),
    };
}

/// The rows of the table that are selected are the points that are.
Driver::Condition hasSelected(const TransferSelection& points)
{
    return [points](const DrivenWindow& window) {
        TransferSelection rows;
        for (const QModelIndex& row : window.find<QTableView>("transfer.table").selectionModel()->selectedRows())
            rows.push_back(static_cast<std::size_t>(row.row()));
        std::ranges::sort(rows);
        return rows == points;
    };
}

Drivers groups()
{
    Drivers drivers;
    for (int group = 0; group <= largestTransferGroup; ++group) {
        const QString number = QString::number(group);
        drivers.push_back(ofPoints(
            "group.assign." + number,
            [group](const JoinedFunction& f, const TransferSelection&, const TransferLimits&) {
                return withGroup(f, twoSelected, group);
            },
            &selectTwo));
        drivers.push_back(
            showing("transfer.change.group.select." + number, hasSelected(twoSelected), [number](DrivenWindow& window) {
                selectTwo(window);
                window.trigger("transfer.change.group.assign." + number);
                window.press("transfer.canvas", Qt::Key_Escape);
            }));
    }
    drivers.push_back(ofPoints(
        "group.none",
        [](const JoinedFunction& f, const TransferSelection& s, const TransferLimits&) {
            return withGroup(f, s, std::nullopt);
        },
        [](DrivenWindow& window) {
            selectAll(window);
            window.trigger("transfer.change.group.assign.3");
        }));
    return drivers;
}

/// How a rule is seen: a point with another close by is moved by a step that is larger than their distance. The rule is
/// another one before.
Driver rule(const QString& name, NeighbourRule kind)
{
    const QString action = "transfer.change.rule." + name;
    const Driver::Change changes = transfer([kind](const TransferFunction& function, const DrivenWindow& window) {
        const TransferLimits range = rangeOf(window);
        return separated(
            moveSelected(joined(function), {0}, {0.05 * lengthOf(range), 0}, kind, range).function); // Shift: 5 steps
    });
    const auto prepare = [kind](DrivenWindow& window) {
        window.choose("volume");
        window.raise("dock.transfer");
        const auto [least, largest] = rangeOf(window);
        const auto at = [&](double part) { return least + part * (largest - least); };
        window.session().setTransfer(transferFunctionFromPoints(
            {{at(0.4), {1, 0, 0}, 0.2F}, {at(0.42), {0, 1, 0}, 0.5F}, {at(1), {0, 0, 1}, 0.9F}}));
        window.trigger(kind == NeighbourRule::Stop ? "transfer.change.rule.push" : "transfer.change.rule.stop");
    };
    return edit(action, changes, prepare, [action](DrivenWindow& window) {
        window.trigger(action);
        selectNothing(window);
        window.press("transfer.table", Qt::Key_Down);
        window.press("transfer.canvas", Qt::Key_Right, Qt::ShiftModifier);
    });
}

QImage plotOf(const DrivenWindow& window)
{
    return window.find<QWidget>("transfer.canvas").grab().toImage();
}

/// How the plot is looked at shows in the plot alone. `again`: it is then as it was at the beginning, before `prepare`
/// made it another one; else it is none that was there.
Driver looking(const QString& name, const Driver::Step& begin, const Driver::Step& prepare, bool again)
{
    const auto pictures = std::make_shared<QList<QImage>>();
    return showing(
        name,
        [pictures, again](const DrivenWindow& window) {
            const QImage now = plotOf(window);
            return again ? now == pictures->first() : !pictures->contains(now);
        },
        [pictures, begin, prepare](DrivenWindow& window) {
            pictures->clear();
            for (const Driver::Step& step : {begin, prepare}) {
                step(window);
                window.find<QWidget>("transfer.canvas").setFocus();
                QCoreApplication::processEvents();
                pictures->append(plotOf(window));
            }
        });
}

/// A choice of several, which is checked then, too. `again`: it is the one at first.
Driver choice(const QString& name, const QString& other, bool again)
{
    Driver driver = looking(
        name, &beginUneven, [other](DrivenWindow& window) { window.trigger(other); }, again);
    driver.shows = [name, seen = driver.shows](const DrivenWindow& window) {
        return window.find<QAction>(name).isChecked() && seen(window);
    };
    return driver;
}

void zoomIn(DrivenWindow& window)
{
    window.press("transfer.canvas", Qt::Key_Plus);
    window.press("transfer.canvas", Qt::Key_Plus, Qt::ControlModifier);
}

/// The function reaches beyond the data, so that these are a part of what is shown.
void reachBeyond(DrivenWindow& window)
{
    beginUneven(window);
    window.session().setTransfer(widened(transferOf(window), middleOf(rangeOf(window)), 1.5));
}

/// What presets in Hounsfield units tell takes some of the picture's height: it is there before.
void beginWithTheMessage(DrivenWindow& window)
{
    beginUneven(window);
    window.trigger("transfer.preset.ct-bone");
    QCoreApplication::processEvents();
    beginUneven(window);
}

/// Presets of colours leave the opacities.
Drivers presetCommands()
{
    Drivers drivers;
    const auto preset = [&drivers](const QString& name, const TransferEdit& edited) {
        drivers.push_back(edit("transfer." + name, transfer(edited), &beginUneven));
    };
    preset("preset.sequential", [](const TransferFunction& old, const DrivenWindow& window) {
        const auto [least, largest] = rangeOf(window);
        return sequentialTransferFunction(least, largest, old.unitDistance);
    });
    preset("preset.diverging", [](const TransferFunction& old, const DrivenWindow& window) {
        const auto [least, largest] = rangeOf(window);
        return divergingTransferFunction(least, largest, old.unitDistance);
    });
    for (const Preset& supplied : suppliedPresets())
        if (supplied.hasOpacities && supplied.id != "preset.sequential" && supplied.id != "preset.diverging")
            drivers.push_back(edit("transfer." + supplied.id,
                                   transfer([supplied](const TransferFunction& old, const DrivenWindow& window) {
                                       return withPreset(old, supplied, PresetPart::Both,
                                                         rangeOf(window), // no Hounsfield units here
                                                         window.session().model()->diagonal());
                                   }),
                                   supplied.isHounsfield ? &beginWithTheMessage : &beginUneven));
    for (const ColourMap& map : colourMaps())
        preset("colours." + QString::fromStdString(map.id),
               [&map](const TransferFunction& old, const DrivenWindow& window) {
                   return withColourMap(old, map, rangeOf(window));
               });
    return drivers;
}

bool copiedAll(const DrivenWindow& window)
{
    const JoinedFunction points = joined(transferOf(window));
    return QGuiApplication::clipboard()->text().toStdString() == copyOfSelected(points, allPoints(points));
}

void selectAllWithNothingCopied(DrivenWindow& window)
{
    QGuiApplication::clipboard()->clear();
    selectAll(window);
}

void addIsovalueInTheMiddle(ViewValue& view, const DrivenWindow& window)
{
    Isovalue isovalue = nextIsovalue(view.isovalues, window.session().range());
    isovalue.value = middleOf(rangeOf(window));
    view.isovalues.push_back(isovalue);
}

} // namespace

Drivers transferCommands()
{
    const Drivers others{
        showing(
            "transfer.change.selectAll",
            [](const DrivenWindow& window) { return hasSelected(allPoints(joined(transferOf(window))))(window); },
            [](DrivenWindow& window) {
                beginUneven(window);
                selectNothing(window);
            }),
        showing("transfer.change.copy", &copiedAll, &selectAllWithNothingCopied),
        edit("transfer.change.addIsovalue", &addIsovalueInTheMiddle, &beginUneven),
        rule("stop", NeighbourRule::Stop),
        rule("push", NeighbourRule::Push),
        rule("pass", NeighbourRule::Pass),
        choice("transfer.axis.linear", "transfer.axis.logarithmic", false),
        choice("transfer.axis.squareRoot", "transfer.axis.linear", true),
        choice("transfer.axis.logarithmic", "transfer.axis.linear", false),
        choice("transfer.valueAxis.linear", "transfer.valueAxis.logarithmic", true),
        choice("transfer.valueAxis.logarithmic", "transfer.valueAxis.linear", false),
        looking("transfer.zoom.selection", &selectTwo, &zoomIn, false),
        looking("transfer.zoom.data", &reachBeyond, &zoomIn, false),
        looking("transfer.zoom.all", &reachBeyond, &zoomIn, true),
        opening("transfer.change.colour", "colourDialog", &selectTwo),
        opening("transfer.change.spread.numbers", "transfer.rescale", &beginUneven),
        opening("transfer.save.paraview", "transferParaviewDialog", &beginUneven),
    };
    return allOf({wholeChanges(), pointChanges(), groups(), presetCommands(), others});
}

} // namespace tetra
