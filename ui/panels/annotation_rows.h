// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <array>

class QCheckBox;
class QComboBox;

namespace tetra {

/// What the annotation is called, for people; `mnemonic` with a letter to choose it by.
QString annotationText(AnnotationKind kind, bool mnemonic = false);
/// What it shows, in a sentence.
QString annotationExplanation(AnnotationKind kind);

/// Which annotations are written over the picture, and in which corner: view.annotation.NAME and .corner.
class AnnotationRows : public QWidget {
    Q_OBJECT
public:
    explicit AnnotationRows(Session& session, QWidget* parent = nullptr);

private:
    void show(const AnnotationState& state);
    void edit(std::size_t index);

    Session& session_;
    std::array<QCheckBox*, annotationCount> shown_{};
    std::array<QComboBox*, annotationCount> corners_{};
};

} // namespace tetra
