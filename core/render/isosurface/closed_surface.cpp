// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/isosurface/closed_surface.h"

#include "core/base/guarded.h"
#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"
#include "core/render/isosurface/isosurface.h"
#include "core/render/isosurface/surface_chunks.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr MarkedText closingSurface = Message::marked("Closing the surface");
constexpr std::uint32_t unmade = 0xffffffff;

/// Clips the boundary of a mesh to the solid, with the vertices of the contour wherever it crosses an edge of the
/// boundary or a vertex.
class Caps {
public:
    Caps(const TetrahedralMesh& mesh, const BoundaryFaces& boundary, double isovalue, SolidSide side, Contour& contour);

    /// Adds what belongs to the solid of a face of the boundary, numbers of the mesh's vertices.
    void add(const Triangle& face);

private:
    bool isAbove(std::uint32_t vertex) const { return static_cast<double>(mesh_.values[vertex]) >= isovalue_; }
    Eigen::Vector3d placeOn(EdgeKey edge) const;
    std::uint32_t crossingOf(std::uint32_t one, std::uint32_t other);
    std::uint32_t vertexAt(std::uint32_t ofMesh);
    std::uint32_t newVertex(const Eigen::Vector3d& place);

    const TetrahedralMesh& mesh_;
    double isovalue_;
    SolidSide side_;
    TriangleMesh& surface_;
    std::vector<std::pair<EdgeKey, std::uint32_t>> crossings_; ///< of edges between vertices of the boundary, sorted
    std::vector<std::uint32_t> atVertex_; ///< the surface's vertex that lies in a vertex of the mesh; else `unmade`
    std::vector<std::uint32_t> corners_;
};

Caps::Caps(const TetrahedralMesh& mesh, const BoundaryFaces& boundary, double isovalue, SolidSide side,
           Contour& contour)
    : mesh_(mesh), isovalue_(isovalue), side_(side), surface_(contour.surface), atVertex_(mesh.positions.size(), unmade)
{
    std::vector<bool> isOnBoundary(mesh.positions.size(), false);
    for (const std::uint32_t vertex : boundary.vertices)
        isOnBoundary[vertex] = true;
    for (std::uint32_t vertex = 0; vertex < contour.edges.size(); ++vertex) {
        const auto ends = endsOf(contour.edges[vertex]);
        for (const std::uint32_t end : ends)
            if (surface_.positions[vertex] == mesh.positions[end])
                atVertex_[end] = vertex;
        if (isOnBoundary[ends[0]] && isOnBoundary[ends[1]])
            crossings_.emplace_back(contour.edges[vertex], vertex);
    }
    std::ranges::sort(crossings_);
}

/// Where the contour crosses an edge, to the last bit: inwards, as its vertices were placed. The other way a crossing
/// that it has in a vertex of the mesh may be beside it.
Eigen::Vector3d Caps::placeOn(EdgeKey edge) const
{
    auto [first, second] = endsOf(edge);
    if (isAbove(first))
        std::swap(first, second);
    const double share = crossingShare(isovalue_, mesh_.values[first], mesh_.values[second]);
    const Eigen::Vector3d &from = mesh_.positions[first], &to = mesh_.positions[second];
    return {coordinateAt(from[0], to[0], share), coordinateAt(from[1], to[1], share),
            coordinateAt(from[2], to[2], share)};
}

/// Of the vertices that the contour had in one vertex of the mesh a single one is left, on one of their edges: that is
/// where the others are looked for.
std::uint32_t Caps::crossingOf(std::uint32_t one, std::uint32_t other)
{
    const EdgeKey edge = edgeKey(one, other);
    const auto found = std::ranges::lower_bound(crossings_, edge, {}, &std::pair<EdgeKey, std::uint32_t>::first);
    if (found != crossings_.end() && found->first == edge)
        return found->second;
    const Eigen::Vector3d place = placeOn(edge);
    for (const std::uint32_t end : {one, other})
        if (place == mesh_.positions[end] && atVertex_[end] != unmade)
            return atVertex_[end];
    const std::uint32_t made = newVertex(place); // the contour knows nothing of it: its values are not numbers
    crossings_.insert(found, {edge, made});
    return made;
}

