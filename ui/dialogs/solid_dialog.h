// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/surface_making.h"

#include <QDialog>

class QCheckBox;
class QComboBox;

namespace tetra {

/// Asks how isosurfaces are made for a printer: closed around the larger or the smaller values or left open, all of
/// them or their largest parts, and whether their deviation is measured. Named solidOptions, with solid.side,
/// .largestPart, .deviation.
class SolidDialog : public QDialog {
    Q_OBJECT
public:
    explicit SolidDialog(QWidget* parent);

    SurfaceMaking making() const;
    bool measuresDeviation() const;

private:
    QComboBox* side_;
    QCheckBox* largestPart_;
    QCheckBox* deviation_;
};

} // namespace tetra
