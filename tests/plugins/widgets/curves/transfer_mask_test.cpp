// SPDX-License-Identifier: GPL-3.0-or-later
// Masks and groups: what a mask hides is transparent to the last bit wherever functions are used, and files keep both.
#include "core/transfer/import/curves.h"
#include "plugins/widgets/curves/whole_function.h"
#include "tests/plugins/widgets/curves/random_functions.h"

#include <tan/transfer.h>

#include <QTest>

#include <limits>

using namespace tetra;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TransferFunction randomMasked(std::mt19937& random)
{
    TransferFunction function = randomCurves(random);
    const double least = 0.5 * double(int(random() % 44) - 22);
    function.mask = TransferMask{least, least + 0.5 * double(random() % 20)};
    return function;
}

/// Each whole and half value, and what lies just beside it.
std::vector<double> telling()
{
    std::vector<double> values;
    for (double value = -12; value <= 12; value += 0.5)
        for (const double toward : {-infinity, value, infinity})
            values.push_back(std::nextafter(value, toward));
    return values;
}

} // namespace

class TransferMaskTest : public QObject {
    Q_OBJECT

private slots:
    void onlyTheMaskIsSeen();
    void segmentsAreThoseOfTheMask();
    void editsSeeThePointsBehindTheMask();
    void filesKeepMasksAndGroups();
    void wrongMasksAndGroupsAreRefused_data();
    void wrongMasksAndGroupsAreRefused();
    void paraviewGetsSteps();
};

void TransferMaskTest::onlyTheMaskIsSeen()
{
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        const TransferFunction function = randomMasked(random);
        QVERIFY(checkTransferFunction(function));
        const TransferFunction open = withoutMask(function);
        for (const double value : telling()) {
            const TransferSample look = evaluate(function, value), behind = evaluate(open, value);
            const bool shown = value >= function.mask->least && value <= function.mask->largest;
            QCOMPARE(look.extinction, shown ? behind.extinction : 0.0);
            QCOMPARE(evaluateUnmasked(function, value).extinction, behind.extinction);
        }
        QCOMPARE(evaluate(function, std::nan("")).extinction, 0.0);
    }
}

void TransferMaskTest::segmentsAreThoseOfTheMask()
{
    std::mt19937 random(2);
    for (int round = 0; round < 300; ++round) {
        const TransferFunction function = randomMasked(random);
        const auto segments = transferSegments(function);
        QCOMPARE(segments.front().begin, -infinity);
        QCOMPARE(segments.back().end, infinity);
        for (std::size_t i = 1; i < segments.size(); ++i) {
            QCOMPARE(segments[i].begin, segments[i - 1].end);
            QVERIFY(segments[i].begin < segments[i].end);
        }
        for (const double value : telling()) {
            const auto segment = std::ranges::find_if(
                segments, [&](const TransferSegment& one) { return value >= one.begin && value < one.end; });
            const double beyond = value - segment->origin;
            const TransferSample look = evaluate(function, value);
            const double extinction = segment->atOrigin.extinction + beyond * segment->perValue.extinction;
            QVERIFY(std::abs(extinction - look.extinction) < 1e-9);
            if (value < function.mask->least || value > function.mask->largest)
                QVERIFY(segment->transparent());
            for (std::size_t channel = 0; channel < 3 && !segment->transparent(); ++channel)
                QVERIFY(std::abs(segment->atOrigin.colour[channel] + beyond * segment->perValue.colour[channel] -
                                 look.colour[channel]) < 1e-9);
        }
    }
}

void TransferMaskTest::editsSeeThePointsBehindTheMask()
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-12, 12);
    for (int round = 0; round < 300; ++round) {
        const TransferFunction function = randomMasked(random);
        const auto added = withPoint(joined(function), place(random));
        QVERIFY(added && added->function.mask == function.mask);
        QVERIFY(largestDifference(function, separated(added->function)) < 1e-6);
        const TransferFunction mirror = mirrored(function, randomLimits);
        for (double value = -12.97; value < 13; value += 0.04)
            QVERIFY(std::abs(evaluate(mirror, -value).extinction - evaluate(function, value).extinction) < 1e-9);
        const TransferFunction coloured = withColourMap(function, colourMaps().front(), randomLimits);
        QVERIFY(coloured.mask == function.mask);
        QVERIFY(largestDifference(function, coloured, false) < 1e-6);
    }
}

