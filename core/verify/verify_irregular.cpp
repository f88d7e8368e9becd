// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/verify_irregular.h"

#include "core/base/rounding.h"
#include "core/mesh/topology.h"
#include "core/verify/findings.h"
#include "core/verify/scattered_cells.h"
#include "core/verify/two_sided_distance.h"
#include "core/verify/verify_boundary.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr std::uint32_t relatedPointsAtOnce = 64;

class RelatedCheck {
public:
    RelatedCheck(const IrregularMesh& mesh, const PointCheck& inside)
        : mesh_(mesh), original_(mesh.original), inside_(inside), isVertex_(original_.points.positions.size()),
          tolerance_(errorAllowance * original_.points.extent)
    {
        for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
            for (const std::uint32_t vertex : mesh.cells.vertices(cell))
                isVertex_[mesh.cells.point(vertex)] = true;
        for (const std::uint32_t cell : mesh.boundary.cells)
            largestOwnWarping_ = std::max(largestOwnWarping_, ownWarping(cell));
    }

    Status run(const Progress& progress);
    void moveTo(LevelReport& verdict);

private:
    /// A point, and what is next to it on the boundary.
    struct Related {
        std::uint32_t point;
        const Eigen::Vector3d& place;
        double value;
        double weight;
        TriangleTree::Nearest nearest;
    };

    void checkPoint(std::uint32_t point);
    void checkWarping(const Related& related);
    void checkOutside(const Related& related);
    void checkOwn(const Related& related, bool covered);
    bool isGrantedNextToIt(const Related& related) const;
    double leastErrorWithin(const Related& related, double radius) const;
    double errorOn(const Related& related, std::uint32_t triangle, double radius) const;
    std::array<double, 3> valuesOf(std::uint32_t triangle) const
    {
        const PointTriangle& t = mesh_.boundary.triangles[triangle];
        return {original_.points.values[t[0]], original_.points.values[t[1]], original_.points.values[t[2]]};
    }
    bool ofHistory() const { return mesh_.cells.size() > 0 && mesh_.cells.historyNumber(0).has_value(); }
    /// What the history grants a cell; anything if it is of no history.
    double ownError(std::size_t cell) const
    {
        const auto number = mesh_.cells.historyNumber(cell);
        return number ? static_cast<double>(halfToFloat(mesh_.model.ownErrors()[*number])) * original_.points.extent
                      : std::numeric_limits<double>::infinity();
    }
    double ownWarping(std::size_t cell) const
    {
        const auto number = mesh_.cells.historyNumber(cell);
        return number ? static_cast<double>(halfToFloat(mesh_.model.ownWarpings()[*number])) * original_.diagonal
                      : std::numeric_limits<double>::infinity();
    }
    std::string name(const Related& related) const
    {
        return "point " + std::to_string(related.point) + " " + textOf(related.place);
    }

    const IrregularMesh& mesh_;
    const IrregularOriginal& original_;
    const PointCheck& inside_;
    std::vector<bool> isVertex_;
    double tolerance_;             ///< by which a claimed error may be exceeded
    double largestOwnWarping_ = 0; ///< of cells on the boundary
    tbb::enumerable_thread_specific<double> largestError_{0.0};
    tbb::enumerable_thread_specific<double> largestWarping_{0.0};
    Findings tooFar_;
    Findings tooLarge_;
    Findings beyondOwn_;
};

Status RelatedCheck::run(const Progress& progress)
{
    return verifyEach(original_.points.positions.size(), relatedPointsAtOnce,
                      "Verifying the boundary's distance at every vertex", progress, [this](std::size_t point) {
                          if (!isVertex_[point])
                              checkPoint(static_cast<std::uint32_t>(point));
                      });
}

void RelatedCheck::checkPoint(std::uint32_t point)
{
    const bool covered = inside_.isCovered(point);
    const bool beyondOwn = ofHistory() && !inside_.isWithinOwn(point);
    if (covered && !original_.isOnBoundary(point) && !beyondOwn)
        return;
    const Eigen::Vector3d& place = original_.points.positions[point];
    const Related related{point, place, original_.points.values[point],
                          mesh_.weights.empty() ? 1 : static_cast<double>(mesh_.weights[point]),
                          mesh_.boundary.tree.nearest(place)};
    if (original_.isOnBoundary(point))
        checkWarping(related);
    if (!covered)
        checkOutside(related);
    if (ofHistory())
        checkOwn(related, covered);
}

