// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the chosen samples of a volume: the bytes from the first to the last of them are found in the file's mapping,
// or brought together out of several files, packed ones or texts; then they are the samples, or become them.
#include "plugins/readers/lattice/stored/stored_reading.h"

#include "plugins/readers/lattice/headers/header_text.h"
#include "plugins/readers/lattice/stored/gzip_decoding.h"
#include "plugins/readers/lattice/stored/stored_conversion.h"
#include "plugins/readers/lattice/stored/stored_text.h"
#include "plugins/readers/lattice/stored/volume_errors.h"

#include <algorithm>
#include <cstring>
#include <numeric>
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

/// "3 x 4 x 5 samples of type uint8, 60 bytes".
Message described(const StoredVolume& volume)
{
    const auto& size = volume.lattice.size;
    const std::string_view type = storedTypeName(volume.type);
    if (volume.numbersOfFile() != volume.lattice.pointCount())
        return Message::say("%1 numbers of type %2, %3 bytes", volume.numbersOfFile(), type, bytesOfFile(volume));
    return Message::say("%1 x %2 x %3 samples of type %4, %5 bytes", size[0], size[1], size[2], type,
                        bytesOfFile(volume));
}

Error tooFew(const StoredVolume& volume, const Message& found)
{
    return {ErrorKind::BadInput, Message::say("it should hold %1, but there are only %2. It is cut short, or its "
                                              "description (sizes, type, bytes to skip) is wrong.",
                                              described(volume), found)};
}

Result<Bytes> skipLines(Bytes file, std::uint64_t lines)
{
    for (std::uint64_t line = 0; line < lines; ++line) {
        const std::size_t end = asText(file).find('\n');
        if (end == std::string_view::npos)
            return Error{ErrorKind::BadInput,
                         Message::say("it has only %1 of the %2 lines to be skipped. Check 'line skip'.", line, lines)};
        file = file.subspan(end + 1);
    }
    return file;
}

/// Where numbers that are not packed stand in what a file has from its first one on.
Result<Bytes> plainNumbers(Bytes found, const StoredVolume& volume)
{
    const std::uint64_t needed = bytesOfFile(volume);
    if (found.size() < needed)
        return tooFew(volume, Message::say("%1 bytes", found.size()));
    if (volume.atEndOfFile)
        return found.last(needed);
    if (volume.mayBeWider && found.size() - needed >= needed)
        return Error{
            ErrorKind::BadInput,
            Message::say("its samples are of a type that has 4 bytes by the format, and there are %1 bytes for %2 "
                         "samples: as many as for a type of 8 bytes. Write them as MET_INT or MET_LONG_LONG.",
                         found.size(), volume.numbersOfFile())};
    if (volume.rest == StoredRest::Refused && found.size() > needed)
        return Error{ErrorKind::BadInput,
                     Message::say("it should hold %1, but there are %2, %3 too many. Its description is wrong: check "
                                  "the sizes, the type and the bytes to skip.",
                                  described(volume), found.size(), found.size() - needed)};
    return found.first(needed);
}

/// What a file has from the first of its numbers on, or from the beginning of what they are packed in.
Result<Bytes> fromFirstNumber(Bytes file, const StoredVolume& volume)
{
    const auto without = [](Bytes bytes, std::uint64_t skipped) {
        return bytes.subspan(std::min<std::uint64_t>(skipped, bytes.size()));
    };
    const Bytes all = file.first(std::min<std::uint64_t>(volume.endByte.value_or(file.size()), file.size()));
    const auto behindLines = skipLines(without(all, volume.headerBytes), volume.skippedLines);
    return behindLines ? without(*behindLines, volume.offset) : behindLines;
}

/// The numbers of one file as they stand there, if it can hold them all.
Result<Bytes> storedBytes(Bytes file, StoredPacking packing, const StoredVolume& volume)
{
    const auto found = fromFirstNumber(file, volume);
    if (!found || packing == StoredPacking::None)
        return found ? plainNumbers(*found, volume) : found;
    if (packing == StoredPacking::Text)
        return found->size() / 2 + found->size() % 2 < volume.numbersOfFile()
                   ? tooFew(volume, Message::say("%1 bytes of text", found->size()))
                   : found;
    if (volume.packedBytes > found->size() || largestUnpackedSize(found->size()) < bytesOfFile(volume))
        return tooFew(volume, Message::say("%1 bytes of compressed data", found->size()));
    return volume.packedBytes > 0 ? found->first(volume.packedBytes) : found;
}

