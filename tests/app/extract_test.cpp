// SPDX-License-Identifier: GPL-3.0-or-later
/// `tan extract` and `tan verify` of the meshes that it writes: every option, every wrong use, and the file as VTK
/// reads it.
#include "tests/app/program.h"
#include "tests/app/read_mesh.h"
#include "tests/app/sample_files.h"
#include "tests/lacks.h"

#include <QJsonArray>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

using namespace tetra;

class ExtractTest : public QObject {
    Q_OBJECT

private:
    Run tan(const QStringList& words) const { return runTan(words, folder_.path()); }
    QString path(const QString& name) const { return folder_.filePath(name); }
    QJsonObject extracted(const QStringList& options, const QString& name = "mesh.vtu") const
    {
        const Run run = tan(QStringList{"extract", "c60.tan", "-o", name, "--json"} + options);
        if (run.exitCode != 0)
            qWarning("%s", run.messages.constData());
        return run.exitCode == 0 ? run.json() : QJsonObject();
    }
    QJsonObject level(const QString& error) const
    {
        return tan({"info", "c60.tan", "--lod", error, "--json"}).json()["levels"].toArray()[0].toObject();
    }
    static qint64 tetrahedra(const QJsonObject& figures) { return figures["tetrahedra"].toInteger(-1); }

    QTemporaryDir folder_;

private slots:
    void initTestCase()
    {
        QVERIFY(tan({"sample", "c60", "--size", "16", "-o", "c60.nrrd"}).exitCode == 0);
        QVERIFY(tan({"build", "c60.nrrd", "-o", "c60.tan"}).exitCode == 0);
        QVERIFY(tan({"sample", "bent-duct", "--size", "10", "-o", "duct.xyz"}).exitCode == 0);
        QVERIFY(
            tan({"build", "duct.xyz", "--builder", "refinement", "--error-in", "grid", "-o", "duct.tan"}).exitCode ==
            0);
    }

