// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/lattice_cells.h"
#include "core/verify/exact_cell.h"
#include "core/verify/findings.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::size_t latticeCellsAtOnce = 1024;

/// What is known of a sample after all cells were visited.
enum SampleState {
    Covered = 1,        ///< some cell holds it
    WithinOwnError = 2, ///< some cell that holds it grants its error
};

/// Compares every original sample with the interpolation in every cell that holds it. `Errors` is ExactError, or
/// RoundedError where builders round, too: if there are weights, and for curvilinear data.
template <class Sample, class Errors> class SampleCheck {
public:
    explicit SampleCheck(const MeshToVerify& mesh)
        : model_(mesh.model), lattice_(mesh.original.lattice), samples_(mesh.original.values.as<Sample>()),
          weights_(mesh.weights), cells_(mesh.cells), claims_(mesh.claims),
          extent_(mesh.original.values.range().extent()), states_(lattice_.pointCount())
    {
    }

    Status run(const Progress& progress);
    void moveTo(LevelReport& verdict);

private:
    using Number = typename Errors::Number;

    void checkCell(std::size_t number);
    Number ownBound(std::size_t number, std::int64_t volume) const;
    Number weighted(Number error, std::uint64_t sample) const
    {
        if constexpr (std::is_same_v<Number, double>)
            return weights_.empty() ? error : error * static_cast<double>(weights_[sample]);
        else
            return error;
    }
    void mark(std::uint64_t sample, int state)
    {
        const auto known = states_[sample].load(std::memory_order_relaxed);
        if ((known | state) != known)
            states_[sample].fetch_or(static_cast<std::uint8_t>(state), std::memory_order_relaxed);
    }
    std::string describe(std::uint64_t sample, double error, std::size_t cell) const;
    double percent(double error) const { return extent_ > 0 ? 100 * error / extent_ : 0; }

    const Model& model_;
    const Lattice& lattice_;
    std::span<const Sample> samples_;
    const Weights& weights_; ///< only with RoundedError
    const LevelCells& cells_;
    const MeshBounds& claims_;
    double extent_;
    std::vector<std::atomic<std::uint8_t>> states_;
    tbb::enumerable_thread_specific<double> largest_{0.0};
    Findings tooLarge_;
};

template <class Sample, class Errors> Status SampleCheck<Sample, Errors>::run(const Progress& progress)
{
    return verifyEach(cells_.size(), latticeCellsAtOnce, "Verifying the error at every sample", progress,
                      [this](std::size_t number) { checkCell(number); });
}

/// What the history grants the cell; anything if it is of no history.
template <class Sample, class Errors>
auto SampleCheck<Sample, Errors>::ownBound(std::size_t number, std::int64_t volume) const -> Number
{
    const auto inHistory = cells_.historyNumber(number);
    return inHistory ? Errors::ownBound(model_.ownErrors()[*inHistory], extent_, volume)
                     : Errors::claimedBound(std::numeric_limits<double>::infinity(), extent_, volume);
}

template <class Sample, class Errors> void SampleCheck<Sample, Errors>::checkCell(std::size_t number)
{
    const CellCorners corners = cells_.corners(number);
    const std::int64_t volume = sixVolumes(corners);
    if (volume <= 0)
        return; // found already, and a flat cell interpolates nothing
    std::array<Sample, 4> values;
    for (int i = 0; i < 4; ++i)
        values[i] = samples_[cells_.point(cells_.vertices(number)[i])];
    const Number own = ownBound(number, volume);
    const bool uniform = claims_.areUniform();
    const Number claimed = uniform ? Errors::claimedBound(claims_.error(0), extent_, volume) : Number(0);
    Number worst = 0;
    Number worstBeyond = 0; ///< of those larger than what is claimed
    std::uint64_t sampleBeyond = 0;
    forEachSample(lattice_, corners, [&](const LatticePoint&, std::uint64_t sample, const auto& weights) {
        const Number error = weighted(Errors::at(weights, values, samples_[sample], volume), sample);
        mark(sample, error <= own ? Covered | WithinOwnError : Covered);
        worst = std::max(worst, error);
        if (error > worstBeyond &&
            error > (uniform ? claimed : Errors::claimedBound(claims_.error(sample), extent_, volume))) {
            worstBeyond = error;
            sampleBeyond = sample;
        }
    });
    largest_.local() = std::max(largest_.local(), Errors::inUnitsOfValues(worst, volume));
    if (worstBeyond > 0)
        tooLarge_.add(number,
                      [&] { return describe(sampleBeyond, Errors::inUnitsOfValues(worstBeyond, volume), number); });
}

