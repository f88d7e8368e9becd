// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/queries/field_judge.h"
#include "core/model/queries/history_links.h"
#include "core/model/queries/site_set.h"

#include <cstdint>

namespace tetra {

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

/// The smallest closed set that holds the first `prefix` sites (which end a group) and whose mesh the judge allows, as
/// far as the model has finer tetrahedra: each one that is too coarse must be destroyed, and only its destroyer does
/// that. O(the set and what it creates). `links` cover the judge's finest prefix. Errors: cancelled, a damaged file.
Result<ClosedSet> smallestClosedSet(const Model& model, const HistoryLinks& links, const FieldJudge& judge,
                                    std::uint32_t prefix, const Progress& progress);

/// The same with the fields multiplied by the least number, at least 1, for which the mesh has at most `budget`
/// tetrahedra. Refines what is farthest from what was asked first, and takes back what was begun when the budget is
/// passed. Error: WrongUsage if even the coarsest mesh has more.
Result<ClosedSet> closedSetWithin(const Model& model, const HistoryLinks& links, const FieldJudge& judge,
                                  std::uint64_t budget, const Progress& progress);

} // namespace tetra