/// Of texts only every so many-th number is kept: what they become may need much more room than them.
std::uint64_t keptStep(const StoredVolume& volume)
{
    if (volume.files.size() > 1 || volume.files.front().packing != StoredPacking::Text)
        return 1;
    std::uint64_t step = volume.isMagnitude() ? volume.componentStride : 0;
    for (const std::uint64_t stride : volume.strides)
        step = std::gcd(step, stride);
    return step;
}

void toNativeOrder(std::span<std::byte> numbers, std::size_t size)
{
    for (std::size_t first = 0; size > 1 && first + size <= numbers.size(); first += size)
        std::ranges::reverse(numbers.subspan(first, size));
}

/// A part of the numbers of a file, into `room`, in the byte order of this machine.
Status decodePart(Bytes stored, StoredPacking packing, const StoredVolume& volume, const Part& part,
                  std::span<std::byte> room, const Progress& progress)
{
    constexpr std::size_t step = std::size_t(4) << 20;
    if (packing == StoredPacking::Text)
        return readStoredText(asText(stored), volume, part.begin / storedSize(volume.type), keptStep(volume), room,
                              progress);
    if (packing == StoredPacking::Zlib) {
        const std::uint64_t behind = bytesOfFile(volume) - part.begin - part.bytes;
        if (const Status unpacked = unpackPart(stored, volume.unpackedOffset + part.begin, room, behind, progress);
            !unpacked)
            return unpacked;
    }
    for (std::size_t done = 0; packing == StoredPacking::None && done < room.size(); done += step) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        std::memcpy(room.data() + done, stored.data() + part.begin + done, std::min(step, room.size() - done));
        progress.report(static_cast<double>(done) / static_cast<double>(room.size()), Message::marked("Reading"));
    }
    if (volume.order != std::endian::native)
        toNativeOrder(room, storedSize(volume.type));
    return {};
}

/// The chosen numbers: bytes, what keeps them, and the volume that describes them.
struct Range {
    Bytes bytes;
    std::shared_ptr<const void> owner;
    StoredVolume volume;
    File file = nullptr; ///< that they lie in; null: in memory
    fs::path path{};     ///< of that file
};

Status checkUnchanged(const fs::path& path, const MappedFile& file)
{
    return file.damaged() ? Status(inFile(path, {ErrorKind::BadInput,
                                                 Message::say("it changed while it was read. Read it again.")}))
                          : Status();
}

/// A file of the volume that is opened as `opened`.
Result<File> openPart(const fs::path& opened, const fs::path& path)
{
    const auto file = openVolumeFile(path);
    return file || path == opened ? file : withHeader(opened, file.error());
}

Result<Range> decodedRange(const fs::path& opened, const StoredVolume& volume, std::vector<Part> parts,
                           const Progress& progress)
{
    const std::uint64_t step = keptStep(volume), size = storedSize(volume.type);
    std::uint64_t all = 0;
    for (Part& part : parts) {
        part.bytes = (part.bytes / size + step - 1) / step * size;
        all += part.bytes;
    }
    auto room = allocateSamples(SampleType::UInt8, all);
    if (!room)
        return inFile(opened, room.error());
    const auto share = [&](std::uint64_t done) { return static_cast<double>(done) / static_cast<double>(all); };
    std::uint64_t done = 0;
    for (const Part& part : parts) {
        const auto& [path, packing] = volume.files[part.file];
        const auto file = openPart(opened, path);
        if (!file)
            return file.error();
        const auto stored = storedBytes((*file)->bytes(), packing, volume); // it may be another one by now
        const Status decoded = stored ? decodePart(*stored, packing, volume, part, {room->get() + done, part.bytes},
                                                   progress.part(share(done), share(done + part.bytes)))
                                      : stored.error();
        if (const Status unchanged = checkUnchanged(path, **file); !unchanged)
            return unchanged.error();
        if (!decoded)
            return inVolume(opened, path, decoded.error());
        done += part.bytes;
    }
    Range range{{room->get(), all}, *room, volume};
    range.volume.order = std::endian::native;
    for (std::uint64_t& stride : range.volume.strides)
        stride /= step;
    range.volume.componentStride /= step;
    return range;
}

