// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/moving.h"
#include "plugins/widgets/curves/reshaping.h"

#include <QRandomGenerator>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace tetra;

/// Values on a logarithmic axis (R18): places, moves along it, and functions that follow the logarithm.
class ValueAxisTest : public QObject {
    Q_OBJECT
private slots:
    void placesComeBack();
    void movesAreFactors();
    void whatDoesNotMoveKeepsItsBits();
    void neighboursStopPushAndPass();
    void zeroHasNoPlace();
    void randomMovesStayValid();
    void theCourseIsThatOfTheLogarithm_data();
    void theCourseIsThatOfTheLogarithm();
    void stepsAndValuesBelowZeroStay();
};

namespace {

JoinedFunction threePoints()
{
    return {{{1, {1, 0, 0}, 0.1F}, {10, {0, 1, 0}, 0.5F}, {1000, {0, 0, 1}, 0.9F}}, 1};
}

SelectionMove byFactor(double factor)
{
    return {.value = std::log(factor), .valueAxis = ValueAxis::Logarithmic};
}

} // namespace

void ValueAxisTest::placesComeBack()
{
    for (const double value : {1e-300, 0.003, 1.0, 7.0, 1e9, 1e300})
        for (const ValueAxis axis : {ValueAxis::Linear, ValueAxis::Logarithmic})
            QVERIFY(std::abs(valueOnAxis(placeOnAxis(value, axis), axis) / value - 1) < 1e-12);
    QVERIFY(hasPlaces({-1, 1}, ValueAxis::Linear));
    QVERIFY(!hasPlaces({0, 1}, ValueAxis::Logarithmic));
    QVERIFY(hasPlaces({1e-9, 1}, ValueAxis::Logarithmic));
}

void ValueAxisTest::movesAreFactors()
{
    const auto moved = moveSelected(threePoints(), {0, 1}, byFactor(3), NeighbourRule::Stop, {1, 1000});
    QVERIFY(std::abs(moved.function.points[0].value - 3) < 1e-9);
    QVERIFY(std::abs(moved.function.points[1].value - 30) < 1e-9);
    QCOMPARE(moved.selection, (TransferSelection{0, 1}));
    const auto atTheEnd = moveSelected(threePoints(), {2}, byFactor(100), NeighbourRule::Stop, {0.5, 5000});
    QCOMPARE(atTheEnd.function.points[2].value, 5000.0);
    const auto atTheBeginning = moveSelected(threePoints(), {0}, byFactor(0.01), NeighbourRule::Stop, {0.5, 5000});
    QCOMPARE(atTheBeginning.function.points[0].value, 0.5);
}

void ValueAxisTest::whatDoesNotMoveKeepsItsBits()
{
    JoinedFunction function = threePoints();
    function.points[0].value = 0.1 + 0.2;
    function.points[2].value = 1234.56789012345;
    const auto moved = moveSelected(function, {1}, byFactor(1.7), NeighbourRule::Stop, {0.1, 5000});
    QCOMPARE(moved.function.points[0], function.points[0]);
    QCOMPARE(moved.function.points[2], function.points[2]);
    QVERIFY(moved.function.points[1].value != function.points[1].value);
}

void ValueAxisTest::neighboursStopPushAndPass()
{
    const TransferLimits limits{1, 1000};
    JoinedFunction function = threePoints();
    function.points[2].value = 100;
    const auto at = [&](NeighbourRule rule, std::size_t point) {
        return moveSelected(function, {1}, byFactor(20), rule, limits).function.points[point].value;
    };
    QVERIFY(at(NeighbourRule::Stop, 1) < 100 && at(NeighbourRule::Stop, 1) > 99.9);
    QVERIFY(at(NeighbourRule::Push, 2) > 200 && std::abs(at(NeighbourRule::Push, 1) - 200) < 1e-9);
    QCOMPARE(at(NeighbourRule::Pass, 1), 100.0);
    QVERIFY(std::abs(at(NeighbourRule::Pass, 2) - 200) < 1e-9);
}

void ValueAxisTest::zeroHasNoPlace()
{
    JoinedFunction function = threePoints();
    function.points[0].value = 0;
    QCOMPARE(moveSelected(function, {1}, byFactor(2), NeighbourRule::Stop, {0.5, 1000}).function, function);
    QCOMPARE(moveSelected(threePoints(), {1}, byFactor(2), NeighbourRule::Stop, {0, 1000}).function, threePoints());
}

