// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/verify/exact_cell.h"

#include <tan/base.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tetra {

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
