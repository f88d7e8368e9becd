// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/builders/refinement/lattice_blocks.h"

#include "core/base/checksum.h"
#include "core/base/number_text.h"
#include "core/base/work_folder.h"
#include "core/model/blocks/lattice_runs.h"
#include "core/model/blocks/merged_model.h"

#include <cmath>

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

std::string gigabytes(std::uint64_t bytes)
{
    return formatNumber(std::ceil(static_cast<double>(bytes) / 1e8) / 10) + " GB";
}

/// Refuses the build as soon as it shows that the disk has no room for it.
class DiskCheck {
public:
    DiskCheck(std::filesystem::path folder, SampleType type) : folder_(std::move(folder)), type_(type) {}

    Status operator()(const RunTotals& soFar, const RunTotals& expected)
    {
        const PlannedCounts counts{static_cast<std::uint32_t>(std::min<std::uint64_t>(expected.sites, 0xffffffff)),
                                   expected.tetrahedra};
        const std::uint64_t numbers = expected.sites * sizeof(std::uint32_t);
        const std::uint64_t needed = expected.fileBytes + numbers + PlannedModelWriter::expectedBytes(counts, type_);
        const std::uint64_t there = soFar.fileBytes;
        const std::uint64_t free = freeDiskBytes(folder_);
        if (free == 0 || needed <= there || needed - there <= free)
            return {};
        return Error{ErrorKind::CannotWrite, "The build needs about " + gigabytes(needed) + " on the disk of '" +
                                                 folder_.parent_path().string() + "', and " + gigabytes(free + there) +
                                                 " are free. Free some space, choose another disk or ask for a larger "
                                                 "error."};
    }

private:
    std::filesystem::path folder_;
    SampleType type_;
};

Result<PlannedCounts> makeAndMerge(const Dataset& dataset, const LatticeRunsOptions& options,
                                   const LatticeBlocks& blocks, const BuildTarget& target, const Progress& progress)
{
    RunFiles runs(target.workFolder, fingerprintOf(dataset, options.box, blocks), options.division.count());
    const Status made = visitSampleType(dataset.values.type(), [&]<class T>() {
        return makeLatticeRuns(options, LatticeSamples(dataset.values.as<T>(), blocks.weights), runs,
                               progress.part(0, refinedShare));
    });
    if (!made)
        return made.error();
    const PlannedModelOpener open = [&](const PlannedCounts& counts) {
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
    options.check = DiskCheck(target.workFolder, dataset.values.type());
    const Result<PlannedCounts> counts = makeAndMerge(dataset, options, blocks, target, progress);
    if (!counts)
        return counts.error();
    return BuildReport{counts->sites, counts->tetrahedra, 0, 0};
}

} // namespace tetra
