// SPDX-License-Identifier: GPL-3.0-or-later
/// A build that is killed at any moment and resumed gives the same model, byte for byte, and leaves nothing else
/// behind.
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
#include <random>

using namespace tetra;

class ResumeTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(runTan({"sample", "marschner-lobb", "--size", "44", "-o", "data.nrrd"}, folder_.path()).exitCode == 0);
        QElapsedTimer timer;
        timer.start();
        const Run run = runTan(buildWords(), folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        usual_ = timer.elapsed();
        right_ = modelBytes();
        QVERIFY(right_.size() > 1'000'000);
    }

    void killedAtAnyMoment_data()
    {
        QTest::addColumn<int>("round");
        for (int round = 0; round < timesOf(2, 10); ++round)
            QTest::newRow(QByteArray::number(round).data()) << round;
    }
    void killedAtAnyMoment()
    {
        QFETCH(int, round);
        std::mt19937 random(seedOf(static_cast<unsigned>(round) + 1));
        QVERIFY(QFile::remove(folder_.filePath("model.tan")));
        // One kill, or several in the same build.
        for (int kill = 0; kill <= round % 3; ++kill)
            QVERIFY(killed(kill == 0 ? buildWords() : buildWords() + QStringList{"--resume"},
                           [&](QProcess& process) { waitAtMost(process, random, usual_); }));
        const Run run = runTan(buildWords() + QStringList{"--resume"}, folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(modelBytes() == right_);
        QCOMPARE(entries(), (QStringList{"data.nrrd", "model.tan"}));
    }

    /// A build from the beginning clears away what another one left.
    void leftoversAreRemoved()
    {
        QVERIFY(killed(buildWords(), [&](QProcess&) {
            QTRY_VERIFY(QFileInfo(folder_.filePath("model.tan.work/blocks.runs")).size() > right_.size() / 8);
        }));
        QVERIFY(entries().contains("model.tan.work"));
        QVERIFY(runTan({"build", "data.nrrd", "-o", "model.tan", "--error", "20", "--block", "none"}, folder_.path())
                    .exitCode == 0);
        QCOMPARE(entries(), (QStringList{"data.nrrd", "model.tan"}));
    }

    /// B6: whatever the builder and the data. What is left is not taken for that of another build.
    void everyBuilderGoesOn_data()
    {
        QTest::addColumn<QStringList>("sample");
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("options");
        const QStringList decimate = {"--builder", "decimation"}, refine = {"--builder", "refinement"};
        const auto row = [](const char* name, const char* sample, int size, const char* input,
                            const QStringList& options) {
            QTest::newRow(name) << QStringList{"sample", sample, "--size", QString::number(size), "-o", input}
                                << QString(input) << options;
        };
        row("decimated lattice", "marschner-lobb", 48, "lattice.nrrd", decimate);
        row("decimated grid", "blunt-body", 32, "grid.xyz", decimate);
        row("decimated points", "scattered", 26, "points.csv", decimate);
        row("decimated mesh", "part", 100, "mesh.vtu", decimate);
        row("refined points", "scattered", 34, "points.csv", refine);
        row("refined rectilinear grid", "stretched", 30, "box.xyz", refine);
        row("refined lattice", "marschner-lobb", 72, "lattice.nrrd", refine + QStringList{"--block", "none"});
    }
    void everyBuilderGoesOn()
    {
        constexpr qsizetype sizeWord = 3;
        QFETCH(QStringList, sample);
        QFETCH(QString, input);
        QFETCH(QStringList, options);
        const QStringList words = QStringList{"build", input, "-o", "model.tan"} + options;
        const QStringList again = words + QStringList{"--resume"};
        const QString state = folder_.filePath("model.tan.work/state");
        qint64 usual = 0;
        QByteArray right;
        // A quick machine is done before anything is kept: it gets more data.
        for (int tries = 0; tries < 6 && !QFile::exists(state); ++tries) {
            if (tries > 0)
                sample[sizeWord] = QString::number(sample[sizeWord].toInt() * 5 / 4);
            QFile::remove(folder_.filePath("model.tan"));
            QVERIFY(runTan(sample, folder_.path()).exitCode == 0);
            QElapsedTimer timer;
            timer.start();
            QVERIFY(runTan(words, folder_.path()).exitCode == 0);
            usual = timer.elapsed();
            right = modelBytes();
            QVERIFY(QFile::remove(folder_.filePath("model.tan")));
            QVERIFY(killed(again, [&](QProcess& process) {
                QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(state) || process.state() == QProcess::NotRunning, 60'000);
            }));
        }
        QVERIFY2(QFile::exists(state), "the build was over before anything of it was kept");
        const Run other = runTan(again + QStringList{"--error", "15"}, folder_.path());
        QCOMPARE(other.exitCode, 2);
        QVERIFY2(other.messages.contains("another version of TAn"), other.messages);
        const QByteArray whole = readFile(state);
        QVERIFY(QFile::resize(state, whole.size() / 2));
        const Run damaged = runTan(again, folder_.path());
        QVERIFY2(damaged.exitCode != 0 && damaged.messages.contains("is damaged"), damaged.messages);
        QFile file(state);
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(whole) == whole.size());
        file.close();

        std::mt19937 random(seedOf(static_cast<unsigned>(sample.last().size())));
        const auto wait = [&](QProcess& process) { waitAtMost(process, random, usual); };
        QVERIFY(killed(again, wait));
        QVERIFY(killed(again + QStringList{"--keep"}, wait, SIGINT)); // there may be a model then, and the rest as well
        const Run run = runTan(again, folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(modelBytes() == right);
        QVERIFY(!entries().contains("model.tan.work"));
    }

private:
    /// Whether a program of these words could be started; wait(process) says when it is killed.
    template <class Wait> bool killed(const QStringList& words, const Wait& wait, int signal = SIGKILL) const
    {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), words);
        if (!process.waitForStarted())
            return false;
        wait(process);
        if (process.state() != QProcess::NotRunning)
            ::kill(static_cast<pid_t>(process.processId()), signal);
        return process.state() == QProcess::NotRunning || process.waitForFinished();
    }
    static void waitAtMost(QProcess& process, std::mt19937& random, qint64 milliseconds)
    {
        process.waitForFinished(static_cast<int>(random() % static_cast<unsigned>(milliseconds + 1)));
    }

    static QStringList buildWords() { return {"build", "data.nrrd", "-o", "model.tan", "--block", "6"}; }
    QByteArray modelBytes() const { return readFile(folder_.filePath("model.tan")); }
    QStringList entries() const
    {
        return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }

    QTemporaryDir folder_;
    QByteArray right_;
    qint64 usual_ = 0; ///< milliseconds that an undisturbed build takes
};

QTEST_GUILESS_MAIN(ResumeTest)
#include "resume_test.moc"
