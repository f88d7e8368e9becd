// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/mesh.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra::python {

/// A place in a tetrahedron: which one, and the weights of its corners, which sum up to 1.
struct Location {
    std::uint32_t tetrahedron = 0;
    std::array<double, 4> weights{};
};

/// Finds the tetrahedra in which places lie: a binary tree of boxes over the mesh's tetrahedra, halved at the median of
/// their middles along the longest axis, down to leaves of eight. Immutable once made; read from any thread. O(n log n)
/// to make, some 12 bytes a tetrahedron; O(log n) a place as a rule. The mesh must live as long.
class PointLocation {
public:
    /// Nothing if it was cancelled.
    static std::optional<PointLocation> of(const TetrahedralMesh& mesh, const Progress& progress);

    /// Of several tetrahedra in which the place lies, as on a common face, the one in which it lies deepest. A place
    /// outside by less than a thousand-millionth of a tetrahedron's height counts as inside, since weights are rounded.
    std::optional<Location> find(const Eigen::Vector3d& place) const;

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::uint32_t first = 0; ///< of its tetrahedra in order_
        std::uint32_t count = 0;
        std::uint32_t second = 0; ///< the second half; the first one follows the node; 0: a leaf
    };

    explicit PointLocation(const TetrahedralMesh& mesh) : mesh_(&mesh) {}
    Eigen::AlignedBox3d boxOf(std::uint32_t tetrahedron) const;
    std::uint32_t divide(std::uint32_t first, std::uint32_t count);
    std::array<double, 4> weightsIn(std::uint32_t tetrahedron, const Eigen::Vector3d& place) const;

    const TetrahedralMesh* mesh_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace tetra::python
