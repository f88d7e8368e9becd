// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"

#include <tan/base.h>
#include <tan/model.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ranges>
#include <span>

// How the tetrahedra of a history are read: in the order of the file by walkHistory(), a site's alone by starOf(). One
// is alive in the mesh of the first N sites if one of them created it and none destroys it (S2).

namespace tetra {

/// Some consecutive stars of a history, a star being what one site created: that of site `firstSite` + i is the
/// tetrahedra [offsets[i], offsets[i + 1]), within the arrays.
struct Stars {
    std::span<const std::array<std::uint32_t, 3>> otherSites; ///< of the whole history, as are the destroyers
    std::span<const std::uint32_t> destroyers;
    std::uint32_t firstSite = 0;
    std::span<const std::uint64_t> offsets;

    std::uint64_t first() const { return offsets.front(); }
    std::uint64_t count() const { return offsets.back() - offsets.front(); }
};

/// Calls `visit` with the stars of the sites [first, end), some thousand tetrahedra at a time, in the order of the
/// file. Each piece was checked against the file's checksums right before, which brings it into the cache, and its
/// offsets are a copy that was checked: they ascend and lie within the file. The rest of the file may change meanwhile,
/// so that a visitor reads every number once, and believes none. Errors: a damaged or inconsistent file, cancelled (as
/// `activity`), the visitor's.
Status walkHistory(const Model& model, std::uint32_t first, std::uint32_t end, const Progress& progress,
                   const Message& activity, const std::function<Status(const Stars&)>& visit);

/// Calls `visit(creator, tetrahedron, destroyer)` for all that none of the first `sites` sites destroys.
template <class Visit> void forEachAlive(const Stars& stars, std::uint32_t sites, const Visit& visit)
{
    for (std::size_t star = 0; star + 1 < stars.offsets.size(); ++star)
        for (std::uint64_t t = stars.offsets[star]; t < stars.offsets[star + 1]; ++t)
            if (const std::uint32_t destroyer = stars.destroyers[t]; destroyer >= sites)
                visit(stars.firstSite + static_cast<std::uint32_t>(star), t, destroyer);
}

struct AliveScan {
    std::array<std::uint32_t, 4>* end; ///< behind the last tetrahedron that was found
    bool sitesComeBefore;              ///< whether in every tetrahedron the other sites come before the creator
};

/// Copies the tetrahedra that are alive in the mesh of the first `sites` sites to `out`, creator first, in order. `out`
/// has room for all tetrahedra of the stars and aliveScanOverrun more: which ones are alive follows no pattern that a
/// processor could predict, so every one is written, and the next one goes over it if it was dead. Reads every number
/// once: what it returns holds even if another program changes the file meanwhile.
AliveScan scanAlive(const Stars& stars, std::uint32_t sites, std::array<std::uint32_t, 4>* out,
                    SimdLevel level = simdLevel());
inline constexpr std::uint64_t aliveScanOverrun = 4;

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

/// Asks memory for the star itself: destroyers, sites and own errors of its tetrahedra.
inline void fetchStar(const Model& model, std::uint32_t site)
{
    const auto star = starOf(model, site);
    if (star.empty())
        return;
    fetchAll(&model.destroyers()[star.front()], star.size());
    fetchAll(&model.otherSites()[star.front()], star.size());
    fetchAll(&model.ownErrors()[star.front()], star.size());
}

} // namespace tetra
