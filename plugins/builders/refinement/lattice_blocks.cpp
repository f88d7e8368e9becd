// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/lattice_blocks.h"

#include "core/base/checksum.h"
#include "core/base/text.h"
#include "core/base/work_folder.h"
#include "core/history/blocks/lattice_runs.h"
#include "core/history/blocks/merged_model.h"
#include "plugins/builders/refinement/disk_need.h"

#include <string>

namespace tetra {

namespace {

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
        told_ = " (" + textOf(need) + ")";
        const std::uint64_t free = freeDiskBytes(workFolder_);
        if (free == 0) // not known
            return {};
        return checkRoom(need, soFar.fileBytes, free, workFolder_.parent_path());
    }

    /// `progress`, whose activities tell the need, too.
    Progress telling(const Progress& progress) const
    {
        return progress.withCallback([this, progress](double fraction, std::string_view activity) {
            progress.report(fraction, std::string(activity) + told_);
        });
    }

private:
    std::filesystem::path workFolder_;
    SampleType type_;
    std::string told_;
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
    const PlannedModelOpener open = [&](const FixedCounts& counts) {
        return target.planned(counts, {{"block", std::to_string(blocks.cells)}});
    };
    return mergeRuns(runs, target.workFolder, open, progress.part(refinedShare, 1));
}

} // namespace

Result<BuildReport> buildLatticeInBlocks(const Dataset& dataset, const LatticeBlocks& blocks, BuildTarget& target,
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

} // namespace tetra
