// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_distance.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/geometry/nearest_triangle.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace tetra {
namespace {

constexpr MarkedText measuringDeviation = Message::marked("Measuring the deviation");
constexpr std::size_t verticesMeasuredAtOnce = 1 << 10;
constexpr std::size_t trianglesMeasuredAtOnce = 1 << 5;
/// Places inside triangles that are cheap even where the surfaces have fewer vertices.
constexpr std::size_t cheapPlaces = 1 << 14;

/// A triangle's own.
class Corners {
public:
    Corners(const TriangleMesh& surface, const Triangle& triangle)
        : a_(surface.positions[triangle[0]]), b_(surface.positions[triangle[1]]), c_(surface.positions[triangle[2]])
    {
    }

    double area() const { return (b_ - a_).cross(c_ - a_).norm() / 2; }
    double longestEdge() const { return std::max({(b_ - a_).norm(), (c_ - b_).norm(), (a_ - c_).norm()}); }
    /// Where the lines cross that cut each edge into `count` pieces.
    Eigen::Vector3d crossing(std::uint32_t towardsB, std::uint32_t towardsC, std::uint32_t count) const
    {
        return a_ + (b_ - a_) * (double(towardsB) / count) + (c_ - a_) * (double(towardsC) / count);
    }

private:
    const Eigen::Vector3d &a_, &b_, &c_;
};

/// How large the triangles are, as far as places to measure go: the median of their longest edges.
double typicalSize(const TriangleMesh& surface)
{
    std::vector<double> sizes;
    sizes.reserve(surface.triangles.size());
    for (const Triangle& triangle : surface.triangles)
        sizes.push_back(Corners(surface, triangle).longestEdge());
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    return *middle;
}

/// Into how many pieces the edges of a triangle are cut, the longest into such of about this length.
std::uint32_t piecesOf(const Corners& corners, double length)
{
    constexpr double most = 1 << 8; // a triangle is measured by one thread
    const double pieces = std::round(corners.longestEdge() / length);
    return std::isfinite(pieces) && pieces > 1 ? static_cast<std::uint32_t>(std::min(pieces, most)) : 1;
}

/// Of the crossings in a triangle those that are not its corners.
std::uint64_t placesIn(std::uint32_t pieces)
{
    return (pieces + 1ULL) * (pieces + 2ULL) / 2 - 3;
}

/// The length of pieces, typical of `to` unless that makes too many places.
double pieceLength(const TriangleMesh& to, const TriangleMesh& from)
{
    const std::uint64_t most = to.positions.size() + from.positions.size() + cheapPlaces;
    const auto isTooFine = [&](double length) {
        std::uint64_t count = 0;
        for (const Triangle& triangle : from.triangles) {
            count += placesIn(piecesOf(Corners(from, triangle), length));
            if (count > most)
                return true;
        }
        return false;
    };
    double length = typicalSize(to);
    if (!(length > 0))
        return std::numeric_limits<double>::infinity();
    while (isTooFine(length))
        length *= 1.5;
    return length;
}

/// The area around each vertex: a third of the pieces of triangles there.
std::vector<double> areasAround(const TriangleMesh& surface, double length)
{
    std::vector<double> areas(surface.positions.size(), 0.0);
    for (const Triangle& triangle : surface.triangles) {
        const Corners corners(surface, triangle);
        const double pieces = piecesOf(corners, length);
        for (const std::uint32_t corner : triangle)
            areas[corner] += corners.area() / (pieces * pieces) / 3;
    }
    return areas;
}

struct MeasuredPlaces {
    double largest = 0, sum = 0, area = 0;

    void add(double distance, double areaAround)
    {
        largest = std::max(largest, distance);
        sum += distance * areaAround;
        area += areaAround;
    }
    void add(const MeasuredPlaces& others)
    {
        largest = std::max(largest, others.largest);
        sum += others.sum;
        area += others.area;
    }
};

/// All crossings in a triangle but its corners.
void measureInside(const NearestTriangle& to, const Corners& corners, std::uint32_t pieces,
                   NearestTriangle::Found& near, MeasuredPlaces& measured)
{
    const double third = corners.area() / (double(pieces) * pieces) / 3;
    for (std::uint32_t j = 0; j <= pieces; ++j)
        for (std::uint32_t i = 0; i + j <= pieces; ++i) {
            const int edges = (i == 0 ? 1 : 0) + (j == 0 ? 1 : 0) + (i + j == pieces ? 1 : 0); // that it lies on
            if (edges == 2)
                continue;
            near = to.nearest(corners.crossing(i, j, pieces), near.triangle);
            measured.add(near.distance, (edges == 1 ? 3 : 6) * third);
        }
}

/// In runs, which do not depend on the number of threads, so that neither does the sum. `measure` takes the number of
/// what to measure, what the place before was nearest to, and where to add.
template <class Measure>
MeasuredPlaces measureAll(std::size_t count, std::size_t runSize, const Progress& progress, Measure&& measure)
{
    SharedProgress shared(progress, static_cast<double>(count), measuringDeviation);
    std::vector<MeasuredPlaces> runs((count + runSize - 1) / runSize);
    tbb::parallel_for(std::size_t(0), runs.size(), [&](std::size_t run) {
        const std::size_t first = run * runSize, end = std::min(first + runSize, count);
        NearestTriangle::Found near;
        for (std::size_t i = first; i < end && !progress.cancelled(); ++i)
            measure(i, near, runs[run]);
        shared.done(static_cast<double>(end - first));
    });
    MeasuredPlaces all;
    for (const MeasuredPlaces& run : runs)
        all.add(run);
    return all;
}

Result<SurfaceDistance> deviation(const TriangleMesh& to, const TriangleMesh& from, const Progress& progress)
{
    constexpr double treeEnd = 0.2, verticesEnd = 0.6;
    progress.report(0, measuringDeviation);
    const NearestTriangle surface(to.positions, to.triangles);
    const double length = pieceLength(to, from);
    const std::vector<double> areas = areasAround(from, length);
    MeasuredPlaces measured =
        measureAll(from.positions.size(), verticesMeasuredAtOnce, progress.part(treeEnd, verticesEnd),
                   [&](std::size_t vertex, NearestTriangle::Found& near, MeasuredPlaces& sum) {
                       if (areas[vertex] > 0) {
                           near = surface.nearest(from.positions[vertex], near.triangle);
                           sum.add(near.distance, areas[vertex]);
                       }
                   });
    measured.add(measureAll(from.triangles.size(), trianglesMeasuredAtOnce, progress.part(verticesEnd, 1),
                            [&](std::size_t triangle, NearestTriangle::Found& near, MeasuredPlaces& sum) {
                                const Corners corners(from, from.triangles[triangle]);
                                if (const std::uint32_t pieces = piecesOf(corners, length); pieces > 1)
                                    measureInside(surface, corners, pieces, near, sum);
                            }));
    if (progress.cancelled())
        return cancelledError(measuringDeviation);
    progress.report(1, measuringDeviation);
    return SurfaceDistance{measured.largest, measured.area > 0 ? measured.sum / measured.area : 0};
}

} // namespace

Result<SurfaceDistance> surfaceDistance(const TriangleMesh& to, const TriangleMesh& from, const Progress& progress)
{
    if (to.triangles.empty() || from.triangles.empty())
        return Error{ErrorKind::WrongUsage, Message::say("One of the two surfaces is empty, so there is no distance.")};
    return guarded(Message::marked("Not enough memory to measure the deviation. Close other programs or lower the "
                                   "accuracy of the mesh."),
                   [&] { return deviation(to, from, progress); });
}

} // namespace tetra
