// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/irregular_original.h"

#include "core/base/disjoint_sets.h"
#include "core/base/sort_unique.h"
#include "core/verify/level_cells.h"
#include "core/verify/touching_points.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {

namespace {

/// An edge as one of its triangles has it.
struct SurfaceEdge {
    std::array<std::uint32_t, 2> points; ///< the smaller number first
    bool turned;                         ///< it runs from the larger one to the smaller
    std::uint32_t triangle;
    std::uint32_t corner; ///< of the triangle, where it begins

    auto operator<=>(const SurfaceEdge&) const = default;
};

std::vector<SurfaceEdge> sortedEdges(std::span<const Triangle> triangles)
{
    std::vector<SurfaceEdge> edges;
    edges.reserve(3 * triangles.size());
    for (std::uint32_t triangle = 0; triangle < triangles.size(); ++triangle)
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t from = triangles[triangle][corner], to = triangles[triangle][(corner + 1) % 3];
            edges.push_back({{std::min(from, to), std::max(from, to)}, from > to, triangle, corner});
        }
    std::ranges::sort(edges);
    return edges;
}

/// Fans: the corners of triangles that follow each other around a vertex.
void joinFans(const SurfaceEdge& first, const SurfaceEdge& second, DisjointSets& fans)
{
    // The edge begins in one triangle where it ends in the other.
    const auto corner = [](const SurfaceEdge& edge, std::uint32_t step) {
        return 3 * edge.triangle + (edge.corner + step) % 3;
    };
    fans.join(corner(first, 0), corner(second, 1));
    fans.join(corner(first, 1), corner(second, 0));
}

/// The vertices whose triangles fall into more than one fan, and into how many.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pinchedVertices(std::span<const Triangle> triangles,
                                                                     DisjointSets& fans)
{
    std::vector<std::uint32_t> centres; // of each fan
    for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
        if (fans.root(corner) == corner)
            centres.push_back(triangles[corner / 3][corner % 3]);
    std::ranges::sort(centres);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pinched;
    for (auto begin = centres.begin(); begin != centres.end();) {
        const auto end = std::find_if(begin, centres.end(), [&](std::uint32_t vertex) { return vertex != *begin; });
        if (end - begin > 1)
            pinched.emplace_back(*begin, static_cast<std::uint32_t>(end - begin));
        begin = end;
    }
    return pinched;
}

/// Numbers the surfaces in the order of their first triangles, and counts what they have: every fan is a vertex, every
/// side of a seam an edge.
void nameSurfaces(std::size_t triangleCount, const std::vector<std::uint32_t>& sidesOfSeams, DisjointSets& joined,
                  DisjointSets& fans, BoundarySurfaces& found)
{
    constexpr std::uint32_t none = 0xffffffff;
    std::vector<std::uint32_t> names(triangleCount, none);
    for (std::uint32_t triangle = 0; triangle < triangleCount; ++triangle) {
        std::uint32_t& name = names[joined.root(triangle)];
        if (name == none) {
            name = static_cast<std::uint32_t>(found.surfaces.size());
            found.surfaces.push_back({triangle, 0});
        }
        found.surfaceOf.push_back(name);
    }
    std::vector<std::int64_t> triangles(found.surfaces.size()), sides(found.surfaces.size());
    for (std::uint32_t triangle = 0; triangle < triangleCount; ++triangle)
        ++triangles[found.surfaceOf[triangle]];
    for (const std::uint32_t triangle : sidesOfSeams)
        ++sides[found.surfaceOf[triangle]];
    for (std::size_t surface = 0; surface < triangles.size(); ++surface)
        found.surfaces[surface].euler = triangles[surface] - (3 * triangles[surface] + sides[surface]) / 2;
    for (std::uint32_t corner = 0; corner < 3 * triangleCount; ++corner)
        if (fans.root(corner) == corner)
            ++found.surfaces[found.surfaceOf[corner / 3]].euler;
}

} // namespace

