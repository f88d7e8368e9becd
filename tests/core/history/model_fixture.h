// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/format.h"

#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace tetra {

/// A lattice of smooth bumps, with spacings and an origin of their own.
Dataset bumps(SampleType type, std::array<std::uint32_t, 3> size);

/// The same values on a grid that is bent in physical space, gently enough that no tetrahedron ever flips; with
/// positions that floats hold or, `precise`, that they do not; `mirrored` makes it left-handed.
Dataset bentBumps(SampleType type, std::array<std::uint32_t, 3> size, bool precise = false, bool mirrored = false);

/// A bent grid of floats with a point that is pulled through its neighbours, so that cells are folded, and a cell
/// without volume.
Dataset faultyGrid();

/// A history in memory, as it was handed over.
struct RecordedSteps final : HistorySink {
    struct Step {
        std::uint64_t point = 0;
        float keyBefore = 0;
        std::vector<HistoryTetrahedron> star;
        std::vector<std::uint32_t> destroyed;
    };
    HistoryTraits traits;
    std::vector<Step> steps;
    float finalKey = -1;

    Status begin(const HistoryTraits& given) override;
    Status add(const HistoryStep& step) override;
    Status finish(float error) override;

    /// The tetrahedra (creator, a, b, c) of the mesh of the first `sites` sites, replayed step by step.
    std::vector<std::array<std::uint32_t, 4>> meshOf(std::size_t sites) const;
    /// The point of each site.
    std::vector<std::uint32_t> points() const;
};

/// Tetrahedra as sets of points, whatever the numbers and the order of their sites: each sorted, and all of them.
using TetrahedraByPoints = std::vector<std::array<std::uint64_t, 4>>;
/// `points`: the point of each site.
TetrahedraByPoints byPoints(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                            std::span<const std::uint32_t> points);

/// Whether the first `sites` sites are whole batches, or all: a query can ask for them.
bool endsBatch(const Model& model, std::uint32_t sites);

/// The history of the slow reference refinement; made once for each kind of dataset and kept.
const RecordedSteps& historyOf(const Dataset& dataset);

/// Hands a recorded history on.
Status replay(const RecordedSteps& history, HistorySink& sink);

/// Writes the model of `dataset`. What fails here fails the test.
void writeModel(const std::filesystem::path& path, const Dataset& dataset);

std::vector<std::byte> readBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A `.tan` file taken apart, so that tests can damage it at a place of their choice.
class FileParts {
public:
    explicit FileParts(std::vector<std::byte> bytes) : content(std::move(bytes)) {}

    format::Header& header() { return *reinterpret_cast<format::Header*>(content.data()); }
    std::span<format::Section> sections();
    format::Section& section(format::SectionId id);
    template <class T> std::span<T> elements(format::SectionId id)
    {
        const format::Section& found = section(id);
        return {reinterpret_cast<T*>(content.data() + found.offset), found.bytes / sizeof(T)};
    }
    /// Makes all checksums right again, those of chunks, too, so that nothing but the damage itself can be found.
    void repairChecksums();
    /// Only that of the header and the table.
    void repairHeader();
    /// Divides the sections into chunks of so many bytes: small ones show what is read to a few bytes.
    void setChunkBytes(std::uint64_t bytes);
    /// Makes it a file of format 1.2, which has checksums of whole sections only.
    void removeChunkSums();
    /// Adds an entry to the table, with no bytes, behind the last section.
    void addSection(std::uint32_t id, std::uint32_t flags);

    std::vector<std::byte> content;

private:
    /// Of a section, as far as it lies in the file.
    std::span<const std::byte> bytesOf(const format::Section& section) const;
    std::vector<std::uint64_t> chunkSums(std::uint64_t chunkBytes);
};

} // namespace tetra
