// SPDX-License-Identifier: GPL-3.0-or-later
// Lattices and curvilinear grids refined in blocks are models like any others (R10, S3, C7): proved on random ones, the
// same for any number of threads, complete after an interruption, and refused where they cannot be.
#include "core/base/checksum.h"
#include "core/base/work_folder.h"
#include "core/build/model_build.h"
#include "core/history/model_writer.h"
#include "plugins/builders/refinement/refinement_builder.h"
#include "plugins/samples/samples.h"
#include "tests/core/refine/bent_grids.h"
#include "tests/plugins/builders/refinement/random_dataset.h"
#include <tan/base.h>
#include <tan/build.h>

#include <tan/verify.h>

#include <QTemporaryDir>
#include <QtTest>

#include <tbb/global_control.h>

#include <fstream>
#include <memory>
#include <random>

using namespace tetra;

namespace {

/// A smooth field, which blocks refine unevenly.
Dataset smoothDataset(std::uint32_t size)
{
    return makeSample({"marschner-lobb", size, {}, 1}).value();
}

/// With flipped tetrahedra on the faces of its blocks.
Dataset wrappedDataset(std::uint32_t size)
{
    const BentGrid grid = oGrid({size / 2, 2 * size, size / 3}, 1.4, 1);
    return curvilinearDataset(grid.size, grid.positions, ScalarField::of(grid.values), "wrapped").value();
}

std::vector<char> contentOf(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

class BlockBuildTest : public QObject {
    Q_OBJECT

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    /// Issue 3, acceptance 2: 50 random lattices of random values and sizes, with random block sizes.
    void randomLatticesAreProved()
    {
        std::mt19937 random(7);
        for (int round = 0; round < 50; ++round) {
            Lattice lattice{{2, 2, 2}, {1, 1, 1}, {0, 0, 0}};
            if (round > 0)
                for (std::uint32_t& size : lattice.size)
                    size = 2 + random() % (round < 25 ? 6 : 16);
            if (round % 4 == 3)
                lattice.spacing = {1, 0.5 + random() % 4, 1.25};
            const auto type = static_cast<SampleType>(random() % 8);
            const Dataset dataset = randomDataset(random, type, lattice);
            const std::string block = round % 5 == 4 ? "none" : std::to_string(1 + random() % 9);
            const double stop = round % 7 == 6 ? 10 : 0;
            const QString name = QString("round %1: %2 x %3 x %4, type %5, block %6")
                                     .arg(round)
                                     .arg(lattice.size[0])
                                     .arg(lattice.size[1])
                                     .arg(lattice.size[2])
                                     .arg(int(type))
                                     .arg(block.c_str());
            const Result<BuildReport> report = build(dataset, block, stop);
            QVERIFY2(report.ok(), qPrintable(name + (report.ok() ? "" : report.error().text().c_str())));
            QVERIFY2(isProved(dataset, stop, *report), qPrintable(name));
            QVERIFY(!std::filesystem::exists(workFolder()));
        }
    }

    /// C7, S4, S5: curvilinear grids at random, folded, wrapped, collapsed and even ones, by blocks and as a whole, at
    /// the eight accuracies of the paper.
    void randomGridsAreProved()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 60; ++round) {
            const BentGrid grid = randomGrid(random);
            const auto made = curvilinearDataset(grid.size, grid.positions, ScalarField::of(grid.values), "grid");
            if (!made) // flat as a whole
                continue;
            const std::string block = round % 6 == 5 ? "none" : std::to_string(1 + random() % 8);
            const double stop = round % 7 == 6 ? 3 : 0;
            const QString name = QString("round %1: %2 x %3 x %4, block %5")
                                     .arg(round)
                                     .arg(grid.size[0])
                                     .arg(grid.size[1])
                                     .arg(grid.size[2])
                                     .arg(block.c_str());
            const Result<BuildReport> report = build(*made, block, stop);
            QVERIFY2(report.ok(), qPrintable(name + (report.ok() ? "" : report.error().text().c_str())));
            QVERIFY2(isProved(*made, stop, *report), qPrintable(name));
            QVERIFY(!std::filesystem::exists(workFolder()));
        }
    }

