// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/model.h"

#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>

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

/// What each site needs to be there before it: the creators of the tetrahedra that it destroys, each once, ascending.
/// Derived from the destroyers in one pass, not stored in the file; about five a site, 1.5 bytes for each tetrahedron
/// of the history.
class HistoryLinks {
public:
    /// Makes them for the first `sites` sites, if they are not there already. Errors: a damaged file, out of memory,
    /// cancelled.
    Status cover(const Model& model, std::uint32_t sites, const Progress& progress);

    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::span<const std::uint32_t> parents(std::uint32_t site) const
    {
        return std::span(parents_).subspan(offsets_[site], offsets_[site + 1] - offsets_[site]);
    }

    /// Asks memory for where they stand, which is going to be looked at soon, and then for themselves.
    void fetchOffsets(std::uint32_t site) const { __builtin_prefetch(&offsets_[site]); }
    void fetchParents(std::uint32_t site) const { __builtin_prefetch(parents_.data() + offsets_[site]); }

private:
    std::uint32_t siteCount_ = 0;
    Buffer<std::uint64_t> offsets_;
    Buffer<std::uint32_t> parents_;
};

} // namespace tetra
