// SPDX-License-Identifier: GPL-3.0-or-later
/// S5, C7, C10: of grids with folded cells, models of every builder are proved at every level, and of meshes of any
/// other query: inverted are those tetrahedra that may be, as a slow search over all cells finds, and no others.
#include "core/data/dataset_checks.h"
#include "core/decimate/decimation.h"
#include "core/decimate/lattice_tetrahedra.h"
#include "core/history/model_writer.h"
#include "core/refine/curvilinear/curvilinear_grid.h"
#include "core/verify/curvilinear_cells.h"
#include "core/verify/verify_mesh.h"
#include "tests/core/history/folded_grids.h"
#include "tests/core/history/model_fixture.h"

#include <tan/build.h>
#include <tan/query.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace tetra;

namespace {

/// Hands a history on, but claims of each mesh that is not consistent that it is, and nearer to the data than the one
/// before.
struct LyingSink final : HistorySink {
    HistorySink& sink;
    float key;

    LyingSink(HistorySink& to, double extent) : sink(to), key(static_cast<float>(extent)) {}
    Status begin(const HistoryTraits& traits) override { return sink.begin(traits); }
    Status add(const HistoryStep& step) override
    {
        HistoryStep lie = step;
        constexpr std::uint32_t corners = 8;
        if (++sites <= corners)
            return sink.add(lie);
        key = std::isinf(step.keyBefore) ? 0.995F * key : std::min(key, step.keyBefore);
        lie.keyBefore = key;
        return sink.add(lie);
    }
    Status finish(float finalKey) override { return sink.finish(finalKey); }

private:
    std::uint32_t sites = 0;
};

/// What a build counts as inverted in the finest mesh.
Result<std::uint64_t> buildFolded(const std::string& builder, const BentGrid& grid, HistorySink& sink)
{
    if (builder.starts_with("decimation")) {
        std::vector<Eigen::Vector3d> places;
        for (std::size_t point = 0; point < grid.positions.size(); ++point)
            places.emplace_back(grid.place(point)[0], grid.place(point)[1], grid.place(point)[2]);
        const auto tetrahedra = latticeTetrahedra(grid.size, LatticeCut::Six);
        DecimationMesh mesh;
        mesh.positions = places;
        mesh.physical = grid.positions;
        mesh.leftHanded = isLeftHanded(datasetOfGrid(grid));
        mesh.values = grid.values;
        mesh.tetrahedra = tetrahedra;
        mesh.box = true;
        DecimationOptions options;
        options.warpingWeight = grid.options().warpingWeight;
        if (builder.ends_with("rounds"))
            options.order = DecimationOrder::IndependentRounds;
        if (const auto done = decimate(mesh, options, sink); !done)
            return done.error();
        return static_cast<std::uint64_t>(std::ranges::count_if(
            tetrahedra, [slow = SlowGrid(grid)](const auto& points) { return slow.isInverted(points); }));
    }
    CurvilinearRefinementOptions options = grid.options();
    if (builder.starts_with("paper"))
        options.selection = CurvilinearSelection::Paper;
    const auto result = grid.refine(options, sink);
    if (!result)
        return result.error();
    return result->inverted;
}

QString failuresOf(const LevelReport& level)
{
    QString text = QString::number(level.asked.error) + " %:";
    for (const std::string& failure : level.failures)
        text += " " + QString::fromStdString(failure);
    return text;
}

const std::vector<Accuracy> allLevels = {{5, 5}, {4, 4}, {3, 3}, {2, 2}, {1, 1}, {.5, .5}, {.2, .2}, {.1, .1}, {0, 0}};

} // namespace

