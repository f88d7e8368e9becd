// SPDX-License-Identifier: GPL-3.0-or-later
// The renderer of slices: its parameters become planes, cut once, whose colours in a picture are those of the transfer
// function.
#include "tests/core/render/scene_parts.h"
#include "tests/plugins/renderers/renderer_fixture.h"
#include "tests/render/picture_check.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <cmath>

using namespace tetra;
using namespace tetra::testing;

namespace {

/// x + y / 4 + z / 16, so that each place of a plane has a value of its own.
double linearField(const Eigen::Vector3d& place)
{
    return place.x() + place.y() / 4 + place.z() / 16;
}

std::shared_ptr<const TetrahedralMesh> linearCube()
{
    return std::make_shared<const TetrahedralMesh>(latticeMesh(5, 1, Split::Six, linearField));
}

/// The cube [0, 2]^3 without the quarter x < 1, z > 1: in the plane z = 1 one half of it ends and the other goes on.
std::shared_ptr<const TetrahedralMesh> stair()
{
    TetrahedralMesh mesh = latticeMesh(4, 2, Split::Six, linearField);
    Buffer<std::array<std::uint32_t, 4>> kept;
    for (const auto& corners : mesh.tetrahedra) {
        Eigen::Vector3d middle(0, 0, 0);
        for (const std::uint32_t vertex : corners)
            middle += mesh.positions[vertex] / 4;
        if (middle.x() > 1 || middle.z() < 1)
            kept.push_back(corners);
    }
    mesh.tetrahedra = std::move(kept);
    return std::make_shared<const TetrahedralMesh>(std::move(mesh));
}

/// With a step, and opacities that rise, stay and fall at once.
TransferFunction manyColours()
{
    TransferFunction function;
    function.colours = {{0, {0, 0, 1}}, {0.5, {1, 0, 0}}, {0.5, {0, 1, 0}}, {1.2, {1, 1, 0}}};
    function.opacities = {{0.1, 0}, {0.4, 0.5f}, {0.8, 0.5f}, {0.8, 1}, {1, 1}, {1, 0}};
    function.unitDistance = 0.3;
    return function;
}

std::vector<const Drawable*> slicesOf(const Scene& scene)
{
    std::vector<const Drawable*> slices;
    for (const Drawable& drawable : scene.drawables)
        if (drawable.id.starts_with("slice-"))
            slices.push_back(&drawable);
    return slices;
}

const Surface& surfaceOf(const Drawable& drawable)
{
    return std::get<Surface>(drawable.shape);
}

double areaOf(const TriangleMesh& mesh)
{
    double area = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        area += (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]).norm() / 2;
    return area;
}

/// Sees the unit box along -y in parallel, so that a pixel's place across y is known.
Camera alongY()
{
    Camera camera = fitted({.azimuth = 0, .elevation = 0}, unitBox);
    camera.perspective = false;
    return camera;
}

constexpr int side = 64;
const PictureOptions oneSample{.width = side, .height = side, .background = {0, 0, 0}, .samplesPerAxis = 1};

/// Where the middle of a pixel meets the plane y = `y`; the picture shows as much as a perspective one at the target.
Eigen::Vector3d placeOf(const Camera& camera, int column, int row, double y)
{
    const double perPixel = 2 * camera.distance * std::tan(camera.fieldOfView / 2 * M_PI / 180) / side;
    return {camera.target.x() + (column + 0.5 - side / 2.0) * perPixel, y,
            camera.target.z() - (row + 0.5 - side / 2.0) * perPixel};
}

bool isInside(const Eigen::Vector3d& place, double margin)
{
    return std::min(place.x(), place.z()) > margin && std::max(place.x(), place.z()) < 1 - margin;
}

} // namespace

