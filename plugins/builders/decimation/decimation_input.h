// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/data/dataset.h"
#include "core/data/weighting.h"
#include "core/decimate/decimation.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A dataset as a mesh that can be decimated: irregular data as they are, lattices and curvilinear grids cut into
/// tetrahedra in computational space, where collapsed lines and cells without volume do no harm (S6).
class DecimationInput {
public:
    /// `dataset` must outlive the input; irregular, regular or curvilinear, with a cell or more. Errors: cancelled, not
    /// enough memory.
    static Result<DecimationInput> make(const Dataset& dataset, const Weighting& weighting, const Progress& progress);

    DecimationMesh mesh() const;

private:
    explicit DecimationInput(const Dataset& dataset) : dataset_(&dataset) {}

    const Dataset* dataset_;
    std::vector<Eigen::Vector3d> positions_; ///< of lattices and grids
    std::vector<double> values_;
    std::vector<float> weights_;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra_; ///< of lattices and grids
};

/// How tetrahedra that are positive where they were made lie in physical space.
struct PhysicalSigns {
    std::uint64_t inverted = 0;   ///< turned over (S5): against the side that most of the grid's cells turn to
    std::uint64_t degenerate = 0; ///< without volume (S6)
};

/// Of a curvilinear dataset; exact. O(tetrahedra).
PhysicalSigns physicalSigns(const Dataset& dataset, std::span<const std::array<std::uint32_t, 4>> tetrahedra);

} // namespace tetra
