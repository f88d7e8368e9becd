// SPDX-License-Identifier: GPL-3.0-or-later
// Any prefix of the sites gives the mesh that was there (R14, R15, S1, S2, B7), and a damaged file an error.
#include "core/history/walk.h"

#include "core/history/model_writer.h"
#include "core/history/site_positions.h"
#include "tests/core/history/model_fixture.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <limits>

using namespace tetra;
using format::SectionId;

class ExtractionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        writeModel(path(), dataset_);
        model_ = open();
    }

    /// After whole batches it is the mesh that was there; within a group there is none.
    void everyPrefixIsTheMeshThatWasThere()
    {
        const std::vector<std::uint32_t> historyPoints = history().points();
        TetrahedralMesh mesh;
        std::uint32_t refused = 0;
        for (std::uint32_t sites = 0; sites <= model_->siteCount(); ++sites) {
            auto extracted = extractPrefix(*model_, sites, {}, std::move(mesh));
            if (sites > 0 && model_->groupGoesOn()[sites - 1] != 0) {
                QVERIFY(!extracted.ok());
                QCOMPARE(extracted.error().kind, ErrorKind::WrongUsage);
                ++refused;
                continue;
            }
            QVERIFY(extracted.ok());
            mesh = std::move(*extracted);
            QCOMPARE(mesh.positions.size(), std::size_t(sites));
            QCOMPARE(mesh.values.size(), std::size_t(sites));
            if (endsBatch(*model_, sites))
                QVERIFY(byPoints(mesh.tetrahedra, model_->points()) ==
                        byPoints(history().meshOf(sites), historyPoints));
        }
        QVERIFY(refused > 7); // the corners are a group; there are others
        for (std::uint32_t site = 0; site < model_->siteCount(); ++site) {
            const std::uint64_t point = model_->points()[site];
            const auto c = dataset_.lattice.coordinates(point);
            QCOMPARE(mesh.positions[site], dataset_.lattice.position(c[0], c[1], c[2]));
            QCOMPARE(mesh.values[site], static_cast<float>(dataset_.values.at(point)));
        }
    }

    /// One after the other they are the mesh that is made as a whole; where there is none, none is visited.
    void tetrahedraAreVisitedInOrder()
    {
        std::uint32_t refused = 0;
        for (std::uint32_t sites = 0; sites <= model_->siteCount(); ++sites) {
            std::vector<std::array<std::uint32_t, 4>> visited;
            const Status status = forEachTetrahedron(
                *model_, sites, [&](auto some) { visited.insert(visited.end(), some.begin(), some.end()); });
            const auto extracted = extractPrefix(*model_, sites);
            QCOMPARE(status.ok(), extracted.ok());
            if (!status) {
                QCOMPARE(status.error().text(), extracted.error().text());
                QVERIFY(visited.empty());
                ++refused;
                continue;
            }
            QVERIFY(std::ranges::equal(visited, extracted->tetrahedra));
        }
        QVERIFY(refused > 7);
    }

    /// By every instruction set that this machine has the scan finds the same, wherever it begins.
    void theScanFindsWhatIsAlive()
    {
        const std::span<const std::uint64_t> offsets = model_->starOffsets();
        QVERIFY(!simdLevels().empty());
        for (const SimdLevel level : simdLevels())
            for (std::uint32_t first = 0; first < model_->siteCount(); first += 3)
                for (std::uint32_t end = first; end <= model_->siteCount(); end += 5) {
                    const Stars stars{model_->otherSites(), model_->destroyers(), first,
                                      offsets.subspan(first, end - first + 1)};
                    const std::uint32_t sites = (first + end) / 2 + 1;
                    std::vector<std::array<std::uint32_t, 4>> out(offsets[end] - offsets[first] + aliveScanOverrun);
                    std::vector<std::array<std::uint32_t, 4>> expected;
                    forEachAlive(stars, sites, [&](std::uint32_t creator, std::uint64_t t, std::uint32_t) {
                        const auto& [a, b, c] = stars.otherSites[t];
                        expected.push_back({creator, a, b, c});
                    });
                    const AliveScan found = scanAlive(stars, sites, out.data(), level);
                    out.resize(std::size_t(found.end - out.data()));
                    QVERIFY2(out == expected, std::to_string(int(level)).c_str());
                    QVERIFY(found.sitesComeBefore);
                }
    }

    /// One wrong number in any place of a star is seen, and the largest numbers are not taken for negative ones.
    void theScanSeesAWrongSite()
    {
        constexpr std::uint32_t creator = 0x80000005;
        QVERIFY(!simdLevels().empty());
        for (const SimdLevel level : simdLevels())
            for (std::size_t count = 1; count < 10; ++count)
                for (std::size_t wrong = 0; wrong <= 3 * count; ++wrong) {
                    std::vector<std::array<std::uint32_t, 3>> others(count, {1, 0x7fffffff, creator - 1});
                    const std::vector<std::uint32_t> destroyers(count, Model::never);
                    if (wrong < 3 * count)
                        others[wrong / 3][wrong % 3] = wrong % 2 == 0 ? creator : 0xffffffff;
                    const std::array<std::uint64_t, 2> offsets = {0, count};
                    std::vector<std::array<std::uint32_t, 4>> out(count + aliveScanOverrun);
                    const AliveScan found =
                        scanAlive({others, destroyers, creator, offsets}, 0x80000006, out.data(), level);
                    QCOMPARE(found.sitesComeBefore, wrong == 3 * count);
                    QCOMPARE(std::size_t(found.end - out.data()), count);
                }
    }

    void buffersAreUsedAgain()
    {
        auto first = extractPrefix(*model_, model_->siteCount());
        const auto* const place = first->tetrahedra.data();
        const auto second = extractPrefix(*model_, someSites(), {}, std::move(*first));
        QCOMPARE(second->tetrahedra.data(), place);
    }

    /// The first mesh that is good enough, found by going through all of them.
    void aQueryIsTheFirstPassage()
    {
        const double extent = model_->description().range.extent();
        std::vector<double> asked = {100, 50, 10, 5, 2, 1, 0.5, 0.1, 0, 1e9, std::numeric_limits<double>::infinity()};
        for (std::uint32_t site = 8; site < model_->siteCount(); ++site)
            asked.push_back(100 * static_cast<double>(history().steps[site].keyBefore) / extent);
        for (const double error : asked) {
            std::uint32_t sites = 8;
            while (sites < model_->siteCount() && history().steps[sites].keyBefore > error / 100 * extent)
                ++sites;
            const MeshSize size = meshSizeAt(*model_, {error});
            QCOMPARE(size.sites, sites);
            QCOMPARE(size.tetrahedra, std::uint64_t(history().meshOf(sites).size()));
            const float reached = sites < model_->siteCount() ? model_->runningKeys()[sites] : history().finalKey;
            QCOMPARE(size.error, 100 * static_cast<double>(reached) / extent);
        }
        QCOMPARE(meshSizeAt(*model_, {-1}).sites, model_->siteCount());
        QCOMPARE(meshSizeAt(*model_, {std::numeric_limits<double>::quiet_NaN()}).sites, model_->siteCount());
    }

    /// Keys may be up when a build is stopped. Then the last mesh says so, and no query ends at it.
    void aHistoryMayEndWorseThanItWas()
    {
        const std::vector<RecordedSteps::Step>& steps = history().steps;
        std::size_t stop = 0, bestMesh = 0;
        for (std::size_t sites = 9, best = 8; sites < steps.size(); ++sites) {
            if (steps[sites].keyBefore > steps[best].keyBefore) {
                stop = sites;
                bestMesh = best;
            } else if (steps[sites].keyBefore < steps[best].keyBefore)
                best = sites;
        }
        QVERIFY(stop > 8);
        RecordedSteps stopped;
        stopped.traits = history().traits;
        stopped.steps.assign(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(stop));
        stopped.finalKey = steps[stop].keyBefore;
        auto writer = ModelWriter::create(path("stopped.tan"), dataset_, {});
        QVERIFY(writer && replay(stopped, **writer).ok());
        const auto model = open("stopped.tan");
        QVERIFY(model);

        const double extent = model->description().range.extent();
        const auto percent = [&](float key) { return 100 * static_cast<double>(key) / extent; };
        QCOMPARE(meshSizeOf(*model, static_cast<std::uint32_t>(stop)).error, percent(stopped.finalKey));
        const MeshSize finest = meshSizeAt(*model, {0});
        QCOMPARE(std::size_t(finest.sites), bestMesh);
        QCOMPARE(finest.error, percent(steps[bestMesh].keyBefore));
        QCOMPARE(meshSizeAt(*model, {finest.error}).sites, finest.sites);
        MeshQuery query;
        query.error = ErrorField(0.0);
        const auto mesh = MeshExtractor(model).extract(query);
        QVERIFY(mesh);
        QCOMPARE((*mesh)->mesh.positions.size(), bestMesh);
        const auto report = verify(*model, dataset_, std::vector<Accuracy>{{0}});
        QVERIFY(report);
        QCOMPARE(std::size_t(report->levels.front().sites), bestMesh);
    }

    void moreSitesThanThereAreIsAnError()
    {
        const auto extracted = extractPrefix(*model_, model_->siteCount() + 1);
        QVERIFY(!extracted.ok());
        QCOMPARE(extracted.error().kind, ErrorKind::WrongUsage);
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto extracted = extractPrefix(*model_, someSites(), Progress(stop.get_token(), {}));
        QVERIFY(!extracted.ok());
        QCOMPARE(extracted.error().kind, ErrorKind::Cancelled);
    }

    void tellsHowFarItIs()
    {
        double last = -1;
        QVERIFY(extractPrefix(*model_, someSites(), Progress({}, [&last](double fraction, const Message&) {
                    QVERIFY(fraction >= last && fraction <= 1);
                    last = fraction;
                })).ok());
        QVERIFY(last >= 0);
    }

    void aDamagedFileIsAnError_data();
    void aDamagedFileIsAnError();

    void aFileCutWhileMappedIsAnError_data()
    {
        QTest::addColumn<double>("left");
        QTest::newRow("nothing") << 0.0;
        QTest::newRow("a third") << 0.3;
        QTest::newRow("nearly all") << 0.999;
    }
    void aFileCutWhileMappedIsAnError()
    {
        QFETCH(double, left);
        const std::filesystem::path copy = folder_.filePath("cut.tan").toStdString();
        std::filesystem::copy_file(path(), copy, std::filesystem::copy_options::overwrite_existing);
        const auto model = Model::open(copy);
        QVERIFY(model.ok());
        std::filesystem::resize_file(copy, static_cast<std::uintmax_t>(left * double(model.value()->fileSize())));
        const auto extracted = extractPrefix(**model, model.value()->siteCount());
        QVERIFY(!extracted.ok());
        QCOMPARE(extracted.error().kind, ErrorKind::BadInput);
        QVERIFY2(extracted.error().text().find("was cut short or changed while it was open") != std::string::npos,
                 extracted.error().text().c_str());
        QVERIFY(!model.value()->checkUnchanged().ok());
    }

    /// LatticePoints divides by multiplying: compare with division where rounding is most likely to go wrong.
    void placesOfLatticePointsAreExact()
    {
        for (const std::array<std::uint32_t, 3> size :
             {std::array{2u, 2u, 2u}, std::array{3u, 7u, 11u}, std::array{1290u, 1290u, 1290u},
              std::array{2u, 2u, 1u << 30}, std::array{1u << 30, 2u, 2u}, std::array{65535u, 65537u, 1u},
              std::array{641u, 6700416u, 1u}}) {
            const Lattice lattice{size, {1, 1, 1}, {0, 0, 0}};
            const LatticePoints points(lattice);
            std::vector<std::uint64_t> indices = {0, 1, lattice.pointCount() - 1};
            for (std::uint64_t i = 1; i < 2000; ++i) {
                indices.push_back(i * 2654435761u % lattice.pointCount());
                indices.push_back(i * size[0] % lattice.pointCount());
                indices.push_back((i * size[0] + lattice.pointCount() - 1) % lattice.pointCount());
                indices.push_back((i * size[0] * size[1] + lattice.pointCount() - 1) % lattice.pointCount());
            }
            for (const std::uint64_t index : indices) {
                const auto c = lattice.coordinates(index);
                QCOMPARE(points.position(static_cast<std::uint32_t>(index)), Eigen::Vector3d(c[0], c[1], c[2]));
            }
        }
    }

