// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/mesh_faces.h"

#include "core/mesh/face_adjacency.h"
#include "core/mesh/face_matching.h"
#include "core/mesh/topology.h"

#include <algorithm>

namespace tetra {

namespace {

void sortUnique(std::vector<std::uint32_t>& numbers)
{
    std::ranges::sort(numbers);
    const auto repeated = std::ranges::unique(numbers);
    numbers.erase(repeated.begin(), repeated.end());
}

bool isBack(const std::array<std::uint32_t, 3>& face, const std::array<std::uint32_t, 3>& other)
{
    for (std::size_t turn = 0; turn < 3; ++turn)
        if (other[turn] == face[0])
            return other[(turn + 1) % 3] == face[2] && other[(turn + 2) % 3] == face[1];
    return false;
}

std::uint64_t keyOf(const std::array<std::uint32_t, 3>& face)
{
    return FaceMatching::keyOf(face[0]) + FaceMatching::keyOf(face[1]) + FaceMatching::keyOf(face[2]);
}

} // namespace

std::array<std::uint32_t, 3> sideCorners(std::span<const std::array<std::uint32_t, 4>> tetrahedra, std::uint32_t side)
{
    const auto& tetrahedron = tetrahedra[FaceAdjacency::cellOf(side)];
    const auto& corners = cornersOfFace[FaceAdjacency::faceOf(side)];
    return {tetrahedron[corners[0]], tetrahedron[corners[1]], tetrahedron[corners[2]]};
}

MeshFaces findMeshFaces(std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    MeshFaces faces;
    const auto sides = static_cast<std::uint32_t>(4 * tetrahedra.size());
    faces.partners.assign(sides, MeshFaces::none);
    FaceMatching matching(2 * std::uint64_t(sides)); // even if no two tetrahedra share a face
    std::vector<std::uint64_t> crowdedKeys;
    constexpr std::uint32_t ahead = 16;
    for (std::uint32_t side = 0; side < sides; ++side) {
        if (side + ahead < sides)
            matching.prefetch(keyOf(sideCorners(tetrahedra, side + ahead)));
        const std::uint64_t key = keyOf(sideCorners(tetrahedra, side));
        const std::uint32_t other = matching.add(key, side);
        if (other == side)
            crowdedKeys.push_back(key);
        else if (other != FaceMatching::none) {
            faces.partners[side] = other;
            faces.partners[other] = side;
        }
    }
    std::ranges::sort(crowdedKeys);
    for (std::uint32_t side = 0; side < sides; ++side) {
        const std::uint32_t other = faces.partners[side];
        const auto corners = sideCorners(tetrahedra, side);
        if (!crowdedKeys.empty() && std::ranges::binary_search(crowdedKeys, keyOf(corners)))
            faces.crowded.push_back(FaceAdjacency::cellOf(side));
        else if (other == MeshFaces::none)
            faces.boundary.push_back(side);
        else if (!isBack(corners, sideCorners(tetrahedra, other)))
            faces.folded.push_back(FaceAdjacency::cellOf(side));
    }
    sortUnique(faces.crowded);
    sortUnique(faces.folded);
    return faces;
}

} // namespace tetra
