// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/grid_cells.h"
#include "core/geometry/box_tree.h"
#include "core/geometry/triangles.h"

#include <tan/zones.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr MarkedText joiningZones = Message::marked("Joining the zones");

bool hasCells(const Dataset& zone)
{
    return std::ranges::min(zone.lattice.size) >= 2;
}

/// The zones that have cells.
Result<std::vector<const Dataset*>> solidZones(std::span<const Dataset> zones)
{
    std::vector<const Dataset*> solid;
    std::uint64_t points = 0;
    for (const Dataset& zone : zones) {
        if (!isOnLattice(zone.domain) || zone.values.count() != zone.lattice.pointCount() ||
            (zone.positions && zone.positions->size() != zone.values.count()) ||
            (zone.cells && hasCells(zone) && zone.cells->size() != zone.lattice.cellCount()))
            return Error{ErrorKind::BadInput,
                         Message::say("The zone '%1' is not a structured grid with a value for each point.",
                                      printable(zone.source.name))};
        if (!hasCells(zone))
            continue;
        solid.push_back(&zone);
        points += zone.pointCount();
    }
    if (solid.empty())
        return Error{ErrorKind::BadInput, Message::say("None of the zones has cells: a volume has at least two points "
                                                       "along each of three axes.")};
    if (points >= std::numeric_limits<std::uint32_t>::max())
        return Error{
            ErrorKind::OutOfResource,
            Message::say("The zones have %1 points; at most 4294967294 can be numbered. Take one zone.", points)};
    return solid;
}

Status checkMemory(const std::vector<const Dataset*>& zones)
{
    std::uint64_t cells = 0;
    for (const Dataset* zone : zones)
        cells += zone->lattice.cellCount();
    const std::uint64_t bytes = bytesOfGridTetrahedron * tetrahedraOfGridCell * cells;
    if (const std::uint64_t usable = usableBytes(); usable > 0 && bytes > usable)
        return Error{ErrorKind::OutOfResource,
                     Message::say("The zones have %1 cells, whose mesh takes up to %2 of memory, of %3. Take one zone.",
                                  cells, neededBytesText(bytes), neededBytesText(usable))};
    return {};
}

/// A face of a zone's hexahedra that only one of them has.
struct OuterFace {
    std::array<std::uint32_t, 4> corners{}; ///< numbers of points, each the first one on its place, in their order
    std::uint32_t zone = 0;
};

std::array<std::uint32_t, 4> sorted(std::array<std::uint32_t, 4> corners)
{
    std::ranges::sort(corners);
    return corners;
}

/// Where a zone's hexahedra are among those of all, and how many there are along each axis.
struct ZoneCells {
    std::uint64_t first = 0;
    std::array<std::uint64_t, 3> size{};
    bool isMirrored = false; ///< the hexahedra stand on their heads
};

struct Hexahedra {
    CellComplex complex;
    std::vector<double> values;
    std::vector<ZoneCells> zones;
};

Status addZone(const Dataset& zone, Hexahedra& all, const Progress& progress)
{
    CellComplex& complex = all.complex;
    const std::uint64_t firstPoint = complex.positions.size();
    const auto& size = zone.lattice.size;
    all.zones.push_back({complex.shapes.size(), {size[0] - 1, size[1] - 1, size[2] - 1}, zone.lattice.isLeftHanded()});
    for (std::uint64_t point = 0; point < zone.pointCount(); ++point) {
        complex.positions.push_back(zone.position(point));
        all.values.push_back(zone.values.at(point));
    }
    const std::uint64_t firstCell = complex.shapes.size();
    const Status visited = forEachCell(zone, progress, [&](const auto& corners, GridCell /*what*/) {
        for (const std::uint64_t corner : corners)
            complex.corners.push_back(firstPoint + corner);
        complex.shapes.push_back(CellShape::Hexahedron);
        complex.offsets.push_back(complex.corners.size());
    });
    if (!visited || !zone.cells)
        return visited;
    complex.blanked.resize(complex.shapes.size());
    for (std::size_t cell = 0; cell < zone.cells->size(); ++cell)
        complex.blanked[firstCell + cell] = (*zone.cells)[cell] != GridCell::Kept;
    return {};
}

/// Whether the cell is there: not hidden, and with a finite value at each corner.
bool isThere(const Hexahedra& all, std::size_t cell)
{
    if (!all.complex.blanked.empty() && all.complex.blanked[cell] != 0)
        return false;
    const auto corners = std::span(all.complex.corners).subspan(8 * cell, 8);
    return std::ranges::all_of(corners, [&](std::uint64_t point) { return std::isfinite(all.values[point]); });
}

