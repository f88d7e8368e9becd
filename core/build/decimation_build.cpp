// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/decimation_build.h"

#include "core/base/guarded.h"
#include "core/build/build_state.h"
#include "core/build/thresholds.h"
#include "core/data/dataset_checks.h"
#include "core/decimate/decimation.h"
#include "core/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <vector>

namespace tetra {

DecimationSize decimationSize(const Dataset& dataset)
{
    if (dataset.domain == DomainClass::Irregular)
        return {dataset.pointCount(), dataset.tetrahedra ? dataset.tetrahedra->size() : 0};
    if (dataset.domain == DomainClass::Scattered) // as its Delaunay mesh will have
        return {dataset.pointCount(), dataset.pointCount() >= 4 ? dataset.pointCount() * 27 / 4 : 0};
    DecimationSize size{dataset.lattice.pointCount(), gridCut(dataset.domain) == LatticeCut::Five ? 5u : 6u};
    for (const std::uint32_t points : dataset.lattice.size)
        size.tetrahedra *= points > 0 ? points - 1 : 0;
    return size;
}

std::uint64_t decimationNeed(const DecimationSize& size)
{
    // Positions, values and weights; the tetrahedra; and what the writer of the model keeps of each site and of the
    // tetrahedra that ever lived, of which there are some 17 a point.
    constexpr std::uint64_t inputBytesAPoint = 24 + 8 + 4, inputBytesATetrahedron = 16;
    constexpr std::uint64_t writerBytesAPoint = 4 + 17 * 4;
    return decimationBytes(size.points, size.tetrahedra) + size.points * (inputBytesAPoint + writerBytesAPoint) +
           size.tetrahedra * inputBytesATetrahedron;
}

Status checkDecimationNeed(const DecimationSize& size, std::uint64_t usableBytes)
{
    constexpr std::uint64_t mostPoints = 0xfffffffe, mostTetrahedra = (1ull << 30) - 1;
    if (size.points > mostPoints || size.tetrahedra > mostTetrahedra)
        return Error{ErrorKind::OutOfResource,
                     Message::say("A mesh of %1 points and %2 tetrahedra is too large to be decimated: the limits are "
                                  "%3 points and %4 tetrahedra. Take a region of it or fewer samples.",
                                  size.points, size.tetrahedra, mostPoints, mostTetrahedra)};
    const std::uint64_t need = decimationNeed(size);
    if (usableBytes == 0 || need <= usableBytes)
        return {};
    return Error{
        ErrorKind::OutOfResource,
        Message::say("Decimation of %1 points and %2 tetrahedra takes about %3 of memory, and this machine has %4. "
                     "Take a region of it or fewer samples, or, if it is a lattice or grid, refine it instead.",
                     size.points, size.tetrahedra, neededBytesText(need), neededBytesText(usableBytes))};
}

namespace {

std::vector<double> valuesOf(const Dataset& dataset)
{
    return visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset.values.as<T>();
        return std::vector<double>(samples.begin(), samples.end());
    });
}

std::vector<Eigen::Vector3d> computationalPositions(const Lattice& lattice)
{
    std::vector<Eigen::Vector3d> positions;
    positions.reserve(lattice.pointCount());
    for (std::uint32_t z = 0; z < lattice.size[2]; ++z)
        for (std::uint32_t y = 0; y < lattice.size[1]; ++y)
            for (std::uint32_t x = 0; x < lattice.size[0]; ++x)
                positions.emplace_back(x, y, z);
    return positions;
}

/// A dataset as a mesh that can be decimated: irregular data as they are, lattices and curvilinear grids (those that
/// are not taken asMesh()) cut into tetrahedra in computational space, where collapsed lines and cells without volume
/// do no harm (S6).
class DecimationInput {
public:
    /// `dataset` must outlive the input; irregular, regular or curvilinear, with a cell or more. Errors: cancelled, not
    /// enough memory.
    static Result<DecimationInput> make(const Dataset& dataset, const Weighting& weighting, const Progress& progress);

    DecimationMesh mesh() const;
    const std::vector<float>& weights() const noexcept { return weights_; }

private:
    explicit DecimationInput(const Dataset& dataset) : dataset_(&dataset) {}

    const Dataset* dataset_;
    std::vector<Eigen::Vector3d> positions_; ///< of lattices and grids
    std::vector<double> values_;
    std::vector<float> weights_;
    std::vector<std::array<std::uint32_t, 4>> tetrahedra_; ///< of lattices and grids
};