private:
    std::filesystem::path path(const char* name = "model.tan") const { return folder_.filePath(name).toStdString(); }
    std::shared_ptr<const Model> open(const char* name = "model.tan") const
    {
        const auto model = Model::open(path(name));
        return model ? *model : nullptr;
    }
    std::uint32_t someSites() const { return meshSizeAt(*model_, {20}).sites; }
    const RecordedSteps& history() const { return historyOf(dataset_); }

    QTemporaryDir folder_;
    const Dataset dataset_ = bumps(SampleType::Int16, {5, 4, 6});
    std::shared_ptr<const Model> model_;
};

using Damage = void (*)(FileParts&);

void ExtractionTest::aDamagedFileIsAnError_data()
{
    QTest::addColumn<Damage>("damage");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, Damage damage, const char* says) {
        QTest::newRow(name) << damage << QString(says);
    };
    const auto others = [](FileParts& f) { return f.elements<std::array<std::uint32_t, 3>>(SectionId::OtherSites); };
    static const auto elements = others;
    row(
        "site too late", [](FileParts& f) { elements(f).back()[1] = 0xfffffff0; }, "comes after its creator");
    row(
        "own creator", [](FileParts& f) { elements(f).back()[2] = f.header().siteCount - 1; },
        "comes after its creator");
    row(
        "first offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[0] = 1; }, "do not match");
    row(
        "offset beyond", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[30] = ~0ull; },
        "the star offsets of site 29 are invalid");
    row(
        "offset back", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[30] = 0; },
        "the star offsets of site 29 are invalid");
    row(
        "last offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets).back() += 1; },
        "do not match its tetrahedra");
    row(
        "mesh size huge", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::MeshSizes).back() = ~0u; },
        "do not match its mesh sizes");
    row(
        "mesh size too large", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::MeshSizes).back() += 1; },
        "tetrahedra instead of");
    row(
        "mesh size too small", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::MeshSizes).back() = 5; },
        "tetrahedra");
    row(
        "lost", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers).back() = 1; },
        "tetrahedra instead of");
    row(
        "never destroyed", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers)[0] = Model::never; },
        "has more than the");
    row(
        "point", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::SitePoints)[12] = 120; },
        "not a point of its lattice");
}

