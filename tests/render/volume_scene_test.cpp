// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with a volume on the CPU back end (R20 to R22, B4): with surfaces, lines and clip planes, against a slow
// integrator and closed forms.
#include "core/graphics/render_backend.h"
#include "core/graphics/volume/volume_renderer.h"
#include "tests/core/graphics/lattice_mesh.h"
#include "tests/render/picture_check.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

Q_DECLARE_METATYPE(tetra::HybridOrder)

namespace {

using Pixel = std::array<std::uint8_t, 4>;
constexpr int width = 28;
constexpr int height = 20;
const PictureOptions usual{.width = width, .height = height, .samplesPerAxis = 1};

const std::vector<NamedMesh>& meshes()
{
    static const std::vector<NamedMesh> all = volumeMeshes();
    return all;
}

const TetrahedralMesh& meshNamed(const QString& name)
{
    return std::ranges::find(meshes(), name.toStdString(), &NamedMesh::name)->mesh;
}

NamedFunction functionFor(const TetrahedralMesh& mesh, const std::string& name)
{
    const auto [low, high] = std::ranges::minmax(mesh.values);
    Eigen::AlignedBox3f bounds;
    for (const auto& position : mesh.positions)
        bounds.extend(position);
    const auto functions = volumeFunctions(low, high, bounds.diagonal().norm() / 10);
    return *std::ranges::find(functions, name, &NamedFunction::name);
}

Picture rendered(const Scene& scene, const Camera& camera, const PictureOptions& options = usual)
{
    auto picture = makeCpuBackend()->render(scene, camera, options);
    if (!picture)
        qFatal("%s", picture.error().text.c_str());
    return std::move(picture).value();
}

std::uint8_t toByte(double channel)
{
    return static_cast<std::uint8_t>(std::lround(std::clamp(channel, 0.0, 1.0) * 255));
}

/// What the integrator sees, over white.
Pixel overWhite(const std::array<double, 4>& colour)
{
    const double light = 1 - colour[3];
    return {toByte(colour[0] + light), toByte(colour[1] + light), toByte(colour[2] + light), 255};
}

/// Every sample but the doubtful ones, which may be one in fifty, within `tolerance` steps of 255, and the mean
/// difference no more than 1e-4 of the whole range for each step.
bool agrees(const Picture& picture, const RayIntegrator& integrator, int tolerance)
{
    std::size_t doubtful = 0, sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Pixel expected = overWhite(integrator.sample(x, y));
            const Pixel& found = pixelAt(picture, x, y);
            if (difference(expected, found) > tolerance && !integrator.isDoubtful(x, y)) {
                qWarning("pixel (%d, %d) is %d %d %d, not %d %d %d; the picture: %s", x, y, found[0], found[1],
                         found[2], expected[0], expected[1], expected[2],
                         qPrintable(savePicture(picture, QTest::currentTestFunction())));
                return false;
            }
            if (difference(expected, found) > tolerance)
                ++doubtful;
            else
                for (std::size_t channel = 0; channel < 3; ++channel)
                    sum += static_cast<std::size_t>(std::abs(expected[channel] - found[channel]));
        }
    const double mean = static_cast<double>(sum) / 255 / static_cast<double>(3 * picture.pixels.size());
    if (mean <= 1e-4 * tolerance && doubtful * 50 <= picture.pixels.size())
        return true;
    qWarning("mean difference %g, %zu doubtful samples of %zu", mean, doubtful, picture.pixels.size());
    return false;
}

/// A picture's pixels are the means of those of a picture `axis` times as large, of one sample each.
bool isMeanOfSamples(const Scene& scene, const Camera& camera, int columns, int rows, int axis)
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

double valueAt(const TetrahedralMesh& mesh, double share)
{
    const auto [low, high] = std::ranges::minmax(mesh.values);
    return std::lerp(double(low), double(high), share);
}

/// A cube [0, 4]^3 of half a unit of optical depth a unit of length, in one colour.
Scene fogCube(float opacityOfUnit)
{
    const TetrahedralMesh mesh = latticeMesh(4, 4, Split::Six, [](const Vector3d&) { return 0.5; });
    return volumeScene(mesh, {{{0, {1, 0.5f, 0}, opacityOfUnit}}, 1});
}

