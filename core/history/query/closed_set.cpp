// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/closed_set.h"

#include "core/history/site_positions.h"
#include "core/history/walk.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace tetra {

namespace {

/// Calls `link(site, parent)` for every site and each of its parents, parents ascending.
template <class Link> Status visitLinks(const Model& model, std::uint32_t sites, Buffer<std::uint32_t>& lastParents,
                                        const Progress& progress, const Link& link)
{
    lastParents.assign(sites, Model::never);
    const auto visit = [&](const Stars& stars) -> Status {
        bool right = true;
        forEachAlive(stars, 0, [&](std::uint32_t creator, std::uint64_t, std::uint32_t destroyer) {
            if (destroyer >= sites || lastParents[destroyer] == creator)
                return;
            right &= destroyer > creator;
            lastParents[destroyer] = creator;
            link(destroyer, creator);
        });
        return right ? Status()
                     : inconsistentModel(model, Message::say("a tetrahedron is destroyed before it is created"));
    };
    return walkHistory(model, 0, sites, progress, Message::marked("Reading the history"), visit);
}

} // namespace

Status HistoryLinks::cover(const Model& model, std::uint32_t sites, const Progress& progress)
{
    if (sites <= siteCount_)
        return {};
    siteCount_ = 0;
    Buffer<std::uint32_t> lastParents;
    offsets_.assign(sites + std::size_t(2), 0);
    if (const Status counted = visitLinks(model, sites, lastParents, progress.part(0, 0.5),
                                          [this](std::uint32_t site, std::uint32_t) { ++offsets_[site + 2]; });
        !counted)
        return counted;
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    const std::uint64_t count = offsets_.back();
    parents_.resize(count);
    bool same = true; // the file may be changed between the passes
    const auto fill = [this, count, &same](std::uint32_t site, std::uint32_t parent) {
        std::uint64_t& place = offsets_[site + 1];
        if (place < count)
            parents_[place++] = parent;
        else
            same = false;
    };
    if (const Status filled = visitLinks(model, sites, lastParents, progress.part(0.5, 1), fill); !filled)
        return filled;
    if (!same || !std::ranges::is_sorted(offsets_) || offsets_[sites] != count)
        return inconsistentModel(model, Message::say("its destroyers changed while they were read"));
    offsets_.pop_back();
    siteCount_ = sites;
    return {};
}

namespace {

/// The sites [first, end) of one group: a set of sites that is to have a mesh takes them all or none (FORMAT.md).
struct GroupOfSites {
    std::uint32_t first;
    std::uint32_t end;
};

GroupOfSites groupOf(const Model& model, std::uint32_t site)
{
    const std::span<const std::uint8_t> goesOn = model.groupGoesOn();
    GroupOfSites group{site, site + 1};
    while (group.first > 0 && goesOn[group.first - 1] != 0)
        --group.first;
    while (group.end < goesOn.size() && goesOn[group.end - 1] != 0)
        ++group.end;
    return group;
}

/// By how many tetrahedra the site makes a mesh larger; what counts is the sum over its group. Modulo 2^64: it may make
/// it smaller.
std::uint64_t growthBy(const Model& model, std::uint32_t site)
{
    const std::span<const std::uint32_t> sizes = model.meshSizes();
    return std::uint64_t(sizes[site]) - (site > 0 ? sizes[site - 1] : 0);
}

/// The tetrahedra that the site created, that none of the sites destroys, and that may be coarser than the criterion
/// allows. In `buffer`, which is used from star to star: written without a branch on what no processor could predict.
std::span<const std::uint64_t> coarseCandidates(const Model& model, const SiteSet& sites,
                                                const RefinementCriterion& criterion, std::uint32_t site,
                                                Buffer<std::uint64_t>& buffer)
{
    const auto star = starOf(model, site);
    if (buffer.size() <= star.size())
        buffer.resize(2 * star.size() + 1);
    std::size_t count = 0;
    for (const std::uint64_t t : star) {
        const bool stays = !sites.contains(std::min(model.destroyers()[t], model.siteCount()));
        buffer[count] = t;
        count += static_cast<std::size_t>(stays & criterion.mayBeTooCoarse(t));
    }
    return std::span(buffer).first(count);
}

/// Sites between asking memory for a star and looking at it: they come in no order that it could know.
constexpr std::size_t sitesAhead = 6;
/// The least scale that says that something was not reached.
constexpr double moreThanAsked = 1 + std::numeric_limits<double>::epsilon();
constexpr MarkedText choosing = Message::marked("Selecting the sites");

/// A closed set while it grows: a tetrahedron that is too coarse must be destroyed, so its destroyer comes with its
/// group and all that these need. Without a budget that is done at once. With one, what is farthest from what was asked
/// goes first, level by level: all that is worse than a scale goes before anything better, and the level that passes
/// the budget is taken back.
class Growth {
public:
    static constexpr std::uint64_t noBudget = std::numeric_limits<std::uint64_t>::max();

