// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the chosen samples of a volume: the bytes from the first to the last of them are found in the file's mapping,
// or brought together out of several files, packed ones or texts; then they are the samples, or become them.
#include "plugins/readers/lattice/stored_reading.h"

#include "plugins/readers/lattice/gzip_decoding.h"
#include "plugins/readers/lattice/stored_conversion.h"
#include "plugins/readers/lattice/stored_text.h"
#include "plugins/readers/lattice/volume_errors.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace tetra {

namespace {

namespace fs = std::filesystem;
using File = std::shared_ptr<const MappedFile>;
using Bytes = std::span<const std::byte>;

/// The part of one file's numbers that is wanted, by bytes of them as they are unpacked.
struct Part {
    std::size_t file = 0;
    std::uint64_t begin = 0, bytes = 0;
};

std::uint64_t bytesOfFile(const StoredVolume& volume)
{
    return volume.numbersOfFile() * storedSize(volume.type);
}

std::vector<Part> partsOf(const StoredVolume& volume)
{
    const StoredRange range = rangeOf(volume);
    const std::uint64_t each = volume.numbersOfFile(), size = storedSize(volume.type);
    std::vector<Part> parts;
    for (std::uint64_t file = range.begin / each; file * each < range.end; ++file) {
        const std::uint64_t begin = std::max(range.begin, file * each), end = std::min(range.end, (file + 1) * each);
        parts.push_back({static_cast<std::size_t>(file), (begin - file * each) * size, (end - begin) * size});
    }
    return parts;
}

Error cutShort(std::uint64_t has, std::uint64_t needs)
{
    return {ErrorKind::BadInput, Message::say("it has %1 bytes, and its header asks for %2. It is cut short: copy the "
                                              "file again.",
                                              has, needs)};
}

/// What is packed, of a file that is.
Result<Bytes> packedBytes(Bytes file, const StoredVolume& volume)
{
    if (volume.offset > file.size() || volume.packedBytes > file.size() - volume.offset)
        return cutShort(file.size(), volume.offset + volume.packedBytes);
    const Bytes rest = file.subspan(volume.offset);
    return volume.packedBytes > 0 ? rest.first(volume.packedBytes) : rest;
}

/// Whether one file can hold its share.
Status checkFile(Bytes file, StoredPacking packing, const StoredVolume& volume)
{
    const std::uint64_t needed = bytesOfFile(volume);
    if (packing == StoredPacking::Zlib) {
        const auto packed = packedBytes(file, volume);
        if (!packed)
            return packed.error();
        return largestUnpackedSize(packed->size()) >= needed
                   ? Status()
                   : Error{ErrorKind::BadInput,
                           Message::say("its %1 bytes of compressed data cannot hold the %2 that its header asks for. "
                                        "It is cut short: copy the file again.",
                                        packed->size(), needed)};
    }
    const std::uint64_t found = file.size() - std::min<std::uint64_t>(volume.offset, file.size());
    const std::uint64_t least = packing == StoredPacking::Text ? 2 * volume.numbersOfFile() : needed;
    if (volume.offset > file.size() || found < least)
        return cutShort(file.size(), volume.offset + least);
    if (packing == StoredPacking::None && volume.mayBeWider && found - needed >= needed)
        return Error{ErrorKind::BadInput,
                     Message::say("its samples are of a type that has 4 bytes by the format, and there are %1 bytes "
                                  "for %2 samples: as many as of a type of 8 bytes. Write them as MET_INT or "
                                  "MET_LONG_LONG.",
                                  found, volume.numbersOfFile())};
    return {};
}

/// The bytes of a part of a file, into `room`.
Status decodePart(Bytes file, StoredPacking packing, const StoredVolume& volume, const Part& part,
                  std::span<std::byte> room, const Progress& progress)
{
    const std::uint64_t all = bytesOfFile(volume);
    if (packing == StoredPacking::Text)
        return readStoredText({reinterpret_cast<const char*>(file.data()) + volume.offset, file.size() - volume.offset},
                              volume.type, volume.numbersOfFile(), part.begin / storedSize(volume.type), room,
                              progress);
    if (packing == StoredPacking::Zlib) {
        const auto packed = packedBytes(file, volume);
        return packed ? unpackZlibPart(*packed, part.begin, room, all - part.begin - part.bytes, progress)
                      : packed.error();
    }
    constexpr std::size_t step = std::size_t(4) << 20;
    const Bytes from = file.subspan(volume.atEndOfFile ? file.size() - all : volume.offset).subspan(part.begin);
    for (std::size_t done = 0; done < room.size(); done += step) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        std::memcpy(room.data() + done, from.data() + done, std::min(step, room.size() - done));
        progress.report(static_cast<double>(done) / static_cast<double>(room.size()), Message::marked("Reading"));
    }
    return {};
}

/// The bytes of the chosen range, and what keeps them.
struct Range {
    Bytes bytes;
    std::shared_ptr<const void> owner;
    File file = nullptr; ///< that they lie in; null: in memory
    fs::path path{};     ///< of that file
};

Status checkUnchanged(const fs::path& path, const MappedFile& file)
{
    return file.damaged() ? Status(inFile(path, {ErrorKind::BadInput,
                                                 Message::say("it changed while it was read. Read it again.")}))
                          : Status();
}

