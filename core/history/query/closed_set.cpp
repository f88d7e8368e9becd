// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/closed_set.h"

#include "core/history/query/history_links.h"
#include "core/history/site_positions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
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
    Growth(const Model& model, const HistoryLinks& links, const RefinementCriterion& judge, std::uint32_t prefix)
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
    const RefinementCriterion& judge_;
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

Result<ClosedSet> smallestClosedSet(const Model& model, const HistoryLinks& links, const RefinementCriterion& judge,
                                    std::uint32_t prefix, const Progress& progress)
{
    return Growth(model, links, judge, prefix).run(progress);
}

namespace {

constexpr std::uint32_t levelsAtOnce = 1 << 10;
/// A level that has gone so far beyond the budget will not come back.
constexpr std::uint64_t hopeless = 2;
constexpr std::uint64_t hopelessAtLeast = 1 << 16;

/// Grows a closed set by the scale of its mesh's worst tetrahedra, level by level: all that is worse than a scale goes
/// before anything better.
class BudgetGrowth {
public:
    BudgetGrowth(const Model& model, const HistoryLinks& links, const RefinementCriterion& judge, std::uint64_t budget)
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
    const RefinementCriterion& judge_;
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

Result<ClosedSet> closedSetWithin(const Model& model, const HistoryLinks& links, const RefinementCriterion& judge,
                                  std::uint64_t budget, const Progress& progress)
{
    return BudgetGrowth(model, links, judge, budget).run(progress);
}

namespace {

constexpr std::uint32_t starsAtOnce = 1 << 14;
/// Sites between asking memory for a star and reading it.
constexpr std::size_t starsAhead = 6;

/// Copies the tetrahedra of the stars that none of the sites destroys.
class SetScan {
public:
    SetScan(const Model& model, const ClosedSet& set, ExtractedMesh& out) : model_(model), set_(set), out_(out) {}

    void numberVertices();
    Status run(const Progress& progress);

private:
    void scanStar(std::uint32_t site);
    std::uint32_t vertexOf(std::uint32_t site) const { return site < set_.prefix ? site : later_[site - set_.prefix]; }

    const Model& model_;
    const ClosedSet& set_;
    ExtractedMesh& out_;
    Buffer<std::uint32_t> later_; ///< the vertices of the sites behind the prefix
    Buffer<std::uint64_t> alive_;
    std::uint64_t found_ = 0;
    bool right_ = true;
};

void SetScan::numberVertices()
{
    out_.points.clear();
    out_.sites.resize(set_.sites.count());
    std::iota(out_.sites.begin(), out_.sites.begin() + set_.prefix, 0);
    std::uint32_t vertex = set_.prefix;
    set_.sites.visitFrom(set_.prefix, [this, &vertex](std::uint32_t site) { out_.sites[vertex++] = site; });
    const std::uint32_t end = vertex > set_.prefix ? out_.sites.back() + 1 : set_.prefix;
    later_.assign(end - set_.prefix, ExtractedMesh::noSite);
    for (std::uint32_t later = set_.prefix; later < vertex; ++later)
        later_[out_.sites[later] - set_.prefix] = later;
}

Status SetScan::run(const Progress& progress)
{
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out_.mesh.tetrahedra;
    tetrahedra.resize(set_.tetrahedra);
    for (std::size_t vertex = 0; vertex < out_.sites.size(); ++vertex) {
        if (vertex % starsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError("Extracting the mesh");
            progress.report(static_cast<double>(vertex) / static_cast<double>(out_.sites.size()),
                            "Extracting the mesh");
        }
        if (vertex + 2 * starsAhead < out_.sites.size()) {
            fetchStarOffsets(model_, out_.sites[vertex + 2 * starsAhead]);
            fetchStar(model_, out_.sites[vertex + starsAhead], false);
        }
        scanStar(out_.sites[vertex]);
    }
    if (!right_ || found_ != tetrahedra.size())
        return inconsistentModel(model_, "its tetrahedra do not fit its mesh sizes");
    return {};
}

/// First which ones, without a branch on what no processor could predict; then their vertices.
void SetScan::scanStar(std::uint32_t site)
{
    const auto star = starOf(model_, site);
    if (alive_.size() <= star.size())
        alive_.resize(2 * star.size() + 1);
    std::size_t count = 0;
    for (const std::uint64_t t : star) {
        alive_[count] = t;
        count += set_.sites.contains(std::min(model_.destroyers()[t], model_.siteCount())) ? 0 : 1;
    }
    Buffer<std::array<std::uint32_t, 4>>& tetrahedra = out_.mesh.tetrahedra;
    right_ &= count <= tetrahedra.size() - found_;
    if (!right_)
        return;
    const std::uint32_t creator = vertexOf(site);
    for (const std::uint64_t t : std::span(alive_).first(count)) {
        const std::array<std::uint32_t, 3> others = model_.otherSites()[t];
        right_ &= others[0] < site && others[1] < site && others[2] < site;
        tetrahedra[found_++] = {creator, vertexOf(std::min(others[0], site)), vertexOf(std::min(others[1], site)),
                                vertexOf(std::min(others[2], site))};
    }
}

} // namespace

Status extractSet(const Model& model, const ClosedSet& set, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out)
{
    if (set.tetrahedra > model.tetrahedronCount())
        return inconsistentModel(model, "its mesh sizes make no sense");
    SetScan scan(model, set, out);
    scan.numberVertices();
    if (const Status scanned = scan.run(progress); !scanned)
        return scanned;
    const auto noVertex = [](const std::array<std::uint32_t, 4>& t) {
        return std::ranges::find(t, ExtractedMesh::noSite) != t.end();
    };
    if (std::ranges::any_of(out.mesh.tetrahedra, noVertex))
        return inconsistentModel(model, "a tetrahedron has a site that its creator does not need");
    if (model.description().leftHanded)
        for (std::array<std::uint32_t, 4>& tetrahedron : out.mesh.tetrahedra)
            std::swap(tetrahedron[2], tetrahedron[3]);
    out.mesh.positions.resize(out.sites.size());
    out.mesh.values.resize(out.sites.size());
    std::ranges::transform(out.sites, out.mesh.positions.begin(),
                           [&places](std::uint32_t site) { return places.positions[site]; });
    std::ranges::transform(out.sites, out.mesh.values.begin(),
                           [&places](std::uint32_t site) { return places.values[site]; });
    out.wholeSites = set.sites.count();
    out.wholeTetrahedra = out.mesh.tetrahedra.size();
    out.scale = set.scale;
    out.method = VariableMethod::ClosedSet;
    return {};
}

} // namespace tetra