BoundarySurfaces boundarySurfaces(std::span<const Triangle> triangles)
{
    BoundarySurfaces found;
    const std::vector<SurfaceEdge> edges = sortedEdges(triangles);
    DisjointSets joined(triangles.size());
    DisjointSets fans(3 * triangles.size());
    std::vector<std::uint32_t> sidesOfSeams; // the triangle of each
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end =
            std::find_if(begin, edges.end(), [&](const SurfaceEdge& edge) { return edge.points != begin->points; });
        if (end - begin == 2 && begin->turned != (end - 1)->turned) {
            joined.join(begin->triangle, (end - 1)->triangle);
            joinFans(*begin, *(end - 1), fans);
        } else {
            found.seams.emplace_back(begin->points, static_cast<std::uint32_t>(end - begin));
            for (auto side = begin; side != end; ++side)
                sidesOfSeams.push_back(side->triangle);
        }
        begin = end;
    }
    found.pinches = pinchedVertices(triangles, fans);
    nameSurfaces(triangles.size(), sidesOfSeams, joined, fans, found);
    return found;
}

namespace {

using SpacePlace = Eigen::Vector3d;

/// How far along the segment, from 0 to 1, its place next to `from` is.
double alongSegment(const SpacePlace& a, const SpacePlace& b, const SpacePlace& from)
{
    const SpacePlace edge = b - a;
    const double length = edge.squaredNorm();
    return length > 0 ? std::clamp(edge.dot(from - a) / length, 0.0, 1.0) : 0;
}

/// Weights of the place where the triangle's plane is next to `from`; negative ones lie outside.
std::array<double, 3> weightsInPlane(const TriangleCorners& t, const SpacePlace& from)
{
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double area = normal.squaredNorm();
    const double second = normal.dot((from - t[0]).cross(t[2] - t[0])) / area;
    const double third = normal.dot((t[1] - t[0]).cross(from - t[0])) / area;
    return {1 - second - third, second, third};
}

SpacePlace at(const TriangleCorners& t, const std::array<double, 3>& weights)
{
    return t[0] + weights[1] * (t[1] - t[0]) + weights[2] * (t[2] - t[0]);
}

bool areInside(const std::array<double, 3>& weights)
{
    return weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0;
}

/// The values at places that were found to be within the radius.
struct DistanceRange {
    const std::array<double, 3>& values;
    std::optional<std::array<double, 2>> range;

    void add(const std::array<double, 3>& weights)
    {
        const double value = values[0] + weights[1] * (values[1] - values[0]) + weights[2] * (values[2] - values[0]);
        if (!range)
            range = {value, value};
        (*range)[0] = std::min((*range)[0], value);
        (*range)[1] = std::max((*range)[1], value);
    }
};

/// Where an edge goes into and out of the ball, or its ends inside.
void addEdge(const TriangleCorners& t, std::size_t from, const SpacePlace& centre, double radius,
             DistanceRange& extremes)
{
    const std::size_t to = (from + 1) % 3;
    const SpacePlace edge = t[to] - t[from];
    const double length = edge.squaredNorm();
    if (!(length > 0))
        return;
    const double middle = edge.dot(centre - t[from]) / length;
    const double off = (t[from] + middle * edge - centre).squaredNorm();
    const double half = std::sqrt(std::max(0.0, radius * radius - off) / length);
    if (off > radius * radius || middle + half < 0 || middle - half > 1)
        return;
    for (const double along : {std::max(0.0, middle - half), std::min(1.0, middle + half)}) {
        std::array<double, 3> weights{};
        weights[from] = 1 - along;
        weights[to] = along;
        extremes.add(weights);
    }
}

/// Where the function is least and largest on the disc that the ball cuts out of the plane.
void addDisc(const TriangleCorners& t, const std::array<double, 3>& values, const SpacePlace& centre, double radius,
             DistanceRange& extremes)
{
    const std::array<double, 3> foot = weightsInPlane(t, centre);
    const double off = (at(t, foot) - centre).squaredNorm();
    if (!(off <= radius * radius))
        return;
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const SpacePlace gradient =
        ((values[1] - values[0]) * (t[2] - t[0]).cross(normal) + (values[2] - values[0]) * normal.cross(t[1] - t[0])) /
        normal.squaredNorm();
    const double steepness = gradient.norm();
    if (!(steepness > 0)) {
        if (areInside(foot))
            extremes.add(foot);
        return;
    }
    const double reach = std::sqrt(radius * radius - off) / steepness;
    for (const double sign : {-1.0, 1.0}) {
        const auto weights = weightsInPlane(t, at(t, foot) + sign * reach * gradient);
        if (areInside(weights))
            extremes.add(weights);
    }
}

} // namespace

