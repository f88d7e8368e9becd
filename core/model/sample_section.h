// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/data/domain_class.h"
#include "core/data/sample_type.h"
#include "core/data/scalar_field.h"

#include <cstdint>
#include <functional>
#include <span>

namespace tetra {

/// How much the arrays of a model hold.
struct ModelCounts {
    std::uint64_t sites = 0;
    std::uint64_t tetrahedra = 0; ///< all that ever lived
};

/// The bytes of the arrays that every model of a regular lattice has.
std::uint64_t arrayBytes(const ModelCounts& counts, SampleType type) noexcept;

/// Whether a model keeps all samples of its dataset of `points` points, with their positions of `positionBytes` each
/// (0: a regular lattice): if they take at most an eighth of the other arrays. A model of a few sites of a huge dataset
/// does not, nor one of scattered points (FORMAT.md).
bool keepsSamples(DomainClass domain, SampleType type, std::size_t positionBytes, std::uint64_t points,
                  const ModelCounts& counts) noexcept;

/// Hands the samples' bytes to `write`, a piece at a time: they may lie in a file larger than memory.
Status writeSamples(const ScalarField& samples, const std::function<Status(std::span<const std::byte>)>& write);

} // namespace tetra
