// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/prefix_copy.h"

#include "core/base/checksum.h"
#include "core/base/file_writer.h"
#include "core/history/build_facts.h"
#include "core/history/derived_sections.h"
#include "core/history/lattice_frame.h"
#include "core/history/section_writer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

namespace tetra {

using format::LevelEntry;
using format::Section;
using format::SectionId;

namespace {

constexpr std::uint64_t frontAtOnce = 16 << 10;
constexpr std::uint64_t copiedAtOnce = 1 << 20;
constexpr MarkedText readingModel = Message::marked("Reading the model");

/// What a prefix takes of a section.
enum class PrefixShare { Whole, Sites, SitesAndOne, Tetrahedra };
struct PrefixPart {
    SectionId id;
    PrefixShare share;
    bool isCopied = true; ///< as it is, but for destroyers; others are written anew
};
/// In the order in which they are read: star offsets first, by which tetrahedra are checked.
constexpr PrefixPart prefixParts[] = {{SectionId::StarOffsets, PrefixShare::SitesAndOne},
                                      {SectionId::SitePoints, PrefixShare::Sites},
                                      {SectionId::SiteValues, PrefixShare::Sites},
                                      {SectionId::SiteRunningKeys, PrefixShare::Sites},
                                      {SectionId::MeshSizes, PrefixShare::Sites},
                                      {SectionId::SiteGroups, PrefixShare::Sites},
                                      {SectionId::SitePositions, PrefixShare::Sites},
                                      {SectionId::OtherSites, PrefixShare::Tetrahedra},
                                      {SectionId::Destroyers, PrefixShare::Tetrahedra},
                                      {SectionId::OwnErrors, PrefixShare::Tetrahedra},
                                      {SectionId::OwnWarpings, PrefixShare::Tetrahedra},
                                      {SectionId::HistoryKind, PrefixShare::Whole},
                                      {SectionId::Frame, PrefixShare::Whole},
                                      {SectionId::Metric, PrefixShare::Whole},
                                      {SectionId::Text, PrefixShare::Whole},
                                      {SectionId::Blocks, PrefixShare::Whole, false},
                                      {SectionId::Faults, PrefixShare::Whole, false},
                                      {SectionId::FaultyCells, PrefixShare::Whole}};

Error damagedModel(const std::string& name, const Message& what)
{
    return {ErrorKind::BadInput,
            Message::say("'%1' is damaged: %2. Copy the file again, or build it again.", name, what), name};
}

Error wrongSum(const std::string& name, const Section& section)
{
    return damagedModel(name, Message::say("the checksum of section '%1' is wrong", format::sectionName(section.id)));
}

/// A small section, checked. `most`: bytes; more are not read.
Result<Buffer<std::byte>> readSmall(const ByteSource& source, const std::string& name, const Section& section,
                                    std::span<const std::byte> front, const Progress& progress)
{
    Buffer<std::byte> bytes(section.bytes);
    if (section.offset + section.bytes <= front.size())
        std::ranges::copy(front.subspan(section.offset, section.bytes), bytes.begin());
    else if (const Status read = source.read(section.offset, bytes, progress); !read)
        return read.error();
    if (checksum(bytes) != section.checksum)
        return wrongSum(name, section);
    return bytes;
}

/// Each level has more sites than the one before, up to all.
bool makeSense(std::span<const LevelEntry> levels, const format::Header& header)
{
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
    for (const LevelEntry& level : levels) {
        if (level.sites <= sites || level.sites > header.siteCount || level.created <= tetrahedra ||
            level.created > header.tetrahedronCount || !(level.key >= 0) || !(level.error >= 0) ||
            !(level.warping >= 0))
            return false;
        sites = level.sites;
        tetrahedra = level.created;
    }
    return levels.empty() || sites == header.siteCount;
}

/// In bytes.
std::uint64_t prefixBytesOf(const PrefixPart& part, const PrefixEnd& end, const Section& section)
{
    switch (part.share) {
    case PrefixShare::Sites: return std::uint64_t(end.sites) * section.elementBytes;
    case PrefixShare::SitesAndOne: return (end.sites + std::uint64_t(1)) * section.elementBytes;
    case PrefixShare::Tetrahedra: return end.tetrahedra * section.elementBytes;
    case PrefixShare::Whole: break;
    }
    return section.bytes;
}

/// What is read of a section: the chunks that a prefix begins in, all without chunks.
std::uint64_t bytesRead(const Section& section, std::uint64_t wanted, std::uint64_t chunk)
{
    return chunk == 0 ? section.bytes : std::min(section.bytes, format::chunkCount(wanted, chunk) * chunk);
}

/// Where the checksums of each section's chunks begin in the section of these, as elements.
std::uint64_t firstSumOf(const FileLayout& layout, std::uint32_t id, std::uint64_t chunk)
{
    std::uint64_t first = 1;
    for (const Section& section : layout.sections) {
        if (section.id == id)
            break;
        if (section.id != std::uint32_t(SectionId::ChunkSums))
            first += format::chunkCount(section.bytes, chunk);
    }
    return first;
}

bool takesAll(const ModelFront& front, const PrefixEnd& end)
{
    return end.sites == front.layout.header.siteCount;
}

std::vector<ByteRange> rangesWithChunks(const ModelFront& front, const PrefixEnd& end, std::uint64_t chunk)
{
    std::vector<ByteRange> ranges;
    for (const PrefixPart& part : prefixParts) {
        if (!front.layout.has(part.id))
            continue;
        const Section& section = front.layout.section(part.id);
        const std::uint64_t bytes = bytesRead(section, prefixBytesOf(part, end, section), chunk);
        if (bytes > 0)
            ranges.push_back({section.offset, bytes});
        if (bytes == 0 || chunk == 0)
            continue;
        const std::uint64_t sums = front.layout.section(SectionId::ChunkSums).offset;
        ranges.push_back({sums + firstSumOf(front.layout, section.id, chunk) * sizeof(std::uint64_t),
                          format::chunkCount(bytes, chunk) * sizeof(std::uint64_t)});
    }
    if (chunk > 0)
        ranges.push_back({front.layout.section(SectionId::ChunkSums).offset, sizeof(std::uint64_t)});
    std::ranges::sort(ranges, {}, &ByteRange::offset);
    return ranges;
}

/// The chunks as TAn writes them; of a file that has others the first of its sums tells.
std::uint64_t expectedChunk(const ModelFront& front)
{
    return front.layout.has(SectionId::ChunkSums) ? format::chunkBytes : 0;
}

class PrefixCopier {
public:
    PrefixCopier(const ByteSource& source, const std::string& name, const ModelFront& front, const PrefixEnd& end,
                 const Progress& progress)
        : source_(source), name_(name), front_(front), end_(end), progress_(progress)
    {
    }

