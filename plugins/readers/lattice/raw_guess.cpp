// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw_guess.h"

#include "core/base/number_text.h"
#include "plugins/readers/lattice/field_text.h"
#include "plugins/readers/lattice/nrrd_types.h"

#include <cmath>
#include <optional>

namespace tetra {

namespace {

constexpr std::size_t mostGuesses = 5;
constexpr std::array<SampleType, 4> usualTypes = {SampleType::UInt8, SampleType::UInt16, SampleType::Float32,
                                                  SampleType::Float64};

bool fills(const RawGuess& guess, std::uint64_t bytes)
{
    std::uint64_t rest = bytes / sampleSize(guess.type);
    for (const std::uint64_t points : guess.size) {
        if (points < 2 || rest % points != 0)
            return false;
        rest /= points;
    }
    return rest == 1 && bytes % sampleSize(guess.type) == 0;
}

std::optional<std::array<std::uint32_t, 3>> sizeInName(std::string_view word)
{
    const std::vector<std::string_view> numbers = split(word, "xX");
    if (numbers.size() != 3)
        return {};
    std::array<std::uint32_t, 3> size{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto points = parseNumber<std::uint32_t>(numbers[axis]);
        if (!points)
            return {};
        size[axis] = *points;
    }
    return size;
}

void add(std::vector<RawGuess>& guesses, const RawGuess& guess, std::uint64_t bytes)
{
    if (guesses.size() < mostGuesses && fills(guess, bytes))
        guesses.push_back(guess);
}

void addFromName(std::vector<RawGuess>& guesses, std::string_view fileName, std::uint64_t bytes)
{
    std::optional<std::array<std::uint32_t, 3>> size;
    std::optional<SampleType> type;
    for (const std::string_view word : split(fileName, "_-. ()")) {
        if (const auto found = sizeInName(word))
            size = found;
        if (const auto found = parseSampleType(word))
            type = *found;
    }
    if (!size)
        return;
    if (type)
        return add(guesses, {*size, *type}, bytes);
    for (const SampleType usual : usualTypes)
        add(guesses, {*size, usual}, bytes);
}

} // namespace

std::vector<RawGuess> guessRawLayouts(std::string_view fileName, std::uint64_t bytes)
{
    std::vector<RawGuess> guesses;
    addFromName(guesses, fileName, bytes);
    if (!guesses.empty())
        return guesses;
    constexpr std::uint64_t largest = std::uint64_t(1) << 48; // beyond it nothing that is guessed here is of use
    if (bytes > largest)
        return guesses;
    for (const SampleType type : usualTypes) {
        const std::uint64_t samples = bytes / sampleSize(type);
        const auto points = static_cast<std::uint32_t>(std::lround(std::cbrt(static_cast<double>(samples))));
        add(guesses, {{points, points, points}, type}, bytes);
    }
    for (const SampleType type : usualTypes)
        for (const std::uint32_t side : {512u, 256u, 128u, 64u, 1024u}) {
            const std::uint64_t slices = bytes / sampleSize(type) / side / side;
            const bool usual = slices >= side / 8 && slices <= std::uint64_t(4) * side;
            if (usual && slices != side)
                add(guesses, {{side, side, static_cast<std::uint32_t>(slices)}, type}, bytes);
        }
    return guesses;
}

} // namespace tetra
