// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_boundary.h"

#include "core/base/disjoint_sets.h"
#include "core/mesh/topology.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"
#include "core/verify/scattered_cells.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>

namespace tetra {

namespace {

using SpacePlace = Eigen::Vector3d;
using MeetingTriangle = std::array<SpacePlace, 3>;

/// The side of a line in the plane without the axis `out`: of c beside the line from a to b.
int sideInPlane(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, int out)
{
    SpacePlace p = a, q = b, r = c;
    p[out] = q[out] = r[out] = 0;
    SpacePlace above = p;
    above[out] = 1;
    return volumeSign(p, q, r, above);
}

/// An axis along which the triangle, which is not flat, has a projection that is not flat.
int axisToLeaveOut(const MeetingTriangle& t)
{
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
    int best = 0;
    normal.maxCoeff(&best);
    for (const int axis : {best, (best + 1) % 3, (best + 2) % 3})
        if (sideInPlane(t[0], t[1], t[2], axis) != 0)
            return axis;
    return best;
}

bool holdsInPlane(const MeetingTriangle& t, const SpacePlace& place, int out)
{
    const int sides[] = {sideInPlane(t[0], t[1], place, out), sideInPlane(t[1], t[2], place, out),
                         sideInPlane(t[2], t[0], place, out)};
    return std::ranges::all_of(sides, [](int side) { return side >= 0; }) ||
           std::ranges::all_of(sides, [](int side) { return side <= 0; });
}

/// Of segments on one line at most: whether their boxes overlap.
bool boxesMeet(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, const SpacePlace& d)
{
    return (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all() &&
           (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
}

bool segmentsMeetInPlane(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, const SpacePlace& d, int out)
{
    if (!boxesMeet(a, b, c, d))
        return false;
    return sideInPlane(a, b, c, out) * sideInPlane(a, b, d, out) <= 0 &&
           sideInPlane(c, d, a, out) * sideInPlane(c, d, b, out) <= 0;
}

/// All in one plane.
bool segmentMeetsInPlane(const SpacePlace& from, const SpacePlace& to, const MeetingTriangle& t)
{
    const int out = axisToLeaveOut(t);
    return holdsInPlane(t, from, out) || holdsInPlane(t, to, out) || segmentsMeetInPlane(from, to, t[0], t[1], out) ||
           segmentsMeetInPlane(from, to, t[1], t[2], out) || segmentsMeetInPlane(from, to, t[2], t[0], out);
}

bool segmentMeets(const SpacePlace& from, const SpacePlace& to, const MeetingTriangle& t)
{
    const int first = volumeSign(t[0], t[1], t[2], from);
    const int second = volumeSign(t[0], t[1], t[2], to);
    if (first * second > 0)
        return false;
    if (first == 0 && second == 0)
        return segmentMeetsInPlane(from, to, t);
    const int sides[] = {volumeSign(from, to, t[0], t[1]), volumeSign(from, to, t[1], t[2]),
                         volumeSign(from, to, t[2], t[0])};
    return std::ranges::all_of(sides, [](int side) { return side >= 0; }) ||
           std::ranges::all_of(sides, [](int side) { return side <= 0; });
}

/// Two triangles with the points that they share in front, in the same order.
struct Pair {
    MeetingTriangle first;
    MeetingTriangle second;
    std::size_t shared = 0;
};

Pair pairOf(std::span<const SpacePlace> positions, PointTriangle first, PointTriangle second)
{
    Pair pair;
    for (std::size_t i = pair.shared; i < 3; ++i) {
        const auto same = std::find(second.begin() + static_cast<std::ptrdiff_t>(pair.shared), second.end(), first[i]);
        if (same == second.end())
            continue;
        std::swap(second[pair.shared], *same);
        std::swap(first[pair.shared], first[i]);
        ++pair.shared;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        pair.first[i] = positions[first[i]];
        pair.second[i] = positions[second[i]];
    }
    return pair;
}

/// Whether a plane across the axis has the triangles on its sides, with nothing but what they share in it; `doubt` is
/// more than what rounding can do to a coordinate along an axis of length 1.
bool separates(const Pair& pair, const SpacePlace& axis, double doubt)
{
    const double margin = doubt * axis.lpNorm<1>();
    if (!(margin > 0))
        return false;
    // The origin is shared, or the mean of two corners: where the plane goes through is free unless points are shared.
    const SpacePlace& origin = pair.first[0];
    double low[2], high[2];
    for (int which = 0; which < 2; ++which) {
        const MeetingTriangle& t = which == 0 ? pair.first : pair.second;
        low[which] = std::numeric_limits<double>::infinity();
        high[which] = -low[which];
        for (std::size_t i = pair.shared; i < 3; ++i) {
            const double at = axis.dot(t[i] - origin);
            low[which] = std::min(low[which], at);
            high[which] = std::max(high[which], at);
        }
    }
    if (pair.shared == 0)
        return low[0] - margin > high[1] + margin || low[1] - margin > high[0] + margin;
    return (low[0] > margin && high[1] < -margin) || (low[1] > margin && high[0] < -margin);
}

/// True only if the triangles have nothing in common but one shared point, or nothing at all: what most pairs are.
bool arePlainlyApart(const Pair& pair)
{
    const auto edges = [](const MeetingTriangle& t) {
        return std::array<SpacePlace, 3>{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    };
    const auto first = edges(pair.first), second = edges(pair.second);
    double size = 0;
    for (const MeetingTriangle* t : {&pair.first, &pair.second})
        for (const SpacePlace& corner : *t)
            size = std::max(size, corner.cwiseAbs().maxCoeff());
    const double doubt = 0x1p-48 * size;
    const SpacePlace firstNormal = first[0].cross(first[2]), secondNormal = second[0].cross(second[2]);
    if (separates(pair, firstNormal, doubt) || separates(pair, secondNormal, doubt))
        return true;
    const SpacePlace middles = (pair.second[1] + pair.second[2]) - (pair.first[1] + pair.first[2]);
    if (separates(pair, middles, doubt))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (separates(pair, firstNormal.cross(first[i]), doubt) ||
            separates(pair, secondNormal.cross(second[i]), doubt))
            return true;
    if (pair.shared == 1) { // between the sides of the two that are next to each other
        for (const SpacePlace& a :
             {SpacePlace(pair.first[1] - pair.first[0]), SpacePlace(pair.first[2] - pair.first[0])})
            for (const SpacePlace& b :
                 {SpacePlace(pair.second[1] - pair.first[0]), SpacePlace(pair.second[2] - pair.first[0])}) {
                const SpacePlace between = a.normalized() + b.normalized();
                if (separates(pair, firstNormal.cross(between), doubt) ||
                    separates(pair, secondNormal.cross(between), doubt))
                    return true;
            }
        return false;
    }
    for (const SpacePlace& a : first)
        for (const SpacePlace& b : second)
            if (separates(pair, a.cross(b), doubt))
                return true;
    return false;
}

/// Of two that share an edge: one lies on the other.
bool areFolded(const Pair& pair)
{
    const auto normal = [](const MeetingTriangle& t) -> SpacePlace { return (t[1] - t[0]).cross(t[2] - t[0]); };
    const SpacePlace first = normal(pair.first), second = normal(pair.second);
    // On opposite sides of the edge the normals, which both turn about it the same way, point apart. Far from rounding.
    if (first.dot(second) < -0x1p-10 * first.norm() * second.norm() &&
        std::min(first.norm(), second.norm()) >
            0x1p-30 * (pair.first[1] - pair.first[0]).norm() * (pair.first[0].cwiseAbs().maxCoeff()))
        return false;
    if (volumeSign(pair.first[0], pair.first[1], pair.first[2], pair.second[2]) != 0)
        return false;
    const int out = axisToLeaveOut(pair.first);
    return sideInPlane(pair.first[0], pair.first[1], pair.first[2], out) ==
           sideInPlane(pair.first[0], pair.first[1], pair.second[2], out);
}

} // namespace

bool segmentMeetsTriangle(const SpacePlace& from, const SpacePlace& to, const SpacePlace& a, const SpacePlace& b,
                          const SpacePlace& c)
{
    return segmentMeets(from, to, {a, b, c});
}

bool facesMeet(std::span<const SpacePlace> positions, const PointTriangle& first, const PointTriangle& second)
{
    const Pair pair = pairOf(positions, first, second);
    if (pair.shared == 2)
        return areFolded(pair);
    if (arePlainlyApart(pair))
        return false;
    const MeetingTriangle& a = pair.first;
    const MeetingTriangle& b = pair.second;
    // What two triangles with a common corner share besides it reaches to a side opposite to that corner.
    if (pair.shared == 1)
        return segmentMeets(a[1], a[2], b) || segmentMeets(b[1], b[2], a);
    for (std::size_t i = 0; i < 3; ++i)
        if (segmentMeets(a[i], a[(i + 1) % 3], b) || segmentMeets(b[i], b[(i + 1) % 3], a))
            return true;
    return false;
}

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

    Status run(LevelReport& verdict, const Progress& progress);

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

Status BoundaryCheck::run(LevelReport& verdict, const Progress& progress)
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
                      LevelReport& verdict, const Progress& progress)
{
    return BoundaryCheck(original, cells, boundary).run(verdict, progress);
}

} // namespace tetra
