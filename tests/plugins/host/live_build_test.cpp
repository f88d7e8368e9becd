// SPDX-License-Identifier: GPL-3.0-or-later
/// Looking at a model while it is built (B8): every look is a model that keeps its word, and never less than the last.
#include "plugins/host/live_build.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <iterator>
#include <limits>
#include <stop_token>
#include <thread>

using namespace tetra;

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

/// At the error that it says to keep, of its whole domain, and at a larger one.
bool isProved(const Model& model, const Dataset& dataset)
{
    const double reached = reachedBy(model);
    const auto verdict = verify(model, dataset, {{100, 100}, {reached, reached}});
    return verdict && verdict->ok();
}

/// What is seen of a build.
struct Looks {
    std::vector<std::shared_ptr<const Model>> models;
    std::string problem;

    void look(LiveBuild& live, const fs::path& path)
    {
        const auto seen = live.look(path);
        if (!seen)
            problem = seen.error().text();
        else if (*seen != nullptr)
            models.push_back(*seen);
    }
};

std::vector<char> contentOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

} // namespace

class LiveBuildTest : public QObject {
    Q_OBJECT

private:
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

    static void datasetsInBlocks()
    {
        QTest::addColumn<QString>("name");
        QTest::newRow("lattice") << "c60";
        QTest::newRow("curvilinear grid") << "blunt-body";
    }
    static Dataset inBlocks(const QString& name)
    {
        return *makeSample({.name = name.toStdString(), .size = 32, .type = std::nullopt, .seed = 1});
    }
    static ParameterValues blockValues() { return {{"block", std::string("11")}}; }

    /// The bytes of the model of a build in blocks that nobody watches.
    std::vector<char> unwatched(const Dataset& dataset)
    {
        if (!buildModel(*host_, dataset, "refinement", blockValues(), path("unwatched.tan")))
            return {};
        return contentOf(path("unwatched.tan"));
    }

