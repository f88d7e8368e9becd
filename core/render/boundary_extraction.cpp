// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/disjoint_sets.h"
#include "core/base/guarded.h"
#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

#include <tan/render.h>

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr MarkedText findingBoundary = Message::marked("Finding the boundary");
constexpr std::size_t largestTriangleCount = 0xffffffff / 3; // corners have numbers

Error tooManyFaces()
{
    return {
        ErrorKind::OutOfResource,
        Message::say("The mesh has too many tetrahedra for its boundary to be shown. Lower the accuracy of the mesh.")};
}

/// An edge as one of its triangles has it. Corner c of triangle t has the number 3 t + c.
struct EdgeSide {
    EdgeKey ends;
    std::uint32_t corner; ///< that the edge begins at, seen from the triangle
    auto operator<=>(const EdgeSide&) const = default;
};

constexpr std::uint32_t nextCorner(std::uint32_t corner)
{
    return corner % 3 == 2 ? corner - 2 : corner + 1;
}

/// The boundary while its vertices are being made.
struct Boundary {
    std::span<const Triangle> triangles; ///< of vertices of the mesh's boundary
    Buffer<Eigen::Vector3d> corners;     ///< the place of each corner
    Buffer<Eigen::Vector3d> normals;     ///< of each triangle, of length one; zero if it has no area

    std::uint32_t vertexOf(std::uint32_t corner) const { return triangles[corner / 3][corner % 3]; }
    double angleAt(std::uint32_t corner) const;
};

double Boundary::angleAt(std::uint32_t corner) const
{
    const std::uint32_t next = nextCorner(corner);
    const Eigen::Vector3d one = corners[next] - corners[corner];
    const Eigen::Vector3d other = corners[nextCorner(next)] - corners[corner];
    return std::atan2(one.cross(other).norm(), one.dot(other));
}

Boundary boundaryOf(std::span<const Triangle> triangles, const auto& placeOf)
{
    Boundary boundary{triangles, Buffer<Eigen::Vector3d>(3 * triangles.size()),
                      Buffer<Eigen::Vector3d>(triangles.size())};
    tbb::parallel_for(std::size_t(0), triangles.size(), [&](std::size_t t) {
        Eigen::Vector3d* corners = &boundary.corners[3 * t];
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = placeOf(triangles[t][c]);
        // stableNormalized() leaves zero as it is.
        boundary.normals[t] = (corners[1] - corners[0]).cross(corners[2] - corners[0]).stableNormalized();
    });
    return boundary;
}

Buffer<EdgeSide> sortedSides(const Boundary& boundary)
{
    Buffer<EdgeSide> sides(boundary.corners.size());
    tbb::parallel_for(std::uint32_t(0), static_cast<std::uint32_t>(sides.size()), [&](std::uint32_t corner) {
        sides[corner] = {edgeKey(boundary.vertexOf(corner), boundary.vertexOf(nextCorner(corner))), corner};
    });
    tbb::parallel_sort(sides.begin(), sides.end());
    return sides;
}

/// Joins the corners that two triangles have at their common edge, where the boundary is smooth there.
DisjointSets smoothCorners(const Boundary& boundary, double featureAngle)
{
    const double smallestCosine = std::cos(featureAngle * std::numbers::pi / 180);
    const auto isSmooth = [&](std::uint32_t one, std::uint32_t other) {
        return featureAngle > 0 && boundary.normals[one / 3].dot(boundary.normals[other / 3]) >= smallestCosine;
    };
    DisjointSets joined(boundary.corners.size());
    const Buffer<EdgeSide> sides = sortedSides(boundary);
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end =
            std::find_if(begin, sides.end(), [&](const EdgeSide& side) { return side.ends != begin->ends; });
        const std::uint32_t one = begin->corner, other = (end - 1)->corner;
        // The edge begins in one triangle where it ends in the other.
        if (end - begin == 2 && boundary.vertexOf(one) == boundary.vertexOf(nextCorner(other)) &&
            isSmooth(one, other)) {
            joined.join(one, nextCorner(other));
            joined.join(nextCorner(one), other);
        }
        begin = end;
    }
    return joined;
}

/// Makes a vertex of each set of corners.
TriangleMesh surfaceOf(const Boundary& boundary, DisjointSets& joined, const auto& valueOf)
{
    TriangleMesh surface;
    surface.triangles.resize(boundary.triangles.size());
    Buffer<std::uint32_t> numbers(boundary.corners.size()); // of the corners that are roots, which come first
    std::vector<Eigen::Vector3d> normals;
    for (std::uint32_t corner = 0; corner < numbers.size(); ++corner) {
        const std::uint32_t root = joined.root(corner);
        if (root == corner) {
            numbers[corner] = static_cast<std::uint32_t>(normals.size());
            normals.emplace_back(0, 0, 0);
            surface.positions.push_back(boundary.corners[corner]);
            surface.values.push_back(valueOf(boundary.vertexOf(corner)));
        }
        const std::uint32_t vertex = numbers[root];
        surface.triangles[corner / 3][corner % 3] = vertex;
        normals[vertex] += boundary.angleAt(corner) * boundary.normals[corner / 3];
    }
    surface.normals.reserve(normals.size());
    for (const Eigen::Vector3d& normal : normals)
        surface.normals.push_back(normal.isZero(0) ? Eigen::Vector3f::UnitZ().eval()
                                                   : normal.stableNormalized().cast<float>().eval());
    return surface;
}

