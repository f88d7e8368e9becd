// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

namespace tetra {

/// Does the newest of the jobs given to it, one at a time, on a thread of its own (at once where none can be had):
/// while one runs at most one waits, and a newer one takes its place. The running job is asked to stop when a newer one
/// comes, but not before it has had its patience: so that quick jobs show something while a slider moves, and slow ones
/// do not hold up the newest.
///
/// Used from the thread that it lives in. Destroying it asks the running job to stop and waits for it.
class LatestJob : public QObject {
    Q_OBJECT
public:
    using Job = std::function<void(std::stop_token)>;

    explicit LatestJob(QObject* parent = nullptr);
    ~LatestJob() override;

    void submit(Job job, std::chrono::milliseconds patience = std::chrono::milliseconds(0));
    /// Drops the waiting job and asks the running one to stop.
    void cancel();

private:
    using Clock = std::chrono::steady_clock;
    struct Entry {
        Job job;
        std::chrono::milliseconds patience{0};
        std::stop_source stop;
        Clock::time_point started;
    };

    void work(const std::stop_token& end);
    void stopOutdated();

    std::mutex mutex_; ///< guards the next three
    std::condition_variable_any changed_;
    std::optional<Entry> waiting_;
    std::optional<Entry> running_; ///< without its job, which the thread has
    QTimer patienceOver_;
    std::jthread thread_; ///< last: ends before what it uses
};

} // namespace tetra
