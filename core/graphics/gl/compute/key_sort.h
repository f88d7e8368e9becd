// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/graphics/gl/compute/compute_programs.h"
#include "core/graphics/gl/compute/prefix_sums.h"

namespace tetra {

/// Sorts pairs of a key and a cell on the graphics card by their keys; pairs of equal keys stay as they are. As
/// StorageBuffer.
class KeySort {
public:
    /// Room for as many pairs, 20 bytes each; what was in it is lost.
    void reserve(const ComputeContext& context, std::size_t count);
    /// The pairs, two words each: to be written before run(), sorted after.
    const StorageBuffer& pairs() const noexcept { return pairs_; }
    /// Sorts the first `count` pairs by the lowest `bits` of their keys, four at a time: O(count bits).
    void run(const ComputeContext& context, const ComputePrograms& programs, std::size_t count, unsigned bits);

private:
    StorageBuffer pairs_;
    StorageBuffer other_;
    StorageBuffer counts_;
    PrefixSums sums_;
};

} // namespace tetra
