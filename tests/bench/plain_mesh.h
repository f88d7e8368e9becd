// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A tetrahedral mesh in doubles, with a value at each vertex.
struct PlainMesh {
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
};

} // namespace tetra
