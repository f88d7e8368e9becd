// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/picture_notice.h"

#include "ui/viewport/viewport.h"

#include <QEvent>
#include <QPainter>

namespace tetra {
namespace {

constexpr int noticeMargin = 8; // pixels
constexpr int dimming = 140;    ///< of 255

} // namespace

PictureNotice::PictureNotice(Viewport& viewport) : QWidget(&viewport), viewport_(viewport)
{
    setObjectName("viewport.notice");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    hide();
}

void PictureNotice::tell(const QString& text)
{
    if (text == accessibleName() && isHidden() == text.isEmpty())
        return;
    setAccessibleName(text);
    dims_ = true;
    setVisible(!text.isEmpty());
    raise();
    update();
}

bool PictureNotice::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(viewport_.rect());
    const bool isUsed = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel;
    if (isUsed && dims_ && isVisible()) {
        dims_ = false;
        update();
    }
    return QWidget::eventFilter(watched, event);
}

void PictureNotice::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    if (dims_) {
        QColor veil = palette().color(QPalette::Window);
        veil.setAlpha(dimming);
        painter.fillRect(rect(), veil);
    }
    const QRect room = rect().adjusted(noticeMargin, noticeMargin, -noticeMargin, 0);
    constexpr int flags = int(Qt::AlignHCenter) | int(Qt::AlignTop) | int(Qt::TextWordWrap);
    const QRect text = painter.boundingRect(room, flags, accessibleName());
    painter.fillRect(QRect(0, 0, width(), text.bottom() + noticeMargin), palette().color(QPalette::ToolTipBase));
    painter.setPen(palette().color(QPalette::ToolTipText));
    painter.drawText(room, flags, accessibleName());
}

} // namespace tetra
