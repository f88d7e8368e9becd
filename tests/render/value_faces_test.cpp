// SPDX-License-Identifier: GPL-3.0-or-later
// A thousand faces in the colours of their values, turned any way, on both back ends: each pixel has the colour that
// the map gives the value there, within 1/255, as the colour bar shows it. Values and colours are worked out here, by
// the place where a pixel's ray meets the face and by the map's own straight pieces.
#include "tests/render/gl_test.h"
#include "tests/render/same_picture.h"

#include <tan/render.h>

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

using namespace tetra;
using namespace tetra::testing;

namespace {

constexpr int cellsOfSide = 10; ///< a face stands in the middle of each
constexpr int cellPixels = 40;
constexpr int pictureSide = cellsOfSide * cellPixels;
constexpr int pictures = 10;
constexpr double eyeDistance = 60; ///< in cells: so far that no face reaches into the cell beside its own
/// Of a pixel: corners are moved to a raster that is finer than this before they are drawn.
constexpr double cornerShift = 1.0 / 100;

/// Two to six points, and a step now and then.
TransferFunction randomMap(std::mt19937& random)
{
    std::uniform_real_distribution<float> channel(0, 1);
    std::uniform_real_distribution<double> gap(0.2, 2);
    const auto colour = [&] { return std::array{channel(random), channel(random), channel(random)}; };
    TransferFunction map;
    double value = -20 * gap(random);
    const std::size_t count = 2 + random() % 5;
    for (std::size_t point = 0; point < count; ++point) {
        value += 10 * gap(random);
        map.colours.push_back({value, colour()});
        if (random() % 4 == 0)
            map.colours.push_back({value, colour()});
    }
    return map;
}

/// Linear between the points, and constant beyond the first and the last.
std::array<double, 3> colourOf(const TransferFunction& map, double value)
{
    const auto& points = map.colours;
    std::size_t above = 0;
    while (above < points.size() && points[above].value <= value)
        ++above;
    const ColourPoint& to = points[std::min(above, points.size() - 1)];
    const ColourPoint& from = points[above == 0 ? 0 : above - 1];
    const double part = to.value > from.value ? (value - from.value) / (to.value - from.value) : 0;
    std::array<double, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel)
        colour[channel] = from.colour[channel] + part * (double(to.colour[channel]) - from.colour[channel]);
    return colour;
}

struct ColourRange {
    std::array<double, 3> least{1, 1, 1};
    std::array<double, 3> largest{0, 0, 0};
};

/// Of all values that differ by no more than `apart`.
ColourRange coloursNear(const TransferFunction& map, double value, double apart)
{
    std::vector<std::array<double, 3>> colours{colourOf(map, value - apart), colourOf(map, value + apart)};
    for (const ColourPoint& point : map.colours)
        if (std::abs(point.value - value) <= apart)
            colours.push_back({point.colour[0], point.colour[1], point.colour[2]});
    ColourRange range;
    for (const auto& colour : colours)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            range.least[channel] = std::min(range.least[channel], colour[channel]);
            range.largest[channel] = std::max(range.largest[channel], colour[channel]);
        }
    return range;
}

/// A triangle in the coordinates of the eye, whose target is the origin, with a value at each corner.
struct Face {
    Eigen::Matrix3d corners; ///< columns
    Eigen::Vector3d values;
    TransferFunction map;
    double leastColumn = 0; ///< left edge of its cell, in pixels
    double leastRow = 0;
};

