// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_overlay.h"

#include "core/picture/tool_painter.h"
#include "ui/session/annotation_language.h"

#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace tetra {

ToolOverlay::ToolOverlay(ToolDesk& desk, Workbench& workbench, Viewport& viewport)
    : QWidget(&viewport), desk_(desk), workbench_(workbench), viewport_(viewport)
{
    setObjectName("viewport.toolOverlay");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    const auto repaint = qOverload<>(&QWidget::update);
    connect(&desk, &ToolDesk::changed, this, repaint);
    connect(&viewport, &Viewport::previewChanged, this, repaint);
    connect(&viewport, &Viewport::backgroundChanged, this, repaint);
}

bool ToolOverlay::eventFilter(QObject* watched, QEvent* event)
{
    const auto& mouse = static_cast<const QMouseEvent&>(*event); // read for mouse events alone
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
        return mouse.button() == Qt::LeftButton ? desk_.press(mouse.position(), mouse.modifiers()) : desk_.dragging();
    case QEvent::MouseMove: return desk_.move(mouse.position(), mouse.modifiers(), mouse.buttons() != Qt::NoButton);
    case QEvent::MouseButtonRelease:
        return mouse.button() == Qt::LeftButton ? desk_.release(mouse.position(), mouse.modifiers()) : desk_.dragging();
    case QEvent::ShortcutOverride:
        if (desk_.dragging() || desk_.hasKey(static_cast<const QKeyEvent&>(*event))) {
            event->accept();
            return true;
        }
        break;
    case QEvent::KeyPress: return desk_.keyPress(static_cast<const QKeyEvent&>(*event));
    case QEvent::KeyRelease: return desk_.keyRelease(static_cast<const QKeyEvent&>(*event));
    case QEvent::Wheel: return desk_.dragging();
    case QEvent::Leave: desk_.leave(); break;
    case QEvent::FocusOut: desk_.letGo(); break;
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

void ToolOverlay::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    if (viewport_.previewing())
        return;
    const std::vector<ToolDrawing> drawings = desk_.drawings();
    if (drawings.empty())
        return;
    const double pixelsPerUnit = devicePixelRatioF();
    QImage painted((QSizeF(size()) * pixelsPerUnit).toSize(), QImage::Format_RGBA8888);
    painted.fill(Qt::transparent);
    const ToolInk ink{viewport_.shownCamera(),     viewport_.background(), annotationLanguage(),
                      workbench_.scenes().fonts(), desk_.selected(),       desk_.hovered()};
    if (!paintTools(pixelsOf(painted), drawings, ink, pixelsPerUnit))
        return; // a desktop without fonts
    painted.setDevicePixelRatio(pixelsPerUnit);
    QPainter(this).drawImage(QPoint(0, 0), painted);
}

} // namespace tetra
