// SPDX-License-Identifier: GPL-3.0-or-later
/// Little memory, few open files and threads, small files, readers that went away, closed streams: each is told as what
/// it is, with exit code 4, and leaves nothing.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/soak.h"
#include "tests/waiting.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>
#include <functional>
#include <optional>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace tetra;

namespace {

constexpr rlim_t noLimit = RLIM_INFINITY;
constexpr uid_t nobody = 54321; ///< a user who runs nothing else, so that his threads can be counted

using Environment = QMap<QString, QString>;

/// What a sanitizer does for itself under a limit is not the program's: here, a thread that looks for leaks.
Environment withoutThreadForLeaks()
{
    return {{"ASAN_OPTIONS", qEnvironmentVariable("ASAN_OPTIONS") + ":detect_leaks=0"}};
}

/// Here, a temporary file of the program's constants, which is left out where there is no folder for it.
Environment withoutTemporaryFiles()
{
    return isInstrumented ? Environment{{"TMPDIR", "/nonexistent"}} : Environment();
}

std::function<void()> limited(int resource, rlim_t most)
{
    return [resource, most] {
        const rlimit limit{most, most};
        setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
    };
}

/// Standard output, or it and standard error, becomes a pipe whose reader has gone.
void loseReader(bool errorsToo)
{
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0)
        _exit(99);
    dup2(ends[1], STDOUT_FILENO);
    if (errorsToo)
        dup2(ends[1], STDERR_FILENO);
    close(ends[0]);
    close(ends[1]);
    signal(SIGPIPE, SIG_DFL); // as a shell starts it
}

} // namespace

