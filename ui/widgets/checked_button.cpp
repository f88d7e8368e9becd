// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/checked_button.h"

#include <QGuiApplication>
#include <QPalette>
#include <QToolButton>

namespace tetra {

void showChecked(QToolButton& button, bool checked)
{
    QPalette palette; // what is not set comes from the parent
    if (checked) {
        palette.setColor(QPalette::Button, QGuiApplication::palette().color(QPalette::Highlight));
        palette.setColor(QPalette::ButtonText, QGuiApplication::palette().color(QPalette::HighlightedText));
    }
    button.setPalette(palette);
    button.setChecked(checked);
}

} // namespace tetra
