// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/data/dataset.h"

#include <array>
#include <limits>
#include <vector>

namespace tetra {

/// How many of a dataset's points a mesh of some error takes, as a few thousand of them let expect: where the field is
/// nearly linear the vertices may lie far apart. A value, immutable.
class SiteDensity {
public:
    /// Nothing is known: every point may be needed.
    SiteDensity() = default;
    /// Lattices and grids: reads 4,096 points and their neighbours at distances up to 16, so that a mapped file is not
    /// read as a whole. Other data: a linear fit to the nearest points of 16 to 512, O(points) for each of these: a
    /// second for some fifty million. The same result every time; nothing is known if it was cancelled.
    static SiteDensity of(const Dataset& dataset, const Progress& progress = {});

    bool known() const noexcept { return !deviations_.empty(); }
    /// The share of the points, in (0, 1]. `error`: as a share of the values' extent and, of curvilinear grids, of the
    /// diagonal. Within a factor of two of what refinement takes of the datasets that it was measured with.
    double share(double error) const;

private:
    static constexpr int levels = 5;
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    /// Of a point: what its neighbours at the distances 1, 2, 4 ... of points tell, less what it is; the largest up to
    /// each distance, as a share of the extent.
    using Deviations = std::array<float, levels>;
    static Deviations onLattice(const Dataset& dataset, std::uint64_t point, double diagonal);
    static Deviations amongPoints(const Dataset& dataset, std::uint64_t point);

    std::vector<Deviations> deviations_;
    /// How far apart sites can be along each axis, in steps of the lattice: no farther than it is long.
    std::array<double, 3> longest_ = {infinite, infinite, infinite};
};

} // namespace tetra
