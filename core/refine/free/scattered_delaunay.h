// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/base.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// An incremental Delaunay tetrahedrization of points anywhere in space, by exact predicates (CGAL). Cospherical points
/// are perturbed symbolically, so that the mesh depends on the set of its points alone and no cell is ever flat. Cells
/// are numbered by slots, which are used again. Not for several threads at once.
class ScatteredDelaunay {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    struct Cell {
        std::uint32_t slot = none;
        std::array<std::uint32_t, 4> points{}; ///< positive: (b-a) . ((c-a) x (d-a)) > 0
    };

    /// The positions are finite, outlive it and do not move.
    explicit ScatteredDelaunay(std::span<const Eigen::Vector3d> positions);
    ~ScatteredDelaunay();
    ScatteredDelaunay(const ScatteredDelaunay&) = delete;
    ScatteredDelaunay& operator=(const ScatteredDelaunay&) = delete;

    /// Makes the mesh of the corners of the points' convex hull, which are `created()`'s points. The error (BadInput)
    /// says what the points lack: too few, all on one line, all in one plane.
    Status start();
    /// The slot of a cell that holds the point, looked for from `hint` on; none if it is outside the mesh.
    std::uint32_t locate(std::uint32_t point, std::uint32_t hint) const;
    /// The slot of one of the created() cells that holds the point, which lies in what the last insertion emptied. A
    /// point on the rim is in cells outside as well; those keep what they had.
    std::uint32_t locateInStar(std::uint32_t point, std::uint32_t hint) const;
    /// Inserts a point that is no vertex and lies in the cell `slot`.
    void insert(std::uint32_t point, std::uint32_t slot);

    /// What the last insertion, or the start, made and removed. The inserted point is the first of each created cell's.
    std::span<const Cell> created() const noexcept { return created_; }
    std::span<const std::uint32_t> destroyed() const noexcept { return destroyed_; } ///< slots, free again

    /// The mesh, of the same positions.
    void archive(StateArchive& archive);

private:
    struct Mesh;
    std::unique_ptr<Mesh> mesh_;
    std::vector<Cell> created_;
    std::vector<std::uint32_t> destroyed_;
};

} // namespace tetra
