// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of the CPU back end (B4), the reference, against closed forms.
#include "core/render/resolve.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/picture_check.h"
#include "tests/render/scenes.h"

#include <tan/render.h>

#include <QTest>

#include <atomic>
#include <cmath>
#include <functional>
#include <limits>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

using Pixel = std::array<std::uint8_t, 4>;

/// Looks along +y at the origin.
const Camera fromFront{.target = {0, 0, 0}, .distance = 5, .azimuth = 0, .elevation = 0};

Pixel toPixel(const Colour& colour)
{
    const auto byte = [](float channel) { return static_cast<std::uint8_t>(std::lround(channel * 255)); };
    return {byte(colour.red), byte(colour.green), byte(colour.blue), 255};
}

Colour mixed(const Colour& front, float opacity, const Colour& back)
{
    return {front.red * opacity + back.red * (1 - opacity), front.green * opacity + back.green * (1 - opacity),
            front.blue * opacity + back.blue * (1 - opacity)};
}

/// Checks every pixel for which `expected` gives one.
bool everyPixel(const Picture& picture, int tolerance, const std::function<std::optional<Pixel>(int, int)>& expected)
{
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const auto wanted = expected(x, y);
            if (!wanted || difference(*wanted, pixelAt(picture, x, y)) <= tolerance)
                continue;
            const Pixel& actual = pixelAt(picture, x, y);
            qWarning("pixel (%d, %d) is %d %d %d %d, not %d %d %d %d; the picture: %s", x, y, actual[0], actual[1],
                     actual[2], actual[3], (*wanted)[0], (*wanted)[1], (*wanted)[2], (*wanted)[3],
                     qPrintable(savePicture(picture, QTest::currentTestFunction())));
            return false;
        }
    return true;
}

} // namespace

class CpuPictureTest : public QObject {
    Q_OBJECT

private slots:
    /// The least by which half of the samples have lost half of their light: of an even number the lower one in the
    /// middle.
    void depthIsTheLowerMedianOfItsSamples()
    {
        constexpr float none = std::numeric_limits<float>::infinity();
        const auto depthsOf = [](std::vector<float> samples, int rowLength, int samplesPerAxis) {
            Picture picture{rowLength / samplesPerAxis, 1, {}};
            picture.depth.resize(static_cast<std::size_t>(picture.width));
            resolveDepth(samples, rowLength, samplesPerAxis, 0, 0, picture);
            return picture.depth;
        };
        QCOMPARE(depthsOf({3, 1, none}, 3, 1), (std::vector<float>{3, 1, none}));
        QCOMPARE(depthsOf({4, 2, none, 5, 3, 1, none, none}, 4, 2), (std::vector<float>{2, none}));
        QCOMPARE(depthsOf({none, 7, 8, none}, 2, 2), (std::vector<float>{8}));
        std::vector<float> sixteen(16);
        for (std::size_t i = 0; i < sixteen.size(); ++i)
            sixteen[i] = static_cast<float>(i * 7 % 16);
        QCOMPARE(depthsOf(sixteen, 4, 4), (std::vector<float>{7}));
        sixteen.resize(9);
        std::ranges::sort(sixteen);
        QCOMPARE(depthsOf(sixteen, 3, 3), (std::vector<float>{sixteen[4]}));
    }

    /// However many translucent layers there are, all of them count.
    void manyTranslucentLayersAddUp()
    {
        constexpr int sheets = 12;
        constexpr float opacity = 0.3f;
        const Colour colour{0.8f, 0.6f, 0.4f};
        SceneParts scene{{}, {}, cube(1)};
        for (int sheet = 0; sheet < sheets; ++sheet)
            scene.surfaces.push_back(
                {quad({-2, -0.9f + 0.15f * static_cast<float>(sheet), -2}, {4, 0, 0}, {0, 0, 4}), colour, opacity});
        const PictureOptions options{.width = 9, .height = 9, .background = {0, 0, 0}, .samplesPerAxis = 1};
        const float hidden = 1 - std::pow(1 - opacity, float(sheets)); // 0.986
        const Pixel expected = toPixel(mixed(facing(colour), hidden, options.background));
        QVERIFY(difference(pixelAt(renderedByCpu(scene, fromFront, options), 4, 4), expected) <= 1);
    }

