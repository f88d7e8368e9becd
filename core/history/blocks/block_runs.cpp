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
#include <chrono>
#include <cstring>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
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

/// A sample of the blocks, then the others as they lie.
std::vector<std::uint32_t> orderOfWork(const BlockShare& share)
{
    const std::uint32_t blocks = share.end - share.first;
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
        order.push_back(share.first + block);
    }
    for (std::uint32_t block = 0; block < blocks; ++block)
        if (!taken[block])
            order.push_back(share.first + block);
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
    RunMaker(const BlockRunsOptions& options, RunFiles& runs, RunMethod method)
        : options_(options), runs_(runs), method_(std::move(method)),
          share_(options.part ? shareOf(*options.part, runs.blockCount()) : BlockShare{0, runs.blockCount()}),
          counted_(runs.blockCount())
    {
        for (std::uint32_t block = 0; block < runs.blockCount(); ++block) {
            const std::uint64_t points = pointsOf(options.division.box(block));
            allPoints_ += points;
            sharedPoints_ += contains(share_, block) ? points : 0;
        }
    }

    const BlockShare& share() const noexcept { return share_; }

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
    RunFiles& runs_;
    RunMethod method_;
    BlockShare share_;
    std::uint64_t allPoints_ = 0;
    std::uint64_t sharedPoints_ = 0; ///< of the share

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
        if (!runs_.intact(block)) {
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
    return runs_.append(recorder, block);
}

