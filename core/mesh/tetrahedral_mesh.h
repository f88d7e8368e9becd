// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>

namespace tetra {

/// A conforming tetrahedral mesh with a value at each vertex (2.2), as plain arrays. What extraction gives and what
/// graphics draws. Tetrahedra (a, b, c, d) are positive: (b-a) . ((c-a) x (d-a)) > 0.
struct TetrahedralMesh {
    Buffer<Eigen::Vector3f> positions;
    Buffer<float> values;
    Buffer<std::array<std::uint32_t, 4>> tetrahedra;
};

} // namespace tetra
