// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menus File and Edit are driven, and what each changes.
#include "core/view/appearance.h"
#include "plugins/samples/samples.h"
#include "tests/ui/driving/driver.h"
#include "ui/opening/recent_files.h"
#include "ui/opening/sample_models.h"
#include "ui/session/files.h"

#include <tan/view.h>

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

namespace tetra {
namespace {

void fillRecentMenu(DrivenWindow& window)
{
    emit window.find<QMenu>("menu.recent").aboutToShow();
}

/// What another file or none comes of.
Driver leaving(const QString& name, Driver::Condition shows, Driver::Step prepare = {})
{
    Driver driver = showing(name, std::move(shows), std::move(prepare));
    driver.opensAnother = true;
    return driver;
}

/// What was open, and the file of the entry that is used.
struct RecentUse {
    std::shared_ptr<const Model> model{};
    std::shared_ptr<const Dataset> dataset{};
    QString path{};
};

/// The model or the dataset of that very entry is opened anew, and the file is the one that was opened last; a dataset
/// leaves the model.
bool hasOpened(const DrivenWindow& window, const RecentUse& use)
{
    const auto& model = window.session().model();
    const auto& dataset = window.workbench.opening().datasets().dataset();
    if (use.path.isEmpty() || recentFiles().value(0) != use.path)
        return false;
    if (use.path.endsWith(".tan"))
        return model && model != use.model && model->path() == filePath(use.path);
    return dataset && dataset != use.dataset && dataset->source.path == use.path.toStdString() && model == use.model;
}

Driver openingRecent()
{
    const auto use = std::make_shared<RecentUse>();
    return leaving(
        "action.recent.*", [use](const DrivenWindow& window) { return hasOpened(window, *use); },
        [use](DrivenWindow& window) {
            fillRecentMenu(window);
            *use = {window.session().model(), window.workbench.opening().datasets().dataset(), {}};
            for (const QAction* entry : window.find<QMenu>("menu.recent").actions())
                if (entry->objectName().startsWith("action.recent."))
                    QObject::connect(entry, &QAction::triggered, entry, [use, entry] { use->path = entry->toolTip(); });
        });
}

/// Each opens the model of its own sample.
Drivers sampleCommands()
{
    Drivers drivers;
    for (const SampleKind& kind : sampleKinds()) {
        const std::string name(kind.name);
        drivers.push_back(leaving("action.sample." + QString::fromStdString(name), [name](const DrivenWindow& window) {
            return window.session().model() && window.session().model()->path() == sampleFolder() / (name + ".tan");
        }));
    }
    return drivers;
}

Drivers addressCommands()
{
    return {opening("action.openAddress", "addressDialog"), opening("action.modelCache", "cacheDialog")};
}

Drivers savingCommands()
{
    return {
        opening("action.saveSession", "sessionDialog"), // the first time
        opening("action.saveSessionAs", "sessionDialog"),
        opening("action.savePicture", "pictureOptions"),
        opening("action.saveFilm", "filmOptions"),
        opening("action.saveMesh", "meshDialog"),
        opening("action.saveSolids", "solidOptions"),
        opening("action.saveSurfaces", "surfaceDialog"),
        opening("action.saveStatistics", "statisticsDialog"),
        opening("action.savePacked", "packedDialog"),
    };
}

void addIsovalue(ViewValue& view, const DrivenWindow& window)
{
    view.isovalues.push_back(nextIsovalue(view.isovalues, window.session().range()));
}

void removeIsovalue(ViewValue& view, const DrivenWindow&)
{
    view.isovalues.pop_back();
}

Driver goingThroughEdits(const QString& name, int steps, Driver::Change changes, Driver::Step prepare)
{
    Driver driver = edit(name, std::move(changes), std::move(prepare));
    driver.steps = steps;
    return driver;
}

Drivers editCommands()
{
    return {
        goingThroughEdits("action.undo", -1, &removeIsovalue,
                          [](DrivenWindow& window) { window.session().addIsovalue(); }),
        goingThroughEdits("action.redo", 1, &addIsovalue,
                          [](DrivenWindow& window) {
                              window.session().addIsovalue();
                              window.session().undoStack().undo();
                          }),
        showing(
            "action.copyPicture",
            [](const DrivenWindow& window) {
                return QGuiApplication::clipboard()->image().size() == window.viewport().size();
            },
            [](DrivenWindow&) { QGuiApplication::clipboard()->clear(); }),
        edit("action.addIsovalue", &addIsovalue),
        opening("action.palette", "palette"),
    };
}

} // namespace

Drivers fileCommands()
{
    const Drivers files{
        opening("action.open", "openDialog"),
        opening("action.applyLook", "lookDialog"),
        opening("action.openWithOptions", "importFileDialog"),
        openingRecent(),
        showing(
            "action.clearRecent", [](const DrivenWindow&) { return recentFiles().isEmpty(); }, &fillRecentMenu),
        leaving("action.close", [](const DrivenWindow& window) { return window.isOpen("empty"); }),
        leaving("action.quit", [](const DrivenWindow& window) { return !window.window.isVisible(); }),
    };
    return allOf({files, addressCommands(), sampleCommands(), savingCommands(), editCommands()});
}

} // namespace tetra
