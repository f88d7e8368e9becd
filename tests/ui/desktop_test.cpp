// SPDX-License-Identifier: GPL-3.0-or-later
/// The programs where no window can come up: they say so, and their help is there all the same. And a window that is
/// ended by a signal.
#include "tests/ui/sample_files.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

#include <sys/types.h>

using namespace tetra;

class DesktopTest : public QObject {
    Q_OBJECT

    /// Of a machine with a terminal only.
    static void startWithoutDisplay(QProcess& process, const QString& program, const QStringList& words)
    {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
            environment.remove(name);
        environment.insert("LC_ALL", "C.UTF-8");
        process.setProcessEnvironment(environment);
        process.start(QString(TAN_BINARY_DIR "/bin/") + program, words);
        QVERIFY(process.waitForFinished());
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    }

private slots:
    void withoutADisplayItSaysWhatWorks_data()
    {
        QTest::addColumn<QString>("program");
        QTest::addColumn<QStringList>("words");
        QTest::newRow("the window") << "tan-desktop" << QStringList();
        QTest::newRow("the window with a file") << "tan-desktop" << QStringList("model.tan");
        QTest::newRow("tan alone") << "tan" << QStringList();
    }
    void withoutADisplayItSaysWhatWorks()
    {
        QFETCH(const QString, program);
        QFETCH(const QStringList, words);
        QProcess process;
        startWithoutDisplay(process, program, words);
        QCOMPARE(process.exitCode(), 4);
        const QString text = QString::fromUtf8(process.readAllStandardError());
        QVERIFY2(text.contains("There is no display") && text.contains("tan render"), qPrintable(text));
    }

    void endingByASignalIsNoCrash_data()
    {
        QTest::addColumn<int>("number");
        QTest::newRow("kill, or the end of a desktop's session") << SIGTERM;
        QTest::newRow("Ctrl-C") << SIGINT;
        QTest::newRow("the terminal is closed") << SIGHUP;
    }
    /// It ends as it should, with all locks taken away.
    void endingByASignalIsNoCrash()
    {
        QFETCH(const int, number);
        const QTemporaryDir home;
        const auto model = buildSampleModel(*hostOfThisBuild(), sampleDataset(8), home.path().toStdString());
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("QT_QPA_PLATFORM", "offscreen");
        environment.insert("HOME", home.path());
        for (const char* name : {"XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME"})
            environment.insert(name, home.filePath(name));
        QProcess process;
        process.setProcessEnvironment(environment);
        process.start(TAN_BINARY_DIR "/bin/tan-desktop", {QString::fromStdString(model)});
        QVERIFY(process.waitForStarted());
        const auto settings = [&home] { // name the model as a recent file once it is open
            QFile file(home.filePath("XDG_CONFIG_HOME/TAn/TAn.conf"));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        QTRY_VERIFY_WITH_TIMEOUT(settings().contains("c60.tan"), 60'000);
        ::kill(static_cast<pid_t>(process.processId()), number);
        QVERIFY(process.waitForFinished(60'000));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(settings().contains("geometry"));
        QVERIFY(QDir(home.filePath("XDG_DATA_HOME/TAn/TAn/views")).entryList({"*.lock", "*.lost*"}).isEmpty());
    }

    void itsHelpNeedsNone()
    {
        QProcess process;
        startWithoutDisplay(process, "tan-desktop", {"--help"});
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(QString::fromUtf8(process.readAllStandardOutput()).contains("--backend"));
    }
};

QTEST_GUILESS_MAIN(DesktopTest)
#include "desktop_test.moc"
