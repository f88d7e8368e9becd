// SPDX-License-Identifier: GPL-3.0-or-later
// What a test lacks is told to ctest: it is skipped, or it fails where nothing may be skipped; never passed.
#include "tests/lacks.h"

#include <QProcess>
#include <QTest>

namespace {

constexpr const char* lackingProgram = "TAN_TEST_LACKS"; ///< set in the program that lacks something

} // namespace

class LacksTest : public QObject {
    Q_OBJECT

private slots:
    void lackIsTold_data()
    {
        QTest::addColumn<QString>("function");
        QTest::addColumn<QString>("maySkip");
        QTest::addColumn<int>("exitCode");
        QTest::addColumn<QByteArray>("said");
        const QByteArray what = "lack of: data, unicorns";
        QTest::newRow("may") << "lacking"
                             << "1" << 77 << "Skipped in part, for " + what;
        QTest::newRow("may not") << "lacking"
                                 << "0" << 1 << "Failed, as nothing may be skipped, for " + what;
        QTest::newRow("fails besides") << "lackingAndFailing"
                                       << "1" << 1 << QByteArray("FAIL!");
        QTest::newRow("lacks nothing") << "lackingNothing"
                                       << "0" << 0 << QByteArray("1 skipped");
    }
    void lackIsTold()
    {
        QFETCH(QString, function);
        QFETCH(QString, maySkip);
        QFETCH(QByteArray, said);
        QProcess program;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("TAN_MAY_SKIP", maySkip);
        environment.insert(lackingProgram, "1");
        program.setProcessEnvironment(environment);
        program.start(QCoreApplication::applicationFilePath(), {"lacks", function});
        QVERIFY(program.waitForFinished(60'000));
        const QByteArray output = program.readAllStandardOutput();
        QVERIFY2(output.contains(said), output);
        QTEST(program.exitCode(), "exitCode");
    }

    void lacking_data()
    {
        QTest::addColumn<bool>("isData");
        QTest::newRow("data") << true;
        QTest::newRow("unicorns") << false;
    }
    void lacking()
    {
        if (!qEnvironmentVariableIsSet(lackingProgram))
            return;
        QFETCH(bool, isData);
        if (isData)
            QSKIP_WITHOUT("data");
        QSKIP_WITHOUT("unicorns");
    }
    void lackingAndFailing()
    {
        if (!qEnvironmentVariableIsSet(lackingProgram))
            return;
        tetra::noteLack("data");
        QFAIL("as it should");
    }
    void lackingNothing()
    {
        if (qEnvironmentVariableIsSet(lackingProgram))
            QSKIP("skipped: another user could");
    }
};

QTEST_GUILESS_MAIN(LacksTest)
#include "lacks_test.moc"
