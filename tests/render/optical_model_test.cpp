// SPDX-License-Identifier: GPL-3.0-or-later
// Optical models of one's own on the CPU: against what is known in closed form of a field that is linear, and against
// the built-in one.
#include "core/render/picking/picking.h"
#include "tests/core/render/scene_parts.h"
#include "tests/render/picture_check.h"
#include "tests/render/volume_scenes.h"

#include <QTest>

#include <atomic>
#include <cmath>
#include <stdexcept>

using namespace tetra;
using namespace tetra::testing;

namespace {

constexpr double side = 4;
const PictureOptions usual{.width = 48, .height = 40, .background = {0, 0, 0}, .samplesPerAxis = 1};

double linearField(const Eigen::Vector3d& place)
{
    return 0.5 * place.x() + 0.25 * place.y() + 0.125 * place.z();
}

constexpr double largestValue = 0.875 * side;

/// A cube of that field, all of which counts.
SceneParts linearCube(std::shared_ptr<const OpticalModel> model)
{
    SceneParts scene =
        volumeScene(latticeMesh(3, side, Split::Five, linearField), transferFunctionFromPoints({{0, {1, 1, 1}, 0.5f}}));
    scene.volume->model = std::move(model);
    return scene;
}

Picture rendered(const SceneParts& scene, const Camera& camera, const PictureOptions& options = usual)
{
    return renderedByCpu(scene, camera, options);
}

std::shared_ptr<const TriangleMesh> wallAt(double y)
{
    TriangleMesh wall;
    const auto depth = static_cast<float>(y);
    wall.positions = {{-9, depth, -9}, {20, depth, -9}, {-9, depth, 20}};
    wall.normals.assign(3, Eigen::Vector3f::Zero());
    wall.triangles = {{0, 1, 2}};
    return std::make_shared<const TriangleMesh>(std::move(wall));
}

/// Emission and absorption of one colour and extinction, as somebody else would write it.
std::shared_ptr<const OpticalModel> fog(const Colour& colour, double extinction)
{
    OpticalModel model;
    model.evaluate = [colour, extinction](const OpticalPieces& pieces) {
        for (std::size_t i = 0; i < pieces.count; ++i) {
            pieces.transmittance[i] = static_cast<float>(std::exp(-extinction * pieces.length[i]));
            const float opacity = 1 - pieces.transmittance[i];
            pieces.red[i] = colour.red * opacity;
            pieces.green[i] = colour.green * opacity;
            pieces.blue[i] = colour.blue * opacity;
        }
    };
    model.shader = "vec4 lightOfPiece(float entry, float exit, float way, float gradient) { return vec4(0.0); }";
    return std::make_shared<const OpticalModel>(model);
}

} // namespace

class OpticalModelTest : public QObject {
    Q_OBJECT

private slots:
    /// Along y, through the middle of each pixel, as far as the cube or a plane lets it.
    void maximumAndSumAreExact_data()
    {
        QTest::addColumn<bool>("isSum");
        QTest::addColumn<double>("end");
        for (const bool isSum : {false, true})
            for (const double end : {side, 2.5})
                QTest::addRow("%s to %g", isSum ? "sum" : "maximum", end) << isSum << end;
    }
    void maximumAndSumAreExact()
    {
        QFETCH(bool, isSum);
        QFETCH(double, end);
        constexpr double opaqueLength = 6;
        const Colour colour{1, 0.5f, 0.25f};
        SceneParts scene =
            linearCube(isSum ? xRay(0, largestValue, opaqueLength, colour) : maximumIntensity(0, largestValue, colour));
        if (end < side)
            scene.surfaces.push_back({.mesh = wallAt(end), .colour = {0, 0, 0}, .lit = false}); // as what is behind
        const Camera camera = beforeCube();
        const Picture picture = rendered(scene, camera);
        int drawn = 0;
        for (int y = 0; y < usual.height; ++y)
            for (int x = 0; x < usual.width; ++x) {
                const double perPixel =
                    2 * camera.distance * std::tan(camera.fieldOfView / 2 * M_PI / 180) / usual.height;
                const Eigen::Vector3d place(2 + (x + 0.5 - usual.width / 2.0) * perPixel, 0,
                                            2 - (y + 0.5 - usual.height / 2.0) * perPixel);
                const double margin = 0.6 * perPixel; // rays lie a little beside the middle
                if (std::min(place.x(), place.z()) < margin || std::max(place.x(), place.z()) > side - margin)
                    continue;
                ++drawn;
                const double first = linearField(place), last = linearField({place.x(), end, place.z()});
                const double opacity = isSum ? (first + last) / 2 / largestValue * end / opaqueLength
                                             : std::max(first, last) / largestValue;
                const auto pixel = pixelAt(picture, x, y);
                // A pixel's ray is somewhere in it: what the field rises by from one to the next may be off.
                const double slack = 2 + 255 * 0.75 * perPixel / largestValue;
                QVERIFY2(std::abs(pixel[0] - 255 * opacity) < slack,
                         qPrintable(QString("%1, %2: %3, not %4").arg(x).arg(y).arg(pixel[0]).arg(255 * opacity)));
                QVERIFY(std::abs(pixel[1] - pixel[0] * 0.5) <= 1 && std::abs(pixel[2] - pixel[0] * 0.25) <= 1);
            }
        QVERIFY(drawn > 300);
    }

