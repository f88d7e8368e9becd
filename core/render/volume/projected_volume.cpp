// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/projected_volume.h"

#include <algorithm>

namespace tetra {

ProjectedVolume projectVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer,
                              std::span<const std::uint32_t> order, const VolumeView& view, const TileGrid& grid,
                              const Progress& progress)
{
    ProjectedVolume volume;
    volume.scaled = scaleSegments(transfer.segments, view.unit);
    volume.projected = projectVertices(*mesh.mesh, view, volume.scaled);
    volume.bins = binCells(mesh.mesh->tetrahedra, transfer.classes, order, volume.projected, view, grid, progress);
    return volume;
}

SetupSource setupSourceOf(const VolumeMesh& mesh, const VolumeTransfer& transfer, const ProjectedVolume& volume,
                          const VolumeView& view, bool shaded)
{
    SetupSource source{mesh.mesh->tetrahedra,
                       volume.projected.vertices,
                       transfer.classes,
                       volume.scaled.segments,
                       view.perspective,
                       shaded,
                       {}};
    for (int axis = 0; axis < 2; ++axis)
        source.lengths[static_cast<std::size_t>(axis)] =
            static_cast<float>(view.imageFromWorld.row(axis).head<3>().norm() * view.unit);
    return source;
}

std::optional<TileModel> tileModelOf(const Volume& volume, const ProjectedVolume& projected, const VolumeView& view)
{
    if (!volume.model)
        return std::nullopt;
    return TileModel{volume.model.get(), projected.scaled.smallest, projected.scaled.perValue, view.unit};
}

bool belongTogether(const VolumeMesh& mesh, const VolumeTransfer& transfer, const VisibilityOrder& order)
{
    const std::size_t cells = mesh.mesh->tetrahedra.size();
    const std::size_t named = cells + order.pieces.tetrahedra.size();
    return transfer.classes.size() == cells &&
           std::ranges::all_of(order.cells, [&](std::uint32_t cell) { return cell < named; });
}

} // namespace tetra
