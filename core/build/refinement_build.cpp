// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/build.h>

#include "core/base/guarded.h"
#include "core/base/scratch_file.h"
#include "core/base/work_folder.h"
#include "core/build/blocked_build.h"
#include "core/build/build_state.h"
#include "core/build/thresholds.h"
#include "core/data/weighting.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/free/scattered_refinement.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "core/refine/lattice/packed_lattice.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tetra {

namespace {

// Regular lattices as a whole.

Result<BuildReport> refineAsWhole(const Dataset& dataset, double stopError, std::span<const float> weights,
                                  BuildTarget& target, const Progress& progress)
{
    LatticeRefinementOptions options;
    options.size = dataset.lattice.size;
    options.spacing = dataset.lattice.spacing;
    options.valueExtent = dataset.values.range().extent();
    options.stopError = stopError;
    const auto state = buildState(target, dataset, "refinement", std::array{stopError}, weights);
    if (!state)
        return state.error();
    options.state = state->get();
    const Result<LatticeRefinementResult> result = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>(), weights), target.history, progress);
    });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

// And in blocks.

Result<BuildReport> refineInBlocks(const Dataset& dataset, double stopError, std::uint32_t cells,
                                   std::span<const float> weights, const BuildTarget& target, const Progress& progress)
{
    LatticeRunsOptions options;
    const auto metric = latticeMetric(BlockDivision(dataset.lattice.size, cells).box(0).size, dataset.lattice.spacing);
    if (!metric)
        return metric.error();
    const double extent = dataset.values.range().extent();
    options.box.latticeSize = dataset.lattice.size;
    options.box.metric = *metric;
    options.box.valueExtent = extent;
    BlockedBuild build{.cells = cells, .weights = weights, .keyExtent = extent > 0 ? extent : 1, .stopKey = stopError};
    build.valueExtent = extent;
    build.others = {static_cast<double>((*metric)[0]), static_cast<double>((*metric)[1]),
                    static_cast<double>((*metric)[2])};
    build.makeRuns = [&](const BlockRunsOptions& common, double stopKey, RunFiles& runs, const Progress& refining) {
        static_cast<BlockRunsOptions&>(options) = common;
        options.box.stopError = stopKey;
        return visitSampleType(dataset.values.type(), [&]<class T>() {
            return makeLatticeRuns(options, LatticeSamples(dataset.values.as<T>(), weights), runs, refining);
        });
    };
    return buildInBlocks(dataset, build, target, progress);
}

/// The cells along an edge of a block, 0 for none, of what is chosen.
Result<std::uint32_t> blocksFor(const Dataset& dataset, const Refinement& refinement, const BuildTarget& target)
{
    if ((refinement.paperSelection || refinement.inSpace) && dataset.domain == DomainClass::Curvilinear) {
        // Which of error and warping comes next, and where a place in space lies, the mesh as a whole decides.
        if (!refinement.block || *refinement.block == 0)
            return 0u;
        if (refinement.inSpace)
            return Error{ErrorKind::WrongUsage,
                         Message::say("The error in space is kept in whole grids only, as a point may lie in a "
                                      "tetrahedron of another block. Set the block to \"none\".")};
        return Error{ErrorKind::WrongUsage,
                     Message::say("The paper's selection of points cannot be used with blocks: blocks that are refined "
                                  "independently could not agree about their faces. Set the block to \"none\".")};
    }
    const auto cells = chooseBlocks(refinement.block, dataset.lattice, usableBytes());
    if (cells && *cells == 0 && target.part)
        return Error{ErrorKind::WrongUsage, Message::say("A build is cut into parts where its blocks are. Choose the "
                                                         "edge of a block, such as 32 cells.")};
    if (cells && *cells > 0 && !target.ofFixedSize && !target.part)
        return Error{ErrorKind::WrongUsage,
                     Message::say("This target cannot be built in blocks. Set the block to \"none\".")};
    return cells;
}

