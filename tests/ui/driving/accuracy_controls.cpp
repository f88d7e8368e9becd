// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Accuracy and Statistics are driven, and what each changes (R26).
#include "core/view/accuracy_scale.h"
#include "core/view/appearance.h"
#include "plugins/samples/samples.h"
#include "plugins/widgets/number_text.h"
#include "tests/ui/driving/driver.h"
#include "tests/ui/folded_model.h"
#include "tests/waiting.h"

#include <tan/view.h>

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>

namespace tetra {
namespace {

constexpr double noPreset = 1.5; // %

void beginBetweenPresets(DrivenWindow& window)
{
    window.session().setError(noPreset);
    window.raise("dock.accuracy");
}

void beginByBudget(DrivenWindow& window)
{
    window.session().setByBudget(true);
    window.raise("dock.accuracy");
}

/// With a model that warps.
Driver::Step withWarping(const WarpingChoice& warping)
{
    return [warping](DrivenWindow& window) {
        const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
        if (!grid)
            qFatal("the grid could not be made");
        window.window.open(QString::fromStdString(buildSampleModel(*window.host, *grid, window.folderPath())));
        const auto isOpen = [&window] {
            return window.session().model() && window.session().model()->description().warpingWeight > 0 &&
                   window.settled();
        };
        if (!waitFor(isOpen, 30'000))
            qFatal("the model of the grid did not open");
        window.session().setError(noPreset);
        window.session().setWarping(warping);
        window.session().undoStack().clear();
        window.raise("dock.accuracy");
    };
}

Driver::Change toWarping(const WarpingChoice& warping)
{
    return [warping](ViewValue& view, const DrivenWindow&) { view.query.warping = warping; };
}

void beginInStatistics(DrivenWindow& window)
{
    window.session().setError(noPreset);
    window.raise("dock.statistics");
}

/// With a model that lists faulty cells.
void beginWithFaultyCells(DrivenWindow& window)
{
    const std::filesystem::path path = window.folderPath() + "/folded.tan";
    if (!buildFoldedModel(path).ok())
        qFatal("the model of the folded grid could not be made");
    window.window.open(QString::fromStdString(path.string()));
    if (!waitFor([&] { return window.session().model()->path() == path && window.settled(); }, 30'000))
        qFatal("the model of the folded grid did not open");
    window.session().undoStack().clear();
    window.raise("dock.statistics");
}

Driver::Change toError(double percent)
{
    return [percent](ViewValue& view, const DrivenWindow&) { view.query.error = percent; };
}

Driver::Change toBudget(bool on)
{
    return [on](ViewValue& view, const DrivenWindow&) { view.query.byBudget = on; };
}

Drivers presets()
{
    Drivers drivers;
    for (const double percent : accuracyPresets)
        drivers.push_back(edit("accuracy.preset." + QString::number(percent), toError(percent), &beginBetweenPresets));
    return drivers;
}

/// With the percentages: tabs between the columns, a line for each preset.
bool copiedTheTable(const DrivenWindow&)
{
    const QString text = QGuiApplication::clipboard()->text();
    return std::ranges::all_of(accuracyPresets,
                               [&text](double percent) { return text.contains('\n' + percentText(percent) + '\t'); });
}

} // namespace

/// Up and right are one round number away from 1.5: up coarser, right finer.
Drivers accuracyControls()
{
    const Drivers accuracy{
        edit("accuracy.curve", toError(2), &beginBetweenPresets), // by the arrow down
        edit("accuracy.slider", toError(1.2), &beginBetweenPresets),
        edit("accuracy.box", toError(2), &beginBetweenPresets),
        edit(
            "accuracy.budget",
            [](ViewValue& view, const DrivenWindow&) {
                view.query.byBudget = true;
                view.query.budget = 500'000; // the next round number
            },
            inDock("dock.accuracy")),
        edit("accuracy.warpingLimit", toWarping({WarpingLimit::Own, noPreset}), withWarping({})), // as the error first
        edit("accuracy.warping", toWarping({WarpingLimit::Own, 4}), withWarping({WarpingLimit::Own, 3})),
        edit("accuracy.byBudget", toBudget(true), inDock("dock.accuracy")),
        edit("accuracy.byError", toBudget(false), &beginByBudget),
    };
    const Drivers statistics{
        edit("statistics.table", toError(accuracyPresets.front()), &beginInStatistics), // to its first line
        edit("statistics.curve", toError(2), &beginInStatistics),
        showing("statistics.copy", &copiedTheTable,
                [](DrivenWindow& window) {
                    QGuiApplication::clipboard()->clear();
                    window.raise("dock.statistics");
                }),
        edit(
            "statistics.faultyCells",
            [](ViewValue& view, const DrivenWindow&) { view.appearance.settings[faultyCellsId] = true; },
            &beginWithFaultyCells),
        opening("statistics.save", "statisticsDialog", &beginInStatistics),
    };
    return allOf({accuracy, presets(), statistics});
}

} // namespace tetra
