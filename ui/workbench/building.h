// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/live_build.h"
#include "ui/opening/opening.h"

#include <QTemporaryDir>
#include <QTimer>

#include <atomic>

namespace tetra {

/// What to build, and where to.
struct BuildOrder {
    std::string builder; ///< id
    ParameterValues values;
    std::filesystem::path target;
    bool watch = true;   ///< show the model while it grows, unless another one is open
    bool resume = false; ///< go on with what an interrupted build left, and leave that if this one is interrupted
};

/// What becomes of a build that the user stops.
enum class BuildEnd {
    Discard, ///< nothing is left of it
    Keep,    ///< what is finished becomes the model, of less accuracy
    Pause,   ///< it can be gone on with, if it was ordered to
};

/// Builds models of the dataset that is open, one at a time, in a worker. A model can be watched while it grows: from
/// time to time what is finished of it is shown in its place.
class Building : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    Building(PluginHost& host, Session& session, Opening& opening);
    ~Building() override;

    LongTask& task() noexcept { return task_; }
    /// Builds a model of the dataset, and opens it.
    void build(const BuildOrder& order);
    void stopBuild(BuildEnd end);
    /// Removes what an interrupted build of that model left, in a worker.
    void discardInterrupted(const std::filesystem::path& target);
    bool running() const noexcept { return task_.running(); }
    /// The dataset and the file of the build that runs.
    const QString& buildName() const noexcept { return buildName_; }
    const std::filesystem::path& buildTarget() const noexcept { return buildTarget_; }
    /// Whether the model of the build that runs is what is seen, as far as it is made.
    bool showsBuild() const { return running() && showsLook(); }
    /// Whether what is finished of that build can become a model.
    bool canKeepBuild() const { return live_ && live_->hasMesh(); }
    /// Whether what is kept of it lies beside a finished model, which stays as it is. Its name tells its error, which
    /// is known when it is written.
    bool keepsBeside() const { return wish_ && wish_->keepsBeside; }
    /// Whether the build that runs can be paused.
    bool canPauseBuild() const noexcept { return running() && resumes_; }

signals:
    /// The build was asked to end.
    void buildStopping(tetra::BuildEnd end);
    /// What discardInterrupted() was asked for is done, or could not be.
    void interruptedDiscarded();
    /// The build is done. Its model is shown next, unless the user has turned to something else. `finished`: it is what
    /// was kept of a build that was stopped, beside this model, which is as it was; else empty.
    void modelBuilt(const QString& path, bool isShown, const QString& finished);
    /// The build is over and its model shown, if it is; nothing more comes of it. `worked`: there is a model.
    void buildEnded(bool worked);
    /// There is no model.
    void saveFailed(const QString& text);

private:
    /// What the user wants of a build that ends early.
    struct Wish {
        std::atomic<bool> keep = false;
        std::atomic<bool> leaveNothing = false;
        std::atomic<bool> keepsBeside = false; ///< what is kept does not become the model that is built
    };

    void lookAtBuild();
    void showLook(const Result<OpenedModel>& look);
    void closeLook();
    void showBuilt(const std::filesystem::path& target, const Result<OpenedModel>& built);
    bool showsLook() const { return look_ != nullptr && session_.model() == look_; }

    PluginHost& host_;
    Session& session_;
    Opening& opening_;
    std::shared_ptr<LiveBuild> live_; ///< of the build that is being watched
    std::shared_ptr<Wish> wish_;      ///< of the same build
    bool resumes_ = false;            ///< likewise
    QString buildName_;
    std::filesystem::path buildTarget_;
    bool turnedAway_ = false;           ///< from that build, to something else
    std::filesystem::path lookPath_;    ///< where looks at it are written
    std::shared_ptr<const Model> look_; ///< the last one shown
    QTimer looking_;
    QTemporaryDir looks_;
    LongTask looker_;
    LongTask discarding_;
    LongTask task_;
};

} // namespace tetra
