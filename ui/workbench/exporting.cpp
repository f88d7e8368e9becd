// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/exporting.h"

#include "core/picture/picture_file.h"
#include "core/picture/text_file.h"
#include "core/view/accuracy_scale.h"
#include "plugins/host/output_check.h"
#include "ui/scenes/picture_image.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <tan/packed.h>
#include <tan/query.h>

#include <array>

namespace tetra {

Exporting::Exporting(PluginHost& host, Session& session, SceneService& scenes)
    : host_(host), session_(session), scenes_(scenes)
{
}

void Exporting::savePicture(const PictureOrder& order)
{
    if (!order.target.empty() && !tellSave(checkPictureFormat(order.target, order.transparent)))
        return;
    const Renderer* renderer = scenes_.renderer();
    std::optional<SceneRequest> ofItsOwn; // a scene for this camera and size, if the mode depends on them
    if (session_.model() && renderer != nullptr && renderer->needs().view && order.scene) {
        ofItsOwn = scenes_.sceneRequest();
        ofItsOwn->camera = order.camera;
        ofItsOwn->width = order.width;
        ofItsOwn->height = order.height;
    }
    savingPicture_.enqueue(
        [this, order, ofItsOwn, model = session_.model()](const Progress& progress) -> std::function<void()> {
            const auto picture = ofItsOwn ? drawPicture(order, *ofItsOwn, progress) : drawPicture(order, progress);
            const Status right = model ? model->confirm(progress.withCallback({})) : Status();
            const Status done = !picture               ? Status(picture.error())
                                : !right               ? right
                                : order.target.empty() ? Status()
                                                       : writeOrdered(order, *picture);
            return [this, order, done, picture] {
                if (!tellSave(done))
                    return;
                if (order.target.empty())
                    emit pictureDrawn(order.transparent ? imageOf(*picture)
                                                        : imageOf(*picture).convertToFormat(QImage::Format_RGB32));
                else
                    emit pictureSaved(pathText(order.target));
            };
        });
}

FilmOrder Exporting::filmOrder() const
{
    FilmOrder order;
    order.model = session_.model();
    order.renderer = scenes_.renderer();
    order.parameters = scenes_.renderingParameters();
    order.view = session_.view();
    order.samples = scenes_.sessionRequest().samples;
    return order;
}

void Exporting::saveFilm(const FilmOrder& order)
{
    filmTarget_ = order.target;
    savingFilm_.enqueue([this, order](const Progress& progress) -> std::function<void()> {
        return [this, order, written = writeFilm(order, progress)] {
            if (tellSave(written))
                emit filmSaved(pathText(order.target));
        };
    });
}

/// The mesh of the present query. If it is the one on the screen, that is used; where two meshes are blended it is
/// extracted.
MeshOrder Exporting::meshOrder(const std::filesystem::path& target) const
{
    MeshOrder order{session_.model(), nullptr,
                    meshQuery(session_.view().query, *session_.model(), presentView(session_.view())), target};
    const Renderer* renderer = scenes_.renderer();
    const bool isBlended = renderer != nullptr && renderer->needs().focusMesh;
    // While the worker is busy its mesh may be that of a picture to come.
    if (!isBlended && !scenes_.sceneBuilder().busy() && session_.showsQuery())
        order.mesh = scenes_.sceneBuilder().mesh();
    return order;
}

void Exporting::saveMesh(const std::filesystem::path& target)
{
    if (!tellModel())
        return;
    saveMesh(target,
             [this, order = meshOrder(target)](const Progress& progress) { return writeMesh(host_, order, progress); });
}

void Exporting::saveSurfaces(const std::filesystem::path& target)
{
    if (!tellModel())
        return;
    SurfaceOrder order{scenes_.sessionRequest(), std::nullopt, target};
    // While the worker is busy its scene may be another one.
    if (!scenes_.previewedView() && !scenes_.sceneBuilder().busy() && session_.showsQuery())
        order.built = scenes_.sceneBuilder().last();
    saveMesh(target, [this, order](const Progress& progress) { return writeSurfaces(host_, order, progress); });
}

void Exporting::saveSolids(const std::filesystem::path& target, const SurfaceMaking& making, bool deviation)
{
    if (!tellModel())
        return;
    const SolidOrder order{meshOrder(target), session_.view().isovalues, making, deviation};
    savingMesh_.enqueue([this, order](const Progress& progress) -> std::function<void()> {
        return [this, target = order.mesh.target, report = writeSolids(host_, order, progress)] {
            if (tellSave(report ? Status() : Status(report.error())))
                emit solidsSaved(pathText(target), translatedMessage(*report));
        };
    });
}

void Exporting::saveMesh(const std::filesystem::path& target,
                         const std::function<Result<FileRemarks>(const Progress&)>& write)
{
    savingMesh_.enqueue([this, target, write](const Progress& progress) -> std::function<void()> {
        return [this, target, saved = write(progress)] {
            if (!tellSave(saved ? Status() : Status(saved.error())))
                return;
            QStringList remarks;
            for (const Message& remark : *saved)
                remarks << translatedMessage(remark);
            emit meshSaved(pathText(target), remarks);
        };
    });
}

void Exporting::saveStatistics(const std::filesystem::path& target)
{
    if (!tellModel())
        return;
    std::vector<Accuracy> levels;
    for (const double error : accuracyPresets)
        levels.push_back(session_.view().query.warping.with(error));
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

void Exporting::savePacked(const std::filesystem::path& target)
{
    if (!tellModel())
        return;
    savingPacked_.enqueue([this, target, model = session_.model()](const Progress& progress) -> std::function<void()> {
        const Status distinct = checkOutput(target, std::array{model->path()});
        const auto report = distinct ? packModel(*model, target, progress) : Result<PackReport>(distinct.error());
        return [this, target, report, unpackedBytes = model->fileSize()] {
            if (tellSave(report ? Status() : Status(report.error())))
                emit packedSaved(pathText(target), report->fileBytes, unpackedBytes);
        };
    });
}

void Exporting::saveText(const std::filesystem::path& target, const std::string& text)
{
    savingText_.enqueue([this, target, text](const Progress&) -> std::function<void()> {
        return [this, target, saved = writeTextFile(target, text)] {
            if (tellSave(saved))
                emit textSaved(pathText(target));
        };
    });
}

void Exporting::loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use)
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

bool Exporting::saving() const noexcept
{
    return savingText_.running() || savingMesh_.running() || savingPacked_.running() || savingPicture_.running();
}

/// The model may have been closed while the user chose a file.
bool Exporting::tellModel()
{
    if (!session_.model())
        emit saveFailed(tr("Nothing was saved: the model was closed in the meantime."));
    return session_.model() != nullptr;
}

void Exporting::tell(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled)
        emit failed(translatedMessage(error.message));
}

bool Exporting::tellSave(const Status& saved)
{
    if (!saved && saved.error().kind != ErrorKind::Cancelled)
        emit saveFailed(translatedMessage(saved.error().message));
    return saved.ok();
}

} // namespace tetra
