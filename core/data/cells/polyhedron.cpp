// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/polyhedron.h"

#include "core/geometry/orientation.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tetra {

namespace {

using Positions = std::span<const Eigen::Vector3d>;
using Nodes = std::vector<std::uint32_t>;

std::array<double, 3> asArray(const Eigen::Vector3d& place)
{
    return {place[0], place[1], place[2]};
}

/// A face in the one order that both cells at it see: from its smallest node towards the smaller one of the two beside
/// that.
struct CanonicalFace {
    Nodes nodes;
    bool isReversed = false;
};

CanonicalFace canonicalFace(std::span<const std::uint32_t> face)
{
    CanonicalFace canonical{.nodes = {face.begin(), face.end()}};
    std::ranges::rotate(canonical.nodes, std::ranges::min_element(canonical.nodes));
    canonical.isReversed = canonical.nodes[1] > canonical.nodes.back();
    if (canonical.isReversed)
        std::reverse(canonical.nodes.begin() + 1, canonical.nodes.end());
    return canonical;
}

/// Perpendicular to a face that is not flat in itself, on the side from which its nodes run counterclockwise; zero for
/// points on a line. The same bits for both cells at it.
Eigen::Vector3d faceNormal(Positions positions, const Nodes& nodes)
{
    const Eigen::Vector3d& origin = positions[nodes[0]];
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        normal += (positions[nodes[i]] - origin).cross(positions[nodes[i + 1]] - origin);
    const double largest = normal.cwiseAbs().maxCoeff();
    return largest > 0 && std::isfinite(largest) ? Eigen::Vector3d(normal / largest) : Eigen::Vector3d::Zero();
}

/// The side of the triangle that looks along the normal: 1, or -1, or 0 if none does, as none of a flat one.
int sideAlong(Positions positions, const Triangle& triangle, const Eigen::Vector3d& normal)
{
    return directionSign(asArray(positions[triangle[0]]), asArray(positions[triangle[1]]),
                         asArray(positions[triangle[2]]), asArray(normal));
}

/// Triangle i, from 1 to two less than there are nodes, of the fan from the node at `first`.
Triangle fanTriangle(const Nodes& nodes, std::size_t first, std::size_t i)
{
    return {nodes[first], nodes[(first + i) % nodes.size()], nodes[(first + i + 1) % nodes.size()]};
}

bool isSoundFan(Positions positions, const Nodes& nodes, const Eigen::Vector3d& normal, std::size_t first)
{
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        if (sideAlong(positions, fanTriangle(nodes, first, i), normal) <= 0)
            return false;
    return true;
}

/// Beyond that only the first fan and few others are tried: no mesh has such faces.
constexpr std::size_t mostFanned = 200;
/// Of a face whose corners are cut off one by one.
constexpr std::size_t mostEars = 64;

/// From where a face is fanned; nothing if every fan has a triangle that is flat or turned over.
std::optional<std::size_t> fanOf(Positions positions, const Nodes& nodes, const Eigen::Vector3d& normal)
{
    std::vector<std::size_t> places(nodes.size());
    std::iota(places.begin(), places.end(), std::size_t(0));
    std::ranges::sort(places, {}, [&](std::size_t place) { return nodes[place]; });
    places.resize(std::min(places.size(), mostFanned));
    const auto sound =
        std::ranges::find_if(places, [&](std::size_t place) { return isSoundFan(positions, nodes, normal, place); });
    return sound == places.end() ? std::nullopt : std::optional(*sound);
}

/// Whether what the corner at `tip` and its neighbours span can be cut off.
bool isEar(Positions positions, const Nodes& nodes, const Eigen::Vector3d& normal, std::size_t tip)
{
    const std::size_t count = nodes.size();
    const Triangle ear = {nodes[(tip + count - 1) % count], nodes[tip], nodes[(tip + 1) % count]};
    if (sideAlong(positions, ear, normal) <= 0)
        return false;
    return std::ranges::none_of(nodes, [&](std::uint32_t node) {
        if (std::ranges::count(ear, node) != 0)
            return false;
        return sideAlong(positions, {ear[0], ear[1], node}, normal) >= 0 &&
               sideAlong(positions, {ear[1], ear[2], node}, normal) >= 0 &&
               sideAlong(positions, {ear[2], ear[0], node}, normal) >= 0;
    });
}

/// Cuts corners off, always that with the smallest node that can be. Nothing if the rest has none.
std::optional<CellSurface> cutEars(Positions positions, Nodes nodes, const Eigen::Vector3d& normal)
{
    CellSurface triangles;
    if (nodes.size() > mostEars)
        return std::nullopt;
    while (nodes.size() >= 3) {
        std::optional<std::size_t> best;
        for (std::size_t tip = 0; tip < nodes.size(); ++tip)
            if ((!best || nodes[tip] < nodes[*best]) && isEar(positions, nodes, normal, tip))
                best = tip;
        if (!best)
            return std::nullopt;
        const std::size_t count = nodes.size();
        triangles.push_back({nodes[(*best + count - 1) % count], nodes[*best], nodes[(*best + 1) % count]});
        nodes.erase(nodes.begin() + static_cast<std::ptrdiff_t>(*best));
    }
    return triangles;
}

CellSurface fan(const Nodes& nodes, std::size_t first)
{
    CellSurface triangles;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i)
        triangles.push_back(fanTriangle(nodes, first, i));
    return triangles;
}

