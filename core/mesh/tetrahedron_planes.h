// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>

#include <array>

namespace tetra {

/// The planes of a positive tetrahedron and its box, as a quick test that never rejects what is inside.
class TetrahedronPlanes {
public:
    explicit TetrahedronPlanes(const std::array<Eigen::Vector3d, 4>& corners);
    bool mayMeet(const Eigen::AlignedBox3d& box) const;

private:
    std::array<Eigen::Vector3d, 4> origins_;
    std::array<Eigen::Vector3d, 4> normals_;    ///< inwards
    std::array<Eigen::Vector3d, 4> magnitudes_; ///< what the normals' rounding errors are relative to
    Eigen::AlignedBox3d box_;
};

} // namespace tetra
