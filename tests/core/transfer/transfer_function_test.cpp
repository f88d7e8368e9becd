// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer function as a value (R18): steps, extinction, segments, and what to begin with.
#include <tan/transfer.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

using namespace tetra;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

TransferFunction stepAtFive()
{
    return transferFunctionFromPoints(
        {{0, {0, 0, 0}, 0}, {5, {1, 0, 0}, 0.5f}, {5, {0, 0, 1}, 0.25f}, {10, {0, 1, 1}, 0}}, 2);
}

TransferFunction randomFunction(std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    TransferFunction function;
    function.unitDistance = 0.1 + unit(random);
    const auto fill = [&](auto& points, const auto& pointAt) {
        for (auto count = random() % 8; count > 0; --count)
            if (const double value = std::round(20 * unit(random)) - 10;
                std::ranges::count(points, value, [](const auto& point) { return point.value; }) < 2)
                points.push_back(pointAt(value));
        std::ranges::stable_sort(points, {}, [](const auto& point) { return point.value; });
    };
    fill(function.colours, [&](double value) {
        return ColourPoint{value, {unit(random), unit(random), unit(random)}};
    });
    fill(function.opacities, [&](double value) { return OpacityPoint{value, unit(random)}; });
    return function;
}

double largestDifference(const TransferSample& a, const TransferSample& b)
{
    double largest = std::abs(a.extinction - b.extinction);
    for (std::size_t channel = 0; channel < 3; ++channel)
        largest = std::max(largest, std::abs(a.colour[channel] - b.colour[channel]));
    return largest;
}

TransferSample inSegment(const TransferSegment& segment, double value)
{
    TransferSample sample = segment.atOrigin;
    const double offset = value - segment.origin;
    for (std::size_t channel = 0; channel < 3; ++channel)
        sample.colour[channel] += offset * segment.perValue.colour[channel];
    sample.extinction += offset * segment.perValue.extinction;
    return sample;
}

} // namespace

class TransferFunctionTest : public QObject {
    Q_OBJECT

private slots:
    /// What error fields take of a function (C3): shares of its largest opacity, nothing outside of the mask.
    void opacitiesAsKnots()
    {
        TransferFunction function;
        QVERIFY(opacityKnots(function).empty());
        function.opacities = {{0, 0}, {10, 0.5F}, {10, 0.25F}, {20, 0}};
        using Knots = std::vector<std::array<double, 2>>;
        QVERIFY((opacityKnots(function) == Knots{{0, 0}, {10, 1}, {10, 0.5}, {20, 0}}));
        function.mask = TransferMask{15, 30};
        QVERIFY((opacityKnots(function) == Knots{{15, 0}, {15, 1}, {20, 0}, {30, 0}, {30, 0}}));
        function.mask = TransferMask{21, 30};
        QVERIFY(opacityKnots(function).empty());
    }

    void extinctionGivesTheOpacityOfTheUnitDistance()
    {
        for (const double opacity : {0.0, 0.01, 0.5, 0.999})
            QVERIFY(std::abs(1 - std::exp(-extinctionOf(opacity, 0.3) * 0.3) - opacity) < 1e-12);
        QVERIFY(std::isfinite(extinctionOf(1, 1)));
    }

    void isLinearBetweenPointsAndConstantBeyond()
    {
        const TransferFunction function = stepAtFive();
        QCOMPARE(evaluate(function, -3).extinction, 0.0);
        QCOMPARE(evaluate(function, 2.5).colour[0], 0.5);
        QCOMPARE(evaluate(function, 2.5).extinction, extinctionOf(0.5, 2) / 2);
        QCOMPARE(evaluate(function, 12).colour[1], 1.0);
        QCOMPARE(evaluate(function, 12).extinction, 0.0);
    }

    void aStepBelongsToTheUpperSide()
    {
        const TransferFunction function = stepAtFive();
        QCOMPARE(evaluate(function, 5).colour[2], 1.0);
        QCOMPARE(evaluate(function, 5).extinction, extinctionOf(0.25, 2));
        QVERIFY(evaluate(function, std::nextafter(5.0, 0.0)).colour[0] > 0.999);
    }

    void nothingAndNanAreTransparent()
    {
        QCOMPARE(evaluate({}, 1).extinction, 0.0);
        QCOMPARE(evaluate(stepAtFive(), notANumber).extinction, 0.0);
    }

    void segmentsCoverAllValuesAndAgreeWithTheFunction()
    {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> value(-12, 12);
        for (int round = 0; round < 200; ++round) {
            const TransferFunction function = randomFunction(random);
            QVERIFY(checkTransferFunction(function).ok());
            const auto segments = transferSegments(function);
            QCOMPARE(segments.front().begin, -infinity);
            QCOMPARE(segments.back().end, infinity);
            for (std::size_t i = 1; i < segments.size(); ++i)
                QCOMPARE(segments[i].begin, segments[i - 1].end);
            for (int i = 0; i < 20; ++i) {
                const double at = i % 4 == 0 ? std::round(value(random)) : value(random);
                const auto segment = std::ranges::find_if(
                    segments, [&](const TransferSegment& one) { return at >= one.begin && at < one.end; });
                QVERIFY(segment != segments.end());
                const TransferSample look = evaluate(function, at);
                QVERIFY(std::abs(inSegment(*segment, at).extinction - look.extinction) < 1e-11);
                if (!function.opacities.empty())
                    QVERIFY(largestDifference(inSegment(*segment, at), look) < 1e-11);
            }
        }
    }

