// SPDX-License-Identifier: GPL-3.0-or-later
// All tetrahedra that are alive at some accuracy of a range, and how long they live (R14, S2).
#include "core/history/query/history_part.h"

#include "core/history/query/window.h"
#include "core/mesh/topology.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/some_models.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <random>

using namespace tetra;
using format::SectionId;

namespace {

using Damage = std::function<void(FileParts&)>;

std::vector<Tetrahedron> sorted(std::span<const Tetrahedron> tetrahedra)
{
    std::vector<Tetrahedron> result(tetrahedra.begin(), tetrahedra.end());
    std::ranges::sort(result);
    return result;
}

ExtractedMesh whole(const HistoryPart& part)
{
    ExtractedMesh mesh;
    mesh.mesh = part.mesh;
    mesh.sites.resize(part.mesh.positions.size());
    std::iota(mesh.sites.begin(), mesh.sites.end(), 0);
    return mesh;
}

/// Its tetrahedra by sites, in order.
std::vector<Tetrahedron> bySites(const ExtractedMesh& mesh)
{
    std::vector<Tetrahedron> result(mesh.mesh.tetrahedra.begin(), mesh.mesh.tetrahedra.end());
    for (Tetrahedron& tetrahedron : result)
        for (std::uint32_t& vertex : tetrahedron)
            vertex = mesh.sites[vertex];
    std::ranges::sort(result);
    return result;
}

} // namespace

class HistoryPartTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        models_ = someModels(folder_.path().toStdString());
        QVERIFY(!models_.empty());
    }

    /// Against the meshes of all accuracies, extracted one by one.
    void everyLifeIsWholeAndNothingElseIsThere()
    {
        for (const auto& [name, model] : models_)
            for (const auto& [one, other] : ranges()) {
                const auto part = extractHistory(*model, {one}, {other});
                QVERIFY2(part.ok(), part.ok() ? "" : part.error().text().c_str());
                QCOMPARE(part->coarse.sites, meshSizeAt(*model, {std::max(one, other)}).sites);
                QCOMPARE(part->fine.sites, meshSizeAt(*model, {std::min(one, other)}).sites);
                QCOMPARE(part->births.size(), part->mesh.tetrahedra.size());
                QCOMPARE(part->deaths.size(), part->mesh.tetrahedra.size());
                std::vector<bool> lived(part->mesh.tetrahedra.size());
                for (std::uint32_t sites = part->coarse.sites; sites <= part->fine.sites; ++sites) {
                    if (!endsBatch(*model, sites))
                        continue;
                    std::vector<Tetrahedron> alive;
                    for (std::size_t t = 0; t < lived.size(); ++t)
                        if (part->births[t] <= sites && sites < part->deaths[t]) {
                            alive.push_back(part->mesh.tetrahedra[t]);
                            lived[t] = true;
                        }
                    const auto mesh = extractPrefix(*model, sites);
                    QVERIFY(mesh.ok());
                    QVERIFY2(sorted(alive) == sorted(mesh->tetrahedra), name.c_str());
                }
                QVERIFY2(std::ranges::all_of(lived, std::identity()), name.c_str());
                QVERIFY(std::ranges::is_sorted(part->births));
                const auto mesh = extractPrefix(*model, part->fine.sites);
                QVERIFY(part->mesh.positions == mesh->positions && part->mesh.values == mesh->values);
            }
    }

    /// Births and deaths in the meshes of all numbers of sites, beyond the range too.
    void livesReachBeyondTheRange()
    {
        for (const auto& [name, model] : models_) {
            const auto part = extractHistory(*model, {5}, {4});
            QVERIFY(part.ok());
            std::map<Tetrahedron, std::vector<std::uint32_t>> alive;
            std::vector<std::uint32_t> ends;
            for (std::uint32_t sites = 1; sites <= model->siteCount(); ++sites)
                if (endsBatch(*model, sites)) {
                    ends.push_back(sites);
                    const auto mesh = extractPrefix(*model, sites);
                    for (const Tetrahedron& tetrahedron : mesh->tetrahedra)
                        alive[tetrahedron].push_back(sites);
                }
            for (std::size_t t = 0; t < part->births.size(); ++t) {
                std::vector<std::uint32_t> expected;
                std::ranges::copy_if(ends, std::back_inserter(expected), [&](std::uint32_t sites) {
                    return part->births[t] <= sites && sites < part->deaths[t];
                });
                QVERIFY2(alive[part->mesh.tetrahedra[t]] == expected, name.c_str());
                QVERIFY(part->deaths[t] == Model::never || part->deaths[t] <= model->siteCount());
            }
        }
    }

    void oneAccuracyIsItsMesh()
    {
        for (const auto& [name, model] : models_)
            for (const double error : {100.0, 7.0, 0.0}) {
                const auto part = extractHistory(*model, {error}, {error});
                const auto mesh = extractPrefix(*model, meshSizeAt(*model, {error}).sites);
                QVERIFY(part.ok() && mesh.ok());
                QVERIFY2(part->mesh.tetrahedra == mesh->tetrahedra, name.c_str());
            }
    }

    /// What is left is what the filters of meshes leave, and each keeps its life.
    void valuesAndWindowChoose()
    {
        std::mt19937 random(8);
        std::size_t chosen = 0;
        for (const auto& [name, model] : models_) {
            const auto all = extractHistory(*model, {30}, {1});
            QVERIFY(all.ok());
            for (int trial = 0; trial < 20; ++trial) {
                const auto anyVertex = [&] { return random() % all->mesh.values.size(); };
                MeshQuery query{.range = LifeRange{{30}, {1}}};
                query.values.resize(random() % 3);
                for (ValueRange& range : query.values)
                    range.minimum = range.maximum = all->mesh.values[anyVertex()];
                if (trial % 4 != 0) {
                    const Eigen::Vector3d one = all->mesh.positions[anyVertex()].cast<double>();
                    const Eigen::Vector3d other = all->mesh.positions[anyVertex()].cast<double>();
                    query.window = Window{{one.cwiseMin(other), one.cwiseMax(other)},
                                          trial % 2 == 0 ? WindowBorder::Intersecting : WindowBorder::Contained};
                }
                const auto part = chooseLives(*all, query);
                QVERIFY(part.ok());
                ExtractedMesh expected = whole(*all);
                QVERIFY(keepValues(expected.mesh, query.values).ok());
                if (query.window)
                    QVERIFY(keepWindow(expected.mesh, *query.window).ok());
                dropUnusedVertices(expected);
                QVERIFY2(part->mesh.tetrahedra == expected.mesh.tetrahedra, name.c_str());
                QVERIFY2(part->mesh.positions == expected.mesh.positions, name.c_str());
                QVERIFY2(part->sites == expected.sites, name.c_str());
                QCOMPARE(part->birthErrors.size(), expected.mesh.tetrahedra.size());
                QCOMPARE(part->deathErrors.size(), expected.mesh.tetrahedra.size());
                QCOMPARE(part->keptTetrahedra, expected.mesh.tetrahedra.size());
                chosen += expected.mesh.tetrahedra.size();
            }
        }
        QVERIFY(chosen > 1000);
    }

    /// Of the tetrahedra that are loaded, births and deaths choose (R17, C2): what is alive at an error of the range is
    /// its mesh, and nothing is extracted for it.
    void livesChoose()
    {
        for (const auto& [name, model] : models_) {
            const double extent = model->description().range.extent(), weight = model->description().warpingWeight;
            const auto both = [&](double percent) { // lives are told by the key
                return weight > 0 ? Accuracy{percent, percent * extent / (weight * model->diagonal())}
                                  : Accuracy{percent};
            };
            MeshExtractor extractor(model);
            MeshQuery query{.range = LifeRange{both(30), both(1)}};
            const auto all = extractor.extract(query);
            QVERIFY(all.ok());
            QVERIFY((*all)->overlaps == ((*all)->mesh.tetrahedra.size() != meshSizeAt(*model, both(1)).tetrahedra));
            bool extracts = false;
            const Progress progress({}, [&](double, const Message& activity) {
                extracts = extracts || activity.text() == "Extracting a range of meshes";
            });
            for (const double error : {29.0, 17.0, 5.0, 2.0, 1.1}) {
                query.range->births = {error, std::numeric_limits<double>::infinity()};
                query.range->deaths = {0, error};
                const auto alive = extractor.extract(query, progress);
                QVERIFY(alive.ok() && !(*alive)->overlaps);
                const double key = error / 100 * extent;
                const auto first = std::ranges::partition_point(
                    model->runningKeys(), [key](float before) { return static_cast<double>(before) > key; });
                const auto mesh =
                    extractPrefix(*model, static_cast<std::uint32_t>(first - model->runningKeys().begin()));
                QVERIFY(mesh.ok());
                QVERIFY2(bySites(**alive) == sorted(mesh->tetrahedra), name.c_str());
            }
            query.range->births = {3, 20};
            query.range->deaths = {2, 10};
            const auto some = extractor.extract(query, progress);
            QVERIFY(some.ok());
            std::size_t expected = 0;
            for (std::size_t t = 0; t < (*all)->birthErrors.size(); ++t) {
                const float birth = (*all)->birthErrors[t], death = (*all)->deathErrors[t];
                QVERIFY(death < birth && birth > 0.999F && death <= 30.001F);
                expected += birth > 3 && birth <= 20 && death >= 2 && death <= 10 ? 1 : 0;
            }
            QCOMPARE((*some)->mesh.tetrahedra.size(), expected);
            QVERIFY(!extracts);
            query.range->other = both(4);
            QVERIFY(extractor.extract(query, progress).ok() && extracts);
        }
    }

    /// Limits that are errors of births or deaths: a birth is beyond the least, the others may be equal.
    void limitsThatOccurChoose()
    {
        std::size_t compared = 0;
        for (const auto& [name, model] : models_) {
            const auto all = extractHistory(*model, {30}, {1});
            QVERIFY(all.ok());
            const auto chosenBy = [&](const LifeRange& range) {
                const auto part = chooseLives(*all, {.range = range});
                return part.ok() ? part->mesh.tetrahedra.size() : std::size_t(-1);
            };
            const auto count = [](const auto& errors, auto keeps) {
                return static_cast<std::size_t>(std::ranges::count_if(errors, keeps));
            };
            const std::size_t whole = all->birthErrors.size();
            for (std::size_t t = 0; t < whole; t += std::max<std::size_t>(1, whole / 7)) {
                const float birth = all->birthErrors[t], death = all->deathErrors[t];
                LifeRange range{{30}, {1}};
                range.births.minimum = birth;
                QCOMPARE(chosenBy(range), count(all->birthErrors, [&](float one) { return one > birth; }));
                range = {{30}, {1}};
                range.births.maximum = birth;
                QCOMPARE(chosenBy(range), count(all->birthErrors, [&](float one) { return one <= birth; }));
                range = {{30}, {1}};
                range.deaths.minimum = death;
                QCOMPARE(chosenBy(range), count(all->deathErrors, [&](float one) { return one >= death; }));
                range = {{30}, {1}};
                range.deaths.maximum = death;
                QCOMPARE(chosenBy(range), count(all->deathErrors, [&](float one) { return one <= death; }));
                ++compared;
            }
        }
        QVERIFY(compared > 20);
    }

    void emptyWindowsHoldNothing()
    {
        const Window window{{{1e3, -1e3, -1e3}, {-1e3, 1e3, 1e3}}, WindowBorder::Intersecting};
        const auto all = extractHistory(*models_[0].model, {30}, {1});
        QVERIFY(all.ok());
        const auto part = chooseLives(*all, {.window = window, .range = LifeRange{{30}, {1}}});
        QVERIFY(part.ok() && part->mesh.tetrahedra.empty() && part->birthErrors.empty() && !part->overlaps);
    }

    /// What a range of accuracies cannot be combined with.
    void wrongQueriesAreRefused()
    {
        const LifeRange range{{2}, {1}};
        MeshExtractor extractor(models_[0].model);
        const Window cut{{{0, 0, 0}, {1, 1, 1}}, WindowBorder::Clipped};
        LifeRange notOrdered = range;
        notOrdered.births = {2, 1};
        for (const MeshQuery& query :
             {MeshQuery{.window = cut, .range = range}, MeshQuery{.budget = 1000, .range = range},
              MeshQuery{.range = LifeRange{{std::nan("")}, {1}}}, MeshQuery{.range = notOrdered}}) {
            const auto part = extractor.extract(query);
            QVERIFY(!part.ok());
            QCOMPARE(part.error().kind, ErrorKind::WrongUsage);
        }
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto part = extractHistory(*models_[0].model, {2}, {1}, Progress(stop.get_token(), {}));
        QVERIFY(!part.ok());
        QCOMPARE(part.error().kind, ErrorKind::Cancelled);
    }

    void aDamagedFileIsAnError_data()
    {
        QTest::addColumn<Damage>("damage");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const Damage& damage, const char* says) {
            QTest::newRow(name) << damage << QString(says);
        };
        row(
            "site too late",
            [](FileParts& f) { f.elements<std::array<std::uint32_t, 3>>(SectionId::OtherSites).back()[1] = ~0u; },
            "comes after its creator");
        row(
            "offset beyond", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[30] = ~0ull; },
            "star offsets of site 29");
        row(
            "offset back", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[30] = 0; },
            "star offsets of site 29");
        row(
            "last offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets).back() += 1; },
            "do not match its tetrahedra");
        row(
            "first offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[0] = 1; },
            "do not match its tetrahedra");
        row(
            "mesh size", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::MeshSizes).back() += 1; },
            "do not have the expected");
        row(
            "never destroyed", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers)[0] = Model::never; },
            "do not have the expected");
        row(
            "no destroyer", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers).back() = ~0u - 1; },
            "does not come after it");
        row(
            "destroyed first",
            [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers).back() = f.header().siteCount - 2; },
            "does not come after it");
        row(
            "point", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::SitePoints)[12] = 7 * 6 * 5; },
            "not a point of its lattice");
        row(
            "no mesh", [](FileParts& f) { std::ranges::fill(f.elements<float>(SectionId::SiteRunningKeys), 0.0f); },
            "first sites");
    }
    void aDamagedFileIsAnError()
    {
        QFETCH(Damage, damage);
        QFETCH(QString, says);
        FileParts parts(readBytes(models_.front().model->path()));
        damage(parts);
        parts.repairChecksums();
        const std::filesystem::path path = folder_.filePath("damaged.tan").toStdString();
        writeBytes(path, parts.content);
        const auto model = Model::open(path);
        QVERIFY(model.ok());
        const auto part = extractHistory(**model, {100}, {0});
        QVERIFY(!part.ok());
        QCOMPARE(part.error().kind, ErrorKind::BadInput);
        QVERIFY2(QString::fromStdString(part.error().text()).contains(says), part.error().text().c_str());
    }

private:
    static std::vector<std::array<double, 2>> ranges()
    {
        return {{100, 0}, {20, 5}, {5, 20}, {3, 3}, {0, 0}, {1e9, 30}, {2, -1}};
    }

    QTemporaryDir folder_;
    std::vector<SomeModel> models_;
};

QTEST_GUILESS_MAIN(HistoryPartTest)
#include "history_part_test.moc"
