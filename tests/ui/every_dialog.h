// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/dialogs/address_dialog.h"
#include "ui/window/leaving.h"

#include <QAbstractButton>
#include <QAction>
#include <QDockWidget>

#include <functional>
#include <vector>

namespace tetra {

/// A dialog of our own, or a popup that works like one, and how it is opened in a window with a model.
struct OpenableDialog {
    const char* name; ///< object name
    std::function<void(WindowFixture&)> open;
};

/// All of them; `volume` and `raw` are files of a dataset, the second one without a header.
inline std::vector<OpenableDialog> everyDialog(const QString& volume, const QString& raw)
{
    const auto byAction = [](const char* action) {
        return [action](WindowFixture& window) { window.find<QAction>(QString("action.") + action).trigger(); };
    };
    const auto import = [](const QString& path) {
        return [path](WindowFixture& window) {
            window.workbench.opening().openWithOptions(path);
            const auto isOpen = [&window] {
                const auto* dialog = window.window.findChild<QWidget*>("importDialog");
                return dialog != nullptr && dialog->isVisible();
            };
            if (!waitFor(isOpen))
                qFatal("%s is not asked about", qPrintable(path));
        };
    };
    const auto openPresets = [](WindowFixture& window) {
        auto& dock = window.find<QDockWidget>("dock.transfer");
        dock.show();
        dock.raise();
        window.find<QAbstractButton>("transfer.presets").click();
    };
    return {
        {"pluginWindow", byAction("plugins")},
        {"aboutBox", byAction("about")},
        {"addressDialog", byAction("openAddress")},
        {"tokenDialog",
         [](WindowFixture& window) {
             askForToken(&window.window, "tokenDialog", "tan+http://volumes.example.org:8080/engine.tan",
                         [](const QString&) {});
         }},
        {"cacheDialog", byAction("modelCache")},
        {"bookmarkDialog", byAction("bookmark.edit")},
        {"palette", byAction("palette")},
        {"pictureOptions", byAction("savePicture")},
        {"filmOptions", byAction("saveFilm")},
        {"importDialog", import(volume)},
        {"importDialog", import(raw)},
        {"leaving.build",
         [](WindowFixture& window) {
             askAboutBuild({LeavingWay::Quit, "headsq_64x64x93_int16.nhdr", "7 % done, about 1 min 20 s left.",
                            "headsq_64x64x93_int16.tan", false, true},
                           &window.window);
         }},
        {"leaving.build",
         [](WindowFixture& window) {
             askAboutBuild({LeavingWay::OpenModel, "headsq_64x64x93_int16.nhdr", "7 % done, about 1 min 20 s left.",
                            "headsq_64x64x93_int16.tan", true, true},
                           &window.window);
         }},
        {"leaving.film",
         [](WindowFixture& window) {
             askAboutFilm(
                 {LeavingWay::OpenModel, "headsq_64x64x93_int16-film.png", "7 % done, about 1 min 20 s left.", {}, {}},
                 &window.window);
         }},
        {"leaving.session",
         [](WindowFixture& window) {
             askAboutSession({LeavingWay::Quit, "headsq_64x64x93_int16.tansession", {}, {}, {}}, &window.window);
         }},
        {"leaving.saving", [](WindowFixture& window) { askAboutSaving(LeavingWay::Quit, &window.window); }},
        {"leaving.saving", [](WindowFixture& window) { askAboutSaving(LeavingWay::OpenModel, &window.window); }},
        {"transfer.presetPopup", openPresets},
        {"transfer.presetName",
         [openPresets](WindowFixture& window) {
             openPresets(window);
             window.find<QAbstractButton>("transfer.presetPopup.save").click();
         }},
        {"transfer.rescale",
         [](WindowFixture& window) { window.find<QAction>("transfer.change.spread.numbers").trigger(); }},
    };
}

} // namespace tetra