TrianglePlace nearestPlace(const TriangleCorners& t, const SpacePlace& from)
{
    const std::array<double, 3> inPlane = weightsInPlane(t, from);
    if (areInside(inPlane))
        return {inPlane, (at(t, inPlane) - from).norm()};
    TrianglePlace best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = alongSegment(t[i], t[(i + 1) % 3], from);
        const double distance = (t[i] + along * (t[(i + 1) % 3] - t[i]) - from).norm();
        if (!(distance < best.distance))
            continue;
        best.weights = {};
        best.weights[i] = 1 - along;
        best.weights[(i + 1) % 3] = along;
        best.distance = distance;
    }
    return best;
}

std::optional<std::array<double, 2>> valuesWithin(const TriangleCorners& triangle, const std::array<double, 3>& values,
                                                  const SpacePlace& centre, double radius)
{
    DistanceRange extremes{values, {}};
    for (std::size_t corner = 0; corner < 3; ++corner)
        addEdge(triangle, corner, centre, radius, extremes);
    addDisc(triangle, values, centre, radius, extremes);
    return extremes.range;
}

namespace {

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
int axisToLeaveOut(const TriangleCorners& t)
{
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
    int best = 0;
    normal.maxCoeff(&best);
    for (const int axis : {best, (best + 1) % 3, (best + 2) % 3})
        if (sideInPlane(t[0], t[1], t[2], axis) != 0)
            return axis;
    return best;
}

bool holdsInPlane(const TriangleCorners& t, const SpacePlace& place, int out)
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
bool segmentMeetsInPlane(const SpacePlace& from, const SpacePlace& to, const TriangleCorners& t)
{
    const int out = axisToLeaveOut(t);
    return holdsInPlane(t, from, out) || holdsInPlane(t, to, out) || segmentsMeetInPlane(from, to, t[0], t[1], out) ||
           segmentsMeetInPlane(from, to, t[1], t[2], out) || segmentsMeetInPlane(from, to, t[2], t[0], out);
}

bool segmentMeets(const SpacePlace& from, const SpacePlace& to, const TriangleCorners& t)
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
    TriangleCorners first;
    TriangleCorners second;
    std::size_t shared = 0;
};