class LimitsTest : public QObject {
    Q_OBJECT

private:
    QStringList files() const { return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden); }
    void addCommands(const std::function<void(const char* name, const QStringList& words)>& add) const;
    void addAllCommands() const
    {
        QTest::addColumn<QStringList>("words");
        addCommands([](const char* name, const QStringList& words) { QTest::newRow(name) << words; });
    }
    enum class Outcome { Done, NotLoaded, Refused };
    Outcome outcomeOf(const QStringList& words, const std::function<void()>& prepare, const QByteArrayList& reasons,
                      rlim_t limit, const Environment& environment = {});

    /// What it takes to load the program, which differs from system to system. Libraries that begin before the program
    /// does may crash with little more, or wait forever: glib, which cannot print that there is no memory, calls itself
    /// until the stack is full, or meets its own lock. One mebibyte lies between, as addresses are random.
    rlim_t leastMebibytes() const
    {
        constexpr unsigned mostSeconds = 10;
        const auto leastFor = [this](const auto& suffices) {
            rlim_t tooLittle = 16, enough = 1024;
            while (enough - tooLittle > 1) {
                const rlim_t tried = (tooLittle + enough) / 2;
                const Run run = runTan({"--version"}, folder_.path(), {}, [tried] {
                    limited(RLIMIT_AS, tried << 20)();
                    alarm(mostSeconds);
                });
                (suffices(run.exitCode) ? enough : tooLittle) = tried;
            }
            return enough;
        };
        static const rlim_t loaded = leastFor([](int exitCode) { return exitCode != 127; });
        static const rlim_t begun = leastFor([](int exitCode) { return exitCode == 0 || exitCode == 4; });
        return std::min(begun, loaded + 1) + 1; // what crashes with more is the program
    }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QVERIFY(runTan({"sample", "noise", "--size", "24", "-o", "noise.nrrd"}, folder_.path()).exitCode == 0);
        const Run build = runTan({"build", "noise.nrrd", "-o", "noise.tan"}, folder_.path());
        QVERIFY2(build.exitCode == 0, build.messages);
        QVERIFY(writeFile(folder_.filePath("view.json"), "{}"));
    }

    void aLimitOfTheFileSize_data()
    {
        QTest::addColumn<QStringList>("words");
        addCommands([](const char* name, const QStringList& words) {
            if (words.contains("-o"))
                QTest::newRow(name) << words;
        });
    }
    void aLimitOfTheFileSize()
    {
        QFETCH(QStringList, words);
        for (const rlim_t most : {rlim_t(0), rlim_t(100)})
            QVERIFY(outcomeOf(words, limited(RLIMIT_FSIZE, most), {"File too large"}, most, withoutTemporaryFiles()) ==
                    Outcome::Refused);
    }

    void aReaderThatWentAway_data()
    {
        QTest::addColumn<bool>("errorsToo");
        QTest::newRow("of the figures") << false;
        QTest::newRow("of everything") << true;
    }
    void aReaderThatWentAway()
    {
        QFETCH(bool, errorsToo);
        const QStringList before = files();
        const auto prepare = [errorsToo] { loseReader(errorsToo); };
        const Run info = runTan({"info", "noise.tan"}, folder_.path(), {}, prepare);
        QCOMPARE(info.exitCode, 4);
        QCOMPARE(info.messages, QByteArray());
        const Run wrong = runTan({"info", "nowhere.tan"}, folder_.path(), {}, prepare);
        QCOMPARE(wrong.exitCode, 3);
        const Run build = runTan({"build", "noise.nrrd", "--error", "1", "-o", "new.tan"}, folder_.path(), {}, prepare);
        QCOMPARE(build.exitCode, 4);
        QCOMPARE(runTan({"info", "new.tan"}, folder_.path()).exitCode, 0); // the work was done all the same
        QVERIFY(QFile::remove(folder_.filePath("new.tan")));
        QCOMPARE(files(), before);
    }

    void fewOpenFiles_data() { addAllCommands(); }
    void fewOpenFiles()
    {
        if (isAddressSanitized)
            QSKIP("skipped: a sanitizer looks at memory through a pipe, which needs descriptors too");
        QFETCH(QStringList, words);
        int refused = 0;
        std::optional<Outcome> fewest; // with the fewest files that suffice to load the program
        // One by one where the least that a command needs lies: a test inherits a descriptor or two from who starts it.
        for (rlim_t most = 4; most < 12; most += most < 7 ? rlim_t(1) : timesOf(rlim_t(2), rlim_t(1))) {
            const Outcome outcome = outcomeOf(words, limited(RLIMIT_NOFILE, most), {"oo many open files"}, most);
            refused += outcome == Outcome::Refused;
            if (!fewest && outcome != Outcome::NotLoaded)
                fewest = outcome;
        }
        // A command that opens no more at a time than its loading does is never refused.
        QVERIFY(refused > 0 || fewest == Outcome::Done || QTest::currentTestFailed());
    }

    /// More blocks than there may be open files.
    void manyBlocksNeedFewOpenFiles()
    {
        const Run run = runTan({"build", "noise.nrrd", "--block", "4", "--threads", "2", "-o", "blocks.tan"},
                               folder_.path(), {}, limited(RLIMIT_NOFILE, 24));
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(QFile::remove(folder_.filePath("blocks.tan")));
    }

    void littleMemory_data() { addAllCommands(); }
    void littleMemory()
    {
        if (isInstrumented)
            QSKIP("skipped: a sanitizer needs more address space than any limit");
        QFETCH(QStringList, words);
        const rlim_t least = leastMebibytes();
        int refused = 0;
        for (rlim_t more = 0; more <= 60; more += timesOf<rlim_t>(20, 5))
            refused += outcomeOf(words, limited(RLIMIT_AS, (least + more) << 20), {"emory", "threads", "unavailable"},
                                 least + more) == Outcome::Refused;
        QVERIFY(refused > 0 || QTest::currentTestFailed());
    }

    void fewThreads_data() { addAllCommands(); }
    void fewThreads()
    {
        if (geteuid() != 0)
            QSKIP("skipped: only root can become a user whose threads are known");
        QFETCH(QStringList, words);
        QVERIFY(QFile(folder_.path()).setPermissions(QFile::Permissions(0x7777)));
        const auto asNobody = [](rlim_t most) {
            return [most] {
                limited(RLIMIT_NPROC, most)();
                if (setgid(nobody) != 0 || setuid(nobody) != 0)
                    _exit(99);
            };
        };
        if (runTan({"--version"}, folder_.path(), withoutThreadForLeaks(), asNobody(noLimit)).exitCode != 0)
            QSKIP("skipped: other users may not start the program here");
        int refused = 0;
        for (rlim_t most = 1; most <= 3; ++most) // the first thread, the one for signals, one for the work
            refused += outcomeOf(words, asNobody(most), {"threads", "unavailable"}, most, withoutThreadForLeaks()) ==
                       Outcome::Refused;
        QVERIFY(refused > 0 || QTest::currentTestFailed());
    }

    /// A file that took the place of standard error would get the messages.
    void closedStreamsAreNotTakenForFiles()
    {
        const QStringList before = files();
        QVERIFY(runTan({"sample", "noise", "--size", "96", "-o", "large.nrrd"}, folder_.path()).exitCode == 0);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.setChildProcessModifier([] {
            for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
                close(descriptor);
        });
        process.start(tanProgram(), {"build", "large.nrrd", "-o", "large.tan"});
        QVERIFY(process.waitForStarted());
        const QDir work(folder_.filePath("large.tan.work"));
        QTRY_VERIFY_WITH_TIMEOUT(!work.entryList({"*.partial"}, QDir::Files | QDir::Hidden).isEmpty(), 60'000);
        for (const char* descriptor : {"0", "1", "2"})
            QCOMPARE(QFile::symLinkTarget(QString("/proc/%1/fd/%2").arg(process.processId()).arg(descriptor)),
                     QString("/dev/null"));
        process.terminate();
        QVERIFY(process.waitForFinished(60'000));
        QVERIFY(QFile::remove(folder_.filePath("large.nrrd")));
        QCOMPARE(files(), before);
    }

    /// A long list of values, as a script makes it.
    void surfacesThatDoNotFitIntoMemory()
    {
        if (isInstrumented)
            QSKIP("skipped: a sanitizer needs more address space than any limit");
        QStringList values;
        for (int value = 0; value < 10'000; ++value)
            values.append(QString::number(100 + value / 1000.));
        const Run run = runTan({"isosurface", "noise.tan", "--value", values.join(','), "-o", "many.ply"},
                               folder_.path(), {}, limited(RLIMIT_AS, rlim_t(512) << 20));
        QVERIFY2(run.exitCode == 4, run.messages);
        QVERIFY2(run.messages.contains("10000 of them") && run.messages.contains("fewer values"), run.messages);
        QVERIFY(!QFile::exists(folder_.filePath("many.ply")));
    }
};

/// Runs a command under a limit: it is done, or the system cannot load it, or it fails with exit code 4 for one of
/// these reasons, says what to do, and leaves nothing. Anything else fails the test.
LimitsTest::Outcome LimitsTest::outcomeOf(const QStringList& words, const std::function<void()>& prepare,
                                          const QByteArrayList& reasons, rlim_t limit, const Environment& environment)
{
    const QStringList before = files();
    const Run run = runTan(words, folder_.path(), environment, prepare);
    QStringList made = files();
    made.removeIf([&](const QString& name) { return before.contains(name); });
    for (const QString& name : made)
        if (!QDir(folder_.path()).rmdir(name))
            QFile::remove(folder_.filePath(name));
    const bool isDone = run.exitCode == 0;
    const bool isNotLoaded = run.exitCode == 127 && run.messages.contains("shared librar"); // the system's own words
    const auto isSaid = [&](const QByteArray& reason) { return run.messages.contains(reason); };
    const bool isTold =
        run.exitCode == 4 && run.messages.contains("tan: ") && std::ranges::any_of(reasons, isSaid) &&
        (run.messages.contains("ulimit") || run.messages.contains("Close other programs") ||
         run.messages.contains("Choose ") || run.messages.contains("Ask for") || run.messages.contains("Show fewer") ||
         run.messages.contains("Take a region") || run.messages.contains("Make the picture smaller"));
    const bool isTidy = isDone || made.isEmpty();
    const QString said = QString("under %1: exit code %2, %3 left, %4");
    if (!isTidy || (!isDone && !isNotLoaded && !isTold))
        QTest::qFail(qPrintable(said.arg(limit).arg(run.exitCode).arg(made.join(' '), run.messages)), __FILE__,
                     __LINE__);
    return isDone ? Outcome::Done : isNotLoaded ? Outcome::NotLoaded : Outcome::Refused;
}

void LimitsTest::addCommands(const std::function<void(const char* name, const QStringList& words)>& add) const
{
    add("info of a dataset", {"info", "noise.nrrd"});
    add("info of a model", {"info", "noise.tan"});
    add("info into a file", {"info", "noise.tan", "-o", "levels.csv"});
    add("sample", {"sample", "noise", "--size", "16", "-o", "small.nrrd"});
    add("build", {"build", "noise.nrrd", "--block", "none", "-o", "out.tan"});
    add("build in blocks", {"build", "noise.nrrd", "--block", "8", "-o", "out.tan"});
    add("build by decimation", {"build", "noise.nrrd", "--builder", "decimation", "--error", "5", "-o", "out.tan"});
    add("verify", {"verify", "noise.tan", "--against", "noise.nrrd", "--lod", "5"});
    add("extract", {"extract", "noise.tan", "-o", "mesh.vtu"});
    add("isosurface", {"isosurface", "noise.tan", "--value", "128", "-o", "surface.ply"});
    add("render", {"render", "noise.tan", "--size", "99x99", "-o", "picture.png"});
    add("render a volume", {"render", "noise.tan", "--mode", "volume", "--size", "99x99", "-o", "picture.png"});
}

QTEST_GUILESS_MAIN(LimitsTest)
#include "limits_test.moc"
