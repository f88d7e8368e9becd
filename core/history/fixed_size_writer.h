// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_writer.h"
#include "core/history/section_checks.h"

#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

/// A section whose size is known before its content.
struct FixedSizeSection {
    format::SectionId id = format::SectionId::Text;
    std::uint32_t elementBytes = 1;
    std::uint64_t count = 0;
    std::uint32_t flags = format::required; ///< 0 for a section that a reader may do without
};

/// Writes the sections of a `.tan` file all at once, each from its beginning to its end, straight to their final
/// places, and behind them the checksums of their chunks. Memory: one buffer a section. May throw std::bad_alloc.
class FixedSizeSections {
public:
    explicit FixedSizeSections(FileWriter file) : file_(std::move(file)) {}

    /// Lays the sections out in this order and takes their room on the disk. Comes first. An error tells a disk that is
    /// too full.
    Status plan(std::span<const FixedSizeSection> sections);
    /// Appends to a section, never beyond the size it was given.
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

    void place(const FixedSizeSection& planned, std::uint64_t& end);
    Cursor& cursor(format::SectionId id);
    Status flush(Cursor& cursor);

    FileWriter file_;
    std::vector<Cursor> cursors_;
};

/// Consecutive sites of a model and the tetrahedra that they created, in the model's own numbers and order (FORMAT.md).
struct FixedSizeStars {
    std::span<const std::uint32_t> points;
    std::span<const float> runningKeys;
    std::span<const std::uint8_t> groupGoesOn;
    std::span<const std::uint32_t> meshSizes;
    std::span<const std::uint32_t> starSizes;
    std::span<const std::array<std::uint32_t, 3>> otherSites; ///< star by star, as are the next two
    std::span<const std::uint32_t> destroyers;
    std::span<const std::uint16_t> ownErrors; ///< halfBound() of the error and the value range
};

/// Writes a model whose numbers of sites, destroyers and order are known beforehand, as they are when the histories of
/// blocks are merged: in constant memory. Nothing appears under `path` before finish() has succeeded. One thread.
class FixedSizeModelWriter {
public:
    /// `description` as for ModelWriter. `workFolder` holds the file until it is complete; on the same disk as `path`.
    static Result<std::unique_ptr<FixedSizeModelWriter>> create(const std::filesystem::path& path,
                                                                const Dataset& dataset, ModelDescription description,
                                                                const FixedCounts& counts,
                                                                const std::filesystem::path& workFolder = {});

    /// Appends. An Error if there is more of anything than was announced.
    Status add(const FixedSizeStars& stars);
    /// `finalKey` bounds the error of the mesh of all sites, in units of the values.
    Status finish(float finalKey);

    /// Bytes of a model of this size, of a lattice of so many points, as well as is known beforehand.
    static std::uint64_t expectedBytes(const FixedCounts& counts, SampleType type, std::uint64_t points) noexcept;

private:
    FixedSizeModelWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                         const FixedCounts& counts);
    Status begin();
    Status addOffsets(std::span<const std::uint32_t> starSizes);
    Status addValues(std::span<const std::uint32_t> points);
    bool samplesKept() const noexcept;
    Error notAsAnnounced() const;

    std::filesystem::path target_;
    FixedSizeSections sections_;
    Dataset dataset_;
    ModelDescription description_;
    FixedCounts counts_;
    FixedCounts added_;
    std::vector<std::uint64_t> offsets_;
    Buffer<std::byte> values_;
};

} // namespace tetra