class FoldedGridsTest : public QObject {
    Q_OBJECT

private slots:
    /// Both ways to find out whether a tetrahedron meets a folded cell, the builder's and the verifier's, against the
    /// slow one: cells that are touched only, far ones along a long axis, cells held whole.
    void meetingIsExact_data()
    {
        QTest::addColumn<QString>("grid");
        for (const char* grid :
             {"inside", "one cell", "a plane", "left-handed", "turned back", "bent cells", "random 1", "long"})
            QTest::newRow(grid) << QString(grid);
    }
    void meetingIsExact()
    {
        QFETCH(QString, grid);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const Dataset dataset = datasetOfGrid(bent);
        const SlowGrid slow(bent);
        const CurvilinearGrid curvilinear(bent.size, bent.positions,
                                          LatticeSamples(std::span<const double>(bent.values)));
        std::vector<std::string> failures;
        const auto original = CurvilinearOriginal::make(dataset, isLeftHanded(dataset), failures, {});
        QVERIFY(original.ok() && failures.empty());
        QCOMPARE(curvilinear.foldedCells().count(), slow.foldedCells());
        QCOMPARE(original->foldedCells(), slow.foldedCells());
        std::mt19937 random(20241122);
        int met = 0, missed = 0;
        while (met + missed < 4000) {
            std::array<std::uint32_t, 4> points{};
            for (std::uint32_t& point : points)
                point = random() % static_cast<std::uint32_t>(bent.values.size());
            LatticeCorners corners{};
            std::array<PackedPoint, 4> packed{};
            for (std::size_t corner = 0; corner < 4; ++corner) {
                auto place = bent.place(points[corner]);
                for (std::size_t axis = 0; axis < 3 && corner > 0 && met % 2 == 0; ++axis) // a small one
                    place[axis] = static_cast<std::uint32_t>(std::clamp<std::int64_t>(
                        corners[0][axis] + std::int64_t(random() % 5) - 2, 0, bent.size[axis] - 1));
                points[corner] = (place[2] * bent.size[1] + place[1]) * bent.size[0] + place[0];
                corners[corner] = {place[0], place[1], place[2]};
                packed[corner] = curvilinear.lattice().pack(place[0], place[1], place[2]);
            }
            if (sixVolumes(corners) == 0)
                continue;
            const bool expected = slow.mayBeInverted(points);
            QCOMPARE(curvilinear.allowsInverted(packed), expected);
            QCOMPARE(original->allowsInverted(corners), expected);
            ++(expected ? met : missed);
        }
        QVERIFY(missed > 40 && (met > 40 || grid == "bent cells"));
    }

    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void modelsAreProvedAtEveryLevel_data()
    {
        QTest::addColumn<QString>("grid");
        QTest::addColumn<QString>("builder");
        for (const char* grid :
             {"inside", "one cell", "on the boundary", "at a face of blocks", "two neighbours", "two places", "a plane",
              "left-handed", "turned back", "bent cells", "random 1", "random 2", "random 3", "random 6"})
            for (const char* builder : {"whole", "blocks", "paper", "decimation", "decimation in rounds"})
                QTest::addRow("%s, %s", grid, builder) << QString(grid) << QString(builder);
    }
    void modelsAreProvedAtEveryLevel()
    {
        QFETCH(QString, grid);
        QFETCH(QString, builder);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const SlowGrid slow(bent);
        QCOMPARE(slow.foldedCells() == 0, grid == "bent cells");
        const Dataset dataset = datasetOfGrid(bent);
        const std::uint64_t inverted = build(dataset, builder.toStdString(), bent);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        const auto verdict = verify(**model, dataset, allLevels);
        QVERIFY(verdict.ok() && verdict->failures.empty());
        QCOMPARE(verdict->foldedCells, slow.foldedCells());
        for (const LevelReport& level : verdict->levels) {
            QVERIFY2(level.ok(), qPrintable(failuresOf(level)));
            std::uint64_t found = 0;
            forEachTetrahedron(**model, level.sites, [&](const std::array<std::uint32_t, 4>& points) {
                if (!slow.isInverted(points))
                    return;
                ++found;
                QVERIFY(slow.mayBeInverted(points));
            });
            QCOMPARE(level.inverted, found);
            QCOMPARE(level.invertedInData, found);
        }
        QCOMPARE(verdict->levels.back().inverted, inverted);
        std::vector<std::uint32_t> sites;
        for (const LevelReport& level : verdict->levels)
            sites.push_back(level.sites);
        const auto counted = countInverted(**model, sites);
        QVERIFY(counted.ok());
        for (std::size_t level = 0; level < sites.size(); ++level)
            QCOMPARE((*counted)[level], verdict->levels[level].inverted);
        if (grid != "one cell" && !(grid == "bent cells" && builder.startsWith("decimation")))
            QVERIFY(inverted > 0);
        // Keys mean something: what is folded in a few places needs no more than that for a coarse mesh.
        if (grid.contains("inside") || grid == "one cell" || grid == "two places" || grid == "on the boundary")
            QVERIFY2(verdict->levels.front().sites < bent.values.size() * 3 / 4,
                     qPrintable(QString::number(verdict->levels.front().sites)));
    }

