// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/canvas.h"

#include "core/picture/scene_pipeline.h"
#include "plugins/widgets/colour_button.h"
#include "ui/scenes/picture_image.h"
#include "ui/session/message_text.h"
#include "ui/widgets/motion.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

/// Along each axis of a pixel: edges are as smooth as in saved pictures, unless that would take longer than this, in
/// seconds, or on a graphics card more samples than have room there.
constexpr int mostSmooth = 4;
constexpr int fineSamples = 2;
constexpr double longestSmoothing = 5;
constexpr double mostSamplesOfGl = 24e6;
/// A coarse picture on its way is finished and shown before a newer one begins; a fine one is given up.
constexpr auto movingPatience = std::chrono::milliseconds(200);
/// What the user chose to draw, whatever it takes, is finished.
constexpr auto chosenPatience = std::chrono::hours(1);
constexpr int fadeTime = 150; // milliseconds
/// The order of cells is used again for cameras that differ by less, in degrees: what is wrong then cannot be seen in
/// motion.
constexpr double movingTolerance = 4;

/// How well OpenGL works here.
enum class GlSupport { None, Software, Hardware };

QSurfaceFormat wantedFormat()
{
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

/// Whether the driver computes on the processor.
bool isSoftware(const QString& renderer)
{
    return std::ranges::any_of(std::array{"llvmpipe", "softpipe", "swrast", "SwiftShader"},
                               [&](const char* name) { return renderer.contains(name, Qt::CaseInsensitive); });
}

/// Tries a context off the screen. None where the platform has no screen that could be drawn on faster.
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
    const bool isRecent = context.format().version() >= qMakePair(3, 3);
    const auto* renderer = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
    const bool software = isSoftware(QString::fromUtf8(renderer));
    context.doneCurrent();
    if (!isRecent)
        return GlSupport::None;
    return software ? GlSupport::Software : GlSupport::Hardware;
}

bool choosesGl(BackendChoice choice)
{
    const GlSupport support = choice == BackendChoice::Cpu ? GlSupport::None : glSupport();
    return support == GlSupport::Hardware || (support == GlSupport::Software && choice == BackendChoice::Gl);
}

bool haveSameStill(const View& first, const View& second)
{
    const auto still = [](const View& view) { return view.levels.empty() ? nullptr : view.levels.front().scene.get(); };
    return still(first) == still(second) && first.camera == second.camera && first.background == second.background;
}

/// Whether a moving picture of this level of `second` would show what was seen of `first` already: its scene is not
/// there yet.
bool wouldShowNothingNew(const View& first, const View& second, std::size_t level)
{
    return level < first.levels.size() && level < second.levels.size() &&
           first.levels[level].scene == second.levels[level].scene && first.camera == second.camera &&
           first.background == second.background;
}

/// The levels of a view for the choice between them.
std::vector<FrameLevel> frameLevels(const View& view)
{
    std::vector<FrameLevel> levels;
    for (const SceneLevel& level : view.levels) {
        FrameLevel& added = levels.emplace_back();
        added.tetrahedra = static_cast<double>(level.tetrahedra);
        added.isVolume = hasVolume(*level.scene);
        added.triangles = static_cast<double>(triangleCount(*level.scene));
    }
    return levels;
}

} // namespace

/// The worker's, made when the first picture is drawn: that may take a while.
struct Canvas::Backends {
    /// Two on the CPU, of moving pictures and of fine ones, as each keeps what its own mesh needs; a graphics card has
    /// what all meshes need.
    struct Pair {
        std::shared_ptr<RenderBackend> moving{};
        std::shared_ptr<RenderBackend> fine{};

        RenderBackend& of(const Order& order) const { return order.isLast || !order.moving ? *fine : *moving; }
    };

    bool usesGl = false;
    Pair chosen{};
    Pair processor{};                          ///< for what OpenGL refuses; made when it does
    std::weak_ptr<const Scene> refusedScene{}; ///< the last one that OpenGL refused,
    double refusedSamples = 0;                 ///< in pictures of so many samples,
    QString refusal{};                         ///< and why

    static Pair onProcessor() { return {makeCpuBackend(), makeCpuBackend()}; }

    Status make()
    {
        if (chosen.fine)
            return {};
        if (!usesGl) {
            chosen = onProcessor();
            return {};
        }
        auto made = makeGlBackend();
        if (!made)
            return made.error();
        chosen.fine = chosen.moving = *std::move(made);
        return {};
    }

    /// Whether the chosen one draws a picture of nothing. What does that has refused the picture before it; what does
    /// not is of no use any more: its context is gone.
    bool drawsAnything(const Order& order) const
    {
        PictureOptions options;
        options.width = options.height = 1;
        options.samplesPerAxis = 1;
        return static_cast<bool>(chosen.fine->render(Scene(), order.camera, options));
    }

