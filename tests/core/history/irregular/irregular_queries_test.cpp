// SPDX-License-Identifier: GPL-3.0-or-later
// Random queries to models of irregular data and to decimated ones of any kind: the mesh is the one that going through
// the whole history gives, and the independent judge proves it (B1, B3, R14, R25).
#include "core/decimate/boundary_surface.h"
#include "core/decimate/lattice_tetrahedra.h"
#include "core/history/query/boundary_repair.h"
#include "core/history/query/closed_set.h"
#include "core/history/query/curvilinear_focus.h"
#include "core/history/query/region_refiner.h"
#include "core/history/site_positions.h"
#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "tests/core/history/irregular/irregular_models.h"
#include "tests/core/history/query/random_queries.h"
#include "tests/verdict_text.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <numbers>

using namespace tetra;

using testing::textOf;

namespace {

struct Case {
    Dataset dataset;
    std::shared_ptr<const Model> model;
};

/// The mesh of the smallest closed set for a query without a budget, whether or not its boundary meets itself.
ExtractedMesh smallestMesh(const Model& model, const MeshQuery& query)
{
    SitePlaces places;
    HistoryLinks links;
    ExtractedMesh mesh;
    bool good = placeSites(model, model.siteCount(), places.positions) &&
                copyValues(model, model.siteCount(), places.values) && links.cover(model, model.siteCount(), {});
    const RefinementCriterion criterion(model, query, places);
    const auto set = smallestClosedSet(model, links, criterion, meshSizeAt(model, criterion.coarsest()).sites, {});
    good = good && set && extractSet(model, *set, places, {}, mesh);
    return good ? mesh : ExtractedMesh();
}

/// A box of which two layers of cells are left out, but for a gap, and that is bent along it.
Dataset withGap(double bend, double gap, std::uint32_t seed = 3)
{
    constexpr std::array<std::uint32_t, 3> size{9, 5, 8};
    constexpr std::uint32_t below = size[2] / 2 - 1; // the layer of cells where the gap begins
    std::mt19937 random(seed);
    std::vector<Eigen::Vector3d> positions;
    std::vector<double> values;
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const double height = z > below + 1 ? z - 2 + gap : z;
                const double wave = std::sin(2 * std::numbers::pi * x / (size[0] - 1)) * std::cos(0.9 * y);
                positions.emplace_back(x + between(random, -0.01, 0.01), y + between(random, -0.01, 0.01),
                                       height + bend * wave + between(random, -0.002, 0.002));
                values.push_back(std::sin(0.9 * x) + std::cos(0.7 * y) + 0.3 * z + between(random, -0.1, 0.1));
            }
    const auto all = latticeTetrahedra(size, LatticeCut::Five);
    std::vector<std::array<std::uint32_t, 4>> kept;
    constexpr std::size_t ofLayer = 5 * (size[0] - 1) * (size[1] - 1);
    for (std::size_t t = 0; t < all.size(); ++t)
        if (t / ofLayer != below && t / ofLayer != below + 1)
            kept.push_back(all[t]);
    return withoutUnused(datasetOfTetrahedra(std::move(positions), values, std::move(kept)));
}

bool isSound(const Model& model, const ExtractedMesh& mesh)
{
    const auto repair = testBoundary(model, mesh, model.siteCount(), {});
    return repair && repair->isSound;
}

} // namespace

class IrregularQueriesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        for (std::uint32_t seed = 100; seed < 145; ++seed) {
            const Dataset dataset = randomIrregular(seed);
            add(dataset, decimated(dataset));
        }
        for (const SampleType type : {SampleType::UInt8, SampleType::Int16, SampleType::Float32}) {
            const Dataset lattice = bumps(type, {6, 5, 4});
            add(lattice, decimatedGrid(lattice));
            const Dataset bent = bentBumps(type, {5, 4, 5}, type == SampleType::Float32, type == SampleType::Int16);
            add(bent, decimatedGrid(bent));
        }
        QVERIFY(!cases_.empty());
    }

    void levelsAreProved()
    {
        for (const Case& one : cases_) {
            const auto verdict = verify(*one.model, one.dataset, {{30, 30}, {10, 10}, {2, 2}, {0, 0}});
            QVERIFY(verdict.ok());
            for (const std::string& failure : verdict->failures)
                qWarning("%s", failure.c_str());
            for (const LevelReport& level : verdict->levels)
                for (const std::string& failure : level.failures)
                    qWarning("%s", failure.c_str());
            QVERIFY(verdict->ok());
        }
    }

    void fieldsGiveTheSmallestClosedSet()
    {
        std::mt19937 random(1);
        for (const Case& one : cases_)
            QVERIFY(areFieldsKept(random, one.model, one.dataset));
    }

    void budgetsGiveTheFinestThatFits()
    {
        std::mt19937 random(2);
        for (const Case& one : cases_)
            QVERIFY(isBudgetKept(random, one.model, one.dataset));
    }

    void uniformMeshesMove()
    {
        std::mt19937 random(3);
        for (const Case& one : cases_) {
            MeshExtractor extractor(one.model);
            for (int round = 0; round < 6; ++round) {
                MeshQuery query;
                const double percent = between(random, 0, 60);
                query.error = percent;
                query.warping = percent;
                const auto mesh = extractor.extract(query);
                QVERIFY(mesh.ok());
                QCOMPARE((*mesh)->wholeSites, meshSizeAt(*one.model, {percent, percent}).sites);
                const auto expected = extractPrefix(*one.model, (*mesh)->wholeSites);
                QVERIFY(expected.ok());
                QVERIFY(byPoints((*mesh)->mesh.tetrahedra, one.model->points()) ==
                        byPoints(expected->tetrahedra, one.model->points()));
                QVERIFY(isProved(*one.model, one.dataset, query, **mesh));
            }
        }
    }

    /// C1: error and warping apart, of the prefix and of the mesh that is smaller; both are measured.
    void pairsAreKept()
    {
        std::mt19937 random(7);
        int pairs = 0, smaller = 0;
        for (const Case& one : cases_) {
            if (!(one.model->description().warpingWeight > 0))
                continue;
            MeshExtractor extractor(one.model);
            std::vector<Accuracy> asked;
            for (int round = 0; round < 6; ++round) {
                asked.push_back({round % 3 == 0 ? anyError : between(random, 0, 40),
                                 round % 3 == 1 ? anyWarping : between(random, 0, 40)});
                MeshQuery query;
                query.error = asked.back().error;
                query.warping = asked.back().warping;
                const auto mesh = extractor.extract(query);
                QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
                QVERIFY(isProved(*one.model, one.dataset, query, **mesh));
                const std::uint32_t prefix = meshSizeAt(*one.model, asked.back()).sites;
                QVERIFY((*mesh)->wholeSites <= prefix);
                ++pairs;
                smaller += (*mesh)->wholeSites < prefix ? 1 : 0;
            }
            const auto verdict = verify(*one.model, one.dataset, asked);
            QVERIFY(verdict.ok() && verdict->ok());
            for (std::size_t i = 0; i < asked.size(); ++i) {
                QCOMPARE(verdict->levels[i].sites, meshSizeAt(*one.model, asked[i]).sites);
                QVERIFY(verdict->levels[i].measured.error.largest <= asked[i].error + 1e-9 ||
                        asked[i].error >= anyError);
                QVERIFY(verdict->levels[i].measured.warping.largest <= asked[i].warping + 1e-9);
            }
        }
        QVERIFY2(pairs > 200 && smaller > pairs / 4, qPrintable(QString("%1 of %2").arg(smaller).arg(pairs)));
    }

    /// Where the boundary of the smallest closed set meets itself, and the judge says so, the answer has more sites and
    /// is proved; with a budget, it is within that (C3). Two parts with a narrow gap between them, which bends: a
    /// coarse side of it would cut into a fine one.
    void boundariesNeverMeetThemselves_data()
    {
        QTest::addColumn<double>("bend");
        QTest::addColumn<double>("gap");
        QTest::newRow("narrow") << 0.8 << 0.2;
        QTest::newRow("wider") << 1.0 << 0.3;
        QTest::newRow("narrowest") << 1.2 << 0.1;
    }
    void boundariesNeverMeetThemselves()
    {
        QFETCH(double, bend);
        QFETCH(double, gap);
        const Dataset dataset = withGap(bend, gap);
        const auto model =
            modelOf(folder_.filePath(QTest::currentDataTag()).toStdString(), dataset, decimated(dataset));
        std::mt19937 random(6);
        MeshExtractor extractor(model);
        int repaired = 0;
        for (int round = 0; round < 100; ++round) {
            const Eigen::AlignedBox3d bounds = model->description().bounds;
            MeshQuery query;
            query.error = SpaceRamp{Sphere{placeIn(random, bounds), between(random, 0, 0.15) * model->diagonal()},
                                    between(random, 0, 3), between(random, 20, 90), 0};
            query.warping = query.error;
            const ExtractedMesh smallest = smallestMesh(*model, query);
            const bool sound = isSound(*model, smallest);
            const auto verdict = verifyMesh(*model, dataset, query, smallest);
            QVERIFY(verdict.ok());
            QCOMPARE(sound, verdict->ok());
            const auto mesh = extractor.extract(query);
            QVERIFY(mesh.ok());
            QVERIFY(isSound(*model, **mesh));
            QVERIFY(isProved(*model, dataset, query, **mesh));
            QCOMPARE((*mesh)->wholeSites > smallest.wholeSites, !sound);
            if (sound)
                continue;
            ++repaired;
            for (const std::uint64_t budget : {smallest.wholeTetrahedra, smallest.wholeTetrahedra * 3 / 4}) {
                query.budget = budget;
                const auto within = extractor.extract(query);
                if (!within)
                    QCOMPARE(within.error().kind, ErrorKind::WrongUsage);
                else
                    QVERIFY((*within)->wholeTetrahedra <= budget && isProved(*model, dataset, query, **within));
            }
        }
        QVERIFY2(repaired >= 5, qPrintable(QString::number(repaired)));
    }

    /// No mesh is certain between the sites of a batch, whose order is not the builder's: there the test finds what a
    /// look at all pairs finds.
    void setsBetweenBatchesAreTested()
    {
        int between = 0, meeting = 0;
        for (std::uint32_t seed = 3; seed < 11; ++seed) {
            const Dataset dataset = withGap(1.2, 0.1, seed);
            const auto model = modelOf(folder_.filePath("batches").toStdString(), dataset, decimated(dataset));
            std::vector<Eigen::Vector3d> places;
            for (std::uint32_t site = 0; site < model->siteCount(); ++site)
                places.push_back(model->position(site));
            for (std::uint32_t sites = 1; sites < model->siteCount(); ++sites) {
                if (model->groupGoesOn()[sites - 1] != 0 || std::isinf(model->runningKeys()[sites]))
                    continue;
                ExtractedMesh mesh;
                auto prefix = extractPrefix(*model, sites);
                QVERIFY(prefix.ok());
                mesh.mesh = *std::move(prefix);
                for (std::uint32_t site = 0; site < sites; ++site)
                    mesh.sites.push_back(site);
                std::vector<SurfaceTriangle> triangles;
                const FaceAdjacency adjacency = matchFaces(mesh.mesh.tetrahedra);
                for (std::uint32_t side = 0; side < 4 * mesh.mesh.tetrahedra.size(); ++side)
                    if ((adjacency.innerFaces[side / 4] >> side % 4 & 1) == 0)
                        triangles.push_back(sideCorners(std::span<const Tetrahedron>(mesh.mesh.tetrahedra), side));
                const BoundarySurface surface(places, triangles);
                const bool meets = std::ranges::any_of(
                    triangles, [&](const SurfaceTriangle& triangle) { return surface.isTouched(triangle); });
                QCOMPARE(isSound(*model, mesh), !meets);
                const bool inBatch = model->runningKeys()[sites] == model->runningKeys()[sites - 1];
                QVERIFY(inBatch || !meets);
                between += inBatch ? 1 : 0;
                meeting += meets ? 1 : 0;
            }
        }
        QVERIFY2(between > 100 && meeting > 0, qPrintable(QString("%1, %2").arg(between).arg(meeting)));
    }

    /// R4, R5: a point that was removed from one side of a gap counts for what comes to lie over it from the other
    /// side, in every mesh.
    void claimsHoldAcrossGaps()
    {
        std::vector<Accuracy> levels;
        for (double percent = 40; percent > 0.5; percent *= 0.8)
            levels.push_back({percent, percent});
        for (const double gap : {0.1, 0.2, 0.5}) {
            const Dataset dataset = withGap(1.2, gap);
            const auto model = modelOf(folder_.filePath("gap").toStdString(), dataset, decimated(dataset));
            const auto verdict = verify(*model, dataset, levels);
            QVERIFY2(verdict.ok() && verdict->ok(), qPrintable(textOf(verdict)));
        }
    }

    /// Nothing is inserted into a mesh that is not Delaunay, however sharp the focus is.
    void sharpFociAreClosedSets()
    {
        std::mt19937 random(4);
        for (const Case& one : cases_) {
            QVERIFY(!one.model->description().delaunay);
            QVERIFY(!RegionRefiner::fits(*one.model) && !CurvilinearFocus::fits(*one.model));
            MeshExtractor extractor(one.model);
            MeshQuery query;
            query.error = randomRamp(random, *one.model);
            query.warping = query.error;
            const auto mesh = extractor.extract(query);
            QVERIFY(mesh.ok());
            QCOMPARE((*mesh)->method, VariableMethod::ClosedSet);
            QVERIFY(isProved(*one.model, one.dataset, query, **mesh));
            query.method = VariableMethod::Insertion;
            const auto refused = extractor.extract(query);
            QVERIFY(!refused.ok());
            QCOMPARE(refused.error().kind, ErrorKind::WrongUsage);
        }
    }

    void windowsOfAllBorders()
    {
        std::mt19937 random(5);
        for (const Case& one : cases_) {
            MeshExtractor extractor(one.model);
            const Eigen::AlignedBox3d bounds = one.model->description().bounds;
            MeshQuery query;
            query.error = between(random, 0, 30);
            query.warping = query.error;
            const Eigen::Vector3d a = placeIn(random, bounds), b = placeIn(random, bounds);
            std::size_t sizes[3] = {};
            for (const WindowBorder border :
                 {WindowBorder::Contained, WindowBorder::Intersecting, WindowBorder::Clipped}) {
                query.window = Window{Box{a.cwiseMin(b), a.cwiseMax(b)}, border};
                const auto part = extractor.extract(query);
                QVERIFY(part.ok());
                sizes[static_cast<std::size_t>(border)] = (*part)->mesh.tetrahedra.size();
                if (border != WindowBorder::Clipped)
                    continue;
                for (const Eigen::Vector3d& place : (*part)->mesh.positions)
                    QVERIFY(Eigen::AlignedBox3d(query.window->box.least, query.window->box.largest)
                                .squaredExteriorDistance(place.cast<double>()) < 1e-9);
            }
            QVERIFY(sizes[static_cast<std::size_t>(WindowBorder::Contained)] <=
                    sizes[static_cast<std::size_t>(WindowBorder::Intersecting)]);
        }
    }

private:
    void add(const Dataset& dataset, const RecordedSteps& history)
    {
        const auto path = folder_.filePath(QString::number(cases_.size())).toStdString();
        cases_.push_back({dataset, modelOf(path, dataset, history)});
    }

    QTemporaryDir folder_;
    std::vector<Case> cases_;
};

QTEST_GUILESS_MAIN(IrregularQueriesTest)
#include "irregular_queries_test.moc"
