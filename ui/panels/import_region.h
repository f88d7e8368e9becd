// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset_part.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QPushButton;
class QSpinBox;

namespace tetra {

class CheckLabel;
class ValueBox;

/// Which part of a dataset is read: of grids first and last point and stride along each axis, with the number of points
/// that this takes; of other data a box in space.
class ImportRegion : public QWidget {
    Q_OBJECT
public:
    explicit ImportRegion(QWidget* parent = nullptr);

    /// A grid of these sizes; the part stays as far as it fits.
    void setGrid(const Lattice& lattice);
    /// Data that are no grid.
    void setSpace();
    void setPart(const DatasetPart& part);
    DatasetPart part() const;
    /// The points that are taken of a grid; nothing if they are not known, or the part does not fit.
    std::optional<std::uint64_t> points() const;
    /// Whether data can be read so, as far as is known.
    bool isUsable() const;

signals:
    /// By the user.
    void edited();

private:
    struct Axis {
        QSpinBox* first = nullptr;
        QSpinBox* last = nullptr;
        QSpinBox* stride = nullptr;
    };

    QWidget* makeGrid();
    QWidget* makeSpace();
    QSpinBox* makeBox(const QString& name, const QString& accessibleName, const QString& toolTip);
    void reset();
    void showCount();
    bool isGrid() const { return lattice_.has_value(); }

    std::optional<Lattice> lattice_;
    std::array<Axis, 3> axes_;
    CheckLabel* count_;
    QPushButton* reset_;
    QCheckBox* inBox_;
    std::array<ValueBox*, 6> corners_{};
    QWidget* grid_;
    QWidget* space_;
};

} // namespace tetra
