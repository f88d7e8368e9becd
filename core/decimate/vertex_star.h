// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/flat_index.h"
#include "core/decimate/collapsible_mesh.h"
#include "core/mesh/topology.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Finds out which numbers there are in short lists: with vectors of sixteen lanes by comparing, else by an index.
class DistinctNumbers {
public:
    /// Each of `numbers` once, in order of appearance, into `distinct`, and where it is there into `places`, which is
    /// as long as `numbers`. None of them is 2^32 - 1.
    void find(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
              std::span<std::uint32_t> places);

private:
    FlatIndex<std::uint32_t> index_;
};

/// A point as evaluations read it, in one line of the cache: points of a star lie all over the memory.
struct alignas(32) PlacedValue {
    std::array<double, 3> place{};
    double value = 0;
};

/// A vertex with the tetrahedra around it, as collapses of it see them. Coordinates are relative to the vertex.
class VertexStar {
public:
    static constexpr std::size_t lanes = 8;

    /// `points` live on. `exact`: their places are integers of at most 16 bits, so that volumes are exact.
    VertexStar(std::span<const PlacedValue> points, bool exact);

    /// `withRim`: whether rim() is wanted.
    void set(const CollapsibleMesh& mesh, std::uint32_t vertex, bool withRim);

    /// Of what mesh it was, that is another one now.
    void forget() { vertex_ = CollapsibleMesh::none; }

    std::uint32_t vertex() const noexcept { return vertex_; }
    std::span<const std::uint32_t> tetrahedra() const noexcept { return slots_; }
    /// The vertices around, each once.
    std::span<const std::uint32_t> link() const noexcept { return link_; }
    /// The faces opposite to the vertex, one a slot, as places in link(); (vertex, face) is positive.
    std::span<const std::array<std::uint32_t, 3>> faces() const noexcept { return faces_; }
    /// A boundary triangle of the vertex: its face of tetrahedra()[slotPlace] has two more corners, places in link().
    struct RimTriangle {
        std::uint32_t triangle;
        std::uint32_t slotPlace;
        std::array<std::uint32_t, 2> corners; ///< (vertex, corners) is counterclockwise from outside
    };
    std::span<const RimTriangle> rim() const noexcept { return rim_; }
    /// Whether the boundary around the vertex is a disk: what collapses of it need.
    bool rimIsOneCycle() const;
    const std::array<double, 3>& place(std::uint32_t linkPlace) const noexcept { return ofLink_[linkPlace].place; }
    double value(std::uint32_t linkPlace) const noexcept { return ofLink_[linkPlace].value; }

    /// Computes what opensOnto() and corners() need.
    void measure();
    /// Whether all tetrahedra that a collapse onto a vertex of the link makes have a volume that is positive beyond
    /// doubt, and there are any.
    bool opensOnto(std::uint32_t linkPlace) const;
    /// How many faces have a vertex of the link: tetrahedra that a collapse onto it would take away.
    std::uint32_t faceCountOf(std::uint32_t linkPlace) const noexcept { return facesOfLink_[linkPlace]; }
    /// The corners of the faces side by side, for arithmetic on eight faces at once: nine columns of paddedFaceCount()
    /// numbers, the x of all first corners first; zeros beyond the last face.
    std::span<const double> corners() const noexcept { return corners_; }
    std::size_t paddedFaceCount() const noexcept { return (faces_.size() + lanes - 1) / lanes * lanes; }
    bool holds(std::size_t face, std::uint32_t linkPlace) const
    {
        const auto& [a, b, c] = faces_[face];
        return (a == linkPlace) | (b == linkPlace) | (c == linkPlace);
    }

private:
    void addRim(const CollapsibleMesh& mesh);
    void countVolumes();

    std::span<const PlacedValue> points_;
    double doubt_;
    std::uint32_t vertex_ = CollapsibleMesh::none;
    std::vector<std::uint32_t> slots_;
    std::vector<std::uint32_t> link_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::vector<RimTriangle> rim_;
    std::vector<PlacedValue> ofLink_;        ///< from the vertex
    std::vector<std::uint32_t> facesOfLink_; ///< how many faces each vertex of the link has
    std::vector<double> corners_;
    /// Columns as of corners(): the normal of each face, its offset, and how large the terms of these four are. The
    /// volume of the tetrahedron with an apex p is offset - normal . p.
    std::vector<double> planes_;
    std::vector<double> apexes_;                ///< the places of link() side by side: three columns, padded
    std::vector<double> positive_;              ///< by place in link(): with how many faces it has a positive volume
    std::vector<std::uint32_t> cornersOfFaces_; ///< the vertices of faces()
    DistinctNumbers distinct_;
};

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

    std::vector<std::uint32_t> link_;       ///< vertices around the star's, sorted
    std::vector<EdgeKey> edges_;            ///< of the link, sorted
    std::vector<std::uint32_t> rim_;        ///< vertices joined to it by boundary edges, sorted
    std::vector<std::uint32_t> shared_;     ///< vertices that have a triangle with it and the target, sorted
    std::vector<EdgeKey> sharedEdges_;      ///< edges that have a tetrahedron with them, sorted
    std::vector<std::uint32_t> sharedLink_; ///< vertices that have a boundary triangle with them
};

} // namespace tetra
