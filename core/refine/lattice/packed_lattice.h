// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// A lattice point's three coordinates in one 32-bit number, so that geometry needs no look-up of vertices. The widths
/// of the fields follow the lattice's size. As numbers, points are in the order of the lattice, x running fastest.
using PackedPoint = std::uint32_t;

/// Packs and unpacks the points of one lattice.
class PackedLattice {
public:
    explicit PackedLattice(const std::array<std::uint32_t, 3>& size)
        : size_(size), shiftY_(width(size[0])), shiftZ_(shiftY_ + width(size[1])), maskX_((1u << shiftY_) - 1),
          maskY_((1u << width(size[1])) - 1), maskZ_((1u << width(size[2])) - 1)
    {
    }

    /// Whether the coordinates fit.
    static bool fits(const std::array<std::uint32_t, 3>& size)
    {
        return width(size[0]) + width(size[1]) + width(size[2]) <= 32 && width(size[0]) < 32 && width(size[1]) < 32 &&
               width(size[0]) + width(size[1]) < 32;
    }

    const std::array<std::uint32_t, 3>& size() const noexcept { return size_; }
    PackedPoint pack(std::uint32_t x, std::uint32_t y, std::uint32_t z) const noexcept
    {
        return x | y << shiftY_ | z << shiftZ_;
    }
    std::int32_t x(PackedPoint point) const noexcept { return static_cast<std::int32_t>(point & maskX_); }
    std::int32_t y(PackedPoint point) const noexcept { return static_cast<std::int32_t>(point >> shiftY_ & maskY_); }
    std::int32_t z(PackedPoint point) const noexcept { return static_cast<std::int32_t>(point >> shiftZ_); }

    /// The coordinates of several points at once, in the compiler's vectors of int.
    template <class Ints> void unpack(const Ints& points, Ints& x, Ints& y, Ints& z) const noexcept
    {
        x = points & static_cast<int>(maskX_);
        y = points >> static_cast<int>(shiftY_) & static_cast<int>(maskY_);
        z = points >> static_cast<int>(shiftZ_) & static_cast<int>(maskZ_);
    }

    /// The point's number in the lattice, the first coordinate running fastest.
    std::uint32_t index(PackedPoint point) const noexcept
    {
        const std::uint32_t row = (point >> shiftZ_) * size_[1] + (point >> shiftY_ & maskY_);
        return row * size_[0] + (point & maskX_);
    }
    /// The point of that number; of one that is too large, some point of the lattice.
    PackedPoint pointAt(std::uint32_t index) const noexcept
    {
        const std::uint32_t row = index / size_[0];
        return pack(index - row * size_[0], row % size_[1], std::min(row / size_[1], size_[2] - 1));
    }

private:
    static std::uint32_t width(std::uint32_t count) { return static_cast<std::uint32_t>(std::bit_width(count - 1)); }

    std::array<std::uint32_t, 3> size_;
    std::uint32_t shiftY_;
    std::uint32_t shiftZ_;
    std::uint32_t maskX_;
    std::uint32_t maskY_;
    std::uint32_t maskZ_;
};

/// indices[i] = lattice.index(points[i]), several at a time.
void latticeIndices(const PackedLattice& lattice, std::span<const PackedPoint> points, std::uint32_t* indices);

/// A box of points in a larger lattice.
struct LatticeBox {
    std::array<std::uint32_t, 3> origin{0, 0, 0}; ///< its first point
    std::array<std::uint32_t, 3> size{2, 2, 2};   ///< points along each axis

    std::uint32_t last(std::size_t axis) const noexcept { return origin[axis] + size[axis] - 1; }
    /// Corner 0 to 7: the bits of its number choose the last point along x, y and z.
    std::array<std::uint32_t, 3> corner(std::uint32_t number) const noexcept
    {
        return {(number & 1) != 0 ? last(0) : origin[0], (number >> 1 & 1) != 0 ? last(1) : origin[1],
                (number >> 2 & 1) != 0 ? last(2) : origin[2]};
    }
    std::uint64_t pointCount() const noexcept { return std::uint64_t(size[0]) * size[1] * size[2]; }
};

/// Integer weights of the squared coordinate differences, in the ratio of the squared spacings: with them the in-sphere
/// test of physical space stays exact in lattice coordinates (S8). (1, 1, 1) for cubic cells.
using LatticeMetric = std::array<std::uint32_t, 3>;

/// The weights for a lattice: exact ratios where small integers hold them, else the closest for which every in-sphere
/// determinant stays below 2^53 and so exact in a double. Error: the lattice is too large even for (1, 1, 1).
Result<LatticeMetric> latticeMetric(const std::array<std::uint32_t, 3>& size, const Eigen::Vector3d& spacing);

/// Whether a lattice of this size is exact with this metric.
bool exactWithMetric(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric);

} // namespace tetra
