// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged files of the VTK formats end in an error that names the file, or in a dataset that is one (S6, S20).
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/vtk/vtk_test_files.h"
#include "tests/soak.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>

using namespace tetra;

namespace {

const std::filesystem::path data = std::filesystem::path(TAN_SOURCE_DIR) / "../shared/data";

bool isWhole(const Dataset& dataset)
{
    const std::uint64_t points = dataset.values.count();
    const bool positions = dataset.positions == nullptr || dataset.positions->size() == points;
    const bool tetrahedra =
        dataset.domain != DomainClass::Irregular || (dataset.tetrahedra != nullptr && !dataset.tetrahedra->empty());
    return points > 0 && dataset.values.notFiniteCount() == 0 && positions && tetrahedra;
}

/// Every change is one that a file may not have.
std::vector<BadFile> wrong(const QByteArray& name, const QByteArray& good,
                           const std::vector<std::pair<QByteArray, QByteArray>>& changes)
{
    std::vector<BadFile> files;
    for (const auto& [from, to] : changes)
        files.push_back({from.left(30) + " -> " + to.left(30), name, with(good, from, to)});
    return files;
}

std::vector<BadFile> wrongFiles()
{
    std::vector<BadFile> all;
    const auto add = [&](const std::vector<BadFile>& files) { all.insert(all.end(), files.begin(), files.end()); };
    add(wrong("bad.vti", vtiText(),
              {{"0 2 0 2 0 2", "0 2 0 2 0 0"},
               {"0 2 0 2 0 2\" Origin", "0 2000000 0 2000000 0 2000000\" Origin"},
               {"0 2 0 2 0 2", "0 -2 0 2 0 2"},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"0 1 2\""},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"nan 1 2\""},
               {"Spacing=\"0.5 1 2\"", "Spacing=\"1 2\""},
               {"Origin=\"1 2 3\"", "Origin=\"1e300 2 3\""},
               {" Origin", " Direction=\"1 0 0 0 1 0 0 0\" Origin"},
               {" Origin", " Direction=\"1 0 0 0 1 0 0 0 nan\" Origin"},
               {" Origin", " Direction=\"1 0 0 0 1 0 1 1 0\" Origin"},
               {"type=\"ImageData\"", "type=\"Table\""},
               {"type=\"ImageData\"", "type=\"PolyData\""}}));
    add(wrong("bad.vts", vtsText(),
              {{"0 2 0 2 0 2", "0 3 0 2 0 2"},
               {"Float32\" Name=\"Points\"", "Float32\" Name=\"Points\" offset=\"99\""},
               {"NumberOfComponents=\"3\"", "NumberOfComponents=\"2\""},
               {"0 0 0\n", "nan 0 0\n"},
               {"Points>", "Pints>"}}));
    add(wrong("bad.vtu", vtuText(),
              {{"NumberOfPoints=\"5\"", "NumberOfPoints=\"500000000000\""},
               {"NumberOfPoints=\"5\"", "NumberOfPoints=\"-5\""},
               {"NumberOfCells=\"2\"", "NumberOfCells=\"99\""},
               {"4 1 2 3", "4 1 2 300"},
               {"4 1 2 3", "4 1 2 -3"},
               {">4 8<", ">4 9000<"},
               {">4 8<", ">8 4<"},
               {">10 10<", ">10 42<"},
               {">10 10<", ">10 41<"},
               {">10 10<", ">10 250<"},
               {">10 10<", ">12 12<"},
               {"0 0 0 1 0 0", "0 0 0 inf 0 0"}}));
    add(wrong("bad.vtp", vtpText(),
              {{"NumberOfPoints=\"5\"", "NumberOfPoints=\"99999999999\""},
               {"NumberOfPoints=\"5\"", "NumberOfPoints=\"0\""},
               {"0 0 0 1 0 0", "0 0 0 nan 0 0"},
               {"<PointData", "<PointDatum"},
               {"Float32\" Name=\"value\"", "String\" Name=\"value\""}}));
    add(wrong("bad.vtk", legacyText(),
              {{"DIMENSIONS 3 3 3", "DIMENSIONS 3 3 1"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS -3 3 3"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS 2000000 2000000 2000000"},
               {"DIMENSIONS 3 3 3", "DIMENSIONS a b c"},
               {"SPACING 0.5", "SPACING 0"},
               {"POINT_DATA 27", "POINT_DATA 999999999999"},
               {"POINT_DATA 27", "POINT_DATA 12"},
               {"value float 1", "value float 99"},
               {"value float 1", "value quaternion 1"},
               {"STRUCTURED_POINTS", "TEAPOTS"}}));
    add(wrong("mesh.vtk", legacyMeshText(),
              {{"POINTS 5", "POINTS 500000000000"},
               {"POINTS 5", "POINTS -1"},
               {"CELLS 2 10", "CELLS 2 1000000000000"},
               {"CELLS 2 10", "CELLS 2000000000 10"},
               {"4 4 1 2 3", "4 4 1 2 33"},
               {"4 4 1 2 3", "400 4 1 2 3"},
               {"4 4 1 2 3", "-4 4 1 2 3"},
               {"CELL_TYPES 2\n10", "CELL_TYPES 2\n99"}}));
    return all;
}

} // namespace

