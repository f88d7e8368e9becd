// SPDX-License-Identifier: GPL-3.0-or-later
// What the CPU back end does with scenes that have a volume (B4): samples, depth, parts, orders, statistics.
#include "tests/core/render/scene_parts.h"
#include "tests/render/picture_check.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <limits>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

using Pixel = std::array<std::uint8_t, 4>;
const PictureOptions usual{.width = 28, .height = 20, .samplesPerAxis = 1};

Picture rendered(const SceneParts& scene, const Camera& camera, const PictureOptions& options = usual)
{
    return renderedByCpu(scene, camera, options);
}

/// A picture's pixels are the means of those of a picture `axis` times as large, of one sample each.
bool isMeanOfSamples(const SceneParts& scene, const Camera& camera, int columns, int rows, int axis)
{
    const Picture picture = rendered(scene, camera, {.width = columns, .height = rows, .samplesPerAxis = axis});
    const Picture fine = rendered(scene, camera, {.width = columns * axis, .height = rows * axis, .samplesPerAxis = 1});
    bool seen = false;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                double mean = 0;
                for (int sample = 0; sample < axis * axis; ++sample)
                    mean += pixelAt(fine, x * axis + sample % axis, y * axis + sample / axis)[channel];
                mean /= axis * axis;
                seen |= mean < 250;
                if (std::abs(mean - pixelAt(picture, x, y)[channel]) > 1.01) {
                    qWarning("pixel (%d, %d) is not the mean of its samples", x, y);
                    return false;
                }
            }
    return seen;
}

} // namespace

class VolumeBackendTest : public QObject {
    Q_OBJECT

private slots:
    void transparentBackgrounds()
    {
        const PictureOptions options{.width = 41, .height = 41, .transparentBackground = true, .samplesPerAxis = 2};
        const Picture picture = rendered(fogCube(0.5f), beforeCube(), options);
        QCOMPARE(pixelAt(picture, 0, 0), (Pixel{0, 0, 0, 0}));
        QVERIFY(difference(pixelAt(picture, 20, 20), {255, 128, 0, toByte(1 - std::pow(0.5, 4))}) <= 1);
    }

    /// Where half of the light is gone, in fog, at a sheet, and at a sheet that is cut away.
    void depthIsWhereHalfIsHidden()
    {
        for (const bool perspective : {true, false})
            for (const int samples : {1, 3}) {
                Camera camera = beforeCube();
                camera.perspective = perspective;
                SceneParts scene = fogCube(1 - std::exp(-0.5f));
                PictureOptions options{.width = 31, .height = 31, .samplesPerAxis = samples, .depth = true};
                const auto middle = [&] { return rendered(scene, camera, options).depth[15 * 31 + 15]; };
                QVERIFY(std::abs(middle() - (6 + 2 * std::log(2.0))) < 0.02);
                scene.surfaces.push_back({quad({0, 1, 0}, {4, 0, 0}, {0, 0, 4}), {0, 0, 0.8f}, 0.9f});
                QVERIFY(std::abs(middle() - 7) < 0.01);
                scene.clipPlanes.push_back({{0, 1, 0}, 2});
                QVERIFY(std::abs(middle() - (8 + 2 * std::log(2.0))) < 0.02);
                QCOMPARE(rendered(scene, camera, options).depth[0], std::numeric_limits<float>::infinity());
                scene.volume.reset();
                scene.clipPlanes.clear();
                QVERIFY(std::abs(middle() - 7) < 0.01);
                options.depth = false;
                QVERIFY(rendered(scene, camera, options).depth.empty());
            }
    }

    /// A pixel is the mean of its samples, those of the volume as well.
    void pixelsAreMeansOfSamples()
    {
        const TetrahedralMesh mesh = irregularWithHole();
        SceneParts scene = volumeScene(mesh, functionFor(mesh, "steps").function);
        addLayer(scene, valueAt(mesh, 0.4), {0.9f, 0.1f, 0.2f}, 0.5f);
        for (int axis = 2; axis <= 4; ++axis)
            QVERIFY(isMeanOfSamples(scene, cameraAround(scene.bounds, true), 60, 50, axis));
    }

    void sameWithAnyNumberOfThreads()
    {
        const TetrahedralMesh mesh = irregularWithHole();
        SceneParts scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
        scene.volume->shaded = true;
        addLayer(scene, valueAt(mesh, 0.4), {0.9f, 0.1f, 0.2f}, 0.5f);
        scene.lines.push_back(boxOutline(scene.bounds, {0, 0, 0}, 2));
        const Camera camera = cameraAround(scene.bounds, true);
        PictureOptions options{.width = 300, .height = 200, .threads = 1, .depth = true};
        const Picture one = rendered(scene, camera, options);
        for (const int threads : {0, 2, 7}) {
            options.threads = threads;
            const Picture many = rendered(scene, camera, options);
            QVERIFY(many.pixels == one.pixels && many.depth == one.depth);
        }
    }

