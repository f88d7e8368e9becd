// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/model/model.h"
#include "core/model/planned_sections.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace tetra {

/// How much a planned model holds.
struct PlannedCounts {
    std::uint32_t sites = 0;
    std::uint64_t tetrahedra = 0;
};

/// Consecutive sites of a model and the tetrahedra that they created, in the model's own numbers and order (FORMAT.md).
struct PlannedStars {
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
class PlannedModelWriter {
public:
    /// `description` as for ModelWriter. `workFolder` holds the file until it is complete; on the same disk as `path`.
    static Result<std::unique_ptr<PlannedModelWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                              ModelDescription description, const PlannedCounts& counts,
                                                              const std::filesystem::path& workFolder = {});

    /// Appends. An Error if there is more of anything than was planned.
    Status add(const PlannedStars& stars);
    /// `finalKey` bounds the error of the mesh of all sites, in units of the values.
    Status finish(float finalKey);

    /// Bytes of a model of this size, of a lattice of so many points, as well as is known beforehand.
    static std::uint64_t expectedBytes(const PlannedCounts& counts, SampleType type, std::uint64_t points) noexcept;

private:
    PlannedModelWriter(FileWriter file, const Dataset& dataset, ModelDescription description,
                       const PlannedCounts& counts);
    Status begin();
    Status addOffsets(std::span<const std::uint32_t> starSizes);
    Status addValues(std::span<const std::uint32_t> points);
    bool samplesKept() const noexcept;
    Error notAsPlanned() const;

    std::filesystem::path target_;
    PlannedSections sections_;
    Dataset dataset_;
    ModelDescription description_;
    PlannedCounts planned_;
    PlannedCounts added_;
    std::vector<std::uint64_t> offsets_;
    Buffer<std::byte> values_;
};

} // namespace tetra
