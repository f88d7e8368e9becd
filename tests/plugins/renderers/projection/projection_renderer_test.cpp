// SPDX-License-Identifier: GPL-3.0-or-later
// The renderer of projections: the largest and the smallest value of each ray in its colour, against closed forms, by
// both back ends alike (B4), and picked where it is.
#include "core/render/picking/picking.h"
#include "tests/core/render/scene_parts.h"
#include "tests/lacks.h"
#include "tests/plugins/renderers/renderer_fixture.h"
#include "tests/render/same_picture.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <cmath>
#include <utility>

using namespace tetra;
using namespace tetra::testing;

namespace {

/// Linear in a cell: falls by half of its way along y to the middle of the cube, and rises again. In the middle a plane
/// of the lattice passes.
double valley(const Eigen::Vector3d& place)
{
    return 1 + place.x() / 2 + place.z() / 4 + std::abs(place.y() - 0.5);
}

double wavy(const Eigen::Vector3d& place)
{
    return 0.5 + 0.4 * std::sin(7 * place.x()) * std::cos(5 * place.y()) + 0.2 * place.z();
}

std::shared_ptr<const TetrahedralMesh> cubeOf(double (*field)(const Eigen::Vector3d&))
{
    return std::make_shared<const TetrahedralMesh>(latticeMesh(6, 1, Split::Six, field));
}

/// Neither lighter nor darker all along, with a step; some of the values are transparent, which changes nothing.
TransferFunction manyColours()
{
    TransferFunction function;
    function.colours = {{0.2, {0, 0, 1}}, {1.2, {1, 0, 0}}, {1.6, {0, 1, 0.5f}}, {1.6, {1, 1, 0}}, {2.2, {0, 0.2f, 0}}};
    function.opacities = {{1.2, 0}, {1.8, 0.4f}};
    return function;
}

Camera alongY()
{
    Camera camera = fitted({.azimuth = 0, .elevation = 0}, unitBox);
    camera.perspective = false;
    return camera;
}

constexpr int side = 48;
const PictureOptions oneSample{.width = side, .height = side, .background = {0.3f, 0.3f, 0.3f}, .samplesPerAxis = 1};

double pixelSize(const Camera& camera)
{
    return 2 * camera.distance * std::tan(camera.fieldOfView / 2 * M_PI / 180) / side;
}

Eigen::Vector3d placeOf(const Camera& camera, int column, int row)
{
    const double perPixel = pixelSize(camera);
    return {camera.target.x() + (column + 0.5 - side / 2.0) * perPixel, 0,
            camera.target.z() - (row + 0.5 - side / 2.0) * perPixel};
}

ParameterValues values(const char* projection, const TransferFunction& function)
{
    return {{"projection", std::string(projection)}, {"transfer", function}, {"outline", false}};
}

} // namespace

class ProjectionRendererTest : public QObject {
    Q_OBJECT

private slots:
    void parametersAreDescribed()
    {
        for (const auto& parameter : rendererNamed("projection").parameters({{-1, 3}, unitBox}))
            QVERIFY(!parameter.id.empty() && !parameter.label.empty() && !parameter.explanation.empty());
    }

    void onlyTheModelIsMadeAnew()
    {
        const auto session = open("projection", cubeOf(valley));
        const auto first = prepared(*session, values("maximum", manyColours()));
        const auto same = prepared(*session, values("maximum", manyColours()));
        const auto other = prepared(*session, values("minimum", manyColours()));
        QCOMPARE(partsOf(*same).volume->model, partsOf(*first).volume->model);
        QVERIFY(partsOf(*other).volume->model != partsOf(*first).volume->model);
        QCOMPARE(partsOf(*other).volume->mesh, partsOf(*first).volume->mesh);
        QCOMPARE(partsOf(*other).volume->transfer, partsOf(*first).volume->transfer);
    }

