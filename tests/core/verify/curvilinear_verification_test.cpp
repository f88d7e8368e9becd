// SPDX-License-Identifier: GPL-3.0-or-later
// The checker proves models of curvilinear data (B3, R4, R5) and finds what is wrong with damaged ones (S5, S6). The
// models come from the slow reference refinement, the expected warpings from the grids' formulas.
#include "core/history/model_writer.h"
#include "core/verify/exact_cell.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/reference_refinement.h"
#include "tests/core/refine/plot3d_data.h"
#include "tests/core/verify/slow_errors.h"
#include "tests/lacks.h"

#include <tan/build.h>
#include <tan/query.h>
#include <tan/verify.h>

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <Eigen/Dense>

#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>

using namespace tetra;
using format::SectionId;
using testing::areSame;
using testing::SlowErrors;

namespace {

QString textOf(const VerificationReport& verdict)
{
    QString text;
    for (const std::string& failure : verdict.failures)
        text += QString::fromStdString(failure) + "\n";
    for (const LevelReport& level : verdict.levels)
        for (const std::string& failure : level.failures)
            text += QString::number(level.asked.error) + " %: " + QString::fromStdString(failure) + "\n";
    return text;
}

/// The dataset with its positions changed; what was built from it no longer fits.
Dataset moved(const Dataset& dataset, const std::function<Eigen::Vector3d(std::uint64_t, const Eigen::Vector3d&)>& move)
{
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>(*dataset.positions);
    for (std::uint64_t point = 0; point < positions->size(); ++point)
        (*positions)[point] = move(point, (*positions)[point]);
    Dataset result = dataset;
    result.positions = positions;
    result.source.hash = contentHash(result.values, result.positions);
    return result;
}

/// A bent grid, or with `turn` one that is wrapped around a hole, each point moved by up to `noise` along each axis.
Dataset movedAtRandom(std::array<std::uint32_t, 3> size, double noise, double turn, bool mirrored)
{
    std::mt19937 random(12);
    std::uniform_real_distribution<double> anywhere(-noise, noise);
    const Dataset bent = bentBumps(SampleType::Float32, size, true, mirrored);
    return moved(bent, [&](std::uint64_t point, Eigen::Vector3d place) {
        const auto [i, j, k] = bent.lattice.coordinates(point);
        const double radius = 2.0 + i;
        if (turn > 0)
            place = {radius * std::cos(turn * j), radius * std::sin(turn * j), 1.0 * k};
        return Eigen::Vector3d(place + Eigen::Vector3d(anywhere(random), anywhere(random), anywhere(random)));
    });
}

} // namespace

class CurvilinearVerificationTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void goodModelsAreProved_data()
    {
        QTest::addColumn<SampleType>("type");
        QTest::addColumn<bool>("precise");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("floats") << SampleType::Float32 << false << false;
        QTest::newRow("doubles") << SampleType::Float64 << true << false;
        QTest::newRow("left-handed") << SampleType::Int16 << false << true;
    }
    void goodModelsAreProved()
    {
        QFETCH(SampleType, type);
        QFETCH(bool, precise);
        QFETCH(bool, mirrored);
        const Dataset dataset = bentBumps(type, {6, 5, 4}, precise, mirrored);
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY2(verdict.ok(), qPrintable(textOf(verdict)));
        QVERIFY(verdict.levels[0].measured.warping.largest > 0);
        for (const LevelReport& level : verdict.levels) {
            QVERIFY(level.measured.error.largest <= level.asked.error + 1e-9);
            QVERIFY(level.measured.warping.largest <= level.asked.warping + 1e-9);
            QVERIFY(level.conforming && level.covers && level.inverted == 0 && level.degenerate == 0);
        }
        QVERIFY(verdict.levels.front().sites < verdict.levels.back().sites);
    }

    /// Both numbers are those of the mesh, measured here over all points and tetrahedra.
    void warpingIsMeasured()
    {
        const Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 3});
        writeModel(path(), dataset);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const auto verdict = verify(**model, dataset, {{100, anyWarping}});
        QVERIFY(verdict.ok() && verdict->ok());
        QCOMPARE(verdict->levels[0].sites, 8U);
        // With the corners alone, points on the edge from (0,0,0) to (4,0,0) warp from the straight line.
        const Eigen::Vector3d chord = 0.5 * (dataset.position(0) + dataset.position(4));
        const double warping = 100 * (dataset.position(2) - chord).norm() / dataset.bounds().diagonal().norm();
        QVERIFY(verdict->levels[0].measured.warping.largest >= warping);
        QVERIFY(verdict->levels[0].measured.warping.largest < 4 * warping);
    }

    /// C12: the error in space is what looking at every tetrahedron for every point finds: on grids moved at random,
    /// gently or until cells fold, and on one that is wrapped around a hole.
    void theErrorInSpaceIsMeasured_data()
    {
        QTest::addColumn<double>("noise");
        QTest::addColumn<double>("turn");
        QTest::addColumn<bool>("mirrored");
        QTest::newRow("gentle") << 0.1 << 0.0 << false;
        QTest::newRow("left-handed") << 0.1 << 0.0 << true;
        QTest::newRow("folded") << 0.9 << 0.0 << false;
        QTest::newRow("wrapped") << 0.05 << 0.8 << false;
    }
    void theErrorInSpaceIsMeasured()
    {
        QFETCH(double, noise);
        QFETCH(double, turn);
        QFETCH(bool, mirrored);
        const Dataset dataset = movedAtRandom({5, 8, 4}, noise, turn, mirrored);
        writeModel(path(), dataset);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const VerificationReport verdict = verdictOf(dataset);
        bool twice = false, differs = false;
        for (const LevelReport& level : verdict.levels) {
            const SlowErrors slow(dataset, **model, level.sites);
            const ErrorInSpace& inSpace = level.measured.errorInSpace;
            QVERIFY2(areSame(inSpace, slow.percents), qPrintable(QString::number(level.asked.error)));
            QCOMPARE(inSpace.outside, slow.outside);
            twice = twice || slow.twice > 0;
            differs = differs || inSpace.largest > 1.5 * level.measured.error.largest;
        }
        QVERIFY(verdict.levels.front().measured.errorInSpace.outside > 0);
        QCOMPARE(twice, noise > 0.5 || turn > 0);
        QVERIFY(differs);
        QCOMPARE(verdict.levels.back().measured.errorInSpace.largest, 0.0);
    }

    /// C12: a build that keeps the error in space does so at every accuracy, and the checker says so of it; of one that
    /// only claims it, the checker says no.
    void theErrorInSpaceIsKept_data() { theErrorInSpaceIsMeasured_data(); }
    void theErrorInSpaceIsKept()
    {
        QFETCH(double, noise);
        QFETCH(double, turn);
        QFETCH(bool, mirrored);
        const Dataset dataset = movedAtRandom({9, 12, 8}, noise, turn, mirrored);
        const auto built = buildModel(dataset, path(), Refinement{.inSpace = true});
        QVERIFY2(built.ok(), built ? "" : built.error().text().c_str());
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const std::vector<Accuracy> levels = {{30, 30}, {20, anyWarping}, {10, 10}, {5, 5}, {2, 8}, {1, 1}, {0, 0}};
        const auto verdict = verify(**model, dataset, levels);
        QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(verdict ? textOf(*verdict) : QString()));
        std::uint32_t before = 0;
        for (const LevelReport& level : verdict->levels) {
            QCOMPARE(level.sites, meshSizeAt(**model, level.asked).sites);
            before = std::max(before, level.sites);
        }
        QVERIFY(verdict->levels.front().sites < before); // it has levels
        const auto mesh = MeshExtractor(*model).extract({.error = 5.0, .warping = 5.0});
        QVERIFY(mesh.ok());
        QCOMPARE((*mesh)->wholeSites, meshSizeAt(**model, {5, 5}).sites);

        const Dataset small = movedAtRandom({5, 8, 4}, noise, turn, mirrored);
        ModelDescription claiming;
        claiming.parameters = {{"error-in", "space"}};
        auto writer = ModelWriter::create(path(), small, claiming);
        QVERIFY(writer.ok());
        QVERIFY(replay(historyOf(small), **writer).ok());
        writer->reset();
        const QString says = textOf(verdictOf(small));
        QVERIFY2(says.contains("The error at the place in space of sample"), qPrintable(says));
    }

    /// C12, C15: the figures of docs/lab/performance.md, and that the option keeps what it says on the same grid.
    void theErrorInSpaceOfARealGrid()
    {
        auto data = readPlot3d("bluntfin");
        if (!data)
            QSKIP_WITHOUT("data");
        const auto dataset =
            curvilinearDataset(data->size, std::move(data->positions), ScalarField::of(std::move(data->values)), "fin");
        QVERIFY(dataset.ok());
        const auto levelsOf = [&](const Refinement& refinement) {
            if (!buildModel(*dataset, path(), refinement))
                qFatal("the grid was not built");
            auto verdict = verify(*Model::open(path()).value(), *dataset, {{8, 8}, {4, 4}});
            if (!verdict || !verdict->ok())
                qFatal("%s", verdict ? qPrintable(textOf(*verdict)) : verdict.error().text().c_str());
            return verdict->levels;
        };
        const std::vector<LevelReport> inGrid = levelsOf({.error = 4, .block = 0});
        QVERIFY(std::abs(inGrid[1].measured.errorInSpace.largest - 11.97) < 0.1);
        QVERIFY(std::abs(inGrid[1].measured.errorInSpace.percentile99 - 4.32) < 0.1);
        const std::vector<LevelReport> inSpace = levelsOf({.error = 4, .inSpace = true});
        for (std::size_t level = 0; level < inSpace.size(); ++level) {
            QVERIFY(inSpace[level].measured.errorInSpace.largest < 1.1 * inSpace[level].asked.error);
            QVERIFY(inSpace[level].sites > inGrid[level].sites && inSpace[level].sites < 2 * inGrid[level].sites);
        }
    }

    /// C12: the same model with any number of threads.
    void theErrorInSpaceIsTheSameOnAnyThreads()
    {
        const Dataset dataset = movedAtRandom({9, 12, 8}, 0.6, 0.55, false);
        const auto built = [&](std::size_t threads) {
            const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, threads);
            if (!buildModel(dataset, path(), Refinement{.inSpace = true}))
                qFatal("the grid was not built");
            QFile file(QString::fromStdString(path().string()));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray one = built(1);
        QVERIFY(!one.isEmpty());
        QVERIFY(built(5) == one);
    }

    /// What does not go with keeping the error in space is refused.
    void theErrorInSpaceIsOfWholeGrids()
    {
        const Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 4});
        QCOMPARE(buildModel(dataset, path(), Refinement{.block = 4, .inSpace = true}).error().kind,
                 ErrorKind::WrongUsage);
        QCOMPARE(buildModel(dataset, path(), Refinement{.paperSelection = true, .inSpace = true}).error().kind,
                 ErrorKind::WrongUsage);
        const Refinement byError{.orderedBy = OrderedBy::Error, .inSpace = true};
        QCOMPARE(buildModel(dataset, path(), byError).error().kind, ErrorKind::WrongUsage);
        const Dataset lattice = bumps(SampleType::UInt8, {5, 4, 4});
        QCOMPARE(buildModel(lattice, path(), Refinement{.inSpace = true}).error().kind, ErrorKind::WrongUsage);
    }

    /// C12: where the grid is a lattice under a linear map there is one error only.
    void inSpaceAndInTheGridAreOneWithoutWarping()
    {
        const Dataset bent = bentBumps(SampleType::Float32, {5, 4, 6});
        const Dataset dataset = moved(bent, [&](std::uint64_t point, const Eigen::Vector3d&) {
            const auto [i, j, k] = bent.lattice.coordinates(point);
            return Eigen::Vector3d(3.0 * i + j, 2.0 * j - 1.0 * k, 4.0 * k + 1.0 * i);
        });
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY2(verdict.ok(), qPrintable(textOf(verdict)));
        for (const LevelReport& level : verdict.levels) {
            const ResidualStatistics& inGrid = level.measured.error;
            const ErrorInSpace& inSpace = level.measured.errorInSpace;
            QCOMPARE(inSpace.outside, std::uint64_t(0));
            for (const auto number : {&ResidualStatistics::largest, &ResidualStatistics::mean,
                                      &ResidualStatistics::percentile99, &ResidualStatistics::rootMeanSquare})
                QVERIFY(std::abs(inSpace.*number - inGrid.*number) < 1e-9);
        }
        QVERIFY(verdict.levels.front().measured.error.mean > 1);
    }

    /// Points that fall together make cells without volume, which are counted and no failure (S6).
    void collapsedAxesAreBorne()
    {
        const Dataset whole = bentBumps(SampleType::Float32, {5, 4, 4});
        const Dataset dataset = moved(whole, [&](std::uint64_t point, const Eigen::Vector3d& place) {
            return point / 5 % 4 == 0 ? whole.position(point % 5) : place; // the lines j = 0 of all k fall together
        });
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY(verdict.levels.back().degenerate > 0);
        for (const LevelReport& level : verdict.levels)
            QVERIFY(level.conforming && level.covers);
        QVERIFY2(verdict.levels.back().ok(), qPrintable(textOf(verdict)));
    }

    /// A point pulled through its neighbours folds cells: what is inverted there is counted, and no failure. The slow
    /// refinement cures nothing: what is inverted elsewhere is a failure.
    void foldedCellsAreBorne()
    {
        const Dataset dataset =
            moved(bentBumps(SampleType::Float32, {5, 4, 4}), [](std::uint64_t point, const Eigen::Vector3d& p) {
                return point == 2 + 5 * (1 + 4 * 2) ? Eigen::Vector3d(p + Eigen::Vector3d(0, 0, -4)) : p;
            });
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY(verdict.failures.empty());
        QCOMPARE(verdict.foldedCells, std::uint64_t(4)); // below the point
        bool borne = false;
        for (const LevelReport& level : verdict.levels) {
            QCOMPARE(level.ok(), level.inverted == level.invertedInData);
            borne = borne || (level.invertedInData > 0 && level.sites < verdict.levels.back().sites);
        }
        QVERIFY(borne);
        QVERIFY2(verdict.levels.back().ok(), qPrintable(textOf(verdict)));
        QVERIFY(verdict.levels.back().inverted > 0);
    }

    /// A grid that is wrapped around: coarse tetrahedra turn over, and none of its cells does.
    void invertedCellsAreFound()
    {
        const Dataset dataset =
            moved(bentBumps(SampleType::Float32, {4, 9, 4}), [](std::uint64_t point, const Eigen::Vector3d&) {
                const double angle = 0.7 * static_cast<double>(point / 4 % 9);
                const double radius = 1 + static_cast<double>(point % 4);
                return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle),
                                       static_cast<double>(point / 36)); // NOLINT(bugprone-integer-division)
            });
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY(verdict.failures.empty());
        QCOMPARE(verdict.foldedCells, std::uint64_t(0));
        QVERIFY2(verdict.levels.back().ok(), qPrintable(textOf(verdict)));
        QCOMPARE(verdict.levels.back().inverted, std::uint64_t(0));
        bool found = false;
        for (const LevelReport& level : verdict.levels) {
            QCOMPARE(level.ok(), level.inverted == 0);
            QCOMPARE(level.invertedInData, std::uint64_t(0));
            found = found || level.inverted > 0;
        }
        QVERIFY(found);
        QVERIFY(textOf(verdict).contains("is inverted in physical space"));
    }

    void damageIsFound_data()
    {
        QTest::addColumn<std::function<void(FileParts&)>>("damage");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, std::function<void(FileParts&)> damage, const char* says) {
            QTest::newRow(name) << std::move(damage) << QString(says);
        };
        row(
            "position", [](FileParts& f) { f.elements<Eigen::Vector3f>(SectionId::SitePositions)[9][1] += 0.25F; },
            "Site 9 does not lie where the original has point");
        row(
            "own warpings",
            [](FileParts& f) {
                for (std::uint16_t& half : f.elements<std::uint16_t>(SectionId::OwnWarpings))
                    half = 0;
            },
            "larger than the own warping of every cell");
        row(
            "weight", [](FileParts& f) { f.header().warpingWeight *= 8; }, "The warping at sample");
        row(
            "running errors",
            [](FileParts& f) {
                for (float& key : f.elements<float>(SectionId::SiteRunningKeys))
                    key /= 4;
                f.header().finalKey = 0;
            },
            "more than the claimed");
        row(
            "hand", [](FileParts& f) { f.header().leftHanded = 1; }, "takes the grid for a left-handed one");
        row(
            "bounds", [](FileParts& f) { f.header().boundingBox[3] += 1; }, "bounding box");
        row(
            "hash", [](FileParts& f) { f.header().sourceHash += 1; }, "other samples or positions");
    }
    void damageIsFound()
    {
        QFETCH(std::function<void(FileParts&)>, damage);
        QFETCH(QString, says);
        const Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 4});
        writeModel(path(), dataset);
        FileParts file(readBytes(path()));
        damage(file);
        file.repairChecksums();
        writeBytes(path(), file.content);
        const VerificationReport verdict = verdictOf(dataset);
        QVERIFY(!verdict.ok());
        QVERIFY2(textOf(verdict).contains(says), qPrintable(textOf(verdict)));
    }

    void otherPositionsAreAnotherDataset()
    {
        const Dataset dataset = bentBumps(SampleType::Float32, {5, 4, 4});
        writeModel(path(), dataset);
        const VerificationReport verdict = verdictOf(moved(dataset, [](std::uint64_t point, const Eigen::Vector3d& p) {
            return point == 17 ? Eigen::Vector3d(p + Eigen::Vector3d(0.125, 0, 0)) : p;
        }));
        QVERIFY2(textOf(verdict).contains("other samples or positions"), qPrintable(textOf(verdict)));
    }

    /// The sign is that of 128-bit whole numbers, however close to none the volume is.
    void volumesHaveTheirExactSign()
    {
        std::mt19937_64 random(20240229);
        int zeros = 0;
        for (int round = 0; round < 20000; ++round) {
            std::array<std::array<std::int64_t, 3>, 4> corners{};
            const int range = round % 3 == 0 ? 2 : round % 3 == 1 ? 1000 : 1 << 30;
            for (auto& corner : corners)
                for (std::int64_t& coordinate : corner)
                    coordinate = static_cast<std::int64_t>(random() % static_cast<unsigned>(range));
            if (round % 2 == 0) // in a plane, or just beside it
                for (std::size_t axis = 0; axis < 3; ++axis)
                    corners[3][axis] =
                        corners[1][axis] + corners[2][axis] - corners[0][axis] + (axis == 2 && round % 4 == 0 ? 1 : 0);
            __int128 edges[3][3];
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    edges[row][axis] = corners[row + 1][axis] - corners[0][axis];
            const __int128 volume = edges[0][0] * (edges[1][1] * edges[2][2] - edges[1][2] * edges[2][1]) -
                                    edges[0][1] * (edges[1][0] * edges[2][2] - edges[1][2] * edges[2][0]) +
                                    edges[0][2] * (edges[1][0] * edges[2][1] - edges[1][1] * edges[2][0]);
            const int expected = volume > 0 ? 1 : volume < 0 ? -1 : 0;
            zeros += expected == 0 ? 1 : 0;
            const double unit = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
            std::array<Eigen::Vector3d, 4> places;
            for (std::size_t corner = 0; corner < 4; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    places[corner][static_cast<Eigen::Index>(axis)] = static_cast<double>(corners[corner][axis]) * unit;
            QCOMPARE(volumeSign(places[0], places[1], places[2], places[3]), expected);
            QCOMPARE(volumeSign(places[1], places[0], places[2], places[3]), -expected);
        }
        QVERIFY(zeros > 1000);
        QCOMPARE(volumeSign({0, 0, 0}, {1e-300, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e300}), 1);
    }

private:
    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }
    VerificationReport verdictOf(const Dataset& dataset) const
    {
        const auto model = Model::open(path());
        if (!model)
            qFatal("%s", model.error().text().c_str());
        const auto verdict = verify(**model, dataset, {{20, 20}, {10, 10}, {5, 5}, {2, 8}, {3, 1}, {1, 1}, {0, 0}});
        if (!verdict)
            qFatal("%s", verdict.error().text().c_str());
        return *verdict;
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(CurvilinearVerificationTest)
#include "curvilinear_verification_test.moc"
