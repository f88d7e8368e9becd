// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QWidget>

class QComboBox;
class QGridLayout;
class QPushButton;
class QToolButton;

namespace tetra {

class ColourButton;
class ValueBox;
class VectorInput;
class Viewport;

/// From where the model is seen (R27), in numbers: direction, distance, projection, named views and background. A
/// camera is saved and loaded in the form that the command line knows (tan/render.h).
class ViewPanel : public QWidget {
    Q_OBJECT
public:
    ViewPanel(Workbench& workbench, Viewport& viewport, QWidget* parent = nullptr);

private:
    QWidget* makeContent();
    void addNumbers(QGridLayout& grid);
    QLayout* makeNamedViews();
    QLayout* makeFiles();
    void connectControls();
    template <class Change> void edit(Change change);
    void showModel();
    void showCamera();
    void load(const QString& path);

    Workbench& workbench_;
    Viewport& viewport_;
    ValueBox* azimuth_;
    ValueBox* elevation_;
    ValueBox* roll_;
    QComboBox* up_;
    ValueBox* distance_;
    ValueBox* fieldOfView_;
    VectorInput* target_ = nullptr;
    QComboBox* projection_;
    QComboBox* turning_;
    ColourButton* background_;
    QToolButton* usualBackground_;
    QPushButton* load_;
    QPushButton* save_;
};

} // namespace tetra
