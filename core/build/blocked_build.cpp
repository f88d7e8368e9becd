// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/build/blocked_build.h"

#include "core/base/folder.h"
#include "core/base/progress.h"
#include "core/base/work_folder.h"
#include "core/build/build_state.h"
#include "core/build/disk_need.h"
#include "core/history/blocks/merged_model.h"

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <utility>

namespace tetra {

namespace {

/// How much of the time has passed when all blocks were refined coarsely, and when they are refined; merging takes the
/// rest.
constexpr double coarseShare = 0.06;
constexpr double refinedShare = 0.7;

/// Tells what the build will take on the disk as soon as that shows, and refuses it if there is no room.
class DiskCheck {
public:
    /// What is told is of the model and the work files, or of these alone.
    enum class Of { Build, WorkFiles };

    DiskCheck(std::filesystem::path workFolder, const Dataset& dataset, Of of)
        : workFolder_(std::move(workFolder)), type_(dataset.values.type()), domain_(dataset.domain), of_(of)
    {
    }

    Status check(const RunTotals& soFar, const RunTotals& expected)
    {
        const DiskNeed need =
            of_ == Of::WorkFiles ? DiskNeed{0, expected.fileBytes} : diskNeed(expected, type_, domain_);
        tell(textOf(need));
        const std::uint64_t free = freeDiskBytes(workFolder_);
        if (free == 0) // not known
            return {};
        return checkRoom(need, soFar.fileBytes, free, workFolder_.parent_path());
    }

    /// `progress`, whose activities tell the need, too.
    Progress telling(const Progress& progress) const
    {
        return progress.withCallback([this, progress](double fraction, const Message& activity) {
            const Message told = this->told();
            progress.report(fraction, told.empty() ? activity : Message::say("%1 (%2)", activity, told));
        });
    }

private:
    void tell(Message need)
    {
        const std::lock_guard lock(mutex_);
        told_ = std::move(need);
    }
    Message told() const
    {
        const std::lock_guard lock(mutex_);
        return told_;
    }

    std::filesystem::path workFolder_;
    SampleType type_;
    DomainClass domain_;
    Of of_;
    mutable std::mutex mutex_; ///< one block is counted while others report
    Message told_;
};

class BuildInBlocks {
public:
    BuildInBlocks(const Dataset& dataset, const BlockedBuild& build, const BuildTarget& target)
        : dataset_(dataset), build_(build), target_(target)
    {
        options_.division = BlockDivision(dataset.lattice.size, build.cells);
        options_.resumes = target.resume;
        options_.samplesIntact = [this] { return dataset_.checkIntact(); };
    }

    Result<BuildReport> run(const Progress& progress);

private:
    Status refineCoarsely(const Progress& progress);
    Status refine(const Progress& progress);
    Status makeChecked(const std::filesystem::path& folder, DiskCheck::Of of, const Progress& progress);
    Result<BuildReport> refinePart(const PartNumber& part, const Progress& progress);
    Result<BuildReport> mergeParts(const Progress& progress);
    Result<BuildReport> merge(const RunFiles& runs, const Progress& progress) const;
    void show(const RunFiles& runs, const Progress& progress) const;
    std::unique_ptr<RunFiles> runsOf(const std::filesystem::path& folder, double stopKey) const;
    std::uint64_t fingerprint(double stopKey) const;
    bool watched() const { return target_.preview || target_.keepWhenCancelled != nullptr; }
    bool kept() const { return target_.keepWhenCancelled != nullptr && *target_.keepWhenCancelled; }

