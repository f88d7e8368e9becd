// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/scalar_field.h"
#include "core/model/queries/mesh_query.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Whether a tetrahedron can contain a value of one of the ranges, ends included. Without ranges it can.
bool canContain(const std::array<float, 4>& values, std::span<const ValueRange> ranges);

/// On which sides of a box many places lie, for tests of the tetrahedra between them that look at few coordinates.
class BoxSides {
public:
    BoxSides() = default;
    /// `positions` live as long as this. All lie outside of a box whose least corner is not the least.
    BoxSides(const Box& box, std::span<const Eigen::Vector3f> positions);

    enum class Place { Inside, Outside, Across }; ///< wholly within; wholly beyond a face of the box; anything else
    Place placeOf(const std::array<std::uint32_t, 4>& tetrahedron) const
    {
        const auto [a, b, c, d] = tetrahedron;
        if ((sides_[a] | sides_[b] | sides_[c] | sides_[d]) == 0)
            return Place::Inside;
        return (sides_[a] & sides_[b] & sides_[c] & sides_[d]) != 0 ? Place::Outside : Place::Across;
    }
    /// Whether they have a common point.
    bool meets(const std::array<std::uint32_t, 4>& tetrahedron) const;

private:
    Box box_;
    std::span<const Eigen::Vector3f> positions_;
    std::vector<std::uint8_t> sides_; ///< a bit for each face of the box that the place lies beyond
};

} // namespace tetra
