// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangles.h"
#include "core/mesh/surface_distance.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

using namespace tetra;
using Eigen::Vector3d;

namespace {

/// A sheet of cells times cells squares over [0, 1]^2, as high as the function says.
template <class Height> TriangleMesh sheet(std::uint32_t cells, Height&& height)
{
    TriangleMesh surface;
    for (std::uint32_t j = 0; j <= cells; ++j)
        for (std::uint32_t i = 0; i <= cells; ++i) {
            const double x = double(i) / cells, y = double(j) / cells;
            surface.positions.push_back({x, y, height(x, y)});
        }
    for (std::uint32_t j = 0; j < cells; ++j)
        for (std::uint32_t i = 0; i < cells; ++i) {
            const std::uint32_t a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
            surface.triangles.push_back({a, b, d});
            surface.triangles.push_back({a, d, c});
        }
    return surface;
}

/// The distance of a place from a triangle, by looking at points of it closer and closer around the best one.
double slowDistance(const Vector3d& place, const TriangleMesh& surface)
{
    double best = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : surface.triangles) {
        double u = 1.0 / 3, v = 1.0 / 3;
        for (double step = 0.4; step > 1e-7; step /= 2)
            for (int round = 0; round < 8; ++round) {
                double bestU = u, bestV = v, here = std::numeric_limits<double>::infinity();
                for (const double du : {-step, 0.0, step})
                    for (const double dv : {-step, 0.0, step}) {
                        const double nu = std::max(0.0, u + du), nv = std::max(0.0, v + dv);
                        const double scale = std::max(1.0, nu + nv);
                        const Vector3d at = surface.positions[a] +
                                            nu / scale * (surface.positions[b] - surface.positions[a]) +
                                            nv / scale * (surface.positions[c] - surface.positions[a]);
                        if ((at - place).norm() < here) {
                            here = (at - place).norm();
                            bestU = nu / scale;
                            bestV = nv / scale;
                        }
                    }
                u = bestU;
                v = bestV;
                best = std::min(best, here);
            }
    }
    return best;
}

SurfaceDistance distance(const TriangleMesh& to, const TriangleMesh& from)
{
    const auto found = surfaceDistance(to, from);
    if (!found)
        qFatal("%s", found.error().text().c_str());
    return *found;
}

} // namespace

class SurfaceDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void parallelSheets()
    {
        const TriangleMesh low = sheet(7, [](double, double) { return 0.0; });
        const TriangleMesh high = sheet(40, [](double, double) { return 0.25; });
        for (const SurfaceDistance& found : {distance(low, high), distance(high, low)}) {
            QCOMPARE(found.largest, 0.25);
            QVERIFY(std::abs(found.mean - 0.25) < 1e-12);
        }
        const SurfaceDistance same = distance(low, low);
        QVERIFY(same.largest == 0 && same.mean == 0);
    }

    /// The mean is one over the area, however densely the vertices lie: a slope has half of its height.
    void theMeanIsOverTheArea()
    {
        const TriangleMesh flat = sheet(3, [](double, double) { return 0.0; });
        TriangleMesh slope = sheet(30, [](double x, double) { return x; });
        for (Vector3d& position : slope.positions) // dense where it is low
            position = {position.x() * position.x(), position.y(), position.x() * position.x()};
        const SurfaceDistance found = distance(flat, slope);
        QCOMPARE(found.largest, 1.0);
        QVERIFY2(std::abs(found.mean - 0.5) < 0.005, qPrintable(QString::number(found.mean)));
    }

    /// Against a search that knows no tree.
    void isTheNearestPlace()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> number(-1, 1);
        TriangleMesh soup;
        for (std::uint32_t i = 0; i < 90; ++i)
            soup.positions.push_back({number(random), number(random), number(random)});
        for (std::uint32_t i = 0; i < 90; i += 3)
            soup.triangles.push_back({i, i + 1, i + 2});
        const TriangleMesh from = sheet(3, [](double x, double y) { return x * y; });
        double largest = 0;
        for (const Vector3d& place : from.positions)
            largest = std::max(largest, slowDistance(place, soup));
        const SurfaceDistance found = distance(soup, from);
        QVERIFY2(std::abs(found.largest - largest) < 1e-5,
                 qPrintable(QString("%1 %2").arg(found.largest).arg(largest)));
    }

    /// Large triangles are measured between their corners, too: both are on the other surface, a cone's tip is not.
    void placesInsideTrianglesCount()
    {
        const double height = 0.25;
        const TriangleMesh flat = sheet(1, [](double, double) { return 0.0; });
        const TriangleMesh cone =
            sheet(40, [&](double x, double y) { return std::max(0.0, height - std::hypot(x - 0.5, y - 0.35)); });
        const SurfaceDistance found = distance(cone, flat);
        const double most = height / std::sqrt(2.0);
        QVERIFY2(found.largest > most - 0.03 && found.largest < most + 0.01,
                 qPrintable(QString::number(found.largest)));
        const double mean = std::numbers::pi * height * height * most / 3; // of a cone over the unit square
        QVERIFY2(std::abs(found.mean / mean - 1) < 0.2, qPrintable(QString::number(found.mean / mean)));
        // However small the other's triangles are, there is an end of it.
        TriangleMesh speck = flat;
        for (Vector3d& position : speck.positions)
            position *= 1e-9;
        QVERIFY(std::abs(distance(speck, sheet(3, [](double, double) { return 0.0; })).largest - std::sqrt(2.0)) <
                1e-6);
    }

    void emptyAndCancelled()
    {
        const TriangleMesh flat = sheet(3, [](double, double) { return 0.0; });
        QVERIFY(!surfaceDistance(flat, TriangleMesh()).ok());
        QVERIFY(!surfaceDistance(TriangleMesh(), flat).ok());
        std::stop_source stop;
        stop.request_stop();
        const auto cancelled = surfaceDistance(flat, flat, Progress(stop.get_token(), {}));
        QVERIFY(!cancelled.ok() && cancelled.error().kind == ErrorKind::Cancelled);
    }
};

QTEST_GUILESS_MAIN(SurfaceDistanceTest)
#include "surface_distance_test.moc"