    /// Pictures that are drawn in parts have no seams, neither of surfaces nor of a domain with gaps: the parts of the
    /// two pictures that are compared end at different samples.
    void partsLeaveNoSeams()
    {
        const TetrahedralMesh mesh = irregularWithHole();
        SceneParts scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
        scene.clipPlanes.push_back({{0, 1, 0.2}, 0.3 * scene.bounds.sizes().y() + scene.bounds.min().y()});
        addLayer(scene, valueAt(mesh, 0.4), {0.9f, 0.1f, 0.2f}, 0.5f);
        for (const bool perspective : {true, false}) {
            Camera camera = cameraAround(scene.bounds, perspective);
            camera.fieldOfView = 0.0115; // across the shorter side
            QVERIFY(isMeanOfSamples(scene, camera, 6000, 2, 3));
            QVERIFY(isMeanOfSamples(scene, camera, 2, 6000, 3));
        }
    }

    /// An order is used again where it is exact still, or near enough.
    void ordersAreKept()
    {
        const auto backend = makeCpuBackend();
        const auto reused = [&](const SceneParts& scene, const Camera& camera, PictureOptions options) {
            if (!backend->render(scene, camera, options).ok())
                qFatal("no picture");
            return backend->statistics().orderReused;
        };
        const TetrahedralMesh convex = refinedLattice();
        SceneParts scene = volumeScene(convex, functionFor(convex, "ramps").function);
        const Camera camera = cameraAround(scene.bounds, true);
        PictureOptions larger = usual, tolerant = usual;
        larger.width *= 2;
        tolerant.orderTolerance = 3;
        QVERIFY(!reused(scene, camera, usual));
        QVERIFY(reused(scene, camera, usual));
        QVERIFY(reused(scene, camera, larger));
        Camera wider = camera;
        wider.fieldOfView = 40;
        QVERIFY(reused(scene, wider, usual));
        QVERIFY(reused(scene, turned(camera, 2, 0), tolerant));
        QVERIFY(!reused(scene, turned(camera, 2, 0), usual));
        QVERIFY(!reused(scene, turned(camera, 20, 0), tolerant));
        // The same mesh again is another one, even in the place of the first.
        const TransferFunction function = functionFor(convex, "ramps").function;
        scene.volume.reset();
        scene.volume = volumeOf(volumeMeshOf(convex), function);
        QVERIFY(!reused(scene, turned(camera, 20, 0), tolerant));

        const TetrahedralMesh hole = irregularWithHole();
        const SceneParts holed = volumeScene(hole, functionFor(hole, "ramps").function);
        QVERIFY(!reused(holed, camera, usual));
        QVERIFY(reused(holed, camera, usual));
        QVERIFY(!reused(holed, camera, larger));
        QVERIFY(!reused(holed, wider, usual));
        QVERIFY(reused(holed, turned(wider, 2, 0), tolerant));
    }

    void statisticsTellWhatItTook()
    {
        const TetrahedralMesh mesh = refinedLattice();
        SceneParts scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
        const auto backend = makeCpuBackend();
        QVERIFY(backend->render(scene, cameraAround(scene.bounds, true), usual).ok());
        const RenderStatistics one = backend->statistics();
        QVERIFY(one.cells > 0 && one.cells <= mesh.tetrahedra.size());
        QVERIFY(one.fragments >= one.cells && one.setUpSeconds > 0 && one.fillSeconds > 0 && one.orderSeconds > 0);
        PictureOptions fine = usual;
        fine.samplesPerAxis = 4;
        QVERIFY(backend->render(scene, cameraAround(scene.bounds, true), fine).ok());
        QVERIFY(backend->statistics().fragments > 4 * one.fragments);
        scene.volume.reset();
        QVERIFY(backend->render(scene, {}, usual).ok());
        QCOMPARE(backend->statistics().cells, std::size_t(0));
    }

    void missingVolumesAreNothing()
    {
        SceneParts scene = fogCube(0.5f);
        const auto transfer = scene.volume->transfer;
        scene.volume->transfer = nullptr;
        for (const Pixel& pixel : rendered(scene, beforeCube()).pixels)
            QCOMPARE(pixel, (Pixel{255, 255, 255, 255}));
        const TetrahedralMesh cell = oneCell();
        scene.volume = Volume{volumeMeshOf(cell), transfer};
        const auto picture = makeCpuBackend()->render(scene, beforeCube(), usual);
        QVERIFY(!picture.ok() && picture.error().kind == ErrorKind::WrongUsage);
        scene.volume = volumeOf(volumeMeshOf({}), {});
        for (const Pixel& pixel : rendered(scene, beforeCube()).pixels)
            QCOMPARE(pixel, (Pixel{255, 255, 255, 255}));
    }

    void reportsAndCancels()
    {
        const TetrahedralMesh mesh = irregularWithHole();
        const SceneParts scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
        const Camera camera = cameraAround(scene.bounds, true);
        const PictureOptions options{.width = 700, .height = 700};
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(makeCpuBackend()->render(scene, camera, options, progress).ok());
        QVERIFY(last == 1.0 && !falls);
        for (const double when : {0.0, 0.05, 0.5}) {
            std::stop_source stop;
            const Progress stopping(stop.get_token(), [&](double fraction, const Message&) {
                last = fraction;
                if (fraction >= when)
                    stop.request_stop();
            });
            QCOMPARE(makeCpuBackend()->render(scene, camera, options, stopping).error().kind, ErrorKind::Cancelled);
            QVERIFY(last < when + 0.3);
        }
    }
};

QTEST_GUILESS_MAIN(VolumeBackendTest)
#include "volume_backend_test.moc"
