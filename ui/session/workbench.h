// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/build_estimate.h"
#include "plugins/host/live_build.h"
#include "plugins/host/plugin_host.h"
#include "ui/annotations/annotation_content.h"
#include "ui/session/draft_builder.h"
#include "ui/session/film_file.h"
#include "ui/session/import_question.h"
#include "ui/session/kept_views.h"
#include "ui/session/mesh_saving.h"
#include "ui/session/picture_file.h"
#include "ui/session/scene_builder.h"
#include "ui/session/session.h"
#include "ui/session/session_document.h"
#include "ui/work/long_task.h"

#include <tan/data.h>

#include <QSize>
#include <QTemporaryDir>
#include <QTimer>

#include <atomic>
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

/// What a session was read from.
enum class SessionSource {
    File,    ///< of its own, which it is saved in from now on
    Picture, ///< that shows it
    Lost,    ///< what was kept of it by a program that ended unexpectedly
};

/// Everything that the window can do, without the window: opens files, builds models, keeps the scene up to date with
/// the session. All work is done in workers; signals come in the thread that it lives in. Errors are told by failed().
class Workbench : public QObject {
    Q_OBJECT
public:
    /// `host` outlives it. How models are seen is kept in the folder `views`.
    explicit Workbench(PluginHost& host, std::filesystem::path views = viewFolder());
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
    /// What building it is expected to take follows from this; zeros without one. Made in the worker that read it.
    const BuildSize& buildSize() const noexcept { return buildSize_; }

    /// Filters for a file dialog: all that can be opened first.
    QStringList nameFilters();
    /// Opens a model, a session, or a dataset by the reader that fits it best; asks by choicesNeeded() where there is a
    /// choice.
    void open(const QString& path);
    /// Opens what a session says that the file holds.
    void openSession(const std::filesystem::path& path, SessionSource source);
    /// What is open and how it is seen; nothing without a model, or while a build is watched. The camera and the
    /// background are the window's.
    std::optional<SessionDocument> sessionDocument() const;
    /// The file of the session that is open; empty if it has none.
    const std::filesystem::path& sessionFile() const noexcept { return sessionFile_; }
    /// Whether that has changes which are not in its file. A model that is not part of a session has none: how it is
    /// seen is kept by itself.
    bool sessionModified() const { return !sessionFile_.empty() && !session_.undoStack().isClean(); }
    /// `then`: with whether it worked.
    void saveSession(const std::filesystem::path& target, const SessionDocument& document,
                     const std::function<void(bool saved)>& then = {});
    /// How models are seen that are not part of a session.
    KeptViews& views() noexcept { return views_; }
    /// How the model would be seen if nobody had ever looked at it; but for the camera. There must be one.
    SessionDocument startingView() const;
    /// Asks by choicesNeeded() how a dataset is to be read, whether it must be known or not.
    void openWithOptions(const QString& path);
    /// Makes the sample of that name (sampleKinds()) unless it is there from before, and opens its model.
    void openSample(const std::string& name);
    /// Draws small pictures of the samples in a worker, once, each told by thumbnailDrawn(). While a file is read they
    /// wait until it has been.
    void drawThumbnails();
    LongTask& thumbnails() noexcept { return thumbnails_; }
    /// The same for the file of the dataset that is open.
    void readDifferently();
    /// Opens a dataset so; ends with datasetOpened() or importFailed().
    void importDataset(const std::filesystem::path& path, const ImportOptions& options);
    /// Builds a model of the dataset, and opens it.
    void build(const BuildOrder& order);
    /// Ends the build; `keep`: what is finished becomes the model, of less accuracy.
    void stopBuild(bool keep);
    /// The dataset and the file of the build that runs.
    const QString& buildName() const noexcept { return buildName_; }
    const std::filesystem::path& buildTarget() const noexcept { return buildTarget_; }
    /// Whether the model of the build that runs is what is seen, as far as it is made.
    bool showsBuild() const { return building_.running() && showsLook(); }
    /// Whether what is finished of that build can become a model.
    bool canKeepBuild() const { return live_ && live_->hasMesh(); }
    /// Whether a model was built of the dataset that is open.
    bool datasetIsBuilt() const noexcept { return dataset_ && dataset_ == built_; }
    /// Whether there is something to close.
    bool hasSomethingOpen() const;
    /// Closes the model, and with it the dataset that it was built of; without a model the dataset, unless that is
    /// being built.
    void close();
    void closeModel();
    /// Asked before what was read is shown, in place of the model that is open or, of a dataset, beside it: calls `go`,
    /// or `stay`. Without one nothing is asked.
    using Gate = std::function<void(bool isModel, const std::function<void()>& go, const std::function<void()>& stay)>;
    void setGate(Gate gate) { gate_ = std::move(gate); }
    /// Where a file about the model goes unless the user says otherwise: beside it, or while its build is watched to
    /// where it will be; of a sample to the user's documents. `ending` follows the model's name. There must be a model.
    QString proposedPath(const QString& ending) const;
    /// Where the model is seen from, in a picture of this size in pixels: for renderers whose scenes depend on it.
    void setSeenFrom(const Camera& camera, QSize pixels);
    /// Saves a picture, or copies it, once those that were ordered before are done.
    void savePicture(const PictureOrder& order);
    LongTask& savingPicture() noexcept { return savingPicture_; }
    /// What the annotations of a picture of what is shown say, seen by `camera` before `background`.
    AnnotationContent annotations(const Camera& camera, const Colour& background) const;
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
    /// Of that film.
    const std::filesystem::path& filmTarget() const noexcept { return filmTarget_; }
    /// Saves the mesh that is asked for now, whether the picture shows it already or not. There must be a model.
    void saveMesh(const std::filesystem::path& target);
    /// Saves the surfaces that the scene of that mesh says can be saved, likewise.
    void saveSurfaces(const std::filesystem::path& target);
    /// Saves the sizes of the model's meshes at the usual accuracies, as .csv or .json.
    void saveStatistics(const std::filesystem::path& target);
    /// Writes a small text: a transfer function, a camera.
    void saveText(const std::filesystem::path& target, const std::string& text);
    /// Reads one and gives it to `use`, in this thread; what that says against it is told with the file's name.
    void loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use);
    LongTask& savingMesh() noexcept { return savingMesh_; }
    LongTask& savingText() noexcept { return savingText_; }
    /// Whether a file is being written that is neither a model nor a film.
    bool saving() const noexcept;