void RelatedCheck::checkWarping(const Related& related)
{
    const double warping = related.weight * related.nearest.place.distance;
    const double claimed = mesh_.claims.warping(related.point);
    largestWarping_.local() = std::max(largestWarping_.local(), warping);
    if (warping > claimed + original_.allowance)
        tooFar_.add(related.point, [&] {
            return "The warping at " + name(related) + " is " + textOf(100 * warping / original_.diagonal) +
                   " % of the diagonal, more than the claimed " + textOf(100 * claimed / original_.diagonal) + " %.";
        });
}

/// The difference, weighted, from the point's value to that of the place of the triangle within the radius that comes
/// closest to it; infinity if there is none.
double RelatedCheck::errorOn(const Related& related, std::uint32_t triangle, double radius) const
{
    const auto range = valuesWithin(mesh_.boundary.tree.corners(triangle), valuesOf(triangle), related.place, radius);
    if (!range)
        return std::numeric_limits<double>::infinity();
    return related.weight * std::max({0.0, (*range)[0] - related.value, related.value - (*range)[1]});
}

double RelatedCheck::leastErrorWithin(const Related& related, double radius) const
{
    double least = std::numeric_limits<double>::infinity();
    mesh_.boundary.tree.visitWithin(related.place, radius, [&](std::uint32_t triangle) {
        least = std::min(least, errorOn(related, triangle, radius));
    });
    return least;
}

void RelatedCheck::checkOutside(const Related& related)
{
    const std::array<double, 3> values = valuesOf(related.nearest.triangle);
    const std::array<double, 3>& weights = related.nearest.place.weights;
    const double there = weights[0] * values[0] + weights[1] * values[1] + weights[2] * values[2];
    double error = related.weight * std::abs(there - related.value);
    const double claimed = mesh_.claims.error(related.point);
    if (error > claimed + tolerance_) {
        const double radius = std::max(related.nearest.place.distance,
                                       mesh_.claims.warping(related.point) / related.weight + original_.allowance);
        error = std::min(error, leastErrorWithin(related, radius));
    }
    largestError_.local() = std::max(largestError_.local(), error);
    if (error > claimed + tolerance_)
        tooLarge_.add(related.point, [&] {
            return "The error at " + name(related) + ", outside the mesh, is " +
                   textOf(original_.points.percent(error)) + " % of the range, more than the claimed " +
                   textOf(original_.points.percent(claimed)) + " %.";
        });
}

/// A point that lies on a face or an edge, but for rounding, may count for a cell on its other side, whose
/// interpolation there is the same; so may one that rounding has put outside of an edge of the boundary. Looks at all
/// cells, for the few that need it.
bool RelatedCheck::isGrantedNextToIt(const Related& related) const
{
    for (std::size_t number = 0; number < mesh_.cells.size(); ++number) {
        const PlacedCell cell = placedCell(original_.points.positions, mesh_.cells, number);
        const auto isBefore = [&](const std::array<std::uint8_t, 3>& face) {
            const Eigen::Vector3d normal = (cell[face[1]] - cell[face[0]]).cross(cell[face[2]] - cell[face[0]]);
            return normal.dot(related.place - cell[face[0]]) > original_.allowance * normal.norm();
        };
        if (std::ranges::any_of(cornersOfFace, isBefore))
            continue;
        std::array<double, 4> values{};
        std::ranges::transform(mesh_.cells.vertices(number), values.begin(), [&](std::uint32_t vertex) {
            return original_.points.values[mesh_.cells.point(vertex)];
        });
        if (related.weight * preciseError(cell, values, related.place, related.value) <= ownError(number) + tolerance_)
            return true;
    }
    return false;
}

