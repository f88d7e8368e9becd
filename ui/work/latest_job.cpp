// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/latest_job.h"

#include <system_error>

namespace tetra {

LatestJob::LatestJob(QObject* parent) : QObject(parent)
{
    try {
        thread_ = std::jthread([this](const std::stop_token& end) { work(end); });
    } catch (const std::system_error&) {
        thread_ = {}; // submit() does it all
    }
    patienceOver_.setSingleShot(true);
    connect(&patienceOver_, &QTimer::timeout, this, &LatestJob::stopOutdated);
}

LatestJob::~LatestJob()
{
    cancel();
}

void LatestJob::submit(Job job, std::chrono::milliseconds patience)
{
    if (!thread_.joinable()) {
        job({});
        return;
    }
    {
        const std::lock_guard lock(mutex_);
        waiting_ = Entry{std::move(job), patience, {}, {}};
    }
    changed_.notify_one();
    stopOutdated();
}

void LatestJob::cancel()
{
    const std::lock_guard lock(mutex_);
    waiting_.reset();
    if (running_)
        running_->stop.request_stop();
}

void LatestJob::stopOutdated()
{
    const std::lock_guard lock(mutex_);
    if (!waiting_ || !running_)
        return;
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(running_->started + running_->patience - Clock::now());
    if (left.count() > 0)
        patienceOver_.start(left);
    else
        running_->stop.request_stop();
}

void LatestJob::work(const std::stop_token& end)
{
    std::unique_lock lock(mutex_);
    while (changed_.wait(lock, end, [this] { return waiting_.has_value(); })) {
        running_ = std::move(waiting_);
        waiting_.reset();
        running_->started = Clock::now();
        const std::stop_token stop = running_->stop.get_token();
        {
            const Job job = std::move(running_->job);
            lock.unlock();
            job(stop);
        } // what it holds, such as a mesh, goes while others may give the next one
        lock.lock();
        running_.reset();
    }
}

} // namespace tetra
