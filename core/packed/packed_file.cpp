// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/packed/packed_file.h"

#include "core/base/checksum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

namespace tetra {

using format::Header;
using format::PackedChunkHead;
using format::PackedFacts;
using format::PackedLevelEntry;
using format::PackedSum;
using format::Section;
using format::SectionId;

namespace {

template <class T> std::span<const std::byte> bytesOfAll(const std::vector<T>& elements)
{
    return std::as_bytes(std::span(elements));
}

/// Whether levels can be those of a model of this header.
bool levelsMakeSense(std::span<const PackedLevelEntry> levels, const Header& header, PackMethod method,
                     std::uint64_t chunkBytes)
{
    // A replayed model's levels have sites of their own.
    const bool own = method == PackMethod::Replayed;
    const ModelDescription about = descriptionOf(header);
    const std::uint64_t fewest = fewestSites(about.domain);
    const std::uint64_t most = own ? about.lattice.pointCount() : header.siteCount;
    const PackedLevelEntry* before = nullptr;
    for (const PackedLevelEntry& level : levels) {
        const bool bounds = level.error >= 0 && std::isfinite(level.error) && level.warping >= 0 &&
                            std::isfinite(level.warping) && level.sites >= fewest && level.sites <= most &&
                            level.chunkBytes <= chunkBytes && level.chunkBytes > sizeof(PackedChunkHead) &&
                            level.replayLevel < format::mostPackedLevels;
        const bool order =
            before == nullptr || (before->sites < level.sites && before->chunkBytes <= level.chunkBytes &&
                                  before->error >= level.error && (!own || before->replayLevel < level.replayLevel));
        if (!bounds || !order)
            return false;
        before = &level;
    }
    return !levels.empty() && levels.size() <= format::mostPackedLevels &&
           (own || levels.back().sites == header.siteCount);
}

/// Whether a model of this header can have so many bytes. What a model keeps of a site, a sample or a tetrahedron takes
/// a small part of what is allowed for each (FORMAT.md); the rest is for faulty cells, which the header does not count.
bool sizeMakesSense(std::uint64_t bytes, const Header& header)
{
    constexpr double ofWhole = 1 << 30, ofElement = 1 << 12;
    const auto [x, y, z] = header.latticeSize;
    const double elements = double(header.siteCount) + double(header.tetrahedronCount) + double(x) * y * z;
    return double(bytes) <= ofWhole + ofElement * elements;
}

std::uint64_t sumOfChunk(const PackedChunkHead& head, std::span<const std::byte> bytes)
{
    Checksum sum;
    sum.add(std::as_bytes(std::span(&head, 1)).subspan(sizeof head.checksum));
    sum.add(bytes);
    return sum.value();
}

} // namespace

PackedFileWriter::PackedFileWriter(FileWriter file, const Model& model, PackMethod method)
    : file_(std::move(file)),
      spool_(file_.target().parent_path().empty() ? std::filesystem::path(".") : file_.target().parent_path())
{
    facts_.method = static_cast<std::uint32_t>(method);
    facts_.fileBytes = model.fileSize();
}

Result<std::unique_ptr<PackedFileWriter>> PackedFileWriter::create(const std::filesystem::path& output,
                                                                   const Model& model, PackMethod method)
{
    Result<FileWriter> file = FileWriter::create(output);
    if (!file)
        return file.error();
    std::unique_ptr<PackedFileWriter> writer(new PackedFileWriter(std::move(*file), model, method));
    const Result<FileLayout> layout = readLayout(model.fileBytes(), model.path());
    if (!layout)
        return layout.error();
    writer->header_ = layout->header;
    writer->frame_ = frameSections(model.description());
    writer->facts_.headerChecksum = layout->header.checksum;
    for (const Section& section : layout->sections)
        writer->sums_.push_back({section.id, 0, section.checksum});
    const Section& text = layout->section(SectionId::Text);
    const std::span<const std::byte> bytes = model.fileBytes().subspan(text.offset, text.bytes);
    if (checksum(bytes) != text.checksum)
        return Error{
            ErrorKind::BadInput,
            Message::say("'%1' is damaged: the checksum of its text is wrong. Copy the file again, or build it "
                         "again.",
                         model.path().string()),
            model.path()};
    writer->text_.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return writer;
}

Status PackedFileWriter::addChunk(std::uint32_t kind, std::span<const std::byte> bytes)
{
    PackedChunkHead head{0, kind, static_cast<std::uint32_t>(bytes.size())};
    head.checksum = sumOfChunk(head, bytes);
    chunks_.append(std::as_bytes(std::span(&head, 1)));
    chunks_.append(bytes);
    return spool_.status();
}

void PackedFileWriter::endLevel(float error, float warping, std::uint32_t sites, std::uint32_t replayLevel)
{
    levels_.push_back({error, warping, sites, replayLevel, chunks_.size()});
}

std::uint64_t PackedFileWriter::size() const noexcept
{
    std::uint64_t size = sizeof(Header) + (5 + frame_.size()) * sizeof(Section);
    for (const FrameSection& section : frame_)
        size = format::aligned(size) + bytesOfAll(section.numbers).size();
    for (const std::uint64_t bytes :
         {std::uint64_t(sizeof(PackedFacts)), std::uint64_t(bytesOfAll(levels_).size()),
          std::uint64_t(bytesOfAll(sums_).size()), std::uint64_t(text_.size()), chunks_.size()})
        size = format::aligned(size) + bytes;
    return size;
}

Status PackedFileWriter::finish()
{
    if (!levelsMakeSense(levels_, header_, static_cast<PackMethod>(facts_.method), chunks_.size()))
        return Error{ErrorKind::BadInput, Message::say("The model cannot be packed into '%1': the errors that it "
                                                       "claims are invalid. 'tan verify' gives details.",
                                                       file_.target().string())};
    struct Part {
        SectionId id;
        std::uint32_t elementBytes;
        std::span<const std::byte> bytes;
    };
    std::vector<Part> front;
    for (const FrameSection& section : frame_)
        front.push_back({section.id, sizeof(double), bytesOfAll(section.numbers)});
    front.insert(front.end(), {{SectionId::PackedFacts, sizeof(PackedFacts), std::as_bytes(std::span(&facts_, 1))},
                               {SectionId::PackedLevels, sizeof(PackedLevelEntry), bytesOfAll(levels_)},
                               {SectionId::PackedSums, sizeof(PackedSum), bytesOfAll(sums_)},
                               {SectionId::Text, 1, std::as_bytes(std::span(text_))}});
    std::vector<Section> table;
    std::uint64_t end = sizeof(Header) + (front.size() + 1) * sizeof(Section);
    const auto place = [&](SectionId id, std::uint32_t elementBytes, std::uint64_t bytes, std::uint64_t sum) {
        const std::uint64_t offset = format::aligned(end);
        table.push_back({static_cast<std::uint32_t>(id), format::required, elementBytes, 0, offset, bytes, sum, {}});
        end = offset + bytes;
        return offset;
    };
    Status written = file_.extend(sizeof(Header) + (front.size() + 1) * sizeof(Section));
    const auto fillTo = [&](std::uint64_t offset) {
        static constexpr std::array<std::byte, format::alignment> zeros{};
        if (written)
            written = file_.write(std::span(zeros).first(offset - file_.size()));
    };
    for (const Part& part : front) {
        fillTo(place(part.id, part.elementBytes, part.bytes.size(), checksum(part.bytes)));
        if (written)
            written = file_.write(part.bytes);
    }
    fillTo(format::aligned(end));
    Checksum sum;
    if (written)
        written = chunks_.forEachChunk([&](std::span<const std::byte> bytes) {
            sum.add(bytes);
            return file_.write(bytes);
        });
    if (!written)
        return written;
    place(SectionId::PackedChunks, 1, chunks_.size(), sum.value());
    Header header = header_;
    header.majorVersion = format::majorVersion;
    header.minorVersion = frame_.empty() ? format::minorVersion : format::minorVersionWithFrame;
    header.sectionCount = static_cast<std::uint32_t>(table.size());
    header.fileBytes = file_.size();
    header.checksum = headerChecksum(header, bytesOfAll(table));
    if (written = file_.overwrite(0, std::as_bytes(std::span(&header, 1))); !written)
        return written;
    if (written = file_.overwrite(sizeof(Header), bytesOfAll(table)); !written)
        return written;
    return file_.commit();
}

// Reading.

Result<std::unique_ptr<const PackedFile>> PackedFile::open(ByteSource source, const std::filesystem::path& name,
                                                           const Progress& progress)
{
    std::unique_ptr<PackedFile> file(new PackedFile);
    file->source_ = std::move(source);
    file->name_ = name;
    if (const Status read = file->readFront(progress); !read)
        return read.error();
    if (const Status sensible = file->checkFront(); !sensible)
        return sensible.error();
    return std::unique_ptr<const PackedFile>(std::move(file));
}

Error PackedFile::damaged(const Message& what) const
{
    return {ErrorKind::BadInput,
            Message::say("'%1' is damaged: %2. Copy the file again, or pack the model again.", name_.string(), what),
            name_};
}

Status PackedFile::readFront(const Progress& progress)
{
    constexpr std::uint64_t firstBytes = 16 << 10;
    std::vector<std::byte> front;
    const auto readTo = [&](std::uint64_t end) -> Status {
        const std::uint64_t have = front.size();
        if (end <= have)
            return {};
        front.resize(end);
        const ByteRange range{have, end - have};
        if (const Status fetched = source_.fetch({&range, 1}, progress); !fetched)
            return fetched;
        return source_.read(have, std::span(front).subspan(have), progress);
    };
    if (const Status read = readTo(std::min(firstBytes, source_.size)); !read)
        return read;
    if (const Status read = readTo(std::min(frontBytes(front), source_.size)); !read)
        return read;
    const Result<FileLayout> layout = readPackedLayout(front, source_.size, name_);
    if (!layout)
        return layout.error();
    header_ = layout->header;
    const auto sectionOf = [&](SectionId id, auto& elements) -> Status {
        const Section& section = layout->section(id);
        std::vector<std::byte> bytes(section.bytes);
        if (section.offset + section.bytes <= front.size()) {
            std::copy_n(front.begin() + static_cast<std::ptrdiff_t>(section.offset), section.bytes, bytes.begin());
        } else {
            const ByteRange range{section.offset, section.bytes};
            if (const Status fetched = source_.fetch({&range, 1}, progress); !fetched)
                return fetched;
            if (const Status read = source_.read(section.offset, bytes, progress); !read)
                return read;
        }
        if (checksum(bytes) != section.checksum)
            return damaged(Message::say("the checksum of section '%1' is wrong", format::sectionName(section.id)));
        elements.resize(bytes.size() / sizeof(elements[0]));
        if (!bytes.empty())
            std::memcpy(static_cast<void*>(elements.data()), bytes.data(), bytes.size());
        return {};
    };
    std::vector<PackedFacts> facts;
    std::string text;
    for (const Status& read : {sectionOf(SectionId::PackedFacts, facts), sectionOf(SectionId::PackedLevels, levels_),
                               sectionOf(SectionId::PackedSums, sums_), sectionOf(SectionId::Text, text)})
        if (!read)
            return read;
    facts_ = facts.front();
    description_ = descriptionOf(header_);
    description_.delaunay =
        std::ranges::find(sums_, std::uint32_t(SectionId::HistoryKind), &PackedSum::id) == sums_.end();
    readText(text, description_);
    for (const SectionId id : frameSectionIds) {
        std::vector<std::byte> numbers;
        if (!layout->has(id))
            continue;
        if (const Status read = sectionOf(id, numbers); !read)
            return read;
        if (!takeFrameSection(id, numbers, description_))
            return damaged(
                Message::say("its section '%1' is invalid", format::sectionName(static_cast<std::uint32_t>(id))));
    }
    const Section& chunks = layout->section(SectionId::PackedChunks);
    chunks_ = {chunks.offset, chunks.bytes};
    chunksSum_ = chunks.checksum;
    if (facts_.method != std::uint32_t(PackMethod::Replayed) &&
        facts_.method != std::uint32_t(PackMethod::StoredByParts))
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "'%1' is packed by method %2, which this version does not know. Install a later version of TAn.",
                name_.string(), facts_.method)};
    return {};
}