/// The point counts for a cell: the one that holds it, or one on the boundary that is near enough.
void RelatedCheck::checkOwn(const Related& related, bool covered)
{
    const bool needsError = !inside_.isWithinOwn(related.point);
    const auto grants = [&](std::uint32_t triangle) {
        const std::uint32_t cell = mesh_.boundary.cells[triangle];
        const double radius = ownWarping(cell) / related.weight + original_.allowance;
        if (!needsError)
            return nearestPlace(mesh_.boundary.tree.corners(triangle), related.place).distance <= radius;
        return errorOn(related, triangle, radius) <= ownError(cell) + tolerance_;
    };
    if (grants(related.nearest.triangle))
        return;
    const bool onCells = covered || related.nearest.place.distance <= original_.allowance;
    bool granted = needsError && onCells && isGrantedNextToIt(related);
    const double farthest = largestOwnWarping_ / related.weight + original_.allowance;
    mesh_.boundary.tree.visitWithin(related.place, farthest,
                                    [&](std::uint32_t triangle) { granted = granted || grants(triangle); });
    if (!granted)
        beyondOwn_.add(related.point, [&] {
            return "The error or the warping at " + name(related) + " is larger than the own ones of every cell " +
                   (covered ? "that holds it." : "on the boundary near it.");
        });
}

void RelatedCheck::moveTo(LevelReport& verdict)
{
    const auto larger = [](double a, double b) { return std::max(a, b); };
    verdict.largestError = std::max(verdict.largestError, original_.points.percent(largestError_.combine(larger)));
    verdict.largestWarping = 100 * largestWarping_.combine(larger) / original_.diagonal;
    for (Findings* findings : {&tooLarge_, &tooFar_, &beyondOwn_})
        findings->moveTo(verdict.failures);
}

} // namespace

Status verifyRelated(const IrregularMesh& mesh, LevelReport& verdict, const Progress& progress)
{
    PointCheck inside(mesh.model, mesh.original.points, mesh.weights, mesh.cells, mesh.claims);
    if (const Status done = inside.run(progress.part(0, 0.6)); !done)
        return done;
    verdict.largestError = mesh.original.points.percent(inside.largestError());
    inside.tooLarge().moveTo(verdict.failures);
    if (mesh.boundary.triangles.empty())
        return {}; // said already
    RelatedCheck check(mesh, inside);
    if (const Status done = check.run(progress.part(0.6, 1)); !done)
        return done;
    check.moveTo(verdict);
    return {};
}

namespace {

constexpr double anything = std::numeric_limits<double>::infinity();

bool claimsTwoSides(const Model& model)
{
    return std::ranges::any_of(model.description().parameters, [](const auto& parameter) {
        return parameter.first == "distance" && parameter.second == "two-sided";
    });
}

/// What the boundary's places farthest from the original's say; weights are of points, so none is judged with them.
void verifyTwoSides(const IrregularMesh& mesh, LevelReport& verdict)
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

Result<LevelReport> verifyPrefix(const Model& model, const IrregularOriginal& original,
                                 const std::vector<LatticePoint>& places, const Weights& weights, std::uint32_t sites,
                                 const MeshBounds& claims, const Progress& progress)
{
    LevelReport verdict;
    verdict.sites = sites;
    const LevelCells cells(model, places, sites);
    if (const Status done = verifyIrregularCells(model, original, weights, cells, claims, verdict, progress); !done)
        return done.error();
    return verdict;
}

} // namespace

Status verifyIrregularCells(const Model& model, const IrregularOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshBounds& claims, LevelReport& verdict,
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
                                    MeshBounds(anything, anything), progress.part(0.5, 1));
    if (!first)
        return first.error();
    for (const std::string& failure : first->failures)
        failures.push_back("The first mesh: " + failure);
    return {};
}

Result<LevelReport> verifyIrregularLevel(const Model& model, const IrregularOriginal& original,
                                         const std::vector<LatticePoint>& places, const Weights& weights,
                                         const Accuracy& asked, const Progress& progress)
{
    const std::uint32_t sites = firstPassage(model, keyAsked(model, original.points.extent, original.diagonal, asked));
    const double claimed = claimedKey(model, sites);
    const MeshBounds claims(claimed, claimed / model.description().warpingWeight);
    Result<LevelReport> verdict = verifyPrefix(model, original, places, weights, sites, claims, progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

} // namespace tetra
