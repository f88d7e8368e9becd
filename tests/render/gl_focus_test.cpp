// SPDX-License-Identifier: GPL-3.0-or-later
// A finer volume inside a region, blended at its border (R24, S18), by OpenGL against the CPU back end (B4). Skipped
// where EGL gives no OpenGL 3.3.
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/focus_fields.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"
#include "tests/render/volume_scenes.h"
#include "tests/soak.h"

#include <QTest>

#include <cmath>
#include <variant>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

const PictureOptions usual{.width = 48, .height = 40, .samplesPerAxis = 1};

/// For a focus that nobody overlooks.
const TransferFunction fire = transferFunctionFromPoints({{0, {1, 0.2f, 0}, 0.1f}, {1, {0, 0.2f, 1}, 0.7f}}, 0.2);

using AnyRegion = std::variant<Box, Sphere>;

TetrahedralMesh shiftedLattice(int cells, Split split, const Vector3d& shift)
{
    TetrahedralMesh mesh = latticeMesh(cells, 1, split, waves);
    for (auto& position : mesh.positions)
        position += shift;
    return mesh;
}

/// Cells along an edge of the cube. Coarse and fine differ by much where the waves are steep.
struct Cells {
    int coarse = 3;
    int fine = 5;
};

SceneParts focusScene(const AnyRegion& region, double border, double opacity, const Vector3d& shift = {0, 0, 0},
                      const Cells& cells = {})
{
    const TransferFunction function = rainbow(opacity);
    SceneParts scene = volumeScene(shiftedLattice(cells.coarse, Split::Six, shift), function);
    const Volume fine = volumeOf(volumeMeshOf(shiftedLattice(cells.fine, Split::Five, shift)), function);
    scene.focus = FinePart{fine, region, border};
    return scene;
}

AnyRegion regionNamed(bool isBox)
{
    return isBox ? AnyRegion(box) : AnyRegion(ball);
}

int differingPixels(const Picture& one, const Picture& other)
{
    int count = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        count += difference(one.pixels[i], other.pixels[i]) > 3 ? 1 : 0;
    return count;
}

} // namespace

class GlFocusTest : public GlTest {
    Q_OBJECT

private:
    /// Checks that both back ends draw the same, and something else than without the focus.
    void compare(const SceneParts& scene, const Camera& camera, const PictureOptions& options = usual, int strays = 0,
                 int leastChanged = 20)
    {
        const Picture cpu = rendered(*cpu_, scene, camera, options);
        const Picture gl = rendered(*gl_, scene, camera, options);
        const Picture again = rendered(*gl_, scene, camera, options);
        const QString name = QString("gl_focus_%1_%2").arg(QTest::currentTestFunction(), QTest::currentDataTag());
        QVERIFY(samePicture(cpu, gl, again, QString(name).replace(' ', '_').remove(','), strays));
        SceneParts without = scene;
        without.focus.reset();
        const int changed = differingPixels(gl, rendered(*gl_, without, camera, options));
        QVERIFY2(changed > leastChanged, qPrintable(QString::number(changed)));
    }

    static void addRegions()
    {
        QTest::addColumn<bool>("isBox");
        QTest::addColumn<bool>("perspective");
        for (const bool isBox : {false, true})
            for (const bool perspective : {true, false})
                QTest::addRow("%s, %s", isBox ? "box" : "ball", perspective ? "perspective" : "orthographic")
                    << isBox << perspective;
    }

private slots:
    void initTestCase() { makeGl(); }

