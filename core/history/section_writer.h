// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"
#include "core/history/section_checks.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// A section whose size is known before its content.
struct PlannedSection {
    format::SectionId id = format::SectionId::Text;
    std::size_t elementBytes = 1;
    std::uint64_t count = 0;
    std::uint32_t flags = format::required; ///< 0 for a section that a reader may do without
    bool mayBeShorter = false;              ///< the count is the most; what is not filled is no part of the section
};

/// Writes the sections of a `.tan` file (FORMAT.md): those whose sizes are known all at once, each from its beginning
/// to its end, straight to their final places; at any time between two plans one that grows, whose size shows only at
/// its end; behind all of them the checksums of their chunks. Memory: a buffer for each. May throw std::bad_alloc. One
/// thread.
class SectionWriter {
public:
    explicit SectionWriter(FileWriter file) : file_(std::move(file)) {}

    /// Begins the section that grows: add() appends to it until plan() is called next. Comes first, or after plan().
    Status grow(format::SectionId id, std::size_t elementBytes, std::uint32_t flags = format::required);
    /// Lays further sections out in this order, behind what there is, and takes their room on the disk. An error tells
    /// a disk that is too full.
    Status plan(std::span<const PlannedSection> sections);
    /// Appends to a section. Errors: beyond the size that it was given, where another one lies.
    Status add(format::SectionId id, std::span<const std::byte> bytes);
    /// What was appended to a section, from a byte of it on. Errors: more than that.
    Status read(format::SectionId id, std::uint64_t offset, std::span<std::byte> bytes);
    /// Once every section is full: completes `header` with sizes and checksums, writes it with the table and commits.
    /// Errors: one that is not.
    Status finish(format::Header header);

private:
    struct Cursor {
        format::Section section;
        bool mayBeShorter = false;
        std::uint64_t written = 0; ///< bytes, those in the buffer included
        Buffer<std::byte> buffer;
        SectionSums sums;
    };

    void place(const PlannedSection& planned, std::uint64_t& end);
    Cursor& cursor(format::SectionId id);
    Status flush(Cursor& cursor);
    Error misfit(const Cursor& cursor) const;

    FileWriter file_;
    std::vector<Cursor> cursors_;
    bool grows_ = false; ///< the last one does
};

} // namespace tetra
