// SPDX-License-Identifier: GPL-3.0-or-later
/// A build that is not in blocks and is interrupted any number of times hands over the very history of one that is not;
/// what it left is refused where it is damaged or of something else (B6).
#include "tests/core/refine/recorded_history.h"
#include "tests/soak.h"

#include <tan/build.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

using namespace tetra;

namespace {

using Bytes = std::vector<char>;

double fieldAt(const Eigen::Vector3d& place)
{
    return std::sin(5 * place.x()) * std::cos(4 * place.y()) + place.z() * place.z() + .1 * std::sin(40 * place.x());
}

std::vector<Eigen::Vector3d> gridPositions(std::uint32_t size, bool bent)
{
    std::vector<Eigen::Vector3d> positions;
    for (std::uint32_t z = 0; z < size; ++z)
        for (std::uint32_t y = 0; y < size; ++y)
            for (std::uint32_t x = 0; x < size; ++x) {
                const Eigen::Vector3d at = Eigen::Vector3d(x, y, z) / size;
                positions.push_back(
                    bent ? Eigen::Vector3d((1 + at.y()) * std::cos(at.x()), (1 + at.y()) * std::sin(at.x()), at.z())
                         : Eigen::Vector3d(at.x() * (1 + at.x()), at.y(), at.z()));
            }
    return positions;
}

template <class Positions> ScalarField fieldOf(const Positions& positions)
{
    std::vector<float> values;
    for (const Eigen::Vector3d& place : positions)
        values.push_back(static_cast<float>(fieldAt(place)));
    return ScalarField::of(std::move(values));
}

Dataset lattice(std::uint32_t size)
{
    return latticeDataset({.size = {size, size, size}}, fieldOf(gridPositions(size, false)), "lattice").value();
}

Dataset grid(std::uint32_t size, bool bent)
{
    const auto positions = gridPositions(size, bent);
    Dataset dataset = curvilinearDataset({size, size, size}, positions, fieldOf(positions), "grid").value();
    dataset.convex = hasConvexDomain(dataset);
    return dataset;
}

Dataset points(std::uint32_t count)
{
    std::mt19937 random(7);
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    const auto coordinate = [&random] { return static_cast<double>(random()) / 4294967296.0 - .5; };
    while (positions.size() < count) {
        const Eigen::Vector3d place(coordinate(), coordinate(), coordinate());
        if (place.norm() > .5)
            continue;
        positions.push_back(place);
        values.push_back(fieldAt(place));
    }
    return scatteredDataset(positions, values, "points").value();
}

Dataset mesh(std::uint32_t count)
{
    Dataset dataset = tetrahedrized(points(count)).value();
    dataset.convex = hasConvexDomain(dataset);
    return dataset;
}

bool same(const RecordedHistory& one, const RecordedHistory& other)
{
    return one.points == other.points && one.runningKeys == other.runningKeys && one.finalKey == other.finalKey &&
           one.traits.warpingWeight == other.traits.warpingWeight && one.traits.delaunay == other.traits.delaunay &&
           std::ranges::equal(one.tetrahedra, other.tetrahedra, [](const auto& a, const auto& b) {
               return a.sites == b.sites && a.error == b.error && a.destroyer == b.destroyer && a.warping == b.warping;
           });
}

Bytes bytesOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void write(const std::filesystem::path& path, const Bytes& bytes)
{
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

} // namespace

class ResumedBuildTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void isTheSame_data() { everyBuilder(); }
    void isTheSame()
    {
        const Case chosen = caseOf(QTest::currentDataTag());
        RecordedHistory expected;
        QVERIFY(build(chosen, expected, false).ok());
        for (std::uint32_t seed = 1; seed <= timesOf(1u, 4u); ++seed) {
            init();
            std::mt19937 random(seedOf(seed));
            int interruptions = 0;
            for (;; ++interruptions) {
                QVERIFY(interruptions < 1000);
                RecordedHistory history;
                const auto report = build(chosen, history, true, 3 + static_cast<int>(random() % 2));
                if (!report) {
                    QVERIFY2(report.error().kind == ErrorKind::Cancelled, report.error().text().c_str());
                    QVERIFY(std::filesystem::exists(file("state")));
                    continue;
                }
                QVERIFY(same(history, expected));
                break;
            }
            QVERIFY(interruptions > 0);
        }
    }

    /// A kill may leave a journal that goes on beyond the state.
    void goesOnFromAnEarlierState_data() { everyBuilder(); }
    void goesOnFromAnEarlierState()
    {
        const Case chosen = caseOf(QTest::currentDataTag());
        RecordedHistory expected, history, again;
        QVERIFY(build(chosen, expected, false).ok());
        QVERIFY(!build(chosen, history, true, 2).ok());
        const Bytes state = bytesOf(file("state"));
        QVERIFY(!build(chosen, history = {}, true, 4).ok());
        QVERIFY(bytesOf(file("state")) != state);
        write(file("state"), state);
        QVERIFY(build(chosen, again, true).ok());
        QVERIFY(same(again, expected));
    }

