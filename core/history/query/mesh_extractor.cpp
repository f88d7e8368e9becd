// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/query/mesh_extractor.h"

#include "core/base/guarded.h"
#include "core/history/pair_limits.h"
#include "core/history/query/boundary_repair.h"
#include "core/history/query/closed_set.h"
#include "core/history/query/coarse_mesh.h"
#include "core/history/query/curvilinear_focus.h"
#include "core/history/query/history_part.h"
#include "core/history/query/refinement_criterion.h"
#include "core/history/query/region_refiner.h"
#include "core/history/query/window.h"
#include "core/history/site_positions.h"
#include "core/history/whole_elsewhere.h"

#include <tan/query.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

namespace tetra {

namespace {

constexpr double share = 0.9; ///< of the budget that is enough
constexpr int mostMeshes = 12;
constexpr double nearlyEqual = 1.005;
/// By which power of the error the tetrahedra of a smooth field are more, until two meshes say it: it is approximated
/// to second order, in three dimensions.
constexpr double firstPower = 1.5;
constexpr double leastPower = 0.2;
constexpr double mostPower = 6;

double powerBetween(double oneScale, double oneSize, double otherScale, double otherSize)
{
    const double power = std::log((oneSize + 1) / (otherSize + 1)) / std::log(otherScale / oneScale);
    return std::isfinite(power) ? std::clamp(power, leastPower, mostPower) : firstPower;
}

} // namespace

Result<double> scaleWithin(std::uint64_t budget, double first, double largest, const SizeAtScale& sizeAt)
{
    double tooFine = 0; // none known
    double fits = 0;    // none known
    double scale = std::clamp(first, 1.0, largest);
    double made = 0;
    double size = 0;
    double power = firstPower;
    const auto allowed = static_cast<double>(budget);
    for (int meshes = 0; meshes < mostMeshes || fits == 0; ++meshes) {
        const auto found = sizeAt(scale);
        if (!found)
            return found.error();
        if (meshes > 0)
            power = powerBetween(made, size, scale, static_cast<double>(*found));
        made = scale;
        size = static_cast<double>(*found);
        if (size > allowed) {
            if (scale >= largest)
                return Error{
                    ErrorKind::WrongUsage,
                    Message::say(
                        "The coarsest mesh has %1 tetrahedra, more than the budget of %2. Allow at least that many.",
                        *found, budget)};
            tooFine = scale;
        } else {
            fits = scale;
            if (scale == 1 || size >= share * allowed)
                return scale;
        }
        if (tooFine > 0 && fits > 0 && fits <= nearlyEqual * tooFine)
            break;
        const double guess = scale * std::pow((size + 1) / (std::sqrt(share) * allowed), 1 / power);
        const double least = tooFine > 0 ? tooFine * std::sqrt(nearlyEqual) : 1;
        const double most = fits > 0 ? fits / std::sqrt(nearlyEqual) : largest;
        const bool bracketed = tooFine > 0 && fits > 0;
        scale = bracketed && (guess <= least || guess >= most) ? std::sqrt(tooFine * fits)
                                                               : std::clamp(guess, least, std::max(least, most));
    }
    if (made != fits)
        if (const auto again = sizeAt(fits); !again)
            return again.error();
    return fits;
}

Result<MeshSize> meshSizeWithin(const Model& model, const Accuracy& asked, std::uint64_t budget)
{
    const auto tooMany = [&](std::uint64_t tetrahedra) {
        return Error{
            ErrorKind::WrongUsage,
            Message::say(
                "The coarsest mesh of '%1' has %2 tetrahedra, more than the budget of %3. Allow at least that many.",
                model.path().string(), tetrahedra, budget)};
    };
    const MeshSize finest = meshSizeAt(model, asked);
    if (model.elsewhere() != nullptr) {
        const std::vector<MeshSize>& meshes = model.elsewhere()->sizes().meshes;
        std::size_t end = 0;
        while (end < meshes.size() && meshes[end].sites <= finest.sites && meshes[end].tetrahedra <= budget)
            ++end;
        return end > 0 ? Result<MeshSize>(meshes[end - 1]) : tooMany(meshes.front().tetrahedra);
    }
    const std::span<const float> errors = model.runningKeys();
    const std::span<const std::uint32_t> sizes = model.meshSizes();
    constexpr std::uint32_t checkedAtOnce = 1 << 12;
    std::uint32_t within = 0;
    for (std::uint32_t sites = 1; sites <= finest.sites; ++sites) {
        if (sites % checkedAtOnce == 1) {
            const std::size_t count = std::min<std::size_t>(checkedAtOnce, errors.size() - (sites - 1));
            const std::size_t next = sites - 1 + count < errors.size() ? 1 : 0; // the loop looks at it, too
            if (!model.check(errors.subspan(sites - 1, count + next)) || !model.check(sizes.subspan(sites - 1, count)))
                return model.checkIntact().error();
        }
        const bool endsBatch = sites == errors.size() || errors[sites] < errors[sites - 1];
        if (endsBatch && sizes[sites - 1] > budget) {
            if (within == 0)
                return tooMany(sizes[sites - 1]);
            break;
        }
        if (endsBatch)
            within = sites;
    }
    return within == finest.sites ? finest : meshSizeOf(model, within);
}

namespace {

/// A focus that holds more than this share of the fine mesh's sites is much quicker and not much larger as a closed
/// set.
constexpr double sharpShare = 0.6;
/// Grids with more points take too long, if it is not asked for, to be gone through for a pair of limits by insertion.
constexpr std::uint64_t mostPointsOfPairs = 1 << 22;
/// A fall-off wider than this share of the focus is no sharp border any more.
constexpr double sharpFalloff = 0.25;

double extentOf(const Region& region)
{
    if (const auto* const box = std::get_if<Box>(&region))
        return (box->largest - box->least).minCoeff();
    if (const auto* const sphere = std::get_if<Sphere>(&region))
        return 2 * sphere->radius;
    return std::numeric_limits<double>::infinity();
}

/// What a mesh of this scale keeps (keptPercent()), as a field. A ramp stays one, unless it falls off from so little
/// that the scaled one would bend.
ErrorField scaledField(const ErrorField& field, double scale)
{
    if (!(scale > 1))
        return field;
    const SpaceRamp* const ramp = field.asSpaceRamp();
    if (ramp != nullptr && (ramp->falloff == 0 || ramp->inner >= leastScaledPercent)) {
        SpaceRamp scaled = *ramp;
        scaled.inner = keptPercent(ramp->inner, scale);
        scaled.outer = keptPercent(ramp->outer, scale);
        return scaled;
    }
    return ErrorField(scale) * largerOf(field, leastScaledPercent);
}

/// The sites that any mesh within these limits has, or as good as any: those of the uniform one, unless its limits are
/// such that it keeps one of them better than asked; then those of the first mesh.
std::uint32_t coarsestPart(const Model& model, const Accuracy& coarsest)
{
    const bool byOwn = !model.batchErrors().empty() && !isInRatio(model, unitLimits(model, coarsest));
    return meshSizeAt(model, byOwn ? Accuracy{anyError, anyWarping} : coarsest).sites;
}

} // namespace

class MeshExtractor::Work {
public:
    explicit Work(std::shared_ptr<const Model> model) : model_(std::move(model)) {}

