// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/mesh/history.h"
#include "core/model/model.h"

#include <memory>

namespace tetra {

/// Writes a history into a `.tan` file while it is made. Nothing appears under `path` before finish() has succeeded:
/// the file is written beside it, synced and renamed; destroying an unfinished writer removes what it wrote. Steps
/// are put together into batches and groups on the way (FORMAT.md). Memory: about 8 bytes a tetrahedron and 4 a site,
/// and one batch whole; all else waits on the disk.
class ModelWriter : public HistorySink {
public:
    /// `description` needs builder and parameters; the rest is taken from `dataset`. The unfinished file lies in
    /// `workFolder`, on the same disk; without one beside `path`.
    static Result<std::unique_ptr<ModelWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                       ModelDescription description,
                                                       const std::filesystem::path& workFolder = {});
    /// In place of finish(), at any time: completes the file with the sites before the batch that is not complete yet,
    /// a mesh of known error. Error: no batch is complete.
    virtual Status finishEarly() = 0;
    /// Handed over so far.
    virtual std::uint32_t siteCount() const noexcept = 0;
    /// In the file so far, without those of the batch that is not complete yet.
    virtual std::uint64_t tetrahedronCount() const noexcept = 0;
};

} // namespace tetra
