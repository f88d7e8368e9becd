// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_copying.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace tetra {
namespace {

/// A block of numbers to be copied: how many along x, y and z, and how far apart, in numbers.
struct BlockCopy {
    std::array<std::uint64_t, 3> counts{}, fromSteps{}, toSteps{};
    std::uint64_t from = 0, to = 0;
};

template <class T> T loaded(const std::byte* at, bool isSwapped)
{
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), at, sizeof(T));
    if (isSwapped)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

/// `convert` makes what is kept of a number as it is stored.
template <class Stored, class Convert> void copyNumbers(const BlockCopy& block, const std::byte* numbers,
                                                        bool isSwapped, const Convert& convert, std::byte* samples)
{
    using Kept = decltype(convert(Stored{}));
    for (std::uint64_t k = 0; k < block.counts[2]; ++k)
        for (std::uint64_t j = 0; j < block.counts[1]; ++j) {
            std::uint64_t from = block.from + k * block.fromSteps[2] + j * block.fromSteps[1];
            std::byte* to = samples + (block.to + k * block.toSteps[2] + j * block.toSteps[1]) * sizeof(Kept);
            for (std::uint64_t i = 0; i < block.counts[0]; ++i, from += block.fromSteps[0], to += sizeof(Kept)) {
                const Kept value = convert(loaded<Stored>(numbers + from * sizeof(Stored), isSwapped));
                std::memcpy(to, &value, sizeof value);
            }
        }
}

void copyOfSize(const BlockCopy& block, const std::byte* numbers, std::size_t size, bool isSwapped, std::byte* samples)
{
    const auto same = [](auto value) { return value; };
    switch (size) {
    case 1: return copyNumbers<std::uint8_t>(block, numbers, false, same, samples);
    case 2: return copyNumbers<std::uint16_t>(block, numbers, isSwapped, same, samples);
    case 4: return copyNumbers<std::uint32_t>(block, numbers, isSwapped, same, samples);
    default: return copyNumbers<std::uint64_t>(block, numbers, isSwapped, same, samples);
    }
}

/// The part of a chunk that lies in the array, with the places of the samples.
BlockCopy blockAt(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& first,
                  const std::vector<std::uint64_t>& shape)
{
    const auto size = selection.sizeIn(array);
    BlockCopy block;
    block.toSteps = {1, size[0], size[0] * size[1]};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t of = selection.axes[axis];
        block.counts[axis] = std::min(shape[of], array.shape[of] - first[of]);
        block.to += first[of] * block.toSteps[axis];
    }
    return block;
}

} // namespace

void copyChunk(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& first,
               std::span<const std::byte> numbers, std::byte* samples)
{
    const ZarrChunks& chunks = array.chunks;
    std::vector<std::uint64_t> steps(chunks.shape.size());
    std::uint64_t step = 1;
    for (std::size_t place = chunks.order.size(); place-- > 0; step *= chunks.shape[chunks.order[place]])
        steps[chunks.order[place]] = step;
    BlockCopy block = blockAt(array, selection, first, chunks.shape);
    for (std::size_t axis = 0; axis < steps.size(); ++axis)
        if (std::ranges::find(selection.axes, axis) == selection.axes.end())
            block.from += (selection.numbers[axis] - first[axis]) * steps[axis];
    for (std::size_t axis = 0; axis < 3; ++axis)
        block.fromSteps[axis] = steps[selection.axes[axis]];
    const bool isSwapped = chunks.isBigEndian != (std::endian::native == std::endian::big);
    if (array.number == ZarrNumber::Float16)
        copyNumbers<std::uint16_t>(block, numbers.data(), isSwapped, floatOfHalf, samples);
    else
        copyOfSize(block, numbers.data(), storedSize(array.number), isSwapped, samples);
}

void fillChunk(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& first,
               const std::vector<std::uint64_t>& shape, std::byte* samples)
{
    const BlockCopy block = blockAt(array, selection, first, shape); // one number, again and again
    copyOfSize(block, array.fill.data(), keptSize(array.number), false, samples);
}

} // namespace tetra
