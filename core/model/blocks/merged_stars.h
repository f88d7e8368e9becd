// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/model/blocks/block_merge.h"
#include "core/model/blocks/merged_numbers.h"
#include "core/model/planned_model_writer.h"

#include <cstdint>
#include <vector>

namespace tetra {

/// Some consecutive groups of the whole model, and where their tetrahedra are.
struct MergedChunk {
    std::uint32_t firstSite = 0;
    std::vector<std::uint32_t> points;
    std::vector<float> runningKeys;
    std::vector<std::uint8_t> groupGoesOn;
    std::vector<std::uint32_t> meshSizes;
    std::vector<MergedBatch::Part> parts;
    std::uint64_t tetrahedronCount = 0;
};

/// Cuts the merged batches of all runs into chunks of about the same number of tetrahedra, at ends of groups.
class ChunkMaker {
public:
    explicit ChunkMaker(const RunFiles& runs) : merge_(runs) {}

    /// An empty chunk at the end.
    Result<MergedChunk> next();

private:
    void takeGroup(MergedChunk& chunk);

    BlockMerge merge_;
    bool inBatch_ = false;
    std::uint32_t place_ = 0; ///< in the batch, where the next group begins
    std::size_t part_ = 0;
    std::uint32_t sites_ = 0; ///< before the next group, in the whole model
    std::uint64_t meshSize_ = 0;
};

/// The chunk's tetrahedra in the model's numbers and order.
struct TranslatedStars {
    std::vector<std::uint32_t> starSizes;
    std::vector<std::array<std::uint32_t, 3>> otherSites;
    std::vector<std::uint32_t> destroyers;
    std::vector<std::uint16_t> ownErrors;
};

/// Reads and translates them. Any number of threads may do that with chunks of their own. May throw std::bad_alloc.
Result<TranslatedStars> translateStars(const MergedChunk& chunk, const RunFiles& runs, const MergedNumbers& numbers);

} // namespace tetra
