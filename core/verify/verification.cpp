// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/history/build_facts.h"
#include "core/history/derived_sections.h"
#include "core/verify/cell_check.h"
#include "core/verify/error_in_space.h"
#include "core/verify/verify_irregular.h"
#include "core/verify/verify_parts.h"

#include <tan/data.h>
#include <tan/verify.h>

#include <algorithm>
#include <limits>
#include <optional>

namespace tetra {

namespace {

LevelReport notChecked(const Accuracy& asked)
{
    LevelReport verdict;
    verdict.asked = asked;
    verdict.failures = {"Not checked, because the model as a whole is wrong."};
    return verdict;
}

/// Limits on error and warping, in units of the values and of length; infinite where there is none.
struct Limits {
    double error = 0;
    double warping = 0;
};

Limits limitsOf(const Model& model, const Original& original, const Accuracy& asked)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    const double error = asked.error / 100 * original.extent;
    if (!(model.description().warpingWeight > 0))
        return {error, none};
    return {original.extent > 0 && asked.error < anyError ? error : none,
            asked.warping < anyWarping ? asked.warping / 100 * original.diagonal : none};
}

/// What a model claims of the meshes at the ends of its batches: by their keys, and where the file tells the two apart
/// by error and warping.
class Claims {
public:
    explicit Claims(const Model& model)
        : model_(model), weight_(model.description().warpingWeight),
          byKeysAlone_(buildFacts(model.description()).claimsByKeysAlone()), derived_(derivedSections(model))
    {
    }

    /// Of the mesh of the first sites, which end a batch.
    Limits of(std::uint32_t sites) const
    {
        Limits bounds;
        bounds.error =
            static_cast<double>(sites < model_.siteCount() ? model_.runningKeys()[sites] : model_.finalKey());
        bounds.warping = weight_ > 0 ? bounds.error / weight_ : 0;
        if (byKeysAlone_)
            return bounds;
        const auto end = std::ranges::lower_bound(derived_.batchEnds, sites - 1);
        const auto batch = static_cast<std::size_t>(end - derived_.batchEnds.begin());
        if (batch >= std::min(derived_.batchErrors.size(), derived_.batchWarpings.size()))
            return bounds;
        bounds.error = std::min(bounds.error, static_cast<double>(derived_.batchErrors[batch]));
        bounds.warping = std::min(bounds.warping, static_cast<double>(derived_.batchWarpings[batch]));
        return bounds;
    }