/// From far before its middle, so that all rays through it are as long.
Camera beforeCube()
{
    Camera camera;
    camera.perspective = false;
    camera.target = {2, 2, 2};
    camera.distance = 8;
    camera.azimuth = 0;
    camera.elevation = 0;
    return camera;
}

} // namespace

class VolumeSceneTest : public QObject {
    Q_OBJECT

private slots:
    /// The same samples as the library's own call, of every mesh.
    void aloneIsAsTheLibraryDrawsIt()
    {
        for (const NamedMesh& named : meshes())
            for (const bool perspective : {true, false}) {
                const Scene scene = volumeScene(named.mesh, functionFor(named.mesh, "ramps").function);
                const Camera camera = cameraAround(scene.bounds, perspective);
                const VolumeMesh& mesh = *scene.volume->mesh;
                const VolumeOptions options{90, 70};
                const auto order = orderForCamera(mesh, camera, options).value();
                const auto samples =
                    drawVolume(mesh, *scene.volume->transfer, order.cells, camera, options).value().samples;
                const Picture picture = rendered(scene, camera, {.width = 90, .height = 70, .samplesPerAxis = 1});
                for (std::size_t i = 0; i < samples.size(); ++i) {
                    const auto& [red, green, blue, alpha] = samples[i];
                    QVERIFY(difference(picture.pixels[i], overWhite({red, green, blue, alpha})) <= 1);
                }
            }
    }

