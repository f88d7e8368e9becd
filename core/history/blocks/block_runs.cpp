// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/block_runs.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/base/guarded.h"
#include "core/base/progress.h"

#include <tan/base.h>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <memory>
#include <mutex>
#include <utility>
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

/// Refines one block into the recorder.
using RefineBlock = std::function<Status(std::uint32_t block, BlockRunRecorder& recorder, const Progress& progress)>;

/// How a run is made.
struct RunMethod {
    std::function<BlockRunRecorder()> recorder; ///< one for each thread
    std::function<RefineBlock()> refiner;       ///< likewise
};

/// Makes the runs of some blocks at a time, and knows what all that are there came to.
class RunMaker {
public:
    RunMaker(const BlockRunsOptions& options, const RunFiles& runs, RunMethod method)
        : options_(options), runs_(runs), method_(std::move(method)), counted_(runs.blockCount())
    {
        for (std::uint32_t block = 0; block < runs.blockCount(); ++block)
            allPoints_ += pointsOf(options.division.box(block));
    }

    /// In this order.
    Status make(std::span<const std::uint32_t> blocks, const Progress& progress);

private:
    /// The runs of one call of make().
    struct Round {
        Round(std::span<const std::uint32_t> these, double pointCount, const Progress& told)
            : blocks(these), progress(told), points(told, pointCount, Message::marked("Refining the blocks"))
        {
        }

        std::span<const std::uint32_t> blocks;
        const Progress& progress;
        SharedProgress points;
        std::atomic<std::uint32_t> next = 0;
        FirstFailure failure;
    };

    Status work(Round& round);
    Status make(std::uint32_t block, Round& round, const RefineBlock& refine, BlockRunRecorder& recorder);
    Status account(std::uint32_t block);

    const BlockRunsOptions& options_;
    const RunFiles& runs_;
    RunMethod method_;
    std::uint64_t allPoints_ = 0;

    std::mutex mutex_;
    RunTotals totals_;
    std::vector<RunTotals> counted_; ///< of each block, as far as it is in the totals
    std::uint32_t finished_ = 0;
};

Status RunMaker::make(std::span<const std::uint32_t> blocks, const Progress& progress)
{
    double points = 0;
    for (const std::uint32_t block : blocks)
        points += static_cast<double>(pointsOf(options_.division.box(block)));
    Round round(blocks, points, progress);
    const int workers = tbb::this_task_arena::max_concurrency();
    tbb::parallel_for(
        0, workers, [&](int) { round.failure.run([&] { return work(round); }); }, tbb::simple_partitioner());
    return round.failure.status();
}

Status RunMaker::work(Round& round)
{
    const RefineBlock refine = method_.refiner();
    BlockRunRecorder recorder = method_.recorder();
    for (std::uint32_t i = round.next++; i < round.blocks.size() && !round.failure.happened(); i = round.next++) {
        const std::uint32_t block = round.blocks[i];
        if (round.progress.cancelled())
            return cancelledError(Message::marked("The build"));
        if (!(options_.reuseIntact && runs_.intact(block))) {
            if (const Status made = make(block, round, refine, recorder); !made)
                return made;
        } else {
            round.points.done(static_cast<double>(pointsOf(options_.division.box(block))));
        }
        if (const Status right = account(block); !right)
            return right;
    }
    return {};
}

Status RunMaker::make(std::uint32_t block, Round& round, const RefineBlock& refine, BlockRunRecorder& recorder)
{
    const auto points = static_cast<double>(pointsOf(options_.division.box(block)));
    const Progress own = round.failure.watching(round.progress).withCallback(round.points.piece(points));
    recorder.start();
    if (const Status refined = refine(block, recorder, own); !refined)
        return refined;
    own.report(1, {});
    if (options_.samplesIntact)
        if (const Status intact = options_.samplesIntact(); !intact)
            return intact;
    return recorder.write(runs_.path(block), runs_.fingerprint(block), block);
}

