// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/check_label.h"

#include <QEvent>

namespace tetra {

CheckLabel::CheckLabel(const QString& name, QWidget* parent) : QLabel(parent)
{
    setObjectName(name);
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
}

void CheckLabel::showCheck(bool fits, const QString& text)
{
    fits_ = fits;
    setText(text.isEmpty() ? QString() : (fits ? QString("✓ ") : QString("✗ ")) + text);
    colour();
}

/// Readable on light and on dark windows.
void CheckLabel::colour()
{
    const bool isDark = palette().color(QPalette::Window).lightness() < 128;
    const QColor good = isDark ? QColor(120, 210, 130) : QColor(20, 110, 40);
    const QColor bad = isDark ? QColor(255, 140, 125) : QColor(175, 30, 20);
    const QColor& wanted = fits_ ? good : bad;
    if (palette().color(foregroundRole()) == wanted)
        return;
    QPalette colours = palette();
    colours.setColor(foregroundRole(), wanted);
    setPalette(colours);
}

void CheckLabel::changeEvent(QEvent* event)
{
    QLabel::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        colour();
}

} // namespace tetra
