// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/data/dataset.h"
#include "core/mesh/history.h"
#include "core/model/model.h"

#include <memory>

namespace tetra {

/// Writes a history into a `.tan` file while it is made. Nothing appears under `path` before finish() has succeeded:
/// the file is written beside it, synced and renamed; destroying an unfinished writer removes what it wrote. Memory:
/// about 6 bytes a tetrahedron and 20 a site; the sites of the tetrahedra go straight to the disk.
class ModelWriter : public HistorySink {
public:
    /// `description` needs builder and parameters; the rest is taken from `dataset`.
    static Result<std::unique_ptr<ModelWriter>> create(const std::filesystem::path& path, const Dataset& dataset,
                                                       ModelDescription description);
    /// So far.
    virtual std::uint32_t siteCount() const noexcept = 0;
    virtual std::uint64_t tetrahedronCount() const noexcept = 0;
};

} // namespace tetra
