// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/gl_canvas.h"

#include "core/graphics/gl/scene_painter.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QTimer>

#include <chrono>

namespace tetra {
namespace {

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
}

GlCanvas::~GlCanvas()
{
    release();
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
    view_ = view;
    settled_ = false;
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
        giveUp(QString::fromStdString(painter.error().text));
}

void GlCanvas::resizeGL(int width, int height)
{
    Q_UNUSED(width);
    Q_UNUSED(height);
    settled_ = false;
}

void GlCanvas::paintGL()
{
    if (!painter_)
        return;
    static const Scene nothing;
    const auto start = std::chrono::steady_clock::now();
    const QSize pixels = size() * devicePixelRatioF();
    PictureOptions options;
    options.width = pixels.width();
    options.height = pixels.height();
    options.background = view_.background;
    options.samplesPerAxis = view_.moving ? 1 : 2;
    const Status drawn =
        painter_->draw(view_.scene ? *view_.scene : nothing, view_.camera, options, defaultFramebufferObject());
    if (!drawn)
        return giveUp(QString::fromStdString(drawn.error().text));
    context()->functions()->glFinish(); // so that the time is that of drawing, not of asking for it
    settled_ = !view_.moving;
    framePainted(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
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