    /// Meshes of a focus, by insertion and as closed sets, near values, of a budget, and of bounds on one of the two.
    void otherMeshesAreProved_data()
    {
        QTest::addColumn<QString>("grid");
        QTest::addColumn<QString>("builder");
        for (const char* grid : {"inside", "at a face of blocks", "a plane", "left-handed", "bent cells", "random 3"})
            for (const char* builder : {"whole", "blocks", "paper", "decimation"})
                QTest::addRow("%s, %s", grid, builder) << QString(grid) << QString(builder);
    }
    void otherMeshesAreProved()
    {
        QFETCH(QString, grid);
        QFETCH(QString, builder);
        const BentGrid bent = foldedGridNamed(grid.toStdString());
        const SlowGrid slow(bent);
        const Dataset dataset = datasetOfGrid(bent);
        build(dataset, builder.toStdString(), bent);
        const auto opened = Model::open(path());
        QVERIFY(opened.ok());
        const std::shared_ptr<const Model>& model = *opened;
        const Eigen::AlignedBox3d bounds = dataset.bounds();
        const double length = bounds.diagonal().norm();
        const double middle = dataset.values.range().minimum + dataset.values.range().extent() / 2;
        const SpaceRamp sharp{Sphere{bent.positions[bent.positions.size() / 2], length / 5}, 0.5, 10, 0};
        const SpaceRamp graded{Sphere{bent.positions[bent.positions.size() / 2], length / 6}, 0.5, 20, length / 4};
        const ErrorField nearMiddle =
            ErrorField::nearValues(std::array{middle}, 1, 30, dataset.values.range().extent() / 9);
        std::vector<MeshQuery> queries;
        for (const ErrorField& field : {ErrorField(sharp), ErrorField(graded), nearMiddle, ErrorField(3.0)})
            for (const double warping : {3.0, 100.0}) {
                MeshQuery query;
                query.error = field;
                query.warping = warping;
                queries.push_back(query);
                query.budget = model->tetrahedronCount() / 4;
                queries.push_back(query);
            }
        MeshExtractor extractor(model);
        std::size_t answered = 0;
        for (MeshQuery& query : queries)
            for (const VariableMethod method :
                 {VariableMethod::Automatic, VariableMethod::ClosedSet, VariableMethod::Insertion}) {
                query.method = method;
                const auto mesh = extractor.extract(query);
                if (!mesh) {
                    QVERIFY2(method == VariableMethod::Insertion && mesh.error().kind == ErrorKind::WrongUsage,
                             mesh.error().text().c_str());
                    continue;
                }
                ++answered;
                const auto level = verifyMesh(*model, dataset, query, **mesh);
                QVERIFY(level.ok());
                QVERIFY2(level->ok(), qPrintable(failuresOf(*level)));
                QCOMPARE(level->inverted, level->invertedInData);
            }
        QVERIFY(answered >= 2 * queries.size());
    }

    /// A model that claims of its first meshes to be consistent: what is inverted there away from the folded cells is a
    /// failure, what meets them is none.
    void invertedElsewhereIsAFailure()
    {
        const BentGrid bent = foldedGridNamed("wrapped");
        const SlowGrid slow(bent);
        QVERIFY(slow.foldedCells() > 0 && slow.foldedCells() < 10);
        const Dataset dataset = datasetOfGrid(bent);
        build(dataset, "whole", bent);
        QVERIFY(verdictOf(dataset, allLevels).ok());
        build(dataset, "lie", bent);
        const auto model = Model::open(path());
        QVERIFY(model.ok());
        std::vector<Accuracy> levels;
        for (std::uint32_t site = 8; site < (*model)->siteCount(); ++site) {
            const double percent = 100 * double((*model)->runningKeys()[site]) / bent.valueExtent();
            if (percent < (levels.empty() ? 100 : levels.back().error))
                levels.push_back({percent, 100});
        }
        const VerificationReport verdict = verdictOf(dataset, levels);
        QVERIFY(verdict.failures.empty());
        int rejected = 0, mixed = 0;
        for (const LevelReport& level : verdict.levels) {
            std::uint64_t inverted = 0, borne = 0;
            forEachTetrahedron(**model, level.sites, [&](const std::array<std::uint32_t, 4>& points) {
                inverted += slow.isInverted(points) ? 1 : 0;
                borne += slow.isInverted(points) && slow.mayBeInverted(points) ? 1 : 0;
            });
            QCOMPARE(level.inverted, inverted);
            QCOMPARE(level.invertedInData, borne);
            QCOMPARE(failuresOf(level).contains("is inverted in physical space"), inverted > borne);
            rejected += inverted > borne ? 1 : 0;
            mixed += inverted > borne && borne > 0 ? 1 : 0;
        }
        QVERIFY(rejected > 2 && mixed > 0);
        QVERIFY(verdict.levels.back().ok());
    }

