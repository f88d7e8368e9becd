// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/build_estimate.h"
#include "plugins/host/plugin_host.h"
#include "ui/session/session.h"
#include "ui/session/session_document.h"
#include "ui/work/long_task.h"
#include "ui/workbench/import_question.h"
#include "ui/workbench/kept_views.h"
#include "ui/workbench/restored_view.h"
#include "ui/workbench/scene_service.h"

#include <tan/data.h>

#include <QTimer>

#include <filesystem>
#include <functional>
#include <map>
#include <mutex>

namespace tetra {

/// What a session was read from.
enum class SessionSource {
    File,    ///< of its own, which it is saved in from now on
    Picture, ///< that shows it
    Lost,    ///< what was kept of it by a program that ended unexpectedly
};

/// A model that was read, and how to show it.
struct OpenedModel {
    std::shared_ptr<const Model> model{};
    FieldExtent field{};
    std::optional<SessionDocument> view{}; ///< none: as at first
    std::filesystem::path from{};          ///< of the view, if that is not how the model was seen last
    SessionSource source = SessionSource::File;
    bool isLocated = false; ///< the user has said where the model of the session is
    /// It is a model under way, as far as it is built or has come; where it will be when it is done.
    std::filesystem::path becomes{};
    /// Of a model of which only the beginning was read: how much there is.
    std::uint32_t sitesOfWhole = 0;
    std::uint64_t bytesOfWhole = 0;
    std::uint64_t bytesRead = 0;
};

/// Opens models, sessions, datasets and samples, and closes them. A model that is packed or on a server is shown while
/// it comes; sessions are saved, too, and how models are seen is kept. What is read is read in a worker, the newest
/// only; what was read passes a gate before it takes the place of what is open.
class Opening : public QObject {
    Q_OBJECT
public:
    /// All outlive it. How models are seen is kept in the folder `views`.
    Opening(PluginHost& host, Session& session, SceneService& scenes, std::filesystem::path views);
    ~Opening() override;

    LongTask& reading() noexcept { return reading_; }
    LongTask& sampling() noexcept { return sampling_; }
    LongTask& thumbnails() noexcept { return thumbnails_; }
    LongTask& savingSession() noexcept { return savingSession_; }

    /// Filters for a file dialog: all that can be opened first.
    QStringList nameFilters();
    /// Opens a model, a session, or a dataset by the reader that fits it best; asks by choicesNeeded() where there is a
    /// choice. Of an address not more is fetched than takes a moment, which partRead() tells.
    void open(const QString& path);
    /// The token for the server of an address, until the program ends; it is written nowhere. From any thread.
    void setToken(const QString& place, const QString& token);
    QString tokenOf(const QString& place) const;
    /// Fetches the rest of the model of which a part is shown.
    void readWhole();
    /// Asks by choicesNeeded() how a dataset is to be read, whether it must be known or not.
    void openWithOptions(const QString& path);
    /// The same for the file of the dataset that is open.
    void readDifferently();
    /// Opens a dataset so; ends with datasetOpened() or importFailed().
    void importDataset(const std::filesystem::path& path, const ImportOptions& options);
    /// Makes the sample of that name (sampleKinds()) unless it is there from before, and opens its model.
    void openSample(const std::string& name);
    /// Draws small pictures of the samples in a worker, once, each told by thumbnailDrawn(). While a file is read they
    /// wait until it has been.
    void drawThumbnails();
    /// Asked before what was read is shown, in place of the model that is open or, of a dataset, beside it: calls `go`,
    /// or `stay`. Without one nothing is asked.
    using Gate = std::function<void(bool isModel, const std::function<void()>& go, const std::function<void()>& stay)>;
    void setGate(Gate gate) { gate_ = std::move(gate); }

    /// How much of the model that is shown there is: 0 if it is whole, or if that is not known yet.
    std::uint32_t sitesOfWhole() const noexcept { return sitesOfWhole_; }
    /// Whether the model that is shown is all there: not a part of one that is packed, on a server, or being built.
    bool showsWhole() const
    {
        return session_.model() && session_.model()->elsewhere() == nullptr && becomes_.empty() && sitesOfWhole_ == 0;
    }
    /// Whether more of that model is being read.
    bool modelComes() const { return coming_ && coming_->shown && coming_->shown == session_.model(); }

    /// Opens what a session says that the file holds; with the model `located`, if the user has said where it is.
    void openSession(const std::filesystem::path& path, SessionSource source,
                     const std::filesystem::path& located = {});
    /// Shows the model that is open as a session or a picture that holds one was seen, in one edit.
    void applyLook(const std::filesystem::path& path);
    /// What is open and how it is seen; nothing without a model, or while a build is watched. The size of the view is
    /// the window's.
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
    /// Where a file about the model goes unless the user says otherwise: beside it, or while its build is watched to
    /// where it will be; of a sample to the user's documents. `ending` follows the model's name. There must be a model.
    QString proposedPath(const QString& ending) const;

    /// The dataset that models can be built of; none before one was opened.
    const std::shared_ptr<const Dataset>& dataset() const noexcept { return dataset_; }
    /// How it was opened.
    const ImportOptions& importOptions() const noexcept { return imported_; }
    /// What each of the host's builders says of the dataset, in their order: asked when it was read, not while somebody
    /// waits.
    const std::vector<Acceptance>& acceptances() const noexcept { return acceptances_; }
    /// What building it is expected to take follows from this; zeros without one. Made in the worker that read it.
    const BuildSize& buildSize() const noexcept { return buildSize_; }
    /// Whether a model was built of the dataset that is open.
    bool datasetIsBuilt() const noexcept { return dataset_ && dataset_ == built_; }
    void setBuilt(const std::shared_ptr<const Dataset>& dataset) { built_ = dataset; }
    /// A dataset that is in use is not closed.
    void setDatasetInUse(bool inUse) { datasetInUse_ = inUse; }

