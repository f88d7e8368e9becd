// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/planned_sections.h"

#include "core/model/file_layout.h"

#include <algorithm>
#include <cassert>

namespace tetra {

using format::Header;
using format::Section;
using format::SectionId;

namespace {

constexpr std::size_t bufferBytes = 1 << 20;

} // namespace

Status PlannedSections::plan(std::span<const PlannedSection> sections)
{
    std::uint64_t end = sizeof(Header) + (sections.size() + 1) * sizeof(Section);
    std::uint64_t chunks = 0;
    for (const PlannedSection& planned : sections) {
        place(planned, end);
        chunks += format::chunkCount(cursors_.back().section.bytes);
    }
    place({SectionId::ChunkSums, sizeof(std::uint64_t), 1 + chunks, 0}, end);
    return file_.extend(end);
}

void PlannedSections::place(const PlannedSection& planned, std::uint64_t& end)
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

Status PlannedSections::add(format::SectionId id, std::span<const std::byte> bytes)
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

Status PlannedSections::finish(Header header)
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

PlannedSections::Cursor& PlannedSections::cursor(format::SectionId id)
{
    const auto found = std::ranges::find(cursors_, static_cast<std::uint32_t>(id),
                                         [](const Cursor& cursor) { return cursor.section.id; });
    assert(found != cursors_.end());
    return *found;
}

Status PlannedSections::flush(Cursor& cursor)
{
    const std::uint64_t offset = cursor.section.offset + cursor.written - cursor.buffer.size();
    const Status written = file_.overwrite(offset, cursor.buffer);
    cursor.buffer.clear();
    return written;
}

} // namespace tetra
