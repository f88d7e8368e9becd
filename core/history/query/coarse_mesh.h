// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/insertion/local_delaunay.h"

#include <tan/base.h>
#include <tan/model.h>
#include <tan/query.h>

#include <span>

namespace tetra {

/// The mesh of a prefix of the history into which the points of a focus are inserted, on lattices and on curvilinear
/// grids.
struct CoarseMesh {
    TetrahedralMesh mesh;       ///< as extractPrefix() gives it, but positive in the space that the model was made in
    Buffer<PackedPoint> points; ///< of its vertices
};

/// Extracts the mesh of the first `sites` sites and loads it into `delaunay`, which is prepared. The buffers of
/// `coarse` are used again. Errors: WrongUsage if it is a mesh, but no Delaunay mesh, as other builders make; a damaged
/// file, cancelled.
Status loadCoarse(const Model& model, std::uint32_t sites, const Progress& progress, CoarseMesh& coarse,
                  LocalDelaunay& delaunay);

/// extractPrefix() of as many sites as the model itself tells for an accuracy: where these have no mesh of their own,
/// it is damaged.
Result<TetrahedralMesh> extractLevel(const Model& model, std::uint32_t sites, const Progress& progress,
                                     TetrahedralMesh reuse);

/// Makes `out` the refined mesh, with room for the positions and values of what was added, which come behind those of
/// the coarse mesh. `addedSites` are the sites of delaunay.added(), or ExtractedMesh::noSite.
void writeRefined(const Model& model, const TetrahedralMesh& coarse, const LocalDelaunay& delaunay,
                  std::span<const std::uint32_t> addedSites, ExtractedMesh& out);

/// That a point could not be added.
Error focusTooLarge();
inline constexpr MarkedText noMemoryForFocus =
    Message::marked("Not enough memory for the mesh of the focus. Choose a larger error or a smaller focus.");

} // namespace tetra
