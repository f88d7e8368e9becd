// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/boundary_faces.h"

#include "core/mesh/face_adjacency.h"
#include "core/mesh/topology.h"

namespace tetra {

BoundaryFaces boundaryFaces(std::size_t vertexCount, std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    constexpr std::uint32_t unused = 0xffffffff;
    const FaceAdjacency adjacency = matchFaces(tetrahedra);
    std::vector<std::uint32_t> numbers(vertexCount, unused);
    BoundaryFaces boundary;
    for (std::size_t cell = 0; cell < tetrahedra.size(); ++cell)
        for (std::size_t face = 0; face < 4; ++face) {
            if ((adjacency.innerFaces[cell] >> face & 1) != 0)
                continue;
            auto& triangle = boundary.triangles.emplace_back();
            for (std::size_t corner = 0; corner < 3; ++corner) {
                triangle[corner] = tetrahedra[cell][cornersOfFace[face][corner]];
                numbers[triangle[corner]] = 0;
            }
        }
    for (std::uint32_t vertex = 0; vertex < numbers.size(); ++vertex)
        if (numbers[vertex] != unused) {
            numbers[vertex] = static_cast<std::uint32_t>(boundary.vertices.size());
            boundary.vertices.push_back(vertex);
        }
    for (auto& triangle : boundary.triangles)
        for (std::uint32_t& corner : triangle)
            corner = numbers[corner];
    return boundary;
}

} // namespace tetra