    const Dataset& dataset_;
    const BlockedBuild& build_;
    const BuildTarget& target_;
    BlockRunsOptions options_;
    std::unique_ptr<RunFiles> coarse_; ///< the finest that are complete
    std::unique_ptr<RunFiles> runs_;
};

Result<BuildReport> BuildInBlocks::run(const Progress& progress)
{
    if (target_.part && target_.part->merges)
        return mergeParts(progress);
    if (target_.part)
        return refinePart({target_.part->number, target_.part->count}, progress);
    if (const Status claimed = claimWork(target_.workFolder, fingerprint(build_.stopKey)); !claimed)
        return claimed.error();
    const double begun = watched() ? coarseShare : 0;
    Status refined = watched() ? refineCoarsely(progress.part(0, begun)) : Status();
    if (refined)
        refined = refine(progress.part(begun, refinedShare));
    const bool isKept = !refined && refined.error().kind == ErrorKind::Cancelled && kept() && coarse_;
    if (!refined && !isKept)
        return refined.error();
    const Progress merging = untilGivenUp(progress.part(refinedShare, 1), [this] { return kept(); });
    auto report = merge(isKept ? *coarse_ : *runs_, merging);
    if (report)
        report->stoppedEarly = isKept;
    return report;
}

Status BuildInBlocks::refineCoarsely(const Progress& progress)
{
    const SiteDensity density = SiteDensity::of(dataset_, progress.part(0, 0));
    std::filesystem::path last;
    double begun = 0;
    int number = 0;
    for (const double error : coarseErrors(density, build_.stopKey / build_.keyExtent)) {
        const double stopKey = error * build_.keyExtent;
        const std::filesystem::path folder = target_.workFolder / ("coarse-" + std::to_string(number++));
        std::error_code problem;
        std::filesystem::create_directory(folder, problem); // without it the first run says what is wrong
        const Progress own = progress.part(begun, (1 + begun) / 2);
        const Progress telling = own.withCallback([own](double fraction, const Message&) {
            own.report(fraction, Message::marked("Refining all blocks coarsely"));
        });
        auto runs = runsOf(folder, stopKey);
        if (const Status opened = runs->openOwn(target_.resume, telling.withCallback({})); !opened)
            return opened;
        if (const Status made = build_.makeRuns(options_, stopKey, *runs, telling); !made)
            return made;
        if (target_.preview)
            show(*runs, progress);
        coarse_ = std::move(runs);
        if (!last.empty()) {
            removeContent(last, {});
            std::filesystem::remove(last, problem);
        }
        last = folder;
        begun = (1 + begun) / 2;
    }
    return {};
}

Status BuildInBlocks::refine(const Progress& progress)
{
    constexpr double openedShare = 0.05;
    runs_ = runsOf(target_.workFolder, build_.stopKey);
    if (const Status opened = runs_->openOwn(target_.resume, progress.part(0, openedShare)); !opened)
        return opened;
    return makeChecked(target_.workFolder, DiskCheck::Of::Build, progress.part(openedShare, 1));
}

/// Makes the runs that are not there, as long as the disk has room.
Status BuildInBlocks::makeChecked(const std::filesystem::path& folder, DiskCheck::Of of, const Progress& progress)
{
    DiskCheck disk(folder, dataset_, of);
    BlockRunsOptions checked = options_;
    checked.check = [&](const RunTotals& soFar, const RunTotals& expected) { return disk.check(soFar, expected); };
    return build_.makeRuns(checked, build_.stopKey, *runs_, disk.telling(progress));
}

/// What the report counts of a part: points on faces of blocks as often as there are blocks that have them.
Result<BuildReport> BuildInBlocks::refinePart(const PartNumber& part, const Progress& progress)
{
    constexpr double openedShare = 0.05;
    runs_ = runsOf(target_.part->folder, build_.stopKey);
    if (const Status opened = runs_->openPart(part, progress.part(0, openedShare)); !opened)
        return opened.error();
    const BlockShare share = shareOf(part, runs_->blockCount());
    if (!runs_->partIsFinished()) {
        options_.part = part;
        options_.waits = target_.part->waits;
        if (const Status made =
                makeChecked(target_.part->folder, DiskCheck::Of::WorkFiles, progress.part(openedShare, 1));
            !made)
            return made.error();
        if (const Status finished = runs_->finishPart(); !finished)
            return finished.error();
    }
    BuildReport report;
    for (std::uint32_t block = share.first; block < share.end; ++block) {
        report.sites += runs_->header(block).siteCount;
        report.tetrahedra += runs_->header(block).tetrahedronCount;
    }
    return report;
}

Result<BuildReport> BuildInBlocks::mergeParts(const Progress& progress)
{
    constexpr double openedShare = 0.2;
    runs_ = runsOf(target_.part->folder, build_.stopKey);
    if (const Status opened = runs_->openParts(progress.part(0, openedShare)); !opened)
        return opened.error();
    return merge(*runs_, progress.part(openedShare, 1));
}

Result<BuildReport> BuildInBlocks::merge(const RunFiles& runs, const Progress& progress) const
{
    const HistoryTraits traits{.warpingWeight = build_.warpingWeight, .blockCells = options_.division.blockCells()};
    const ModelFileOpener open = [&](const FixedCounts& counts) {
        auto writer = target_.ofFixedSize(counts, {{"block", std::to_string(build_.cells)}});
        if (writer)
            (*writer)->setTraits(traits);
        return writer;
    };
    const Result<FixedCounts> counts = mergeRuns(runs, target_.workFolder, open, progress);
    if (!counts)
        return counts.error();
    BuildReport report{counts->sites, counts->tetrahedra, 0, 0};
    for (std::uint32_t block = 0; block < runs.blockCount(); ++block) {
        report.inverted += runs.header(block).inverted;
        report.degenerate += runs.header(block).degenerate;
    }
    return report;
}

/// What cannot be shown is not missed: it may be too large to be looked at.
void BuildInBlocks::show(const RunFiles& runs, const Progress& progress) const
{
    const RunUnits units{build_.valueExtent, build_.diagonal, build_.warpingWeight};
    target_.preview([&](HistorySink& history) {
        return handMesh(runs, target_.workFolder, units, history, progress.withCallback({}));
    });
}

std::unique_ptr<RunFiles> BuildInBlocks::runsOf(const std::filesystem::path& folder, double stopKey) const
{
    return std::make_unique<RunFiles>(folder, fingerprint(stopKey), options_.division.count());
}

std::uint64_t BuildInBlocks::fingerprint(double stopKey) const
{
    std::vector<double> numbers{stopKey, build_.warpingWeight, build_.valueExtent, build_.diagonal,
                                double(build_.cells)};
    numbers.insert(numbers.end(), build_.others.begin(), build_.others.end());
    return buildFingerprint("runs", dataset_, numbers, build_.weights);
}

} // namespace

std::vector<double> coarseErrors(const SiteDensity& density, double finalError)
{
    // In sites for each point of the dataset: refining takes some time for each point, however few of them enter.
    constexpr double passCost = 1.0 / 30, budget = 1.0 / 16;
    const auto cost = [&](double error) { return density.share(error) + passCost; };
    std::vector<double> errors{1};
    double finest = 1;
    for (double error = 0.5; error > 2 * finalError && cost(error) <= budget * cost(finalError); error /= 2)
        finest = error;
    if (finest < 1)
        errors.push_back(finest);
    return errors;
}

std::uint64_t blockCount(const Lattice& lattice, std::uint32_t cells)
{
    std::uint64_t count = 1;
    for (const std::uint32_t size : lattice.size)
        count *= (size - 2) / cells + 1;
    return count;
}

Result<BuildReport> buildInBlocks(const Dataset& dataset, const BlockedBuild& build, const BuildTarget& target,
                                  const Progress& progress)
{
    return BuildInBlocks(dataset, build, target).run(progress);
}

} // namespace tetra
