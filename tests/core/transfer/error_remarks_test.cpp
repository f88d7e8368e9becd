// SPDX-License-Identifier: GPL-3.0-or-later
// What of a picture the error of its mesh alone may have made.

#include <tan/transfer.h>

#include <QTest>

using namespace tetra;
using Kind = ErrorRemark::Kind;

namespace {

/// Data from 0 to 100, most of which are 20.
ErrorRemarkInput inputOf(double error)
{
    return {
        .range = {0, 100}, .background = BackgroundValues{18, 20, 22}, .errorAt = [error](double) { return error; }};
}

std::vector<ErrorRemark> ofIsovalue(double isovalue, double error)
{
    ErrorRemarkInput input = inputOf(error);
    input.isovalues = {&isovalue, 1};
    return errorRemarks(input);
}

std::vector<ErrorRemark> ofOpacities(const std::vector<OpacityPoint>& opacities, double error)
{
    const TransferFunction function{{}, opacities, 1, {}};
    ErrorRemarkInput input = inputOf(error);
    input.transfer = &function;
    return errorRemarks(input);
}

} // namespace

class ErrorRemarksTest : public QObject {
    Q_OBJECT

private slots:
    void isovalues_data()
    {
        QTest::addColumn<double>("isovalue");
        QTest::addColumn<double>("error");
        QTest::addColumn<double>("other"); ///< negative: no remark
        QTest::newRow("far from all") << 60.0 << 2.0 << -1.0;
        QTest::newRow("above the least") << 1.5 << 2.0 << 0.0;
        QTest::newRow("below the largest") << 99.0 << 2.0 << 100.0;
        QTest::newRow("above the background") << 21.0 << 2.0 << 20.0;
        QTest::newRow("below the background") << 18.5 << 2.0 << 20.0;
        QTest::newRow("just beyond the error") << 22.5 << 2.0 << -1.0;
        QTest::newRow("of a smaller error") << 21.0 << 0.5 << -1.0;
        QTest::newRow("of the exact mesh") << 20.0 << 0.0 << -1.0;
        QTest::newRow("of no data") << -1.0 << 2.0 << -1.0;
    }
    void isovalues()
    {
        QFETCH(double, isovalue);
        QFETCH(double, error);
        QFETCH(double, other);
        const auto remarks = ofIsovalue(isovalue, error);
        QCOMPARE(remarks.size(), std::size_t(other >= 0 ? 1 : 0));
        if (remarks.empty())
            return;
        QCOMPARE(remarks[0].kind, other == 20 ? Kind::IsovalueAtBackground : Kind::IsovalueAtEnd);
        QCOMPARE(remarks[0].value, isovalue);
        QCOMPARE(remarks[0].other, other);
        QCOMPARE(remarks[0].error, error);
        QVERIFY(ofIsovalue(isovalue, remarks[0].enough).empty());
        QVERIFY(ofIsovalue(isovalue, enoughPercent(remarks[0], {0, 100})).empty());
    }

    /// The error where the data have the value that may be mistaken counts, not that at the isovalue.
    void theErrorMayDependOnTheValue()
    {
        const double isovalue = 23;
        ErrorRemarkInput input = inputOf(0);
        input.isovalues = {&isovalue, 1};
        input.errorAt = [](double value) { return value > 22 ? 10 : 1; };
        QVERIFY(errorRemarks(input).empty());
        input.errorAt = [](double value) { return value > 22 ? 1 : 10; };
        QCOMPARE(errorRemarks(input).size(), std::size_t(1));
    }

    void opacitiesBesideATransparentBackground()
    {
        const std::vector<OpacityPoint> step{{0, 0}, {23, 0}, {23, 0.5F}, {100, 0.5F}};
        QVERIFY(ofOpacities(step, 2.9).empty());
        const auto remarks = ofOpacities(step, 3.1);
        QCOMPARE(remarks.size(), std::size_t(1));
        QCOMPARE(remarks[0].kind, Kind::OpacityAtBackground);
        QCOMPARE(remarks[0].value, 23.0);
        QCOMPARE(remarks[0].other, 20.0);
        QVERIFY(ofOpacities(step, remarks[0].enough).empty());
        const std::vector<OpacityPoint> below{{0, 0.5F}, {17, 0.5F}, {17, 0}, {100, 0}};
        QCOMPARE(ofOpacities(below, 3.1).size(), std::size_t(1));
        QVERIFY(ofOpacities(below, 2.9).empty());
    }

