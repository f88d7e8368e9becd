// SPDX-License-Identifier: GPL-3.0-or-later
// What of the session goes into files: pictures, meshes, surfaces, statistics, small texts.
#include "ui/session/accuracy_scale.h"
#include "ui/session/sample_models.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"
#include "ui/session/workbench.h"

#include <tan/query.h>

#include <QFileInfo>

namespace tetra {

QString Workbench::proposedPath(const QString& ending) const
{
    const std::filesystem::path& path = session_.model()->path();
    const QFileInfo model(pathText(path == lookPath_ ? buildTarget_ : path)); // looks go with the program
    // What lies beside a sample may be gone tomorrow.
    const QString folder = isOfSample(path) ? documentFolder() : model.absolutePath();
    return folder + "/" + model.completeBaseName() + ending;
}

void Workbench::saveText(const std::filesystem::path& target, const std::string& text)
{
    savingText_.enqueue([this, target, text](const Progress&) -> std::function<void()> {
        return [this, target, saved = writeTextFile(target, text)] {
            if (tellSave(saved))
                emit textSaved(pathText(target));
        };
    });
}

void Workbench::loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use)
{
    loadingText_.enqueue([this, path, use = std::move(use)](const Progress&) -> std::function<void()> {
        return [this, path, use, text = readTextFile(path)] {
            if (!text)
                return tell(text.error());
            if (const Status used = use(*text); !used)
                tell({used.error().kind, Message::say("In '%1': %2", path.string(), used.error().message)});
        };
    });
}

bool Workbench::saving() const noexcept
{
    return savingText_.running() || savingMesh_.running() || savingPicture_.running();
}

/// What is asked for now; of the mesh that is seen where that is the one. Of two meshes that are blended neither is.
MeshOrder Workbench::meshOrder(const std::filesystem::path& target) const
{
    MeshOrder order{session_.model(), nullptr, meshQuery(session_.view().query(), *session_.model()), target};
    const bool isBlended = renderer() != nullptr && renderer()->blendsFocus();
    // While the worker is busy its mesh may be that of a picture to come.
    if (!isBlended && !sceneBuilder_.busy() && session_.showsQuery())
        order.mesh = sceneBuilder_.mesh();
    return order;
}

void Workbench::saveMesh(const std::filesystem::path& target)
{
    saveMesh(target,
             [this, order = meshOrder(target)](const Progress& progress) { return writeMesh(host_, order, progress); });
}

void Workbench::saveSurfaces(const std::filesystem::path& target)
{
    saveMesh(target, [this, order = SurfaceOrder{meshOrder(target), session_.view().isovalues()}](
                         const Progress& progress) { return writeSurfaces(host_, order, progress); });
}

void Workbench::saveMesh(const std::filesystem::path& target, const std::function<Status(const Progress&)>& write)
{
    savingMesh_.enqueue([this, target, write](const Progress& progress) -> std::function<void()> {
        return [this, target, saved = write(progress)] {
            if (tellSave(saved))
                emit meshSaved(pathText(target));
        };
    });
}

void Workbench::saveStatistics(const std::filesystem::path& target)
{
    std::vector<Accuracy> levels;
    for (const double error : accuracyPresets)
        levels.push_back(bothWithin(error));
    savingText_.enqueue(
        [this, target, levels, model = session_.model()](const Progress& progress) -> std::function<void()> {
            const auto text = levelsAsText(target, *model, levels);
            Status saved = text ? model->confirm(progress.withCallback({})) : Status(text.error());
            if (saved)
                saved = writeTextFile(target, *text);
            return [this, target, saved] {
                if (tellSave(saved))
                    emit textSaved(pathText(target));
            };
        });
}

} // namespace tetra