    const std::shared_ptr<const Model>& model() const noexcept { return model_; }
    Result<std::shared_ptr<const ExtractedMesh>> extract(const MeshQuery& query, const Progress& progress);

private:
    Result<std::shared_ptr<const ExtractedMesh>> extractRange(const MeshQuery& query, const Progress& progress);
    Status extractWhole(const MeshQuery& query, const Progress& progress);
    Status extractUniform(const MeshQuery& query, const Progress& progress);
    Status extractPair(const MeshQuery& query, const Accuracy& asked, const Progress& progress);
    Status extractSmaller(const MeshQuery& query, const Progress& progress);
    Status extractClosedSet(const MeshQuery& query, const Progress& progress);
    Status extractSoundSet(const MeshQuery& query, const RefinementCriterion& criterion, std::uint32_t finest,
                           const Progress& progress);
    Status extractRepaired(const RefinementCriterion& criterion, bool budgeted, std::uint32_t finest,
                           std::uint64_t most, const Progress& progress, ClosedSet& set);
    std::optional<Message> obstacleToInsertion(const MeshQuery& query) const;
    bool insertionIsBetter(const MeshQuery& query);
    Status extractByInsertion(const MeshQuery& query, const Progress& progress);
    Status extractWithinBudget(const MeshQuery& query, const Progress& progress);
    Status ensureSites(std::uint32_t sites);
    /// A mesh that goes to a caller and comes back when nobody holds it any more.
    struct LendableMesh {
        ExtractedMesh content;
        std::atomic<bool> lent = false;
    };
    static std::shared_ptr<const ExtractedMesh> lend(const std::shared_ptr<LendableMesh>& mesh);
    bool isLent() const { return !whole_ || whole_->lent.load(std::memory_order_acquire); }
    ExtractedMesh& startWhole();

