// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes with a volume on the CPU back end (R20 to R22, B4): with surfaces, lines and clip planes, against a slow
// integrator and closed forms.
#include "core/render/volume/volume_renderer.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/picture_check.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <limits>
#include <utility>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

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

Picture rendered(const SceneParts& scene, const Camera& camera, const PictureOptions& options = usual)
{
    return renderedByCpu(scene, camera, options);
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

/// Each cell in two, by the middle of its first edge, with values whose gradients turn within the cells.
TetrahedralMesh splitLengthwise(const TetrahedralMesh& mesh)
{
    TetrahedralMesh split = mesh;
    split.tetrahedra.clear();
    for (const auto& [a, b, c, d] : mesh.tetrahedra) {
        const auto middle = static_cast<std::uint32_t>(split.positions.size());
        split.positions.push_back((mesh.positions[a] + mesh.positions[b]) / 2);
        split.tetrahedra.push_back({a, middle, c, d});
        split.tetrahedra.push_back({middle, b, c, d});
    }
    split.values.resize(split.positions.size());
    for (std::size_t vertex = 0; vertex < split.values.size(); ++vertex)
        split.values[vertex] = static_cast<float>(vertex * vertex % 7) / 7;
    return split;
}

/// The volume under light, and else as `rays` has it.
bool litAgrees(const TetrahedralMesh& mesh, const TransferFunction& function, SceneParts scene, RayScene rays,
               const Camera& camera)
{
    scene.volume->shaded = true;
    rays.shaded = true;
    const RayIntegrator integrator(mesh, function, camera, width, height, std::move(rays));
    return agrees(rendered(scene, camera), integrator, 1);
}

} // namespace

class VolumeSceneTest : public QObject {
    Q_OBJECT

private slots:
    /// The same samples as the library's own call, of every mesh.
    void aloneIsAsTheLibraryDrawsIt()
    {
        QVERIFY(!meshes().empty());
        for (const NamedMesh& named : meshes())
            for (const bool perspective : {true, false}) {
                const SceneParts scene = volumeScene(named.mesh, functionFor(named.mesh, "ramps").function);
                const Camera camera = cameraAround(scene.bounds, perspective);
                const VolumeMesh& mesh = *scene.volume->mesh;
                const VolumeOptions options{90, 70};
                const auto order = orderForCamera(mesh, camera, options).value();
                const auto samples = drawVolume(mesh, *scene.volume->transfer, order, camera, options).value().samples;
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
        QTest::addColumn<bool>("wholeCells");
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramps", "steps", "opaque"})
                for (const bool wholeCells : {false, true}) {
                    const bool perspective = QString(function) != "steps";
                    QTest::addRow("%s, %s, %s", mesh.name.c_str(), function, wholeCells ? "with cell" : "exact")
                        << QString::fromStdString(mesh.name) << QString(function) << perspective << wholeCells;
                }
    }
    /// Translucent isosurfaces and an opaque one in the volume.
    void hybridAgreesWithTheIntegrator()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        QFETCH(bool, wholeCells);
        const TetrahedralMesh& tetrahedra = meshNamed(mesh);
        const NamedFunction chosen = functionFor(tetrahedra, function.toStdString());
        SceneParts scene = volumeScene(tetrahedra, chosen.function);
        scene.wholeCells = wholeCells;
        RayScene rays;
        rays.wholeCells = wholeCells;
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
                SceneParts scene = volumeScene(mesh, function.function);
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
        SceneParts scene = volumeScene(mesh, function.function);
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

    /// By gradients between those of the vertices; with surfaces, and opaque slabs of many parts.
    void shadedVolumesAreLit()
    {
        for (const char* name : {"one cell", "refined lattice", "refined bent grid"})
            for (const char* kind : {"ramp", "steps", "opaque"})
                for (const bool perspective : {true, false}) {
                    const TetrahedralMesh& mesh = meshNamed(name);
                    const TransferFunction function = functionFor(mesh, kind).function;
                    SceneParts scene = volumeScene(mesh, function);
                    RayScene rays;
                    if (perspective)
                        rays.layers = {addLayer(scene, valueAt(mesh, 0.45), {0.9f, 0.1f, 0.2f}, 0.5f)};
                    QVERIFY(litAgrees(mesh, function, scene, rays, cameraAround(scene.bounds, perspective)));
                }
    }

    /// Sticks that hide each other in a circle are cut for the order; the pieces have the light of the whole.
    void piecesHaveTheLightOfTheirCells()
    {
        const TetrahedralMesh mesh = splitLengthwise(threeSticks());
        const TransferFunction function = functionFor(mesh, "ramp").function;
        SceneParts scene = volumeScene(mesh, function);
        Camera camera = cameraAround(scene.bounds, true);
        camera.azimuth = camera.elevation = 0;
        QVERIFY(litAgrees(mesh, function, scene, {}, camera));
        Scene drawn = scene;
        std::get<Volume>(drawn.drawables.front().shape).shaded = true;
        const auto backend = makeCpuBackend();
        QVERIFY(backend->render(drawn, camera, {.width = width, .height = height}).ok());
        QVERIFY(backend->statistics().cutCells > 0);
    }

    /// Where the field is flat no direction is known: the colours stay as they are.
    void flatFieldsAreNotLit()
    {
        const TetrahedralMesh mesh = latticeMesh(3, 3, Split::Five, [](const Vector3d&) { return 0.5; });
        TransferFunction function;
        function.colours = {{0, {0.2f, 0.4f, 0.6f}}, {1, {0.2f, 0.4f, 0.6f}}};
        function.opacities = {{0, 0.5f}, {1, 0.5f}};
        SceneParts scene = volumeScene(mesh, function);
        const Camera camera = cameraAround(scene.bounds, true);
        const Picture unlit = rendered(scene, camera);
        scene.volume->shaded = true;
        QVERIFY(pixelAt(unlit, width / 2, height / 2) != pixelAt(unlit, 0, 0)); // it is seen
        QVERIFY(rendered(scene, camera).pixels == unlit.pixels);
    }

    /// A translucent sheet in the middle of a fog, an opaque one and a line behind it: closed forms.
    void sheetsAndLinesInFog()
    {
        SceneParts scene = fogCube(0.5f);
        scene.surfaces.push_back({quad({0, 1, 0}, {4, 0, 0}, {0, 0, 4}), {0, 0, 0.8f}, 0.25f});
        const Colour sheet = facing({0, 0, 0.8f});
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
        const Colour wall = facing({0.5f, 0.5f, 0.5f});
        QVERIFY(difference(pixelAt(rendered(scene, beforeCube(), options), 20, 20), bytes(expected(wall, 1))) <= 1);
    }
};

QTEST_GUILESS_MAIN(VolumeSceneTest)
#include "volume_scene_test.moc"
