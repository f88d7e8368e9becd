// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/vertex_star.h"

#include "core/base/simd.h"
#include "core/mesh/face_adjacency.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

constexpr std::size_t lanes = VertexStar::lanes;

/// Fills the eight columns of VertexStar's planes.
TETRA_SIMD_CLONES void computePlanes(const double* corners, double* planes, std::size_t count)
{
    for (std::size_t first = 0; first < count; first += lanes) {
        double offset[lanes] = {}, magnitude[lanes] = {};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const auto along = [=](std::size_t corner, std::size_t axis) {
                    const std::size_t face = first + lane;
                    return corners[(3 * corner + axis) * count + face] - corners[axis * count + face];
                };
                const double plus = along(1, j) * along(2, k), minus = along(1, k) * along(2, j);
                const double from = corners[i * count + first + lane];
                const double size = std::abs(plus) + std::abs(minus);
                planes[i * count + first + lane] = plus - minus;
                planes[(4 + i) * count + first + lane] = size;
                offset[lane] += (plus - minus) * from;
                magnitude[lane] += size * std::abs(from);
            }
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            planes[3 * count + first + lane] = offset[lane];
            planes[7 * count + first + lane] = magnitude[lane];
        }
    }
}

/// How many faces have a volume with the apex that is positive beyond doubt.
TETRA_SIMD_CLONES std::size_t countPositive(const double* planes, std::size_t count, const double* apex, double doubt)
{
    double positive[lanes] = {};
    const double x = apex[0], y = apex[1], z = apex[2];
    const double absX = doubt * std::abs(x), absY = doubt * std::abs(y), absZ = doubt * std::abs(z);
    for (std::size_t first = 0; first < count; first += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double* plane = planes + first + lane;
            const double volume = plane[3 * count] - plane[0] * x - plane[count] * y - plane[2 * count] * z;
            const double least =
                doubt * plane[7 * count] + plane[4 * count] * absX + plane[5 * count] * absY + plane[6 * count] * absZ;
            positive[lane] += volume > least ? 1.0 : 0.0;
        }
    double sum = 0;
    for (const double part : positive)
        sum += part;
    return static_cast<std::size_t>(sum);
}

} // namespace

VertexStar::VertexStar(std::span<const Eigen::Vector3d> positions, bool exact)
    : positions_(positions), doubt_(exact ? 0 : 1e-13), placeInLink_(positions.size(), 0)
{
}

void VertexStar::set(const CollapsibleMesh& mesh, std::uint32_t vertex, bool withRim)
{
    vertex_ = vertex;
    slots_.assign(mesh.star(vertex).begin(), mesh.star(vertex).end());
    link_.clear();
    faces_.clear();
    places_.clear();
    facesOfLink_.clear();
    rim_.clear();
    for (const std::uint32_t slot : slots_)
        mesh.prefetch(slot);
    for (const std::uint32_t slot : slots_) {
        const CollapsibleMesh::Four& vertices = mesh.vertices(slot);
        const std::size_t own = indexOf(vertices, vertex);
        const auto& others = cornersOfFace[own];
        faces_.push_back(
            {linkPlaceOf(vertices[others[0]]), linkPlaceOf(vertices[others[1]]), linkPlaceOf(vertices[others[2]])});
        for (const std::uint32_t place : faces_.back())
            ++facesOfLink_[place];
        if (withRim)
            addRim(mesh, slot, own);
    }
}

/// The boundary triangles among the faces of the tetrahedron met last that have the vertex.
void VertexStar::addRim(const CollapsibleMesh& mesh, std::uint32_t slot, std::size_t own)
{
    for (std::size_t face = 0; face < 4; ++face) {
        if (face == own || !CollapsibleMesh::isTriangle(mesh.neighbours(slot)[face]))
            continue;
        const auto& [a, b, c] = faces_.back();
        // Of (vertex, a, b, c) the faces (vertex, c, b), (vertex, a, c) and (vertex, b, a) look outwards.
        const std::uint32_t opposite = linkPlaceOf(mesh.vertices(slot)[face]);
        rim_.push_back({mesh.neighbours(slot)[face], static_cast<std::uint32_t>(faces_.size() - 1),
                        opposite == a   ? std::array{c, b}
                        : opposite == b ? std::array{a, c}
                                        : std::array{b, a}});
    }
}

bool VertexStar::rimIsOneCycle() const
{
    if (rim_.empty())
        return false;
    std::vector<std::uint32_t> next(link_.size(), CollapsibleMesh::none);
    for (const RimTriangle& triangle : rim_) {
        if (next[triangle.corners[0]] != CollapsibleMesh::none)
            return false;
        next[triangle.corners[0]] = triangle.corners[1];
    }
    std::size_t length = 1;
    const std::uint32_t first = rim_.front().corners[0];
    std::uint32_t at = next[first];
    for (; at != first && at != CollapsibleMesh::none && length <= rim_.size(); ++length)
        at = next[at];
    return at == first && length == rim_.size();
}

std::uint32_t VertexStar::linkPlaceOf(std::uint32_t vertex)
{
    const std::uint32_t known = placeInLink_[vertex];
    if (known < link_.size() && link_[known] == vertex)
        return known;
    const auto place = static_cast<std::uint32_t>(link_.size());
    placeInLink_[vertex] = place;
    link_.push_back(vertex);
    facesOfLink_.push_back(0);
    const Eigen::Vector3d from = positions_[vertex] - positions_[vertex_];
    places_.push_back({from.x(), from.y(), from.z()});
    return place;
}

void VertexStar::measure()
{
    const std::size_t room = paddedFaceCount();
    corners_.assign(9 * room, 0);
    planes_.resize(8 * room);
    for (std::size_t face = 0; face < faces_.size(); ++face)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::array<double, 3>& place = places_[faces_[face][corner]];
            for (std::size_t axis = 0; axis < 3; ++axis)
                corners_[(3 * corner + axis) * room + face] = place[axis];
        }
    computePlanes(corners_.data(), planes_.data(), room);
}

bool VertexStar::opensOnto(std::uint32_t linkPlace) const
{
    // Faces that have the vertex themselves have no volume with it, so they are not counted.
    const std::size_t wanted = faces_.size() - facesOfLink_[linkPlace];
    return wanted > 0 && countPositive(planes_.data(), paddedFaceCount(), places_[linkPlace].data(), doubt_) == wanted;
}

} // namespace tetra
