// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/build.h>

#include "core/base/checksum.h"
#include "core/base/guarded.h"
#include "core/base/work_folder.h"
#include "core/build/disk_need.h"
#include "core/build/thresholds.h"
#include "core/history/blocks/lattice_runs.h"
#include "core/history/blocks/merged_model.h"
#include "core/refine/curvilinear/curvilinear_refinement.h"
#include "core/refine/free/scattered_refinement.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "core/refine/lattice/packed_lattice.h"

#include <cmath>
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
    const Result<LatticeRefinementResult> result = visitSampleType(dataset.values.type(), [&]<class T>() {
        return refineLattice(options, LatticeSamples(dataset.values.as<T>(), weights), target.history, progress);
    });
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

// And in blocks, out of core (R10, B6): the blocks are refined one by one, and merged into one model.

/// What is to be built.
struct LatticeBlocks {
    double stopError = 0;           ///< in units of the values
    std::uint32_t cells = 0;        ///< along an edge of a block
    std::span<const float> weights; ///< one a point, or none
};

/// Refining takes most of the time, merging the rest.
constexpr double refinedShare = 0.7;

/// Stands for all that a run depends on, so that one of another build is not taken for one of this.
std::uint64_t fingerprintOf(const Dataset& dataset, const LatticeBoxOptions& box, const LatticeBlocks& blocks)
{
    std::string text = "TAn " TAN_VERSION " lattice runs\n";
    const auto add = [&text](const std::string& value) { text += value + '\n'; };
    add(std::to_string(dataset.source.hash));
    add(std::string(sampleTypeName(dataset.values.type())));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        add(std::to_string(box.latticeSize[axis]));
        add(std::to_string(box.metric[axis]));
    }
    add(formatNumber(box.valueExtent));
    add(formatNumber(box.stopError));
    add(std::to_string(blocks.cells));
    add(std::to_string(checksum(std::as_bytes(blocks.weights))));
    return checksum(std::as_bytes(std::span(text)));
}

/// Tells what the build will take on the disk as soon as that shows, and refuses it if there is no room.
class DiskCheck {
public:
    DiskCheck(std::filesystem::path workFolder, SampleType type) : workFolder_(std::move(workFolder)), type_(type) {}

    Status check(const RunTotals& soFar, const RunTotals& expected)
    {
        const DiskNeed need = diskNeed(expected, type_);
        told_ = textOf(need);
        const std::uint64_t free = freeDiskBytes(workFolder_);
        if (free == 0) // not known
            return {};
        return checkRoom(need, soFar.fileBytes, free, workFolder_.parent_path());
    }

    /// `progress`, whose activities tell the need, too.
    Progress telling(const Progress& progress) const
    {
        return progress.withCallback([this, progress](double fraction, const Message& activity) {
            progress.report(fraction, told_.empty() ? activity : Message::say("%1 (%2)", activity, told_));
        });
    }

private:
    std::filesystem::path workFolder_;
    SampleType type_;
    Message told_;
};

Result<FixedCounts> makeAndMerge(const Dataset& dataset, LatticeRunsOptions options, const LatticeBlocks& blocks,
                                 const BuildTarget& target, const Progress& progress)
{
    DiskCheck disk(target.workFolder, dataset.values.type());
    options.check = [&](const RunTotals& soFar, const RunTotals& expected) { return disk.check(soFar, expected); };
    const Progress refining = disk.telling(progress.part(0, refinedShare));
    RunFiles runs(target.workFolder, fingerprintOf(dataset, options.box, blocks), options.division.count());
    const Status made = visitSampleType(dataset.values.type(), [&]<class T>() {
        return makeLatticeRuns(options, LatticeSamples(dataset.values.as<T>(), blocks.weights), runs, refining);
    });
    if (!made)
        return made.error();
    const ModelFileOpener open = [&](const FixedCounts& counts) {
        auto writer = target.ofFixedSize(counts, {{"block", std::to_string(blocks.cells)}});
        if (writer)
            (*writer)->setBlocks(options.division.blockCells());
        return writer;
    };
    return mergeRuns(runs, target.workFolder, open, progress.part(refinedShare, 1));
}

Result<BuildReport> refineInBlocks(const Dataset& dataset, const LatticeBlocks& blocks, BuildTarget& target,
                                   const Progress& progress)
{
    LatticeRunsOptions options;
    options.division = BlockDivision(dataset.lattice.size, blocks.cells);
    const auto metric = latticeMetric(options.division.box(0).size, dataset.lattice.spacing);
    if (!metric)
        return metric.error();
    options.box.latticeSize = dataset.lattice.size;
    options.box.metric = *metric;
    options.box.valueExtent = dataset.values.range().extent();
    options.box.stopError = blocks.stopError;
    options.reuseIntact = target.resume;
    options.samplesIntact = [&dataset] { return dataset.checkIntact(); };
    const Result<FixedCounts> counts = makeAndMerge(dataset, options, blocks, target, progress);
    if (!counts)
        return counts.error();
    return BuildReport{counts->sites, counts->tetrahedra, 0, 0};
}

Result<BuildReport> buildLattice(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                 const Progress& progress)
{
    const double stopError = refinement.error / 100 * dataset.values.range().extent();
    const auto cells = chooseBlocks(refinement.block, dataset.lattice, usableBytes());
    if (!cells)
        return cells.error();
    if (*cells > 0 && !target.ofFixedSize)
        return Error{ErrorKind::WrongUsage,
                     Message::say("Blocks cannot be built into this target. Set the block to \"none\".")};
    const Result<std::vector<float>> weights = pointWeights(refinement.weighting, dataset, progress);
    if (!weights)
        return weights.error();
    if (*cells == 0)
        return refineAsWhole(dataset, stopError, *weights, target, progress);
    return refineInBlocks(dataset, {stopError, *cells, *weights}, target, progress);
}