void ExtractionTest::aDamagedFileIsAnError()
{
    QFETCH(Damage, damage);
    QFETCH(QString, says);
    FileParts parts(readBytes(path()));
    damage(parts);
    parts.repairChecksums();
    writeBytes(path("damaged.tan"), parts.content);
    const auto model = open("damaged.tan");
    QVERIFY(model);
    const auto extracted = extractPrefix(*model, model->siteCount());
    QVERIFY(!extracted.ok());
    QCOMPARE(extracted.error().kind, ErrorKind::BadInput);
    QVERIFY2(QString::fromStdString(extracted.error().text()).contains(says), extracted.error().text().c_str());

    // What is visited is never out of bounds; that a position is none is for whoever asks for it to find.
    const std::uint32_t sites = model->siteCount();
    bool isWithin = true;
    const Status visited = forEachTetrahedron(*model, sites, [&](auto some) {
        for (const auto& tetrahedron : some)
            for (const std::uint32_t site : tetrahedron)
                isWithin = isWithin && site < sites;
    });
    QVERIFY(isWithin);
    const bool isOfPlaces = QByteArray(QTest::currentDataTag()) == "point";
    QCOMPARE(visited.ok(), isOfPlaces);
    if (!isOfPlaces)
        QCOMPARE(visited.error().text(), extracted.error().text());
}

QTEST_GUILESS_MAIN(ExtractionTest)
#include "extraction_test.moc"
