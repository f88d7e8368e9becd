// SPDX-License-Identifier: GPL-3.0-or-later
// What was taken of a file that VTK reads, what was a guess, and what was left out (D3); probe() says the same as
// read().
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

using namespace tetra;

namespace {

struct Told {
    QString taken;
    QString leftOut;
};

QByteArray dataArray(const QByteArray& name, int components, const QByteArray& values)
{
    return "<DataArray type=\"Float32\" Name=\"" + name + "\" NumberOfComponents=\"" + QByteArray::number(components) +
           "\" format=\"ascii\">" + values + "</DataArray>";
}

/// A grid of 2 x 2 x 2 points; `attributes` of the element PointData.
QByteArray image(const QByteArray& attributes, const QByteArray& pointArrays, const QByteArray& fieldData = {})
{
    return "<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"0 1 0 1 0 1\" Origin=\"0 0 0\" "
           "Spacing=\"1 1 1\">" +
           fieldData + "<Piece Extent=\"0 1 0 1 0 1\"><PointData" + attributes + ">" + pointArrays +
           "</PointData></Piece></ImageData></VTKFile>\n";
}

const QByteArray rising = "0 1 2 3 4 5 6 7";
const QByteArray vectors = rising + " " + rising + " " + rising;

/// Two tetrahedra with a value for each point; `at` moves them along x.
QByteArray legacyMesh(const char* array, int at)
{
    QByteArray points;
    for (const char* place : {"0 0 0", "1 0 0", "0 1 0", "0 0 1", "1 1 1"})
        points += QByteArray::number(at + QByteArray(place).split(' ')[0].toInt()) + QByteArray(place).mid(1) + "\n";
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n" + points +
           "CELLS 2 10\n4 0 1 2 3\n4 4 1 2 3\nCELL_TYPES 2\n10 10\nPOINT_DATA 5\nSCALARS " + QByteArray(array) +
           " float 1\nLOOKUP_TABLE default\n1 2 3 4 5\n";
}

} // namespace

class VtkProvenanceTest : public QObject {
    Q_OBJECT

private slots:
    void arraysAreGuessedUnlessMarkedOrNamed()
    {
        const QByteArray two = dataArray("a", 1, rising) + dataArray("b", 1, rising);
        QCOMPARE(told("one.vti", image("", dataArray("a", 1, rising))).taken, QString("array: a"));
        QCOMPARE(told("two.vti", image("", two)).taken, QString("array: a (a guess)"));
        QCOMPARE(told("two.vti", image(" Scalars=\"b\"", two)).taken, QString("array: b"));
        QCOMPARE(told("two.vti", image("", two), {{"array", std::string("2")}}).taken, QString("array: b"));
        QCOMPARE(told("two.vti", image("", two), {{"array", std::string("automatic")}}).taken,
                 QString("array: a (a guess)"));
        const QByteArray helping = dataArray("a", 1, rising) + dataArray("ObjectId", 1, rising);
        QCOMPARE(told("helping.vti", image("", helping)).taken, QString("array: a"));
    }

