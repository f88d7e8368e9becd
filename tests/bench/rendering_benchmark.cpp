// SPDX-License-Identifier: GPL-3.0-or-later
// Direct volume rendering on the CPU while the camera turns: visibility order and picture of each frame, on one thread
// and on two, beside VTK's volume mappers with the same mesh, cameras and transfer function in the same run. Then
// isosurfaces beside VTK's, and the orders of meshes.

#include "tests/bench/bench_report.h"
#include "tests/bench/hybrid_cases.h"
#include "tests/bench/mesh_cases.h"
#include "tests/bench/rendering_scenes.h"
#include "tests/bench/vtk_yardstick.h"

#include "core/render/volume/volume_renderer.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QImage>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include <sched.h>
#include <unistd.h>

namespace tetra {

namespace {

/// `./dev bench` pins programs to one core; the cases on two threads need more.
void useAllCores()
{
    cpu_set_t cores;
    CPU_ZERO(&cores);
    for (long core = 0; core < ::sysconf(_SC_NPROCESSORS_ONLN); ++core)
        CPU_SET(static_cast<std::size_t>(core), &cores);
    ::sched_setaffinity(0, sizeof cores, &cores);
}

void save(const VolumePicture& picture, const QString& path)
{
    QImage image(picture.width, picture.height, QImage::Format_RGB888);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto& sample = picture.samples[std::size_t(y) * std::size_t(picture.width) + std::size_t(x)];
            const auto byte = [&](float channel) {
                return static_cast<int>(std::clamp(channel + 1 - sample[3], 0.0f, 1.0f) * 255 + 0.5f);
            };
            image.setPixel(x, y, qRgb(byte(sample[0]), byte(sample[1]), byte(sample[2])));
        }
    image.save(path);
}

struct Prepared {
    VolumeMesh mesh;
    VolumeTransfer transfer;
};

/// The first frame is drawn twice and counted once.
BenchCase measure(const RenderingScene& scene, const Prepared& prepared, int size, int threads, const QString& folder)
{
    VolumeOptions options{size, size, threads};
    std::vector<double> ordering, drawing, frame;
    VolumePicture picture;
    for (std::size_t i = 0; i <= scene.cameras.size(); ++i) {
        const Camera& camera = scene.cameras[i == 0 ? 0 : i - 1];
        VisibilityOrder order;
        const double orderSeconds =
            secondsOn(threads, [&] { order = orderForCamera(prepared.mesh, camera, options).value(); });
        const double drawSeconds = secondsOn(
            threads, [&] { picture = drawVolume(prepared.mesh, prepared.transfer, order, camera, options).value(); });
        if (i == 0)
            continue;
        ordering.push_back(orderSeconds);
        drawing.push_back(drawSeconds);
        frame.push_back(orderSeconds + drawSeconds);
    }
    if (!folder.isEmpty() && threads == 1)
        save(picture, QString("%1/%2 %3 tan.png").arg(folder, scene.name).arg(size));
    BenchCase one;
    one.name = QString("%1, %2, %3 thread%4").arg(scene.name).arg(size).arg(threads).arg(threads == 1 ? "" : "s");
    one.seconds = median(frame);
    const auto cells = double(scene.mesh->tetrahedra.size());
    one.more = {{"frames_per_second", 1 / one.seconds},
                {"million_tetrahedra_per_second", cells / one.seconds / 1e6},
                {"order_seconds", median(ordering)},
                {"draw_seconds", median(drawing)}};
    return one;
}

int framesOf(const QCommandLineParser& parser)
{
    return std::max(3, parser.value("frames").toInt());
}

std::vector<BenchCase> volumeCases(const QCommandLineParser& parser)
{
    const int frames = framesOf(parser);
    std::vector<BenchCase> cases;
    for (const RenderingScene& scene : renderingScenes(parser.value("cells").toUInt(), frames)) {
        const Prepared prepared{makeVolumeMesh(scene.mesh).value(),
                                makeVolumeTransfer(*scene.mesh, scene.function).value()};
        for (const QString& size : parser.value("sizes").split(','))
            for (const int threads : {1, 2}) {
                const QString folder = parser.value("pictures");
                std::map<QString, double> yardsticks;
                if (!parser.isSet("without-vtk"))
                    yardsticks = timeVtk(scene, size.toInt(), threads, folder);
                addCompared(measure(scene, prepared, size.toInt(), threads, folder), yardsticks, cases);
            }
    }
    return cases;
}

} // namespace

} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    useAllCores();
    const QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addOption({"json", "Print one JSON object."});
    parser.addOption({"frames", "Frames of each case, at least 3; the median is reported.", "N", "5"});
    parser.addOption({"cells", "Cells along an axis of the Marschner-Lobb signal and of C60.", "N", "64"});
    parser.addOption({"sizes", "Sides of the pictures, with commas between.", "N,N", "512,1024"});
    parser.addOption({"parts", "What to measure: volume, hybrid, gl, isosurface, order, with commas between.", "PARTS",
                      "volume,isosurface,order"});
    parser.addOption({"without-vtk", "Leave the comparison with VTK out."});
    parser.addOption({"pictures", "Keep the last picture of each case in this folder.", "FOLDER"});
    parser.process(application);
    const int frames = framesOf(parser);
    const QStringList parts = parser.value("parts").split(',');
    std::vector<BenchCase> cases;
    if (parts.contains("volume"))
        cases = volumeCases(parser);
    if (parts.contains("hybrid"))
        for (const RenderingScene& scene : renderingScenes(parser.value("cells").toUInt(), frames))
            for (const QString& size : parser.value("sizes").split(','))
                std::ranges::move(hybridCases(scene, size.toInt()), std::back_inserter(cases));
    if (parts.contains("gl"))
        for (const RenderingScene& scene : renderingScenes(parser.value("cells").toUInt(), frames))
            for (const QString& size : parser.value("sizes").split(','))
                std::ranges::move(glCases(scene, size.toInt()), std::back_inserter(cases));
    for (const BenchMesh& mesh : benchMeshes(parser.value("cells").toUInt())) {
        std::vector<BenchCase> ofMesh;
        if (parts.contains("isosurface"))
            ofMesh = isosurfaceCases(mesh, frames, !parser.isSet("without-vtk"));
        cases.insert(cases.end(), ofMesh.begin(), ofMesh.end());
        ofMesh.clear();
        if (parts.contains("order"))
            ofMesh = orderCases(mesh, frames);
        cases.insert(cases.end(), ofMesh.begin(), ofMesh.end());
    }
    printReport("rendering", cases, parser.isSet("json"));
    return 0;
}