/// The corners of a cell's six sides, the lower and the upper one of each axis.
constexpr std::array<std::array<std::uint8_t, 4>, 6> sidesOfCell = {
    {{0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}, {0, 1, 2, 3}, {4, 5, 6, 7}}};

/// Calls visit(corners) for the sides of a zone's cells beyond which there is none, by the points of all zones.
template <class Visit> void forOuterSides(const Hexahedra& all, const ZoneCells& zone, const Visit& visit)
{
    const std::array<std::uint64_t, 3> steps = {1, zone.size[0], zone.size[0] * zone.size[1]};
    const std::uint64_t count = steps[2] * zone.size[2];
    for (std::uint64_t cell = 0; cell < count; ++cell) {
        if (!isThere(all, zone.first + cell))
            continue;
        for (std::size_t side = 0; side < 6; ++side) {
            const std::size_t axis = side / 2;
            const std::uint64_t index = cell / steps[axis] % zone.size[axis];
            const bool isUpper = side % 2 != 0, isLast = index == (isUpper ? zone.size[axis] - 1 : 0);
            if (!isLast && isThere(all, zone.first + (isUpper ? cell + steps[axis] : cell - steps[axis])))
                continue;
            std::array<std::uint64_t, 4> points{};
            for (std::size_t i = 0; i < 4; ++i)
                points[i] = all.complex.corners[8 * (zone.first + cell) +
                                                sidesOfCell[zone.isMirrored && axis == 2 ? side ^ 1U : side][i]];
            visit(points);
        }
    }
}

/// The faces that only one cell of their zone has: not those along which a zone meets itself, and none of which two
/// corners lie on one place.
std::vector<OuterFace> outerFaces(const Hexahedra& all)
{
    std::vector<bool> used(all.complex.positions.size());
    for (const ZoneCells& zone : all.zones)
        forOuterSides(all, zone, [&](const std::array<std::uint64_t, 4>& points) {
            for (const std::uint64_t point : points)
                used[point] = all.complex.positions[point].allFinite();
        });
    const std::vector<std::uint32_t> first = firstOnPlace(all.complex.positions, used);
    std::vector<OuterFace> outer, ofZone;
    for (std::uint32_t zone = 0; zone < all.zones.size(); ++zone) {
        ofZone.clear();
        forOuterSides(all, all.zones[zone], [&](const std::array<std::uint64_t, 4>& points) {
            OuterFace face{.corners = {}, .zone = zone};
            for (std::size_t i = 0; i < 4; ++i)
                face.corners[i] = first[points[i]];
            const auto key = sorted(face.corners);
            if (std::ranges::all_of(points, [&](std::uint64_t point) { return used[point]; }) &&
                std::ranges::adjacent_find(key) == key.end())
                ofZone.push_back(face);
        });
        std::ranges::sort(ofZone, {}, [](const OuterFace& face) { return sorted(face.corners); });
        for (std::size_t begin = 0, end = 0; begin < ofZone.size(); begin = end) {
            const auto key = sorted(ofZone[begin].corners);
            for (end = begin; end < ofZone.size() && sorted(ofZone[end].corners) == key; ++end) {
            }
            if (end == begin + 1)
                outer.push_back(ofZone[begin]);
        }
    }
    return outer;
}

/// How zones meet.
struct Meeting {
    std::uint64_t fitting = 0;     ///< faces that two zones have
    std::uint64_t mismatching = 0; ///< faces of one that lie against another one's, which are not the same
};

double distanceTo(std::span<const Eigen::Vector3d> positions, const OuterFace& face, const Eigen::Vector3d& place)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::array<std::size_t, 3>& half : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
        std::array<std::array<double, 3>, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t axis = 0; axis < 3; ++axis)
                corners[i][axis] = positions[face.corners[half[i]]][Eigen::Index(axis)] - place[Eigen::Index(axis)];
        const auto weights = nearestWeights(corners);
        Eigen::Vector3d to = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            to += weights[i] * Eigen::Vector3d(corners[i][0], corners[i][1], corners[i][2]);
        nearest = std::min(nearest, to.norm());
    }
    return nearest;
}

