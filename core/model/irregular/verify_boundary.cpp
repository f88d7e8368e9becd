// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/verify_boundary.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/topology.h"
#include "core/model/findings.h"
#include "core/model/irregular/face_meeting.h"
#include "core/model/scattered_cells.h"
#include "core/model/verify_each.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <optional>

namespace tetra {

namespace {

constexpr std::size_t trianglesAtOnce = 256;

std::vector<PointTriangle> trianglesOf(const LevelCells& cells, std::span<const BoundaryFace> faces)
{
    std::vector<PointTriangle> triangles;
    triangles.reserve(faces.size());
    for (const BoundaryFace& face : faces)
        triangles.push_back(
            {cells.point(face.vertices[0]), cells.point(face.vertices[1]), cells.point(face.vertices[2])});
    return triangles;
}

std::vector<std::uint32_t> cellsOf(std::span<const BoundaryFace> faces)
{
    std::vector<std::uint32_t> cells(faces.size());
    std::ranges::transform(faces, cells.begin(), &BoundaryFace::cell);
    return cells;
}

Eigen::AlignedBox3d boxOfPlaced(const PlacedCell& cell)
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : cell)
        box.extend(corner);
    return box;
}

class BoundaryCheck {
public:
    BoundaryCheck(const IrregularOriginal& original, const LevelCells& cells, const MeshBoundary& boundary)
        : original_(original), cells_(cells), boundary_(boundary)
    {
    }

    Status run(LevelVerdict& verdict, const Progress& progress);

private:
    void checkManifold();
    void checkComponents();
    void checkSurfaces();
    Status checkMeetings(const Progress& progress);
    void checkCoveredOnce();
    bool isUndivided(std::size_t cell) const;
    bool coversOnce(std::uint32_t triangle) const;
    std::optional<std::uint32_t> triangleWithRoom(std::uint32_t surface) const;
    PlacedCell placed(std::size_t cell) const { return placedCell(original_.points.positions, cells_, cell); }
    Eigen::Vector3d middleOf(std::size_t cell) const
    {
        const PlacedCell c = placed(cell);
        return (c[0] + c[1] + c[2] + c[3]) / 4;
    }
    bool isOriginal(std::uint32_t triangle) const;
    std::string name(std::uint32_t point) const
    {
        return std::to_string(point) + " " + textOf(original_.points.positions[point]);
    }
    std::string name(const PointTriangle& t) const
    {
        const auto& places = original_.points.positions;
        return textOf(places[t[0]]) + " " + textOf(places[t[1]]) + " " + textOf(places[t[2]]);
    }

    const IrregularOriginal& original_;
    const LevelCells& cells_;
    const MeshBoundary& boundary_;
    Findings manifold_;
    Findings components_;
    Findings surfaces_;
    Findings meetings_;
    Findings coverage_;
};

void BoundaryCheck::checkManifold()
{
    for (const auto& edge : boundary_.surfaces.brokenEdges)
        manifold_.add(edge[0], [&] {
            return "The boundary's edge from point " + name(edge[0]) + " to " + name(edge[1]) +
                   " does not belong to two of its faces.";
        });
    for (const std::uint32_t vertex : boundary_.surfaces.brokenVertices)
        manifold_.add(vertex, [&] {
            return "The boundary touches itself at point " + name(vertex) + ": it is no manifold there.";
        });
}

void BoundaryCheck::checkComponents()
{
    const std::size_t points = original_.componentOf.size();
    DisjointSets joined(points);
    std::vector<bool> used(points);
    for (std::size_t cell = 0; cell < cells_.size(); ++cell) {
        const LevelCells::Cell& c = cells_.vertices(cell);
        const std::uint32_t first = cells_.point(c[0]);
        for (const std::uint32_t vertex : c) {
            const std::uint32_t point = cells_.point(vertex);
            joined.join(first, point);
            used[point] = true;
            if (original_.componentOf[point] != original_.componentOf[first])
                components_.add(cell, [&] {
                    return "A cell joins points " + name(first) + " and " + name(point) +
                           " of two components of the data.";
                });
        }
    }
    std::int64_t parts = 0;
    std::int64_t components = 0;
    for (std::uint32_t point = 0; point < points; ++point) {
        parts += used[point] && joined.root(point) == point ? 1 : 0;
        components += original_.componentOf[point] == point ? 1 : 0;
    }
    if (parts != components)
        components_.add(0, [&] {
            return "The mesh has " + std::to_string(parts) + " components, and the data have " +
                   std::to_string(components) + ".";
        });
}

