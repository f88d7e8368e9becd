// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/tools/plane/plane_tool.h"

#include "plugins/api/scene_parameters.h"
#include "plugins/api/slice_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace tetra {
namespace {

constexpr double arrowPart = 0.2;      ///< of the diagonal of the domain
constexpr std::size_t mostPlanes = 16; ///< that OpenGL takes
constexpr const char* centreHandle = "centre";
constexpr const char* tipHandle = "tip";
constexpr const char* chosenClips = "clip!"; ///< where there are slices, too
constexpr const char* kindId = "kind";
constexpr const char* numberId = "number";
constexpr const char* normalId = "normal";
constexpr const char* offsetId = "offset";
constexpr MarkedText clipKind = Message::marked("Clip plane");
constexpr MarkedText sliceKind = Message::marked("Slice");

/// A plane of the settings, and how it is written there.
struct WrittenPlane {
    CutPlane plane;
    std::string text;
};

CutPlane ofUnitLength(const Eigen::Vector3d& normal, double offset)
{
    const double length = normal.stableNorm();
    return {normal / length, offset / length};
}

/// "z=12.5" where a slice lies across an axis; else four numbers.
std::string textOf(const CutPlane& plane, bool isSlice)
{
    for (Eigen::Index axis = 0; isSlice && axis < 3; ++axis)
        if (plane.normal == Eigen::Vector3d::Unit(axis))
            return std::string(1, "xyz"[axis]) + "=" + formatNumber(plane.offset);
    const Eigen::Vector3d normal = plane.normal + Eigen::Vector3d::Zero(); // no zero is below zero
    return clipPlanesText(std::array{ClipPlane{normal, plane.offset + 0.0}});
}

/// No finer than anybody can drag: a decimal number of a hundred-thousandth of the box.
double readableOffset(double offset, const Eigen::AlignedBox3d& box)
{
    constexpr int digits = 5;
    const double inverse = std::pow(10, digits - std::floor(std::log10(box.diagonal().norm())));
    const double rounded =
        inverse >= 1 ? std::round(offset * inverse) / inverse : std::round(offset * inverse) * std::round(1 / inverse);
    return std::isfinite(rounded) ? rounded : offset;
}

/// Which planes there are, and which one is held: the tool's reading of the settings.
class HeldPlanes {
public:
    explicit HeldPlanes(const ToolSurroundings& surroundings) : surroundings_(surroundings)
    {
        const std::string_view kept = surroundings.value;
        hasClips_ = has(clipId);
        hasSlices_ = has(slicesId);
        isSlice_ = hasSlices_ && (!hasClips_ || !kept.starts_with(chosenClips));
        const std::string text =
            parameterValue<std::string>(surroundings.parameters, surroundings.view.appearance.settings, id());
        if (isSlice_)
            readSlices(text);
        else
            readClips(text);
        const auto number = parseNumber<std::size_t>(kept.substr(std::min(kept.find(' '), kept.size() - 1) + 1));
        number_ = std::min(number.value_or(planes_.size()), planes_.empty() ? 0 : planes_.size() - 1);
    }

    bool canBeAny() const { return hasClips_ || hasSlices_; }
    bool hasClips() const { return hasClips_; }
    bool hasSlices() const { return hasSlices_; }
    bool isSlice() const { return isSlice_; }
    const char* id() const { return isSlice_ ? slicesId : clipId; }
    std::size_t count() const { return planes_.size(); }
    std::size_t number() const { return number_; }
    bool holdsOne() const { return !planes_.empty(); }
    const CutPlane& held() const { return planes_[number_].plane; }
    const Eigen::AlignedBox3d& box() const { return surroundings_.model.bounds; }
    Eigen::Vector3d centre() const { return centreOf(held(), box()); }
    double arrow() const { return arrowPart * box().diagonal().norm(); }
    Eigen::Vector3d tip() const { return centre() + arrow() * held().normal; }

