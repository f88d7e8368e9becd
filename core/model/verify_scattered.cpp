// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/verify_scattered.h"

#include "core/model/exact_volume.h"
#include "core/model/findings.h"
#include "core/model/point_check.h"
#include "core/model/scattered_cells.h"
#include "core/model/verify_each.h"

#include <tbb/parallel_for.h>

#include <limits>

namespace tetra {

namespace {

constexpr std::size_t scatteredSitesAtOnce = 64;

/// How many cells hold a place inside the domain. Conforming positive cells whose boundary is the domain's cover every
/// place equally often, so one tells of all.
void verifyCoveredOnce(const ScatteredOriginal& original, const LevelCells& cells, LevelVerdict& verdict)
{
    for (std::size_t number = 0; number < cells.size(); ++number) {
        const PlacedCell cell = placedCell(original.positions, cells, number);
        const Eigen::Vector3d middle = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
        if (volumeSign(cell) <= 0 || !holdsInside(cell, middle))
            continue; // too thin for a double inside it
        std::size_t count = 0;
        for (std::size_t other = 0; other < cells.size(); ++other) {
            const PlacedCell around = placedCell(original.positions, cells, other);
            count += volumeSign(around) > 0 && holds(around, middle);
        }
        if (count != 1)
            verdict.failures.push_back("The place " + textOf(middle) + " lies in " + std::to_string(count) + " cells.");
        verdict.covers = verdict.covers && count == 1;
        return;
    }
    verdict.covers = false;
    verdict.failures.emplace_back("No cell has an inside.");
}

/// Whether all initial sites lie on one side of a face, which is given by its points.
bool onHull(const Model& model, const ScatteredOriginal& original, std::uint32_t initialSites,
            const std::array<std::uint32_t, 3>& face)
{
    const Eigen::Vector3d a = original.positions[face[0]], b = original.positions[face[1]],
                          c = original.positions[face[2]];
    int side = 0;
    for (std::uint32_t site = 0; site < initialSites; ++site) {
        const int sign = volumeSign(a, b, c, original.positions[model.points()[site]]);
        if (sign * side < 0)
            return false;
        side = side == 0 ? sign : side;
    }
    return true;
}

/// The mesh of the first sites.
Result<LevelVerdict> verifyPrefix(const Model& model, const ScatteredOriginal& original,
                                  const std::vector<LatticePoint>& places, const Weights& weights, std::uint32_t sites,
                                  double claimed, const Progress& progress)
{
    LevelVerdict verdict;
    verdict.sites = sites;
    const LevelCells cells(model, places, sites);
    if (const Status done =
            verifyScatteredCells(model, original, weights, cells, MeshClaims(claimed, 0), verdict, progress);
        !done)
        return done.error();
    return verdict;
}

} // namespace

ScatteredOriginal::ScatteredOriginal(const Dataset& dataset)
    : positions(*dataset.positions), values(dataset.pointCount()), extent(dataset.values.range().extent()),
      tree(positions)
{
    for (std::uint64_t point = 0; point < values.size(); ++point)
        values[point] = dataset.values.at(point);
}

void verifyPlacedVolumes(const ScatteredOriginal& original, const LevelCells& cells, LevelVerdict& verdict)
{
    Findings wrong;
    tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t number) {
        const PlacedCell cell = placedCell(original.positions, cells, number);
        if (const int sign = volumeSign(cell); sign <= 0)
            wrong.add(number, [&] {
                return std::string(sign == 0 ? "Flat" : "Inverted") + " cell with corners " + textOf(cell) + ".";
            });
    });
    verdict.inverted = wrong.count();
    wrong.moveTo(verdict.failures);
}