    void sphereIsLitByTheFormula_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::newRow("perspective") << true;
        QTest::newRow("orthographic") << false;
    }
    /// Every pixel well inside a sphere against the ray that meets it. Tolerance 2: the facets' normals are
    /// interpolated.
    void sphereIsLitByTheFormula()
    {
        QFETCH(bool, perspective);
        const Colour colour{0.9f, 0.5f, 0.1f};
        SceneParts scene{{{sphere({0, 0, 0}, 1), colour, 1}}, {}, cube(1)};
        Camera camera{.target = {0.1, 0, 0.05}, .distance = 4, .perspective = perspective};
        const PictureOptions options{.width = 230, .height = 171, .samplesPerAxis = 1};
        const Picture picture = renderedByCpu(scene, camera, options);

        const Eigen::Matrix4d inverse =
            (projectionMatrix(camera, 230.0 / 171, scene.bounds) * viewMatrix(camera)).inverse();
        int lit = 0;
        QVERIFY(everyPixel(picture, 2, [&](int x, int y) -> std::optional<Pixel> {
            const Eigen::Vector2d place((x + 0.5) / 230 * 2 - 1, 1 - (y + 0.5) / 171 * 2);
            const Vector3d from = (inverse * Eigen::Vector4d(place.x(), place.y(), -1, 1)).hnormalized();
            const Vector3d to = (inverse * Eigen::Vector4d(place.x(), place.y(), 1, 1)).hnormalized();
            const Vector3d ray = (to - from).normalized();
            const double middle = -from.dot(ray);
            const double distance = (from + middle * ray).norm();
            if (distance > 1.01)
                return Pixel{255, 255, 255, 255};
            if (distance > 0.98)
                return std::nullopt;
            ++lit;
            const Vector3d normal = from + (middle - std::sqrt(1 - distance * distance)) * ray;
            const Vector3d inCamera = viewMatrix(camera).topLeftCorner<3, 3>() * normal;
            const double cosine = std::abs(normal.dot(ray)), front = std::min(1.0, 0.5 + 2 * cosine);
            const auto along = [&](double right, double up, double back) {
                const double falling = inCamera.dot(Vector3d(right, up, back));
                return falling > 0 ? front * falling : (front - 1) * falling;
            };
            const double factor = 0.08 + 0.52 * cosine + 0.45 * along(-96.0 / 169, 72.0 / 169, 119.0 / 169) +
                                  0.1 * along(0.8, -0.36, 0.48) + 0.1 * along(0.36, 0.8, -0.48);
            const double highlight = 0.18 * std::pow(std::max(0.0, inCamera.dot(Vector3d(-4, 3, 12) / 13)), 32);
            const auto channel = [&](float of) { return static_cast<float>(std::min(1.0, of * factor + highlight)); };
            return toPixel(Colour{channel(colour.red), channel(colour.green), channel(colour.blue)});
        }));
        QVERIFY(lit > 5000);
    }

    /// Five layers in a mixed order, each over all that lie behind it. Tolerance 1: rounding.
    void translucentLayersBlendInDepthOrder()
    {
        const std::array<float, 5> depths = {0.3f, -0.8f, 0.9f, 0.0f, -0.4f};
        const std::array<float, 5> opacities = {0.5f, 0.3f, 1.0f, 0.7f, 0.2f};
        const std::array<Colour, 5> colours = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}}};
        SceneParts scene{{}, {}, cube(1)};
        for (std::size_t i = 0; i < depths.size(); ++i)
            scene.surfaces.push_back({quad({-9, depths[i], -9}, {18, 0, 0}, {0, 0, 18}), colours[i], opacities[i]});
        Camera camera = fromFront;
        camera.perspective = false; // the same light everywhere: c = 1
        const Picture picture = renderedByCpu(scene, camera, {.width = 70, .height = 70});
        Colour expected{1, 1, 1};
        for (const std::size_t i : {2, 0, 3, 4, 1}) // from the farthest
            expected = mixed(facing(colours[i]), opacities[i], expected);
        QVERIFY(everyPixel(picture, 1, [&](int, int) { return toPixel(expected); }));
    }

    /// Two translucent planes that cross: the order changes inside each of them.
    void crossingPlanesChangeOrder()
    {
        SceneParts scene{{}, {}, cube(2)};
        scene.surfaces.push_back({quad({-6, -3, -6}, {12, 6, 0}, {0, 0, 12}), {1, 0, 0}, 0.6f});
        scene.surfaces.push_back({quad({-6, 3, -6}, {12, -6, 0}, {0, 0, 12}), {0, 0, 1}, 0.6f});
        Camera camera = fromFront;
        camera.perspective = false;
        const Picture picture = renderedByCpu(scene, camera, {.width = 100, .height = 50, .samplesPerAxis = 1});
        // The planes are inclined by 1 : 2, the red one to the right and the blue one to the left.
        const float sine = std::sqrt(0.2f), cosine = std::sqrt(0.8f);
        const Colour red = shaded({1, 0, 0}, lightOn(sine, 0.0f, cosine, cosine));
        const Colour blue = shaded({0, 0, 1}, lightOn(-sine, 0.0f, cosine, cosine));
        const Pixel left = toPixel(mixed(red, 0.6f, mixed(blue, 0.6f, {1, 1, 1})));
        const Pixel right = toPixel(mixed(blue, 0.6f, mixed(red, 0.6f, {1, 1, 1})));
        QVERIFY(everyPixel(picture, 1, [&](int x, int) { return x < 50 ? left : right; }));
    }

    void coverageIsExactlyOne_data()
    {
        QTest::addColumn<int>("samples");
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("elevation");
        QTest::newRow("whole sheet, 1 sample") << 1 << 3.0 << 0.0;
        QTest::newRow("whole sheet, 3 samples") << 3 << 3.0 << 0.0;
        QTest::newRow("beyond the picture") << 2 << 0.5 << 0.0;
        QTest::newRow("inclined") << 1 << 1.2 << 70.0;
        QTest::newRow("through the eye") << 1 << 0.02 << 89.0;
        QTest::newRow("far beyond the guard band") << 2 << 0.001 << 30.0;
    }
    /// A sheet of random triangles of opacity 1/2: each sample is covered once, so alpha is 1/2, neither 0 (a gap) nor
    /// 3/4 (an overlap).
    void coverageIsExactlyOne()
    {
        QFETCH(int, samples);
        QFETCH(double, distance);
        QFETCH(double, elevation);
        for (unsigned seed = 0; seed < 4; ++seed) {
            SceneParts scene{{{crumpledSheet(40, seed), {0, 0, 0}, 0.5f}}, {}, cube(1)};
            Camera camera = fromFront;
            camera.target = {0.013, 0, -0.007};
            camera.distance = distance;
            camera.elevation = elevation;
            camera.fieldOfView = 25;
            const PictureOptions options{
                .width = 131, .height = 97, .transparentBackground = true, .samplesPerAxis = samples};
            const Picture picture = renderedByCpu(scene, camera, options);
            const Eigen::Matrix4d view = projectionMatrix(camera, 131.0 / 97, scene.bounds) * viewMatrix(camera);
            const Eigen::Matrix4d inverse = view.inverse();
            int covered = 0;
            const bool right = everyPixel(picture, 0, [&](int x, int y) -> std::optional<Pixel> {
                const Eigen::Vector2d place((x + 0.5) / 131 * 2 - 1, 1 - (y + 0.5) / 97 * 2);
                const Vector3d from = (inverse * Eigen::Vector4d(place.x(), place.y(), -1, 1)).hnormalized();
                const Vector3d to = (inverse * Eigen::Vector4d(place.x(), place.y(), 1, 1)).hnormalized();
                const double fraction = from.y() / (from.y() - to.y());
                const Vector3d hit = from + fraction * (to - from);
                const double pixel = 0.05 * (hit - eyePosition(camera)).norm() / std::cos(elevation * 0.01745);
                const double edge = 1 - std::max(std::abs(hit.x()), std::abs(hit.z()));
                if (!(fraction > 5e-5 && fraction < 0.999) || std::abs(edge) < std::min(pixel, 0.2))
                    return std::nullopt; // at the sheet's border or at the near plane
                covered += edge > 0 ? 1 : 0;
                return edge > 0 ? Pixel{0, 0, 0, 128} : Pixel{0, 0, 0, 0};
            });
            QVERIFY(right);
            QVERIFY(covered > 1000);
        }
    }

    /// From inside a closed surface there is no way out: the near plane opens no hole, clipping no crack.
    void eyeInsideSeesNoBackground()
    {
        SceneParts scene{{{sphere({0, 0, 0}, 1, 40), {0, 0.5f, 1}, 1}}, {}, cube(1)};
        for (const double field : {30.0, 140.0})
            for (int turn = 0; turn < 5; ++turn) {
                Camera camera{.target = {0.2, 0, 0.1}, .distance = 0.5, .fieldOfView = field};
                camera = turned(camera, turn * 70, turn * 17 - 50);
                const Picture picture =
                    renderedByCpu(scene, camera, {.width = 90, .height = 60, .background = {1, 0, 0}});
                for (const Pixel& pixel : picture.pixels)
                    QVERIFY(pixel[0] < 60);
            }
    }

    /// The outline of a cube before, behind and inside things.
    void linesHideAndAreHidden()
    {
        SceneParts scene{{}, {boxOutline(cube(1), {1, 0, 0}, 3)}, cube(3)};
        Camera camera = fromFront;
        camera.perspective = false;
        camera.distance = 3 / (2 * std::tan(15 * std::numbers::pi / 180)); // 3 units high, 100 pixels: 33.3 a unit
        const PictureOptions options{.width = 100, .height = 100, .samplesPerAxis = 1};
        const Pixel white{255, 255, 255, 255};
        const Pixel red{255, 0, 0, 255};

        Picture picture = renderedByCpu(scene, camera, options);
        QCOMPARE(pixelAt(picture, 50, 50), white);
        for (const int place : {16, 83}) {
            QCOMPARE(pixelAt(picture, place, 50), red);
            QCOMPARE(pixelAt(picture, 50, place), red);
            QCOMPARE(pixelAt(picture, place, place), red); // the corner is closed
        }
        int wide = 0;
        for (int x = 0; x < 50; ++x)
            wide += pixelAt(picture, x, 50) == red ? 1 : 0;
        QCOMPARE(wide, 3);

        const Colour green{0, 1, 0};
        scene.surfaces.push_back({quad({-2, -2, -2}, {2, 0, 0}, {0, 0, 4}), green, 1});      // left, before
        scene.surfaces.push_back({quad({0, 2, -2}, {2, 0, 0}, {0, 0, 4}), {0, 0, 1}, 1});    // right, behind
        scene.surfaces.push_back({quad({-2, -2.5, -2}, {4, 0, 0}, {0, 0, 2}), green, 0.5f}); // below, before all
        picture = renderedByCpu(scene, camera, options);
        QCOMPARE(pixelAt(picture, 16, 30), toPixel(facing(green)));
        QCOMPARE(pixelAt(picture, 83, 30), red);
        QVERIFY(difference(pixelAt(picture, 83, 60), toPixel(mixed(facing(green), 0.5f, {1, 0, 0}))) <= 1);
    }

    void antialiasingIsTheMeanOfTheSamples()
    {
        // The quad ends a quarter of a pixel into column 10: of 2 x 2 samples, one column.
        Camera camera = fromFront;
        camera.perspective = false;
        camera.distance = 1 / (2 * std::tan(15 * std::numbers::pi / 180)); // 1 unit high, 20 pixels
        SceneParts scene{{{quad({-1, 0, -1}, {1 + 0.5f / 20, 0, 0}, {0, 0, 2}), {0, 0, 0}, 1}}, {}, cube(1)};
        const Picture picture = renderedByCpu(
            scene, camera, {.width = 20, .height = 20, .transparentBackground = true, .samplesPerAxis = 2});
        QCOMPARE(int(pixelAt(picture, 9, 9)[3]), 255);
        QCOMPARE(int(pixelAt(picture, 10, 9)[3]), 128);
        QCOMPARE(int(pixelAt(picture, 11, 9)[3]), 0);
    }

    void everySizeIsTheSamePicture_data()
    {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const auto& [width, height] : {std::pair{1, 1}, {3, 200}, {200, 3}, {64, 64}, {65, 31}, {129, 127}})
            QTest::addRow("%dx%d", width, height) << width << height;
    }
    /// Tiles leave no seams: a sheet over everything is one colour at any size and number of samples.
    void everySizeIsTheSamePicture()
    {
        QFETCH(int, width);
        QFETCH(int, height);
        Camera camera = fromFront;
        camera.perspective = false;
        const Colour colour{0.2f, 0.4f, 0.6f};
        const SceneParts scene{{{quad({-900, 0, -900}, {1800, 0, 0}, {0, 0, 1800}), colour, 1}}, {}, cube(1)};
        for (int samples = 1; samples <= 4; ++samples) {
            const Picture picture =
                renderedByCpu(scene, camera, {.width = width, .height = height, .samplesPerAxis = samples});
            QCOMPARE(picture.pixels.size(), std::size_t(width) * std::size_t(height));
            QVERIFY(everyPixel(picture, 1, [&](int, int) { return toPixel(facing(colour)); }));
        }
    }

    void sameWithAnyNumberOfThreads()
    {
        const SceneParts scene{{{sphere({0, 0, 0}, 1, 60), {0.3f, 0.6f, 0.9f}, 0.4f},
                                {sphere({0.4f, 0, 0}, 0.8f, 50), {0.9f, 0.6f, 0.3f}, 0.6f},
                                {sphere({0, 0, 0}, 1, 60), {1, 0, 0}, 0.5f}}, // again in the same place: ties by order
                               {boxOutline(cube(1), {0, 0, 0}, 2)},
                               cube(1)};
        const Camera camera = fitted({}, scene.bounds);
        const Picture one = renderedByCpu(scene, camera, {.width = 300, .height = 200, .threads = 1});
        for (const int threads : {0, 2, 7})
            QVERIFY(renderedByCpu(scene, camera, {.width = 300, .height = 200, .threads = threads}).pixels ==
                    one.pixels);
    }

    void emptySceneIsBackground()
    {
        const PictureOptions options{.width = 5, .height = 4, .background = {0, 1, 0}};
        for (const Pixel& pixel : renderedByCpu({}, {}, options).pixels)
            QCOMPARE(pixel, (Pixel{0, 255, 0, 255}));
        const PictureOptions transparent{.width = 5, .height = 4, .transparentBackground = true};
        for (const Pixel& pixel : renderedByCpu({}, {}, transparent).pixels)
            QCOMPARE(pixel, (Pixel{0, 0, 0, 0}));
    }

    void badScenesAreErrors()
    {
        const auto backend = makeCpuBackend();
        const auto errorOf = [&](const SceneParts& scene, const PictureOptions& options) {
            const auto picture = backend->render(scene, fromFront, options);
            return picture ? std::string() : picture.error().text();
        };
        for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {1 << 20, 10}})
            QVERIFY(errorOf({}, {.width = width, .height = height}).find("pixels") != std::string::npos);
        QVERIFY(!errorOf({}, {.samplesPerAxis = 0}).empty());
        QVERIFY(!errorOf({}, {.threads = -1}).empty());

        auto mesh = std::make_shared<TriangleMesh>(*quad({0, 0, 0}, {1, 0, 0}, {0, 0, 1}));
        mesh->triangles.push_back({0, 1, 4});
        QVERIFY(errorOf({{{mesh, {}, 1}}, {}, cube(1)}, {}).find("corner") != std::string::npos);
        mesh->triangles.pop_back();
        mesh->normals.pop_back();
        QVERIFY(errorOf({{{mesh, {}, 1}}, {}, cube(1)}, {}).find("normal") != std::string::npos);
        LineSet line{{Vector3d(0, 0, 0)}, {{0, 1}}, {}, 1};
        QVERIFY(errorOf({{}, {line}, cube(1)}, {}).find("line") != std::string::npos);
    }

    /// What cannot be placed is left out, and nothing else with it.
    void notFiniteCoordinatesAreLeftOut()
    {
        auto mesh = std::make_shared<TriangleMesh>(*quad({-9, 0, -9}, {18, 0, 0}, {0, 0, 18}));
        for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
            mesh->positions.emplace_back(bad, 0.0f, 0.0f);
            mesh->normals.emplace_back(bad, bad, bad);
            mesh->triangles.push_back({0, 1, static_cast<std::uint32_t>(mesh->positions.size() - 1)});
        }
        const SceneParts scene{{{mesh, {0, 0, 0}, 1}, {nullptr, {}, 1}, {mesh, {1, 0, 0}, 0}}, {}, cube(1)};
        Camera camera = fromFront;
        camera.perspective = false;
        const Picture picture = renderedByCpu(scene, camera, {.width = 20, .height = 20});
        QVERIFY(everyPixel(picture, 1, [](int, int) { return toPixel(facing({0, 0, 0})); }));
    }

    void reportsAndCancels()
    {
        const SceneParts scene{{{sphere({0, 0, 0}, 1, 30), {1, 0, 0}, 1}}, {}, cube(1)};
        std::stop_source stop;
        double last = 0;
        bool falls = false;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            falls |= fraction < last;
            last = fraction;
        });
        QVERIFY(makeCpuBackend()->render(scene, fromFront, {}, progress).ok());
        QCOMPARE(last, 1.0);
        QVERIFY(!falls);

        std::atomic<int> reports = 0;
        const Progress stopping(stop.get_token(), [&](double fraction, const Message&) {
            ++reports;
            if (fraction > 0.3)
                stop.request_stop();
        });
        QCOMPARE(makeCpuBackend()->render(scene, fromFront, {}, stopping).error().kind, ErrorKind::Cancelled);
        QVERIFY(reports < 200); // of 768 tiles
    }
};

QTEST_GUILESS_MAIN(CpuPictureTest)
#include "cpu_picture_test.moc"
