// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/irregular_original.h"

#include "core/base/disjoint_sets.h"
#include "core/verify/scattered_cells.h"

#include <Eigen/Geometry>

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

std::vector<SurfaceEdge> sortedEdges(std::span<const PointTriangle> triangles)
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

/// The vertices of each triangle whose corners fall into more than one fan, sorted.
std::vector<std::uint32_t> verticesOfManyFans(std::span<const PointTriangle> triangles, DisjointSets& fans)
{
    std::vector<std::array<std::uint32_t, 2>> roots; // of a vertex
    for (std::uint32_t corner = 0; corner < 3 * triangles.size(); ++corner)
        roots.push_back({triangles[corner / 3][corner % 3], fans.root(corner)});
    std::ranges::sort(roots);
    roots.erase(std::ranges::unique(roots).begin(), roots.end());
    std::vector<std::uint32_t> broken;
    for (std::size_t i = 1; i < roots.size(); ++i)
        if (roots[i][0] == roots[i - 1][0] && (broken.empty() || broken.back() != roots[i][0]))
            broken.push_back(roots[i][0]);
    return broken;
}

/// Numbers the surfaces in the order of their first triangles, and counts what they have: every fan is a vertex.
void nameSurfaces(std::size_t triangleCount, DisjointSets& joined, DisjointSets& fans, BoundarySurfaces& found)
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
    std::vector<std::int64_t> triangles(found.surfaces.size());
    for (std::uint32_t triangle = 0; triangle < triangleCount; ++triangle)
        ++triangles[found.surfaceOf[triangle]];
    for (std::size_t surface = 0; surface < triangles.size(); ++surface)
        found.surfaces[surface].euler = triangles[surface] - 3 * triangles[surface] / 2;
    for (std::uint32_t corner = 0; corner < 3 * triangleCount; ++corner)
        if (fans.root(corner) == corner)
            ++found.surfaces[found.surfaceOf[corner / 3]].euler;
}

} // namespace

BoundarySurfaces boundarySurfaces(std::span<const PointTriangle> triangles)
{
    BoundarySurfaces found;
    const std::vector<SurfaceEdge> edges = sortedEdges(triangles);
    DisjointSets joined(triangles.size());
    DisjointSets fans(3 * triangles.size());
    for (auto begin = edges.begin(); begin != edges.end();) {
        const auto end =
            std::find_if(begin, edges.end(), [&](const SurfaceEdge& edge) { return edge.points != begin->points; });
        if (end - begin == 2 && begin->turned != (end - 1)->turned) {
            joined.join(begin->triangle, (end - 1)->triangle);
            joinFans(*begin, *(end - 1), fans);
        } else {
            found.brokenEdges.push_back(begin->points);
        }
        begin = end;
    }
    if (found.brokenEdges.empty())
        found.brokenVertices = verticesOfManyFans(triangles, fans);
    nameSurfaces(triangles.size(), joined, fans, found);
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

TriangleTree::TriangleTree(std::span<const Eigen::Vector3d> positions, std::span<const PointTriangle> triangles)
    : positions_(positions), triangles_(triangles),
      tree_(
          triangles.size(), [this](std::uint32_t triangle) { return boxOf(triangle); },
          [this](std::uint32_t triangle, Eigen::Index axis) {
              const auto [a, b, c] = corners(triangle);
              return a[axis] + b[axis] + c[axis];
          })
{
}

Eigen::AlignedBox3d TriangleTree::boxOf(std::uint32_t triangle) const
{
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3d& corner : corners(triangle))
        box.extend(corner);
    return box;
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& from) const
{
    return nearestOf(from, {});
}

TriangleTree::Nearest TriangleTree::nearest(const Eigen::Vector3d& from, std::uint32_t hint) const
{
    return nearestOf(from, {hint, nearestPlace(corners(hint), from)});
}

TriangleTree::Nearest TriangleTree::nearestOf(const Eigen::Vector3d& from, Nearest best) const
{
    tree_.visitNearer(
        from, [&best] { return best.place.distance; },
        [&](std::uint32_t triangle) {
            if (const TrianglePlace place = nearestPlace(corners(triangle), from); place.distance < best.place.distance)
                best = {triangle, place};
        });
    return best;
}

namespace {

std::vector<PointTriangle> boundaryOf(const Dataset& dataset, std::vector<std::string>& failures)
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
    std::vector<PointTriangle> triangles;
    triangles.reserve(faces.size());
    for (const BoundaryFace& face : faces)
        triangles.push_back(face.vertices);
    return triangles;
}

std::vector<std::uint32_t> surfacesOfPoints(std::size_t points, std::span<const PointTriangle> boundary,
                                            const BoundarySurfaces& surfaces)
{
    std::vector<std::uint32_t> surfaceOf(points, IrregularOriginal::none);
    for (std::size_t triangle = 0; triangle < boundary.size(); ++triangle)
        for (const std::uint32_t point : boundary[triangle])
            surfaceOf[point] = surfaces.surfaceOf[triangle];
    return surfaceOf;
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

IrregularOriginal::IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures)
    : points(dataset), boundary(boundaryOf(dataset, failures)), surfaces(boundarySurfaces(boundary)),
      surfaceOf(surfacesOfPoints(dataset.pointCount(), boundary, surfaces)), componentOf(componentsOfPoints(dataset)),
      tree(points.positions, boundary)
{
    const Eigen::AlignedBox3d bounds = dataset.bounds();
    diagonal = bounds.diagonal().norm();
    const double farthest = std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    allowance = 1e-12 * diagonal + 0x1p-44 * farthest;
    if (!surfaces.isManifold())
        failures.emplace_back("The boundary of the dataset is no manifold.");
}

} // namespace tetra
