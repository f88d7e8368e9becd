// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <array>

class QLabel;
class QToolButton;

namespace tetra {

class AccuracyBox;
class AccuracySlider;
class ValueSlider;
class VectorInput;

/// The region where the mesh has an accuracy of its own (R25): shape, place, size, error and fall-off. What the tools
/// in the picture do by hand, by numbers.
class FocusPanel : public QWidget {
    Q_OBJECT
public:
    explicit FocusPanel(Session& session, QWidget* parent = nullptr);

signals:
    /// The focus shall go to what the camera looks at.
    void centreWanted();

protected:
    void changeEvent(QEvent* event) override;

private:
    QLayout* makeShapes();
    QLayout* makeInputs();
    void connectInputs();
    QLayout* makeButtons();
    const FocusState& focus() const { return session_.view().query.focus; }
    template <class Change> void edit(Change change);
    void showModel();
    void showFocus();
    void showExpectation();

    Session& session_;
    std::array<QToolButton*, 3> shapes_{}; ///< in the order of FocusState::Shape
    QWidget* settings_;                    ///< all that is of use with a focus only
    VectorInput* centre_ = nullptr;
    VectorInput* size_ = nullptr;
    QLabel* radiusLabel_;
    ValueSlider* radius_;
    AccuracySlider* error_;
    AccuracyBox* errorBox_;
    ValueSlider* falloff_;
    QLabel* clamped_;
    QLabel* outside_;
    QLabel* expectation_;
    QLabel* hint_;
};

} // namespace tetra
