// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <array>

class QToolButton;

namespace tetra {

class AccuracyBox;
class AccuracySlider;
class ValueSlider;

/// The lens (C5): its shape, magnification and size, and the error of the mesh in it.
class LensInputs : public QWidget {
    Q_OBJECT
public:
    explicit LensInputs(Session& session, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    template <class Change> void edit(Change change);
    QLayout* makeShapes();
    void makeSettings();
    void show();

    Session& session_;
    std::array<QToolButton*, 3> shapes_{}; ///< in the order of LensState::Shape
    QWidget* settings_;
    ValueSlider* magnification_;
    ValueSlider* radius_; ///< in % of the picture
    AccuracySlider* error_;
    AccuracyBox* errorBox_;
};

} // namespace tetra
