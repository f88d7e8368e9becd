// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/disjoint_sets.h"
#include "core/history/blocks/run_files.h"

#include <cstdint>
#include <queue>
#include <vector>

namespace tetra {

/// A batch of the whole model, put together from those of the blocks: a point on a shared face is one site, and groups
/// that have a site in common are one.
struct MergedBatch {
    /// What one block's group contributes.
    struct Part {
        std::uint32_t block = 0;
        std::uint32_t siteCount = 0;
        std::uint32_t firstSite = 0; ///< in the block
        std::uint32_t tetrahedronCount = 0;
        std::uint32_t destroyedCount = 0;
        std::uint32_t firstPlace = 0;       ///< its sites' places are places[firstPlace] and following
        std::uint64_t firstTetrahedron = 0; ///< in the block
        std::uint32_t group = 0;            ///< in the order of the model
    };

    float runningKey = 0;
    std::vector<std::uint32_t> points; ///< of the sites, in the order of the model
    std::vector<std::uint8_t> groupGoesOn;
    std::vector<Part> parts;           ///< in the order of their groups
    std::vector<std::uint32_t> places; ///< where in this batch each part's sites go
};

/// Goes through the batches of all runs in falling order of their keys. Memory: a buffer a run, and one batch's sites.
/// May throw std::bad_alloc.
class BlockMerge {
public:
    explicit BlockMerge(const RunFiles& files);
    ~BlockMerge();

    /// False at the end.
    Result<bool> next();
    const MergedBatch& batch() const noexcept { return batch_; }

private:
    class RunBatches;
    struct Front {
        std::uint32_t key = 0;
        std::uint32_t block = 0;
        /// Whether it comes later: lower keys, then later blocks.
        bool operator<(const Front& other) const { return key != other.key ? key < other.key : block > other.block; }
    };
    /// A site of a part before it is known which sites are one.
    struct Entry {
        std::uint32_t point = 0;
        std::uint32_t part = 0;
        std::uint32_t slot = 0; ///< in places
    };
    /// How far a run has been read.
    struct Counts {
        std::uint32_t sites = 0;
        std::uint64_t tetrahedra = 0;
    };

    Status advance(std::uint32_t block);
    Status readBatch(std::uint32_t block);
    void unite();
    void takeOnlyPart();
    void numberGroups();
    void placeSites();
    void sortParts();

    std::vector<RunBatches> runs_;
    std::vector<Counts> counts_;
    std::priority_queue<Front> fronts_;
    bool started_ = false;
    MergedBatch batch_;
    std::vector<Entry> entries_;
    DisjointSets groups_;                   ///< of the parts
    std::vector<std::uint32_t> groupSizes_; ///< in sites, then where each group's next site goes
};

} // namespace tetra
