// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include "core/picture/view_picture.h"
#include "core/view/lens.h"
#include "ui/widgets/motion.h"

#include <QEvent>
#include <QGestureEvent>
#include <QGuiApplication>
#include <QInputDevice>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tetra {
namespace {

/// Wheel turns and keys that follow each other within this are one series.
constexpr auto seriesPause = std::chrono::milliseconds(700);
constexpr int glideTime = 220; // milliseconds

/// Two fingers on a trackpad move the picture; with Ctrl, or on a wheel, they zoom.
bool isPan(const QWheelEvent& event)
{
    const bool byFingers = event.device() != nullptr && event.device()->type() == QInputDevice::DeviceType::TouchPad;
    return byFingers && !event.pixelDelta().isNull() && !event.modifiers().testFlag(Qt::ControlModifier);
}

/// By which factor fingers have parted since the last event of a touchpad or touch screen; nothing for other events.
std::optional<double> pinchFactor(const QEvent& event)
{
    if (event.type() == QEvent::NativeGesture) {
        const auto& native = static_cast<const QNativeGestureEvent&>(event);
        if (native.gestureType() == Qt::ZoomNativeGesture)
            return 1 + native.value();
    } else if (event.type() == QEvent::Gesture) {
        const auto& gestures = static_cast<const QGestureEvent&>(event);
        if (const auto* pinch = static_cast<QPinchGesture*>(gestures.gesture(Qt::PinchGesture)))
            return pinch->scaleFactor();
    }
    return std::nullopt;
}

} // namespace

Viewport::Viewport(Session& session, BackendChoice choice, QWidget* parent)
    : QWidget(parent), session_(session), gesture_(session.newGesture())
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setMouseTracking(true);
    resting_.setSingleShot(true);
    resting_.setInterval(usualIdleTime);
    connect(&resting_, &QTimer::timeout, this, &Viewport::rest);
    pausing_.setSingleShot(true);
    pausing_.setInterval(seriesPause);
    connect(&pausing_, &QTimer::timeout, this, [this] {
        if (QGuiApplication::mouseButtons() == Qt::NoButton)
            gesture_ = session_.newGesture();
    });
    glide_.setStartValue(0.0);
    glide_.setEndValue(1.0);
    glide_.setDuration(glideTime);
    glide_.setEasingCurve(QEasingCurve::OutCubic);
    connect(&glide_, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& part) { showGlide(part.toDouble()); });
    grabGesture(Qt::PinchGesture);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    useCanvas(new Canvas(choice));
    followBackground();
    connect(&session, &Session::modelChanged, this, [this] {
        endPreview();
        showCamera();
        followBackground();
    });
    session.whenChanged(ViewPart::Camera, this, &Viewport::followCamera);
    session.whenChanged(ViewPart::Background, this, &Viewport::followBackground);
}

void Viewport::useCanvas(Canvas* canvas)
{
    if (canvas_ != nullptr) {
        canvas_->disconnect(this);
        canvas_->hide();
        canvas_->deleteLater();
    }
    canvas_ = canvas;
    canvas_->setObjectName("viewport.canvas");
    canvas_->setMouseTracking(true);
    connect(canvas_, &Canvas::framePainted, this, &Viewport::framePainted);
    connect(canvas_, &Canvas::failed, this, &Viewport::failed);
    connect(canvas_, &Canvas::unusable, this, [this](const QString& text) {
        emit failed(tr("OpenGL cannot be used; the CPU draws the picture instead. %1").arg(text));
        useCanvas(new Canvas);
    });
    setFrameRate(frameRate_);
    canvas_->setMovingKind(movingKind_);
    layout()->addWidget(canvas_);
    canvas_->lower(); // below what tools draw over it
    canvas_->setView(view_);
}

void Viewport::setScene(std::shared_ptr<const Scene> scene, std::uint64_t tetrahedra)
{
    if (tetrahedra != scene_.tetrahedra)
        drafts_.clear();
    scene_ = {std::move(scene), tetrahedra};
    show();
}

void Viewport::setDrafts(std::vector<SceneLevel> drafts)
{
    drafts_ = std::move(drafts);
    view_.levels.resize(std::min<std::size_t>(view_.levels.size(), 1));
    for (const SceneLevel& draft : drafts_)
        if (!view_.levels.empty())
            view_.levels.push_back(withOutlines(draft));
    canvas_->setView(view_);
}

void Viewport::setOutlines(std::vector<LineSet> outlines)
{
    if (outlines.empty() && outlines_.empty())
        return;
    outlines_ = std::move(outlines);
    show();
}

/// The scene with the outlines, which may stick out of the domain, and lines as wide on any screen.
SceneLevel Viewport::withOutlines(const SceneLevel& level) const
{
    const double pixelsPerUnit = devicePixelRatioF();
    if (outlines_.empty() && pixelsPerUnit == 1)
        return level;
    auto scene = std::make_shared<Scene>(*level.scene);
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
        for (const Eigen::Vector3d& point : outlines_[i].points)
            scene->bounds.extend(point);
        scene->drawables.push_back({.id = "tool-outline-" + std::to_string(i + 1), .shape = outlines_[i]});
    }
    scaleLines(*scene, pixelsPerUnit);
    return {std::move(scene), level.tetrahedra};
}

