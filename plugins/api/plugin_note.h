// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// What a plugin says of itself lies in its library as a note, one of the pieces of an ELF file that are meant to be
// read by others: so it is found without loading the library, and stripping the file leaves it there. It is one text:
//
//     {"interface": "org.tan.Reader/3", "qt": "", "build": "linux-x86_64-64/...", "metadata": {"id": "lattice", ...}}
//
// "metadata" is the plugin's JSON file (metadata.h), "interface" comes of its class, "build" and "qt" of its build.

namespace tetra {

/// CRC-32 (ISO 3309, as in gzip).
constexpr std::uint32_t noteChecksum(std::string_view text) noexcept
{
    std::uint32_t sum = ~std::uint32_t(0);
    for (const char letter : text) {
        sum ^= static_cast<unsigned char>(letter);
        for (int bit = 0; bit < 8; ++bit)
            sum = sum >> 1 ^ (0xedb88320U & -(sum & 1U));
    }
    return ~sum;
}

/// What a note of a plugin begins with: its owner and, in 8 bytes, what it is.
inline constexpr std::string_view pluginNoteMark{"TAn\0TAnPlug1", 12};

/// No plugin has so much to say.
inline constexpr std::size_t mostNoteBytes = 1 << 16;

/// The note as it lies in the file: numbers in the order of bytes of the machine, its length a multiple of 8.
template <std::size_t textBytes> struct PluginNote {
    static constexpr std::size_t paddedBytes = (textBytes + 7) / 8 * 8;

    std::uint32_t ownerBytes = 4;
    std::uint32_t contentBytes = 8 + 4 + 4 + paddedBytes;
    std::uint32_t type = 1;
    std::array<char, 12> mark{}; ///< pluginNoteMark
    std::uint32_t size = textBytes;
    std::uint32_t checksum = 0;           ///< of the text
    std::array<char, paddedBytes> text{}; ///< and zeros

    template <class Parts> constexpr explicit PluginNote(const Parts& parts)
    {
        static_assert(textBytes <= mostNoteBytes, "the plugin's metadata are too long");
        std::size_t at = 0;
        for (const std::string_view part : parts)
            for (const char letter : part)
                text[at++] = letter;
        for (std::size_t i = 0; i < mark.size(); ++i)
            mark[i] = pluginNoteMark[i];
        checksum = noteChecksum({text.data(), textBytes});
    }
};

/// The pieces of a note's text.
constexpr std::array<std::string_view, 9> pluginNoteText(std::string_view interface, std::string_view qt,
                                                         std::string_view build, std::string_view metadata)
{
    return {R"({"interface": ")",
            interface,
            R"(", "qt": ")",
            qt,
            R"(", "build": ")",
            build,
            R"(", "metadata": )",
            metadata,
            "}"};
}

template <class Parts> constexpr std::size_t totalBytes(const Parts& parts)
{
    std::size_t total = 0;
    for (const std::string_view part : parts)
        total += part.size();
    return total;
}

} // namespace tetra
