// SPDX-License-Identifier: GPL-3.0-or-later
// What a transfer function that fits a histogram looks like, whatever the histogram.
#include <tan/transfer.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace tetra;

namespace {

constexpr std::size_t parts = 256;

/// 70 % of the volume within the tenth of the values around `place` (in [0, 1]), the others all alike.
ValueHistogram withBackground(double place, double least, double largest)
{
    ValueHistogram histogram{least, largest, std::vector<std::uint64_t>(parts, 300)};
    const auto first = static_cast<std::size_t>(std::clamp(place - 0.05, 0.0, 0.9) * parts);
    for (std::size_t part = first; part < first + parts / 10; ++part)
        histogram.counts[part] += 7000;
    return histogram;
}

ValueHistogram randomHistogram(std::mt19937& random)
{
    ValueHistogram histogram{-3, 5, std::vector<std::uint64_t>(1 + random() % 300)};
    std::exponential_distribution<double> spread(1);
    for (auto& count : histogram.counts)
        count = static_cast<std::uint64_t>(std::exp(4 * spread(random)));
    return histogram;
}

double meanDepth(const ValueHistogram& volumes, const TransferFunction& function, double length)
{
    double sum = 0, total = 0;
    for (std::size_t part = 0; part < volumes.counts.size(); ++part) {
        const double place = (static_cast<double>(part) + 0.5) / static_cast<double>(volumes.counts.size());
        const auto count = static_cast<double>(volumes.counts[part]);
        sum += count * evaluate(function, std::lerp(volumes.least, volumes.largest, place)).extinction;
        total += count;
    }
    return sum / total * length;
}

} // namespace

class FittedTransferFunctionTest : public QObject {
    Q_OBJECT

private slots:
    void whatFillsTheDomainIsTransparent_data()
    {
        QTest::addColumn<double>("place");
        QTest::newRow("air around a part") << 0.05;
        QTest::newRow("flow around a body") << 0.4;
        QTest::newRow("water around bubbles") << 0.95;
    }
    void whatFillsTheDomainIsTransparent()
    {
        QFETCH(double, place);
        const TransferFunction function = fittedTransferFunction(withBackground(place, -10, 30), 2);
        QVERIFY(checkTransferFunction(function).ok());
        const double background = evaluate(function, -10 + 40 * place).extinction;
        for (const double other : {0.05, 0.25, 0.4, 0.6, 0.75, 0.95})
            if (std::abs(other - place) > 0.15) {
                const double extinction = evaluate(function, -10 + 40 * other).extinction;
                QVERIFY2(extinction > 10 * background, qPrintable(QString::number(other)));
                QVERIFY(extinction > extinctionOf(0.01, 2));
            }
    }

    /// Exactly nothing within the error of the background, and nothing less of what lies farther off than twice that.
    void whatTheErrorMakesOfTheBackgroundIsTransparent_data()
    {
        QTest::addColumn<double>("place");
        QTest::addColumn<double>("error");
        for (const double place : {0.0, 0.4, 1.0})
            for (const double error : {0.0, 0.02, 0.1, 0.3})
                QTest::addRow("%g, error %g", place, error) << place << error;
    }
    void whatTheErrorMakesOfTheBackgroundIsTransparent()
    {
        QFETCH(double, place);
        QFETCH(double, error);
        ValueHistogram histogram{-10, 30, std::vector<std::uint64_t>(parts, 5)};
        histogram.counts[static_cast<std::size_t>(place * (parts - 1))] = 90'000;
        const auto background = backgroundValues(histogram);
        QVERIFY(background.has_value());
        const double reach = 40 * error;
        const TransferFunction function = fittedTransferFunction(histogram, 2, reach);
        QVERIFY(checkTransferFunction(function).ok());
        const TransferFunction exact = fittedTransferFunction(histogram, 2);
        bool isSeen = false;
        for (double value = -10; value <= 30; value += 0.01) {
            const double distance = std::max(background->least - value, value - background->largest);
            const double extinction = evaluate(function, value).extinction;
            if (distance <= reach)
                QCOMPARE(extinction, 0.0);
            else if (distance > 2 * 1.06 * reach + 40.0 / 16 && place != 0.4)
                QVERIFY(extinction >= evaluate(exact, value).extinction * (1 - 1e-5));
            isSeen = isSeen || extinction > extinctionOf(0.02, 2);
        }
        QVERIFY(isSeen);
        ErrorRemarkInput input{.range = {-10, 30},
                               .background = background,
                               .transfer = &function,
                               .errorAt = [&](double) { return reach; }};
        // What is left to see may be fewer values than so large an error: that is told, and true.
        for (const ErrorRemark& remark : errorRemarks(input))
            QVERIFY(remark.kind == ErrorRemark::Kind::NarrowOpacity && error > 0.25);
    }

