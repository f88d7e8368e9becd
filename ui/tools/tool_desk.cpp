// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_desk.h"

#include "core/picture/kept_tools.h"
#include "ui/session/annotation_language.h"
#include "ui/session/message_text.h"

#include <QCursor>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

constexpr double handleReach = 11;   ///< pixels around a handle
constexpr double clickMoves = 3;     ///< pixels that a hand may move while it clicks
constexpr double keyStepPart = 0.01; ///< of the diagonal, for an arrow key
constexpr double fineKeyStep = 0.2;  ///< of that, with Ctrl

/// As ToolKey and ToolCommand have it.
std::string nameOfKey(const QKeyEvent& event)
{
    switch (event.key()) {
    case Qt::Key_Escape: return "Escape";
    case Qt::Key_Delete: return "Delete";
    case Qt::Key_Backspace: return "Backspace";
    default: return event.text().toUpper().toStdString();
    }
}

std::optional<SeenThere> seenThere(const std::optional<SeenPlace>& seen)
{
    return seen ? std::optional(SeenThere{seen->place, seen->drawable, seen->value}) : std::nullopt;
}

} // namespace

ToolDesk::ToolDesk(Workbench& workbench, Viewport& viewport, QObject* parent)
    : QObject(parent), workbench_(workbench), session_(workbench.session()), viewport_(viewport),
      tools_(workbench.host().tools())
{
    setObjectName("viewport.toolDesk");
    connect(&session_, &Session::modelChanged, this, &ToolDesk::followModel);
    connect(&session_, &Session::modelGrown, this, &ToolDesk::follow);
    connect(&session_, &Session::viewChanged, this, &ToolDesk::follow);
    connect(&viewport, &Viewport::cameraChanged, this, &ToolDesk::changed);
}

const Tool* ToolDesk::tool() const
{
    const auto found = std::ranges::find(tools_, chosen_, &Provided<Tool>::id);
    return found != tools_.end() ? found->plugin : nullptr;
}

void ToolDesk::choose(const std::string& id)
{
    const bool isThere = std::ranges::find(tools_, id, &Provided<Tool>::id) != tools_.end();
    const std::string next = isThere && session_.model() ? id : std::string();
    if (next == chosen_)
        return;
    letGo();
    leave();
    forgetPlaces();
    chosen_ = next;
    select({});
    emit chosenChanged();
    emit changed();
}

void ToolDesk::select(const std::string& handle)
{
    selected_ = handle;
    const auto there = handle.empty() ? std::nullopt : handleOf(handle);
    viewport_.setAccessibleDescription(there ? translatedMessage(there->name) : QString());
}

/// Drops the places that are still to be looked at.
void ToolDesk::forgetPlaces()
{
    wanted_.clear();
    seen_.forget();
    seeking_ = false;
}

/// What was selected may be gone.
void ToolDesk::follow()
{
    ofMode_.reset();
    if (!session_.model())
        choose({});
    else if (!selected_.empty() && !drag_ && !handleOf(selected_))
        select({});
    emit changed();
}

/// Another model has places of its own: what is held of the one before is let go, and moves nothing any more.
void ToolDesk::followModel()
{
    letGo();
    forgetPlaces();
    pointer_.reset();
    follow();
}

const std::vector<Parameter>& ToolDesk::parametersOfMode() const
{
    if (!ofMode_)
        ofMode_ = workbench_.scenes().matteringParameters();
    return *ofMode_;
}

/// Of the chosen one.
ToolStage ToolDesk::stage() const
{
    return {chosen_, session_, parametersOfMode()};
}

ToolSurroundings ToolDesk::surroundings(const ToolStage& stage) const
{
    ToolSurroundings surroundings = stage.surroundings(viewport_.shownCamera(), viewport_.size());
    surroundings.chosen = true;
    surroundings.handle = selected_;
    surroundings.pointer = pointer_;
    return surroundings;
}

std::vector<Parameter> ToolDesk::parameters() const
{
    if (!isAtWork())
        return {};
    const ToolStage now = stage();
    return tool()->parameters(surroundings(now));
}

