// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"
#include "core/render/cpu/draw_list.h"
#include "core/render/cpu/tile_bins.h"
#include "core/render/cpu/tile_painter.h"
#include "core/render/resolve.h"
#include "core/render/scene_checks.h"
#include "core/render/tiles.h"
#include "core/render/view_transform.h"
#include "core/render/volume/projected_volume.h"
#include "core/render/volume/ray_casting.h"
#include "core/render/volume/tile_picture.h"
#include "core/render/volume/volume_mesh.h"
#include "core/render/volume/volume_renderer.h"
#include "core/render/volume/volume_view.h"

#include <tan/base.h>

#include <tan/render.h>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace tetra {

namespace {

/// A part of a picture that is to be drawn, in samples.
struct PartView {
    SampleRectangle part;
    ViewTransform surfaces; ///< of the whole picture
    VolumeView volume;      ///< of the part
    SampleRectangle target; ///< what the picture in memory is of the whole; holds the part
};

/// The volumes of a scene.
struct SceneVolumes {
    const Volume* volume = nullptr;     ///< of a blend that outside
    const FocusVolume* focus = nullptr; ///< the blend
    const SampledVolume* samples = nullptr;
};

/// A volume with the cells that its order names, front to back.
struct OrderedVolume {
    Volume volume;
    std::span<const std::uint32_t> order;
};

/// The volumes of a scene as they are drawn.
struct OrderedVolumes {
    std::optional<OrderedVolume> volume, fine; ///< fine: in the focus
    const FocusVolume* focus = nullptr;        ///< if there is a fine one
    const SampledVolume* samples = nullptr;    ///< in place of the others
};

constexpr MarkedText drawingParts = Message::marked("Drawing the picture");

class Stopwatch {
public:
    /// Seconds since it was made or asked last.
    double lap()
    {
        const auto now = std::chrono::steady_clock::now();
        const std::chrono::duration<double> passed = now - last_;
        last_ = now;
        return passed.count();
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

PremultipliedColour backgroundOf(const PictureOptions& options)
{
    if (options.transparentBackground)
        return {0, 0, 0, 0};
    return {options.background.red, options.background.green, options.background.blue, 1};
}

/// The fine volume of a focus, ready to be drawn.
struct ProjectedFocus {
    ProjectedVolume volume;
    SetupSource source;
    FocusRays rays;
};

/// A part of a scene made ready to be drawn.
struct ProjectedPart {
    OrderedVolumes scene;
    DrawList list;
    TileBins bins;
    ClipBounds clips;
    std::optional<ProjectedVolume> volume;
    SetupSource source; ///< of the volume
    std::optional<TileModel> model;
    std::optional<ProjectedFocus> focus;
    std::optional<SampledView> samples;
};

/// Draws tiles on one thread.
class PartPainter {
public:
    PartPainter(const ProjectedPart& part, const PartView& view, const PictureOptions& options)
        : part_(part), view_(view), options_(options),
          surfaces_(part.list, view.surfaces, view.part, view.volume, part.clips)
    {
        if (part.volume || part.samples)
            volume_.emplace(part.source, view.volume);
        surroundings_.splitCells = !part.scene.volume || !part.scene.volume->volume.wholeCells;
        surroundings_.depth = options.depth;
        surroundings_.model = part.model ? &*part.model : nullptr;
        surroundings_.clips = part.clips.empty() ? nullptr : &part.clips;
    }

    void paint(const SampleRectangle& tile, std::size_t number, const Progress& progress, Picture& picture)
    {
        const auto triangles = part_.bins.trianglesOf(number);
        const bool cells = hasCells(number);
        if (cells || !triangles.empty())
            surfaces_.draw(tile, triangles);
        if (cells)
            paintBoth(tile, number, triangles.empty(), progress);
        else
            paintSurfaces(tile, triangles.empty());
        const int samples = options_.samplesPerAxis;
        const int left = (view_.part.left - view_.target.left + tile.left) / samples;
        const int top = (view_.part.top - view_.target.top + tile.top) / samples;
        resolve(colours_, tile.width(), samples, left, top, picture);
        if (options_.depth)
            resolveDepth(depth_, tile.width(), samples, left, top, picture);
    }

    std::size_t cells() const noexcept { return cells_; }
    std::size_t fragments() const noexcept { return fragments_; }

private:
    void paintSurfaces(const SampleRectangle& tile, bool nothing)
    {
        if (nothing) {
            const auto samples = static_cast<std::size_t>(tile.width()) * static_cast<std::size_t>(tile.height());
            colours_.assign(samples, backgroundOf(options_));
            depth_.assign(options_.depth ? samples : 0, std::numeric_limits<float>::infinity());
            return;
        }
        const auto colours = surfaces_.colours(backgroundOf(options_));
        colours_.assign(colours.begin(), colours.end());
        depth_.clear();
        if (options_.depth)
            for (const float nearness : surfaces_.halfNearness())
                depth_.push_back(distanceOf(nearness));
        fragments_ += surfaces_.fragmentCount();
    }

    bool hasCells(std::size_t tile) const
    {
        return part_.samples || (part_.volume && (!part_.volume->bins.cellsOf(tile).empty() ||
                                                  (part_.focus && !part_.focus->volume.bins.cellsOf(tile).empty())));
    }

    void paintBoth(const SampleRectangle& tile, std::size_t number, bool noSurfaces, const Progress& progress)
    {
        TileSurroundings surroundings = surroundings_;
        FocusTile focus;
        if (part_.focus) {
            focus = {&part_.focus->rays, &part_.focus->source, part_.focus->volume.bins.cellsOf(number),
                     part_.scene.volume->volume.mesh->mesh->positions, part_.scene.fine->volume.mesh->mesh->positions};
            surroundings.focus = &focus;
        }
        if (!noSurfaces) {
            const SurfaceFragments& fragments = surfaces_.fragments();
            surroundings.surfaces = fragments.empty ? nullptr : &fragments;
            fragments_ += surfaces_.fragmentCount();
        }
        const DrawnTile drawn =
            part_.samples
                ? volume_->paintBlocks(tile, surroundings,
                                       [&](const TileShading& shading, SampleBlock* blocks, int columns, int rows) {
                                           castRays(*part_.samples, shading, blocks, columns, rows);
                                       })
                : volume_->paint(tile, part_.volume->bins.cellsOf(number), surroundings, progress);
        cells_ += drawn.cells;
        fragments_ += drawn.fragments;
        colours_.assign(drawn.colours.begin(), drawn.colours.end());
        depth_.assign(drawn.depth.begin(), drawn.depth.end());
        const PremultipliedColour background = backgroundOf(options_);
        for (PremultipliedColour& colour : colours_) {
            const float transmittance = 1 - colour[3];
            for (std::size_t channel = 0; channel < colour.size(); ++channel)
                colour[channel] += transmittance * background[channel];
        }
    }

    float distanceOf(float nearness) const
    {
        if (nearness == TilePainter::neverHalf)
            return std::numeric_limits<float>::infinity();
        if (nearness >= overlayNearness)
            return 0;
        const double w = view_.volume.perspective ? 1.0 / nearness : -nearness;
        return static_cast<float>(w * view_.volume.unit);
    }

    const ProjectedPart& part_;
    const PartView& view_;
    const PictureOptions& options_;
    TileSurroundings surroundings_;
    TilePainter surfaces_;
    std::optional<VolumeTilePainter> volume_;
    std::vector<PremultipliedColour> colours_; ///< of one tile, like `depth_`
    std::vector<float> depth_;
    std::size_t cells_ = 0;
    std::size_t fragments_ = 0;
};

/// Samples an axis of a tile; tiles hold whole pixels.
int tileSideFor(int samplesPerAxis)
{
    return volumeTileSide / samplesPerAxis * samplesPerAxis;
}

/// Draws a part of the scene into its place in the picture: surfaces and lines by tiles, and where there are cells of
/// the volume, both together, front to back (R21). Adds to the statistics. On all threads of
/// the current arena, the same picture with any number. Errors: a scene whose indices lead nowhere, cancelled. May
/// throw std::bad_alloc.
Status drawPart(const Scene& scene, const OrderedVolumes& volumes, const PartView& view, const PictureOptions& options,
                const Progress& progress, Picture& picture, RenderStatistics& statistics)
{
    Stopwatch watch;
    progress.report(0, drawingParts);
    const TileGrid grid{view.part.width(), view.part.height(), tileSideFor(options.samplesPerAxis)};
    Result<DrawList> list = makeDrawList(
        scene, view.surfaces, view.part, options.samplesPerAxis,
        volumes.volume || volumes.samples != nullptr ? SamplePlaces::Rays : SamplePlaces::Middle, progress);
    if (!list)
        return list.error();
    if (progress.cancelled())
        return cancelledError(drawingParts);
    TileBins bins(*list, grid);
    ProjectedPart part{
        volumes, std::move(list).value(), std::move(bins), ClipBounds(scene.clipPlanes, view.volume), {}, {}, {}, {},
        {}};
    if (volumes.volume) {
        const Volume& volume = volumes.volume->volume;
        part.volume = projectVolume(*volume.mesh, *volume.transfer, volumes.volume->order, view.volume, grid,
                                    volume.shaded && !volume.model, progress);
        part.source = setupSourceOf(*volume.mesh, *volume.transfer, *part.volume, view.volume);
        part.source.perFullGradient = perFullGradient(volume.fullGradient, volume.mesh->longestGradient);
        part.source.measured = volume.model != nullptr;
        part.model = tileModelOf(volume, *part.volume, view.volume);
    }
    if (volumes.focus != nullptr) {
        const Volume& fine = volumes.fine->volume;
        part.focus.emplace(ProjectedFocus{
            projectVolume(*fine.mesh, *fine.transfer, volumes.fine->order, view.volume, grid, fine.shaded, progress),
            {},
            FocusRays(volumes.focus->regions, view.volume),
        });
        part.focus->source = setupSourceOf(*fine.mesh, *fine.transfer, part.focus->volume, view.volume);
        part.focus->source.perFullGradient = perFullGradient(fine.fullGradient, fine.mesh->longestGradient);
    }
    if (const SampledVolume* samples = volumes.samples; samples != nullptr) {
        part.samples = makeSampledView(*samples, view.volume);
        part.source.segments = part.samples->scaled.segments;
        part.source.perspective = view.volume.perspective;
    }
    if (progress.cancelled())
        return cancelledError(drawingParts);
    statistics.setUpSeconds += watch.lap();

    SharedProgress tiles(progress.part(0.2, 1), static_cast<double>(grid.count()), drawingParts);
    tbb::enumerable_thread_specific<PartPainter> painters([&] { return PartPainter(part, view, options); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.count(), 1), [&](const auto& range) {
        PartPainter& painter = painters.local();
        for (std::size_t tile = range.begin(); tile != range.end() && !progress.cancelled(); ++tile) {
            painter.paint(grid.tile(tile), tile, progress, picture);
            tiles.done(1);
        }
    });
    if (progress.cancelled())
        return cancelledError(drawingParts);
    for (const PartPainter& painter : painters) {
        statistics.cells += painter.cells();
        statistics.fragments += painter.fragments();
    }
    statistics.fillSeconds += watch.lap();
    return {};
}

/// Fills a new vector, unless cancelled: gigabytes take seconds.
template <class Value> void fill(std::vector<Value>& values, std::size_t count, const Progress& progress)
{
    constexpr std::size_t atOnce = 1 << 22;
    values.reserve(count);
    while (values.size() < count && !progress.cancelled())
        values.resize(std::min(count, values.size() + atOnce));
}

Picture emptyPicture(int width, int height, bool depth, const Progress& progress)
{
    Picture picture{width, height, {}};
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    fill(picture.pixels, pixels, progress);
    fill(picture.depth, depth ? pixels : 0, progress);
    return picture;
}

/// A rectangle of samples grown to the tiles of the whole picture that it touches: tiles are drawn as a whole, so that
/// their samples do not depend on what is wanted of them.
SampleRectangle grownToTiles(const SampleRectangle& wanted, int width, int height, int side)
{
    const auto up = [side](int end) { return (end + side - 1) / side * side; };
    return {wanted.left / side * side, wanted.top / side * side, std::min(up(wanted.right), width),
            std::min(up(wanted.bottom), height)};
}

/// Makes the picture that of its difference to the other one.
void takeDifference(const Picture& reference, Picture& picture, RenderStatistics& statistics)
{
    double sum = 0;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        int largest = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int difference = std::abs(int(picture.pixels[i][channel]) - int(reference.pixels[i][channel]));
            largest = std::max(largest, difference);
            picture.pixels[i][channel] = static_cast<std::uint8_t>(std::min(255, differenceBrightness * difference));
        }
        picture.pixels[i][3] = 255;
        statistics.largestDifference = std::max(statistics.largestDifference, largest);
        sum += largest;
    }
    statistics.meanDifference = picture.pixels.empty() ? 0 : sum / static_cast<double>(picture.pixels.size());
}

class CpuBackend final : public RenderBackend {
public:
    std::string_view id() const noexcept override { return "cpu"; }