template <class Sample, class Errors>
std::string SampleCheck<Sample, Errors>::describe(std::uint64_t sample, double error, std::size_t cell) const
{
    const auto c = lattice_.coordinates(sample);
    return "The error at sample " + textOf(LatticePoint{c[0], c[1], c[2]}) + " is " + textOf(percent(error)) +
           " % of the range, more than the claimed " + textOf(percent(claims_.error(sample))) +
           " %, in the cell with corners " + textOf(cells_.corners(cell)) + ".";
}

template <class Sample, class Errors> void SampleCheck<Sample, Errors>::moveTo(LevelReport& verdict)
{
    Findings notCovered;
    Findings beyondOwn;
    const auto placeOf = [this](std::uint64_t sample) {
        const auto c = lattice_.coordinates(sample);
        return textOf(LatticePoint{c[0], c[1], c[2]});
    };
    for (std::uint64_t sample = 0; sample < states_.size(); ++sample) {
        const std::uint8_t state = states_[sample].load(std::memory_order_relaxed);
        if ((state & Covered) == 0)
            notCovered.add(sample, [&] { return "Sample " + placeOf(sample) + " lies in no cell."; });
        else if ((state & WithinOwnError) == 0)
            beyondOwn.add(sample, [&] {
                return "The error at sample " + placeOf(sample) +
                       " is larger than the own error of every cell that holds it.";
            });
    }
    verdict.covers = verdict.covers && notCovered.none();
    verdict.largestError = percent(largest_.combine([](double a, double b) { return std::max(a, b); }));
    for (Findings* findings : {&notCovered, &tooLarge_, &beyondOwn})
        findings->moveTo(verdict.failures);
}

/// Flat and inverted cells, and whether the volumes add up to the domain's.
void verifyVolumes(const LevelCells& cells, const Lattice& lattice, LevelReport& verdict)
{
    Findings wrong;
    std::int64_t sum = 0;
    for (std::size_t number = 0; number < cells.size(); ++number) {
        const std::int64_t volume = sixVolumes(cells.corners(number));
        sum += volume;
        if (volume <= 0)
            wrong.add(number, [&] {
                return std::string(volume == 0 ? "Flat" : "Inverted") + " cell with corners " +
                       textOf(cells.corners(number)) + ".";
            });
    }
    const auto domain = 6 * static_cast<std::int64_t>(lattice.cellCount());
    verdict.inverted = wrong.count();
    verdict.covers = sum == domain;
    wrong.moveTo(verdict.failures);
    if (!verdict.covers)
        verdict.failures.push_back("The cells fill " + std::to_string(sum) +
                                   " sixths of a lattice cell, and the domain has " + std::to_string(domain) + ".");
}

FaceRule faceRule(const LevelCells& cells, const Lattice& lattice)
{
    const auto onBoundary = [&cells, &lattice](const std::array<std::uint32_t, 3>& vertices) {
        for (int axis = 0; axis < 3; ++axis)
            for (const std::int64_t side : {std::int64_t(0), std::int64_t(lattice.size[axis]) - 1})
                if (std::ranges::all_of(vertices,
                                        [&](std::uint32_t vertex) { return cells.place(vertex)[axis] == side; }))
                    return true;
        return false;
    };
    return {onBoundary, [&cells](std::uint32_t vertex) { return textOf(cells.place(vertex)); }};
}

} // namespace

Status verifyLatticeCells(const MeshToVerify& mesh, LevelReport& verdict, const Progress& progress)
{
    const Dataset& original = mesh.original;
    const bool lifted = original.domain == DomainClass::Curvilinear;
    const double samplesEnd = lifted ? 0.7 : 1; // how far it is after each part
    const double facesEnd = samplesEnd / 2;
    verdict.tetrahedra = mesh.cells.size();
    verifyVolumes(mesh.cells, original.lattice, verdict);
    if (const Status faces =
            verifyFaces(mesh.cells, faceRule(mesh.cells, original.lattice), verdict, progress.part(0, facesEnd));
        !faces)
        return faces;
    const Status samples = visitSampleType(original.values.type(), [&]<class Sample>() {
        const auto run = [&]<class Errors>() {
            SampleCheck<Sample, Errors> check(mesh);
            const Status done = check.run(progress.part(facesEnd, samplesEnd));
            check.moveTo(verdict);
            return done;
        };
        const bool rounds = !mesh.weights.empty() || lifted;
        return !rounds ? run.template operator()<ExactError<Sample>>()
                       : run.template operator()<RoundedError<Sample>>();
    });
    return samples && lifted ? verifyCurvilinear(mesh, verdict, progress.part(samplesEnd, 1)) : samples;
}

} // namespace tetra
