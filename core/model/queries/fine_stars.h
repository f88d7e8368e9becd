// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// The tetrahedra of a prefix of the history, to ask for one by its sites: what a mesh has in common with the prefix's
/// keeps the prefix's error. 8 bytes for each tetrahedron that is alive, made in one pass.
class FineStars {
public:
    FineStars() = default;
    /// Of the first `sites` sites, but only what those from `firstCreator` on created. Errors: a damaged file,
    /// cancelled.
    static Result<FineStars> make(const Model& model, std::uint32_t firstCreator, std::uint32_t sites,
                                  const Progress& progress);

    std::uint32_t firstCreator() const noexcept { return firstCreator_; }
    std::uint32_t siteCount() const noexcept { return siteCount_; }

    /// Whether the tetrahedron is in the prefix's mesh; any order of sites, some of which may be no sites. Tetrahedra
    /// that are not are taken for others with a probability of 2^-60.
    bool holds(const std::array<std::uint32_t, 4>& sites) const;

    /// Fetches what holds() will look at.
    void prefetch(const std::array<std::uint32_t, 4>& sites) const
    {
        if (const std::uint32_t creator = std::ranges::max(sites); creator >= firstCreator_ && creator < siteCount_)
            __builtin_prefetch(keys_.data() + starts_[creator - firstCreator_]);
    }

private:
    static std::uint64_t keyOf(std::uint64_t a, std::uint64_t b, std::uint64_t c)
    {
        // Symmetric, and what is equal in all three is the same set.
        return (a + b + c) * 0x9e3779b97f4a7c15 + (a * b + b * c + c * a) * 0xbf58476d1ce4e5b9 +
               a * b * c * 0x94d049bb133111eb;
    }

    std::uint32_t firstCreator_ = 0;
    std::uint32_t siteCount_ = 0;
    std::vector<std::uint32_t> starts_; ///< of each creator's keys
    std::vector<std::uint64_t> keys_;
};

} // namespace tetra