/// The weights of a build's points: in memory, or of blocks in a file that the system may keep there.
class BuildWeights {
public:
    static Result<BuildWeights> make(const Refinement& refinement, const Dataset& dataset, bool inBlocks,
                                     const std::filesystem::path& workFolder, const Progress& progress)
    {
        BuildWeights weights;
        if (refinement.weighting.empty())
            return weights;
        if (!inBlocks) {
            Result<std::vector<float>> all = pointWeights(refinement.weighting, dataset, progress);
            if (!all)
                return all.error();
            weights.memory_ = *std::move(all);
            return weights;
        }
        const Result<ScratchFile> file = ScratchFile::create(workFolder, dataset.pointCount() * sizeof(float));
        if (!file)
            return file.error();
        weights.file_ = *file;
        if (const Status weighed = weighPoints(refinement.weighting, dataset, weights.file_->as<float>(), progress);
            !weighed)
            return weighed.error();
        return weights;
    }

    /// One a point, or none.
    std::span<const float> all() const { return file_ ? file_->as<const float>() : std::span<const float>(memory_); }

private:
    std::vector<float> memory_;
    std::optional<ScratchFile> file_;
};

Result<BuildReport> buildLattice(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                 const Progress& progress)
{
    const double stopError = refinement.error / 100 * dataset.values.range().extent();
    const auto cells = blocksFor(dataset, refinement, target);
    if (!cells)
        return cells.error();
    const Result<BuildWeights> weights =
        BuildWeights::make(refinement, dataset, *cells > 0, target.workFolder, progress);
    if (!weights)
        return weights.error();
    Dataset meshed = dataset;
    meshed.lattice.spacing = refinement.metric.value_or(dataset.lattice.spacing);
    if (*cells == 0)
        return refineAsWhole(meshed, stopError, weights->all(), target, progress);
    return refineInBlocks(meshed, stopError, *cells, weights->all(), target, progress);
}

Result<BuildReport> refineCurvilinearInBlocks(const Dataset& dataset, const ThresholdKey& key, std::uint32_t cells,
                                              std::span<const float> weights, const BuildTarget& target,
                                              const Progress& progress)
{
    CurvilinearRunsOptions options;
    options.box.size = dataset.lattice.size;
    options.box.warpingWeight = key.warpingWeight;
    options.box.valueExtent = key.valueExtent;
    options.box.positionExtent = key.positionExtent;
    progress.report(0, Message::marked("Examining the cells"));
    visitSampleType(dataset.values.type(), [&]<class T>() {
        options.box.facts =
            factsOf(dataset.lattice.size, *dataset.positions, LatticeSamples(dataset.values.as<T>(), weights));
    });
    BlockedBuild build{.cells = cells, .weights = weights, .keyExtent = key.keyExtent};
    build.stopKey = key.stopKey.value_or(key.leastKey);
    build.warpingWeight = key.warpingWeight;
    build.valueExtent = key.valueExtent;
    build.diagonal = key.positionExtent;
    build.makeRuns = [&](const BlockRunsOptions& common, double stopKey, RunFiles& runs, const Progress& refining) {
        static_cast<BlockRunsOptions&>(options) = common;
        options.box.stopKey = stopKey;
        return visitSampleType(dataset.values.type(), [&]<class T>() {
            return makeCurvilinearRuns(options, *dataset.positions, LatticeSamples(dataset.values.as<T>(), weights),
                                       runs, refining);
        });
    };
    return buildInBlocks(dataset, build, target, progress);
}

Result<BuildReport> buildCurvilinear(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                     const Progress& progress)
{
    const auto cells = blocksFor(dataset, refinement, target);
    if (!cells)
        return cells.error();
    const Result<BuildWeights> weights =
        BuildWeights::make(refinement, dataset, *cells > 0, target.workFolder, progress);
    if (!weights)
        return weights.error();
    const BuildThresholds thresholds{refinement.error, refinement.warping, refinement.orderedBy};
    if (const Status possible = checkThresholds(thresholds, dataset); !possible)
        return possible.error();
    if (refinement.paperSelection && refinement.orderedBy != OrderedBy::Both)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The paper's selection compares error and warping, so a build cannot be ordered by "
                                  "one of them alone. Choose the normalised selection, or order by both.")};
    if (refinement.inSpace && (refinement.paperSelection || refinement.orderedBy != OrderedBy::Both))
        return Error{ErrorKind::WrongUsage,
                     Message::say("To keep the error in space, a build must be ordered by error and warping, with the "
                                  "normalised selection. Leave out the other choice.")};
    const ThresholdKey key = thresholdKey(thresholds, dataset);
    if (*cells > 0)
        return refineCurvilinearInBlocks(dataset, key, *cells, weights->all(), target, progress);
    CurvilinearRefinementOptions options;
    options.valueExtent = key.valueExtent;
    options.positionExtent = key.positionExtent;
    options.warpingWeight = key.warpingWeight;
    options.stopKey = key.stopKey.value_or(key.leastKey);
    options.inSpace = refinement.inSpace;
    options.selection = refinement.paperSelection ? CurvilinearSelection::Paper : CurvilinearSelection::Normalised;
    const auto state = buildState(
        target, dataset, "refinement",
        std::array{options.warpingWeight, options.stopKey, double(options.inSpace), double(options.selection)},
        weights->all());
    if (!state)
        return state.error();
    options.state = state->get();
    const Result<CurvilinearRefinementResult> result =
        visitSampleType(dataset.values.type(), [&]<class T>() -> Result<CurvilinearRefinementResult> {
            return refineCurvilinear(dataset.lattice.size, *dataset.positions,
                                     LatticeSamples(dataset.values.as<T>(), weights->all()), options, target.history,
                                     progress);
        });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, result->inverted, result->degenerate};
}

