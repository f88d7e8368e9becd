// SPDX-License-Identifier: GPL-3.0-or-later
/// Models of the earlier versions of the format, as the commands meet them: described, proved against their data,
/// extracted and drawn, and never written to. What they hold, tests/core/history/old_files_test.cpp shows.
#include "tests/app/program.h"
#include "tests/app/sample_files.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

const QString oldModelsFolder = TAN_SOURCE_DIR "/tests/core/history/old_files";
const QString oldSessionsFolder = TAN_SOURCE_DIR "/tests/ui/old_sessions";

} // namespace

class OldModelsTest : public QObject {
    Q_OBJECT

private:
    /// Another folder for each model, which holds nothing else.
    QString folderWith(const QString& model)
    {
        const QString folder = folder_.filePath(QString(model).replace('/', '-'));
        QDir().mkpath(folder);
        QFile::copy(oldModelsFolder + "/" + model + ".tan", folder + "/m.tan");
        return folder;
    }
    /// What it was built from, in a form that needs no VTK.
    static QString dataOf(const Run& info)
    {
        const QDir data(oldModelsFolder + "/data");
        const QString source = info.json()["source"].toString().section('.', 0, 0);
        for (const QString& name : data.entryList({source + ".*"}, QDir::Files))
            if (!name.endsWith(".q"))
                return data.filePath(name);
        return {};
    }

    QTemporaryDir folder_;

private slots:
    void commandsTakeThem_data()
    {
        QTest::addColumn<QString>("model");
        QDirIterator files(oldModelsFolder, {"*.tan"}, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString model = QDir(oldModelsFolder).relativeFilePath(files.next()).chopped(4);
            QTest::newRow(qPrintable(model)) << model;
        }
    }
    void commandsTakeThem()
    {
        QFETCH(QString, model);
        const QString folder = folderWith(model);
        const QByteArray before = readFile(folder + "/m.tan");
        const Run info = runTan({"info", "m.tan", "--lod", "10,4,1,0.1,0", "--json"}, folder);
        QVERIFY2(info.exitCode == 0, info.messages);
        const Run verify =
            runTan({"verify", "m.tan", "--against", dataOf(info), "--lod", "10,4,1,0.1,0", "--json"}, folder);
        const QJsonArray said = info.json()["levels"].toArray(), proved = verify.json()["levels"].toArray();
        const QList<QByteArray> recorded = readFile(oldModelsFolder + "/" + model + ".csv").split('\n');
        QCOMPARE(said.size(), 5);
        QCOMPARE(proved.size(), 5);
        for (qsizetype level = 0; level < 5; ++level) {
            const QList<QByteArray> words = recorded[level + 1].split(',');
            QCOMPARE(said[level]["sites"].toInt(), words[2].toInt());
            QCOMPARE(said[level]["tetrahedra"].toInt(), words[3].toInt());
            QCOMPARE(proved[level]["sites"].toInt(), words[2].toInt());
            QCOMPARE(proved[level]["tetrahedra"].toInt(), words[3].toInt());
            QVERIFY2(proved[level]["ok"].toBool(), verify.output);
            QVERIFY(proved[level]["largest_error"].toDouble() <= words[4].toDouble() * (1 + 1e-6));
        }
        // The cells are the same in another order, which their checksum tells.
        const QJsonArray failures = verify.json()["failures"].toArray();
        if (model == "1_2/irregular") {
            QCOMPARE(failures.size(), 1);
            QVERIFY2(failures[0].toString().startsWith("The model was built from other samples"), verify.output);
        } else {
            QVERIFY2(failures.isEmpty(), verify.output);
            QCOMPARE(verify.exitCode, 0);
        }
        const QString other = dataOf(info).endsWith("few.csv") ? "/data/points.csv" : "/data/few.csv";
        const Run wrong = runTan({"verify", "m.tan", "--against", oldModelsFolder + other, "--json"}, folder);
        QVERIFY2(wrong.exitCode == 1 && !wrong.json()["failures"].toArray().isEmpty(), wrong.messages);

        const Run extract = runTan({"extract", "m.tan", "--error", "1", "-o", "mesh.vtu"}, folder);
        QVERIFY2(extract.exitCode == 0, extract.messages);
        const Run render = runTan({"render", "m.tan", "--error", "1", "--size", "60x40", "-o", "picture.png"}, folder);
        QVERIFY2(render.exitCode == 0, render.messages);
        QCOMPARE(QDir(folder).entryList(QDir::Files | QDir::Hidden), (QStringList{"m.tan", "mesh.vtu", "picture.png"}));
        QVERIFY(readFile(folder + "/m.tan") == before);
    }

    void sessionsOfTheirTimeAreDrawn_data()
    {
        QTest::addColumn<QString>("session");
        for (const QString& name : QDir(oldSessionsFolder).entryList({"*.tansession"}, QDir::Files))
            QTest::newRow(qPrintable(name)) << name;
        QCOMPARE(QDir(oldSessionsFolder).entryList({"*.tansession"}, QDir::Files).size(), 3);
    }
    /// The sessions' test shows that they are read to the letter (tests/ui/old_sessions_test.cpp).
    void sessionsOfTheirTimeAreDrawn()
    {
        QFETCH(QString, session);
        const QTemporaryDir folder;
        QVERIFY(QFile::copy(oldModelsFolder + "/1_1/lattice.tan", folder.filePath("lattice.tan")));
        QVERIFY(QFile::copy(oldSessionsFolder + "/" + session, folder.filePath(session)));
        const Run render = runTan({"render", session, "--size", "60x40", "-o", "picture.png", "--json"}, folder.path());
        QVERIFY2(render.exitCode == 0, render.messages);
        QVERIFY(readFile(folder.filePath("picture.png")).size() > 100);
        QVERIFY(readFile(folder.filePath(session)) == readFile(oldSessionsFolder + "/" + session));
    }
};

QTEST_GUILESS_MAIN(OldModelsTest)
#include "old_models_test.moc"
