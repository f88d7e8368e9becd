// SPDX-License-Identifier: GPL-3.0-or-later
/// R1, R8, S20: refinement of points anywhere, by properties of what comes out, on random and on degenerate points.
#include "core/mesh/topology.h"
#include "core/refine/free/scattered_refinement.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>

using namespace tetra;

namespace {

using Position = Eigen::Vector3d;

struct Cloud {
    std::vector<Position> positions;
    std::vector<double> values;
    std::vector<float> weights{};
    ScatteredPoints points() const { return {positions, values, weights}; }
};

/// Replays a history and keeps the mesh as it stands.
struct Replay final : HistorySink {
    std::vector<std::uint64_t> sites;
    std::vector<float> keys;
    std::map<std::uint32_t, Tetrahedron> alive; ///< by history number
    std::map<std::uint32_t, float> errors;
    std::uint32_t made = 0;
    float finalKey = -1;

    Status add(const HistoryStep& step) override
    {
        for (const std::uint32_t number : step.destroyed)
            if (alive.erase(number) != 1)
                return Error{ErrorKind::BadInput, "destroys what is not there"};
        for (const HistoryTetrahedron& made_ : step.star) {
            const auto site = static_cast<std::uint32_t>(sites.size());
            errors[made] = made_.error;
            alive[made++] = {site, made_.sites[0], made_.sites[1], made_.sites[2]};
        }
        sites.push_back(step.point);
        keys.push_back(step.keyBefore);
        return {};
    }
    Status finish(float key) override
    {
        finalKey = key;
        return {};
    }
};

double field(const Position& p)
{
    return std::sin(3 * p[0]) * std::cos(2 * p[1]) + p[2] * p[2];
}

Cloud ball(std::size_t count, unsigned seed)
{
    Cloud cloud;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    while (cloud.positions.size() < count) {
        const Position p(coordinate(random), coordinate(random), coordinate(random));
        if (p.norm() < 1)
            cloud.positions.push_back(p);
    }
    for (const Position& p : cloud.positions)
        cloud.values.push_back(field(p));
    return cloud;
}

/// Every eight neighbours lie on a sphere, every layer in a plane.
Cloud grid(int edge, double step)
{
    Cloud cloud;
    for (int i = 0; i < edge * edge * edge; ++i) {
        cloud.positions.emplace_back(step * (i % edge), step * (i / edge % edge), step * (i / edge / edge));
        cloud.values.push_back(field(cloud.positions.back()));
    }
    return cloud;
}

long double sixVolumes(const Replay& replay, const Cloud& cloud, const Tetrahedron& t)
{
    using Long = Eigen::Matrix<long double, 3, 1>;
    const auto at = [&](std::uint32_t site) -> Long { return cloud.positions[replay.sites[site]].cast<long double>(); };
    const Long a = at(t[0]);
    return (at(t[1]) - a).dot((at(t[2]) - a).cross(at(t[3]) - a));
}

QString textOf(const Result<ScatteredRefinementResult>& result)
{
    return result ? QString() : QString::fromStdString(result.error().text());
}

} // namespace

class ScatteredRefinementTest : public QObject {
    Q_OBJECT

private slots:
    void fullMeshesFillTheHull_data()
    {
        QTest::addColumn<Cloud>("cloud");
        QTest::addColumn<double>("volume");
        QTest::newRow("random ball") << ball(400, 1) << 0.0;
        QTest::newRow("grid, all cospherical") << grid(6, 1) << 125.0;
        QTest::newRow("grid of steps that are no binary fraction") << grid(5, 0.1) << 0.064;
        Cloud flat = ball(300, 2);
        for (Position& p : flat.positions)
            p[2] *= 1e-9;
        QTest::newRow("nearly a plane") << flat << 0.0;
        Cloud far = ball(300, 3);
        for (Position& p : far.positions)
            p += Position(4.2e6, -3e5, 100);
        QTest::newRow("far from the origin") << far << 0.0;
        QTest::newRow("four points") << Cloud{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {1, 2, 3, 4}} << 1.0 / 6;
    }
    void fullMeshesFillTheHull()
    {
        QFETCH(Cloud, cloud);
        QFETCH(double, volume);
        Replay replay;
        const auto result = refineScattered(cloud.points(), 0, replay);
        QVERIFY2(result.ok(), qPrintable(textOf(result)));
        QCOMPARE(result->sites, static_cast<std::uint32_t>(replay.sites.size()));
        QCOMPARE(result->tetrahedra, std::uint64_t(replay.made));
        QCOMPARE(replay.finalKey, 0.0f);
        QCOMPARE(std::set(replay.sites.begin(), replay.sites.end()).size(), replay.sites.size());
        QVERIFY(std::isinf(replay.keys[0]) && std::isinf(replay.keys[3]));
        long double sum = 0;
        std::map<std::array<std::uint32_t, 3>, int> faces;
        for (const auto& [number, t] : replay.alive) {
            const long double six = sixVolumes(replay, cloud, t);
            QVERIFY2(six > 0, qPrintable(QString("cell %1 is flat or inverted").arg(number)));
            sum += six;
            for (std::size_t opposite = 0; opposite < 4; ++opposite) {
                std::array<std::uint32_t, 3> face{};
                std::size_t i = 0;
                for (std::size_t corner = 0; corner < 4; ++corner)
                    if (corner != opposite)
                        face[i++] = t[corner];
                std::ranges::sort(face);
                ++faces[face];
            }
        }
        for (const auto& [face, cells] : faces)
            QVERIFY(cells <= 2);
        if (volume > 0)
            QVERIFY(std::abs(static_cast<double>(sum) / 6 - volume) < 1e-9 * volume);
    }

