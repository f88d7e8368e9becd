// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/region_tools.h"

#include "plugins/widgets/colour_button.h"
#include "ui/viewport/region_painter.h"
#include "ui/viewport/viewport.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <array>
#include <utility>

namespace tetra {
namespace {

constexpr double reach = 11; ///< of a handle, in pixels around it
constexpr float outlineWidth = 1.5F;
constexpr double stepPart = 0.01;                                  ///< of the diagonal, for an arrow key
constexpr double fineStep = 0.2;                                   ///< of that, with Ctrl
constexpr double leastRegionPart = 2e-3;                           ///< of the diagonal, for an edge or a radius
constexpr std::array kinds{RegionKind::Window, RegionKind::Focus}; ///< as they are painted

} // namespace

RegionTools::RegionTools(Session& session, Viewport& viewport)
    : QWidget(&viewport), session_(session), viewport_(viewport)
{
    setObjectName("viewport.tools");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_NoSystemBackground);
    setGeometry(viewport.rect());
    viewport.installEventFilter(this);
    connect(&viewport, &Viewport::cameraChanged, this, qOverload<>(&QWidget::update));
    connect(&viewport, &Viewport::backgroundChanged, this, [this] {
        showOutlines();
        update();
    });
    connect(&session, &Session::modelChanged, this, &RegionTools::followQuery);
    session.whenChanged(ViewPart::Query, this, &RegionTools::followQuery);
}

void RegionTools::select(RegionKind kind)
{
    selected_ = session_.model() && query().has(kind) ? kind : RegionKind::None;
    hovered_.reset();
    update();
}

QColor RegionTools::ground() const
{
    return qtColour(viewport_.background());
}

std::vector<RegionHandle> RegionTools::handles() const
{
    return handlesOf(selected_);
}

void RegionTools::place(const MovableRegion& place)
{
    session_.setQuery(query().moved(selected_, place));
}

/// Of a region that is not selected the centre alone.
std::vector<RegionHandle> RegionTools::handlesOf(RegionKind kind) const
{
    if (!query().has(kind))
        return {};
    auto handles = tetra::handlesOf(query().place(kind), viewport_.projection());
    if (kind != selected_)
        handles.resize(1);
    return handles;
}

std::optional<RegionTools::Grip> RegionTools::gripAt(QPointF pixel) const
{
    for (const RegionKind kind : {selected_, RegionKind::Focus, RegionKind::Window})
        if (const auto handle = handleAt(handlesOf(kind), viewport_.projection(), pixel, reach))
            return Grip{kind, *handle};
    return std::nullopt;
}

