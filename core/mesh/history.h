// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// A tetrahedron of the history, as its creator (the latest of its four sites) knows it: (creator, sites[0], sites[1],
/// sites[2]) is positive in the space that the mesh was made in (computational space for curvilinear data). Sites are
/// numbered in order of insertion.
struct HistoryTetrahedron {
    std::array<std::uint32_t, 3> sites{};
    float error = 0;   ///< bound on its own error (2.3), in units of the values, never rounded down
    float warping = 0; ///< bound on its own warping (R4), in units of length, never rounded down
};

/// One site entering the mesh, with all that it changes (DESIGN: a mesh is a closed set of sites).
struct HistoryStep {
    std::uint64_t point = 0; ///< the dataset's point that becomes the next site
    /// How far the whole mesh just before was from the data, in units of the values: its error, or with warping the
    /// larger of the error and HistoryTraits::warpingWeight times the warping (S4). Infinity for the initial sites and
    /// for a mesh that is not consistent (S5).
    float keyBefore = 0;
    std::span<const HistoryTetrahedron> star; ///< the tetrahedra that it creates; history indices go on from the last
    std::span<const std::uint32_t> destroyed; ///< history indices of the tetrahedra that it destroys
};

/// What holds for a history as a whole.
struct HistoryTraits {
    /// Units of the values for a unit of length: makes errors and warpings comparable (S4). 0 where there is no
    /// warping, as in convex domains.
    double warpingWeight = 0;
    /// Whether the mesh of every prefix is the Delaunay mesh of its sites, so that any set of sites has a mesh. False
    /// for decimation: there only closed sets have one.
    bool delaunay = true;
};

/// Takes a history while a builder makes it, coarse first. Called from one thread.
class HistorySink {
public:
    virtual ~HistorySink() = default;
    /// Comes first, if anything but the defaults holds.
    virtual Status begin(const HistoryTraits& /*traits*/) { return {}; }
    /// An error (a full disk) ends the build.
    virtual Status add(const HistoryStep& step) = 0;
    /// The build is complete; `finalKey` bounds the last mesh's distance from the data, as HistoryStep::keyBefore.
    virtual Status finish(float finalKey) = 0;
};

} // namespace tetra
