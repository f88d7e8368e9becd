// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/editors/transferfunction/editor_state.h"

#include <QBoxLayout>
#include <QWidget>

namespace tetra {

class ColourButton;
class ValueBox;

/// In numbers what is selected in the plot: the value, opacity and colour of points, isovalues and ends of the mask;
/// and the unit distance.
class PointNumbers : public QWidget {
    Q_OBJECT
public:
    /// `state` outlives it.
    explicit PointNumbers(EditorState& state, QWidget* parent = nullptr);
    /// Another model, with lengths of its own.
    void showModel();
    void showSelection();
    /// In a dialog.
    void askForColour();
    /// That of the unit distance, with room for buttons before it.
    QHBoxLayout& lowerRow() noexcept { return *lowerRow_; }

private:
    void nameControls();
    void layOut();
    void connectControls();
    void setOpacity(double percent);
    void setColour(const QColor& colour);

    EditorState& state_;
    ValueBox* value_;
    ValueBox* opacity_;
    ColourButton* colour_;
    ValueBox* unitDistance_;
    QHBoxLayout* lowerRow_;
};

} // namespace tetra