std::vector<ToolReading> ToolDesk::readings() const
{
    if (!isAtWork())
        return {};
    const ToolStage now = stage();
    return tool()->readings(surroundings(now));
}

std::vector<ToolCommand> ToolDesk::commands() const
{
    if (!isAtWork())
        return {};
    const ToolStage now = stage();
    return tool()->commands(surroundings(now));
}

void ToolDesk::setParameter(const std::string& id, const ParameterValue& value)
{
    if (!isAtWork())
        return;
    const ToolStage now = stage();
    take(now, tool()->parameterSet(surroundings(now), id, value));
}

void ToolDesk::command(const std::string& id)
{
    if (!isAtWork())
        return;
    const ToolStage now = stage();
    take(now, tool()->commanded(surroundings(now), id));
}

/// The chosen one over the others.
std::vector<ToolDrawing> ToolDesk::drawings() const
{
    if (!session_.model())
        return {};
    std::vector<Provided<Tool>> others = tools_;
    std::erase_if(others, [this](const Provided<Tool>& each) { return each.id == chosen_; });
    auto all = keptDrawings(others, session_.model()->description(), parametersOfMode(), session_.view(),
                            viewport_.shownCamera(), {double(viewport_.width()), double(viewport_.height())},
                            annotationLanguage());
    if (isAtWork())
        all.push_back(drawing());
    return all;
}

ToolDrawing ToolDesk::drawing() const
{
    const ToolStage now = stage();
    return tool()->drawing(surroundings(now));
}

std::optional<ToolHandle> ToolDesk::handleOf(const std::string& id) const
{
    if (!isAtWork())
        return std::nullopt;
    const std::vector<ToolHandle> all = drawing().handles;
    const auto found = std::ranges::find(all, id, &ToolHandle::id);
    return found != all.end() ? std::optional(*found) : std::nullopt;
}

/// The nearest within reach.
std::optional<ToolHandle> ToolDesk::handleAt(QPointF pixel) const
{
    std::optional<ToolHandle> nearest;
    if (!isAtWork() || viewport_.previewing())
        return nearest;
    const ViewProjection projection = viewport_.projection();
    double reach = handleReach;
    for (const ToolHandle& handle : drawing().handles)
        if (const auto place = projection.pixelOf(handle.place)) {
            const double distance = std::hypot(place->x() - pixel.x(), place->y() - pixel.y());
            if (!(distance <= reach)) // nor if it is not a number
                continue;
            reach = distance;
            nearest = handle;
        }
    return nearest;
}

void ToolDesk::take(const ToolStage& stage, const ToolAnswer& answer)
{
    if (auto view = stage.after(answer, session_.view()))
        session_.setView(*std::move(view), translatedMessage(answer.name));
    if (answer.handle)
        select(*answer.handle);
    emit changed();
}

ToolPointer ToolDesk::pointerAt(QPointF pixel, Qt::KeyboardModifiers modifiers) const
{
    ToolPointer pointer = tetra::pointerAt(viewport_.projection(), viewport_.shownCamera(), pixel);
    pointer.shift = modifiers.testFlag(Qt::ShiftModifier);
    pointer.control = modifiers.testFlag(Qt::ControlModifier);
    return pointer;
}

/// One after the other; of places that the pointer has only passed the last one.
void ToolDesk::seek(const Wanted& wanted)
{
    const auto isPassed = [](Wanted::Purpose purpose) {
        return purpose == Wanted::Purpose::Hover || purpose == Wanted::Purpose::Move;
    };
    if (!wanted_.empty() && isPassed(wanted_.back().purpose))
        wanted_.pop_back();
    wanted_.push_back(wanted);
    seekNext();
}

void ToolDesk::seekNext()
{
    if (seeking_ || wanted_.empty())
        return;
    const Wanted next = wanted_.front();
    wanted_.pop_front();
    const auto scene = viewport_.scene();
    if (!scene || viewport_.previewing())
        return found(next, std::nullopt);
    seeking_ = true;
    seen_.find(scene, viewport_.projection().pickingRay(viewport_.beneathLens(next.pixel)),
               [this, next](const std::optional<SeenPlace>& seen) {
                   seeking_ = false;
                   found(next, seen);
               });
}

