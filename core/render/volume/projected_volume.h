// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/render/order/visibility_order.h"
#include "core/render/tiles.h"
#include "core/render/volume/cell_setup.h"
#include "core/render/volume/model_tile.h"
#include "core/render/volume/projected_vertices.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>
#include <tan/render.h>

#include <cstdint>
#include <optional>
#include <span>

namespace tetra {

/// A volume made ready to be drawn into the tiles of a view.
struct ProjectedVolume {
    ScaledSegments scaled;
    ProjectedVertices projected;
    Buffer<VertexGradient> gradients; ///< of the vertices if it is lit, else none
    CellBins bins;
};

/// `order` front to back. Mesh, transfer function and order belong together (belongTogether). O(cells + entries of the
/// tiles), on all threads of the current arena. Incomplete if cancelled. May throw std::bad_alloc.
ProjectedVolume projectVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer,
                              std::span<const std::uint32_t> order, const VolumeView& view, const TileGrid& grid,
                              bool lit, const Progress& progress);

/// What its cells are set up from; all arguments must outlive it.
SetupSource setupSourceOf(const VolumeMesh& mesh, const VolumeTransfer& transfer, const ProjectedVolume& volume,
                          const VolumeView& view);

/// What drawing by the volume's optical model needs; nothing if it has none. `volume` outlives it.
std::optional<TileModel> tileModelOf(const Volume& volume, const ProjectedVolume& projected, const VolumeView& view);

/// The transfer function has a class for each of the mesh's cells, and the order names only such cells and its pieces.
bool belongTogether(const VolumeMesh& mesh, const VolumeTransfer& transfer, const VisibilityOrder& order);

} // namespace tetra
