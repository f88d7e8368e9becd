// SPDX-License-Identifier: GPL-3.0-or-later
// Volumes and hybrids of the OpenGL back end against the CPU's (B4, R20, R21), by TAN_GL_LEVEL at most: run for both.
// Skipped where EGL gives no OpenGL 3.3.
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/gl_test.h"
#include "tests/render/gl_volume_scenes.h"
#include "tests/render/same_picture.h"
#include "tests/soak.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <stop_token>

using namespace tetra;
using namespace tetra::testing;

class GlVolumeTest : public GlTest {
    Q_OBJECT

private:
    /// Checks that OpenGL's picture is `expected`, twice, and that there is something to be seen.
    void compare(const Picture& expected, const SceneParts& scene, const Camera& camera, const PictureOptions& options,
                 double leastSeen = 0.05, int strays = 0)
    {
        QVERIFY(shareOfOther(expected, expected.pixels.front()) > leastSeen);
        const Picture gl = rendered(*gl_, scene, camera, options);
        const Picture again = rendered(*gl_, scene, camera, options);
        const QString name = QString("gl_volume_%1_%2").arg(QTest::currentTestFunction(), QTest::currentDataTag());
        QVERIFY(samePicture(expected, gl, again, QString(name).replace(' ', '_').remove(','), strays));
    }

private slots:
    void initTestCase() { makeGl(); }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramp", "ramps", "steps", "spikes", "opaque"})
                for (const bool perspective : {true, false})
                    if (takesRow(row))
                        QTest::addRow("%s, %s, %s", mesh.name.c_str(), function,
                                      perspective ? "perspective" : "orthographic")
                            << QString::fromStdString(mesh.name) << QString(function) << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        const SceneParts scene = sceneNamed(mesh, function);
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{.width = 60, .height = 40, .background = {0.2f, 0.5f, 0.3f}};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options);
    }

    void eyeInTheMesh_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        int row = 0;
        for (const NamedMesh& mesh : meshes())
            for (const char* function : {"ramp", "spikes"})
                if (takesRow(row))
                    QTest::addRow("%s, %s", mesh.name.c_str(), function)
                        << QString::fromStdString(mesh.name) << QString(function);
    }
    void eyeInTheMesh()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        const SceneParts scene = sceneNamed(mesh, function);
        const PictureOptions options{.width = 42, .height = 49};
        double seen = 0;
        for (int turn = 0; turn < 4; ++turn) {
            Camera camera = turned(cameraFor(scene, true), 80 * turn, 35 * turn - 60);
            camera.fieldOfView = 70;
            camera = withEyeAt(camera, scene.bounds.center() + 0.05 * (turn - 1) * scene.bounds.diagonal());
            const Picture expected = rendered(*cpu_, scene, camera, options);
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
        const SceneParts scene = sceneNamed("refined lattice", "ramps");
        const Camera camera = cameraFor(scene, true);
        const PictureOptions options{
            .width = width, .height = height, .transparentBackground = transparent, .samplesPerAxis = samples};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options, 0.001);
    }

    /// Many cells of which each shows next to nothing: their sum must not drown in rounding.
    void faintCells()
    {
        const TetrahedralMesh fine = column(1500);
        const auto mesh = std::make_shared<VolumeMesh>(*makeVolumeMesh(std::make_shared<TetrahedralMesh>(fine)));
        const TransferFunction function =
            transferFunctionFromPoints({{0, {1, 0.2f, 0}, 0.5f}, {1, {0, 0.2f, 1}, 0.9f}}, 1);
        SceneParts scene;
        scene.volume = {mesh, std::make_shared<VolumeTransfer>(*makeVolumeTransfer(fine, function))};
        scene.bounds = mesh->bounds;
        Camera camera{.target = mesh->bounds.center(), .distance = 4, .azimuth = 1, .elevation = 2};
        camera.perspective = false;
        const PictureOptions options{.width = 24, .height = 24};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options);
    }

    /// More cells than are drawn at once; behind what is opaque none are drawn.
    void severalChunks()
    {
        const auto rising = [](const Eigen::Vector3d& p) { return -p.y() + 0.1 * std::sin(9 * p.x() + 7 * p.z()); };
        const TetrahedralMesh mesh = latticeMesh(24, 1, Split::Five, rising);
        const auto fragmentsOf = [&](const std::string& function) {
            SceneParts scene;
            scene.volume = volumeOf(mesh, function);
            scene.bounds = scene.volume->mesh->bounds;
            const Camera camera = cameraFor(scene, true);
            const PictureOptions options{.width = 70, .height = 60, .samplesPerAxis = 1};
            compare(rendered(*cpu_, scene, camera, options), scene, camera, options);
            return gl_->statistics().fragments;
        };
        const std::size_t faint = fragmentsOf("ramp");
        QVERIFY(faint > 50000);
        QVERIFY(fragmentsOf("opaque") < 0.8 * static_cast<double>(faint));
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
            position += Eigen::Vector3d(300, -200, 100);
        for (float& value : mesh.values)
            value += 500;
        SceneParts scene;
        scene.volume = volumeOf(mesh, "ramps");
        scene.bounds = scene.volume->mesh->bounds;
        Camera camera = zoomed(cameraFor(scene, perspective), zoom);
        const PictureOptions options{.width = 63, .height = 49};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options);
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
        const TransferFunction function =
            transferFunctionFromPoints({{0, {1, 0.2f, 0}, 0.1f}, {1, {0, 0.2f, 1}, 0.3f}}, 1);
        SceneParts scene;
        scene.volume = {std::make_shared<VolumeMesh>(*makeVolumeMesh(std::make_shared<TetrahedralMesh>(mesh))),
                        std::make_shared<VolumeTransfer>(*makeVolumeTransfer(mesh, function))};
        scene.bounds = scene.volume->mesh->bounds;
        const Camera camera = cameraFor(scene, true);
        const PictureOptions options{.width = 80, .height = 60};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options);
    }

    void hybrids_data()
    {
        QTest::addColumn<QString>("surfaces");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<bool>("exact");
        int row = 0;
        for (const char* surfaces : {"opaque", "translucent", "crossing", "isosurfaces"})
            for (const bool perspective : {true, false})
                for (const bool exact : {true, false})
                    if (takesRow(row))
                        QTest::addRow("%s, %s, %s", surfaces, perspective ? "perspective" : "orthographic",
                                      exact ? "exact" : "with cell")
                            << QString(surfaces) << QString(perspective == exact ? "ramps" : "spikes") << perspective
                            << exact;
    }
    /// R21: surfaces and lines among the cells, in both orders, whole and cut by planes.
    void hybrids()
    {
        QFETCH(QString, surfaces);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        QFETCH(bool, exact);
        SceneParts scene = sceneNamed("refined lattice", function);
        addSurfaces(scene, surfaces);
        scene.lines.push_back(boxOutline(scene.bounds, {0, 0, 0}, 2));
        scene.wholeCells = !exact;
        scene.volume->shaded = surfaces == "crossing";
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{
            .width = 54, .height = 42, .background = {0.9f, 0.8f, 1}, .transparentBackground = !perspective};
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options, 0.05, 1);
        const Eigen::Vector3d centre = scene.bounds.center();
        for (const Eigen::Vector3d& normal : {Eigen::Vector3d(1, 0.3, 0.2), Eigen::Vector3d(-0.4, -1, 0.5)})
            scene.clipPlanes.push_back({normal, normal.dot(centre) - 0.1 * scene.bounds.diagonal().norm()});
        compare(rendered(*cpu_, scene, camera, options), scene, camera, options, 0.05, 1);
    }

    void shadedVolumes_data()
    {
        QTest::addColumn<QString>("mesh");
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<double>("fullGradient"); // of the longest
        for (const char* mesh : {"one cell", "irregular with a hole", "refined bent grid"})
            for (const bool perspective : {true, false})
                QTest::addRow("%s, %s", mesh, perspective ? "perspective" : "orthographic")
                    << QString(mesh) << QString(perspective ? "steps" : "ramps") << perspective << 0.0;
        QTest::newRow("faded by the gradient") << "refined bent grid"
                                               << "ramps" << true << 0.7;
    }
    void shadedVolumes()
    {
        QFETCH(QString, mesh);
        QFETCH(QString, function);
        QFETCH(bool, perspective);
        SceneParts scene = sceneNamed(mesh, function);
        QFETCH(double, fullGradient);
        scene.volume->shaded = true;
        scene.volume->fullGradient = fullGradient * scene.volume->mesh->longestGradient;
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{.width = 60, .height = 50};
        const Picture picture = rendered(*cpu_, scene, camera, options);
        compare(picture, scene, camera, options);
        scene.volume->fullGradient = 0;
        QCOMPARE(picture.pixels == rendered(*cpu_, scene, camera, options).pixels, fullGradient == 0);
    }

    void depths_data()
    {
        QTest::addColumn<QString>("surfaces");
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<bool>("volume");
        int row = 0;
        for (const char* surfaces : {"none", "opaque", "translucent", "crossing"})
            for (const bool perspective : {true, false})
                for (const bool volume : {true, false})
                    if (takesRow(row))
                        QTest::addRow("%s, %s%s", surfaces, perspective ? "perspective" : "orthographic",
                                      volume ? ", volume" : "")
                            << QString(surfaces) << perspective << volume;
    }
    /// Where half of the light is gone, but for few pixels at edges. Tolerance: inside a cell the CPU takes the
    /// extinction for constant.
    void depths()
    {
        QFETCH(QString, surfaces);
        QFETCH(bool, perspective);
        QFETCH(bool, volume);
        SceneParts scene = sceneNamed("refined lattice", "ramps");
        addSurfaces(scene, surfaces);
        if (!volume)
            scene.volume.reset();
        const Camera camera = cameraFor(scene, perspective);
        const PictureOptions options{.width = 36, .height = 30, .samplesPerAxis = 2, .depth = true};
        const Picture cpu = rendered(*cpu_, scene, camera, options);
        const Picture gl = rendered(*gl_, scene, camera, options);
        QVERIFY(samePicture(cpu, gl, gl, "gl_volume_depth", 2));
        QCOMPARE(gl.depth.size(), cpu.depth.size());
        const double tolerance = scene.bounds.diagonal().norm() / 200;
        int wrong = 0;
        for (std::size_t i = 0; i < cpu.depth.size(); ++i) {
            const bool same =
                std::isinf(cpu.depth[i]) ? std::isinf(gl.depth[i]) : std::abs(cpu.depth[i] - gl.depth[i]) <= tolerance;
            wrong += same ? 0 : 1;
        }
        QVERIFY2(wrong <= 6, qPrintable(QString::number(wrong)));
        const auto finite = std::ranges::count_if(cpu.depth, [](float depth) { return std::isfinite(depth); });
        QCOMPARE(finite > 20, surfaces != "none" || volume);
        QVERIFY(rendered(*gl_, scene, camera, {.width = 36, .height = 30}).depth.empty());
    }

    /// The order and the buffers are kept while they fit, and not longer.
    void keepsWhatFits()
    {
        SceneParts scene = sceneNamed("refined lattice", "ramps");
        const PictureOptions exact{.width = 60, .height = 40};
        PictureOptions quick = exact;
        quick.orderTolerance = 5;
        Camera camera = cameraFor(scene, true);
        const auto reuses = [&](const PictureOptions& options) {
            const Picture picture = rendered(*gl_, scene, camera, options);
            if (options.orderTolerance == 0 &&
                !samePicture(rendered(*cpu_, scene, camera, options), picture, picture, "gl_volume_kept"))
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
        QVERIFY(samePicture(rendered(*cpu_, scene, camera, exact), rendered(*gl_, scene, camera, exact),
                            rendered(*gl_, scene, camera, exact), "gl_volume_function"));
        scene.volume->mesh = std::make_shared<VolumeMesh>(*mesh);
        QVERIFY(!reuses(quick));
        camera = turned(camera, 30, 0);
        QVERIFY(!reuses(quick));
    }

    void badScenesAreErrors()
    {
        SceneParts scene = sceneNamed("one cell", "ramp");
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
        const SceneParts scene = sceneNamed("refined lattice", "ramp");
        const PictureOptions small{.width = 60, .height = 50};
        std::stop_source stop;
        const Progress stopping(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction > 0.1)
                stop.request_stop();
        });
        QCOMPARE(gl_->render(scene, cameraFor(scene, true), small, stopping).error().kind, ErrorKind::Cancelled);
        QVERIFY(gl_->render(scene, cameraFor(scene, true), small).ok());
    }
};

QTEST_GUILESS_MAIN(GlVolumeTest)
#include "gl_volume_test.moc"
