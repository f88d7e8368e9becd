// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/verify_irregular.h"

#include "core/model/irregular/two_sided_distance.h"
#include "core/model/irregular/verify_boundary.h"
#include "core/model/irregular/verify_related.h"
#include "core/model/scattered_cells.h"

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr double anything = std::numeric_limits<double>::infinity();

bool claimsTwoSides(const Model& model)
{
    return std::ranges::any_of(model.description().parameters, [](const auto& parameter) {
        return parameter.first == "distance" && parameter.second == "two-sided";
    });
}

/// What the boundary's places farthest from the original's say; weights are of points, so none is judged with them.
void verifyTwoSides(const IrregularMesh& mesh, LevelVerdict& verdict)
{
    const BoundaryDistances distances = distancesToOriginal(mesh.original, mesh.boundary.triangles);
    const double percent = 100 / mesh.original.diagonal;
    verdict.twoSidedWarping = std::max(verdict.largestWarping, percent * distances.found);
    verdict.twoSidedBound = std::max(verdict.largestWarping, percent * distances.bound);
    const double claimed = mesh.claims.areUniform() ? mesh.claims.warping(0) : anything;
    if (claimsTwoSides(mesh.model) && mesh.weights.empty() && distances.found > claimed + mesh.original.allowance)
        verdict.failures.push_back("The boundary goes " + textOf(percent * distances.found) +
                                   " % of the diagonal away from that of the data, more than the claimed " +
                                   textOf(percent * claimed) + " %.");
}

Result<LevelVerdict> verifyPrefix(const Model& model, const IrregularOriginal& original,
                                  const std::vector<LatticePoint>& places, const Weights& weights, std::uint32_t sites,
                                  const MeshClaims& claims, const Progress& progress)
{
    LevelVerdict verdict;
    verdict.sites = sites;
    const LevelCells cells(model, places, sites);
    if (const Status done = verifyIrregularCells(model, original, weights, cells, claims, verdict, progress); !done)
        return done.error();
    return verdict;
}

} // namespace

Status verifyIrregularCells(const Model& model, const IrregularOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshClaims& claims, LevelVerdict& verdict,
                            const Progress& progress)
{
    verdict.covers = true;
    verdict.tetrahedra = cells.size();
    verifyPlacedVolumes(original.points, cells, verdict);
    const FaceRule rule{[](const auto&) { return true; },
                        [&](std::uint32_t vertex) { return textOf(original.points.positions[cells.point(vertex)]); }};
    std::vector<BoundaryFace> faces;
    if (const Status done = verifyFaces(cells, rule, verdict, progress.part(0, 0.2), &faces); !done)
        return done;
    const MeshBoundary boundary(original, cells, faces);
    const IrregularMesh mesh{model, original, weights, cells, boundary, claims};
    if (verdict.conforming && verdict.inverted == 0)
        if (const Status done = verifyBoundary(original, cells, boundary, verdict, progress.part(0.2, 0.4)); !done)
            return done;
    verdict.covers = verdict.covers && verdict.conforming && verdict.inverted == 0;
    if (const Status done = verifyRelated(mesh, verdict, progress.part(0.4, 1)); !done)
        return done;
    if (!boundary.triangles.empty() && !original.boundary.empty())
        verifyTwoSides(mesh, verdict);
    return {};
}

Status verifyIrregularHistory(const Model& model, const IrregularOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress)
{
    if (const Status done = verifyPlacedHistory(model, original.points, failures, progress.part(0, 0.5)); !done)
        return done;
    const auto first = verifyPrefix(model, original, places, weights, initialSiteCount(model),
                                    MeshClaims(anything, anything), progress.part(0.5, 1));
    if (!first)
        return first.error();
    for (const std::string& failure : first->failures)
        failures.push_back("The first mesh: " + failure);
    return {};
}

Result<LevelVerdict> verifyIrregularLevel(const Model& model, const IrregularOriginal& original,
                                          const std::vector<LatticePoint>& places, const Weights& weights,
                                          const Accuracy& asked, const Progress& progress)
{
    const std::uint32_t sites = firstPassage(model, keyAsked(model, original.points.extent, original.diagonal, asked));
    const double claimed = claimedKey(model, sites);
    const MeshClaims claims(claimed, claimed / model.description().warpingWeight);
    Result<LevelVerdict> verdict = verifyPrefix(model, original, places, weights, sites, claims, progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

} // namespace tetra
