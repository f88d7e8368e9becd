// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/remaining_time.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace tetra {

/// How far a task is, for people.
struct TaskProgress {
    double fraction = 0;
    QString activity;
    std::optional<double> remainingSeconds;
};

/// One piece of work that takes long enough to want a progress bar, on a thread of its own. Used from the thread that
/// it lives in, where all signals are emitted. Destroying it cancels and waits.
class LongTask : public QObject {
    Q_OBJECT
public:
    /// Runs in the worker; what it returns runs afterwards in the thread of the task, also after a cancel.
    using Work = std::function<std::function<void()>(const Progress&)>;

    explicit LongTask(QObject* parent = nullptr);
    ~LongTask() override;

    bool running() const noexcept { return newest_ != nullptr; }
    /// Starts `work` at once. One that is still running is cancelled; nothing more is heard of it.
    void start(Work work);
    /// Asks the work to stop; it ends in its own time, with finished().
    void cancel();

signals:
    void started();
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
    std::vector<std::unique_ptr<Run>> runs_; ///< that have not ended; all but the newest were cancelled
    Run* newest_ = nullptr;                  ///< none once it has ended
};

} // namespace tetra
