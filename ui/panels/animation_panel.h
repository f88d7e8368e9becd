// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;
class QStackedWidget;

namespace tetra {

class ValueBox;
class Viewport;

/// The session's film (R27): a turntable or key frames, and a preview of it in the picture. Nothing plays before it is
/// told to, and once through.
class AnimationPanel : public QWidget {
    Q_OBJECT
public:
    AnimationPanel(Workbench& workbench, Viewport& viewport, QWidget* parent = nullptr);

    bool playing() const { return playing_.isActive(); }

signals:
    /// The film is to be written.
    void filmWanted();

private:
    QWidget* makeContent();
    QWidget* makeTurntable();
    QLayout* makePlayer();
    void connectControls();
    void showAnimation();
    void showModel();
    template <class Change> void edit(Change change);
    void play();
    void playOn();
    void showFrame(int frame);
    void stop();

    Workbench& workbench_;
    Viewport& viewport_;
    QComboBox* kind_;
    QStackedWidget* pages_;
    QComboBox* axis_;
    ValueBox* degrees_;
    QSpinBox* frames_;
    QSpinBox* rate_;
    QPushButton* play_;
    QSlider* position_;
    QLabel* summary_;
    QPushButton* write_;
    QTimer playing_;
    QElapsedTimer clock_;
};

} // namespace tetra
