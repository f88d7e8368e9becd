// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/mesh_saving.h"
#include "ui/scenes/scene_service.h"
#include "ui/work/long_task.h"
#include "ui/workbench/film_file.h"

namespace tetra {

/// What of the session goes into files: pictures, films, meshes, surfaces, statistics and small texts. Each kind is
/// written one after the other in a worker, and the outcome of each order is told, by the signal of its kind or by
/// saveFailed().
class Exporting : public QObject {
    Q_OBJECT
public:
    /// All three outlive it.
    Exporting(PluginHost& host, Session& session, SceneService& scenes);

    /// Saves a picture, or copies it.
    void savePicture(const PictureOrder& order);
    /// A film of the session's animation: what it takes of the model. There must be one, and a way to show it.
    FilmOrder filmOrder() const;
    void saveFilm(const FilmOrder& order);
    /// Of the last film that was ordered.
    const std::filesystem::path& filmTarget() const noexcept { return filmTarget_; }
    /// Saves the mesh of the present query, even if the picture does not show it yet. Without a model nothing is saved,
    /// here and below; that is told.
    void saveMesh(const std::filesystem::path& target);
    /// Saves those surfaces of its scene that can be saved (Drawable::saved), likewise.
    void saveSurfaces(const std::filesystem::path& target);
    /// Saves the isosurfaces that are visible, of the present query's mesh, made as they are not seen: as solids.
    void saveSolids(const std::filesystem::path& target, const SurfaceMaking& making, bool deviation);
    /// Saves the sizes of the model's meshes at the usual accuracies, as .csv or .json.
    void saveStatistics(const std::filesystem::path& target);
    /// Packs the model, which must be a whole one; not into its own file.
    void savePacked(const std::filesystem::path& target);
    /// Writes a small text: a transfer function, a camera.
    void saveText(const std::filesystem::path& target, const std::string& text);
    /// Reads one and gives it to `use`, in this thread; an error of `use` is told with the file's name, by failed().
    void loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use);

    LongTask& savingPicture() noexcept { return savingPicture_; }
    LongTask& savingFilm() noexcept { return savingFilm_; }
    LongTask& savingMesh() noexcept { return savingMesh_; }
    LongTask& savingPacked() noexcept { return savingPacked_; }
    LongTask& savingText() noexcept { return savingText_; }
    /// Whether a file is being written that is no film.
    bool saving() const noexcept;

signals:
    void failed(const QString& text);
    void saveFailed(const QString& text);
    void pictureSaved(const QString& path);
    void pictureDrawn(const QImage& picture); ///< one that was ordered without a target
    void filmSaved(const QString& path);
    void meshSaved(const QString& path, const QStringList& remarks); ///< on the file; translated
    void solidsSaved(const QString& path, const QString& report);    ///< what they are, in sentences
    void packedSaved(const QString& path, quint64 bytes, quint64 unpackedBytes);
    void textSaved(const QString& path);

private:
    MeshOrder meshOrder(const std::filesystem::path& target) const;
    void saveMesh(const std::filesystem::path& target,
                  const std::function<Result<FileRemarks>(const Progress&)>& write);
    /// Whether there is a model; else it is told.
    bool tellModel();
    void tell(const Error& error);
    /// Whether it worked; else it is told.
    bool tellSave(const Status& saved);

    PluginHost& host_;
    Session& session_;
    SceneService& scenes_;
    std::filesystem::path filmTarget_;
    LongTask savingPicture_;
    LongTask savingFilm_;
    LongTask savingMesh_;
    LongTask savingPacked_;
    LongTask savingText_;
    LongTask loadingText_;
};

} // namespace tetra