class VtkBadFilesTest : public QObject {
    Q_OBJECT

private slots:
    void theGoodOnesAreRead_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("vti") << QByteArray("good.vti") << vtiText();
        QTest::newRow("vts") << QByteArray("good.vts") << vtsText();
        QTest::newRow("vtu") << QByteArray("good.vtu") << vtuText();
        QTest::newRow("vtp") << QByteArray("good.vtp") << vtpText();
        QTest::newRow("vtk") << QByteArray("good.vtk") << legacyText();
        QTest::newRow("vtk of cells") << QByteArray("mesh.vtk") << legacyMeshText();
    }
    void theGoodOnesAreRead()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        const auto dataset = complete(readerOf(name.toStdString()).read(folder_.write(name, content), {}, {}));
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(isWhole(*dataset));
    }

    /// What cannot be right is refused.
    void wrongFilesAreRefused()
    {
        QStringList accepted;
        for (const BadFile& file : wrongFiles()) {
            const auto dataset =
                complete(readerOf(file.name.toStdString()).read(folder_.write(file.name, file.content), {}, {}));
            if (dataset)
                accepted << file.name + ": " + file.what;
            else
                QVERIFY2(dataset.error().text().find(file.name.toStdString()) != std::string::npos,
                         dataset.error().text().c_str());
        }
        QVERIFY2(accepted.isEmpty(), qPrintable("\n" + accepted.join('\n')));
    }

    /// What is said is true of the file, says what to do, and shows nothing of this program's memory.
    void reasonsAreTrue_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QByteArray>("told");
        const auto row = [](const char* what, const char* name, const QByteArray& content, const char* told) {
            QTest::newRow(what) << QByteArray(name) << content << QByteArray(told);
        };
        const QByteArray hdf5 = QByteArray("\x89HDF\r\n\x1a\n", 8) + QByteArray(100, '\0');
        row("HDF4", "a.hdf", QByteArray("\x0e\x03\x13\x01", 4) + QByteArray(500, '\0'), "it is an HDF4 file");
        row("HDF5 of others", "a.hdf", hdf5 + "Something", "it does not have the group VTKHDF");
        row("a later type", "a.vtkhdf", hdf5 + "VTKHDF Type PolyData",
            "of the type PolyData, which VTK 9.1 does not read");
        row("a later kind of several files", "a.vtkhdf", hdf5 + "VTKHDF UnstructuredGrid PartitionedDataSetCollection",
            "of the type PartitionedDataSetCollection");
        row("time steps", "a.vtkhdf", hdf5 + "VTKHDF UnstructuredGrid Steps NSteps", "several time steps");
        row("HDF5 that is damaged", "a.vtkhdf", hdf5 + "VTKHDF UnstructuredGrid", "VTK");
        row("a field alone", "a.vtk", "# vtk DataFile Version 2.0\nvalues\nASCII\nFIELD data 1\nx 1 3 float\n1 2 3\n",
            "values alone, without the points or the grid");
        row("a table", "a.vtk", "# vtk DataFile Version 3.0\nvalues\nASCII\nDATASET TABLE\nROW_DATA 1\n",
            "'DATASET TABLE'");
        row("a piece that is missing", "a.pvtu",
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\"><PUnstructuredGrid "
            "GhostLevel=\"0\">"
            "<Piece Source=\"piece.vtu\"/></PUnstructuredGrid></VTKFile>\n",
            "its file 'piece.vtu' is missing");
        const auto blocks = [](const QByteArray& dataSets) {
            return "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>" + dataSets +
                   "</vtkMultiBlockDataSet></VTKFile>";
        };
        row("a block above", "a.vtm", blocks("<DataSet index=\"0\" file=\"below/../../a.vtu\"/>"),
            "is not in its folder");
        row("a block by its whole path", "a.vtm", blocks("<DataSet index=\"0\" file=\"/etc/passwd\"/>"),
            "is not in its folder");
        row("a block above, with blanks", "a.vtm", blocks("<DataSet index=\"0\" file = \"../a.vtu\"/>"),
            "is not in its folder");
        row("a block above, behind what looks like it", "a.vtm",
            blocks("<DataSet name=' file=\"good.vtu\" ' file=\"../a.vtu\"/>"), "is not in its folder");
        row("a piece above", "a.pvti",
            "<VTKFile type=\"PImageData\" version=\"0.1\"><PImageData WholeExtent=\"0 1 0 1 0 1\">"
            "<Piece Extent=\"0 1 0 1 0 1\" Source=\"../a.vti\"/></PImageData></VTKFile>",
            "is not in its folder");
        row("blocks of itself", "a.vtm", blocks(QByteArray("<DataSet index=\"0\" file=\"a.vtm\"/>").repeated(1000)),
            "refers back to it");
        row("a geometry above", "a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: ../a.geo\n",
            "is not in its folder");
        row("a geometry above, behind a word that stands for lists of cases", "a.case",
            "# master_server\nFORMAT\ntype: ensight gold\nGEOMETRY\nmodel: ../a.geo\n", "is not in its folder");
        row("a list of cases", "a.case",
            "FORMAT\ntype: master_server gold\nSERVERS\nnumber of servers: 1\ncasefile: other.case\n",
            "a list of EnSight cases");
        row("numbers of files beyond all", "a.case",
            "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: 1 a**.geo\nTIME\ntime set: 1\nnumber of steps: 3\n"
            "filename start number: 9223372036854775807\nfilename increment: 9223372036854775807\n"
            "time values: 0 1 2\n",
            "is missing");
        row("a geometry that is missing", "a.case", "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: no.geo\n",
            "its file 'no.geo' is missing");
        row("a section that VTK does not know", "a.case",
            "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: no.geo\nMATERIAL\nmaterial set number: 1\n", "'MATERIAL'");
        row("variables without end", "a.case",
            "FORMAT\ntype: ensight gold\nGEOMETRY\nmodel: no.geo\nVARIABLE\n" +
                QByteArray("scalar per node: v no.heat\n").repeated(5001),
            "names more than 5000 variables");
        row("components without end", "a.vtu",
            with(vtuText(), "NumberOfComponents=\"1\"", "NumberOfComponents=\"4294967297\""), "4294967297 components");
        row("elements in one another without end", "a.vti",
            "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\" version=\"1.0\">" + QByteArray("<a>").repeated(300'000),
            "deep");
        QByteArray attributes = "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\"";
        for (int n = 0; n < 100'000; ++n)
            attributes += " a" + QByteArray::number(n) + "=\"1\"";
        row("attributes without end", "a.vtu", attributes + ">", "damaged or cut short");
        row("attributes of an image without end", "a.vti",
            QByteArray(attributes).replace("UnstructuredGrid", "ImageData") + ">", "attributes");
        row("more cells than bytes", "a.vtu", with(vtuText(), "NumberOfCells=\"2\"", "NumberOfCells=\"1000000000\""),
            "too short for 1000000000 numbers");
        row("text that is none", "a.vtu",
            "<?xml version=\"1.0\"?><VTKFile type=\"UnstructuredGrid\">" + QByteArray(1000, '\0'),
            "damaged or cut short");
        row("text of points that is none", "a.vtp",
            "<?xml version=\"1.0\"?><VTKFile type=\"PolyData\">" + QByteArray(1000, '\0'),
            "TAn cannot tell whether the file is damaged");
        row("more points than bytes", "a.vtp", with(vtpText(), "NumberOfPoints=\"5\"", "NumberOfPoints=\"1000000000\""),
            "1000000000 points or cells");
        row("Tecplot that is cut", "hang.tec",
            "TITLE=\"TEST\"\nVARIABLES=\"X\",\"Y\",\"Z\",\"P\"\nZONE T=\"ZONE1\", N=", "ends within its header");
        row("an unknown dataset", "a.vtk", with(legacyText(), "STRUCTURED_POINTS", "TEAPOTS"), "TEAPOTS");
    }
    void reasonsAreTrue()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        QFETCH(QByteArray, told);
        QElapsedTimer timer;
        timer.start();
        const auto dataset = complete(readerOf(name.toStdString()).read(folder_.write(name, content), {}, {}));
        QVERIFY(!dataset.ok());
        const std::string& text = dataset.error().text();
        QVERIFY2(text.find(told.toStdString()) != std::string::npos, text.c_str());
        QVERIFY2(text.find(name.toStdString()) != std::string::npos, text.c_str());
        QVERIFY2(text.find("0x") == std::string::npos && text.find("Debug") == std::string::npos, text.c_str());
        QVERIFY2(text.find(".cxx") == std::string::npos, text.c_str());
        QCOMPARE(int(dataset.error().kind), int(ErrorKind::BadInput));
        QVERIFY(timer.elapsed() < soon(10'000));
    }

    /// VTK reads a file as often as a list of blocks names it, which a small list may do without end.
    void filesThatAreNamedAgainAndAgain()
    {
        folder_.write("again.vti", vtiText());
        const auto listed = [&](const QByteArray& name, const QByteArray& inside, int times) {
            return folder_.write(name, "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>" +
                                           ("<DataSet index=\"0\" file=\"" + inside + "\"/>").repeated(times) +
                                           "</vtkMultiBlockDataSet></VTKFile>");
        };
        const auto errorOf = [&](const std::filesystem::path& path) {
            const auto read = builtVtkReader().read(path, {}, {});
            return read ? std::string() : read.error().text();
        };
        const std::string often = errorOf(listed("often.vtm", "again.vti", 300));
        QVERIFY2(often.find("it lists 1 files 300 times") != std::string::npos, often.c_str());
        const std::string inner = errorOf(listed("inner.vtm", "again.vti", 60));
        QVERIFY2(inner.find("times") == std::string::npos, inner.c_str());
        const std::string outer = errorOf(listed("outer.vtm", "inner.vtm", 60));
        QVERIFY2(outer.find("it lists 2 files 3660 times") != std::string::npos, outer.c_str());
    }

    /// VTK leaves out the last letter of a section of values: a digit, if the bracket stands right behind it.
    void valuesOfFluentKeepTheirLastDigit()
    {
        const auto path = folder_.write(
            "a.cas",
            "(0 \"one tetrahedron\")\n(2 3)\n(10 (0 1 4 0 3))\n(10 (1 1 4 1 3)(\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n))\n"
            "(12 (0 1 1 0))\n(12 (2 1 1 1 2))\n(13 (0 1 4 0))\n"
            "(13 (3 1 4 3 3)(\n1 3 2 1 0\n1 2 4 1 0\n2 3 4 1 0\n1 4 3 1 0\n))\n(45 (2 fluid inside)())\n");
        const auto withValue = [&](const char* value) {
            folder_.write("a.dat", "(33 (1 1 1))\n(300 (1 2 1 0 0 1 1)(\n" + QByteArray(value) + "))\n");
            return builtVtkReader().read(path, {}, {});
        };
        for (const char* whole : {"17\n", "17 "}) {
            const auto read = withValue(whole);
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
            QCOMPARE(read->values.range().minimum, 17.);
        }
        const auto refused = withValue("17");
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().find("drops a digit") != std::string::npos, refused.error().text().c_str());
    }

    /// Some programs call quadratic cells linear; the number of their corners tells.
    void mislabelledQuadraticCellsAreRead()
    {
        const QByteArray corners = "0 0 0 2 0 0 0 2 0 0 0 2 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 0 1 1";
        const QByteArray text =
            "# vtk DataFile Version 3.0\ntest\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 float\n" + corners +
            "\nCELLS 1 11\n10 0 1 2 3 4 5 6 7 8 9\nCELL_TYPES 1\n10\nPOINT_DATA 10\nSCALARS value double 1\n"
            "LOOKUP_TABLE default\n0 1 2 3 4 5 6 7 8 9\n";
        const auto linear = builtVtkReader().read(folder_.write("linear.vtk", text), {}, {});
        const auto quadratic = builtVtkReader().read(
            folder_.write("quadratic.vtk", with(text, "CELL_TYPES 1\n10", "CELL_TYPES 1\n24")), {}, {});
        QVERIFY2(linear.ok(), linear.ok() ? "" : linear.error().text().c_str());
        QVERIFY2(quadratic.ok(), quadratic.ok() ? "" : quadratic.error().text().c_str());
        QCOMPARE(*linear->tetrahedra, *quadratic->tetrahedra);
        QCOMPARE(linear->tetrahedra->size(), std::size_t(8));
        QCOMPARE(linear->remarks.size(), quadratic->remarks.size() + 1);
    }

    /// What may be right by chance is read or refused, for every cut and change.
    void damagedFilesAreReadOrRefused_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("content");
        QTest::newRow("vti") << QByteArray("bad.vti") << vtiText();
        QTest::newRow("vts") << QByteArray("bad.vts") << vtsText();
        QTest::newRow("vtu") << QByteArray("bad.vtu") << vtuText();
        QTest::newRow("vtp") << QByteArray("bad.vtp") << vtpText();
        QTest::newRow("vtk") << QByteArray("bad.vtk") << legacyText();
        QTest::newRow("vtk of cells") << QByteArray("bad.vtk") << legacyMeshText();
        for (const char* name : {"regular/hydrogen.vti", "irregular/disk_out_ref.ex2", "irregular/spx.vtu"}) {
            QFile file(QString::fromStdString((data / name).string()));
            if (file.open(QIODevice::ReadOnly))
                QTest::newRow(name) << "bad" + QByteArray(std::filesystem::path(name).extension().c_str())
                                    << file.readAll();
            else
                noteLack("data");
        }
    }
    void damagedFilesAreReadOrRefused()
    {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, content);
        const auto files = damaged(name, content);
        QVERIFY(!files.empty());
        for (const BadFile& file : files) {
            const auto dataset =
                complete(readerOf(file.name.toStdString()).read(folder_.write(file.name, file.content), {}, {}));
            if (dataset)
                QVERIFY2(isWhole(*dataset), file.what.constData());
            else
                QVERIFY2(dataset.error().text().find(file.name.toStdString()) != std::string::npos,
                         dataset.error().text().c_str());
        }
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkBadFilesTest)
#include "vtk_bad_files_test.moc"