    void everyErrorGivesAFunction()
    {
        std::mt19937 random(5);
        for (int turn = 0; turn < 100; ++turn) {
            const ValueHistogram histogram = randomHistogram(random);
            for (const double error : {0.01, 0.5, 3.0, 8.0, 1e9}) {
                const TransferFunction function = fittedTransferFunction(histogram, 1, error);
                QVERIFY(checkTransferFunction(function).ok());
                QCOMPARE(function.opacities.front().value, histogram.least);
                QCOMPARE(function.opacities.back().value, histogram.largest);
                if (histogram.counts.size() > 32)
                    QVERIFY(meanDepth(histogram, function, 20) < 8);
            }
        }
    }

    void equallyFrequentValuesRise()
    {
        const TransferFunction function = fittedTransferFunction({0, 1, std::vector<std::uint64_t>(parts, 9)}, 1);
        QVERIFY(!function.opacities.empty());
        for (std::size_t point = 1; point < function.opacities.size(); ++point)
            QVERIFY(function.opacities[point].opacity > function.opacities[point - 1].opacity);
    }

    /// Points over the whole range in order, nothing that hides all that is behind, something to see.
    void allHistogramsGiveFunctions()
    {
        std::mt19937 random(3);
        for (int turn = 0; turn < 300; ++turn) {
            const ValueHistogram histogram = randomHistogram(random);
            const double unitDistance = 0.01 * static_cast<double>(1 + random() % 1000);
            const TransferFunction function = fittedTransferFunction(histogram, unitDistance);
            QVERIFY(checkTransferFunction(function).ok());
            QCOMPARE(function.unitDistance, unitDistance);
            QCOMPARE(function.opacities.front().value, histogram.least);
            QCOMPARE(function.opacities.back().value, histogram.largest);
            QVERIFY(std::ranges::any_of(function.opacities, [](const auto& point) { return point.opacity > 0.02f; }));
            QVERIFY(std::ranges::none_of(function.opacities, [](const auto& point) { return point.opacity > 0.91f; }));
            if (histogram.counts.size() > 32)
                QVERIFY(meanDepth(histogram, function, 20 * unitDistance) < 8);
        }
    }

    /// Neither the units of the values nor those of the volume matter.
    void unitsDoNotMatter()
    {
        ValueHistogram histogram = withBackground(0.2, 0, 1);
        const TransferFunction one = fittedTransferFunction(histogram, 1);
        for (auto& count : histogram.counts)
            count *= 1'000'003;
        histogram.least = 1e6;
        histogram.largest = 3e6;
        const TransferFunction other = fittedTransferFunction(histogram, 7);
        QCOMPARE(other.opacities.size(), one.opacities.size());
        for (std::size_t point = 0; point < one.opacities.size(); ++point) {
            QVERIFY(std::abs(other.opacities[point].opacity - one.opacities[point].opacity) < 1e-6f);
            QVERIFY(std::abs(other.opacities[point].value - (1e6 + 2e6 * one.opacities[point].value)) < 1e-3);
        }
    }

    void nothingKnownIsTheSequentialOne()
    {
        constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(fittedTransferFunction({2, 5, {}}, 3) == sequentialTransferFunction(2, 5, 3));
        QVERIFY(fittedTransferFunction({2, 5, {0, 0}}, 3) == sequentialTransferFunction(2, 5, 3));
        QVERIFY(fittedTransferFunction({5, 5, {7}}, 3) == sequentialTransferFunction(5, 5, 3));
        QVERIFY(checkTransferFunction(fittedTransferFunction({notANumber, 5, {7}}, 3)).ok());
    }
};

QTEST_GUILESS_MAIN(FittedTransferFunctionTest)
#include "fitted_transfer_function_test.moc"
