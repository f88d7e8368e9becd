// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/fixed_size_writer.h"

#include "core/history/file_layout.h"
#include "core/history/model_writer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <new>

namespace tetra {

using format::Header;
using format::Section;
using format::SectionId;

namespace {

constexpr std::size_t bufferBytes = 1 << 20;

} // namespace

Status FixedSizeSections::plan(std::span<const FixedSizeSection> sections)
{
    std::uint64_t end = sizeof(Header) + (sections.size() + 1) * sizeof(Section);
    std::uint64_t chunks = 0;
    for (const FixedSizeSection& planned : sections) {
        place(planned, end);
        chunks += format::chunkCount(cursors_.back().section.bytes);
    }
    place({SectionId::ChunkSums, sizeof(std::uint64_t), 1 + chunks, 0}, end);
    return file_.extend(end);
}

void FixedSizeSections::place(const FixedSizeSection& planned, std::uint64_t& end)
{
    Cursor cursor;
    cursor.section.id = static_cast<std::uint32_t>(planned.id);
    cursor.section.flags = planned.flags;
    cursor.section.elementBytes = planned.elementBytes;
    cursor.section.offset = format::aligned(end);
    cursor.section.bytes = planned.elementBytes * planned.count;
    end = cursor.section.offset + cursor.section.bytes;
    cursor.buffer.reserve(std::min<std::uint64_t>(bufferBytes, cursor.section.bytes));
    cursors_.push_back(std::move(cursor));
}

Status FixedSizeSections::add(format::SectionId id, std::span<const std::byte> bytes)
{
    Cursor& to = cursor(id);
    assert(bytes.size() <= to.section.bytes - to.written);
    to.sums.add(bytes);
    if (bytes.size() > to.buffer.capacity() - to.buffer.size())
        if (const Status flushed = flush(to); !flushed)
            return flushed;
    to.written += bytes.size();
    if (bytes.size() > to.buffer.capacity())
        return file_.overwrite(to.section.offset + to.written - bytes.size(), bytes);
    to.buffer.insert(to.buffer.end(), bytes.begin(), bytes.end());
    return {};
}

Status FixedSizeSections::finish(Header header)
{
    ChunkSums sums;
    for (const Cursor& cursor : std::span(cursors_).first(cursors_.size() - 1))
        sums.append(cursor.sums);
    if (const Status added = add(SectionId::ChunkSums, sums.bytes()); !added)
        return added;
    std::vector<Section> table;
    for (Cursor& cursor : cursors_) {
        assert(cursor.written == cursor.section.bytes);
        if (const Status flushed = flush(cursor); !flushed)
            return flushed;
        cursor.section.checksum = cursor.sums.ofWhole();
        table.push_back(cursor.section);
    }
    header.sectionCount = static_cast<std::uint32_t>(table.size());
    header.fileBytes = file_.size();
    header.checksum = headerChecksum(header, std::as_bytes(std::span(table)));
    if (const Status written = file_.overwrite(0, std::as_bytes(std::span(&header, 1))); !written)
        return written;
    if (const Status written = file_.overwrite(sizeof(Header), std::as_bytes(std::span(table))); !written)
        return written;
    return file_.commit();
}

FixedSizeSections::Cursor& FixedSizeSections::cursor(format::SectionId id)
{
    const auto found = std::ranges::find(cursors_, static_cast<std::uint32_t>(id),
                                         [](const Cursor& cursor) { return cursor.section.id; });
    assert(found != cursors_.end());
    return *found;
}

Status FixedSizeSections::flush(Cursor& cursor)
{
    const std::uint64_t offset = cursor.section.offset + cursor.written - cursor.buffer.size();
    const Status written = file_.overwrite(offset, cursor.buffer);
    cursor.buffer.clear();
    return written;
}

using format::SectionId;

Result<std::unique_ptr<FixedSizeModelWriter>>
FixedSizeModelWriter::create(const std::filesystem::path& path, const Dataset& dataset, ModelDescription description,
                             const FixedCounts& counts, const std::filesystem::path& workFolder)
{
    describeSource(description, dataset);
    Result<FileWriter> file = FileWriter::create(path, 1, workFolder);
    if (!file)
        return file.error();
    try {
        std::unique_ptr<FixedSizeModelWriter> writer(
            new FixedSizeModelWriter(std::move(*file), dataset, std::move(description), counts));
        if (const Status begun = writer->begin(); !begun)
            return begun.error();
        return writer;
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource,
                     "Not enough memory to write '" + path.string() + "'. Close other programs."};
    }
}

FixedSizeModelWriter::FixedSizeModelWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                                           const FixedCounts& counts)
    : target_(file.target()), sections_(std::move(file)), dataset_(dataset), description_(std::move(description)),
      counts_(counts)
{
}