/// Each surface is one of the original's and of its kind.
void BoundaryCheck::checkSurfaces()
{
    const auto& surfaces = boundary_.surfaces.surfaces;
    const auto& originals = original_.surfaces.surfaces;
    if (surfaces.size() != originals.size())
        surfaces_.add(0, [&] {
            return "The boundary has " + std::to_string(surfaces.size()) + " surfaces, and that of the data has " +
                   std::to_string(originals.size()) + ".";
        });
    constexpr std::uint32_t unknown = 0xfffffffe;
    std::vector<std::uint32_t> meant(surfaces.size(), unknown);
    for (std::uint32_t triangle = 0; triangle < boundary_.triangles.size(); ++triangle)
        for (const std::uint32_t point : boundary_.triangles[triangle]) {
            std::uint32_t& surface = meant[boundary_.surfaces.surfaceOf[triangle]];
            if (surface == unknown)
                surface = original_.surfaceOf[point];
            if (original_.surfaceOf[point] != surface || surface == IrregularOriginal::none)
                surfaces_.add(triangle, [&] {
                    return "The boundary goes through point " + name(point) +
                           (original_.isOnBoundary(point) ? ", which lies on another surface of the data."
                                                          : ", which lies inside the data.");
                });
        }
    std::vector<bool> taken(originals.size());
    for (std::size_t surface = 0; surface < surfaces.size(); ++surface) {
        if (meant[surface] >= originals.size())
            continue; // said already
        if (taken[meant[surface]])
            surfaces_.add(surfaces[surface].firstTriangle, [&] {
                return "A surface of the data's boundary became two, one of them with the face " +
                       name(boundary_.triangles[surfaces[surface].firstTriangle]) + ".";
            });
        taken[meant[surface]] = true;
        if (surfaces[surface].euler != originals[meant[surface]].euler)
            surfaces_.add(surfaces[surface].firstTriangle, [&] {
                return "The surface of the boundary with the face " +
                       name(boundary_.triangles[surfaces[surface].firstTriangle]) + " has Euler characteristic " +
                       std::to_string(surfaces[surface].euler) + ", and that of the data has " +
                       std::to_string(originals[meant[surface]].euler) + ": a hole was opened or closed.";
            });
    }
}

bool BoundaryCheck::isOriginal(std::uint32_t triangle) const
{
    PointTriangle wanted = boundary_.triangles[triangle];
    std::ranges::sort(wanted);
    bool found = false;
    original_.tree.visitMeeting(boundary_.tree.boxOf(triangle), [&](std::uint32_t other) {
        PointTriangle points = original_.boundary[other];
        std::ranges::sort(points);
        found |= points == wanted;
    });
    return found;
}

Status BoundaryCheck::checkMeetings(const Progress& progress)
{
    const auto& triangles = boundary_.triangles;
    const auto checkTriangle = [&](std::uint32_t number) {
        boundary_.tree.visitMeeting(boundary_.tree.boxOf(number), [&](std::uint32_t other) {
            if (other <= number || !facesMeet(original_.points.positions, triangles[number], triangles[other]) ||
                (isOriginal(number) && isOriginal(other)))
                return;
            meetings_.add(number, [&] {
                return "The boundary meets itself: the faces " + name(triangles[number]) + " and " +
                       name(triangles[other]) + " have more in common than their corners.";
            });
        });
    };
    return verifyEach(triangles.size(), trianglesAtOnce, "Verifying the boundary", progress,
                      [&](std::size_t number) { checkTriangle(static_cast<std::uint32_t>(number)); });
}

