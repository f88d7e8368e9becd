// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// The tetrahedra of an ApexFan, as its members of the same names give them.
struct FanTetrahedra {
    std::span<const double> columns;
    std::size_t columnLength;
    std::span<const std::uint32_t> faces;
    std::array<double, 3> apex;
};

/// Finds out which tetrahedra of a fan places lie in, eight at once. Refers to what the tetrahedra refer to.
class FanLocation {
public:
    /// For about `placeCount` places.
    FanLocation(const FanTetrahedra& tetrahedra, std::size_t placeCount);

    /// For eight places, given by their coordinates, the face of the tetrahedron that has each: the one whose smallest
    /// weight is largest, of equals the first, so that rounding leaves no place without one. And how far the value
    /// there is from the apex's. Soonest done where places come in an order in which near ones follow one another.
    void locateEight(const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps);

private:
    FanTetrahedra tetrahedra_;
    bool many_;
    std::size_t latest_ = 0; ///< the tetrahedron of one of the places before, in faces
};

} // namespace tetra