void ToolDesk::found(const Wanted& wanted, const std::optional<SeenPlace>& seen)
{
    ToolPointer pointer = pointerAt(wanted.pixel, wanted.modifiers);
    if (const auto there = seenThere(seen))
        pointer = withSeen(pointer, *there);
    switch (wanted.purpose) {
    case Wanted::Purpose::Hover:
        if (isAtWork() && tool()->needs().pointer && !drag_) {
            pointer_ = pointer;
            emit changed();
        }
        break;
    case Wanted::Purpose::Move:
    case Wanted::Purpose::LastMove:
        moveHandle(pointer, wanted.pixel);
        if (wanted.purpose == Wanted::Purpose::LastMove)
            endDrag();
        break;
    case Wanted::Purpose::Click:
        if (isAtWork()) {
            const ToolStage now = stage();
            take(now, tool()->clicked(surroundings(now), pointer));
        }
        break;
    }
    seekNext();
}

void ToolDesk::moveHandle(const ToolPointer& pointer, QPointF pixel)
{
    if (!drag_ || !isAtWork())
        return;
    HandleMove move{.handle = drag_->handle.id, .from = drag_->handle.place, .pointer = pointer};
    move.to = inPlaneThrough(move.from, viewport_.projection(), pixel);
    take(drag_->start, tool()->moved(surroundings(drag_->start), move));
}

bool ToolDesk::press(QPointF pixel, Qt::KeyboardModifiers modifiers)
{
    cancelled_ = false;
    if (drag_)
        return true; // another button changes nothing
    endSeries();
    const auto handle = handleAt(pixel);
    pressed_.reset();
    if (handle) {
        select(handle->id);
        const QPointF place = viewport_.projection().pixelOf(handle->place).value_or(pixel);
        drag_.emplace(Drag{stage(), *handle, pixel - place, pixel});
        session_.beginGesture();
        viewport_.setCursor(Qt::ClosedHandCursor);
        emit changed();
        return true;
    }
    if (isAtWork() && modifiers == Qt::NoModifier)
        pressed_ = pixel;
    return false;
}

bool ToolDesk::move(QPointF pixel, Qt::KeyboardModifiers modifiers, bool buttonDown)
{
    if (drag_) {
        const QPointF place = pixel - drag_->beside;
        drag_->moved = drag_->moved || (pixel - drag_->pressed).manhattanLength() > clickMoves;
        if (!drag_->moved)
            return true;
        if (drag_->handle.seeks)
            seek({Wanted::Purpose::Move, place, modifiers});
        else
            moveHandle(pointerAt(place, modifiers), place);
        return true;
    }
    if (pressed_ && (pixel - *pressed_).manhattanLength() > clickMoves)
        pressed_.reset();
    if (!isAtWork() || buttonDown)
        return cancelled_;
    const auto handle = handleAt(pixel);
    if (const std::string id = handle ? handle->id : std::string(); id != hovered_) {
        hovered_ = id;
        if (handle)
            viewport_.setCursor(Qt::OpenHandCursor);
        else
            viewport_.unsetCursor();
        emit changed();
    }
    if (tool()->needs().pointer)
        seek({Wanted::Purpose::Hover, pixel, modifiers});
    return false;
}

bool ToolDesk::release(QPointF pixel, Qt::KeyboardModifiers modifiers)
{
    if (drag_) {
        const bool moved = drag_->moved || (pixel - drag_->pressed).manhattanLength() > clickMoves;
        if (moved && drag_->handle.seeks)
            seek({Wanted::Purpose::LastMove, pixel - drag_->beside, modifiers});
        else
            endDrag();
        return true;
    }
    // What others have begun to drag is no click.
    if (std::exchange(pressed_, std::nullopt) && isAtWork() && !session_.inGesture())
        seek({Wanted::Purpose::Click, pixel, modifiers});
    return std::exchange(cancelled_, false);
}

void ToolDesk::leave()
{
    if (!hovered_.empty())
        viewport_.unsetCursor();
    hovered_.clear();
    pointer_.reset();
    emit changed();
}