    /// The value that holds another plane.
    std::string holding(bool slice, std::size_t number) const
    {
        const char* kind = slice ? slicesId : hasSlices_ ? chosenClips : clipId;
        return std::string(kind) + " " + std::to_string(number);
    }
    /// With the held plane moved: brought back to the data where it would miss them.
    ToolAnswer with(CutPlane plane, const Message& name) const
    {
        const ValueRange met = offsetsIn(box(), plane.normal);
        plane.offset = std::clamp(plane.offset, met.minimum, met.maximum);
        auto planes = planes_;
        if (planes.empty())
            planes.emplace_back();
        planes[number_] = {plane, textOf(plane, isSlice_)};
        return answer(planes, number_, name);
    }
    ToolAnswer withAnother(const CutPlane& plane, const Message& name) const
    {
        auto planes = planes_;
        const CutPlane added{plane.normal, readableOffset(plane.offset, box())};
        planes.push_back({added, textOf(added, isSlice_)});
        return answer(planes, planes.size() - 1, name);
    }
    ToolAnswer without(const Message& name) const
    {
        auto planes = planes_;
        planes.erase(planes.begin() + static_cast<std::ptrdiff_t>(number_));
        return answer(planes, number_ > 0 ? number_ - 1 : 0, name);
    }

private:
    bool has(const char* id) const
    {
        return std::ranges::find(surroundings_.parameters, id, &Parameter::id) != surroundings_.parameters.end();
    }
    void readClips(const std::string& text)
    {
        if (const auto planes = parseClipPlanes(text))
            for (const ClipPlane& plane : *planes)
                planes_.push_back({ofUnitLength(plane.normal, plane.offset), clipPlanesText(std::array{plane})});
    }
    void readSlices(const std::string& text)
    {
        if (const auto slices = parseSlices(text))
            for (const SlicePlane& slice : *slices)
                planes_.push_back({ofUnitLength(slice.plane.normal, slice.plane.offset), slice.text});
    }
    ToolAnswer answer(const std::vector<WrittenPlane>& planes, std::size_t number, const Message& name) const
    {
        std::string text;
        for (const WrittenPlane& plane : planes)
            text += (text.empty() ? "" : ";") + plane.text;
        ToolAnswer answer{.value = holding(isSlice_, number), .view = surroundings_.view, .name = name};
        answer.view->appearance.settings[id()] = text;
        return answer;
    }

    const ToolSurroundings& surroundings_;
    bool hasClips_ = false, hasSlices_ = false, isSlice_ = false;
    std::vector<WrittenPlane> planes_;
    std::size_t number_ = 0;
};

/// Away from the viewer, so that what lies before the place is cut away.
CutPlane facing(const Eigen::Vector3d& place, const Eigen::Vector3d& direction)
{
    const Eigen::Vector3d normal = nearestAxis(direction);
    return {normal, normal.dot(place)};
}

ToolAnswer moveCentre(const HeldPlanes& planes, const HandleMove& move)
{
    CutPlane plane = planes.held();
    plane.offset +=
        move.byKeys ? plane.normal.dot(move.to - move.from) : alongNormal(move.from, plane.normal, move.pointer);
    plane.offset = readableOffset(plane.offset, planes.box());
    return planes.with(plane, Message::marked("Move Plane"));
}

/// The plane turns about its centre.
ToolAnswer moveTip(const HeldPlanes& planes, const HandleMove& move)
{
    const Eigen::Vector3d centre = planes.centre();
    const bool isBefore = (move.from - centre).dot(move.pointer.direction) <= 0;
    const Eigen::Vector3d tip = move.byKeys ? move.to : onSphere(centre, planes.arrow(), move.pointer, isBefore);
    Eigen::Vector3d normal = tip - centre;
    if (normal.isZero())
        return {};
    normal = move.pointer.shift ? nearestAxis(normal) : Eigen::Vector3d(normal.normalized());
    return planes.with({normal, normal.dot(centre)}, Message::marked("Turn Plane"));
}

Message noPlanes()
{
    return Message::say("This rendering mode has neither clip planes nor slices.");
}

} // namespace

std::vector<Eigen::Vector3d> cutOfBox(const CutPlane& plane, const Eigen::AlignedBox3d& box)
{
    std::vector<Eigen::Vector3d> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (int edge = 0; edge < 4; ++edge) {
            Eigen::Vector3d from = box.min();
            from[(axis + 1) % 3] = edge % 2 == 0 ? box.min()[(axis + 1) % 3] : box.max()[(axis + 1) % 3];
            from[(axis + 2) % 3] = edge < 2 ? box.min()[(axis + 2) % 3] : box.max()[(axis + 2) % 3];
            const double slope = plane.normal[axis];
            const double along = slope != 0 ? (plane.offset - plane.normal.dot(from)) / slope : -1;
            if (along < 0 || along > box.sizes()[axis])
                continue;
            from[axis] += along;
            const double near = 1e-9 * box.diagonal().norm();
            if (std::ranges::none_of(corners, [&](const auto& corner) { return (corner - from).norm() <= near; }))
                corners.push_back(from);
        }
    if (corners.size() < 3)
        return {};
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners)
        middle += corner / static_cast<double>(corners.size());
    const Eigen::Vector3d across = plane.normal.unitOrthogonal(), other = plane.normal.cross(across);
    std::ranges::sort(corners, {}, [&](const Eigen::Vector3d& corner) {
        return std::atan2(other.dot(corner - middle), across.dot(corner - middle));
    });
    return corners;
}

