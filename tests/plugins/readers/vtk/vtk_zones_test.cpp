// SPDX-License-Identifier: GPL-3.0-or-later
// Files of several parts: grids that meet become one mesh, whose values and places are those of the whole; grids that
// overlap do not; and where all parts make no mesh, one of them can be taken.
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

#include <array>
#include <set>

using namespace tetra;

namespace {

using Size = std::array<int, 3>;

double valueAt(const Eigen::Vector3d& place)
{
    return place[0] + 10 * place[1] + 100 * place[2];
}

/// Bent along z, in numbers that are exact.
Eigen::Vector3d bent(int i, int j, int k)
{
    return {double(i), double(j), k + 0.25 * (i % 2)};
}

QByteArray numberText(double number)
{
    return QByteArray::number(number, 'g', 17) + ' ';
}

QByteArray arrayText(const char* name, int components, const QByteArray& numbers)
{
    return QByteArray("<DataArray type=\"Float64\" Name=\"") + name + "\" NumberOfComponents=\"" +
           QByteArray::number(components) + "\" format=\"ascii\">" + numbers + "</DataArray>";
}

/// A structured grid of so many points that begins at i = `from`.
QByteArray gridText(const Size& size, int from, const char* name = "t")
{
    QByteArray places, values;
    for (int k = 0; k < size[2]; ++k)
        for (int j = 0; j < size[1]; ++j)
            for (int i = from; i < from + size[0]; ++i) {
                const Eigen::Vector3d place = bent(i, j, k);
                for (const double coordinate : place)
                    places += numberText(coordinate);
                values += numberText(valueAt(place));
            }
    const QByteArray extent = "0 " + QByteArray::number(size[0] - 1) + " 0 " + QByteArray::number(size[1] - 1) + " 0 " +
                              QByteArray::number(size[2] - 1);
    return "<VTKFile type=\"StructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\"><StructuredGrid "
           "WholeExtent=\"" +
           extent + "\"><Piece Extent=\"" + extent + "\"><PointData>" + arrayText(name, 1, values) +
           "</PointData><Points>" + arrayText("Points", 3, places) + "</Points></Piece></StructuredGrid></VTKFile>\n";
}

/// Image data of 3 x 3 x 3 points from x = `from` on, whose cells have all the same value.
QByteArray cellsText(int from, double value)
{
    QByteArray values;
    for (int cell = 0; cell < 8; ++cell)
        values += numberText(value);
    return "<VTKFile type=\"ImageData\" version=\"0.1\" byte_order=\"LittleEndian\"><ImageData WholeExtent=\"0 2 0 2 0 "
           "2\" Origin=\"" +
           QByteArray::number(from) + " 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"0 2 0 2 0 2\"><CellData>" +
           arrayText("c", 1, values) + "</CellData></Piece></ImageData></VTKFile>\n";
}

/// A tetrahedron on each side of x = 0, and with `faulty` another one in the place of the first.
QByteArray meshText(bool faulty, int shift)
{
    QByteArray places, values;
    const std::vector<Eigen::Vector3d> points{{0, 0, 0}, {0, 1, 0},  {0, 0, 1},
                                              {1, 0, 0}, {-1, 0, 0}, {0.5, 0.25, 0.25}};
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Vector3d place = point + Eigen::Vector3d(shift, 0, 0);
        places += numberText(place[0]) + numberText(place[1]) + numberText(place[2]) + '\n';
        values += numberText(valueAt(place));
    }
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 double\n" + places +
           (faulty ? "CELLS 3 15\n4 0 1 2 3\n4 0 2 1 4\n4 0 1 2 5\nCELL_TYPES 3\n10 10 10\n"
                   : "CELLS 2 10\n4 0 1 2 3\n4 0 2 1 4\nCELL_TYPES 2\n10 10\n") +
           "POINT_DATA 6\nSCALARS t double 1\nLOOKUP_TABLE default\n" + values + "\n";
}

QByteArray blocksText(const std::vector<QByteArray>& files)
{
    QByteArray text = "<VTKFile type=\"vtkMultiBlockDataSet\" version=\"1.0\"><vtkMultiBlockDataSet>";
    for (std::size_t file = 0; file < files.size(); ++file)
        text += "<DataSet index=\"" + QByteArray::number(int(file)) + "\" name=\"" + files[file].left(1) +
                "\" file=\"" + files[file] + "\"/>";
    return text + "</vtkMultiBlockDataSet></VTKFile>\n";
}

