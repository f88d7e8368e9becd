// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/history/extraction.h"
#include "core/history/model.h"
#include "core/history/query/mesh_query.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace tetra {

/// The size of the mesh whose errors are asked for times a number, which the call makes.
using SizeAtScale = std::function<Result<std::uint64_t>(double scale)>;

/// Looks for the least scale, at least 1, whose mesh has at most `budget` tetrahedra, with a few meshes: ends when one
/// uses nine tenths of the budget or the next would hardly differ. The last mesh made is that of the scale returned.
/// `first`: where to begin. Errors: WrongUsage if no mesh up to `largest` is small enough; sizeAt's.
Result<double> scaleWithin(std::uint64_t budget, double first, double largest, const SizeAtScale& sizeAt);

/// The most accurate mesh that a uniform query can give, no finer than asked, before the first one that has more than
/// `budget` tetrahedra. Reads what the file says of its meshes' sizes, as far as that goes. Error: WrongUsage if even
/// the coarsest mesh has more.
Result<MeshSize> meshSizeWithin(const Model& model, const Accuracy& asked, std::uint64_t budget);

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
