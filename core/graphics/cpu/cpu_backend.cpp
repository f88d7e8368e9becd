// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/cpu/draw_list.h"
#include "core/graphics/cpu/tile_bins.h"
#include "core/graphics/cpu/tile_painter.h"
#include "core/graphics/picture_options.h"
#include "core/graphics/render_backend.h"
#include "core/graphics/resolve.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <mutex>
#include <new>

namespace tetra {
namespace {

constexpr std::string_view activity = "Drawing the picture";

/// Samples an axis of a tile: its buffers, 36 bytes a sample, fit the second-level cache.
constexpr int samplesPerTile = 64;

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

PremultipliedColour backgroundOf(const PictureOptions& options)
{
    if (options.transparentBackground)
        return {0, 0, 0, 0};
    return {options.background.red, options.background.green, options.background.blue, 1};
}

Result<Picture> draw(const Scene& scene, const Camera& camera, const PictureOptions& options, const Progress& progress)
{
    const int samples = options.samplesPerAxis;
    const TileGrid grid{options.width * samples, options.height * samples, samplesPerTile / samples * samples};
    const ViewTransform transform = makeViewTransform(camera, grid.width, grid.height, scene.bounds);
    progress.report(0, activity);
    const Result<DrawList> list = makeDrawList(scene, transform, samples);
    if (!list)
        return list.error();
    if (progress.cancelled())
        return cancelledError(activity);
    const TileBins bins(*list, grid);

    Picture picture{options.width, options.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height));
    const Progress tilesPart = progress.part(0.2, 1);
    TileProgress done(tilesPart, grid.count());
    tbb::enumerable_thread_specific<TilePainter> painters([&] { return TilePainter(*list, transform); });
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, grid.count(), 1), [&](const auto& range) {
        TilePainter& painter = painters.local();
        for (std::size_t t = range.begin(); t != range.end() && !progress.cancelled(); ++t) {
            const SampleRectangle tile = grid.tile(t);
            const auto colours = painter.paint(tile, bins.trianglesOf(t), backgroundOf(options));
            resolve(colours, tile.width(), samples, tile.left / samples, tile.top / samples, picture);
            done.tileDone();
        }
    });
    if (progress.cancelled())
        return cancelledError(activity);
    return picture;
}

class CpuBackend final : public RenderBackend {
public:
    std::string_view id() const noexcept override { return "cpu"; }

    RenderStatistics statistics() const override { return {}; }

    Result<Picture> render(const Scene& scene, const Camera& camera, const PictureOptions& options,
                           const Progress& progress) override
    {
        if (Status status = checkOptions(options); !status)
            return status.error();
        try {
            const int allThreads = tbb::info::default_concurrency();
            tbb::task_arena arena(options.threads > 0 ? std::min(options.threads, allThreads) : allThreads);
            return arena.execute([&] { return draw(scene, camera, options, progress); });
        } catch (const std::bad_alloc&) {
            return Error{ErrorKind::OutOfResource, "Not enough memory for a picture of this size and scene. Make the "
                                                   "picture smaller or lower the accuracy of the mesh."};
        }
    }
};

} // namespace

std::unique_ptr<RenderBackend> makeCpuBackend()
{
    return std::make_unique<CpuBackend>();
}

} // namespace tetra
