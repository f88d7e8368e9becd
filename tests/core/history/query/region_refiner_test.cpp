// SPDX-License-Identifier: GPL-3.0-or-later
// S1, R25: meshes with a sharp focus conform, cover, keep their error at every sample, and are what inserting the same
// points into the coarse mesh gives however slowly.
#include "core/history/query/region_refiner.h"

#include "core/history/model_writer.h"
#include "core/refine/lattice/lattice_refinement.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/lattice_models.h"
#include "tests/core/history/query/slow_focus.h"

#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace tetra;

namespace {

std::vector<Tetrahedron> byPoints(const Model& model, const ExtractedMesh& mesh)
{
    const Lattice& lattice = model.description().lattice;
    std::vector<std::uint32_t> points;
    for (const Eigen::Vector3d& position : mesh.mesh.positions) {
        const Eigen::Vector3d place = (position.cast<double>() - lattice.origin).cwiseQuotient(lattice.spacing);
        points.push_back(static_cast<std::uint32_t>(lattice.index(std::uint32_t(std::lround(place[0])),
                                                                  std::uint32_t(std::lround(place[1])),
                                                                  std::uint32_t(std::lround(place[2])))));
    }
    std::vector<Tetrahedron> tetrahedra;
    for (const auto& t : mesh.mesh.tetrahedra)
        tetrahedra.push_back({points[t[0]], points[t[1]], points[t[2]], points[t[3]]});
    return tetrahedra;
}

std::vector<Tetrahedron> sorted(std::vector<Tetrahedron> tetrahedra)
{
    for (Tetrahedron& t : tetrahedra)
        std::ranges::sort(t);
    std::ranges::sort(tetrahedra);
    return tetrahedra;
}

bool same(const ExtractedMesh& one, const ExtractedMesh& other)
{
    return one.mesh.tetrahedra == other.mesh.tetrahedra && one.mesh.positions == other.mesh.positions &&
           one.mesh.values == other.mesh.values && one.sites == other.sites;
}

/// A random lattice's model, whole or in blocks, and a ramp in it.
struct Case {
    Dataset dataset;
    std::shared_ptr<const Model> model;
    SpaceRamp ramp;
    std::uint32_t blockCells = 0;
};

class Cases {
public:
    explicit Cases(std::uint32_t seed) : random_(seed), seed_(seed) {}

    Case next(const std::filesystem::path& folder)
    {
        Case one;
        const auto kind = static_cast<LatticeKind>(seed_ % 4);
        std::array<std::uint32_t, 3> size{};
        for (std::uint32_t& along : size)
            along = 5 + random_() % 8;
        one.blockCells = std::array{0, 4, 5, 7}[seed_ / 4 % 4];
        one.dataset = randomLattice(kind, size, seed_);
        one.model = modelOf(one.dataset, one.blockCells, folder);
        one.ramp = ramp(one.dataset.lattice);
        return one;
    }

    SpaceRamp ramp(const Lattice& lattice)
    {
        const Eigen::AlignedBox3d bounds = lattice.bounds();
        const Eigen::Vector3d centre =
            bounds.min() + bounds.sizes().cwiseProduct(Eigen::Vector3d(part(), part(), part()));
        const double radius = (0.1 + 0.3 * part()) * bounds.sizes().maxCoeff();
        SpaceRamp ramp;
        ramp.inner = std::array{0.0, 0.5, 2.0, 5.0}[random_() % 4];
        ramp.outer = std::array{8.0, 15.0, 30.0, 60.0}[random_() % 4];
        const auto shape = random_() % 8;
        if (shape == 0)
            ramp.region = Sphere{centre, radius};
        else if (shape == 1)
            ramp.region = HalfSpace{Eigen::Vector3d(part(), part(), 0.1 + part()).normalized(), centre[2]};
        else
            ramp.region = Box{centre.array() - radius, centre.array() + radius};
        if (random_() % 5 == 0)
            ramp.falloff = radius;
        return ramp;
    }

private:
    double part() { return static_cast<double>(random_() % 1000) / 1000; }

    std::mt19937 random_;
    std::uint32_t seed_;
};

} // namespace