    /// The keys are the true errors: recomputed over all points of a mesh that refinement stopped at.
    void keysAreTheMeshesErrors_data()
    {
        QTest::addColumn<Cloud>("cloud");
        QTest::newRow("random") << ball(600, 4);
        Cloud layers = ball(600, 8); // points on faces, which two cells hold
        for (std::size_t i = 0; i < layers.positions.size(); ++i) {
            layers.positions[i][2] = 0.25 * std::round(4 * layers.positions[i][2]);
            layers.values[i] = field(layers.positions[i]) + (i % 7 == 0 ? 0.3 : 0);
        }
        QTest::newRow("layers") << layers;
    }
    void keysAreTheMeshesErrors()
    {
        QFETCH(Cloud, cloud);
        double before = 1e9;
        for (const double stop : {0.5, 0.2, 0.05, 0.01}) {
            Replay replay;
            const auto result = refineScattered(cloud.points(), stop, replay);
            QVERIFY(result.ok());
            QVERIFY(static_cast<double>(result->finalKey) <= stop);
            double largest = 0;
            for (std::size_t point = 0; point < cloud.positions.size(); ++point)
                largest = std::max(largest, errorAt(replay, cloud, point));
            QVERIFY(largest <= static_cast<double>(result->finalKey) * (1 + 1e-6) + 1e-12);
            QVERIFY(largest >= static_cast<double>(result->finalKey) * (1 - 1e-6) - 1e-12);
            QVERIFY(largest < before);
            before = largest;
        }
    }

    void linearFieldsNeedTheHullOnly()
    {
        Cloud cloud = grid(5, 0.1);
        for (std::size_t point = 0; point < cloud.values.size(); ++point)
            cloud.values[point] = cloud.positions[point].dot(Position(1.1, -2.3, 0.7)) + 5;
        Replay replay;
        const auto result = refineScattered(cloud.points(), 0, replay);
        QVERIFY(result.ok());
        QCOMPARE(result->sites, 8u);
    }

    void weightsDrawSites()
    {
        Cloud cloud = ball(1500, 5);
        Replay plain;
        QVERIFY(refineScattered(cloud.points(), 0.05, plain).ok());
        for (const Position& p : cloud.positions)
            cloud.weights.push_back(p[0] > 0 ? 1.0f : 0.1f);
        Replay weighted;
        QVERIFY(refineScattered(cloud.points(), 0.05, weighted).ok());
        const auto share = [&](const Replay& replay) {
            const auto right = std::ranges::count_if(replay.sites, [&](auto p) { return cloud.positions[p][0] > 0; });
            return static_cast<double>(right) / static_cast<double>(replay.sites.size());
        };
        QVERIFY(weighted.sites.size() < plain.sites.size());
        QVERIFY(share(weighted) > share(plain) + 0.1);
    }

    void refusesWhatHasNoVolume_data()
    {
        QTest::addColumn<Cloud>("cloud");
        QTest::addColumn<QString>("reason");
        Cloud line, plane;
        for (int i = 0; i < 20; ++i) {
            line.positions.emplace_back(i, 2 * i, -3 * i);
            plane.positions.emplace_back(i, i * i, 3 * i + 2 * i * i);
        }
        line.values = plane.values = std::vector<double>(20, 1);
        QTest::newRow("none") << Cloud{} << "only 0 points";
        QTest::newRow("three") << Cloud{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {1, 2, 3}} << "only 3 points";
        QTest::newRow("line") << line << "on one line";
        QTest::newRow("plane") << plane << "in one plane";
        Cloud twice = ball(50, 6);
        twice.positions[40] = twice.positions[7];
        QTest::newRow("two points at one place") << twice << "Points 7 and 40";
    }
    void refusesWhatHasNoVolume()
    {
        QFETCH(Cloud, cloud);
        QFETCH(QString, reason);
        Replay replay;
        const auto result = refineScattered(cloud.points(), 0, replay);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().kind, ErrorKind::BadInput);
        QVERIFY2(textOf(result).contains(reason), qPrintable(textOf(result)));
    }

    void canBeCancelled()
    {
        const Cloud cloud = ball(3000, 7);
        std::stop_source stop;
        Replay replay;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction > 0)
                stop.request_stop();
        });
        const auto result = refineScattered(cloud.points(), 0, replay, progress);
        QVERIFY(!result.ok());
        QCOMPARE(result.error().kind, ErrorKind::Cancelled);
        QVERIFY(replay.sites.size() < 3000);
    }

private:
    /// The error at a point by brute force: the smallest over all cells that hold it.
    static double errorAt(const Replay& replay, const Cloud& cloud, std::size_t point)
    {
        double error = std::numeric_limits<double>::infinity();
        for (const auto& [number, t] : replay.alive) {
            const auto at = [&](std::size_t i) { return cloud.positions[replay.sites[t[i]]]; };
            Eigen::Matrix3d edges;
            edges << at(1) - at(0), at(2) - at(0), at(3) - at(0);
            const Position b = edges.inverse() * (cloud.positions[point] - at(0));
            if (b.minCoeff() < -1e-12 || b.sum() > 1 + 1e-12)
                continue;
            const auto value = [&](std::size_t i) { return cloud.values[replay.sites[t[i]]]; };
            const double interpolation =
                value(0) + b[0] * (value(1) - value(0)) + b[1] * (value(2) - value(0)) + b[2] * (value(3) - value(0));
            error = std::min(error, std::abs(cloud.values[point] - interpolation));
        }
        return error;
    }
};

QTEST_GUILESS_MAIN(ScatteredRefinementTest)
#include "scattered_refinement_test.moc"
