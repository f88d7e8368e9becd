// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QLineEdit;
class QSpinBox;

namespace tetra {

class ValueBox;

/// What the annotation is called, for people; `mnemonic` with a letter to choose it by.
QString annotationText(AnnotationKind kind, bool mnemonic = false);
/// What it shows, in a sentence.
QString annotationExplanation(AnnotationKind kind);

/// Which annotations are written over the picture, and in which corner: view.annotation.NAME and .corner; and the ends
/// of the colour bar: view.barEnds.fixed, .least and .largest; and what they say: view.annotationText.title, .quantity
/// and .unit, view.numbers.style and .decimals; how lengths are written: view.lengths.style and .decimals; and how all
/// texts look: view.textSize and view.boldText.
class AnnotationRows : public QWidget {
    Q_OBJECT
public:
    explicit AnnotationRows(Session& session, QWidget* parent = nullptr);

private:
    void show(const AnnotationState& state);
    void edit(std::size_t index);
    QComboBox* makeCorner(std::size_t index);
    QWidget* makeBarEnds();
    QWidget* makeBarTexts();
    QWidget* makeNumbers(std::size_t index);
    QWidget* makeTextLook();
    QLineEdit* makeText(std::size_t index, const QString& name, const QString& title, const QString& toolTip);
    void showTexts(const AnnotationState& state);
    void showNumbers(const AnnotationState& state);
    void editNumbers(std::size_t index);
    void editTextLook();
    void showBarEnds(const AnnotationState& state);
    void setBarEnds(const std::optional<BarEnds>& ends);
    /// One end moved; the other one, if it is in the way, keeps its distance.
    void moveEnd(double BarEnds::*end, double value);

    Session& session_;
    std::array<QCheckBox*, annotationCount> shown_{};
    std::array<QComboBox*, annotationCount> corners_{}; ///< null for what stands in no corner
    QCheckBox* fixed_;
    ValueBox* least_;
    ValueBox* largest_;
    std::array<QLineEdit*, 3> texts_{};        ///< title, quantity, unit
    std::array<QComboBox*, 2> numberStyles_{}; ///< of the colour bar, of lengths
    std::array<QSpinBox*, 2> decimals_{};
    QSpinBox* textSize_;
    QCheckBox* boldText_;
};

} // namespace tetra
