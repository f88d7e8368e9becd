// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/cpu/drawing_threads.h"
#include "core/graphics/cpu/kept_order.h"
#include "core/graphics/cpu/part_drawing.h"
#include "core/graphics/cpu/picture_parts.h"
#include "core/graphics/picture_options.h"
#include "core/graphics/render_backend.h"
#include "core/graphics/scene_check.h"
#include "core/graphics/volume/volume_mesh.h"
#include "core/graphics/volume/projected_volume.h"

#include <algorithm>
#include <chrono>

namespace tetra {
namespace {

/// Fills a new vector, unless cancelled: gigabytes take seconds.
template <class Value> void fill(std::vector<Value>& values, std::size_t count, const Progress& progress)
{
    constexpr std::size_t atOnce = 1 << 22;
    values.reserve(count);
    while (values.size() < count && !progress.cancelled())
        values.resize(std::min(count, values.size() + atOnce));
}

Picture emptyPicture(const PictureOptions& options, const Progress& progress)
{
    Picture picture{options.width, options.height, {}};
    const auto pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    fill(picture.pixels, pixels, progress);
    fill(picture.depth, options.depth ? pixels : 0, progress);
    return picture;
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
        if (hasVolume(scene) && !belongTogether(*scene.volume->mesh, *scene.volume->transfer, {}))
            return Error{ErrorKind::WrongUsage, "The scene's volume and its transfer function do not belong together."};
        if (hasFocus(scene) && !belongTogether(*scene.focus->fine.mesh, *scene.focus->fine.transfer, {}))
            return Error{ErrorKind::WrongUsage, "The focus' volume and its transfer function do not belong together."};
        return onThreads(options.threads, [&] { return draw(scene, camera, options, progress); });
    }

private:
    Result<Picture> draw(const Scene& scene, const Camera& camera, const PictureOptions& options,
                         const Progress& progress)
    {
        const int samples = options.samplesPerAxis;
        const int width = options.width * samples, height = options.height * samples;
        const Eigen::AlignedBox3d bounds = drawnBounds(scene);
        const ViewTransform transform = makeViewTransform(camera, width, height, bounds);
        const VolumeView view = makeVolumeView(camera, width, height, bounds);
        const std::vector<SampleRectangle> parts = picturePartsOf(width, height, tileSideFor(samples));
        Picture picture = emptyPicture(options, progress);
        if (progress.cancelled())
            return cancelledError("Drawing the picture");
        RenderStatistics statistics;
        statistics.orderReused = hasVolume(scene); // until a part needs a new one
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto share = [&](double part) { return (static_cast<double>(i) + part) / double(parts.size()); };
            const KeptOrder::Request request{nullptr, camera, view, parts[i], options.orderTolerance};
            if (Status status = orderCells(scene, request, progress.part(share(0), share(0.1)), statistics); !status)
                return status.error();
            const PartView part{parts[i], partOf(transform, parts[i]), partOf(view, parts[i])};
            const Progress drawing = progress.part(share(hasVolume(scene) ? 0.1 : 0), share(1));
            Status status =
                drawPart(scene, part, {order_.cells(), fineOrder_.cells()}, options, drawing, picture, statistics);
            if (!status)
                return status.error();
        }
        statistics_ = statistics;
        return picture;
    }

    Status orderCells(const Scene& scene, KeptOrder::Request request, const Progress& progress,
                      RenderStatistics& statistics)
    {
        const auto start = std::chrono::steady_clock::now();
        Status status;
        if (hasVolume(scene)) {
            request.mesh = scene.volume->mesh;
            status = order_.prepare(request, progress);
            statistics.orderReused = statistics.orderReused && order_.reused();
            statistics.brokenCycles = std::max(statistics.brokenCycles, order_.brokenCycles());
        }
        if (status && hasFocus(scene)) {
            request.mesh = scene.focus->fine.mesh;
            status = fineOrder_.prepare(request, progress);
            statistics.orderReused = statistics.orderReused && fineOrder_.reused();
            statistics.brokenCycles = std::max(statistics.brokenCycles, fineOrder_.brokenCycles());
        }
        statistics.orderSeconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        return status;
    }

    KeptOrder order_;
    KeptOrder fineOrder_;
    RenderStatistics statistics_;
};

} // namespace

std::unique_ptr<RenderBackend> makeCpuBackend()
{
    return std::make_unique<CpuBackend>();
}

} // namespace tetra
