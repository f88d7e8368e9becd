// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/verify_scattered.h"

#include "core/base/half.h"
#include "core/model/exact_volume.h"
#include "core/model/findings.h"
#include "core/model/scattered_cells.h"
#include "core/model/shared_progress.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <limits>

namespace tetra {

namespace {

constexpr std::size_t cellsAtOnce = 256;
constexpr double allowance = 1e-12; // of the value range

/// What is known of a point after all cells were visited.
enum PointState {
    Covered = 1,        ///< some cell holds it
    WithinOwnError = 2, ///< some cell that holds it grants its error
};

/// Compares every original point with the interpolation in every cell that holds it.
class PointCheck {
public:
    PointCheck(const Model& model, const ScatteredOriginal& original, const Weights& weights, const LevelCells& cells,
               const MeshClaims& claims)
        : model_(model), original_(original), weights_(weights), cells_(cells), claims_(claims),
          states_(original.positions.size())
    {
    }

    Status run(const Progress& progress);
    void moveTo(LevelVerdict& verdict);

private:
    void checkCell(std::size_t number);
    /// What the history grants the cell; anything if it is of no history.
    double ownBound(std::size_t number) const
    {
        const auto inHistory = cells_.historyNumber(number);
        return inHistory ? static_cast<double>(halfToFloat(model_.ownErrors()[*inHistory])) * original_.extent
                         : std::numeric_limits<double>::infinity();
    }
    double percent(double error) const { return original_.extent > 0 ? 100 * error / original_.extent : 0; }

    const Model& model_;
    const ScatteredOriginal& original_;
    const Weights& weights_;
    const LevelCells& cells_;
    const MeshClaims& claims_;
    std::vector<std::atomic<std::uint8_t>> states_;
    tbb::enumerable_thread_specific<double> largest_{0.0};
    Findings tooLarge_;
};

Status PointCheck::run(const Progress& progress)
{
    SharedProgress shared(progress, cells_.size(), "Verifying the error at every point");
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells_.size(), cellsAtOnce), [&](const auto& range) {
        for (std::size_t number = range.begin(); number != range.end(); ++number) {
            if (shared.cancelled())
                return;
            checkCell(number);
        }
        shared.done(range.size());
    });
    if (progress.cancelled())
        return cancelledError("Verifying the model");
    return {};
}

void PointCheck::checkCell(std::size_t number)
{
    const PlacedCell cell = placedCell(original_.positions, cells_, number);
    if (volumeSign(cell) <= 0)
        return; // found already, and a flat cell interpolates nothing
    std::array<double, 4> values{};
    std::ranges::transform(cells_.vertices(number), values.begin(),
                           [&](std::uint32_t vertex) { return original_.values[cells_.point(vertex)]; });
    const double tolerance = allowance * original_.extent;
    const double own = ownBound(number);
    original_.tree.visitNear(cell, [&](std::uint32_t point) {
        const Eigen::Vector3d& place = original_.positions[point];
        if (!holds(cell, place))
            return;
        const double claimed = claims_.error(point);
        const double weight = weights_.empty() ? 1 : static_cast<double>(weights_[point]);
        const CellError quick = quickError(cell, values, place, original_.values[point]);
        const bool clear = (quick.error + quick.doubt) * weight <= std::min(own, claimed);
        const double error =
            weight * (clear ? quick.error : preciseError(cell, values, place, original_.values[point]));
        largest_.local() = std::max(largest_.local(), error);
        states_[point].fetch_or(error <= own + tolerance ? Covered | WithinOwnError : Covered,
                                std::memory_order_relaxed);
        if (error > claimed + tolerance)
            tooLarge_.add(point, [&] {
                return "The error at point " + std::to_string(point) + " " + textOf(place) + " is " +
                       textOf(percent(error)) + " % of the range, more than the claimed " + textOf(percent(claimed)) +
                       " %, in the cell with corners " + textOf(cell) + ".";
            });
    });
}

void PointCheck::moveTo(LevelVerdict& verdict)
{
    Findings notCovered;
    Findings beyondOwn;
    for (std::uint64_t point = 0; point < states_.size(); ++point) {
        const std::uint8_t state = states_[point].load(std::memory_order_relaxed);
        const auto name = [&] { return "oint " + std::to_string(point) + " " + textOf(original_.positions[point]); };
        if ((state & Covered) == 0)
            notCovered.add(point, [&] { return "P" + name() + " lies in no cell."; });
        else if ((state & WithinOwnError) == 0)
            beyondOwn.add(point, [&] {
                return "The error at p" + name() + " is larger than the own error of every cell that holds it.";
            });
    }
    verdict.covers = verdict.covers && notCovered.none();
    verdict.largestError = percent(largest_.combine([](double a, double b) { return std::max(a, b); }));
    for (Findings* findings : {&notCovered, &tooLarge_, &beyondOwn})
        findings->moveTo(verdict.failures);
}

void verifyVolumes(const ScatteredOriginal& original, const LevelCells& cells, LevelVerdict& verdict)
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

Status verifyScatteredCells(const Model& model, const ScatteredOriginal& original, const Weights& weights,
                            const LevelCells& cells, const MeshClaims& claims, LevelVerdict& verdict,
                            const Progress& progress)
{
    verdict.covers = true;
    verdict.tetrahedra = cells.size();
    verifyVolumes(original, cells, verdict);
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
    check.moveTo(verdict);
    return {};
}

Status verifyScatteredHistory(const Model& model, const ScatteredOriginal& original,
                              const std::vector<LatticePoint>& places, const Weights& weights,
                              std::vector<std::string>& failures, const Progress& progress)
{
    Findings positions;
    Findings volumes;
    for (std::uint32_t site = 0; site < model.siteCount(); ++site)
        if (model.position(site) != original.positions[model.points()[site]])
            positions.add(site, [&] {
                return "Site " + std::to_string(site) + " lies at " + textOf(model.position(site)) +
                       "; the original's point is at " + textOf(original.positions[model.points()[site]]) + ".";
            });
    const Progress half = progress.part(0, 0.5);
    SharedProgress shared(half, model.siteCount(), "Verifying the history");
    tbb::parallel_for(std::uint32_t(0), model.siteCount(), [&](std::uint32_t creator) {
        if (shared.cancelled())
            return;
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
        shared.done(1);
    });
    if (progress.cancelled())
        return cancelledError("Verifying the model");
    positions.moveTo(failures);
    volumes.moveTo(failures);
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
