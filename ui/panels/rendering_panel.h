// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace tetra {

class ParameterForm;
class Viewport;

/// How a model is looked at (R27): the mode, and what it can be told; and what is drawn while something moves, and for
/// how long (R23, C4), which is the user's and kept in the settings.
class RenderingPanel : public QWidget {
    Q_OBJECT
public:
    RenderingPanel(Workbench& workbench, Viewport& viewport, QWidget* parent = nullptr);

    /// As the user does.
    void chooseMode(const QString& id);
    void setSetting(const std::string& id);

signals:
    /// By the user.
    void modeChosen();

private:
    QWidget* makeContent();
    void showModel();
    void showAppearance();
    void showExamples();
    QFormLayout* makeMotion();
    void setFrameRate(int perSecond);
    void readMotion();
    void setMotion();

    Workbench& workbench_;
    Viewport& viewport_;
    QComboBox* mode_;
    QLabel* explanation_;
    ParameterForm* settings_;
    QFormLayout* motion_ = nullptr;
    QComboBox* moving_;
    QSpinBox* frameRate_;
    QDoubleSpinBox* movingError_;
    QSpinBox* movingShare_;
    QSpinBox* idleTime_;
    std::string shownMode_;
    ParameterValues shownDefaults_; ///< of its settings
};

} // namespace tetra
