// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/nrrd_geometry.h"

#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/nrrd_axes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

using ThreeAxes = std::array<NrrdAxis, 3>;

/// The three axes that hold points.
Result<ThreeAxes> volumeAxes(std::vector<NrrdAxis> axes)
{
    const std::size_t dimension = axes.size();
    if (dimension > 3)
        std::erase_if(axes, [](const NrrdAxis& axis) { return axis.size == 1; });
    if (axes.size() != 3)
        return Error{ErrorKind::BadInput,
                     Message::say("it has %1 dimensions, %2 of them with more than one point. A volume has three: take "
                                  "out a part that has, such as one component or one time step.",
                                  dimension, axes.size())};
    for (const NrrdAxis& axis : axes)
        if (!axis.kind.empty() && axis.kind != "domain" && axis.kind != "space" && axis.kind != "time")
            return Error{
                ErrorKind::BadInput,
                Message::say("one of its axes, of size %1, holds '%2' instead of points. Take out one component first.",
                             axis.size, printable(axis.kind))};
    return ThreeAxes{std::move(axes[0]), std::move(axes[1]), std::move(axes[2])};
}

std::optional<double> spacingOf(const NrrdAxis& axis)
{
    if (axis.spacing)
        return axis.spacing;
    if (axis.minimum && axis.maximum && axis.size > 1)
        return (*axis.maximum - *axis.minimum) / static_cast<double>(axis.centeredInCells ? axis.size : axis.size - 1);
    return {};
}

/// By spacings, axis mins and axis maxs.
Status placeAlongAxes(const ThreeAxes& axes, Lattice& lattice)
{
    const auto known = std::ranges::count_if(axes, [](const NrrdAxis& axis) { return spacingOf(axis).has_value(); });
    if (known != 0 && known != 3)
        return Error{ErrorKind::BadInput,
                     Message::say("its header gives the spacing of some axes only. Give all three, or none.")};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        lattice.spacing[axis] = spacingOf(axes[i]).value_or(1);
        lattice.origin[axis] = axes[i].minimum.value_or(0);
        if (axes[i].minimum && axes[i].centeredInCells)
            lattice.origin[axis] += lattice.spacing[axis] / 2;
    }
    return {};
}

/// Length of a vector, exact if it lies along an axis.
double lengthOf(const Eigen::Vector3d& vector)
{
    const double largest = vector.cwiseAbs().maxCoeff();
    return (vector.array() != 0).count() <= 1 ? largest : vector.norm();
}

/// By space directions and space origin.
Status placeInSpace(const ThreeAxes& axes, const Eigen::Vector3d& spaceOrigin, Lattice& lattice)
{
    Eigen::Matrix3d directions;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        const Eigen::Vector3d& direction = *axes[i].direction;
        lattice.spacing[axis] = lengthOf(direction);
        directions.col(axis) = direction / lattice.spacing[axis];
    }
    constexpr double rightAngle = 1e-4; // headers hold few digits
    const Eigen::Matrix3d cosines = directions.transpose() * directions;
    if (!((cosines - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() <= rightAngle))
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "its space directions are not three vectors at right angles. Resample it on a rectangular grid.")};
    lattice.origin = directions.transpose() * spaceOrigin;
    return {};
}

/// Nothing if it is not given, or unknown.
Result<std::optional<Eigen::Vector3d>> parseSpaceOrigin(const NrrdFields& fields)
{
    if (!fields.has("space origin"))
        return std::optional<Eigen::Vector3d>();
    const std::optional<Eigen::Vector3d> origin = parseNrrdVector(fields["space origin"]);
    if (!origin)
        return Error{ErrorKind::BadInput, Message::say("its space origin '%1' is not three numbers in parentheses.",
                                                       printable(fields["space origin"]))};
    return origin->allFinite() ? origin : std::nullopt;
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

} // namespace

Result<Lattice> nrrdLattice(const NrrdFields& fields)
{
    Result<std::vector<NrrdAxis>> all = parseNrrdAxes(fields);
    if (!all)
        return all.error();
    const Result<ThreeAxes> axes = volumeAxes(*std::move(all));
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

} // namespace tetra
