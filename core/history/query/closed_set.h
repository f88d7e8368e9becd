// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/query/refinement_criterion.h"
#include "core/history/walk.h"

#include <tan/base.h>
#include <tan/model.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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

/// A set of a model's sites, a bit each.
class SiteSet {
public:
    /// The sites before `prefix`, of `sites` in all.
    SiteSet(std::uint32_t sites, std::uint32_t prefix) : words_(sites / bits + std::size_t(1)), count_(prefix)
    {
        std::fill_n(words_.begin(), prefix / bits, ~std::uint64_t(0));
        words_[prefix / bits] = (std::uint64_t(1) << prefix % bits) - 1;
    }

    bool contains(std::uint32_t site) const { return (words_[site / bits] >> site % bits & 1) != 0; }
    void insert(std::uint32_t site)
    {
        count_ += contains(site) ? 0 : 1;
        words_[site / bits] |= bit(site);
    }
    void erase(std::uint32_t site)
    {
        count_ -= contains(site) ? 1 : 0;
        words_[site / bits] &= ~bit(site);
    }
    std::uint32_t count() const noexcept { return count_; }

    /// Calls `visit(site)` for each, ascending, from `first` on.
    template <class Visit> void visitFrom(std::uint32_t first, const Visit& visit) const
    {
        for (std::size_t place = first / bits; place < words_.size(); ++place) {
            std::uint64_t word = words_[place];
            if (place == first / bits)
                word &= ~((std::uint64_t(1) << first % bits) - 1);
            for (; word != 0; word &= word - 1)
                visit(static_cast<std::uint32_t>(place * bits + static_cast<unsigned>(std::countr_zero(word))));
        }
    }

    bool operator==(const SiteSet&) const = default;

private:
    static constexpr std::uint32_t bits = 64;
    static std::uint64_t bit(std::uint32_t site) { return std::uint64_t(1) << site % bits; }

    std::vector<std::uint64_t> words_;
    std::uint32_t count_ = 0;
};

/// A closed set of sites (B1): with a site it holds the site's whole group and the creators of all that they destroy.
/// Its mesh, the tetrahedra made by one of its sites and destroyed by none, conforms and covers the domain.
struct ClosedSet {
    SiteSet sites;
    std::uint32_t prefix = 0;     ///< all sites before this one belong to it
    std::uint64_t tetrahedra = 0; ///< of its mesh, as the file says
    /// Number that errors and warpings asked for must be multiplied by to allow all of its mesh: 1, or more where the
    /// model has nothing finer or the budget ended it.
    double scale = 1;
};

/// The smallest closed set that holds the first `prefix` sites (which end a group) and whose mesh the criterion allows,
/// as far as the model has finer tetrahedra: each one that is too coarse must be destroyed, and only its destroyer does
/// that. O(the set and what it creates). `links` cover the criterion's finest prefix. Errors: cancelled, a damaged
/// file.
Result<ClosedSet> smallestClosedSet(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion,
                                    std::uint32_t prefix, const Progress& progress);

/// The same with the fields multiplied by the least number, at least 1, for which the mesh has at most `budget`
/// tetrahedra. Refines what is farthest from what was asked first, and takes back what was begun when the budget is
/// passed. Error: WrongUsage if even the coarsest mesh has more.
Result<ClosedSet> closedSetWithin(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion,
                                  std::uint64_t budget, const Progress& progress);

/// Adds these sites, which are known to the links, with all that they need, and destroys what comes with them and is
/// too coarse: without `budgeted` for the criterion, else for its fields times set.scale.
Status extendSet(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion, bool budgeted,
                 std::span<const std::uint32_t> sites, const Progress& progress, ClosedSet& set);

/// Takes the mesh of a closed set out of the file: vertices are its sites, ascending, tetrahedra come by creator. The
/// buffers of `out` are used again. `places` of all its sites. Errors: a damaged file, cancelled.
Status extractSet(const Model& model, const ClosedSet& set, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out);

} // namespace tetra