    std::shared_ptr<const Model> model_;
    SitePlaces places_;
    HistoryLinks links_;
    std::optional<RegionRefiner> focus_;               ///< of a regular lattice
    std::optional<CurvilinearFocus> curvilinearFocus_; ///< of a curvilinear grid
    bool insertionFitsHistory_ = true;                 ///< as far as is known: its meshes are Delaunay
    std::shared_ptr<LendableMesh> whole_;              ///< the last mesh before values and window; null after an error
    std::uint32_t uniformSites_ = 0;                   ///< of that, if it is a prefix; else 0
    std::optional<MeshQuery> pair_;                    ///< of that, if it is uniform and no prefix
    std::optional<HistoryPart> part_;                  ///< of the last query with a range
};

Result<std::shared_ptr<const ExtractedMesh>> MeshExtractor::Work::extract(const MeshQuery& query,
                                                                          const Progress& progress)
{
    if (const Status sensible = checkQuery(*model_, query); !sensible)
        return sensible.error();
    if (model_->elsewhere() != nullptr)
        return model_->elsewhere()->extract(query, progress);
    if (query.range)
        return extractRange(query, progress);
    part_.reset();
    const bool filters = !query.values.empty() || query.window.has_value();
    Status found = extractWhole(query, progress.part(0, filters ? 0.7 : 1));
    // Whatever else came of damaged numbers, this is the reason.
    if (const Status intact = model_->checkIntact(); !intact)
        found = intact;
    if (!found) {
        whole_.reset();
        return found.error();
    }
    ExtractedMesh& whole = whole_->content;
    whole.keptSites = static_cast<std::uint32_t>(whole.mesh.positions.size());
    whole.keptTetrahedra = whole.wholeTetrahedra;
    if (!filters)
        return lend(whole_);
    auto part = std::make_shared<ExtractedMesh>(whole_->content);
    if (!query.values.empty())
        if (const Status kept = keepValues(part->mesh, query.values, progress.part(0.7, 0.8)); !kept)
            return kept.error();
    part->keptTetrahedra = part->mesh.tetrahedra.size();
    if (query.window) {
        const auto kept = keepWindow(part->mesh, *query.window, progress.part(0.8, 1));
        if (!kept)
            return kept.error();
        part->keptTetrahedra = *kept;
    }
    dropUnusedVertices(*part);
    return std::shared_ptr<const ExtractedMesh>(std::move(part));
}

/// Of the tetrahedra that are there already, if they are the same meshes'.
Result<std::shared_ptr<const ExtractedMesh>> MeshExtractor::Work::extractRange(const MeshQuery& query,
                                                                               const Progress& progress)
{
    std::uint32_t coarse = meshSizeAt(*model_, query.range->one).sites;
    std::uint32_t fine = meshSizeAt(*model_, query.range->other).sites;
    if (coarse > fine)
        std::swap(coarse, fine);
    if (!part_ || part_->coarse.sites != coarse || part_->fine.sites != fine) {
        part_.reset();
        auto part = extractHistory(*model_, query.range->one, query.range->other, progress.part(0, 0.8));
        if (!part)
            return part.error();
        part_ = *std::move(part);
    }
    auto chosen = chooseLives(*part_, query, progress.part(0.8, 1));
    if (!chosen)
        return chosen.error();
    return std::make_shared<const ExtractedMesh>(*std::move(chosen));
}

Status MeshExtractor::Work::extractWhole(const MeshQuery& query, const Progress& progress)
{
    const bool warps = model_->description().warpingWeight > 0;
    if (query.error.isConstant() && (query.warping.isConstant() || !warps))
        return extractUniform(query, progress);
    const std::optional<Message> obstacle = obstacleToInsertion(query);
    if (query.method == VariableMethod::Insertion && obstacle)
        return Error{ErrorKind::WrongUsage, Message::say("%1. Use a closed set, or the automatic choice.", *obstacle)};
    if (query.method == VariableMethod::Insertion)
        return extractByInsertion(query, progress);
    if (query.method == VariableMethod::Automatic && insertionFitsHistory_ && !obstacle && insertionIsBetter(query)) {
        if (const Status inserted = extractByInsertion(query, progress);
            inserted || inserted.error().kind != ErrorKind::WrongUsage)
            return inserted;
    }
    return extractClosedSet(query, progress);
}

Status MeshExtractor::Work::extractUniform(const MeshQuery& query, const Progress& progress)
{
    const Accuracy asked = {query.error.bounds().minimum, query.warping.bounds().minimum};
    if (!model_->batchErrors().empty() && !isInRatio(*model_, unitLimits(*model_, asked)))
        return extractPair(query, asked, progress);
    MeshSize size = meshSizeAt(*model_, asked);
    if (query.budget) {
        const auto within = meshSizeWithin(*model_, asked, *query.budget);
        if (!within)
            return within.error();
        size = *within;
    }
    if (isLent() || uniformSites_ != size.sites) {
        ExtractedMesh& out = startWhole();
        auto extracted = extractLevel(*model_, size.sites, progress, std::move(out.mesh));
        if (!extracted)
            return extracted.error();
        out.mesh = *std::move(extracted);
        out.sites.resize(size.sites);
        std::iota(out.sites.begin(), out.sites.end(), 0);
        out.points.clear();
        out.wholeSites = size.sites;
        out.wholeTetrahedra = out.mesh.tetrahedra.size();
        out.method = VariableMethod::ClosedSet;
        uniformSites_ = size.sites;
    }
    whole_->content.scale = scaleReached(size, asked);
    whole_->content.reached = Accuracy{size.error, size.warping};
    return {};
}

/// Two limits, one of which a prefix of the history keeps better than requested (C1). A closed set also contains the
/// sites that were inserted earlier for the other limit: for BluntFin, with a limit on the warping alone, 2.8 times the
/// sites of a model built for that limit; insertion needs 1.01 times as many.
Status MeshExtractor::Work::extractPair(const MeshQuery& query, const Accuracy& asked, const Progress& progress)
{
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    MeshQuery pair;
    pair.error = asked.error < anyError ? asked.error : unlimited;
    pair.warping = asked.warping < anyWarping ? asked.warping : unlimited;
    pair.budget = query.budget;
    pair.method = query.method;
    if (!isLent() && pair_ == pair)
        return {};
    const std::optional<Message> obstacle = obstacleToInsertion(pair);
    if (query.method == VariableMethod::Insertion && obstacle)
        return Error{ErrorKind::WrongUsage, Message::say("%1. Use a closed set, or the automatic choice.", *obstacle)};
    Status found;
    if (query.method == VariableMethod::Insertion)
        found = extractByInsertion(pair, progress);
    else if (query.method == VariableMethod::Automatic && insertionFitsHistory_ && !obstacle && !query.budget &&
             model_->description().lattice.pointCount() <= mostPointsOfPairs)
        found = extractSmaller(pair, progress);
    else
        found = extractClosedSet(pair, progress);
    if (found)
        pair_ = std::move(pair);
    return found;
}

/// By both methods: which mesh is smaller, only they tell. A closed set takes a hundredth of the time.
Status MeshExtractor::Work::extractSmaller(const MeshQuery& query, const Progress& progress)
{
    if (const Status found = extractClosedSet(query, progress.part(0, 0.05)); !found)
        return found;
    const std::uint32_t sites = whole_->content.wholeSites;
    const Status inserted = extractByInsertion(query, progress.part(0.05, 0.95));
    if (inserted ? whole_->content.wholeSites <= sites : inserted.error().kind != ErrorKind::WrongUsage)
        return inserted;
    return extractClosedSet(query, progress.part(0.95, 1));
}

Status MeshExtractor::Work::extractClosedSet(const MeshQuery& query, const Progress& progress)
{
    RefinementCriterion criterion(*model_, query, places_);
    const std::uint32_t finest = meshSizeAt(*model_, criterion.finest()).sites;
    constexpr unsigned all = Model::Batches | Model::Stars | Model::OwnBounds;
    if (const Status right = model_->checkPrefix(finest, all, progress); !right)
        return right;
    if (const Status linked = links_.cover(*model_, finest, progress.part(0, 0.3)); !linked)
        return linked;
    if (const Status covered = ensureSites(finest); !covered)
        return covered;
    criterion.lookAtSites(finest);
    return extractSoundSet(query, criterion, finest, progress.part(0.3, 1));
}

/// Of irregular data, whose boundary moves, only meshes at the ends of batches certainly do not meet themselves: other
/// sets are tested, and grow until they do not (C3). Within a budget, one that grows beyond it is begun again with a
/// smaller one.
Status MeshExtractor::Work::extractSoundSet(const MeshQuery& query, const RefinementCriterion& criterion,
                                            std::uint32_t finest, const Progress& progress)
{
    if (!query.budget) {
        constexpr std::uint64_t noLimit = std::numeric_limits<std::uint64_t>::max(); // a damaged file may count any
        auto set = smallestClosedSet(*model_, links_, criterion, coarsestPart(*model_, criterion.coarsest()),
                                     progress.part(0, 0.7));
        return set ? extractRepaired(criterion, false, finest, noLimit, progress.part(0.7, 1), *set)
                   : Status(set.error());
    }
    constexpr int mostBudgets = 6;
    std::uint64_t budget = *query.budget;
    for (int tried = 0; tried < mostBudgets && budget > 0; ++tried) {
        auto set = closedSetWithin(*model_, links_, criterion, budget, progress.part(0, 0.7));
        if (!set && tried > 0)
            break; // less than the coarsest mesh
        if (!set)
            return set.error();
        if (const Status extracted =
                extractRepaired(criterion, true, finest, *query.budget, progress.part(0.7, 1), *set);
            !extracted || set->tetrahedra <= *query.budget)
            return extracted;
        budget -= std::min(budget, 2 * (set->tetrahedra - *query.budget));
    }
    const auto size = meshSizeWithin(*model_, criterion.finest(), *query.budget);
    if (!size)
        return size.error();
    ClosedSet prefix{SiteSet(model_->siteCount(), size->sites), size->sites, size->tetrahedra,
                     scaleReached(*size, criterion.finest())};
    return extractSet(*model_, prefix, places_, progress.part(0.7, 1), startWhole());
}

/// Ends with a larger set than `most` tetrahedra as soon as that is known.
Status MeshExtractor::Work::extractRepaired(const RefinementCriterion& criterion, bool budgeted, std::uint32_t finest,
                                            std::uint64_t most, const Progress& progress, ClosedSet& set)
{
    constexpr int mostRounds = 32;
    for (int round = 0; set.tetrahedra <= most; ++round) {
        const Progress rest = progress.part(1 - 1 / (1.0 + round), 1 - 1 / (2.0 + round));
        if (const Status extracted = extractSet(*model_, set, places_, rest, startWhole()); !extracted)
            return extracted;
        if (model_->description().domain != DomainClass::Irregular || set.sites.count() == set.prefix)
            return {};
        const auto repair = testBoundary(*model_, whole_->content, finest, rest.withCallback({}));
        if (!repair)
            return repair.error();
        if (repair->isSound)
            return {};
        // At worst the prefix of the finest accuracy that is asked for anywhere.
        std::vector<std::uint32_t> all;
        if (repair->sites.empty() || round >= mostRounds) {
            all.resize(finest);
            std::iota(all.begin(), all.end(), 0);
        }
        const std::uint32_t before = set.sites.count();
        if (const Status extended =
                extendSet(*model_, links_, criterion, budgeted,
                          all.empty() ? std::span(repair->sites) : std::span<const std::uint32_t>(all),
                          rest.withCallback({}), set);
            !extended)
            return extended;
        if (set.sites.count() == before)
            return {}; // the model's finest mesh is no better
    }
    return {};
}

/// Why a query cannot be answered by insertion, a sentence without its full stop; nothing if, without looking, it can.
std::optional<Message> MeshExtractor::Work::obstacleToInsertion(const MeshQuery& query) const
{
    if (model_->description().domain == DomainClass::Scattered)
        return Message::say("Insertion is for lattices and curvilinear grids, not for scattered points");
    if (!model_->description().delaunay)
        return Message::say("Insertion needs a model made by refinement, whose meshes are Delaunay meshes");
    if (model_->samples().empty())
        return Message::say("Insertion needs all samples of the dataset, which the file of this model does not hold");
    if (CurvilinearFocus::fits(*model_))
        return std::nullopt;
    const SpaceRamp* const ramp = query.error.asSpaceRamp();
    if (ramp == nullptr || !(ramp->inner < ramp->outer))
        return Message::say("Insertion into a lattice is for one box, sphere or half-space of smaller error");
    if (query.budget && scaledField(query.error, 2).asSpaceRamp() == nullptr)
        return Message::say("Insertion within a budget needs a sharp border, or an error of at least %1 to fall off "
                            "from",
                            "0.001 %");
    if (RegionRefiner::fits(*model_))
        return std::nullopt;
    return Message::say("Insertion cannot tell how this model was built, or its grid is too large");
}

/// Closed sets are small for graded fields, and quick for large foci. In computational space, where much of a grid
/// can lie in a small place, they are large for any sharp focus.
bool MeshExtractor::Work::insertionIsBetter(const MeshQuery& query)
{
    const SpaceRamp* const ramp = query.error.asSpaceRamp();
    if (ramp == nullptr || !(ramp->inner < ramp->outer) || ramp->falloff > sharpFalloff * extentOf(ramp->region))
        return false;
    if (query.budget || model_->description().domain == DomainClass::Curvilinear)
        return true;
    if (!focus_)
        focus_.emplace(*model_);
    const double fine = meshSizeAt(*model_, {query.error.bounds().minimum}).sites;
    return static_cast<double>(focus_->sitesInside(*ramp)) <= sharpShare * fine;
}

/// As often as it takes to find out how much coarser the budget makes it.
Status MeshExtractor::Work::extractWithinBudget(const MeshQuery& query, const Progress& progress)
{
    const Accuracy outside = {query.error.bounds().maximum, query.warping.bounds().maximum};
    const auto coarse = meshSizeWithin(*model_, outside, *query.budget);
    if (!coarse)
        return coarse.error();
    constexpr double all = 100;
    const double largest = all / std::max(query.error.bounds().minimum, leastScaledPercent);
    int meshes = 0;
    const auto sizeAt = [&](double scale) -> Result<std::uint64_t> {
        MeshQuery scaled = query;
        scaled.budget.reset();
        scaled.error = scaledField(query.error, scale);
        scaled.warping = scaledField(query.warping, scale);
        progress.report(1 - 1 / (1 + 0.25 * ++meshes),
                        Message::marked("Searching for the best mesh within the budget"));
        if (const Status found = extractByInsertion(scaled, progress.withCallback({})); !found)
            return found.error();
        return whole_->content.wholeTetrahedra;
    };
    const auto scale = scaleWithin(*query.budget, scaleReached(*coarse, outside), largest, sizeAt);
    if (!scale)
        return scale.error();
    whole_->content.scale = *scale;
    return {};
}

Status MeshExtractor::Work::extractByInsertion(const MeshQuery& query, const Progress& progress)
{
    if (query.budget)
        return extractWithinBudget(query, progress);
    ExtractedMesh& out = startWhole();
    const bool curvilinear = model_->description().domain == DomainClass::Curvilinear;
    if (curvilinear && !curvilinearFocus_)
        curvilinearFocus_.emplace(*model_);
    if (!curvilinear && !focus_)
        focus_.emplace(*model_);
    auto found = curvilinear ? curvilinearFocus_->extract(query, progress, std::move(out))
                             : focus_->extract(*query.error.asSpaceRamp(), false, progress, std::move(out));
    if (!found) {
        // Of another builder: only looking at its meshes tells.
        insertionFitsHistory_ &= found.error().kind != ErrorKind::WrongUsage;
        return found.error();
    }
    out = *std::move(found);
    return {};
}

Status MeshExtractor::Work::ensureSites(std::uint32_t sites)
{
    if (sites <= places_.positions.size())
        return {};
    Status covered = placeSites(*model_, sites, places_.positions);
    if (covered)
        covered = copyValues(*model_, sites, places_.values);
    if (!covered)
        places_.positions.clear();
    return covered;
}

/// The pointer that callers share counts apart from ours, and its end says that they are done: what they read happened
/// before what is written next.
std::shared_ptr<const ExtractedMesh> MeshExtractor::Work::lend(const std::shared_ptr<LendableMesh>& mesh)
{
    mesh->lent.store(true, std::memory_order_relaxed);
    return {&mesh->content, [mesh](const ExtractedMesh*) { mesh->lent.store(false, std::memory_order_release); }};
}

/// To be overwritten: the last mesh, so that its memory is used again, or another one if it is in others' hands.
ExtractedMesh& MeshExtractor::Work::startWhole()
{
    if (isLent())
        whole_ = std::make_shared<LendableMesh>();
    uniformSites_ = 0;
    pair_.reset();
    return whole_->content;
}

MeshExtractor::MeshExtractor(std::shared_ptr<const Model> model) : work_(std::make_unique<Work>(std::move(model))) {}
MeshExtractor::~MeshExtractor() = default;
MeshExtractor::MeshExtractor(MeshExtractor&&) noexcept = default;
MeshExtractor& MeshExtractor::operator=(MeshExtractor&&) noexcept = default;

const std::shared_ptr<const Model>& MeshExtractor::model() const noexcept
{
    return work_->model();
}

Result<std::shared_ptr<const ExtractedMesh>> MeshExtractor::extract(const MeshQuery& query, const Progress& progress)
{
    auto mesh =
        guarded(Message::marked(
                    "There is not enough memory for this mesh. Choose a larger error, a smaller focus or a budget."),
                [&] { return work_->extract(query, progress); });
    if (!mesh && mesh.error().kind == ErrorKind::OutOfResource)
        work_ = std::make_unique<Work>(work_->model()); // without what it kept for the next query
    return mesh;
}

} // namespace tetra
