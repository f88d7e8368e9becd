// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Some of many points, by their places: a grid of about as many cubes as points are expected. 4 bytes a point and
/// 4 bytes a cube.
class PointGrid {
public:
    /// `positions` outlives the grid. May throw std::bad_alloc.
    PointGrid(std::span<const Eigen::Vector3d> positions, std::size_t expected) : positions_(positions)
    {
        if (expected == 0)
            return;
        Eigen::AlignedBox3d box;
        for (const Eigen::Vector3d& position : positions)
            box.extend(position);
        corner_ = box.min();
        const double largest = box.sizes().maxCoeff();
        constexpr double flattest = 1e-3; // so that the cubes of flat boxes are not too many along them
        const Eigen::Array3d sizes = box.sizes().array().max(flattest * largest);
        const double edge = std::cbrt(sizes.prod() / static_cast<double>(expected));
        perLength_ = edge > 0 ? 1 / edge : 0;
        for (int axis = 0; axis < 3; ++axis)
            counts_[axis] = static_cast<std::uint32_t>(box.sizes()[axis] * perLength_) + 1;
        first_.assign(std::size_t(counts_[0]) * counts_[1] * counts_[2], end);
        next_.assign(positions.size(), absent);
    }

    /// A point that is there already stays. O(1).
    void insert(std::uint32_t point)
    {
        if (next_[point] != absent)
            return;
        const std::array<std::uint32_t, 3> cube = cubeOf(positions_[point]);
        std::uint32_t& first = first_[numberOf(cube[0], cube[1], cube[2])];
        next_[point] = first;
        first = point;
    }

    /// Calls visit(point) with each point in the box, borders included. O(cubes that meet it and points there).
    template <class Visit> void visitIn(const Eigen::AlignedBox3d& box, const Visit& visit) const
    {
        if (first_.empty())
            return;
        const auto from = cubeOf(box.min()), to = cubeOf(box.max());
        for (std::uint32_t z = from[2]; z <= to[2]; ++z)
            for (std::uint32_t y = from[1]; y <= to[1]; ++y)
                for (std::uint32_t x = from[0]; x <= to[0]; ++x)
                    for (std::uint32_t point = first_[numberOf(x, y, z)]; point != end; point = next_[point])
                        if (box.contains(positions_[point]))
                            visit(point);
    }

    void archive(StateArchive& archive) { archive(first_, next_); }

private:
    static constexpr std::uint32_t end = 0xffffffff;    ///< of a cube's points
    static constexpr std::uint32_t absent = 0xfffffffe; ///< what follows a point that is not there

    std::array<std::uint32_t, 3> cubeOf(const Eigen::Vector3d& place) const
    {
        std::array<std::uint32_t, 3> cube{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto k = static_cast<Eigen::Index>(axis);
            const double number = std::max((place[k] - corner_[k]) * perLength_, 0.0);
            cube[axis] = static_cast<std::uint32_t>(std::min(number, static_cast<double>(counts_[axis] - 1)));
        }
        return cube;
    }
    std::size_t numberOf(std::uint32_t x, std::uint32_t y, std::uint32_t z) const
    {
        return (std::size_t(z) * counts_[1] + y) * counts_[0] + x;
    }

    std::span<const Eigen::Vector3d> positions_;
    Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
    double perLength_ = 0;
    std::array<std::uint32_t, 3> counts_{1, 1, 1};
    std::vector<std::uint32_t> first_; ///< of each cube
    std::vector<std::uint32_t> next_;  ///< of each point
};

} // namespace tetra
