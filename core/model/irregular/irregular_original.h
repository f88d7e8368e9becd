// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/irregular/boundary_surfaces.h"
#include "core/model/irregular/triangle_tree.h"
#include "core/model/verify_scattered.h"

#include <cstdint>
#include <string>
#include <vector>

namespace tetra {

/// The original of a model of irregular data, ready to be compared with. The dataset outlives it.
struct IrregularOriginal {
    /// `dataset` has tetrahedra; what is wrong with them is appended to `failures`.
    IrregularOriginal(const Dataset& dataset, std::vector<std::string>& failures);

    static constexpr std::uint32_t none = 0xffffffff;

    ScatteredOriginal points;
    std::vector<PointTriangle> boundary;
    BoundarySurfaces surfaces;
    std::vector<std::uint32_t> surfaceOf;   ///< of each point; none inside
    std::vector<std::uint32_t> componentOf; ///< of each point, the smallest point that it is joined with
    TriangleTree tree;                      ///< of `boundary`
    double diagonal = 0;
    double allowance = 0; ///< by which a claimed warping may be exceeded: coordinates are rounded

    bool isOnBoundary(std::uint32_t point) const { return surfaceOf[point] != none; }
};

} // namespace tetra
