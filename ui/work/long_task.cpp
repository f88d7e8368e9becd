// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/long_task.h"

#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

namespace tetra {
namespace {

/// How often people are told: often enough to look alive, too seldom to cost anything.
constexpr auto tellingInterval = std::chrono::milliseconds(100);

} // namespace

struct LongTask::Run {
    std::mutex mutex; ///< guards the next two
    double fraction = 0;
    Message activity;
    std::jthread thread; ///< last: ends before what it uses
};

LongTask::LongTask(QObject* parent) : QObject(parent)
{
    connect(&telling_, &QTimer::timeout, this, &LongTask::tell);
}

LongTask::~LongTask()
{
    for (const auto& run : runs_)
        run->thread.request_stop();
    runs_.clear(); // waits
    std::stop_source stopped;
    stopped.request_stop();
    for (const Work& work : waiting_)
        work(Progress(stopped.get_token(), {}));
}

void LongTask::enqueue(Work work)
{
    if (!running() && waiting_.empty())
        return start(std::move(work));
    waiting_.push_back(std::move(work));
    emit waitingChanged();
}

void LongTask::start(Work work)
{
    cancel();
    remaining_ = {};
    clock_.start();
    telling_.start(tellingInterval);
    Run* run = runs_.emplace_back(std::make_unique<Run>()).get();
    newest_ = run;
    emit started();

    const auto doIt = [this, run, work = std::move(work)](const std::stop_token& stop) {
        const Progress progress(stop, [run](double fraction, const Message& activity) {
            const std::lock_guard lock(run->mutex);
            run->fraction = fraction;
            run->activity = activity;
        });
        std::function<void()> afterwards = work(progress);
        QMetaObject::invokeMethod(
            this, [this, run, afterwards = std::move(afterwards)] { ended(run, afterwards); }, Qt::QueuedConnection);
    };
    try {
        run->thread = std::jthread(doIt);
    } catch (const std::system_error&) {
        doIt({}); // a window that stands still for a while, but nothing lost
    }
}

void LongTask::cancel()
{
    if (newest_ != nullptr)
        newest_->thread.request_stop();
}

void LongTask::ended(const Run* run, const std::function<void()>& afterwards)
{
    const bool isReplaced = run != newest_;
    std::erase_if(runs_, [run](const auto& other) { return other.get() == run; });
    if (isReplaced)
        return;
    newest_ = nullptr;
    telling_.stop();
    emit finished();
    afterwards();
    if (running() || waiting_.empty())
        return;
    Work next = std::move(waiting_.front());
    waiting_.pop_front();
    emit waitingChanged();
    start(std::move(next));
}

void LongTask::tell()
{
    TaskProgress progress;
    {
        const std::lock_guard lock(newest_->mutex);
        progress.fraction = newest_->fraction;
        progress.activity = newest_->activity;
    }
    remaining_.update(progress.fraction, static_cast<double>(clock_.elapsed()) / 1000);
    progress.remainingSeconds = remaining_.seconds();
    emit progressed(progress);
}

} // namespace tetra