    void sumsEndAtOne()
    {
        const Picture picture =
            rendered(linearCube(xRay(0, 0.001, 0.01, {1, 1, 1})), beforeCube(), {.width = 20, .height = 20});
        QCOMPARE(pixelAt(picture, 10, 10), (std::array<std::uint8_t, 4>{255, 255, 255, 255}));
    }

    /// Light, depth, surfaces in the volume and clip planes are those of the kernel that everybody else uses.
    void oneOverTheOtherIsAsBuiltIn_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<bool>("wholeCells");
        for (const bool perspective : {false, true})
            for (const bool wholeCells : {false, true})
                QTest::addRow("%s%s", perspective ? "perspective" : "orthographic", wholeCells ? ", whole cells" : "")
                    << perspective << wholeCells;
    }
    void oneOverTheOtherIsAsBuiltIn()
    {
        QFETCH(bool, perspective);
        QFETCH(bool, wholeCells);
        SceneParts scene = linearCube(nullptr);
        scene.volume = volumeOf(scene.volume->mesh, transferFunctionFromPoints({{0, {1, 0.5f, 0}, 0.4f}}));
        scene.wholeCells = wholeCells;
        addLayer(scene, 0.9, {0, 0.8f, 0.2f}, 0.5f);
        addLayer(scene, 2.2, {0.1f, 0.2f, 0.9f}, 1);
        scene.clipPlanes = {{{0, 0, -1}, -3.3}};
        const Camera camera = cameraAround(scene.bounds, perspective);
        PictureOptions options = usual;
        options.depth = true;
        const Picture expected = rendered(scene, camera, options);
        scene.volume->model = fog({1, 0.5f, 0}, extinctionOf(0.4, 1));
        const Picture picture = rendered(scene, camera, options);
        QVERIFY(!picture.pixels.empty());
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            QVERIFY2(difference(picture.pixels[i], expected.pixels[i]) <= 1, qPrintable(QString::number(i)));
            QVERIFY(std::abs(picture.depth[i] - expected.depth[i]) < 1e-3 || picture.depth[i] == expected.depth[i]);
        }
    }

    /// What is combined otherwise lies before translucent surfaces, and opaque ones end it.
    void translucentSurfacesLieBehindAMaximum()
    {
        SceneParts scene = linearCube(maximumIntensity(0, largestValue, {1, 1, 1}));
        const Picture alone = rendered(scene, beforeCube());
        scene.surfaces.push_back({.mesh = wallAt(1), .colour = {1, 0, 0}, .opacity = 0.5f, .lit = false});
        const Picture picture = rendered(scene, beforeCube());
        const int x = usual.width / 2, y = usual.height / 2;
        const float before = pixelAt(alone, x, y)[0] / 255.0f;
        QVERIFY(before > 0.3f && before < 0.9f);
        QVERIFY(std::abs(pixelAt(picture, x, y)[0] - 255 * (before + (1 - before) * 0.5f)) <= 2);
        QVERIFY(std::abs(pixelAt(picture, x, y)[1] - 255 * before) <= 2);
    }

    void gradientsAndLengthsAreThoseOfTheData()
    {
        OpticalModel model;
        std::atomic<int> wrong = 0, seen = 0;
        model.combiner = Combiner::Sum;
        model.evaluate = [&](const OpticalPieces& pieces) {
            const double expected = Eigen::Vector3d(0.5, 0.25, 0.125).norm();
            for (std::size_t i = 0; i < pieces.count; ++i) {
                pieces.red[i] = pieces.green[i] = pieces.blue[i] = 0;
                pieces.transmittance[i] = 1;
                if (!(pieces.length[i] > 0))
                    continue;
                ++seen;
                const double rise = std::abs(pieces.exit[i] - pieces.entry[i]);
                if (std::abs(pieces.gradient[i] - expected) > 1e-4 * expected ||
                    rise > pieces.length[i] * expected + 1e-3)
                    ++wrong;
            }
        };
        model.shader = "none";
        rendered(linearCube(std::make_shared<const OpticalModel>(model)),
                 cameraAround({Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(side, side, side)}, true));
        QVERIFY(seen > 1000);
        QCOMPARE(wrong.load(), 0);
    }

    void picksTellTheValueThatIsSeen()
    {
        PickingRay line;
        line.origin = {1, -10, 2};
        line.direction = {0, 1, 0};
        auto seen = seenPlace(linearCube(maximumIntensity(0, largestValue, {1, 1, 1})), line);
        QVERIFY(seen && seen->drawable.starts_with("volume"));
        QVERIFY(std::abs(*seen->value - linearField({1, side, 2})) < 1e-4);
        QVERIFY(std::abs(seen->place.y() - side) < 1e-4);
        QVERIFY(std::abs(seen->share - *seen->value / largestValue) < 1e-4);
        seen = seenPlace(linearCube(fog({1, 1, 1}, 0.7)), line);
        QVERIFY(seen && std::abs(seen->share - (1 - std::exp(-0.7 * side))) < 1e-4);
        QVERIFY(std::abs(*seen->value - linearField(seen->place)) < 1e-4);
        QVERIFY(seen->place.y() < 1.5); // what is first takes most
    }

    void mistakesAreErrors()
    {
        OpticalModel broken;
        broken.shader = "none";
        const auto errorOf = [](const OpticalModel& model) {
            return makeCpuBackend()
                ->render(linearCube(std::make_shared<const OpticalModel>(model)), beforeCube(), usual)
                .error()
                .text();
        };
        QVERIFY(errorOf(broken).find("lacks its function") != std::string::npos);
        broken.evaluate = [](const OpticalPieces&) { throw std::runtime_error("no light"); };
        QVERIFY(errorOf(broken).find("no light") != std::string::npos);
        Scene made = linearCube(std::make_shared<const OpticalModel>(broken));
        made.maker = "example.fog";
        const auto blamed = makeCpuBackend()->render(made, beforeCube(), usual);
        QVERIFY(!blamed && blamed.error().text().starts_with("The plugin 'example.fog' failed: no light."));
        // What is no number is nothing.
        broken.evaluate = [](const OpticalPieces& pieces) {
            for (std::size_t i = 0; i < pieces.count; ++i)
                pieces.red[i] = pieces.green[i] = pieces.blue[i] = pieces.transmittance[i] = NAN;
        };
        const Picture picture = rendered(linearCube(std::make_shared<const OpticalModel>(broken)), beforeCube());
        QCOMPARE(pixelAt(picture, usual.width / 2, usual.height / 2), (std::array<std::uint8_t, 4>{0, 0, 0, 255}));

        SceneParts two = linearCube(nullptr);
        Scene scene = two;
        scene.drawables.push_back({.id = "another", .shape = *two.volume});
        QVERIFY(makeCpuBackend()->render(scene, beforeCube(), usual).error().text().find("has 2") != std::string::npos);
        two.focus = FinePart{*two.volume, Sphere{{2, 2, 2}, 1}, 0.5};
        two.volume->model = fog({1, 1, 1}, 1);
        QVERIFY(!makeCpuBackend()->render(two, beforeCube(), usual).ok());
    }
};

QTEST_GUILESS_MAIN(OpticalModelTest)
#include "optical_model_test.moc"