bool RegionTools::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonPress: return press(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove: return move(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease: return release(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonDblClick: return doubleClick(*static_cast<QMouseEvent*>(event));
    case QEvent::KeyPress: return keyPress(*static_cast<QKeyEvent*>(event));
    case QEvent::KeyRelease: return keyRelease(*static_cast<QKeyEvent*>(event));
    case QEvent::Wheel: return drag_.has_value();
    case QEvent::Leave: hover(std::nullopt); break;
    case QEvent::FocusOut: letGo(); break;
    case QEvent::Resize: setGeometry(viewport_.rect()); break;
    default: break;
    }
    return QWidget::eventFilter(watched, event);
}

bool RegionTools::press(const QMouseEvent& event)
{
    cancelled_ = false;
    if (drag_)
        return true; // another button changes nothing
    const auto grip = event.button() == Qt::LeftButton ? gripAt(event.position()) : std::nullopt;
    if (!grip)
        return false;
    select(grip->region);
    pointer_ = event.position();
    rule_ = {.restrained = false, .axis = std::nullopt, .least = leastRegionPart * session_.model()->diagonal()};
    drag_ = RegionDrag{query().place(selected_), grip->handle, viewport_.projection(), pointer_};
    session_.beginGesture();
    viewport_.setCursor(Qt::ClosedHandCursor);
    showOutlines();
    return true;
}

bool RegionTools::move(const QMouseEvent& event)
{
    if (!drag_) {
        if (event.buttons() == Qt::NoButton)
            hover(gripAt(event.position()));
        return cancelled_;
    }
    pointer_ = event.position();
    drag(event.modifiers());
    return true;
}

bool RegionTools::release(const QMouseEvent& event)
{
    if (event.button() == Qt::LeftButton && drag_) {
        endDrag();
        return true;
    }
    return drag_ || std::exchange(cancelled_, false);
}

/// A focus goes to the place on a surface that was clicked. A handle that is grabbed twice in quick succession is
/// grabbed.
bool RegionTools::doubleClick(const QMouseEvent& event)
{
    if (press(event))
        return true;
    if (!query().has(RegionKind::Focus) || !viewport_.scene() || event.button() != Qt::LeftButton)
        return false;
    const auto scene = viewport_.scene();
    place_.find(surfacesOf(*scene), viewport_.projection().pickingRay(viewport_.beneathLens(event.position())),
                [this, scene](const std::optional<SeenPlace>& seen) {
                    if (seen && scene == viewport_.scene() && !drag_)
                        bringFocusTo(seen->place);
                });
    return true;
}

void RegionTools::bringFocusTo(const Eigen::Vector3d& place)
{
    if (!query().has(RegionKind::Focus))
        return;
    FocusState focus = query().focus;
    focus.centre = place;
    session_.setFocus(focus);
    select(RegionKind::Focus);
    emit focusPlaced();
}

void RegionTools::drag(Qt::KeyboardModifiers modifiers)
{
    rule_.restrained = modifiers.testFlag(Qt::ShiftModifier);
    place(drag_->at(pointer_, rule_));
    update();
}

void RegionTools::endDrag()
{
    drag_.reset();
    session_.endGesture();
    viewport_.unsetCursor();
    hover(gripAt(pointer_));
    showOutlines();
}

void RegionTools::letGo()
{
    if (drag_)
        endDrag();
    session_.endGesture();
}

void RegionTools::cancelDrag()
{
    place(drag_->start);
    endDrag();
    cancelled_ = true;
}

bool RegionTools::keyPress(const QKeyEvent& event)
{
    if (drag_)
        return keyWhileDragging(event);
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        return selectNext();
    if (selected_ == RegionKind::None)
        return false;
    switch (event.key()) {
    case Qt::Key_Escape: select(RegionKind::None); return true;
    case Qt::Key_Delete: session_.setQuery(query().without(selected_)); return true;
    default: return moveByKey(event);
    }
}

/// Focus, window, neither; false if there is none.
bool RegionTools::selectNext()
{
    const bool focusIsNext = selected_ == RegionKind::None && query().has(RegionKind::Focus);
    const bool windowIsNext = selected_ != RegionKind::Window && query().has(RegionKind::Window);
    const RegionKind before = selected_;
    select(focusIsNext ? RegionKind::Focus : windowIsNext ? RegionKind::Window : RegionKind::None);
    return selected_ != before;
}

bool RegionTools::keyWhileDragging(const QKeyEvent& event)
{
    const auto restrain = [this](int axis) { rule_.axis = rule_.axis == axis ? std::nullopt : std::optional(axis); };
    Qt::KeyboardModifiers modifiers = event.modifiers();
    switch (event.key()) {
    case Qt::Key_Escape: cancelDrag(); return true;
    case Qt::Key_X: restrain(0); break;
    case Qt::Key_Y: restrain(1); break;
    case Qt::Key_Z: restrain(2); break;
    case Qt::Key_Shift: modifiers |= Qt::ShiftModifier; break;
    default: break;
    }
    drag(modifiers);
    return true; // nothing else while something is held
}

bool RegionTools::moveByKey(const QKeyEvent& event)
{
    if (event.modifiers() & ~(Qt::ControlModifier | Qt::KeypadModifier))
        return false;
    const ViewProjection projection = viewport_.projection();
    Eigen::Vector3d direction = Eigen::Vector3d::Zero();
    switch (event.key()) {
    case Qt::Key_Left: direction = -projection.right(); break;
    case Qt::Key_Right: direction = projection.right(); break;
    case Qt::Key_Up: direction = projection.up(); break;
    case Qt::Key_Down: direction = -projection.up(); break;
    case Qt::Key_PageUp: direction = -projection.towardsViewer(); break;
    case Qt::Key_PageDown: direction = projection.towardsViewer(); break;
    default: return false;
    }
    const double part = event.modifiers().testFlag(Qt::ControlModifier) ? stepPart * fineStep : stepPart;
    if (!event.isAutoRepeat())
        session_.beginGesture();
    place(moved(query().place(selected_), direction * part * session_.model()->diagonal()));
    return true;
}

bool RegionTools::keyRelease(const QKeyEvent& event)
{
    if (drag_ && event.key() == Qt::Key_Shift)
        drag(event.modifiers() & ~Qt::ShiftModifier);
    else if (!drag_ && !event.isAutoRepeat())
        session_.endGesture();
    return drag_.has_value();
}

void RegionTools::hover(const std::optional<Grip>& grip)
{
    if (grip && !hovered_)
        viewport_.setCursor(Qt::OpenHandCursor);
    else if (!grip && hovered_)
        viewport_.unsetCursor();
    hovered_ = grip;
    update();
}

/// What was just switched on is what one wants to move.
void RegionTools::followQuery()
{
    const bool focus = query().has(RegionKind::Focus);
    const bool window = query().has(RegionKind::Window);
    if (window && !windowWasOn_)
        select(RegionKind::Window);
    if (focus && !focusWasOn_)
        select(RegionKind::Focus);
    focusWasOn_ = focus;
    windowWasOn_ = window;
    if (!query().has(selected_)) {
        if (drag_)
            endDrag();
        select(RegionKind::None);
    }
    showOutlines();
    update();
}

/// In the picture, where surfaces hide them; but not what is being dragged: a new picture takes longer than the pointer
/// to move on.
void RegionTools::showOutlines()
{
    std::vector<Outlined> outlined;
    for (const RegionKind kind : kinds)
        if (query().has(kind) && !(drag_ && kind == selected_))
            outlined.push_back({query().place(kind), regionColour(kind, ground())});
    if (query().has(RegionKind::Focus))
        for (const MovableRegion& other : query().focus.others)
            outlined.push_back({other, regionColour(RegionKind::Focus, ground())});
    if (outlined == outlined_)
        return;
    outlined_ = std::move(outlined);
    std::vector<LineSet> outlines;
    for (const auto& [place, colour] : outlined_)
        outlines.push_back(outlineOf(place, colourOf(colour), outlineWidth));
    viewport_.setOutlines(std::move(outlines));
}

void RegionTools::paintEvent(QPaintEvent* event)
{
    Q_UNUSED(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const ViewProjection projection = viewport_.projection();
    for (const RegionKind kind : kinds) {
        if (!query().has(kind))
            continue;
        RegionLook look{regionColour(kind, ground()), ground(), kind == selected_, drag_ && kind == selected_, {}};
        if (drag_ && look.selected)
            look.hovered = drag_->handle;
        else if (hovered_ && hovered_->region == kind)
            look.hovered = hovered_->handle;
        paintRegion(painter, projection, query().place(kind), handlesOf(kind), look);
    }
    if (drag_ && rule_.axis && drag_->handle.kind == RegionHandle::Kind::Centre)
        paintAxis(painter, projection, centreOf(drag_->start), *rule_.axis, session_.model()->diagonal() / 2,
                  regionColour(selected_, ground()));
}

} // namespace tetra
