// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/history/blocks/block_merge.h"
#include "core/history/blocks/run_files.h"
#include "core/history/model_writer.h"

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace tetra {

/// Consecutive sites of the whole model, and where their tetrahedra are: whole groups, or a slice of a large one.
struct MergedChunk {
    std::uint32_t firstSite = 0;
    bool slice = false; ///< its parts hold tetrahedra of other sites, too
    std::vector<std::uint32_t> points;
    std::vector<float> runningKeys;
    std::vector<std::uint8_t> groupGoesOn;
    std::vector<std::uint32_t> meshSizes;
    std::vector<MergedBatch::Part> parts;
    std::uint64_t tetrahedronCount = 0; ///< of a slice about
};

/// Of a group that is cut; each slice reads all parts that reach into it, so not too thin.
constexpr std::uint64_t usualSliceTetrahedra = 1 << 20;

/// Cuts the merged batches of all runs into chunks of about the same number of tetrahedra. Groups are cut only if they
/// have more than two slices: where large parts of the data hardly differ, one group may hold a good part of a batch.
class ChunkMaker {
public:
    explicit ChunkMaker(const RunFiles& runs, std::uint64_t sliceTetrahedra = usualSliceTetrahedra)
        : merge_(runs), sliceTetrahedra_(sliceTetrahedra)
    {
    }

    /// An empty chunk at the end.
    Result<MergedChunk> next();

private:
    /// A group of the batch.
    struct Group {
        std::uint32_t endPlace = 0;
        std::size_t endPart = 0;
        std::uint64_t tetrahedronCount = 0;
    };

    Result<bool> findGroup();
    void takeGroup(MergedChunk& chunk);
    void takeSlice(MergedChunk& chunk);
    void takeSites(MergedChunk& chunk, std::uint32_t endPlace);

    BlockMerge merge_;
    std::uint64_t sliceTetrahedra_;
    bool inBatch_ = false;
    bool inGroup_ = false;
    Group group_;
    std::uint32_t place_ = 0; ///< in the batch: the next site
    std::size_t part_ = 0;    ///< in the batch: the group's first
    std::uint32_t sliceSites_ = 0;
    std::uint32_t sites_ = 0;    ///< before the next group, in the whole model
    std::uint64_t meshSize_ = 0; ///< after the group
};

/// Opens the model that is to be written, once its size is known.
using ModelFileOpener = std::function<Result<std::unique_ptr<ModelFileWriter>>(const FixedCounts&)>;

/// Merges the runs of all blocks into one model (why builds of whole datasets do not go this way: model_writer.h), on
/// all threads that TBB may use; the result does not depend on their number nor on the slices in which large groups are
/// taken. Memory: some buffers, the sites of one batch, and a slice a thread. Errors: the runs' and the model's files,
/// memory, cancelled.
Result<FixedCounts> mergeRuns(const RunFiles& runs, const std::filesystem::path& workFolder,
                              const ModelFileOpener& open, const Progress& progress,
                              std::uint64_t sliceTetrahedra = usualSliceTetrahedra);

/// What bounds of errors and warpings in runs count in.
struct RunUnits {
    double valueExtent = 1;
    double diagonal = 0;      ///< of the box around the dataset, 0 where there is no warping
    double warpingWeight = 0; ///< HistoryTraits
};

/// Hands the mesh of all sites to `sink`, as a history of that mesh alone, begin() to finish(): something to look at.
/// Memory: that of mergeRuns() on one thread. Errors: the runs' files, memory, the sink's, cancelled.
Status handMesh(const RunFiles& runs, const std::filesystem::path& workFolder, const RunUnits& units, HistorySink& sink,
                const Progress& progress);

} // namespace tetra
