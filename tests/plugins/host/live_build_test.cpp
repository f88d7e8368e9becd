// SPDX-License-Identifier: GPL-3.0-or-later
/// Looking at a model while it is built (B8): every look is a model that keeps its word, and never less than the last.
#include "plugins/host/live_build.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <atomic>
#include <thread>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Dataset sample(std::uint32_t size)
{
    return *makeSample({.name = "c60", .size = size, .type = std::nullopt, .seed = 1});
}

/// The error that the model keeps in percent, and a little more: percentages round.
double reachedBy(const Model& model)
{
    return 100 * (1 + 1e-12) * static_cast<double>(model.finalKey()) / model.description().range.extent();
}

} // namespace

class LiveBuildTest : public QObject {
    Q_OBJECT

private:
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;

private slots:
    void initTestCase() { host_ = PluginHost::standard(); }

    void nothingToSeeBeforeTheBuild()
    {
        LiveBuild live;
        const auto look = live.look(path("look.tan"));
        QVERIFY(look);
        QVERIFY(*look == nullptr);
    }

    /// Looks from another thread, as fast as it can, while a build runs.
    void everyLookKeepsItsWord()
    {
        const Dataset dataset = sample(48);
        LiveBuild live;
        std::atomic<bool> done = false;
        std::vector<std::shared_ptr<const Model>> looks;
        std::string problem;
        std::thread looker([&] {
            while (!done) {
                const auto look = live.look(path("look.tan"));
                if (!look)
                    problem = look.error().text();
                else if (*look != nullptr)
                    looks.push_back(*look);
            }
        });
        const auto built = buildModel(*host_, dataset, "refinement", {}, path("built.tan"), {}, {.live = &live});
        done = true;
        looker.join();
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QVERIFY2(problem.empty(), problem.c_str());
        QVERIFY(!looks.empty());

        std::uint32_t sites = 0;
        for (const auto& look : looks) {
            QVERIFY(look->siteCount() > sites);
            sites = look->siteCount();
        }
        for (const auto& look : {looks.front(), looks.back()}) {
            const auto verdict = verify(*look, dataset, {{50}, {reachedBy(*look)}});
            QVERIFY(verdict);
            QVERIFY2(verdict->ok(), verdict->levels.back().failures.empty()
                                        ? "the file as a whole"
                                        : verdict->levels.back().failures.front().c_str());
        }
        const auto whole = Model::open(path("built.tan"));
        QVERIFY(whole);
        QCOMPARE(meshSizeAt(**whole, {reachedBy(*looks.back())}).sites, looks.back()->siteCount());
    }

    /// What does not fit is left to the model itself.
    void remembersNoMoreThanItMay()
    {
        const Dataset dataset = sample(24);
        LiveBuild live(5000);
        QVERIFY(buildModel(*host_, dataset, "refinement", {}, path("built.tan"), {}, {.live = &live}));
        const auto look = live.look(path("look.tan"));
        QVERIFY(look && *look != nullptr);
        QVERIFY((*look)->tetrahedronCount() < 10'000);
        const auto whole = Model::open(path("built.tan"));
        QVERIFY(whole && (*whole)->tetrahedronCount() > 20'000);
    }
};

} // namespace tetra

QTEST_GUILESS_MAIN(tetra::LiveBuildTest)
#include "live_build_test.moc"