    bool refuses(const Order& order) const
    {
        return order.level.scene && refusedScene.lock() == order.level.scene && samplesOf(order) >= refusedSamples;
    }

    void refuse(const Order& order, const QString& why)
    {
        refusedScene = order.level.scene;
        refusedSamples = samplesOf(order);
        refusal = why;
        if (!processor.fine)
            processor = onProcessor();
    }
};

Canvas::Canvas(BackendChoice choice, QWidget* parent)
    : QWidget(parent), usesGl_(choosesGl(choice)), backends_(std::make_shared<Backends>(Backends{.usesGl = usesGl_}))
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    pacer_.setFrameRate(usualFrameRate());
    fade_.setStartValue(0.0);
    fade_.setEndValue(1.0);
    fade_.setDuration(fadeTime);
    connect(&fade_, &QVariantAnimation::valueChanged, this, [this] { update(); });
    connect(&fade_, &QVariantAnimation::finished, this, [this] { fadedFrom_ = {}; });
}

Canvas::~Canvas() = default;

void Canvas::setMovingKind(MovingQuality::Kind kind)
{
    if (kind == pacer_.kind())
        return;
    pacer_.setKind(kind);
    if (newest_ > 0)
        render();
}

QString Canvas::backendName() const
{
    return usesGl_ ? tr("OpenGL") : tr("CPU");
}

void Canvas::setView(const View& view)
{
    const View before = std::exchange(view_, view);
    pacer_.setLevels(frameLevels(view));
    if (!view_.moving)
        clock_.stop();
    if (view_.levels.empty() && !before.levels.empty()) {
        // What was seen is gone, and is not to be taken for what comes.
        shown_ = {};
        fade_.stop();
        emptied_ = newest_;
        update();
    }
    const bool isAlwaysFull = pacer_.kind() == MovingQuality::Kind::Full;
    const bool areStill = isAlwaysFull || (!before.moving && !view_.moving);
    if (newest_ == 0 || !((areStill && haveSameStill(before, view_)) || bringsNothing(before)))
        render();
}

/// A finer scene while coarser ones move, or the other way round: a picture would only hold up the next one.
bool Canvas::bringsNothing(const View& before)
{
    return view_.moving && wouldShowNothingNew(before, view_, pacer_.nextFrame(pixelCount()).level);
}

/// Begins anew: the view or the size has changed.
void Canvas::render()
{
    settled_ = false;
    ++newest_;
    if (pixels().isEmpty())
        return;
    if (pacer_.kind() == MovingQuality::Kind::Full)
        return drawFull();
    if (view_.moving)
        return drawMoving();
    steps_ = pacer_.refinement(pixelCount(), smoothSamples());
    refine(0);
}

/// Along each axis of a pixel.
int Canvas::smoothSamples() const
{
    const auto isTooMuch = [&](int samples) {
        return pacer_.secondsOfStill(pixelCount(), samples) > longestSmoothing ||
               (usesGl_ && (isTooSmooth_ || pixelCount() * samples * samples > mostSamplesOfGl));
    };
    int samples = mostSmooth;
    while (samples > fineSamples && isTooMuch(samples))
        samples = usesGl_ ? samples - 1 : fineSamples;
    return samples;
}

double Canvas::pixelCount() const
{
    return static_cast<double>(pixels().width()) * pixels().height();
}

void Canvas::drawMoving()
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

/// As at rest, at once.
void Canvas::drawFull()
{
    Order order;
    order.moving = view_.moving;
    order.isLast = true;
    order.options.samplesPerAxis = smoothSamples();
    submit(order);
}

/// Draws this step and, when it is on the screen, the next one.
void Canvas::refine(std::size_t step)
{
    Order order;
    order.step = step;
    order.isLast = step + 1 == steps_.size();
    order.reduction = steps_[step].reduction;
    order.options.samplesPerAxis = steps_[step].samplesPerAxis;
    order.options.orderTolerance = order.isLast ? 0 : movingTolerance;
    submit(order);
}

void Canvas::submit(Order order)
{
    if (order.levelIndex < view_.levels.size())
        order.level = view_.levels[order.levelIndex];
    order.camera = view_.camera;
    order.options.width = std::max(1, static_cast<int>(std::lround(pixels().width() / order.reduction)));
    order.options.height = std::max(1, static_cast<int>(std::lround(pixels().height() / order.reduction)));
    order.options.background = view_.background;
    order.view = newest_;
    job_.submit(
        [this, order, backends = backends_](const std::stop_token& stop) {
            QMetaObject::invokeMethod(
                this, [this, order, drawn = draw(*backends, order, stop)] { arrived(order, drawn); },
                Qt::QueuedConnection);
        },
        !order.moving                                     ? std::chrono::milliseconds(0)
        : pacer_.kind() == MovingQuality::Kind::FrameRate ? movingPatience
                                                          : std::chrono::milliseconds(chosenPatience));
}

