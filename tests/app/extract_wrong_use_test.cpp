// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan extract`, and `tan verify` of such meshes, refuse what makes no sense, with a text and without a file.
#include "tests/app/program.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class ExtractWrongUseTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }
    QString path(const QString& name) const { return folder_.filePath(name); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QVERIFY(tan({"sample", "c60", "--size", "16", "-o", "c60.nrrd"}).exitCode == 0);
        QVERIFY(tan({"build", "c60.nrrd", "-o", "c60.tan"}).exitCode == 0);
    }

    void wrongUseIsRefused_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("part");
        QTest::addColumn<bool>("alsoVerify");
        const QStringList focus = {"--focus", "sphere:8,8,8,3", "--focus-error", "0.5"};
        const auto row = [](const char* name, const QStringList& options, const char* part, bool alsoVerify = true) {
            QTest::newRow(name) << options << QString(part) << alsoVerify;
        };
        row("error too large", {"--error", "101"}, "'--error'");
        row("error no number", {"--error", "few"}, "'--error'");
        row("focus without error", {"--focus", "sphere:8,8,8,3"}, "--focus-error");
        row("focus error without focus", {"--focus-error", "1"}, "'--focus'");
        row("focus warping without focus", {"--focus-warping", "1", "--error", "1"}, "'--focus'");
        row("falloff without focus", {"--falloff", "1"}, "'--focus'");
        row("focus error no number", {"--focus", "sphere:8,8,8,3", "--focus-error", "-1"}, "'--focus-error'");
        row("focus coarser than the rest", {"--error", "0.1", "--focus", "sphere:8,8,8,3", "--focus-error", "0.5"},
            "Exchange '--focus-error' and '--error'");
        row("warping in the focus larger", focus + QStringList{"--warping", "1", "--focus-warping", "2"},
            "Exchange '--focus-warping' and '--warping'");
        row("negative falloff", focus + QStringList{"--falloff", "-1"}, "'--falloff'");
        for (const char* region : {"ball:1,2,3,4", "sphere:1,2,3", "sphere:1,2,3,0", "sphere:1,2,3,-1",
                                   "sphere:1,2,3,nan", "sphere:1,2,3,4,5", "box:1,2,3,4,5", "box:1,2,3,4,5,6,7",
                                   "box:1,2,3,4,5,inf", "box:1;2;3;4;5;6", "box", ""})
            row(qPrintable(QString("focus ") + region), {"--focus", region, "--focus-error", "0.5"}, "sphere:x,y,z,r");
        row("field that is none", {"--field", "cube(1)"}, "'--field'");
        row("field and error", {"--field", "1", "--error", "1"}, "'--error' cannot be combined with it");
        row("field and focus", QStringList{"--field", "1"} + focus, "'--focus' cannot be combined with it");
        row("field and falloff", {"--field", "1", "--falloff", "2"}, "'--falloff' cannot be combined with it");
        row("no budget", {"--budget", "0"}, "'--budget'");
        row("broken budget", {"--budget", "12.5"}, "a whole number from 1 to 1000000000000.");
        row("budget too small", {"--budget", "1"}, "budget");
        row("unknown method", focus + QStringList{"--method", "magic"}, "automatic, closed-set, insertion");
        row("method without a focus", {"--error", "1", "--method", "closed-set"}, "'--method'");
        row("insertion of what is not sharp", {"--field", "isovalues(120; 0.5, 8, 20)", "--method", "insertion"},
            "one box, sphere or half-space");
        row("insertion with a budget",
            QStringList{"--focus", "sphere:8,8,8,3", "--focus-error", "0", "--falloff", "2", "--budget", "5000",
                        "--method", "insertion"},
            "within a budget needs a sharp border");
        row("border without a window", {"--border", "clipped"}, "'--window'", false);
        row("unknown border", {"--window", "0,0,0,5,5,5", "--border", "torn"}, "intersecting, contained, clipped",
            false);
        row("window of five numbers", {"--window", "0,0,0,5,5"}, "'--window'", false);
        row("window outside", {"--window", "100,100,100,105,105,105"},
            "in that crop box, so nothing was written. The data lie between (0, 0, 0) and (15, 15, 15)", false);
        row("values of one number", {"--values", "100"}, "'--values'", false);
        row("values turned round", {"--values", "100,90"}, "'--values'", false);
        row("values outside", {"--values", "900,901"}, "No tetrahedron has such values, so nothing was written", false);
        row("range of one", {"--range", "1"}, "'--range'", false);
        row("range of three", {"--range", "1,2,3"}, "'--range'", false);
        row("range too large", {"--range", "1,200"}, "'--range'", false);
        row("range and error", {"--range", "1,2", "--error", "1"}, "'--error' cannot be combined with it", false);
        row("range and focus", QStringList{"--range", "1,2"} + focus, "'--focus' cannot be combined with it", false);
        row("range and budget", {"--range", "1,2", "--budget", "100"}, "'--budget' cannot be combined with it", false);
        row("range and method", {"--range", "1,2", "--method", "automatic"}, "'--method' cannot be combined with it",
            false);
        row("births without a range", {"--births", "1,2"}, "'--range'", false);
        row("deaths turned round", {"--range", "1,2", "--deaths", "2,1"}, "'--deaths'", false);
        row("nothing so short-lived", {"--range", "1,2", "--births", "0,0"}, "appears and disappears at such errors",
            false);
        row("range cut off", {"--range", "1,2", "--window", "0,0,0,5,5,5", "--border", "clipped"},
            "'--border clipped' cannot be combined", false);
    }
    void wrongUseIsRefused()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, part);
        QFETCH(bool, alsoVerify);
        const Run run = tan(QStringList{"extract", "c60.tan", "-o", "wrong.vtu"} + options);
        QVERIFY2(run.exitCode == 2, QByteArray::number(run.exitCode) + ": " + run.messages);
        QVERIFY2(QString::fromUtf8(run.messages).contains(part), run.messages);
        QVERIFY(run.output.isEmpty());
        QVERIFY(!QFile::exists(path("wrong.vtu")));
        if (!alsoVerify)
            return;
        const Run verify = tan(QStringList{"verify", "c60.tan", "--against", "c60.nrrd"} + options);
        QVERIFY2(verify.exitCode == 2, QByteArray::number(verify.exitCode) + ": " + verify.messages);
        QVERIFY2(QString::fromUtf8(verify.messages).contains(part), verify.messages);
    }

    /// What makes no sense for a proof is refused with the reason, not as unknown (C2).
    void verifyProvesWholeMeshes()
    {
        for (const QStringList& options :
             {QStringList{"--range", "1,2"}, QStringList{"--births", "1,2"}, QStringList{"--window", "0,0,0,5,5,5"},
              QStringList{"--border", "clipped"}, QStringList{"--values", "1,2"}}) {
            const Run run = tan(QStringList{"verify", "c60.tan", "--against", "c60.nrrd"} + options);
            QCOMPARE(run.exitCode, 2);
            QVERIFY2(run.messages.contains("'" + options[0].toUtf8() + "' ") && run.messages.contains("verified"),
                     run.messages);
        }
    }

    void wrongFilesAreRefused()
    {
        const Run ending = tan({"extract", "c60.tan", "-o", "mesh.off"});
        QCOMPARE(ending.exitCode, 2);
        QVERIFY2(ending.messages.contains(".vtk, .vtu; or"), ending.messages);
        for (const char* name : {"history.stl", "history.obj", "history.glb", "history.vtp"}) {
            const Run range = tan({"extract", "c60.tan", "--range", "1,2", "-o", name});
            QCOMPARE(range.exitCode, 2);
            QVERIFY2(range.messages.contains("overlap"), range.messages);
        }
        QVERIFY(QFile::copy(path("c60.tan"), path("model.vtu")));
        const Run same = tan({"extract", "model.vtu", "-o", "model.vtu"});
        QCOMPARE(same.exitCode, 2);
        QVERIFY2(same.messages.contains("is the input"), same.messages);
        QCOMPARE(tan({"extract", "c60.nrrd", "-o", "mesh.vtu"}).exitCode, 3);
        QCOMPARE(tan({"extract", "none.tan", "-o", "mesh.vtu"}).exitCode, 3);
        QCOMPARE(tan({"extract", "c60.tan", "-o", "none/mesh.vtu"}).exitCode, 4);
        QCOMPARE(tan({"extract", "c60.tan"}).exitCode, 2);
    }
};

QTEST_GUILESS_MAIN(ExtractWrongUseTest)
#include "extract_wrong_use_test.moc"
