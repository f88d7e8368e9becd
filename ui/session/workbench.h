// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "plugins/host/build_estimate.h"
#include "plugins/host/live_build.h"
#include "plugins/host/plugin_host.h"
#include "ui/session/draft_builder.h"
#include "ui/session/film_file.h"
#include "ui/session/import_question.h"
#include "ui/session/mesh_saving.h"
#include "ui/session/picture_file.h"
#include "ui/session/scene_builder.h"
#include "ui/session/session.h"
#include "ui/session/session_document.h"
#include "ui/work/long_task.h"

#include <QTemporaryDir>
#include <QTimer>

#include <atomic>
#include <deque>
#include <filesystem>
#include <functional>

namespace tetra {

/// What to build, and where to.
struct BuildOrder {
    std::string builder; ///< id
    ParameterValues values;
    std::filesystem::path target;
    bool watch = true; ///< show the model while it grows, unless another one is open
};

/// Everything that the window can do, without the window: opens files, builds models, keeps the scene up to date with
/// the session. All work is done in workers; signals come in the thread that it lives in. Errors are told by failed().
class Workbench : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it.
    explicit Workbench(PluginHost& host, QObject* parent = nullptr);
    ~Workbench() override;

    PluginHost& host() noexcept { return host_; }
    Session& session() noexcept { return session_; }
    LongTask& reading() noexcept { return reading_; }
    LongTask& sampling() noexcept { return sampling_; }
    LongTask& building() noexcept { return building_; }
    SceneBuilder& sceneBuilder() noexcept { return sceneBuilder_; }
    DraftBuilder& draftBuilder() noexcept { return draftBuilder_; }
    /// The ways to look at a model; empty before the first one was opened.
    const std::vector<Provided<Renderer>>& modes() const noexcept { return modes_; }
    /// The parameters of the mode that is in use, fitting the model; empty without one.
    std::vector<Parameter> renderingParameters() const;
    /// Those of them that matter as they are set.
    std::vector<Parameter> matteringParameters() const;
    /// The dataset that models can be built of; none before one was opened.
    const std::shared_ptr<const Dataset>& dataset() const noexcept { return dataset_; }
    /// What building it is expected to take follows from this; zeros without one.
    const BuildSize& buildSize() const noexcept { return buildSize_; }

    /// Filters for a file dialog: all that can be opened first.
    QStringList nameFilters();
    /// Opens a model, a session, or a dataset by the reader that fits it best; asks by choicesNeeded() where there is a
    /// choice.
    void open(const QString& path);
    /// Opens the session that `text` describes, with paths from `folder` on; `file` is where it is saved from now on,
    /// empty if it has no file.
    void openSession(const std::string& text, const std::filesystem::path& folder,
                     const std::filesystem::path& file = {});
    /// What is open and how it is seen; nothing without a model, or while a build is watched. The camera and the
    /// background are the window's.
    std::optional<SessionDocument> sessionDocument() const;
    /// The file of the session that is open; empty if it has none.
    const std::filesystem::path& sessionFile() const noexcept { return sessionFile_; }
    void saveSession(const std::filesystem::path& target, const SessionDocument& document);
    /// Asks by choicesNeeded() how a dataset is to be read, whether it must be known or not.
    void openWithOptions(const QString& path);
    /// Makes the sample of that name (sampleKinds()) unless it is there from before, and opens its model.
    void openSample(const std::string& name);
    /// The same for the file of the dataset that is open.
    void readDifferently();
    /// Opens a dataset so; ends with datasetOpened() or importFailed().
    void importDataset(const std::filesystem::path& path, const ImportOptions& options);
    /// Builds a model of the dataset, and opens it.
    void build(const BuildOrder& order);
    /// Ends the build; `keep`: what is finished becomes the model, of less accuracy.
    void stopBuild(bool keep);
    void closeModel();
    /// Where a file about the model goes unless the user says otherwise: beside it, or while its build is watched to
    /// where it will be. `ending` follows the model's name. There must be a model.
    QString proposedPath(const QString& ending) const;
    /// Saves a picture, or copies it, once those that were ordered before are done.
    void savePicture(const PictureOrder& order);
    LongTask& savingPicture() noexcept { return savingPicture_; }
    /// Pictures that wait for the one that is being drawn.
    int picturesWaiting() const noexcept { return static_cast<int>(pictures_.size()); }
    /// Of the present view, which `camera` belongs to.
    FilmFrame presentFrame(const Camera& camera) const;
    /// A film of the session's animation: what it takes of the model. There must be one, and a way to show it.
    FilmOrder filmOrder(const Camera& camera) const;
    /// Shows a frame of a film in place of the session's view; nothing: that again. The camera is the viewport's.
    void previewFrame(const std::optional<FilmFrame>& frame);
    const std::optional<FilmFrame>& previewedFrame() const noexcept { return preview_; }
    /// One at a time: there must be none being saved.
    void saveFilm(const FilmOrder& order);
    LongTask& savingFilm() noexcept { return savingFilm_; }
    /// Saves the mesh of the picture, once that is up to date.
    void saveMesh(const std::filesystem::path& target);
    /// Saves the visible isosurfaces of that mesh, likewise.
    void saveSurfaces(const std::filesystem::path& target);
    /// Saves the sizes of the model's meshes at the usual accuracies, as .csv or .json.
    void saveStatistics(const std::filesystem::path& target);
    /// Writes a small text: a transfer function, a camera.
    void saveText(const std::filesystem::path& target, const std::string& text);
    /// Reads one and gives it to `use`, in this thread; what that says against it is told with the file's name.
    void loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use);
    LongTask& savingMesh() noexcept { return savingMesh_; }

