// SPDX-License-Identifier: GPL-3.0-or-later
/// Ctrl-C ends long work cleanly within a second; a file that is cut while it is mapped is an error and no crash.
#include "app/command_line/command_line.h"
#include "tests/app/program.h"
#include "tests/app/sample_files.h"
#include "tests/soak.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <filesystem>
#include <functional>
#include <sstream>

using namespace tetra;

namespace {

/// A second is promised; other tests may keep the machine busy meanwhile. The build would take far longer.
constexpr qint64 promptMilliseconds = 3000;

/// A stream that calls a function before its first character.
class CallingBuffer : public std::stringbuf {
public:
    explicit CallingBuffer(std::function<void()> call) : call_(std::move(call)) {}

protected:
    std::streamsize xsputn(const char* text, std::streamsize count) override
    {
        if (call_)
            std::exchange(call_, nullptr)();
        return std::stringbuf::xsputn(text, count);
    }

private:
    std::function<void()> call_;
};

} // namespace

class InterruptionTest : public QObject {
    Q_OBJECT

private:
    QTemporaryDir folder_;

    /// Of the file that a build is writing.
    qint64 unfinishedBytes() const
    {
        const auto files =
            QDir(folder_.filePath("kept.tan.work")).entryInfoList({"*.partial"}, QDir::Files | QDir::Hidden);
        return files.isEmpty() ? 0 : files.front().size();
    }

private slots:
    void initTestCase()
    {
        QVERIFY(runTan({"sample", "noise", "--size", "128", "-o", "noise.nrrd"}, folder_.path()).exitCode == 0);
    }

