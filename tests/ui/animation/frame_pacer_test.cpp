// SPDX-License-Identifier: GPL-3.0-or-later
// Choosing mesh and picture size for a frame rate (R23), with back ends of any speed, also such as the model does not
// foresee.
#include "ui/animation/frame_pacer.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace tetra;

namespace {

constexpr double pixels = 800 * 600;

std::vector<FrameLevel> levelsOf(std::uint64_t whole)
{
    std::vector<FrameLevel> levels{{static_cast<double>(whole), true, 0}};
    for (const std::uint64_t size : coarserMeshes(whole))
        levels.push_back({static_cast<double>(size), true, 0});
    return levels;
}

/// Seconds of a picture: a law of its own, with noise.
class MadeUpBackend {
public:
    MadeUpBackend(double speed, double exponent, double noise) : speed_(speed), exponent_(exponent), noise_(noise) {}
    double seconds(double tetrahedra, double samples)
    {
        std::uniform_real_distribution<double> noise(1, 1 + noise_);
        return noise(random_) / speed_ * (1e-7 * tetrahedra + 1e-8 * samples * std::pow(tetrahedra, exponent_));
    }

private:
    double speed_;
    double exponent_;
    double noise_;
    std::mt19937 random_{1};
};

struct Turn {
    double shareInTime = 0; ///< after the first second
    int changes = 0;        ///< of the plan, then
    FramePlan last;
};

Turn turned(FramePacer& pacer, MadeUpBackend& backend)
{
    constexpr int frames = 300;
    Turn turn;
    double clock = 0;
    int counted = 0;
    int inTime = 0;
    FramePlan previous;
    for (int frame = 0; frame < frames; ++frame) {
        const FramePlan plan = pacer.nextFrame(pixels);
        const double samples = pixels / (plan.reduction * plan.reduction);
        const double seconds = backend.seconds(pacer.levels()[plan.level].tetrahedra, samples);
        pacer.learn(plan.level, samples, {}, seconds);
        if (clock > 1) {
            ++counted;
            inTime += seconds <= 1 / pacer.frameRate() ? 1 : 0;
            turn.changes += plan == previous ? 0 : 1;
        }
        previous = plan;
        clock += seconds;
    }
    turn.shareInTime = counted == 0 ? 1 : static_cast<double>(inTime) / counted;
    turn.last = previous;
    return turn;
}

} // namespace

