// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the OpenGL back end against the CPU's, the reference (B4). Skipped where EGL gives no OpenGL 3.3.
#include "core/render/gl/egl_context.h"
#include "core/render/gl/scene_painter.h"
#include "core/render/scene_checks.h"
#include "tests/core/render/lattice_mesh.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/scenes.h"

#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace tetra;
using namespace tetra::testing;

namespace {

/// Isosurfaces of smooth noise: they fold over each other many times.
SceneParts foldedScene()
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> phase(0, 6.28);
    std::array<Eigen::Vector4d, 6> waves;
    for (auto& wave : waves)
        wave = Eigen::Vector4d(phase(random), phase(random), phase(random), phase(random));
    const auto mesh = latticeMesh(14, 2, Split::Six, [&](const Eigen::Vector3d& p) {
        double sum = 0;
        for (const auto& wave : waves)
            sum += std::sin(wave.head<3>().dot(p) + wave.w());
        return sum;
    });
    const auto gradients = vertexGradients(mesh);
    SceneParts scene;
    scene.bounds = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(2, 2, 2)};
    const std::array<Colour, 3> colours = {{{0.9f, 0.6f, 0}, {0.3f, 0.7f, 0.9f}, {0, 0.6f, 0.5f}}};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        auto surface = extractIsosurface(mesh, gradients, static_cast<double>(i) - 0.8);
        scene.surfaces.push_back(
            {std::make_shared<TriangleMesh>(std::move(*surface)), colours[i], i == 1 ? 1.0f : 0.35f});
    }
    scene.lines.push_back(boxOutline(scene.bounds, {0, 0, 0}, 2));
    return scene;
}

SceneParts movedBy(const SceneParts& scene, const Eigen::Vector3d& offset)
{
    SceneParts result;
    result.bounds = scene.bounds.translated(offset);
    for (const Surface& surface : scene.surfaces) {
        auto mesh = std::make_shared<TriangleMesh>(*surface.mesh);
        for (auto& position : mesh->positions)
            position += offset;
        result.surfaces.push_back({mesh, surface.colour, surface.opacity});
    }
    return result;
}

struct View {
    SceneParts scene;
    Camera camera;
    PictureOptions options{.width = 140, .height = 100};
};

View viewNamed(const QString& name)
{
    View view;
    const Colour orange{0.9f, 0.6f, 0.1f};
    if (name.startsWith("folded") || name == "far from the origin") {
        view.scene = foldedScene();
        if (name == "far from the origin")
            view.scene = movedBy(view.scene, {5000, -3000, 8000});
        view.camera = fitted({}, view.scene.bounds);
        view.camera.perspective = name != "folded, orthographic";
        if (name == "folded, eye inside")
            view.camera.distance = 0.65;
        if (name == "folded, eye farther inside")
            view.camera.distance = 0.75;
        view.options.transparentBackground = name == "folded, transparent background";
        view.options.samplesPerAxis = name == "folded, one sample" ? 1 : 2;
        return view;
    }
    view.scene.bounds = cube(1);
    view.camera = fitted({}, view.scene.bounds);
    view.options.background = {0.1f, 0.2f, 0.3f};
    if (name == "opaque sphere") {
        view.scene.surfaces = {{sphere({0, 0, 0}, 1, 100), orange, 1}};
        view.scene.lines = {boxOutline(cube(1), {1, 1, 1}, 3)};
    } else if (name == "spheres in each other") {
        for (int i = 0; i < 12; ++i)
            view.scene.surfaces.push_back(
                {sphere({0.1f * static_cast<float>(i % 3), 0, 0}, 0.3f + 0.05f * static_cast<float>(i), 40),
                 {static_cast<float>(i % 2), static_cast<float>(i % 3) / 2, 0.5f},
                 0.1f + 0.05f * static_cast<float>(i)});
    } else if (name == "equal depths") {
        const auto sheet = quad({-1, 0, -1}, {2, 0, 0}, {0, 0, 2});
        for (const Colour& colour : {Colour{1, 0, 0}, Colour{0, 1, 0}, Colour{0, 0, 1}})
            view.scene.surfaces.push_back({sheet, colour, 0.5f});
    } else if (name == "lines alone") {
        view.scene.lines = {boxOutline(cube(1), {1, 1, 0}, 1), boxOutline(cube(0.5), {1, 0, 0}, 5)};
    }
    return view;
}

} // namespace

class GlPictureTest : public GlTest {
    Q_OBJECT

private slots:
    void initTestCase() { makeGl(); }

