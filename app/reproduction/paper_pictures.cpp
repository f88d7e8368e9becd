// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/paper_pictures.h"

#include "core/picture/rendering_modes.h"
#include "core/picture/shown_error.h"
#include "core/picture/view_picture.h"

#include <tan/view.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>

namespace tetra {
namespace {

constexpr std::size_t turns = 3; ///< pictures, of which the median counts
constexpr std::array<std::uint8_t, 4> ground = {255, 255, 255, 255};

} // namespace

Result<DrawnPicture> drawPicture(PluginHost& host, const std::shared_ptr<const Model>& model,
                                 const PaperPicture& picture, const Progress& progress)
{
    const auto field = extentOf(model);
    if (!field)
        return field.error();
    const auto modes = renderingModes(host);
    const FieldExtent seen = seenWith(*field, picture.query, *model);
    ViewValue view = startingView(modes, *model, *field);
    view.appearance.transfer = startingAppearance(modes, seen, model->description().domain).transfer;
    view.appearance.settings.clear();
    if (picture.drawsSurfacesWithCells)
        view.appearance.settings["order"] = std::string("with-cell");
    view.isovalues = picture.isovalues;
    const auto renderer = host.renderer(picture.mode);
    if (!renderer)
        return renderer.error();
    SceneRequest request = sceneOf(model, renderer->plugin, renderer->plugin->parameters(seen), view);
    request.query = picture.query;
    request.width = request.height = paperPictureSide;
    ScenePipeline pipeline;
    const auto built = pipeline.make(request, progress);
    if (!built)
        return built.error();
    const PictureOrder order{.scene = built->scene,
                             .camera = view.camera,
                             .background = {1, 1, 1},
                             .width = paperPictureSide,
                             .height = paperPictureSide,
                             .samplesPerAxis = 1};
    DrawnPicture drawn;
    std::array<double, turns> seconds{};
    for (double& one : seconds) {
        ScenePipeline unused; // its back end knows nothing yet
        const auto start = std::chrono::steady_clock::now();
        auto made = unused.draw(order, false, progress);
        if (!made)
            return made.error();
        one = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        drawn.picture = *std::move(made);
    }
    std::ranges::nth_element(seconds, seconds.begin() + turns / 2);
    drawn.seconds = seconds[turns / 2];
    return drawn;
}

Degradation degradationOf(const Picture& picture, const Picture& reference)
{
    double squares = 0;
    std::size_t shown = 0;
    std::size_t visible = 0;
    for (std::size_t pixel = 0; pixel < reference.pixels.size(); ++pixel) {
        const auto& one = picture.pixels[pixel];
        const auto& other = reference.pixels[pixel];
        if (one == ground && other == ground)
            continue;
        ++shown;
        int largest = 0;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int difference = std::abs(int(one[channel]) - int(other[channel]));
            squares += difference * difference;
            largest = std::max(largest, difference);
        }
        visible += 10 * largest > 255 ? 1 : 0;
    }
    if (shown == 0)
        return {};
    const auto pixels = static_cast<double>(shown);
    return {.rootMeanSquare = 100 * std::sqrt(squares / (3 * pixels)) / 255,
            .visiblePercent = 100 * static_cast<double>(visible) / pixels};
}

} // namespace tetra