Pair pairOf(std::span<const SpacePlace> positions, Triangle first, Triangle second)
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
        const TriangleCorners& t = which == 0 ? pair.first : pair.second;
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
    const auto edges = [](const TriangleCorners& t) {
        return std::array<SpacePlace, 3>{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    };
    const auto first = edges(pair.first), second = edges(pair.second);
    double size = 0;
    for (const TriangleCorners* t : {&pair.first, &pair.second})
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
    const auto normal = [](const TriangleCorners& t) -> SpacePlace { return (t[1] - t[0]).cross(t[2] - t[0]); };
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

bool facesMeet(std::span<const SpacePlace> positions, const Triangle& first, const Triangle& second)
{
    const Pair pair = pairOf(positions, first, second);
    if (pair.shared == 2)
        return areFolded(pair);
    if (arePlainlyApart(pair))
        return false;
    const TriangleCorners& a = pair.first;
    const TriangleCorners& b = pair.second;
    // What two triangles with a common corner share besides it reaches to a side opposite to that corner.
    if (pair.shared == 1)
        return segmentMeets(a[1], a[2], b) || segmentMeets(b[1], b[2], a);
    for (std::size_t i = 0; i < 3; ++i)
        if (segmentMeets(a[i], a[(i + 1) % 3], b) || segmentMeets(b[i], b[(i + 1) % 3], a))
            return true;
    return false;
}

TriangleTree::TriangleTree(std::span<const Eigen::Vector3d> positions, std::span<const Triangle> triangles)
    : positions_(positions), triangles_(triangles),
      tree_(
          triangles.size(), [this](std::uint32_t triangle) { return boxOf(triangle); },
          [this](std::uint32_t triangle, Eigen::Index axis) {
              const auto [a, b, c] = corners(triangle);
              return a[axis] + b[axis] + c[axis];
          })
{
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& from, std::optional<std::uint32_t> hint) const
{
    Nearest best;
    if (hint)
        best = {*hint, nearestPlace(corners(*hint), from)};
    tree_.visitNearer(
        from, [&best] { return best.place.distance; },
        [&](std::uint32_t triangle) {
            if (const TrianglePlace place = nearestPlace(corners(triangle), from); place.distance < best.place.distance)
                best = {triangle, place};
        });
    return best;
}

namespace {

std::vector<Triangle> boundaryOf(const Dataset& dataset, std::vector<std::string>& failures)
{
    std::vector<std::uint32_t> points(dataset.pointCount());
    std::iota(points.begin(), points.end(), 0);
    const std::vector<LatticePoint> none;
    const LevelCells cells(points, none, {dataset.tetrahedra->begin(), dataset.tetrahedra->end()});
    const FaceRule rule{[](const auto&) { return true; },
                        [&](std::uint32_t point) { return textOf((*dataset.positions)[point]); }};
    std::vector<BoundaryFace> faces;
    LevelReport found;
    if (!verifyFaces(cells, rule, found, {}, &faces) || !found.conforming)
        failures.push_back("The dataset's own tetrahedra do not conform." +
                           (found.failures.empty() ? std::string() : " " + found.failures.front()));
    std::vector<Triangle> triangles;
    triangles.reserve(faces.size());
    for (const BoundaryFace& face : faces)
        triangles.push_back(face.vertices);
    return triangles;
}

std::vector<std::uint32_t> surfacesOfPoints(std::size_t points, std::span<const Triangle> boundary,
                                            const BoundarySurfaces& surfaces)
{
    std::vector<std::uint32_t> surfaceOf(points, IrregularOriginal::none);
    for (std::size_t triangle = 0; triangle < boundary.size(); ++triangle)
        for (const std::uint32_t point : boundary[triangle])
            surfaceOf[point] = surfaces.surfaceOf[triangle];
    return surfaceOf;
}

std::vector<std::array<std::uint32_t, 2>> surfacesOfPinches(std::span<const Triangle> boundary,
                                                            const BoundarySurfaces& surfaces)
{
    std::vector<std::array<std::uint32_t, 2>> result;
    for (std::size_t triangle = 0; triangle < boundary.size(); ++triangle)
        for (const std::uint32_t point : boundary[triangle])
            if (surfaces.isPinched(point))
                result.push_back({point, surfaces.surfaceOf[triangle]});
    sortUnique(result);
    return result;
}

std::vector<std::uint32_t> componentsOfPoints(const Dataset& dataset)
{
    DisjointSets joined(dataset.pointCount());
    for (const auto& tetrahedron : *dataset.tetrahedra)
        for (int corner = 1; corner < 4; ++corner)
            joined.join(tetrahedron[0], tetrahedron[corner]);
    std::vector<std::uint32_t> componentOf(dataset.pointCount());
    for (std::uint32_t point = 0; point < componentOf.size(); ++point)
        componentOf[point] = joined.root(point);
    return componentOf;
}

} // namespace

ScatteredOriginal::ScatteredOriginal(const Dataset& dataset)
    : positions(*dataset.positions), values(dataset.pointCount()),
      tree(
          positions.size(),
          [this](std::uint32_t point) { return Eigen::AlignedBox3d(positions[point], positions[point]); },
          [this](std::uint32_t point, Eigen::Index axis) { return positions[point][axis]; })
{
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
}

IrregularOriginal::IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures)
    : points(dataset), boundary(boundaryOf(dataset, failures)), surfaces(boundarySurfaces(boundary)),
      surfaceOf(surfacesOfPoints(dataset.pointCount(), boundary, surfaces)),
      atPinches(surfacesOfPinches(boundary, surfaces)), componentOf(componentsOfPoints(dataset)),
      touching(touchingPoints(points.positions, *dataset.tetrahedra, boundary)), faces(boundary),
      tree(points.positions, boundary), diagonal(dataset.bounds().diagonal().norm())
{
    for (Triangle& face : faces)
        std::ranges::sort(face);
    std::ranges::sort(faces);
}

