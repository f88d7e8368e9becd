// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/packed_lattice.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

namespace tetra {

/// The values of a lattice's points in whatever type they came, read as doubles. Owns nothing; a cheap value.
class LatticeSamples {
public:
    template <class T> explicit LatticeSamples(std::span<const T> samples) : samples_(samples.data()) {}

    /// values[i] = the sample of points[i].
    void gather(const PackedLattice& lattice, std::span<const PackedPoint> points, double* values) const
    {
        std::visit(
            [&](const auto* samples) {
                for (std::size_t i = 0; i < points.size(); ++i)
                    values[i] = static_cast<double>(samples[lattice.index(points[i])]);
            },
            samples_);
    }

private:
    std::variant<const std::uint8_t*, const std::int8_t*, const std::uint16_t*, const std::int16_t*,
                 const std::uint32_t*, const std::int32_t*, const float*, const double*>
        samples_;
};

} // namespace tetra
