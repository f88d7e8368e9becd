// SPDX-License-Identifier: GPL-3.0-or-later
// How the actions of the menus File and Edit are driven.
#include "tests/ui/driving/driver.h"
#include "ui/session/recent_files.h"
#include "ui/session/sample_models.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>

namespace tetra {
namespace {

void fillRecentMenu(DrivenWindow& window)
{
    emit window.find<QMenu>("menu.recent").aboutToShow();
}

/// A model or a dataset, whichever it was, is opened anew.
Driver openingRecent()
{
    const auto before = std::make_shared<std::pair<std::shared_ptr<const Model>, std::shared_ptr<const Dataset>>>();
    return showing(
        "action.recent.*",
        [before](const DrivenWindow& window) {
            return window.session().model() != before->first || window.workbench.opening().dataset() != before->second;
        },
        [before](DrivenWindow& window) {
            fillRecentMenu(window);
            *before = {window.session().model(), window.workbench.opening().dataset()};
        });
}

Drivers savingCommands()
{
    return {
        opening("action.saveSession", "sessionDialog"), // the first time
        opening("action.saveSessionAs", "sessionDialog"), opening("action.savePicture", "pictureOptions"),
        opening("action.saveFilm", "filmOptions"),        opening("action.saveMesh", "meshDialog"),
        opening("action.saveSurfaces", "surfaceDialog"),  opening("action.saveStatistics", "statisticsDialog"),
    };
}

Drivers editCommands()
{
    return {
        showing(
            "action.undo", [](const DrivenWindow& window) { return window.session().view().isovalues.size() == 1; },
            [](DrivenWindow& window) { window.session().addIsovalue(); }),
        showing(
            "action.redo", [](const DrivenWindow& window) { return window.session().view().isovalues.size() == 2; },
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
        {"action.addIsovalue",
         [](const DrivenWindow& window) { return window.session().view().isovalues.size() == 2; }},
        opening("action.palette", "palette"),
    };
}

} // namespace

Drivers fileCommands()
{
    const Drivers files{
        opening("action.open", "openDialog"),
        opening("action.openWithOptions", "importFileDialog"),
        openingRecent(),
        showing("action.sample.*",
                [](const DrivenWindow& window) {
                    return window.session().model() && window.session().model()->path().parent_path() == sampleFolder();
                }),
        showing(
            "action.clearRecent", [](const DrivenWindow&) { return recentFiles().isEmpty(); }, &fillRecentMenu),
        showing("action.close", [](const DrivenWindow& window) { return window.isOpen("empty"); }),
        showing("action.quit", [](const DrivenWindow& window) { return !window.window.isVisible(); }),
    };
    return allOf({files, savingCommands(), editCommands()});
}

} // namespace tetra
