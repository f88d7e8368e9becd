// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/drawing_times.h"

#include "ui/workbench/view_picture.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace tetra {
namespace {

constexpr std::size_t turns = 3; ///< pictures, of which the median counts

Result<double> timePicture(const std::shared_ptr<const Scene>& scene, const Camera& camera, const Progress& progress)
{
    const PictureOrder order{.scene = scene,
                             .camera = camera,
                             .background = {1, 1, 1},
                             .width = timedPictureSide,
                             .height = timedPictureSide,
                             .samplesPerAxis = 1};
    std::array<double, turns> seconds{};
    for (double& one : seconds) {
        ScenePipeline unused; // its back end knows nothing yet
        const auto start = std::chrono::steady_clock::now();
        if (const auto picture = unused.draw(order, false, progress); !picture)
            return picture.error();
        one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    std::ranges::nth_element(seconds, seconds.begin() + turns / 2);
    return seconds[turns / 2];
}

} // namespace

Result<DrawingTimes> measureDrawing(PluginHost& host, const std::shared_ptr<const Model>& model, const MeshQuery& query,
                                    double isovalue, const Progress& progress)
{
    const FieldExtent field = extentOf(*model);
    ViewValue view = startingView(renderingModes(host), *model, field);
    view.appearance.settings.clear();
    view.isovalues = {Isovalue{isovalue}};
    ScenePipeline pipeline;
    DrawingTimes times;
    for (const auto& [id, time] : {std::pair("isosurface", &times.surface), std::pair("volume", &times.volume),
                                   std::pair("hybrid", &times.hybrid)}) {
        const auto renderer = host.renderer(id);
        if (!renderer)
            return renderer.error();
        SceneRequest request = sceneOf(model, renderer->plugin, renderer->plugin->parameters(field), view);
        request.query = query;
        request.width = request.height = timedPictureSide;
        const auto built = pipeline.make(request, progress);
        if (!built)
            return built.error();
        const auto seconds = timePicture(built->scene, view.camera, progress);
        if (!seconds)
            return seconds.error();
        *time = *seconds;
    }
    return times;
}

} // namespace tetra
