// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_renderer.h"

#include "core/graphics/picture_options.h"
#include "core/graphics/volume/boundary_relations.h"
#include "core/graphics/volume/cell_bins.h"
#include "core/graphics/volume/tile_picture.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>

namespace tetra {
namespace {

constexpr std::string_view activity = "Drawing the volume";
constexpr std::string_view ordering = "Ordering the tetrahedra";

/// Runs `work` on as many threads as are wanted.
template <class Work> auto onThreads(const VolumeOptions& options, Work&& work) -> decltype(work())
{
    if (options.width < 1 || options.height < 1 || options.width > largestPictureSide ||
        options.height > largestPictureSide)
        return Error{ErrorKind::WrongUsage, "A picture must have 1 to " + std::to_string(largestPictureSide) +
                                                " samples a side. Draw a larger one in parts."};
    try {
        const int all = tbb::info::default_concurrency();
        tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, all) : all);
        return arena.execute(work);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, "Not enough memory for a volume picture of this size and mesh. Make the "
                                               "picture smaller or lower the accuracy of the mesh."};
    }
}

/// Counts finished tiles for all threads, so that the fraction never falls.
class TileProgress {
public:
    TileProgress(const Progress& progress, std::size_t tiles) : progress_(progress), tiles_(tiles) {}
    void tileDone()
    {
        const std::scoped_lock lock(mutex_);
        progress_.report(static_cast<double>(++done_) / static_cast<double>(tiles_), activity);
    }

private:
    const Progress& progress_;
    std::size_t tiles_;
    std::size_t done_ = 0;
    std::mutex mutex_;
};

TileGrid gridOf(const VolumeView& view)
{
    return {view.width, view.height, volumeTileSide};
}

Result<VisibilityOrder> makeOrder(const VolumeMesh& mesh, const VolumeView& view, const Progress& progress)
{
    progress.report(0, ordering);
    const TetrahedralMesh& cells = *mesh.mesh;
    std::vector<CellRelation> relations;
    if (!mesh.convex)
        relations = boundaryRelations(cells.tetrahedra, mesh.adjacency, projectVertices(cells, view, {}), view,
                                      gridOf(view), progress);
    if (progress.cancelled())
        return cancelledError(ordering);
    VisibilityOrder order = orderByAdjacency(cells, mesh.adjacency, {view.eye, view.perspective}, relations);
    progress.report(1, ordering);
    return order;
}

Result<VolumePicture> draw(const VolumeMesh& mesh, const VolumeTransfer& transfer, std::span<const std::uint32_t> order,
                           const VolumeView& view, const VolumeOptions& options, const Progress& progress)
{
    progress.report(0, activity);
    const auto& tetrahedra = mesh.mesh->tetrahedra;
    const ScaledSegments scaled = scaleSegments(transfer.segments, view.unit);
    const ProjectedVertices projected = projectVertices(*mesh.mesh, view, scaled);
    const TileGrid grid = gridOf(view);
    const CellBins bins = binCells(tetrahedra, transfer.classes, order, projected, view, grid, progress);
    if (progress.cancelled())
        return cancelledError(activity);

    const SetupSource source{tetrahedra, projected.vertices, transfer.classes, scaled.segments, view.perspective};
    VolumePicture picture{view.width, view.height, {}, {}, 0};
    const std::size_t samples = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    picture.samples.resize(samples);
    picture.depth.resize(options.depth ? samples : 0);

    const Progress tilesPart = progress.part(0.2, 1);
    TileProgress done(tilesPart, grid.count());
    std::atomic<std::size_t> drawn = 0;
    tbb::enumerable_thread_specific<VolumeTilePainter> painters([&] { return VolumeTilePainter(source, view); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.count(), 1), [&](const auto& range) {
        VolumeTilePainter& painter = painters.local();
        for (std::size_t tile = range.begin(); tile != range.end() && !progress.cancelled(); ++tile) {
            drawn += painter.paint(grid.tile(tile), bins.cellsOf(tile), progress, picture);
            done.tileDone();
        }
    });
    if (progress.cancelled())
        return cancelledError(activity);
    picture.drawnCells = drawn;
    return picture;
}

bool belongTogether(const VolumeMesh& mesh, const VolumeTransfer& transfer, std::span<const std::uint32_t> order)
{
    const std::size_t cells = mesh.mesh->tetrahedra.size();
    return transfer.classes.size() == cells && std::ranges::all_of(order, [&](auto cell) { return cell < cells; });
}

} // namespace

Result<VisibilityOrder> orderForCamera(const VolumeMesh& mesh, const Camera& camera, const VolumeOptions& options,
                                       const Progress& progress)
{
    return onThreads(options, [&]() -> Result<VisibilityOrder> {
        return makeOrder(mesh, makeVolumeView(camera, options.width, options.height, mesh.bounds), progress);
    });
}

Result<VolumePicture> drawVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer,
                                 std::span<const std::uint32_t> order, const Camera& camera,
                                 const VolumeOptions& options, const Progress& progress)
{
    if (!belongTogether(mesh, transfer, order))
        return Error{ErrorKind::WrongUsage, "The mesh, its transfer function and its order do not belong together."};
    return onThreads(options, [&]() -> Result<VolumePicture> {
        const VolumeView view = makeVolumeView(camera, options.width, options.height, mesh.bounds);
        return draw(mesh, transfer, order, view, options, progress);
    });
}

} // namespace tetra
