// SPDX-License-Identifier: GPL-3.0-or-later
// What of the session goes into files: pictures, meshes, surfaces, statistics, small texts.
#include "core/model/level_text.h"
#include "ui/session/accuracy_scale.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"
#include "ui/session/workbench.h"

#include <QFileInfo>

namespace tetra {

QString Workbench::proposedPath(const QString& ending) const
{
    const std::filesystem::path& path = session_.model()->path();
    const QFileInfo model(pathText(path == lookPath_ ? buildTarget_ : path)); // looks go with the program
    return model.absolutePath() + "/" + model.completeBaseName() + ending;
}

void Workbench::saveText(const std::filesystem::path& target, const std::string& text)
{
    textFiles_.start([this, target, text](const Progress&) -> std::function<void()> {
        return [this, target, saved = writeTextFile(target, text)] {
            if (saved)
                emit textSaved(pathText(target));
            else
                tell(saved.error());
        };
    });
}

void Workbench::loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use)
{
    textFiles_.start([this, path, use = std::move(use)](const Progress&) -> std::function<void()> {
        return [this, path, use, text = readTextFile(path)] {
            if (!text)
                return tell(text.error());
            if (const Status used = use(*text); !used)
                tell({used.error().kind, "In '" + path.string() + "': " + used.error().text});
        };
    });
}

void Workbench::saveMesh(const std::filesystem::path& target)
{
    meshTarget_ = target;
    savesSurfaces_ = false;
    saveMeshWhenShown();
}

void Workbench::saveSurfaces(const std::filesystem::path& target)
{
    meshTarget_ = target;
    savesSurfaces_ = true;
    saveMeshWhenShown();
}

void Workbench::saveStatistics(const std::filesystem::path& target)
{
    std::vector<Accuracy> levels;
    for (const double error : accuracyPresets)
        levels.push_back(bothWithin(error));
    textFiles_.start(
        [this, target, levels, model = session_.model()](const Progress& progress) -> std::function<void()> {
            const auto text = levelsFor(target, *model, levels);
            const Status right = text ? model->confirm(progress.withCallback({})) : Status(text.error());
            return [this, target, saved = right ? writeTextFile(target, *text) : right] {
                if (saved)
                    emit textSaved(pathText(target));
                else
                    tell(saved.error());
            };
        });
}

void Workbench::saveMeshWhenShown()
{
    MeshOrder order{session_.model(), sceneBuilder_.mesh(), session_.shown() ? session_.shown()->query : MeshQuery(),
                    meshTarget_};
    // While the worker is busy its mesh may be that of a picture to come.
    if (meshTarget_.empty() || sceneBuilder_.busy() || !session_.showsQuery() || !order.mesh)
        return;
    // Of two meshes that are blended neither is what was asked for.
    if (renderer() != nullptr && renderer()->blendsFocus())
        order.mesh = nullptr;
    meshTarget_.clear();
    savingMesh_.start([this, order, surfaces = savesSurfaces_,
                       isovalues = session_.view().isovalues()](const Progress& progress) -> std::function<void()> {
        const Status result = surfaces ? writeSurfaces({order, isovalues}, progress) : writeMesh(order, progress);
        return [this, target = order.target, saved = result] {
            if (saved)
                emit meshSaved(pathText(target));
            else
                tell(saved.error());
        };
    });
}

} // namespace tetra
