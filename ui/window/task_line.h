// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/work/long_task.h"

#include <QWidget>

class QLabel;
class QProgressBar;

namespace tetra {

/// A line for the status bar that says how far a task is, with a button that cancels it. Seen while the task runs and
/// takes long enough to want it. Its parts are named NAME.activity, .progress and .cancel.
class TaskLine : public QWidget {
    Q_OBJECT
public:
    TaskLine(const QString& name, const QString& activity, LongTask& task, QWidget* parent = nullptr);

    /// `details`: for who points at it.
    void setActivity(const QString& activity, const QString& details = {});

private:
    void follow(const TaskProgress& progress);

    QLabel* activity_;
    QProgressBar* progress_;
};

} // namespace tetra
