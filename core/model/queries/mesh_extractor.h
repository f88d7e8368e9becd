// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/model/model.h"
#include "core/model/queries/mesh_query.h"

#include <memory>

namespace tetra {

/// Answers query after query to one model. What variable queries look at again and again is kept: places and values of
/// the sites, and links of the part of the history that was looked at, never more than 8 bytes for each tetrahedron of
/// that. A uniform mesh is kept, too, so that another window or other values of it cost only the filter. Used from one
/// thread at a time. Results live on without it. If the last result is not held by anybody else its memory is used
/// again.
class MeshExtractor {
public:
    explicit MeshExtractor(std::shared_ptr<const Model> model);
    ~MeshExtractor();
    MeshExtractor(MeshExtractor&&) noexcept;
    MeshExtractor& operator=(MeshExtractor&&) noexcept;

    const std::shared_ptr<const Model>& model() const noexcept;

    /// The mesh that the query asks for. Errors: WrongUsage (a query that makes no sense, with what to change), a
    /// damaged file, out of memory, cancelled. After an error the next query starts afresh.
    Result<std::shared_ptr<const ExtractedMesh>> extract(const MeshQuery& query, const Progress& progress = {});

private:
    class Work;
    std::unique_ptr<Work> work_;
};

} // namespace tetra