Result<TriangleMesh> boundaryOfMesh(const TetrahedralMesh& mesh, double featureAngle, const Progress& progress)
{
    const BoundaryFaces faces = boundaryFaces(mesh.positions.size(), mesh.tetrahedra);
    if (faces.triangles.size() > largestTriangleCount)
        return tooManyFaces();
    if (progress.cancelled())
        return cancelledError(findingBoundary);
    progress.report(0.5, findingBoundary);
    const Boundary boundary = boundaryOf(faces.triangles, [&](std::uint32_t vertex) -> Eigen::Vector3d {
        return mesh.positions[faces.vertices[vertex]];
    });
    DisjointSets joined = smoothCorners(boundary, featureAngle);
    if (progress.cancelled())
        return cancelledError(findingBoundary);
    TriangleMesh surface =
        surfaceOf(boundary, joined, [&](std::uint32_t vertex) { return mesh.values[faces.vertices[vertex]]; });
    progress.report(1, findingBoundary);
    return surface;
}

constexpr MarkedText noMemoryForBoundary =
    Message::marked("Not enough memory for the boundary of the mesh. Lower the accuracy of the mesh.");

} // namespace

Result<TriangleMesh> extractBoundary(const TetrahedralMesh& mesh, double featureAngle, const Progress& progress)
{
    progress.report(0, findingBoundary);
    if (mesh.tetrahedra.size() > largestAdjacentCellCount)
        return tooManyFaces();
    return guarded(noMemoryForBoundary, [&] { return boundaryOfMesh(mesh, featureAngle, progress); });
}

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Colour mixedColour(const Colour& one, const Colour& other, float part)
{
    return {std::lerp(one.red, other.red, part), std::lerp(one.green, other.green, part),
            std::lerp(one.blue, other.blue, part)};
}

/// Values in whose range the colour is linear.
struct ColourSpan {
    double least = -unbounded;
    double largest = unbounded;
    Colour atLeast;
    Colour atLargest;

    Colour at(double value) const
    {
        if (!(largest - least < unbounded))
            return atLeast; // beyond the first and the last point
        return mixedColour(atLeast, atLargest, static_cast<float>((value - least) / (largest - least)));
    }
};

Colour colourOf(const ColourPoint& point)
{
    return {point.colour[0], point.colour[1], point.colour[2]};
}

/// From below the first point to above the last; none is empty.
std::vector<ColourSpan> spansOf(const TransferFunction& function)
{
    const auto& points = function.colours;
    std::vector<ColourSpan> spans{{-unbounded, points.front().value, colourOf(points.front()), {}}};
    for (std::size_t i = 1; i < points.size(); ++i)
        if (points[i - 1].value < points[i].value)
            spans.push_back({points[i - 1].value, points[i].value, colourOf(points[i - 1]), colourOf(points[i])});
    spans.push_back({points.back().value, unbounded, colourOf(points.back()), {}});
    return spans;
}

/// The span of a value: the upper one at a point, as of the transfer function itself.
std::size_t spanOf(std::span<const ColourSpan> spans, double value)
{
    const auto above = std::ranges::upper_bound(spans, value, {}, &ColourSpan::least);
    return above == spans.begin() ? 0 : static_cast<std::size_t>(above - spans.begin()) - 1;
}

/// A corner of a piece of a triangle.
struct ColouredCorner {
    Eigen::Vector3d position;
    Eigen::Vector3f normal;
    double value;
    std::uint32_t vertex; ///< of the surface, or `cut`
};
constexpr std::uint32_t isNewVertex = 0xffffffff;

/// On the edge from one to the other, reckoned from the smaller value, so that both its triangles get the same place.
ColouredCorner cornerAt(double value, const ColouredCorner* one, const ColouredCorner* other)
{
    if (one->value > other->value)
        std::swap(one, other);
    const double part = (value - one->value) / (other->value - one->value);
    const auto single = static_cast<float>(part);
    return {one->position + part * (other->position - one->position),
            one->normal + single * (other->normal - one->normal), value, isNewVertex};
}

/// What of a convex polygon has values on one side of `value`.
std::vector<ColouredCorner> sideOf(const std::vector<ColouredCorner>& polygon, double value, bool above)
{
    const auto isInside = [&](const ColouredCorner& corner) {
        return above ? corner.value >= value : corner.value <= value;
    };
    std::vector<ColouredCorner> result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ColouredCorner& current = polygon[i];
        const ColouredCorner& next = polygon[(i + 1) % polygon.size()];
        if (isInside(current))
            result.push_back(current);
        if (isInside(current) != isInside(next) && current.value != value && next.value != value)
            result.push_back(cornerAt(value, &current, &next));
    }
    return result;
}

