// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"
#include "core/model/section_sums.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A section whose size is known before its content.
struct PlannedSection {
    format::SectionId id = format::SectionId::Text;
    std::uint32_t elementBytes = 1;
    std::uint64_t count = 0;
    std::uint32_t flags = format::required; ///< 0 for a section that a reader may do without
};

/// Writes the sections of a `.tan` file all at once, each from its beginning to its end, straight to their final
/// places, and behind them the checksums of their chunks. Memory: one buffer a section. May throw std::bad_alloc.
class PlannedSections {
public:
    explicit PlannedSections(FileWriter file) : file_(std::move(file)) {}

    /// Lays the sections out in this order and takes their room on the disk. Comes first. An error tells a disk that is
    /// too full.
    Status plan(std::span<const PlannedSection> sections);
    /// Appends to a section, never beyond its planned size.
    Status add(format::SectionId id, std::span<const std::byte> bytes);
    /// Once every section is full: completes `header` with sizes and checksums, writes it with the table and commits.
    Status finish(format::Header header);

private:
    struct Cursor {
        format::Section section;
        std::uint64_t written = 0; ///< bytes, those in the buffer included
        Buffer<std::byte> buffer;
        SectionSums sums;
    };

    void place(const PlannedSection& planned, std::uint64_t& end);
    Cursor& cursor(format::SectionId id);
    Status flush(Cursor& cursor);

    FileWriter file_;
    std::vector<Cursor> cursors_;
};

} // namespace tetra