class RegionRefinerTest : public QObject {
    Q_OBJECT

private slots:
    void isWhatInsertingGives_data() { seeds(64); }
    void isWhatInsertingGives()
    {
        QFETCH(quint32, seed);
        const Case one = Cases(seed).next(folder());
        QVERIFY(RegionRefiner::fits(*one.model));
        RegionRefiner focus(*one.model);
        const std::uint64_t inside = focus.sitesInside(one.ramp);
        const auto mesh = focus.extract(one.ramp, true);
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        SlowFocus slow(*one.model, *focusDivision(*one.model));
        const bool real = one.dataset.values.type() == SampleType::Float32;
        const std::vector<Tetrahedron> tetrahedra = byPoints(*one.model, *mesh);
        QCOMPARE(slow.faultOf(tetrahedra, one.ramp, real ? 1e-12 : 0), std::string());
        QVERIFY(mesh->wholeSites >= meshSizeAt(*one.model, {one.ramp.outer}).sites + inside);
        QCOMPARE(std::size_t(mesh->wholeSites), mesh->sites.size());
        checkSites(*one.model, one.dataset, *mesh);
        if (!real)
            QVERIFY(sorted(tetrahedra) == sorted(slow.meshOf(one.ramp)));
    }

    void movesKeepEverything_data() { seeds(32); }
    void movesKeepEverything()
    {
        QFETCH(quint32, seed);
        Case one = Cases(seed + 1000).next(folder());
        RegionRefiner focus(*one.model);
        const SlowFocus slow(*one.model, *focusDivision(*one.model));
        const bool real = one.dataset.values.type() == SampleType::Float32;
        ExtractedMesh last;
        for (int step = 0; step < 6; ++step) {
            if (Box* const box = std::get_if<Box>(&one.ramp.region)) {
                box->least.array() += 0.25;
                box->largest.array() += 0.25;
            } else if (Sphere* const sphere = std::get_if<Sphere>(&one.ramp.region)) {
                sphere->centre.array() -= 0.2;
            }
            auto mesh = focus.extract(one.ramp, false, {}, std::move(last));
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE(slow.faultOf(byPoints(*one.model, *mesh), one.ramp, real ? 1e-12 : 0), std::string());
            checkSites(*one.model, one.dataset, *mesh);
            last = *std::move(mesh);
        }
        // What came before does not show if it must not.
        const auto fresh = focus.extract(one.ramp, true);
        const auto first = RegionRefiner(*one.model).extract(one.ramp, true);
        QVERIFY(same(*fresh, *first));
        // Nor does another error outside, for which another mesh is loaded.
        SpaceRamp other = one.ramp;
        other.outer *= 1.7;
        QVERIFY(focus.extract(other, false).ok());
        QVERIFY(same(*focus.extract(one.ramp, true), *first));
    }

    /// A model that ends before the ramp: what it lacks is inserted, too.
    void aModelThatEndsEarlyIsGoneBeyond()
    {
        const Dataset dataset = randomLattice(LatticeKind::Smooth, {9, 8, 10}, 5);
        const std::shared_ptr<const Model> whole = modelOf(dataset, 0, folder());
        const auto path = folder() / "short.tan";
        LatticeRefinementOptions options;
        options.size = dataset.lattice.size;
        options.spacing = dataset.lattice.spacing;
        options.stopError = 0.02 * dataset.values.range().extent();
        const auto writer = ModelWriter::create(path, dataset, {});
        QVERIFY(refineLattice(options, LatticeSamples(dataset.values.as<std::uint8_t>()), **writer).ok());
        const auto model = Model::open(path).value();
        QVERIFY(RegionRefiner::fits(*model));
        const SlowFocus slow(*model, *focusDivision(*model));
        for (const double outer : {20.0, 1.0}) {
            const SpaceRamp ramp{Sphere{dataset.lattice.bounds().center(), 1.2}, 0.5, outer, 0};
            const auto mesh = RegionRefiner(*model).extract(ramp, true);
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE(slow.faultOf(byPoints(*model, *mesh), ramp, 0), std::string());
        }
    }

    /// Rounding makes errors of vertices, which must not be inserted again.
    void roundedErrorsAreBorne()
    {
        const Dataset dataset = randomLattice(LatticeKind::Wide, {12, 11, 13}, 4);
        const auto model = modelOf(dataset, 0, folder());
        const Eigen::Vector3d centre = dataset.lattice.bounds().center();
        for (const Region& region : {Region(Sphere{centre, 1.5}), Region(Box{centre.array() - 1, centre.array() + 1}),
                                     Region(HalfSpace{{0, 0, 1}, centre.z()})})
            for (const double falloff : {0.0, 1.0}) {
                const SpaceRamp ramp{region, 0, 10, falloff};
                const auto mesh = RegionRefiner(*model).extract(ramp, true);
                QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
                const SlowFocus slow(*model, *focusDivision(*model));
                QCOMPARE(slow.faultOf(byPoints(*model, *mesh), ramp, 1e-12), std::string());
            }
    }

