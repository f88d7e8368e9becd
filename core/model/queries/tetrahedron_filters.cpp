// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/tetrahedron_filters.h"

#include "core/model/queries/tetrahedron_meets.h"

#include <algorithm>

namespace tetra {

bool canContain(const std::array<float, 4>& values, std::span<const ValueRange> ranges)
{
    const double least = std::min(std::min(values[0], values[1]), std::min(values[2], values[3]));
    const double largest = std::max(std::max(values[0], values[1]), std::max(values[2], values[3]));
    const auto overlaps = [least, largest](const ValueRange& range) {
        return largest >= range.minimum && least <= range.maximum && range.minimum <= range.maximum;
    };
    return ranges.empty() || std::ranges::any_of(ranges, overlaps);
}

BoxSides::BoxSides(const Box& box, std::span<const Eigen::Vector3f> positions)
    : box_(box), positions_(positions), sides_(positions.size())
{
    const bool isEmpty = (box.least.array() > box.largest.array()).any();
    for (std::size_t vertex = 0; vertex < positions.size(); ++vertex) {
        unsigned sides = isEmpty ? ~0u : 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = positions[vertex][axis];
            sides |= unsigned(coordinate < box.least[axis]) << 2 * axis;
            sides |= unsigned(coordinate > box.largest[axis]) << (2 * axis + 1);
        }
        sides_[vertex] = static_cast<std::uint8_t>(sides);
    }
}

bool BoxSides::meets(const std::array<std::uint32_t, 4>& tetrahedron) const
{
    if (const Place place = placeOf(tetrahedron); place != Place::Across)
        return place == Place::Inside;
    Corners corners;
    for (int corner = 0; corner < 4; ++corner) {
        if (sides_[tetrahedron[corner]] == 0)
            return true;
        corners[corner] = positions_[tetrahedron[corner]].cast<double>();
    }
    return tetrahedronMeetsBox(corners, box_, 0);
}

} // namespace tetra
