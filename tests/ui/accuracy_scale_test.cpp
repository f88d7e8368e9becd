// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/accuracy_scale.h"
#include "tests/ui/sample_files.h"
#include "ui/session/accuracy_keys.h"

#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

/// The scale that slider and curve share, in % of the value range (R7), and the curve of Fig. 10 (R26).
class AccuracyScaleTest : public QObject {
    Q_OBJECT
private slots:
    void positionsAndErrorsAreEachOthersInverse();
    void endsAreTheCoarsestErrorAndZero();
    void aDecadeIsAsLongAsAnyOther();
    void stepsGoToRoundNumbers_data();
    void stepsGoToRoundNumbers();
    void stepsNeverLeaveTheScale();
    void keys();
    void theCurveIsThatOfTheModel();
    void theFirstErrorIsOneThatCanBeWorkedWith_data();
    void theFirstErrorIsOneThatCanBeWorkedWith();
};

void AccuracyScaleTest::positionsAndErrorsAreEachOthersInverse()
{
    for (int step = 0; step <= 94; ++step) {
        const double percent = accuracyAt(step / 100.0);
        QVERIFY(std::abs(accuracyPosition(percent) - step / 100.0) < 1e-3);
    }
    for (const double percent : accuracyPresets)
        QCOMPARE(accuracyAt(accuracyPosition(percent)), percent);
}

void AccuracyScaleTest::endsAreTheCoarsestErrorAndZero()
{
    QCOMPARE(accuracyAt(0), coarsestOnScale);
    QCOMPARE(accuracyAt(1), 0.0);
    QCOMPARE(accuracyAt(-5), coarsestOnScale);
    QCOMPARE(accuracyPosition(0), 1.0);
    QCOMPARE(accuracyPosition(100), 0.0);
    QCOMPARE(accuracyPosition(1e-9), logarithmicPart);
    QCOMPARE(accuracyAt(logarithmicPart), finestOnScale);
}

void AccuracyScaleTest::aDecadeIsAsLongAsAnyOther()
{
    const double decade = accuracyPosition(1) - accuracyPosition(10);
    QVERIFY(std::abs(accuracyPosition(0.1) - accuracyPosition(1) - decade) < 1e-12);
}

void AccuracyScaleTest::stepsGoToRoundNumbers_data()
{
    QTest::addColumn<double>("from");
    QTest::addColumn<int>("steps");
    QTest::addColumn<double>("to");
    QTest::newRow("finer") << 1.0 << 1 << 0.8;
    QTest::newRow("coarser") << 1.0 << -1 << 1.2;
    QTest::newRow("finer from between") << 0.93 << 1 << 0.8;
    QTest::newRow("coarser from between") << 0.93 << -1 << 1.0;
    QTest::newRow("a page") << 1.0 << 5 << 0.3;
    QTest::newRow("to zero") << 0.01 << 1 << 0.0;
    QTest::newRow("from zero") << 0.0 << -1 << 0.01;
    QTest::newRow("from outside") << 60.0 << 1 << 20.0;
}

void AccuracyScaleTest::stepsGoToRoundNumbers()
{
    QFETCH(double, from);
    QFETCH(int, steps);
    QFETCH(double, to);
    QCOMPARE(steppedAccuracy(from, steps), to);
}

void AccuracyScaleTest::stepsNeverLeaveTheScale()
{
    QCOMPARE(steppedAccuracy(0, 100), 0.0);
    QCOMPARE(steppedAccuracy(20, -100), 20.0);
    QCOMPARE(steppedAccuracy(100, -1), 20.0);
}

void AccuracyScaleTest::keys()
{
    QCOMPARE(accuracyByKey(1, Qt::Key_Right), std::optional(0.8));
    QCOMPARE(accuracyByKey(1, Qt::Key_Left), std::optional(1.2));
    QCOMPARE(accuracyByKey(1, Qt::Key_Home), std::optional(coarsestOnScale));
    QCOMPARE(accuracyByKey(1, Qt::Key_End), std::optional(0.0));
    QCOMPARE(accuracyByKey(1, Qt::Key_A), std::nullopt);
}

void AccuracyScaleTest::theCurveIsThatOfTheModel()
{
    const QTemporaryDir folder;
    const auto host = hostOfThisBuild();
    const auto model = Model::open(buildSampleModel(*host, sampleDataset(16), folder.path().toStdString()));
    QVERIFY(model.ok());
    const auto curve = sizeAgainstError(**model, {}, 50);
    QCOMPARE(curve.size(), std::size_t{51});
    QCOMPARE(curve.front().error, coarsestOnScale);
    QCOMPARE(curve.back().error, 0.0);
    QCOMPARE(curve.back().sites, (*model)->siteCount());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        QCOMPARE(curve[i].sites, meshSizeAt(**model, {curve[i].error}).sites);
        QCOMPARE(curve[i].tetrahedra, meshSizeAt(**model, {curve[i].error}).tetrahedra);
        QVERIFY(i == 0 || curve[i].sites >= curve[i - 1].sites);
    }
}

/// 2 % as long as 3 million tetrahedra hold it: first pictures of coarser meshes show their errors.
void AccuracyScaleTest::theFirstErrorIsOneThatCanBeWorkedWith_data()
{
    QTest::addColumn<double>("atOnePercent"); ///< tetrahedra, of which there are fewer in proportion at larger errors
    QTest::addColumn<double>("error");
    QTest::newRow("small") << 999'000.0 << 1.0;
    QTest::newRow("half as many at 2 %") << 1'001'000.0 << 2.0;
    QTest::newRow("just held") << 5'999'000.0 << 2.0;
    QTest::newRow("just not") << 6'001'000.0 << 3.0;
    QTest::newRow("at 4 %") << 11'900'000.0 << 4.0;
    QTest::newRow("coarser than 5 %") << 20e6 << 8.0;
    QTest::newRow("never") << 1e12 << coarsestOnScale;
}

void AccuracyScaleTest::theFirstErrorIsOneThatCanBeWorkedWith()
{
    QFETCH(double, atOnePercent);
    QFETCH(double, error);
    const auto tetrahedraAt = [=](double percent) { return static_cast<std::uint64_t>(atOnePercent / percent); };
    QCOMPARE(startingError(tetrahedraAt), error);
    // Where the domain has a shape of its own, a small mesh is more accurate.
    const auto shaped = [&] { return startingError(tetrahedraAt, true); };
    QVERIFY(shaped() <= error);
    if (error > 1)
        QCOMPARE(shaped(), error);
    for (const auto& [atOne, first] :
         {std::pair(25'000.0, 0.1), std::pair(26'000.0, 0.2), std::pair(51'000.0, 0.5), std::pair(126'000.0, 1.0)})
        QCOMPARE(startingError([=](double percent) { return static_cast<std::uint64_t>(atOne / percent); }, true),
                 first);
}

QTEST_GUILESS_MAIN(AccuracyScaleTest)
#include "accuracy_scale_test.moc"