Result<BuildReport> buildScattered(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                   const Progress& progress)
{
    const Result<std::vector<float>> weights = pointWeights(refinement.weighting, dataset, progress);
    if (!weights)
        return weights.error();
    std::vector<double> values(dataset.pointCount());
    for (std::uint64_t point = 0; point < values.size(); ++point) {
        values[point] = dataset.values.at(point);
        if (!std::isfinite(values[point]) || !dataset.position(point).allFinite())
            return Error{
                ErrorKind::BadInput,
                Message::say("Point %1 of '%2' has a position or a value that is not a finite number. Leave it out.",
                             point, dataset.source.name)};
    }
    const double stopError = refinement.error / 100 * dataset.values.range().extent();
    const auto state = buildState(target, dataset, "refinement", std::array{stopError}, *weights);
    if (!state)
        return state.error();
    const Result<ScatteredRefinementResult> result =
        refineScattered({*dataset.positions, values, *weights}, stopError, target.history, progress, state->get());
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

/// A good compromise: the mesh has a few percent more sites than a whole one, and its memory stays in the cache.
constexpr std::uint32_t defaultCells = 32;
/// The most that refining a lattice as a whole takes, history included.
constexpr std::uint64_t bytesAPoint = 600;
/// Beyond that many points blocks are quicker by more than their sites cost (docs/lab/performance.md).
constexpr std::uint64_t mostPointsAsWhole = 1 << 22;
/// Merging reads the runs of all blocks at once, each through a buffer.
constexpr std::uint64_t mostBlocks = 1 << 17;

bool isLarge(std::uint64_t points, std::uint64_t usableBytes)
{
    return points > mostPointsAsWhole || (usableBytes > 0 && points * bytesAPoint > usableBytes / 2);
}

bool fitsAsWhole(const Lattice& lattice, std::uint64_t usableBytes)
{
    return !isLarge(lattice.pointCount(), usableBytes) && latticeMetric(lattice.size, lattice.spacing).ok();
}

std::string latticeSizeText(const Lattice& lattice)
{
    return std::to_string(lattice.size[0]) + " x " + std::to_string(lattice.size[1]) + " x " +
           std::to_string(lattice.size[2]);
}

} // namespace

Status checkRefinement(const Dataset& dataset)
{
    constexpr std::uint64_t mostPoints = 1ull << 32;
    switch (dataset.domain) {
    case DomainClass::RegularLattice:
    case DomainClass::Curvilinear:
        if (dataset.lattice.pointCount() <= mostPoints)
            return {};
        return Error{
            ErrorKind::BadInput,
            Message::say("A lattice of %1 points is too large: a model holds at most 4294967296. Crop or subsample it.",
                         latticeSizeText(dataset.lattice))};
    case DomainClass::Scattered:
        if (dataset.pointCount() >= 4)
            return {};
        return Error{ErrorKind::BadInput, Message::say("A tetrahedral mesh needs four points or more.")};
    case DomainClass::Irregular: break;
    }
    if (dataset.convex)
        return {};
    return Error{ErrorKind::BadInput,
                 Message::say("The domain of this mesh is not convex, and refinement would fill what its boundary "
                              "leaves out. Decimation keeps it.")};
}

