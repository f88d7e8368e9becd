// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_texts.h"

#include <QApplication>
#include <QHelpEvent>
#include <QWhatsThis>
#include <QWidget>

namespace tetra {

HelpTexts::HelpTexts(QObject* parent) : QObject(parent)
{
    QCoreApplication::instance()->installEventFilter(this);
}

QString HelpTexts::textFor(const QWidget* widget)
{
    for (; widget != nullptr; widget = widget->isWindow() ? nullptr : widget->parentWidget()) {
        if (!widget->whatsThis().isEmpty())
            return widget->whatsThis();
        if (!widget->toolTip().isEmpty())
            return widget->toolTip();
    }
    return {};
}

void HelpTexts::showForFocus()
{
    QWidget* widget = QApplication::focusWidget();
    if (const QString text = textFor(widget); !text.isEmpty())
        QWhatsThis::showText(widget->mapToGlobal(widget->rect().bottomLeft()), text, widget);
}

bool HelpTexts::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || !widget->whatsThis().isEmpty())
        return false;
    if (event->type() == QEvent::QueryWhatsThis) {
        event->setAccepted(!textFor(widget).isEmpty());
        return true;
    }
    if (event->type() != QEvent::WhatsThis)
        return false;
    const QString text = textFor(widget);
    if (text.isEmpty())
        return false;
    QWhatsThis::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, widget);
    event->accept();
    return true;
}

} // namespace tetra
