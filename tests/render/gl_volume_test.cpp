// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes and hybrids of the OpenGL back end against the CPU's (B4, R20, R21). Skipped where EGL gives no OpenGL 3.3.
#include "core/graphics/resolve.h"
#include "core/graphics/volume/volume_renderer.h"
#include "tests/core/graphics/volume/volume_meshes.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"

#include <QTest>

#include <limits>
#include <stop_token>

using namespace tetra;
using namespace tetra::testing;

namespace {

const std::vector<NamedMesh>& meshes()
{
    static const std::vector<NamedMesh> all = volumeMeshes();
    return all;
}

std::vector<NamedFunction> functionsFor(const VolumeMesh& mesh)
{
    const auto [low, high] = std::ranges::minmax(mesh.mesh->values);
    return volumeFunctions(low, high, mesh.bounds.diagonal().norm() / 10);
}

Volume volumeOf(const TetrahedralMesh& tetrahedra, const std::string& functionName)
{
    auto mesh = makeVolumeMesh(std::make_shared<const TetrahedralMesh>(tetrahedra));
    if (!mesh)
        qFatal("%s", mesh.error().text.c_str());
    const auto functions = functionsFor(*mesh);
    const auto function = std::ranges::find(functions, functionName, &NamedFunction::name);
    auto transfer = makeVolumeTransfer(tetrahedra, function->function);
    if (!transfer)
        qFatal("%s", transfer.error().text.c_str());
    return {std::make_shared<VolumeMesh>(std::move(*mesh)), std::make_shared<VolumeTransfer>(std::move(*transfer))};
}

Volume volumeNamed(const std::string& meshName, const std::string& functionName)
{
    return volumeOf(std::ranges::find(meshes(), meshName, &NamedMesh::name)->mesh, functionName);
}

/// What the CPU's volume renderer makes of a scene with nothing else.
Picture volumePicture(const Scene& scene, const Camera& camera, const PictureOptions& options)
{
    const VolumeOptions samples{options.width * options.samplesPerAxis, options.height * options.samplesPerAxis};
    const auto order = orderForCamera(*scene.volume->mesh, camera, samples);
    auto volume = drawVolume(*scene.volume->mesh, *scene.volume->transfer, order->cells, camera, samples);
    if (!volume)
        qFatal("%s", volume.error().text.c_str());
    if (!options.transparentBackground)
        for (auto& sample : volume->samples) {
            const float light = 1 - sample[3];
            sample = {sample[0] + light * options.background.red, sample[1] + light * options.background.green,
                      sample[2] + light * options.background.blue, 1};
        }
    Picture picture{options.width, options.height, {}};
    picture.pixels.resize(static_cast<std::size_t>(options.width * options.height));
    resolve(volume->samples, samples.width, options.samplesPerAxis, 0, 0, picture);
    return picture;
}

/// Cubes one behind the other along y, of `count` * 6 cells.
TetrahedralMesh column(std::uint32_t count)
{
    TetrahedralMesh mesh;
    for (std::uint32_t j = 0; j <= count; ++j)
        for (const auto& [x, z] : {std::array{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
            const float y = static_cast<float>(j) / static_cast<float>(count);
            mesh.positions.emplace_back(static_cast<float>(x), y, static_cast<float>(z));
            mesh.values.push_back(y);
        }
    for (std::uint32_t j = 0; j < count; ++j)
        for (const auto& [a, b] : {std::array{1u, 5u}, {5u, 4u}, {4u, 6u}, {6u, 2u}, {2u, 3u}, {3u, 1u}})
            mesh.tetrahedra.push_back({4 * j, 4 * j + b, 4 * j + a, 4 * j + 7}); // around the diagonal from 0 to 7
    return mesh;
}

/// The camera with its eye at a place, looking where it looked.
Camera withEyeAt(const Camera& camera, const Eigen::Vector3d& place)
{
    Camera result = camera;
    result.target += place - eyePosition(camera);
    return result;
}

/// The part of the pixels that are not `colour`: something is seen there.
double shareOfOther(const Picture& picture, const std::array<std::uint8_t, 4>& colour)
{
    const auto same = std::ranges::count(picture.pixels, colour);
    return 1 - static_cast<double>(same) / static_cast<double>(picture.pixels.size());
}

Scene sceneNamed(const QString& meshName, const QString& functionName)
{
    Scene scene;
    scene.volume = volumeNamed(meshName.toStdString(), functionName.toStdString());
    scene.bounds = scene.volume->mesh->bounds;
    return scene;
}

Camera cameraFor(const Scene& scene, bool perspective)
{
    Camera camera;
    camera.azimuth = 33;
    camera.elevation = 21;
    camera.perspective = perspective;
    return zoomed(fitted(camera, scene.bounds), 0.8);
}

} // namespace

class GlVolumeTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<RenderBackend> gl_;

    /// Checks that OpenGL's picture is `expected`, twice, and that there is something to be seen.
    void compare(const Picture& expected, const Scene& scene, const Camera& camera, const PictureOptions& options,
                 double leastSeen = 0.05)
    {
        QVERIFY(shareOfOther(expected, expected.pixels.front()) > leastSeen);
        const Picture gl = rendered(*gl_, scene, camera, options);
        const Picture again = rendered(*gl_, scene, camera, options);
        const QString name = QString("gl_volume_%1_%2").arg(QTest::currentTestFunction(), QTest::currentDataTag());
        QVERIFY(samePicture(expected, gl, again, QString(name).replace(' ', '_').remove(',')));
    }

private slots:
    void initTestCase()
    {
        auto backend = makeGlBackend();
        if (!backend)
            QSKIP(("skipped: " + backend.error().text).c_str());
        gl_ = std::move(*backend);
    }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramp", "ramps", "steps", "spikes", "opaque"})
                for (const bool perspective : {true, false})
                    QTest::addRow("%s, %s, %s", mesh.name.c_str(), function,
                                  perspective ? "perspective" : "orthographic")
                        << QString::fromStdString(mesh.name) << QString(function) << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        const Scene scene = sceneNamed(mesh, function);
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{.width = 90, .height = 60, .background = {0.2f, 0.5f, 0.3f}};
        compare(volumePicture(scene, camera, options), scene, camera, options);
    }

