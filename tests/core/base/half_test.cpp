// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rounding.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace tetra;

class HalfTest : public QObject {
    Q_OBJECT

private slots:
    void knownValues_data()
    {
        QTest::addColumn<int>("half");
        QTest::addColumn<float>("value");
        QTest::newRow("zero") << 0x0000 << 0.0f;
        QTest::newRow("smallest") << 0x0001 << 0x1p-24f;
        QTest::newRow("largest subnormal") << 0x03ff << 1023 * 0x1p-24f;
        QTest::newRow("smallest normal") << 0x0400 << 0x1p-14f;
        QTest::newRow("a third") << 0x3555 << 0.333251953125f;
        QTest::newRow("one") << 0x3c00 << 1.0f;
        QTest::newRow("minus two") << 0xc000 << -2.0f;
        QTest::newRow("largest") << 0x7bff << 65504.0f;
        QTest::newRow("infinity") << 0x7c00 << std::numeric_limits<float>::infinity();
    }
    void knownValues()
    {
        QFETCH(int, half);
        QFETCH(float, value);
        QCOMPARE(halfToFloat(static_cast<std::uint16_t>(half)), value);
        if (value >= 0)
            QCOMPARE(int(halfRoundedUp(value)), half);
    }

    void everyHalfSurvives()
    {
        for (std::uint32_t half = 0; half <= 0x7c00; ++half)
            QCOMPARE(std::uint32_t(halfRoundedUp(halfToFloat(static_cast<std::uint16_t>(half)))), half);
        QVERIFY(std::isnan(halfToFloat(0x7e00)));
    }

    /// Just above each half comes the next one; between two, the upper one.
    void roundsUp()
    {
        for (std::uint32_t half = 0; half < 0x7bff; ++half) {
            const float value = halfToFloat(static_cast<std::uint16_t>(half));
            const float next = halfToFloat(static_cast<std::uint16_t>(half + 1));
            QCOMPARE(std::uint32_t(halfRoundedUp(std::nextafter(value, next))), half + 1);
            QCOMPARE(std::uint32_t(halfRoundedUp(std::nextafter(next, value))), half + 1);
            QCOMPARE(std::uint32_t(halfRoundedUp(value / 2 + next / 2)), half + 1);
        }
        QCOMPARE(int(halfRoundedUp(65505.0f)), 0x7c00);
        QCOMPARE(int(halfRoundedUp(std::numeric_limits<float>::denorm_min())), 1);
        QCOMPARE(int(halfRoundedUp(std::numeric_limits<float>::quiet_NaN())), 0x7c00);
    }
};

QTEST_GUILESS_MAIN(HalfTest)
#include "half_test.moc"
