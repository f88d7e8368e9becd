// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QWidget>

#include <functional>

class QCheckBox;
class QToolButton;

namespace tetra {

class ColourButton;
class ValueSlider;

/// The controls of one isovalue. Its parts are named isovalue.N.visible, .colour, .value, .opacity and .remove, where N
/// is its place in the list.
class IsovalueRow : public QWidget {
    Q_OBJECT
public:
    IsovalueRow(Session& session, int index, QWidget* parent = nullptr);

    /// Shows what the session has.
    void refresh();
    void focusValue();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    const Isovalue& isovalue() const;
    void layOut();
    void connectControls();
    void edit(const std::function<void(Isovalue&)>& change);

    Session& session_;
    int index_; ///< in the list
    QCheckBox* visible_;
    ColourButton* colour_;
    ValueSlider* value_;
    ValueSlider* opacity_;
    QToolButton* remove_;
};

} // namespace tetra
