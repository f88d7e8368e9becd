// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string_view>

namespace tetra {

inline std::string_view asText(const std::uint8_t* bytes, std::size_t size)
{
    return {reinterpret_cast<const char*>(bytes), size};
}

inline std::span<const std::byte> asBytes(std::string_view text)
{
    return std::as_bytes(std::span(text));
}

/// Takes the text up to `end`, or all of it, off the front.
inline std::string_view takeUntil(std::string_view& text, char end)
{
    const std::size_t length = std::min(text.find(end), text.size());
    const std::string_view taken = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    return taken;
}

inline void require(bool isSo, const char* what)
{
    if (isSo)
        return;
    std::fprintf(stderr, "broken promise: %s\n", what);
    std::abort();
}

/// A refusal is a sentence that can be shown.
inline void requireText(const Error& error)
{
    require(error.text().size() > 10, "an error has a text");
    require(std::ranges::none_of(error.text(), [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\n'; }),
            "an error's text can be printed");
}

/// What every dataset that a reader lets pass keeps.
inline void requireSound(const Result<Dataset>& read)
{
    const Result<Dataset> dataset = read ? withHoles(*read) : read;
    if (!dataset)
        return requireText(dataset.error());
    const std::uint64_t points = dataset->pointCount();
    require(points > 0 && points == dataset->lattice.pointCount(), "one sample a point");
    require(dataset->values.notFiniteCount() == 0, "values are finite");
    require((dataset->lattice.spacing.array() > 0).all(), "spacings are positive");
    if (dataset->positions) {
        require(dataset->positions->size() == points, "one place a point");
        require(std::ranges::all_of(*dataset->positions, [](const auto& place) { return place.allFinite(); }),
                "places are finite");
    }
}

} // namespace tetra