void TransferMaskTest::filesKeepMasksAndGroups()
{
    std::mt19937 random(4);
    for (int round = 0; round < 300; ++round) {
        const TransferFunction function = randomCurves(random);
        const auto back = transferFunctionFromText(transferFunctionToText(function));
        QVERIFY2(back, back ? "" : back.error().text().c_str());
        QCOMPARE(*back, function);
    }
}

void TransferMaskTest::wrongMasksAndGroupsAreRefused_data()
{
    QTest::addColumn<QByteArray>("members");
    QTest::addColumn<QByteArray>("told");
    const auto row = [](const char* name, const char* members, const char* told) {
        QTest::newRow(name) << QByteArray(members) << QByteArray(told);
    };
    row("mask is a number", "\"mask\": 3, \"points\": []", "line 2, column 9");
    row("half a mask", "\"mask\": {\"least\": 1}, \"points\": []", "no \"largest\"");
    row("mask with more", "\"mask\": {\"least\": 1, \"largest\": 2, \"mean\": 1}, \"points\": []", "\"mean\"");
    row("mask the wrong way", "\"mask\": {\"least\": 3, \"largest\": 2}, \"points\": []", "line 2, column 9");
    row("mask without end", "\"mask\": {\"least\": 3, \"largest\": 1e999}, \"points\": []", "line 2, column 33");
    row("group 10", "\"points\": [{\"value\": 1, \"colour\": [0, 0, 0], \"opacity\": 1, \"group\": 10}]", "0 to 9");
    row("group -1", "\"points\": [{\"value\": 1, \"colour\": [0, 0, 0], \"opacity\": 1, \"group\": -1}]", "0 to 9");
    row("group 1.5", "\"points\": [{\"value\": 1, \"colour\": [0, 0, 0], \"opacity\": 1, \"group\": 1.5}]",
        "\"group\" must be");
}

void TransferMaskTest::wrongMasksAndGroupsAreRefused()
{
    QFETCH(QByteArray, members);
    QFETCH(QByteArray, told);
    const QByteArray text = "{\"format\": \"tan-transfer-function\", \"version\": 1,\n" + members + "}";
    const auto function = transferFunctionFromText(text.toStdString());
    QVERIFY(!function);
    QVERIFY2(QByteArray::fromStdString(function.error().text()).contains(told), function.error().text().c_str());
}

void TransferMaskTest::paraviewGetsSteps()
{
    std::mt19937 random(5);
    for (int round = 0; round < 100; ++round) {
        TransferFunction function = randomMasked(random);
        if (function.opacities.empty())
            continue;
        const auto imported = importTransferFunctions(transferFunctionToParaview(function, "masked"),
                                                      {TransferFunction{{}, {}, function.unitDistance}, std::nullopt});
        QVERIFY(imported);
        const TransferFunction& back = imported->front().function;
        for (double value = -12.97; value < 13; value += 0.04)
            QVERIFY(std::abs(opacityOf(back, evaluate(back, value)) - opacityOf(function, evaluate(function, value))) <=
                    2.0 / 1000 + 1e-6);
        // The mask's largest value is seen there, too.
        const double last = function.mask->largest;
        if (std::ranges::find(function.opacities, last, &OpacityPoint::value) == function.opacities.end())
            QVERIFY(std::abs(opacityOf(back, evaluate(back, last)) - opacityOf(function, evaluate(function, last))) <=
                    2.0 / 1000 + 1e-6);
    }
    // Steps come back as steps.
    const TransferFunction steps = transferFunctionFromPoints(
        {{0, {1, 0, 0}, 0.5F}, {2, {1, 0, 0}, 0.5F}, {2, {0, 1, 0}, 0.25F}, {5, {0, 1, 0}, 0.25F}});
    const auto again = importTransferFunctions(transferFunctionToParaview(steps, "steps"), {});
    QVERIFY(again);
    QCOMPARE(again->front().function, steps);
}

QTEST_APPLESS_MAIN(TransferMaskTest)
#include "transfer_mask_test.moc"