double Canvas::samplesOf(const Order& order)
{
    return std::pow(order.options.samplesPerAxis, 2) * order.options.width * order.options.height;
}

Canvas::Drawn Canvas::draw(Backends& backends, const Order& order, const std::stop_token& stop)
{
    if (const Status made = backends.make(); !made)
        return {.error = translatedMessage(made.error().message), .isUnusable = true};
    Drawn drawn;
    if (!backends.refuses(order)) {
        drawn = drawWith(backends.chosen.of(order), order, stop);
        const bool mayBeTooSmooth = order.options.samplesPerAxis > fineSamples; // arrived() takes fewer first
        if (!backends.usesGl || !drawn.image.isNull() || drawn.cancelled || mayBeTooSmooth)
            return drawn;
        drawn.isUnusable = !backends.drawsAnything(order);
        if (drawn.isUnusable)
            return drawn;
        backends.refuse(order, drawn.error);
    }
    drawn = drawWith(backends.processor.of(order), order, stop);
    drawn.refusal = backends.refusal;
    return drawn;
}

Canvas::Drawn Canvas::drawWith(RenderBackend& backend, const Order& order, const std::stop_token& stop)
{
    Drawn drawn;
    const auto start = std::chrono::steady_clock::now();
    static const Scene nothing;
    Scene scene = order.level.scene ? *order.level.scene : nothing;
    scaleLines(scene, 1 / order.reduction); // as wide as in the full picture
    const auto picture = backend.render(scene, order.camera, order.options, Progress(stop, {}));
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

void Canvas::arrived(const Order& order, const Drawn& drawn)
{
    if (drawn.cancelled || order.view <= emptied_)
        return;
    const bool isNewest = order.view == newest_;
    if (drawn.image.isNull()) {
        settled_ = settled_ || isNewest;
        return tellError(order, drawn);
    }
    tellRefusal(drawn.refusal);
    pacer_.learn(order.levelIndex, samplesOf(order), drawn.statistics, drawn.seconds);
    // An older picture is still news while the camera moves, but not over a newer fine one.
    if (!isNewest && (settled_ || !order.moving))
        return;
    showPicture(order, drawn.image);
    settled_ = isNewest && order.isLast;
    emit framePainted({drawn.seconds, order.moving, order.moving ? clock_.tick() : 0, order.reduction,
                       order.level.tetrahedra, drawn.statistics.cells, drawn.statistics.cutCells,
                       drawn.statistics.brokenCycles});
    if (isNewest && !order.moving && !order.isLast)
        refine(order.step + 1);
}

/// A graphics card that fails has no room for so many samples, or is of no use.
void Canvas::tellError(const Order& order, const Drawn& drawn)
{
    if (drawn.isUnusable) {
        emit unusable(drawn.error);
    } else if (usesGl_ && order.options.samplesPerAxis > fineSamples && drawn.refusal.isEmpty()) {
        isTooSmooth_ = true;
        render();
    } else {
        emit failed(drawn.error);
    }
}

/// Once for all pictures that follow each other and are refused for the same reason.
void Canvas::tellRefusal(const QString& refusal)
{
    if (!refusal.isEmpty())
        isTooSmooth_ = false; // that was not the reason
    const bool isNew = refusal != std::exchange(toldRefusal_, refusal);
    if (isNew && !refusal.isEmpty())
        emit failed(tr("OpenGL cannot draw this picture; the CPU draws it instead. %1").arg(refusal));
}

/// A finer picture of what a coarse one shows fades in; what moves is there at once.
void Canvas::showPicture(const Order& order, const QImage& image)
{
    const bool fades = isShownCoarse_ && !order.moving && !shown_.isNull() && order.camera == shownCamera_ &&
                       isVisible() && mayGlide(*this);
    if (fades) {
        QImage seen(pixels(), QImage::Format_RGB32);
        QPainter painter(&seen);
        paint(painter, seen.rect());
        fadedFrom_ = seen;
    }
    fade_.stop();
    shown_ = image;
    shownCamera_ = order.camera;
    isShownCoarse_ = !order.isLast;
    if (fades)
        fade_.start();
    else
        fadedFrom_ = {};
    update();
}

void Canvas::paint(QPainter& painter, const QRect& area) const
{
    painter.setRenderHint(QPainter::SmoothPixmapTransform, shown_.size() != pixels());
    if (!fadedFrom_.isNull()) {
        painter.drawImage(area, fadedFrom_);
        painter.setOpacity(fade_.currentValue().toDouble());
    }
    painter.drawImage(area, shown_);
}

void Canvas::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    if (shown_.isNull())
        painter.fillRect(rect(), qtColour(view_.background));
    else
        paint(painter, rect());
}

void Canvas::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    render();
}

} // namespace tetra