Status RunMaker::account(std::uint32_t block)
{
    const Result<BlockRunHeader> header = runs_.readHeader(block);
    if (!header)
        return header.error();
    if (header->cureCount > 0) // it will be made again
        return {};
    const RunTotals now{pointsOf(options_.division.box(block)), header->siteCount, header->tetrahedronCount,
                        runBytes(*header), header->livingCount};
    const std::lock_guard lock(mutex_);
    finished_ += counted_[block].points == 0 ? 1 : 0;
    for (std::uint64_t RunTotals::*amount :
         {&RunTotals::points, &RunTotals::sites, &RunTotals::tetrahedra, &RunTotals::fileBytes, &RunTotals::living})
        totals_.*amount += now.*amount - counted_[block].*amount;
    counted_[block] = now;
    if (const Status fits = checkMeshSize(totals_.living, totals_.living); !fits)
        return fits;
    if (finished_ < std::min(blocksSampled, runs_.blockCount()))
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

constexpr MarkedText noMemoryForBlocks =
    Message::marked("Not enough memory to refine blocks of this size. Close other programs, use fewer threads or "
                    "choose smaller blocks.");

RunMethod methodOf(const LatticeRunsOptions& options, const LatticeSamples& samples)
{
    const auto& size = options.box.latticeSize;
    return {[&] { return BlockRunRecorder(std::uint64_t(size[0]) * size[1] * size[2], options.box.valueExtent, 0); },
            [&] {
                return [&, refiner = std::make_shared<LatticeRefiner>()](
                           std::uint32_t block, BlockRunRecorder& recorder, const Progress& progress) -> Status {
                    LatticeBoxOptions box = options.box;
                    box.box = options.division.box(block);
                    box.centreAtOrigin = !options.division.odd(block);
                    const Result<LatticeRefinementResult> refined = refiner->refine(box, samples, recorder, progress);
                    return refined ? Status() : Status(refined.error());
                };
            }};
}

/// The rounds in which the blocks of a curvilinear grid are refined.
class CurvilinearRounds {
public:
    CurvilinearRounds(const CurvilinearRunsOptions& options, std::span<const Eigen::Vector3d> positions,
                      const LatticeSamples& samples, RunFiles& runs)
        : options_(options), positions_(positions), samples_(samples), runs_(runs), cures_(options.division),
          maker_(options, runs, method())
    {
    }

    Status run(const Progress& progress, std::uint32_t mostRounds);

private:
    RunMethod method();
    Result<std::vector<FaceCure>> found(std::span<const std::uint32_t> blocks) const;
    std::filesystem::path path() const { return runs_.folder() / "cures"; }
    void load();
    Status save() const;
    void take(std::span<const FaceCure> cures);

    /// The file of what is known, followed by the cures.
    struct Header {
        std::array<char, 8> magic{'T', 'A', 'N', 'C', 'U', 'R', '0', '1'};
        std::uint64_t fingerprint = 0;
        std::uint64_t rounds = 0; ///< that are over
        std::uint64_t checksum = 0;
    };

    const CurvilinearRunsOptions& options_;
    std::span<const Eigen::Vector3d> positions_;
    const LatticeSamples& samples_;
    RunFiles& runs_;
    FaceCures cures_;
    std::vector<std::uint32_t> changed_; ///< by the cures that were taken last
    std::uint64_t rounds_ = 0;
    RunMaker maker_;
};

RunMethod CurvilinearRounds::method()
{
    const auto& size = options_.box.size;
    return {[this, size] {
                return BlockRunRecorder(std::uint64_t(size[0]) * size[1] * size[2], options_.box.valueExtent,
                                        options_.box.positionExtent);
            },
            [this] {
                return [this, refiner = std::make_shared<CurvilinearRefiner>()](
                           std::uint32_t block, BlockRunRecorder& recorder, const Progress& progress) -> Status {
                    CurvilinearBoxOptions box = options_.box;
                    box.box = options_.division.box(block);
                    box.centreAtOrigin = !options_.division.odd(block);
                    std::vector<FaceCure> needed;
                    const Result<CurvilinearRefinementResult> refined =
                        refiner->refine(box, positions_, samples_, cures_.of(block), needed, recorder, progress);
                    if (!refined)
                        return refined.error();
                    recorder.setFindings(std::move(needed), refined->inverted, refined->degenerate);
                    return {};
                };
            }};
}

void CurvilinearRounds::take(std::span<const FaceCure> cures)
{
    changed_ = cures_.add(cures);
    for (const std::uint32_t block : changed_)
        runs_.setCures(block, cures_.of(block));
}

Result<std::vector<FaceCure>> CurvilinearRounds::found(std::span<const std::uint32_t> blocks) const
{
    std::vector<FaceCure> found;
    for (const std::uint32_t block : blocks) {
        const Result<std::vector<FaceCure>> ofBlock = runs_.readCures(block);
        if (!ofBlock)
            return ofBlock.error();
        found.insert(found.end(), ofBlock->begin(), ofBlock->end());
    }
    return found;
}

/// What a build that was killed knew; nothing if it cannot be read: that costs only time.
void CurvilinearRounds::load()
{
    const auto file = MappedFile::open(path());
    Header header;
    if (!file || (*file)->bytes().size() < sizeof header)
        return;
    std::memcpy(&header, (*file)->bytes().data(), sizeof header);
    const std::span<const std::byte> content = (*file)->bytes().subspan(sizeof header);
    if (header.magic != Header().magic || header.fingerprint != runs_.fingerprint() ||
        header.checksum != (checksum(content) ^ header.rounds) || content.size() % sizeof(FaceCure) != 0)
        return;
    std::vector<FaceCure> cures(content.size() / sizeof(FaceCure));
    std::memcpy(cures.data(), content.data(), content.size());
    take(cures);
    rounds_ = header.rounds;
}

Status CurvilinearRounds::save() const
{
    const std::vector<FaceCure> cures = cures_.all();
    const std::span<const std::byte> content = std::as_bytes(std::span(cures));
    const Header header{.fingerprint = runs_.fingerprint(), .rounds = rounds_, .checksum = checksum(content) ^ rounds_};
    Result<FileWriter> file = FileWriter::create(path(), 1, runs_.folder());
    if (!file)
        return file.error();
    for (const std::span<const std::byte> part : {std::as_bytes(std::span(&header, 1)), content})
        if (const Status written = file->write(part); !written)
            return written;
    return file->commit(FileWriter::Durability::Process);
}

Status CurvilinearRounds::run(const Progress& progress, std::uint32_t mostRounds)
{
    if (options_.reuseIntact)
        load();
    // Most grids need one round, and others their first for most of the time.
    constexpr double firstShare = 0.8;
    double begun = 0, end = rounds_ == 0 ? firstShare : (1 + firstShare) / 2;
    for (std::vector<std::uint32_t> due = orderOfWork(runs_.blockCount()); !due.empty(); due = changed_) {
        if (const Status made = maker_.make(due, progress.part(begun, end)); !made)
            return made;
        const Result<std::vector<FaceCure>> needed = found(due);
        if (!needed)
            return needed.error();
        changed_.clear();
        if (!needed->empty()) {
            take(++rounds_ < mostRounds ? *needed : cures_.wholeFacesOf(*needed));
            if (const Status saved = save(); !saved)
                return saved;
        }
        begun = std::exchange(end, (1 + end) / 2);
    }
    return {};
}

} // namespace

Status makeLatticeRuns(const LatticeRunsOptions& options, const LatticeSamples& samples, const RunFiles& runs,
                       const Progress& progress)
{
    return guarded(noMemoryForBlocks, [&] {
        return RunMaker(options, runs, methodOf(options, samples)).make(orderOfWork(runs.blockCount()), progress);
    });
}

Status makeCurvilinearRuns(const CurvilinearRunsOptions& options, std::span<const Eigen::Vector3d> positions,
                           const LatticeSamples& samples, RunFiles& runs, const Progress& progress,
                           std::uint32_t mostRounds)
{
    return guarded(noMemoryForBlocks,
                   [&] { return CurvilinearRounds(options, positions, samples, runs).run(progress, mostRounds); });
}

} // namespace tetra