signals:
    /// Something could not be opened or shown.
    void failed(const QString& text);
    /// A file was not written.
    void saveFailed(const QString& text);
    /// Something is about to be read.
    void opening();
    /// What is open is about to give way, the last moment to look at it.
    void leaving();
    void datasetOpened();
    void datasetClosed();
    void choicesNeeded(const tetra::ImportQuestion& question);
    /// What the reader has against the choices; empty if the user stopped it.
    void importFailed(const QString& reason);
    /// A model is shown as somebody left it, like this; `from` is the file of the session or picture that says so,
    /// empty if that is how the model was seen last.
    void viewRestored(const tetra::SessionDocument& document, const std::filesystem::path& from);
    void sessionFileChanged();
    /// The build was asked to end.
    void buildStopping(bool keep);
    /// The build is done. Its model is shown next, unless the user has turned to something else.
    void modelBuilt(const QString& path, bool isShown);
    /// The build is over and its model shown, if it is; nothing more comes of it. `worked`: there is a model.
    void buildEnded(bool worked);
    void pictureSaved(const QString& path);
    void thumbnailDrawn(const std::string& sample, const QImage& picture);
    void pictureDrawn(const QImage& picture); ///< one that was ordered without a target
    void filmSaved(const QString& path);
    /// A picture was opened that holds the session by which it was made.
    void pictureOpened(const QString& path);
    void meshSaved(const QString& path);
    void textSaved(const QString& path);

