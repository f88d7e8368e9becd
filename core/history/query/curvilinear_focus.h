// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <memory>

namespace tetra {

/// What RegionRefiner is for regular lattices, for curvilinear grids: the sites that the fields ask for inserted into
/// the coarse mesh of computational space, where it is Delaunay, then the worst samples and the cures of flipped
/// tetrahedra that may not stay so (S5) until every sample's error and warping is at most the fields'. For any fields.
/// Holds 50 bytes for each point of the grid. Used from one thread at a time.
class CurvilinearFocus {
public:
    /// Whether the model allows it: curvilinear, unweighted, not too large, its file with all samples.
    static bool fits(const Model& model);
    /// `model` fits and outlives it.
    explicit CurvilinearFocus(const Model& model);
    ~CurvilinearFocus();
    CurvilinearFocus(CurvilinearFocus&&) noexcept;
    CurvilinearFocus& operator=(CurvilinearFocus&&) noexcept;

    /// The mesh for query.error and query.warping; nothing else of the query counts. `reuse`: a result whose buffers
    /// may be used again.
    Result<ExtractedMesh> extract(const MeshQuery& query, const Progress& progress = {}, ExtractedMesh reuse = {});

private:
    class Work;
    std::unique_ptr<Work> work_;
};

} // namespace tetra
