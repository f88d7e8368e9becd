// SPDX-License-Identifier: GPL-3.0-or-later
/// A build that is killed at any moment and resumed gives the same model, byte for byte, and leaves nothing else
/// behind.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <random>

namespace tetra {

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
        for (int round = 0; round < 10; ++round)
            QTest::newRow(QByteArray::number(round).data()) << round;
    }
    void killedAtAnyMoment()
    {
        QFETCH(int, round);
        std::mt19937 random(static_cast<unsigned>(round) + 1);
        QVERIFY(QFile::remove(folder_.filePath("model.tan")));
        // One kill, or several in the same build.
        for (int kill = 0; kill <= round % 3; ++kill) {
            QProcess process;
            process.setWorkingDirectory(folder_.path());
            process.start(tanProgram(), kill == 0 ? buildWords() : buildWords() + QStringList{"--resume"});
            QVERIFY(process.waitForStarted());
            process.waitForFinished(static_cast<int>(random() % static_cast<unsigned>(usual_ + 1)));
            if (process.state() != QProcess::NotRunning)
                ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
            QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished());
        }
        const Run run = runTan(buildWords() + QStringList{"--resume"}, folder_.path());
        QVERIFY2(run.exitCode == 0, run.messages);
        QVERIFY(modelBytes() == right_);
        QCOMPARE(entries(), (QStringList{"data.nrrd", "model.tan"}));
    }

    /// A build from the beginning clears away what another one left.
    void leftoversAreRemoved()
    {
        QProcess process;
        process.setWorkingDirectory(folder_.path());
        process.start(tanProgram(), buildWords());
        QVERIFY(process.waitForStarted());
        QTRY_VERIFY(QDir(folder_.filePath("model.tan.work")).entryList({"*.run"}).size() > 3);
        ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
        QVERIFY(process.waitForFinished());
        QVERIFY(entries().contains("model.tan.work"));
        QVERIFY(runTan({"build", "data.nrrd", "-o", "model.tan", "--error", "20", "--block", "none"}, folder_.path())
                    .exitCode == 0);
        QCOMPARE(entries(), (QStringList{"data.nrrd", "model.tan"}));
    }

private:
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

} // namespace tetra

QTEST_GUILESS_MAIN(tetra::ResumeTest)
#include "resume_test.moc"