    /// Without perspective, as from the front: all rays are parallel to faces of the box, and most pass beside it.
    void alongTheAxes_data()
    {
        QTest::addColumn<int>("up");
        for (const UpAxis up : {UpAxis::X, UpAxis::Y, UpAxis::Z})
            QTest::addRow("axis %d up", int(up)) << int(up);
    }
    void alongTheAxes()
    {
        QFETCH(int, up);
        const SceneParts scene = focusScene(Box{{0.3, 0.35, 0.3}, {0.6, 0.65, 0.55}}, 0.1, 0.5);
        Camera camera{.azimuth = 0, .elevation = 0, .up = static_cast<UpAxis>(up), .perspective = false};
        camera = fitted(camera, scene.bounds);
        camera.target += Vector3d(0.003, 0.007, 0.011); // so that no ray lies in a face between cells
        compare(scene, camera);
    }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<bool>("isBox");
        QTest::addColumn<double>("border");
        QTest::addColumn<double>("opacity");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const bool isBox : {false, true})
            for (const double border : {0.0, 0.02, 0.2})
                for (const double opacity : {0.2, 0.9})
                    for (const bool perspective : {true, false})
                        if (takesRow(row))
                            QTest::addRow("%s, border %g, opacity %g, %s", isBox ? "box" : "ball", border, opacity,
                                          perspective ? "perspective" : "orthographic")
                                << isBox << border << opacity << perspective;
    }
    void sameAsTheCpu()
    {
        QFETCH(bool, isBox);
        QFETCH(double, border);
        QFETCH(double, opacity);
        QFETCH(bool, perspective);
        const SceneParts scene = focusScene(regionNamed(isBox), border, opacity);
        compare(scene, cameraAround(scene.bounds, perspective));
    }

    /// With the border and the region all around, or in part behind.
    void eyeInside_data()
    {
        QTest::addColumn<bool>("isBox");
        QTest::addColumn<Vector3d>("eye");
        for (const bool isBox : {false, true}) {
            QTest::addRow("%s, in the region", isBox ? "box" : "ball") << isBox << Vector3d(0.41, 0.52, 0.57);
            QTest::addRow("%s, in the border", isBox ? "box" : "ball") << isBox << Vector3d(0.45, 0.14, 0.55);
        }
    }
    void eyeInside()
    {
        QFETCH(bool, isBox);
        QFETCH(Vector3d, eye);
        // The layers that OpenGL mixes in the border show where a large cell is close.
        const SceneParts scene = focusScene(regionNamed(isBox), 0.2, 0.4, {0, 0, 0}, {4, 7});
        for (int turn = 0; turn < 4; ++turn) {
            const Camera camera = turned(cameraAround(scene.bounds, true), 90 * turn, 30 * turn - 40);
            const Picture cpu = rendered(*cpu_, scene, withEyeAt(camera, eye), usual);
            const Picture gl = rendered(*gl_, scene, withEyeAt(camera, eye), usual);
            QVERIFY(samePicture(cpu, gl, gl, "gl_focus_inside"));
        }
    }

    void clipPlanes_data() { addRegions(); }
    void clipPlanes()
    {
        QFETCH(bool, isBox);
        QFETCH(bool, perspective);
        SceneParts scene = focusScene(regionNamed(isBox), 0.15, 0.5);
        scene.clipPlanes = {{{0.6, 0.8, 0}, 0.63}, {{0, 0, -1}, -0.8}};
        compare(scene, cameraAround(scene.bounds, perspective));
    }

    void surfaces_data()
    {
        QTest::addColumn<float>("surfaceOpacity");
        QTest::addColumn<bool>("isBox");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const float opacity : {1.0f, 0.5f})
            for (const bool isBox : {false, true})
                for (const bool perspective : {true, false})
                    if (takesRow(row))
                        QTest::addRow("%s, %s, %s", opacity < 1 ? "translucent" : "opaque", isBox ? "box" : "ball",
                                      perspective ? "perspective" : "orthographic")
                            << opacity << isBox << perspective;
    }
    /// A surface across the border. In the border the CPU draws a layer's piece before or behind it as a whole.
    void surfaces()
    {
        QFETCH(float, surfaceOpacity);
        QFETCH(bool, isBox);
        QFETCH(bool, perspective);
        SceneParts scene = focusScene(regionNamed(isBox), 0.1, 0.3);
        addLayer(scene, 0.55, {0.9f, 0.5f, 0.2f}, surfaceOpacity);
        compare(scene, cameraAround(scene.bounds, perspective), usual, 1);
    }

    void wholeCells_data() { addRegions(); }
    /// Surfaces are drawn before the cells that they lie in.
    void wholeCells()
    {
        QFETCH(bool, isBox);
        QFETCH(bool, perspective);
        SceneParts scene = focusScene(regionNamed(isBox), 0, 0.5);
        scene.wholeCells = true;
        addLayer(scene, 0.55, {0.9f, 0.5f, 0.2f}, 0.5f);
        compare(scene, cameraAround(scene.bounds, perspective), usual, 1, 10);
    }

    void farFromTheOriginAndNear_data()
    {
        QTest::addColumn<double>("zoom");
        QTest::addColumn<bool>("isBox");
        QTest::addColumn<bool>("perspective");
        int row = 0;
        for (const double zoom : {1.0, 0.05, 0.002})
            for (const bool isBox : {false, true})
                for (const bool perspective : {true, false})
                    if (takesRow(row))
                        QTest::addRow("%g, %s, %s", zoom, isBox ? "box" : "ball",
                                      perspective ? "perspective" : "orthographic")
                            << zoom << isBox << perspective;
    }
    /// What single precision could not hold: all far away from zero, and an eye close to the region's end.
    void farFromTheOriginAndNear()
    {
        QFETCH(double, zoom);
        QFETCH(bool, isBox);
        QFETCH(bool, perspective);
        const Vector3d shift(300, -200, 100);
        const AnyRegion region = isBox ? AnyRegion(Box{box.least + shift, box.largest + shift})
                                       : AnyRegion(Sphere{ball.centre + shift, ball.radius});
        SceneParts scene = focusScene(region, 0.1, 0.2, shift);
        scene.focus->fine = volumeOf(scene.focus->fine.mesh, fire);
        Camera camera = cameraAround(scene.bounds, perspective);
        if (zoom < 1)
            camera.target = shift + (isBox ? Vector3d(0.7, 0.6, 0.4) : Vector3d(0.75, 0.5, 0.55));
        compare(scene, zoomed(camera, zoom));
    }

    /// C5: several regions, and surfaces of both resolutions, with and without volumes.
    void severalRegions_data()
    {
        QTest::addColumn<double>("border");
        QTest::addColumn<bool>("perspective");
        for (const double border : {0.0, 0.25})
            for (const bool perspective : {true, false})
                QTest::addRow("border %g, %s", border, perspective ? "perspective" : "orthographic")
                    << border << perspective;
    }
    void severalRegions()
    {
        QFETCH(double, border);
        QFETCH(bool, perspective);
        SceneParts scene = focusScene(Sphere{{0.25, 0.3, 0.4}, 0.15}, border, 0.3);
        scene.focus->more = {{Sphere{{0.75, 0.75, 0.6}, 0.15}, border}, {Box{{0.4, 0.4, 0.1}, {0.6, 0.6, 0.9}}, 0.1}};
        compare(scene, turned(cameraAround(scene.bounds, perspective), perspective ? 0 : 70, 0));
    }

    void sharedSurfaces_data()
    {
        QTest::addColumn<float>("opacity");
        QTest::addColumn<bool>("withVolume");
        for (const float opacity : {0.5f, 1.0f})
            for (const bool withVolume : {false, true})
                QTest::addRow("opacity %g%s", double(opacity), withVolume ? ", in volumes" : "")
                    << opacity << withVolume;
    }
    void sharedSurfaces()
    {
        QFETCH(float, opacity);
        QFETCH(bool, withVolume);
        SceneParts scene = focusScene(Sphere{{0.4, 0.5, 0.5}, 0.15}, 0.2, 0.3);
        scene.focus->more = {{Box{{0.6, 0.2, 0.2}, {0.9, 0.8, 0.9}}, 0.1}};
        SceneParts fine = scene;
        fine.volume = scene.focus->fine;
        addLayer(scene, 0.55, {0.9f, 0.2f, 0.2f}, opacity);
        addLayer(fine, 0.55, {0.2f, 0.2f, 0.9f}, opacity);
        scene.surfaces.push_back(fine.surfaces.front());
        for (const bool isFine : {false, true})
            scene.surfaces[isFine ? 1 : 0].share =
                std::make_shared<const FocusShare>(FocusShare{regionsOf(*scene.focus), isFine});
        if (!withVolume) {
            scene.volume.reset();
            scene.focus.reset();
        }
        for (const bool perspective : {true, false}) {
            const Camera camera = cameraAround(scene.bounds, perspective);
            const Picture cpu = rendered(*cpu_, scene, camera, usual), gl = rendered(*gl_, scene, camera, usual);
            const QString name = QString("gl_shared_%1").arg(QTest::currentDataTag());
            QVERIFY(samePicture(cpu, gl, rendered(*gl_, scene, camera, usual),
                                QString(name).replace(' ', '_').remove(','), 12));
        }
    }

    void tooManyRegionsAreRefused()
    {
        SceneParts scene = focusScene(ball, 0.1, 0.3);
        scene.focus->more.assign(16, FocusRegion{ball, 0.1});
        const auto picture = gl_->render(scene, cameraAround(scene.bounds, true), usual);
        QVERIFY(!picture && picture.error().kind == ErrorKind::OutOfResource);
    }

    /// Lit, many samples, a transparent background.
    void shadedAndTransparent()
    {
        SceneParts scene = focusScene(ball, 0.1, 0.5);
        scene.volume->shaded = true;
        scene.focus->fine.shaded = true;
        compare(scene, cameraAround(scene.bounds, true),
                {.width = 40, .height = 30, .transparentBackground = true, .samplesPerAxis = 2});
    }

    /// One mesh for both, of another function in the focus.
    void oneMeshTwoFunctions()
    {
        SceneParts scene = focusScene(box, 0.1, 0.3);
        scene.focus->fine = volumeOf(scene.volume->mesh, fire);
        compare(scene, cameraAround(scene.bounds, true));
        QVERIFY(gl_->statistics().cells > 0);
    }

    void depths()
    {
        const SceneParts scene = focusScene(ball, 0.1, 0.5);
        const Camera camera = cameraAround(scene.bounds, true);
        const PictureOptions options{.width = 30, .height = 24, .samplesPerAxis = 1, .depth = true};
        const Picture cpu = rendered(*cpu_, scene, camera, options), gl = rendered(*gl_, scene, camera, options);
        QCOMPARE(gl.depth.size(), cpu.depth.size());
        int wrong = 0;
        for (std::size_t i = 0; i < cpu.depth.size(); ++i) {
            const bool same =
                std::isinf(cpu.depth[i]) ? std::isinf(gl.depth[i]) : std::abs(cpu.depth[i] - gl.depth[i]) <= 0.03;
            wrong += same ? 0 : 1;
        }
        QVERIFY2(wrong <= 10, qPrintable(QString::number(wrong)));
        QVERIFY(std::ranges::count_if(cpu.depth, [](float depth) { return std::isfinite(depth); }) > 20);
    }

    void besideTheDomainItIsNothing()
    {
        SceneParts scene = focusScene(Sphere{{3, 3, 3}, 0.5}, 0.1, 0.5);
        const Camera camera = cameraAround(scene.bounds, true);
        const Picture picture = rendered(*gl_, scene, camera, usual);
        scene.focus.reset();
        QCOMPARE(differingPixels(picture, rendered(*gl_, scene, camera, usual)), 0);
    }

    void refusesAFunctionOfAnotherMesh()
    {
        SceneParts scene = focusScene(ball, 0.1, 0.5);
        scene.focus->fine.transfer = scene.volume->transfer;
        const auto picture = gl_->render(scene, cameraAround(scene.bounds, true), usual);
        QVERIFY(!picture);
        QCOMPARE(picture.error().kind, ErrorKind::WrongUsage);
    }
};

QTEST_GUILESS_MAIN(GlFocusTest)
#include "gl_focus_test.moc"