/// Of faces that no other zone has as they are, how many lie against another zone: their middle is nearer to a face of
/// it than a twentieth of the shortest edge, as on a bent border that both follow in steps of their own.
std::uint64_t countMismatching(std::span<const Eigen::Vector3d> positions, const std::vector<OuterFace>& faces,
                               const Progress& progress)
{
    constexpr double near = 0.05;
    constexpr std::size_t facesBetweenReports = 1 << 14;
    const auto boxOf = [&](std::uint32_t face) {
        Eigen::AlignedBox3d box;
        for (const std::uint32_t corner : faces[face].corners)
            box.extend(positions[corner]);
        return box;
    };
    const BoxTree tree(faces.size(), boxOf, [&](std::uint32_t face, Eigen::Index axis) {
        double sum = 0;
        for (const std::uint32_t corner : faces[face].corners)
            sum += positions[corner][axis];
        return sum;
    });
    std::uint64_t count = 0;
    for (std::size_t number = 0; number < faces.size(); ++number) {
        if (number % facesBetweenReports == 0) {
            if (progress.cancelled())
                return count;
            progress.report(double(number) / double(faces.size()), joiningZones);
        }
        const OuterFace& face = faces[number];
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < 4; ++i) {
            middle += positions[face.corners[i]] / 4;
            shortest = std::min(shortest, (positions[face.corners[i]] - positions[face.corners[(i + 1) % 4]]).norm());
        }
        bool lies = false;
        tree.visitNear(
            [&](const Eigen::AlignedBox3d& box) { return !lies && box.exteriorDistance(middle) <= near * shortest; },
            [&](std::uint32_t other) {
                lies = lies || (faces[other].zone != face.zone &&
                                distanceTo(positions, faces[other], middle) <= near * shortest);
            });
        count += lies ? 1 : 0;
    }
    return count;
}

Meeting meetingOf(const Hexahedra& all, const Progress& progress)
{
    std::vector<OuterFace> faces = outerFaces(all), alone;
    std::ranges::sort(faces, {}, [](const OuterFace& face) { return std::pair(sorted(face.corners), face.zone); });
    Meeting meeting;
    for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
        const auto key = sorted(faces[begin].corners);
        for (end = begin; end < faces.size() && sorted(faces[end].corners) == key; ++end) {
        }
        if (end == begin + 1)
            alone.push_back(faces[begin]);
        else
            ++meeting.fitting;
    }
    meeting.mismatching = countMismatching(all.complex.positions, alone, progress);
    return meeting;
}

std::vector<Message> remarksOn(std::size_t zones, std::size_t leftOut, const Meeting& meeting)
{
    std::vector<Message> remarks;
    if (meeting.fitting > 0)
        remarks.push_back(Message::say("Its %1 zones were joined into one mesh, in which they share %2 faces.", zones,
                                       meeting.fitting));
    else if (zones > 1)
        remarks.push_back(
            Message::say("Its %1 zones were put into one mesh, in which no two of them share a face.", zones));
    if (meeting.mismatching > 0)
        remarks.push_back(Message::say("Faces of zones that meet another zone with different points there: %1. The "
                                       "mesh has a seam there, and is not connected across it.",
                                       meeting.mismatching));
    if (leftOut > 0)
        remarks.push_back(Message::say("Zones left out because they have no volume: %1.", leftOut));
    return remarks;
}

SampleType commonType(const std::vector<const Dataset*>& zones)
{
    const SampleType type = zones.front()->values.type();
    return std::ranges::all_of(zones, [&](const Dataset* zone) { return zone->values.type() == type; })
               ? type
               : SampleType::Float64;
}

} // namespace

Result<JoinedZones> joinZones(std::span<const Dataset> zones, const Progress& progress)
{
    constexpr double added = 0.5;
    const auto solid = solidZones(zones);
    if (!solid)
        return solid.error();
    if (const Status fits = checkMemory(*solid); !fits)
        return fits.error();
    Hexahedra all;
    all.complex.offsets = {0};
    for (std::size_t zone = 0; zone < solid->size(); ++zone)
        if (const Status is = addZone(*(*solid)[zone], all,
                                      progress.part(added * double(zone) / double(solid->size()),
                                                    added * double(zone + 1) / double(solid->size())));
            !is)
            return is.error();
    if (!all.complex.blanked.empty())
        all.complex.blanked.resize(all.complex.shapes.size());
    const Meeting meeting = meetingOf(all, progress.part(added, 1));
    if (progress.cancelled())
        return cancelledError(joiningZones);
    JoinedZones joined;
    joined.complex = std::move(all.complex);
    joined.values = {.values = std::move(all.values), .perCell = false, .type = commonType(*solid)};
    joined.remarks = remarksOn(solid->size(), zones.size() - solid->size(), meeting);
    return joined;
}

} // namespace tetra
