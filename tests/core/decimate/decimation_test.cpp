// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_log.h"
#include "core/decimate/decimation.h"

#include "tests/core/decimate/decimation_check.h"
#include "tests/lacks.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <stop_token>

using namespace tetra;

namespace {

QByteArray faultAt(const std::string& fault, std::size_t sites, std::uint32_t seed)
{
    return QByteArray::fromStdString(fault + ", at " + std::to_string(sites) + " sites, seed " + std::to_string(seed));
}

void compareSound(const TestMesh& mesh, const DecimationOptions& options, std::uint32_t seed, std::size_t step)
{
    RecordedHistory history;
    const auto result = decimate(mesh.view(), options, history);
    QVERIFY2(result, result ? "" : result.error().text().c_str());
    QVERIFY(!history.traits.delaunay);
    QCOMPARE(history.points.size(), mesh.positions.size());
    QCOMPARE(history.finalKey, 0.0f);
    const TetrahedraTopology original = topologyOf(mesh.tetrahedra);
    for (std::size_t sites = result->initialSites; sites <= mesh.positions.size(); sites += step) {
        const std::string fault = prefixFault(mesh, history, sites, original);
        QVERIFY2(fault.empty(), faultAt(fault, sites, seed).constData());
    }
    const std::string last = prefixFault(mesh, history, mesh.positions.size(), original);
    QVERIFY2(last.empty(), last.c_str());
}

int physicalSign(const TestMesh& mesh, const std::array<std::uint32_t, 4>& points)
{
    const auto at = [&mesh](std::uint32_t point) {
        const Eigen::Vector3d& place = mesh.physical[point];
        return std::array<double, 3>{place.x(), place.y(), place.z()};
    };
    return orientationSign(at(points[0]), at(points[1]), at(points[2]), at(points[3]));
}

} // namespace

class DecimationTest : public QObject {
    Q_OBJECT

private slots:
    void latticesKeepTheirBox();
    void nonconvexMeshesStaySound();
    void curvilinearGridsStaySound();
    void everyOrderIsSound();
    void theSameInputGivesTheSameHistory();
    void stopsAtTheKey();
    void aKeyThatOccursIsReached();
    void isCancelled();
    void refusesBadInput();
    void refusesMoreTetrahedraThanCanBeNumbered();
    void buckyballNeedsFewSites();
};

void DecimationTest::latticesKeepTheirBox()
{
    for (std::uint32_t seed = 0; seed < 6; ++seed)
        compareSound(latticeMesh({5 + seed % 3, 6, 5}, seed % 2 == 0 ? LatticeCut::Five : LatticeCut::Six, seed), {},
                     seed, 7);
}

void DecimationTest::nonconvexMeshesStaySound()
{
    DecimationOptions options;
    options.warpingWeight = 1;
    for (std::uint32_t seed = 0; seed < 500; ++seed)
        compareSound(nonconvexMesh(seed, seed % 3 == 0 ? 0 : .15), options, seed, seed % 25 == 0 ? 5 : 45);
}

void DecimationTest::curvilinearGridsStaySound()
{
    DecimationOptions options;
    options.warpingWeight = .5;
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        TestMesh mesh = latticeMesh({6, 5, 5}, LatticeCut::Five, seed);
        for (const Eigen::Vector3d& at : mesh.positions) {
            const double angle = .25 * at.x();
            mesh.physical.emplace_back((3 + at.y()) * std::cos(angle), (3 + at.y()) * std::sin(angle), 1.5 * at.z());
        }
        mesh.weights.assign(mesh.positions.size(), seed % 2 == 0 ? 1.0f : .5f);
        compareSound(mesh, options, seed, 7);
        RecordedHistory history;
        QVERIFY(decimate(mesh.view(), options, history));
        int hand = 0;
        for (const auto& t : mesh.tetrahedra)
            hand += physicalSign(mesh, {t[0], t[1], t[2], t[3]});
        for (const RecordedHistory::Tetrahedron& tetrahedron : history.tetrahedra) {
            std::array<std::uint32_t, 4> points{};
            for (std::size_t i = 0; i < 4; ++i)
                points[i] = static_cast<std::uint32_t>(history.points[tetrahedron.sites[i]]);
            QVERIFY(physicalSign(mesh, points) * (hand < 0 ? -1 : 1) >= 0);
        }
    }
}

