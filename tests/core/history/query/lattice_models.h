// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>

namespace tetra {

/// What the samples of a random dataset look like.
enum class LatticeKind {
    Ties,   ///< uint8 of three values: most points are as wrong as others
    Noise,  ///< uint16 at random
    Smooth, ///< uint8 of a few waves
    Real,   ///< float of a few waves
    Wide,   ///< double of all magnitudes: errors are never exact
};

/// A lattice of values made from `seed`.
Dataset randomLattice(LatticeKind kind, const std::array<std::uint32_t, 3>& size, std::uint32_t seed);

/// The model of all its points that are needed, refined as a whole or in blocks of so many cells. Files go to `folder`.
/// What fails here fails the test.
std::shared_ptr<const Model> modelOf(const Dataset& dataset, std::uint32_t blockCells,
                                     const std::filesystem::path& folder);

} // namespace tetra
