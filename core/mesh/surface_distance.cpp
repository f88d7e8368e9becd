// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/surface_distance.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"
#include "core/geometry/nearest_triangle.h"
#include "core/mesh/topology.h"

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

constexpr MarkedText measuringDeviation = Message::marked("Measuring the deviation");
constexpr std::size_t verticesMeasuredAtOnce = 1 << 10;

/// A third of the area of the triangles around each vertex.
std::vector<double> areasAround(const TriangleMesh& surface)
{
    std::vector<double> areas(surface.positions.size(), 0.0);
    for (const Triangle& triangle : surface.triangles) {
        const Eigen::Vector3d& a = surface.positions[triangle[0]];
        const double area = (surface.positions[triangle[1]] - a).cross(surface.positions[triangle[2]] - a).norm() / 2;
        for (const std::uint32_t corner : triangle)
            areas[corner] += area / 3;
    }
    return areas;
}

Result<SurfaceDistance> deviation(const TriangleMesh& to, const TriangleMesh& from, const Progress& progress)
{
    constexpr double treeEnd = 0.2;
    progress.report(0, measuringDeviation);
    const NearestTriangle surface(to.positions, to.triangles);
    const std::vector<double> areas = areasAround(from);
    std::vector<double> distances(from.positions.size(), 0.0);
    SharedProgress shared(progress.part(treeEnd, 1), static_cast<double>(distances.size()), measuringDeviation);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, distances.size(), verticesMeasuredAtOnce),
                      [&](const auto& range) {
                          NearestTriangle::Found near;
                          for (std::size_t first = range.begin(); first < range.end() && !progress.cancelled();
                               first += verticesMeasuredAtOnce) {
                              const std::size_t end = std::min(first + verticesMeasuredAtOnce, range.end());
                              for (std::size_t vertex = first; vertex < end; ++vertex)
                                  if (areas[vertex] > 0) {
                                      near = surface.nearest(from.positions[vertex], near.triangle);
                                      distances[vertex] = near.distance;
                                  }
                              shared.done(static_cast<double>(end - first));
                          }
                      });
    if (progress.cancelled())
        return cancelledError(measuringDeviation);
    SurfaceDistance found;
    double area = 0;
    for (std::size_t vertex = 0; vertex < distances.size(); ++vertex) {
        found.largest = std::max(found.largest, distances[vertex]);
        found.mean += areas[vertex] * distances[vertex];
        area += areas[vertex];
    }
    found.mean = area > 0 ? found.mean / area : 0;
    progress.report(1, measuringDeviation);
    return found;
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