    void eyeInTheMesh_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramp", "spikes"})
                QTest::addRow("%s, %s", mesh.name.c_str(), function)
                    << QString::fromStdString(mesh.name) << QString(function);
    }
    void eyeInTheMesh()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        const Scene scene = sceneNamed(mesh, function);
        const PictureOptions options{.width = 60, .height = 70};
        double seen = 0;
        for (int turn = 0; turn < 4; ++turn) {
            Camera camera = turned(cameraFor(scene, true), 80 * turn, 35 * turn - 60);
            camera.fieldOfView = 70;
            camera = withEyeAt(camera, scene.bounds.center() + 0.05 * (turn - 1) * scene.bounds.diagonal());
            const Picture expected = volumePicture(scene, camera, options);
            seen = std::max(seen, shareOfOther(expected, {255, 255, 255, 255}));
            compare(expected, scene, camera, options, -1);
        }
        QVERIFY(seen > 0.05);
    }

    void anyPicture_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("samples");
        QTest::addColumn<bool>("transparent");
        QTest::newRow("one sample") << 50 << 80 << 1 << false;
        QTest::newRow("transparent") << 80 << 50 << 2 << true;
        QTest::newRow("many samples, transparent") << 33 << 35 << 4 << true;
        QTest::newRow("one row") << 200 << 1 << 1 << false;
    }
    void anyPicture()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, samples);
        QFETCH(bool, transparent);
        const Scene scene = sceneNamed("refined lattice", "ramps");
        const Camera camera = cameraFor(scene, true);
        const PictureOptions options{
            .width = width, .height = height, .transparentBackground = transparent, .samplesPerAxis = samples};
        compare(volumePicture(scene, camera, options), scene, camera, options, 0.001);
    }

    /// Many cells of which each shows next to nothing: their sum must not drown in rounding.
    void faintCells()
    {
        const TetrahedralMesh fine = column(1500);
        const auto mesh = std::make_shared<VolumeMesh>(*makeVolumeMesh(std::make_shared<TetrahedralMesh>(fine)));
        const TransferFunction function{{{0, {1, 0.2f, 0}, 0.5f}, {1, {0, 0.2f, 1}, 0.9f}}, 1};
        Scene scene;
        scene.volume = {mesh, std::make_shared<VolumeTransfer>(*makeVolumeTransfer(fine, function))};
        scene.bounds = mesh->bounds;
        Camera camera{.target = mesh->bounds.center(), .distance = 4, .azimuth = 1, .elevation = 2};
        camera.perspective = false;
        const PictureOptions options{.width = 60, .height = 60};
        compare(volumePicture(scene, camera, options), scene, camera, options);
    }

    void farFromTheOriginAndNear_data()
    {
        QTest::addColumn<double>("zoom");
        QTest::addColumn<bool>("perspective");
        for (const double zoom : {1.0, 0.05, 0.002})
            for (const bool perspective : {true, false})
                QTest::addRow("%g, %s", zoom, perspective ? "perspective" : "orthographic") << zoom << perspective;
    }
    /// What single precision could not hold: a mesh far away from zero, values, too, and an eye close to it.
    void farFromTheOriginAndNear()
    {
        QFETCH(double, zoom);
        QFETCH(bool, perspective);
        TetrahedralMesh mesh = randomLattice(3);
        for (auto& position : mesh.positions)
            position += Eigen::Vector3f(300, -200, 100);
        for (float& value : mesh.values)
            value += 500;
        Scene scene;
        scene.volume = volumeOf(mesh, "ramps");
        scene.bounds = scene.volume->mesh->bounds;
        Camera camera = zoomed(cameraFor(scene, perspective), zoom);
        const PictureOptions options{.width = 90, .height = 70};
        compare(volumePicture(scene, camera, options), scene, camera, options);
    }

    /// Cells without volume, without finite places or values show nothing, and do no harm.
    void damagedMeshes()
    {
        TetrahedralMesh mesh = refinedLattice();
        mesh.positions[7].x() = std::numeric_limits<float>::quiet_NaN();
        mesh.positions[20].z() = std::numeric_limits<float>::infinity();
        mesh.values[40] = std::numeric_limits<float>::quiet_NaN();
        for (const auto& cell : {std::array<std::uint32_t, 4>{1, 2, 3, 3}, {5, 5, 5, 5}, {2, 1, 4, 3}})
            mesh.tetrahedra.push_back(cell);
        std::ranges::reverse(mesh.tetrahedra[11]); // inverted where it was
        std::swap(mesh.tetrahedra[12][0], mesh.tetrahedra[12][1]);
        const TransferFunction function{{{0, {1, 0.2f, 0}, 0.1f}, {1, {0, 0.2f, 1}, 0.3f}}, 1};
        Scene scene;
        scene.volume = {std::make_shared<VolumeMesh>(*makeVolumeMesh(std::make_shared<TetrahedralMesh>(mesh))),
                        std::make_shared<VolumeTransfer>(*makeVolumeTransfer(mesh, function))};
        scene.bounds = scene.volume->mesh->bounds;
        const Camera camera = cameraFor(scene, true);
        const PictureOptions options{.width = 80, .height = 60};
        compare(volumePicture(scene, camera, options), scene, camera, options);
    }

    /// The order and the buffers are kept while they fit, and not longer.
    void keepsWhatFits()
    {
        Scene scene = sceneNamed("refined lattice", "ramps");
        const PictureOptions exact{.width = 60, .height = 40};
        PictureOptions quick = exact;
        quick.orderTolerance = 5;
        Camera camera = cameraFor(scene, true);
        const auto reuses = [&](const PictureOptions& options) {
            const Picture picture = rendered(*gl_, scene, camera, options);
            if (options.orderTolerance == 0 &&
                !samePicture(volumePicture(scene, camera, options), picture, picture, "gl_volume_kept"))
                qFatal("a wrong picture");
            return gl_->statistics().orderReused;
        };
        QVERIFY(!reuses(exact));
        QVERIFY(gl_->statistics().cells > 100);
        QVERIFY(gl_->statistics().cells <= scene.volume->mesh->mesh->tetrahedra.size());
        QVERIFY(gl_->statistics().fragments > 10 * 60 * 40);
        camera = turned(camera, 2, 0);
        QVERIFY(reuses(quick));
        QVERIFY(!reuses(exact));
        QVERIFY(reuses(exact) == scene.volume->mesh->convex);
        // Another function of the same mesh keeps the order; a copy of the mesh does not.
        const auto mesh = scene.volume->mesh;
        scene.volume->transfer = volumeOf(*mesh->mesh, "steps").transfer;
        QVERIFY(reuses(quick));
        QVERIFY(samePicture(volumePicture(scene, camera, exact), rendered(*gl_, scene, camera, exact),
                            rendered(*gl_, scene, camera, exact), "gl_volume_function"));
        scene.volume->mesh = std::make_shared<VolumeMesh>(*mesh);
        QVERIFY(!reuses(quick));
        camera = turned(camera, 30, 0);
        QVERIFY(!reuses(quick));
    }

    void badScenesAreErrors()
    {
        Scene scene = sceneNamed("one cell", "ramp");
        const auto mesh = scene.volume->mesh;
        scene.volume->mesh = sceneNamed("refined lattice", "ramp").volume->mesh;
        QCOMPARE(gl_->render(scene, {}, {}).error().kind, ErrorKind::WrongUsage);
        scene.volume->mesh = mesh;
        scene.clipPlanes.resize(17);
        QCOMPARE(gl_->render(scene, {}, {}).error().kind, ErrorKind::OutOfResource);
        scene.clipPlanes.clear();
        scene.volume->mesh = nullptr; // nothing to be seen is no error
        QVERIFY(gl_->render(scene, {}, {}).ok());
    }

    void cancels()
    {
        const Scene scene = sceneNamed("refined lattice", "ramp");
        std::stop_source stop;
        const Progress stopping(stop.get_token(), [&](double fraction, std::string_view) {
            if (fraction > 0.1)
                stop.request_stop();
        });
        QCOMPARE(gl_->render(scene, cameraFor(scene, true), {}, stopping).error().kind, ErrorKind::Cancelled);
        QVERIFY(gl_->render(scene, cameraFor(scene, true), {}).ok());
    }
};

QTEST_GUILESS_MAIN(GlVolumeTest)
#include "gl_volume_test.moc"
