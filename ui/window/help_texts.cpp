// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_texts.h"

#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QScreen>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <QWidget>

#include <algorithm>

namespace tetra {
namespace {

constexpr int helpTextWidth = 340;
constexpr int margin = 8;

/// Qt's own window for this is translucent: black where nothing composes the screen.
void showText(QPoint place, const QString& text, QWidget* parent)
{
    QWhatsThis::leaveWhatsThisMode();
    auto* popup = new QFrame(parent, Qt::Popup);
    popup->setObjectName("help");
    popup->setAttribute(Qt::WA_DeleteOnClose);
    popup->setFrameShape(QFrame::Box);
    popup->setPalette(QToolTip::palette());
    auto* label = new QLabel(text);
    label->setObjectName("help.text");
    label->setWordWrap(true);
    label->setFixedWidth(helpTextWidth);
    auto* layout = new QVBoxLayout(popup);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addWidget(label);
    popup->adjustSize();
    const QRect screen = parent->screen()->availableGeometry();
    popup->move(std::min(place.x(), screen.right() - popup->width()),
                std::min(place.y(), screen.bottom() - popup->height()));
    popup->show();
}

} // namespace

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
        showText(widget->mapToGlobal(widget->rect().bottomLeft()), text, widget);
}

bool HelpTexts::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr)
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
    showText(static_cast<QHelpEvent*>(event)->globalPos(), text, widget);
    event->accept();
    return true;
}

} // namespace tetra
