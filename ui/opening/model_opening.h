// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/opening/kept_views.h"
#include "ui/opening/opened_model.h"
#include "ui/opening/reading.h"
#include "ui/opening/server_tokens.h"
#include "ui/opening/session_file.h"
#include "ui/scenes/scene_service.h"
#include "ui/session/session.h"

#include <tan/base.h>
#include <tan/open.h>

#include <filesystem>
#include <functional>
#include <memory>

namespace tetra {

/// What is to be read as a model.
struct ModelRequest {
    std::filesystem::path place;
    OpenedModel as{};     ///< what else is known of it: how it is to be seen
    bool isWhole = false; ///< of an address all of it, not only as much as takes a moment
    /// Asks for it anew, once there is a token for its server; none: opens the place.
    std::function<void()> again{};
};

/// Reads, shows and closes models. One that is packed or on a server is shown while it comes.
class ModelOpening : public QObject {
    Q_OBJECT
public:
    /// All outlive it; `reading` need not be there before something is read.
    ModelOpening(Session& session, SceneService& scenes, SessionFile& sessionFile, const KeptViews& views,
                 Reading& reading);
    ~ModelOpening() override;

    ServerTokens& tokens() noexcept { return tokens_; }

    /// Reads the model of a file or an address. Of an address not more is fetched than takes a moment, which partRead()
    /// tells.
    void open(const std::filesystem::path& place);
    /// Fetches the rest of the model of which a part is shown.
    void readWhole();

    /// How much of the model that is shown there is: 0 if it is whole, or if that is not known yet.
    std::uint32_t sitesOfWhole() const noexcept { return sitesOfWhole_; }
    /// Where the model that is shown will be when it is built or has come; empty if it is no model under way.
    const std::filesystem::path& becomes() const noexcept { return becomes_; }
    /// Whether the model that is shown is all there: not a part of one that is packed, on a server, or being built.
    bool showsWhole() const;
    /// Whether more of that model is being read.
    bool isComing() const;

    /// Opens a model that needs no token, whole. For a worker.
    Result<OpenedModel> readNow(const std::filesystem::path& path) const;
    /// Shows it in place of what is open. Asks nobody.
    void show(const OpenedModel& opened);
    /// Goes on with more of the model that is shown. What nobody has chosen follows the model.
    void growTo(const OpenedModel& opened);
    void close();

    /// A model on its way, in the GUI thread.
    struct Coming;
    using ComingModel = std::shared_ptr<Coming>;
    /// Reads in a worker what may turn out to be a model; `work` hands that to whenRead().
    using Work = std::function<std::function<void()>(const ComingModel& coming, const Progress& progress)>;
    void read(const Work& work);
    /// In the worker: what is to be done with a model when all of it has come. Parts are shown before.
    std::function<void()> whenRead(const ModelRequest& request, const ComingModel& coming, const Progress& progress);
    /// What was being read is not wanted any more; something else is.
    void forgetComing() { coming_.reset(); }

signals:
    /// What is open is about to give way, the last moment to look at it.
    void leaving();
    /// A model is shown as somebody left it; `from` is the file of the session or picture that says so, empty if that
    /// is how the model was seen last.
    void viewRestored(const std::filesystem::path& from, bool isAll);
    /// A model that was read has taken the place of what was open.
    void modelTaken();
    /// Another part of the model is shown than before, or nothing more of it comes.
    void shownPartChanged();
    /// All of the model that was to be read is shown, and there is more.
    void partRead(const tetra::OpenedModel& part);
    /// The server of that address answers only those who have its token; then `again` opens what was to be opened.
    void tokenWanted(const QString& place, const std::function<void()>& again);
    /// Not all of how a model was seen could be shown.
    void failed(const QString& text);

private:
    void start(const ModelRequest& request, const ComingModel& coming);
    OpenOptions optionsFor(const ModelRequest& request) const;
    std::function<void()> whenRefused(const ModelRequest& request, const ComingModel& coming, const Error& error,
                                      bool needsToken);
    void showComing(const ComingModel& coming, const OpenedModel& part);
    void showNewest(Coming& coming);
    void endComing(Coming& coming, bool hasCome);

    Session& session_;
    SceneService& scenes_;
    SessionFile& sessionFile_;
    const KeptViews& views_;
    Reading& reading_;
    ServerTokens tokens_;
    std::filesystem::path becomes_; ///< the model that is open
    std::uint32_t sitesOfWhole_ = 0;
    ComingModel coming_; ///< by the reading that runs
};

} // namespace tetra