/// R11, C8: that of the paper is one.
void DecimationTest::everyOrderIsSound()
{
    DecimationOptions options;
    options.warpingWeight = 1;
    for (const DecimationOrder order : {DecimationOrder::PaperEstimates, DecimationOrder::IndependentRounds})
        for (std::uint32_t seed = 600; seed < 612; ++seed) {
            options.order = order;
            compareSound(nonconvexMesh(seed, .15), options, seed, 31);
            compareSound(latticeMesh({5, 4, 6}, LatticeCut::Six, seed), options, seed, 31);
        }
}

void DecimationTest::theSameInputGivesTheSameHistory()
{
    DecimationOptions options;
    options.warpingWeight = 1;
    const TestMesh mesh = nonconvexMesh(7, .15);
    RecordedHistory first, second;
    QVERIFY(decimate(mesh.view(), options, first));
    QVERIFY(decimate(mesh.view(), options, second));
    QCOMPARE(first.points, second.points);
    QCOMPARE(first.runningKeys, second.runningKeys);
    QCOMPARE(first.tetrahedra.size(), second.tetrahedra.size());
}

/// R12, S11: no collapse is made whose error is beyond the key, so that the last mesh keeps it.
void DecimationTest::stopsAtTheKey()
{
    DecimationOptions options;
    options.stopKey = .25;
    RecordedHistory history;
    const TestMesh mesh = latticeMesh({8, 8, 8}, LatticeCut::Five, 3);
    const auto result = decimate(mesh.view(), options, history);
    QVERIFY(result);
    QVERIFY(result->initialSites > 8);
    QVERIFY(result->initialSites < mesh.positions.size());
    for (const RecordedHistory::Tetrahedron& tetrahedron : history.tetrahedra)
        QVERIFY(tetrahedron.error <= .25f);
}

/// What is as large as the limit is within it: the first error that a decimation comes to is that of its mesh.
void DecimationTest::aKeyThatOccursIsReached()
{
    TestMesh mesh = latticeMesh({6, 6, 6}, LatticeCut::Five, 3);
    for (double& value : mesh.values)
        value = std::round(2 * value);
    for (const DecimationOrder order :
         {DecimationOrder::ExactError, DecimationOrder::PaperEstimates, DecimationOrder::IndependentRounds}) {
        DecimationOptions options;
        options.order = order;
        RecordedHistory whole;
        QVERIFY(decimate(mesh.view(), options, whole));
        // The last sites come first in a decimation; the finest mesh has no error.
        const auto first = std::ranges::find_if(whole.runningKeys.rbegin(), whole.runningKeys.rend(),
                                                [](float key) { return key > 0; });
        QVERIFY(first != whole.runningKeys.rend() && std::isfinite(*first));
        options.stopKey = static_cast<double>(*first);
        RecordedHistory stopped;
        const auto result = decimate(mesh.view(), options, stopped);
        QVERIFY(result);
        float largest = 0;
        for (const RecordedHistory::Tetrahedron& tetrahedron : stopped.tetrahedra)
            largest = std::max(largest, tetrahedron.error);
        QCOMPARE(largest, *first);
    }
}

