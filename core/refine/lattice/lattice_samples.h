// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <variant>

namespace tetra {

/// The values of a lattice's points in whatever type they came, read as doubles, and optionally a weight for each that
/// its error is multiplied by (R6). Owns nothing; a cheap value.
class LatticeSamples {
public:
    /// `weights` are finite and not negative, one for each sample; empty: all are 1.
    template <class T> explicit LatticeSamples(std::span<const T> samples, std::span<const float> weights = {})
        : samples_(samples.data()), weights_(weights.empty() ? nullptr : weights.data())
    {
    }

    /// Whether the interpolation's numerators are exact integers in a double.
    bool exact() const
    {
        return std::visit([]<class T>(const T*) { return std::is_integral_v<T> && sizeof(T) <= 2; }, samples_);
    }
    bool weighted() const noexcept { return weights_ != nullptr; }

    /// Calls `function` with the pointer to the first sample, of its own type, and gives what it gives.
    template <class Function> decltype(auto) visit(Function&& function) const { return std::visit(function, samples_); }

    /// values[i] = the sample of points[i].
    void gather(const PackedLattice& lattice, std::span<const PackedPoint> points, double* values) const
    {
        std::visit(
            [&lattice, points, values](const auto* samples) {
                std::array<std::uint32_t, 64> indices;
                for (std::size_t first = 0; first < points.size(); first += indices.size()) {
                    const std::size_t count = std::min(indices.size(), points.size() - first);
                    latticeIndices(lattice, points.subspan(first, count), indices.data());
                    for (std::size_t i = 0; i < count; ++i)
                        values[first + i] = static_cast<double>(samples[indices[i]]);
                }
            },
            samples_);
    }

    /// Only if weighted().
    float weight(const PackedLattice& lattice, PackedPoint point) const { return weights_[lattice.index(point)]; }

    /// A copy of the box's samples and weights out of those of a lattice of `latticeSize` points, in `scratch`, which
    /// must outlive it.
    LatticeSamples copyBox(const std::array<std::uint32_t, 3>& latticeSize, const LatticeBox& box,
                           Buffer<std::byte>& scratch) const
    {
        const std::uint64_t count = std::uint64_t(box.size[0]) * box.size[1] * box.size[2];
        const std::uint64_t weightBytes = weighted() ? count * sizeof(float) : 0;
        return std::visit(
            [&]<class T>(const T* samples) {
                const std::uint64_t first = (weightBytes + sizeof(T) - 1) / sizeof(T) * sizeof(T); // aligned
                scratch.resize(first + count * sizeof(T));
                copyRows(samples, latticeSize, box, scratch.data() + first);
                if (weighted())
                    copyRows(weights_, latticeSize, box, scratch.data());
                return LatticeSamples(
                    std::span(reinterpret_cast<const T*>(scratch.data() + first), count),
                    std::span(reinterpret_cast<const float*>(scratch.data()), weightBytes / sizeof(float)));
            },
            samples_);
    }

private:
    template <class T> static void copyRows(const T* from, const std::array<std::uint32_t, 3>& latticeSize,
                                            const LatticeBox& box, std::byte* to)
    {
        const std::size_t rowBytes = box.size[0] * sizeof(T);
        for (std::uint64_t z = box.origin[2]; z < box.origin[2] + box.size[2]; ++z)
            for (std::uint64_t y = box.origin[1]; y < box.origin[1] + box.size[1]; ++y, to += rowBytes)
                std::memcpy(to, from + (z * latticeSize[1] + y) * latticeSize[0] + box.origin[0], rowBytes);
    }

    std::variant<const std::uint8_t*, const std::int8_t*, const std::uint16_t*, const std::int16_t*,
                 const std::uint32_t*, const std::int32_t*, const float*, const double*>
        samples_;
    const float* weights_;
};

} // namespace tetra
