// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/collapsible_mesh.h"
#include "core/mesh/decimation/vertex_star.h"

#include <cstdint>
#include <vector>

namespace tetra {

/// Whether collapses of boundary vertices keep the topology (S12): Dey and others' link condition, the boundary closed
/// by a dummy vertex. Of inner vertices, and of those on the sides of a box, positive volumes say as much: there the
/// new tetrahedra fill the star of the vertex once, and no simplex of theirs can lie elsewhere.
class LinkCondition {
public:
    /// For collapses of a boundary vertex.
    void set(const VertexStar& star);
    /// Whether a boundary edge joins the vertex with another: onto others it must not move.
    bool isOnRim(std::uint32_t vertex) const;
    /// Whether the vertex may move onto one of its link, which must then be joined to it by a boundary edge, and leave
    /// the history one in which closed sets have meshes.
    bool allows(const CollapsibleMesh& mesh, const VertexStar& star, std::uint32_t linkPlace);

private:
    static bool leavesFaceOpen(const VertexStar& star, std::uint32_t linkPlace);
    using Edge = std::uint64_t;
    static Edge edgeOf(std::uint32_t a, std::uint32_t b) { return a < b ? Edge(a) << 32 | b : Edge(b) << 32 | a; }

    std::vector<std::uint32_t> link_;      ///< vertices around the star's, sorted
    std::vector<Edge> edges_;              ///< of the link, sorted
    std::vector<std::uint32_t> rim_;       ///< vertices joined to it by boundary edges, sorted
    std::vector<Edge> rimEdges_;           ///< opposite to it in boundary triangles, sorted
    std::vector<std::uint32_t> shared_;    ///< vertices that have a triangle with it and the target, sorted
    std::vector<Edge> sharedEdges_;        ///< edges that have a tetrahedron with them, sorted
    std::vector<std::uint32_t> sharedRim_; ///< vertices that have a boundary triangle with them
};

} // namespace tetra
