// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/helper/zarr_samples.h"

#include "plugins/process/process_limits.h"
#include "plugins/readers/zarr/helper/zarr_shard.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace tetra {
namespace {

/// Chunks that have to do with a selection, by their numbers along each axis; the last axis runs fastest.
struct ChunkRange {
    std::vector<std::uint64_t> first, counts;

    std::uint64_t size() const
    {
        std::uint64_t all = 1;
        for (const std::uint64_t count : counts)
            all *= count; // not more than points, if the range is of the whole array
        return all;
    }
    /// To the next numbers; false behind the last ones.
    bool advance(std::vector<std::uint64_t>& numbers) const
    {
        for (std::size_t axis = numbers.size(); axis-- > 0;) {
            if (++numbers[axis] < first[axis] + counts[axis])
                return true;
            numbers[axis] = first[axis];
        }
        return false;
    }
};

/// Those of this shape in a box of the array, which begins at `from`, a place where chunks do, and has `size` elements.
ChunkRange chunksOf(const ZarrArray& array, const ZarrSelection& selection, const std::vector<std::uint64_t>& shape,
                    const std::vector<std::uint64_t>& from, const std::vector<std::uint64_t>& size)
{
    ChunkRange range;
    for (std::size_t axis = 0; axis < shape.size(); ++axis) {
        const bool isWhole = std::ranges::find(selection.axes, axis) != selection.axes.end();
        const std::uint64_t inside = std::min(size[axis], array.shape[axis] - from[axis]);
        range.first.push_back(isWhole ? 0 : (selection.numbers[axis] - from[axis]) / shape[axis]);
        range.counts.push_back(isWhole ? (inside - 1) / shape[axis] + 1 : 1);
    }
    return range;
}

std::vector<std::uint64_t> firstElement(const std::vector<std::uint64_t>& numbers,
                                        const std::vector<std::uint64_t>& shape, const std::vector<std::uint64_t>& from)
{
    std::vector<std::uint64_t> first = from;
    for (std::size_t axis = 0; axis < first.size(); ++axis)
        first[axis] += numbers[axis] * shape[axis];
    return first;
}

/// What is on the disk of the chunks.
struct ChunkFiles {
    std::uint64_t there = 0, bytes = 0;
};

Result<ChunkFiles> lookAtChunks(const ZarrFolder& folder, const ZarrArray& array, const ChunkRange& range)
{
    constexpr std::uint64_t mostInVain = std::uint64_t(1) << 16U;
    ChunkFiles files;
    std::vector<std::uint64_t> numbers = range.first;
    std::uint64_t looked = 0;
    do {
        const auto size = folder.fileSize(zarrPath(array.path, chunkName(array, numbers)));
        if (!size)
            return size.error();
        files.there += *size ? 1 : 0;
        files.bytes += size->value_or(0);
    } while (range.advance(numbers) && (++looked < mostInVain || files.there > 0));
    return files;
}

/// Reads chunk after chunk.
class ChunkReading {
public:
    ChunkReading(const ZarrFolder& folder, const ZarrArray& array, const ZarrSelection& selection, std::byte* samples)
        : folder_(folder), array_(array), selection_(selection), samples_(samples),
          origin_(array.shape.size(), std::uint64_t(0)),
          chunkBytes_(array.chunks.numberCount() * storedSize(array.number))
    {
    }

    /// A file with a chunk, or with many.
    Status readFile(const std::vector<std::uint64_t>& numbers)
    {
        const std::string name = zarrPath(array_.path, chunkName(array_, numbers));
        const auto file = folder_.file(name);
        if (!file)
            return file.error();
        const std::vector<std::uint64_t> first = firstElement(numbers, array_.fileShape(), origin_);
        if (!*file) {
            const std::uint64_t lost = array_.shards ? inShard(first).size() : 1;
            all_ += lost;
            missing_ += lost;
            fillChunk(array_, selection_, first, array_.fileShape(), samples_);
            return {};
        }
        const Status read = array_.shards ? readShard((*file)->bytes(), first) : readChunk((*file)->bytes(), first);
        if (read && (*file)->damaged())
            return Error{ErrorKind::BadInput,
                         Message::say("its file '%1' was changed while it was read. Try again.", printable(name))};
        return read
                   ? Status()
                   : Error{read.error().kind, Message::say("its file '%1': %2", printable(name), read.error().message)};
    }
    std::uint64_t missing() const { return missing_; }
    std::uint64_t all() const { return all_; }

private:
    ChunkRange inShard(const std::vector<std::uint64_t>& first) const
    {
        return chunksOf(array_, selection_, array_.chunks.shape, first, array_.shards->shape);
    }

    Status readShard(std::span<const std::byte> bytes, const std::vector<std::uint64_t>& shard)
    {
        const auto index = ShardIndex::of(array_, bytes);
        if (!index)
            return index.error();
        const ChunkRange range = inShard(shard);
        std::vector<std::uint64_t> numbers = range.first;
        do {
            const auto chunk = index->chunk(numbers);
            if (!chunk)
                return chunk.error();
            const std::vector<std::uint64_t> first = firstElement(numbers, array_.chunks.shape, shard);
            if (*chunk) {
                if (const Status read = readChunk(**chunk, first); !read)
                    return read;
            } else {
                ++all_;
                ++missing_;
                fillChunk(array_, selection_, first, array_.chunks.shape, samples_);
            }
        } while (range.advance(numbers));
        return {};
    }

    Status readChunk(std::span<const std::byte> bytes, const std::vector<std::uint64_t>& first)
    {
        ++all_;
        const auto numbers = unpacking_.unpack(bytes, array_.chunks.codecs, chunkBytes_);
        if (!numbers)
            return numbers.error();
        copyChunk(array_, selection_, first, *numbers, samples_);
        return {};
    }

