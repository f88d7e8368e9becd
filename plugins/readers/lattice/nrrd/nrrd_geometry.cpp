// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd/nrrd_geometry.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/nrrd/nrrd_axes.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

namespace tetra {

namespace {

using ThreeAxes = std::array<NrrdAxis, 3>;

/// The three axes that hold points.
Result<ThreeAxes> volumeAxes(const NrrdFields& fields)
{
    const auto axes = parseNrrdAxes(fields);
    const auto roles = axes ? nrrdRoles(*axes) : axes.error();
    if (!roles)
        return roles.error();
    const auto& [x, y, z] = roles->points;
    return ThreeAxes{(*axes)[x], (*axes)[y], (*axes)[z]};
}

std::optional<double> spacingOf(const NrrdAxis& axis)
{
    if (axis.spacing)
        return axis.spacing;
    if (axis.minimum && axis.maximum && axis.size > 1)
        return (*axis.maximum - *axis.minimum) / static_cast<double>(axis.centeredInCells ? axis.size : axis.size - 1);
    return {};
}

/// By spacings, axis mins and axis maxs; where they fall along an axis, it runs backwards.
Status placeAlongAxes(const ThreeAxes& axes, Lattice& lattice)
{
    const auto known = std::ranges::count_if(axes, [](const NrrdAxis& axis) { return spacingOf(axis).has_value(); });
    if (known != 0 && known != 3)
        return Error{ErrorKind::BadInput,
                     Message::say("its header gives the spacing of some axes only. Give all three, or none.")};
    Eigen::Vector3d spacing, origin;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        spacing[axis] = spacingOf(axes[i]).value_or(1);
        origin[axis] = axes[i].minimum.value_or(0);
        if (axes[i].minimum && axes[i].centeredInCells)
            origin[axis] += spacing[axis] / 2;
    }
    placeBySteps(lattice, spacing.asDiagonal(), origin);
    return {};
}

/// By space directions and space origin.
Status placeInSpace(const ThreeAxes& axes, const Eigen::Vector3d& spaceOrigin, Lattice& lattice)
{
    Eigen::Matrix3d steps;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (axes[axis].runsThroughTime)
            return Error{
                ErrorKind::BadInput,
                Message::say(
                    "one of its axes, of size %1, is time. A volume has three axes in space: take out one time step.",
                    axes[axis].size)};
        steps.col(static_cast<Eigen::Index>(axis)) = *axes[axis].direction;
    }
    placeBySteps(lattice, steps, spaceOrigin);
    return {};
}

/// Nothing if it is not given, or unknown.
Result<std::optional<Eigen::Vector3d>> parseSpaceOrigin(const NrrdFields& fields)
{
    if (!fields.has("space origin"))
        return std::optional<Eigen::Vector3d>();
    const auto origin = parseNrrdVector(fields["space origin"], nrrdSpaceHasTime(fields));
    if (!origin)
        return Error{ErrorKind::BadInput, Message::say("its space origin '%1' is not three numbers in parentheses.",
                                                       printable(fields["space origin"]))};
    return origin->place.allFinite() ? std::optional(origin->place) : std::nullopt;
}

Status place(const ThreeAxes& axes, const std::optional<Eigen::Vector3d>& spaceOrigin, Lattice& lattice)
{
    const auto directions =
        std::ranges::count_if(axes, [](const NrrdAxis& axis) { return axis.direction.has_value(); });
    if (directions == 3)
        return placeInSpace(axes, spaceOrigin.value_or(Eigen::Vector3d(0, 0, 0)), lattice);
    if (directions != 0)
        return Error{
            ErrorKind::BadInput,
            Message::say("its space directions are given for some axes only. Give them for all three, or for none.")};
    const Status placed = placeAlongAxes(axes, lattice);
    lattice.origin = spaceOrigin.value_or(lattice.origin);
    return placed;
}

constexpr std::string_view leftHandedSpaces[] = {"left-anterior-superior",      "las",  "3d-left-handed",
                                                 "left-anterior-superior-time", "last", "3d-left-handed-time"};

