// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/closed_set.h"
#include "core/model/queries/coarse_candidates.h"
#include "core/model/queries/group_walk.h"
#include "core/model/queries/stars.h"
#include "core/model/site_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t levelsAtOnce = 1 << 10;
/// A level that has gone so far beyond the budget will not come back.
constexpr std::uint64_t hopeless = 2;
constexpr std::uint64_t hopelessAtLeast = 1 << 16;

/// Grows a closed set by the scale of its mesh's worst tetrahedra, level by level: all that is worse than a scale goes
/// before anything better.
class BudgetGrowth {
public:
    BudgetGrowth(const Model& model, const HistoryLinks& links, const FieldJudge& judge, std::uint64_t budget)
        : model_(model), links_(links), judge_(judge),
          budget_(std::min(budget, model.tetrahedronCount())), set_{SiteSet(model.siteCount(), 0), 0, 0, 1}
    {
    }

    Result<ClosedSet> run(const Progress& progress);

private:
    struct Coarse {
        double scale;
        std::uint32_t destroyer;
        bool operator<(const Coarse& other) const { return scale < other.scale; }
    };

    Status finishLevel(double level, const Progress& progress);
    void refineStar(std::uint32_t site);
    void addGroup(std::uint32_t site);
    void takeBackLevel();
    bool hopelesslyLarge() const { return set_.tetrahedra > hopeless * budget_ + hopelessAtLeast; }
    Error impossible() const;

    const Model& model_;
    const HistoryLinks& links_;
    const FieldJudge& judge_;
    const std::uint64_t budget_;
    ClosedSet set_;
    std::vector<Coarse> queue_;          ///< a heap
    std::vector<std::uint32_t> waiting_; ///< added, not looked at yet
    Buffer<std::uint64_t> candidates_;
    std::vector<std::uint32_t> level_; ///< added since the last finished level, the first site of each group
    bool coverable_ = true;            ///< every site that was needed has its links
};

Result<ClosedSet> BudgetGrowth::run(const Progress& progress)
{
    addGroup(0);
    constexpr double first = std::numeric_limits<double>::infinity();
    if (const Status begun = finishLevel(first, progress); !begun)
        return begun.error();
    if (set_.tetrahedra > budget_)
        return impossible();
    level_.clear();
    for (std::uint64_t seen = 0; !queue_.empty(); ++seen) {
        if (seen % levelsAtOnce == 0)
            progress.report(std::min(1.0, static_cast<double>(set_.tetrahedra) / static_cast<double>(budget_)),
                            "Choosing the sites");
        const double level = queue_.front().scale;
        const double before = set_.scale;
        if (const Status finished = finishLevel(level, progress); !finished)
            return finished.error();
        if (set_.tetrahedra > budget_) {
            takeBackLevel();
            set_.scale = std::max(before, level);
            break;
        }
        level_.clear();
    }
    return std::move(set_);
}

/// Destroys every tetrahedron of that scale or more, old or new.
Status BudgetGrowth::finishLevel(double level, const Progress& progress)
{
    for (std::uint64_t seen = 0;; ++seen) {
        if (seen % levelsAtOnce == 0 && progress.cancelled())
            return cancelledError("Choosing the sites");
        if (!waiting_.empty()) {
            const std::uint32_t site = waiting_.back();
            waiting_.pop_back();
            for (const std::uint32_t parent : links_.parents(site))
                addGroup(parent);
            refineStar(site);
        } else if (!queue_.empty() && queue_.front().scale >= level && !hopelesslyLarge()) {
            std::pop_heap(queue_.begin(), queue_.end());
            const std::uint32_t destroyer = queue_.back().destroyer;
            queue_.pop_back();
            addGroup(destroyer);
        } else if (!coverable_) {
            return inconsistentModel(model_, "its running errors do not bound the tetrahedra's own ones");
        } else {
            return {};
        }
    }
}

void BudgetGrowth::refineStar(std::uint32_t site)
{
    for (const std::uint64_t t : coarseCandidates(model_, set_.sites, judge_, site, candidates_)) {
        const std::uint32_t destroyer = model_.destroyers()[t];
        if (!judge_.tooCoarse(t, site, destroyer))
            continue;
        const double scale = std::max(1 + std::numeric_limits<double>::epsilon(), judge_.scaleFor(t, site, destroyer));
        if (destroyer < links_.siteCount()) {
            queue_.push_back({scale, destroyer});
            std::push_heap(queue_.begin(), queue_.end());
        } else {
            set_.scale = std::max(set_.scale, scale);
        }
    }
}

void BudgetGrowth::addGroup(std::uint32_t site)
{
    if (!coverable_ || set_.sites.contains(site))
        return;
    const GroupOfSites group = groupOf(model_, site);
    coverable_ &= group.end <= links_.siteCount();
    if (!coverable_)
        return;
    set_.tetrahedra += growthBy(model_, group);
    level_.push_back(group.first);
    for (std::uint32_t member = group.first; member < group.end; ++member) {
        set_.sites.insert(member);
        waiting_.push_back(member);
    }
}

void BudgetGrowth::takeBackLevel()
{
    for (const std::uint32_t first : level_) {
        const GroupOfSites group = groupOf(model_, first);
        set_.tetrahedra -= growthBy(model_, group);
        for (std::uint32_t member = group.first; member < group.end; ++member)
            set_.sites.erase(member);
    }
}

Error BudgetGrowth::impossible() const
{
    return {ErrorKind::WrongUsage, "The coarsest mesh of '" + model_.path().string() + "' has " +
                                       std::to_string(set_.tetrahedra) + " tetrahedra, more than the budget of " +
                                       std::to_string(budget_) + ". Allow at least as many."};
}

} // namespace

Result<ClosedSet> closedSetWithin(const Model& model, const HistoryLinks& links, const FieldJudge& judge,
                                  std::uint64_t budget, const Progress& progress)
{
    return BudgetGrowth(model, links, judge, budget).run(progress);
}

} // namespace tetra