Eigen::Vector3d centreOf(const CutPlane& plane, const Eigen::AlignedBox3d& box)
{
    const Eigen::Vector3d middle = box.center();
    return middle + plane.normal * (plane.offset - plane.normal.dot(middle));
}

Eigen::Vector3d nearestAxis(const Eigen::Vector3d& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    Eigen::Vector3d nearest = Eigen::Vector3d::Zero();
    nearest[axis] = direction[axis] < 0 ? -1 : 1;
    return nearest;
}

double alongNormal(const Eigen::Vector3d& from, const Eigen::Vector3d& normal, const ToolPointer& pointer)
{
    constexpr double leastSeen = 1e-3; ///< of a unit along the normal, squared
    const Eigen::Vector3d between = from - pointer.origin;
    const double cosine = normal.dot(pointer.direction);
    const double seen = 1 - cosine * cosine;
    if (seen < leastSeen)
        return 0;
    return (cosine * pointer.direction.dot(between) - normal.dot(between)) / seen;
}

Eigen::Vector3d onSphere(const Eigen::Vector3d& centre, double radius, const ToolPointer& pointer, bool before)
{
    const Eigen::Vector3d toCentre = centre - pointer.origin;
    const double middle = pointer.direction.dot(toCentre);
    const Eigen::Vector3d nearest = pointer.origin + middle * pointer.direction;
    const double distance = (nearest - centre).norm();
    if (distance >= radius)
        return centre + radius / distance * (nearest - centre);
    const double half = std::sqrt(radius * radius - distance * distance);
    return nearest + (before ? -half : half) * pointer.direction;
}

ToolLook PlaneTool::look() const
{
    return {.shortcut = "S",
            .icon = {{{3, 15}, {10, 8}, {21, 12}, {14, 19}, {3, 15}}, {{12, 13}, {12, 3}}, {{9, 6}, {12, 3}, {15, 6}}}};
}

ToolDrawing PlaneTool::drawing(const ToolSurroundings& surroundings) const
{
    ToolDrawing drawing;
    const HeldPlanes planes(surroundings);
    if (!surroundings.chosen || !planes.holdsOne())
        return drawing;
    drawing.lines.push_back({.points = cutOfBox(planes.held(), planes.box()), .closed = true});
    drawing.lines.push_back({.points = {planes.centre(), planes.tip()}});
    drawing.handles.push_back(
        {.id = centreHandle, .place = planes.centre(), .name = Message::marked("Centre of the plane"), .square = true});
    drawing.handles.push_back(
        {.id = tipHandle, .place = planes.tip(), .name = Message::marked("Direction of the plane")});
    return drawing;
}

/// The first click makes a plane, others bring the held one to what is seen there.
ToolAnswer PlaneTool::clicked(const ToolSurroundings& surroundings, const ToolPointer& pointer) const
{
    const HeldPlanes planes(surroundings);
    if (!planes.canBeAny())
        return {};
    if (!planes.holdsOne())
        return planes.withAnother(facing(pointer.place, pointer.direction), Message::marked("Add Plane"));
    if (!pointer.seen)
        return {};
    CutPlane plane = planes.held();
    plane.offset = readableOffset(plane.normal.dot(pointer.seen->place), planes.box());
    return planes.with(plane, Message::marked("Move Plane"));
}

ToolAnswer PlaneTool::moved(const ToolSurroundings& surroundings, const HandleMove& move) const
{
    const HeldPlanes planes(surroundings);
    if (!planes.holdsOne())
        return {};
    return move.handle == centreHandle ? moveCentre(planes, move) : moveTip(planes, move);
}

