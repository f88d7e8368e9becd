// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_texts.h"

#include <QApplication>
#include <QDialog>
#include <QFrame>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QScreen>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWhatsThis>
#include <QWidget>

#include <algorithm>
#include <array>
#include <utility>

namespace tetra {
namespace {

constexpr int helpTextWidth = 340;
constexpr int margin = 8;
constexpr const char* popupName = "help";

/// By the names of the panels and dialogs.
constexpr std::array<std::pair<const char*, const char*>, 20> manualPlaces{{
    {"dock.build", "manual.html#build"},
    {"dock.accuracy", "manual.html#accuracy"},
    {"dock.rendering", "manual.html#modes"},
    {"dock.view", "manual.html#look"},
    {"dock.isovalues", "manual.html#isovalues"},
    {"dock.transfer", "manual.html#transfer-function"},
    {"dock.focus", "manual.html#focus"},
    {"dock.region", "manual.html#region"},
    {"dock.statistics", "manual.html#statistics"},
    {"dock.tools", "manual.html#tools"},
    {"dock.animation", "manual.html#films"},
    {"importDialog", "formats.html"},
    {"pictureOptions", "manual.html#pictures"},
    {"filmOptions", "manual.html#films"},
    {"solidOptions", "command-line.html#tan-isosurface"},
    {"pluginWindow", "manual.html#plugins"},
    {"cacheDialog", "manual.html#open"},
    {"addressDialog", "manual.html#open"},
    {"palette", "manual.html#find-a-command"},
    {"viewport.canvas", "manual.html#look"},
}};

bool isHelpKey(const QEvent& event)
{
    if (event.type() != QEvent::KeyPress)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.key() == Qt::Key_F1 && key.modifiers() == Qt::NoModifier;
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

QString HelpTexts::manualPlaceOf(const QWidget* widget)
{
    for (; widget != nullptr; widget = widget->parentWidget())
        for (const auto& [name, place] : manualPlaces)
            if (widget->objectName() == QLatin1String(name))
                return QString::fromLatin1(place);
    return QStringLiteral("manual.html");
}

void HelpTexts::showForFocus()
{
    QWidget* widget = QApplication::focusWidget();
    if (const QString text = textFor(widget); !text.isEmpty())
        showText(widget->mapToGlobal(widget->rect().bottomLeft()), text, widget);
    else
        emit manualWanted(manualPlaceOf(widget));
}

/// Qt's own window for this is translucent: black where nothing composes the screen.
void HelpTexts::showText(QPoint place, const QString& text, QWidget* of)
{
    QWhatsThis::leaveWhatsThisMode();
    auto* popup = new QFrame(of, Qt::Popup);
    popup->setObjectName(popupName);
    popup->setAttribute(Qt::WA_DeleteOnClose);
    popup->setFrameShape(QFrame::Box);
    popup->setPalette(QToolTip::palette());
    auto* label = new QLabel(text);
    label->setObjectName("help.text");
    label->setWordWrap(true);
    label->setFixedWidth(helpTextWidth);
    const QString link = QStringLiteral("<a href=\"%1\">%2</a>");
    auto* manual = new QLabel(link.arg(manualPlaceOf(of), tr("More in the manual (F1)")));
    manual->setObjectName("help.manual");
    manual->setTextFormat(Qt::RichText); // a link of our own
    connect(manual, &QLabel::linkActivated, this, [this, popup](const QString& target) {
        popup->close();
        emit manualWanted(target);
    });
    auto* layout = new QVBoxLayout(popup);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->addWidget(label);
    layout->addWidget(manual);
    popup->adjustSize();
    const QRect screen = of->screen()->availableGeometry();
    popup->move(std::min(place.x(), screen.right() - popup->width()),
                std::min(place.y(), screen.bottom() - popup->height()));
    popup->show();
}

bool HelpTexts::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr)
        return false;
    if (isHelpKey(*event) && widget->objectName() == QLatin1String(popupName)) {
        const QString place = manualPlaceOf(widget->parentWidget());
        widget->close();
        emit manualWanted(place);
        return true;
    }
    if (isHelpKey(*event) && widget == QApplication::focusWidget() &&
        qobject_cast<QDialog*>(widget->window()) != nullptr) {
        showForFocus();
        return true;
    }
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
