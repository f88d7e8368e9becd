// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/samples.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

using namespace tetra;

namespace {

Dataset ball(std::uint32_t size, std::uint64_t seed = 1)
{
    Result<Dataset> made = makeSample({"scattered", size, SampleType::Float64, seed});
    Q_ASSERT(made.ok());
    return *std::move(made);
}

} // namespace

/// Random points in a ball: the same ones everywhere, evenly spread, with the field of the formula.
class AnalyticPointsTest : public QObject {
    Q_OBJECT
private slots:
    void beginsWithThePublishedNumbers();
    void neverChanges();
    void fillsTheBallEvenly();
    void followsItsFormula();
    void followsTheSeed();
    void refusesTooMany();
    void cancels();
};

/// The first numbers of SplitMix64 from 1234567, as published for checking it, are the first point's coordinates.
void AnalyticPointsTest::beginsWithThePublishedNumbers()
{
    const std::array<std::uint64_t, 3> published = {6457827717110365317u, 3203168211198807973u, 9817491932198370423u};
    const Eigen::Vector3d first = ball(2, 1234567).position(0);
    for (int axis = 0; axis < 3; ++axis)
        QCOMPARE(first[axis], double(published[static_cast<std::size_t>(axis)] >> 40) / (1 << 23) - 1);
}

/// The same bits on every machine: this number may only change with the formulas. A program of its own that rounds
/// nothing but the cosine has the same one.
void AnalyticPointsTest::neverChanges()
{
    const Dataset dataset = ball(10);
    QCOMPARE(dataset.source.hash, contentHash(dataset.values, dataset.positions));
    QCOMPARE(quint64(dataset.source.hash), quint64(16207845446075956168u));
}

void AnalyticPointsTest::fillsTheBallEvenly()
{
    const Dataset dataset = ball(40);
    QCOMPARE(dataset.domain, DomainClass::Scattered);
    QCOMPARE(dataset.pointCount(), std::uint64_t(64000));
    QCOMPARE(dataset.lattice.pointCount(), std::uint64_t(64000));
    std::array<int, 16> parts{}; // the octants of the inner ball with half of the volume, and those of the shell
    for (const Eigen::Vector3d& place : *dataset.positions) {
        QVERIFY(place.squaredNorm() <= 1);
        QCOMPARE(place, place.cast<float>().cast<double>());
        const int octant = (place[0] < 0 ? 1 : 0) + (place[1] < 0 ? 2 : 0) + (place[2] < 0 ? 4 : 0);
        ++parts[static_cast<std::size_t>(octant + (std::pow(place.norm(), 3) < 0.5 ? 0 : 8))];
    }
    for (const int count : parts) // 4000 expected, six standard deviations: 367
        QVERIFY(std::abs(count - 4000) < 367);
}

void AnalyticPointsTest::followsItsFormula()
{
    const Dataset dataset = ball(12);
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point) {
        const Eigen::Vector3d place = dataset.position(point);
        const double turns = 1.5 * place.squaredNorm() + place[2] / 2;
        const double expected = 0.5 + 0.5 * std::cos(2 * std::numbers::pi * turns);
        QVERIFY(std::abs(dataset.values.at(point) - expected) <= 1e-14);
    }
}

void AnalyticPointsTest::followsTheSeed()
{
    QCOMPARE(ball(4).source.hash, ball(4, 1).source.hash);
    QVERIFY(ball(4).source.hash != ball(4, 2).source.hash);
    // more of them begin with the fewer
    QCOMPARE(ball(9).position(63), ball(4).position(63));
}

void AnalyticPointsTest::refusesTooMany()
{
    const Result<Dataset> made = makeSample({"scattered", 513, {}, 1});
    QVERIFY(!made.ok());
    QCOMPARE(made.error().kind, ErrorKind::WrongUsage);
    QVERIFY(QString::fromStdString(made.error().text()).contains("from 2 to 512"));
}

void AnalyticPointsTest::cancels()
{
    std::stop_source stop;
    double last = 0;
    const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        last = fraction;
        stop.request_stop();
    });
    const Result<Dataset> cancelled = makeSample({"scattered", 64, {}, 1}, progress);
    QVERIFY(!cancelled.ok());
    QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
    QVERIFY(last < 0.1);
}

QTEST_GUILESS_MAIN(AnalyticPointsTest)
#include "analytic_points_test.moc"