    void canBeCancelled()
    {
        const Case one = Cases(1).next(folder());
        RegionRefiner focus(*one.model);
        std::stop_source stop;
        stop.request_stop();
        const SpaceRamp ramp{Sphere{one.dataset.lattice.bounds().center(), 2}, 0, 30, 0};
        const auto cancelled = focus.extract(ramp, false, Progress(stop.get_token(), {}));
        QVERIFY(!cancelled.ok());
        QCOMPARE(cancelled.error().kind, ErrorKind::Cancelled);
        QVERIFY(same(*focus.extract(ramp, false), *RegionRefiner(*one.model).extract(ramp, true)));
    }

    void aRampTheWrongWayRoundIsRefused()
    {
        const Case one = Cases(1).next(folder());
        const auto mesh = RegionRefiner(*one.model).extract({Sphere{}, 5, 2, 0}, true);
        QVERIFY(!mesh.ok());
        QCOMPARE(mesh.error().kind, ErrorKind::WrongUsage);
    }

    /// R25: numbers of a damaged file give errors or other meshes, never a crash.
    void damageIsHarmless_data() { seeds(60); }
    void damageIsHarmless()
    {
        QFETCH(quint32, seed);
        std::mt19937 random(seed);
        const Dataset dataset = randomLattice(LatticeKind::Smooth, {9, 8, 9}, 3);
        const auto model = modelOf(dataset, seed % 2 == 0 ? 0 : 4, folder());
        FileParts parts(readBytes(model->path()));
        using format::SectionId;
        const auto sections = {SectionId::SitePoints, SectionId::StarOffsets, SectionId::SiteRunningKeys,
                               SectionId::MeshSizes,  SectionId::OtherSites,  SectionId::Destroyers,
                               SectionId::OwnErrors,  SectionId::SiteGroups};
        const SectionId id = *(sections.begin() + seed % sections.size());
        const auto bytes = parts.elements<std::uint8_t>(id);
        for (int i = 0; i < 1 + int(seed % 3); ++i)
            bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
        parts.repairChecksums();
        const auto path = folder() / "damaged.tan";
        writeBytes(path, parts.content);
        const auto damaged = Model::open(path);
        if (!damaged.ok() || !RegionRefiner::fits(**damaged))
            return;
        RegionRefiner focus(**damaged);
        Cases cases(seed);
        for (int i = 0; i < 5; ++i) {
            const SpaceRamp ramp = cases.ramp(dataset.lattice);
            (void)focus.sitesInside(ramp);
            const auto mesh = focus.extract(ramp, i % 2 == 0);
            if (!mesh.ok()) {
                QVERIFY(!mesh.error().text().empty());
                continue;
            }
            for (const auto& t : mesh->mesh.tetrahedra)
                QVERIFY(*std::ranges::max_element(t) < mesh->mesh.positions.size());
        }
    }

    void whatDoesNotFitIsSaid()
    {
        const Dataset dataset = randomLattice(LatticeKind::Smooth, {5, 6, 7}, 1);
        FileParts parts(readBytes(modelOf(dataset, 0, folder())->path()));
        parts.section(format::SectionId::Samples).id = 999;
        parts.repairChecksums();
        writeBytes(folder() / "without.tan", parts.content);
        QVERIFY(!RegionRefiner::fits(*Model::open(folder() / "without.tan").value()));
        writeModel(folder() / "bent.tan", bentBumps(SampleType::UInt8, {4, 5, 4}));
        QVERIFY(!RegionRefiner::fits(*Model::open(folder() / "bent.tan").value()));
    }

private:
    static void seeds(quint32 count)
    {
        QTest::addColumn<quint32>("seed");
        for (quint32 seed = 0; seed < count; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }

    /// Vertices are where their sites lie and have the samples that lie there; what is said to be no site is none.
    static void checkSites(const Model& model, const Dataset& dataset, const ExtractedMesh& mesh)
    {
        const Lattice& lattice = dataset.lattice;
        for (std::size_t vertex = 0; vertex < mesh.sites.size(); ++vertex) {
            const Eigen::Vector3d place =
                (mesh.mesh.positions[vertex].cast<double>() - lattice.origin).cwiseQuotient(lattice.spacing);
            const auto point = lattice.index(std::uint32_t(std::lround(place[0])), std::uint32_t(std::lround(place[1])),
                                             std::uint32_t(std::lround(place[2])));
            const auto site = std::ranges::find(model.points(), std::uint32_t(point));
            const std::uint32_t number =
                site == model.points().end() ? ExtractedMesh::noSite : std::uint32_t(site - model.points().begin());
            QCOMPARE(mesh.sites[vertex], number);
            QCOMPARE(mesh.mesh.values[vertex], static_cast<float>(dataset.values.at(point)));
        }
    }

    std::filesystem::path folder() const { return folder_.path().toStdString(); }

    QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(RegionRefinerTest)
#include "region_refiner_test.moc"
