// SPDX-License-Identifier: GPL-3.0-or-later
// How the controls of the docks Accuracy and Statistics are driven.
#include "tests/ui/driving/driver.h"
#include "ui/session/accuracy_scale.h"

#include <QClipboard>
#include <QGuiApplication>

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

bool isByBudget(const DrivenWindow& window)
{
    return window.session().view().query.byBudget;
}

bool hasOtherError(const DrivenWindow& window)
{
    return window.session().view().query.error != window.before().query.error && window.settled();
}

Drivers presets()
{
    Drivers drivers;
    for (const double percent : accuracyPresets)
        drivers.push_back(
            {"accuracy.preset." + QString::number(percent),
             [percent](const DrivenWindow& window) { return window.session().view().query.error == percent; },
             &beginBetweenPresets});
    return drivers;
}

} // namespace

Drivers accuracyControls()
{
    const Drivers accuracy{
        {"accuracy.curve", &hasOtherError, &beginBetweenPresets},
        {"accuracy.slider", &hasOtherError, &beginBetweenPresets},
        {"accuracy.box", &hasOtherError, &beginBetweenPresets},
        {"accuracy.budget", &isByBudget, inDock("dock.accuracy")},
        {"accuracy.byBudget", &isByBudget, inDock("dock.accuracy")},
        {"accuracy.byError", [](const DrivenWindow& window) { return !isByBudget(window); }, &beginByBudget},
    };
    const Drivers statistics{
        {"statistics.table", &hasOtherError, &beginInStatistics},
        {"statistics.curve", &hasOtherError, &beginInStatistics},
        showing(
            "statistics.copy", [](const DrivenWindow&) { return QGuiApplication::clipboard()->text().contains('\t'); },
            [](DrivenWindow& window) {
                QGuiApplication::clipboard()->clear();
                window.raise("dock.statistics");
            }),
        opening("statistics.save", "statisticsDialog", &beginInStatistics),
    };
    return allOf({accuracy, presets(), statistics});
}

} // namespace tetra
