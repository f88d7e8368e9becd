// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/sample_slice.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace tetra {

namespace {

template <class T> T sampleAt(const std::byte* place, std::endian order)
{
    std::array<std::byte, sizeof(T)> bytes;
    std::memcpy(bytes.data(), place, sizeof(T));
    if (order != std::endian::native)
        std::ranges::reverse(bytes);
    return std::bit_cast<T>(bytes);
}

/// Evenly spaced from the first to the last of `size`.
std::uint32_t spread(std::uint32_t index, std::uint32_t count, std::uint32_t size)
{
    return count < 2 ? 0 : static_cast<std::uint32_t>(std::uint64_t(index) * (size - 1) / (count - 1));
}

ValueRange windowOf(std::vector<float> values)
{
    std::erase_if(values, [](float value) { return !std::isfinite(value); });
    if (values.empty())
        return {};
    constexpr std::size_t share = 100; // of all, left out at either end
    const auto low = values.begin() + static_cast<std::ptrdiff_t>(values.size() / share);
    const auto high = values.end() - 1 - static_cast<std::ptrdiff_t>(values.size() / share);
    std::ranges::nth_element(values, low);
    const float least = *low;
    std::ranges::nth_element(values, high);
    return {least, *high};
}

} // namespace

Result<SampleSlice> readSampleSlice(std::span<const std::byte> file, const StoredSamples& samples, int axis,
                                    std::uint32_t number, std::uint32_t most, const Progress& progress)
{
    if (axis < 0 || axis > 2 || number >= samples.size[static_cast<std::size_t>(axis)])
        return Error{ErrorKind::WrongUsage, Message::say("There is no layer %1 along this axis.", number)};
    const auto across = static_cast<std::size_t>(axis);
    const std::size_t right = axis == 0 ? 1 : 0;
    const std::size_t up = axis == 2 ? 1 : 2;
    SampleSlice slice;
    slice.width = std::min(samples.size[right], most);
    slice.height = std::min(samples.size[up], most);
    slice.values.resize(std::size_t(slice.width) * slice.height);
    const std::uint64_t held =
        file.size() > samples.skippedBytes ? (file.size() - samples.skippedBytes) / sampleSize(samples.type) : 0;
    const bool finished = visitSampleType(samples.type, [&]<class T>() {
        for (std::uint32_t y = 0; y < slice.height; ++y) {
            if (progress.cancelled())
                return false;
            for (std::uint32_t x = 0; x < slice.width; ++x) {
                std::array<std::uint64_t, 3> place{};
                place[across] = number;
                place[right] = spread(x, slice.width, samples.size[right]);
                place[up] = spread(y, slice.height, samples.size[up]);
                const std::uint64_t index = (place[2] * samples.size[1] + place[1]) * samples.size[0] + place[0];
                slice.values[std::size_t(y) * slice.width + x] =
                    index < held ? static_cast<float>(sampleAt<T>(
                                       file.data() + samples.skippedBytes + index * sizeof(T), samples.order))
                                 : std::numeric_limits<float>::quiet_NaN();
            }
        }
        return true;
    });
    if (!finished)
        return cancelledError(Message::marked("The preview"));
    slice.window = windowOf(slice.values);
    return slice;
}

} // namespace tetra
