// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/mesh/topology.h"
#include "core/render/isosurface/isosurface.h"

#include <tan/render.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <utility>

namespace tetra {
namespace {

/// How deep each vertex lies in the half-space, negative outside, rounded to a float after all else: so the error is
/// a part of the distance, not of the coordinates.
Buffer<float> depthsIn(const HalfSpace& unit, const TetrahedralMesh& mesh)
{
    Buffer<float> depths(mesh.positions.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, depths.size(), 1 << 15), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v)
            depths[v] = static_cast<float>(unit.offset - unit.normal.dot(mesh.positions[v]));
    });
    return depths;
}

/// Where the depth is zero on an edge whose ends lie on different sides, from the one outside.
EdgePoint pointOf(EdgeKey edge, const Buffer<float>& depths)
{
    auto [from, to] = endsOf(edge);
    if (depths[from] >= 0)
        std::swap(from, to);
    const double outside = static_cast<double>(depths[from]), inside = static_cast<double>(depths[to]);
    const double share = outside / (outside - inside);
    return {from, to, share >= 0 && share <= 1 ? share : 0.5};
}

Result<MeshCut> cutAt(const TetrahedralMesh& mesh, const HalfSpace& unit, const Progress& progress)
{
    const Buffer<float> depths = depthsIn(unit, mesh);
    const Eigen::Vector3f inwards = -unit.normal.cast<float>();
    const Buffer<Eigen::Vector3f> gradients(mesh.positions.size(), inwards);
    auto contour = extractContour(mesh, depths, nullptr, gradients, 0, progress);
    if (!contour)
        return contour.error();
    MeshCut result{std::move(contour->surface), Buffer<EdgePoint>(contour->edges.size())};
    result.surface.values.resize(contour->edges.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, contour->edges.size(), 1 << 12), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const EdgePoint point = pointOf(contour->edges[v], depths);
            const double from = static_cast<double>(mesh.values[point.from]);
            const double to = static_cast<double>(mesh.values[point.to]);
            result.points[v] = point;
            result.surface.values[v] = static_cast<float>(from + point.share * (to - from));
        }
    });
    return result;
}

} // namespace

Result<MeshCut> cutByPlane(const TetrahedralMesh& mesh, const HalfSpace& plane, const Progress& progress)
{
    const double length = plane.normal.stableNorm();
    if (!std::isfinite(length) || !(length > 0) || !std::isfinite(plane.offset / length))
        return Error{
            ErrorKind::WrongUsage,
            Message::say("A plane needs a normal of three finite numbers, not all zero, and a finite offset.")};
    if (mesh.values.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, Message::say("The mesh and its values do not belong together.")};
    const HalfSpace unit{plane.normal / length, plane.offset / length};
    return guarded(
        Message::marked("Not enough memory to cut the mesh. Close other programs or lower the accuracy of the mesh."),
        [&] { return cutAt(mesh, unit, progress); });
}

} // namespace tetra
