// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/mesh.h>

#include <Eigen/Core>

#include <cstdint>

namespace tetra {

/// From where cells are seen.
struct EyePoint {
    Eigen::Vector3d place{0, 0, 0}; ///< in orthographic views the direction towards the eye
    bool perspective = true;
};

/// For each cell, bit f: its face f is seen from outside by the eye; bit 4 + f: from inside; neither if the eye lies in
/// its plane. Exact for all finite positions (orientationSign()), so both cells of a face agree. O(cells), on all
/// threads of the current arena; where the eye lies within some 1e-12 of the plane, a face may take a microsecond.
Buffer<std::uint8_t> classifyFaces(const TetrahedralMesh& mesh, const EyePoint& eye);

} // namespace tetra
