// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/verify/exact_cell.h"

#include <Eigen/Geometry>
#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;
using Position = Eigen::Vector3d;

/// Signs against exact integers, and where rounding alone would answer wrongly.
class ExactVolumeTest : public QObject {
    Q_OBJECT

private slots:
    void agreesWithIntegers()
    {
        std::mt19937 random(1);
        int flat = 0;
        for (int attempt = 0; attempt < 20000; ++attempt) {
            const int range = attempt % 2 == 0 ? 3 : 100000;
            std::array<std::array<std::int64_t, 3>, 4> p{};
            for (auto& point : p)
                for (auto& coordinate : point)
                    coordinate = static_cast<std::int64_t>(random() % static_cast<unsigned>(range)) - range / 2;
            const auto d = [&](std::size_t i, std::size_t axis) { return p[i][axis] - p[0][axis]; };
            const std::int64_t determinant = d(1, 0) * (d(2, 1) * d(3, 2) - d(2, 2) * d(3, 1)) +
                                             d(1, 1) * (d(2, 2) * d(3, 0) - d(2, 0) * d(3, 2)) +
                                             d(1, 2) * (d(2, 0) * d(3, 1) - d(2, 1) * d(3, 0));
            // A shift and a power of two change no sign; the shift makes the differences of what was rounded exact.
            const double scale = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
            const auto place = [&](std::size_t i) {
                return Position(scale * (4e9 + static_cast<double>(p[i][0])), scale * static_cast<double>(p[i][1]),
                                scale * (-7e8 + static_cast<double>(p[i][2])));
            };
            QCOMPARE(volumeSign(place(0), place(1), place(2), place(3)), (determinant > 0) - (determinant < 0));
            flat += determinant == 0;
        }
        QVERIFY(flat > 1000);
    }

    /// Points at thirds and tenths are not where they seem: one unit in the last place decides.
    void theLastBitDecides()
    {
        const Position a(0.1, 0.1, 0.1), b(0.2, 0.7, 0.1), c(0.9, 0.3, 0.1);
        Position d(0.4, 0.5, 0.1);
        QCOMPARE(volumeSign(a, b, c, d), 0);
        const Eigen::Vector3d normal = (b - a).cross(c - a);
        const int up = normal[2] > 0 ? 1 : -1;
        d[2] = std::nextafter(0.1, 1);
        QCOMPARE(volumeSign(a, b, c, d), up);
        d[2] = std::nextafter(0.1, 0);
        QCOMPARE(volumeSign(a, b, c, d), -up);
    }

    /// Swapping two points turns the sign, however thin the cell is.
    void isAntisymmetric()
    {
        std::mt19937 random(2);
        std::uniform_real_distribution<double> number(-1, 1);
        for (int attempt = 0; attempt < 5000; ++attempt) {
            std::array<Position, 4> p;
            for (Position& point : p)
                point = {number(random), number(random), number(random)};
            p[3] = p[0] + 0.3 * (p[1] - p[0]) + 0.4 * (p[2] - p[0]); // rounded: on either side of the plane
            const int sign = volumeSign(p[0], p[1], p[2], p[3]);
            QCOMPARE(volumeSign(p[1], p[0], p[2], p[3]), -sign);
            QCOMPARE(volumeSign(p[0], p[2], p[1], p[3]), -sign);
            QCOMPARE(volumeSign(p[0], p[1], p[3], p[2]), -sign);
            QCOMPARE(volumeSign(p[3], p[1], p[2], p[0]), -sign);
            QCOMPARE(volumeSign(p[2], p[0], p[1], p[3]), sign);
        }
    }
};

QTEST_GUILESS_MAIN(ExactVolumeTest)
#include "exact_volume_test.moc"
