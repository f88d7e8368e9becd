// SPDX-License-Identifier: GPL-3.0-or-later
#include <tan/transfer.h>

#include <QTest>

#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace tetra;

class ValueHistogramTest : public QObject {
    Q_OBJECT

private slots:
    void countsAsASlowCountDoes()
    {
        std::mt19937 random(1);
        std::normal_distribution<float> value(3, 2);
        std::vector<float> values(2000);
        for (float& one : values)
            one = value(random);
        const ValueHistogram histogram = valueHistogram(values, 0, 8, 16);
        QCOMPARE(histogram.counts.size(), std::size_t{16});
        for (std::size_t part = 0; part < 16; ++part) {
            const double begin = 0.5 * static_cast<double>(part);
            const auto count = std::ranges::count_if(
                values, [&](float one) { return one >= begin && (one < begin + 0.5 || (part == 15 && one == 8)); });
            QCOMPARE(histogram.counts[part], static_cast<std::uint64_t>(count));
        }
    }

    void endsBelongToItAndNothingOutsideDoes()
    {
        const std::vector<float> values{0, 10, -1, 11, std::numeric_limits<float>::quiet_NaN(), 5};
        const ValueHistogram histogram = valueHistogram(values, 0, 10, 4);
        QCOMPARE(histogram.counts, (std::vector<std::uint64_t>{1, 0, 1, 1}));
        QCOMPARE(histogram.highest(), std::uint64_t{1});
    }

    void nothingComesOfNoRange()
    {
        QVERIFY(valueHistogram({}, 0, std::numeric_limits<double>::infinity(), 4).counts.empty());
        QVERIFY(valueHistogram({}, 1, 0, 4).counts.empty());
        QVERIFY(valueHistogram({}, 0, 1, 0).counts.empty());
        QCOMPARE(valueHistogram(std::vector<float>{2, 2}, 2, 2, 3).counts, (std::vector<std::uint64_t>{2, 0, 0}));
    }

    void logarithmsHaveEqualPartsOfFactors()
    {
        const std::vector<float> values{1, 5, 9.9F, 11, 99, 100, 1000, 0, -3, 1001};
        const ValueHistogram histogram = logarithmicHistogram(values, 1, 1000, 3);
        QCOMPARE(histogram.counts, (std::vector<std::uint64_t>{3, 2, 2}));
        QVERIFY(std::abs(histogram.least) < 1e-12 && std::abs(histogram.largest - std::log(1000.0)) < 1e-6);
        QVERIFY(logarithmicHistogram(values, 0, 1000, 3).counts.empty());
        QVERIFY(logarithmicHistogram(values, -1, 1000, 3).counts.empty());
    }

    void rareValuesAreHigherInLogarithms()
    {
        QCOMPARE(barHeight(0, 0, false), 0.0);
        QCOMPARE(barHeight(50, 100, false), 0.5);
        QCOMPARE(barHeight(100, 100, true), 1.0);
        QCOMPARE(barHeight(0, 100, true), 0.0);
        QVERIFY(barHeight(1, 10000, true) > 100 * barHeight(1, 10000, false));
    }
};

QTEST_APPLESS_MAIN(ValueHistogramTest)
#include "value_histogram_test.moc"