    /// Of points and of cells there may be arrays of one name.
    void arraysOfOneNameAreBothListed()
    {
        const QByteArray ofCells = "CELL_DATA 2\nSCALARS a float 1\nLOOKUP_TABLE default\n7 9\n";
        const auto contents = builtVtkReader().probe(folder_.write("both.vtk", legacyMesh("a", 0) + ofCells), {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->arrays.size(), 2u);
        QVERIFY(!contents->arrays[0].perCell && contents->arrays[1].perCell);
        QCOMPARE(contents->arrays[1].range->minimum, 7);
    }

    void componentsAreGuessedUnlessNamed()
    {
        const QByteArray file = image("", dataArray("wind", 3, vectors));
        QCOMPARE(told("v.vti", file).taken, QString("array: wind; component: magnitude (a guess)"));
        QCOMPARE(told("v.vti", file, {{"component", std::string("1")}}).taken, QString("array: wind; component: 1"));
        QCOMPARE(told("v.vti", file, {{"component", std::string("magnitude")}}).taken,
                 QString("array: wind; component: magnitude"));
    }

    void fieldDataAreLeftOut()
    {
        const auto file = image("", dataArray("a", 1, rising),
                                "<FieldData><DataArray type=\"Float64\" Name=\"run\" NumberOfTuples=\"1\" "
                                "format=\"ascii\">3</DataArray></FieldData>");
        const auto dataset = builtVtkReader().read(folder_.write("f.vti", file), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(leftOutOf(dataset->source.leftOut),
                 QString("Field data, which belong to no point or cell, are not read: run."));
    }

    /// Lists of values that belong to something else.
    void arraysOfOtherLengthsAreLeftOut()
    {
        const QByteArray file = legacyMesh("t", 0) + "FIELD more 1\nlong 1 7 float\n1 2 3 4 5 6 7\n";
        const Told all = told("long.vtk", file);
        QCOMPARE(all.taken, QString("array: t"));
        QCOMPARE(all.leftOut, QString("Its array 'long' has 7 values for 5 points and is not read."));
    }

    void partsAreNamed()
    {
        folder_.write("a.vtk", legacyMesh("t", 0));
        folder_.write("b.vtk", legacyMesh("t", 5));
        folder_.write("c.vtk", legacyMesh("other", 10));
        folder_.write("d.vtk",
                      "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 "
                      "0\nPOLYGONS 1 4\n3 0 1 2\nPOINT_DATA 3\nSCALARS t float 1\nLOOKUP_TABLE default\n1 2 "
                      "3\n");
        const auto list = [](const QByteArray& files) {
            QByteArray text = "<VTKFile type=\"Collection\" version=\"0.1\"><Collection>";
            for (const char file : files)
                text += QByteArray("<DataSet timestep=\"0\" name=\"") + file + "\" file=\"" + file + ".vtk\"/>";
            return text + "</Collection></VTKFile>\n";
        };
        const Told joined = told("ab.pvd", list("ab"));
        QCOMPARE(joined.taken, QString("array: t"));
        QCOMPARE(joined.leftOut, QString());
        const Told some = told("abcd.pvd", list("abcd"));
        QCOMPARE(some.taken, QString("array: t; block: a, b"));
        QCOMPARE(some.leftOut, QString("1 other part has no 't' and is not read: c. 1 other part is not read: d."));
        const Told one = told("abcd.pvd", list("abcd"), {{"part", std::string("2")}});
        QCOMPARE(one.taken, QString("array: t; block: b"));
        QCOMPARE(one.leftOut, QString("3 other parts are not read: a, c, d."));
        folder_.write("g.vti", image("", dataArray("t", 1, rising)));
        const Told grid = told("gd.pvd", list("dg").replace("g.vtk", "g.vti"));
        QCOMPARE(grid.taken, QString("array: t; block: g"));
    }

private:
    /// Of read(), after comparing it to that of probe().
    Told told(const QByteArray& name, const QByteArray& content, const ParameterValues& values = {})
    {
        const auto path = folder_.write(name, content);
        const auto dataset = builtVtkReader().read(path, values, {});
        const auto contents = builtVtkReader().probe(path, values, {});
        if (!dataset || !contents)
            return {QString::fromStdString(dataset ? contents.error().text() : dataset.error().text()), {}};
        if (takenOf(contents->taken) != takenOf(dataset->source.taken))
            return {"probe says " + takenOf(contents->taken) + ", read " + takenOf(dataset->source.taken), {}};
        if (leftOutOf(contents->leftOut) != leftOutOf(dataset->source.leftOut))
            return {"probe leaves out: " + leftOutOf(contents->leftOut), leftOutOf(dataset->source.leftOut)};
        return {takenOf(dataset->source.taken), leftOutOf(dataset->source.leftOut)};
    }

    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkProvenanceTest)
#include "vtk_provenance_test.moc"