    Status run(const std::filesystem::path& output);

private:
    Status findChunks();
    Status copyWhole(FileWriter file);
    Status copyBytes(FileWriter& file, std::uint64_t from, std::uint64_t end, Checksum* sum);
    Status copyPart(const PrefixPart& part, SectionWriter& sections);
    Status readPart(const Section& section, std::uint64_t wanted,
                    const std::function<Status(std::span<std::byte> piece)>& take);
    Status take(SectionId id, std::span<std::byte> piece);
    template <class Element, class Check> Status takeEach(std::span<std::byte> piece, const Check& check);
    Status tell(std::uint64_t bytes);
    Error makesNoSense(SectionId id) const
    {
        return damagedModel(
            name_, Message::say("section '%1' is invalid", format::sectionName(static_cast<std::uint32_t>(id))));
    }
    bool needsPositions() const { return front_.layout.has(SectionId::Faults); }

    const ByteSource& source_;
    const std::string& name_;
    const ModelFront& front_;
    const PrefixEnd& end_;
    const Progress& progress_;
    std::uint64_t chunk_ = 0;
    std::uint64_t done_ = 0;
    std::uint64_t all_ = 1;
    std::vector<std::uint64_t> offsets_;
    std::array<std::uint32_t, 3> blockCells_{};
    KnownFaults faults_;
    // Where take() is in its section:
    std::uint64_t number_ = 0;
    std::uint32_t creator_ = 0;
    float key_ = 0;
};

Status PrefixCopier::run(const std::filesystem::path& output)
{
    Result<FileWriter> file = FileWriter::create(output);
    if (!file)
        return file.error();
    if (const Status found = findChunks(); !found)
        return found;
    if (takesAll(front_, end_))
        return copyWhole(*std::move(file));
    SectionWriter sections(*std::move(file));
    std::vector<PlannedSection> planned{{SectionId::LevelIndex, sizeof(LevelEntry), format::mostLevels, 0, true}};
    for (const FrameSection& section : frameSections(front_.description))
        planned.push_back({section.id, sizeof(double), section.numbers.size()});
    planned.push_back({SectionId::Text, 1, front_.layout.section(SectionId::Text).bytes});
    const auto isPlanned = [&](SectionId id) {
        return std::ranges::find(planned, id, &PlannedSection::id) != planned.end();
    };
    for (const PrefixPart& part : prefixParts)
        if (part.isCopied && !isPlanned(part.id) && front_.layout.has(part.id)) {
            const Section& section = front_.layout.section(part.id);
            planned.push_back({part.id, section.elementBytes, prefixBytesOf(part, end_, section) / section.elementBytes,
                               section.flags});
        }
    if (const Status laidOut = sections.plan(planned); !laidOut)
        return laidOut;
    for (const PrefixPart& part : prefixParts)
        if (front_.layout.has(part.id))
            if (const Status copied = copyPart(part, sections); !copied)
                return copied;
    const DerivedFrom from{.faults = needsPositions() ? &faults_ : nullptr,
                           .description = front_.description,
                           .counts = {end_.sites, end_.tetrahedra},
                           .finalKey = end_.key,
                           .blockCells = blockCells_};
    if (const Status derived = writeDerivedSections(sections, from); !derived)
        return derived;
    format::Header header = headerOf(front_.description);
    header.siteCount = end_.sites;
    header.tetrahedronCount = end_.tetrahedra;
    header.finalKey = end_.key;
    return sections.finish(header);
}

/// Has everything ready. A file whose chunks have another size than expected is asked once more.
Status PrefixCopier::findChunks()
{
    chunk_ = expectedChunk(front_);
    const auto ready = [this] {
        const std::vector<ByteRange> ranges =
            takesAll(front_, end_) ? prefixRanges(front_, end_) : rangesWithChunks(front_, end_, chunk_);
        for (const ByteRange& range : ranges)
            all_ += range.size;
        return source_.fetch(ranges, progress_.part(0, 0.5));
    };
    if (const Status fetched = ready(); !fetched || chunk_ == 0 || takesAll(front_, end_))
        return fetched;
    const Section& sums = front_.layout.section(SectionId::ChunkSums);
    std::uint64_t chunk = 0;
    if (sums.bytes < sizeof chunk)
        return makesNoSense(SectionId::ChunkSums);
    if (const Status read = source_.read(sums.offset, std::as_writable_bytes(std::span(&chunk, 1)), progress_); !read)
        return read;
    if (!std::has_single_bit(chunk) || chunk < format::leastChunkBytes || chunk > format::mostChunkBytes ||
        firstSumOf(front_.layout, 0, chunk) * sizeof chunk != sums.bytes)
        return makesNoSense(SectionId::ChunkSums);
    return std::exchange(chunk_, chunk) == chunk ? Status() : ready();
}

Status PrefixCopier::tell(std::uint64_t bytes)
{
    done_ += bytes;
    progress_.report(0.5 + 0.5 * std::min(1.0, static_cast<double>(done_) / static_cast<double>(all_)), readingModel);
    return progress_.cancelled() ? Status(cancelledError(readingModel)) : Status();
}

Status PrefixCopier::copyWhole(FileWriter file)
{
    std::uint64_t at = 0;
    for (const Section& section : front_.layout.sections) {
        Checksum sum;
        if (const Status copied = copyBytes(file, at, section.offset, nullptr); !copied)
            return copied;
        at = section.offset + section.bytes;
        if (const Status copied = copyBytes(file, section.offset, at, &sum); !copied)
            return copied;
        if (sum.value() != section.checksum)
            return wrongSum(name_, section);
    }
    return file.commit();
}

Status PrefixCopier::copyBytes(FileWriter& file, std::uint64_t from, std::uint64_t end, Checksum* sum)
{
    Buffer<std::byte> piece;
    for (; from < end; from += piece.size()) {
        piece.resize(std::min(copiedAtOnce, end - from));
        if (const Status read = source_.read(from, piece, progress_); !read)
            return read;
        if (sum != nullptr)
            sum->add(piece);
        if (const Status written = file.write(piece); !written)
            return written;
        if (const Status goOn = tell(piece.size()); !goOn)
            return goOn;
    }
    return {};
}

Status PrefixCopier::copyPart(const PrefixPart& part, SectionWriter& sections)
{
    const Section& section = front_.layout.section(part.id);
    number_ = 0;
    creator_ = 0;
    return readPart(section, prefixBytesOf(part, end_, section), [&](std::span<std::byte> piece) {
        const Status taken = take(part.id, piece);
        return taken && part.isCopied ? sections.add(part.id, piece) : taken;
    });
}

/// Hands the first bytes of a section on, in pieces of whole elements; what a checksum covers beyond them is read, too.
Status PrefixCopier::readPart(const Section& section, std::uint64_t wanted,
                              const std::function<Status(std::span<std::byte> piece)>& take)
{
    const std::uint64_t toRead = bytesRead(section, wanted, chunk_);
    const std::uint64_t sumsAt = chunk_ == 0
                                     ? 0
                                     : front_.layout.section(SectionId::ChunkSums).offset +
                                           firstSumOf(front_.layout, section.id, chunk_) * sizeof(std::uint64_t);
    const std::uint64_t atOnce = copiedAtOnce - copiedAtOnce % std::max(section.elementBytes, 1u);
    Buffer<std::byte> piece;
    Checksum sum;
    std::uint64_t chunks = 0;
    for (std::uint64_t at = 0; at < toRead; at += piece.size()) {
        piece.resize(std::min(atOnce, toRead - at));
        if (const Status read = source_.read(section.offset + at, piece, progress_); !read)
            return read;
        for (std::uint64_t summed = at; summed < at + piece.size();) {
            const std::uint64_t stop = chunk_ == 0 ? toRead : std::min((chunks + 1) * chunk_, toRead);
            const std::uint64_t end = std::min<std::uint64_t>(stop, at + piece.size());
            sum.add(std::span(piece).subspan(summed - at, end - summed));
            summed = end;
            if (end < stop)
                continue;
            std::uint64_t right = section.checksum;
            if (chunk_ > 0)
                if (const Status read = source_.read(sumsAt + chunks * sizeof right,
                                                     std::as_writable_bytes(std::span(&right, 1)), progress_);
                    !read)
                    return read;
            if (sum.value() != right)
                return wrongSum(name_, section);
            sum.reset();
            ++chunks;
        }
        if (at < wanted)
            if (const Status taken = take(std::span(piece).first(std::min<std::uint64_t>(piece.size(), wanted - at)));
                !taken)
                return taken;
        if (const Status goOn = tell(piece.size()); !goOn)
            return goOn;
    }
    return {};
}

/// Calls check(element) for each; false says that the section makes no sense.
template <class Element, class Check> Status PrefixCopier::takeEach(std::span<std::byte> piece, const Check& check)
{
    for (std::size_t at = 0; at + sizeof(Element) <= piece.size(); at += sizeof(Element), ++number_) {
        Element element;
        std::memcpy(static_cast<void*>(&element), piece.data() + at, sizeof element);
        if (!check(element))
            return Error{ErrorKind::BadInput, {}};
        std::memcpy(piece.data() + at, static_cast<const void*>(&element), sizeof element);
    }
    return {};
}

/// Checks elements, and makes of them what they are in the prefix.
Status PrefixCopier::take(SectionId id, std::span<std::byte> piece)
{
    const auto creator = [this] {
        while (offsets_[creator_ + 1] <= number_)
            ++creator_;
        return creator_;
    };
    const std::uint32_t last = end_.sites - 1;
    const auto checked = [&]() -> Status {
        switch (id) {
        case SectionId::StarOffsets:
            return takeEach<std::uint64_t>(piece, [&](std::uint64_t offset) {
                const bool fits = (offsets_.empty() ? offset == 0 : offset >= offsets_.back()) &&
                                  (number_ <= last ? offset <= end_.tetrahedra : offset == end_.tetrahedra);
                offsets_.push_back(offset);
                return fits;
            });
        case SectionId::SitePoints:
            return takeEach<std::uint32_t>(
                piece, [&](std::uint32_t point) { return point < front_.description.lattice.pointCount(); });
        case SectionId::SiteRunningKeys:
            return takeEach<float>(piece, [&](float key) {
                const bool falls = number_ == 0 ? std::isinf(key) && key > 0 : key <= key_;
                key_ = key;
                return falls && (number_ < last ? key >= end_.key : key > end_.key);
            });
        case SectionId::SiteGroups:
            return takeEach<std::uint8_t>(piece,
                                          [&](std::uint8_t goesOn) { return goesOn <= (number_ < last ? 1 : 0); });
        case SectionId::SitePositions:
            if (!needsPositions())
                return {};
            if (front_.layout.section(id).elementBytes == sizeof(Eigen::Vector3d))
                return takeEach<std::array<double, 3>>(piece, [&](const std::array<double, 3>& place) {
                    faults_.sitePositions.emplace_back(place.data());
                    return true;
                });
            return takeEach<std::array<float, 3>>(piece, [&](const std::array<float, 3>& place) {
                faults_.sitePositions.emplace_back(place[0], place[1], place[2]);
                return true;
            });
        case SectionId::OtherSites:
            return takeEach<std::array<std::uint32_t, 3>>(
                piece, [&](const std::array<std::uint32_t, 3>& sites) { return std::ranges::max(sites) < creator(); });
        case SectionId::Destroyers:
            return takeEach<std::uint32_t>(piece, [&](std::uint32_t& destroyer) {
                const bool isLater = destroyer > creator();
                destroyer = destroyer < end_.sites ? destroyer : Model::never;
                return isLater;
            });
        case SectionId::HistoryKind:
            return takeEach<std::uint32_t>(
                piece, [](std::uint32_t kind) { return kind == std::uint32_t(format::HistoryKind::ClosedSetsOnly); });
        case SectionId::Blocks:
            return takeEach<std::uint32_t>(piece, [&](std::uint32_t cells) {
                blockCells_[number_] = cells;
                return cells > 0;
            });
        case SectionId::Faults:
            return takeEach<format::Fault>(piece, [&](const format::Fault& fault) {
                if (fault.kind < std::uint32_t(format::FaultKind::InvertedTetrahedron))
                    faults_.ofCells.push_back(fault);
                return true;
            });
        default: return {};
        }
    }();
    return checked ? checked : Status(makesNoSense(id));
}

} // namespace

Result<ModelFront> readFront(const ByteSource& source, const std::string& name, const Progress& progress)
{
    Buffer<std::byte> bytes(std::min(source.size, frontAtOnce));
    if (const Status read = source.read(0, bytes, progress); !read)
        return read.error();
    if (const std::uint64_t needed = std::min(frontBytes(bytes), source.size); needed > bytes.size()) {
        bytes.resize(needed);
        if (const Status read = source.read(0, bytes, progress); !read)
            return read.error();
    }
    Result<FileLayout> layout = readLayout(bytes, source.size, name);
    if (!layout)
        return layout.error();
    ModelFront front{*std::move(layout), {}, {}};
    front.description = descriptionOf(front.layout.header);
    front.description.delaunay = !front.layout.has(SectionId::HistoryKind);
    const auto text = readSmall(source, name, front.layout.section(SectionId::Text), bytes, progress);
    if (!text)
        return text.error();
    readText({reinterpret_cast<const char*>(text->data()), text->size()}, front.description);
    for (const SectionId id : frameSectionIds) {
        if (!front.layout.has(id))
            continue;
        const Section& section = front.layout.section(id);
        const auto numbers = readSmall(source, name, section, bytes, progress);
        if (!numbers)
            return numbers.error();
        if (!takeFrameSection(id, *numbers, front.description))
            return damagedModel(name, Message::say("section '%1' is invalid", format::sectionName(section.id)));
    }
    if (!front.layout.has(SectionId::LevelIndex))
        return front;
    const Section& index = front.layout.section(SectionId::LevelIndex);
    const auto levels = readSmall(source, name, index, bytes, progress);
    if (!levels)
        return levels.error();
    front.levels.resize(levels->size() / sizeof(LevelEntry));
    if (!levels->empty())
        std::memcpy(static_cast<void*>(front.levels.data()), levels->data(), levels->size());
    if (!makeSense(front.levels, front.layout.header))
        return damagedModel(name, Message::say("section '%1' is invalid", format::sectionName(index.id)));
    return front;
}

namespace {

PrefixEnd endOfLevel(const LevelEntry& level)
{
    return {level.sites, level.created, level.key};
}

PrefixEnd endOfWhole(const ModelFront& front)
{
    const format::Header& header = front.layout.header;
    return {header.siteCount, header.tetrahedronCount, header.finalKey};
}

} // namespace

PrefixEnd prefixFor(const ModelFront& front, const Accuracy& accuracy)
{
    const double error = accuracy.error / 100 * front.description.range.extent();
    const double warping = accuracy.warping / 100 * front.description.bounds.diagonal().norm();
    // What such a model tells of error and warping apart holds from one side only.
    const double weight = buildFacts(front.description).claimsTwoSides ? front.description.warpingWeight : 0;
    const auto found = std::ranges::find_if(front.levels, [&](const LevelEntry& level) {
        const auto key = static_cast<double>(level.key);
        return weight > 0 ? key <= error && key <= weight * warping
                          : static_cast<double>(level.error) <= error && static_cast<double>(level.warping) <= warping;
    });
    return found != front.levels.end() ? endOfLevel(*found) : endOfWhole(front);
}

PrefixEnd prefixWithin(const ModelFront& front, std::uint64_t bytes)
{
    if (front.levels.empty())
        return endOfWhole(front);
    // The more sites, the more bytes.
    const auto fits = [&](const LevelEntry& level) {
        std::uint64_t sum = 0;
        for (const ByteRange& range : prefixRanges(front, endOfLevel(level)))
            sum += range.size;
        return sum <= bytes;
    };
    const auto beyond = std::ranges::partition_point(front.levels, fits);
    return endOfLevel(beyond == front.levels.begin() ? front.levels.front() : *std::prev(beyond));
}

PrefixEnd prefixFor(const Model& model, const Accuracy& accuracy)
{
    const std::uint32_t sites = meshSizeAt(model, accuracy).sites;
    const bool isAll = sites >= model.siteCount();
    return {sites, model.starOffsets()[sites], isAll ? model.finalKey() : model.runningKeys()[sites]};
}

std::vector<ByteRange> prefixRanges(const ModelFront& front, const PrefixEnd& end)
{
    if (takesAll(front, end))
        return {{0, front.layout.header.fileBytes}};
    return rangesWithChunks(front, end, expectedChunk(front));
}

Status copyPrefix(const ByteSource& source, const std::string& name, const ModelFront& front, const PrefixEnd& end,
                  const std::filesystem::path& output, const Progress& progress)
{
    return PrefixCopier(source, name, front, end, progress).run(output);
}

} // namespace tetra
