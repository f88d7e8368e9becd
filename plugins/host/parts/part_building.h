// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/import_options.h"
#include "plugins/host/model_building.h"
#include "plugins/host/parts/parts_plan.h"
#include "plugins/host/plugin_host.h"

#include <tan/base.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

// A build that many processes share, on one machine or on many that see one disk (D15): one prepares it, then each
// builds a part, whenever and in whatever order, and at last one merges them. Nobody talks to anybody; a part that was
// killed is begun again and goes on. The model is, byte for byte, the one that a single process builds in the same
// blocks. Call from worker threads.

namespace tetra {

/// What is prepared: the plan, and the dataset, which has more to tell than goes into it.
struct PreparedParts {
    PartsPlan plan;
    Dataset dataset;
};

/// Goes through the dataset and leaves a plan in `folder`, which is made if it is not there. `builder` and `values` as
/// of buildModel(), but without an id the builder is one that builds in parts; where the edge of a block is the
/// builder's choice, it is 32 cells. Errors: what cannot be built in parts (WrongUsage); writePlan()'s, the reader's,
/// the builder's.
Result<PreparedParts> prepareParts(PluginHost& host, const std::filesystem::path& input, const ImportOptions& imported,
                                   const std::optional<std::string>& builder, const ParameterValues& values,
                                   const std::filesystem::path& folder, const Progress& progress = {});

/// What a part came to.
struct BuiltPart {
    bool wasFinished = false; ///< already, and left as it was
    std::uint64_t sites = 0;  ///< those on faces of blocks once for each block
    std::uint64_t tetrahedra = 0;
    double seconds = 0;
    std::uint64_t peakBytes = 0; ///< ModelBuild's
};

/// Builds part `number` of `count`, from 1, of the build that was prepared in `folder`, of which any number of parts
/// may be built at once; a part that is finished already is left as it is. Reads no more of the samples than the part's
/// blocks need, if these lie in a file as they are used. `waits`: BuildPart's. Errors: no plan; data that have changed
/// since (BadInput); other parts that have to be built further first (NotYet); the folder's disk; cancelled.
Result<BuiltPart> buildPart(PluginHost& host, const std::filesystem::path& folder, std::uint32_t number,
                            std::uint32_t count, bool waits = false, const Progress& progress = {});

/// Merges the parts in `folder` into the model `output`, as buildModel() makes it. The folder stays as it is. Errors:
/// parts that are not finished (NotYet), damaged, or of another build; data that have changed since the build was
/// prepared (BadInput); buildModel()'s.
Result<ModelBuild> mergeParts(PluginHost& host, const std::filesystem::path& folder,
                              const std::filesystem::path& output, const Progress& progress = {});

} // namespace tetra