QByteArray listText(const std::vector<QByteArray>& files)
{
    QByteArray text = "<VTKFile type=\"Collection\" version=\"0.1\"><Collection>";
    for (const QByteArray& file : files)
        text += "<DataSet timestep=\"0\" name=\"" + file.left(1) + "\" file=\"" + file + "\"/>";
    return text + "</Collection></VTKFile>\n";
}

double volumeOf(const Dataset& mesh)
{
    double volume = 0;
    for (const auto& corners : *mesh.tetrahedra) {
        const Eigen::Vector3d a = mesh.position(corners[0]);
        volume +=
            (mesh.position(corners[1]) - a).dot((mesh.position(corners[2]) - a).cross(mesh.position(corners[3]) - a)) /
            6;
    }
    return volume;
}

bool says(const std::vector<Message>& messages, const std::string& text)
{
    return std::ranges::any_of(messages,
                               [&](const Message& one) { return one.text().find(text) != std::string::npos; });
}

} // namespace

class VtkZonesTest : public QObject {
    Q_OBJECT

private slots:
    /// Points on one place are one, as in the whole.
    void gridsThatMeetAreOneMesh()
    {
        folder_.write("a.vts", gridText({4, 3, 3}, 0));
        folder_.write("b.vts", gridText({3, 3, 3}, 3));
        const auto mesh = read("two.vtm", blocksText({"a.vts", "b.vts"}));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QVERIFY(mesh->domain == DomainClass::Irregular);
        QCOMPARE(mesh->pointCount(), std::uint64_t(6 * 3 * 3));
        std::set<std::array<double, 3>> places;
        for (std::uint64_t point = 0; point < mesh->pointCount(); ++point) {
            const Eigen::Vector3d place = mesh->position(point);
            QCOMPARE(mesh->values.at(point), valueAt(place));
            places.insert({place[0], place[1], place[2]});
        }
        QCOMPARE(places.size(), std::size_t(6 * 3 * 3));
        QVERIFY(std::abs(volumeOf(*mesh) - 5 * 2 * 2) < 1e-9);
        QVERIFY(says(mesh->remarks, "Its 2 zones were joined into one mesh, in which they share 4 faces."));
        QCOMPARE(leftOutOf(mesh->source.leftOut), QString());
        const auto contents = builtVtkReader().probe(folder_.path() / "two.vtm", {}, {});
        QVERIFY(contents.ok());
        QVERIFY(contents->domain == DomainClass::Irregular);
        QCOMPARE(contents->points, std::uint64_t(7 * 3 * 3));
        QCOMPARE(contents->blocks, (std::vector<std::string>{"a", "b"}));
    }

    void oneGridCanBeTaken()
    {
        folder_.write("a.vts", gridText({4, 3, 3}, 0));
        folder_.write("b.vts", gridText({3, 3, 3}, 3));
        const auto grid = read("two.vtm", blocksText({"a.vts", "b.vts"}), {{"part", std::string("b")}});
        QVERIFY2(grid.ok(), grid.ok() ? "" : grid.error().text().c_str());
        QVERIFY(grid->domain == DomainClass::Curvilinear);
        QCOMPARE(grid->pointCount(), std::uint64_t(27));
        QCOMPARE(takenOf(grid->source.taken), QString("array: t; block: b"));
        QCOMPARE(leftOutOf(grid->source.leftOut), QString("1 other part is not read: a."));
    }