private:
    /// A model that was read, and how to show it.
    struct OpenedModel {
        std::shared_ptr<const Model> model;
        FieldExtent field;
        std::optional<SessionDocument> view{}; ///< none: as at first
        std::filesystem::path from{};          ///< of the view, if that is not how the model was seen last
        SessionSource source = SessionSource::File;
    };
    struct ReadDataset {
        Result<Dataset> dataset;
        BuildSize size;
        ImportOptions options;
    };

    void read(LongTask::Work work);
    void startThumbnails();
    /// Either reads the file or asks for choices.
    void look(const std::filesystem::path& path, bool ask);
    Result<OpenedModel> openModel(const std::filesystem::path& path) const;
    Result<OpenedModel> openedBySession(const std::filesystem::path& path, SessionSource source) const;
    std::function<void()> whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress);
    std::function<void()> tellLater(const Error& error);
    void passGate(
        bool isModel, const std::function<void()>& go, const std::function<void()>& stay = [] {});
    ReadDataset readDataset(const std::filesystem::path& path, const ImportOptions& options, const Progress& progress);
    void datasetRead(const std::filesystem::path& path, const ReadDataset& read);
    void takeDataset(const std::filesystem::path& path, const ReadDataset& read);
    void closeDataset();
    void showModel(const OpenedModel& opened);
    bool prepareToShow(const OpenedModel& opened);
    void showSession(const SessionDocument& document, const OpenedModel& opened);
    void setSessionFile(const std::filesystem::path& file);

    void lookAtBuild();
    void showLook(const Result<std::shared_ptr<const Model>>& look, const FieldExtent& field,
                  const std::optional<SessionDocument>& view);
    void growTo(const std::shared_ptr<const Model>& model, const FieldExtent& field);
    void closeLook();
    void showBuilt(const BuildOrder& order, const Result<OpenedModel>& built);
    bool showsLook() const { return look_ != nullptr && session_.model() == look_; }
    const Renderer* renderer() const;
    SceneRequest sessionRequest() const;
    SceneRequest sceneRequest() const;
    void requestScene();
    void requestDrafts(const BuiltScene& scene);
    void watchForDamage();
    void lookForDamage();
    MeshOrder meshOrder(const std::filesystem::path& target) const;
    void saveMesh(const std::filesystem::path& target, const std::function<Status(const Progress&)>& write);
    void tell(const Error& error);
    /// Whether it worked; else it is told.
    bool tellSave(const Status& saved);

    PluginHost& host_;
    Session session_;
    std::shared_ptr<const Dataset> dataset_;
    BuildSize buildSize_{.points = 0};
    ImportOptions imported_; ///< how the dataset was opened
    std::vector<Provided<Renderer>> modes_;
    FieldExtent field_; ///< of the model that is open
    Camera camera_;     ///< setSeenFrom() with these
    QSize pixels_{1024, 768};
    KeptViews views_; ///< before the workers that look into it
    SceneBuilder sceneBuilder_;
    DraftBuilder draftBuilder_;
    LongTask reading_;
    LongTask sampling_;
    LongTask thumbnails_;
    bool thumbnailsWanted_ = false;
    LongTask building_;
    LongTask savingPicture_;
    LongTask savingFilm_;
    std::filesystem::path filmTarget_;
    std::optional<FilmFrame> preview_;
    LongTask savingMesh_;
    LongTask savingText_;
    LongTask loadingText_;
    Gate gate_;
    std::filesystem::path sessionFile_;
    QJsonObject sessionFound_; ///< the text of that file: what is not known here stays in it

    std::shared_ptr<LiveBuild> live_;         ///< of the build that is being watched
    std::shared_ptr<std::atomic<bool>> keep_; ///< of the same build
    QString buildName_;
    std::filesystem::path buildTarget_;
    std::shared_ptr<const Dataset> built_; ///< that a model was built of last
    bool turnedAway_ = false;              ///< from that build, to something else
    std::filesystem::path lookPath_;       ///< where looks at it are written
    std::shared_ptr<const Model> look_;    ///< the last one shown
    QTimer looking_;
    QTimer watching_; ///< the model's file for damage
    LongTask looker_;
    QTemporaryDir looks_;
};

} // namespace tetra
