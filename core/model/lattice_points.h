// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/lattice.h"

#include <Eigen/Core>

#include <cstdint>

namespace tetra {

/// Positions of many lattice points given by their index, without a division a point.
class LatticePoints {
public:
    explicit LatticePoints(const Lattice& lattice)
        : sizeX_(lattice.size[0]), sizeXy_(std::uint64_t(lattice.size[0]) * lattice.size[1]),
          perRow_(1.0 / lattice.size[0]), perSlice_(1.0 / static_cast<double>(sizeXy_)), spacing_(lattice.spacing),
          origin_(lattice.origin)
    {
    }

    /// Where Lattice::position() puts the point, rounded to float. Any index is harmless; one outside has no meaning.
    Eigen::Vector3f position(std::uint32_t index) const
    {
        const std::uint64_t slice = quotient(index, perSlice_);
        const std::uint64_t inSlice = index - slice * sizeXy_;
        const std::uint64_t row = quotient(inSlice, perRow_);
        const std::uint64_t inRow = inSlice - row * sizeX_;
        return (origin_ + spacing_.cwiseProduct(Eigen::Vector3d(static_cast<double>(inRow), static_cast<double>(row),
                                                                static_cast<double>(slice))))
            .cast<float>();
    }

private:
    /// Exact: half a unit away from the next integer the product errs by less than that, for 32-bit numbers.
    static std::uint64_t quotient(std::uint64_t number, double perUnit)
    {
        return static_cast<std::uint64_t>(
            static_cast<std::int64_t>((static_cast<double>(static_cast<std::int64_t>(number)) + 0.5) * perUnit));
    }

    std::uint64_t sizeX_;
    std::uint64_t sizeXy_;
    double perRow_;
    double perSlice_;
    Eigen::Vector3d spacing_;
    Eigen::Vector3d origin_;
};

} // namespace tetra
