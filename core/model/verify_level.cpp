// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/verify_cells.h"
#include "core/model/verify_parts.h"

#include <algorithm>
#include <limits>

namespace tetra {

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

Result<LevelVerdict> verifyLevel(const Model& model, const Dataset& original, const LiftedOriginal* lifted,
                                 const std::vector<LatticePoint>& places, const Weights& weights, const Accuracy& asked,
                                 const Progress& progress)
{
    LevelVerdict verdict;
    verdict.asked = asked;
    verdict.sites = firstPassage(
        model, keyAsked(model, original.values.range().extent(), original.bounds().diagonal().norm(), asked));
    const double claimed = claimedKey(model, verdict.sites);
    const double warpingWeight = model.description().warpingWeight;
    const LevelCells cells(model, places, verdict.sites);
    const MeshClaims claims(claimed, warpingWeight > 0 ? claimed / warpingWeight : 0);
    if (const Status done = verifyLatticeCells({model, original, weights, cells, claims, lifted}, verdict, progress);
        !done)
        return done.error();
    return verdict;
}

} // namespace tetra