    /// Colours have their steps where opacities have none.
    void theCurvesAreTheirOwn()
    {
        const TransferFunction function{
            {{0, {0, 0, 0}}, {2, {1, 0, 0}}, {2, {0, 1, 0}}}, {{1, 0}, {3, 0.75f}, {4, 0.25f}}, 0.5};
        QCOMPARE(evaluate(function, 1).colour[0], 0.5);
        QCOMPARE(evaluate(function, 1).extinction, 0.0);
        QCOMPARE(evaluate(function, 2).colour[1], 1.0);
        QCOMPARE(evaluate(function, 2).extinction, extinctionOf(0.75, 0.5) / 2);
        QCOMPARE(evaluate(function, 9).extinction, extinctionOf(0.25, 0.5));
        const auto segments = transferSegments(function);
        QCOMPARE(segments.size(), std::size_t(6));
        QCOMPARE(segments[3].begin, 2.0);
        QCOMPARE(segments[3].end, 3.0);
        QCOMPARE(segments[3].perValue.colour[1], 0.0);
        // What either curve has alone changes nothing of the other's.
        QCOMPARE(evaluate({{{1, {0, 1, 0}}}, {}}, 1).extinction, 0.0);
        QCOMPARE(evaluate({{}, {{1, 0.5f}}}, 1).colour, (std::array{1.0, 1.0, 1.0}));
    }

    void pointsOfBothCurves()
    {
        const std::vector<TransferPoint> points{
            {0, {0, 0, 0}, 0}, {5, {1, 0, 0}, 0.5f}, {5, {0, 0, 1}, 0.25f, 3}, {10, {0, 1, 1}, 0}};
        QCOMPARE(transferPoints(transferFunctionFromPoints(points, 2)), points);
        QVERIFY(transferPoints({}).empty());
        std::mt19937 random(6);
        std::uniform_real_distribution<double> value(-12, 12);
        for (int round = 0; round < 200; ++round) {
            const TransferFunction function = randomFunction(random);
            const auto joined = transferFunctionFromPoints(transferPoints(function), function.unitDistance);
            QVERIFY(checkTransferFunction(joined).ok());
            for (int i = 0; i < 20; ++i) {
                const double at = i % 4 == 0 ? std::round(value(random)) : value(random);
                const auto opacity = [&](const TransferFunction& of) {
                    return -std::expm1(-evaluate(of, at).extinction * of.unitDistance);
                };
                QVERIFY(std::abs(opacity(joined) - opacity(function)) < 1e-5);
                for (std::size_t channel = 0; channel < 3; ++channel)
                    QVERIFY(std::abs(evaluate(joined, at).colour[channel] - evaluate(function, at).colour[channel]) <
                            1e-6);
            }
        }
    }

    void refusesWhatIsNoFunction_data();
    void refusesWhatIsNoFunction();
    void defaultsCoverTheRange();
};

void TransferFunctionTest::refusesWhatIsNoFunction_data()
{
    QTest::addColumn<TransferFunction>("function");
    QTest::addColumn<QString>("word");
    QTest::newRow("order") << transferFunctionFromPoints({{1, {}, 0}, {0, {}, 0}}, 1) << "ascending";
    QTest::newRow("three of one value") << transferFunctionFromPoints({{1, {}, 0}, {1, {}, 0}, {1, {}, 0}}, 1)
                                        << "third";
    QTest::newRow("NaN value") << transferFunctionFromPoints({{notANumber, {}, 0}}, 1) << "finite";
    QTest::newRow("infinite value") << transferFunctionFromPoints({{infinity, {}, 0}}, 1) << "finite";
    QTest::newRow("colour") << transferFunctionFromPoints({{1, {0, 2, 0}, 0}}, 1)
                            << "Colour 1 of the transfer function has a channel";
    QTest::newRow("opacity") << transferFunctionFromPoints({{1, {}, -0.1f}}, 1)
                             << "Opacity 1 of the transfer function is outside";
    QTest::newRow("NaN opacity") << transferFunctionFromPoints({{1, {}, std::nanf("")}}, 1)
                                 << "Opacity 1 of the transfer function is outside";
    QTest::newRow("unit distance") << TransferFunction{{}, {}, 0} << "unit distance";
    QTest::newRow("infinite unit distance") << TransferFunction{{}, {}, infinity} << "unit distance";
}

void TransferFunctionTest::refusesWhatIsNoFunction()
{
    QFETCH(TransferFunction, function);
    QFETCH(QString, word);
    const Status status = checkTransferFunction(function);
    QVERIFY(!status.ok());
    QVERIFY2(QString::fromStdString(status.error().text()).contains(word), status.error().text().c_str());
}

void TransferFunctionTest::defaultsCoverTheRange()
{
    for (const auto make : {sequentialTransferFunction, divergingTransferFunction}) {
        const TransferFunction function = make(-3, 17, 0.5);
        QVERIFY(checkTransferFunction(function).ok());
        QCOMPARE(transferPoints(function).front().value, -3.0);
        QCOMPARE(transferPoints(function).back().value, 17.0);
        QCOMPARE(function.unitDistance, 0.5);
        for (const auto& [smallest, largest] : {std::pair{4.0, 4.0}, {infinity, -infinity}, {notANumber, 1.0}})
            QVERIFY(checkTransferFunction(make(smallest, largest, 1)).ok());
    }
    // Lightness rises with the value, so that the order of the colours is seen without telling hues apart.
    const TransferFunction function = sequentialTransferFunction(0, 1, 1);
    const auto lightness = [](const ColourPoint& point) {
        return 0.2126f * point.colour[0] + 0.7152f * point.colour[1] + 0.0722f * point.colour[2];
    };
    QVERIFY(std::ranges::is_sorted(function.colours, {}, lightness));
}

QTEST_GUILESS_MAIN(TransferFunctionTest)
#include "transfer_function_test.moc"
