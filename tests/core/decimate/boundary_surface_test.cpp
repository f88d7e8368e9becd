// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/boundary_distance.h"
#include "core/decimate/boundary_surface.h"

#include <QTest>

#include <algorithm>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace tetra;

namespace {

bool isSame(SurfaceTriangle one, SurfaceTriangle other)
{
    std::ranges::sort(one);
    std::ranges::sort(other);
    return one == other;
}

/// BoundarySurface by looking at all pairs.
class PlainSurface {
public:
    PlainSurface(std::span<const Eigen::Vector3d> positions, std::vector<SurfaceTriangle> triangles)
        : positions_(positions), triangles_(std::move(triangles))
    {
    }
    bool meetsItself(const std::vector<SurfaceTriangle>& added, const std::vector<SurfaceTriangle>& removed) const
    {
        std::vector<SurfaceTriangle> others = without(removed);
        for (const SurfaceTriangle& triangle : added) {
            if (withoutArea(positions_, triangle))
                return true;
            for (const SurfaceTriangle& other : others) {
                if (surfaceTrianglesMeet(positions_, triangle, other))
                    return true;
            }
            others.push_back(triangle);
        }
        return false;
    }
    void replace(const std::vector<SurfaceTriangle>& removed, const std::vector<SurfaceTriangle>& added)
    {
        triangles_ = without(removed);
        triangles_.insert(triangles_.end(), added.begin(), added.end());
    }
    const std::vector<SurfaceTriangle>& triangles() const { return triangles_; }

private:
    std::vector<SurfaceTriangle> without(const std::vector<SurfaceTriangle>& removed) const
    {
        std::vector<SurfaceTriangle> rest;
        std::ranges::copy_if(triangles_, std::back_inserter(rest), [&](const SurfaceTriangle& triangle) {
            return std::ranges::none_of(removed, [&](const SurfaceTriangle& r) { return isSame(triangle, r); });
        });
        return rest;
    }

    std::span<const Eigen::Vector3d> positions_;
    std::vector<SurfaceTriangle> triangles_;
};

/// Two shells of a grid of n x n points, close to each other; they lie flat or are bent.
struct Sheets {
    std::vector<Eigen::Vector3d> points;
    std::vector<SurfaceTriangle> triangles;
};

Sheets makeSheets(std::uint32_t n, double distance, double bend, std::mt19937& random)
{
    Sheets sheets;
    std::uniform_real_distribution<double> noise(-bend, bend);
    for (const double height : {0.0, distance}) {
        const auto first = static_cast<std::uint32_t>(sheets.points.size());
        for (std::uint32_t y = 0; y < n; ++y) {
            for (std::uint32_t x = 0; x < n; ++x)
                sheets.points.emplace_back(x, y, height + noise(random));
        }
        for (std::uint32_t y = 0; y + 1 < n; ++y) {
            for (std::uint32_t x = 0; x + 1 < n; ++x) {
                const std::uint32_t corner = first + y * n + x;
                sheets.triangles.push_back({corner, corner + 1, corner + n});
                sheets.triangles.push_back({corner + 1, corner + n + 1, corner + n});
            }
        }
    }
    return sheets;
}

struct Replacement {
    std::vector<SurfaceTriangle> removed, added;
};

/// What the half-edge collapse of one corner into another does to the surface, whether it is legal or not.
Replacement collapse(const std::vector<SurfaceTriangle>& triangles, std::uint32_t from, std::uint32_t to)
{
    Replacement replacement;
    for (const SurfaceTriangle& triangle : triangles) {
        if (std::ranges::find(triangle, from) == triangle.end())
            continue;
        replacement.removed.push_back(triangle);
        if (std::ranges::find(triangle, to) != triangle.end())
            continue;
        SurfaceTriangle moved = triangle;
        std::ranges::replace(moved, from, to);
        replacement.added.push_back(moved);
    }
    return replacement;
}

} // namespace

class BoundarySurfaceTest : public QObject {
    Q_OBJECT
private slots:
    /// S12: collapses one after the other, so that small and very large triangles lie beside each other.
    void agreesWithAllPairs_data()
    {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("bend");
        QTest::addRow("flat") << 1.0 << 0.0;
        QTest::addRow("bent") << 0.75 << 0.25;
        QTest::addRow("thin") << 1e-9 << 0.0;
        QTest::addRow("crossing") << 0.1 << 0.2;
    }
    void agreesWithAllPairs()
    {
        QFETCH(double, distance);
        QFETCH(double, bend);
        std::mt19937 random(3);
        const Sheets sheets = makeSheets(16, distance, bend, random);
        BoundarySurface surface(sheets.points, sheets.triangles);
        PlainSurface plain(sheets.points, sheets.triangles);
        std::array<int, 2> seen{};
        for (int trial = 0; trial < 6000; ++trial) {
            const SurfaceTriangle& triangle = plain.triangles()[random() % plain.triangles().size()];
            const std::size_t corner = random() % 3;
            const Replacement tried = collapse(plain.triangles(), triangle[corner], triangle[(corner + 1) % 3]);
            const bool meets = plain.meetsItself(tried.added, tried.removed);
            QCOMPARE(surface.meetsItself(tried.added, tried.removed), meets);
            ++seen[meets];
            if (meets || tried.added.empty())
                continue;
            surface.replace(tried.removed, tried.added);
            plain.replace(tried.removed, tried.added);
            QCOMPARE(surface.size(), plain.triangles().size());
        }
        QVERIFY2(seen[0] > 200 && seen[1] > 200, qPrintable(QString("%1 %2").arg(seen[0]).arg(seen[1])));
    }