/// The texts of '"mm" "mm" "mm"'.
std::vector<std::string_view> quotedTexts(std::string_view text)
{
    std::vector<std::string_view> texts;
    for (auto begin = text.find('"'); begin != std::string_view::npos; begin = text.find('"')) {
        text.remove_prefix(begin + 1);
        const auto end = std::min(text.find('"'), text.size());
        texts.push_back(trimmed(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return texts;
}

/// Those of the space, else of the axes with points; none unless there are as many as there should be.
std::set<std::string_view> lengthUnits(const NrrdFields& fields)
{
    const bool isInSpace = fields.has("space directions");
    const auto units = quotedTexts(fields[isInSpace ? "space units" : "units"]);
    const auto axes = parseNrrdAxes(fields);
    const auto roles = axes ? nrrdRoles(*axes) : axes.error();
    std::set<std::string_view> found;
    if (roles && units.size() == (!isInSpace ? axes->size() : nrrdSpaceHasTime(fields) ? 4 : 3))
        for (std::size_t i = 0; i < 3; ++i)
            found.insert(units[isInSpace ? i : roles->points[i]]);
    return found;
}

} // namespace

bool tellsNrrdSpacing(const NrrdFields& fields)
{
    const auto axes = volumeAxes(fields);
    return axes && std::ranges::any_of(*axes, [](const NrrdAxis& axis) { return axis.direction || spacingOf(axis); });
}

bool tellsNrrdOrigin(const NrrdFields& fields)
{
    const auto axes = volumeAxes(fields);
    const auto origin = parseSpaceOrigin(fields);
    return (origin && *origin) ||
           (axes && std::ranges::any_of(*axes, [](const NrrdAxis& axis) { return axis.minimum.has_value(); }));
}

std::string nrrdSpace(const NrrdFields& fields)
{
    constexpr std::array<std::array<std::string_view, 2>, 3> spaces = {
        {{"right-anterior-superior", "ras"}, {"left-anterior-superior", "las"}, {"left-posterior-superior", "lps"}}};
    const std::string name = lowerCase(fields["space"]);
    if (!fields.has("space directions"))
        return {};
    for (const auto& [words, letters] : spaces)
        if (name == words || name == letters || name == std::string(words) + "-time" ||
            name == std::string(letters) + "t") {
            std::string capitals(letters);
            std::ranges::transform(capitals, capitals.begin(), [](char c) { return static_cast<char>(c - 'a' + 'A'); });
            return capitals;
        }
    return {};
}

Result<Lattice> nrrdLattice(const NrrdFields& fields)
{
    const Result<ThreeAxes> axes = volumeAxes(fields);
    if (!axes)
        return axes.error();
    if (const Status checked = checkLatticeSize({(*axes)[0].size, (*axes)[1].size, (*axes)[2].size}); !checked)
        return checked.error();
    const Result<std::optional<Eigen::Vector3d>> spaceOrigin = parseSpaceOrigin(fields);
    if (!spaceOrigin)
        return spaceOrigin.error();
    Lattice lattice;
    for (std::size_t axis = 0; axis < 3; ++axis)
        lattice.size[axis] = static_cast<std::uint32_t>((*axes)[axis].size);
    if (const Status placed = place(*axes, *spaceOrigin, lattice); !placed)
        return placed.error();
    if (const Status checked = checkLatticePlacement(lattice); !checked)
        return checked.error();
    return lattice;
}

std::string nrrdLengthUnit(const NrrdFields& fields)
{
    const auto units = lengthUnits(fields);
    return units.size() == 1 ? printable(*units.begin()) : std::string();
}

Eigen::Vector3d nrrdStepsToOrigin(const NrrdFields& fields)
{
    Eigen::Vector3d steps = Eigen::Vector3d::Zero();
    const auto axes = volumeAxes(fields);
    const auto spaceOrigin = parseSpaceOrigin(fields);
    if (!axes || tellsNrrdSpacing(fields) || !spaceOrigin || *spaceOrigin)
        return steps;
    for (std::size_t axis = 0; axis < 3; ++axis)
        if ((*axes)[axis].minimum && (*axes)[axis].centeredInCells)
            steps[static_cast<Eigen::Index>(axis)] = 0.5;
    return steps;
}

std::vector<Message> nrrdPlaceRemarks(const NrrdFields& fields)
{
    std::vector<Message> remarks;
    if (std::ranges::find(leftHandedSpaces, lowerCase(fields["space"])) != std::end(leftHandedSpaces))
        remarks.push_back(Message::say("Its space '%1' is left-handed. Its coordinates are kept, and pictures and "
                                       "other programs treat them as right-handed: they show the mirror image.",
                                       printable(fields["space"])));
    if (lengthUnits(fields).size() > 1)
        remarks.push_back(
            Message::say("Its units differ from axis to axis: %1. Its numbers were used as they are, without a unit.",
                         printable(fields[fields.has("space directions") ? "space units" : "units"])));
    return remarks;
}

} // namespace tetra
