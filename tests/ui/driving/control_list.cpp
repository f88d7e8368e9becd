// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/driving/control_list.h"

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QWidgetAction>

#include <algorithm>
#include <array>

namespace tetra {
namespace {

bool isInsideAnother(const QWidget& widget)
{
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget())
        if (qobject_cast<const QAbstractSpinBox*>(parent) != nullptr ||
            qobject_cast<const QComboBox*>(parent) != nullptr || qobject_cast<const QLineEdit*>(parent) != nullptr)
            return true;
    return false;
}

bool onlyShowsOrHolds(const QWidget& widget)
{
    constexpr std::array holders{"QLabel", "QScrollArea",        "QScrollBar", "QHeaderView",           "QTabBar",
                                 "QMenu",  "QTableCornerButton", "QSizeGrip",  "QDockWidgetTitleButton"};
    return widget.focusProxy() != nullptr || widget.objectName().startsWith("qt_") ||
           std::ranges::any_of(holders, [&](const char* holder) { return widget.inherits(holder); });
}

} // namespace

QList<QWidget*> controlsOf(const QWidget& root)
{
    QList<QWidget*> controls;
    for (QWidget* widget : root.findChildren<QWidget*>()) {
        const bool canBeUsed =
            widget->focusPolicy() != Qt::NoFocus || qobject_cast<QAbstractButton*>(widget) != nullptr;
        if (canBeUsed && !onlyShowsOrHolds(*widget) && !isInsideAnother(*widget))
            controls.append(widget);
    }
    return controls;
}

QList<QAction*> commandsOf(const QWidget& root)
{
    QList<QAction*> commands;
    for (QAction* action : root.findChildren<QAction*>()) {
        const bool isOfQt = action->objectName().startsWith("_q_") || qobject_cast<QWidgetAction*>(action) != nullptr;
        if (!action->isSeparator() && action->menu() == nullptr && !isOfQt)
            commands.append(action);
    }
    return commands;
}

} // namespace tetra
