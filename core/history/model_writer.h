// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/section_writer.h"

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace tetra {

// Who writes model files. One SectionWriter lays each of them out, sums it up and completes it, and one
// writeDerivedSections() adds what follows from the arrays. What fills the arrays is not one writer but several, since
// histories come in several ways:
// - From a build of a whole dataset, site after site: ModelWriter. The other sites of tetrahedra, most of a file, go
//   straight to their place; of the rest, whose place depends on their number, what is final waits in a spool file.
// - From a build in blocks, one run a block, of which each batch takes its share: mergeRuns() (merged_model.h), by the
//   ModelFileWriter that ModelWriter uses, too. One writer for both would have a build of a whole dataset write one run
//   and merge that: then every small build would write all that it has twice, and read it once more.
// - From another model: prefix_copy.cpp takes the beginning of each section, placed_copy.cpp every section but the
//   text and the frame. Neither makes steps of a history out of them.
// - From a packed model whose history is decoded (core/packed/parts.cpp): the arrays are complete and in memory, and
//   sections come in the order of the file that was packed, so that every byte is the same.
// Packed files have a front like these, but chunks in place of sections: core/packed/packed_file.cpp lays them out.

/// Which samples of a dataset are known to those who write a model of it.
enum class KnownSamples {
    All,
    OfSites ///< the others are whatever they are: the model keeps none, and its description is taken as it is given
};

/// Writes the sections that a model of a dataset has (FORMAT.md), whoever made its history and in whatever order it
/// comes. Memory: buffers, and what writeDerivedSections() takes at the end. Nothing appears under the path before
/// finish() has succeeded: the file is written beside it, synced and renamed; destroying an unfinished writer removes
/// what it wrote. One thread. May throw std::bad_alloc.
class ModelFileWriter {
public:
    /// `description` needs builder and parameters; the rest is taken from `dataset`. The unfinished file lies in
    /// `workFolder`, on the same disk; without one beside `path`.
    static Result<std::unique_ptr<ModelFileWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                           ModelDescription description,
                                                           const std::filesystem::path& workFolder = {},
                                                           KnownSamples known = KnownSamples::All);
    /// Likewise of a history whose size is known already.
    static Result<std::unique_ptr<ModelFileWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                           ModelDescription description, const FixedCounts& counts,
                                                           const std::filesystem::path& workFolder = {});

    const ModelDescription& description() const noexcept { return description_; }
    const std::filesystem::path& target() const noexcept { return target_; }
    /// Comes before announce(); without it there is no warping, and meshes are Delaunay ones.
    void setTraits(const HistoryTraits& traits);
    /// HistoryTraits::blockCells; before finish().
    void setBlocks(const std::array<std::uint32_t, 3>& blockCells) { blockCells_ = blockCells; }

    // Each appends to a section, never more than was announced.

    /// May begin before announce(), while nobody knows how many there will be.
    Status addOtherSites(std::span<const std::array<std::uint32_t, 3>> otherSites);
    /// All sections but those of the other sites come after this one. An error tells a disk that is too full.
    Status announce(const FixedCounts& counts);
    /// The sites' points, and with them their values and positions.
    Status addPoints(std::span<const std::uint32_t> points);
    /// How many tetrahedra each site created.
    Status addStarSizes(std::span<const std::uint32_t> starSizes);
    /// A section that is written as it is: SiteRunningKeys, MeshSizes, SiteGroups, Destroyers, OwnErrors,
    /// OwnWarpings.
    template <class Element> Status add(format::SectionId id, std::span<const Element> elements)
    {
        return sections_.add(id, std::as_bytes(elements));
    }

    /// Completes the file with what follows from the rest. `finalKey` bounds the error of the mesh of all sites, in
    /// units of the values. Errors: the file's, values that
    /// changed meanwhile, an Error (BadInput) if there was more or less of anything than was announced.
    Status finish(float finalKey);

    /// Bytes of a model of this size, of a lattice or grid of so many points, as well as is known beforehand.
    static std::uint64_t expectedBytes(const FixedCounts& counts, SampleType type, DomainClass domain,
                                       std::uint64_t points) noexcept;

private:
    ModelFileWriter(FileWriter file, const Dataset& dataset, ModelDescription description, KnownSamples known);
    Status begin();
    bool hasPositions() const noexcept { return dataset_.domain != DomainClass::RegularLattice; }
    bool keepsSamples() const noexcept;
    Status addSamplePositions();
    Error notAsAnnounced() const;

    std::filesystem::path target_;
    SectionWriter sections_;
    Dataset dataset_;
    ModelDescription description_;
    FixedCounts counts_;
    FixedCounts added_;
    std::array<std::uint32_t, 3> blockCells_{};
    bool otherSitesBegun_ = false;
    bool positionsFitFloats_ = false;
    KnownSamples known_ = KnownSamples::All;
    std::vector<std::uint64_t> offsets_;
    Buffer<std::byte> elements_;
};

/// Writes a history into a `.tan` file while it is made. Steps are put together into batches and groups on the way
/// (FORMAT.md). Memory: about 8 bytes a tetrahedron and 4 a site, and one batch whole; all else waits on the disk.
class TAN_INTERNAL ModelWriter : public HistorySink {
public:
    /// As ModelFileWriter's.
    static Result<std::unique_ptr<ModelWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                       ModelDescription description,
                                                       const std::filesystem::path& workFolder = {},
                                                       KnownSamples known = KnownSamples::All);
    /// In place of finish(), at any time: completes the file with the sites before the batch that is not complete yet,
    /// a mesh of known error. Error: no batch is complete.
    virtual Status finishEarly() = 0;
    /// Handed over so far.
    virtual std::uint32_t siteCount() const noexcept = 0;
    /// In the file so far, without those of the batch that is not complete yet.
    virtual std::uint64_t tetrahedronCount() const noexcept = 0;
};

} // namespace tetra
