// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"

#include <array>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tetra {

/// The removed points of a star side by side, for arithmetic on eight at once: arrays are filled up to a multiple of
/// eight with copies of the first point.
struct StarPoints {
    static constexpr std::size_t lanes = 8;

    std::vector<std::uint32_t> points;   ///< their numbers; count() of them
    std::array<Buffer<double>, 3> place; ///< where errors are measured, from the star's vertex
    Buffer<double> value;
    Buffer<double> weight;                ///< empty: 1
    std::array<Buffer<double>, 3> lifted; ///< in physical space; empty: no warping

    Buffer<std::uint32_t> owner; ///< by the last evaluation: which tetrahedron has the point
    Buffer<double> error;        ///< by the last evaluation, weighted
    Buffer<double> warping;      ///< likewise, where points are lifted

    std::size_t count() const noexcept { return points.size(); }
};

} // namespace tetra
