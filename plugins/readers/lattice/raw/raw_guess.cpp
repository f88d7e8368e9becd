// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/lattice/raw/raw_guess.h"

#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/nrrd/nrrd_types.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

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

/// The axis that a word like Z120 gives the size of, and the size.
std::optional<std::pair<std::size_t, std::uint32_t>> axisInName(std::string_view word)
{
    const std::size_t axis = word.empty() ? std::string_view::npos : std::string_view("xyzXYZ").find(word.front());
    if (axis == std::string_view::npos)
        return {};
    const auto points = parseNumber<std::uint32_t>(word.substr(1));
    return points ? std::optional(std::pair(axis % 3, *points)) : std::nullopt;
}

/// As types are called in a description, or shorter, as in head_u16.raw.
std::optional<SampleType> typeInName(std::string_view word)
{
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> shortNames{{{"u8", "uint8"},
                                                                                               {"s8", "int8"},
                                                                                               {"i8", "int8"},
                                                                                               {"u16", "uint16"},
                                                                                               {"s16", "int16"},
                                                                                               {"i16", "int16"},
                                                                                               {"u32", "uint32"},
                                                                                               {"i32", "int32"},
                                                                                               {"f32", "float"},
                                                                                               {"f64", "double"}}};
    std::string lower(word);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    for (const auto& [shortName, name] : shortNames)
        if (lower == shortName)
            lower = name;
    const auto found = parseStoredType(lower);
    return found ? plainSampleType(*found) : std::nullopt;
}

void add(std::vector<RawGuess>& guesses, const RawGuess& guess, std::uint64_t bytes)
{
    if (guesses.size() < mostGuesses && fills(guess, bytes))
        guesses.push_back(guess);
}

void addFromName(std::vector<RawGuess>& guesses, std::string_view fileName, std::uint64_t bytes)
{
    std::optional<std::array<std::uint32_t, 3>> size;
    std::array<std::uint32_t, 3> byAxis{};
    std::optional<SampleType> type;
    for (const std::string_view word : split(fileName, "_-. ()")) {
        if (const auto found = sizeInName(word))
            size = found;
        if (const auto found = axisInName(word))
            byAxis[found->first] = found->second;
        if (const auto found = typeInName(word))
            type = *found;
    }
    if (!size && std::ranges::count(byAxis, 0u) == 0)
        size = byAxis;
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
