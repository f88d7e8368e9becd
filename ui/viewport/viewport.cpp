// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include "ui/session/view_picture.h"
#include "ui/viewport/make_canvas.h"
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
#include <variant>

namespace tetra {
namespace {

/// The camera rests when it has not moved for this long.
constexpr auto restAfter = std::chrono::milliseconds(150);

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

Viewport::Viewport(BackendChoice choice, QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setMouseTracking(true);
    resting_.setSingleShot(true);
    resting_.setInterval(restAfter);
    connect(&resting_, &QTimer::timeout, this, &Viewport::rest);
    pausing_.setSingleShot(true);
    pausing_.setInterval(seriesPause);
    connect(&pausing_, &QTimer::timeout, this, [this] {
        if (QGuiApplication::mouseButtons() == Qt::NoButton)
            ++gesture_;
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
    useCanvas(makeCanvas(choice));
    followPalette();
}

void Viewport::useCanvas(Canvas* canvas)
{
    if (canvas_ != nullptr) {
        canvas_->widget()->hide();
        canvas_->widget()->deleteLater();
    }
    canvas_ = canvas;
    canvas_->widget()->setObjectName("viewport.canvas");
    canvas_->widget()->setMouseTracking(true);
    canvas_->framePainted = [this](const FrameReport& report) { emit framePainted(report); };
    canvas_->failed = [this](const QString& text) { emit failed(text); };
    canvas_->unusable = [this](const QString& text) {
        emit failed(tr("OpenGL cannot be used, the picture is drawn by the processor instead. %1").arg(text));
        useCanvas(makeCanvas(BackendChoice::Cpu));
    };
    setFrameRate(frameRate_);
    layout()->addWidget(canvas_->widget());
    canvas_->widget()->lower(); // below what tools draw over it
    canvas_->show(view_);
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
    canvas_->show(view_);
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
    const auto pixelsPerUnit = static_cast<float>(devicePixelRatioF());
    if (outlines_.empty() && pixelsPerUnit == 1)
        return level;
    auto scene = std::make_shared<Scene>(*level.scene);
    for (std::size_t i = 0; i < outlines_.size(); ++i) {
        for (const Eigen::Vector3f& point : outlines_[i].points)
            scene->bounds.extend(point.cast<double>());
        scene->drawables.push_back({.id = "tool-outline-" + std::to_string(i + 1), .shape = outlines_[i]});
    }
    for (Drawable& drawable : scene->drawables)
        if (auto* lines = std::get_if<LineSet>(&drawable.shape))
            lines->width *= pixelsPerUnit;
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
    canvas_->show(view_);
}

void Viewport::setCamera(const Camera& camera)
{
    if (camera != camera_)
        moveCamera(camera);
}

void Viewport::startFrom(const Camera& camera, const std::optional<Colour>& background)
{
    endPreview();
    ++gesture_;
    glide_.stop();
    camera_ = camera;
    view_.camera = camera;
    background_ = background;
    emit started();
    followPalette();
    emit cameraChanged();
}

void Viewport::startFitted(const Camera& camera, const Eigen::AlignedBox3d& bounds)
{
    startBounds_ = bounds;
    startFit_ = fitted(camera, bounds, aspectRatio());
    startFrom(*startFit_, std::nullopt);
}

void Viewport::glideTo(const Camera& camera)
{
    endPreview();
    if (camera == camera_)
        return;
    ++gesture_;
    glide_.stop();
    glideFrom_ = view_.camera;
    camera_ = camera;
    const bool glides = mayGlide(*this) && isVisible();
    if (glides)
        glide_.start();
    showGlide(glides ? 0 : 1); // tells at once: the choice is made
    ++gesture_;
}

void Viewport::showGlide(double part)
{
    view_.camera = between(glideFrom_, camera_, part);
    view_.moving = true;
    resting_.start();
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::setPreview(const std::optional<Camera>& camera)
{
    if (!camera)
        return endPreview();
    glide_.stop();
    previewing_ = true;
    view_.camera = *camera;
    view_.moving = true;
    resting_.start();
    canvas_->show(view_);
    emit previewChanged(true);
}

void Viewport::endPreview()
{
    if (!previewing_)
        return;
    previewing_ = false;
    view_.camera = camera_;
    canvas_->show(view_);
    emit previewChanged(false);
}

void Viewport::setBackground(const std::optional<Colour>& background)
{
    if (background == background_)
        return;
    ++gesture_; // each choice is a step of its own
    background_ = background;
    followPalette();
}

void Viewport::setFollowing(bool following)
{
    if (following == following_)
        return;
    following_ = following;
    view_.moving = following || resting_.isActive();
    canvas_->show(view_);
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

void Viewport::fit(const Eigen::AlignedBox3d& bounds)
{
    glideTo(fitted(camera_, bounds, aspectRatio()));
}

double Viewport::aspectRatio() const
{
    return static_cast<double>(std::max(1, width())) / std::max(1, height());
}

void Viewport::seeFrom(NamedView view)
{
    glideTo(seenFrom(camera_, view));
}

void Viewport::setPerspective(bool perspective)
{
    Camera camera = camera_;
    camera.perspective = perspective;
    glideTo(camera);
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

void Viewport::moveCamera(const Camera& camera)
{
    endPreview();
    glide_.stop();
    camera_ = camera;
    view_.camera = camera;
    view_.moving = true;
    resting_.start();
    pausing_.start();
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::rest()
{
    view_.moving = following_;
    canvas_->show(view_);
}

void Viewport::mousePressEvent(QMouseEvent* event)
{
    lastPosition_ = event->position();
    ++gesture_;
}

void Viewport::mouseReleaseEvent(QMouseEvent* event)
{
    QWidget::mouseReleaseEvent(event);
    ++gesture_;
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF before = std::exchange(lastPosition_, event->position());
    const QPointF moved = lastPosition_ - before;
    const bool left = event->buttons().testFlag(Qt::LeftButton);
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->buttons().testFlag(Qt::MiddleButton) || (left && shift))
        moveCamera(pannedByDrag(camera(), moved, size()));
    else if (left)
        moveCamera(turnedByDrag(camera(), before, lastPosition_, size()));
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    if (isPan(*event))
        moveCamera(pannedByDrag(camera(), event->pixelDelta(), size()));
    else
        moveCamera(zoomedByWheel(camera(), event->angleDelta().y()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (const auto moved = movedByKey(camera(), *event))
        moveCamera(*moved);
    else
        QWidget::keyPressEvent(event);
}

bool Viewport::event(QEvent* event)
{
    const auto factor = pinchFactor(*event);
    if (!factor)
        return QWidget::event(event);
    moveCamera(zoomedByPinch(camera(), *factor));
    event->accept();
    return true;
}

void Viewport::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        followPalette();
}

void Viewport::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    emit resized();
    if (startFit_ && camera_ == *startFit_ && !previewing_) {
        startFit_ = fitted(camera_, startBounds_, aspectRatio());
        startFrom(*startFit_, background_);
    }
}

void Viewport::followPalette()
{
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    view_.background = background_.value_or(usualBackground(dark));
    canvas_->show(view_);
    emit backgroundChanged();
}

} // namespace tetra