/// Of a face that is no quadrilateral; the plain fan if there is no good one, so that its cells have no cut.
CellSurface cutFace(Positions positions, const Nodes& nodes)
{
    if (nodes.size() == 3)
        return fan(nodes, 0);
    const Eigen::Vector3d normal = faceNormal(positions, nodes);
    if (const auto first = fanOf(positions, nodes, normal))
        return fan(nodes, *first);
    const auto ears = cutEars(positions, nodes, normal);
    return ears ? *ears : fan(nodes, 0);
}

CellPolygon quadrilateralOf(std::span<const std::uint32_t> face)
{
    return {{face[0], face[1], face[2], face[3]}, 4};
}

/// Appends the triangles of a face, in its own orientation.
void addFace(Positions positions, std::span<const std::uint32_t> face, const OtherDiagonal& other,
             CellSurface& triangles)
{
    const CanonicalFace canonical = canonicalFace(face);
    const std::size_t first = triangles.size();
    const bool isTurned = face.size() == 4 && other && other(quadrilateralOf(face));
    for (const Triangle& triangle :
         face.size() == 4 ? fan(canonical.nodes, isTurned ? 1 : 0) : cutFace(positions, canonical.nodes))
        triangles.push_back(triangle);
    if (canonical.isReversed)
        for (Triangle& triangle : std::span(triangles).subspan(first))
            std::swap(triangle[1], triangle[2]);
}

/// How faces hang together by their edges.
class FaceGraph {
public:
    /// Whether the faces are one closed surface; then they are turned so that all look outwards, or all inwards.
    bool orient(std::vector<Nodes>& faces)
    {
        for (std::uint32_t face = 0; face < faces.size(); ++face)
            if (!addSides(faces[face], face))
                return false;
        if (!match())
            return false;
        return turn(faces);
    }

private:
    struct Side {
        EdgeKey edge = 0;
        std::uint32_t face = 0;
        bool rises = false; ///< the face runs from the edge's smaller node to the larger one
    };

    /// False if the face has a node twice.
    bool addSides(const Nodes& nodes, std::uint32_t face)
    {
        first_.push_back(static_cast<std::uint32_t>(sides_.size()));
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const std::uint32_t from = nodes[i], to = nodes[(i + 1) % nodes.size()];
            sides_.push_back({edgeKey(from, to), face, from < to});
        }
        Nodes sorted = nodes;
        std::ranges::sort(sorted);
        return std::ranges::adjacent_find(sorted) == sorted.end();
    }

    /// False unless each edge is in two faces.
    bool match()
    {
        std::vector<std::uint32_t> order(sides_.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::sort(order, {}, [&](std::uint32_t side) { return sides_[side].edge; });
        partners_.resize(sides_.size());
        if (order.size() % 2 != 0)
            return false;
        for (std::size_t i = 0; i < order.size(); i += 2) {
            const EdgeKey edge = sides_[order[i]].edge;
            if (sides_[order[i + 1]].edge != edge || (i + 2 < order.size() && sides_[order[i + 2]].edge == edge))
                return false;
            partners_[order[i]] = order[i + 1];
            partners_[order[i + 1]] = order[i];
        }
        return true;
    }

    /// False for several surfaces, and for one with a single side.
    bool turn(std::vector<Nodes>& faces) const
    {
        enum State : std::uint8_t { Unseen, Kept, Turned };
        std::vector<State> states(faces.size(), Unseen);
        std::vector<std::uint32_t> waiting{0};
        states[0] = Kept;
        std::size_t seen = 1;
        while (!waiting.empty()) {
            const std::uint32_t face = waiting.back();
            waiting.pop_back();
            for (std::size_t i = 0; i < faces[face].size(); ++i) {
                const std::uint32_t side = first_[face] + static_cast<std::uint32_t>(i);
                const Side& beyond = sides_[partners_[side]];
                const bool alike = sides_[side].rises == beyond.rises; // then one of the two is turned
                const State wanted = (states[face] == Turned) != alike ? Turned : Kept;
                if (states[beyond.face] == Unseen) {
                    states[beyond.face] = wanted;
                    waiting.push_back(beyond.face);
                    ++seen;
                } else if (states[beyond.face] != wanted) {
                    return false;
                }
            }
        }
        for (std::size_t face = 0; face < faces.size(); ++face)
            if (states[face] == Turned)
                std::ranges::reverse(faces[face]);
        return seen == faces.size();
    }

    std::vector<std::uint32_t> first_; ///< of each face's sides
    std::vector<Side> sides_;
    std::vector<std::uint32_t> partners_; ///< the side against each
};