void ToolDesk::endDrag()
{
    if (!drag_)
        return;
    drag_.reset();
    session_.endGesture();
    viewport_.unsetCursor();
    follow();
}

/// The button may still be down: until it is up, moves are nobody's.
void ToolDesk::letGo()
{
    cancelled_ = cancelled_ || drag_.has_value();
    endDrag();
    endSeries();
}

void ToolDesk::endSeries()
{
    if (std::exchange(series_, false))
        session_.endGesture();
}

/// As if nothing had been moved, but for where the camera has gone meanwhile.
void ToolDesk::cancelDrag()
{
    session_.setView(drag_->start.before(session_.view()));
    wanted_.clear();
    endDrag();
    cancelled_ = true;
}

bool ToolDesk::hasKey(const QKeyEvent& event) const
{
    if (!isAtWork() || event.modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier))
        return false;
    const std::string key = nameOfKey(event);
    return !key.empty() &&
           std::ranges::any_of(commands(), [&](const ToolCommand& command) { return command.key == key; });
}

bool ToolDesk::keyPress(const QKeyEvent& event)
{
    if (!isAtWork())
        return false;
    if (drag_) {
        if (event.key() == Qt::Key_Escape)
            cancelDrag();
        return true; // nothing else while something is held
    }
    switch (event.key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter: selectNext(); return true;
    case Qt::Key_Space: {
        const QPoint pointer = viewport_.mapFromGlobal(QCursor::pos());
        const bool isOver = viewport_.rect().contains(pointer) && viewport_.underMouse();
        seek({Wanted::Purpose::Click, isOver ? pointer : viewport_.rect().center(), Qt::NoModifier});
        return true;
    }
    default: return moveByKey(event) || ownKey(event);
    }
}

/// One after the other in their order, then none.
void ToolDesk::selectNext()
{
    const std::vector<ToolHandle> all = drawing().handles;
    const auto now = std::ranges::find(all, selected_, &ToolHandle::id);
    const auto next = selected_.empty() || now == all.end() ? all.begin() : now + 1;
    select(next == all.end() ? std::string() : next->id);
    emit changed();
}

bool ToolDesk::moveByKey(const QKeyEvent& event)
{
    const auto handle = handleOf(selected_);
    if (!handle || event.modifiers() & ~(Qt::ControlModifier | Qt::ShiftModifier | Qt::KeypadModifier))
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
    const double part = event.modifiers().testFlag(Qt::ControlModifier) ? keyStepPart * fineKeyStep : keyStepPart;
    HandleMove move{.handle = handle->id, .from = handle->place, .byKeys = true};
    move.to = move.from + direction * part * session_.model()->diagonal();
    const QPointF pixel = projection.pixelOf(move.to).value_or(QPointF(viewport_.rect().center()));
    move.pointer = pointerAt(pixel, event.modifiers() & ~Qt::ControlModifier);
    move.pointer.place = move.to;
    if (!series_)
        session_.beginGesture();
    series_ = true;
    const ToolStage now = stage();
    take(now, tool()->moved(surroundings(now), move));
    return true;
}

bool ToolDesk::ownKey(const QKeyEvent& event)
{
    const std::string key = nameOfKey(event);
    if (hasKey(event)) {
        endSeries();
        for (const ToolCommand& each : commands())
            if (each.key == key && each.enabled)
                command(each.id);
        return true;
    }
    if (key.empty())
        return false;
    if (key == "Escape" && !selected_.empty()) {
        select({});
        emit changed();
        return true;
    }
    const ToolStage now = stage();
    const ToolAnswer answer = tool()->pressed(surroundings(now), {key, event.modifiers().testFlag(Qt::ShiftModifier),
                                                                  event.modifiers().testFlag(Qt::ControlModifier)});
    if (answer.taken)
        take(now, answer);
    else if (key == "Escape")
        choose({});
    return answer.taken || key == "Escape";
}

bool ToolDesk::keyRelease(const QKeyEvent& event)
{
    if (!event.isAutoRepeat())
        endSeries();
    return drag_.has_value();
}

} // namespace tetra