    RenderStatistics statistics() const override { return statistics_; }

    Result<Picture> render(const Scene& scene, const Camera& camera, const PictureOptions& options,
                           const Progress& progress) override
    {
        if (Status status = checkOptions(options); !status)
            return status.error();
        if (Status status = checkVolumes(scene); !status)
            return status.error();
        return guardedDrawing(scene.maker, [&]() -> Result<Picture> {
            if (!scene.reference)
                return drawWhole(scene, camera, options, progress);
            auto picture = drawWhole(scene, camera, options, progress.part(0, 0.5));
            const RenderStatistics statistics = statistics_;
            const auto reference = picture ? render(*scene.reference, camera, options, progress.part(0.5, 1)) : picture;
            if (!reference)
                return reference.error();
            statistics_ = statistics;
            takeDifference(*reference, *picture, statistics_);
            return picture;
        });
    }

private:
    Result<Picture> drawWhole(const Scene& scene, const Camera& camera, const PictureOptions& options,
                              const Progress& progress)
    {
        const auto drawn = withDrawn(scene, camera, options.width, options.height);
        return onThreads(options.threads, [&] { return draw(drawn ? *drawn : scene, camera, options, progress); });
    }

    Result<Picture> draw(const Scene& scene, const Camera& camera, const PictureOptions& options,
                         const Progress& progress)
    {
        const int samples = options.samplesPerAxis;
        const int width = options.width * samples, height = options.height * samples;
        const Eigen::AlignedBox3d bounds = drawnBounds(scene);
        const ViewTransform transform = makeViewTransform(camera, width, height, bounds);
        const VolumeView view = makeVolumeView(camera, width, height, bounds);
        const PixelRectangle wanted = drawnPart(options);
        const SampleRectangle samplesWanted{wanted.left * samples, wanted.top * samples,
                                            (wanted.left + wanted.width) * samples,
                                            (wanted.top + wanted.height) * samples};
        const SampleRectangle target = grownToTiles(samplesWanted, width, height, tileSideFor(samples));
        const std::vector<SampleRectangle> parts = partsOf(target, tileSideFor(samples));
        Picture picture = emptyPicture(target.width() / samples, target.height() / samples, options.depth, progress);
        if (progress.cancelled())
            return cancelledError(Message::marked("Drawing the picture"));
        RenderStatistics statistics;
        const SceneVolumes volumes{volumeOf(scene), focusOf(scene), samplesOf(scene)};
        statistics.orderReused = volumes.volume != nullptr; // until a part needs a new one
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto share = [&](double part) { return (static_cast<double>(i) + part) / double(parts.size()); };
            const CachedOrder::Request request{nullptr, camera, view, parts[i], options.orderTolerance};
            if (Status status = orderCells(volumes, request, progress.part(share(0), share(0.1)), statistics); !status)
                return status.error();
            const PartView part{parts[i], transform, partOf(view, parts[i]), target};
            const Progress drawing = progress.part(share(volumes.volume != nullptr ? 0.1 : 0), share(1));
            Status status = drawPart(scene, ordered(volumes), part, options, drawing, picture, statistics);
            if (!status)
                return status.error();
        }
        statistics_ = statistics;
        return cutOut(std::move(picture), {wanted.left - target.left / samples, wanted.top - target.top / samples,
                                           wanted.width, wanted.height});
    }

