// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/tetrahedron_boxes.h"

#include "core/base/simd.h"

#include <algorithm>

namespace tetra {

namespace {

/// Coordinates that do not fit count as the largest that do, everywhere: then boxes are only larger.
std::uint16_t shortened(std::int32_t coordinate)
{
    return static_cast<std::uint16_t>(std::clamp(coordinate, 0, 0xffff));
}

constexpr std::size_t boxesAtOnce = 4096;

TETRA_SIMD_CLONES void keepMeeting(const std::uint16_t* first, const std::uint16_t* last, std::size_t count,
                                   std::uint16_t from, std::uint16_t to, std::uint16_t* meets)
{
    for (std::size_t i = 0; i < count; ++i)
        meets[i] = static_cast<std::uint16_t>(meets[i] & (first[i] <= to ? 1 : 0) & (last[i] >= from ? 1 : 0));
}

} // namespace

void TetrahedronBoxes::assign(const PackedLattice& lattice, std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                              std::span<const PackedPoint> vertices)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first_[axis].resize(tetrahedra.size());
        last_[axis].resize(tetrahedra.size());
    }
    for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
        const auto keep = [&](std::size_t axis, auto coordinate) {
            const auto& [a, b, c, d] = tetrahedra[i];
            const auto [least, largest] = std::minmax(
                {coordinate(vertices[a]), coordinate(vertices[b]), coordinate(vertices[c]), coordinate(vertices[d])});
            first_[axis][i] = shortened(least);
            last_[axis][i] = shortened(largest);
        };
        keep(0, [&](PackedPoint point) { return lattice.x(point); });
        keep(1, [&](PackedPoint point) { return lattice.y(point); });
        keep(2, [&](PackedPoint point) { return lattice.z(point); });
    }
}

void TetrahedronBoxes::findMeeting(const std::array<std::int32_t, 3>& first, const std::array<std::int32_t, 3>& last,
                                   std::vector<std::uint32_t>& found) const
{
    const std::size_t count = first_[0].size();
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (first[axis] > last[axis])
            return;
    std::array<std::uint16_t, boxesAtOnce> meets{};
    for (std::size_t start = 0; start < count; start += boxesAtOnce) {
        const std::size_t piece = std::min(boxesAtOnce, count - start);
        meets.fill(1);
        for (std::size_t axis = 0; axis < 3; ++axis)
            keepMeeting(first_[axis].data() + start, last_[axis].data() + start, piece, shortened(first[axis]),
                        shortened(last[axis]), meets.data());
        for (std::size_t i = 0; i < piece; ++i)
            if (meets[i] != 0)
                found.push_back(static_cast<std::uint32_t>(start + i));
    }
}

} // namespace tetra
