// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/lens_tool.h"

#include "core/view/lens.h"
#include "ui/session/annotation_language.h"
#include "ui/session/message_text.h"
#include "ui/viewport/viewport.h"
#include "ui/workbench/workbench.h"

#include <QImage>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include <chrono>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

constexpr auto seriesTime = std::chrono::milliseconds(700);
constexpr auto movingLensPatience = std::chrono::milliseconds(200);
constexpr int restingSamples = 2;
constexpr double perTurn = 1.15;     ///< of the magnification, for a notch of the wheel or a key
constexpr double anglePerTurn = 120; ///< of QWheelEvent
constexpr double lensStep = 0.02;    ///< of the picture's sides, for an arrow key

} // namespace

/// Made in the worker when the first picture is drawn; the canvas's own may be drawing.
struct LensTool::Backend {
    bool usesGl = false;
    std::unique_ptr<RenderBackend> made{};

    RenderBackend& get()
    {
        if (!made && usesGl)
            if (auto gl = makeGlBackend())
                made = *std::move(gl);
        if (!made)
            made = makeCpuBackend();
        return *made;
    }
};

struct LensTool::Order {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    PictureOptions options;
    double lineScale = 1;
    DrawnLens lens; ///< without its content
    bool fine = false;
    quint64 number = 0;
};

