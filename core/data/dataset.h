// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/lattice.h"
#include "core/data/scalar_field.h"

#include <filesystem>
#include <string>

namespace tetra {

/// Where a dataset came from: kept in every model built from it.
struct Source {
    std::string name;           ///< what the user calls it: the file's name, or a sample's
    std::filesystem::path path; ///< empty when it was never a file
    std::uint64_t hash = 0;     ///< XXH3 of the samples' bytes in memory order
};

/// The reference model (2.3) of a regular dataset: a lattice and one scalar per point. Immutable, cheap to copy.
struct Dataset {
    Lattice lattice;
    ScalarField values; ///< one sample per lattice point, all finite
    Source source;
};

} // namespace tetra