    const ZarrFolder& folder_;
    const ZarrArray& array_;
    const ZarrSelection& selection_;
    std::byte* samples_;
    std::vector<std::uint64_t> origin_;
    std::uint64_t chunkBytes_;
    ChunkUnpacking unpacking_;
    std::uint64_t missing_ = 0, all_ = 0;
};

/// 64-bit whole numbers as 32-bit ones if all fit, else as doubles: in their place.
template <class T> void shorten(ZarrSamples& found)
{
    const std::size_t count = found.samples.size() / sizeof(T);
    const auto at = [&](std::size_t number) {
        T value{};
        std::memcpy(&value, found.samples.data() + number * sizeof(T), sizeof value);
        return value;
    };
    bool areSigned = true, areUnsigned = true;
    for (std::size_t number = 0; number < count; ++number) {
        areSigned = areSigned && std::in_range<std::int32_t>(at(number));
        areUnsigned = areUnsigned && std::in_range<std::uint32_t>(at(number));
    }
    std::uint64_t rounded = 0;
    const auto keepAs = [&]<class To>(To) {
        for (std::size_t number = 0; number < count; ++number) {
            const auto value = static_cast<To>(at(number));
            std::memcpy(found.samples.data() + number * sizeof(To), &value, sizeof value);
        }
        found.samples.resize(count * sizeof(To));
        found.type = sampleTypeOf<To>();
    };
    if (areSigned)
        return keepAs(std::int32_t());
    if (areUnsigned)
        return keepAs(std::uint32_t());
    for (std::size_t number = 0; number < count; ++number) {
        const auto value = static_cast<double>(at(number));
        const bool isBeyond = value >= 2.0 * (std::uint64_t(1) << (std::numeric_limits<T>::digits - 1));
        rounded += isBeyond || static_cast<T>(value) != at(number) ? 1 : 0;
    }
    keepAs(double());
    if (rounded > 0)
        found.remarks.push_back(Message::say("%1 whole numbers of 64 bits were rounded to double precision.", rounded));
}

/// The chunks' files by the other separator, where the metadata do not say it and none is there by the usual one.
Result<ChunkFiles> findChunks(const ZarrFolder& folder, const ChunkRange& range, ZarrArray& array)
{
    auto files = lookAtChunks(folder, array, range);
    if (files && files->there == 0 && !array.separatorIsSaid) {
        const char usual = std::exchange(array.separator, '/');
        files = lookAtChunks(folder, array, range);
        if (files && files->there == 0)
            array.separator = usual;
    }
    if (files && files->there == 0)
        return Error{ErrorKind::BadInput,
                     Message::say("none of the %1 files with its values exists, such as '%2'. The copy is not "
                                  "complete, or they were never written: copy or export it again.",
                                  range.size(), printable(zarrPath(array.path, chunkName(array, range.first))))};
    return files;
}

void tellMissing(const ZarrArray& array, std::uint64_t missing, std::uint64_t all, ZarrSamples& found)
{
    if (missing == 0)
        return;
    const std::string fill = keptNumberText(array.number, array.fill);
    found.remarks.push_back(
        array.fillIsSaid
            ? Message::say(
                  "%1 of its %2 chunks are missing: as the format specifies, their values are the fill value %3.",
                  missing, all, fill)
            : Message::say("%1 of its %2 chunks are missing, and it has no fill value: %3 is assumed.", missing, all,
                           fill));
}

} // namespace

Result<ZarrSamples> readZarrSamples(const ZarrFolder& folder, ZarrArray array, const ZarrSelection& selection,
                                    const TellProgress& progress)
{
    constexpr std::uint64_t mostFiles = std::uint64_t(1) << 20U, tellEvery = 16; // each is looked for, some 20 µs
    const auto size = selection.sizeIn(array);
    const std::uint64_t points = size[0] * size[1] * size[2];
    const std::vector<std::uint64_t> origin(array.shape.size());
    const ChunkRange range = chunksOf(array, selection, array.fileShape(), origin, array.shape);
    if (range.size() > mostFiles)
        return Error{
            ErrorKind::OutOfResource,
            Message::say("it lies in %1 files, more than %2. Write it in larger chunks.", range.size(), mostFiles)};
    const auto files = findChunks(folder, range, array);
    if (!files)
        return files.error();
    const std::uint64_t chunkBytes = array.chunks.numberCount() * storedSize(array.number);
    const std::uint64_t unpacked = points * keptSize(array.number) + std::min(chunkBytes, ~std::uint64_t(0) >> 2U);
    limitWork(limitsFor(files->bytes, unpacked, physicalBytes()));
    ZarrSamples found;
    found.samples.resize(points * keptSize(array.number));
    ChunkReading reading(folder, array, selection, found.samples.data());
    std::vector<std::uint64_t> numbers = range.first;
    std::uint64_t done = 0;
    do {
        if (const Status read = reading.readFile(numbers); !read)
            return read.error();
        if (++done % tellEvery == 0)
            progress(static_cast<double>(done) / static_cast<double>(range.size()));
    } while (range.advance(numbers));
    if (reading.missing() == reading.all())
        return Error{ErrorKind::BadInput,
                     Message::say("none of its %1 chunks was written. Export it again.", reading.all())};
    tellMissing(array, reading.missing(), reading.all(), found);
    if (const auto type = sampleTypeOf(array.number))
        found.type = *type;
    else if (array.number == ZarrNumber::Int64)
        shorten<std::int64_t>(found);
    else
        shorten<std::uint64_t>(found);
    return found;
}

} // namespace tetra