signals:
    void failed(const QString& text);
    void datasetOpened();
    void choicesNeeded(const tetra::ImportQuestion& question);
    /// What the reader has against the choices; empty if the user stopped it.
    void importFailed(const QString& reason);
    /// A session's model is shown; this is how it was seen.
    void sessionOpened(const tetra::SessionDocument& document);
    /// The build is done; its model is opened next.
    void modelBuilt();
    void pictureSaved(const QString& path);
    void pictureDrawn(const QImage& picture); ///< one that was ordered without a target
    void picturesWaitingChanged();
    void filmSaved(const QString& path);
    /// A picture was opened that holds the session by which it was made.
    void pictureOpened(const QString& path, const std::string& session);
    void meshSaved(const QString& path);
    void textSaved(const QString& path);

private:
    /// Either reads the file or asks for choices.
    void look(const std::filesystem::path& path, bool ask);
    std::function<void()> whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress);
    void lookAtBuild();
    void showLook(const Result<std::shared_ptr<const Model>>& look);
    void closeLook();
    void showBuilt(const std::filesystem::path& target);
    bool showsLook() const { return look_ != nullptr && session_.model() == look_; }
    struct ReadDataset {
        Result<Dataset> dataset;
        BuildSize size;
        ImportOptions options;
    };
    ReadDataset readDataset(const std::filesystem::path& path, const ImportOptions& options, const Progress& progress);
    void datasetRead(const std::filesystem::path& path, const ReadDataset& read);
    std::function<void()> whenModelRead(const Result<std::shared_ptr<const Model>>& model);
    void showModel(const std::shared_ptr<const Model>& model, const FieldExtent& field);
    void showSession(const std::shared_ptr<const Model>& model, const FieldExtent& field,
                     const SessionDocument& document);
    bool prepareToShow(const std::shared_ptr<const Model>& model, const FieldExtent& field);
    const Renderer* renderer() const;
    SceneRequest sceneRequest() const;
    void requestScene();
    void requestDrafts(const BuiltScene& scene);
    void saveNextPicture();
    void openPicture(const std::filesystem::path& path);
    void saveMeshWhenShown();
    void watchForDamage();
    void lookForDamage();
    void tell(const Error& error);

    PluginHost& host_;
    Session session_;
    std::shared_ptr<const Dataset> dataset_;
    BuildSize buildSize_{.points = 0};
    ImportOptions imported_; ///< how the dataset was opened
    std::vector<Provided<Renderer>> modes_;
    FieldExtent field_; ///< of the model that is open
    SceneBuilder sceneBuilder_;
    DraftBuilder draftBuilder_;
    LongTask reading_;
    LongTask sampling_;
    LongTask building_;
    LongTask savingPicture_;
    LongTask savingFilm_;
    std::deque<PictureOrder> pictures_; ///< that wait
    std::optional<FilmFrame> preview_;
    LongTask savingMesh_;
    LongTask textFiles_;
    std::filesystem::path sessionFile_;
    QJsonObject sessionFound_;         ///< the text of that file: what is not known here stays in it
    std::filesystem::path meshTarget_; ///< of what waits to be saved; empty if nothing does
    bool savesSurfaces_ = false;       ///< the isosurfaces, not the mesh

    std::shared_ptr<LiveBuild> live_;         ///< of the build that is being watched
    std::shared_ptr<std::atomic<bool>> keep_; ///< of the same build
    std::filesystem::path buildTarget_;       ///< of that build
    std::filesystem::path lookPath_;          ///< where looks at it are written
    std::shared_ptr<const Model> look_;       ///< the last one shown
    QTimer looking_;
    QTimer watching_; ///< the model's file for damage
    LongTask looker_;
    QTemporaryDir looks_;
};

} // namespace tetra