Result<BuildReport> buildCurvilinear(const Dataset& dataset, const Refinement& refinement, BuildTarget& target,
                                     const Progress& progress)
{
    const Result<std::vector<float>> weights = pointWeights(refinement.weighting, dataset, progress);
    if (!weights)
        return weights.error();
    CurvilinearRefinementOptions options;
    const BuildThresholds thresholds{refinement.error, refinement.warping, refinement.orderedBy};
    if (const Status possible = checkThresholds(thresholds, dataset); !possible)
        return possible.error();
    if (refinement.paperSelection && refinement.orderedBy != OrderedBy::Both)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The paper's selection compares error and warping, so a build cannot be ordered by "
                                  "one of them alone. Take the normalised selection, or order by both.")};
    const ThresholdKey key = thresholdKey(thresholds, dataset);
    options.valueExtent = key.valueExtent;
    options.positionExtent = key.positionExtent;
    options.warpingWeight = key.warpingWeight;
    options.stopKey = key.stopKey.value_or(key.leastKey);
    options.selection = refinement.paperSelection ? CurvilinearSelection::Paper : CurvilinearSelection::Normalised;
    options.blockEdge = refinement.block.value_or(0);
    const Result<CurvilinearRefinementResult> result =
        visitSampleType(dataset.values.type(), [&]<class T>() -> Result<CurvilinearRefinementResult> {
            return refineCurvilinear(dataset.lattice.size, *dataset.positions,
                                     LatticeSamples(dataset.values.as<T>(), *weights), options, target.history,
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
    const Result<ScatteredRefinementResult> result =
        refineScattered({*dataset.positions, values, *weights}, stopError, target.history, progress);
    if (!result)
        return result.error();
    return BuildReport{result->sites, result->tetrahedra, 0, 0};
}

/// A good compromise: the mesh has a few percent more sites than a whole one, and its memory stays in the cache.
constexpr std::uint32_t defaultCells = 32;
/// The most that refining a lattice as a whole takes, history included.
constexpr std::uint64_t bytesAPoint = 600;
/// Beyond that many points blocks are quicker by more than their sites cost (docs/performance.md).
constexpr std::uint64_t mostPointsAsWhole = 1 << 22;
/// Each block is a file until they are merged.
constexpr std::uint64_t mostBlocks = 1 << 17;

bool isLarge(std::uint64_t points, std::uint64_t usableBytes)
{
    return points > mostPointsAsWhole || (usableBytes > 0 && points * bytesAPoint > usableBytes / 2);
}

bool fitsAsWhole(const Lattice& lattice, std::uint64_t usableBytes)
{
    return !isLarge(lattice.pointCount(), usableBytes) && latticeMetric(lattice.size, lattice.spacing).ok();
}

std::uint64_t blockCount(const Lattice& lattice, std::uint32_t cells)
{
    std::uint64_t count = 1;
    for (const std::uint32_t size : lattice.size)
        count *= (size - 2) / cells + 1;
    return count;
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
        if (dataset.lattice.pointCount() <= mostPoints)
            return {};
        return Error{
            ErrorKind::BadInput,
            Message::say("A lattice of %1 points is too large: a model holds at most 4294967296. Crop or subsample it.",
                         latticeSizeText(dataset.lattice))};
    case DomainClass::Curvilinear:
        if (const auto metric = latticeMetric(dataset.lattice.size, {1, 1, 1}); !metric)
            return Error{ErrorKind::BadInput, metric.error().message};
        return {};
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
        return Error{ErrorKind::WrongUsage,
                     Message::say("Only rectilinear grids can be refined in one space or the other, and '%1' is none.",
                                  dataset.source.name)};
    const bool inIndices = isGrid && (!dataset.convex || refinement.computational);
    const bool warps = refinement.warping > 0 || refinement.paperSelection || refinement.orderedBy != OrderedBy::Both;
    const bool hasBlocks = refinement.block.value_or(0) > 0;
    if (isGrid && !inIndices && (warps || hasBlocks))
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is a rectilinear grid, which is refined in physical space: there it has no "
                                  "warping and no blocks. Leave these out, or refine it in computational space.",
                                  dataset.source.name)};
    if (!inIndices && warps)
        return Error{ErrorKind::WrongUsage,
                     Message::say("Refined, '%1' has no warping. Leave out what is asked of it.", dataset.source.name)};
    if (!isOnLattice(dataset.domain) && hasBlocks)
        return Error{ErrorKind::WrongUsage,
                     Message::say("'%1' is no grid, so it has no blocks. Leave them out.", dataset.source.name)};
    if (inIndices || !dataset.convex || dataset.domain == DomainClass::RegularLattice)
        return dataset;
    if (isGrid)
        if (const Status enough = checkMemoryOfPoints(refinement, dataset, usableBytes()); !enough)
            return enough.error();
    return asPoints(dataset);
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
            Message::say("Blocks of %1 cells cut this dataset into %2 pieces; %3 are the most. Choose larger blocks.",
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
                     Message::say("Refinement takes the points of a convex mesh, and this is the mesh itself.")};
    }
    return buildLattice(dataset, refinement, target, progress);
}

} // namespace tetra
