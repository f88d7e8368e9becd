// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/apex_fan.h"
#include "core/mesh/decimation/collapsible_mesh.h"
#include "core/mesh/decimation/star_points.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A vertex with the tetrahedra around it, as collapses of it see them. Coordinates are relative to the vertex.
class VertexStar {
public:
    /// `exact`: the positions are integers of at most 16 bits, so that volumes are exact.
    VertexStar(std::span<const Eigen::Vector3d> positions, bool exact);

    void set(const CollapsibleMesh& mesh, std::uint32_t vertex);

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
    const std::array<double, 3>& place(std::uint32_t linkPlace) const noexcept { return places_[linkPlace]; }

    /// Whether all tetrahedra that a collapse onto a vertex of the link makes have a volume that is positive beyond
    /// doubt, and there are any.
    bool opensOnto(std::uint32_t linkPlace) const;
    bool holds(std::size_t face, std::uint32_t linkPlace) const
    {
        const auto& [a, b, c] = faces_[face];
        return a == linkPlace || b == linkPlace || c == linkPlace;
    }

private:
    /// Of a face: the volume of the tetrahedron with an apex p is offset - normal . p, to about `doubt` (1 + |p|).
    struct Plane {
        std::array<double, 3> normal{};
        double offset = 0;
        std::array<double, 3> magnitude{}; ///< of the normal's terms
        double offsetMagnitude = 0;
    };
    void addRim(const CollapsibleMesh::Tetrahedron& tetrahedron, std::size_t own);
    std::uint32_t linkPlaceOf(std::uint32_t vertex);
    Plane planeOf(const std::array<std::uint32_t, 3>& face) const;

    std::span<const Eigen::Vector3d> positions_;
    double doubt_;
    std::uint32_t vertex_ = CollapsibleMesh::none;
    std::vector<std::uint32_t> slots_;
    std::vector<std::uint32_t> link_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::vector<RimTriangle> rim_;
    std::vector<std::array<double, 3>> places_;
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> placeInLink_; ///< by vertex; valid if the link has the vertex there
};

} // namespace tetra
