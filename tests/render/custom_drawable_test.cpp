// SPDX-License-Identifier: GPL-3.0-or-later
// What a plugin draws itself in each picture, among everything else and over it, on both back ends where there is
// OpenGL.
#include "tests/core/render/scene_parts.h"
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"
#include "tests/render/volume_scenes.h"

#include <QTest>

#include <stdexcept>

using namespace tetra;
using namespace tetra::testing;

namespace {

/// A square that faces the eye, so large and so far before the middle of the cube of fog.
Drawable squareTowards(const Camera& camera, double size, double distance, const Colour& colour, bool overlay)
{
    const Eigen::Matrix3d axes = eyeAxes(camera);
    const Eigen::Vector3d middle = Eigen::Vector3d(2, 2, 2) + distance * axes.col(2);
    TriangleMesh square;
    for (const auto& [right, up] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
        square.positions.emplace_back(middle + size * (right * axes.col(0) + up * axes.col(1)));
    square.normals.assign(4, axes.col(2).cast<float>());
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    return {.id = "square",
            .shape = Surface{.mesh = std::make_shared<const TriangleMesh>(square), .colour = colour, .lit = false},
            .overlay = overlay};
}

Scene sceneWith(const CustomDrawable& custom, bool overlay)
{
    Scene scene = fogCube(0.3f);
    scene.drawables.insert(
        scene.drawables.begin(),
        {.id = "custom", .shape = std::make_shared<const CustomDrawable>(custom), .overlay = overlay});
    return scene;
}

const PictureOptions usual{.width = 60, .height = 50, .background = {0, 0, 0}};

} // namespace

class CustomDrawableTest : public GlTest {
    Q_OBJECT

private slots:
    void initTestCase() { makeGlIfThere(); }

    void followsTheCamera_data()
    {
        QTest::addColumn<bool>("overlay");
        QTest::addColumn<bool>("perspective");
        for (const bool overlay : {false, true})
            for (const bool perspective : {false, true})
                QTest::addRow("%s%s", overlay ? "overlay" : "opaque", perspective ? "" : ", orthographic")
                    << overlay << perspective;
    }
    void followsTheCamera()
    {
        QFETCH(bool, overlay);
        QFETCH(bool, perspective);
        int calls = 0;
        const Colour colour{0.2f, 0.4f, 0.9f};
        const Scene scene = sceneWith(
            {[&](const Camera& camera, int width, int height) {
                ++calls;
                if (width != usual.width || height != usual.height)
                    qFatal("another size");
                const LineSet lines{{{0.2f, 0.2f, 3.8f}, {3.8f, 0.2f, 3.8f}}, {{0, 1}}, {0.9f, 0.1f, 0.1f}, 2};
                return std::vector<Drawable>{squareTowards(camera, 0.8, -0.5, colour, overlay),
                                             {.id = "lines", .shape = lines}};
            }},
            overlay);
        for (const double azimuth : {20.0, 140.0}) {
            Camera camera = cameraAround(scene.bounds, perspective);
            camera.azimuth = azimuth;
            const auto picture = [&](RenderBackend& backend) {
                auto drawn = backend.render(scene, camera, usual);
                if (!drawn)
                    qFatal("%s", drawn.error().text().c_str());
                return *std::move(drawn);
            };
            const Picture cpu = picture(*cpu_);
            if (gl_) {
                const Picture gl = picture(*gl_);
                QVERIFY(samePicture(cpu, gl, picture(*gl_), "gl_custom", 3));
            }
            const auto middle = pixelAt(cpu, usual.width / 2 + 1, usual.height / 2 + 1);
            const std::array<std::uint8_t, 4> pure{toByte(0.2f), toByte(0.4f), toByte(0.9f), 255};
            if (overlay)
                QVERIFY(difference(middle, pure) <= 1); // over the fog before it
            else
                QVERIFY(difference(middle, pure) > 20); // through it
        }
        QCOMPARE(calls, gl_ ? 6 : 2);
    }

    /// Later ones over earlier ones, whatever their places.
    void overlaysLieInTheirOrder()
    {
        const Camera camera = cameraAround(fogCube(0.3f).bounds, true);
        const Drawable far = squareTowards(camera, 0.8, -1.5, {1, 0, 0}, true);
        Drawable near = squareTowards(camera, 0.8, 1.5, {0, 0, 1}, true);
        near.id = "near";
        for (const bool farIsLast : {false, true}) {
            Scene scene = fogCube(0.3f);
            scene.drawables.push_back(farIsLast ? near : far);
            scene.drawables.push_back(farIsLast ? far : near);
            for (RenderBackend* backend : backends()) {
                const auto picture = backend->render(scene, camera, usual);
                QVERIFY(picture.ok());
                QCOMPARE(pixelAt(*picture, usual.width / 2, usual.height / 2)[0], farIsLast ? 255 : 0);
            }
        }
    }

    void whatItThrowsIsAnError()
    {
        const Scene scene = sceneWith(
            {[](const Camera&, int, int) -> std::vector<Drawable> { throw std::runtime_error("no arrows"); }}, false);
        QVERIFY(!backends().empty());
        for (RenderBackend* backend : backends()) {
            const auto picture = backend->render(scene, {}, usual);
            QVERIFY(!picture && picture.error().text().find("no arrows") != std::string::npos);
        }
    }
};

QTEST_GUILESS_MAIN(CustomDrawableTest)
#include "custom_drawable_test.moc"