/// In a cell of its own; one that is seen straight on has no depth.
Face randomFace(std::mt19937& random, int cell, bool straightOn)
{
    std::uniform_real_distribution<double> turn(0, 2 * std::numbers::pi / 3), depth(-0.5, 0.5), share(-0.2, 1.2);
    Face face;
    face.map = randomMap(random);
    const int column = cell % cellsOfSide, row = cell / cellsOfSide;
    face.leastColumn = column * cellPixels;
    face.leastRow = row * cellPixels;
    const Eigen::Vector3d middle(column + 0.5 - cellsOfSide / 2.0, cellsOfSide / 2.0 - row - 0.5, 0);
    const double low = face.map.colours.front().value, high = face.map.colours.back().value;
    const double start = turn(random);
    for (int corner = 0; corner < 3; ++corner) {
        const double angle = start + corner * 2 * std::numbers::pi / 3 + turn(random) / 3;
        face.corners.col(corner) = middle + 0.44 * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
        face.corners(2, corner) = straightOn ? 0 : depth(random);
        face.values[corner] = static_cast<float>(low + share(random) * (high - low));
    }
    return face;
}

/// The weights of the corners where the ray through the middle of a pixel meets the face's plane.
Eigen::Vector3d weightsAt(const Face& face, double column, double row, bool perspective)
{
    const Eigen::Vector3d place((column + 0.5) / cellPixels - cellsOfSide / 2.0,
                                cellsOfSide / 2.0 - (row + 0.5) / cellPixels, 0);
    const Eigen::Vector3d eye(0, 0, eyeDistance);
    const Eigen::Vector3d along = perspective ? Eigen::Vector3d(place - eye) : Eigen::Vector3d(0, 0, -1);
    // corners * weights = place + t * along, and the weights sum to one
    Eigen::Matrix4d system;
    system << face.corners, -along, Eigen::RowVector4d(1, 1, 1, 0);
    return (system.inverse() * Eigen::Vector4d(place.x(), place.y(), place.z(), 1)).head<3>();
}

Surface surfaceOf(const Face& face, const Camera& camera)
{
    TriangleMesh mesh;
    for (int corner = 0; corner < 3; ++corner) {
        mesh.positions.push_back(camera.target + eyeAxes(camera) * face.corners.col(corner));
        mesh.values.push_back(static_cast<float>(face.values[corner]));
    }
    const Eigen::Vector3d normal =
        (mesh.positions[1] - mesh.positions[0]).cross(mesh.positions[2] - mesh.positions[0]).normalized();
    mesh.normals.assign(3, normal.cast<float>());
    mesh.triangles = {{0, 1, 2}};
    return {.mesh = std::make_shared<const TriangleMesh>(colouredByValue(mesh, face.map)), .colour = {1, 0, 1}};
}

Scene sceneOf(const std::vector<Face>& faces, const Camera& camera)
{
    Scene scene;
    for (const Face& face : faces) {
        const Surface surface = surfaceOf(face, camera);
        for (const Eigen::Vector3d& position : surface.mesh->positions)
            scene.bounds.extend(position);
        scene.drawables.push_back({.id = std::to_string(scene.drawables.size()), .shape = surface});
    }
    return scene;
}

} // namespace

class ValueFacesTest : public GlTest {
    Q_OBJECT

private:
    /// How many pixels of the face were judged; one that is wrong fails the test.
    int judged(const Face& face, const Picture& picture, bool perspective) const
    {
        int pixels = 0;
        for (int y = 0; y < cellPixels; ++y)
            for (int x = 0; x < cellPixels; ++x) {
                const double column = face.leastColumn + x, row = face.leastRow + y;
                const auto valueAt = [&](double right, double down) {
                    return face.values.dot(weightsAt(face, column + right, row + down, perspective));
                };
                if (weightsAt(face, column, row, perspective).minCoeff() < 0.05)
                    continue; // a pixel at an edge may belong to what is beside it
                const double value = valueAt(0, 0);
                const double apart = cornerShift * (std::abs(valueAt(1, 0) - value) + std::abs(valueAt(0, 1) - value)) +
                                     1e-5 * (face.map.colours.back().value - face.map.colours.front().value);
                const ColourRange range = coloursNear(face.map, value, apart);
                const auto& pixel = pixelAt(picture, static_cast<int>(column), static_cast<int>(row));
                for (std::size_t channel = 0; channel < 3; ++channel)
                    if (pixel[channel] < 255 * range.least[channel] - 1 ||
                        pixel[channel] > 255 * range.largest[channel] + 1) {
                        QTest::qFail(qPrintable(QString("pixel %1, %2: channel %3 is %4, not %5 to %6")
                                                    .arg(column)
                                                    .arg(row)
                                                    .arg(channel)
                                                    .arg(pixel[channel])
                                                    .arg(255 * range.least[channel])
                                                    .arg(255 * range.largest[channel])),
                                     __FILE__, __LINE__);
                        return 0;
                    }
                ++pixels;
            }
        return pixels;
    }

private slots:
    void initTestCase() { makeGlIfThere(); }

