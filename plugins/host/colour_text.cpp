// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/colour_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

namespace tetra {
namespace {

constexpr std::array<std::pair<std::string_view, std::uint32_t>, 14> names = {{
    {"black", 0x000000},
    {"blue", 0x1f77b4},
    {"brown", 0x8c564b},
    {"cyan", 0x17becf},
    {"gold", 0xe6b422},
    {"green", 0x2ca02c},
    {"grey", 0x7f7f7f},
    {"magenta", 0xd62790},
    {"orange", 0xff7f0e},
    {"purple", 0x9467bd},
    {"red", 0xd62728},
    {"silver", 0xc0c0c0},
    {"white", 0xffffff},
    {"yellow", 0xffdd00},
}};

Colour fromPacked(std::uint32_t packed)
{
    const auto channel = [&](int shift) { return static_cast<float>(packed >> shift & 0xff) / 255.0f; };
    return {channel(16), channel(8), channel(0)};
}

/// #rgb as #rrggbb.
std::string withDoubledDigits(std::string_view digits)
{
    std::string doubled;
    for (const char digit : digits)
        doubled.append(2, digit);
    return doubled;
}

} // namespace

Result<Colour> parseColour(std::string_view text)
{
    const auto named = std::ranges::find(names, text, [](const auto& entry) { return entry.first; });
    if (named != names.end())
        return fromPacked(named->second);
    const auto material = std::ranges::find(materials, text, [](const Material& one) { return one.word; });
    if (material != materials.end())
        return material->colour;
    if (text.starts_with('#') && (text.size() == 4 || text.size() == 7)) {
        const std::string digits = text.size() == 4 ? withDoubledDigits(text.substr(1)) : std::string(text.substr(1));
        std::uint32_t packed = 0;
        const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), packed, 16);
        if (problem == std::errc() && end == digits.data() + digits.size())
            return fromPacked(packed);
    }
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' is not a colour. Give #rrggbb in hexadecimal, or one of %2.", text, colourNames())};
}

std::string colourText(const Colour& colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const float channel : {colour.red, colour.green, colour.blue}) {
        const auto level = static_cast<unsigned>(std::lround(std::clamp(channel, 0.0f, 1.0f) * 255));
        text += {digits[level >> 4], digits[level & 15]};
    }
    return text;
}

std::string colourNames()
{
    std::string list;
    for (const auto& [name, packed] : names)
        list += (list.empty() ? "" : ", ") + std::string(name);
    for (const Material& material : materials)
        list += ", " + std::string(material.word);
    return list;
}

} // namespace tetra
