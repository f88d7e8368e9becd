// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/orientation.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace tetra;

namespace {

using Point = std::array<double, 3>;
using Integer = __int128;

/// The same sign in integers; products of three differences below 2^124.
int signInIntegers(const Point& a, const Point& b, const Point& c, const Point& d)
{
    const auto offset = [&a](const Point& p) {
        std::array<Integer, 3> difference{};
        for (std::size_t k = 0; k < 3; ++k)
            difference[k] = static_cast<Integer>(p[k]) - static_cast<Integer>(a[k]);
        return difference;
    };
    const auto u = offset(b), v = offset(c), w = offset(d);
    const Integer determinant =
        u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2]) + u[2] * (v[0] * w[1] - v[1] * w[0]);
    return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

} // namespace

class ExactOrientationTest : public QObject {
    Q_OBJECT
private slots:
    void unitTetrahedron()
    {
        QCOMPARE(orientationSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
        QCOMPARE(orientationSign({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
        QCOMPARE(orientationSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}), 0);
    }

    /// S6: points on a line or in a plane up to the last bit: integers say what is right.
    void nearlyFlatAgreesWithIntegers()
    {
        std::mt19937_64 random(7);
        std::array<int, 3> seen{};
        for (int trial = 0; trial < 20000; ++trial) {
            const auto number = [&](std::int64_t bound) {
                return static_cast<double>(static_cast<std::int64_t>(random() % std::uint64_t(2 * bound)) - bound);
            };
            constexpr std::int64_t large = std::int64_t(1) << 35;
            const Point a{number(large), number(large), number(large)};
            const Point u{number(1 << 20), number(1 << 20), number(1 << 20)};
            const Point v{number(1 << 20), number(1 << 20), number(1 << 20)};
            Point b{}, c{}, d{};
            const double s = number(1000), t = number(1000);
            for (std::size_t k = 0; k < 3; ++k) {
                b[k] = a[k] + u[k];
                c[k] = a[k] + v[k];
                d[k] = a[k] + s * u[k] + t * v[k] + (random() % 8 == 0 ? number(2) : 0);
            }
            const int expected = signInIntegers(a, b, c, d);
            QCOMPARE(orientationSign(a, b, c, d), expected);
            ++seen[static_cast<std::size_t>(expected + 1)];
        }
        QVERIFY(*std::ranges::min_element(seen) > 1000);
    }

    /// A point so far away, and nearly in the plane of near ones, that its digits are all that a double has.
    void farPointsAgreeWithIntegers()
    {
        std::mt19937_64 random(8);
        std::array<int, 3> seen{};
        for (int trial = 0; trial < 20000; ++trial) {
            const auto number = [&](std::int64_t bound) {
                return static_cast<double>(static_cast<std::int64_t>(random() % std::uint64_t(2 * bound)) - bound);
            };
            const auto near = [&] { return Point{number(1 << 15), number(1 << 15), number(1 << 15)}; };
            const Point a = near(), b = near(), c = near();
            constexpr std::int64_t large = std::int64_t(1) << 34;
            const double s = number(large), t = number(large);
            Point d{}, direction{};
            for (std::size_t k = 0; k < 3; ++k) {
                direction[k] = s * (b[k] - a[k]) + t * (c[k] - a[k]) + (random() % 8 == 0 ? number(2) : 0);
                d[k] = a[k] + direction[k];
            }
            const int expected = signInIntegers(a, b, c, d);
            QCOMPARE(orientationSign(a, b, c, d), expected);
            QCOMPARE(orientationSign(b, a, d, c), expected);
            QCOMPARE(directionSign(a, b, c, direction), expected);
            QCOMPARE(directionSign(b, a, c, direction), -expected);
            ++seen[static_cast<std::size_t>(expected + 1)];
        }
        QVERIFY(*std::ranges::min_element(seen) > 1000);
    }

    /// Differences that are no doubles: c - a is (0, 1, 1) but for 1e-30.
    void directionsBesidePlanesThatRound()
    {
        QCOMPARE(directionSign({0, 0, 1e-30}, {1, 0, 1e-30}, {0, 1, 1}, {1, 1, 1}), 1);
        QCOMPARE(directionSign({0, 0, -1e-30}, {1, 0, -1e-30}, {0, 1, 1}, {1, 1, 1}), -1);
        QCOMPARE(directionSign({0, 0, 1e-30}, {1, 0, 1e-30}, {0, 1, 1}, {1, 1, 1 - 0x1p-53}), -1);
        QCOMPARE(directionSign({0, 0, 0}, {1, 0, 0}, {0, 1, 1}, {1, 1, 1}), 0);
        QCOMPARE(directionSign({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 7, 0}), 0);
    }

    /// The coordinates need no common exponent.
    void smallOffsetsBesideLargeCoordinates()
    {
        const double tiny = 1e-40;
        QCOMPARE(orientationSign({1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}, {1e6 + 0.5, 0.5, tiny}), 1);
        QCOMPARE(orientationSign({1e6, 0, 0}, {1e6 + 1, 0, 0}, {1e6, 1, 0}, {1e6 + 0.5, 0.5, -tiny}), -1);
        QCOMPARE(orientationSign({0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.7, 0.1}, {0.1, 0.1, 0.1}), 0);
    }
};

QTEST_APPLESS_MAIN(ExactOrientationTest)
#include "exact_orientation_test.moc"