    void aBackgroundThatIsSeenItselfIsNoMistake()
    {
        QVERIFY(ofOpacities({{0, 0.3F}, {100, 0.5F}}, 5).empty());
        QVERIFY(ofOpacities({{0, 0.005F}, {100, 0.05F}}, 5).empty()); // nor is what is hardly more than it
    }

    void fewerValuesThanTheError()
    {
        const std::vector<OpacityPoint> band{{60, 0}, {60, 0.5F}, {64, 0.5F}, {64, 0}};
        QVERIFY(ofOpacities(band, 3.9).empty());
        const auto remarks = ofOpacities(band, 4.1);
        QCOMPARE(remarks.size(), std::size_t(1));
        QCOMPARE(remarks[0].kind, Kind::NarrowOpacity);
        QCOMPARE(remarks[0].value, 62.0);
        QVERIFY(ofOpacities(band, remarks[0].enough).empty());
    }

    /// A mask hides what lies outside of it.
    void aMaskCounts()
    {
        const TransferFunction function{{}, {{0, 0.5F}, {100, 0.5F}}, 1, TransferMask{21, 90}};
        ErrorRemarkInput input = inputOf(2);
        input.transfer = &function;
        QCOMPARE(errorRemarks(input).size(), std::size_t(1));
        QCOMPARE(errorRemarks(input)[0].value, 21.0);
    }

    void theErrorsThatAreEnoughAreRound_data()
    {
        QTest::addColumn<double>("enough");
        QTest::addColumn<double>("percent");
        QTest::newRow("less than one") << 0.79 << 0.3; // of a range of 200
        QTest::newRow("hundredths") << 0.119 << 0.05;
        QTest::newRow("above one") << 7.9 << 3.0;
        QTest::newRow("above ten") << 50.0 << 20.0;
        QTest::newRow("none") << 0.0 << 0.0;
    }
    void theErrorsThatAreEnoughAreRound()
    {
        QFETCH(double, enough);
        QFETCH(double, percent);
        const ErrorRemark remark{Kind::IsovalueAtEnd, 1, 0, 5, enough};
        QCOMPARE(enoughPercent(remark, {0, 200}), percent);
        QVERIFY(!errorRemarkText(remark).empty() && !errorCureText(remark, {0, 200}).empty());
    }

    /// Of logarithms errors are told as factors, and values as they are typed.
    void ofLogarithmsFactorsAreTold_data()
    {
        QTest::addColumn<ErrorRemark>("remark");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("end") << ErrorRemark{Kind::IsovalueAtEnd, -2.9, -3, 0.1, 0.05}
                             << QStringList{"isovalue log10(0.00125893)", "a factor of 1.26", "log10(0.001)"};
        QTest::newRow("background") << ErrorRemark{Kind::IsovalueAtBackground, 2, 1.999, 0.002, 0.0005}
                                    << QStringList{"isovalue log10(100)", "a factor of 1.0046", "log10(99.8)"};
        QTest::newRow("opacity") << ErrorRemark{Kind::OpacityAtBackground, -5, -6, 1.5, 0.5}
                                 << QStringList{"from log10(1e-05)", "a factor of 31.6", "log10(1e-06)"};
        QTest::newRow("narrow") << ErrorRemark{Kind::NarrowOpacity, 0, 0, 0.3, 0.1}
                                << QStringList{"around log10(1)", "a factor of 2"};
    }
    void ofLogarithmsFactorsAreTold()
    {
        QFETCH(ErrorRemark, remark);
        QFETCH(QStringList, words);
        const QString text = QString::fromStdString(errorRemarkText(remark, true).text());
        for (const QString& word : words)
            QVERIFY2(text.contains(word), qPrintable(text));
        const QString cure = QString::fromStdString(errorCureText(remark, {-6, 4}, true).text());
        QVERIFY2(cure.contains(" %") && cure.contains("near log10("), qPrintable(cure));
        QCOMPARE(errorRemarkText(remark, false), errorRemarkText(remark));
    }
};

QTEST_APPLESS_MAIN(ErrorRemarksTest)
#include "error_remarks_test.moc"
