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
               double claimed)
        : model_(model), original_(original), weights_(weights), cells_(cells), claimed_(claimed),
          states_(original.positions.size())
    {
    }

    Status run(const Progress& progress);
    void moveTo(LevelVerdict& verdict);

private:
    void checkCell(std::size_t number);
    double percent(double error) const { return original_.extent > 0 ? 100 * error / original_.extent : 0; }

    const Model& model_;
    const ScatteredOriginal& original_;
    const Weights& weights_;
    const LevelCells& cells_;
    double claimed_;
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
    const PlacedCell cell = placedCell(model_, original_.positions, cells_.sites(number));
    if (volumeSign(cell) <= 0)
        return; // found already, and a flat cell interpolates nothing
    std::array<double, 4> values{};
    std::ranges::transform(cells_.sites(number), values.begin(),
                           [&](std::uint32_t site) { return original_.values[model_.points()[site]]; });
    const double tolerance = allowance * original_.extent;
    const double own =
        static_cast<double>(halfToFloat(model_.ownErrors()[cells_.historyNumber(number)])) * original_.extent;
    original_.tree.visitNear(cell, [&](std::uint32_t point) {
        const Eigen::Vector3d& place = original_.positions[point];
        if (!holds(cell, place))
            return;
        const double weight = weights_.empty() ? 1 : static_cast<double>(weights_[point]);
        const CellError quick = quickError(cell, values, place, original_.values[point]);
        const bool clear = (quick.error + quick.doubt) * weight <= std::min(own, claimed_);
        const double error =
            weight * (clear ? quick.error : preciseError(cell, values, place, original_.values[point]));
        largest_.local() = std::max(largest_.local(), error);
        states_[point].fetch_or(error <= own + tolerance ? Covered | WithinOwnError : Covered,
                                std::memory_order_relaxed);
        if (error > claimed_ + tolerance)
            tooLarge_.add(point, [&] {
                return "The error at point " + std::to_string(point) + " " + textOf(place) + " is " +
                       textOf(percent(error)) + " % of the range, more than the claimed " + textOf(percent(claimed_)) +
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

void verifyVolumes(const Model& model, const ScatteredOriginal& original, const LevelCells& cells,
                   LevelVerdict& verdict)
{
    Findings wrong;
    tbb::parallel_for(std::size_t(0), cells.size(), [&](std::size_t number) {
        const PlacedCell cell = placedCell(model, original.positions, cells.sites(number));
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
void verifyCoveredOnce(const Model& model, const ScatteredOriginal& original, const LevelCells& cells,
                       LevelVerdict& verdict)
{
    for (std::size_t number = 0; number < cells.size(); ++number) {
        const PlacedCell cell = placedCell(model, original.positions, cells.sites(number));
        const Eigen::Vector3d middle = (cell[0] + cell[1] + cell[2] + cell[3]) / 4;
        if (volumeSign(cell) <= 0 || !holdsInside(cell, middle))
            continue; // too thin for a double inside it
        std::size_t count = 0;
        for (std::size_t other = 0; other < cells.size(); ++other) {
            const PlacedCell around = placedCell(model, original.positions, cells.sites(other));
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

/// Whether all initial sites lie on one side of a face.
bool onHull(const Model& model, const ScatteredOriginal& original, std::uint32_t initialSites,
            const std::array<std::uint32_t, 3>& face)
{
    const auto place = [&](std::uint32_t site) { return original.positions[model.points()[site]]; };
    const Eigen::Vector3d a = place(face[0]), b = place(face[1]), c = place(face[2]);
    int side = 0;
    for (std::uint32_t site = 0; site < initialSites; ++site) {
        const int sign = volumeSign(a, b, c, place(site));
        if (sign * side < 0)
            return false;
        side = side == 0 ? sign : side;
    }
    return true;
}

/// The mesh of the first sites.
Result<LevelVerdict> verifyMesh(const Model& model, const ScatteredOriginal& original,
                                const std::vector<LatticePoint>& places, const Weights& weights, std::uint32_t sites,
                                double claimed, const Progress& progress)
{
    LevelVerdict verdict;
    verdict.sites = sites;
    verdict.covers = true;
    const LevelCells cells(model, places, sites);
    verdict.tetrahedra = cells.size();
    verifyVolumes(model, original, cells, verdict);
    const std::uint32_t initialSites = initialSiteCount(model);
    const FaceRule rule{
        [&](const std::array<std::uint32_t, 3>& face) { return onHull(model, original, initialSites, face); },
        [&](std::uint32_t site) { return textOf(original.positions[model.points()[site]]); }};
    if (const Status faces = verifyFaces(cells, rule, verdict, progress.part(0, 0.4)); !faces)
        return faces.error();
    verifyCoveredOnce(model, original, cells, verdict);
    PointCheck check(model, original, weights, cells, claimed);
    if (const Status done = check.run(progress.part(0.4, 1)); !done)
        return done.error();
    check.moveTo(verdict);
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
            const PlacedCell cell = placedCell(model, original.positions, {creator, others[0], others[1], others[2]});
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
    const auto first = verifyMesh(model, original, places, weights, initialSiteCount(model),
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
    const float claimed = sites < model.siteCount() ? model.runningErrors()[sites] : model.finalError();
    Result<LevelVerdict> verdict =
        verifyMesh(model, original, places, weights, sites, static_cast<double>(claimed), progress);
    if (verdict)
        verdict->asked = asked;
    return verdict;
}

} // namespace tetra