    void oneThreadAndTwoMakeTheSameBytes_data() { bothKinds(); }
    void oneThreadAndTwoMakeTheSameBytes()
    {
        QFETCH(bool, curvilinear);
        const Dataset dataset = curvilinear ? wrappedDataset(30) : smoothDataset(30);
        std::vector<std::vector<char>> contents;
        for (const std::size_t threads : {1, 2, 5}) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            QVERIFY(build(dataset, "7", 0).ok());
            contents.push_back(contentOf(path()));
        }
        QVERIFY(!contents[0].empty());
        QVERIFY(contents[1] == contents[0]);
        QVERIFY(contents[2] == contents[0]);
    }

    void oneBlockIsTheWhole()
    {
        const Dataset dataset = smoothDataset(12);
        QVERIFY(build(dataset, "none", 0).ok());
        const auto whole = Model::open(path()).value();
        const std::vector<std::uint32_t> points(whole->points().begin(), whole->points().end());
        const std::vector<std::uint32_t> destroyers(whole->destroyers().begin(), whole->destroyers().end());
        QVERIFY(build(dataset, "11", 0).ok());
        const auto block = Model::open(path()).value();
        QVERIFY(std::ranges::equal(block->points(), points));
        QVERIFY(std::ranges::equal(block->destroyers(), destroyers));
    }

    void theModelTellsItsBlocks()
    {
        QVERIFY(build(smoothDataset(10), "4", 0).ok());
        const auto model = Model::open(path()).value();
        const auto& parameters = model->description().parameters;
        QVERIFY(std::ranges::find(parameters, std::pair(std::string("block"), std::string("4"))) != parameters.end());
    }

    /// Whatever a killed build left: whole runs, damaged ones, those of another dataset.
    void leftRunsAreUsedIfTheyAreRight_data() { bothKinds(); }
    void leftRunsAreUsedIfTheyAreRight()
    {
        QFETCH(bool, curvilinear);
        const Dataset dataset = curvilinear ? wrappedDataset(20) : smoothDataset(20);
        QVERIFY(build(dataset, "6", 0).ok());
        const std::vector<char> right = contentOf(path());
        interrupt(dataset, 0.4);
        const std::filesystem::path runs = workFolder() / "blocks.runs";
        QVERIFY(std::filesystem::file_size(runs) > 10'000);
        {
            std::fstream damaged(runs, std::ios::binary | std::ios::in | std::ios::out);
            damaged.seekp(200);
            damaged.put('\x55');
        }
        std::filesystem::resize_file(runs, std::filesystem::file_size(runs) - 12);
        QVERIFY(build(dataset, "6", 0, true).ok());
        QVERIFY(contentOf(path()) == right);
        QVERIFY(!std::filesystem::exists(workFolder()));

        interrupt(dataset, 0.4);
        const Dataset other = curvilinear ? wrappedDataset(21) : smoothDataset(21);
        QVERIFY(build(other, "6", 0).ok());
        interrupt(dataset, 0.4);
        const auto refused = build(other, "6", 0, true);
        QVERIFY(!refused && refused.error().kind == ErrorKind::WrongUsage);
        QVERIFY(build(dataset, "6", 0, true).ok());
        QVERIFY(contentOf(path()) == right);
    }

    /// C7: wherever a build of a curvilinear grid stops, also between the rounds in which its blocks agree about their
    /// faces, the rest makes the same model.
    void roundsGoOnWhereTheyWereLeft()
    {
        const Dataset dataset = makeSample({.name = "o-grid", .size = 20, .type = std::nullopt, .seed = 1}).value();
        QVERIFY(build(dataset, "6", 0).ok());
        const std::vector<char> right = contentOf(path());
        const std::filesystem::path cures = workFolder() / "cures";
        bool betweenRounds = false;
        for (double when = 0.1; when < 0.9; when += 0.08) {
            interrupt(dataset, when);
            betweenRounds |= std::filesystem::exists(cures);
            QVERIFY(build(dataset, "6", 0, true).ok());
            QVERIFY(contentOf(path()) == right);
        }
        QVERIFY(betweenRounds);
        for (double when = 0.4; when < 0.9 && !std::filesystem::exists(cures); when += 0.02)
            interrupt(dataset, when);
        QVERIFY(std::filesystem::exists(cures));
        std::filesystem::resize_file(cures, std::filesystem::file_size(cures) - 1);
        QVERIFY(build(dataset, "6", 0, true).ok());
        QVERIFY(contentOf(path()) == right);
    }

    /// C7: the paper's selection looks at the mesh as a whole.
    void thePapersSelectionTakesNoBlocks()
    {
        const Dataset dataset = wrappedDataset(12);
        QCOMPARE(build(dataset, "4", 0, false, 2, nullptr, "paper").error().kind, ErrorKind::WrongUsage);
        QVERIFY(build(dataset, "automatic", 0, false, 2, nullptr, "paper").ok());
        const RefinementBuilder builder;
        QVERIFY(builder.abilities(dataset, {{"block", std::string("4")}}).resumes);
        QVERIFY(builder.abilities(dataset, {{"block", std::string("4")}}).usesThreads);
        QVERIFY(builder.abilities(dataset, {{"block", std::string("none")}}).resumes);
    }

    void cancellingLeavesNothing()
    {
        for (const double when : {0.05, 0.4, 0.72, 0.9}) {
            const Result<BuildReport> report = build(smoothDataset(24), "5", 0, false, when);
            QVERIFY(!report.ok());
            QCOMPARE(report.error().kind, ErrorKind::Cancelled);
            QVERIFY(std::filesystem::is_empty(folder_->path().toStdString()));
        }
    }

    void progressOnlyGrows()
    {
        double last = 0;
        bool grows = true;
        const Progress progress({}, [&](double fraction, const Message&) {
            grows = grows && fraction >= last - 1e-12 && fraction <= 1 + 1e-12;
            last = fraction;
        });
        QVERIFY(build(smoothDataset(24), "5", 0, false, 2, &progress).ok());
        QVERIFY(grows);
        QVERIFY(last > 0.99);
    }

    /// The need of disk is told while there is time to stop.
    void theActivityTellsWhatTheBuildWillTake()
    {
        std::string told;
        double toldAt = 1;
        const Progress progress({}, [&](double fraction, const Message& activity) {
            if (!told.empty() || activity.text().find("model about") == std::string::npos)
                return;
            told = activity.text();
            toldAt = fraction;
        });
        QVERIFY(build(smoothDataset(31), "5", 0, false, 2, &progress).ok());
        QVERIFY2(told.find("work files") != std::string::npos, told.c_str());
        QVERIFY(toldAt < 0.5);
    }

    /// A dataset that stays in its file: what is read of one that was cut meanwhile must not become a model, nor a
    /// block that a later build goes on with.
    void aFileCutWhileItIsReadGivesNoModel_data()
    {
        QTest::addColumn<QString>("block");
        QTest::addColumn<double>("when");
        QTest::newRow("as a whole") << "none" << 0.3;
        QTest::newRow("first blocks") << "5" << 0.1;
        QTest::newRow("later blocks") << "5" << 0.5;
        QTest::newRow("merging") << "5" << 0.9;
    }
    void aFileCutWhileItIsReadGivesNoModel()
    {
        QFETCH(QString, block);
        QFETCH(double, when);
        const Dataset whole = smoothDataset(26);
        QVERIFY(build(whole, block.toStdString(), 0).ok());
        const std::vector<char> right = contentOf(path());
        std::filesystem::remove(path());

        const Dataset mapped = mappedCopy(whole);
        const Progress cutting({}, [&](double fraction, const Message&) {
            if (fraction >= when)
                std::filesystem::resize_file(mapped.mappedFile->path(), 100);
        });
        const auto report = build(mapped, block.toStdString(), 0, true, 2, &cutting);
        QVERIFY(!report.ok());
        QCOMPARE(report.error().kind, ErrorKind::BadInput);
        QVERIFY2(report.error().text().find("cut short or changed") != std::string::npos,
                 report.error().text().c_str());
        QVERIFY(!std::filesystem::exists(path()));

        QVERIFY(build(mappedCopy(whole), block.toStdString(), 0, true).ok());
        QVERIFY(contentOf(path()) == right);
    }

    void anotherBuildOfTheSameModelIsRefused()
    {
        const auto other = WorkFolder::open(workFolder(), WorkFolder::Leftovers::Remove);
        QVERIFY(other.ok());
        const Result<BuildReport> report = build(smoothDataset(10), "4", 0);
        QVERIFY(!report.ok());
        QCOMPARE(report.error().kind, ErrorKind::CannotWrite);
        QVERIFY(QString::fromStdString(report.error().text()).contains("another program is building this model"));
    }

    void aFolderOfTheUserIsNotTouched()
    {
        std::filesystem::create_directory(workFolder());
        std::ofstream(workFolder() / "thesis.txt") << "all of it";
        const Result<BuildReport> report = build(smoothDataset(10), "4", 0);
        QVERIFY(!report.ok());
        QVERIFY(QString::fromStdString(report.error().text()).contains("it is used for something else"));
        QVERIFY(std::filesystem::exists(workFolder() / "thesis.txt"));
    }

    void theBlockIsChosenBySizeAndMemory()
    {
        const auto cells = [](const std::optional<std::uint32_t>& block, std::uint32_t size, std::uint64_t memory) {
            const Lattice lattice{{size, size, size}, {1, 1, 1}, {0, 0, 0}};
            return chooseBlocks(block, lattice, memory);
        };
        constexpr std::uint64_t plenty = 64ull << 30;
        QCOMPARE(*cells({}, 64, plenty), 0u);
        QCOMPARE(*cells({}, 256, plenty), 32u);
        QCOMPARE(*cells({}, 128, 1ull << 30), 32u);
        QCOMPARE(*cells({}, 64, 0), 0u);
        QCOMPARE(*cells(0, 256, plenty), 0u);
        QCOMPARE(*cells(17, 64, plenty), 17u);
        for (const char* wrong : {"0", "-3", "1.5", "many", ""})
            QCOMPARE(build(smoothDataset(10), wrong, 0).error().kind, ErrorKind::WrongUsage);
        QVERIFY(cells(1, 256, plenty).error().text().find("Choose larger blocks") != std::string::npos);
    }

private:
    static void bothKinds()
    {
        QTest::addColumn<bool>("curvilinear");
        QTest::newRow("lattice") << false;
        QTest::newRow("curvilinear grid, C7") << true;
    }

    std::filesystem::path path() const { return folder_->filePath("model.tan").toStdString(); }
    std::filesystem::path workFolder() const { return folder_->filePath("model.tan.work").toStdString(); }

    /// The same dataset, its values in a file.
    Dataset mappedCopy(const Dataset& dataset) const
    {
        const std::filesystem::path file = folder_->filePath("samples.raw").toStdString();
        const auto bytes = dataset.values.bytes();
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        Dataset copy = dataset;
        copy.mappedFile = MappedFile::open(file).value();
        copy.values = ScalarField(dataset.values.type(), dataset.values.count(),
                                  {copy.mappedFile, copy.mappedFile->bytes().data()});
        return copy;
    }

    /// As the host does it; cancelled when the progress reaches `cancelAt`.
    Result<BuildReport> build(const Dataset& dataset, const std::string& block, double stop, bool resume = false,
                              double cancelAt = 2, const Progress* progress = nullptr,
                              const std::string& selection = "normalised") const
    {
        ModelDescription description;
        description.builder = "refinement";
        description.parameters = {{"block", "automatic"}};
        const auto file = ModelFileTarget::open(path(), dataset, description, resume);
        if (!file)
            return file.error();
        BuildTarget target = (*file)->target((*file)->writer());
        std::stop_source source;
        const Progress cancelling(source.get_token(), [&](double fraction, const Message&) {
            if (fraction >= cancelAt)
                source.request_stop();
        });
        const ParameterValues values{{"error", stop}, {"block", block}, {"selection", selection}};
        const auto report =
            RefinementBuilder().build(dataset, values, target, progress != nullptr ? *progress : cancelling);
        if (!report && resume)
            (*file)->keepWork();
        return report;
    }

    /// Leaves a work folder as an interrupted build does.
    void interrupt(const Dataset& dataset, double when) const
    {
        QVERIFY(!build(dataset, "6", 0, true, when).ok());
        QVERIFY(std::filesystem::exists(workFolder()));
    }

    bool isProved(const Dataset& dataset, double stop, const BuildReport& report) const
    {
        const auto model = Model::open(path());
        if (!model || (*model)->siteCount() != report.sites || (*model)->tetrahedronCount() > report.tetrahedra)
            return false;
        std::vector<Accuracy> levels;
        if (dataset.domain == DomainClass::Curvilinear) {
            for (const double percent : {4.0, 3.0, 2.0, 1.0, 0.5, 0.2, 0.1, 0.0})
                if (percent >= stop)
                    levels.push_back({percent, percent});
        } else {
            for (const double percent : {70.0, 50.0, 30.0, 20.0, 10.0})
                levels.push_back({percent});
            if (stop == 0)
                for (const double percent : {5.0, 1.0, 0.0})
                    levels.push_back({percent});
        }
        const Result<VerificationReport> verdict = verify(**model, dataset, levels);
        if (!verdict)
            return false;
        for (const std::string& failure : verdict->failures)
            qWarning("%s", failure.c_str());
        for (const LevelReport& level : verdict->levels)
            for (const std::string& failure : level.failures)
                qWarning("%g %%: %s", level.asked.error, failure.c_str());
        return verdict->ok();
    }

    std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(BlockBuildTest)
#include "block_build_test.moc"
