// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan build`: an option is used, refused with what to do instead, or its limits are told; none is taken and ignored
/// (R10, R12, B6, C7).
#include "tests/app/program.h"

#include <QFile>
#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

class BuildOptionsTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QCOMPARE(tan({"sample", "c60", "--size", "12", "-o", "lattice.nrrd"}).exitCode, 0);
        QCOMPARE(tan({"sample", "blunt-body", "--size", "10", "-o", "grid.xyz"}).exitCode, 0);
        QCOMPARE(tan({"sample", "scattered", "--size", "6", "-o", "points.csv"}).exitCode, 0);
        QCOMPARE(tan({"sample", "part", "--size", "6", "-o", "mesh.vtu"}).exitCode, 0);
        QCOMPARE(tan({"sample", "stretched", "--size", "10", "-o", "box.xyz"}).exitCode, 0);
    }

    void whatIsOfNoUseIsRefused_data()
    {
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("part");
        const QStringList decimate = {"--builder", "decimation"};
        const auto row = [](const QByteArray& name, const char* input, const QStringList& options, const char* part) {
            QTest::newRow(name) << QString(input) << options << QString(part);
        };
        const char* const warping = "'--warping' is for curvilinear data only";
        row("lattice, warping", "lattice.nrrd", {"--warping", "2"}, warping);
        row("lattice, a warping that is the default", "lattice.nrrd", {"--warping", "0"}, warping);
        row("lattice, selection", "lattice.nrrd", {"--selection", "paper"}, "'--selection' is for curvilinear data");
        row("lattice decimated, block", "lattice.nrrd", decimate + QStringList{"--block", "6"},
            "'--builder refinement'");
        row("lattice decimated, warping", "lattice.nrrd", decimate + QStringList{"--warping", "2"},
            "'--warping' is for curvilinear or rectilinear or irregular or scattered data only");
        row("lattice refined, order", "lattice.nrrd", {"--builder", "refinement", "--order", "paper"},
            "'--builder decimation'");
        row("grid decimated, block", "grid.xyz", decimate + QStringList{"--block", "4"}, "'--builder refinement'");
        row("grid, options of two builders", "grid.xyz", {"--block", "4", "--order", "paper"}, "Leave it out.");
        row("grid, paper's selection in blocks", "grid.xyz",
            {"--builder", "refinement", "--selection", "paper", "--block", "4"},
            "The paper's selection of points cannot be used with blocks");
        row("points, block", "points.csv", {"--block", "4"}, "'--block' is for regular or curvilinear data");
        row("points, no block", "points.csv", {"--block", "none"}, "'--block' is for regular or curvilinear");
        row("points, warping", "points.csv", {"--warping", "2"}, warping);
        row("points, selection", "points.csv", {"--selection", "paper"}, "'--selection' is for curvilinear data");
        row("a header tells the size", "lattice.nrrd", {"--size", "12x12x12"}, "'--size' describes raw files");
        row("a header tells the type", "lattice.nrrd", {"--type", "uint8"}, "'--type' describes raw files");
        row("mesh, block", "mesh.vtu", {"--block", "4"}, "Leave it out");
        const char* const space = "Leave it out, or choose '--space computational'";
        row("C6: rectilinear, warping", "box.xyz", {"--warping", "2"}, space);
        row("C6: rectilinear, warping only", "box.xyz", {"--warping", "2"}, "is a rectilinear grid. Leave it out");
        row("C6: rectilinear, block", "box.xyz", {"--block", "4"}, space);
        row("C6: rectilinear, no block", "box.xyz", {"--block", "none", "--space", "physical"}, space);
        row("C6: rectilinear, selection", "box.xyz", {"--selection", "paper"}, space);
        for (const char* other : {"lattice.nrrd", "points.csv"})
            row(QByteArray("C6: space, ") + other, other, {"--space", "computational"},
                "'--space' is for rectilinear data only");
        row("C6: space, grid refined", "grid.xyz", {"--builder", "refinement", "--space", "computational"},
            "'--space' is for rectilinear data only");
        row("mesh, space", "mesh.vtu", {"--space", "computational"},
            "'--space' is for curvilinear or rectilinear data");
    }
    void whatIsOfNoUseIsRefused()
    {
        QFETCH(QString, input);
        QFETCH(QStringList, options);
        QFETCH(QString, part);
        const Run run = tan(QStringList{"build", input, "-o", "refused.tan"} + options);
        QVERIFY2(run.exitCode == 2, QByteArray::number(run.exitCode) + ": " + run.output + run.messages);
        QVERIFY2(QString::fromUtf8(run.messages).contains(part), run.messages);
        QVERIFY(!QFile::exists(folder_.filePath("refused.tan")));
        QVERIFY(!QFile::exists(folder_.filePath("refused.tan.work")));
    }

    void whatIsOfUseIsTaken_data()
    {
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("options");
        const auto row = [](const char* name, const char* input, const QStringList& options) {
            QTest::newRow(name) << QString(input) << options;
        };
        row("blocks are resumed", "lattice.nrrd", {"--block", "6", "--resume"});
        for (const char* input : {"lattice.nrrd", "grid.xyz", "points.csv", "mesh.vtu", "box.xyz"})
            for (const char* builder : {"refinement", "decimation"})
                if (QByteArray(input) != "mesh.vtu" || QByteArray(builder) != "refinement") // it may not be convex
                    row((QByteArray(input) + " by " + builder + " is resumed").constData(), input,
                        {"--builder", builder, "--resume"});
        row("a grid with the paper's selection is refined, and resumed", "grid.xyz",
            {"--selection", "paper", "--resume"});
        row("a whole is kept", "lattice.nrrd", {"--keep"});
        row("blocks are kept and resumed", "lattice.nrrd", {"--block", "6", "--keep", "--resume"});
        row("a decimation is kept", "lattice.nrrd", {"--builder", "decimation", "--keep"});
        row("an order has the lattice decimated", "lattice.nrrd", {"--order", "paper"});
        row("a grid warps", "grid.xyz", {"--warping", "2", "--selection", "paper"});
        row("blocks of a grid are resumed, C7", "grid.xyz", {"--block", "4", "--resume"});
        row("a grid is decimated by its indices", "grid.xyz", {"--space", "computational", "--resume"});
        row("a decimated grid warps", "grid.xyz", {"--builder", "decimation", "--warping", "2"});
        row("a mesh warps", "mesh.vtu", {"--warping", "2"});
        row("C6: a rectilinear grid as a curvilinear one", "box.xyz",
            {"--space", "computational", "--warping", "2", "--block", "4"});
        row("C6: decimated points warp", "points.csv", {"--builder", "decimation", "--warping", "2"});
    }
    void whatIsOfUseIsTaken()
    {
        QFETCH(QString, input);
        QFETCH(QStringList, options);
        const Run run = tan(QStringList{"build", input, "-o", "taken.tan"} + options);
        QVERIFY2(run.exitCode == 0, run.messages);
    }

    /// C6: a rectilinear grid is refined in physical space, where it has no warping; as a curvilinear grid, as all once
    /// were, it has one. Either model is proved, and so is one of decimated points.
    void everyModelIsProved_data()
    {
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("kind");
        QTest::newRow("rectilinear") << "box.xyz" << QStringList{} << "scattered";
        QTest::newRow("as curvilinear") << "box.xyz" << QStringList{"--space", "computational"} << "curvilinear";
        QTest::newRow("points") << "points.csv" << QStringList{"--builder", "decimation"} << "irregular";
        QTest::newRow("grid") << "grid.xyz" << QStringList{} << "irregular";
        QTest::newRow("grid by its indices") << "grid.xyz" << QStringList{"--space", "computational"} << "curvilinear";
        QTest::newRow("grid refined") << "grid.xyz" << QStringList{"--builder", "refinement"} << "curvilinear";
    }
    void everyModelIsProved()
    {
        QFETCH(QString, input);
        QFETCH(QStringList, options);
        QFETCH(QString, kind);
        QCOMPARE(tan(QStringList{"build", input, "-o", "proved.tan"} + options).exitCode, 0);
        const QJsonObject info = tan({"info", "proved.tan", "--json"}).json();
        QCOMPARE(info["kind"].toString(), kind);
        const QString space = options.contains("refinement") || input == "points.csv" ? QString()
                              : options.contains("computational")                     ? "computational"
                                                                                      : "physical";
        QCOMPARE(info["parameters"].toObject()["space"].toString(), space);
        const Run run = tan({"verify", "proved.tan", "--against", input, "--json"});
        QVERIFY2(run.exitCode == 0, run.output + run.messages);
        QCOMPARE(run.json()["levels"].toArray().size(), 8);
        for (const QJsonValue level : run.json()["levels"].toArray())
            if (kind == "scattered")
                QCOMPARE(level["largest_warping"].toDouble(), 0.0);
        const Run other = tan({"verify", "proved.tan", "--against", "mesh.vtu"});
        QVERIFY2(other.exitCode == 1 && other.output.contains("built from another dataset"), other.output);
    }

    /// C6: what is not convex is no points' hull.
    void nonconvexMeshesAreNotRefined()
    {
        for (const auto& [input, isConvex] : {std::pair("box.xyz", true), {"grid.xyz", false}, {"mesh.vtu", false}})
            QCOMPARE(tan({"info", input, "--json"}).json()["convex"].toBool(!isConvex), isConvex);
        QVERIFY(tan({"info", "box.xyz"}).output.contains("rectilinear grid of 10 x 10 x 10 points"));
        const Run run = tan({"build", "mesh.vtu", "--builder", "refinement", "-o", "refused.tan"});
        QVERIFY(run.exitCode != 0);
        QVERIFY2(run.messages.contains("not convex") && run.messages.contains("Decimation"), run.messages);
    }

    /// What was not used does not stand in the model as if it had been.
    void theModelTellsWhatWasUsed()
    {
        QCOMPARE(tan({"build", "lattice.nrrd", "-o", "used.tan"}).exitCode, 0);
        const QJsonObject parameters = tan({"info", "used.tan", "--json"}).json()["parameters"].toObject();
        QVERIFY(parameters.contains("error") && parameters.contains("block"));
        QVERIFY(!parameters.contains("warping") && !parameters.contains("selection"));
    }

    /// A limit of threads is kept by whoever uses one; that more were asked for in vain is told.
    void threadsThatAreNotUsedAreTold_data()
    {
        QTest::addColumn<QString>("input");
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<int>("threads");
        const auto row = [](const char* name, const char* input, const QStringList& options, int threads) {
            QTest::newRow(name) << QString(input) << options << threads;
        };
        row("blocks", "lattice.nrrd", {"--block", "6"}, 2);
        row("whole", "lattice.nrrd", {}, 1);
        row("decimation", "lattice.nrrd", {"--builder", "decimation"}, 1);
        row("grid", "grid.xyz", {}, 1);
        row("blocks of a grid, C7", "grid.xyz", {"--block", "4"}, 2);
        row("in space, C12", "grid.xyz", {"--error-in", "space"}, 2);
        row("points", "points.csv", {}, 1);
        row("mesh", "mesh.vtu", {}, 1);
    }
    void threadsThatAreNotUsedAreTold()
    {
        QFETCH(QString, input);
        QFETCH(QStringList, options);
        QFETCH(int, threads);
        const QStringList words = QStringList{"build", input, "--threads", "2", "-o", "threads.tan"} + options;
        const Run json = tan(words + QStringList{"--json"});
        QVERIFY2(json.exitCode == 0, json.messages);
        QCOMPARE(json.json()["threads"].toInt(), threads);
        const Run text = tan(words);
        QCOMPARE(text.output.contains("One thread was used"), threads == 1);
        QCOMPARE(text.output.contains("'--block 32'"), threads == 1 && input == "lattice.nrrd" && options.isEmpty());
        QVERIFY(!tan(QStringList{"build", input, "-o", "threads.tan"} + options).output.contains("One thread"));
    }

    /// R12: one threshold alone holds for error and warping, whoever builds.
    void oneThresholdAloneIsBoth_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addRow("refinement") << QStringList{"--builder", "refinement"};
        QTest::addRow("decimation") << QStringList{"--builder", "decimation"};
    }
    void oneThresholdAloneIsBoth()
    {
        QFETCH(QStringList, options);
        const auto built = [&](const QStringList& thresholds) {
            const Run run = tan(QStringList{"build", "grid.xyz", "-o", "model.tan", "--json"} + options + thresholds);
            const QJsonObject figures = run.json();
            return std::pair(figures["sites"].toInt(), figures["tetrahedra"].toInt());
        };
        const auto both = built({"--error", "4", "--warping", "4"});
        QVERIFY(both.first > 0 && both != built({}));
        QCOMPARE(built({"--error", "4"}), both);
        QCOMPARE(built({"--warping", "4"}), both);
    }

    /// What a build takes is asked of each builder that would do it.
    void theEstimateIsOfTheBuilder()
    {
        const auto estimates = [this](const char* input) {
            QMap<QString, QJsonObject> found;
            for (const QJsonValue& value : tan({"info", input, "--json"}).json()["estimates"].toArray())
                found[value["builder"].toString()] = value.toObject();
            return found;
        };
        const auto lattice = estimates("lattice.nrrd");
        QCOMPARE(lattice.keys(), QStringList({"decimation", "refinement"}));
        for (const QString key : {"memory_bytes", "disk_bytes", "model_bytes", "seconds"})
            QVERIFY2(lattice["refinement"][key].toDouble() > 0 && lattice["decimation"][key].toDouble() > 0,
                     qPrintable(key));
        QVERIFY(lattice["decimation"]["seconds"].toDouble() > lattice["refinement"]["seconds"].toDouble());
        QVERIFY(lattice["decimation"]["memory_bytes"].toDouble() > lattice["refinement"]["memory_bytes"].toDouble());
        QCOMPARE(estimates("points.csv").keys(), QStringList({"decimation", "refinement"})); // C6
        QCOMPARE(estimates("mesh.vtu").keys(), QStringList({"decimation"}));
        const Run text = tan({"info", "lattice.nrrd"});
        QVERIFY2(text.output.contains("by decimation would take about "), text.output);
    }
};

QTEST_GUILESS_MAIN(BuildOptionsTest)
#include "build_options_test.moc"
