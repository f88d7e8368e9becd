// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace tetra {

/// All but letters, digits and -._~/,:;() as "%20" and the like, for the path of a URL or a value in its query.
inline std::string percentEncoded(std::string_view text)
{
    constexpr std::string_view digits = "0123456789ABCDEF", plain = "-._~/,:;()";
    std::string encoded;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
            plain.find(c) != std::string_view::npos)
            encoded += c;
        else
            encoded += {'%', digits[code >> 4], digits[code & 15]};
    }
    return encoded;
}

/// "%20" and the like, once. Nothing if a '%' is not followed by two digits, or if it gives a zero byte.
inline std::optional<std::string> percentDecoded(std::string_view text)
{
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        unsigned code = 0;
        const std::string_view digits = text.substr(i + 1, 2);
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (digits.size() != 2 || end != digits.data() + 2 || error != std::errc() || code == 0)
            return {};
        decoded += static_cast<char>(code);
        i += 2;
    }
    return decoded;
}

} // namespace tetra
