// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/decimation/decimation.h"

#include <cstdint>
#include <vector>

namespace tetra {

/// A copy of a mesh in which what lies near in space lies near in memory: points along a Hilbert curve, tetrahedra by
/// their first point. Looking at a star then waits for memory a third as long.
class RenumberedMesh {
public:
    /// May throw std::bad_alloc.
    explicit RenumberedMesh(const DecimationMesh& mesh);

    /// Refers to this.
    DecimationMesh view() const { return {positions_, lifted_, values_, weights_, tetrahedra_, box_, leftHanded_}; }
    /// For each point its number in the mesh that was copied.
    const std::vector<std::uint32_t>& originals() const noexcept { return originals_; }

private:
    std::vector<std::uint32_t> originals_;
    std::vector<Eigen::Vector3d> positions_;
    std::vector<Eigen::Vector3d> lifted_;
    std::vector<double> values_;
    std::vector<float> weights_;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra_;
    bool box_;
    bool leftHanded_;
};

} // namespace tetra
