// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/face_adjacency.h"
#include "core/render/order/visibility_order.h"
#include "core/render/tiles.h"
#include "core/render/volume/projected_vertices.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// For each sample whose ray leaves the domain and comes back: the cell that it leaves by and the cell that it comes
/// back by. Sorted, without doubles. Draws the faces of the boundary into the tiles of `grid`: O(cells + samples they
/// cover), on all threads of the current arena. Incomplete if cancelled. May throw std::bad_alloc.
std::vector<CellRelation> boundaryRelations(std::span<const std::array<std::uint32_t, 4>> tetrahedra,
                                            const FaceAdjacency& adjacency, const ProjectedVertices& projected,
                                            const VolumeView& view, const TileGrid& grid, const Progress& progress);

} // namespace tetra
