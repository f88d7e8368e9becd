// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/foam_dimensions.h"

#include "plugins/readers/vtk/unit_powers.h"

#include <tan/base.h>

#include <zlib.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace tetra {
namespace {

constexpr std::string_view foamSeparators = " \t\r\n";

/// The words between the brackets of the entry that begins a line.
std::vector<std::string_view> wordsOfDimensions(std::string_view text)
{
    constexpr std::string_view key = "dimensions";
    std::vector<std::string_view> words;
    for (auto place = text.find(key); place != std::string_view::npos; place = text.find(key, place + 1)) {
        std::string_view behind = text.substr(place + key.size());
        behind.remove_prefix(std::min(behind.find_first_not_of(foamSeparators), behind.size()));
        const bool beginsLine = place == 0 || text[place - 1] == '\n' || text[place - 1] == ' ';
        const auto end = behind.find(']');
        if (!beginsLine || !behind.starts_with('[') || end == std::string_view::npos)
            continue;
        for (std::string_view rest = behind.substr(1, end - 1);;) {
            rest.remove_prefix(std::min(rest.find_first_not_of(foamSeparators), rest.size()));
            if (rest.empty())
                return words;
            words.push_back(rest.substr(0, rest.find_first_of(foamSeparators)));
            rest.remove_prefix(words.back().size());
        }
    }
    return words;
}

} // namespace

std::string foamUnit(std::string_view text)
{
    constexpr std::array<std::string_view, 7> units{"kg", "m", "s", "K", "mol", "A", "cd"};
    constexpr std::size_t leastPowers = 5; // older files leave out those of A and cd
    const auto words = wordsOfDimensions(text);
    std::vector<double> powers;
    std::string named;
    for (const std::string_view word : words) {
        named += (named.empty() ? "" : " ") + std::string(word);
        if (const auto power = parseNumber<double>(word); power && powers.size() < units.size())
            powers.push_back(*power);
    }
    if (powers.empty())
        return named;
    return powers.size() == words.size() && powers.size() >= leastPowers ? unitOfPowers(units, powers) : std::string();
}

std::string foamUnitOfFile(const std::filesystem::path& path)
{
    constexpr std::size_t beginning = 1 << 14; // the entry stands behind the header
    std::string text(beginning, '\0');
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);
    const int got = file ? gzread(file.get(), text.data(), beginning) : 0;
    return foamUnit(std::string_view(text).substr(0, static_cast<std::size_t>(std::max(0, got))));
}

} // namespace tetra
