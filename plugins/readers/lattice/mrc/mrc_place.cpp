// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/mrc/mrc_place.h"

#include "plugins/api/lattice_steps.h"
#include "plugins/api/placement_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tetra {

namespace {

Eigen::Vector3d vectorOf(const std::array<double, 3>& numbers)
{
    return {numbers[0], numbers[1], numbers[2]};
}

std::string textOf(const Eigen::Vector3d& vector)
{
    return formatNumber(vector[0]) + ", " + formatNumber(vector[1]) + ", " + formatNumber(vector[2]);
}

/// Exact where a right angle makes it 0.
double cosineOf(double degrees)
{
    return degrees == 90 ? 0 : std::cos(degrees * std::numbers::pi / 180);
}

double sineOf(double degrees)
{
    return degrees == 90 ? 1 : std::sin(degrees * std::numbers::pi / 180);
}

/// The third edge of a cell of unit lengths whose first runs along x and whose second lies in the plane of x and y;
/// without numbers if no cell has such angles.
Eigen::Vector3d thirdEdge(const std::array<double, 3>& angles)
{
    const double x = cosineOf(angles[1]);
    const double y = (cosineOf(angles[0]) - cosineOf(angles[1]) * cosineOf(angles[2])) / sineOf(angles[2]);
    return {x, y, x == 0 && y == 0 ? 1 : std::sqrt(1 - x * x - y * y)};
}

/// The edges of the cell as columns.
Eigen::Matrix3d edgesOf(const std::array<double, 3>& lengths, const std::array<double, 3>& angles)
{
    Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();
    edges.col(1) = Eigen::Vector3d(cosineOf(angles[2]), sineOf(angles[2]), 0);
    edges.col(2) = thirdEdge(angles);
    return edges * vectorOf(lengths).asDiagonal();
}

bool areAngles(const std::array<double, 3>& angles)
{
    return std::ranges::all_of(angles, [](double angle) { return angle > 0 && angle < 180; }) &&
           thirdEdge(angles).allFinite() && thirdEdge(angles)[2] > 0;
}

/// Right angles where the header says none, or such as no cell has.
std::array<double, 3> anglesOf(const MrcHeader& header, StoredVolume& volume)
{
    constexpr std::array<double, 3> right{90, 90, 90};
    if (areAngles(header.angles))
        return header.angles;
    if (header.angles != std::array<double, 3>{})
        volume.leftOut.push_back(Message::say("Its cell angles are %1, which no cell has; right angles were used.",
                                              textOf(vectorOf(header.angles))));
    return right;
}

/// Which axis of the cell columns, rows and sections run along, from 0.
std::array<Eigen::Index, 3> axesOf(const MrcHeader& header, StoredVolume& volume)
{
    std::array<std::int32_t, 3> sorted = header.axes;
    std::ranges::sort(sorted);
    if (sorted == std::array{1, 2, 3})
        return {header.axes[0] - 1, header.axes[1] - 1, header.axes[2] - 1};
    if (header.axes != std::array{0, 0, 0})
        volume.leftOut.push_back(Message::say("Its header states that its columns, rows and sections run along the "
                                              "axes %1, %2 and %3, which is impossible; x, y and z were used.",
                                              header.axes[0], header.axes[1], header.axes[2]));
    return {0, 1, 2};
}

/// How many steps the cell has along x, y and z: where the header does not say, as many as there are samples.
Eigen::Vector3d gridOf(const MrcHeader& header, const std::array<Eigen::Index, 3>& axes)
{
    Eigen::Vector3d grid;
    for (std::size_t i = 0; i < 3; ++i)
        grid[axes[i]] = header.size[i];
    for (std::size_t i = 0; i < 3; ++i)
        if (header.grid[i] > 0)
            grid[static_cast<Eigen::Index>(i)] = header.grid[i];
    return grid;
}

/// What places the first sample, and what else would.
void placeFirst(const MrcHeader& header, const Eigen::Matrix3d& steps, StoredVolume& volume)
{
    constexpr std::int32_t originOfMrc = 4; // the flag of IMOD for ORIGIN of the usual sign
    const Eigen::Vector3d start(header.start[0], header.start[1], header.start[2]);
    const Eigen::Vector3d origin = vectorOf(header.origin), byStart = steps * start;
    const bool hasOrigin = origin.allFinite() && origin != Eigen::Vector3d::Zero();
    const bool hasStart = start != Eigen::Vector3d::Zero();
    volume.lattice.origin = hasOrigin ? origin : byStart;
    const double step = volume.lattice.spacing.minCoeff();
    const bool differs = (origin - byStart).norm() > 0.01 * step;
    const bool mayBeNegative = hasOrigin && header.isOfImod && (header.imodFlags & originOfMrc) == 0;
    if (hasOrigin || hasStart)
        volume.taken.push_back({TakenPart::Frame, hasOrigin ? Message("ORIGIN") : Message("NXSTART, NYSTART, NZSTART"),
                                mayBeNegative || (hasOrigin && hasStart && differs)});
    if (!origin.allFinite())
        volume.leftOut.push_back(Message::say("Its ORIGIN is not a finite number and was not used."));
    if (hasOrigin && hasStart && differs)
        volume.leftOut.push_back(Message::say(
            "By its NXSTART, NYSTART and NZSTART (%1) the first sample would lie at %2; its ORIGIN was used.",
            textOf(start), textOf(byStart)));
    if (mayBeNegative)
        volume.leftOut.push_back(Message::say("IMOD wrote it without the flag that its ORIGIN has the usual sign: the "
                                              "first sample may lie at the negative of it."));
}

} // namespace

void placeMrc(const MrcHeader& header, StoredVolume& volume)
{
    const auto axes = axesOf(header, volume);
    const bool hasCell = std::ranges::all_of(header.cell, [](double length) { return length > 0 && length < 1e30; });
    const Eigen::Vector3d grid = gridOf(header, axes);
    const Eigen::Matrix3d edges =
        hasCell ? edgesOf(header.cell, anglesOf(header, volume)) : Eigen::Matrix3d::Identity();
    const Eigen::Vector3d parts = hasCell ? grid : Eigen::Vector3d::Ones();
    Eigen::Matrix3d steps;
    for (std::size_t i = 0; i < 3; ++i)
        steps.col(static_cast<Eigen::Index>(i)) = edges.col(axes[i]) / parts[axes[i]];
    placeBySteps(volume.lattice, steps, Eigen::Vector3d::Zero());
    placeFirst(header, steps, volume);
    if (header.skew == 1)
        volume.leftOut.push_back(
            Message::say("Its header has a matrix that turns the map (LSKFLG), which was not used."));
    volume.lengthUnit = hasCell ? "angstrom" : "";
    if (!hasCell && volume.lattice.origin != vectorOf(header.origin))
        volume.stepsToOrigin = Eigen::Vector3d(header.start[0], header.start[1], header.start[2]);
    const bool hasPlace = volume.lattice.origin != Eigen::Vector3d::Zero();
    volume.untold = untoldPlacement(hasCell, hasCell || hasPlace, hasCell);
}

} // namespace tetra
