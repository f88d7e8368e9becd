// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/remaining_time.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <atomic>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

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

    bool running() const noexcept { return running_; }
    /// Starts `work`; a task that is still running is cancelled and awaited first, and its end is not told.
    void start(Work work);
    /// Asks the work to stop; it ends in its own time, with finished().
    void cancel();

signals:
    void started();
    void progressed(const tetra::TaskProgress& progress);
    /// Just before what the work returned runs.
    void finished();

private:
    void tell();

    bool running_ = false;
    QTimer telling_;
    QElapsedTimer clock_;
    RemainingTime remaining_;
    std::mutex mutex_; ///< guards the next two
    double fraction_ = 0;
    std::string activity_;
    quint64 number_ = 0; ///< of the started tasks, so that the end of a replaced one is not taken for the present one's
    std::jthread thread_;
};

} // namespace tetra