    Growth(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion, ClosedSet set,
           std::uint64_t budget)
        : model_(model), links_(links), criterion_(criterion), budget_(budget), set_(std::move(set))
    {
    }

    static ClosedSet firstSites(const Model& model, std::uint32_t prefix)
    {
        return {SiteSet(model.siteCount(), prefix), prefix, prefix > 0 ? model.meshSizes()[prefix - 1] : 0, 1};
    }

    Result<ClosedSet> run(const Progress& progress);
    Result<ClosedSet> runWithin(const Progress& progress);
    Result<ClosedSet> goOn(std::span<const std::uint32_t> sites, const Progress& progress);

private:
    struct Coarse {
        double scale;
        std::uint32_t destroyer;
        bool operator<(const Coarse& other) const { return scale < other.scale; }
    };

    Status close(double level, const Progress& progress);
    void fetchAhead() const;
    void refineStar(std::uint32_t site);
    void addGroup(std::uint32_t site);
    void takeBack(std::size_t firstAdded);
    bool isHopeless() const;

    const Model& model_;
    const HistoryLinks& links_;
    const RefinementCriterion& criterion_;
    const std::uint64_t budget_;
    ClosedSet set_;
    std::vector<std::uint32_t> added_; ///< behind the prefix, in the order in which they are looked at
    std::size_t next_ = 0;             ///< of these
    std::vector<Coarse> queue_;        ///< a heap; empty without a budget
    Buffer<std::uint64_t> candidates_;
    std::uint64_t steps_ = 0;
    bool linksReach_ = true; ///< every site that was needed has its links
};

Result<ClosedSet> Growth::run(const Progress& progress)
{
    constexpr std::uint32_t sitesAtOnce = 1 << 12;
    for (std::uint32_t site = 0; site < set_.prefix; ++site) {
        if (site % sitesAtOnce == 0 && progress.cancelled())
            return cancelledError(choosing);
        refineStar(site);
    }
    if (const Status closed = close(0, progress); !closed)
        return closed.error();
    return std::move(set_);
}

Result<ClosedSet> Growth::runWithin(const Progress& progress)
{
    addGroup(0);
    if (const Status begun = close(std::numeric_limits<double>::infinity(), progress); !begun)
        return begun.error();
    if (set_.tetrahedra > budget_)
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "The coarsest mesh of '%1' has %2 tetrahedra, more than the budget of %3. Allow at least that many.",
                model_.path().string(), set_.tetrahedra, budget_)};
    while (!queue_.empty()) {
        const double level = queue_.front().scale;
        const double before = set_.scale;
        const std::size_t firstAdded = added_.size();
        if (const Status closed = close(level, progress); !closed)
            return closed.error();
        if (set_.tetrahedra > budget_) {
            takeBack(firstAdded);
            set_.scale = std::max(before, level);
            break;
        }
    }
    return std::move(set_);
}

/// What is left of an earlier level has its scale.
Result<ClosedSet> Growth::goOn(std::span<const std::uint32_t> sites, const Progress& progress)
{
    for (const std::uint32_t site : sites)
        addGroup(site);
    const double worse = std::nextafter(set_.scale, std::numeric_limits<double>::infinity());
    if (const Status closed = close(worse, progress); !closed)
        return closed.error();
    return std::move(set_);
}

/// Looks at all that was added, and destroys every tetrahedron of that scale or more, old or new.
Status Growth::close(double level, const Progress& progress)
{
    constexpr std::uint64_t stepsAtOnce = 1 << 12;
    for (;; ++steps_) {
        if (steps_ % stepsAtOnce == 0) {
            if (progress.cancelled())
                return cancelledError(choosing);
            progress.report(budget_ == noBudget ? 0 : std::min(1.0, double(set_.tetrahedra) / double(budget_)),
                            choosing);
        }
        if (next_ < added_.size()) {
            fetchAhead();
            const std::uint32_t site = added_[next_++];
            for (const std::uint32_t parent : links_.parents(site))
                addGroup(parent);
            refineStar(site);
        } else if (!queue_.empty() && queue_.front().scale >= level && !isHopeless()) {
            std::pop_heap(queue_.begin(), queue_.end());
            const std::uint32_t destroyer = queue_.back().destroyer;
            queue_.pop_back();
            addGroup(destroyer);
        } else {
            return linksReach_
                       ? Status()
                       : inconsistentModel(
                             model_, Message::say("its running errors do not bound the errors of its tetrahedra"));
        }
    }
}