Result<DecimationInput> DecimationInput::make(const Dataset& dataset, const Weighting& weighting,
                                              const Progress& progress)
{
    const auto makeInput = [&]() -> Result<DecimationInput> {
        DecimationInput input(dataset);
        Result<std::vector<float>> weights = pointWeights(weighting, dataset, progress);
        if (!weights)
            return weights.error();
        input.weights_ = *std::move(weights);
        input.values_ = valuesOf(dataset);
        if (dataset.domain != DomainClass::Irregular) {
            input.positions_ = computationalPositions(dataset.lattice);
            input.tetrahedra_ = latticeTetrahedra(dataset.lattice.size, gridCut(dataset.domain));
        }
        return input;
    };
    return guarded(Message::marked("Not enough memory to decimate '%1'. Take a region of it or fewer samples."),
                   makeInput, dataset.source.name);
}

DecimationMesh DecimationInput::mesh() const
{
    DecimationMesh mesh;
    mesh.values = values_;
    mesh.weights = weights_;
    if (dataset_->domain == DomainClass::Irregular) {
        mesh.positions = *dataset_->positions;
        mesh.tetrahedra = *dataset_->tetrahedra;
        return mesh;
    }
    mesh.positions = positions_;
    mesh.tetrahedra = tetrahedra_;
    mesh.box = true;
    if (dataset_->domain == DomainClass::Curvilinear) {
        mesh.physical = *dataset_->positions;
        mesh.leftHanded = isLeftHanded(*dataset_);
    }
    return mesh;
}

/// How tetrahedra that are positive where they were made lie in physical space.
struct PhysicalSigns {
    std::uint64_t inverted = 0;   ///< turned over (S5): against the side that most of the grid's cells turn to
    std::uint64_t degenerate = 0; ///< without volume (S6)
};

/// Of a curvilinear dataset; exact. O(tetrahedra).
PhysicalSigns physicalSigns(const Dataset& dataset, std::span<const std::array<std::uint32_t, 4>> tetrahedra)
{
    const auto at = [&](std::uint32_t point) {
        const Eigen::Vector3d& position = (*dataset.positions)[point];
        return std::array<double, 3>{position.x(), position.y(), position.z()};
    };
    const int right = isLeftHanded(dataset) ? -1 : 1;
    PhysicalSigns signs;
    for (const auto& corners : tetrahedra) {
        const int sign = orientationSign(at(corners[0]), at(corners[1]), at(corners[2]), at(corners[3]));
        signs.inverted += sign == -right ? 1 : 0;
        signs.degenerate += sign == 0 ? 1 : 0;
    }
    return signs;
}

/// Hands on a history, coarse first, as far as the first mesh whose key is no more than `finest`. If it `keeps` that
/// mesh, it can be asked for.
class HistoryBeginning final : public HistorySink {
public:
    HistoryBeginning(HistorySink& next, double finest, bool keeps) : next_(next), finest_(finest), keeps_(keeps) {}

    Status begin(const HistoryTraits& traits) override { return next_.begin(traits); }
    Status add(const HistoryStep& step) override
    {
        if (complete_)
            return {};
        if (static_cast<double>(step.keyBefore) <= finest_) {
            complete_ = true;
            return next_.finish(step.keyBefore);
        }
        ++sites_;
        tetrahedra_ += step.star.size();
        if (keeps_)
            keep(step);
        return next_.add(step);
    }
    Status finish(float finalKey) override { return complete_ ? Status() : next_.finish(finalKey); }

    std::uint64_t sites() const noexcept { return sites_; }
    std::uint64_t tetrahedra() const noexcept { return tetrahedra_; }
    /// The finest mesh, of the dataset's points.
    std::vector<std::array<std::uint32_t, 4>> mesh() const
    {
        std::vector<std::array<std::uint32_t, 4>> living;
        std::ranges::copy_if(kept_, std::back_inserter(living),
                             [](const auto& corners) { return corners != destroyed; });
        return living;
    }

private:
    static constexpr std::array<std::uint32_t, 4> destroyed{};

    void keep(const HistoryStep& step)
    {
        points_.push_back(static_cast<std::uint32_t>(step.point));
        for (const std::uint32_t index : step.destroyed)
            kept_[index] = destroyed;
        for (const HistoryTetrahedron& tetrahedron : step.star) {
            const auto& sites = tetrahedron.sites;
            kept_.push_back({points_.back(), points_[sites[0]], points_[sites[1]], points_[sites[2]]});
        }
    }

    HistorySink& next_;
    double finest_;
    bool keeps_;
    std::vector<std::uint32_t> points_;              ///< of the sites
    std::vector<std::array<std::uint32_t, 4>> kept_; ///< by history index
    bool complete_ = false;
    std::uint64_t sites_ = 0;
    std::uint64_t tetrahedra_ = 0;
};

