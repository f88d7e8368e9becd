// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/task_line.h"

#include "plugins/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>

#include <cmath>

namespace tetra {

TaskLine::TaskLine(const QString& name, const QString& activity, LongTask& task, QWidget* parent)
    : QWidget(parent), activity_(new QLabel(activity)), progress_(new QProgressBar)
{
    setObjectName(name);
    activity_->setObjectName(name + ".activity");
    progress_->setObjectName(name + ".progress");
    progress_->setRange(0, 100);
    progress_->setTextVisible(false);
    progress_->setFixedSize(120, 12);
    auto* cancel = new QToolButton;
    cancel->setObjectName(name + ".cancel");
    cancel->setIcon(glyphIcon(Glyph::Close));
    cancel->setIconSize({12, 12});
    cancel->setAutoRaise(true);
    cancel->setToolTip(tr("Cancel"));
    cancel->setAccessibleName(tr("Cancel"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->addWidget(activity_);
    layout->addWidget(progress_);
    layout->addWidget(cancel);
    hide();
    connect(cancel, &QToolButton::clicked, &task, &LongTask::cancel);
    connect(&task, &LongTask::progressed, this, &TaskLine::follow);
    connect(&task, &LongTask::finished, this, &QWidget::hide);
}

void TaskLine::setActivity(const QString& activity, const QString& details)
{
    activity_->setText(activity);
    activity_->setToolTip(details);
}

void TaskLine::follow(const TaskProgress& progress)
{
    progress_->setValue(static_cast<int>(std::lround(100 * progress.fraction)));
    show();
}

} // namespace tetra
