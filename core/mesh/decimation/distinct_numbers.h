// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Finds out which numbers there are in short lists.
class DistinctNumbers {
public:
    /// Each of `numbers` once, in order of appearance, into `distinct`, and where it is there into `places`, which is
    /// as long as `numbers`. None of them is 2^32 - 1.
    void find(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
              std::span<std::uint32_t> places);

private:
    void findByTable(std::span<const std::uint32_t> numbers, std::vector<std::uint32_t>& distinct,
                     std::span<std::uint32_t> places);

    std::vector<std::uint32_t> table_; ///< places among the distinct ones, by the hash of the number
};

} // namespace tetra
