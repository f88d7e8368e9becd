// SPDX-License-Identifier: GPL-3.0-or-later
// All tetrahedra that are alive at some accuracy of a range, and how long they live (R14, S2).
#include "core/history/query/history_part.h"

#include "core/history/query/window.h"
#include "core/mesh/topology.h"
#include "tests/core/history/model_fixture.h"
#include "tests/core/history/query/some_models.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <map>
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

} // namespace

Q_DECLARE_METATYPE(Damage)

class HistoryPartTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { models_ = someModels(folder_.path().toStdString()); }

    /// Against the meshes of all accuracies, extracted one by one.
    void everyLifeIsWholeAndNothingElseIsThere()
    {
        for (const auto& [name, model] : models_)
            for (const auto& [one, other] : ranges()) {
                const auto part = extractHistory(*model, {one}, {other}, {}, {});
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
            const auto part = extractHistory(*model, {5}, {4}, {}, {});
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
                const auto part = extractHistory(*model, {error}, {error}, {}, {});
                const auto mesh = extractPrefix(*model, meshSizeAt(*model, {error}).sites);
                QVERIFY(part.ok() && mesh.ok());
                QVERIFY2(part->mesh.tetrahedra == mesh->tetrahedra, name.c_str());
            }
    }

    /// What is left is what the filters of meshes leave.
    void valuesAndWindowChoose()
    {
        std::mt19937 random(8);
        std::size_t chosen = 0;
        for (const auto& [name, model] : models_)
            for (int trial = 0; trial < 20; ++trial) {
                const auto all = extractHistory(*model, {30}, {1}, {}, {});
                QVERIFY(all.ok());
                const auto anyVertex = [&] { return random() % all->mesh.values.size(); };
                std::vector<ValueRange> values(random() % 3);
                for (ValueRange& range : values)
                    range.minimum = range.maximum = all->mesh.values[anyVertex()];
                std::optional<Window> window;
                if (trial % 4 != 0) {
                    const Eigen::Vector3d one = all->mesh.positions[anyVertex()].cast<double>();
                    const Eigen::Vector3d other = all->mesh.positions[anyVertex()].cast<double>();
                    window = Window{{one.cwiseMin(other), one.cwiseMax(other)},
                                    trial % 2 == 0 ? WindowBorder::Intersecting : WindowBorder::Contained};
                }
                const auto part = extractHistory(*model, {30}, {1}, values, window);
                QVERIFY(part.ok());
                TetrahedralMesh expected = all->mesh;
                QVERIFY(keepValues(expected, values).ok());
                if (window)
                    QVERIFY(keepWindow(expected, *window).ok());
                QVERIFY2(part->mesh.tetrahedra == expected.tetrahedra, name.c_str());
                QCOMPARE(part->births.size(), expected.tetrahedra.size());
                QCOMPARE(part->deaths.size(), expected.tetrahedra.size());
                chosen += expected.tetrahedra.size();
            }
        QVERIFY(chosen > 1000);
    }

    void emptyWindowsHoldNothing()
    {
        const Window window{{{1e3, -1e3, -1e3}, {-1e3, 1e3, 1e3}}, WindowBorder::Intersecting};
        const auto part = extractHistory(*models_[0].model, {30}, {1}, {}, window);
        QVERIFY(part.ok() && part->mesh.tetrahedra.empty() && part->births.empty() && part->deaths.empty());
    }

    void whatIsCutHasNoLife()
    {
        const auto part =
            extractHistory(*models_[0].model, {2}, {1}, {}, Window{{{0, 0, 0}, {1, 1, 1}}, WindowBorder::Clipped});
        QVERIFY(!part.ok());
        QCOMPARE(part.error().kind, ErrorKind::WrongUsage);
    }

    void canBeCancelled()
    {
        std::stop_source stop;
        stop.request_stop();
        const auto part = extractHistory(*models_[0].model, {2}, {1}, {}, {}, Progress(stop.get_token(), {}));
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
            "do not fit its tetrahedra");
        row(
            "first offset", [](FileParts& f) { f.elements<std::uint64_t>(SectionId::StarOffsets)[0] = 1; },
            "do not fit its tetrahedra");
        row(
            "mesh size", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::MeshSizes).back() += 1; },
            "that they should have");
        row(
            "never destroyed", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers)[0] = Model::never; },
            "that they should have");
        row(
            "no destroyer", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers).back() = ~0u - 1; },
            "does not come after it");
        row(
            "destroyed first",
            [](FileParts& f) { f.elements<std::uint32_t>(SectionId::Destroyers).back() = f.header().siteCount - 2; },
            "does not come after it");
        row(
            "point", [](FileParts& f) { f.elements<std::uint32_t>(SectionId::SitePoints)[12] = 7 * 6 * 5; },
            "no point of its lattice");
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
        const auto part = extractHistory(**model, {100}, {0}, {}, {});
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
