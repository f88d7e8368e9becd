// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// The media type of a packed mesh.
inline constexpr std::string_view packedMeshType = "application/vnd.tan.mesh";

/// What a packed mesh holds.
struct UnpackedMesh {
    TetrahedralMesh mesh;
    Buffer<float> birthErrors; ///< ExtractedMesh::birthErrors: one for each tetrahedron, or none
    Buffer<float> deathErrors;
    std::string facts; ///< what its sender tells of it
};

/// Near which places coordinates lie: at origin + unit * n with small integers n, if they are those of a lattice. Each
/// unit is finite and positive. It decides how few bytes a mesh takes, and nothing else.
struct PlaceScale {
    Eigen::Vector3d origin{0, 0, 0};
    Eigen::Vector3d unit{1, 1, 1};
};

/// The mesh in few bytes, for the way over a network (PACKED_MESH.md): as a rule one to two bytes a tetrahedron in
/// place of twenty. Every coordinate, value and error keeps its bits; what changes is the order of vertices and
/// tetrahedra, and which corner of a tetrahedron is named first (its sign stays). Any mesh whose corners exist goes,
/// also one with holes, in pieces, or of tetrahedra over each other; a connected one without folds takes least.
/// O(tetrahedra), about 200 bytes a tetrahedron while it works, on one thread. Errors: WrongUsage for arrays that do
/// not belong together; out of memory; cancelled.
TAN_INTERNAL Result<std::vector<std::byte>> packMesh(const TetrahedralMesh& mesh, std::span<const float> birthErrors,
                                                     std::span<const float> deathErrors, std::string_view facts,
                                                     const PlaceScale& scale = {}, const Progress& progress = {});

/// The inverse. The bytes may come from anywhere: all sizes and indices are checked, and memory is taken for what is
/// there, not for what is announced. Errors: BadInput for bytes that are no packed mesh or damaged, OutOfResource for a
/// mesh of more than `mostTetrahedra` tetrahedra (or four times as many vertices) or more than there is memory for;
/// cancelled.
TAN_INTERNAL Result<UnpackedMesh> unpackMesh(std::span<const std::byte> bytes, std::uint64_t mostTetrahedra,
                                             const Progress& progress = {});

} // namespace tetra