void ValueAxisTest::randomMovesStayValid()
{
    QRandomGenerator random(5);
    for (int round = 0; round < 3000; ++round) {
        JoinedFunction function;
        double value = 1e-3;
        for (int point = 0; point < 6; ++point) {
            if (point == 0 || random.bounded(4) != 0 ||
                (point > 1 && function.points[static_cast<std::size_t>(point) - 2].value == value))
                value *= 1 + random.bounded(3.0) + 1e-9;
            function.points.push_back({value, {}, static_cast<float>(random.bounded(1.0))});
        }
        QVERIFY(checkTransferFunction(separated(function)));
        const TransferSelection selection{static_cast<std::size_t>(random.bounded(3)),
                                          3 + static_cast<std::size_t>(random.bounded(3))};
        const auto rule = static_cast<NeighbourRule>(random.bounded(3));
        const TransferLimits limits{1e-3, value * (1 + random.bounded(2.0))};
        const auto moved = moveSelected(function, selection, byFactor(std::exp(random.bounded(6.0) - 3)), rule, limits);
        QVERIFY(checkTransferFunction(separated(moved.function)));
        QCOMPARE(moved.function.points.size(), function.points.size());
        QVERIFY(moved.function.points.front().value >= limits.least);
        QVERIFY(moved.function.points.back().value <= limits.largest);
    }
}

void ValueAxisTest::theCourseIsThatOfTheLogarithm_data()
{
    QTest::addColumn<double>("largest");
    QTest::addColumn<float>("opacity");
    QTest::newRow("a little") << 1.1 << 0.5F;
    QTest::newRow("a decade") << 10.0 << 0.3F;
    QTest::newRow("three decades, opaque") << 1000.0 << 1.0F;
    QTest::newRow("nine decades") << 1e9 << 0.9F;
}

void ValueAxisTest::theCourseIsThatOfTheLogarithm()
{
    QFETCH(double, largest);
    QFETCH(float, opacity);
    const JoinedFunction ends{{{1, {1, 0, 0.2F}, 0}, {largest, {0, 1, 0.2F}, opacity}}, 2};
    const LookTolerance tolerance;
    const auto edited = withLogarithmicCourse(ends, {0, 1}, tolerance);
    QVERIFY(checkTransferFunction(separated(edited.function)));
    QCOMPARE(edited.function.points.front(), ends.points.front());
    QCOMPARE(edited.function.points.back(), ends.points.back());
    QCOMPARE(edited.selection, allPoints(edited.function));
    const TransferFunction curves = separated(edited.function);
    const TransferSample from = evaluate(separated(ends), 1), to = evaluate(separated(ends), largest);
    double farthest = 0;
    for (int step = 0; step <= 20'000; ++step) {
        const double share = step / 20'000.0, value = std::exp(share * std::log(largest));
        const TransferSample sample = evaluate(curves, value);
        for (std::size_t channel = 0; channel < 3; ++channel)
            farthest = std::max(farthest, std::abs(sample.colour[channel] -
                                                   std::lerp(from.colour[channel], to.colour[channel], share)) /
                                              tolerance.colour);
        const double wanted = -std::expm1(-2 * std::lerp(from.extinction, to.extinction, share));
        farthest = std::max(farthest, std::abs(-std::expm1(-2 * sample.extinction) - wanted) / tolerance.opacity);
    }
    QVERIFY2(farthest <= 1.001, qPrintable(QString::number(farthest)));
    // Not many more points than are needed: with half of them the colours alone are off by more.
    QVERIFY(edited.function.points.size() < 200);
    QVERIFY(farthest > 0.05);
}

void ValueAxisTest::stepsAndValuesBelowZeroStay()
{
    const JoinedFunction function{
        {{-5, {1, 0, 0}, 0}, {1, {0, 1, 0}, 0.5F}, {1, {0, 0, 1}, 0.1F}, {1.0000000001, {1, 1, 1}, 0.9F}}, 1};
    const auto edited = withLogarithmicCourse(function, {0, 1, 2}, {});
    QCOMPARE(edited.function, function);
    QCOMPARE(edited.selection, (TransferSelection{0, 1, 2}));
    QVERIFY(checkTransferFunction(separated(withLogarithmicCourse(function, {0, 1, 2, 3}, {}).function)));
    QCOMPARE(withLogarithmicCourse(threePoints(), {0, 2}, {}).function, threePoints()); // no neighbours
    const auto part = withLogarithmicCourse(threePoints(), {1, 2}, {});
    QVERIFY(part.function.points.size() > 3);
    QCOMPARE(part.function.points[1], threePoints().points[1]);
}

QTEST_GUILESS_MAIN(ValueAxisTest)
#include "value_axis_test.moc"
