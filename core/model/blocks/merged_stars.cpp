// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/blocks/merged_stars.h"

#include "core/base/buffer.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace tetra {

namespace {

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
        const std::span<std::byte> room(bytes_.data() + begin, count * runs_.header(first.block).recordBytes);
        if (const Status read = runs_.readTetrahedra(first.block, first.firstTetrahedron, count, room); !read)
            return read;
    }
    return {};
}

/// A tetrahedron in the model's numbers, the creator first.
struct Translated {
    std::array<std::uint32_t, 4> sites;
    std::uint32_t destroyer;
    std::uint16_t ownError;
};

Error unfit()
{
    return {ErrorKind::OutOfResource, "The runs of the blocks do not fit together. Start the build again."};
}

/// Translates a part's tetrahedra and appends them; false if a number makes no sense.
template <class Record> bool translatePart(const std::byte* bytes, std::uint32_t count,
                                           std::span<const std::uint32_t> numbers, std::vector<Translated>& out)
{
    const auto known = [&](std::uint32_t site) { return site < numbers.size(); };
    for (std::uint32_t i = 0; i < count; ++i) {
        Record record;
        std::memcpy(&record, bytes + i * sizeof(Record), sizeof(Record));
        const bool dies = record.destroyer != Record::never;
        if (!std::ranges::all_of(record.sites, known) || (dies && !known(record.destroyer)))
            return false;
        out.push_back({latestFirst({numbers[record.sites[0]], numbers[record.sites[1]], numbers[record.sites[2]],
                                    numbers[record.sites[3]]}),
                       dies ? numbers[record.destroyer] : Model::never, record.ownError});
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
            return unfit();
        ++stars.starSizes[place];
    }
    std::vector<std::uint32_t> next(chunk.points.size());
    std::exclusive_scan(stars.starSizes.begin(), stars.starSizes.end(), next.begin(), 0u);
    stars.otherSites.resize(tetrahedra.size());
    stars.destroyers.resize(tetrahedra.size());
    stars.ownErrors.resize(tetrahedra.size());
    for (const auto& [sites, destroyer, ownError] : tetrahedra) {
        const std::uint32_t at = next[sites[0] - chunk.firstSite]++;
        stars.otherSites[at] = {sites[1], sites[2], sites[3]};
        stars.destroyers[at] = destroyer;
        stars.ownErrors[at] = ownError;
    }
    return {};
}

} // namespace

Result<MergedChunk> ChunkMaker::next()
{
    MergedChunk chunk;
    chunk.firstSite = sites_;
    while (chunk.tetrahedronCount < tetrahedraInChunk) {
        if (!inBatch_) {
            const Result<bool> more = merge_.next();
            if (!more)
                return more.error();
            if (!*more)
                break;
            inBatch_ = true;
            place_ = 0;
            part_ = 0;
        }
        takeGroup(chunk);
        inBatch_ = place_ < merge_.batch().points.size();
    }
    return chunk;
}

void ChunkMaker::takeGroup(MergedChunk& chunk)
{
    const MergedBatch& batch = merge_.batch();
    const std::uint32_t group = batch.parts[part_].group;
    for (; part_ < batch.parts.size() && batch.parts[part_].group == group; ++part_) {
        const MergedBatch::Part& part = batch.parts[part_];
        chunk.tetrahedronCount += part.tetrahedronCount;
        meshSize_ += part.tetrahedronCount;
        meshSize_ -= part.destroyedCount;
        if (part.tetrahedronCount > 0)
            chunk.parts.push_back(part);
    }
    bool goesOn = true;
    for (; goesOn; ++place_, ++sites_) {
        goesOn = batch.groupGoesOn[place_] != 0;
        chunk.points.push_back(batch.points[place_]);
        chunk.runningKeys.push_back(batch.runningKey);
        chunk.groupGoesOn.push_back(batch.groupGoesOn[place_]);
        chunk.meshSizes.push_back(static_cast<std::uint32_t>(meshSize_));
    }
}

Result<TranslatedStars> translateStars(const MergedChunk& chunk, const RunFiles& runs, const MergedNumbers& numbers)
{
    ChunkReader reader(chunk, runs);
    if (const Status read = reader.read(); !read)
        return read.error();
    std::vector<Translated> tetrahedra;
    tetrahedra.reserve(chunk.tetrahedronCount);
    for (std::size_t number = 0; number < chunk.parts.size(); ++number) {
        const MergedBatch::Part& part = chunk.parts[number];
        const bool isNarrow = runs.header(part.block).recordBytes == sizeof(NarrowTetrahedron);
        const bool right = (isNarrow ? translatePart<NarrowTetrahedron>
                                     : translatePart<WideTetrahedron>)(reader.of(number), part.tetrahedronCount,
                                                                       numbers.ofBlock(part.block), tetrahedra);
        if (!right)
            return unfit();
    }
    TranslatedStars stars;
    if (const Status sorted = sortIntoStars(tetrahedra, chunk, stars); !sorted)
        return sorted.error();
    return stars;
}

} // namespace tetra
