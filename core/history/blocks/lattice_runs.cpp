// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/lattice_runs.h"

#include "core/base/guarded.h"
#include "core/base/progress.h"

#include <tan/base.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <vector>

namespace tetra {

namespace {

/// So many blocks, spread over the lattice, come first: what they came to tells what all will.
constexpr std::uint32_t blocksSampled = 64;

std::uint64_t pointsOf(const LatticeBox& box)
{
    return std::uint64_t(box.size[0]) * box.size[1] * box.size[2];
}

/// A sample of all blocks, then the others as they lie.
std::vector<std::uint32_t> orderOfWork(std::uint32_t blocks)
{
    std::vector<std::uint32_t> order;
    std::vector<bool> taken(blocks);
    const std::uint32_t sampled = std::min(blocksSampled, blocks);
    for (std::uint32_t i = 0; i < sampled; ++i) {
        // Multiples of the golden ratio fill an interval evenly, however many they are.
        const double place = 0.6180339887498949 * (i + 1);
        auto block = static_cast<std::uint32_t>((place - static_cast<std::uint32_t>(place)) * blocks);
        while (taken[block])
            block = (block + 1) % blocks;
        taken[block] = true;
        order.push_back(block);
    }
    for (std::uint32_t block = 0; block < blocks; ++block)
        if (!taken[block])
            order.push_back(block);
    return order;
}

class RunMaker {
public:
    RunMaker(const LatticeRunsOptions& options, const LatticeSamples& samples, const RunFiles& runs,
             const Progress& progress)
        : options_(options), samples_(samples), runs_(runs), progress_(progress), order_(orderOfWork(runs.blockCount()))
    {
        for (std::uint32_t block = 0; block < runs.blockCount(); ++block)
            allPoints_ += pointsOf(options.division.box(block));
        points_.emplace(progress, static_cast<double>(allPoints_), Message::marked("Refining the blocks"));
    }

    Status run();

private:
    Status work();
    Status make(std::uint32_t block, LatticeRefiner& refiner, BlockRunRecorder& recorder);
    Status account(std::uint32_t block);

    const LatticeRunsOptions& options_;
    const LatticeSamples& samples_;
    const RunFiles& runs_;
    const Progress& progress_;
    std::vector<std::uint32_t> order_;
    std::uint64_t allPoints_ = 0;
    std::atomic<std::uint32_t> next_ = 0;
    FirstFailure failure_;
    std::optional<SharedProgress> points_;

    std::mutex mutex_;
    RunTotals totals_;
    std::uint32_t finished_ = 0;
};

Status RunMaker::run()
{
    const int workers = tbb::this_task_arena::max_concurrency();
    tbb::parallel_for(
        0, workers, [this](int) { failure_.run([this] { return work(); }); }, tbb::simple_partitioner());
    return failure_.status();
}

Status RunMaker::work()
{
    LatticeRefiner refiner;
    const auto& size = options_.box.latticeSize;
    BlockRunRecorder recorder(std::uint64_t(size[0]) * size[1] * size[2], options_.box.valueExtent);
    for (std::uint32_t i = next_++; i < order_.size() && !failure_.happened(); i = next_++) {
        const std::uint32_t block = order_[i];
        if (progress_.cancelled())
            return cancelledError(Message::marked("The build"));
        if (!(options_.reuseIntact && runs_.intact(block))) {
            if (const Status made = make(block, refiner, recorder); !made)
                return made;
        } else {
            points_->done(static_cast<double>(pointsOf(options_.division.box(block))));
        }
        if (const Status right = account(block); !right)
            return right;
    }
    return {};
}

Status RunMaker::make(std::uint32_t block, LatticeRefiner& refiner, BlockRunRecorder& recorder)
{
    LatticeBoxOptions box = options_.box;
    box.box = options_.division.box(block);
    box.centreAtOrigin = !options_.division.odd(block);
    const auto points = static_cast<double>(pointsOf(box.box));
    const Progress own = failure_.watching(progress_).withCallback(points_->piece(points));
    recorder.start();
    const Result<LatticeRefinementResult> refined = refiner.refine(box, samples_, recorder, own);
    if (!refined)
        return refined.error();
    own.report(1, {});
    if (options_.samplesIntact)
        if (const Status intact = options_.samplesIntact(); !intact)
            return intact;
    return recorder.write(runs_.path(block), runs_.fingerprint(), block);
}

Status RunMaker::account(std::uint32_t block)
{
    const Result<BlockRunHeader> header = runs_.readHeader(block);
    if (!header)
        return header.error();
    const std::lock_guard lock(mutex_);
    totals_.points += pointsOf(options_.division.box(block));
    totals_.sites += header->siteCount;
    totals_.tetrahedra += header->tetrahedronCount;
    totals_.living += header->livingCount;
    totals_.fileBytes += runBytes(*header);
    ++finished_;
    if (const Status fits = checkMeshSize(totals_.living, totals_.living); !fits)
        return fits;
    if (finished_ < std::min<std::size_t>(blocksSampled, order_.size()))
        return {};
    const double share = static_cast<double>(allPoints_) / static_cast<double>(totals_.points);
    const auto scaled = [share](std::uint64_t amount) {
        return static_cast<std::uint64_t>(static_cast<double>(amount) * share);
    };
    const RunTotals expected{allPoints_, scaled(totals_.sites), scaled(totals_.tetrahedra), scaled(totals_.fileBytes),
                             scaled(totals_.living)};
    if (const Status fits = checkMeshSize(totals_.living, expected.living); !fits)
        return fits;
    return options_.check ? options_.check(totals_, expected) : Status();
}

} // namespace

Status makeLatticeRuns(const LatticeRunsOptions& options, const LatticeSamples& samples, const RunFiles& runs,
                       const Progress& progress)
{
    return guarded(
        Message::marked(
            "Not enough memory to refine blocks of this size. Close other programs, use fewer threads or choose "
            "smaller blocks."),
        [&] { return RunMaker(options, samples, runs, progress).run(); });
}

} // namespace tetra
