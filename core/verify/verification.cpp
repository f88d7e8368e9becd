// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/history/derived_sections.h"
#include "core/verify/cell_check.h"
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

/// The largest running key of a mesh that keeps both thresholds (S4).
double keyAsked(const Model& model, const Original& original, const Accuracy& asked)
{
    const double extent = original.extent;
    constexpr double anything = std::numeric_limits<double>::infinity();
    const double weight = model.description().warpingWeight;
    double key = weight > 0 && extent == 0 ? anything : asked.error / 100 * extent;
    if (weight > 0 && asked.warping < anyWarping)
        key = std::min(key, asked.warping / 100 * weight * original.diagonal);
    return key;
}

/// The sites of the first mesh whose error is at most `asked`, in units of the values, found by looking at one after
/// the other (S1); if there is none, of the most accurate one, which need not be the last.
std::uint32_t firstPassage(const Model& model, double asked)
{
    const auto best = static_cast<double>(*std::ranges::min_element(model.runningKeys()));
    if (best < static_cast<double>(model.finalKey()) && !(asked > best))
        asked = best;
    std::uint32_t sites = initialSiteCount(model);
    while (sites < model.siteCount() && !(static_cast<double>(model.runningKeys()[sites]) <= asked))
        ++sites;
    return sites;
}

/// What the model claims of the mesh of its first sites, which end a batch: by its key, and where the file tells them
/// apart by error and warping. That warping goes one way only, from the data to the mesh.
MeshBounds claimedBounds(const Model& model, std::uint32_t sites)
{
    const double weight = model.description().warpingWeight;
    double error = static_cast<double>(sites < model.siteCount() ? model.runningKeys()[sites] : model.finalKey());
    double warping = weight > 0 ? error / weight : 0;
    const DerivedSections derived = derivedSections(model);
    const auto end = std::ranges::lower_bound(derived.batchEnds, sites - 1);
    const auto batch = static_cast<std::size_t>(end - derived.batchEnds.begin());
    if (batch < derived.batchErrors.size())
        error = std::min(error, static_cast<double>(derived.batchErrors[batch]));
    if (batch < derived.batchWarpings.size() && !claimsTwoSides(model))
        warping = std::min(warping, static_cast<double>(derived.batchWarpings[batch]));
    return {error, warping};
}

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

/// One level, proved from the file's arrays and the original samples alone.
Result<LevelReport> verifyLevel(const ModelToVerify& all, const Accuracy& asked, const Progress& progress)
{
    const std::uint32_t sites = firstPassage(all.model, keyAsked(all.model, all.original, asked));
    Result<LevelReport> verdict = verifyPrefix(all, sites, claimedBounds(all.model, sites), progress);
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

Result<VerificationReport> verifyAll(const Model& model, const Dataset& dataset, const std::vector<Accuracy>& levels,
                                     const Progress& progress)
{
    constexpr double bytesEnd = 0.05; // how far it is after each part
    constexpr double historyEnd = 0.2;
    VerificationReport verdict;
    if (const Status done = verifyBytes(model, verdict.failures, progress.part(0, bytesEnd)); !done)
        return done.error();
    std::vector<LatticePoint> places;
    if (verifySource(model, dataset, verdict.failures))
        places = verifySites(model, dataset, verdict.failures);
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
