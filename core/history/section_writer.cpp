// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/section_writer.h"

#include <algorithm>
#include <cassert>

namespace tetra {

using format::Header;
using format::Section;
using format::SectionId;

namespace {

constexpr std::size_t bufferBytes = 1 << 20;

/// The table gets room for so many sections: all that there are, and two to spare.
constexpr std::uint64_t mostInTable = 24;
constexpr std::uint64_t firstSectionBegins = sizeof(Header) + mostInTable * sizeof(Section);

} // namespace

Status SectionWriter::grow(SectionId id, std::size_t elementBytes, std::uint32_t flags)
{
    std::uint64_t end = std::max(file_.size(), firstSectionBegins);
    place({id, elementBytes, 0, flags}, end);
    grows_ = true;
    return file_.extend(end);
}

Status SectionWriter::plan(std::span<const PlannedSection> sections)
{
    if (grows_)
        cursors_.back().section.bytes = cursors_.back().written;
    grows_ = false;
    std::uint64_t end = std::max(file_.size(), firstSectionBegins);
    for (const PlannedSection& planned : sections)
        place(planned, end);
    return file_.extend(end);
}

void SectionWriter::place(const PlannedSection& planned, std::uint64_t& end)
{
    Cursor cursor;
    cursor.section.id = static_cast<std::uint32_t>(planned.id);
    cursor.section.flags = planned.flags;
    cursor.section.elementBytes = static_cast<std::uint32_t>(planned.elementBytes);
    cursor.section.offset = format::aligned(end);
    cursor.section.bytes = planned.elementBytes * planned.count;
    cursor.mayBeShorter = planned.mayBeShorter;
    end = cursor.section.offset + cursor.section.bytes;
    cursor.buffer.reserve(std::min<std::uint64_t>(bufferBytes, cursor.section.bytes));
    cursors_.push_back(std::move(cursor));
}

Status SectionWriter::add(SectionId id, std::span<const std::byte> bytes)
{
    Cursor& to = cursor(id);
    const bool grows = grows_ && &to == &cursors_.back();
    if (!grows && bytes.size() > to.section.bytes - to.written)
        return misfit(to);
    to.sums.add(bytes);
    if (grows) {
        to.written += bytes.size();
        return file_.write(bytes);
    }
    if (bytes.size() > to.buffer.capacity() - to.buffer.size())
        if (const Status flushed = flush(to); !flushed)
            return flushed;
    to.written += bytes.size();
    if (bytes.size() > to.buffer.capacity())
        return file_.overwrite(to.section.offset + to.written - bytes.size(), bytes);
    to.buffer.insert(to.buffer.end(), bytes.begin(), bytes.end());
    return {};
}

Status SectionWriter::read(SectionId id, std::uint64_t offset, std::span<std::byte> bytes)
{
    Cursor& from = cursor(id);
    if (offset > from.written || bytes.size() > from.written - offset)
        return misfit(from);
    if (const Status flushed = flush(from); !flushed)
        return flushed;
    return file_.read(from.section.offset + offset, bytes);
}

Status SectionWriter::finish(Header header)
{
    ChunkSums sums;
    for (const Cursor& cursor : cursors_)
        sums.append(cursor.sums);
    const PlannedSection last{SectionId::ChunkSums, sizeof(std::uint64_t), sums.bytes().size() / sizeof(std::uint64_t),
                              0};
    if (const Status planned = plan({&last, 1}); !planned)
        return planned;
    if (const Status added = add(SectionId::ChunkSums, sums.bytes()); !added)
        return added;
    std::vector<Section> table;
    for (Cursor& cursor : cursors_) {
        if (cursor.mayBeShorter)
            cursor.section.bytes = cursor.written;
        if (cursor.written != cursor.section.bytes)
            return misfit(cursor);
        if (const Status flushed = flush(cursor); !flushed)
            return flushed;
        cursor.section.checksum = cursor.sums.ofWhole();
        table.push_back(cursor.section);
    }
    if (table.size() > mostInTable) // it would reach into the first section
        return misfit(cursors_.back());
    header.sectionCount = static_cast<std::uint32_t>(table.size());
    header.fileBytes = file_.size();
    header.checksum = headerChecksum(header, std::as_bytes(std::span(table)));
    if (const Status written = file_.overwrite(0, std::as_bytes(std::span(&header, 1))); !written)
        return written;
    if (const Status written = file_.overwrite(sizeof(Header), std::as_bytes(std::span(table))); !written)
        return written;
    return file_.commit();
}

SectionWriter::Cursor& SectionWriter::cursor(SectionId id)
{
    const auto found = std::ranges::find(cursors_, static_cast<std::uint32_t>(id),
                                         [](const Cursor& cursor) { return cursor.section.id; });
    assert(found != cursors_.end());
    return *found;
}

/// Whoever plans sections and fills them contradicts himself: better no file than one whose sections overlap.
Error SectionWriter::misfit(const Cursor& cursor) const
{
    return {ErrorKind::CannotWrite,
            Message::say("Cannot write '%1': section '%2' was planned with %3 bytes, which does not match its content. "
                         "This is a fault of TAn: please report it.",
                         file_.target().string(), format::sectionName(cursor.section.id), cursor.section.bytes)};
}

Status SectionWriter::flush(Cursor& cursor)
{
    if (cursor.buffer.empty())
        return {};
    const std::uint64_t offset = cursor.section.offset + cursor.written - cursor.buffer.size();
    const Status written = file_.overwrite(offset, cursor.buffer);
    cursor.buffer.clear();
    return written;
}

} // namespace tetra
