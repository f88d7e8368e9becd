// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/collapsible_mesh.h"
#include "core/mesh/decimation/distinct_numbers.h"
#include "core/mesh/decimation/placed_value.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A vertex with the tetrahedra around it, as collapses of it see them. Coordinates are relative to the vertex.
class VertexStar {
public:
    static constexpr std::size_t lanes = 8;

    /// `points` live on. `exact`: their places are integers of at most 16 bits, so that volumes are exact.
    VertexStar(std::span<const PlacedValue> points, bool exact);

    /// `withRim`: whether rim() is wanted.
    void set(const CollapsibleMesh& mesh, std::uint32_t vertex, bool withRim);

    std::uint32_t vertex() const noexcept { return vertex_; }
    std::span<const std::uint32_t> slots() const noexcept { return slots_; }
    /// The vertices around, each once.
    std::span<const std::uint32_t> link() const noexcept { return link_; }
    /// The faces opposite to the vertex, one a slot, as places in link(); (vertex, face) is positive.
    std::span<const std::array<std::uint32_t, 3>> faces() const noexcept { return faces_; }
    /// A boundary triangle of the vertex: its face of slots()[slotPlace] has two more corners, places in link().
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

} // namespace tetra