std::uint32_t Caps::vertexAt(std::uint32_t ofMesh)
{
    if (atVertex_[ofMesh] == unmade)
        atVertex_[ofMesh] = newVertex(mesh_.positions[ofMesh]);
    return atVertex_[ofMesh];
}

std::uint32_t Caps::newVertex(const Eigen::Vector3d& place)
{
    surface_.positions.push_back(place);
    return static_cast<std::uint32_t>(surface_.positions.size() - 1);
}

void Caps::add(const Triangle& face)
{
    const auto isOfSolid = [this](std::uint32_t vertex) { return isAbove(vertex) == (side_ == SolidSide::Above); };
    corners_.clear();
    const auto take = [this](std::uint32_t vertex) {
        if (corners_.empty() || corners_.back() != vertex)
            corners_.push_back(vertex);
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t here = face[i], next = face[(i + 1) % 3];
        if (isOfSolid(here))
            take(vertexAt(here));
        if (isAbove(here) != isAbove(next))
            take(crossingOf(here, next));
    }
    while (corners_.size() > 1 && corners_.back() == corners_.front())
        corners_.pop_back();
    for (std::size_t i = 2; i < corners_.size(); ++i)
        surface_.triangles.push_back({corners_[0], corners_[i - 1], corners_[i]});
}

Result<TriangleMesh> closed(const TetrahedralMesh& mesh, const ClosingBasis& basis, double isovalue, SolidSide side,
                            const Progress& progress)
{
    constexpr double contoured = 0.7;
    auto contour = extractContour(mesh, mesh.values, nullptr, basis.gradients, isovalue, progress.part(0, contoured));
    if (!contour)
        return contour.error();
    contour->surface.normals.clear();
    if (side == SolidSide::Below)
        for (Triangle& triangle : contour->surface.triangles)
            std::swap(triangle[1], triangle[2]);
    const BoundaryFaces& boundary = basis.boundary;
    Caps caps(mesh, boundary, isovalue, side, *contour);
    if (progress.cancelled())
        return cancelledError(closingSurface);
    for (const Triangle& face : boundary.triangles)
        caps.add({boundary.vertices[face[0]], boundary.vertices[face[1]], boundary.vertices[face[2]]});
    progress.report(1, closingSurface);
    return std::move(contour->surface);
}

constexpr MarkedText noMemory =
    Message::marked("Not enough memory to close the isosurface. Close other programs or lower the accuracy of the "
                    "mesh.");

} // namespace

Result<ClosingBasis> closingBasis(const TetrahedralMesh& mesh, const Progress& progress)
{
    if (mesh.tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource,
                     Message::say("The mesh has too many tetrahedra for its boundary to be found. Lower the accuracy "
                                  "of the mesh.")};
    return guarded(noMemory, [&]() -> Result<ClosingBasis> {
        progress.report(0, closingSurface);
        ClosingBasis basis{boundaryFaces(mesh.positions.size(), mesh.tetrahedra),
                           Buffer<Eigen::Vector3f>(mesh.positions.size(), Eigen::Vector3f(0, 0, 1))};
        if (progress.cancelled())
            return cancelledError(closingSurface);
        progress.report(1, closingSurface);
        return basis;
    });
}

Result<TriangleMesh> closedIsosurface(const TetrahedralMesh& mesh, const ClosingBasis& basis, double isovalue,
                                      SolidSide side, const Progress& progress)
{
    if (std::isnan(isovalue))
        return Error{ErrorKind::WrongUsage, Message::say("The isovalue is not a number.")};
    if (mesh.values.size() != mesh.positions.size() || basis.gradients.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, Message::say("The mesh and its values do not belong together.")};
    return guarded(noMemory, [&] { return closed(mesh, basis, isovalue, side, progress); });
}

Result<TriangleMesh> closedIsosurface(const TetrahedralMesh& mesh, double isovalue, SolidSide side,
                                      const Progress& progress)
{
    constexpr double prepared = 0.3;
    const auto basis = closingBasis(mesh, progress.part(0, prepared));
    if (!basis)
        return basis.error();
    return closedIsosurface(mesh, *basis, isovalue, side, progress.part(prepared, 1));
}

} // namespace tetra
