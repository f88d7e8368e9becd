// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/model.h"

#include <cstddef>
#include <cstdint>
#include <ranges>

namespace tetra {

/// The tetrahedra that a site created, by their numbers: empty if the file's offsets make no sense, which is found
/// where whole prefixes are read.
inline auto starOf(const Model& model, std::uint32_t site)
{
    std::uint64_t begin = model.starOffsets()[site];
    const std::uint64_t end = model.starOffsets()[site + std::size_t(1)];
    if (begin > end || end > model.tetrahedronCount())
        begin = end;
    return std::views::iota(begin, end);
}

/// Asks memory for so many numbers in a row.
template <class T> void fetchAll(const T* first, std::size_t count)
{
    constexpr std::size_t line = 64;
    const auto* byte = reinterpret_cast<const char*>(first);
    for (std::size_t at = 0; at < count * sizeof(T); at += line)
        __builtin_prefetch(byte + at);
}

/// Asks memory for where the star begins and ends, which is going to be looked at soon.
inline void fetchStarOffsets(const Model& model, std::uint32_t site)
{
    __builtin_prefetch(&model.starOffsets()[site]);
}

/// Asks memory for the star itself: destroyers, sites and, if they matter, own errors of its tetrahedra.
inline void fetchStar(const Model& model, std::uint32_t site, bool withErrors)
{
    const auto star = starOf(model, site);
    if (star.empty())
        return;
    fetchAll(&model.destroyers()[star.front()], star.size());
    fetchAll(&model.otherSites()[star.front()], star.size());
    if (withErrors)
        fetchAll(&model.ownErrors()[star.front()], star.size());
}

} // namespace tetra