    /// Whether there is something to close.
    bool hasSomethingOpen() const { return session_.model() || (dataset_ && !datasetInUse_); }
    /// Closes the model, and with it the dataset that it was built of; without a model the dataset.
    void close();
    void closeModel();

    // For Building.

    /// For a worker.
    Result<OpenedModel> openModel(const std::filesystem::path& path) const;
    /// Asks nobody.
    void showModel(const OpenedModel& opened);
    /// Goes on with more of the model that is shown. What nobody has chosen follows the model.
    void growTo(const OpenedModel& opened);

signals:
    /// Something could not be opened or shown.
    void failed(const QString& text);
    /// A session was not saved.
    void saveFailed(const QString& text);
    void sessionSaved(const QString& path);
    /// The model of a session is not to be found; openSession() can be told where it is.
    void modelMissing(const std::filesystem::path& session, tetra::SessionSource source,
                      const std::filesystem::path& model);
    /// The server of that address answers only those who have its token; then `again` opens what was to be opened.
    void tokenWanted(const QString& place, const std::function<void()>& again);
    /// Another part of the model is shown than before, or nothing more of it comes.
    void shownPartChanged();
    /// All of the model that was to be read is shown, and there is more.
    void partRead(const tetra::OpenedModel& part);
    /// Something is about to be read.
    void aboutToRead();
    /// What is open is about to give way, the last moment to look at it.
    void leaving();
    void datasetOpened();
    void datasetClosed();
    void choicesNeeded(const tetra::ImportQuestion& question);
    /// Why the reader refuses the choices; empty if the user stopped it.
    void importFailed(const QString& reason);
    /// A model is shown as somebody left it; `from` is the file of the session or picture that says so, empty if that
    /// is how the model was seen last.
    void viewRestored(const std::filesystem::path& from, bool isAll);
    void sessionFileChanged();
    void thumbnailDrawn(const std::string& sample, const QImage& picture);
    /// A picture was opened that holds the session by which it was made.
    void pictureOpened(const QString& path);

private:
    struct ReadDataset {
        Result<Dataset> dataset;
        BuildSize size;
        ImportOptions options;
        std::vector<Acceptance> acceptances{}; ///< by the builders, in their order
    };

    /// A model that is read, bit by bit if it is packed or on a server. In the GUI thread.
    struct Coming {
        bool isAsked = false;    ///< whether it may take the place of what is open
        bool isAccepted = false; ///< and it may
        bool isInParts = false;  ///< the first was not the last
        std::shared_ptr<const Model> shown{};
        OpenedModel newest{};
    };

    OpenedModel asSeenLast(const std::filesystem::path& place) const;
    void read(LongTask::Work work);
    void readModel(const std::filesystem::path& place, const std::shared_ptr<Coming>& coming, bool whole);
    std::function<void()> whenModelCame(const std::filesystem::path& place, const OpenedModel& as,
                                        const std::shared_ptr<Coming>& coming, bool whole, const Progress& progress);
    void showComing(const std::shared_ptr<Coming>& coming, const OpenedModel& part);
    void showNewest(Coming& coming);
    void endComing(Coming& coming, bool hasCome);
    void look(const std::filesystem::path& path, bool ask);
    std::function<void()> whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress);
    std::function<void()> tellLater(const Error& error);
    void passGate(
        bool isModel, const std::function<void()>& go, const std::function<void()>& stay = [] {});
    ReadDataset readDataset(const std::filesystem::path& path, const ImportOptions& options, const Progress& progress);
    void datasetRead(const std::filesystem::path& path, const ReadDataset& read);
    void takeDataset(const std::filesystem::path& path, const ReadDataset& read);
    void closeDataset();
    void startThumbnails();
    void showSession(const RestoredView& restored, const OpenedModel& opened);
    void setSessionFile(const std::filesystem::path& file);
    void watchForDamage();
    void lookForDamage();
    void tell(const Error& error);

    PluginHost& host_;
    Session& session_;
    SceneService& scenes_;
    std::shared_ptr<const Dataset> dataset_;
    BuildSize buildSize_{.points = 0};
    ImportOptions imported_;
    std::vector<Acceptance> acceptances_;
    std::shared_ptr<const Dataset> built_; ///< that a model was built of last
    bool datasetInUse_ = false;
    std::filesystem::path becomes_; ///< the model that is open
    std::uint32_t sitesOfWhole_ = 0;
    std::shared_ptr<Coming> coming_; ///< by the reading that runs
    std::filesystem::path sessionFile_;
    mutable std::mutex tokensMutex_;    ///< guards the next one
    std::map<QString, QString> tokens_; ///< of servers
    QJsonObject sessionFound_;          ///< the text of that file: what is not known here stays in it
    Gate gate_;
    bool thumbnailsWanted_ = false;
    QTimer watching_; ///< the model's file for damage
    KeptViews views_; ///< before the workers that look into it
    LongTask reading_;
    LongTask applying_;  ///< a look
    quint64 opened_ = 0; ///< how many models were opened or closed; one that grows stays the same
    LongTask sampling_;
    LongTask thumbnails_;
    LongTask savingSession_;
};

} // namespace tetra