class SliceRendererTest : public QObject {
    Q_OBJECT

private slots:
    void threePlanesAtFirst()
    {
        const auto scene = prepared(*open("slice", linearCube()), {});
        const auto slices = slicesOf(*scene);
        QCOMPARE(slices.size(), std::size_t(3));
        for (std::size_t axis = 0; axis < 3; ++axis) {
            QCOMPARE(slices[axis]->id, "slice-" + std::to_string(axis + 1));
            QCOMPARE(slices[axis]->label, std::string("slice ") + "xyz"[axis] + "=0.5");
            QVERIFY(slices[axis]->saved && !slices[axis]->value);
            const Surface& surface = surfaceOf(*slices[axis]);
            QVERIFY(surface.lit == false && surface.opacity == 1);
            QVERIFY(std::abs(areaOf(*surface.mesh) - 1) < 1e-6);
            QCOMPARE(surface.mesh->values.size(), surface.mesh->positions.size());
            for (std::size_t v = 0; v < surface.mesh->positions.size(); ++v) {
                const Eigen::Vector3d& place = surface.mesh->positions[v];
                QVERIFY(std::abs(place[static_cast<Eigen::Index>(axis)] - 0.5) < 1e-6);
                QVERIFY(std::abs(static_cast<double>(surface.mesh->values[v]) - linearField(place)) < 1e-6);
            }
        }
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
    }

    /// Of x + y / 4 + z / 16 = 0.6 in the unit cube the area is known: a plane that meets all four edges along x.
    void isosurfacesStandBesideTheSlices()
    {
        const auto session = open("slice", linearCube());
        ParameterValues values{{"isovalues", std::vector{Isovalue{.value = 0.6}}}};
        QCOMPARE(prepared(*session, values)->drawables.size(), std::size_t(4)); // with the outline
        values["isosurfaces"] = true;
        const auto scene = prepared(*session, values);
        QCOMPARE(slicesOf(*scene).size(), std::size_t(3));
        double area = 0;
        for (const Drawable& drawable : scene->drawables)
            if (drawable.value == 0.6)
                area += areaOf(*surfaceOf(drawable).mesh);
        QVERIFY(std::abs(area - std::sqrt(1 + 1.0 / 16 + 1.0 / 256)) < 1e-6);
    }

    void parametersAreDescribed()
    {
        for (const auto& parameter : rendererNamed("slice").parameters({{-1, 3}, unitBox}))
            QVERIFY(!parameter.id.empty() && !parameter.label.empty() && !parameter.explanation.empty());
        QVERIFY(!rendererNamed("slice").needs().view && !rendererNamed("slice").needs().focusMesh);
    }

    /// One plane at a share of the way, ends included: there it lies in the boundary.
    void onePlaneAcrossAnAxis_data()
    {
        QTest::addColumn<int>("axis");
        QTest::addColumn<double>("place");
        for (int axis = 0; axis < 3; ++axis)
            for (const double place : {0.0, 25.0, 60.0, 100.0})
                QTest::addRow("%c at %g", "xyz"[axis], place) << axis << place;
    }
    void onePlaneAcrossAnAxis()
    {
        QFETCH(int, axis);
        QFETCH(double, place);
        const auto scene =
            prepared(*open("slice", linearCube()),
                     {{"slice-axis", std::string(1, "xyz"[axis])}, {"slice-place", place}, {"outline", false}});
        const auto slices = slicesOf(*scene);
        QCOMPARE(slices.size(), std::size_t(1));
        const TriangleMesh& mesh = *surfaceOf(*slices[0]).mesh;
        QVERIFY2(std::abs(areaOf(mesh) - 1) < 1e-6, QByteArray::number(areaOf(mesh)));
        for (const Eigen::Vector3d& position : mesh.positions)
            QVERIFY(std::abs(position[axis] - place / 100) < 1e-6);
    }

