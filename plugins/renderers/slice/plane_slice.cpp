// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/renderers/slice/plane_slice.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tetra {
namespace {

// Faces that lie in the plane are in a cut only if the mesh goes on behind them on its outer side. Those with which a
// part of the mesh ends in the plane come of the cut from the other side.

using Face = std::array<std::uint32_t, 3>; ///< the vertices of a mesh that it has, in ascending order

/// The face of the mesh that a triangle of a cut is; none of another triangle. Of points a hair beside a vertex both
/// cuts make the same triangles.
std::optional<Face> faceOf(const Face& triangle, const MeshCut& cut)
{
    constexpr double hair = 1e-12;
    Face face{};
    for (std::size_t corner = 0; corner < face.size(); ++corner) {
        const EdgePoint& point = cut.points[triangle[corner]];
        if (point.share > hair && point.share < 1 - hair)
            return std::nullopt;
        face[corner] = point.share < 0.5 ? point.from : point.to;
    }
    std::ranges::sort(face);
    return face[0] < face[1] && face[1] < face[2] ? std::optional(face) : std::nullopt;
}

/// Adds a triangle of a cut from the other side, which winds the other way.
void addFlipped(const Face& triangle, const TriangleMesh& other, std::map<std::uint32_t, std::uint32_t>& numbers,
                TriangleMesh& surface)
{
    Face added{};
    for (std::size_t corner = 0; corner < added.size(); ++corner) {
        const std::uint32_t vertex = triangle[corner];
        const auto next = static_cast<std::uint32_t>(surface.positions.size());
        const auto [number, isNew] = numbers.emplace(vertex, next);
        if (isNew) {
            surface.positions.push_back(other.positions[vertex]);
            surface.normals.push_back(-other.normals[vertex]);
            surface.values.push_back(other.values[vertex]);
        }
        added[added.size() - 1 - corner] = number->second;
    }
    surface.triangles.push_back(added);
}

bool hasVertexIn(const HalfSpace& plane, const TetrahedralMesh& mesh)
{
    constexpr double rounding = 1e-9;
    return std::ranges::any_of(mesh.positions, [&](const Eigen::Vector3d& place) {
        const double size = plane.normal.cwiseAbs().dot(place.cwiseAbs()) + std::abs(plane.offset);
        return std::abs(plane.normal.dot(place) - plane.offset) <= rounding * size;
    });
}

} // namespace

Result<TriangleMesh> planeSlice(const TetrahedralMesh& mesh, const HalfSpace& plane, const Progress& progress)
{
    auto cut = cutByPlane(mesh, plane, progress.part(0, 0.5));
    if (!cut)
        return cut.error();
    if (!hasVertexIn(plane, mesh))
        return std::move(cut->surface);
    const auto other = cutByPlane(mesh, {-plane.normal, -plane.offset}, progress.part(0.5, 1));
    if (!other)
        return other.error();
    std::set<Face> faces;
    for (const Face& triangle : cut->surface.triangles)
        if (const auto face = faceOf(triangle, *cut))
            faces.insert(*face);
    std::map<std::uint32_t, std::uint32_t> numbers; // of the other cut's vertices in the surface
    for (const Face& triangle : other->surface.triangles)
        if (const auto face = faceOf(triangle, *other); face && faces.insert(*face).second)
            addFlipped(triangle, other->surface, numbers, cut->surface);
    return std::move(cut->surface);
}

} // namespace tetra
