// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace tetra {

/// Some consecutive stars of a history: that of site `firstSite` + i is [offsets[i], offsets[i + 1]), within the
/// arrays.
struct Stars {
    std::span<const std::array<std::uint32_t, 3>> otherSites; ///< of the whole history, as are the destroyers
    std::span<const std::uint32_t> destroyers;
    std::uint32_t firstSite = 0;
    std::span<const std::uint64_t> offsets;
};

struct AliveScan {
    std::array<std::uint32_t, 4>* end; ///< behind the last tetrahedron that was found
    bool sitesComeBefore;              ///< whether in every tetrahedron the other sites come before the creator
};

/// Copies the tetrahedra that are alive in the mesh of the first `sites` sites to `out`, creator first, in order. `out`
/// has room for all tetrahedra of the stars and aliveScanOverrun more: which ones are alive follows no pattern that a
/// processor could predict, so every one is written, and the next one goes over it if it was dead. Reads every number
/// once: what it returns holds even if another program changes the file meanwhile.
using AliveScanFunction = AliveScan (*)(const Stars& stars, std::uint32_t sites, std::array<std::uint32_t, 4>* out);
inline constexpr std::uint64_t aliveScanOverrun = 4;

struct AliveScanVariant {
    std::string_view name;
    AliveScanFunction scan;
};

/// The variants that this processor can run, the fastest first; all do the same.
std::span<const AliveScanVariant> aliveScans();

} // namespace tetra