std::vector<Parameter> PlaneTool::parameters(const ToolSurroundings& surroundings) const
{
    const HeldPlanes planes(surroundings);
    std::vector<Parameter> parameters;
    if (!planes.canBeAny())
        return parameters;
    Parameter kind, number, normal, offset;
    kind.id = kindId;
    kind.label = Message::marked("Kind");
    kind.explanation =
        Message::marked("What is moved: a plane that cuts the picture open, or one that shows the data.");
    if (planes.hasClips())
        kind.choices.emplace_back(clipKind);
    if (planes.hasSlices())
        kind.choices.emplace_back(sliceKind);
    kind.defaultValue = std::string(planes.isSlice() ? sliceKind : clipKind);
    parameters.push_back(kind);
    if (!planes.holdsOne())
        return parameters;
    number.id = numberId;
    number.label = Message::marked("Plane");
    number.explanation = Message::marked("Which of the planes is moved.");
    for (std::size_t i = 1; i <= planes.count(); ++i)
        number.choices.push_back(std::to_string(i));
    number.defaultValue = std::to_string(planes.number() + 1);
    normal.id = normalId;
    normal.label = Message::marked("Direction");
    normal.explanation = Message::marked("Across the plane, along x, y and z; of a clip plane towards what is shown.");
    normal.defaultValue = planes.held().normal;
    offset.id = offsetId;
    offset.label = Message::marked("Place along it");
    offset.explanation =
        Message::marked("How far the plane lies from the origin in its direction, in the data's unit of "
                        "length.");
    offset.unit = surroundings.model.lengthUnit;
    offset.defaultValue = planes.held().offset;
    parameters.insert(parameters.end(), {number, normal, offset});
    return parameters;
}

ToolAnswer PlaneTool::parameterSet(const ToolSurroundings& surroundings, const std::string& id,
                                   const ParameterValue& value) const
{
    const HeldPlanes planes(surroundings);
    const auto* text = std::get_if<std::string>(&value);
    if (id == kindId && text != nullptr)
        return {.value = planes.holding(*text == std::string_view(sliceKind), 0),
                .name = Message::marked("Choose Plane")};
    if (!planes.holdsOne())
        return {};
    if (id == numberId && text != nullptr)
        return {.value = planes.holding(planes.isSlice(), parseNumber<std::size_t>(*text).value_or(1) - 1),
                .name = Message::marked("Choose Plane")};
    CutPlane plane = planes.held();
    if (const auto* normal = std::get_if<Eigen::Vector3d>(&value); normal != nullptr && id == normalId) {
        if (!(normal->stableNorm() > 0))
            return {};
        plane = {normal->stableNormalized(), 0};
        plane.offset = plane.normal.dot(planes.centre());
        return planes.with(plane, Message::marked("Turn Plane"));
    }
    if (const auto* offset = std::get_if<double>(&value); offset != nullptr && id == offsetId) {
        plane.offset = *offset;
        return planes.with(plane, Message::marked("Move Plane"));
    }
    return {};
}

std::vector<ToolReading> PlaneTool::readings(const ToolSurroundings& surroundings) const
{
    if (!HeldPlanes(surroundings).canBeAny())
        return {{Message::marked("Plane"), noPlanes()}};
    return {};
}

std::vector<ToolCommand> PlaneTool::commands(const ToolSurroundings& surroundings) const
{
    const HeldPlanes planes(surroundings);
    return {{.id = "add",
             .text = Message::marked("Add Plane"),
             .explanation = Message::marked("Cut through the middle of the data, across the axis that one looks along"),
             .key = "A",
             .enabled = planes.canBeAny() && planes.count() < mostPlanes},
            {.id = "flip",
             .text = Message::marked("Flip Plane"),
             .explanation = Message::marked("Show what was cut away, and cut away what was shown"),
             .key = "R",
             .enabled = planes.holdsOne()},
            {.id = "align",
             .text = Message::marked("Align with Axis"),
             .explanation = Message::marked("Turn the plane across the nearest axis; Shift does so while it is turned"),
             .key = "X",
             .enabled = planes.holdsOne()},
            {.id = "remove",
             .text = Message::marked("Remove Plane"),
             .explanation = Message::marked("Remove the plane that is moved"),
             .key = "Delete",
             .enabled = planes.holdsOne()}};
}

ToolAnswer PlaneTool::commanded(const ToolSurroundings& surroundings, const std::string& id) const
{
    const HeldPlanes planes(surroundings);
    if (id == "add" && planes.canBeAny()) {
        const Eigen::Vector3d away = surroundings.camera.target - eyePosition(surroundings.camera);
        return planes.withAnother(facing(planes.box().center(), away), Message::marked("Add Plane"));
    }
    if (!planes.holdsOne())
        return {};
    if (id == "flip")
        return planes.with({-planes.held().normal, -planes.held().offset}, Message::marked("Flip Plane"));
    if (id == "align") {
        const Eigen::Vector3d normal = nearestAxis(planes.held().normal);
        return planes.with({normal, normal.dot(planes.centre())}, Message::marked("Turn Plane"));
    }
    return planes.without(Message::marked("Remove Plane"));
}

} // namespace tetra
