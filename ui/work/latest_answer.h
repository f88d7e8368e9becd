// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/work/latest_job.h"

#include <QMetaObject>
#include <QObject>

#include <functional>
#include <utility>

namespace tetra {

/// What plugins and disks are asked as often as a control changes, without waiting for them: a worker asks, and the
/// newest question alone is answered. A member of the object that asks, whose thread hears the answers.
template <class Answer> class LatestAnswer {
public:
    /// `find` in the worker, asked to stop when another question comes; then `tell` in the thread of `owner`, unless
    /// one has come.
    void ask(QObject& owner, std::function<Answer(const std::stop_token&)> find,
             std::function<void(const Answer&)> tell)
    {
        const quint64 number = ++newest_;
        isWaiting_ = true;
        job_.submit(
            [this, &owner, number, find = std::move(find), tell = std::move(tell)](const std::stop_token& stop) {
                QMetaObject::invokeMethod(
                    &owner,
                    [this, number, tell, answer = find(stop)] {
                        if (number != newest_)
                            return;
                        isWaiting_ = false;
                        tell(answer);
                    },
                    Qt::QueuedConnection);
            });
    }
    /// The answer is of no use any more.
    void forget()
    {
        ++newest_;
        isWaiting_ = false;
        job_.cancel();
    }
    bool isWaiting() const noexcept { return isWaiting_; }

private:
    quint64 newest_ = 0;
    bool isWaiting_ = false;
    LatestJob job_; ///< last: ends before what it uses
};

} // namespace tetra
