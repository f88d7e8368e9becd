// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/box_tree.h"
#include "core/verify/exact_cell.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetra {

/// The points of a grid where they lie in space, in a tree of the boxes around two by two by two of them, to find those
/// in a tetrahedron. Some 10 bytes a point. Safe to ask from any number of threads.
class GridPoints {
public:
    explicit GridPoints(const Dataset& grid);

    /// Calls visit(point) for all points in the boxes which meets(box) says yes of, and for some more near them.
    template <class Meets, class Visit> void visitNear(const Meets& meets, const Visit& visit) const
    {
        tree_.visitNear(meets, [&](std::uint32_t block) {
            if (meets(boxes_[block]))
                forEachPoint(block, visit);
        });
    }

private:
    template <class Visit> void forEachPoint(std::uint32_t block, const Visit& visit) const
    {
        std::array<std::uint32_t, 3> first{}, end{};
        for (std::size_t axis = 0; axis < 3; block /= blocks_[axis++]) {
            first[axis] = 2 * (block % blocks_[axis]);
            end[axis] = std::min(first[axis] + 2, lattice_.size[axis]);
        }
        for (std::uint32_t k = first[2]; k < end[2]; ++k)
            for (std::uint32_t j = first[1]; j < end[1]; ++j)
                for (std::uint32_t i = first[0]; i < end[0]; ++i)
                    visit(lattice_.index(i, j, k));
    }

    Lattice lattice_;
    std::array<std::uint32_t, 3> blocks_{}; ///< along each axis
    std::vector<Eigen::AlignedBox3d> boxes_;
    BoxTree tree_;
};

/// The grid of a model of curvilinear data as verification sees it: its hand, its folded cells, and so which
/// tetrahedra may be inverted (S5, FORMAT.md). Exact; finds all that by itself and in another way than builders do.
class CurvilinearOriginal {
public:
    /// `original` is curvilinear. Says in `failures` if `leftHanded`, the model's word, is not true of it. An Error
    /// only if cancelled.
    static Result<CurvilinearOriginal> make(const Dataset& original, bool leftHanded,
                                            std::vector<std::string>& failures, const Progress& progress);

    /// The sign of volumes that are not inverted.
    int hand() const noexcept { return hand_; }
    std::uint64_t foldedCells() const noexcept { return folded_.size(); }
    /// Cells are numbered as they lie, x fastest. In order.
    std::vector<std::uint64_t> foldedCellNumbers() const;
    /// Those none of whose corner tetrahedra has volume.
    const std::vector<std::uint64_t>& cellsWithoutVolume() const noexcept { return withoutVolume_; }
    /// Whether a tetrahedron of these points, positive in computational space, is allowed if it is inverted
    /// (FORMAT.md).
    bool allowsInverted(const LatticeCorners& corners) const;

private:
    std::uint64_t numberOf(const LatticePoint& cell) const;

    int hand_ = 1;
    std::array<std::uint32_t, 3> size_{}; ///< points along each axis
    std::vector<LatticePoint> folded_;    ///< the first corners of these cells, as z, y, x; sorted
    std::vector<std::uint64_t> withoutVolume_;
};

/// How many tetrahedra are inverted in physical space in each of several meshes, those of the first `sites` sites (S5):
/// none but of curvilinear data. Exact; O(tetrahedra) for these, on all threads. Error: the file is inconsistent; of
/// indices that are merely wrong the count is.
TAN_INTERNAL Result<std::vector<std::uint64_t>> countInverted(const Model& model, std::span<const std::uint32_t> sites);

} // namespace tetra