    /// Nor is a model believed that says of itself that the grid has the other hand.
    void aWrongHandIsAFailure()
    {
        for (const char* name : {"inside", "left-handed"}) {
            const BentGrid bent = foldedGridNamed(name);
            const Dataset dataset = datasetOfGrid(bent);
            build(dataset, "whole", bent);
            FileParts file(readBytes(path()));
            file.header().leftHanded = 1 - file.header().leftHanded;
            file.repairChecksums();
            writeBytes(path(), file.content);
            const VerificationReport verdict = verdictOf(dataset, allLevels);
            QCOMPARE(verdict.failures.size(), std::size_t(1));
            QVERIFY2(QString::fromStdString(verdict.failures[0]).contains("-handed"), verdict.failures[0].c_str());
        }
    }

    void damagedFilesAreNotCounted()
    {
        const BentGrid bent = foldedGridNamed("inside");
        build(datasetOfGrid(bent), "whole", bent);
        const std::vector<std::byte> sound = readBytes(path());
        for (const int kind : {0, 1, 2}) {
            FileParts file(sound);
            const auto offsets = file.elements<std::uint64_t>(format::SectionId::StarOffsets);
            if (kind == 0)
                std::swap(offsets[20], offsets[40]);
            else if (kind == 1)
                offsets[30] = ~std::uint64_t(0);
            else
                std::ranges::fill(file.elements<std::array<std::uint32_t, 3>>(format::SectionId::OtherSites),
                                  std::array<std::uint32_t, 3>{~0U, ~0U, ~0U}); // followed by nobody
            file.repairChecksums();
            writeBytes(path(), file.content);
            const auto model = Model::open(path());
            QVERIFY(model.ok());
            const auto counted = countInverted(**model, std::array{(*model)->siteCount()});
            QCOMPARE(counted.ok(), kind == 2);
            if (kind == 2)
                QCOMPARE(counted->front(), std::uint64_t(0));
        }
    }

private:
    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }

    std::uint64_t build(const Dataset& dataset, const std::string& builder, const BentGrid& grid) const
    {
        if (builder == "blocks") {
            const auto report = buildModel(dataset, path(), Refinement{.block = 3});
            if (!report)
                qFatal("%s", report.error().text().c_str());
            return report->inverted;
        }
        ModelDescription description;
        description.builder = builder;
        const auto writer = ModelWriter::create(path(), dataset, description);
        if (!writer)
            qFatal("%s", writer.error().text().c_str());
        LyingSink liar(**writer, grid.valueExtent());
        const auto inverted = buildFolded(builder, grid, builder == "lie" ? static_cast<HistorySink&>(liar) : **writer);
        if (!inverted)
            qFatal("%s", inverted.error().text().c_str());
        return *inverted;
    }

    VerificationReport verdictOf(const Dataset& dataset, const std::vector<Accuracy>& levels) const
    {
        const auto model = Model::open(path());
        const auto verdict = model ? verify(**model, dataset, levels) : Result<VerificationReport>(model.error());
        if (!verdict)
            qFatal("%s", verdict.error().text().c_str());
        return *verdict;
    }

    /// By its definition: created by one of the first sites, destroyed by none; the numbers of the dataset's points.
    template <class Visit> static void forEachTetrahedron(const Model& model, std::uint32_t sites, const Visit& visit)
    {
        for (std::uint32_t creator = 0; creator < sites; ++creator)
            for (std::uint64_t t = model.starOffsets()[creator]; t < model.starOffsets()[creator + 1]; ++t)
                if (model.destroyers()[t] >= sites) {
                    const auto& [a, b, c] = model.otherSites()[t];
                    visit({model.points()[creator], model.points()[a], model.points()[b], model.points()[c]});
                }
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(FoldedGridsTest)
#include "folded_grids_test.moc"
