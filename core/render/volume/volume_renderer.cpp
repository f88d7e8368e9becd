// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/render/volume/volume_renderer.h"

#include "core/base/progress.h"
#include "core/render/order/visibility_order.h"
#include "core/render/scene_checks.h"
#include "core/render/tiles.h"
#include "core/render/volume/boundary_relations.h"
#include "core/render/volume/projected_volume.h"
#include "core/render/volume/tile_picture.h"

#include <tan/base.h>

#include <tan/render.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <Eigen/LU>

#include <algorithm>
#include <atomic>

namespace tetra {

namespace {

constexpr MarkedText renderingVolume = Message::marked("Drawing the volume");
constexpr MarkedText ordering = Message::marked("Ordering the tetrahedra");

Status checkSize(const VolumeOptions& options)
{
    if (options.width < 1 || options.height < 1 || options.width > largestPictureSide ||
        options.height > largestPictureSide)
        return Error{ErrorKind::WrongUsage,
                     Message::say("A picture must have 1 to %1 samples per side. Draw a larger one in parts.",
                                  largestPictureSide)};
    return {};
}

TileGrid gridOf(const VolumeView& view)
{
    return {view.width, view.height, volumeTileSide};
}

/// Copies a tile to its place in the picture.
void place(const DrawnTile& drawn, const SampleRectangle& tile, VolumePicture& picture)
{
    const auto width = static_cast<std::size_t>(tile.width());
    for (int row = tile.top; row < tile.bottom; ++row) {
        const auto from = static_cast<std::size_t>(row - tile.top) * width;
        const auto to = static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                        static_cast<std::size_t>(tile.left);
        std::ranges::copy(drawn.colours.subspan(from, width), picture.samples.data() + to);
        if (!picture.depth.empty())
            std::ranges::copy(drawn.depth.subspan(from, width), picture.depth.data() + to);
    }
}

Result<VolumePicture> draw(const VolumeMesh& mesh, const VolumeTransfer& transfer, std::span<const std::uint32_t> order,
                           const VolumeView& view, const VolumeOptions& options, const Progress& progress)
{
    progress.report(0, renderingVolume);
    const TileGrid grid = gridOf(view);
    const ProjectedVolume volume = projectVolume(mesh, transfer, order, view, grid, false, progress);
    if (progress.cancelled())
        return cancelledError(renderingVolume);

    VolumePicture picture{view.width, view.height, {}, {}, 0};
    const std::size_t samples = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
    picture.samples.resize(samples);
    picture.depth.resize(options.depth ? samples : 0);

    const SetupSource source = setupSourceOf(mesh, transfer, volume, view);
    const TileSurroundings surroundings{.depth = options.depth};
    SharedProgress tiles(progress.part(0.2, 1), static_cast<double>(grid.count()), renderingVolume);
    std::atomic<std::size_t> drawnCells = 0;
    tbb::enumerable_thread_specific<VolumeTilePainter> painters([&] { return VolumeTilePainter(source, view); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.count(), 1), [&](const auto& range) {
        VolumeTilePainter& painter = painters.local();
        for (std::size_t t = range.begin(); t != range.end() && !progress.cancelled(); ++t) {
            const SampleRectangle tile = grid.tile(t);
            const DrawnTile drawn = painter.paint(tile, volume.bins.cellsOf(t), surroundings, progress);
            place(drawn, tile, picture);
            drawnCells += drawn.cells;
            tiles.done(1);
        }
    });
    if (progress.cancelled())
        return cancelledError(renderingVolume);
    picture.drawnCells = drawnCells;
    return picture;
}

template <class Value, class Added> Buffer<Value> joined(const Buffer<Value>& values, const Added& added)
{
    Buffer<Value> all;
    all.reserve(values.size() + added.size());
    all.insert(all.end(), values.begin(), values.end());
    all.insert(all.end(), added.begin(), added.end());
    return all;
}

/// The gradients at the vertices of pieces: a piece has the field of its cell, and so its light.
std::vector<Eigen::Vector3f> gradientsOfPieces(const VolumeMesh& mesh, const CellPieces& pieces)
{
    const TetrahedralMesh& whole = *mesh.mesh;
    std::vector<Eigen::Vector3f> gradients(pieces.positions.size(), Eigen::Vector3f(0, 0, 0));
    for (std::size_t piece = 0; piece < pieces.tetrahedra.size(); ++piece) {
        const auto& corners = whole.tetrahedra[pieces.cells[piece]];
        const Eigen::Vector3d& origin = whole.positions[corners[0]];
        Eigen::Matrix3d edges;
        Eigen::Matrix3f rises;
        for (int edge = 0; edge < 3; ++edge) {
            const std::uint32_t corner = corners[static_cast<std::size_t>(edge) + 1];
            edges.col(edge) = whole.positions[corner] - origin;
            rises.col(edge) = mesh.gradients[corner] - mesh.gradients[corners[0]];
        }
        const Eigen::Matrix3d shares = edges.inverse();
        for (const std::uint32_t vertex : pieces.tetrahedra[piece])
            if (vertex >= whole.positions.size()) {
                const std::size_t added = vertex - whole.positions.size();
                const Eigen::Vector3d at = shares * (pieces.positions[added] - origin);
                gradients[added] = mesh.gradients[corners[0]] + rises * at.cast<float>();
            }
    }
    return gradients;
}

/// The mesh with the pieces after its own cells, without their neighbours.
VolumeMesh meshWithPieces(const VolumeMesh& mesh, const CellPieces& pieces)
{
    const TetrahedralMesh& whole = *mesh.mesh;
    TetrahedralMesh cut{joined(whole.positions, pieces.positions), joined(whole.values, pieces.values),
                        joined(whole.tetrahedra, pieces.tetrahedra)};
    return {std::make_shared<const TetrahedralMesh>(std::move(cut)),
            {},
            mesh.bounds,
            mesh.convex,
            joined(mesh.gradients, gradientsOfPieces(mesh, pieces)),
            mesh.longestGradient};
}

/// Pieces lie in no more segments than their cells.
VolumeTransfer transferWithPieces(const VolumeTransfer& transfer, const CellPieces& pieces)
{
    std::vector<CellClass> classes;
    for (const std::uint32_t cell : pieces.cells)
        classes.push_back(transfer.classes[cell]);
    return {transfer.segments, joined(transfer.classes, classes)};
}

/// orderForCamera() for a view that is made already, on all threads of the current arena. Errors: cancelled. May throw
/// std::bad_alloc.
Result<VisibilityOrder> orderForView(const VolumeMesh& mesh, const VolumeView& view, const Progress& progress)
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

} // namespace

Result<VisibilityOrder> orderForCamera(const VolumeMesh& mesh, const Camera& camera, const VolumeOptions& options,
                                       const Progress& progress)
{
    if (Status status = checkSize(options); !status)
        return status.error();
    return onThreads(options.threads, [&]() -> Result<VisibilityOrder> {
        return orderForView(mesh, makeVolumeView(camera, options.width, options.height, mesh.bounds), progress);
    });
}

Result<VolumePicture> drawVolume(const VolumeMesh& mesh, const VolumeTransfer& transfer, const VisibilityOrder& order,
                                 const Camera& camera, const VolumeOptions& options, const Progress& progress)
{
    if (Status status = checkSize(options); !status)
        return status.error();
    if (!belongTogether(mesh, transfer, order))
        return Error{ErrorKind::WrongUsage,
                     Message::say("The mesh, its transfer function and its order do not belong together.")};
    return onThreads(options.threads, [&]() -> Result<VolumePicture> {
        const VolumeView view = makeVolumeView(camera, options.width, options.height, mesh.bounds);
        if (order.pieces.cells.empty())
            return draw(mesh, transfer, order.cells, view, options, progress);
        return draw(meshWithPieces(mesh, order.pieces), transferWithPieces(transfer, order.pieces), order.cells, view,
                    options, progress);
    });
}

bool CachedOrder::fits(const Request& request) const
{
    if (mesh_.expired() || mesh_.lock() != request.mesh)
        return false;
    const bool sameSamples = pictureSize_ == Eigen::Vector2i(request.whole.width, request.whole.height) &&
                             part_ == request.part && camera_ == request.camera;
    if (sameSamples)
        return true;
    const SampleRectangle whole{0, 0, pictureSize_.x(), pictureSize_.y()};
    if (!request.mesh->convex && (request.tolerance <= 0 || part_ != whole))
        return false;
    return orderDrift(request.mesh->bounds, camera_, request.camera) <= request.tolerance;
}

Status CachedOrder::prepare(const Request& request, const Progress& progress)
{
    reused_ = fits(request);
    if (reused_)
        return {};
    mesh_.reset();
    auto order = orderForView(*request.mesh, partOf(request.whole, request.part), progress);
    if (!order)
        return order.error();
    order_ = std::move(order).value();
    cut_.reset();
    if (!order_.pieces.cells.empty())
        cut_ = std::make_shared<const VolumeMesh>(meshWithPieces(*request.mesh, order_.pieces));
    mesh_ = request.mesh;
    camera_ = request.camera;
    pictureSize_ = {request.whole.width, request.whole.height};
    part_ = request.part;
    return {};
}

Volume CachedOrder::withPieces(const Volume& volume) const
{
    if (!cut_)
        return volume;
    Volume cut = volume;
    cut.mesh = cut_;
    cut.transfer = std::make_shared<const VolumeTransfer>(transferWithPieces(*volume.transfer, order_.pieces));
    return cut;
}

} // namespace tetra