    /// Where a part of the mesh ends in the plane and another goes on, both are seen, from whichever side, once.
    void partsThatEndInThePlane_data()
    {
        QTest::addColumn<QByteArray>("plane");
        QTest::addColumn<double>("area");
        QTest::addColumn<Eigen::Vector3d>("normal");
        const auto row = [](const char* plane, double area, const Eigen::Vector3d& normal) {
            QTest::newRow(plane) << QByteArray(plane) << area << normal;
        };
        row("z=1", 4, {0, 0, 1});
        row("0,0,-3,-3", 4, {0, 0, -1});
        row("x=1", 4, {1, 0, 0});
        row("-1,0,0,-1", 4, {-1, 0, 0});
        row("z=0", 4, {0, 0, 1});
        row("z=2", 2, {0, 0, 1});
        row("x=2", 4, {1, 0, 0});
        row("z=0.5", 4, {0, 0, 1}); // through vertices, within the mesh
        row("z=1.25", 2, {0, 0, 1});
        row("y=1", 3, {0, 1, 0});
        row("1e-200,0,0,5e-201", 2, {1, 0, 0}); // x = 0.5
    }
    void partsThatEndInThePlane()
    {
        QFETCH(QByteArray, plane);
        QFETCH(double, area);
        QFETCH(Eigen::Vector3d, normal);
        const auto scene = prepared(*open("slice", stair()), {{"slices", plane.toStdString()}});
        const auto slices = slicesOf(*scene);
        QCOMPARE(slices.size(), std::size_t(1));
        const TriangleMesh& mesh = *surfaceOf(*slices[0]).mesh;
        QVERIFY2(std::abs(areaOf(mesh) - area) < 1e-6, QByteArray::number(areaOf(mesh)));
        for (const auto& [a, b, c] : mesh.triangles) {
            const Eigen::Vector3d& first = mesh.positions[a];
            QVERIFY((mesh.positions[b] - first).cross(mesh.positions[c] - first).dot(normal) >= 0);
        }
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            QVERIFY(mesh.normals[v].cast<double>().dot(normal) > 0.999);
            QVERIFY(std::abs(static_cast<double>(mesh.values[v]) - linearField(mesh.positions[v])) < 1e-6);
        }
    }

    /// In place of those across the axes.
    void planesOfTheList()
    {
        const auto scene = prepared(*open("slice", linearCube()), {{"slices", std::string(" z = 0.25;1,1,0, 1; x=7;")},
                                                                   {"slice-axis", std::string("y")},
                                                                   {"clip", std::string("0,1,0,0.5")}});
        const auto slices = slicesOf(*scene);
        QCOMPARE(slices.size(), std::size_t(3));
        QCOMPARE(slices[0]->label, std::string("slice z = 0.25"));
        QVERIFY(std::abs(areaOf(*surfaceOf(*slices[0]).mesh) - 1) < 1e-6);
        QCOMPARE(slices[1]->label, std::string("slice 1,1,0, 1"));
        QVERIFY(std::abs(areaOf(*surfaceOf(*slices[1]).mesh) - std::sqrt(2)) < 1e-6);
        QVERIFY(surfaceOf(*slices[2]).mesh->triangles.empty()); // beside the data
        QCOMPARE(scene->clipPlanes.size(), std::size_t(1));
    }

    void textsThatAreNoPlanes_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("told"); // nothing: it is fine
        const auto row = [](const char* text, const char* told) {
            QTest::newRow(text) << QByteArray(text) << QByteArray(told);
        };
        row("", "");
        row("x=0", "");
        row("z=1", "");
        row("0,0,2,1", "");
        row("-1,0,0,-0.5", "");
        row("1,1,1,3", "");
        row("w=0.5", "'w=0.5' is not a plane");
        row("X=0.5", "'X=0.5' is not a plane");
        row("x", "'x' is not a plane");
        row("x=", "'x=' is not a plane");
        row("=0.5", "'=0.5' is not a plane");
        row("x=0,5", "'x=0,5' is not a plane");
        row("x=0.5=2", "is not a plane");
        row("x=inf", "'x=inf' is not a plane");
        row("1,2,3", "'1,2,3' is not a plane");
        row("0,0,0,1", "'0,0,0,1' is not a plane");
        row("1,0,0,0.5,1", "is not a plane");
        row("z=0.5;y=much", "'y=much' is not a plane");
        row("z=1.01", "'z=1.01' misses the data, which extend from 0 to 1");
        row("z=-3", "'z=-3' misses");
        row("1,1,1,3.1", "'1,1,1,3.1' misses the data, which extend from 0 to 3");
    }
    void textsThatAreNoPlanes()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, told);
        for (const auto& parameter : rendererNamed("slice").parameters({{0, 1}, unitBox}))
            if (parameter.id == "slices") {
                const std::string mistake = parameter.mistake(text.toStdString()).text();
                QVERIFY2(mistake.empty() == told.isEmpty(), mistake.c_str());
                QVERIFY2(mistake.find(told.toStdString()) != std::string::npos, mistake.c_str());
            }
        // What misses these data may meet others: it shows nothing.
        const auto scene = open("slice", linearCube())->prepare({{{"slices", text.toStdString()}}}, {});
        QCOMPARE(scene.ok(), told.isEmpty() || told.contains("misses"));
        if (!scene)
            QVERIFY(scene.error().kind == ErrorKind::WrongUsage &&
                    scene.error().text().starts_with("The setting 'slices' "));
    }

    void anotherFunctionCutsNothingAnew()
    {
        const auto session = open("slice", linearCube());
        const ParameterValues values{{"slices", std::string("z=0.3")}, {"transfer", manyColours()}};
        const auto first = prepared(*session, values);
        ParameterValues more = values;
        more["slices"] = std::string("y=0.5;z=0.3");
        const auto second = prepared(*session, more);
        QCOMPARE(surfaceOf(*slicesOf(*second)[1]).mesh, surfaceOf(*slicesOf(*first)[0]).mesh);
        more["transfer"] = sequentialTransferFunction(0, 1, 1);
        QVERIFY(surfaceOf(*slicesOf(*prepared(*session, more))[1]).mesh != surfaceOf(*slicesOf(*first)[0]).mesh);
    }

    /// Each pixel within 1/255 of the colour of the value in its middle, whatever the light; pixels beside a step of
    /// the colours are left out.
    void coloursAreThoseOfTheValues()
    {
        constexpr double y = 0.4;
        const TransferFunction function = manyColours();
        const auto scene = prepared(*open("slice", linearCube()),
                                    {{"slices", "y=" + formatNumber(y)}, {"transfer", function}, {"outline", false}});
        const Camera camera = alongY();
        const Picture picture = renderedByCpu(*scene, camera, oneSample);
        const double perPixel = (placeOf(camera, 1, 0, y) - placeOf(camera, 0, 0, y)).x();
        int compared = 0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const Eigen::Vector3d place = placeOf(camera, column, row, y);
                const double value = linearField(place);
                if (!isInside(place, perPixel) || std::abs(value - 0.5) < 2 * perPixel)
                    continue;
                const auto colour = evaluateUnmasked(function, value).colour;
                const auto pixel = pixelAt(picture, column, row);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    QVERIFY2(std::abs(pixel[channel] - 255 * colour[channel]) <= 1.01, QString("%1, %2: %3, not %4")
                                                                                           .arg(column)
                                                                                           .arg(row)
                                                                                           .arg(pixel[channel])
                                                                                           .arg(255 * colour[channel])
                                                                                           .toUtf8());
                ++compared;
            }
        QVERIFY2(compared > side * side / 3, QByteArray::number(compared));
    }

    /// Over black: colour times opacity, that of a layer of the unit distance, in steps of 1/128.
    void opacitiesAreThoseOfTheFunction()
    {
        constexpr double y = 0.4;
        for (const bool hasMask : {false, true}) {
            TransferFunction function = manyColours();
            if (hasMask)
                function.mask = TransferMask{0.3, 0.9};
            const auto scene = prepared(*open("slice", linearCube()), {{"slices", "y=" + formatNumber(y)},
                                                                       {"slice-opacity", std::string("function")},
                                                                       {"transfer", function},
                                                                       {"outline", false}});
            double area = 0;
            for (const Drawable* piece : slicesOf(*scene)) {
                QVERIFY(piece->saved && surfaceOf(*piece).opacity > 0 && surfaceOf(*piece).opacity <= 1);
                area += areaOf(*surfaceOf(*piece).mesh);
            }
            QVERIFY(area > 0.2 && area < 0.95); // what is transparent is left out
            const Camera camera = alongY();
            const Picture picture = renderedByCpu(*scene, camera, oneSample);
            const double perPixel = (placeOf(camera, 1, 0, y) - placeOf(camera, 0, 0, y)).x();
            int compared = 0;
            for (int row = 0; row < side; ++row)
                for (int column = 0; column < side; ++column) {
                    const Eigen::Vector3d place = placeOf(camera, column, row, y);
                    const double value = linearField(place);
                    bool nearStep = !isInside(place, perPixel);
                    for (const double step : {0.3, 0.5, 0.8, 0.9, 1.0})
                        nearStep = nearStep || std::abs(value - step) < 2 * perPixel;
                    if (nearStep)
                        continue;
                    const TransferSample sample = evaluate(function, value);
                    const double opacity = 1 - std::exp(-sample.extinction * function.unitDistance);
                    const auto colour = evaluateUnmasked(function, value).colour;
                    for (std::size_t channel = 0; channel < 3; ++channel)
                        QVERIFY(std::abs(pixelAt(picture, column, row)[channel] - 255 * opacity * colour[channel]) <
                                2.5);
                    ++compared;
                }
            QVERIFY2(compared > side * side / 5, QByteArray::number(compared));
        }
    }

    void badValuesAreErrors()
    {
        const auto session = open("slice", linearCube());
        TransferFunction wrong = manyColours();
        wrong.unitDistance = 0;
        QCOMPARE(session->prepare({{{"transfer", wrong}}}, {}).ok(), false);
        QCOMPARE(session->prepare({{{"slice-axis", std::string("w")}}}, {}).error().kind, ErrorKind::WrongUsage);
        std::stop_source stop;
        stop.request_stop();
        QCOMPARE(session->prepare({}, Progress(stop.get_token(), {})).error().kind, ErrorKind::Cancelled);
        QVERIFY(session->prepare({}, {}).ok());
    }

    void functionsWithoutColoursAreWhite()
    {
        TransferFunction function;
        function.opacities = {{0, 0.2f}, {1, 0.9f}};
        for (const char* opacity : {"opaque", "function"}) {
            const auto scene = prepared(*open("slice", linearCube()),
                                        {{"transfer", function}, {"slice-opacity", std::string(opacity)}});
            for (const Drawable* piece : slicesOf(*scene)) {
                const Surface& surface = surfaceOf(*piece);
                QVERIFY(surface.colour == (Colour{1, 1, 1}));
                for (const Colour& colour : surface.mesh->colours)
                    QVERIFY(colour == (Colour{1, 1, 1}));
            }
        }
    }

    void emptyMeshShowsTheOutline()
    {
        const auto scene = prepared(*open("slice", std::make_shared<TetrahedralMesh>()), {});
        QCOMPARE(partsOf(*scene).lines.size(), std::size_t(1));
        for (const Drawable* slice : slicesOf(*scene))
            QVERIFY(surfaceOf(*slice).mesh->triangles.empty());
    }

    void showsTheBoundary() { checkBoundary("slice", 3); }
};

QTEST_GUILESS_MAIN(SliceRendererTest)
#include "slice_renderer_test.moc"
