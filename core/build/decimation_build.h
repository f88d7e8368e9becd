// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/decimate/lattice_tetrahedra.h"

#include <tan/build.h>

#include <cstdint>

namespace tetra {

/// How the cells of a grid are cut: lattices into five tetrahedra each, the fewest; curvilinear grids into six, from
/// which a fifth fewer sites keep the same accuracy (docs/lab/performance.md).
constexpr LatticeCut gridCut(DomainClass domain) noexcept
{
    return domain == DomainClass::Curvilinear ? LatticeCut::Six : LatticeCut::Five;
}

/// How large the mesh of a dataset is that is decimated.
struct DecimationSize {
    std::uint64_t points = 0;
    std::uint64_t tetrahedra = 0;
};

DecimationSize decimationSize(const Dataset& dataset);

/// About the most memory that its decimation into a model takes, besides the dataset: the mesh, the decimation, and
/// what the model's writer keeps.
std::uint64_t decimationNeed(const DecimationSize& size);

/// An error (OutOfResource) that says what is needed and what there is, unless that much memory can be used, or the
/// mesh has more points or tetrahedra than can be numbered. `usableBytes`: 0 if unknown.
Status checkDecimationNeed(const DecimationSize& size, std::uint64_t usableBytes);

} // namespace tetra