    /// Builds in blocks until the progress reaches `when`; the work goes on being there if it is kept.
    Result<ModelBuild> stopped(const Dataset& dataset, double when, bool kept)
    {
        std::stop_source stop;
        const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
            if (fraction >= when)
                stop.request_stop();
        });
        const std::atomic<bool> keep = kept;
        return buildModel(*host_, dataset, "refinement", blockValues(), path("kept.tan"), progress,
                          {.keepWhenCancelled = &keep, .resume = kept});
    }

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
        Looks looks;
        std::thread looker([&] {
            while (!done)
                looks.look(live, path("look.tan"));
        });
        const auto built = buildModel(*host_, dataset, "refinement", {}, path("built.tan"), {}, {.live = &live});
        done = true;
        looker.join();
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QVERIFY2(looks.problem.empty(), looks.problem.c_str());
        QVERIFY(!looks.models.empty());

        std::uint32_t sites = 0;
        for (const auto& look : looks.models) {
            QVERIFY(look->siteCount() > sites);
            sites = look->siteCount();
        }
        for (const auto& look : {looks.models.front(), looks.models.back()}) {
            const auto verdict = verify(*look, dataset, {{50}, {reachedBy(*look)}});
            QVERIFY(verdict);
            QVERIFY2(verdict->ok(), verdict->levels.back().failures.empty()
                                        ? "the file as a whole"
                                        : verdict->levels.back().failures.front().c_str());
        }
        const auto whole = Model::open(path("built.tan"));
        QVERIFY(whole);
        QCOMPARE(meshSizeAt(**whole, {reachedBy(*looks.models.back())}).sites, looks.models.back()->siteCount());
    }

    /// Decimation hands over nothing before its end: it shows the mesh as it is, with the error that this has.
    void aDecimationIsWatched()
    {
        const Dataset dataset = sample(52);
        LiveBuild live;
        Looks looks;
        const auto coarsened = [&] { return looks.models.size() > 1; };
        const Progress looking({}, [&](double, const Message&) {
            looks.look(live, path("look.tan"));
            if (!coarsened()) // meshes are shown half a second apart, or more; the whole build may take as long
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
        });
        QVERIFY(!live.hasMesh());
        const auto built = buildModel(*host_, dataset, "decimation", {}, path("built.tan"), looking, {.live = &live});
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QVERIFY2(looks.problem.empty(), looks.problem.c_str());
        QVERIFY(!built->stoppedEarly && live.hasMesh());
        QVERIFY(!looks.models.empty());
        std::uint32_t sites = std::numeric_limits<std::uint32_t>::max();
        for (const auto& look : looks.models)
            if (look->runningKeys().back() == std::numeric_limits<float>::infinity()) { // before the history comes
                QVERIFY(look->siteCount() < sites);
                sites = look->siteCount();
                const auto verdict = verify(*look, dataset, {{reachedBy(*look)}});
                QVERIFY2(verdict && verdict->ok(), qPrintable(QString::number(sites)));
            }
        QVERIFY(sites < dataset.pointCount());
    }

    /// Stopped, it keeps all that it has done: the history up to the mesh that it had come to.
    void aStoppedDecimationIsKept()
    {
        const Dataset dataset = sample(20);
        for (const bool kept : {true, false}) {
            std::stop_source stop;
            const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
                if (fraction > 0.5)
                    stop.request_stop();
            });
            const std::atomic<bool> keep = kept;
            const auto built =
                buildModel(*host_, dataset, "decimation", {}, path("kept.tan"), progress, {.keepWhenCancelled = &keep});
            QCOMPARE(built.ok(), kept);
            if (!kept) {
                QCOMPARE(built.error().kind, ErrorKind::Cancelled);
                continue;
            }
            QVERIFY(built->stoppedEarly);
            const auto model = Model::open(path("kept.tan"));
            QVERIFY(model && (*model)->siteCount() == dataset.pointCount());
            const auto coarsest = meshSizeAt(**model, {.error = 100}).sites;
            QVERIFY(coarsest > 100 && coarsest < dataset.pointCount() * 9 / 10);
            const auto verdict = verify(**model, dataset, {{100}, {1}, {0.1}, {0}});
            QVERIFY(verdict && verdict->ok());
            QCOMPARE(verdict->levels[3].measured.error.largest, 0.0);
            fs::remove(path("kept.tan"));
        }
        QVERIFY(!fs::exists(path("kept.tan")));
    }

    void whatIsKeptReplacesNoFinishedModel_data()
    {
        QTest::addColumn<QString>("builder");
        QTest::addColumn<bool>("inBlocks");
        QTest::newRow("refinement") << "refinement" << false;
        QTest::newRow("in blocks") << "refinement" << true;
        QTest::newRow("decimation") << "decimation" << false;
    }
    /// A finished model stays what it is; what is kept has a name that says its error, and another one the next time.
    void whatIsKeptReplacesNoFinishedModel()
    {
        QFETCH(QString, builder);
        QFETCH(bool, inBlocks);
        const Dataset dataset = sample(20);
        const fs::path folder = path("finished");
        fs::create_directory(folder);
        const fs::path finished = folder / "engine.tan";
        QVERIFY(buildModel(*host_, dataset, std::nullopt, {}, finished));
        const std::vector<char> content = contentOf(finished);
        std::vector<fs::path> kept;
        for (int time = 0; time < 2; ++time) {
            std::stop_source stop;
            const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
                if (fraction > 0.3)
                    stop.request_stop();
            });
            const std::atomic<bool> keep = true;
            const auto built =
                buildModel(*host_, dataset, builder.toStdString(), inBlocks ? blockValues() : ParameterValues(),
                           finished, progress, {.keepWhenCancelled = &keep});
            QVERIFY2(built, built ? "" : built.error().text().c_str());
            QVERIFY(built->stoppedEarly);
            QVERIFY(contentOf(finished) == content);
            QVERIFY(fs::equivalent(built->model.parent_path(), folder) && fs::exists(built->model));
            const auto model = Model::open(built->model);
            QVERIFY(model);
            QCOMPARE(built->fileBytes, fs::file_size(built->model));
            const std::string name = keptName(finished, reachedBy(**model));
            if (time == 0)
                QCOMPARE(built->model.filename().string(), name);
            QVERIFY(built->model != finished && std::ranges::find(kept, built->model) == kept.end());
            kept.push_back(built->model);
        }
        QCOMPARE(std::distance(fs::directory_iterator(folder), {}), 3); // nor is anything else left
        fs::remove_all(folder);
    }

    /// Whoever builds with interruptions gets a better model of the same name each time, unless it is not their own.
    void whatAResumedBuildHasKeptIsReplacedByMore()
    {
        const Dataset dataset = inBlocks("c60");
        QVERIFY(stopped(dataset, 0.055, true)->model == path("kept.tan"));
        const float first = (*Model::open(path("kept.tan")))->finalKey();
        QVERIFY(!keepsBeside(path("kept.tan")));
        QVERIFY(stopped(dataset, 0.3, true)->model == path("kept.tan"));
        QVERIFY((*Model::open(path("kept.tan")))->finalKey() < first);
        QVERIFY(buildModel(*host_, sample(12), std::nullopt, {}, path("other.tan")));
        fs::rename(path("other.tan"), path("kept.tan"));
        QVERIFY(keepsBeside(path("kept.tan")));
        const auto beside = stopped(dataset, 0.5, true);
        QVERIFY(beside && beside->model != path("kept.tan") && fs::exists(beside->model));
        QVERIFY(buildModel(*host_, dataset, "refinement", blockValues(), path("kept.tan"), {}, {.resume = true}));
        fs::remove(beside->model);
        fs::remove(path("kept.tan"));
    }

    void keptModelsAreNamedByTheirErrors()
    {
        QCOMPARE(keptName("some/engine.tan", 25.3), std::string("engine-25-percent.tan"));
        QCOMPARE(keptName("engine.tan", 2.24), std::string("engine-2.2-percent.tan"));
        QCOMPARE(keptName("engine.tan", 0.0125), std::string("engine-0.013-percent.tan"));
        QCOMPARE(keptName("engine.tan", 100), std::string("engine-100-percent.tan"));
        QCOMPARE(keptName("engine.tan", 0), std::string("engine-stopped.tan"));
    }

    void blocksAreWatched_data() { datasetsInBlocks(); }
    /// C7: a build in blocks shows all of them at one error, and again at a smaller one, before it refines each to the
    /// end; its model is that of a build that nobody watches.
    void blocksAreWatched()
    {
        QFETCH(QString, name);
        const Dataset dataset = inBlocks(name);
        LiveBuild live;
        Looks looks;
        const Progress looking({}, [&](double, const Message&) { looks.look(live, path("look.tan")); });
        const auto built =
            buildModel(*host_, dataset, "refinement", blockValues(), path("watched.tan"), looking, {.live = &live});
        QVERIFY2(built, built ? "" : built.error().text().c_str());
        QVERIFY2(looks.problem.empty(), looks.problem.c_str());
        QVERIFY(live.hasMesh());
        QVERIFY2(looks.models.size() == 2, QByteArray::number(qsizetype(looks.models.size())));
        QVERIFY(looks.models[0]->siteCount() < looks.models[1]->siteCount() &&
                looks.models[1]->siteCount() < built->report.sites / 4);
        QVERIFY(looks.models[0]->finalKey() > looks.models[1]->finalKey() && looks.models[1]->finalKey() > 0);
        for (const auto& look : looks.models)
            QVERIFY(isProved(*look, dataset));
        QVERIFY(contentOf(path("watched.tan")) == unwatched(dataset));
    }

    void stoppedBlocksAreKept_data() { datasetsInBlocks(); }
    /// C7: stopped, it keeps the mesh that all blocks have come to, with the error of the whole domain, and can go on.
    void stoppedBlocksAreKept()
    {
        QFETCH(QString, name);
        const Dataset dataset = inBlocks(name);
        const std::vector<char> whole = unwatched(dataset);
        std::vector<float> keys;
        for (const double when : {0.055, 0.3, 0.5}) {
            const auto kept = stopped(dataset, when, true);
            QVERIFY2(kept, kept ? "" : kept.error().text().c_str());
            QVERIFY(kept->stoppedEarly);
            const auto model = Model::open(path("kept.tan"));
            QVERIFY(model && (*model)->siteCount() == kept->report.sites);
            keys.push_back((*model)->finalKey());
            QVERIFY(isProved(**model, dataset));
            QVERIFY(fs::exists(path("kept.tan.work")));
            const auto resumed =
                buildModel(*host_, dataset, "refinement", blockValues(), path("kept.tan"), {}, {.resume = true});
            QVERIFY(resumed && !resumed->stoppedEarly);
            QVERIFY(contentOf(path("kept.tan")) == whole);
            QVERIFY(!fs::exists(path("kept.tan.work")));
            fs::remove(path("kept.tan"));
        }
        QVERIFY(keys[0] > keys[1] && keys[1] == keys[2] && keys[2] > 0);

        // While they are merged, everything is there: a whole model, also over one that is finished.
        for (int time = 0; time < 2; ++time) {
            const auto merged = stopped(dataset, 0.9, true);
            QVERIFY(merged && !merged->stoppedEarly && merged->model == path("kept.tan"));
            QVERIFY(contentOf(path("kept.tan")) == whole);
        }
        fs::remove(path("kept.tan"));
        for (const double when : {0.055, 0.3, 0.9})
            QCOMPARE(stopped(dataset, when, false).error().kind, ErrorKind::Cancelled);
        QCOMPARE(stopped(dataset, 0, true).error().kind, ErrorKind::Cancelled); // nothing to keep yet
        QVERIFY(!fs::exists(path("kept.tan")));
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

QTEST_GUILESS_MAIN(LiveBuildTest)
#include "live_build_test.moc"
