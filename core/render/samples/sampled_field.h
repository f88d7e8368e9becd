// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>
#include <tan/transfer.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// Blocks of this many cells a side tell what may be passed by.
inline constexpr std::uint32_t sampleBlockSide = 4;

/// The samples of a lattice, made ready once to be cast rays through. Immutable; share it between threads.
struct SampledField {
    Lattice lattice;
    ScalarField values; ///< bytes and signed numbers of 16 bits as they are, others in single precision, as in meshes
    std::array<std::uint32_t, 3> blocks{};     ///< their number along each axis
    std::vector<std::array<float, 2>> extents; ///< of each block's values, x fastest
};

/// Where the field rises at each sample: central differences, at the border one-sided, in world coordinates, by one
/// factor for all, so that the longest component is 32767. The fourth number is none.
struct SampleGradients {
    Buffer<std::array<std::int16_t, 4>> vectors;
    double unit = 0; ///< what 1 is, in units of the values for one of length
};

/// O(samples), on all threads; takes 4 bytes a sample where values are converted, and no other copy. Errors: a dataset
/// that is no lattice, or has holes or values that are not finite; not enough memory; cancelled.
Result<SampledField> makeSampledField(const Dataset& dataset, const Progress& progress);

/// 8 bytes a sample. Errors: not enough memory, cancelled.
Result<SampleGradients> sampleGradients(const SampledField& field, const Progress& progress);

/// A transfer function made ready for the samples.
struct SampledTransfer {
    std::vector<TransferSegment> segments;
    /// For each block how far the next one is in which something is seen, as the larger of the differences of their
    /// numbers; 0 for one of these itself. At most 255.
    std::vector<std::uint8_t> distances;
};

/// O(blocks). Errors: too many segments, not enough memory.
Result<SampledTransfer> makeSampledTransfer(const SampledField& field, std::span<const TransferSegment> segments);

} // namespace tetra
