// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/annotation_overlay.h"

#include "core/picture/annotations/annotation_painter.h"
#include "ui/session/annotation_language.h"
#include "ui/viewport/viewport.h"
#include "ui/workbench/workbench.h"

#include <QEvent>
#include <QImage>
#include <QPainter>

namespace tetra {

AnnotationOverlay::AnnotationOverlay(Workbench& workbench, Viewport& viewport)
    : QWidget(&viewport), workbench_(workbench), viewport_(viewport)
{
    setObjectName("viewport.annotations");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    const auto repaint = qOverload<>(&QWidget::update);
    const Session* session = &workbench.session();
    connect(&viewport, &Viewport::cameraChanged, this, repaint);
    connect(&viewport, &Viewport::previewChanged, this, repaint);
    connect(&viewport, &Viewport::backgroundChanged, this, repaint);
    connect(session, &Session::modelChanged, this, repaint);
    connect(session, &Session::shownChanged, this, repaint);
    session->whenChanged(ViewPart::Appearance | ViewPart::Annotations | ViewPart::Isovalues, this,
                         [this] { update(); });
}

bool AnnotationOverlay::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        setGeometry(viewport_.rect());
    return QWidget::eventFilter(watched, event);
}

void AnnotationOverlay::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    if (!workbench_.session().model())
        return;
    const double pixelsPerUnit = devicePixelRatioF();
    QImage written((QSizeF(size()) * pixelsPerUnit).toSize(), QImage::Format_RGBA8888);
    written.fill(Qt::transparent);
    const auto content = workbench_.scenes().annotations(viewport_.shownCamera(), viewport_.background());
    if (!paintAnnotations(pixelsOf(written), content, pixelsPerUnit))
        return; // a desktop without fonts
    written.setDevicePixelRatio(pixelsPerUnit);
    QPainter(this).drawImage(QPoint(0, 0), written);
}

} // namespace tetra