class FramePacerTest : public QObject {
    Q_OBJECT

private slots:
    void meshesFallByQuarters()
    {
        QCOMPARE(coarserMeshes(1'000'000), (std::vector<std::uint64_t>{250'000, 62'500, 15'625, 3'906}));
        QVERIFY(coarserMeshes(7'000).empty());
        QVERIFY(coarserMeshes(0).empty());
    }

    /// C4: what the user chose is drawn, whatever it takes.
    void theChosenLevelIsDrawn()
    {
        FramePacer pacer;
        pacer.setFrameRate(1000);
        pacer.setLevels(levelsOf(10'000'000));
        QVERIFY(pacer.nextFrame(pixels) != (FramePlan{0, 1}));
        pacer.setKind(MovingQuality::Kind::Full);
        QCOMPARE(pacer.nextFrame(pixels), (FramePlan{0, 1}));
        pacer.setLevels({{1e7, true, 0}, {1e6, true, 0}});
        QCOMPARE(pacer.nextFrame(pixels), (FramePlan{0, 1}));
        for (const auto kind : {MovingQuality::Kind::Error, MovingQuality::Kind::Share}) {
            pacer.setKind(kind);
            QCOMPARE(pacer.nextFrame(pixels), (FramePlan{1, 1}));
        }
        pacer.setLevels({{1e7, true, 0}}); // not there yet
        QVERIFY(pacer.nextFrame(pixels).reduction > 1);
    }

    void holdsTheRateWithBackEndsOfAnySpeed_data()
    {
        QTest::addColumn<double>("speed");
        QTest::addColumn<double>("exponent");
        for (const double speed : {0.5, 1.0, 3.0, 20.0})
            for (const double exponent : {0.2, 1.0 / 3, 0.5})
                QTest::addRow("%g times, exponent %g", speed, exponent) << speed << exponent;
    }

    void holdsTheRateWithBackEndsOfAnySpeed()
    {
        QFETCH(double, speed);
        QFETCH(double, exponent);
        MadeUpBackend backend(speed, exponent, 0.2);
        FramePacer pacer;
        pacer.setLevels(levelsOf(1'500'000));
        const Turn turn = turned(pacer, backend);
        QVERIFY2(turn.shareInTime >= 0.95, qPrintable(QString::number(turn.shareInTime)));
        QVERIFY2(turn.changes <= 6, qPrintable(QString::number(turn.changes)));
    }

    void asFineAsTheTimeAllows()
    {
        MadeUpBackend slow(0.3, 1.0 / 3, 0);
        MadeUpBackend quick(100, 1.0 / 3, 0);
        FramePacer pacer;
        pacer.setLevels(levelsOf(1'000'000));
        const Turn coarse = turned(pacer, slow);
        QVERIFY(coarse.last.level > 0);
        const Turn fine = turned(pacer, quick);
        QCOMPARE(fine.last, FramePlan());
    }

    void aHigherRateIsCoarser()
    {
        const std::vector<FrameLevel> levels = levelsOf(1'000'000);
        double last = 0;
        for (const double rate : {1.0, 5.0, 15.0, 30.0, 60.0}) {
            const FramePlan plan = chooseFrame(levels, pixels, 1 / rate, std::nullopt);
            const double coarseness = std::log2(plan.reduction) + 2.0 / 3 * static_cast<double>(plan.level);
            QVERIFY(coarseness >= last);
            last = coarseness;
        }
    }

    void theQuickestIfNothingIsQuickEnough()
    {
        const std::vector<FrameLevel> levels = levelsOf(1'000'000);
        QCOMPARE(chooseFrame(levels, pixels, 1e-9, std::nullopt), (FramePlan{levels.size() - 1, 4}));
    }

    void aPlanThatAlmostKeepsTheBudgetIsKept()
    {
        const std::vector<FrameLevel> levels = levelsOf(1'000'000);
        const FramePlan plan{2, 1.5};
        const double seconds = predictedSeconds(levels[2], pixels, 1.5);
        QCOMPARE(chooseFrame(levels, pixels, 0.9 * seconds, plan), plan);
        QCOMPARE(chooseFrame(levels, pixels, 1.05 * seconds, plan), plan);
        QVERIFY(chooseFrame(levels, pixels, 0.5 * seconds, plan) != plan);
        QVERIFY(chooseFrame(levels, pixels, 100 * seconds, plan) != plan);
    }

    void refinementCostsLittleMoreThanTheLastPicture()
    {
        FrameLevel level{1e6, true, 0};
        for (const double speed : {0.001, 0.1, 1.0, 10.0, 100.0}) {
            level.cost = {speed, speed, speed, speed};
            const auto steps = refinementSteps(level, pixels, 2);
            QCOMPARE(steps.back(), (RefinementStep{1, 2}));
            double sum = 0;
            for (const RefinementStep& step : steps)
                sum += predictedSeconds(level, pixels, step.reduction / step.samplesPerAxis);
            QVERIFY(sum <= 1.6 * predictedSeconds(level, pixels, 0.5));
        }
        level.cost = {1e-4, 1e-4, 1e-4, 1e-4};
        QCOMPARE(refinementSteps(level, pixels, 2).size(), std::size_t{1});
    }

    void whatWasLearntGoesOverToOtherMeshes()
    {
        FramePacer pacer;
        pacer.setLevels(levelsOf(1'000'000));
        for (int frame = 0; frame < 20; ++frame)
            pacer.learn(0, pixels, {}, 2);
        pacer.setLevels(levelsOf(1'200'000));
        QVERIFY(predictedSeconds(pacer.levels()[0], pixels, 1) > 1.5);
    }
};

QTEST_APPLESS_MAIN(FramePacerTest)
#include "frame_pacer_test.moc"