namespace {

/// Of a rectilinear grid, which has as many sites as points if nothing ends the build before.
Status checkMemoryOfPoints(const Refinement& refinement, const Dataset& dataset, std::uint64_t usableBytes)
{
    constexpr std::uint64_t bytesAPoint = 150, bytesASite = 700;
    const std::uint64_t need = dataset.pointCount() * (bytesAPoint + (refinement.error > 0 ? 0 : bytesASite));
    if (usableBytes == 0 || need <= usableBytes)
        return {};
    return Error{
        ErrorKind::OutOfResource,
        Message::say("Refining a rectilinear grid of %1 points in physical space takes about %2 of memory, and "
                     "this machine has %3. Refine it in computational space, as a curvilinear grid, or take a "
                     "region of it or fewer samples.",
                     dataset.pointCount(), neededBytesText(need), neededBytesText(usableBytes))};
}

} // namespace

Result<Dataset> takenFor(const Refinement& refinement, const Dataset& dataset, const Progress&)
{
    const bool isGrid = dataset.domain == DomainClass::Curvilinear;
    if (refinement.computational && !(isGrid && dataset.convex))
        return Error{
            ErrorKind::WrongUsage,
            Message::say("Only rectilinear grids can be refined in one space or the other, and '%1' is not one.",
                         dataset.source.name)};
    const bool inIndices = isGrid && (!dataset.convex || refinement.computational);
    const bool warps = refinement.warping > 0 || refinement.paperSelection || refinement.orderedBy != OrderedBy::Both;
    const bool hasBlocks = refinement.block.value_or(0) > 0;
    if (refinement.inSpace && !inIndices)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("'%1' is refined in the space where its points lie, so its error is the error in space. "
                         "Leave this choice out.",
                         dataset.source.name)};
    if (isGrid && !inIndices && (warps || hasBlocks))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is a rectilinear grid, which is refined in physical space: there it has no "
                                  "warping and no blocks. Leave these out, or refine it in computational space.",
                                  dataset.source.name)};
    if (!inIndices && warps)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("When refined, '%1' has no warping. Leave out the options about it.", dataset.source.name)};
    if (!isOnLattice(dataset.domain) && hasBlocks)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is not a grid, so it has no blocks. Leave them out.", dataset.source.name)};
    if (inIndices || !dataset.convex || dataset.domain == DomainClass::RegularLattice)
        return dataset;
    if (isGrid)
        if (const Status enough = checkMemoryOfPoints(refinement, dataset, usableBytes()); !enough)
            return enough.error();
    return asPoints(dataset);
}

bool keepsErrorInSpace(std::uint64_t points)
{
    constexpr std::uint64_t mostPoints = 1'000'000;
    return points <= mostPoints;
}

bool takesBlocks(const std::optional<std::uint32_t>& block, std::uint64_t points, std::uint64_t usableBytes)
{
    return block ? *block > 0 : isLarge(points, usableBytes);
}

Result<std::uint32_t> chooseBlocks(const std::optional<std::uint32_t>& block, const Lattice& lattice,
                                   std::uint64_t usableBytes)
{
    if (!block)
        return fitsAsWhole(lattice, usableBytes) ? 0 : defaultCells;
    if (*block == 0)
        return 0u;
    if (const std::uint64_t count = blockCount(lattice, *block); count > mostBlocks)
        return Error{
            ErrorKind::WrongUsage,
            Message::say("Blocks of %1 cells cut this dataset into %2 pieces; the limit is %3. Choose larger blocks.",
                         *block, count, mostBlocks)};
    return *block;
}

Result<BuildReport> buildInto(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                              const Progress& progress)
{
    if (const Status possible = checkRefinement(dataset); !possible)
        return possible.error();
    switch (dataset.domain) {
    case DomainClass::Curvilinear: return buildCurvilinear(dataset, refinement, target, progress);
    case DomainClass::Scattered:
        return guarded(noMemoryForPoints, [&] { return buildScattered(dataset, refinement, target, progress); });
    case DomainClass::RegularLattice: break;
    case DomainClass::Irregular:
        return Error{ErrorKind::WrongUsage,
                     Message::say("Refinement uses the points of a convex mesh, and this is the mesh itself.")};
    }
    return buildLattice(dataset, refinement, target, progress);
}

} // namespace tetra
