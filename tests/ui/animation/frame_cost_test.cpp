// SPDX-License-Identifier: GPL-3.0-or-later
// The cost model of progressive rendering (R23) against back ends whose times follow another law.
#include "ui/animation/frame_pacer.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace tetra;

namespace {

/// A back end of a certain speed; the parts are not in the proportion that the model begins with.
struct MadeUpBackend {
    double orderPerCell = 1e-7;
    double setUpPerCell = 1e-8;
    double fillPerFragment = 3e-8;
    double perSample = 2e-8;

    RenderStatistics draw(const FrameWork& work) const
    {
        RenderStatistics statistics;
        statistics.cells = static_cast<std::size_t>(work.tetrahedra);
        statistics.fragments = static_cast<std::size_t>(0.9 * work.samples * std::cbrt(work.tetrahedra));
        statistics.orderSeconds = orderPerCell * work.tetrahedra;
        statistics.setUpSeconds = setUpPerCell * work.tetrahedra;
        statistics.fillSeconds = fillPerFragment * static_cast<double>(statistics.fragments);
        return statistics;
    }

    double seconds(const FrameWork& work) const
    {
        const RenderStatistics statistics = draw(work);
        return statistics.orderSeconds + statistics.setUpSeconds + statistics.fillSeconds + perSample * work.samples;
    }
};

bool within(double value, double expected, double part)
{
    return std::abs(value - expected) <= part * expected;
}

} // namespace

class FrameCostTest : public QObject {
    Q_OBJECT

private slots:
    void growsWithAllThatIsDrawn()
    {
        const FrameCost cost;
        const FrameWork work{1e5, 1e4, 1e5};
        const double seconds = predictedSeconds(cost, work);
        QVERIFY(predictedSeconds(cost, {2e5, 1e4, 1e5}) > seconds);
        QVERIFY(predictedSeconds(cost, {1e5, 2e4, 1e5}) > seconds);
        QVERIFY(predictedSeconds(cost, {1e5, 1e4, 2e5}) > seconds);
        QVERIFY(predictedSeconds(cost, {}) > 0);
    }

    void learnsTheTimeOfAPictureAndOfOthersLikeIt()
    {
        const MadeUpBackend backend;
        const FrameWork work{3e5, 0, 480'000};
        FrameCost cost;
        for (int frame = 0; frame < 12; ++frame)
            cost = learned(cost, work, backend.draw(work), backend.seconds(work));
        QVERIFY(within(predictedSeconds(cost, work), backend.seconds(work), 0.02));
        for (const double reduction : {1.25, 1.5, 2.0}) {
            const FrameWork smaller{3e5, 0, 480'000 / (reduction * reduction)};
            // On the safe side, where this back end's filling costs nothing for the cells themselves.
            QVERIFY(predictedSeconds(cost, smaller) >= 0.9 * backend.seconds(smaller));
            QVERIFY(predictedSeconds(cost, smaller) <= 2 * backend.seconds(smaller));
        }
        const FrameWork coarser{75'000, 0, 480'000};
        QVERIFY(within(predictedSeconds(cost, coarser), backend.seconds(coarser), 0.3));
    }

    void learnsFromTheTimeAlone()
    {
        const FrameWork work{0, 2e5, 480'000};
        FrameCost cost;
        for (int frame = 0; frame < 12; ++frame)
            cost = learned(cost, work, {}, 0.25);
        QVERIFY(within(predictedSeconds(cost, work), 0.25, 0.02));
    }

    void oneHeldUpPictureDoesNotCountMuch()
    {
        const FrameWork work{1e5, 0, 1e5};
        FrameCost cost;
        for (int frame = 0; frame < 12; ++frame)
            cost = learned(cost, work, {}, 0.05);
        cost = learned(cost, work, {}, 5);
        QVERIFY(predictedSeconds(cost, work) < 0.2);
        for (int frame = 0; frame < 4; ++frame)
            cost = learned(cost, work, {}, 0.05);
        QVERIFY(within(predictedSeconds(cost, work), 0.05, 0.1));
    }

    void anOrderThatWasReusedSaysNothingOfOrders()
    {
        const FrameWork work{1e5, 0, 1e5};
        const FrameCost cost;
        RenderStatistics statistics = MadeUpBackend().draw(work);
        statistics.orderReused = true;
        statistics.orderSeconds = 1e-3;
        QCOMPARE(learned(cost, work, statistics, 0.1).order, cost.order);
    }

    void staysFiniteWhateverIsMeasured()
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> exponent(-9, 6);
        FrameCost cost;
        for (int frame = 0; frame < 2000; ++frame) {
            const FrameWork work{std::pow(10, exponent(random)), 0, std::pow(10, exponent(random))};
            RenderStatistics statistics;
            statistics.fillSeconds = std::pow(10, exponent(random));
            statistics.fragments = static_cast<std::size_t>(std::pow(10, exponent(random)));
            cost = learned(cost, work, statistics, std::pow(10, exponent(random)));
            QVERIFY(std::isfinite(predictedSeconds(cost, work)));
        }
    }
};

QTEST_APPLESS_MAIN(FrameCostTest)
#include "frame_cost_test.moc"
