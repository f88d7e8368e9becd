// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/value_pick.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/logarithm_text.h"
#include "ui/viewport/viewport.h"

#include <QCursor>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <utility>

namespace tetra {
namespace {

constexpr double clickReach = 3; ///< pixels that a hand may move while it clicks
constexpr double ringRadius = 6;
constexpr double labelDistance = 10;

/// On an isosurface its isovalue, elsewhere what the field has there; nothing on what tells no value.
std::optional<PickedValue> pickedOf(const SeenPlace& seen, const Scene& scene)
{
    if (!seen.value)
        return std::nullopt;
    const Drawable* drawable = drawableOf(scene, seen.drawable);
    return PickedValue{*seen.value, seen.place, drawable != nullptr && drawable->value.has_value()};
}

} // namespace

ValuePick::ValuePick(Workbench& workbench, Viewport& viewport)
    : QWidget(&viewport), workbench_(workbench), viewport_(viewport)
{
    setObjectName("viewport.pick");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    const auto repaint = qOverload<>(&QWidget::update);
    connect(&viewport, &Viewport::cameraChanged, this, repaint);
    connect(&viewport, &Viewport::previewChanged, this, repaint);
    connect(&workbench.session(), &Session::modelChanged, this, &ValuePick::forget);
    // The viewport gets the scene by the same signal.
    connect(&workbench.scenes().sceneBuilder(), &SceneBuilder::sceneReady, this, &ValuePick::look,
            Qt::QueuedConnection);
}

QString ValuePick::text() const
{
    const auto& model = workbench_.session().model();
    if (!picked_ || !model)
        return {};
    const auto length = [&](int axis) { return valueText(picked_->place[axis], model->diagonal()); };
    return tr("%1 at (%2, %3, %4)")
        .arg(dataValueText(picked_->value, model->description()), length(0), length(1), length(2));
}

void ValuePick::pickAt(QPointF pixel)
{
    wanted_ = viewport_.beneathLens(pixel);
    look();
}

void ValuePick::pickAtPointer()
{
    const QPoint pointer = viewport_.mapFromGlobal(QCursor::pos());
    pickAt(viewport_.rect().contains(pointer) && viewport_.underMouse() ? pointer : viewport_.rect().center());
}

void ValuePick::forget()
{
    wanted_.reset();
    seen_.forget();
    setPicked(std::nullopt);
}

void ValuePick::look()
{
    const auto scene = viewport_.scene();
    if (!wanted_ || !scene || viewport_.previewing() || workbench_.scenes().sceneBuilder().busy())
        return;
    const PickingRay line = viewport_.projection().pickingRay(*wanted_);
    wanted_.reset();
    seen_.find(scene, line, [this, scene](const std::optional<SeenPlace>& seen) {
        setPicked(seen ? pickedOf(*seen, *scene) : std::nullopt);
    });
}

void ValuePick::setPicked(const std::optional<PickedValue>& picked)
{
    if (picked == picked_)
        return;
    picked_ = picked;
    viewport_.setAccessibleDescription(text());
    update();
    emit pickedChanged();
}

void ValuePick::followMouse(const QMouseEvent& event)
{
    switch (event.type()) {
    case QEvent::MouseButtonPress:
        pressed_.reset();
        if (clickable_ && event.button() == Qt::LeftButton && event.modifiers() == Qt::NoModifier)
            pressed_ = event.position();
        break;
    case QEvent::MouseMove:
        if (pressed_ && (event.position() - *pressed_).manhattanLength() > clickReach)
            pressed_.reset();
        break;
    case QEvent::MouseButtonRelease:
        if (pressed_ && event.button() == Qt::LeftButton)
            pickAt(*std::exchange(pressed_, std::nullopt));
        break;
    default: pressed_.reset(); break; // the second press of a double click
    }
}

bool ValuePick::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease: followMouse(static_cast<const QMouseEvent&>(*event)); break;
    case QEvent::KeyPress:
        if (picked_ && static_cast<const QKeyEvent&>(*event).key() == Qt::Key_Escape) {
            forget();
            return true;
        }
        break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

/// A ring around the place, whatever hides it, and the value beside.
void ValuePick::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    if (!picked_ || viewport_.previewing())
        return;
    const auto place = viewport_.projection().pixelOf(picked_->place);
    if (!place)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor highlight = palette().color(QPalette::Highlight);
    for (const auto& [colour, width] : {std::pair(palette().color(QPalette::Base), 5.0), std::pair(highlight, 2.0)}) {
        painter.setPen(QPen(colour, width));
        painter.drawEllipse(*place, ringRadius, ringRadius);
    }
    const auto& model = workbench_.session().model();
    const QString value = model ? dataValueText(picked_->value, model->description()) : QString();
    QRectF label(0, 0, fontMetrics().horizontalAdvance(value) + 10, fontMetrics().height() + 4);
    label.moveCenter(*place + QPointF(labelDistance + label.width() / 2, 0));
    if (label.right() > width())
        label.moveRight(place->x() - labelDistance);
    painter.setPen(Qt::NoPen);
    painter.setBrush(highlight);
    painter.drawRoundedRect(label, 3, 3);
    painter.setPen(palette().color(QPalette::HighlightedText));
    painter.drawText(label, Qt::AlignCenter, value);
}

} // namespace tetra
