// SPDX-License-Identifier: GPL-3.0-or-later
/// The programs where no window can come up: they say so, and their help is there all the same.
#include <QProcess>
#include <QTest>

namespace tetra {

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

    void itsHelpNeedsNone()
    {
        QProcess process;
        startWithoutDisplay(process, "tan-desktop", {"--help"});
        QCOMPARE(process.exitCode(), 0);
        QVERIFY(QString::fromUtf8(process.readAllStandardOutput()).contains("--backend"));
    }
};

} // namespace tetra

QTEST_GUILESS_MAIN(tetra::DesktopTest)
#include "desktop_test.moc"