    static void count(const CachedOrder& order, RenderStatistics& statistics)
    {
        statistics.orderReused = statistics.orderReused && order.reused();
        statistics.cutCells = std::max(statistics.cutCells, order.cutCells());
        statistics.brokenCycles = std::max(statistics.brokenCycles, order.brokenCycles());
    }

    Status orderCells(const SceneVolumes& volumes, CachedOrder::Request request, const Progress& progress,
                      RenderStatistics& statistics)
    {
        const auto start = std::chrono::steady_clock::now();
        Status status;
        if (volumes.volume != nullptr) {
            request.mesh = volumes.volume->mesh;
            status = order_.prepare(request, progress);
            count(order_, statistics);
        }
        if (status && volumes.focus != nullptr) {
            request.mesh = volumes.focus->fine.mesh;
            status = fineOrder_.prepare(request, progress);
            count(fineOrder_, statistics);
        }
        statistics.orderSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return status;
    }

    OrderedVolumes ordered(const SceneVolumes& volumes) const
    {
        OrderedVolumes drawn;
        if (volumes.volume != nullptr)
            drawn.volume = OrderedVolume{order_.withPieces(*volumes.volume), order_.cells()};
        drawn.focus = volumes.focus;
        drawn.samples = volumes.samples;
        if (volumes.focus != nullptr)
            drawn.fine = OrderedVolume{fineOrder_.withPieces(volumes.focus->fine), fineOrder_.cells()};
        return drawn;
    }

    CachedOrder order_;
    CachedOrder fineOrder_;
    RenderStatistics statistics_;
};

} // namespace

std::unique_ptr<RenderBackend> makeCpuBackend()
{
    return std::make_unique<CpuBackend>();
}

} // namespace tetra