namespace {

constexpr double relativeTolerance = 0.05;
constexpr double leastOfDiagonal = 1e-3;
constexpr int mostCuts = 8; ///< a triangle becomes at most 4^8 pieces

/// A piece of a triangle, to be looked at.
struct TrianglePiece {
    TriangleCorners corners;
    std::uint32_t hint = 0; ///< a triangle that may be near
    int cuts = 0;
};

Eigen::Vector3d middleOf(const TriangleCorners& t)
{
    return (t[0] + t[1] + t[2]) / 3;
}

class Search {
public:
    Search(const IrregularOriginal& original, double found)
        : tree_(original.tree), least_(leastOfDiagonal * original.diagonal), result_{found, found}
    {
    }

    BoundaryDistances run(const TriangleCorners& triangle)
    {
        waiting_ = {{triangle, tree_.nearest(middleOf(triangle)).triangle, 0}};
        while (!waiting_.empty()) {
            const TrianglePiece piece = waiting_.back();
            waiting_.pop_back();
            look(piece);
        }
        return result_;
    }

private:
    void look(const TrianglePiece& piece)
    {
        const Eigen::Vector3d middle = middleOf(piece.corners);
        const TriangleTree::Nearest nearest = tree_.nearest(middle, piece.hint);
        result_.found = std::max(result_.found, nearest.place.distance);
        // Distances change no faster than places; that to one triangle, which is convex, is largest at a corner.
        const TriangleCorners next = tree_.corners(nearest.triangle);
        double size = 0;
        double atCorners = 0;
        for (const Eigen::Vector3d& corner : piece.corners) {
            size = std::max(size, (corner - middle).norm());
            atCorners = std::max(atCorners, nearestPlace(next, corner).distance);
        }
        const double bound = std::min(nearest.place.distance + size, atCorners);
        if (bound > std::max((1 + relativeTolerance) * result_.found, least_) && piece.cuts < mostCuts)
            cut(piece, nearest.triangle);
        else
            result_.bound = std::max(result_.bound, bound);
    }

    void cut(const TrianglePiece& piece, std::uint32_t hint)
    {
        const TriangleCorners& c = piece.corners;
        const Eigen::Vector3d ab = (c[0] + c[1]) / 2, bc = (c[1] + c[2]) / 2, ca = (c[2] + c[0]) / 2;
        for (const TriangleCorners& part : {TriangleCorners{c[0], ab, ca}, TriangleCorners{ab, c[1], bc},
                                            TriangleCorners{ca, bc, c[2]}, TriangleCorners{ab, bc, ca}})
            waiting_.push_back({part, hint, piece.cuts + 1});
    }

    const TriangleTree& tree_;
    double least_;
    BoundaryDistances result_;
    std::vector<TrianglePiece> waiting_;
};

} // namespace

BoundaryDistances distancesToOriginal(const IrregularOriginal& original, std::span<const Triangle> triangles)
{
    std::vector<TriangleCorners> others;
    for (const Triangle& t : triangles)
        if (!original.isFace(t)) // which is nowhere far from it
            others.push_back(
                {original.points.positions[t[0]], original.points.positions[t[1]], original.points.positions[t[2]]});
    std::vector<BoundaryDistances> found(others.size());
    tbb::parallel_for(std::size_t(0), others.size(), [&](std::size_t number) {
        found[number].found = original.tree.nearest(middleOf(others[number])).place.distance;
    });
    const auto largest = [&](double BoundaryDistances::*which) {
        double most = 0;
        for (const BoundaryDistances& one : found)
            most = std::max(most, one.*which);
        return most;
    };
    const double atMiddles = largest(&BoundaryDistances::found);
    tbb::parallel_for(std::size_t(0), others.size(),
                      [&](std::size_t number) { found[number] = Search(original, atMiddles).run(others[number]); });
    return {largest(&BoundaryDistances::found), largest(&BoundaryDistances::bound)};
}

} // namespace tetra
