// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <QColor>
#include <QToolButton>

namespace tetra {

/// The same colour as Qt's, and back.
QColor qtColour(const Colour& colour);
Colour colourOf(const QColor& colour);

/// Shows a colour; its menu offers the palette's colours and any other.
class ColourButton : public QToolButton {
    Q_OBJECT
public:
    explicit ColourButton(QWidget* parent = nullptr);
    void setColour(const QColor& colour);
    const QColor& colour() const noexcept { return colour_; }
    /// Brings up the dialog for any colour.
    void chooseOther();

signals:
    /// By the user.
    void colourChosen(const QColor& colour);

private:
    void fillMenu(QMenu* menu);

    QColor colour_;
};

} // namespace tetra