Status PackedFile::checkFront() const
{
    if (!levelsMakeSense(levels_, header_, static_cast<PackMethod>(facts_.method), chunks_.size))
        return damaged(Message::say("its levels are invalid"));
    if (!sizeMakesSense(facts_.fileBytes, header_))
        return damaged(Message::say("its model cannot have %1 bytes", facts_.fileBytes));
    return {};
}

Status PackedFile::checkChunks(const Progress& progress) const
{
    if (!source_.isLocal)
        return {};
    const std::lock_guard lock(checking_);
    if (areChecked_)
        return {};
    const Status right = sumChunks(progress);
    areChecked_ = right.ok();
    return right;
}

Status PackedFile::sumChunks(const Progress& progress) const
{
    constexpr std::uint64_t atOnce = 1 << 20;
    std::vector<std::byte> window(std::min(atOnce, chunks_.size));
    Checksum sum;
    for (std::uint64_t place = 0; place < chunks_.size; place += window.size()) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading a packed model"));
        window.resize(std::min(atOnce, chunks_.size - place));
        if (const Status read = source_.read(chunks_.offset + place, window, progress); !read)
            return read;
        sum.add(window);
    }
    if (sum.value() == chunksSum_)
        return {};
    return damaged(Message::say("the checksum of section '%1' is wrong",
                                format::sectionName(std::uint32_t(SectionId::PackedChunks))));
}