Status FixedSizeModelWriter::begin()
{
    const Result<std::string> text = textOf(description_, target_);
    if (!text)
        return text.error();
    const auto sampleBytes = static_cast<std::uint32_t>(sampleSize(dataset_.values.type()));
    std::vector<FixedSizeSection> sections = {{SectionId::Text, 1, text->size()},
                                              {SectionId::SitePoints, 4, counts_.sites},
                                              {SectionId::SiteValues, sampleBytes, counts_.sites},
                                              {SectionId::SiteRunningErrors, 4, counts_.sites},
                                              {SectionId::StarOffsets, 8, counts_.sites + 1ull},
                                              {SectionId::MeshSizes, 4, counts_.sites},
                                              {SectionId::SiteGroups, 1, counts_.sites},
                                              {SectionId::OtherSites, 12, counts_.tetrahedra},
                                              {SectionId::Destroyers, 4, counts_.tetrahedra},
                                              {SectionId::OwnErrors, 2, counts_.tetrahedra}};
    if (samplesKept())
        sections.push_back({SectionId::Samples, sampleBytes, dataset_.pointCount(), 0});
    if (const Status planned = sections_.plan(sections); !planned)
        return planned;
    return sections_.add(SectionId::Text, std::as_bytes(std::span(*text)));
}

Status FixedSizeModelWriter::add(const FixedSizeStars& stars)
{
    if (stars.points.size() > counts_.sites - added_.sites ||
        stars.otherSites.size() > counts_.tetrahedra - added_.tetrahedra)
        return notAsAnnounced();
    for (const Status& written : {sections_.add(SectionId::SitePoints, std::as_bytes(stars.points)),
                                  sections_.add(SectionId::SiteRunningErrors, std::as_bytes(stars.runningKeys)),
                                  sections_.add(SectionId::MeshSizes, std::as_bytes(stars.meshSizes)),
                                  sections_.add(SectionId::SiteGroups, std::as_bytes(stars.groupGoesOn)),
                                  sections_.add(SectionId::OtherSites, std::as_bytes(stars.otherSites)),
                                  sections_.add(SectionId::Destroyers, std::as_bytes(stars.destroyers)),
                                  sections_.add(SectionId::OwnErrors, std::as_bytes(stars.ownErrors)),
                                  addOffsets(stars.starSizes), addValues(stars.points)})
        if (!written)
            return written;
    return {};
}

Status FixedSizeModelWriter::addOffsets(std::span<const std::uint32_t> starSizes)
{
    offsets_.clear();
    for (const std::uint32_t size : starSizes) {
        offsets_.push_back(added_.tetrahedra);
        added_.tetrahedra += size;
    }
    added_.sites += static_cast<std::uint32_t>(starSizes.size());
    return sections_.add(SectionId::StarOffsets, std::as_bytes(std::span(offsets_)));
}

Status FixedSizeModelWriter::addValues(std::span<const std::uint32_t> points)
{
    return visitSampleType(dataset_.values.type(), [&]<class T>() {
        const std::span<const T> samples = dataset_.values.as<T>();
        values_.resize(points.size() * sizeof(T));
        for (std::size_t i = 0; i < points.size(); ++i)
            std::memcpy(values_.data() + i * sizeof(T), &samples[points[i]], sizeof(T));
        return sections_.add(SectionId::SiteValues, values_);
    });
}

Status FixedSizeModelWriter::finish(float finalKey)
{
    if (added_.sites != counts_.sites || added_.tetrahedra != counts_.tetrahedra || !(finalKey >= 0) ||
        !std::isfinite(finalKey))
        return notAsAnnounced();
    const std::uint64_t end = added_.tetrahedra;
    if (const Status written = sections_.add(SectionId::StarOffsets, std::as_bytes(std::span(&end, 1))); !written)
        return written;
    if (samplesKept()) {
        const Status written = writeSamples(dataset_.values, [this](std::span<const std::byte> piece) {
            return sections_.add(SectionId::Samples, piece);
        });
        if (!written)
            return written;
    }
    format::Header header = headerOf(description_);
    header.siteCount = counts_.sites;
    header.tetrahedronCount = counts_.tetrahedra;
    header.finalError = finalKey;
    if (const Status intact = dataset_.checkIntact(); !intact)
        return intact;
    return sections_.finish(header);
}

bool FixedSizeModelWriter::samplesKept() const noexcept
{
    return keepsSamples(dataset_.domain, dataset_.values.type(), 0, dataset_.pointCount(),
                        {counts_.sites, counts_.tetrahedra});
}

std::uint64_t FixedSizeModelWriter::expectedBytes(const FixedCounts& counts, SampleType type,
                                                  std::uint64_t points) noexcept
{
    constexpr std::uint64_t frontAndText = 4096;
    const ModelCounts whole{counts.sites, counts.tetrahedra};
    const bool samples = keepsSamples(DomainClass::RegularLattice, type, 0, points, whole);
    const std::uint64_t content = arrayBytes(whole, type) + (samples ? points * sampleSize(type) : 0);
    return content + format::chunkCount(content) * sizeof(std::uint64_t) + frontAndText;
}

Error FixedSizeModelWriter::notAsAnnounced() const
{
    return {ErrorKind::BadInput, "The builder '" + description_.builder +
                                     "' made another history than it had announced. Nothing was written; report this "
                                     "to its author."};
}

} // namespace tetra
