// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/work/long_task.h"

#include <functional>
#include <utility>

namespace tetra {

/// What is being read: one thing, the newest. What was read passes a gate before it takes the place of what is open.
class Reading : public QObject {
    Q_OBJECT
public:
    /// In a worker; what was being read before is not wanted any more.
    void start(LongTask::Work work);
    LongTask& task() noexcept { return task_; }
    bool running() const noexcept { return task_.running(); }
    void cancel() { task_.cancel(); }

    /// Asked before what was read is shown, in place of the model that is open or, of a dataset, beside it: calls `go`,
    /// or `stay`. Without one nothing is asked.
    using Gate = std::function<void(bool isModel, const std::function<void()>& go, const std::function<void()>& stay)>;
    void setGate(Gate gate) { gate_ = std::move(gate); }
    /// Lets what was read take the place of what is open, if that may be.
    void passGate(
        bool isModel, const std::function<void()>& go, const std::function<void()>& stay = [] {}) const;

    /// Tells by failed() what is wrong; nothing of what the user has cancelled.
    void tell(const Error& error);
    /// The same as the outcome of a worker.
    std::function<void()> tellLater(const Error& error);

signals:
    /// Something is about to be read.
    void aboutToRead();
    /// Something could not be opened or shown.
    void failed(const QString& text);

private:
    Gate gate_;
    LongTask task_; ///< last: ends before what it uses
};

} // namespace tetra
