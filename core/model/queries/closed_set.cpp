// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/closed_set.h"

#include "core/model/queries/coarse_candidates.h"
#include "core/model/queries/group_walk.h"
#include "core/model/queries/stars.h"
#include "core/model/site_places.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace tetra {

namespace {

/// Sites between two looks at whether the work was cancelled.
constexpr std::uint32_t sitesAtOnce = 1 << 12;
/// Sites between asking memory for a star and looking at it.
constexpr std::size_t sitesAhead = 6;
/// The least scale that says that something was not reached.
constexpr double moreThanAsked = 1 + std::numeric_limits<double>::epsilon();

/// The set while it grows. What was added is looked at in turn.
class Growth {
public:
    Growth(const Model& model, const HistoryLinks& links, const FieldJudge& judge, std::uint32_t prefix)
        : model_(model), links_(links), judge_(judge), set_{SiteSet(model.siteCount(), prefix), prefix,
                                                            prefix > 0 ? model.meshSizes()[prefix - 1] : 0, 1}
    {
    }

    Result<ClosedSet> run(const Progress& progress);

private:
    void fetchAhead(std::size_t next) const;
    void refineStar(std::uint32_t site);
    void addGroup(std::uint32_t site);

    const Model& model_;
    const HistoryLinks& links_;
    const FieldJudge& judge_;
    ClosedSet set_;
    std::vector<std::uint32_t> added_; ///< behind the prefix, in the order in which they are looked at
    Buffer<std::uint64_t> candidates_;
    bool coverable_ = true; ///< every site that was needed has its links
};

/// Sites come in no order that memory could know.
void Growth::fetchAhead(std::size_t next) const
{
    if (next + 2 * sitesAhead < added_.size()) {
        fetchStarOffsets(model_, added_[next + 2 * sitesAhead]);
        links_.fetchOffsets(added_[next + 2 * sitesAhead]);
    }
    if (next + sitesAhead < added_.size()) {
        fetchStar(model_, added_[next + sitesAhead], true);
        links_.fetchParents(added_[next + sitesAhead]);
    }
}

Result<ClosedSet> Growth::run(const Progress& progress)
{
    for (std::uint32_t site = 0; site < set_.prefix; ++site) {
        if (site % sitesAtOnce == 0 && progress.cancelled())
            return cancelledError("Choosing the sites");
        refineStar(site);
    }
    for (std::size_t next = 0; next < added_.size(); ++next) {
        if (next % sitesAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Choosing the sites");
            progress.report(0, "Choosing the sites");
        }
        fetchAhead(next);
        const std::uint32_t site = added_[next];
        for (const std::uint32_t parent : links_.parents(site))
            addGroup(parent);
        refineStar(site);
    }
    if (!coverable_)
        return inconsistentModel(model_, "its running errors do not bound the tetrahedra's own ones");
    return std::move(set_);
}

void Growth::refineStar(std::uint32_t site)
{
    for (const std::uint64_t t : coarseCandidates(model_, set_.sites, judge_, site, candidates_)) {
        const std::uint32_t destroyer = model_.destroyers()[t];
        if (set_.sites.contains(std::min(destroyer, model_.siteCount())) || !judge_.tooCoarse(t, site, destroyer))
            continue;
        if (destroyer < model_.siteCount())
            addGroup(destroyer);
        else
            set_.scale = std::max({set_.scale, moreThanAsked, judge_.scaleFor(t, site, destroyer)});
    }
}

void Growth::addGroup(std::uint32_t site)
{
    if (!coverable_ || set_.sites.contains(site))
        return;
    const GroupOfSites group = groupOf(model_, site);
    coverable_ &= group.end <= links_.siteCount();
    if (!coverable_)
        return;
    set_.tetrahedra += growthBy(model_, group);
    for (std::uint32_t member = group.first; member < group.end; ++member) {
        set_.sites.insert(member);
        added_.push_back(member);
    }
}

} // namespace

Result<ClosedSet> smallestClosedSet(const Model& model, const HistoryLinks& links, const FieldJudge& judge,
                                    std::uint32_t prefix, const Progress& progress)
{
    return Growth(model, links, judge, prefix).run(progress);
}

} // namespace tetra
