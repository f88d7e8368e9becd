// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <array>
#include <vector>

class QComboBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace tetra {

class AccuracyBox;
class AccuracySlider;
class ValueSlider;
class VectorInput;

/// What the accuracy varies with (R25, C3): regions, with shape, place, size, error and fall-off, which the tools in
/// the picture move by hand; the distance from the viewer; the isovalues that are shown; or the opacity.
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
    QLayout* makeRegions();
    QLayout* makeInputs();
    void connectInputs();
    QLayout* makeButtons();
    const FocusState& focus() const { return session_.view().query.focus; }
    template <class Change> void edit(Change change);
    void showModel();
    void showFocus();
    void showRegions();
    void showExpectation();

    Session& session_;
    std::array<QToolButton*, 6> shapes_{}; ///< in the order of FocusState::Shape
    QWidget* settings_;                    ///< all that is of use with a focus only
    QWidget* buttons_;                     ///< of regions only
    QComboBox* regions_;
    QPushButton* add_;
    QPushButton* remove_;
    std::vector<QWidget*> axisNames_;
    VectorInput* centre_ = nullptr;
    VectorInput* size_ = nullptr;
    QLabel* radiusLabel_;
    ValueSlider* radius_;
    AccuracySlider* error_;
    AccuracyBox* errorBox_;
    QLabel* falloffLabel_;
    ValueSlider* falloff_;
    QLabel* distanceLabel_;
    ValueSlider* distance_;
    QLabel* valueFalloffLabel_;
    ValueSlider* valueFalloff_;
    QLabel* clamped_;
    QLabel* outside_;
    QLabel* expectation_;
    QLabel* hint_;
};

} // namespace tetra
