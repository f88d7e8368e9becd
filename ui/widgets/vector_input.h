// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <QObject>

#include <array>

class QGridLayout;
class QLabel;

namespace tetra {

class Session;
class ValueBox;

/// Three numbers, one for each axis, as a row of a grid with a label before them. Its boxes are named NAME.x, .y and
/// .z; they are the grid's, as the label is.
class VectorInput : public QObject {
    Q_OBJECT
public:
    /// Fills columns 0 to 3 of the row. What a held key does is one step of the session's undo stack.
    VectorInput(const QString& name, const QString& label, const QString& toolTip, Session& session, QGridLayout& grid,
                int row, QObject* parent);

    void setRange(const Eigen::Vector3d& minimum, const Eigen::Vector3d& maximum);
    /// Shows it; tells nobody.
    void setValue(const Eigen::Vector3d& value);
    void setVisible(bool visible);
    void setEnabled(bool enabled);

signals:
    /// By the user.
    void edited(const Eigen::Vector3d& value);

private:
    /// As the last setValue(), but for the axis that was edited: boxes may show less than all digits.
    Eigen::Vector3d value_{0, 0, 0};
    QLabel* label_;
    std::array<ValueBox*, 3> boxes_;
};

/// A row of axis names above the columns of VectorInputs.
void addAxisNames(QGridLayout& grid, int row);

} // namespace tetra