/// A triangle of the surface whose cell has a middle that doubles can name.
std::optional<std::uint32_t> BoundaryCheck::triangleWithRoom(std::uint32_t surface) const
{
    for (std::uint32_t triangle = boundary_.surfaces.surfaces[surface].firstTriangle;
         triangle < boundary_.triangles.size(); ++triangle) {
        const std::uint32_t cell = boundary_.cells[triangle];
        if (boundary_.surfaces.surfaceOf[triangle] == surface && volumeSign(placed(cell)) > 0 &&
            holdsInside(placed(cell), middleOf(cell)))
            return triangle;
    }
    return {};
}

/// Whether no face of the boundary goes into a cell. With cells that conform none goes even through its faces.
bool BoundaryCheck::isUndivided(std::size_t cell) const
{
    const PlacedCell corners = placed(cell);
    const LevelCells::Cell& c = cells_.vertices(cell);
    std::array<PointTriangle, 4> faces;
    for (std::size_t face = 0; face < 4; ++face)
        for (std::size_t i = 0; i < 3; ++i)
            faces[face][i] = cells_.point(c[cornersOfFace[face][i]]);
    bool undivided = true;
    boundary_.tree.visitMeeting(boxOfPlaced(corners), [&](std::uint32_t number) {
        const PointTriangle& other = boundary_.triangles[number];
        undivided = undivided &&
                    std::ranges::none_of(boundary_.tree.corners(number),
                                         [&](const Eigen::Vector3d& place) { return holdsInside(corners, place); });
        for (const PointTriangle& face : faces)
            undivided = undivided && (std::ranges::is_permutation(face, other) ||
                                      !facesMeet(original_.points.positions, face, other));
    });
    return undivided;
}

/// Whether just inside the surface, at this triangle, there is its cell alone.
bool BoundaryCheck::coversOnce(std::uint32_t triangle) const
{
    const Eigen::Vector3d middle = middleOf(boundary_.cells[triangle]);
    std::atomic<std::uint32_t> cells = 0;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells_.size(), 4096), [&](const auto& range) {
        for (std::size_t cell = range.begin(); cell != range.end(); ++cell) {
            const PlacedCell c = placed(cell);
            cells += boxOfPlaced(c).contains(middle) && volumeSign(c) > 0 && holds(c, middle) ? 1 : 0;
        }
    });
    return cells == 1 && isUndivided(boundary_.cells[triangle]);
}

/// How many cells hold a place changes only at the boundary, and there by one. So it is at most one everywhere if it is
/// one just inside each of the surfaces, which do not meet.
void BoundaryCheck::checkCoveredOnce()
{
    for (std::uint32_t surface = 0; surface < boundary_.surfaces.surfaces.size(); ++surface) {
        const auto triangle = triangleWithRoom(surface);
        if (triangle && coversOnce(*triangle))
            continue;
        const std::uint32_t first = boundary_.surfaces.surfaces[surface].firstTriangle;
        coverage_.add(first, [&] {
            return (triangle ? "Cells lie on one another" : std::string("No cell has room for a number in doubles")) +
                   " inside the surface of the boundary with the face " + name(boundary_.triangles[first]) + ".";
        });
    }
}

Status BoundaryCheck::run(LevelVerdict& verdict, const Progress& progress)
{
    checkManifold();
    checkComponents();
    if (manifold_.none()) {
        checkSurfaces();
        if (const Status done = checkMeetings(progress); !done)
            return done;
    }
    if (manifold_.none() && meetings_.none())
        checkCoveredOnce();
    verdict.conforming = verdict.conforming && manifold_.none();
    verdict.covers = verdict.covers && components_.none() && surfaces_.none() && meetings_.none() && coverage_.none();
    for (Findings* findings : {&manifold_, &components_, &surfaces_, &meetings_, &coverage_})
        findings->moveTo(verdict.failures);
    return {};
}

} // namespace

MeshBoundary::MeshBoundary(const IrregularOriginal& original, const LevelCells& levelCells,
                           std::span<const BoundaryFace> faces)
    : triangles(trianglesOf(levelCells, faces)), cells(cellsOf(faces)), surfaces(boundarySurfaces(triangles)),
      tree(original.points.positions, triangles)
{
}

Status verifyBoundary(const IrregularOriginal& original, const LevelCells& cells, const MeshBoundary& boundary,
                      LevelVerdict& verdict, const Progress& progress)
{
    return BoundaryCheck(original, cells, boundary).run(verdict, progress);
}

} // namespace tetra