    /// Flat grids are no volumes, and grids without the values stay apart.
    void onlyVolumesWithTheValuesAreJoined()
    {
        folder_.write("a.vts", gridText({4, 3, 3}, 0));
        folder_.write("b.vts", gridText({3, 3, 3}, 3));
        folder_.write("c.vts", gridText({3, 3, 1}, 0));
        folder_.write("d.vts", gridText({3, 3, 3}, 5, "other"));
        const auto mesh = read("four.vtm", blocksText({"c.vts", "a.vts", "d.vts", "b.vts"}));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->pointCount(), std::uint64_t(6 * 3 * 3));
        QCOMPARE(takenOf(mesh->source.taken), QString("array: t; block: a, b"));
        QCOMPARE(leftOutOf(mesh->source.leftOut),
                 QString("1 other part has no 't' and is not read: d. 1 other part is not read: c."));
        const auto alone = read("alone.vtm", blocksText({"c.vts", "a.vts", "d.vts"}));
        QVERIFY2(alone.ok(), alone.ok() ? "" : alone.error().text().c_str());
        QVERIFY(alone->domain == DomainClass::Curvilinear);
        QCOMPARE(takenOf(alone->source.taken), QString("array: t; block: a"));
    }

    /// The mean of all cells around a point, of whichever grid they are.
    void valuesOfCellsMeetAtTheirBorder()
    {
        folder_.write("a.vti", cellsText(0, 1));
        folder_.write("b.vti", cellsText(2, 5));
        const auto mesh = read("cells.vtm", blocksText({"a.vti", "b.vti"}));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->pointCount(), std::uint64_t(5 * 3 * 3));
        for (std::uint64_t point = 0; point < mesh->pointCount(); ++point) {
            const double x = mesh->position(point)[0];
            QCOMPARE(mesh->values.at(point), x < 2 ? 1. : x > 2 ? 5. : 3.);
        }
    }

    /// They make no mesh: the first is read, as if it were alone, and the reason is told.
    void gridsThatOverlapAreNotJoined()
    {
        folder_.write("a.vti", cellsText(0, 1));
        folder_.write("b.vti", with(cellsText(0, 5), "Origin=\"0 0 0\"", "Origin=\"0.75 0.25 0.25\""));
        const auto grid = read("over.vtm", blocksText({"a.vti", "b.vti"}));
        QVERIFY2(grid.ok(), grid.ok() ? "" : grid.error().text().c_str());
        QVERIFY(grid->domain == DomainClass::RegularLattice);
        QCOMPARE(grid->pointCount(), std::uint64_t(27));
        QCOMPARE(takenOf(grid->source.taken), QString("array: c; block: a (a guess)"));
        QVERIFY2(says(grid->source.leftOut, "Its grids do not make a mesh together, and only the first one is read."),
                 qPrintable(leftOutOf(grid->source.leftOut)));
    }

    /// The refusal says which parts there are, and the others can be read without the faulty one.
    void aFaultyPartCanBeLeftOut()
    {
        folder_.write("g.vtk", meshText(false, 0));
        folder_.write("f.vtk", meshText(true, 5));
        const auto all = read("gf.pvd", listText({"g.vtk", "f.vtk"}));
        QVERIFY(!all.ok());
        QVERIFY2(all.error().text().ends_with("It has 2 parts, of which 'part' takes one: g, f."),
                 all.error().text().c_str());
        const auto good = read("gf.pvd", listText({"g.vtk", "f.vtk"}), {{"part", std::string("g")}});
        QVERIFY2(good.ok(), good.ok() ? "" : good.error().text().c_str());
        QCOMPARE(good->tetrahedra->size(), std::size_t(2));
        const auto faulty = read("gf.pvd", listText({"g.vtk", "f.vtk"}), {{"part", std::string("f")}});
        QVERIFY(!faulty.ok());
        QVERIFY(faulty.error().text().find("of which 'part'") == std::string::npos);
    }

    /// A grid and an irregular mesh beside it.
    void gridsAndMeshesAreJoined()
    {
        folder_.write("a.vts", gridText({3, 3, 3}, 0));
        folder_.write("m.vtk", meshText(false, 9));
        const auto mesh = read("am.pvd", listText({"a.vts", "m.vtk"}));
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->pointCount(), std::uint64_t(27 + 5));
        for (std::uint64_t point = 0; point < mesh->pointCount(); ++point)
            QCOMPARE(mesh->values.at(point), valueAt(mesh->position(point)));
        QVERIFY(std::abs(volumeOf(*mesh) - (8 + 1. / 3)) < 1e-9);
    }

private:
    Result<Dataset> read(const QByteArray& name, const QByteArray& content, const ParameterValues& values = {})
    {
        return builtVtkReader().read(folder_.write(name, content), values, {});
    }

    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkZonesTest)
#include "vtk_zones_test.moc"
