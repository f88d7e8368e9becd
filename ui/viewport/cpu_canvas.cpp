// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/cpu_canvas.h"

#include "ui/session/picture_image.h"

#include <QPainter>

#include <chrono>

namespace tetra {
namespace {

/// The time that a picture may take while the camera moves, in seconds.
constexpr double movingBudget = 0.04;
constexpr int coarsestReduction = 4;
/// A coarse picture on its way is finished and shown before a newer one begins; a fine one is given up.
constexpr auto movingPatience = std::chrono::milliseconds(200);

} // namespace

CpuCanvas::CpuCanvas(QWidget* parent) : QWidget(parent), backend_(makeCpuBackend())
{
    setAttribute(Qt::WA_OpaquePaintEvent);
}

CpuCanvas::~CpuCanvas() = default;

QString CpuCanvas::backendName() const
{
    return tr("CPU");
}

void CpuCanvas::show(const View& view)
{
    view_ = view;
    render();
}

void CpuCanvas::render()
{
    settled_ = false;
    const QSize pixels = size() * devicePixelRatioF();
    if (pixels.isEmpty())
        return;
    const bool fine = !view_.moving;
    const int divisor = fine ? 1 : reduction(pixels);
    PictureOptions options;
    options.width = std::max(1, pixels.width() / divisor);
    options.height = std::max(1, pixels.height() / divisor);
    options.background = view_.background;
    options.samplesPerAxis = fine ? 2 : 1;
    job_.submit(
        [this, backend = backend_, view = view_, options, fine, number = ++newest_](const std::stop_token& stop) {
            Drawn drawn = draw(*backend, view, options, stop);
            drawn.number = number;
            drawn.fine = fine;
            QMetaObject::invokeMethod(
                this, [this, drawn = std::move(drawn)] { arrived(drawn); }, Qt::QueuedConnection);
        },
        fine ? std::chrono::milliseconds(0) : movingPatience);
}

CpuCanvas::Drawn CpuCanvas::draw(RenderBackend& backend, const View& view, const PictureOptions& options,
                                 const std::stop_token& stop)
{
    const auto start = std::chrono::steady_clock::now();
    static const Scene nothing;
    const auto picture = backend.render(view.scene ? *view.scene : nothing, view.camera, options, Progress(stop, {}));
    Drawn drawn;
    if (picture) {
        drawn.image = imageOf(*picture);
    } else {
        drawn.cancelled = picture.error().kind == ErrorKind::Cancelled;
        drawn.error = QString::fromStdString(picture.error().text);
    }
    drawn.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return drawn;
}

void CpuCanvas::arrived(const Drawn& drawn)
{
    if (drawn.cancelled)
        return;
    if (drawn.image.isNull()) {
        settled_ = true;
        failed(drawn.error);
        return;
    }
    // An older picture is still news while the camera moves, but not over a newer fine one.
    if (settled_ && drawn.number < newest_)
        return;
    if (!drawn.fine)
        secondsPerPixel_ = drawn.seconds / (static_cast<double>(drawn.image.width()) * drawn.image.height());
    shown_ = drawn.image;
    settled_ = drawn.fine && drawn.number == newest_;
    update();
    framePainted(drawn.seconds);
}

int CpuCanvas::reduction(QSize pixels) const
{
    const double whole = secondsPerPixel_ * pixels.width() * pixels.height();
    int divisor = secondsPerPixel_ > 0 ? 1 : 2;
    while (divisor < coarsestReduction && whole / (divisor * divisor) > movingBudget)
        ++divisor;
    return divisor;
}

void CpuCanvas::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    if (shown_.isNull()) {
        painter.fillRect(rect(), QColor::fromRgbF(view_.background.red, view_.background.green, view_.background.blue));
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, shown_.size() != size() * devicePixelRatioF());
    painter.drawImage(rect(), shown_);
}

void CpuCanvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    render();
}

} // namespace tetra