    void endsABuildCleanly_data()
    {
        QTest::addColumn<int>("signal");
        QTest::addColumn<QString>("block");
        QTest::newRow("Ctrl-C") << SIGINT << "none";
        QTest::newRow("kill") << SIGTERM << "none";
        QTest::newRow("Ctrl-C, in blocks") << SIGINT << "32";
    }
    void endsABuildCleanly()
    {
        QFETCH(int, signal);
        QFETCH(QString, block);
        const QStringList before = QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden);
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), {"build", "noise.nrrd", "--block", block, "-o", "noise.tan"});
        QVERIFY(process.waitForStarted());
        // Once its unfinished file is there, the build itself is running.
        QTRY_VERIFY_WITH_TIMEOUT(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden) != before, 60'000);
        QElapsedTimer timer;
        timer.start();
        ::kill(static_cast<pid_t>(process.processId()), signal);
        QVERIFY(process.waitForFinished(60'000));
        const qint64 took = timer.elapsed();
        const Run run = collect(process);
        QVERIFY2(run.exitCode == 130, run.messages);
        QVERIFY2(run.messages.contains("cancelled"), run.messages);
        QVERIFY2(took < soon(promptMilliseconds * TAN_TEST_SLOWNESS), QByteArray::number(took) + " ms");
        QCOMPARE(QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden), before);
    }

    void keepsWhatIsFinishedIfAsked_data()
    {
        QTest::addColumn<QString>("block");
        QTest::newRow("as a whole") << "none";
        QTest::newRow("in blocks, B8") << "16";
    }
    void keepsWhatIsFinishedIfAsked()
    {
        QFETCH(QString, block);
        QFile::remove(folder_.filePath("kept.tan")); // of the row before
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), {"build", "noise.nrrd", "--keep", "--block", block, "-o", "kept.tan", "--json"});
        QVERIFY(process.waitForStarted());
        // A mesh of known error is on the disk.
        if (block == "none")
            QTRY_VERIFY_WITH_TIMEOUT(unfinishedBytes() > 1'000'000, 60'000);
        else
            QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(folder_.filePath("kept.tan.work/blocks.runs")), 60'000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        const Run run = collect(process);
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(run.json()["stopped_early"].toBool());
        const Run verified = runTan({"verify", "kept.tan", "--against", "noise.nrrd", "--lod", "90"}, folder_.path());
        QVERIFY2(verified.exitCode == 0, verified.output + verified.messages);
    }

    void saysHowToGoOn()
    {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), {"build", "noise.nrrd", "--resume", "--block", "none", "-o", "kept.tan"});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(unfinishedBytes() > 1'000'000, 60'000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        const Run run = collect(process);
        QCOMPARE(run.exitCode, 130);
        QVERIFY2(run.messages.contains("is kept in 'kept.tan.work': the same command continues from there."),
                 run.messages);
        QVERIFY(QDir(folder_.filePath("kept.tan.work")).removeRecursively());
    }

    /// What another build left is not thrown away for a new one unasked, in blocks or not.
    void resumesNoOtherBuild_data()
    {
        QTest::addColumn<QStringList>("begun");
        QTest::addColumn<QStringList>("other");
        const QStringList whole = {"--block", "none"}, blocks = {"--block", "16"};
        QTest::newRow("as a whole") << whole << whole + QStringList{"--error", "3"};
        QTest::newRow("in blocks") << blocks << blocks + QStringList{"--error", "3"};
        QTest::newRow("blocks of another size") << blocks << QStringList{"--block", "8"};
        QTest::newRow("as a whole after blocks") << blocks << whole;
    }
    void resumesNoOtherBuild()
    {
        QFETCH(QStringList, begun);
        QFETCH(QStringList, other);
        const QString folder = folder_.filePath("kept.tan.work");
        const QStringList build = {"build", "noise.nrrd", "--resume", "-o", "kept.tan"};
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), build + begun);
        QVERIFY(process.waitForStarted());
        if (begun.contains("none"))
            QTRY_VERIFY_WITH_TIMEOUT(unfinishedBytes() > 1'000'000, 60'000);
        else
            QTRY_VERIFY_WITH_TIMEOUT(QFileInfo(folder + "/blocks.runs").size() > 1000, 60'000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(collect(process).exitCode, 130);
        const QStringList before = QDir(folder).entryList();
        const Run run = runTan(build + other, folder_.path());
        QVERIFY2(run.exitCode == 2, run.messages);
        QVERIFY2(run.messages.contains("belongs to other data, other options, or another version of TAn"),
                 run.messages);
        QCOMPARE(QDir(folder).entryList(), before);
        QVERIFY(QDir(folder).removeRecursively());
    }

    /// What is kept lies beside a finished model, which stays as it is.
    void keepsBesideAFinishedModel()
    {
        QVERIFY(runTan({"sample", "c60", "--size", "12", "-o", "c60.nrrd"}, folder_.path()).exitCode == 0);
        QVERIFY(runTan({"build", "c60.nrrd", "-o", "kept.tan"}, folder_.path()).exitCode == 0);
        const auto content = [&] {
            QFile file(folder_.filePath("kept.tan"));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = content();
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), {"build", "noise.nrrd", "--keep", "--block", "none", "-o", "kept.tan", "--json"});
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(unfinishedBytes() > 1'000'000, 60'000);
        ::kill(static_cast<pid_t>(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(60'000));
        const Run run = collect(process);
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(content() == before);
        const QString kept = run.json()["model"].toString();
        QVERIFY2(kept.startsWith("kept-") && kept.endsWith("-percent.tan"), qPrintable(kept));
        const Run told = runTan({"info", kept}, folder_.path());
        QVERIFY2(told.exitCode == 0, told.messages);
        QVERIFY(QFile::remove(folder_.filePath("kept.tan")));
    }

    void aModelCutWhileMappedIsAnError()
    {
        const QString model = folder_.filePath("cut.tan");
        QVERIFY(runTan({"sample", "noise", "--size", "20", "-o", "small.nrrd"}, folder_.path()).exitCode == 0);
        QVERIFY(runTan({"build", "small.nrrd", "-o", model}, folder_.path()).exitCode == 0);

        // The first progress that is drawn comes after the model was mapped, and before it was read.
        CallingBuffer buffer([&] { std::filesystem::resize_file(model.toStdString(), 4096); });
        std::ostream messages(&buffer);
        std::ostringstream output;
        const auto host = PluginHost::standard();
        const std::vector<std::string> words = {"verify", model.toStdString(), "--against",
                                                folder_.filePath("small.nrrd").toStdString()};
        const int code = runCommandLine(words, *host, {output, messages, true}, {});
        const std::string said = buffer.str();
        QVERIFY2(code == 3, said.c_str());
        QVERIFY2(said.find("cut short") != std::string::npos, said.c_str());
    }

    void aSecondRequestIsNotNeededInProcess()
    {
        std::stop_source stop;
        stop.request_stop();
        std::ostringstream output;
        std::ostringstream messages;
        const auto host = PluginHost::standard();
        const std::vector<std::string> words = {"build", folder_.filePath("noise.nrrd").toStdString(), "-o",
                                                folder_.filePath("never.tan").toStdString()};
        QCOMPARE(runCommandLine(words, *host, {output, messages}, stop.get_token()), 130);
        QVERIFY(!QFile::exists(folder_.filePath("never.tan")));
    }
};

QTEST_GUILESS_MAIN(InterruptionTest)
#include "interruption_test.moc"
