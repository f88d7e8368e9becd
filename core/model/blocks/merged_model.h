// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/model/blocks/merged_stars.h"
#include "core/model/planned_model_writer.h"

#include <filesystem>
#include <functional>
#include <memory>

namespace tetra {

/// Opens the model that is to be written, once its size is known.
using PlannedModelOpener = std::function<Result<std::unique_ptr<PlannedModelWriter>>(const PlannedCounts&)>;

/// Merges the runs of all blocks into one model, on all threads that TBB may use; the result does not depend on their
/// number nor on the slices in which large groups are taken. Memory: some buffers, the sites of one batch, and a slice
/// a thread. Errors: the runs' and the model's files, memory, cancelled.
Result<PlannedCounts> mergeRuns(RunFiles& runs, const std::filesystem::path& workFolder, const PlannedModelOpener& open,
                                const Progress& progress, std::uint64_t sliceTetrahedra = usualSliceTetrahedra);

} // namespace tetra
