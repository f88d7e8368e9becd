// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <tan/base.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tetra {

/// How far a task is, for people.
struct TaskProgress {
    double fraction = 0;
    Message activity;
    std::optional<double> remainingSeconds;
};

/// Pieces of work that take long enough to want a progress bar, one at a time, on a thread of their own. Used from the
/// thread that it lives in, where all signals are emitted.
///
/// There are two ways to give it another piece while one runs: start() is for what is only wanted as it is now, such as
/// a file that is opened or a preview; enqueue() for what has to happen, such as a file that is saved, and whose
/// outcome is always delivered.
///
/// Destroying it asks all to stop and waits: what looks at its progress ends soon, and what does not, because it is
/// short, is done; so a small file that is being written or waits for that is written.
class LongTask : public QObject {
    Q_OBJECT
public:
    /// Runs in the worker; what it returns runs afterwards in the thread of the task, also after a cancel.
    using Work = std::function<std::function<void()>(const Progress&)>;

    explicit LongTask(QObject* parent = nullptr);
    ~LongTask() override;

    bool running() const noexcept { return newest_ != nullptr; }
    /// Starts `work` at once. One that is still running is cancelled, and its outcome is not delivered. Where no thread
    /// can be had, start() does the work itself before it returns; it cannot be cancelled then. What it returned still
    /// runs later.
    void start(Work work);
    /// Starts `work` when those that were given before have ended, at once if there are none.
    void enqueue(Work work);
    /// Those that wait for the one that runs.
    int waiting() const noexcept { return static_cast<int>(waiting_.size()); }
    /// Asks the work that runs to stop; it ends in its own time, with finished().
    void cancel();

signals:
    void started();
    void waitingChanged();
    void progressed(const tetra::TaskProgress& progress);
    /// Just before what the work returned runs.
    void finished();

private:
    struct Run;
    void tell();
    void ended(const Run* run, const std::function<void()>& afterwards);

    QTimer telling_;
    QElapsedTimer clock_;
    RemainingTime remaining_;
    std::deque<Work> waiting_;
    std::vector<std::unique_ptr<Run>> runs_; ///< that have not ended; all but the newest were cancelled
    Run* newest_ = nullptr;                  ///< none once it has ended
};

} // namespace tetra
