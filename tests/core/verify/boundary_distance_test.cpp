// SPDX-License-Identifier: GPL-3.0-or-later
// Distances and values on triangles, and from one boundary to another, against many samples (R4, S13).
#include "core/verify/irregular_original.h"
#include "tests/core/history/irregular/irregular_models.h"

#include <QTest>

#include <cmath>

using namespace tetra;

namespace {

constexpr int steps = 60;

/// Calls function(weights, place) for a lattice of places on the triangle.
template <class Function> void forEachPlace(const TriangleCorners& t, Function&& function)
{
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j) {
            const std::array<double, 3> w = {double(steps - i - j) / steps, double(i) / steps, double(j) / steps};
            function(w, Eigen::Vector3d(w[0] * t[0] + w[1] * t[1] + w[2] * t[2]));
        }
}

Eigen::Vector3d randomPlace(std::mt19937& random)
{
    std::uniform_real_distribution<double> number(-1, 1);
    return {number(random), number(random), number(random)};
}

TriangleCorners randomTriangle(std::mt19937& random)
{
    return {randomPlace(random), randomPlace(random), randomPlace(random)};
}

} // namespace

class BoundaryDistanceTest : public QObject {
    Q_OBJECT

private slots:
    void nearestPlacesAreNearest()
    {
        std::mt19937 random(1);
        for (int attempt = 0; attempt < 300; ++attempt) {
            const TriangleCorners t = randomTriangle(random);
            const Eigen::Vector3d from = 2 * randomPlace(random);
            const TrianglePlace found = nearestPlace(t, from);
            const auto& w = found.weights;
            QVERIFY(std::abs(w[0] + w[1] + w[2] - 1) < 1e-12 && std::ranges::min(w) >= 0);
            QVERIFY(std::abs((w[0] * t[0] + w[1] * t[1] + w[2] * t[2] - from).norm() - found.distance) < 1e-12);
            forEachPlace(t, [&](const auto&, const Eigen::Vector3d& place) {
                QVERIFY((place - from).norm() >= found.distance - 1e-12);
            });
        }
    }

    void valuesWithinABall()
    {
        std::mt19937 random(2);
        int partly = 0;
        for (int attempt = 0; attempt < 500; ++attempt) {
            const TriangleCorners t = randomTriangle(random);
            const Eigen::Vector3d centre = randomPlace(random);
            const double radius = std::abs(randomPlace(random)[0]);
            const Eigen::Vector3d corner = randomPlace(random);
            const std::array<double, 3> values = {corner[0], corner[1], corner[2]};
            const auto range = valuesWithin(t, values, centre, radius);
            QCOMPARE(range.has_value(), nearestPlace(t, centre).distance <= radius);
            double least = INFINITY, largest = -INFINITY;
            forEachPlace(t, [&](const auto& w, const Eigen::Vector3d& place) {
                if ((place - centre).norm() > radius)
                    return;
                const double value = w[0] * values[0] + w[1] * values[1] + w[2] * values[2];
                least = std::min(least, value);
                largest = std::max(largest, value);
            });
            if (!(least <= largest))
                continue; // smaller than the lattice
            ++partly;
            QVERIFY((*range)[0] <= least + 1e-12 && (*range)[1] >= largest - 1e-12);
            // The extremes are near places of the lattice.
            QVERIFY((*range)[0] >= least - 0.3 && (*range)[1] <= largest + 0.3);
        }
        QVERIFY(partly > 150);
    }

    void treesFindTheNearest()
    {
        const Dataset dataset = randomIrregular(4);
        std::vector<std::string> failures;
        const IrregularOriginal original(dataset, failures);
        QVERIFY(failures.empty());
        std::mt19937 random(3);
        for (int attempt = 0; attempt < 200; ++attempt) {
            const Eigen::Vector3d from = dataset.bounds().center() + 4 * randomPlace(random);
            double least = INFINITY;
            for (std::uint32_t triangle = 0; triangle < original.boundary.size(); ++triangle)
                least = std::min(least, nearestPlace(original.tree.corners(triangle), from).distance);
            QCOMPARE(original.tree.nearest(from).place.distance, least);
            const auto hint = static_cast<std::uint32_t>(random() % original.boundary.size());
            QCOMPARE(original.tree.nearest(from, hint).place.distance, least);
        }
    }

    /// The farthest of many places lies between what was found and the bound.
    void bothSidesAreMeasured()
    {
        int far = 0;
        for (std::uint32_t seed = 0; seed < 12; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            std::vector<std::string> failures;
            const IrregularOriginal original(dataset, failures);
            std::mt19937 random(seed);
            std::vector<Triangle> triangles; // any will do
            for (int i = 0; i < 10; ++i) {
                const auto point = [&] { return static_cast<std::uint32_t>(random() % dataset.pointCount()); };
                triangles.push_back({point(), point(), point()});
            }
            triangles.push_back(original.boundary.front());
            const BoundaryDistances found = distancesToOriginal(original, triangles);
            double largest = 0;
            for (const Triangle& t : triangles)
                forEachPlace({dataset.position(t[0]), dataset.position(t[1]), dataset.position(t[2])},
                             [&](const auto&, const Eigen::Vector3d& place) {
                                 largest = std::max(largest, original.tree.nearest(place).place.distance);
                             });
            QVERIFY(found.found <= found.bound && largest <= found.bound);
            QVERIFY(found.bound <= std::max(1.05 * found.found, 1.001e-3 * original.diagonal));
            QVERIFY(found.found <= largest + 0.2);
            far += largest > 0.1 ? 1 : 0;
            const BoundaryDistances none = distancesToOriginal(original, original.boundary);
            QVERIFY(none.found == 0 && none.bound == 0);
        }
        QVERIFY(far > 6);
    }
};

QTEST_GUILESS_MAIN(BoundaryDistanceTest)
#include "boundary_distance_test.moc"