void Growth::fetchAhead() const
{
    if (next_ + 2 * sitesAhead < added_.size()) {
        fetchStarOffsets(model_, added_[next_ + 2 * sitesAhead]);
        links_.fetchOffsets(added_[next_ + 2 * sitesAhead]);
    }
    if (next_ + sitesAhead < added_.size()) {
        fetchStar(model_, added_[next_ + sitesAhead]);
        links_.fetchParents(added_[next_ + sitesAhead]);
    }
}

void Growth::refineStar(std::uint32_t site)
{
    for (const std::uint64_t t : coarseCandidates(model_, set_.sites, criterion_, site, candidates_)) {
        const std::uint32_t destroyer = model_.destroyers()[t];
        if (set_.sites.contains(std::min(destroyer, model_.siteCount())) || !criterion_.tooCoarse(t, site, destroyer))
            continue;
        if (budget_ == noBudget && destroyer < model_.siteCount()) {
            addGroup(destroyer);
            continue;
        }
        const double scale = std::max(moreThanAsked, criterion_.scaleFor(t, site, destroyer));
        if (destroyer < links_.siteCount()) {
            queue_.push_back({scale, destroyer});
            std::push_heap(queue_.begin(), queue_.end());
        } else {
            set_.scale = std::max(set_.scale, scale);
        }
    }
}

void Growth::addGroup(std::uint32_t site)
{
    if (!linksReach_ || set_.sites.contains(site))
        return;
    const GroupOfSites group = groupOf(model_, site);
    linksReach_ = group.end <= links_.siteCount();
    if (!linksReach_)
        return;
    for (std::uint32_t member = group.first; member < group.end; ++member) {
        set_.tetrahedra += growthBy(model_, member);
        set_.sites.insert(member);
        added_.push_back(member);
    }
}

void Growth::takeBack(std::size_t firstAdded)
{
    for (const std::uint32_t site : std::span(added_).subspan(firstAdded)) {
        set_.tetrahedra -= growthBy(model_, site);
        set_.sites.erase(site);
    }
}

/// A level that has gone so far beyond the budget will not come back.
bool Growth::isHopeless() const
{
    constexpr std::uint64_t hopeless = 2;
    constexpr std::uint64_t hopelessAtLeast = 1 << 16;
    return set_.tetrahedra > hopeless * budget_ + hopelessAtLeast;
}

} // namespace

Result<ClosedSet> smallestClosedSet(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion,
                                    std::uint32_t prefix, const Progress& progress)
{
    if (prefix > links.siteCount()) // more than the finest mesh has, which is all that was read
        return inconsistentModel(model, Message::say("its meshes do not grow with their accuracy"));
    return Growth(model, links, criterion, Growth::firstSites(model, prefix), Growth::noBudget).run(progress);
}

Result<ClosedSet> closedSetWithin(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion,
                                  std::uint64_t budget, const Progress& progress)
{
    return Growth(model, links, criterion, Growth::firstSites(model, 0), std::min(budget, model.tetrahedronCount()))
        .runWithin(progress);
}

Status extendSet(const Model& model, const HistoryLinks& links, const RefinementCriterion& criterion, bool budgeted,
                 std::span<const std::uint32_t> sites, const Progress& progress, ClosedSet& set)
{
    const std::uint64_t most = budgeted ? model.tetrahedronCount() : Growth::noBudget;
    auto extended = Growth(model, links, criterion, std::move(set), most).goOn(sites, progress);
    if (!extended)
        return extended.error();
    set = *std::move(extended);
    return {};
}

namespace {

constexpr std::uint32_t starsAtOnce = 1 << 14;
/// Sites between asking memory for a star and reading it.
constexpr std::size_t starsAhead = 6;

/// The largest of many numbers of which each is the smaller of its own bound, rounded up in the file, and what the mesh
/// had that its tetrahedron died in. Few of the latter, which lie anywhere, are looked at.
class LargestBound {
public:
    /// `own` as in the file, where numbers that are not negative come in the order of their bits.
    template <class Bound, class AtDeath> void take(std::uint16_t own, const Bound& bound, const AtDeath& atDeath)
    {
        if (own <= seen_)
            return;
        const double ownBound = bound(), other = atDeath();
        if (ownBound <= other)
            seen_ = own;
        largest_ = std::max(largest_, std::min(ownBound, other));
    }
    double largest() const { return largest_; }

private:
    std::uint16_t seen_ = 0;
    double largest_ = 0;
};

/// Copies the tetrahedra of the stars that none of the sites destroys.
class SetScan {
public:
    SetScan(const Model& model, const ClosedSet& set, ExtractedMesh& out)
        : model_(model), set_(set), out_(out), warps_(model.description().warpingWeight > 0)
    {
    }

