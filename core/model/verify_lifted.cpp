// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/half.h"
#include "core/model/cell_samples.h"
#include "core/model/exact_volume.h"
#include "core/model/findings.h"
#include "core/model/verify_cells.h"
#include "core/model/verify_each.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr std::size_t liftedCellsAtOnce = 256;

/// What of a mesh holds in physical space: that its cells are not inverted, and how far they are from the grid.
class LiftedCheck {
public:
    explicit LiftedCheck(const MeshToVerify& mesh)
        : model_(mesh.model), original_(mesh.original), weights_(mesh.weights), cells_(mesh.cells),
          claims_(mesh.claims), lifted_(*mesh.lifted), diagonal_(original_.bounds().diagonal().norm()),
          allowance_(1e-12 * diagonal_ + 0x1p-44 * farthest(original_)), withinOwn_(original_.pointCount())
    {
    }

    Status run(const Progress& progress);
    void moveTo(LevelVerdict& verdict);

private:
    /// Coordinates of this size are rounded, in the builder as here.
    static double farthest(const Dataset& original)
    {
        const Eigen::AlignedBox3d bounds = original.bounds();
        return std::max(bounds.min().cwiseAbs().maxCoeff(), bounds.max().cwiseAbs().maxCoeff());
    }
    void checkCell(std::size_t number);
    void checkVolume(std::size_t number, const std::array<Eigen::Vector3d, 4>& places);
    /// What the history grants the cell; anything if it is of no history.
    double ownBound(std::size_t number) const
    {
        const auto inHistory = cells_.historyNumber(number);
        return inHistory ? static_cast<double>(halfToFloat(model_.ownWarpings()[*inHistory])) * diagonal_ + allowance_
                         : std::numeric_limits<double>::infinity();
    }
    double percent(double warping) const { return 100 * warping / diagonal_; }

    const Model& model_;
    const Dataset& original_;
    const Weights& weights_;
    const LevelCells& cells_;
    const MeshClaims& claims_;
    const LiftedOriginal& lifted_;
    double diagonal_;
    double allowance_;                         ///< by which a claim may be exceeded
    std::vector<std::atomic<bool>> withinOwn_; ///< for each sample whether one of its cells' own warpings bounds it
    tbb::enumerable_thread_specific<double> largest_{0.0};
    std::atomic<std::uint64_t> degenerate_ = 0;
    std::atomic<std::uint64_t> borne_ = 0; ///< inverted, as the grid itself is there
    Findings inverted_;
    Findings tooLarge_;
};

Status LiftedCheck::run(const Progress& progress)
{
    return verifyEach(cells_.size(), liftedCellsAtOnce, "Verifying the warping at every sample", progress,
                      [this](std::size_t number) { checkCell(number); });
}

void LiftedCheck::checkVolume(std::size_t number, const std::array<Eigen::Vector3d, 4>& places)
{
    const int sign = volumeSign(places[0], places[1], places[2], places[3]);
    if (sign == 0)
        ++degenerate_;
    else if (sign != lifted_.hand() && lifted_.bears(cells_.corners(number)))
        ++borne_;
    else if (sign != lifted_.hand())
        inverted_.add(number, [&] {
            return "Cell with corners " + textOf(cells_.corners(number)) + " is inverted in physical space.";
        });
}

void LiftedCheck::checkCell(std::size_t number)
{
    const CellCorners corners = cells_.corners(number);
    const std::int64_t volume = sixVolumes(corners);
    if (volume <= 0)
        return; // found already
    std::array<Eigen::Vector3d, 4> places;
    for (std::size_t corner = 0; corner < 4; ++corner)
        places[corner] = original_.position(cells_.point(cells_.vertices(number)[corner]));
    checkVolume(number, places);
    const double own = ownBound(number);
    double worst = 0;
    double worstBeyond = 0; ///< of those larger than what is claimed
    std::uint64_t sampleBeyond = 0;
    forEachSample(original_.lattice, corners, [&](const LatticePoint&, std::uint64_t sample, const auto& weights) {
        const Eigen::Vector3d original = original_.position(sample);
        Eigen::Vector3d offset(0, 0, 0);
        for (std::size_t corner = 0; corner < 4; ++corner)
            offset += static_cast<double>(weights[corner]) / static_cast<double>(volume) * (places[corner] - original);
        const double warping = offset.norm() * (weights_.empty() ? 1 : static_cast<double>(weights_[sample]));
        if (warping <= own)
            withinOwn_[sample].store(true, std::memory_order_relaxed);
        worst = std::max(worst, warping);
        if (warping > worstBeyond && warping > claims_.warping(sample) + allowance_) {
            worstBeyond = warping;
            sampleBeyond = sample;
        }
    });
    largest_.local() = std::max(largest_.local(), worst);
    if (worstBeyond > 0)
        tooLarge_.add(number, [&] {
            const auto c = original_.lattice.coordinates(sampleBeyond);
            return "The warping at sample " + textOf(LatticePoint{c[0], c[1], c[2]}) + " is " +
                   textOf(percent(worstBeyond)) + " % of the diagonal, more than the claimed " +
                   textOf(percent(claims_.warping(sampleBeyond))) + " %, in the cell with corners " + textOf(corners) +
                   ".";
        });
}

void LiftedCheck::moveTo(LevelVerdict& verdict)
{
    Findings beyondOwn;
    const bool ofHistory = cells_.size() > 0 && cells_.historyNumber(0).has_value();
    for (std::uint64_t sample = 0; sample < withinOwn_.size(); ++sample)
        if (ofHistory && !withinOwn_[sample].load(std::memory_order_relaxed))
            beyondOwn.add(sample, [&] {
                const auto c = original_.lattice.coordinates(sample);
                return "The warping at sample " + textOf(LatticePoint{c[0], c[1], c[2]}) +
                       " is larger than the own warping of every cell that holds it.";
            });
    verdict.largestWarping = percent(largest_.combine([](double a, double b) { return std::max(a, b); }));
    verdict.inverted += inverted_.count() + borne_;
    verdict.invertedInData = borne_;
    verdict.degenerate = degenerate_;
    for (Findings* findings : {&inverted_, &tooLarge_, &beyondOwn})
        findings->moveTo(verdict.failures);
}

} // namespace

Status verifyLifted(const MeshToVerify& mesh, LevelVerdict& verdict, const Progress& progress)
{
    LiftedCheck check(mesh);
    const Status done = check.run(progress);
    check.moveTo(verdict);
    return done;
}

} // namespace tetra
