// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Accuracy and Statistics are driven, and what each changes (R26).
#include "plugins/widgets/number_text.h"
#include "tests/ui/driving/driver.h"
#include "ui/session/accuracy_scale.h"

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

void beginInStatistics(DrivenWindow& window)
{
    window.session().setError(noPreset);
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
        opening("statistics.save", "statisticsDialog", &beginInStatistics),
    };
    return allOf({accuracy, presets(), statistics});
}

} // namespace tetra
