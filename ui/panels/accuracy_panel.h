// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QGridLayout;
class QRadioButton;
class QToolButton;

namespace tetra {

class AccuracyBox;
class AccuracyCurve;
class AccuracySlider;
class BudgetBox;

/// Where the accuracy is chosen: by curve, slider, number or preset, or by a budget of tetrahedra; with the size of the
/// mesh that belongs to it (R26), and in words what is shown.
class AccuracyPanel : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    QLayout* makePresets();
    QLayout* makeModes();
    void addWarping(QGridLayout& grid, int row);
    QLayout* makeNumbers();
    void connectInputs();
    void showModel();
    void showCurve();
    void showWarping();
    void showQuery();
    void showError(double error);
    void showErrorPlace();
    void showSize();
    std::optional<double> errorOfMesh() const;

    Session& session_;
    AccuracyCurve* curve_;
    AccuracySlider* slider_;
    QRadioButton* byError_;
    AccuracyBox* box_;
    QRadioButton* byBudget_;
    BudgetBox* budget_;
    QLabel* inUnits_;
    QLabel* errorPlace_;   ///< which error it is, where there are two
    QLabel* warpingLabel_; ///< seen with its row if the model can warp
    QComboBox* warpingLimit_;
    AccuracyBox* warping_;
    WarpingChoice curveWarping_; ///< of the curve that is shown
    QLabel* sites_;
    QLabel* siteShare_;
    QLabel* tetrahedra_;
    QLabel* tetrahedronShare_;
    QLabel* outcome_;
    QLabel* limit_;
    std::vector<QToolButton*> presets_;
};

} // namespace tetra
