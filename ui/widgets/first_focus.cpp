// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/first_focus.h"

#include <QPushButton>

namespace tetra {

void focusFirst(QWidget& dialog, QPushButton& meant)
{
    meant.setDefault(true);
    for (QWidget* next = dialog.nextInFocusChain(); next != &dialog; next = next->nextInFocusChain())
        if (dialog.isAncestorOf(next) && next->isEnabled() && next->isVisibleTo(&dialog) &&
            (next->focusPolicy() & Qt::TabFocus) == Qt::TabFocus)
            return next->setFocus(Qt::TabFocusReason);
}

} // namespace tetra