Status RunMaker::account(std::uint32_t block)
{
    const BlockRunHeader& header = runs_.header(block);
    if (header.cureCount > 0) // it will be made again
        return {};
    const RunTotals now{pointsOf(options_.division.box(block)), header.siteCount, header.tetrahedronCount,
                        runBytes(header), header.livingCount};
    const std::lock_guard lock(mutex_);
    finished_ += counted_[block].points == 0 ? 1 : 0;
    for (std::uint64_t RunTotals::*amount :
         {&RunTotals::points, &RunTotals::sites, &RunTotals::tetrahedra, &RunTotals::fileBytes, &RunTotals::living})
        totals_.*amount += now.*amount - counted_[block].*amount;
    counted_[block] = now;
    if (const Status fits = checkMeshSize(totals_.living, totals_.living); !fits)
        return fits;
    if (finished_ < std::min(blocksSampled, share_.end - share_.first))
        return {};
    const auto scaled = [&](std::uint64_t amount, std::uint64_t points) {
        const double share = static_cast<double>(points) / static_cast<double>(totals_.points);
        return static_cast<std::uint64_t>(static_cast<double>(amount) * share);
    };
    if (const Status fits = checkMeshSize(totals_.living, scaled(totals_.living, allPoints_)); !fits)
        return fits;
    const RunTotals expected{sharedPoints_, scaled(totals_.sites, sharedPoints_),
                             scaled(totals_.tetrahedra, sharedPoints_), scaled(totals_.fileBytes, sharedPoints_),
                             scaled(totals_.living, sharedPoints_)};
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

/// Cures of a file, and how many rounds were over when it was written.
struct SavedCures {
    std::uint64_t rounds = 0;
    std::vector<FaceCure> cures;
};

/// What such a file begins with; the cures follow.
struct CuresHeader {
    std::array<char, 8> magic{'T', 'A', 'N', 'C', 'U', 'R', '0', '1'};
    std::uint64_t fingerprint = 0;
    std::uint64_t rounds = 0;
    std::uint64_t checksum = 0;
};

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
    Status makeMissing(const Progress& progress);
    Result<std::vector<FaceCure>> found(std::span<const std::uint32_t> blocks) const;
    Result<std::vector<FaceCure>> neededBy(std::span<const std::uint32_t> due, const Progress& progress);
    Result<std::vector<FaceCure>> neededByAllParts(std::vector<std::uint32_t> due, const Progress& progress);
    Result<std::vector<FaceCure>> toldBy(const PartNumber& part, const Progress& progress) const;
    std::filesystem::path path() const { return runs_.folder() / "cures"; }
    std::filesystem::path pathOfRound(const PartNumber& part) const;
    void load();
    Status save(const std::filesystem::path& path, std::span<const FaceCure> cures) const;
    std::optional<SavedCures> saved(const std::filesystem::path& path) const;
    void take(std::span<const FaceCure> cures);

    const CurvilinearRunsOptions& options_;
    std::span<const Eigen::Vector3d> positions_;
    const LatticeSamples& samples_;
    RunFiles& runs_;
    FaceCures cures_;
    std::vector<std::uint32_t> changed_; ///< by the cures that were taken last
    std::uint64_t rounds_ = 0;           ///< that are over
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

// What is known of faces, in files.

Status CurvilinearRounds::save(const std::filesystem::path& path, std::span<const FaceCure> cures) const
{
    const std::span<const std::byte> content = std::as_bytes(cures);
    const CuresHeader header{
        .fingerprint = runs_.fingerprint(), .rounds = rounds_, .checksum = checksum(content) ^ rounds_};
    // Others need what a part tells, and may be begun again after the disk's machine has failed.
    const auto durability = options_.part ? FileWriter::Durability::Power : FileWriter::Durability::Process;
    Result<FileWriter> file = FileWriter::create(path, 1, options_.part ? std::filesystem::path() : runs_.folder());
    if (!file)
        return file.error();
    for (const std::span<const std::byte> part : {std::as_bytes(std::span(&header, 1)), content})
        if (const Status written = file->write(part); !written)
            return written;
    return file->commit(durability);
}

/// Nothing if the file is not there, of another build or damaged.
std::optional<SavedCures> CurvilinearRounds::saved(const std::filesystem::path& path) const
{
    const auto file = MappedFile::open(path);
    CuresHeader header;
    if (!file || (*file)->bytes().size() < sizeof header)
        return std::nullopt;
    std::memcpy(&header, (*file)->bytes().data(), sizeof header);
    const std::span<const std::byte> content = (*file)->bytes().subspan(sizeof header);
    if (header.magic != CuresHeader().magic || header.fingerprint != runs_.fingerprint() ||
        header.checksum != (checksum(content) ^ header.rounds) || content.size() % sizeof(FaceCure) != 0)
        return std::nullopt;
    SavedCures saved{header.rounds, std::vector<FaceCure>(content.size() / sizeof(FaceCure))};
    std::memcpy(saved.cures.data(), content.data(), content.size());
    return saved;
}

/// What a build that was killed knew.
void CurvilinearRounds::load()
{
    if (const auto known = saved(path())) {
        take(known->cures);
        rounds_ = known->rounds;
    }
}

// The rounds.

/// What a run needs depends on its block and on the cures that the block knows: so the rounds of a shared build make
/// the runs that those of a build alone do.
Status CurvilinearRounds::run(const Progress& progress, std::uint32_t mostRounds)
{
    if (options_.resumes && !options_.part)
        load();
    // Most grids need one round, and others their first for most of the time.
    constexpr double firstShare = 0.8;
    double begun = 0, end = rounds_ == 0 ? firstShare : (1 + firstShare) / 2;
    for (std::vector<std::uint32_t> due = orderOfWork(maker_.share());; due = changed_) {
        const Progress own = progress.part(begun, end);
        const Result<std::vector<FaceCure>> needed = options_.part ? neededByAllParts(due, own) : neededBy(due, own);
        if (!needed)
            return needed.error();
        if (needed->empty())
            return makeMissing(progress.part(end, 1));
        take(++rounds_ < mostRounds ? *needed : cures_.wholeFacesOf(*needed));
        if (!options_.part)
            if (const Status kept = save(path(), cures_.all()); !kept)
                return kept;
        begun = std::exchange(end, (1 + end) / 2);
    }
}

/// Makes the runs of these blocks, and tells what they need.
Result<std::vector<FaceCure>> CurvilinearRounds::neededBy(std::span<const std::uint32_t> due, const Progress& progress)
{
    const Status made = maker_.make(due, progress);
    return made ? found(due) : made.error();
}

/// Of those that are this part's; then all parts tell each other what they need.
Result<std::vector<FaceCure>> CurvilinearRounds::neededByAllParts(std::vector<std::uint32_t> due,
                                                                  const Progress& progress)
{
    std::erase_if(due, [&](std::uint32_t block) { return !contains(maker_.share(), block); });
    const std::filesystem::path own = pathOfRound(*options_.part);
    if (!saved(own)) {
        const auto needed = neededBy(due, progress);
        if (!needed)
            return needed.error();
        if (const Status told = save(own, *needed); !told)
            return told.error();
    }
    std::vector<FaceCure> all;
    for (PartNumber part{1, options_.part->count}; part.number <= part.count; ++part.number) {
        const Result<std::vector<FaceCure>> told = toldBy(part, progress);
        if (!told)
            return told.error();
        all.insert(all.end(), told->begin(), told->end());
    }
    return all;
}

/// What a part that was begun again lacks of earlier rounds.
Status CurvilinearRounds::makeMissing(const Progress& progress)
{
    std::vector<std::uint32_t> due = orderOfWork(maker_.share());
    std::erase_if(due, [&](std::uint32_t block) { return runs_.intact(block); });
    return maker_.make(due, progress);
}

std::filesystem::path CurvilinearRounds::pathOfRound(const PartNumber& part) const
{
    return runs_.folder() / roundFileName(part, rounds_);
}

/// In this round.
Result<std::vector<FaceCure>> CurvilinearRounds::toldBy(const PartNumber& part, const Progress& progress) const
{
    // Parts of the same size are done at about the same time; who takes longer is asked less often.
    constexpr std::chrono::milliseconds firstPause(2), longestPause(200);
    auto pause = firstPause;
    auto told = saved(pathOfRound(part));
    while (!told && options_.waits) {
        if (progress.cancelled())
            return cancelledError(Message::marked("The build"));
        progress.report(1, Message::say("Waiting for part %1", part.number));
        std::this_thread::sleep_for(pause);
        pause = std::min(2 * pause, longestPause);
        told = saved(pathOfRound(part));
    }
    if (told)
        return std::move(told->cures);
    return Error{ErrorKind::NotYet,
                 Message::say("Part %1 of %2 has done what it can until part %3 has found out what it needs of their "
                              "common faces. Start it again after that: it goes on from here.",
                              options_.part->number, options_.part->count, part.number)};
}

} // namespace

Status makeLatticeRuns(const LatticeRunsOptions& options, const LatticeSamples& samples, RunFiles& runs,
                       const Progress& progress)
{
    return guarded(noMemoryForBlocks, [&] {
        RunMaker maker(options, runs, methodOf(options, samples));
        return maker.make(orderOfWork(maker.share()), progress);
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
