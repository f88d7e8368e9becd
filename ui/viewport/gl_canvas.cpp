// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/gl_canvas.h"

#include "core/render/gl/scene_painter.h"
#include "ui/session/message_text.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

/// As in CpuCanvas, degrees.
constexpr double glMovingTolerance = 4;
/// Along each axis of a pixel, of the first picture at rest, and of the smooth one that follows where it is quick, in
/// seconds, as the window waits for it, and does not take too much memory, in samples.
constexpr int glFineSamples = 2;
constexpr int glSmoothSamples = 4;
constexpr double longestWait = 0.25;
constexpr double mostSamples = 24e6;

QSurfaceFormat wantedFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setAlphaBufferSize(0);
    return format;
}

/// Whether the driver computes on the processor.
bool isSoftware(const QString& renderer)
{
    for (const char* name : {"llvmpipe", "softpipe", "swrast", "SwiftShader"})
        if (renderer.contains(name, Qt::CaseInsensitive))
            return true;
    return false;
}

} // namespace

GlCanvas::GlCanvas(QWidget* parent) : QOpenGLWidget(parent)
{
    setFormat(wantedFormat());
    pacer_.setFrameRate(usualFrameRate());
}

GlCanvas::~GlCanvas()
{
    release();
    if (context() != nullptr) // QOpenGLWidget destroys it when this is no longer a GlCanvas
        disconnect(context(), nullptr, this, nullptr);
}

void GlCanvas::release()
{
    if (!painter_)
        return;
    makeCurrent();
    painter_.reset();
    doneCurrent();
}

QString GlCanvas::backendName() const
{
    return tr("OpenGL");
}

void GlCanvas::show(const View& view)
{
    const View before = std::exchange(view_, view);
    pacer_.setLevels(frameLevels(view));
    if (!view_.moving)
        clock_.stop();
    const QSize pixels = size() * devicePixelRatioF();
    const auto level = [&] { return pacer_.nextFrame(static_cast<double>(pixels.width()) * pixels.height()).level; };
    if (haveSameStill(before, view_) || (view_.moving && wouldShowNothingNew(before, view_, level())))
        return;
    settled_ = false;
    smoothing_ = false;
    update();
}

void GlCanvas::initializeGL()
{
    // The context goes when the widget moves to another window.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::release, Qt::UniqueConnection);
    auto painter = ScenePainter::make([](const char* name) {
        return reinterpret_cast<void*>(QOpenGLContext::currentContext()->getProcAddress(name));
    });
    if (painter)
        painter_ = *std::move(painter);
    else
        giveUp(translatedMessage(painter.error().message));
}

void GlCanvas::resizeGL(int width, int height)
{
    Q_UNUSED(width);
    Q_UNUSED(height);
    settled_ = false;
    smoothing_ = false;
}

void GlCanvas::paintGL()
{
    if (!painter_)
        return;
    const auto start = std::chrono::steady_clock::now();
    const QSize pixels = size() * devicePixelRatioF();
    const FramePlan plan =
        view_.moving ? pacer_.nextFrame(static_cast<double>(pixels.width()) * pixels.height()) : FramePlan();
    const SceneLevel level = plan.level < view_.levels.size() ? view_.levels[plan.level] : SceneLevel();
    PictureOptions options;
    options.width = std::max(1, static_cast<int>(std::lround(pixels.width() / plan.reduction)));
    options.height = std::max(1, static_cast<int>(std::lround(pixels.height() / plan.reduction)));
    options.background = view_.background;
    options.samplesPerAxis = view_.moving ? 1 : smoothing_ ? smoothSamples() : glFineSamples;
    options.orderTolerance = view_.moving ? glMovingTolerance : 0;
    Status drawn = draw(level, options);
    if (!drawn && smoothing_) {
        isTooSmooth_ = true;
        options.samplesPerAxis = glFineSamples;
        drawn = draw(level, options);
    }
    if (!drawn)
        return giveUp(translatedMessage(drawn.error().message));
    context()->functions()->glFinish(); // so that the time is that of drawing, not of asking for it
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const int samples = options.samplesPerAxis * options.samplesPerAxis;
    pacer_.learn(plan.level, static_cast<double>(samples) * options.width * options.height, painter_->statistics(),
                 seconds);
    const bool smoothNext = !view_.moving && !smoothing_ && smoothSamples() > glFineSamples;
    settled_ = !view_.moving && !smoothNext;
    if (smoothNext) {
        smoothing_ = true;
        update();
    }
    const RenderStatistics statistics = painter_->statistics();
    framePainted({seconds, view_.moving, view_.moving ? clock_.tick() : 0, plan.reduction, level.tetrahedra,
                  statistics.cells, statistics.brokenCycles});
}

/// Along each axis of a pixel.
int GlCanvas::smoothSamples() const
{
    const QSize pixels = size() * devicePixelRatioF();
    const double count = static_cast<double>(pixels.width()) * pixels.height();
    int samples = isTooSmooth_ ? glFineSamples : glSmoothSamples;
    while (samples > glFineSamples &&
           (count * samples * samples > mostSamples || pacer_.secondsOfStill(count, samples) > longestWait))
        --samples;
    return samples;
}

/// A picture that is smaller than the window is drawn beside it and stretched over it.
Status GlCanvas::draw(const SceneLevel& level, const PictureOptions& options)
{
    static const Scene nothing;
    const Scene& scene = level.scene ? *level.scene : nothing;
    const QSize drawn(options.width, options.height);
    const QSize shown = size() * devicePixelRatioF();
    if (drawn == shown)
        return painter_->draw(scene, view_.camera, options, defaultFramebufferObject());
    QOpenGLFramebufferObject smaller(drawn);
    if (const Status status = painter_->draw(scene, view_.camera, options, smaller.handle()); !status)
        return status;
    QOpenGLExtraFunctions* functions = context()->extraFunctions();
    functions->glBindFramebuffer(GL_READ_FRAMEBUFFER, smaller.handle());
    functions->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    functions->glBlitFramebuffer(0, 0, drawn.width(), drawn.height(), 0, 0, shown.width(), shown.height(),
                                 GL_COLOR_BUFFER_BIT, GL_LINEAR);
    functions->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    return {};
}

void GlCanvas::giveUp(const QString& text)
{
    if (givenUp_)
        return;
    givenUp_ = true;
    // Later: the canvas is replaced, and it is just being painted.
    QTimer::singleShot(0, this, [this, text] { unusable(text); });
}

GlSupport glSupport()
{
    static const QStringList without{"offscreen", "minimal", "vnc", "linuxfb", "minimalegl", "eglfs"};
    if (without.contains(QGuiApplication::platformName()))
        return GlSupport::None;
    QOffscreenSurface surface;
    surface.setFormat(wantedFormat());
    surface.create();
    QOpenGLContext context;
    context.setFormat(wantedFormat());
    if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface))
        return GlSupport::None;
    const bool recent = context.format().version() >= qMakePair(3, 3);
    const auto* renderer = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const bool software = isSoftware(QString::fromUtf8(renderer));
    context.doneCurrent();
    if (!recent)
        return GlSupport::None;
    return software ? GlSupport::Software : GlSupport::Hardware;
}

} // namespace tetra