    /// Any triangles, that share no more than corners.
    void agreesWithAllPairsOnSoup()
    {
        std::mt19937 random(4);
        std::array<int, 2> seen{};
        for (int trial = 0; trial < 2000; ++trial) {
            std::vector<Eigen::Vector3d> points(30);
            for (Eigen::Vector3d& point : points)
                point = Eigen::Vector3d(random() % 64, random() % 64, random() % 64) - Eigen::Vector3d(100, 0, 7);
            std::vector<SurfaceTriangle> triangles;
            while (triangles.size() < 6) {
                SurfaceTriangle triangle;
                std::ranges::generate(triangle, [&] { return std::uint32_t(random() % 30); });
                const auto same = [&](const SurfaceTriangle& other) { return isSame(triangle, other); };
                if (!withoutArea(points, triangle) && std::ranges::none_of(triangles, same))
                    triangles.push_back(triangle);
            }
            const std::vector<SurfaceTriangle> added(triangles.begin(), triangles.begin() + 2);
            const std::vector<SurfaceTriangle> removed(triangles.begin() + 2, triangles.begin() + 4);
            triangles.erase(triangles.begin(), triangles.begin() + 2);
            const bool meets = PlainSurface(points, triangles).meetsItself(added, removed);
            QCOMPARE(BoundarySurface(points, triangles).meetsItself(added, removed), meets);
            ++seen[meets];
        }
        QVERIFY2(std::ranges::min(seen) > 200, qPrintable(QString("%1 %2").arg(seen[0]).arg(seen[1])));
    }

    /// C11, S13: no place of a triangle is farther from the surface than the bound, which is not much more than the
    /// farthest place; a triangle of the surface, and one within it, is known to be no distance away.
    void distancesAreBounds()
    {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> coordinate(-1, 1);
        constexpr int steps = 24;
        for (int round = 0; round < 60; ++round) {
            std::vector<Eigen::Vector3d> points;
            for (int i = 0; i < 12; ++i)
                points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
            std::vector<SurfaceTriangle> surface;
            for (std::uint32_t i = 0; i + 2 < 9; ++i)
                surface.push_back({i, i + 1, i + 2});
            BoundaryDistance distance(points, surface);
            const SurfaceTriangle triangle{9, 10, 11};
            double farthest = 0;
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const Eigen::Vector3d place =
                        (i * points[9] + j * points[10] + (steps - i - j) * points[11]) / double(steps);
                    double nearest = std::numeric_limits<double>::infinity();
                    for (const auto& [a, b, c] : surface) {
                        std::array<std::array<double, 3>, 3> corners{};
                        for (int axis = 0; axis < 3; ++axis) {
                            const auto k = static_cast<std::size_t>(axis);
                            corners[0][k] = points[a][axis] - place[axis];
                            corners[1][k] = points[b][axis] - place[axis];
                            corners[2][k] = points[c][axis] - place[axis];
                        }
                        const auto weights = nearestWeights(corners);
                        const Eigen::Vector3d at =
                            weights[0] * points[a] + weights[1] * points[b] + weights[2] * points[c];
                        nearest = std::min(nearest, (at - place).norm());
                    }
                    farthest = std::max(farthest, nearest);
                }
            constexpr double anything = std::numeric_limits<double>::infinity();
            const double coarse = distance.bound(triangle, anything, anything, anything);
            const double bound = distance.bound(triangle, anything, 0, anything);
            QVERIFY2(bound >= (1 - 1e-12) * farthest && coarse >= bound,
                     qPrintable(QString("%1 %2").arg(bound).arg(farthest)));
            QVERIFY2(bound < 1.2 * farthest + 0.05, qPrintable(QString("%1 %2").arg(bound).arg(farthest)));
            QCOMPARE(distance.bound(triangle, anything, 0, anything), bound);
            QCOMPARE(distance.bound(triangle, 0.5 * bound, 0, anything), 0.5 * bound);
            QVERIFY(distance.bound(surface[3], anything, 0, anything) < 1e-12);
        }
    }

    void flatTriangleIsRefused()
    {
        const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
        const BoundarySurface surface(points, {});
        QVERIFY(surface.meetsItself(std::vector<SurfaceTriangle>{{0, 1, 2}}, {}));
        QVERIFY(!surface.meetsItself({}, {}));
    }
};

QTEST_APPLESS_MAIN(BoundarySurfaceTest)
#include "boundary_surface_test.moc"