    void numberVertices();
    Status run(const Progress& progress);
    /// Of the tetrahedra that were copied.
    Accuracy reached() const;

private:
    void scanStar(std::uint32_t site);
    void noteBounds(std::uint64_t tetrahedron);
    std::uint32_t vertexOf(std::uint32_t site) const { return site < set_.prefix ? site : later_[site - set_.prefix]; }

    const Model& model_;
    const ClosedSet& set_;
    ExtractedMesh& out_;
    const bool warps_;
    LargestBound error_;          ///< in units of the values
    LargestBound warping_;        ///< in units of length
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
                return cancelledError(Message::marked("Extracting the mesh"));
            progress.report(static_cast<double>(vertex) / static_cast<double>(out_.sites.size()),
                            Message::marked("Extracting the mesh"));
        }
        if (vertex + 2 * starsAhead < out_.sites.size()) {
            fetchStarOffsets(model_, out_.sites[vertex + 2 * starsAhead]);
            fetchStar(model_, out_.sites[vertex + starsAhead]);
        }
        scanStar(out_.sites[vertex]);
    }
    if (!right_ || found_ != tetrahedra.size())
        return inconsistentModel(model_, Message::say("its tetrahedra do not match its mesh sizes"));
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
        noteBounds(t);
        right_ &= others[0] < site && others[1] < site && others[2] < site;
        tetrahedra[found_++] = {creator, vertexOf(std::min(others[0], site)), vertexOf(std::min(others[1], site)),
                                vertexOf(std::min(others[2], site))};
    }
}

void SetScan::noteBounds(std::uint64_t tetrahedron)
{
    const auto keyAtDeath = [&] {
        const std::uint32_t destroyer = model_.destroyers()[tetrahedron];
        if (destroyer >= model_.siteCount())
            return model_.finalKey();
        model_.check(model_.runningKeys()[destroyer]); // it may lie behind all that the query was expected to read
        return model_.runningKeys()[destroyer];
    };
    error_.take(
        model_.ownErrors()[tetrahedron], [&] { return model_.ownError(tetrahedron); },
        [&] { return static_cast<double>(keyAtDeath()); });
    if (warps_)
        warping_.take(
            model_.ownWarpings()[tetrahedron], [&] { return model_.ownWarping(tetrahedron); },
            [&] { return keyAtDeath() / model_.description().warpingWeight; });
}

Accuracy SetScan::reached() const
{
    const double extent = model_.description().range.extent();
    return {extent > 0 ? 100 * error_.largest() / extent : 0,
            warps_ ? 100 * warping_.largest() / model_.diagonal() : 0};
}

} // namespace

Status extractSet(const Model& model, const ClosedSet& set, const SitePlaces& places, const Progress& progress,
                  ExtractedMesh& out)
{
    if (set.tetrahedra > model.tetrahedronCount())
        return inconsistentModel(model, Message::say("its mesh sizes are invalid"));
    SetScan scan(model, set, out);
    scan.numberVertices();
    if (const Status scanned = scan.run(progress); !scanned)
        return scanned;
    const auto noVertex = [](const std::array<std::uint32_t, 4>& t) {
        return std::ranges::find(t, ExtractedMesh::noSite) != t.end();
    };
    if (std::ranges::any_of(out.mesh.tetrahedra, noVertex))
        return inconsistentModel(model, Message::say("a tetrahedron has a site that its creator does not need"));
    turnToPhysicalSpace(model, out.mesh.tetrahedra);
    out.mesh.positions.resize(out.sites.size());
    out.mesh.values.resize(out.sites.size());
    std::ranges::transform(out.sites, out.mesh.positions.begin(),
                           [&places](std::uint32_t site) { return places.positions[site]; });
    std::ranges::transform(out.sites, out.mesh.values.begin(),
                           [&places](std::uint32_t site) { return places.values[site]; });
    out.wholeSites = set.sites.count();
    out.wholeTetrahedra = out.mesh.tetrahedra.size();
    out.scale = set.scale;
    out.reached = scan.reached();
    out.method = VariableMethod::ClosedSet;
    return {};
}

} // namespace tetra
