// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/mesh/packed_lattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The bounding boxes of many tetrahedra, side by side so that all are compared with a box at a glance: 12 bytes each.
class TetrahedronBoxes {
public:
    /// May throw std::bad_alloc, as the others.
    void assign(const PackedLattice& lattice, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                std::span<const PackedPoint> vertices);

    /// Appends the numbers of those that may have a point in common with the box; never too few. O(tetrahedra), some
    /// thousand million a second.
    void findMeeting(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last,
                     std::vector<std::uint32_t>& found) const;

private:
    std::array<Buffer<std::uint16_t>, 3> first_;
    std::array<Buffer<std::uint16_t>, 3> last_;
};

} // namespace tetra
