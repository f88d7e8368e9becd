// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/blocks/merged_model.h"

#include "core/base/guarded.h"
#include "core/base/rounding.h"
#include "core/base/scratch_file.h"
#include "core/history/blocks/block_merge.h"

#include <tan/base.h>
#include <tan/model.h>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <limits>
#include <mutex>
#include <numeric>
#include <span>

namespace tetra {

namespace {

/// The number that each site of each block has in the whole model.
class MergedNumbers {
public:
    /// Goes once through all runs. 4 bytes a site of a block, in a file in `workFolder` that the system may keep in
    /// memory. Errors: unreadable runs, no room, too many sites, cancelled.
    static Result<MergedNumbers> make(const RunFiles& runs, const std::filesystem::path& workFolder,
                                      const Progress& progress);

    /// In all blocks, each once.
    std::uint32_t siteCount() const noexcept { return siteCount_; }
    std::span<const std::uint32_t> ofBlock(std::uint32_t block) const
    {
        return file_.as<const std::uint32_t>().subspan(firsts_[block], firsts_[block + 1] - firsts_[block]);
    }

private:
    explicit MergedNumbers(ScratchFile file) : file_(std::move(file)) {}
    Status fill(const RunFiles& runs, const Progress& progress);

    ScratchFile file_;
    std::vector<std::uint64_t> firsts_; ///< where each block's numbers begin, and the end
    std::uint32_t siteCount_ = 0;
};

/// The chunk's tetrahedra in the model's numbers and order.
struct TranslatedStars {
    std::vector<std::uint32_t> starSizes;
    std::vector<std::array<std::uint32_t, 3>> otherSites;
    std::vector<std::uint32_t> destroyers;
    std::vector<std::uint16_t> ownErrors;
    std::vector<std::uint16_t> ownWarpings; ///< of data that can warp
};

constexpr std::uint64_t sitesBetweenReports = 1 << 16;

Error unfitNumbers()
{
    return {ErrorKind::OutOfResource,
            Message::say("The runs of the blocks do not fit together. Start the build again.")};
}

Result<MergedNumbers> MergedNumbers::make(const RunFiles& runs, const std::filesystem::path& workFolder,
                                          const Progress& progress)
{
    std::vector<std::uint64_t> firsts{0};
    for (std::uint32_t block = 0; block < runs.blockCount(); ++block)
        firsts.push_back(firsts.back() + runs.header(block).siteCount);
    Result<ScratchFile> file = ScratchFile::create(workFolder, firsts.back() * sizeof(std::uint32_t));
    if (!file)
        return file.error();
    MergedNumbers numbers(*std::move(file));
    numbers.firsts_ = std::move(firsts);
    if (const Status filled = numbers.fill(runs, progress); !filled)
        return filled.error();
    return numbers;
}

Status MergedNumbers::fill(const RunFiles& runs, const Progress& progress)
{
    const std::span<std::uint32_t> numbers = file_.as<std::uint32_t>();
    BlockMerge merge(runs);
    std::uint64_t done = 0;
    std::uint64_t reported = 0;
    for (;;) {
        const Result<bool> more = merge.next();
        if (!more.ok())
            return more.error();
        if (!*more)
            break;
        const MergedBatch& batch = merge.batch();
        if (batch.points.size() >= Model::never - siteCount_)
            return Error{ErrorKind::OutOfResource,
                         Message::say("The model would have more than 4294967294 sites. Choose a larger error, or take "
                                      "a part of the dataset.")};
        for (const MergedBatch::Part& part : batch.parts) {
            const std::uint64_t first = firsts_[part.block] + part.firstSite;
            if (first + part.siteCount > firsts_[part.block + 1])
                return unfitNumbers();
            for (std::uint32_t site = 0; site < part.siteCount; ++site)
                numbers[first + site] = siteCount_ + batch.places[part.firstPlace + site];
            done += part.siteCount;
        }
        siteCount_ += static_cast<std::uint32_t>(batch.points.size());
        if (done < reported + sitesBetweenReports)
            continue;
        reported = done;
        if (progress.cancelled())
            return cancelledError(Message::marked("Merging the blocks"));
        progress.report(static_cast<double>(done) / static_cast<double>(numbers.size()),
                        Message::marked("Numbering the sites"));
    }
    return done == numbers.size() ? Status() : Status(unfitNumbers());
}

constexpr std::uint64_t tetrahedraInChunk = 1 << 18;

/// The chunk's tetrahedra as they stand in the runs, read with as few calls as their places allow.
class ChunkReader {
public:
    ChunkReader(const MergedChunk& chunk, const RunFiles& runs)
        : chunk_(chunk), runs_(runs), places_(chunk.parts.size())
    {
    }

