// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/cpu_canvas.h"

#include "ui/session/message_text.h"
#include "ui/session/picture_image.h"

#include <QPainter>

#include <chrono>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

/// Along each axis of a pixel: edges are as smooth as in saved pictures, unless that would keep the processor busy for
/// longer than this, in seconds.
constexpr int smoothSamples = 4;
constexpr int fineSamples = 2;
constexpr double longestSmoothing = 5;
/// A coarse picture on its way is finished and shown before a newer one begins; a fine one is given up.
constexpr auto movingPatience = std::chrono::milliseconds(200);
/// The order of cells is used again for cameras that differ by less, in degrees: what is wrong then cannot be seen in
/// motion.
constexpr double movingTolerance = 4;

} // namespace

CpuCanvas::CpuCanvas(QWidget* parent)
    : QWidget(parent), movingBackend_(makeCpuBackend()), fineBackend_(makeCpuBackend())
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    pacer_.setFrameRate(usualFrameRate());
}

CpuCanvas::~CpuCanvas() = default;

QString CpuCanvas::backendName() const
{
    return tr("CPU");
}

void CpuCanvas::show(const View& view)
{
    const View before = std::exchange(view_, view);
    pacer_.setLevels(frameLevels(view));
    if (!view_.moving)
        clock_.stop();
    if (view_.levels.empty() && !before.levels.empty()) {
        // What was seen is gone, and is not to be taken for what comes.
        shown_ = {};
        emptied_ = newest_;
        update();
    }
    if (newest_ == 0 || !(haveSameStill(before, view_) || bringsNothing(before)))
        render();
}

/// A finer scene while coarser ones move, or the other way round: a picture would only hold up the next one.
bool CpuCanvas::bringsNothing(const View& before)
{
    return view_.moving && wouldShowNothingNew(before, view_, pacer_.nextFrame(pixelCount()).level);
}

/// Begins anew: the view or the size has changed.
void CpuCanvas::render()
{
    settled_ = false;
    ++newest_;
    if (pixels().isEmpty())
        return;
    if (view_.moving)
        return drawMoving();
    const bool isSmooth = pacer_.secondsOfStill(pixelCount(), smoothSamples) <= longestSmoothing;
    steps_ = pacer_.refinement(pixelCount(), isSmooth ? smoothSamples : fineSamples);
    refine(0);
}

double CpuCanvas::pixelCount() const
{
    return static_cast<double>(pixels().width()) * pixels().height();
}

void CpuCanvas::drawMoving()
{
    const FramePlan plan = pacer_.nextFrame(pixelCount());
    Order order;
    order.levelIndex = plan.level;
    order.reduction = plan.reduction;
    order.moving = true;
    order.options.samplesPerAxis = 1;
    order.options.orderTolerance = movingTolerance;
    submit(order);
}

/// Draws this step and, when it is on the screen, the next one.
void CpuCanvas::refine(std::size_t step)
{
    Order order;
    order.step = step;
    order.isLast = step + 1 == steps_.size();
    order.reduction = steps_[step].reduction;
    order.options.samplesPerAxis = steps_[step].samplesPerAxis;
    order.options.orderTolerance = order.isLast ? 0 : movingTolerance;
    submit(order);
}

void CpuCanvas::submit(Order order)
{
    if (order.levelIndex < view_.levels.size())
        order.level = view_.levels[order.levelIndex];
    order.camera = view_.camera;
    order.options.width = std::max(1, static_cast<int>(std::lround(pixels().width() / order.reduction)));
    order.options.height = std::max(1, static_cast<int>(std::lround(pixels().height() / order.reduction)));
    order.options.background = view_.background;
    order.view = newest_;
    job_.submit(
        [this, order, backend = order.moving ? movingBackend_ : fineBackend_](const std::stop_token& stop) {
            QMetaObject::invokeMethod(
                this, [this, order, drawn = draw(*backend, order, stop)] { arrived(order, drawn); },
                Qt::QueuedConnection);
        },
        order.moving ? movingPatience : std::chrono::milliseconds(0));
}

CpuCanvas::Drawn CpuCanvas::draw(RenderBackend& backend, const Order& order, const std::stop_token& stop)
{
    const auto start = std::chrono::steady_clock::now();
    static const Scene nothing;
    Scene scene = order.level.scene ? *order.level.scene : nothing;
    for (LineSet& lines : scene.lines) // as wide as in the full picture
        lines.width = static_cast<float>(lines.width / order.reduction);
    const auto picture = backend.render(scene, order.camera, order.options, Progress(stop, {}));
    Drawn drawn;
    if (picture) {
        drawn.image = imageOf(*picture);
        drawn.statistics = backend.statistics();
    } else {
        drawn.cancelled = picture.error().kind == ErrorKind::Cancelled;
        drawn.error = translatedMessage(picture.error().message);
    }
    drawn.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return drawn;
}

void CpuCanvas::arrived(const Order& order, const Drawn& drawn)
{
    if (drawn.cancelled || order.view <= emptied_)
        return;
    const bool isNewest = order.view == newest_;
    if (drawn.image.isNull()) {
        settled_ = settled_ || isNewest;
        failed(drawn.error);
        return;
    }
    const double samples = std::pow(order.options.samplesPerAxis, 2) * order.options.width * order.options.height;
    pacer_.learn(order.levelIndex, samples, drawn.statistics, drawn.seconds);
    // An older picture is still news while the camera moves, but not over a newer fine one.
    if (!isNewest && (settled_ || !order.moving))
        return;
    shown_ = drawn.image;
    settled_ = isNewest && order.isLast;
    update();
    framePainted({drawn.seconds, order.moving, order.moving ? clock_.tick() : 0, order.reduction,
                  order.level.tetrahedra, drawn.statistics.cells, drawn.statistics.brokenCycles});
    if (isNewest && !order.moving && !order.isLast)
        refine(order.step + 1);
}

void CpuCanvas::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    if (shown_.isNull()) {
        painter.fillRect(rect(), QColor::fromRgbF(view_.background.red, view_.background.green, view_.background.blue));
        return;
    }
    painter.setRenderHint(QPainter::SmoothPixmapTransform, shown_.size() != pixels());
    painter.drawImage(rect(), shown_);
}

void CpuCanvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    render();
}

} // namespace tetra
