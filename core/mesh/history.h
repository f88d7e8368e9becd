// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstdint>
#include <span>

namespace tetra {

/// A tetrahedron of the history, as its creator (the latest of its four sites) knows it: (creator, sites[0], sites[1],
/// sites[2]) is positive. Sites are numbered in order of insertion.
struct HistoryTetrahedron {
    std::array<std::uint32_t, 3> sites{};
    float error = 0; ///< bound on its own error (2.3), in units of the values, never rounded down
};

/// One site entering the mesh, with all that it changes (DESIGN: a mesh is a closed set of sites).
struct HistoryStep {
    std::uint64_t point = 0;                  ///< the dataset's point that becomes the next site
    float errorBefore = 0;                    ///< error of the whole mesh just before; infinity for the initial sites
    std::span<const HistoryTetrahedron> star; ///< the tetrahedra that it creates; history indices go on from the last
    std::span<const std::uint32_t> destroyed; ///< history indices of the tetrahedra that it destroys
};

/// Takes a history while a builder makes it, coarse first. Called from one thread.
class HistorySink {
public:
    virtual ~HistorySink() = default;
    /// An error (a full disk) ends the build.
    virtual Status add(const HistoryStep& step) = 0;
    /// The build is complete; `finalError` bounds the error of the last mesh.
    virtual Status finish(float finalError) = 0;
};

} // namespace tetra
