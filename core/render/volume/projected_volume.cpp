// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/projected_volume.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace tetra {
namespace {

/// By the axes of the view, O(vertices), on all threads of the current arena. May throw std::bad_alloc.
Buffer<VertexGradient> projectGradients(const VolumeMesh& mesh, const VolumeView& view)
{
    const Eigen::Matrix3f axes = view.axes();
    Buffer<VertexGradient> gradients(mesh.gradients.size());
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, gradients.size(), 1 << 13), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
            const Eigen::Vector3f seen = axes * mesh.gradients[i];
            gradients[i] = {seen.x(), seen.y(), seen.z(), 0};
        }
    });
    return gradients;
}

} // namespace

ProjectedVolume projectVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer,
                              std::span<const std::uint32_t> order, const VolumeView& view, const TileGrid& grid,
                              bool lit, const Progress& progress)
{
    ProjectedVolume volume;
    volume.scaled = scaleSegments(transfer.segments, view.unit);
    volume.projected = projectVertices(*mesh.mesh, view, volume.scaled);
    if (lit)
        volume.gradients = projectGradients(mesh, view);
    volume.bins = binCells(mesh.mesh->tetrahedra, transfer.classes, order, volume.projected, view, grid, progress);
    return volume;
}

SetupSource setupSourceOf(const VolumeMesh& mesh, const VolumeTransfer& transfer, const ProjectedVolume& volume,
                          const VolumeView& view)
{
    SetupSource source{mesh.mesh->tetrahedra,
                       volume.projected.vertices,
                       transfer.classes,
                       volume.scaled.segments,
                       view.perspective,
                       volume.gradients,
                       0,
                       false,
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
