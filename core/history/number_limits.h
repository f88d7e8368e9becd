// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/format.h"

#include <tan/data.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace tetra {

/// What the numbers of a section can be, as far as each tells by itself and with the header: values lie in the range of
/// the dataset's, positions in its bounding box, and no bound is negative or not a number. Checksums say that a file is
/// what somebody wrote; this, that no mesh of it has a vertex without a place or a value.
class NumberLimits {
public:
    /// Of any section; there are some that have no limits.
    NumberLimits(const format::Section& section, const format::Header& header) noexcept;

    /// Whether all numbers in a part of the section are possible, which begins `offset` bytes behind its beginning;
    /// both are multiples of a number's size. Some 10 GB a second.
    bool hold(std::uint64_t offset, std::span<const std::byte> part) const noexcept;

private:
    enum class Kind { None, Samples, Positions, Bounds, Halves, Flags };

    Kind kind_ = Kind::None;
    std::size_t numberBytes_ = 1;
    SampleType type_ = SampleType::UInt8;
    std::array<double, 2> range_{};
    std::array<double, 6> box_{};
};

} // namespace tetra