Result<Range> decodedRange(const fs::path& opened, const StoredVolume& volume, const std::vector<Part>& parts,
                           const Progress& progress)
{
    std::uint64_t all = 0;
    for (const Part& part : parts)
        all += part.bytes;
    auto room = allocateSamples(SampleType::UInt8, all);
    if (!room)
        return inFile(opened, room.error());
    const auto share = [&](std::uint64_t done) { return static_cast<double>(done) / static_cast<double>(all); };
    std::uint64_t done = 0;
    for (const Part& part : parts) {
        const auto& [path, packing] = volume.files[part.file];
        const auto file = openVolumeFile(path);
        if (!file)
            return path == opened ? file.error() : withHeader(opened, file.error());
        Status decoded = checkFile((*file)->bytes(), packing, volume); // it may be another one by now
        if (decoded)
            decoded = decodePart((*file)->bytes(), packing, volume, part, {room->get() + done, part.bytes},
                                 progress.part(share(done), share(done + part.bytes)));
        if (const Status unchanged = checkUnchanged(path, **file); !unchanged)
            return unchanged.error();
        if (!decoded)
            return inVolume(opened, path, decoded.error());
        done += part.bytes;
    }
    return Range{{room->get(), all}, *room};
}

/// In the mapping of a file that is neither packed nor a text, if all is in one; else decoded.
Result<Range> chosenRange(const fs::path& opened, const StoredVolume& volume, const Progress& progress)
{
    const std::vector<Part> parts = partsOf(volume);
    const auto& [path, packing] = volume.files[parts.front().file];
    if (parts.size() > 1 || packing != StoredPacking::None)
        return decodedRange(opened, volume, parts, progress);
    const auto file = openVolumeFile(path);
    if (!file)
        return path == opened ? file.error() : withHeader(opened, file.error());
    const Bytes bytes = (*file)->bytes();
    if (const Status fits = checkFile(bytes, packing, volume); !fits)
        return inVolume(opened, path, fits.error());
    const std::uint64_t first = volume.atEndOfFile ? bytes.size() - bytesOfFile(volume) : volume.offset;
    return Range{bytes.subspan(first + parts.front().begin, parts.front().bytes), *file, *file, path};
}

bool isAligned(Bytes bytes, std::size_t size)
{
    return reinterpret_cast<std::uintptr_t>(bytes.data()) % size == 0;
}

} // namespace

Status checkStoredFiles(const fs::path& opened, StoredVolume& volume)
{
    for (const Part& part : partsOf(volume)) {
        const auto& [path, packing] = volume.files[part.file];
        const auto file = openVolumeFile(path);
        if (!file)
            return path == opened ? file.error() : withHeader(opened, file.error());
        const Bytes bytes = (*file)->bytes();
        if (const Status fits = checkFile(bytes, packing, volume); !fits)
            return inVolume(opened, path, fits.error());
        const std::uint64_t behind = bytes.size() - std::min<std::uint64_t>(bytes.size(), volume.offset);
        if (packing == StoredPacking::None && !volume.atEndOfFile && volume.files.size() == 1 &&
            behind > bytesOfFile(volume))
            volume.leftOut.push_back(
                Message::say("%1 bytes behind its samples were not read.", behind - bytesOfFile(volume)));
    }
    return {};
}

Result<Dataset> readStored(const fs::path& opened, const StoredVolume& volume, const Progress& progress)
{
    const auto range = chosenRange(opened, volume, progress.part(0, 0.5));
    if (!range)
        return range.error();
    // Texts became numbers of this machine's order.
    StoredVolume decoded = volume;
    if (volume.files.front().packing == StoredPacking::Text)
        decoded.order = std::endian::native;
    const std::size_t size = storedSize(volume.type);
    const bool inPlace =
        areSamples(volume) && (size == 1 || decoded.order == std::endian::native) && isAligned(range->bytes, size);
    std::vector<Message> remarks = volume.remarks;
    const Progress converting = progress.part(0.5, 1);
    auto values = inPlace ? ScalarField::scanned(*plainSampleType(volume.type), volume.lattice.pointCount(),
                                                 {range->owner, range->bytes.data()}, converting)
                          : samplesOfStored(range->bytes, decoded, remarks, converting);
    if (range->file)
        if (const Status unchanged = checkUnchanged(range->path, *range->file); !unchanged)
            return unchanged.error();
    if (!values)
        return inFile(opened, values.error());
    Dataset dataset;
    dataset.lattice = volume.lattice;
    dataset.values = *std::move(values);
    dataset.space = volume.space;
    dataset.lengthUnit = volume.lengthUnit;
    dataset.remarks = std::move(remarks);
    dataset.source = {opened.filename().string(), opened, 0, {}, volume.taken, volume.leftOut};
    if (inPlace)
        dataset.mappedFile = range->file;
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

FileContents storedContents(const StoredVolume& volume)
{
    return FileContents{.domain = DomainClass::RegularLattice,
                        .lattice = volume.lattice,
                        .points = volume.lattice.pointCount(),
                        .type = storedSampleType(volume),
                        .arrays = {{.name = {}, .components = static_cast<int>(volume.components)}},
                        .timeSteps = volume.timeSteps,
                        .taken = volume.taken,
                        .leftOut = volume.leftOut,
                        .untold = volume.untold};
}

} // namespace tetra