    void coloursAreThoseOfTheMap()
    {
        std::mt19937 random(11);
        std::uniform_real_distribution<double> angle(-180, 180);
        const PictureOptions options{
            .width = pictureSide, .height = pictureSide, .background = {0, 0, 0}, .samplesPerAxis = 1};
        for (int round = 0; round < pictures; ++round) {
            const bool perspective = round % 2 == 0;
            const Camera camera{.target = {3, -2, 7},
                                .distance = eyeDistance,
                                .azimuth = angle(random),
                                .elevation = angle(random) / 2,
                                .roll = angle(random),
                                .fieldOfView = 2 * std::atan(cellsOfSide / 2.0 / eyeDistance) * 180 / std::numbers::pi,
                                .perspective = perspective};
            std::vector<Face> faces;
            for (int cell = 0; cell < cellsOfSide * cellsOfSide; ++cell)
                faces.push_back(randomFace(random, cell, cell % 4 == 0));
            const Scene scene = sceneOf(faces, camera);
            for (RenderBackend* backend : backends()) {
                const Picture picture = rendered(*backend, scene, camera, options);
                for (const Face& face : faces) {
                    const int pixels = judged(face, picture, perspective);
                    if (QTest::currentTestFailed())
                        return;
                    QVERIFY2(pixels > 50, qPrintable(QString("%1 pixels of a face").arg(pixels)));
                }
            }
        }
    }

    /// What light would make of them, and does where it is asked for.
    void lightIsAChoice()
    {
        std::mt19937 random(12);
        const Camera camera{.distance = eyeDistance,
                            .fieldOfView = 2 * std::atan(cellsOfSide / 2.0 / eyeDistance) * 180 / std::numbers::pi};
        const std::vector<Face> faces{randomFace(random, 55, true)};
        const PictureOptions options{.width = pictureSide, .height = pictureSide, .samplesPerAxis = 1};
        const Scene unlit = sceneOf(faces, camera);
        Scene lit = unlit, plain = unlit;
        std::get<Surface>(lit.drawables[0].shape).lit = true;
        auto bare = std::make_shared<TriangleMesh>(*std::get<Surface>(plain.drawables[0].shape).mesh);
        bare->colours.clear();
        std::get<Surface>(plain.drawables[0].shape) = {.mesh = bare, .colour = {0.5f, 0.5f, 0.5f}};
        const int middle = 5 * cellPixels + cellPixels / 2;
        for (RenderBackend* backend : backends()) {
            const auto seen = [&](const Scene& scene) {
                return pixelAt(rendered(*backend, scene, camera, options), middle, middle);
            };
            // What faces the eye has 0.965 of its colour and a highlight of 0.014.
            for (std::size_t channel = 0; channel < 3; ++channel)
                QVERIFY(std::abs(seen(lit)[channel] - std::min(255.0, 0.965 * seen(unlit)[channel] + 3.5)) <= 2);
            QVERIFY(std::ranges::max(seen(unlit)) > 180); // where that differs
            QVERIFY(std::abs(seen(plain)[0] - 127) <= 2); // one colour all over is lit
        }
    }
};

QTEST_GUILESS_MAIN(ValueFacesTest)
#include "value_faces_test.moc"