Status verifyScatteredCells(const Model& model, const ScatteredOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshClaims& claims, LevelVerdict& verdict,
                            const Progress& progress)
{
    verdict.covers = true;
    verdict.tetrahedra = cells.size();
    verifyPlacedVolumes(original, cells, verdict);
    const std::uint32_t initialSites = initialSiteCount(model);
    const FaceRule rule{[&](const std::array<std::uint32_t, 3>& face) {
                            return onHull(model, original, initialSites,
                                          {cells.point(face[0]), cells.point(face[1]), cells.point(face[2])});
                        },
                        [&](std::uint32_t vertex) { return textOf(original.positions[cells.point(vertex)]); }};
    if (const Status faces = verifyFaces(cells, rule, verdict, progress.part(0, 0.4)); !faces)
        return faces;
    verifyCoveredOnce(original, cells, verdict);
    PointCheck check(model, original, weights, cells, claims);
    if (const Status done = check.run(progress.part(0.4, 1)); !done)
        return done;
    Findings notCovered;
    Findings beyondOwn;
    for (std::uint32_t point = 0; point < original.positions.size(); ++point) {
        const auto name = [&] { return "oint " + std::to_string(point) + " " + textOf(original.positions[point]); };
        if (!check.isCovered(point))
            notCovered.add(point, [&] { return "P" + name() + " lies in no cell."; });
        else if (!check.isWithinOwn(point))
            beyondOwn.add(point, [&] {
                return "The error at p" + name() + " is larger than the own error of every cell that holds it.";
            });
    }
    verdict.covers = verdict.covers && notCovered.none();
    verdict.largestError = original.percent(check.largestError());
    for (Findings* findings : {&notCovered, &check.tooLarge(), &beyondOwn})
        findings->moveTo(verdict.failures);
    return {};
}

Status verifyPlacedHistory(const Model& model, const ScatteredOriginal& original, std::vector<std::string>& failures,
                           const Progress& progress)
{
    Findings positions;
    Findings volumes;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        if (model.position(site) != original.positions[model.points()[site]])
            positions.add(site, [&] {
                return "Site " + std::to_string(site) + " lies at " + textOf(model.position(site)) +
                       "; the original's point is at " + textOf(original.positions[model.points()[site]]) + ".";
            });
    const auto checkStar = [&](std::size_t creator) {
        for (std::uint64_t number = model.starOffsets()[creator]; number < model.starOffsets()[creator + 1]; ++number) {
            const auto& others = model.otherSites()[number];
            const auto point = [&](std::uint32_t site) { return model.points()[site]; };
            const PlacedCell cell =
                placedCell(original.positions, {point(creator), point(others[0]), point(others[1]), point(others[2])});
            if (const int sign = volumeSign(cell); sign <= 0)
                volumes.add(number, [&] {
                    return "Tetrahedron " + std::to_string(number) + " with corners " + textOf(cell) + " is " +
                           (sign == 0 ? "flat." : "inverted.");
                });
        }
    };
    if (const Status checked =
            verifyEach(model.siteCount(), scatteredSitesAtOnce, "Verifying the history", progress, checkStar);
        !checked)
        return checked;
    positions.moveTo(failures);
    volumes.moveTo(failures);
    return {};
}

Status verifyScatteredHistory(const Model& model, const ScatteredOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress)
{
    if (const Status done = verifyPlacedHistory(model, original, failures, progress.part(0, 0.5)); !done)
        return done;
    const auto first = verifyPrefix(model, original, places, weights, initialSiteCount(model),
                                    std::numeric_limits<double>::infinity(), progress.part(0.5, 1));
    if (!first)
        return first.error();
    for (const std::string& failure : first->failures)
        failures.push_back("The first mesh: " + failure);
    return {};
}

Result<LevelVerdict> verifyScatteredLevel(const Model& model, const ScatteredOriginal& original,
                                          const std::vector<LatticePoint>& places, const Weights& weights,
                                          const Accuracy& asked, const Progress& progress)
{
    const std::uint32_t sites = firstPassage(model, asked.error / 100 * original.extent);
    Result<LevelVerdict> verdict =
        verifyPrefix(model, original, places, weights, sites, claimedKey(model, sites), progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

} // namespace tetra
