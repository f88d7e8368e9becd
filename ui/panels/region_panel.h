// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QComboBox;
class QPushButton;

namespace tetra {

class AccuracyBox;
class AccuracySlider;
class ValueSlider;
class VectorInput;

/// Which part of the mesh is seen: a window into the domain, and what becomes of the tetrahedra at its border (S17);
/// a range of values; and in place of one mesh what lived between two errors, chosen by births and deaths (C2).
class RegionPanel : public QWidget {
    Q_OBJECT
public:
    explicit RegionPanel(Session& session, QWidget* parent = nullptr);

private:
    QLayout* makeWindow();
    QLayout* makeValues();
    QLayout* makeRange();
    template <class Change> void editWindow(Change change);
    template <class Change> void editValues(Change change);
    template <class Change> void editRange(Change change);
    void showModel();
    void showQuery();

    Session& session_;
    QCheckBox* window_;
    QWidget* windowSettings_;
    VectorInput* from_ = nullptr;
    VectorInput* to_ = nullptr;
    QComboBox* border_;
    QCheckBox* values_;
    QWidget* valueSettings_;
    ValueSlider* least_;
    ValueSlider* largest_;
    QPushButton* reset_;
    /// An error of the range.
    struct RangeInput {
        double RangeState::*percent;
        AccuracySlider* slider;
        AccuracyBox* box;
    };
    QCheckBox* range_;
    QWidget* rangeSettings_;
    std::vector<RangeInput> rangeInputs_;
};

} // namespace tetra