void Viewport::show()
{
    view_.levels.clear();
    if (scene_.scene) {
        view_.levels.push_back(withOutlines(scene_));
        for (const SceneLevel& draft : drafts_)
            view_.levels.push_back(withOutlines(draft));
    }
    canvas_->setView(view_);
}

void Viewport::setCamera(const Camera& camera)
{
    if (camera != this->camera())
        moveByHand(camera);
}

void Viewport::moveByHand(const Camera& camera)
{
    endPreview();
    expectChange();
    pausing_.start();
    byHand_ = true;
    session_.setCamera(camera, gesture_);
    byHand_ = false;
}

/// By hand and where the view only takes another shape the picture is there at once, and else on its way: undone, say.
void Viewport::followCamera()
{
    if (!byHand_)
        return glide();
    if (!previewing_)
        showCamera();
}

void Viewport::showCamera()
{
    glide_.stop();
    view_.camera = camera();
    canvas_->setView(view_);
    emit cameraChanged();
}

void Viewport::glide()
{
    glide_.stop();
    glideFrom_ = view_.camera;
    endPreview();
    gesture_ = session_.newGesture(); // what follows by hand is a step of its own
    const bool glides = mayGlide(*this) && isVisible();
    if (glides)
        glide_.start();
    showGlide(glides ? 0 : 1); // tells at once: the choice is made
}

void Viewport::showGlide(double part)
{
    view_.camera = between(glideFrom_, camera(), part);
    expectChange();
    canvas_->setView(view_);
    emit cameraChanged();
}

void Viewport::setPreview(const std::optional<Camera>& camera)
{
    if (!camera)
        return endPreview();
    glide_.stop();
    previewing_ = true;
    view_.camera = *camera;
    expectChange();
    canvas_->setView(view_);
    emit previewChanged(true);
}

void Viewport::endPreview()
{
    if (!previewing_)
        return;
    previewing_ = false;
    view_.camera = camera();
    canvas_->setView(view_);
    emit previewChanged(false);
}

QPointF Viewport::beneathLens(QPointF pixel) const
{
    const LensState& lens = session_.view().lens;
    const double pixelsPerUnit = devicePixelRatioF();
    const QSize pixels = size() * pixelsPerUnit;
    const Eigen::Vector2d place(pixel.x() * pixelsPerUnit, pixel.y() * pixelsPerUnit);
    if (!lens.isOn() || pixels.isEmpty())
        return pixel;
    const LensPicture picture = lensPicture(lens, pixels.width(), pixels.height());
    if (!holds(lens, picture, place))
        return pixel;
    const Eigen::Vector2d beneath = placeUnder(picture, place) / pixelsPerUnit;
    return {beneath.x(), beneath.y()};
}

void Viewport::setFollowing(bool following)
{
    if (following == following_)
        return;
    following_ = following;
    view_.moving = following || resting_.isActive();
    canvas_->setView(view_);
}

void Viewport::expectChange()
{
    view_.moving = true;
    resting_.start();
}

void Viewport::setFrameRate(std::optional<double> perSecond)
{
    frameRate_ = perSecond;
    canvas_->setFrameRate(perSecond.value_or(canvas_->usualFrameRate()));
}

void Viewport::setMovingKind(MovingQuality::Kind kind)
{
    movingKind_ = kind;
    canvas_->setMovingKind(kind);
}

QString Viewport::backendName() const
{
    return canvas_->backendName();
}

bool Viewport::settled() const
{
    return !view_.moving && glide_.state() != QAbstractAnimation::Running && canvas_->settled();
}

QImage Viewport::picture() const
{
    return canvas_->picture();
}

void Viewport::rest()
{
    view_.moving = following_;
    canvas_->setView(view_);
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    lastPosition_ = event->position();
    gesture_ = session_.newGesture();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    QWidget::mouseReleaseEvent(event);
    gesture_ = session_.newGesture();
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = std::exchange(lastPosition_, event->position());
    const QPointF moved = lastPosition_ - before;
    const bool left = event->buttons().testFlag(Qt::LeftButton);
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->buttons().testFlag(Qt::MiddleButton) || (left && shift))
        moveByHand(pannedByDrag(camera(), moved, size()));
    else if (left)
        moveByHand(turnedByDrag(camera(), before, lastPosition_, size()));
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (isPan(*event))
        moveByHand(pannedByDrag(camera(), event->pixelDelta(), size()));
    else
        moveByHand(zoomedByWheel(camera(), event->angleDelta().y()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (const auto moved = movedByKey(camera(), *event))
        moveByHand(*moved);
    else
        QWidget::keyPressEvent(event);
}

bool Viewport::event(QEvent* event)
{
    const auto factor = pinchFactor(*event);
    if (!factor)
        return QWidget::event(event);
    moveByHand(zoomedByPinch(camera(), *factor));
    event->accept();
    return true;
}

void Viewport::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        followBackground();
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    emit resized();
    byHand_ = true;
    session_.setShape(static_cast<double>(std::max(1, width())) / std::max(1, height()));
    byHand_ = false;
}

void Viewport::setDarkGround(bool dark)
{
    if (std::exchange(darkGround_, dark) != dark)
        followBackground();
}

void Viewport::followBackground()
{
    const bool dark = darkGround_ || palette().color(QPalette::Window).lightness() < 128;
    view_.background = session_.view().background.value_or(usualBackground(dark));
    canvas_->setView(view_);
    emit backgroundChanged();
}

} // namespace tetra