    /// The mesh of an accuracy, in each format, of the same size as info tells.
    void writesAMeshOfAnAccuracy_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"mesh.vtu", "mesh.vtk"})
            QTest::newRow(name) << QString(name);
    }
    void writesAMeshOfAnAccuracy()
    {
        QFETCH(QString, name);
        const QJsonObject figures = extracted({"--error", "2"}, name);
        const QJsonObject expected = level("2");
        QCOMPARE(figures["file"].toString(), name);
        QCOMPARE(figures["sites"].toInteger(), expected["sites"].toInteger());
        QCOMPARE(tetrahedra(figures), tetrahedra(expected));
        QCOMPARE(figures["whole_tetrahedra"].toInteger(), tetrahedra(expected));
        QCOMPARE(figures["whole_sites"].toInteger(), expected["sites"].toInteger());
        QCOMPARE(figures["error"].toDouble(), 2.0);
        QCOMPARE(figures["warping"].toDouble(-1), 0.0);
        QCOMPARE(figures["scale"].toDouble(), 1.0);
        QCOMPARE(figures["method"].toString(), QString("closed-set"));
        QVERIFY(figures["seconds"].toDouble(-1) >= 0);
        QVERIFY(QFileInfo(path(name)).size() > 16 * figures["sites"].toInteger());
    }

    /// In the formats for triangles: closed but for nothing, and it encloses the domain.
    void writesTheBoundary_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"mesh.vtp", "mesh.ply", "mesh.obj", "mesh.glb"})
            QTest::newRow(name) << QString(name);
    }
    void writesTheBoundary()
    {
        QFETCH(QString, name);
        QCOMPARE(tetrahedra(extracted({"--error", "2"}, name)), tetrahedra(level("2")));
        const VtkReader reader(path(name));
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(reader.ok(), reader.messages());
        const std::vector<double> points = reader.places();
        const std::vector<std::uint32_t> corners = reader.array<std::uint32_t>("cells");
        QVERIFY(corners.size() >= 3 * 12 && corners.size() % 3 == 0);
        double volume = 0;
        for (std::size_t t = 0; t < corners.size(); t += 3) {
            const auto at = [&](std::size_t i) {
                const std::size_t first = 3 * corners[t + i];
                return std::array<double, 3>{points[first], points[first + 1], points[first + 2]};
            };
            const auto a = at(0), b = at(1), c = at(2);
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) /
                      6;
        }
        QVERIFY2(std::abs(volume - 15.0 * 15 * 15) < 1e-6, qPrintable(QString::number(volume)));
    }

    void theDefaultErrorIsOne() { QCOMPARE(tetrahedra(extracted({})), tetrahedra(level("1"))); }

    /// The file is the mesh: VTK reads positive tetrahedra that fill the domain, and the data's values at its points.
    void vtkReadsTheMesh()
    {
        const QJsonObject figures = extracted({"--error", "2"});
        const VtkReader reader(path("mesh.vtu"));
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(reader.ok(), reader.messages());
        const ReadMesh mesh(reader);
        QCOMPARE(static_cast<qint64>(mesh.cellCount()), tetrahedra(figures));
        for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell)
            QVERIFY(mesh.volume(cell) > 0);
        QVERIFY(std::abs(mesh.volume() - 15.0 * 15 * 15) < 1e-6);
        const QJsonObject facts = reader.told()["facts"].toObject();
        QCOMPARE(facts["error"].toDouble(), 2.0);
        QCOMPARE(facts["error_scale"].toDouble(), 1.0);
        QVERIFY(facts["reached_error"].toDouble() > 0);
        QVERIFY(facts["reached_error"].toDouble() <= 2.0);
        const QByteArray head = readFile(path("mesh.vtu")).left(500);
        QVERIFY2(head.contains("<!-- model: c60.tan -->") && head.contains("<!-- source: c60.nrrd -->"), head);
        QFile nrrd(path("c60.nrrd"));
        QVERIFY(nrrd.open(QIODevice::ReadOnly));
        const QByteArray content = nrrd.readAll();
        const QByteArray samples = content.mid(content.indexOf("\n\n") + 2);
        QCOMPARE(samples.size(), 16 * 16 * 16);
        for (std::size_t vertex = 0; vertex < mesh.values.size(); ++vertex) {
            const auto at = [&](std::size_t axis) { return std::lround(mesh.points[3 * vertex + axis]); };
            const auto sample = static_cast<std::uint8_t>(samples.at(at(0) + 16 * (at(1) + 16 * at(2))));
            QCOMPARE(mesh.values[vertex], static_cast<float>(sample));
        }
    }

    /// Fewer tetrahedra than fine everywhere, more than coarse everywhere; more regions and wider borders need more.
    void aFocusIsFiner()
    {
        const QStringList focus = {"--error", "8", "--focus", "sphere:8,8,8,3", "--focus-error", "0.5"};
        const qint64 one = tetrahedra(extracted(focus));
        QVERIFY(one > tetrahedra(level("8")) && one < tetrahedra(level("0.5")));
        const qint64 two = tetrahedra(extracted(focus + QStringList{"--focus", "box:0,0,0,2,2,2"}));
        QVERIFY(two > one);
        QVERIFY(tetrahedra(extracted(focus + QStringList{"--falloff", "4"})) > one);
        QCOMPARE(tetrahedra(extracted({"--error", "8", "--focus", "sphere:90,8,8,3", "--focus-error", "0.5"})),
                 tetrahedra(level("8")));
        const QJsonObject figures = extracted(focus + QStringList{"--method", "closed-set"});
        QCOMPARE(figures["error"].toDouble(), 8.0);
        QCOMPARE(figures["method"].toString(), QString("closed-set"));
        // A box is given by any two opposite corners.
        const QStringList box = {"--error", "8", "--focus-error", "0.5", "--focus"};
        QCOMPARE(tetrahedra(extracted(box + QStringList{"box:1,2,9,6,5,4"})),
                 tetrahedra(extracted(box + QStringList{"box:6,5,4,1,2,9"})));
    }

    void aFieldIsTheSameInWords()
    {
        QCOMPARE(tetrahedra(extracted({"--field", "sphere(8,8,8, 3; 0.5, 8, 2)", "--method", "closed-set"})),
                 tetrahedra(extracted({"--error", "8", "--focus", "sphere:8,8,8,3", "--focus-error", "0.5", "--falloff",
                                       "2", "--method", "closed-set"})));
        QCOMPARE(tetrahedra(extracted({"--field", "2"})), tetrahedra(level("2")));
        QVERIFY(tetrahedra(extracted({"--field", "isovalues(120; 0.5, 8, 20)"})) > tetrahedra(level("8")));
    }

    void aBudgetIsKept()
    {
        const QJsonObject figures = extracted({"--budget", "3000"});
        QVERIFY(tetrahedra(figures) <= 3000 && tetrahedra(figures) > 1500);
        QVERIFY(figures["scale"].toDouble() > 1);
        const double error = figures["error"].toDouble();
        QVERIFY(error > 0 && error < 50);
        QCOMPARE(tetrahedra(extracted({"--budget", "3000", "--error", QString::number(error * 0.9)})),
                 tetrahedra(figures));
        QCOMPARE(tetrahedra(extracted({"--budget", "100000000", "--error", "2"})), tetrahedra(level("2")));
        const QJsonObject focused =
            extracted({"--budget", "2000", "--error", "4", "--focus", "sphere:8,8,8,3", "--focus-error", "0.1"});
        QVERIFY(tetrahedra(focused) <= 2000 && focused["scale"].toDouble() > 1);
    }

    /// Pieces are more than what they were cut from, which is never more than the whole.
    void piecesAreNotTetrahedraOfTheModel()
    {
        const QStringList cut = {"--error",  "10",     "--window", "0.75,0.75,0.75,14.25,14.25,14.25",
                                 "--border", "clipped"};
        const QJsonObject figures = extracted(cut);
        QVERIFY(tetrahedra(figures) > figures["whole_tetrahedra"].toInteger());
        const qint64 kept = figures["kept_tetrahedra"].toInteger();
        QVERIFY(kept > 0 && kept <= figures["whole_tetrahedra"].toInteger());
        QVERIFY(figures["kept_sites"].toInteger(-1) >= 0);
        QVERIFY(figures["kept_sites"].toInteger() <= figures["whole_sites"].toInteger());
        const Run run = tan(QStringList{"extract", "c60.tan", "-o", "cut.vtu"} + cut);
        QVERIFY2(run.output.contains(QString("pieces of %1 of the %2 of the whole mesh")
                                         .arg(kept)
                                         .arg(figures["whole_tetrahedra"].toInteger())
                                         .toUtf8()),
                 run.output);
        const QJsonObject all = extracted({"--error", "10"});
        QCOMPARE(all["kept_tetrahedra"].toInteger(), all["whole_tetrahedra"].toInteger());
        QCOMPARE(all["kept_sites"].toInteger(), all["whole_sites"].toInteger());
    }

    void aWindowChooses()
    {
        const QStringList window = {"--error", "2", "--window", "3.5,0,0,9.5,15,15"};
        QStringList names = {"intersecting", "contained", "clipped"};
        std::map<QString, double> volumes;
        for (const QString& border : names) {
            const QJsonObject figures = extracted(window + QStringList{"--border", border});
            QCOMPARE(figures["whole_tetrahedra"].toInteger(), tetrahedra(level("2")));
            const VtkReader reader(path("mesh.vtu"));
            if (reader.isMissing())
                QSKIP_WITHOUT("python3-vtk9");
            QVERIFY2(reader.ok(), reader.messages());
            const ReadMesh mesh(reader);
            volumes[border] = mesh.volume();
            std::set<std::uint32_t> used(mesh.cells.begin(), mesh.cells.end());
            QCOMPARE(used.size(), mesh.values.size());
            for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell) {
                double least = 99;
                double most = -99;
                for (std::size_t corner = 0; corner < 4; ++corner) {
                    least = std::min(least, mesh.coordinate(cell, corner, 0));
                    most = std::max(most, mesh.coordinate(cell, corner, 0));
                }
                QVERIFY(least <= 9.5 && most >= 3.5);
                QVERIFY(border == "intersecting" || (least >= 3.5 - 1e-6 && most <= 9.5 + 1e-6));
            }
        }
        QVERIFY(std::abs(volumes["clipped"] - 6.0 * 15 * 15) < 1e-3);
        QVERIFY(volumes["contained"] < volumes["clipped"] && volumes["clipped"] < volumes["intersecting"]);
        QCOMPARE(tetrahedra(extracted(window)),
                 tetrahedra(extracted(window + QStringList{"--border", "intersecting"})));
    }

    void valuesChoose()
    {
        const qint64 all = tetrahedra(level("2"));
        const qint64 some = tetrahedra(extracted({"--error", "2", "--values", "100,110"}));
        QVERIFY(some > 0 && some < all);
        const VtkReader reader(path("mesh.vtu"));
        const qint64 more = tetrahedra(extracted({"--error", "2", "--values", "100,110", "--values", "30,40"}));
        QVERIFY(more > some && more < all);
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        const ReadMesh mesh(reader);
        QCOMPARE(static_cast<qint64>(mesh.cellCount()), some);
        for (std::size_t cell = 0; cell < mesh.cellCount(); ++cell) {
            double least = 999;
            double most = -999;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                least = std::min(least, mesh.value(cell, corner));
                most = std::max(most, mesh.value(cell, corner));
            }
            QVERIFY(least <= 110 && most >= 100);
        }
    }

    /// The mesh of any error between the two ends is in the file, by the lives of its tetrahedra.
    void aRangeHoldsItsMeshes()
    {
        const QJsonObject figures = extracted({"--range", "1,8"});
        QCOMPARE(tetrahedra(figures["coarse"].toObject()), tetrahedra(level("8")));
        QCOMPARE(tetrahedra(figures["fine"].toObject()), tetrahedra(level("1")));
        QCOMPARE(tetrahedra(extracted({"--range", "8,1"})), tetrahedra(figures));
        const VtkReader reader(path("mesh.vtu"));
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(reader.ok(), reader.messages());
        const std::vector<float> births = reader.array<float>("cell.birth_error");
        const std::vector<float> deaths = reader.array<float>("cell.death_error");
        QCOMPARE(static_cast<qint64>(births.size()), tetrahedra(figures));
        for (const float error : {1.0F, 1.37F, 2.0F, 3.3F, 5.71F, 8.0F}) {
            qint64 alive = 0;
            for (std::size_t cell = 0; cell < births.size(); ++cell)
                alive += deaths[cell] <= error && error < births[cell] ? 1 : 0;
            QCOMPARE(alive, tetrahedra(level(QString::number(static_cast<double>(error)))));
        }
        QCOMPARE(tetrahedra(extracted({"--range", "2,2"})), tetrahedra(level("2")));
        QVERIFY(tetrahedra(extracted({"--range", "1,8", "--values", "100,110"})) < tetrahedra(figures));
        QVERIFY(tetrahedra(extracted({"--range", "1,8", "--window", "0,0,0,5,5,5", "--border", "contained"})) <
                tetrahedra(extracted({"--range", "1,8", "--window", "0,0,0,5,5,5"})));
    }

    /// Births and deaths choose from a range (R17, C2): what is alive at an error is its mesh, which has a boundary.
    void livesChooseFromARange()
    {
        const QStringList alive = {"--range", "1,8", "--births", "2,inf", "--deaths", "0,2"};
        QCOMPARE(tetrahedra(extracted(alive)), tetrahedra(level("2")));
        QCOMPARE(tetrahedra(extracted(alive, "mesh.stl")), tetrahedra(level("2")));
        const qint64 all = tetrahedra(extracted({"--range", "1,8"}));
        const qint64 early = tetrahedra(extracted({"--range", "1,8", "--births", "3,inf"}));
        const qint64 late = tetrahedra(extracted({"--range", "1,8", "--births", "0,3"}));
        QVERIFY(early > 0 && late > 0);
        QCOMPARE(early + late, all);
    }

    /// Isosurfaces of the same meshes by the same options (R19, C2).
    void isosurfacesTakeTheSameQueries_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("nothing") << QStringList();
        QTest::newRow("error") << QStringList{"--error", "3"};
        QTest::newRow("foci") << QStringList{
            "--error", "8", "--focus", "sphere:8,8,8,3", "--focus", "box:0,0,0,3,3,3", "--focus-error", "0.5"};
        QTest::newRow("field") << QStringList{"--field", "isovalues(120; 0.5, 8, 20)"};
        QTest::newRow("budget") << QStringList{"--budget", "2000"};
        QTest::newRow("window") << QStringList{"--window", "0,0,0,8,8,8", "--border", "clipped"};
        QTest::newRow("values") << QStringList{"--values", "100,110"};
        QTest::newRow("range") << QStringList{"--range", "1,8"};
        QTest::newRow("part of a range") << QStringList{"--range",  "1,8",     "--births", "2,20",
                                                        "--values", "100,130", "--window", "0,0,0,8,8,15"};
    }
    void isosurfacesTakeTheSameQueries()
    {
        QFETCH(QStringList, options);
        const Run run = tan(QStringList{"isosurface", "c60.tan", "--value", "120", "-o", "s.vtp", "--json"} + options);
        QVERIFY2(run.exitCode == 0, run.messages);
        const QJsonObject surface = run.json(), mesh = extracted(options);
        for (const char* figure : {"sites", "tetrahedra", "scale", "method", "kept_tetrahedra", "coarse", "fine"})
            QCOMPARE(surface[figure], mesh[figure]);
        QVERIFY(surface["triangles"].toInteger() > 0 || options.contains("--values"));
    }

    /// The triangles of a range know the lives of their tetrahedra: those alive at an error are its isosurface (C2).
    void trianglesOfARangeHaveLives_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"lives.vtp", "lives.vtu", "lives.vtk"})
            QTest::newRow(name) << QString(name);
    }
    void trianglesOfARangeHaveLives()
    {
        QFETCH(QString, name);
        const Run run = tan({"isosurface", "c60.tan", "--value", "120,60", "--range", "1,8", "-o", name, "--json"});
        QVERIFY2(run.exitCode == 0, run.messages);
        const VtkReader reader(path(name));
        if (reader.isMissing())
            QSKIP_WITHOUT("python3-vtk9");
        QVERIFY2(reader.ok(), reader.messages());
        const std::vector<float> births = reader.array<float>("cell.birth_error");
        const std::vector<float> deaths = reader.array<float>("cell.death_error");
        QCOMPARE(static_cast<qint64>(births.size()), run.json()["triangles"].toInteger());
        QCOMPARE(deaths.size(), births.size());
        for (const float error : {1.0F, 2.0F, 8.0F}) {
            qint64 alive = 0;
            for (std::size_t cell = 0; cell < births.size(); ++cell)
                alive += deaths[cell] <= error && error < births[cell] ? 1 : 0;
            const Run one = tan({"isosurface", "c60.tan", "--value", "120,60", "--error",
                                 QString::number(static_cast<double>(error)), "-o", "one.vtp", "--json"});
            QCOMPARE(alive, one.json()["triangles"].toInteger());
        }
    }

    /// Their readers take nothing behind the lists of vertices.
    void plyFilesOfARangeHaveNoLives()
    {
        const Run run = tan({"isosurface", "c60.tan", "--value", "120", "--range", "1,8", "-o", "lives.ply", "--json"});
        QCOMPARE(run.exitCode, 0);
        const QString remark = run.json()["remarks"].toArray().at(0).toString();
        QVERIFY2(remark.contains("does not contain the triangles' values (birth_error, death_error)"),
                 qPrintable(remark));
        QFile file(path("lives.ply"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray content = file.readAll();
        const qsizetype end = content.indexOf("end_header\n") + 11;
        const QByteArray head = content.left(end);
        QVERIFY(head.contains("property list uchar int vertex_indices\nend_header\n"));
        const auto count = [&head](const QByteArray& element) {
            const qsizetype at = head.indexOf("element " + element + " ") + 9 + element.size();
            return head.mid(at, head.indexOf('\n', at) - at).toLongLong();
        };
        const qsizetype vertexBytes = head.contains("property double x") ? 40 : 28;
        QCOMPARE(content.size() - end, count("vertex") * vertexBytes + count("face") * 13);
    }

    /// Foci and fields on real irregular meshes are proved, boundary included (C3, R25).
    void irregularFociAreProved_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QStringList>("options");
        const auto row = [](const char* file, const char* name, const QStringList& options) {
            QTest::addRow("%s, %s", file, name) << QString(file) << options;
        };
        row("spx.vtu", "sphere",
            {"--error", "40", "--focus", "sphere:6,2,-4,1.5", "--focus-error", "0", "--falloff", "0.2"});
        row("spx.vtu", "boxes",
            {"--error", "60", "--focus", "box:4,0,-8,6,3,-6", "--focus", "sphere:9,5,0,1", "--focus-error", "0.5"});
        row("spx.vtu", "field", {"--field", "min(halfspace(1,0,0,6;0,60),values(0.2:1,0.5:60))"});
        row("spx.vtu", "budget",
            {"--error", "20", "--focus", "sphere:8,3,-3,2", "--focus-error", "0", "--budget", "4000"});
        row("bracket_57k.vtu", "half", {"--field", "halfspace(1,0,0,0;0.5,50)"});
    }
    void irregularFociAreProved()
    {
        QFETCH(QString, file);
        QFETCH(QStringList, options);
        const QString data = TAN_SOURCE_DIR "/../shared/data/irregular/" + file;
        if (!QFile::exists(data))
            QSKIP_WITHOUT("data");
        const QString model = file + ".tan";
        if (!QFile::exists(path(model)))
            QCOMPARE(tan({"build", data, "-o", model}).exitCode, 0);
        const Run verified = tan(QStringList{"verify", model, "--against", data, "--json"} + options);
        QVERIFY2(verified.exitCode == 0, verified.output + verified.messages);
        const QJsonObject mesh = verified.json()["levels"].toArray()[0].toObject();
        const QJsonObject all = tan({"info", model, "--lod", "0", "--json"}).json()["levels"].toArray()[0].toObject();
        QVERIFY(mesh["sites"].toInteger() > 0 && mesh["sites"].toInteger() < all["sites"].toInteger());
    }

    void warpingIsLimited()
    {
        const auto size = [&](const QStringList& options) {
            const Run run = tan(QStringList{"extract", "duct.tan", "-o", "duct.vtu", "--json"} + options);
            if (run.exitCode != 0)
                qWarning("%s", run.messages.constData());
            return tetrahedra(run.json());
        };
        const qint64 coarse = size({"--error", "8", "--warping", "100"});
        const qint64 straight = size({"--error", "8", "--warping", "0.5"});
        QVERIFY(coarse > 0 && coarse < straight);
        QCOMPARE(size({"--error", "8"}), size({"--error", "8", "--warping", "8"}));
        const QStringList focus = {"--error",       "8", "--warping", "8", "--focus", "box:-99,-99,-99,99,99,99",
                                   "--focus-error", "8"};
        QCOMPARE(size(focus), size({"--error", "8"}));
        const QStringList straightFocus = focus + QStringList{"--focus-warping", "0.5"};
        QVERIFY(size(straightFocus) > size(focus));
        const Run verify = tan(QStringList{"verify", "duct.tan", "--against", "duct.xyz", "--json"} + straightFocus);
        QVERIFY2(verify.exitCode == 0, verify.output + verify.messages);
        QVERIFY(verify.json()["levels"].toArray()[0].toObject()["largest_warping"].toDouble(100) <= 0.5);
        QCOMPARE(tan({"extract", "duct.tan", "-o", "duct.vtu", "--error", "8", "--warping", "3", "--json"})
                     .json()["warping"]
                     .toDouble(),
                 3.0);
    }

    /// What extract writes, verify proves.
    void verifyProvesTheSameMesh_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<double>("error"); // that holds everywhere; -1 is any
        QTest::newRow("error") << QStringList{"--error", "3"} << 3.0;
        QTest::newRow("focus") << QStringList{"--error", "8", "--focus", "sphere:8,8,8,3", "--focus-error", "0.5"}
                               << 8.0;
        QTest::newRow("two with falloff") << QStringList{"--error",       "8",
                                                         "--focus",       "sphere:8,8,8,3",
                                                         "--focus",       "box:0,0,0,3,3,3",
                                                         "--focus-error", "0.5",
                                                         "--falloff",     "3"}
                                          << 8.0;
        QTest::newRow("field") << QStringList{"--field", "isovalues(120; 0.5, 8, 20)"} << 8.0;
        QTest::newRow("budget") << QStringList{"--budget", "2500"} << -1.0;
        QTest::newRow("focus in a budget")
            << QStringList{"--budget", "2500", "--error", "4", "--focus", "sphere:8,8,8,3", "--focus-error", "0.1"}
            << -1.0;
    }
    void verifyProvesTheSameMesh()
    {
        QFETCH(QStringList, options);
        QFETCH(double, error);
        const Run run = tan(QStringList{"verify", "c60.tan", "--against", "c60.nrrd", "--json"} + options);
        QVERIFY2(run.exitCode == 0, run.output + run.messages);
        const QJsonArray levels = run.json()["levels"].toArray();
        QCOMPARE(levels.size(), 1);
        const QJsonObject level = levels[0].toObject();
        QVERIFY(level["ok"].toBool() && level["conforming"].toBool() && level["covers"].toBool());
        QCOMPARE(level["inverted"].toInt(-1), 0);
        QCOMPARE(level["failures"].toArray().size(), 0);
        QVERIFY(error < 0 || level["error"].toDouble() == error);
        QVERIFY(level["largest_error"].toDouble(100) <= level["error"].toDouble() + 1e-9);
        QCOMPARE(tetrahedra(level), tetrahedra(extracted(options)));
    }

    void everyKindOfModelIsProved_data()
    {
        QTest::addColumn<QStringList>("sample");
        QTest::addColumn<QStringList>("build");
        QTest::addColumn<QString>("focus");
        QTest::newRow("weights") << QStringList{"c60", "-o", "data.nrrd"} << QStringList{"--weight", "point:8,8,8,6"}
                                 << "sphere:5,8,8,3";
        QTest::newRow("blocks") << QStringList{"c60", "-o", "data.nrrd"} << QStringList{"--block", "5"}
                                << "sphere:5,8,8,3";
        QTest::newRow("floats") << QStringList{"hydrogen", "--type", "float", "-o", "data.nrrd"} << QStringList{}
                                << "sphere:5,8,8,3";
        QTest::newRow("scattered") << QStringList{"scattered", "-o", "data.csv"} << QStringList{} << "sphere:0,0,0,0.4";
        QTest::newRow("collapsed axis") << QStringList{"blunt-body", "-o", "data.xyz"} << QStringList{}
                                        << "box:-9,-9,-9,0,9,9";
    }
    void everyKindOfModelIsProved()
    {
        QFETCH(QStringList, sample);
        QFETCH(QStringList, build);
        QFETCH(QString, focus);
        const QString data = sample.back();
        QCOMPARE(tan(QStringList{"sample", "--size", "14"} + sample).exitCode, 0);
        QCOMPARE(tan(QStringList{"build", data, "-o", "model.tan"} + build).exitCode, 0);
        for (const QStringList& options :
             {QStringList{"--error", "6", "--focus", focus, "--focus-error", "1"}, QStringList{"--budget", "3000"}}) {
            const Run run = tan(QStringList{"verify", "model.tan", "--against", data} + options);
            QVERIFY2(run.exitCode == 0, run.output + run.messages);
        }
    }

    void verifyProvesLevelsBesideIt()
    {
        const Run run =
            tan({"verify", "c60.tan", "--against", "c60.nrrd", "--lod", "4,2", "--budget", "2500", "--json"});
        QCOMPARE(run.exitCode, 0);
        QCOMPARE(run.json()["levels"].toArray().size(), 3);
        QCOMPARE(tan({"verify", "duct.tan", "--against", "duct.xyz", "--error", "5", "--focus-error", "1", "--focus",
                      "box:-99,-99,-99,0,99,99"})
                     .exitCode,
                 0);
    }
};

QTEST_GUILESS_MAIN(ExtractTest)
#include "extract_test.moc"
