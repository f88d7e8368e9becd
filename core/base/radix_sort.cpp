// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/radix_sort.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace tetra {
namespace {

constexpr int digitBits = 11;
constexpr std::size_t digitCount = std::size_t(1) << digitBits;
constexpr std::size_t smallestBlock = std::size_t(1) << 16;
constexpr std::size_t mostBlocks = 64;

using DigitPlaces = std::array<std::size_t, digitCount>;

std::size_t digitOf(const KeyedIndex& item, int shift) noexcept
{
    return item.key >> shift & (digitCount - 1);
}

/// Turns the counts of each block and digit into the places where they begin; false if all items have one digit.
bool placesFromCounts(std::vector<DigitPlaces>& blocks, std::size_t count)
{
    std::size_t place = 0;
    bool several = true;
    for (std::size_t digit = 0; digit < digitCount; ++digit) {
        const std::size_t before = place;
        for (DigitPlaces& block : blocks)
            place += std::exchange(block[digit], place);
        several = several && place - before < count;
    }
    return several;
}

} // namespace

void radixSort(Buffer<KeyedIndex>& items, int keyBits, const Progress& progress)
{
    const std::size_t count = items.size();
    const std::size_t blockSize = std::max(smallestBlock, (count + mostBlocks - 1) / mostBlocks);
    std::vector<DigitPlaces> places((count + blockSize - 1) / blockSize);
    Buffer<KeyedIndex> sorted(count);
    for (int shift = 0; shift < keyBits && !progress.cancelled(); shift += digitBits) {
        tbb::parallel_for(std::size_t(0), places.size(), [&](std::size_t block) {
            places[block].fill(0);
            for (std::size_t i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i)
                ++places[block][digitOf(items[i], shift)];
        });
        if (!placesFromCounts(places, count))
            continue;
        tbb::parallel_for(std::size_t(0), places.size(), [&](std::size_t block) {
            for (std::size_t i = block * blockSize; i < std::min(count, (block + 1) * blockSize); ++i)
                sorted[places[block][digitOf(items[i], shift)]++] = items[i];
        });
        items.swap(sorted);
    }
}

} // namespace tetra
