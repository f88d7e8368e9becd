// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include "ui/viewport/make_canvas.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <chrono>

namespace tetra {
namespace {

/// The camera rests when it has not moved for this long.
constexpr auto restAfter = std::chrono::milliseconds(150);

constexpr Colour lightBackground{0.957F, 0.961F, 0.969F};
constexpr Colour darkBackground{0.118F, 0.125F, 0.137F};

} // namespace

Viewport::Viewport(BackendChoice choice, QWidget* parent) : QWidget(parent)
{
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(200, 150);
    setMouseTracking(true);
    resting_.setSingleShot(true);
    resting_.setInterval(restAfter);
    connect(&resting_, &QTimer::timeout, this, &Viewport::rest);
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

/// The scene with the outlines, which may stick out of the domain.
SceneLevel Viewport::withOutlines(const SceneLevel& level) const
{
    if (outlines_.empty())
        return level;
    auto scene = std::make_shared<Scene>(*level.scene);
    for (const LineSet& outline : outlines_) {
        for (const Eigen::Vector3f& point : outline.points)
            scene->bounds.extend(point.cast<double>());
        scene->lines.push_back(outline);
    }
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
    if (camera != Viewport::camera())
        moveCamera(camera);
}

void Viewport::setPreview(const std::optional<Camera>& camera)
{
    if (!camera)
        return endPreview();
    if (!kept_)
        kept_ = view_.camera;
    view_.camera = *camera;
    view_.moving = true;
    resting_.start();
    canvas_->show(view_);
    emit previewChanged(true);
}

void Viewport::endPreview()
{
    if (!kept_)
        return;
    view_.camera = *kept_;
    kept_.reset();
    canvas_->show(view_);
    emit previewChanged(false);
}

void Viewport::setBackground(const std::optional<Colour>& background)
{
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

void Viewport::setFrameRate(std::optional<double> perSecond)
{
    frameRate_ = perSecond;
    canvas_->setFrameRate(perSecond.value_or(canvas_->usualFrameRate()));
}

void Viewport::fit(const Eigen::AlignedBox3d& bounds)
{
    endPreview();
    view_.camera = fitted(view_.camera, bounds);
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::seeFrom(NamedView view)
{
    endPreview();
    view_.camera = seenFrom(view_.camera, view);
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::setPerspective(bool perspective)
{
    endPreview();
    view_.camera.perspective = perspective;
    canvas_->show(view_);
    emit cameraChanged();
}

QString Viewport::backendName() const
{
    return canvas_->backendName();
}

bool Viewport::settled() const
{
    return !view_.moving && canvas_->settled();
}

QImage Viewport::picture() const
{
    return canvas_->picture();
}

void Viewport::moveCamera(const Camera& camera)
{
    endPreview();
    view_.camera = camera;
    view_.moving = true;
    resting_.start();
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
}

void Viewport::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF moved = event->position() - lastPosition_;
    lastPosition_ = event->position();
    const bool left = event->buttons().testFlag(Qt::LeftButton);
    const bool shift = event->modifiers().testFlag(Qt::ShiftModifier);
    if (event->buttons().testFlag(Qt::MiddleButton) || (left && shift))
        moveCamera(pannedByDrag(camera(), moved, size()));
    else if (left)
        moveCamera(turnedByDrag(camera(), moved));
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    moveCamera(zoomedByWheel(camera(), event->angleDelta().y()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (const auto moved = movedByKey(camera(), *event))
        moveCamera(*moved);
    else
        QWidget::keyPressEvent(event);
}

void Viewport::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        followPalette();
}

void Viewport::followPalette()
{
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    view_.background = background_.value_or(dark ? darkBackground : lightBackground);
    canvas_->show(view_);
    emit backgroundChanged();
}

} // namespace tetra
