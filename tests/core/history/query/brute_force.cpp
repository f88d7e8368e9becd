// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/history/query/brute_force.h"

#include "core/base/rounding.h"

#include <tan/query.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace tetra {

namespace {

constexpr double nearlyOne = 1 + std::numeric_limits<double>::epsilon();

double valueOf(const Model& model, std::uint32_t site)
{
    return visitSampleType(model.description().sampleType, [&]<class T>() {
        return static_cast<double>(reinterpret_cast<const T*>(model.values().data())[site]);
    });
}

} // namespace

BruteForce::BruteForce(const Model& model) : model_(model)
{
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        for (std::uint64_t t = model.starOffsets()[site]; t < model.starOffsets()[site + 1]; ++t)
            creators_.push_back(site);
    std::uint32_t group = 0;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site) {
        groups_.push_back(group);
        group += model.groupGoesOn()[site] == 0 ? 1 : 0;
    }
}

std::array<std::uint32_t, 4> BruteForce::corners(std::uint64_t tetrahedron) const
{
    const auto& others = model_.otherSites()[tetrahedron];
    return {creators_[tetrahedron], others[0], others[1], others[2]};
}

/// For each tetrahedron of the history what error and warping asked for must be multiplied by to allow it; 1 if it is
/// allowed as it is.
std::vector<double> BruteForce::scalesOf(const MeshQuery& query) const
{
    const ModelDescription& about = model_.description();
    const bool warps = about.warpingWeight > 0;
    const double extent = about.range.extent();
    std::vector<double> scales;
    for (std::uint64_t t = 0; t < model_.tetrahedronCount(); ++t) {
        const std::uint32_t destroyer = model_.destroyers()[t];
        const double key = destroyer == Model::never ? model_.finalKey() : model_.runningKeys()[destroyer];
        double error = 100 * static_cast<double>(halfToFloat(model_.ownErrors()[t]));
        error = extent > 0 ? std::min(error, 100 * key / extent) : 0;
        double warping = 0;
        if (warps)
            warping = std::min(100 * static_cast<double>(halfToFloat(model_.ownWarpings()[t])),
                               100 * key / (about.warpingWeight * model_.diagonal()));
        std::array<Eigen::Vector3d, 4> places;
        ValueRange values{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
        for (int i = 0; i < 4; ++i) {
            const std::uint32_t site = corners(t)[i];
            places[i] = model_.position(site);
            values.minimum = std::min(values.minimum, static_cast<double>(static_cast<float>(valueOf(model_, site))));
            values.maximum = std::max(values.maximum, static_cast<double>(static_cast<float>(valueOf(model_, site))));
        }
        const double doubt = error / 100 * extent;
        values = {values.minimum - doubt, values.maximum + doubt};
        const double largest =
            std::max(about.bounds.min().cwiseAbs().maxCoeff(), about.bounds.max().cwiseAbs().maxCoeff());
        const double margin = largest * 0x1p-52 + warping / 100 * model_.diagonal();
        const double askedError = query.error.leastIn(places, margin, values);
        const double askedWarping = warps ? query.warping.leastIn(places, margin, values) : 0;
        double scale = 1;
        if (error > askedError || warping > askedWarping)
            scale = std::max({nearlyOne, error / std::max(askedError, leastScaledPercent),
                              warps ? warping / std::max(askedWarping, leastScaledPercent) : 0});
        scales.push_back(scale);
    }
    return scales;
}

/// The smallest closed superset without tetrahedra of a larger scale, as far as they die.
std::vector<bool> BruteForce::groupClosure(std::vector<bool> sites, const std::vector<double>& scales,
                                           double most) const
{
    for (bool changed = true; changed;) {
        changed = false;
        const auto take = [&](std::uint32_t wanted) {
            for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
                if (groups_[site] == groups_[wanted] && !sites[site]) {
                    sites[site] = true;
                    changed = true;
                }
        };
        for (std::uint64_t t = 0; t < model_.tetrahedronCount(); ++t) {
            const std::uint32_t destroyer = model_.destroyers()[t];
            if (destroyer == Model::never)
                continue;
            if (sites[destroyer] && !sites[creators_[t]])
                take(creators_[t]);
            if (sites[creators_[t]] && !sites[destroyer] && scales[t] > most)
                take(destroyer);
        }
    }
    return sites;
}

BruteForce::Answer BruteForce::meshOf(std::vector<bool> sites) const
{
    Answer answer;
    for (std::uint64_t t = 0; t < model_.tetrahedronCount(); ++t) {
        const std::uint32_t destroyer = model_.destroyers()[t];
        if (sites[creators_[t]] && (destroyer == Model::never || !sites[destroyer]))
            answer.tetrahedra.push_back(t);
    }
    answer.sites = std::move(sites);
    return answer;
}

BruteForce::Answer BruteForce::smallestClosedSet(const MeshQuery& query, bool fromFirstMesh) const
{
    const std::vector<double> scales = scalesOf(query);
    std::vector<bool> sites(model_.siteCount(), false);
    const std::uint32_t prefix =
        meshSizeAt(model_, {query.error.bounds().maximum, query.warping.bounds().maximum}).sites;
    for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
        sites[site] = fromFirstMesh ? groups_[site] == 0 : site < prefix;
    Answer answer = meshOf(groupClosure(std::move(sites), scales, 1));
    for (const std::uint64_t t : answer.tetrahedra)
        answer.scale = std::max(answer.scale, scales[t]);
    return answer;
}

std::optional<BruteForce::Answer> BruteForce::closedSetWithin(const MeshQuery& query) const
{
    const std::vector<double> scales = scalesOf(query);
    std::set<double, std::greater<>> levels(scales.begin(), scales.end());
    levels.insert(1);
    std::optional<Answer> best;
    for (const double level : levels) { // all that is worse than the level goes
        if (std::isinf(level))
            continue; // an inverted tetrahedron goes whatever it costs
        std::vector<bool> sites(model_.siteCount(), false);
        for (std::uint32_t site = 0; site < model_.siteCount(); ++site)
            sites[site] = groups_[site] == 0;
        const Answer answer = meshOf(groupClosure(std::move(sites), scales, level));
        if (answer.tetrahedra.size() > *query.budget)
            break;
        best = answer;
        for (const std::uint64_t t : answer.tetrahedra)
            best->scale = std::max(best->scale, scales[t]);
    }
    return best;
}

} // namespace tetra