    /// The largest value of a ray is that at an end, the smallest one that in the middle.
    void coloursAreThoseOfTheValues_data()
    {
        QTest::addColumn<QByteArray>("projection");
        for (const char* projection : {"maximum", "minimum"})
            QTest::newRow(projection) << QByteArray(projection);
    }
    void coloursAreThoseOfTheValues()
    {
        QFETCH(QByteArray, projection);
        const bool isMaximum = projection == "maximum";
        const TransferFunction function = manyColours();
        const auto scene = prepared(*open("projection", cubeOf(valley)), values(projection.constData(), function));
        const Camera camera = alongY();
        const Picture picture = renderedByCpu(*scene, camera, oneSample);
        const double perPixel = pixelSize(camera);
        int compared = 0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const Eigen::Vector3d place = placeOf(camera, column, row);
                const double value = valley({place.x(), isMaximum ? 0 : 0.5, place.z()});
                const bool isInside =
                    std::min(place.x(), place.z()) > perPixel && std::max(place.x(), place.z()) < 1 - perPixel;
                if (!isInside || std::abs(value - 1.6) < perPixel)
                    continue;
                const auto colour = evaluateUnmasked(function, value).colour;
                constexpr double slack = 1.05; // rays lie a little beside the middle of pixels
                for (std::size_t channel = 0; channel < 3; ++channel)
                    QVERIFY2(std::abs(pixelAt(picture, column, row)[channel] - 255 * colour[channel]) <= slack,
                             QString("%1, %2: %3, not %4")
                                 .arg(column)
                                 .arg(row)
                                 .arg(pixelAt(picture, column, row)[channel])
                                 .arg(255 * colour[channel])
                                 .toUtf8());
                ++compared;
            }
        QVERIFY2(compared > side * side / 4, QByteArray::number(compared));
        const auto background = static_cast<std::uint8_t>(std::lround(0.3 * 255));
        QCOMPARE(pixelAt(picture, 0, 0), (std::array<std::uint8_t, 4>{background, background, background, 255}));
    }

    /// The least value of all is a colour, too, not the background.
    void theEndsOfTheRangeAreSeen()
    {
        for (const char* projection : {"maximum", "minimum"}) {
            const auto flat = std::make_shared<const TetrahedralMesh>(
                latticeMesh(2, 1, Split::Six, [](const Eigen::Vector3d&) { return 0.25; }));
            const TransferFunction red = transferFunctionFromPoints({{0.25, {1, 0, 0}, 0.5f}});
            const auto scene = prepared(*open("projection", flat), values(projection, red));
            const Picture picture = renderedByCpu(*scene, alongY(), oneSample);
            QCOMPARE(pixelAt(picture, side / 2, side / 2), (std::array<std::uint8_t, 4>{255, 0, 0, 255}));
        }
    }

    /// Ranges whose extent is no float, or no normal one: the shader has numbers, and each value its colour.
    void theLargestAndTheSmallestNumbers_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("largest");
        QTest::newRow("largest") << -3.3e38 << 3.3e38;
        QTest::newRow("large") << 1e38 << 3.4e38;
        QTest::newRow("small") << 0.0 << 8e-38;
        QTest::newRow("smallest") << 0.0 << 8e-41;
        QTest::newRow("usual") << -2.0 << 3.0;
    }
    void theLargestAndTheSmallestNumbers()
    {
        QFETCH(double, least);
        QFETCH(double, largest);
        const auto mesh = std::make_shared<const TetrahedralMesh>(latticeMesh(
            4, 1, Split::Six, [&](const Eigen::Vector3d& place) { return std::lerp(least, largest, place.z()); }));
        const TransferFunction grey = transferFunctionFromPoints({{least, {0, 0, 0}, 1}, {largest, {1, 1, 1}, 1}});
        for (const char* projection : {"maximum", "minimum"}) {
            const auto scene = prepared(*open("projection", mesh), values(projection, grey));
            const OpticalModel& model = *partsOf(*scene).volume->model;
            for (const std::string& text : {model.shader, model.rayShader})
                QVERIFY2(text.find("inf") == std::string::npos && text.find("nan") == std::string::npos, text.c_str());
            for (const double share : {0.0, 0.25, 0.5, 0.9, 1.0}) {
                const auto value = static_cast<float>(std::lerp(least, largest, share));
                const float length = 1, gradient = 0;
                float light = 0, through = 0;
                model.evaluate({1, &value, &value, &length, &gradient, &light, &light, &light, &through});
                const auto colour = model.lightOfRay(1 - through);
                QVERIFY2(std::abs(static_cast<double>(colour[0]) - share) < 1e-3,
                         QByteArray::number(static_cast<double>(colour[0])));
            }
        }
    }

    /// What is edited by hand is data of a program that OpenGL compiles once.
    void anotherFunctionIsTheSameShader()
    {
        const auto session = open("projection", cubeOf(wavy));
        const auto modelOf = [&](const char* projection, const TransferFunction& function) {
            return *partsOf(*prepared(*session, values(projection, function))).volume->model;
        };
        const TransferFunction red = transferFunctionFromPoints({{0, {1, 0, 0}, 1}});
        for (const char* projection : {"maximum", "minimum"}) {
            const OpticalModel one = modelOf(projection, manyColours()), other = modelOf(projection, red);
            QCOMPARE(one.shader, other.shader);
            QCOMPARE(one.rayShader, other.rayShader);
            QVERIFY(one.rayData != other.rayData);
        }
    }

    void valuesThatAreNoNumbersAreRefused()
    {
        const auto endless = std::make_shared<const TetrahedralMesh>(latticeMesh(
            2, 1, Split::Six, [](const Eigen::Vector3d& place) { return place.z() > 0.9 ? HUGE_VAL : place.z(); }));
        const auto scene = open("projection", endless)->prepare({values("maximum", manyColours())}, {});
        QVERIFY(!scene && scene.error().kind == ErrorKind::BadInput);
        QVERIFY2(scene.error().text().starts_with("Some values of the model are not finite"),
                 scene.error().text().c_str());
    }

    void whatIsClippedDoesNotCount()
    {
        ParameterValues clipped = values("minimum", manyColours());
        clipped["clip"] = std::string("0,-1,0,-0.25"); // shows y <= 0.25
        const auto scene = prepared(*open("projection", cubeOf(valley)), clipped);
        const auto seen = seenPlace(*scene, {{0.52, -3, 0.41}, {0, 1, 0}});
        QVERIFY(seen.has_value());
        QVERIFY(std::abs(*seen->value - valley({0.52, 0.25, 0.41})) < 1e-5);
    }

    void theValueIsPickedWhereItIs()
    {
        const auto session = open("projection", cubeOf(valley));
        const Eigen::Vector3d start(0.31, -2, 0.64);
        // Falls from y = 0 on, is least in the middle, and as large as before at the end.
        for (const char* projection : {"maximum", "minimum"}) {
            const auto scene = prepared(*session, values(projection, manyColours()));
            const auto seen = seenPlace(*scene, {start, {0, 1, 0}});
            QVERIFY(seen.has_value());
            QCOMPARE(seen->drawable, std::string("projection"));
            QVERIFY(seen->share == 1);
            const double y = seen->place.y();
            QVERIFY2(std::string(projection) == "minimum" ? std::abs(y - 0.5) < 1e-6
                                                          : std::min(std::abs(y), std::abs(y - 1)) < 1e-6,
                     QByteArray::number(y));
            QVERIFY(std::abs(*seen->value - valley(seen->place)) < 1e-5);
        }
        const auto beside = seenPlace(*prepared(*session, {}), {{3, -2, 0.5}, {0, 1, 0}});
        QVERIFY(!beside);
    }

    void bothBackEndsAlike()
    {
        auto backend = makeGlBackend();
        if (!backend) {
            noteLack("OpenGL");
            QSKIP(("skipped: " + backend.error().text()).c_str());
        }
        const auto cpu = makeCpuBackend();
        const auto session = open("projection", cubeOf(wavy));
        for (const char* projection : {"maximum", "minimum"}) {
            ParameterValues looks = values(projection, manyColours());
            Camera camera{.azimuth = 25, .elevation = 35};
            camera.perspective = std::string(projection) == "maximum";
            if (!camera.perspective)
                looks["clip"] = std::string("1,0.5,0,0.4");
            const auto scene = prepared(*session, looks);
            camera = fitted(camera, unitBox);
            PictureOptions options{.width = 60, .height = 50, .background = {0.2f, 0.3f, 0.1f}};
            const Picture ours = rendered(*cpu, *scene, camera, options);
            const Picture theirs = rendered(**backend, *scene, camera, options);
            options.width *= options.samplesPerAxis;
            options.height *= options.samplesPerAxis;
            const int perAxis = std::exchange(options.samplesPerAxis, 1);
            const SamplePictures samples{rendered(*cpu, *scene, camera, options),
                                         rendered(**backend, *scene, camera, options), perAxis};
            QVERIFY(samePicture(ours, theirs, theirs, QString("projection_%1").arg(projection), 1, &samples));
        }
    }

    void badValuesAreErrors()
    {
        const auto session = open("projection", cubeOf(valley));
        TransferFunction wrong = manyColours();
        wrong.unitDistance = 0;
        QVERIFY(!session->prepare({{{"transfer", wrong}}}, {}).ok());
        QCOMPARE(session->prepare({{{"projection", std::string("mean")}}}, {}).error().kind, ErrorKind::WrongUsage);
        QVERIFY(session->prepare({}, {}).ok());
    }

    void emptyMeshShowsTheOutline()
    {
        const auto scene = prepared(*open("projection", std::make_shared<TetrahedralMesh>()), {});
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
    }
};

QTEST_GUILESS_MAIN(ProjectionRendererTest)
#include "projection_renderer_test.moc"