void DecimationTest::isCancelled()
{
    const TestMesh mesh = latticeMesh({16, 16, 16}, LatticeCut::Five, 3);
    for (const DecimationOrder order :
         {DecimationOrder::ExactError, DecimationOrder::PaperEstimates, DecimationOrder::IndependentRounds}) {
        std::stop_source stop;
        double last = 0;
        bool falling = false;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            falling |= fraction < last;
            last = fraction;
            stop.request_stop();
        });
        RecordedHistory history;
        DecimationOptions options;
        options.order = order;
        const auto result = decimate(mesh.view(), options, history, progress);
        QVERIFY(!result);
        QVERIFY(result.error().kind == ErrorKind::Cancelled);
        QVERIFY(!falling);
    }
}

void DecimationTest::refusesBadInput()
{
    const TestMesh sound = latticeMesh({3, 3, 3}, LatticeCut::Five, 1);
    const auto refused = [](const TestMesh& mesh, const DecimationOptions& options = {}) {
        RecordedHistory history;
        const auto result = decimate(mesh.view(), options, history);
        return !result && !result.error().text().empty() && history.points.empty();
    };
    TestMesh mesh = sound;
    mesh.tetrahedra.clear();
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.tetrahedra[3][2] = 27;
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.values[5] = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.positions[5].y() = std::numeric_limits<double>::infinity();
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.positions.emplace_back(1, 2, 3);
    QVERIFY(refused(mesh));
    mesh.values.push_back(1);
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.weights.assign(mesh.positions.size(), 0);
    QVERIFY(refused(mesh));
    mesh = sound;
    mesh.box = false;
    QVERIFY(refused(mesh));
    DecimationOptions options;
    options.stopKey = -1;
    QVERIFY(refused(sound, options));
    RecordedHistory history;
    history.failAfter = 10;
    const auto full = decimate(sound.view(), {}, history);
    QVERIFY(!full);
    QVERIFY(full.error().kind == ErrorKind::CannotWrite);
}

/// Counts of 32 bits that only add up to too much.
void DecimationTest::refusesMoreTetrahedraThanCanBeNumbered()
{
    CollapseLog log;
    log.add(1, 1, {}, 1u << 31);
    log.add(2, 2, {}, 1u << 31);
    RecordedHistory history;
    const Status refused = log.replay(std::vector<std::uint32_t>{0, 1, 2}, {}, 0, history, {});
    QVERIFY(!refused.ok());
    QCOMPARE(refused.error().kind, ErrorKind::OutOfResource);
    QCOMPARE(history.points.size(), std::size_t(0));
}

/// The paper's Table 2, and what acceptance asks for.
void DecimationTest::buckyballNeedsFewSites()
{
    QFile file(TAN_SOURCE_DIR "/../shared/data/buckyball/bucky_32x32x32_uint8.raw");
    if (!file.open(QIODevice::ReadOnly))
        QSKIP_WITHOUT("data");
    const QByteArray samples = file.readAll();
    TestMesh mesh = latticeMesh({32, 32, 32}, LatticeCut::Six, 0);
    QCOMPARE(static_cast<std::size_t>(samples.size()), mesh.positions.size());
    for (std::size_t i = 0; i < mesh.values.size(); ++i)
        mesh.values[i] = static_cast<unsigned char>(samples[static_cast<qsizetype>(i)]);
    const auto [least, greatest] = std::ranges::minmax(mesh.values);
    RecordedHistory history;
    QVERIFY(decimate(mesh.view(), {}, history));
    struct Level {
        double percent, papersSites, share;
    };
    constexpr Level levels[] = {{4, 7125, 1.05},  {3, 8680, 1.02},  {2, 10808, 1.02}, {1, 14372, .85},
                                {.5, 18090, .85}, {.2, 22982, .85}, {.1, 26854, 1.02}};
    for (const Level& level : levels) {
        const auto sites = static_cast<double>(history.sitesAt(level.percent / 100 * (greatest - least)));
        QVERIFY2(sites <= level.share * level.papersSites,
                 qPrintable(QString("%1 sites at %2 %").arg(sites).arg(level.percent)));
    }
}

QTEST_GUILESS_MAIN(DecimationTest)
#include "decimation_test.moc"