    /// The sites of the first mesh that keeps both limits, found by looking at one after the other (S1, C1); if there
    /// is none, of the one of the smallest key, which need not be the last.
    std::uint32_t firstPassage(const Limits& limits) const
    {
        // Of a file that is cut short meanwhile only zeros are left, which the model tells afterwards.
        const std::uint32_t initial = std::clamp(initialSiteCount(model_), std::uint32_t(1), model_.siteCount());
        for (std::uint32_t sites = initial; sites <= model_.siteCount(); ++sites) {
            const bool endsBatch =
                sites == model_.siteCount() || model_.runningKeys()[sites] < model_.runningKeys()[sites - 1];
            if (!endsBatch)
                continue;
            const Limits bounds = of(sites);
            if (bounds.error <= limits.error && bounds.warping <= limits.warping)
                return sites;
        }
        const float least = *std::ranges::min_element(model_.runningKeys());
        std::uint32_t sites = model_.siteCount();
        if (least < model_.finalKey())
            for (sites = initial; sites < model_.siteCount() && model_.runningKeys()[sites] > least;)
                ++sites;
        return sites;
    }

private:
    const Model& model_;
    const double weight_;
    const bool byKeysAlone_;
    const DerivedSections derived_;
};

/// A model, and what its levels are compared with.
struct ModelToVerify {
    const Model& model;
    const Original& original;
    const std::vector<LatticePoint>& places;
    const Weights& weights;
};

Result<LevelReport> verifyPrefix(const ModelToVerify& all, std::uint32_t sites, const MeshBounds& bounds,
                                 const Progress& progress)
{
    LevelReport verdict;
    verdict.sites = sites;
    const LevelCells cells(all.model, all.places, sites);
    if (const Status done = verifyCells({all.model, all.original, all.weights, cells, bounds}, verdict, progress);
        !done)
        return done.error();
    return verdict;
}

/// One level, proved from the file's arrays and the original samples alone: both limits, each by itself.
Result<LevelReport> verifyLevel(const ModelToVerify& all, const Accuracy& asked, const Progress& progress)
{
    const Claims claims(all.model);
    const std::uint32_t sites = claims.firstPassage(limitsOf(all.model, all.original, asked));
    const Limits claimed = claims.of(sites);
    Result<LevelReport> verdict = verifyPrefix(all, sites, {claimed.error, claimed.warping}, progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

/// The history as a whole. Of lattices the volumes say that the first mesh fills the domain and with it all others; of
/// other data it is looked at as a level is, but claims nothing.
Status verifyWholeHistory(const ModelToVerify& all, std::vector<std::string>& failures, bool& usable,
                          const Progress& progress)
{
    constexpr double historyEnd = 0.8; // how far it is after this
    const Progress silent = progress.withCallback({});
    if (const Status done =
            verifyHistory(all.model, all.original, all.places, failures, usable, progress.part(0, historyEnd));
        !done || !usable)
        return done;
    if (!isOnLattice(all.original.dataset.domain)) {
        constexpr double anything = std::numeric_limits<double>::infinity();
        const auto first = verifyPrefix(all, initialSiteCount(all.model), MeshBounds(anything, anything), silent);
        if (!first)
            return first.error();
        for (const std::string& failure : first->failures)
            failures.push_back("The first mesh: " + failure);
    }
    if (const Status done = verifyGroups(all.model, failures, progress.part(historyEnd, 1)); !done)
        return done;
    if (const Status done = verifyDerived(all.model, all.original, all.places, failures, silent); !done)
        return done;
    return all.model.description().delaunay ? Status{} : verifyClosure(all.model, failures, silent);
}

Result<VerificationReport> verifyAll(const Model& model, const Dataset& given, const std::vector<Accuracy>& levels,
                                     const Progress& progress)
{
    constexpr double bytesEnd = 0.05; // how far it is after each part
    constexpr double historyEnd = 0.2;
    VerificationReport verdict;
    if (const Status done = verifyBytes(model, verdict.failures, progress.part(0, bytesEnd)); !done)
        return done.error();
    const Result<Dataset> taken = takenByModel(model, given, progress.withCallback({}));
    if (!taken)
        return taken.error();
    const Dataset& dataset = *taken;
    std::vector<LatticePoint> places;
    if (verifySource(model, given, dataset, verdict.failures))
        places = verifySites(model, dataset, verdict.failures);
    if (!places.empty() && given.domain != dataset.domain && dataset.domain == DomainClass::Scattered)
        verifyConvex(model, given, verdict.failures);
    const Result<Weights> weights = weightsOf(model, dataset, verdict.failures, progress);
    if (!weights)
        return weights.error();
    bool usable = !places.empty();
    std::optional<Original> original;
    if (usable) {
        auto made = Original::make(model, dataset, verdict.failures, progress.withCallback({}));
        if (!made)
            return made.error();
        original.emplace(*std::move(made));
        verdict.foldedCells = original->curvilinear ? original->curvilinear->foldedCells() : 0;
        verdict.touchingPoints = original->touchingPoints().size();
        if (const Status done = verifyWholeHistory({model, *original, places, *weights}, verdict.failures, usable,
                                                   progress.part(bytesEnd, historyEnd));
            !done)
            return done.error();
    }
    for (std::size_t number = 0; number < levels.size(); ++number) {
        if (!usable) {
            verdict.levels.push_back(notChecked(levels[number]));
            continue;
        }
        const double share = (1 - historyEnd) / static_cast<double>(levels.size());
        const double begin = historyEnd + share * static_cast<double>(number);
        Result<LevelReport> level =
            verifyLevel({model, *original, places, *weights}, levels[number], progress.part(begin, begin + share));
        if (!level)
            return level.error();
        verdict.levels.push_back(std::move(*level));
    }
    // What checksums say is among the failures.
    if (const Status unchanged = model.checkUnchanged(); !unchanged)
        return unchanged.error();
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact.error();
    return verdict;
}

} // namespace

bool VerificationReport::ok() const noexcept
{
    return failures.empty() && std::ranges::all_of(levels, &LevelReport::ok);
}

Result<VerificationReport> verify(const Model& model, const Dataset& original, const std::vector<Accuracy>& levels,
                                  const Progress& progress)
{
    return guarded(
        Message::marked("Not enough memory to verify '%1'. Close other programs, or verify coarser levels only."),
        [&] { return verifyAll(model, original, levels, progress); }, model.path().native());
}

} // namespace tetra