/// Has the next `count` bytes in the window.
Status PackedChunkReader::have(std::uint64_t count, const Progress& progress)
{
    constexpr std::uint64_t atOnce = 1 << 20;
    if (place_ + count <= windowPlace_ + window_.size())
        return {};
    if (progress.cancelled())
        return cancelledError(Message::marked("Reading a packed model"));
    const std::uint64_t size = std::min(std::max(count, atOnce), end_ - place_);
    windowPlace_ = place_;
    window_.resize(size);
    const ByteRange range{file_.chunks().offset + place_, size};
    if (const Status fetched = file_.source().fetch({&range, 1}, progress); !fetched)
        return fetched;
    return file_.source().read(range.offset, window_, progress);
}

Result<bool> PackedChunkReader::next(const Progress& progress)
{
    if (place_ == end_)
        return false;
    if (end_ - place_ < sizeof head_)
        return file_.damaged(Message::say("a chunk is cut short"));
    if (const Status there = have(sizeof head_, progress); !there)
        return there.error();
    std::memcpy(static_cast<void*>(&head_), window_.data() + (place_ - windowPlace_), sizeof head_);
    if (head_.bytes > format::mostPackedChunkBytes || head_.bytes > end_ - place_ - sizeof head_)
        return file_.damaged(Message::say("a chunk is cut short"));
    if (const Status there = have(sizeof head_ + head_.bytes, progress); !there)
        return there.error();
    bytes_ = std::span(window_).subspan(place_ - windowPlace_ + sizeof head_, head_.bytes);
    if (sumOfChunk(head_, bytes_) != head_.checksum)
        return file_.damaged(Message::say("the checksum of a chunk is wrong"));
    place_ += sizeof head_ + head_.bytes;
    return true;
}

} // namespace tetra
