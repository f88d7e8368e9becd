// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/hybrid_cases.h"

#include "core/render/volume/volume_mesh.h"
#include "tests/core/render/scene_parts.h"

#include <tan/render.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace tetra {
namespace {

struct NamedScene {
    QString name;
    Scene scene;
    bool depth = false;
};

std::vector<NamedScene> scenesOf(const RenderingScene& source)
{
    testing::SceneParts alone;
    alone.volume =
        Volume{std::make_shared<const VolumeMesh>(makeVolumeMesh(source.mesh).value()),
               std::make_shared<const VolumeTransfer>(makeVolumeTransfer(*source.mesh, source.function).value())};
    alone.bounds = alone.volume->mesh->bounds;

    testing::SceneParts surfaces = alone;
    const auto [low, high] = std::ranges::minmax(source.mesh->values);
    const auto gradients = vertexGradients(*source.mesh);
    for (const float share : {0.4f, 0.6f}) {
        auto mesh = extractIsosurface(*source.mesh, gradients, std::lerp(low, high, share)).value();
        surfaces.surfaces.push_back({std::make_shared<const TriangleMesh>(std::move(mesh)), {0.8f, share, 0}, 0.4f});
    }
    testing::SceneParts onlySurfaces = surfaces;
    onlySurfaces.volume.reset();
    testing::SceneParts withCell = surfaces;
    withCell.wholeCells = true;
    testing::SceneParts clipped = alone;
    clipped.clipPlanes.push_back({{1, 0, 0}, alone.bounds.center().x()});
    testing::SceneParts lit = alone;
    lit.volume->shaded = true;
    return {{"the volume alone", alone},        {"two isosurfaces alone", onlySurfaces},
            {"with two isosurfaces", surfaces}, {"with two isosurfaces before cells", withCell},
            {"cut in halves", clipped},         {"lit", lit},
            {"with depth", alone, true}};
}

/// Seconds of each picture of the scene by each camera but the first, and that last picture.
struct Turned {
    std::vector<double> seconds;
    std::vector<double> orderSeconds;
    Picture last;
};

Turned turn(RenderBackend& backend, const Scene& scene, const std::vector<Camera>& cameras, PictureOptions options)
{
    Turned turned;
    for (std::size_t frame = 0; frame < cameras.size() + 1; ++frame) {
        const Camera& camera = cameras[frame == 0 ? 0 : frame - 1];
        const double time = secondsOf([&] {
            auto picture = backend.render(scene, camera, options);
            if (!picture)
                qFatal("%s", picture.error().text().c_str());
            turned.last = std::move(*picture);
        });
        if (frame == 0)
            continue;
        turned.seconds.push_back(time);
        turned.orderSeconds.push_back(backend.statistics().orderSeconds);
    }
    return turned;
}

/// Of 255, in any channel of any pixel.
int largestDifference(const Picture& one, const Picture& other)
{
    int largest = 0;
    for (std::size_t pixel = 0; pixel < one.pixels.size(); ++pixel)
        for (std::size_t channel = 0; channel < 4; ++channel)
            largest = std::max(largest, std::abs(int(one.pixels[pixel][channel]) - int(other.pixels[pixel][channel])));
    return largest;
}

} // namespace

std::vector<BenchCase> glCases(const RenderingScene& scene, int size)
{
    const auto gl = makeGlBackend();
    if (!gl) {
        std::fprintf(stderr, "skipped: %s\n", gl.error().text().c_str());
        return {};
    }
    std::vector<BenchCase> cases;
    for (const NamedScene& named : scenesOf(scene)) {
        const PictureOptions options{.width = size, .height = size, .depth = named.depth};
        const Turned card = turn(**gl, named.scene, scene.cameras, options);
        const auto sentBytes = double((*gl)->statistics().sentBytes);
        const Turned processor = turn(*makeCpuBackend(), named.scene, scene.cameras, options);
        BenchCase one;
        one.name = QString("%1, %2, %3, OpenGL").arg(scene.name).arg(size).arg(named.name);
        one.seconds = median(card.seconds);
        one.yardstick = "CPU back end, all threads";
        one.yardstickSeconds = median(processor.seconds);
        one.more = {{"order_seconds", median(card.orderSeconds)},
                    {"sent_bytes", sentBytes},
                    {"largest_difference", double(largestDifference(card.last, processor.last))}};
        cases.push_back(one);
    }
    return cases;
}

std::vector<BenchCase> hybridCases(const RenderingScene& scene, int size)
{
    std::vector<BenchCase> cases;
    for (const NamedScene& named : scenesOf(scene)) {
        const auto backend = makeCpuBackend();
        const PictureOptions options{
            .width = size, .height = size, .samplesPerAxis = 1, .threads = 1, .depth = named.depth};
        std::vector<double> seconds;
        for (int frame = 0; frame < 6; ++frame) {
            const double time = secondsOn(1, [&] {
                if (!backend->render(named.scene, scene.cameras.front(), options).ok())
                    qFatal("No picture.");
            });
            if (frame > 0)
                seconds.push_back(time);
        }
        BenchCase one;
        one.name = QString("%1, %2, %3").arg(scene.name).arg(size).arg(named.name);
        one.seconds = median(seconds);
        if (!cases.empty()) {
            one.yardstick = "the volume alone";
            one.yardstickSeconds = cases.front().seconds;
        }
        one.more["fragments"] = double(backend->statistics().fragments);
        cases.push_back(one);
    }
    return cases;
}

} // namespace tetra
