// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/drawing_times.h"

#include "plugins/api/scene_parameters.h"

#include <tan/render.h>

#include <algorithm>
#include <array>
#include <chrono>

namespace tetra {
namespace {

constexpr std::size_t turns = 3; ///< pictures, of which the median counts
constexpr int histogramParts = 256;

ParameterValues valuesFor(const ModelDescription& data, const TetrahedralMesh& mesh, double isovalue)
{
    const FieldExtent field{data.range, data.bounds,
                            volumeHistogram(mesh, data.range.minimum, data.range.maximum, histogramParts)};
    Isovalue shown = std::get<std::vector<Isovalue>>(isovaluesParameter(field).defaultValue).front();
    shown.value = isovalue;
    return {{isovaluesId, std::vector{shown}}, {transferId, transferParameter(field).defaultValue}};
}

Result<double> timePicture(const Scene& scene, const Camera& camera, const Progress& progress)
{
    PictureOptions options;
    options.width = options.height = timedPictureSide;
    options.samplesPerAxis = 1;
    std::array<double, turns> seconds{};
    for (double& one : seconds) {
        const auto backend = makeCpuBackend(); // that knows nothing yet
        const auto start = std::chrono::steady_clock::now();
        if (const auto picture = backend->render(scene, camera, options, progress); !picture)
            return picture.error();
        one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
    std::ranges::nth_element(seconds, seconds.begin() + turns / 2);
    return seconds[turns / 2];
}

} // namespace

Result<DrawingTimes> measureDrawing(PluginHost& host, const ModelDescription& data,
                                    const std::shared_ptr<const TetrahedralMesh>& mesh, double isovalue,
                                    const Progress& progress)
{
    const Eigen::AlignedBox3d bounds = data.bounds;
    const Camera camera = fitted(Camera(), bounds);
    const ParameterValues values = valuesFor(data, *mesh, isovalue);
    DrawingTimes times;
    for (const auto& [id, time] : {std::pair("isosurface", &times.surface), std::pair("volume", &times.volume),
                                   std::pair("hybrid", &times.hybrid)}) {
        const auto renderer = host.renderer(id);
        if (!renderer)
            return renderer.error();
        const auto scene = renderer->plugin->open({.mesh = mesh, .bounds = bounds})
                               ->prepare({values, camera, timedPictureSide, timedPictureSide}, progress);
        if (!scene)
            return scene.error();
        const auto seconds = timePicture(**scene, camera, progress);
        if (!seconds)
            return seconds.error();
        *time = *seconds;
    }
    return times;
}

} // namespace tetra