    void sameAsTheCpu_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"opaque sphere", "spheres in each other", "equal depths", "lines alone", "nothing",
                                 "folded", "folded, orthographic", "folded, eye inside", "folded, eye farther inside",
                                 "folded, transparent background", "folded, one sample", "far from the origin"})
            QTest::newRow(name) << QString(name);
    }
    void sameAsTheCpu()
    {
        QFETCH(QString, name);
        const View view = viewNamed(name);
        const Picture cpu = rendered(*cpu_, view.scene, view.camera, view.options);
        const Picture gl = rendered(*gl_, view.scene, view.camera, view.options);
        const Picture again = rendered(*gl_, view.scene, view.camera, view.options);
        PictureOptions single = view.options;
        single.width *= view.options.samplesPerAxis;
        single.height *= view.options.samplesPerAxis;
        single.samplesPerAxis = 1;
        const SamplePictures samples{rendered(*cpu_, view.scene, view.camera, single),
                                     rendered(*gl_, view.scene, view.camera, single), view.options.samplesPerAxis};
        QVERIFY(samePicture(cpu, gl, again, "gl_" + QString(name).replace(' ', '_').remove(','), 0, &samples));
    }

    /// A mesh that died and a new one at its address are told apart; sizes may change from picture to picture.
    void meshesAreNotMixedUp()
    {
        for (int i = 1; i <= 20; ++i) {
            View view = viewNamed("nothing");
            const float size = 0.04f * static_cast<float>(i);
            view.scene.surfaces = {{quad({-size, 0, -size}, {2 * size, 0, 0}, {0, 0, 2 * size}), {1, 0, 0}, 1}};
            view.options.width = 60 + i;
            const Picture cpu = rendered(*cpu_, view.scene, view.camera, view.options);
            const Picture gl = rendered(*gl_, view.scene, view.camera, view.options);
            QVERIFY(samePicture(cpu, gl, gl, "gl_meshes"));
        }
    }

    void badScenesAreErrors()
    {
        auto mesh = std::make_shared<TriangleMesh>(*quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1}));
        mesh->triangles.push_back({0, 1, 4});
        QCOMPARE(gl_->render(SceneParts{{{mesh, {}, 1}}, {}, cube(1)}, {}, {}).error().kind, ErrorKind::WrongUsage);
        const LineSet line{{Eigen::Vector3d(0, 0, 0)}, {{0, 1}}, {}, 1};
        QCOMPARE(gl_->render(SceneParts{{}, {line}, cube(1)}, {}, {}).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(gl_->render({}, {}, {.width = 0}).error().kind, ErrorKind::WrongUsage);
        QCOMPARE(gl_->render({}, {}, {.width = largestPictureSide + 1}).error().kind, ErrorKind::WrongUsage);
        // More than OpenGL draws at once is drawn in parts.
        QVERIFY(gl_->render({}, {}, {.width = largestPictureSide, .height = 1, .samplesPerAxis = 4}).ok());
        QVERIFY(gl_->render({}, {}, {.width = 5, .height = 5}).ok()); // still usable
    }

    void notFiniteCoordinatesAreLeftOut()
    {
        auto mesh = std::make_shared<TriangleMesh>(*sphere({0, 0, 0}, 1, 20));
        mesh->positions[100].x() = std::numeric_limits<float>::quiet_NaN();
        mesh->positions[300].x() = std::numeric_limits<float>::infinity();
        View view = viewNamed("nothing");
        view.scene.surfaces = {{mesh, {1, 0, 0}, 1}, {nullptr, {}, 1}};
        const Picture cpu = rendered(*cpu_, view.scene, view.camera, view.options);
        const Picture gl = rendered(*gl_, view.scene, view.camera, view.options);
        QVERIFY(samePicture(cpu, gl, gl, "gl_not_finite"));
    }

    void cancels()
    {
        const View view = viewNamed("folded");
        std::stop_source stop;
        double last = 0;
        bool falls = false;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(gl_->render(view.scene, view.camera, view.options, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);
        const Progress stopping(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction > 0.2)
                stop.request_stop();
        });
        QCOMPARE(gl_->render(view.scene, view.camera, view.options, stopping).error().kind, ErrorKind::Cancelled);
    }

    void severalBackendsLiveTogether()
    {
        auto other = makeGlBackend();
        QVERIFY(other.ok());
        const View view = viewNamed("opaque sphere");
        const Picture one = rendered(*gl_, view.scene, view.camera, view.options);
        QVERIFY(rendered(**other, view.scene, view.camera, view.options).pixels == one.pixels);
        other->reset();
        QVERIFY(rendered(*gl_, view.scene, view.camera, view.options).pixels == one.pixels);
    }
};

QTEST_GUILESS_MAIN(GlPictureTest)
#include "gl_picture_test.moc"
