// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace tetra {

class AccuracyBox;
class AccuracyCurve;
class AccuracySlider;

/// Where the accuracy is chosen: by curve, slider, number or preset; with the mesh that belongs to it (R26).
class AccuracyPanel : public QWidget {
    Q_OBJECT
public:
    explicit AccuracyPanel(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    QLayout* makePresets();
    QLayout* makeNumbers();
    void showModel();
    void showAccuracy();

    Session& session_;
    AccuracyCurve* curve_;
    AccuracySlider* slider_;
    AccuracyBox* box_;
    QLabel* inUnits_;
    QLabel* sites_;
    QLabel* siteShare_;
    QLabel* tetrahedra_;
    QLabel* tetrahedronShare_;
    QLabel* limit_;
    std::vector<QToolButton*> presets_;
};

} // namespace tetra