double volume6(Positions positions, const CellSurface& surface)
{
    const Eigen::Vector3d& origin = positions[surface[0][0]];
    double volume = 0;
    for (const auto& [a, b, c] : surface)
        volume += (positions[a] - origin).dot((positions[b] - origin).cross(positions[c] - origin));
    return volume;
}

bool hasArea(Positions positions, const Triangle& triangle)
{
    return sideAlong(positions, triangle, Eigen::Vector3d::UnitX()) != 0 ||
           sideAlong(positions, triangle, Eigen::Vector3d::UnitY()) != 0 ||
           sideAlong(positions, triangle, Eigen::Vector3d::UnitZ()) != 0;
}

/// Whether all points lie in a plane. Exact.
bool isFlat(Positions positions, const CellSurface& surface)
{
    const auto base =
        std::ranges::find_if(surface, [&](const Triangle& triangle) { return hasArea(positions, triangle); });
    return base == surface.end() || std::ranges::all_of(surface, [&](const Triangle& other) {
               return std::ranges::all_of(other, [&](std::uint32_t node) {
                   return orientation(positions, {(*base)[0], (*base)[1], (*base)[2], node}) == 0;
               });
           });
}

} // namespace

bool needsOtherDiagonal(Positions positions, const CellPolygon& quadrilateral)
{
    const Nodes nodes = canonicalFace(std::span(quadrilateral.nodes).first(4)).nodes;
    const Eigen::Vector3d normal = faceNormal(positions, nodes);
    return !isSoundFan(positions, nodes, normal, 0) && isSoundFan(positions, nodes, normal, 1);
}

std::vector<CellPolygon> quadrilateralsOf(std::span<const std::uint32_t> faces)
{
    std::vector<CellPolygon> quadrilaterals;
    (void)forFaces(faces, [&](std::span<const std::uint32_t> face) {
        if (face.size() == 4)
            quadrilaterals.push_back(quadrilateralOf(face));
    });
    return quadrilaterals;
}

PolyhedronSurface polyhedronSurface(Positions positions, std::span<const std::uint32_t> faces,
                                    const OtherDiagonal& other)
{
    std::vector<Nodes> oriented;
    (void)forFaces(faces,
                   [&](std::span<const std::uint32_t> face) { oriented.emplace_back(face.begin(), face.end()); });
    PolyhedronSurface surface;
    if (oriented.empty() || !FaceGraph().orient(oriented)) {
        surface.kind = PolyhedronSurface::Kind::Open;
        return surface;
    }
    for (const Nodes& face : oriented)
        addFace(positions, face, other, surface.triangles);
    const double volume = volume6(positions, surface.triangles);
    if (volume < 0)
        for (Triangle& triangle : surface.triangles)
            std::swap(triangle[1], triangle[2]);
    // Rounding may make a volume of none; only where it is small that is looked at.
    constexpr double small = 1e-12;
    double size = 0;
    for (const auto& [a, b, c] : surface.triangles)
        size = std::max({size, (positions[a] - positions[b]).norm(), (positions[a] - positions[c]).norm()});
    if (std::abs(volume) <= small * size * size * size && isFlat(positions, surface.triangles))
        surface.kind = PolyhedronSurface::Kind::Flat;
    return surface;
}

namespace {

/// Of one cell: far more than any needs that is no garbage.
constexpr std::uint64_t mostLooks = 1 << 22;

bool seesOthers(Positions positions, const CellSurface& surface, std::uint32_t corner, std::uint64_t& looksLeft)
{
    return std::ranges::all_of(surface, [&](const Triangle& triangle) {
        if (looksLeft == 0)
            return false;
        --looksLeft;
        return std::ranges::count(triangle, corner) != 0 ||
               orientation(positions, {triangle[0], triangle[2], triangle[1], corner}) > 0;
    });
}

} // namespace

