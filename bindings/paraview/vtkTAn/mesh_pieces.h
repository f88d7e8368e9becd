// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <cstdint>
#include <vector>

/// A mesh divided among processes. Each has the same mesh and divides it in the same way, so nothing is exchanged.
namespace tanpieces {

/// To which of so many pieces each tetrahedron belongs. Pieces differ in size by one tetrahedron at most for each
/// halving, and are compact: boxes are halved along their longest side by the middles of the tetrahedra. The same for
/// the same mesh, on every machine. O(tetrahedra log pieces).
std::vector<std::uint32_t> pieceOfEach(const tetra::TetrahedralMesh& mesh, std::uint32_t pieces);

/// A piece with the tetrahedra around it.
struct MeshPiece {
    std::vector<std::uint32_t> vertices;   ///< numbers in the mesh, rising
    std::vector<std::uint32_t> tetrahedra; ///< likewise
    std::vector<bool> isOthers;            ///< of each tetrahedron: it is another piece's, and here for its neighbours
    std::vector<bool> isOthersVertex;      ///< of each vertex: a piece with a smaller number has it, too
};

/// Of a mesh that was divided: one piece, with so many layers of neighbours. A vertex belongs to the first piece that
/// has it. O(size of the mesh).
MeshPiece pieceOf(const tetra::TetrahedralMesh& mesh, const std::vector<std::uint32_t>& pieceOfEach,
                  std::uint32_t piece, int layers);

} // namespace tanpieces