class Colouring {
public:
    Colouring(const TriangleMesh& surface, std::vector<ColourSpan> spans) : surface_(surface), spans_(std::move(spans))
    {
        coloured_.positions = surface.positions;
        coloured_.normals = surface.normals;
        coloured_.values = surface.values;
        coloured_.triangles.reserve(surface.triangles.size());
        coloured_.colours.reserve(surface.positions.size());
        for (const float value : surface.values)
            coloured_.colours.push_back(spans_[spanOf(spans_, value)].at(value));
    }

    void add(const std::array<std::uint32_t, 3>& triangle);
    TriangleMesh take() { return std::move(coloured_); }

private:
    ColouredCorner cornerOf(std::uint32_t vertex) const
    {
        return {surface_.positions[vertex], surface_.normals[vertex], surface_.values[vertex], vertex};
    }
    std::uint32_t numberOf(const ColouredCorner& corner, const ColourSpan& span);
    void addPiece(const std::vector<ColouredCorner>& polygon, const ColourSpan& span);

    const TriangleMesh& surface_;
    std::vector<ColourSpan> spans_;
    TriangleMesh coloured_;
};

/// A vertex of the surface itself where that has the span's colour, else a new one: at a cut, and on a step's lower
/// side.
std::uint32_t Colouring::numberOf(const ColouredCorner& corner, const ColourSpan& span)
{
    const Colour colour = span.at(corner.value);
    if (corner.vertex != isNewVertex && coloured_.colours[corner.vertex] == colour)
        return corner.vertex;
    const auto number = static_cast<std::uint32_t>(coloured_.positions.size());
    coloured_.positions.push_back(corner.position);
    coloured_.normals.push_back(corner.normal.normalized());
    coloured_.values.push_back(static_cast<float>(corner.value));
    coloured_.colours.push_back(colour);
    return number;
}

void Colouring::addPiece(const std::vector<ColouredCorner>& polygon, const ColourSpan& span)
{
    if (polygon.size() < 3)
        return;
    std::vector<std::uint32_t> numbers;
    for (const ColouredCorner& corner : polygon)
        numbers.push_back(numberOf(corner, span));
    for (std::size_t i = 2; i < numbers.size(); ++i)
        coloured_.triangles.push_back({numbers[0], numbers[i - 1], numbers[i]});
}

void Colouring::add(const std::array<std::uint32_t, 3>& triangle)
{
    const std::vector<ColouredCorner> corners = {cornerOf(triangle[0]), cornerOf(triangle[1]), cornerOf(triangle[2])};
    const auto [least, largest] = std::minmax({corners[0].value, corners[1].value, corners[2].value});
    // Cut upwards from the span of the smallest value; of a triangle of one value only that is there.
    std::size_t span = spanOf(spans_, least);
    std::vector<ColouredCorner> rest = corners;
    for (; spans_[span].largest < largest; ++span) {
        addPiece(sideOf(rest, spans_[span].largest, false), spans_[span]);
        rest = sideOf(rest, spans_[span].largest, true);
    }
    addPiece(rest, spans_[span]);
}

} // namespace

TriangleMesh colouredByValue(const TriangleMesh& surface, const TransferFunction& function)
{
    if (function.colours.empty() || surface.values.empty())
        return surface;
    Colouring colouring(surface, spansOf(function));
    for (const auto& triangle : surface.triangles)
        colouring.add(triangle);
    return colouring.take();
}

Result<Surface> BoundaryCache::plain(const BoundaryLook& look, const Progress& progress)
{
    if (!(look.opacity > 0 && look.opacity <= 1))
        return Error{ErrorKind::WrongUsage, Message::say("The boundary's opacity must be above 0 and at most 1.")};
    if (!boundary_) {
        auto boundary = extractBoundary(*mesh_, usualFeatureAngle, progress);
        if (!boundary)
            return boundary.error();
        boundary_ = std::make_shared<const TriangleMesh>(*std::move(boundary));
    }
    return Surface{boundary_, look.colour, look.opacity, look.backFacesOnly};
}

Result<Surface> BoundaryCache::coloured(const TransferFunction& function, const BoundaryLook& look,
                                        const Progress& progress)
{
    return guarded(noMemoryForBoundary, [&]() -> Result<Surface> {
        if (const Status usable = checkTransferFunction(function); !usable)
            return usable.error();
        auto surface = plain(look, progress);
        if (!surface)
            return surface.error();
        if (!coloured_ || function_ != function) {
            coloured_ = std::make_shared<const TriangleMesh>(colouredByValue(*boundary_, function));
            function_ = function;
        }
        surface->mesh = coloured_;
        surface->lit = false;
        if (function.colours.empty())
            surface->colour = {1, 1, 1}; // as the function has it
        return surface;
    });
}

} // namespace tetra
