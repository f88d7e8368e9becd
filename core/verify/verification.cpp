// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verification.h"

#include "core/data/weighting.h"
#include "core/verify/curvilinear_cells.h"
#include "core/verify/lattice_cells.h"
#include "core/verify/scattered_cells.h"
#include "core/verify/verify_irregular.h"
#include "core/verify/verify_parts.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <new>
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

Result<VerificationReport> verifyAll(const Model& model, const Dataset& original, const std::vector<Accuracy>& levels,
                                     const Progress& progress)
{
    constexpr double bytesEnd = 0.05; // how far it is after each part
    constexpr double historyEnd = 0.17;
    constexpr double groupsEnd = 0.2;
    VerificationReport verdict;
    if (const Status done = verifyBytes(model, verdict.failures, progress.part(0, bytesEnd)); !done)
        return done.error();
    std::vector<LatticePoint> places;
    if (verifySource(model, original, verdict.failures))
        places = verifySites(model, original, verdict.failures);
    const Result<Weights> weights = weightsOf(model, original, verdict.failures, progress);
    if (!weights)
        return weights.error();
    bool usable = !places.empty();
    std::optional<ScatteredOriginal> scattered;
    std::optional<IrregularOriginal> irregular;
    if (usable && original.domain == DomainClass::Scattered)
        scattered.emplace(original);
    std::optional<CurvilinearOriginal> lifted;
    if (usable && original.domain == DomainClass::Curvilinear) {
        auto made = CurvilinearOriginal::make(original, model.description().leftHanded, verdict.failures,
                                              progress.withCallback({}));
        if (!made)
            return made.error();
        lifted = *std::move(made);
        verdict.foldedCells = lifted->foldedCells();
    }
    if (usable && original.domain == DomainClass::Irregular)
        irregular.emplace(original, verdict.failures);
    const std::vector<LatticePoint> none;
    if (usable)
        if (const Status done = verifyHistory(model, isOnLattice(original.domain) ? places : none, verdict.failures,
                                              usable, progress.part(bytesEnd, historyEnd));
            !done)
            return done.error();
    if (usable && scattered)
        if (const Status done = verifyScatteredHistory(model, *scattered, places, *weights, verdict.failures,
                                                       progress.withCallback({}));
            !done)
            return done.error();
    if (usable && irregular)
        if (const Status done = verifyIrregularHistory(model, *irregular, places, *weights, verdict.failures,
                                                       progress.withCallback({}));
            !done)
            return done.error();
    if (usable)
        if (const Status done = verifyGroups(model, verdict.failures, progress.part(historyEnd, groupsEnd)); !done)
            return done.error();
    if (usable && !model.description().delaunay)
        if (const Status done = verifyClosure(model, verdict.failures, progress.withCallback({})); !done)
            return done.error();
    for (std::size_t number = 0; number < levels.size(); ++number) {
        if (!usable) {
            verdict.levels.push_back(notChecked(levels[number]));
            continue;
        }
        const double share = (1 - groupsEnd) / static_cast<double>(levels.size());
        const double begin = groupsEnd + share * static_cast<double>(number);
        const Progress part = progress.part(begin, begin + share);
        Result<LevelReport> level =
            scattered ? verifyScatteredLevel(model, *scattered, places, *weights, levels[number], part)
            : irregular
                ? verifyIrregularLevel(model, *irregular, places, *weights, levels[number], part)
                : verifyLevel(model, original, lifted ? &*lifted : nullptr, places, *weights, levels[number], part);
        if (!level)
            return level.error();
        verdict.levels.push_back(std::move(*level));
    }
    // What checksums say is among the failures.
    if (const Status unchanged = model.checkUnchanged(); !unchanged)
        return unchanged.error();
    if (const Status intact = original.checkIntact(); !intact)
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
    try {
        return verifyAll(model, original, levels, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory to verify '" + model.path().string() +
                                                   "'. Close other programs, or verify coarser levels only."};
    }
}

std::string textOf(const LatticePoint& point)
{
    return "(" + std::to_string(point[0]) + ", " + std::to_string(point[1]) + ", " + std::to_string(point[2]) + ")";
}

std::string textOf(const CellCorners& corners)
{
    return textOf(corners[0]) + " " + textOf(corners[1]) + " " + textOf(corners[2]) + " " + textOf(corners[3]);
}

std::string textOf(double number)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 6).ptr};
}

Result<Weights> weightsOf(const Model& model, const Dataset& original, std::vector<std::string>& failures,
                          const Progress& progress)
{
    const auto& parameters = model.description().parameters;
    const auto given = std::ranges::find(parameters, "weights", &std::pair<std::string, std::string>::first);
    if (given == parameters.end())
        return Weights{};
    const Result<Weighting> weighting = parseWeighting(given->second);
    if (!weighting) {
        failures.push_back("The model's weights cannot be read. " + weighting.error().text);
        return Weights{};
    }
    return pointWeights(*weighting, original, progress);
}

double keyAsked(const Model& model, double extent, double diagonal, const Accuracy& asked)
{
    constexpr double anything = std::numeric_limits<double>::infinity();
    const double weight = model.description().warpingWeight;
    double key = weight > 0 && extent == 0 ? anything : asked.error / 100 * extent;
    if (weight > 0 && asked.warping < anyWarping)
        key = std::min(key, asked.warping / 100 * weight * diagonal);
    return key;
}

std::uint32_t firstPassage(const Model& model, double asked)
{
    std::uint32_t sites = initialSiteCount(model);
    while (sites < model.siteCount() && !(static_cast<double>(model.runningErrors()[sites]) <= asked))
        ++sites;
    return sites;
}

double claimedKey(const Model& model, std::uint32_t sites)
{
    return static_cast<double>(sites < model.siteCount() ? model.runningErrors()[sites] : model.finalError());
}

Result<LevelReport> verifyLevel(const Model& model, const Dataset& original, const CurvilinearOriginal* lifted,
                                const std::vector<LatticePoint>& places, const Weights& weights, const Accuracy& asked,
                                const Progress& progress)
{
    LevelReport verdict;
    verdict.asked = asked;
    verdict.sites = firstPassage(
        model, keyAsked(model, original.values.range().extent(), original.bounds().diagonal().norm(), asked));
    const double claimed = claimedKey(model, verdict.sites);
    const double warpingWeight = model.description().warpingWeight;
    const LevelCells cells(model, places, verdict.sites);
    const MeshBounds claims(claimed, warpingWeight > 0 ? claimed / warpingWeight : 0);
    if (const Status done = verifyLatticeCells({model, original, weights, cells, claims, lifted}, verdict, progress);
        !done)
        return done.error();
    return verdict;
}

} // namespace tetra
