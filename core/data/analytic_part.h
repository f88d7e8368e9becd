// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A mesh of tetrahedra, with a value in [0, 1] for each point.
struct AnalyticMesh {
    std::vector<Eigen::Vector3d> positions; ///< floats
    std::vector<std::array<std::uint32_t, 4>> tetrahedra;
    std::vector<double> values;
};

/// A machine part: a plate of 6 x 4 x 1 with five round holes through it, and, where a sixth one would be, a closed
/// cavity within; finer at the holes. `size` / 8 cells on half a hole's distance, at least 2; about size^3 / 20 points.
/// The field is the equivalent stress (von Mises) under tension along x, after the plane solution for one hole in an
/// infinite plate (G. Kirsch, "Die Theorie der Elastizitaet und die Beduerfnisse der Festigkeitslehre", 1898), what
/// the holes change added up, over the largest there can be. The same bits on every machine.
AnalyticMesh analyticPart(std::uint32_t size);

} // namespace tetra