    void hybridAgreesWithTheIntegrator_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<HybridOrder>("order");
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramps", "steps", "opaque"})
                for (const HybridOrder order : {HybridOrder::Exact, HybridOrder::WithCell}) {
                    const bool perspective = QString(function) != "steps";
                    QTest::addRow("%s, %s, %s", mesh.name.c_str(), function,
                                  order == HybridOrder::Exact ? "exact" : "with cell")
                        << QString::fromStdString(mesh.name) << QString(function) << perspective << order;
                }
    }
    /// Translucent isosurfaces and an opaque one in the volume.
    void hybridAgreesWithTheIntegrator()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        QFETCH(HybridOrder, order);
        const TetrahedralMesh& tetrahedra = meshNamed(mesh);
        const NamedFunction chosen = functionFor(tetrahedra, function.toStdString());
        Scene scene = volumeScene(tetrahedra, chosen.function);
        scene.hybridOrder = order;
        RayScene rays;
        rays.order = order;
        rays.layers = {addLayer(scene, valueAt(tetrahedra, 0.35), {0.9f, 0.1f, 0.2f}, 0.4f),
                       addLayer(scene, valueAt(tetrahedra, 0.52), {0.1f, 0.3f, 0.9f}, 0.6f),
                       addLayer(scene, valueAt(tetrahedra, 0.77), {0.2f, 0.8f, 0.3f}, 1)};
        const Camera camera = cameraAround(scene.bounds, perspective);
        const RayIntegrator integrator(tetrahedra, chosen.function, camera, width, height, rays);
        QVERIFY(agrees(rendered(scene, camera), integrator, chosen.opaque ? 2 : 1));
    }

    /// A volume that is cut open, with an isosurface that is cut, too.
    void clipPlanesCutBoth()
    {
        for (const char* name : {"refined lattice", "irregular with a hole"})
            for (const bool perspective : {true, false}) {
                const TetrahedralMesh& mesh = meshNamed(name);
                const NamedFunction function = functionFor(mesh, "ramps");
                Scene scene = volumeScene(mesh, function.function);
                const Camera camera = cameraAround(scene.bounds, perspective);
                const Vector3d centre = scene.bounds.center();
                for (const Vector3d& normal : {Vector3d(1, 0.3, 0.2), Vector3d(-0.2, 1, -0.4), Vector3d(0, 0, -2)})
                    scene.clipPlanes.push_back(
                        {normal, normal.dot(centre + Vector3d(-0.1, 0.05, 0.2).cwiseProduct(scene.bounds.sizes()))});
                RayScene rays;
                rays.clipPlanes = scene.clipPlanes;
                rays.layers = {addLayer(scene, valueAt(mesh, 0.45), {0.9f, 0.1f, 0.2f}, 0.5f)};
                const RayIntegrator integrator(mesh, function.function, camera, width, height, rays);
                QVERIFY(agrees(rendered(scene, camera), integrator, 1));
            }
    }

    /// The eye in the volume, with surfaces and a clip plane around it.
    void eyeInside()
    {
        const TetrahedralMesh& mesh = meshNamed("refined lattice");
        const NamedFunction function = functionFor(mesh, "ramps");
        Scene scene = volumeScene(mesh, function.function);
        RayScene rays;
        rays.layers = {addLayer(scene, valueAt(mesh, 0.4), {0.9f, 0.1f, 0.2f}, 0.4f),
                       addLayer(scene, valueAt(mesh, 0.6), {0.1f, 0.3f, 0.9f}, 0.3f)};
        const Vector3d inside = scene.bounds.min() + Vector3d(0.41, 0.47, 0.38).cwiseProduct(scene.bounds.sizes());
        const Vector3d vertex = mesh.positions[mesh.positions.size() / 2].cast<double>();
        scene.clipPlanes.push_back({{0, 0, 1}, inside.z() - 0.2 * scene.bounds.sizes().z()});
        rays.clipPlanes = scene.clipPlanes;
        for (const Vector3d& eye : {inside, vertex}) {
            Camera camera = cameraAround(scene.bounds, true);
            camera.fieldOfView = 60;
            camera = withEyeAt(camera, eye);
            const RayIntegrator integrator(mesh, function.function, camera, width, height, rays);
            QVERIFY(agrees(rendered(scene, camera), integrator, 1));
        }
    }

    /// Lit by the gradient of each cell.
    void shadedVolumesAreLit()
    {
        for (const char* name : {"one cell", "refined lattice", "refined bent grid"})
            for (const char* kind : {"ramp", "steps"})
                for (const bool perspective : {true, false}) {
                    const TetrahedralMesh& mesh = meshNamed(name);
                    TransferFunction function = functionFor(mesh, kind).function;
                    for (TransferPoint& point : function.points)
                        for (float& channel : point.colour)
                            channel *= 0.8f; // so that no highlight is cut off, which the back end does slab by slab
                    Scene scene = volumeScene(mesh, function);
                    scene.volume->shaded = true;
                    RayScene rays;
                    rays.shaded = true;
                    if (perspective)
                        rays.layers = {addLayer(scene, valueAt(mesh, 0.45), {0.9f, 0.1f, 0.2f}, 0.5f)};
                    const Camera camera = cameraAround(scene.bounds, perspective);
                    const RayIntegrator integrator(mesh, function, camera, width, height, rays);
                    QVERIFY(agrees(rendered(scene, camera), integrator, 1));
                }
    }

    /// A translucent sheet in the middle of a fog, an opaque one and a line behind it: closed forms.
    void sheetsAndLinesInFog()
    {
        Scene scene = fogCube(0.5f);
        scene.surfaces.push_back({quad({0, 1, 0}, {4, 0, 0}, {0, 0, 4}), {0, 0, 0.8f}, 0.25f});
        const Colour sheet = shaded({0, 0, 0.8f}, 1, 1);
        scene.lines.push_back({{{0, 3, 2}, {4, 3, 2}}, {{0, 1}}, {0, 1, 0}, 2});
        const PictureOptions options{.width = 41, .height = 41, .background = {0.2f, 0.3f, 0.4f}, .samplesPerAxis = 1};
        const Picture picture = rendered(scene, beforeCube(), options);
        // One unit of fog lets half of the light through.
        const auto over = [](const Colour& front, double opacity, const Colour& back) -> Colour {
            const auto mix = [&](float a, float b) { return static_cast<float>(a * opacity + b * (1 - opacity)); };
            return {mix(front.red, back.red), mix(front.green, back.green), mix(front.blue, back.blue)};
        };
        const Colour fog{1, 0.5f, 0};
        const auto expected = [&](const Colour& behind, double length) {
            return over(fog, 0.5, over(sheet, 0.25, over(fog, 1 - std::pow(0.5, length), behind)));
        };
        const auto bytes = [](const Colour& colour) -> Pixel {
            return {toByte(colour.red), toByte(colour.green), toByte(colour.blue), 255};
        };
        QVERIFY(difference(pixelAt(picture, 20, 12), bytes(expected(options.background, 3))) <= 1);
        QVERIFY(difference(pixelAt(picture, 20, 20), bytes(expected({0, 1, 0}, 2))) <= 1);
        QVERIFY(difference(pixelAt(picture, 0, 0), bytes(options.background)) <= 1);

        // With an opaque wall instead nothing behind it is seen.
        scene.surfaces.push_back({quad({0, 2, 0}, {4, 0, 0}, {0, 0, 4}), {0.5f, 0.5f, 0.5f}, 1});
        const Colour wall = shaded({0.5f, 0.5f, 0.5f}, 1, 1);
        QVERIFY(difference(pixelAt(rendered(scene, beforeCube(), options), 20, 20), bytes(expected(wall, 1))) <= 1);
    }

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
                Scene scene = fogCube(1 - std::exp(-0.5f));
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
        const TetrahedralMesh& mesh = meshNamed("irregular with a hole");
        Scene scene = volumeScene(mesh, functionFor(mesh, "steps").function);
        addLayer(scene, valueAt(mesh, 0.4), {0.9f, 0.1f, 0.2f}, 0.5f);
        for (int axis = 2; axis <= 4; ++axis)
            QVERIFY(isMeanOfSamples(scene, cameraAround(scene.bounds, true), 60, 50, axis));
    }

    void sameWithAnyNumberOfThreads()
    {
        const TetrahedralMesh& mesh = meshNamed("irregular with a hole");
        Scene scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
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
        const TetrahedralMesh& mesh = meshNamed("irregular with a hole");
        Scene scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
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
        const auto reused = [&](const Scene& scene, const Camera& camera, PictureOptions options) {
            if (!backend->render(scene, camera, options).ok())
                qFatal("no picture");
            return backend->statistics().orderReused;
        };
        const TetrahedralMesh& convex = meshNamed("refined lattice");
        Scene scene = volumeScene(convex, functionFor(convex, "ramps").function);
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

        const TetrahedralMesh& hole = meshNamed("irregular with a hole");
        const Scene holed = volumeScene(hole, functionFor(hole, "ramps").function);
        QVERIFY(!reused(holed, camera, usual));
        QVERIFY(reused(holed, camera, usual));
        QVERIFY(!reused(holed, camera, larger));
        QVERIFY(!reused(holed, wider, usual));
        QVERIFY(reused(holed, turned(wider, 2, 0), tolerant));
    }

    void statisticsTellWhatItTook()
    {
        const TetrahedralMesh& mesh = meshNamed("refined lattice");
        Scene scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
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
        Scene scene = fogCube(0.5f);
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
        const TetrahedralMesh& mesh = meshNamed("irregular with a hole");
        const Scene scene = volumeScene(mesh, functionFor(mesh, "ramps").function);
        const Camera camera = cameraAround(scene.bounds, true);
        const PictureOptions options{.width = 700, .height = 700};
        double last = 0;
        bool falls = false;
        const Progress progress({}, [&](double fraction, std::string_view) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(makeCpuBackend()->render(scene, camera, options, progress).ok());
        QVERIFY(last == 1.0 && !falls);
        for (const double when : {0.0, 0.05, 0.5}) {
            std::stop_source stop;
            const Progress stopping(stop.get_token(), [&](double fraction, std::string_view) {
                last = fraction;
                if (fraction >= when)
                    stop.request_stop();
            });
            QCOMPARE(makeCpuBackend()->render(scene, camera, options, stopping).error().kind, ErrorKind::Cancelled);
            QVERIFY(last < when + 0.3);
        }
    }
};

QTEST_GUILESS_MAIN(VolumeSceneTest)
#include "volume_scene_test.moc"