LensTool::LensTool(Workbench& workbench, Viewport& viewport)
    : QWidget(&viewport), workbench_(workbench), viewport_(viewport),
      backend_(std::make_shared<Backend>(Backend{.usesGl = viewport.usesGl()}))
{
    setObjectName("viewport.lens");
    setAccessibleName(tr("Lens"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    resting_.setSingleShot(true);
    resting_.setInterval(Viewport::usualIdleTime);
    connect(&resting_, &QTimer::timeout, this, &LensTool::rest);
    pausing_.setSingleShot(true);
    pausing_.setInterval(seriesTime);
    connect(&pausing_, &QTimer::timeout, this, [this] { series_ = 0; });
    Session& session = workbench.session();
    connect(&viewport, &Viewport::cameraChanged, this, &LensTool::follow);
    connect(&viewport, &Viewport::previewChanged, this, &LensTool::follow);
    connect(&viewport, &Viewport::backgroundChanged, this, &LensTool::follow);
    connect(&viewport, &Viewport::resized, this, &LensTool::follow);
    connect(&session, &Session::modelChanged, this, &LensTool::follow);
    session.whenChanged(ViewPart::Lens | ViewPart::Scene, this, &LensTool::follow);
    // Queued: the viewport gets the scene first.
    connect(&workbench.scenes().sceneBuilder(), &SceneBuilder::sceneReady, this, &LensTool::follow,
            Qt::QueuedConnection);
    connect(&viewport, &Viewport::framePainted, this, [this] {
        if (isOn() && !settled_)
            update(); // the enlarged picture is another one
    });
    connect(&builder_, &SceneBuilder::sceneReady, this, [this](const BuiltScene& built) {
        if (isOn() && workbench_.scenes().renderer() != nullptr && built.mesh.query == request().query)
            draw(built.scene, built.mesh.tetrahedra, true);
    });
    connect(&builder_, &SceneBuilder::failed, this,
            [this](const Error& error) { emit failed(translatedMessage(error.message)); });
    follow();
}

LensTool::~LensTool() = default;

const LensState& LensTool::lens() const
{
    return workbench_.session().view().lens;
}

bool LensTool::isOn() const
{
    return lens().isOn() && workbench_.session().model() != nullptr;
}

QSize LensTool::pixels() const
{
    return viewport_.size() * viewport_.devicePixelRatioF();
}

LensPicture LensTool::place() const
{
    return lensPicture(lens(), std::max(1, pixels().width()), std::max(1, pixels().height()));
}

bool LensTool::holds(QPointF pixel) const
{
    const QPointF inPixels = pixel * viewport_.devicePixelRatioF();
    return isOn() && tetra::holds(lens(), place(), {inPixels.x(), inPixels.y()});
}

/// The scene of its own mesh.
SceneRequest LensTool::request() const
{
    return lensScene({lens(), workbench_.scenes().sceneRequest()}, place(), viewport_.shownCamera());
}

/// Something has changed: what is there is drawn at once, and the finer mesh when all is at rest.
void LensTool::follow()
{
    setVisible(isOn());
    if (!std::exchange(wasOn_, isOn()) && !isOn())
        return;
    settled_ = false;
    ++newest_;
    if (!isOn()) {
        resting_.stop();
        job_.cancel();
        builder_.clear();
        drawn_.reset();
        grabbed_.reset();
        return;
    }
    setAccessibleDescription(tr("Enlarged %1 times").arg(QLocale().toString(lens().magnification, 'g', 3)));
    draw(viewport_.scene(), 0, false);
    resting_.start();
    update();
}

void LensTool::rest()
{
    if (!isOn() || !viewport_.scene() || workbench_.scenes().renderer() == nullptr)
        return;
    const SceneRequest wanted = request();
    if (wanted.query == workbench_.scenes().sceneRequest().query && !workbench_.scenes().sceneBuilder().busy())
        return draw(viewport_.scene(), 0, true);
    builder_.request(wanted);
}

void LensTool::draw(std::shared_ptr<const Scene> scene, std::size_t tetrahedra, bool fine)
{
    if (!scene || pixels().isEmpty())
        return;
    Order order;
    order.scene = std::move(scene);
    order.camera = viewport_.shownCamera();
    order.lens = {.shape = lens().shape, .place = place(), .tetrahedra = tetrahedra};
    order.options.width = order.lens.place.width;
    order.options.height = order.lens.place.height;
    order.options.part = order.lens.place.part;
    order.options.background = viewport_.background();
    order.options.samplesPerAxis = fine ? restingSamples : 1;
    order.lineScale = viewport_.devicePixelRatioF();
    order.fine = fine;
    order.number = newest_;
    job_.submit(
        [this, order, backend = backend_](const std::stop_token& stop) {
            Scene drawn = *order.scene;
            scaleLines(drawn, order.lineScale);
            const auto picture = backend->get().render(drawn, order.camera, order.options, Progress(stop, {}));
            const bool failed = !picture && picture.error().kind != ErrorKind::Cancelled;
            QMetaObject::invokeMethod(
                this,
                [this, order, drawn = picture ? *picture : Picture(),
                 error = failed ? translatedMessage(picture.error().message) : QString()] {
                    arrived(order, drawn, error);
                },
                Qt::QueuedConnection);
        },
        fine ? std::chrono::milliseconds(0) : movingLensPatience);
}

/// Of an older place it is no news: the enlarged picture is.
void LensTool::arrived(const Order& order, const Picture& picture, const QString& error)
{
    if (order.number != newest_ || !isOn())
        return;
    settled_ = order.fine;
    if (!error.isEmpty())
        emit failed(error);
    if (picture.pixels.empty())
        return;
    drawn_ = order.lens;
    drawn_->content = picture;
    drawnCamera_ = order.camera;
    update();
}

bool LensTool::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    case QEvent::MouseButtonPress: return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease: return release();
    case QEvent::Wheel: return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::KeyPress: return keyPress(*static_cast<QKeyEvent*>(event));
    case QEvent::FocusOut: endDrag(); break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

bool LensTool::press(const QMouseEvent& event)
{
    if (grabbed_)
        return true; // another button changes nothing
    if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier || !holds(event.position()))
        return false;
    atPress_ = lens();
    grabbed_ = event.position() - QPointF(lens().x * viewport_.width(), lens().y * viewport_.height());
    workbench_.session().beginGesture();
    viewport_.setCursor(Qt::ClosedHandCursor);
    return true;
}

bool LensTool::move(const QMouseEvent& event)
{
    if (!grabbed_)
        return false;
    LensState moved = lens();
    const QPointF middle = event.position() - *grabbed_;
    moved.x = middle.x() / viewport_.width();
    moved.y = middle.y() / viewport_.height();
    workbench_.session().setLens(moved);
    return true;
}

bool LensTool::release()
{
    const bool wasGrabbed = grabbed_.has_value();
    endDrag();
    return wasGrabbed;
}

void LensTool::endDrag()
{
    if (!grabbed_)
        return;
    grabbed_.reset();
    workbench_.session().endGesture();
    viewport_.unsetCursor();
}

/// As one of a series.
void LensTool::change(LensState lens)
{
    if (series_ == 0)
        series_ = workbench_.session().newGesture();
    pausing_.start();
    workbench_.session().setLens(lens, series_);
}

bool LensTool::wheel(const QWheelEvent& event)
{
    if (grabbed_)
        return true;
    if (!holds(event.position()))
        return false;
    LensState turned = lens();
    turned.magnification *= std::pow(perTurn, event.angleDelta().y() / anglePerTurn);
    change(turned);
    return true;
}

bool LensTool::keyPress(const QKeyEvent& event)
{
    if (!isOn())
        return false;
    LensState changed = lens();
    if (event.key() == Qt::Key_Escape) {
        if (grabbed_) {
            workbench_.session().setLens(atPress_);
            endDrag();
        } else {
            changed.shape = LensState::Shape::None;
            workbench_.session().setLens(changed);
        }
        return true;
    }
    if ((event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) != Qt::AltModifier)
        return false;
    switch (event.key()) {
    case Qt::Key_Left: changed.x -= lensStep; break;
    case Qt::Key_Right: changed.x += lensStep; break;
    case Qt::Key_Up: changed.y -= lensStep; break;
    case Qt::Key_Down: changed.y += lensStep; break;
    case Qt::Key_Plus:
    case Qt::Key_Equal: changed.magnification *= perTurn; break;
    case Qt::Key_Minus:
    case Qt::Key_Underscore: changed.magnification /= perTurn; break;
    default: return false;
    }
    change(changed);
    return true;
}

/// What is on the screen there, enlarged: until it is drawn for the lens.
Picture LensTool::enlargedPicture() const
{
    const QImage picture = viewport_.picture();
    const LensPicture lens = place();
    if (picture.isNull())
        return {};
    const double scaleX = static_cast<double>(picture.width()) / lens.width;
    const double scaleY = static_cast<double>(picture.height()) / lens.height;
    const QRectF part(lens.part.left * scaleX, lens.part.top * scaleY, lens.part.width * scaleX,
                      lens.part.height * scaleY);
    QImage enlarged(lens.part.width, lens.part.height, QImage::Format_RGBA8888);
    QPainter painter(&enlarged);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(enlarged.rect()), picture, part);
    painter.end();
    const PixelView seen = pixelsOf(enlarged);
    return {.width = seen.width, .height = seen.height, .pixels = {seen.pixels.begin(), seen.pixels.end()}};
}

void LensTool::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    if (!isOn())
        return;
    DrawnLens seen{.shape = lens().shape, .place = place()};
    const bool isDrawn = drawn_ && drawn_->place == seen.place && drawnCamera_ == viewport_.shownCamera();
    seen.content = isDrawn ? drawn_->content : enlargedPicture();
    const double pixelsPerUnit = viewport_.devicePixelRatioF();
    const int around = static_cast<int>(std::ceil(2 * pixelsPerUnit)); // of its rim
    PixelRectangle& square = seen.place.square;
    const QPointF corner(square.left - around, square.top - around);
    QImage image(square.width + 2 * around, square.height + 2 * around, QImage::Format_RGBA8888);
    image.fill(Qt::transparent);
    square.left = square.top = around;
    if (!paintLens(pixelsOf(image), seen, viewport_.background(), pixelsPerUnit,
                   {numberSigns(QLocale()), workbench_.scenes().fonts()}))
        return; // a desktop without fonts
    image.setDevicePixelRatio(pixelsPerUnit);
    QPainter(this).drawImage(corner / pixelsPerUnit, image);
}

} // namespace tetra
