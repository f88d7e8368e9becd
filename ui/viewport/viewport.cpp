// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport.h"

#include "ui/viewport/make_canvas.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QVBoxLayout>
#include <QWheelEvent>

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
    canvas_->framePainted = [this](double seconds) { emit framePainted(seconds); };
    canvas_->failed = [this](const QString& text) { emit failed(text); };
    canvas_->unusable = [this](const QString& text) {
        emit failed(tr("OpenGL cannot be used, the picture is drawn by the processor instead. %1").arg(text));
        useCanvas(makeCanvas(BackendChoice::Cpu));
    };
    layout()->addWidget(canvas_->widget());
    canvas_->widget()->lower(); // below what tools draw over it
    canvas_->show(view_);
}

void Viewport::setScene(std::shared_ptr<const Scene> scene)
{
    scene_ = std::move(scene);
    show();
}

void Viewport::setOutlines(std::vector<LineSet> outlines)
{
    if (outlines.empty() && outlines_.empty())
        return;
    outlines_ = std::move(outlines);
    show();
}

/// The scene with the outlines, which may stick out of the domain.
void Viewport::show()
{
    view_.scene = scene_;
    if (scene_ && !outlines_.empty()) {
        auto scene = std::make_shared<Scene>(*scene_);
        for (const LineSet& outline : outlines_) {
            for (const Eigen::Vector3f& point : outline.points)
                scene->bounds.extend(point.cast<double>());
            scene->lines.push_back(outline);
        }
        view_.scene = std::move(scene);
    }
    canvas_->show(view_);
}

void Viewport::fit(const Eigen::AlignedBox3d& bounds)
{
    view_.camera = fitted(view_.camera, bounds);
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::seeFrom(NamedView view)
{
    view_.camera = seenFrom(view_.camera, view);
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::setPerspective(bool perspective)
{
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
    view_.camera = camera;
    view_.moving = true;
    resting_.start();
    canvas_->show(view_);
    emit cameraChanged();
}

void Viewport::rest()
{
    view_.moving = false;
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
        moveCamera(pannedByDrag(view_.camera, moved, size()));
    else if (left)
        moveCamera(turnedByDrag(view_.camera, moved));
}

void Viewport::wheelEvent(QWheelEvent* event)
{
    moveCamera(zoomedByWheel(view_.camera, event->angleDelta().y()));
}

void Viewport::keyPressEvent(QKeyEvent* event)
{
    if (const auto moved = movedByKey(view_.camera, *event))
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
    view_.background = dark ? darkBackground : lightBackground;
    canvas_->show(view_);
}

} // namespace tetra
