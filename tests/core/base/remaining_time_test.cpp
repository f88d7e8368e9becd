// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/progress.h"

#include <tan/base.h>

#include <QTest>

using namespace tetra;

class RemainingTimeTest : public QObject {
    Q_OBJECT

private slots:
    void knowsNothingAtFirst()
    {
        RemainingTime time;
        QVERIFY(!time.seconds());
        time.update(0.01, 0.5);
        QVERIFY(!time.seconds());
        time.update(0.01, 2);
        QVERIFY(time.seconds());
    }

    void isExactForSteadyWork()
    {
        RemainingTime time;
        for (int second = 1; second <= 100; ++second) {
            time.update(second / 100.0, second);
            QVERIFY(qAbs(*time.seconds() - (100 - second)) < 1e-6);
        }
    }

    /// Half the work in 10 s, then ten times slower: after another 20 s the guess is mostly about the new speed.
    void noticesASlowerSecondHalf()
    {
        RemainingTime time;
        for (int step = 1; step <= 10; ++step)
            time.update(0.05 * step, step);
        for (int step = 1; step <= 20; ++step)
            time.update(0.5 + 0.005 * step, 10 + step);
        QVERIFY2(*time.seconds() > 60 && *time.seconds() < 100, qPrintable(QString::number(*time.seconds())));
    }

    void aStallMovesItLittle()
    {
        RemainingTime time;
        for (int second = 1; second <= 100; ++second)
            time.update(second / 200.0, second);
        time.update(0.5, 103);
        QVERIFY2(*time.seconds() < 120, qPrintable(QString::number(*time.seconds())));
    }

    void ignoresStepsBack()
    {
        RemainingTime time;
        time.update(0.5, 10);
        time.update(0.4, 11);
        time.update(0.6, 9);
        QVERIFY(qAbs(*time.seconds() - 10) < 1e-9);
        time.update(1, 20);
        QCOMPARE(*time.seconds(), 0.0);
    }
};

QTEST_GUILESS_MAIN(RemainingTimeTest)
#include "remaining_time_test.moc"