std::optional<CellPieces> cutFromCorner(Positions positions, std::span<const std::uint32_t> corners,
                                        const CellSurface& surface)
{
    std::uint64_t looksLeft = mostLooks;
    const auto corner = std::ranges::find_if(
        corners, [&](std::uint32_t node) { return seesOthers(positions, surface, node, looksLeft); });
    if (corner == corners.end())
        return std::nullopt;
    CellPieces pieces;
    for (const Triangle& triangle : surface)
        if (std::ranges::count(triangle, *corner) == 0)
            pieces.push_back({triangle[0], triangle[2], triangle[1], *corner});
    return pieces;
}

bool seesAll(Positions positions, const CellSurface& surface, const Eigen::Vector3d& point)
{
    return std::ranges::all_of(surface, [&](const Triangle& triangle) {
        return orientation(positions[triangle[0]], positions[triangle[2]], positions[triangle[1]], point) > 0;
    });
}

CellPieces cutFromPoint(const CellSurface& surface, std::uint32_t point)
{
    CellPieces pieces;
    for (const Triangle& triangle : surface)
        pieces.push_back({triangle[0], triangle[2], triangle[1], point});
    return pieces;
}

Eigen::Vector3d meanOf(Positions positions, std::span<const std::uint32_t> points)
{
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : points)
        mean += positions[point] / static_cast<double>(points.size());
    return mean;
}

namespace {

/// The planes of triangles.
struct Plane {
    Eigen::Vector3d inward;
    Eigen::Vector3d place;
    double depthOf(const Eigen::Vector3d& point) const { return inward.dot(point - place); }
};

std::vector<Plane> planesOf(Positions positions, const CellSurface& surface)
{
    std::vector<Plane> planes;
    for (const auto& [a, b, c] : surface) {
        const Eigen::Vector3d normal = (positions[c] - positions[a]).cross(positions[b] - positions[a]);
        if (const double length = normal.stableNorm(); length > 0 && std::isfinite(length))
            planes.push_back({normal / length, positions[a]});
    }
    return planes;
}

} // namespace

std::optional<Eigen::Vector3d> pointInside(Positions positions, std::span<const std::uint32_t> corners,
                                           const CellSurface& surface)
{
    Eigen::Vector3d point = meanOf(positions, corners);
    if (seesAll(positions, surface, point))
        return point;
    // The depth behind the plane that is nearest, or passed, is a concave function: steps away from that plane, ever
    // shorter ones, lead to its maximum.
    constexpr int steps = 1000;
    const std::vector<Plane> planes = planesOf(positions, surface);
    if (planes.empty())
        return std::nullopt;
    double size = 0;
    for (const std::uint32_t corner : corners)
        size = std::max(size, (positions[corner] - point).norm());
    Eigen::Vector3d best = point;
    double deepest = -size;
    for (int step = 0; step < steps; ++step) {
        const auto nearest =
            std::ranges::min_element(planes, {}, [&](const Plane& plane) { return plane.depthOf(point); });
        if (const double depth = nearest->depthOf(point); depth > deepest) {
            deepest = depth;
            best = point;
        }
        point += size / (step + 2) * nearest->inward;
    }
    return seesAll(positions, surface, best) ? std::optional(best) : std::nullopt;
}

double valueAmong(Positions positions, std::span<const std::uint32_t> points, std::span<const double> values,
                  const Eigen::Vector3d& place)
{
    const Eigen::Vector3d middle = meanOf(positions, points);
    double mean = 0, size = 0, lowest = values[points[0]], highest = lowest;
    for (const std::uint32_t point : points) {
        mean += values[point] / static_cast<double>(points.size());
        size = std::max(size, (positions[point] - middle).norm());
        lowest = std::min(lowest, values[point]);
        highest = std::max(highest, values[point]);
    }
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    Eigen::Vector3d rise = Eigen::Vector3d::Zero();
    for (const std::uint32_t point : points) {
        const Eigen::Vector3d from = (positions[point] - middle) / size;
        spread += from * from.transpose();
        rise += from * (values[point] - mean);
    }
    const Eigen::Vector3d slope = spread.fullPivLu().solve(rise);
    const double value = mean + slope.dot((place - middle) / size);
    return std::clamp(std::isfinite(value) ? value : mean, lowest, highest);
}

} // namespace tetra
