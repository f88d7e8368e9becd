// SPDX-License-Identifier: GPL-3.0-or-later
// A picture frames what there is to see in a background, whatever its shape, its place and the camera.
#include "core/render/object_values.h"
#include "tests/core/render/lattice_mesh.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;
using namespace tetra::testing;
using Eigen::Vector3d;

namespace {

constexpr std::uint32_t cells = 40;
constexpr double extent = 2;

/// 1 in an ellipsoid, 0 around it, with a slope between that is one cell wide.
struct Ellipsoid {
    Vector3d middle, radii;

    double operator()(const Vector3d& point) const
    {
        const double distance = ((point - middle).cwiseQuotient(radii).norm() - 1) * radii.minCoeff();
        return std::clamp(0.5 - distance / (extent / cells), 0.0, 1.0);
    }
};

std::vector<Vector3d> outlineOf(const TetrahedralMesh& mesh)
{
    const auto [least, largest] = std::ranges::minmax(mesh.values);
    return objectOutline(mesh, volumeHistogram(mesh, least, largest, 256));
}

/// How far into a picture of this width / height a place is: 1 at the edge. In closed form, of a camera that is level.
double reach(const Camera& camera, double aspectRatio, const Vector3d& place)
{
    const double turn = camera.azimuth * M_PI / 180, rise = camera.elevation * M_PI / 180;
    const Vector3d back(std::sin(turn) * std::cos(rise), -std::cos(turn) * std::cos(rise), std::sin(rise));
    const Vector3d right(std::cos(turn), std::sin(turn), 0), up = back.cross(right);
    const Vector3d from = place - camera.target;
    const double away = camera.perspective ? camera.distance - from.dot(back) : camera.distance;
    const double across = std::tan(camera.fieldOfView * M_PI / 360) * away;
    return std::max(std::abs(from.dot(right)) / (across * std::max(1.0, aspectRatio)),
                    std::abs(from.dot(up)) / (across * std::max(1.0, 1 / aspectRatio)));
}

} // namespace

