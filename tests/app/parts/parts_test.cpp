// SPDX-License-Identifier: GPL-3.0-or-later
// A build that processes share gives the bytes of one that a single process makes (D15): for any number of parts, in
// any order, with parts that were killed, built twice or by two processes at once. What is missing, damaged, foreign or
// changed is told.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/soak.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <fstream>
#include <numeric>
#include <random>
#include <string_view>
#include <vector>

#include <sys/resource.h>

using namespace tetra;

class PartsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(runTan({"sample", "marschner-lobb", "--size", "30", "-o", "data.nrrd"}, folder_.path()).exitCode == 0);
        right_ = inOneProcess("data.nrrd", {"--block", "7"});
        QVERIFY(right_.size() > 100'000);
    }
    void init()
    {
        QVERIFY(QDir(path("parts")).removeRecursively());
        QFile::remove(path("model.tan"));
    }

    /// 125 blocks: of 200 parts some have none.
    void anyNumberOfPartsMakesTheSameModel_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 3, 8, 13})
            QTest::newRow(QByteArray::number(count).data()) << count;
        if (isSoak())
            QTest::newRow("200") << 200;
    }
    void anyNumberOfPartsMakesTheSameModel()
    {
        QFETCH(int, count);
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        std::vector<int> order(static_cast<std::size_t>(count));
        std::iota(order.begin(), order.end(), 1);
        std::mt19937 random(seedOf(static_cast<unsigned>(count)));
        std::ranges::shuffle(order, random);
        for (const int number : order)
            QVERIFY2(built("data.nrrd", number, count, number % 2 == 0 ? "1" : "2").exitCode == 0, told_);
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right_);
    }

    /// What the options of a build are, the edge of a block that nobody chose, weights, a part of a dataset and samples
    /// that are not stored as they are used.
    void everyWayToBuildALattice_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QStringList>("alone");
        const QStringList none;
        QTest::newRow("usual blocks") << "data.nrrd" << QStringList{"--error", "1"} << QStringList{"--block", "32"};
        QTest::newRow("region and stride")
            << "data.nrrd" << QStringList{"--block", "5", "--region", "2,3,4,27,25,26", "--stride", "2,1,1"} << none;
        QTest::newRow("weights") << "data.nrrd"
                                 << QStringList{"--block", "9", "--weight", "point:0,0,0,0.5", "--error", "2"} << none;
        QTest::newRow("weights where the data lie")
            << "placed.nrrd" << QStringList{"--block", "5", "--weight", "point:103,2,-40,6", "--error", "2"} << none;
        QTest::newRow("converted samples") << "big-endian.nrrd" << QStringList{"--block", "12"} << none;
        QTest::newRow("logarithms") << "data.nrrd" << QStringList{"--block", "11", "--scale", "log:0.01"} << none;
        QTest::newRow("all values the same") << "even.nrrd" << QStringList{"--block", "3"} << none;
    }
    void everyWayToBuildALattice()
    {
        QFETCH(QString, sample);
        QFETCH(QStringList, options);
        QFETCH(QStringList, alone);
        writeNrrd("big-endian.nrrd", "big", [](int i) { return static_cast<unsigned short>(i * 2654435761u >> 13); });
        writeNrrd("even.nrrd", "little", [](int) { return static_cast<unsigned short>(7); });
        writeNrrd(
            "placed.nrrd", "little", [](int i) { return static_cast<unsigned short>(i * 2654435761u >> 15); },
            "space dimension: 3\nspace directions: (1,0,0) (0,0,2) (0,1,0)\nspace origin: (100,0,-50)\n###\n");
        const QByteArray right = inOneProcess(sample, options + alone);
        QVERIFY2(!right.isEmpty(), told_);
        QVERIFY2(prepared(sample, options), told_);
        for (const int number : {2, 3, 1})
            QVERIFY2(built(sample, number, 3, "2").exitCode == 0, told_);
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right);
    }

    void aPartGoesOnWhereItWasKilled()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        std::mt19937 random(seedOf(1));
        for (int kill = 0; kill < timesOf(6, 60); ++kill)
            QVERIFY(killed(random() % 2 + 1, random() % 250));
        for (const int number : {1, 2})
            QVERIFY2(built("data.nrrd", number, 2, "1").exitCode == 0, told_);
        QCOMPARE(QDir(path("parts")).entryList({"part-*"}, QDir::Files, QDir::Name),
                 (QStringList{"part-1-of-2.runs", "part-2-of-2.runs"}));
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right_);
    }

    /// As where a step of a scheduler goes on beside its successor.
    void twoProcessesOnOnePartDoNoHarm()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        for (int round = 0; round < timesOf(3, 20); ++round) {
            std::array<QProcess, 3> processes;
            for (QProcess& process : processes) {
                process.setWorkingDirectory(folder_.path());
                process.start(tanProgram(), words("data.nrrd", 1, 2));
            }
            for (QProcess& process : processes) {
                QVERIFY(process.waitForFinished(60'000));
                const Run run = collect(process);
                QVERIFY2(run.exitCode == 0, run.messages);
            }
            QCOMPARE(QDir(path("parts")).entryList({"part-1-*"}, QDir::Files), QStringList{"part-1-of-2.runs"});
            if (round == 0)
                QVERIFY2(built("data.nrrd", 2, 2, "1").exitCode == 0, told_);
            QVERIFY2(merged().exitCode == 0, told_);
            QVERIFY(readFile(path("model.tan")) == right_);
            QVERIFY(QFile::remove(path("parts/part-1-of-2.runs")));
        }
    }

    void aFinishedPartIsLeftAsItIs()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        QCOMPARE(run({"info", "parts"}).json()["finished"].toArray().size(), 0);
        QVERIFY2(built("data.nrrd", 1, 2, "1").exitCode == 0, told_);
        QVERIFY(!run_.json()["finished_before"].toBool());
        const QJsonArray finished = run({"info", "parts"}).json()["finished"].toArray();
        QCOMPARE(finished.size(), 1);
        QCOMPARE(finished[0].toObject()["part"].toInt(), 1);
        QCOMPARE(finished[0].toObject()["parts"].toInt(), 2);
        const QFileInfo before(path("parts/part-1-of-2.runs"));
        const QDateTime written = before.lastModified();
        QVERIFY2(built("data.nrrd", 1, 2, "1").exitCode == 0, told_);
        QVERIFY(run_.json()["finished_before"].toBool());
        QCOMPARE(QFileInfo(path("parts/part-1-of-2.runs")).lastModified(), written);
    }

    /// What a reader took and changed is told once, when all is read.
    void thePreparationTellsWhatTheReaderDid()
    {
        QVERIFY2(run({"build", "data.nrrd", "--block", "7", "-o", "alone.tan"}).exitCode == 0, told_);
        const QJsonObject alone = run_.json();
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        QVERIFY(!alone["taken"].toObject().isEmpty());
        for (const char* figure : {"taken", "guesses", "unused", "remarks"})
            QCOMPARE(run_.json()[figure], alone[figure]);
        QVERIFY2(merged().exitCode == 5, told_);
    }

    void missingPartsAreNamed()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        QCOMPARE(merged().exitCode, 5);
        QVERIFY2(told_.contains("No part of the build in 'parts' is finished yet."), told_);
        for (const int number : {1, 4})
            QVERIFY2(built("data.nrrd", number, 5, "1").exitCode == 0, told_);
        QCOMPARE(merged().exitCode, 5);
        QVERIFY2(told_.contains("Of the 5 parts of the build in 'parts' these are not finished yet: 2, 3, 5."), told_);
        QVERIFY2(built("data.nrrd", 1, 3, "1").exitCode == 0, told_);
        QCOMPARE(merged().exitCode, 5);
        QVERIFY2(told_.contains("of different divisions"), told_);
        QVERIFY(!QFile::exists(path("model.tan")));
        // Whatever the divisions, the blocks count.
        for (const int number : {2, 3})
            QVERIFY2(built("data.nrrd", number, 3, "1").exitCode == 0, told_);
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right_);
    }

    void aDamagedPartIsToldAndBuiltAgain_data()
    {
        QTest::addColumn<int>("byte");
        QTest::newRow("in the header of the first run") << 40;
        QTest::newRow("in its content") << 500;
        QTest::newRow("cut off") << -1;
    }
    void aDamagedPartIsToldAndBuiltAgain()
    {
        QFETCH(int, byte);
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        for (const int number : {1, 2})
            QVERIFY2(built("data.nrrd", number, 2, "1").exitCode == 0, told_);
        const QString part = path("parts/part-2-of-2.runs");
        if (byte < 0) {
            QVERIFY(QFile::resize(part, QFileInfo(part).size() - 100));
        } else {
            std::fstream stream(part.toStdString(), std::ios::binary | std::ios::in | std::ios::out);
            stream.seekg(byte);
            const char was = static_cast<char>(stream.get());
            stream.seekp(byte);
            stream.put(static_cast<char>(was ^ 0x40));
        }
        QCOMPARE(merged().exitCode, 3);
        QVERIFY2(told_.contains("part-2-of-2.runs' is damaged. Build that part again"), told_);
        QVERIFY2(built("data.nrrd", 2, 2, "1").exitCode == 0, told_);
        QVERIFY(!run_.json()["finished_before"].toBool());
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right_);
    }

    void aPartOfAnotherBuildIsRefused()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7", "--error", "5"}), told_);
        QVERIFY2(built("data.nrrd", 1, 1, "1").exitCode == 0, told_);
        QVERIFY(QFile::copy(path("parts/part-1-of-1.runs"), path("other.runs")));
        QVERIFY(QDir(path("parts")).removeRecursively());
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        QVERIFY(QFile::rename(path("other.runs"), path("parts/part-1-of-1.runs")));
        QCOMPARE(merged().exitCode, 2);
        QVERIFY2(told_.contains("part-1-of-1.runs' belongs to another build"), told_);
        QCOMPARE(built("data.nrrd", 1, 1, "1").exitCode, 2);
        QVERIFY2(told_.contains("part-1-of-1.runs' belongs to another build"), told_);
        QVERIFY(QFile::exists(path("parts/part-1-of-1.runs")));
    }

    void dataThatChangedAreRefused()
    {
        writeNrrd("changing.nrrd", "little", [](int i) { return static_cast<unsigned short>(i * 31); });
        QVERIFY2(prepared("changing.nrrd", {"--block", "7"}), told_);
        for (const int number : {1, 2})
            QVERIFY2(built("changing.nrrd", number, 2, "1").exitCode == 0, told_);
        writeNrrd("changing.nrrd", "little", [](int i) { return static_cast<unsigned short>(i * 37); });
        QCOMPARE(built("changing.nrrd", 2, 2, "1").exitCode, 3);
        QVERIFY2(told_.contains("has changed since the build was prepared"), told_);
        QCOMPARE(merged().exitCode, 3);
        QVERIFY2(told_.contains("has changed since the build was prepared"), told_);
        QVERIFY(!QFile::exists(path("model.tan")));
    }

    void whatDoesNotFitIsRefused_data()
    {
        QTest::addColumn<QStringList>("command");
        QTest::addColumn<QString>("says");
        const auto row = [](const char* name, const QStringList& command, const char* says) {
            QTest::newRow(name) << QStringList{"build", "data.nrrd", "-o", "parts"} + command << QString(says);
        };
        row("another error", {"--part", "1/2", "--error", "3"}, "with another value of '--error'");
        row("other blocks", {"--part", "1/2", "--block", "8"}, "with another value of '--block'");
        row("another region", {"--part", "1/2", "--region", "0,0,0,9,9,9"}, "with other options for reading");
        row("another builder", {"--part", "1/2", "--builder", "decimation"}, "for the builder 'refinement'");
        row("prepared otherwise", {"--part", "prepare", "--block", "8"}, "'parts' holds another build");
        row("no part", {"--part", "3/2"}, "'3/2' names no part");
        row("part none", {"--part", "0/2"}, "'0/2' names no part");
        row("a word", {"--part", "all"}, "'all' names no part");
        row("one number", {"--part", "1"}, "'1' names no part");
        row("kept", {"--part", "1/2", "--keep"}, "'--keep' cannot be combined with '--part'");
        row("resumed", {"--part", "1/2", "--resume"}, "a part always goes on where it was stopped");
        row("packed", {"--part", "1/2", "--packed"}, "'--packed' cannot be combined with '--part'");
        row("an option of another builder", {"--part", "1/2", "--finest", "3"}, "--finest");
        row("waiting", {"--part", "1/2", "--wait"}, "Parts of a regular lattice wait for nothing");
        row("a preparation that waits", {"--part", "prepare", "--wait"}, "The preparation waits for nothing");
        row("waiting for no part", {"--wait"}, "'--wait' is for parts");
        row("as a whole", {"--part", "prepare", "--block", "none"}, "cannot be built in parts");
        row("decimation", {"--part", "prepare", "--builder", "decimation"}, "cannot be built in parts");
    }
    void whatDoesNotFitIsRefused()
    {
        QFETCH(QStringList, command);
        QFETCH(QString, says);
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        const QStringList before = QDir(path("parts")).entryList();
        const Run run = runTan(command, folder_.path());
        QVERIFY2(run.exitCode == 2 && run.messages.contains(says.toUtf8()), run.messages);
        QCOMPARE(QDir(path("parts")).entryList(), before);
    }

    void aFolderOfOthersIsLeftAlone()
    {
        QVERIFY(QDir(folder_.path()).mkdir("parts"));
        std::ofstream(path("parts/mine.txt").toStdString()) << "mine";
        QVERIFY(!prepared("data.nrrd", {}));
        QVERIFY2(told_.contains("'parts' is not empty"), told_);
        QCOMPARE(QDir(path("parts")).entryList(QDir::Files), QStringList{"mine.txt"});
        QCOMPARE(built("data.nrrd", 1, 2, "1").exitCode, 2);
        QVERIFY2(told_.contains("There is no build to share in 'parts'"), told_);
        QCOMPARE(merged().exitCode, 2);
        QVERIFY2(told_.contains("There is no build to share in 'parts'"), told_);
    }

    /// As it does for 'tan build', but that takes decimation first, which has no blocks.
    void theBuilderIsOneThatBuildsInParts()
    {
        QVERIFY(!rightGrid().isEmpty());
        QVERIFY2(prepared("grid.xyz", {"--block", "6"}), told_);
        QCOMPARE(run_.json()["builder"].toString(), QString("refinement"));
    }

    /// Blocks of curvilinear grids agree about their faces in rounds: a part that lacks what another one finds out ends
    /// with exit code 5, and goes on when it is begun again.
    void partsOfGridsGoOnRoundByRound_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {1, 2, 5})
            QTest::newRow(QByteArray::number(count).data()) << count;
    }
    void partsOfGridsGoOnRoundByRound()
    {
        QFETCH(int, count);
        const QByteArray right = rightGrid();
        QVERIFY2(!right.isEmpty(), told_);
        QVERIFY2(prepared("grid.xyz", gridOptions()), told_);
        std::mt19937 random(seedOf(static_cast<unsigned>(count)));
        std::vector<int> due(static_cast<std::size_t>(count));
        std::iota(due.begin(), due.end(), 1);
        bool waited = false;
        for (int pass = 0; !due.empty(); ++pass) {
            QVERIFY(pass < 40);
            std::ranges::shuffle(due, random);
            std::erase_if(due, [&](int number) {
                if (random() % 4 == 0)
                    (void)killed(static_cast<unsigned>(number), random() % 200, "grid.xyz", count);
                const int code = built("grid.xyz", number, count, "2").exitCode;
                waited = waited || (code == 5 && told_.contains("Start it again"));
                if (code != 0 && code != 5)
                    qWarning("%s", told_.constData());
                return code == 0;
            });
        }
        QCOMPARE(waited, count > 1);
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right);
    }

    void partsOfGridsWaitForEachOther()
    {
        constexpr int count = 3;
        const QByteArray right = rightGrid();
        QVERIFY2(prepared("grid.xyz", gridOptions()), told_);
        std::array<QProcess, count> processes;
        for (int number = 1; number <= count; ++number) {
            QProcess& process = processes[static_cast<std::size_t>(number - 1)];
            process.setWorkingDirectory(folder_.path());
            process.start(tanProgram(), words("grid.xyz", number, count) + QStringList{"--wait"});
        }
        for (QProcess& process : processes) {
            QVERIFY(process.waitForFinished(60'000));
            const Run run = collect(process);
            QVERIFY2(run.exitCode == 0, run.messages);
        }
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right);
    }

    void whoWaitsCanBeStopped()
    {
        QVERIFY(!rightGrid().isEmpty());
        QVERIFY2(prepared("grid.xyz", gridOptions()), told_);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), words("grid.xyz", 1, 2) + QStringList{"--wait"});
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(path("parts/part-1-of-2.round-0")), 60'000);
        QVERIFY(!process.waitForFinished(300));
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        const Run stopped = collect(process);
        QCOMPARE(stopped.exitCode, 130);
        QVERIFY2(stopped.messages.contains("What is done is kept in 'parts'"), stopped.messages);
    }

    void dataWithoutBlocksAreRefused()
    {
        QVERIFY(runTan({"sample", "scattered", "--size", "10", "-o", "points.csv"}, folder_.path()).exitCode == 0);
        QVERIFY(!prepared("points.csv", {}));
        QVERIFY2(told_.contains("cannot be built in parts"), told_);
        QVERIFY(!QFile::exists(path("parts")));
    }

    void aPlanThatIsNoneIsRefused_data()
    {
        QTest::addColumn<QByteArray>("from");
        QTest::addColumn<QByteArray>("to");
        QTest::addColumn<QString>("says");
        QTest::newRow("another version") << QByteArray("\"tan\": \"") << QByteArray("\"tan\": \"9")
                                         << "Use one version";
        QTest::newRow("no JSON") << QByteArray("{") << QByteArray("<") << "Cannot use the plan";
        QTest::newRow("no size") << QByteArray("\"size\"") << QByteArray("\"none\"") << "it is damaged";
        QTest::newRow("an enormous size") << QByteArray("\"x\": 30") << QByteArray("\"x\": 4000000000") << "changed";
        QTest::newRow("no parameters") << QByteArray("\"parameters\"") << QByteArray("\"none\"") << "it is damaged";
        QTest::newRow("an odd place") << QByteArray("\",\n        \"file_bytes\"")
                                      << QByteArray("1\",\n        \"file_bytes\"") << "it is damaged";
        QTest::newRow("an empty size") << QByteArray("\"x\": 30") << QByteArray("\"x\": 0") << "Cannot use the plan";
        QTest::newRow("no type") << QByteArray("\"type\": \"") << QByteArray("\"type\": \"no") << "it is damaged";
        QTest::newRow("another place") << QByteArray("\"offset\": \"") << QByteArray("\"offset\": \"99999999")
                                       << "changed";
    }
    void aPlanThatIsNoneIsRefused()
    {
        QFETCH(QByteArray, from);
        QFETCH(QByteArray, to);
        QFETCH(QString, says);
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        QByteArray plan = readFile(path("parts/plan.json"));
        const qsizetype place = plan.indexOf(from);
        QVERIFY2(place >= 0, plan);
        plan.replace(place, from.size(), to);
        std::ofstream(path("parts/plan.json").toStdString()) << plan.toStdString();
        const Run run = built("data.nrrd", 1, 2, "1");
        QVERIFY2(run.exitCode == 3 && told_.contains(says.toUtf8()), told_);
    }

    /// A full disk costs a part nothing but time.
    void aFullDiskLosesNothing()
    {
        QVERIFY2(prepared("data.nrrd", {"--block", "7"}), told_);
        constexpr rlim_t most = 300'000;
        const auto small = [] {
            const struct rlimit limit {
                most, most
            };
            ::setrlimit(RLIMIT_FSIZE, &limit);
        };
        const Run run = runTan(words("data.nrrd", 1, 2), folder_.path(), {}, small);
        QVERIFY2(run.exitCode == 4 && run.messages.contains("Cannot write"), run.messages);
        const auto left = QDir(path("parts")).entryInfoList({"part-1-of-2-*.unfinished"});
        QVERIFY(left.size() == 1 && left[0].size() > 10'000 && left[0].size() <= qint64(most));
        const QByteArray done = readFile(left[0].filePath());
        for (const int number : {1, 2})
            QVERIFY2(built("data.nrrd", number, 2, "1").exitCode == 0, told_);
        QVERIFY(readFile(path("parts/part-1-of-2.runs")).startsWith(done)); // no block was refined again
        QVERIFY2(merged().exitCode == 0, told_);
        QVERIFY(readFile(path("model.tan")) == right_);
    }

    /// The most memory that a process occupied counts the pages of the file that it read.
    void aPartReadsNoMoreThanItsBlocks()
    {
        constexpr qint64 fileBytes = 4 * 240 * 240 * 240;
        QVERIFY(runTan({"sample", "marschner-lobb", "--size", "240", "-o", "large.nrrd"}, folder_.path()).exitCode ==
                0);
        QVERIFY(QFileInfo(path("large.nrrd")).size() >= fileBytes);
        QVERIFY2(prepared("large.nrrd", {"--error", "20", "--block", "12"}), told_);
        QVERIFY(run_.json()["reads_only_its_blocks"].toBool());
        const auto peakOf = [&](int number, int count) {
            return qint64(built("large.nrrd", number, count, "1").json()["peak_bytes"].toDouble());
        };
        const qint64 hardlyAnything = peakOf(1, 4000), eighth = peakOf(4, 8);
        QVERIFY(hardlyAnything > 0 && eighth > 0);
        QVERIFY2(eighth < hardlyAnything + fileBytes / 3,
                 qPrintable(QString("%1 and %2").arg(eighth).arg(hardlyAnything)));
    }

private:
    QString path(const QString& name) const { return folder_.filePath(name); }

    const Run& run(const QStringList& command)
    {
        run_ = runTan(command + QStringList{"--json"}, folder_.path());
        told_ = run_.output + run_.messages;
        return run_;
    }
    bool prepared(const QString& input, const QStringList& options)
    {
        return run(QStringList{"build", input, "--part", "prepare", "-o", "parts"} + options).exitCode == 0;
    }
    static QStringList words(const QString& input, int number, int count)
    {
        return {"build", input, "--part", QString("%1/%2").arg(number).arg(count), "-o", "parts"};
    }
    const Run& built(const QString& input, int number, int count, const QString& threads)
    {
        return run(words(input, number, count) + QStringList{"--threads", threads});
    }
    const Run& merged() { return run({"merge", "parts", "-o", "model.tan"}); }

    QByteArray inOneProcess(const QString& input, const QStringList& options)
    {
        const bool made = run(QStringList{"build", input, "-o", "alone.tan"} + options).exitCode == 0;
        return made ? readFile(path("alone.tan")) : QByteArray();
    }

    /// An O-grid, whose blocks need cures on their faces.
    QByteArray rightGrid()
    {
        if (rightGrid_.isEmpty() &&
            runTan({"sample", "o-grid", "--size", "20", "-o", "grid.xyz"}, folder_.path()).exitCode == 0)
            rightGrid_ = inOneProcess("grid.xyz", gridOptions());
        return rightGrid_;
    }
    static QStringList gridOptions() { return {"--builder", "refinement", "--block", "6"}; }

    /// Whether a process on a part could be started; it is killed after so many milliseconds at the latest.
    bool killed(unsigned number, unsigned milliseconds, const QString& input = "data.nrrd", int count = 2) const
    {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), words(input, static_cast<int>(number), count));
        if (!process.waitForStarted())
            return false;
        if (!process.waitForFinished(static_cast<int>(milliseconds)))
            ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        return process.state() == QProcess::NotRunning || process.waitForFinished();
    }

    /// 14^3 numbers of 16 bits.
    template <class ValueAt>
    void writeNrrd(const QString& name, const char* order, const ValueAt& valueAt, const char* place = "") const
    {
        std::ofstream stream(path(name).toStdString(), std::ios::binary);
        stream << "NRRD0004\n##\ntype: uint16\ndimension: 3\nsizes: 14 14 14\nendian: " << order << "\nencoding: raw\n"
               << place << "\n";
        for (int i = 0; i < 14 * 14 * 14; ++i) {
            const unsigned value = valueAt(i);
            const char low = static_cast<char>(value), high = static_cast<char>(value >> 8);
            const bool isBig = std::string_view(order) == "big";
            stream.put(isBig ? high : low).put(isBig ? low : high);
        }
    }

    QTemporaryDir folder_;
    QByteArray right_; ///< of data.nrrd, in blocks of 7 cells
    QByteArray rightGrid_;
    Run run_;
    QByteArray told_;
};

QTEST_GUILESS_MAIN(PartsTest)
#include "parts_test.moc"
