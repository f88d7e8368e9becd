// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blocks/merged_model.h"

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>

namespace tetra {

namespace {

/// How far it is when the sites have their numbers.
constexpr double numberedShare = 0.2;

/// A chunk on its way through the pipeline.
struct SectionPiece {
    MergedChunk chunk;
    TranslatedStars stars;
};
using PiecePointer = std::shared_ptr<SectionPiece>;

/// Reads, translates and writes at once; the first thing that goes wrong stops all.
class StarPipeline {
public:
    StarPipeline(const RunFiles& runs, const MergedNumbers& numbers, PlannedModelWriter& writer,
                 const Progress& progress, std::uint64_t sliceTetrahedra)
        : runs_(runs), numbers_(numbers), writer_(writer), progress_(progress), maker_(runs, sliceTetrahedra)
    {
    }

    Status run();

private:
    PiecePointer make(tbb::flow_control& control);
    PiecePointer translate(PiecePointer piece);
    void write(const SectionPiece& piece);
    void fail(const Error& error);

    const RunFiles& runs_;
    const MergedNumbers& numbers_;
    PlannedModelWriter& writer_;
    const Progress& progress_;
    ChunkMaker maker_;
    std::atomic<bool> failed_ = false;
    std::mutex mutex_;
    Status status_;
};

Status StarPipeline::run()
{
    const auto tokens = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()) + 2;
    tbb::parallel_pipeline(
        tokens,
        tbb::make_filter<void, PiecePointer>(tbb::filter_mode::serial_in_order, [this](tbb::flow_control& control) {
            return make(control);
        }) & tbb::make_filter<PiecePointer, PiecePointer>(tbb::filter_mode::parallel, [this](PiecePointer piece) {
            return translate(std::move(piece));
        }) & tbb::make_filter<PiecePointer, void>(tbb::filter_mode::serial_in_order, [this](const PiecePointer& piece) {
            write(*piece);
        }));
    return status_;
}

PiecePointer StarPipeline::make(tbb::flow_control& control)
{
    auto piece = std::make_shared<SectionPiece>();
    if (progress_.cancelled())
        fail(cancelledError("Merging the blocks"));
    if (!failed_) {
        Result<MergedChunk> chunk = maker_.next();
        if (chunk)
            piece->chunk = *std::move(chunk);
        else
            fail(chunk.error());
    }
    if (failed_ || piece->chunk.points.empty())
        control.stop();
    return piece;
}

PiecePointer StarPipeline::translate(PiecePointer piece)
{
    if (failed_)
        return piece;
    Result<TranslatedStars> stars = translateStars(piece->chunk, runs_, numbers_);
    if (stars)
        piece->stars = *std::move(stars);
    else
        fail(stars.error());
    return piece;
}

void StarPipeline::write(const SectionPiece& piece)
{
    if (failed_)
        return;
    const MergedChunk& chunk = piece.chunk;
    const TranslatedStars& stars = piece.stars;
    const Status written = writer_.add({chunk.points, chunk.runningKeys, chunk.groupGoesOn, chunk.meshSizes,
                                        stars.starSizes, stars.otherSites, stars.destroyers, stars.ownErrors});
    if (!written)
        fail(written.error());
    const auto sites = static_cast<double>(chunk.firstSite) + static_cast<double>(chunk.points.size());
    progress_.report(sites / numbers_.siteCount(), "Merging the blocks");
}

void StarPipeline::fail(const Error& error)
{
    const std::lock_guard lock(mutex_);
    if (status_)
        status_ = error;
    failed_ = true;
}

Result<PlannedCounts> merge(RunFiles& runs, const std::filesystem::path& workFolder, const PlannedModelOpener& open,
                            const Progress& progress, std::uint64_t sliceTetrahedra)
{
    if (const Status opened = runs.open(); !opened)
        return opened.error();
    PlannedCounts counts;
    float finalKey = 0;
    std::uint64_t living = 0;
    for (std::uint32_t block = 0; block < runs.blockCount(); ++block) {
        counts.tetrahedra += runs.header(block).tetrahedronCount;
        living += runs.header(block).livingCount;
        finalKey = std::max(finalKey, runs.header(block).finalKey);
    }
    if (const Status fits = checkMeshSize(living, living); !fits)
        return fits.error();
    const Result<MergedNumbers> numbers = MergedNumbers::make(runs, workFolder, progress.part(0, numberedShare));
    if (!numbers)
        return numbers.error();
    counts.sites = numbers->siteCount();
    const Result<std::unique_ptr<PlannedModelWriter>> writer = open(counts);
    if (!writer)
        return writer.error();
    const Progress writing = progress.part(numberedShare, 1);
    if (const Status merged = StarPipeline(runs, *numbers, **writer, writing, sliceTetrahedra).run(); !merged)
        return merged.error();
    if (progress.cancelled())
        return cancelledError("Merging the blocks");
    if (const Status finished = (*writer)->finish(finalKey); !finished)
        return finished.error();
    return counts;
}

} // namespace

Result<PlannedCounts> mergeRuns(RunFiles& runs, const std::filesystem::path& workFolder, const PlannedModelOpener& open,
                                const Progress& progress, std::uint64_t sliceTetrahedra)
{
    try {
        return merge(runs, workFolder, open, progress, sliceTetrahedra);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to merge the blocks. Close other programs, or ask for "
                     "a larger error."};
    }
}

} // namespace tetra
