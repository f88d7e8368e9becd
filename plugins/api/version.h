// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace tetra {

/// A version number, "major.minor.patch"; ordered as such.
struct Version {
    int major = 0;
    int minor = 0;
    int patch = 0;
    constexpr auto operator<=>(const Version&) const = default;
};

/// Whether something made for `wanted` works with what is `offered`: the same major version (another one breaks), and
/// no later minor one (what was added since `offered` would be missing). Patches change no interface. A version fits
/// itself. Before 1.0 minor versions break, too.
constexpr bool fits(const Version& wanted, const Version& offered) noexcept
{
    const bool breaks = wanted.major == 0 && wanted.minor != offered.minor;
    return wanted.major == offered.major && wanted.minor <= offered.minor && !breaks;
}

/// Reads "1", "1.2" or "1.2.3": one to three decimal numbers, nothing before, between or after; what is missing is 0.
inline std::optional<Version> parseVersion(std::string_view text)
{
    Version version;
    int* const numbers[] = {&version.major, &version.minor, &version.patch};
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int* number : numbers) {
        if (at == end || *at < '0' || *at > '9')
            return std::nullopt;
        const auto [next, problem] = std::from_chars(at, end, *number);
        if (problem != std::errc())
            return std::nullopt;
        if (next == end)
            return version;
        if (*next != '.')
            return std::nullopt;
        at = next + 1;
    }
    return std::nullopt;
}

inline std::string toText(const Version& version)
{
    return std::to_string(version.major) + "." + std::to_string(version.minor) + "." + std::to_string(version.patch);
}

} // namespace tetra
