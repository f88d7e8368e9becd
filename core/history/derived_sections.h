// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/format.h"
#include "core/history/section_writer.h"

#include <tan/base.h>
#include <tan/build.h>
#include <tan/data.h>
#include <tan/model.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

/// What a file tells beside the arrays that every model has (FORMAT.md, sections 4 and 48 to 53): levels, batches,
/// blocks and faults. All of it follows from the other sections and the dataset, and is there so that nobody need look
/// for it. Empty where the file has none.
struct DerivedSections {
    std::span<const format::LevelEntry> levels;
    std::span<const std::uint32_t> batchEnds;
    std::span<const float> batchErrors;                   ///< one a batch, as are the next: of data that warp
    std::span<const float> batchWarpings;                 ///< in units of length
    std::span<const std::uint32_t> blockCells;            ///< three: cells along an edge of a block on each axis
    std::optional<std::span<const format::Fault>> faults; ///< of curvilinear data
    std::span<const format::FaultyCell> faultyCells;      ///< of irregular data
};

/// Refers to the mapped file. Reads no more than its header and its table: elements want Model::check(), as all do.
DerivedSections derivedSections(const Model& model);

/// The section FaultyCells of a dataset: its cells whose corners are known.
std::vector<format::FaultyCell> faultyCellsOf(const Dataset& dataset);

/// What the faults of a model of curvilinear data are found by where the grid is not at hand.
struct KnownFaults {
    std::vector<format::Fault> ofCells;         ///< of the grid
    std::vector<Eigen::Vector3d> sitePositions; ///< of all sites
};

/// What the derived sections are derived from, beside the other sections.
struct DerivedFrom {
    const Dataset* dataset = nullptr;    ///< the faults of curvilinear data are found in it ...
    const KnownFaults* faults = nullptr; ///< ... or by these; with neither the file has no list of them
    const ModelDescription& description;
    FixedCounts counts;
    float finalKey = 0;                        ///< of the mesh of all sites
    std::array<std::uint32_t, 3> blockCells{}; ///< HistoryTraits::blockCells
};

/// Writes them, once all other sections have been written; the level index has been planned. Reads these again. Memory:
/// buffers; of data that warp 4 bytes a site and 16 a batch, and 8 a cell of a grid that has no volume. Errors: the
/// file's. May throw std::bad_alloc.
Status writeDerivedSections(SectionWriter& sections, const DerivedFrom& from);

} // namespace tetra