    Status read();
    /// The tetrahedra of a part.
    const std::byte* of(std::size_t part) const { return bytes_.data() + places_[part]; }

private:
    const MergedChunk& chunk_;
    const RunFiles& runs_;
    std::vector<std::size_t> places_;
    Buffer<std::byte> bytes_;
};

Status ChunkReader::read()
{
    const std::vector<MergedBatch::Part>& parts = chunk_.parts;
    std::vector<std::uint32_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::sort(order, {},
                      [&](std::uint32_t part) { return std::pair(parts[part].block, parts[part].firstTetrahedron); });
    std::size_t size = 0;
    for (const std::uint32_t part : order) {
        places_[part] = size;
        size += std::size_t(parts[part].tetrahedronCount) * runs_.header(parts[part].block).recordBytes;
    }
    bytes_.resize(size);
    for (std::size_t i = 0; i < order.size();) {
        const MergedBatch::Part& first = parts[order[i]];
        const std::size_t begin = places_[order[i]];
        std::uint64_t count = 0;
        for (; i < order.size() && parts[order[i]].block == first.block &&
               parts[order[i]].firstTetrahedron == first.firstTetrahedron + count;
             ++i)
            count += parts[order[i]].tetrahedronCount;
        const std::span<std::byte> to(bytes_.data() + begin, count * runs_.header(first.block).recordBytes);
        if (const Status read = runs_.readTetrahedra(first.block, first.firstTetrahedron, count, to); !read)
            return read;
    }
    return {};
}

/// A tetrahedron in the model's numbers, the creator first.
struct Translated {
    std::array<std::uint32_t, 4> sites;
    std::uint32_t destroyer;
    std::uint16_t ownError;
    std::uint16_t ownWarping;
};

Error unfitStars()
{
    return {ErrorKind::OutOfResource,
            Message::say("The runs of the blocks do not fit together. Start the build again.")};
}

/// Translates a part's tetrahedra and appends them; false if a number makes no sense.
template <class Record> bool translatePart(const std::byte* bytes, std::uint32_t count,
                                           std::span<const std::uint32_t> numbers, const MergedChunk& chunk,
                                           std::vector<Translated>& out)
{
    const auto known = [&](std::uint32_t site) { return site < numbers.size(); };
    for (std::uint32_t i = 0; i < count; ++i) {
        Record record;
        std::memcpy(&record, bytes + i * sizeof(Record), sizeof(Record));
        const bool dies = record.destroyer != Record::never;
        if (!std::ranges::all_of(record.sites, known) || (dies && !known(record.destroyer)))
            return false;
        const auto sites = latestFirst(
            {numbers[record.sites[0]], numbers[record.sites[1]], numbers[record.sites[2]], numbers[record.sites[3]]});
        if (chunk.slice && sites[0] - chunk.firstSite >= chunk.points.size())
            continue;
        std::uint16_t ownWarping = 0;
        if constexpr (requires { record.ownWarping; })
            ownWarping = record.ownWarping;
        out.push_back({sites, dies ? numbers[record.destroyer] : Model::never, record.ownError, ownWarping});
    }
    return true;
}

/// Puts the tetrahedra of each star together, in the order in which they come.
Status sortIntoStars(const std::vector<Translated>& tetrahedra, const MergedChunk& chunk, TranslatedStars& stars)
{
    stars.starSizes.assign(chunk.points.size(), 0);
    for (const Translated& tetrahedron : tetrahedra) {
        const std::uint32_t place = tetrahedron.sites[0] - chunk.firstSite;
        if (place >= chunk.points.size())
            return unfitStars();
        ++stars.starSizes[place];
    }
    std::vector<std::uint32_t> next(chunk.points.size());
    std::exclusive_scan(stars.starSizes.begin(), stars.starSizes.end(), next.begin(), 0u);
    stars.otherSites.resize(tetrahedra.size());
    stars.destroyers.resize(tetrahedra.size());
    stars.ownErrors.resize(tetrahedra.size());
    stars.ownWarpings.resize(tetrahedra.size());
    for (const auto& [sites, destroyer, ownError, ownWarping] : tetrahedra) {
        const std::uint32_t at = next[sites[0] - chunk.firstSite]++;
        stars.otherSites[at] = {sites[1], sites[2], sites[3]};
        stars.destroyers[at] = destroyer;
        stars.ownErrors[at] = ownError;
        stars.ownWarpings[at] = ownWarping;
    }
    return {};
}

} // namespace

Result<MergedChunk> ChunkMaker::next()
{
    MergedChunk chunk;
    chunk.firstSite = sites_;
    while (chunk.tetrahedronCount < tetrahedraInChunk) {
        const Result<bool> found = findGroup();
        if (!found.ok())
            return found.error();
        if (!*found)
            break;
        if (group_.tetrahedronCount <= 2 * sliceTetrahedra_) {
            takeGroup(chunk);
        } else {
            if (chunk.points.empty())
                takeSlice(chunk);
            break;
        }
    }
    return chunk;
}

/// Makes the group at place_ known, unless it is; false at the end of all batches.
Result<bool> ChunkMaker::findGroup()
{
    if (inGroup_)
        return true;
    if (!inBatch_) {
        const Result<bool> more = merge_.next();
        if (!more.ok() || !*more)
            return more;
        place_ = 0;
        part_ = 0;
    }
    const MergedBatch& batch = merge_.batch();
    group_ = {place_ + 1, part_, 0};
    while (batch.groupGoesOn[group_.endPlace - 1] != 0)
        ++group_.endPlace;
    const std::uint32_t number = batch.parts[part_].group;
    for (; group_.endPart < batch.parts.size() && batch.parts[group_.endPart].group == number; ++group_.endPart) {
        const MergedBatch::Part& part = batch.parts[group_.endPart];
        group_.tetrahedronCount += part.tetrahedronCount;
        meshSize_ += part.tetrahedronCount;
        meshSize_ -= part.destroyedCount;
    }
    if (const Status fits = checkMeshSize(meshSize_, meshSize_); !fits)
        return fits.error();
    const std::uint64_t slices = group_.tetrahedronCount / sliceTetrahedra_ + 1;
    sliceSites_ = static_cast<std::uint32_t>((group_.endPlace - place_) / slices + 1);
    inBatch_ = true;
    inGroup_ = true;
    return true;
}

void ChunkMaker::takeGroup(MergedChunk& chunk)
{
    const std::vector<MergedBatch::Part>& parts = merge_.batch().parts;
    for (std::size_t part = part_; part < group_.endPart; ++part)
        if (parts[part].tetrahedronCount > 0)
            chunk.parts.push_back(parts[part]);
    chunk.tetrahedronCount += group_.tetrahedronCount;
    takeSites(chunk, group_.endPlace);
}

/// The next sites of the group and the parts that reach among them.
void ChunkMaker::takeSlice(MergedChunk& chunk)
{
    const MergedBatch& batch = merge_.batch();
    const std::uint32_t endPlace = std::min(place_ + sliceSites_, group_.endPlace);
    for (std::size_t number = part_; number < group_.endPart; ++number) {
        const MergedBatch::Part& part = batch.parts[number];
        const auto places = std::span(batch.places).subspan(part.firstPlace, part.siteCount);
        // A part's sites are in the order of their points, and so of their places.
        if (places.front() < endPlace && places.back() >= place_)
            chunk.parts.push_back(part);
    }
    chunk.slice = true;
    chunk.tetrahedronCount = sliceTetrahedra_;
    takeSites(chunk, endPlace);
}

void ChunkMaker::takeSites(MergedChunk& chunk, std::uint32_t endPlace)
{
    const MergedBatch& batch = merge_.batch();
    sites_ += endPlace - place_;
    for (; place_ < endPlace; ++place_) {
        chunk.points.push_back(batch.points[place_]);
        chunk.runningKeys.push_back(batch.runningKey);
        chunk.groupGoesOn.push_back(batch.groupGoesOn[place_]);
        chunk.meshSizes.push_back(static_cast<std::uint32_t>(meshSize_));
    }
    inGroup_ = place_ < group_.endPlace;
    if (!inGroup_)
        part_ = group_.endPart;
    inBatch_ = inGroup_ || place_ < batch.points.size();
}

namespace {

/// Reads and translates them. Any number of threads may do that with chunks of their own. May throw std::bad_alloc.
Result<TranslatedStars> translateStars(const MergedChunk& chunk, const RunFiles& runs, const MergedNumbers& numbers)
{
    ChunkReader reader(chunk, runs);
    if (const Status read = reader.read(); !read)
        return read.error();
    std::vector<Translated> tetrahedra;
    tetrahedra.reserve(chunk.tetrahedronCount);
    for (std::size_t number = 0; number < chunk.parts.size(); ++number) {
        const MergedBatch::Part& part = chunk.parts[number];
        const std::uint32_t bytes = runs.header(part.block).recordBytes;
        const auto translate = bytes == sizeof(NarrowTetrahedron)   ? translatePart<NarrowTetrahedron>
                               : bytes == sizeof(WarpedTetrahedron) ? translatePart<WarpedTetrahedron>
                                                                    : translatePart<WideTetrahedron>;
        const bool right =
            translate(reader.of(number), part.tetrahedronCount, numbers.ofBlock(part.block), chunk, tetrahedra);
        if (!right)
            return unfitStars();
    }
    TranslatedStars stars;
    if (const Status sorted = sortIntoStars(tetrahedra, chunk, stars); !sorted)
        return sorted.error();
    return stars;
}

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
    StarPipeline(const RunFiles& runs, const MergedNumbers& numbers, ModelFileWriter& writer, const Progress& progress,
                 std::uint64_t sliceTetrahedra)
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
    ModelFileWriter& writer_;
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
        fail(cancelledError(Message::marked("Merging the blocks")));
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
    using format::SectionId;
    for (const Status& written :
         {writer_.addPoints(chunk.points), writer_.addStarSizes(stars.starSizes),
          writer_.add<float>(SectionId::SiteRunningKeys, chunk.runningKeys),
          writer_.add<std::uint8_t>(SectionId::SiteGroups, chunk.groupGoesOn),
          writer_.add<std::uint32_t>(SectionId::MeshSizes, chunk.meshSizes), writer_.addOtherSites(stars.otherSites),
          writer_.add<std::uint32_t>(SectionId::Destroyers, stars.destroyers),
          writer_.add<std::uint16_t>(SectionId::OwnErrors, stars.ownErrors),
          canWarp(writer_.description().domain) ? writer_.add<std::uint16_t>(SectionId::OwnWarpings, stars.ownWarpings)
                                                : Status()})
        if (!written)
            return fail(written.error());
    const auto sites = static_cast<double>(chunk.firstSite) + static_cast<double>(chunk.points.size());
    progress_.report(sites / numbers_.siteCount(), Message::marked("Merging the blocks"));
}

void StarPipeline::fail(const Error& error)
{
    const std::lock_guard lock(mutex_);
    if (status_)
        status_ = error;
    failed_ = true;
}

Result<FixedCounts> merge(const RunFiles& runs, const std::filesystem::path& workFolder, const ModelFileOpener& open,
                          const Progress& progress, std::uint64_t sliceTetrahedra)
{
    if (const Status complete = runs.checkComplete(); !complete)
        return complete.error();
    FixedCounts counts;
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
    const Result<std::unique_ptr<ModelFileWriter>> writer = open(counts);
    if (!writer)
        return writer.error();
    const Progress writing = progress.part(numberedShare, 1);
    if (const Status merged = StarPipeline(runs, *numbers, **writer, writing, sliceTetrahedra).run(); !merged)
        return merged.error();
    if (progress.cancelled())
        return cancelledError(Message::marked("Merging the blocks"));
    if (const Status finished = (*writer)->finish(finalKey); !finished)
        return finished.error();
    return counts;
}

/// What lives to the end of the chunk's stars.
Status handLiving(const MergedChunk& chunk, const TranslatedStars& stars, const RunUnits& units, HistorySink& sink)
{
    std::vector<HistoryTetrahedron> living;
    std::size_t tetrahedron = 0;
    for (std::size_t site = 0; site < chunk.points.size(); ++site) {
        living.clear();
        for (const std::size_t end = tetrahedron + stars.starSizes[site]; tetrahedron < end; ++tetrahedron)
            if (stars.destroyers[tetrahedron] == Model::never)
                living.push_back({stars.otherSites[tetrahedron],
                                  roundedUp(halfToFloat(stars.ownErrors[tetrahedron]) * units.valueExtent),
                                  roundedUp(halfToFloat(stars.ownWarpings[tetrahedron]) * units.diagonal)});
        if (const Status added = sink.add({chunk.points[site], std::numeric_limits<float>::infinity(), living, {}});
            !added)
            return added;
    }
    return {};
}

Status handAll(const RunFiles& runs, const std::filesystem::path& workFolder, const RunUnits& units, HistorySink& sink,
               const Progress& progress)
{
    const Result<MergedNumbers> numbers = MergedNumbers::make(runs, workFolder, progress);
    if (!numbers)
        return numbers.error();
    if (const Status begun = sink.begin({.warpingWeight = units.warpingWeight, .delaunay = false}); !begun)
        return begun;
    ChunkMaker maker(runs);
    for (;;) {
        const Result<MergedChunk> chunk = maker.next();
        if (!chunk)
            return chunk.error();
        if (chunk->points.empty())
            break;
        if (progress.cancelled())
            return cancelledError(Message::marked("Merging the blocks"));
        const Result<TranslatedStars> stars = translateStars(*chunk, runs, *numbers);
        if (!stars)
            return stars.error();
        if (const Status handed = handLiving(*chunk, *stars, units, sink); !handed)
            return handed;
    }
    float finalKey = 0;
    for (std::uint32_t block = 0; block < runs.blockCount(); ++block)
        finalKey = std::max(finalKey, runs.header(block).finalKey);
    return sink.finish(finalKey);
}

constexpr MarkedText noMemoryToMerge =
    Message::marked("Not enough memory to merge the blocks. Close other programs, or choose a larger error.");

} // namespace

Result<FixedCounts> mergeRuns(const RunFiles& runs, const std::filesystem::path& workFolder,
                              const ModelFileOpener& open, const Progress& progress, std::uint64_t sliceTetrahedra)
{
    return guarded(noMemoryToMerge, [&] { return merge(runs, workFolder, open, progress, sliceTetrahedra); });
}

Status handMesh(const RunFiles& runs, const std::filesystem::path& workFolder, const RunUnits& units, HistorySink& sink,
                const Progress& progress)
{
    return guarded(noMemoryToMerge, [&] {
        const Status complete = runs.checkComplete();
        return complete ? handAll(runs, workFolder, units, sink, progress) : complete;
    });
}

} // namespace tetra