/// A model from a finest mesh on that is coarser than its coarsest one would hold nothing.
Status checkFinest(const Decimation& decimation)
{
    const double stop = decimation.error > 0 ? decimation.error : decimation.warping;
    if (!(stop > 0) || decimation.finest <= stop)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("The finest error (%1 %) is larger than the error at which to stop (%2 %). Choose a "
                              "smaller finest error, or 0 to keep everything.",
                              formatNumber(decimation.finest), formatNumber(stop))};
}

} // namespace

Status checkDecimation(const Dataset& dataset)
{
    const DecimationSize size = decimationSize(dataset);
    if (size.tetrahedra == 0)
        return Error{ErrorKind::BadInput,
                     dataset.domain == DomainClass::Scattered
                         ? Message::say("A tetrahedral mesh needs four points or more.")
                         : Message::say("A tetrahedral mesh needs a cell: two points or more along each axis.")};
    return checkDecimationNeed(size, usableBytes());
}

Result<Dataset> takenFor(const Decimation& decimation, const Dataset& dataset, const Progress& progress)
{
    if (dataset.domain == DomainClass::RegularLattice &&
        (decimation.warping > 0 || decimation.orderedBy != OrderedBy::Both))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is a regular lattice, which has no warping. Leave out the options about it.",
                                  dataset.source.name)};
    if (decimation.computational && dataset.domain != DomainClass::Curvilinear)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("Only curvilinear grids can be decimated in one space or the other, and '%1' is not one.",
                         dataset.source.name)};
    if (!checkDecimation(dataset))
        return dataset;
    if (dataset.domain == DomainClass::Curvilinear && !decimation.computational)
        return asMesh(dataset, progress);
    if (dataset.domain != DomainClass::Scattered)
        return dataset;
    return guarded(
        Message::marked("Not enough memory to decimate '%1'. Take a region of it or fewer samples."),
        [&] { return tetrahedrized(dataset, progress); }, dataset.source.name);
}

Result<BuildReport> buildInto(const Dataset& dataset, const Decimation& decimation, BuildTarget& target,
                              const Progress& progress)
{
    if (const Status possible = checkDecimation(dataset); !possible)
        return possible.error();
    if (dataset.domain == DomainClass::Scattered)
        return Error{ErrorKind::WrongUsage,
                     Message::say("Decimation needs the mesh of scattered points, and these are the points alone.")};
    if (const Status possible = checkFinest(decimation); !possible)
        return possible.error();
    const BuildThresholds thresholds{decimation.error, decimation.warping, decimation.orderedBy};
    if (const Status possible = checkThresholds(thresholds, dataset); !possible)
        return possible.error();
    if (decimation.twoSided && dataset.domain != DomainClass::Irregular)
        return Error{ErrorKind::WrongUsage, Message::say("Only irregular data have a boundary that moves, and so a "
                                                         "distance from both sides to limit. Leave that out.")};
    const auto input = DecimationInput::make(dataset, decimation.weighting, progress.part(0, 0.02));
    if (!input)
        return input.error();
    const ThresholdKey key = thresholdKey(thresholds, dataset);
    DecimationOptions options;
    options.order = decimation.order;
    options.warpingWeight = key.warpingWeight;
    options.twoSided = decimation.twoSided;
    if (key.stopKey) // without thresholds to the coarsest mesh
        options.stopKey = *key.stopKey;
    options.preview = target.preview;
    options.keepWhenCancelled = target.keepWhenCancelled;
    const auto state = buildState(target, dataset, "decimation",
                                  std::array{double(options.order), double(decimation.orderedBy), options.warpingWeight,
                                             options.stopKey, double(options.twoSided), decimation.finest},
                                  input->weights());
    if (!state)
        return state.error();
    options.state = state->get();
    const DecimationMesh mesh = input->mesh();
    const bool isGrid = dataset.domain == DomainClass::Curvilinear;
    const bool isCutOff = decimation.finest > 0;
    const double finestKey = isCutOff ? std::max(decimation.finest / 100 * key.keyExtent, key.leastKey) : -1;
    HistoryBeginning history(target.history, finestKey, isGrid && isCutOff);
    const auto result = decimate(mesh, options, history, progress.part(0.02, 1));
    if (!result)
        return result.error();
    BuildReport report{history.sites(), history.tetrahedra(), 0, 0, result->stoppedEarly};
    if (isGrid) {
        const PhysicalSigns signs =
            isCutOff ? physicalSigns(dataset, history.mesh()) : physicalSigns(dataset, mesh.tetrahedra);
        report.inverted = signs.inverted;
        report.degenerate = signs.degenerate;
    }
    return report;
}

} // namespace tetra
