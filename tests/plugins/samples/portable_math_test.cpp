// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/portable_math.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace tetra;

class PortableMathTest : public QObject {
    Q_OBJECT

private slots:
    void exponentialIsAccurate()
    {
        for (int i = -700000; i <= 700000; i += 7) {
            const double x = i * 0.001;
            const double expected = std::exp(x);
            QVERIFY(std::abs(portableExponential(x) - expected) <= 4e-16 * expected);
        }
    }
    void exponentialIsClamped()
    {
        QCOMPARE(portableExponential(0), 1.0);
        QCOMPARE(portableExponential(-1e300), portableExponential(-700));
        QCOMPARE(portableExponential(1e300), portableExponential(700));
    }
    void cosineIsAccurate()
    {
        for (int i = -100000; i <= 100000; ++i) {
            const double turns = i * 0.000123;
            const double rest = turns - std::floor(turns);
            QVERIFY(std::abs(portableCosineOfTurns(turns) - std::cos(2 * std::numbers::pi * rest)) <= 2e-15);
        }
    }
    void cosineIsExactAtQuarterTurns()
    {
        for (int turns = -3; turns <= 3; ++turns) {
            QCOMPARE(portableCosineOfTurns(turns), 1.0);
            QCOMPARE(portableCosineOfTurns(turns + 0.5), -1.0);
            QVERIFY(portableCosineOfTurns(turns + 0.25) == 0);
        }
    }
};

QTEST_GUILESS_MAIN(PortableMathTest)
#include "portable_math_test.moc"
