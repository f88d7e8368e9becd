// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/model.h"

#include <cstdint>
#include <span>

namespace tetra {

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
