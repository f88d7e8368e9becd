// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"
#include "core/model/section_sums.h"

#include <span>
#include <vector>

namespace tetra {

/// Writes the sections of a `.tan` file one after the other, then the checksums of their chunks, then the header and
/// the table in the place that was left free for them. May throw std::bad_alloc.
class SectionWriter {
public:
    /// `mostSections`: the table gets room for so many, and for the chunks' checksums.
    SectionWriter(FileWriter file, std::uint32_t mostSections) : file_(std::move(file)), mostSections_(mostSections + 1)
    {
    }

    /// Leaves the place for header and table; comes first.
    Status reserveFront();
    /// `flags`: format::required, or 0 for a section that a reader may do without.
    Status begin(format::SectionId id, std::size_t elementBytes, std::uint32_t flags = format::required);
    Status add(std::span<const std::byte> bytes);
    void end();
    /// Completes `header` with sizes and checksums, writes it with the table and commits the file.
    Status finish(format::Header header);

private:
    Status padTo(std::uint64_t offset);
    Status writeChunkSums();

    FileWriter file_;
    std::uint32_t mostSections_;
    std::vector<format::Section> sections_;
    SectionSums sums_; ///< of the section that is being written
    ChunkSums chunkSums_;
};

} // namespace tetra
