// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/work/long_task.h"

#include <QCoreApplication>

namespace tetra {
namespace {

/// How often people are told: often enough to look alive, too seldom to cost anything.
constexpr auto tellingInterval = std::chrono::milliseconds(100);

} // namespace

LongTask::LongTask(QObject* parent) : QObject(parent)
{
    connect(&telling_, &QTimer::timeout, this, &LongTask::tell);
}

LongTask::~LongTask() = default;

void LongTask::start(Work work)
{
    thread_ = {}; // asks the previous one to stop and waits
    running_ = true;
    remaining_ = {};
    fraction_ = 0;
    activity_.clear();
    clock_.start();
    telling_.start(tellingInterval);
    emit started();

    thread_ = std::jthread([this, number = ++number_, work = std::move(work)](const std::stop_token& stop) {
        const Progress progress(stop, [this](double fraction, std::string_view activity) {
            const std::lock_guard lock(mutex_);
            fraction_ = fraction;
            activity_ = activity;
        });
        std::function<void()> afterwards = work(progress);
        QMetaObject::invokeMethod(
            this,
            [this, number, afterwards = std::move(afterwards)] {
                if (number != number_)
                    return;
                running_ = false;
                telling_.stop();
                emit finished();
                afterwards();
            },
            Qt::QueuedConnection);
    });
}

void LongTask::cancel()
{
    thread_.request_stop();
}

void LongTask::tell()
{
    TaskProgress progress;
    {
        const std::lock_guard lock(mutex_);
        progress.fraction = fraction_;
        // Plugins write their activities in English; those that the shell knows are translated.
        progress.activity = QCoreApplication::translate("Plugin", activity_.c_str());
    }
    remaining_.update(progress.fraction, static_cast<double>(clock_.elapsed()) / 1000);
    progress.remainingSeconds = remaining_.seconds();
    emit progressed(progress);
}

} // namespace tetra
