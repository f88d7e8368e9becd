// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/vector_input.h"

#include "plugins/widgets/gesture_watcher.h"
#include "plugins/widgets/value_box.h"
#include "ui/session/session.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

namespace tetra {
namespace {

constexpr std::array axisLabels{"x", "y", "z"};

} // namespace

VectorInput::VectorInput(const QString& name, const QString& label, const QString& toolTip, Session& session,
                         QGridLayout& grid, int row, QObject* parent)
    : QObject(parent), label_(new QLabel(label))
{
    grid.addWidget(label_, row, 0);
    for (int axis = 0; axis < 3; ++axis) {
        auto* box = new ValueBox;
        boxes_[static_cast<std::size_t>(axis)] = box;
        box->setObjectName(QString("%1.%2").arg(name, axisLabels[static_cast<std::size_t>(axis)]));
        box->setAccessibleName(
            QString("%1 %2").arg(QString(label).remove('&'), axisLabels[static_cast<std::size_t>(axis)]));
        box->setToolTip(toolTip);
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        grid.addWidget(box, row, axis + 1);
        new GestureWatcher(box, session);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, axis](double value) {
            value_[axis] = value;
            emit edited(value_);
        });
    }
    label_->setBuddy(boxes_[0]);
}

void VectorInput::setRange(const Eigen::Vector3d& minimum, const Eigen::Vector3d& maximum)
{
    for (int axis = 0; axis < 3; ++axis) {
        ValueBox* box = boxes_[static_cast<std::size_t>(axis)];
        const QSignalBlocker blocker(box);
        box->setValueRange(minimum[axis], maximum[axis]);
    }
}

void VectorInput::setValue(const Eigen::Vector3d& value)
{
    value_ = value;
    for (int axis = 0; axis < 3; ++axis) {
        ValueBox* box = boxes_[static_cast<std::size_t>(axis)];
        const QSignalBlocker blocker(box);
        box->setValue(value[axis]);
    }
}

void VectorInput::setVisible(bool visible)
{
    label_->setVisible(visible);
    for (ValueBox* box : boxes_)
        box->setVisible(visible);
}

void VectorInput::setEnabled(bool enabled)
{
    label_->setEnabled(enabled);
    for (ValueBox* box : boxes_)
        box->setEnabled(enabled);
}

void addAxisNames(QGridLayout& grid, int row)
{
    for (int axis = 0; axis < 3; ++axis)
        grid.addWidget(new QLabel(axisLabels[static_cast<std::size_t>(axis)]), row, axis + 1, Qt::AlignHCenter);
}

} // namespace tetra