    void damageIsRefused_data()
    {
        QTest::addColumn<int>("nothing");
        for (const char* name : {"decimated lattice", "decimated mesh", "refined points", "refined lattice"})
            QTest::newRow(name) << 0;
    }
    void damageIsRefused()
    {
        const Case chosen = caseOf(QTest::currentDataTag());
        RecordedHistory history;
        QVERIFY(!build(chosen, history, true, 6).ok());
        std::mt19937 random(seedOf(5));
        for (const char* name : {"state", "journal"}) {
            const Bytes whole = bytesOf(file(name));
            QVERIFY(whole.size() > 100);
            for (int round = 0; round < timesOf(6, 30); ++round) {
                Bytes damaged = whole;
                if (round % 3 == 0)
                    damaged.resize(round == 0 ? 0 : random() % whole.size());
                else
                    damaged[random() % whole.size()] ^= static_cast<char>(1 << random() % 8);
                write(file(name), damaged);
                const auto report = build(chosen, history = {}, true);
                QVERIFY2(!report, name);
                QVERIFY2(report.error().kind == ErrorKind::BadInput, report.error().text().c_str());
                QVERIFY2(report.error().text().find("is damaged") != std::string::npos, report.error().text().c_str());
            }
            write(file(name), whole);
        }
        QVERIFY(std::filesystem::remove(file("journal")));
        QVERIFY(!build(chosen, history = {}, true).ok());
    }

    void anotherBuildIsRefused()
    {
        const Case chosen = caseOf("decimated lattice");
        RecordedHistory history;
        QVERIFY(!build(chosen, history, true, 3).ok());
        Case other = chosen;
        std::get<Decimation>(other.method).error = 20;
        Case otherData = chosen;
        otherData.dataset = lattice(15);
        Case otherWeights = chosen;
        std::get<Decimation>(otherWeights.method).weighting = parseWeighting("value:0,1").value();
        for (const Case& refused : {other, otherData, otherWeights, caseOf("refined lattice")}) {
            const auto report = build(refused, history = {}, true);
            QVERIFY(!report);
            QVERIFY2(report.error().kind == ErrorKind::WrongUsage, report.error().text().c_str());
            QVERIFY(report.error().text().find("another version of TAn") != std::string::npos);
        }
        QVERIFY(build(chosen, history = {}, true).ok());
    }

private:
    struct Case {
        Dataset dataset;
        BuildMethod method;
    };

    static void everyBuilder()
    {
        QTest::addColumn<int>("nothing");
        for (const char* name :
             {"decimated lattice", "decimated grid", "decimated points", "decimated mesh", "decimated mesh, two-sided",
              "decimated lattice, the paper's order", "decimated mesh, the paper's order", "decimated mesh, rounds",
              "refined points", "refined mesh", "refined rectilinear grid", "refined lattice", "refined grid",
              "refined grid, the paper's selection", "refined grid, in space"})
            QTest::newRow(name) << 0;
    }
    static Case caseOf(const std::string& name)
    {
        constexpr DecimationOrder paper = DecimationOrder::PaperEstimates, rounds = DecimationOrder::IndependentRounds;
        constexpr std::uint32_t some = 4000;
        if (name == "decimated lattice")
            return {lattice(16), Decimation{}};
        if (name == "decimated grid")
            return {grid(16, true), Decimation{}};
        if (name == "decimated points")
            return {points(some), Decimation{}};
        if (name == "decimated mesh")
            return {mesh(some), Decimation{}};
        if (name == "decimated mesh, two-sided")
            return {mesh(some), Decimation{.twoSided = true}};
        if (name == "decimated lattice, the paper's order")
            return {lattice(16), Decimation{.order = paper}};
        if (name == "decimated mesh, the paper's order")
            return {mesh(some), Decimation{.order = paper}};
        if (name == "decimated mesh, rounds")
            return {mesh(some), Decimation{.order = rounds}};
        if (name == "refined points")
            return {points(2 * some), Refinement{}};
        if (name == "refined mesh")
            return {mesh(2 * some), Refinement{}};
        if (name == "refined rectilinear grid")
            return {grid(20, false), Refinement{}};
        if (name == "refined lattice")
            return {lattice(32), Refinement{.block = 0}};
        if (name == "refined grid")
            return {grid(32, true), Refinement{.block = 0}};
        if (name == "refined grid, the paper's selection")
            return {grid(32, true), Refinement{.paperSelection = true}};
        return {grid(24, true), Refinement{.error = 1, .inSpace = true}};
    }

    std::filesystem::path file(const char* name) const { return folder_->filePath(name).toStdString(); }

    /// Cancelled after so many reports of its progress.
    Result<BuildReport> build(const Case& chosen, HistorySink& history, bool resume, int reports = 1 << 30) const
    {
        std::stop_source stop;
        const Progress progress(stop.get_token(), [&](double, const Message&) {
            if (--reports == 0)
                stop.request_stop();
        });
        return std::visit(
            [&](const auto& method) -> Result<BuildReport> {
                const auto taken = takenFor(method, chosen.dataset);
                if (!taken)
                    return taken.error();
                BuildTarget target{.history = history};
                if (resume) {
                    target.workFolder = folder_->path().toStdString();
                    target.resume = true;
                }
                return buildInto(*taken, method, target, progress);
            },
            chosen.method);
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(ResumedBuildTest)
#include "resumed_build_test.moc"