class ObjectOutlineTest : public QObject {
    Q_OBJECT

private slots:
    void anObjectFillsThePicture()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> unit(0, 1);
        const auto between = [&](double least, double largest) { return std::lerp(least, largest, unit(random)); };
        for (int round = 0; round < 12; ++round) {
            const Vector3d radii(between(0.15, 0.5), between(0.15, 0.5), between(0.15, 0.5));
            const Ellipsoid field{Vector3d(between(0.6, 1.4), between(0.6, 1.4), between(0.6, 1.4)), radii};
            const TetrahedralMesh mesh = latticeMesh(cells, extent, Split::Six, field);
            const auto outline = outlineOf(mesh);
            QVERIFY(!outline.empty() && outline.size() <= 128);
            for (int view = 0; view < 20; ++view) {
                const double aspectRatio = between(0.4, 2.5);
                const Camera camera = fitted({.azimuth = between(-180, 180),
                                              .elevation = between(-85, 85),
                                              .fieldOfView = between(10, 60),
                                              .perspective = view % 2 == 0},
                                             outline, aspectRatio);
                double largest = 0;
                for (std::size_t vertex = 0; vertex < mesh.positions.size(); ++vertex)
                    if (mesh.values[vertex] > 0.5)
                        largest = std::max(largest, reach(camera, aspectRatio, mesh.positions[vertex]));
                QVERIFY2(largest > 0.7 && largest < 1, qPrintable(QString::number(largest)));
            }
        }
    }

    /// It does not matter which of the two is the darker one, nor in which units.
    void units()
    {
        const Ellipsoid field{Vector3d(1.2, 0.9, 1), Vector3d(0.3, 0.4, 0.2)};
        const auto outline = outlineOf(latticeMesh(cells, extent, Split::Five, field));
        QVERIFY(!outline.empty());
        const auto inverse = [&](const Vector3d& point) { return 1e6 - 3e5 * field(point); };
        QCOMPARE(outlineOf(latticeMesh(cells, extent, Split::Five, inverse)), outline);
    }

    /// An isovalue or a function that shows more than the object is told from one that does not.
    void valuesOfTheObject()
    {
        const Ellipsoid field{Vector3d(1.2, 0.9, 1), Vector3d(0.3, 0.4, 0.2)};
        for (const double sign : {1.0, -1.0}) {
            const TetrahedralMesh mesh =
                latticeMesh(cells, extent, Split::Five, [&](const Vector3d& point) { return sign * field(point); });
            const auto [least, largest] = std::ranges::minmax(mesh.values);
            const ValueHistogram volumes = volumeHistogram(mesh, least, largest, 256);
            const ObjectValues object(volumes, sign * 0.5);
            QVERIFY(object.isBesideBackground());
            QVERIFY(object.has(sign * 0.6) && object.has(sign) && !object.has(0));
            QVERIFY(object.hasAllBeyond(sign * 0.5) && object.hasAllBeyond(sign * 0.9));
            QVERIFY(!object.hasAllBeyond(sign * 0.005) && !object.hasAllBeyond(-sign * 0.1));
            for (const double unitDistance : {0.01, 1.0, 30.0})
                for (const double error : {0.0, 0.1})
                    QVERIFY(object.hasAllSeenOf(fittedTransferFunction(volumes, unitDistance, error)));
            const auto flat = [&](double from) {
                return transferFunctionFromPoints(
                    {{std::min(from, sign), {1, 1, 1}, 0.5F}, {std::max(from, sign), {1, 1, 1}, 0.5F}}, 1);
            };
            QVERIFY(!object.hasAllSeenOf(flat(0)));
        }
        const TetrahedralMesh slope = latticeMesh(8, extent, Split::Five, [](const Vector3d& p) { return p.sum(); });
        const ObjectValues everything(volumeHistogram(slope, 0, 3 * extent, 256), {});
        QVERIFY(!everything.isBesideBackground() && everything.has(0.1) && everything.hasAllBeyond(0.1));
    }

    /// All that there is, is to be seen: there is no object in front of it.
    void withoutABackground()
    {
        QVERIFY(outlineOf(latticeMesh(8, extent, Split::Five, [](const Vector3d& p) { return p.sum(); })).empty());
        QVERIFY(outlineOf(latticeMesh(8, extent, Split::Five, [](const Vector3d&) { return 4.0; })).empty());
        QVERIFY(objectOutline({}, {}).empty());
        QCOMPARE(fitted(Camera{.distance = 3}, std::span<const Vector3d>()), Camera{.distance = 3});
    }

    /// A single bright sample in a dark room is not worth going so near.
    void aSpeck()
    {
        const auto speck = [](const Vector3d& p) { return (p - Vector3d::Constant(1)).norm() < 0.01 ? 1.0 : 0.0; };
        const TetrahedralMesh mesh = latticeMesh(cells, extent, Split::Five, speck);
        QVERIFY(std::ranges::max(mesh.values) == 1);
        QVERIFY(outlineOf(mesh).empty());
    }

    /// Nor is it worth to leave out what little is around an object.
    void nearlyAll()
    {
        const auto outline = [](double radius) {
            return outlineOf(
                latticeMesh(cells, extent, Split::Five, Ellipsoid{Vector3d::Constant(1), Vector3d::Constant(radius)}));
        };
        QVERIFY(!outline(0.8).empty());
        QVERIFY(outline(0.98).empty());
    }

    /// What is not finite is nowhere.
    void placesThatAreNotFinite()
    {
        TetrahedralMesh mesh =
            latticeMesh(cells, extent, Split::Five, Ellipsoid{Vector3d::Constant(1), Vector3d::Constant(0.5)});
        const auto expected = outlineOf(mesh);
        mesh.positions.push_back(Vector3d::Constant(std::nan("")));
        mesh.positions.push_back(Vector3d(0, std::numeric_limits<double>::infinity(), 0));
        mesh.values.resize(mesh.positions.size(), 1);
        QVERIFY(!expected.empty());
        QCOMPARE(outlineOf(mesh), expected);
    }
};

QTEST_GUILESS_MAIN(ObjectOutlineTest)
#include "object_outline_test.moc"
