// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/section_writer.h"

#include "core/model/file_layout.h"

#include <array>
#include <cassert>

namespace tetra {

using format::Header;
using format::Section;

Status SectionWriter::reserveFront()
{
    return padTo(sizeof(Header) + mostSections_ * sizeof(Section));
}

Status SectionWriter::begin(format::SectionId id, std::size_t elementBytes, std::uint32_t flags)
{
    if (const Status padded = padTo(format::aligned(file_.size())); !padded)
        return padded;
    Section section;
    section.id = static_cast<std::uint32_t>(id);
    section.flags = flags;
    section.elementBytes = static_cast<std::uint32_t>(elementBytes);
    section.offset = file_.size();
    sections_.push_back(section);
    sums_ = {};
    return {};
}

Status SectionWriter::add(std::span<const std::byte> bytes)
{
    sums_.add(bytes);
    return file_.write(bytes);
}

void SectionWriter::end()
{
    sections_.back().bytes = file_.size() - sections_.back().offset;
    sections_.back().checksum = sums_.ofWhole();
    chunkSums_.append(sums_);
}

Status SectionWriter::writeChunkSums()
{
    if (const Status begun = begin(format::SectionId::ChunkSums, sizeof(std::uint64_t), 0); !begun)
        return begun;
    const Status written = add(chunkSums_.bytes());
    sections_.back().bytes = chunkSums_.bytes().size();
    sections_.back().checksum = sums_.ofWhole();
    return written;
}

Status SectionWriter::finish(Header header)
{
    if (const Status written = writeChunkSums(); !written)
        return written;
    assert(sections_.size() <= mostSections_);
    const std::span<const std::byte> table = std::as_bytes(std::span(sections_));
    header.sectionCount = static_cast<std::uint32_t>(sections_.size());
    header.fileBytes = file_.size();
    header.checksum = headerChecksum(header, table);
    if (const Status written = file_.overwrite(0, std::as_bytes(std::span(&header, 1))); !written)
        return written;
    if (const Status written = file_.overwrite(sizeof(Header), table); !written)
        return written;
    return file_.commit();
}

Status SectionWriter::padTo(std::uint64_t offset)
{
    static constexpr std::array<std::byte, 4096> zeros{};
    while (file_.size() < offset)
        if (const Status written =
                file_.write(std::span(zeros).first(std::min<std::uint64_t>(zeros.size(), offset - file_.size())));
            !written)
            return written;
    return {};
}

} // namespace tetra