/// In the mapping of a file that is neither packed nor a text, if all is in one; else decoded.
Result<Range> chosenRange(const fs::path& opened, const StoredVolume& volume, const Progress& progress)
{
    const std::vector<Part> parts = partsOf(volume);
    const auto& [path, packing] = volume.files[parts.front().file];
    if (parts.size() > 1 || packing != StoredPacking::None)
        return decodedRange(opened, volume, parts, progress);
    const auto file = openPart(opened, path);
    if (!file)
        return file.error();
    const auto stored = storedBytes((*file)->bytes(), packing, volume);
    if (!stored)
        return inVolume(opened, path, stored.error());
    return Range{stored->subspan(parts.front().begin, parts.front().bytes), *file, volume, *file, path};
}

bool isAligned(Bytes bytes, std::size_t size)
{
    return reinterpret_cast<std::uintptr_t>(bytes.data()) % size == 0;
}

/// They are named by part in the order of TakenPart, whatever the order in which a header tells them.
std::vector<Taken> sorted(std::vector<Taken> taken)
{
    std::ranges::stable_sort(taken, {}, &Taken::part);
    return taken;
}

} // namespace

Status checkStoredFiles(const fs::path& opened, StoredVolume& volume)
{
    for (const Part& part : partsOf(volume)) {
        const auto& [path, packing] = volume.files[part.file];
        const auto file = openPart(opened, path);
        if (!file)
            return file.error();
        const Bytes bytes = (*file)->bytes();
        if (const auto stored = storedBytes(bytes, packing, volume); !stored)
            return inVolume(opened, path, stored.error());
        const bool isTold = volume.rest == StoredRest::Told && !volume.atEndOfFile && volume.files.size() == 1;
        const auto found = fromFirstNumber(bytes, volume);
        if (isTold && packing == StoredPacking::None && found && found->size() > bytesOfFile(volume))
            volume.leftOut.push_back(
                Message::say("%1 bytes after its samples were not read.", found->size() - bytesOfFile(volume)));
    }
    return {};
}

Result<Dataset> readStored(const fs::path& opened, const StoredVolume& volume, const Progress& progress)
{
    const auto range = chosenRange(opened, volume, progress.part(0, 0.5));
    if (!range)
        return range.error();
    const StoredVolume& stored = range->volume;
    const std::size_t size = storedSize(stored.type);
    const bool inPlace =
        areSamples(stored) && (size == 1 || stored.order == std::endian::native) && isAligned(range->bytes, size);
    std::vector<Message> remarks = volume.remarks;
    const Progress converting = progress.part(0.5, 1);
    auto values = inPlace ? ScalarField::scanned(*plainSampleType(stored.type), stored.lattice.pointCount(),
                                                 {range->owner, range->bytes.data()}, converting)
                          : samplesOfStored(range->bytes, stored, remarks, converting);
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
    dataset.source = {opened.filename().string(), opened, 0, volume.valueName, sorted(volume.taken), volume.leftOut};
    if (inPlace)
        dataset.mappedFile = range->file;
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

FileContents storedContents(const StoredVolume& volume)
{
    FileContents contents{.domain = DomainClass::RegularLattice,
                          .lattice = volume.lattice,
                          .points = volume.lattice.pointCount(),
                          .type = storedSampleType(volume),
                          .arrays = volume.arrays,
                          .timeSteps = volume.timeSteps,
                          .taken = sorted(volume.taken),
                          .leftOut = volume.leftOut,
                          .untold = volume.untold};
    if (contents.arrays.empty())
        contents.arrays = {{.name = {}, .components = static_cast<int>(volume.components)}};
    return contents;
}

} // namespace tetra
