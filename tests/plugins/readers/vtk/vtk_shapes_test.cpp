// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of VTK that are no plain shapes of TAn: of Lagrange and Bezier, with nodes in the middle of faces, prisms with
// more sides. Their nodes lie on a box of 2 x 2 x 2; the value of each is a linear function of its place.
#include "tests/plugins/readers/vtk/vtk_test_files.h"

#include <QTest>

#include <cmath>

using namespace tetra;

namespace {

using Places = std::vector<std::array<double, 3>>;

double linear(const Eigen::Vector3d& place)
{
    return place[0] + 10 * place[1] + 100 * place[2];
}

/// One cell of that type of VTK over these nodes, in the form of VTK 9.1, in which Lagrange cells have its numbers.
QByteArray oneCell(int type, const Places& nodes)
{
    const auto count = QByteArray::number(qsizetype(nodes.size()));
    QByteArray points, values, connectivity;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        const auto& [x, y, z] = nodes[n];
        points += QByteArray::number(x) + " " + QByteArray::number(y) + " " + QByteArray::number(z) + "\n";
        values += QByteArray::number(linear({x, y, z}), 'g', 17) + "\n";
        connectivity += QByteArray::number(qsizetype(n)) + " ";
    }
    return "# vtk DataFile Version 5.1\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + count + " double\n" + points +
           "CELLS 2 " + count + "\nOFFSETS vtktypeint64\n0 " + count + "\nCONNECTIVITY vtktypeint64\n" + connectivity +
           "\nCELL_TYPES 1\n" + QByteArray::number(type) + "\nPOINT_DATA " + count +
           "\nSCALARS value double 1\nLOOKUP_TABLE default\n" + values;
}

const Places boxCorners = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}};
const Places tetrahedronCorners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
const Places prismCorners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {0, 2, 2}};
const Places pyramidCorners = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 2}};

Places withMiddles(Places nodes, const std::vector<std::vector<std::size_t>>& groups)
{
    for (const auto& group : groups) {
        std::array<double, 3> sum{};
        for (const std::size_t corner : group)
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += nodes[corner][axis] / double(group.size());
        nodes.push_back(sum);
    }
    return nodes;
}

const std::vector<std::vector<std::size_t>> boxMiddles = {{0, 1},
                                                          {1, 2},
                                                          {2, 3},
                                                          {3, 0},
                                                          {4, 5},
                                                          {5, 6},
                                                          {6, 7},
                                                          {7, 4},
                                                          {0, 4},
                                                          {1, 5},
                                                          {2, 6},
                                                          {3, 7},
                                                          {0, 3, 4, 7},
                                                          {1, 2, 5, 6},
                                                          {0, 1, 4, 5},
                                                          {2, 3, 6, 7},
                                                          {0, 1, 2, 3},
                                                          {4, 5, 6, 7},
                                                          {0, 1, 2, 3, 4, 5, 6, 7}};
const std::vector<std::vector<std::size_t>> tetrahedronMiddles = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};
const std::vector<std::vector<std::size_t>> prismMiddles = {
    {0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}, {0, 1, 3, 4}, {1, 2, 4, 5}, {2, 0, 5, 3}};
const std::vector<std::vector<std::size_t>> pyramidMiddles = {{0, 1}, {1, 2}, {2, 3}, {3, 0},      {0, 4},
                                                              {1, 4}, {2, 4}, {3, 4}, {0, 1, 2, 3}};

double volumeOf(const Dataset& dataset)
{
    double volume = 0;
    for (const auto& [a, b, c, d] : *dataset.tetrahedra) {
        const Eigen::Vector3d o = dataset.position(a);
        volume += (dataset.position(b) - o).dot((dataset.position(c) - o).cross(dataset.position(d) - o)) / 6;
    }
    return volume;
}

} // namespace

class VtkShapesTest : public QObject {
    Q_OBJECT

private slots:
    void shapesFillTheirVolume_data()
    {
        QTest::addColumn<QByteArray>("file");
        QTest::addColumn<int>("nodes"); // that are used
        QTest::addColumn<double>("volume");
        QTest::addColumn<QByteArray>("remark");
        const auto row = [](const char* what, const QByteArray& file, std::size_t nodes, double volume,
                            const char* remark = "") {
            QTest::newRow(what) << file << int(nodes) << volume << QByteArray(remark);
        };
        const double tetrahedron = 8. / 6, prism = 4, pyramid = 8. / 3;
        row("Lagrange tetrahedron of order 1", oneCell(71, tetrahedronCorners), 4, tetrahedron);
        row("Lagrange hexahedron of order 1", oneCell(72, boxCorners), 8, 8);
        row("Lagrange prism of order 1", oneCell(73, prismCorners), 6, prism);
        row("Lagrange pyramid of order 1", oneCell(74, pyramidCorners), 5, pyramid);
        row("Lagrange tetrahedron of order 2", oneCell(71, withMiddles(tetrahedronCorners, tetrahedronMiddles)), 10,
            tetrahedron);
        row("Lagrange hexahedron of order 2", oneCell(72, withMiddles(boxCorners, boxMiddles)), 27, 8);
        row("Lagrange prism of order 2", oneCell(73, withMiddles(prismCorners, prismMiddles)), 15, prism,
            "nodes in the middle of its faces");
        row("Lagrange pyramid of order 2", oneCell(74, withMiddles(pyramidCorners, pyramidMiddles)), 13, pyramid,
            "nodes in the middle of its faces");
        row("triquadratic hexahedron", oneCell(29, withMiddles(boxCorners, boxMiddles)), 27, 8);
        Places biquadratic = withMiddles(boxCorners, boxMiddles);
        biquadratic.resize(24);
        row("biquadratic hexahedron", oneCell(33, biquadratic), 20, 8, "nodes in the middle of its faces");
        row("biquadratic prism", oneCell(32, withMiddles(prismCorners, prismMiddles)), 15, prism,
            "nodes in the middle of its faces");
        Places third = tetrahedronCorners; // of order 3: 20 nodes, of which only the corners are looked at
        for (int n = 0; n < 16; ++n)
            third.push_back({0.1 * n, 0.1, 0.2});
        row("Lagrange tetrahedron of order 3", oneCell(71, third), 4, tetrahedron, "by its corners alone");
        row("Bezier tetrahedron of order 2", oneCell(78, withMiddles(tetrahedronCorners, tetrahedronMiddles)), 4,
            tetrahedron, "by its corners alone");
    }
    void shapesFillTheirVolume()
    {
        QFETCH(QByteArray, file);
        QFETCH(int, nodes);
        QFETCH(double, volume);
        QFETCH(QByteArray, remark);
        const auto dataset = builtVtkReader().read(folder_.write("cell.vtk", file), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), std::uint64_t(nodes));
        QVERIFY(std::abs(volumeOf(*dataset) - volume) < 1e-12);
        for (std::uint64_t point = 0; point < dataset->pointCount(); ++point)
            QVERIFY(std::abs(dataset->values.at(point) - linear(dataset->position(point))) < 1e-12);
        const bool told = std::ranges::any_of(dataset->remarks, [&](const Message& one) {
            return !remark.isEmpty() && one.text().find(remark.toStdString()) != std::string::npos;
        });
        QCOMPARE(told, !remark.isEmpty());
    }

    /// A prism of the orders 1, 1 and 5 has as many nodes as one of order 2.
    void degreesTellTheOrder()
    {
        QByteArray points, values, connectivity;
        for (int n = 0; n < 18; ++n) {
            const auto& [x, y, z] = n < 6 ? prismCorners[std::size_t(n)] : std::array{0.1, 0.1, 0.1 * n};
            points += QByteArray::number(x) + " " + QByteArray::number(y) + " " + QByteArray::number(z) + " ";
            values += QByteArray::number(linear({x, y, z}), 'g', 17) + " ";
            connectivity += QByteArray::number(n) + " ";
        }
        const auto array = [](const QByteArray& type, const QByteArray& name, int components,
                              const QByteArray& numbers) {
            return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                   QByteArray::number(components) + "\" format=\"ascii\">" + numbers + "</DataArray>";
        };
        folder_.write(
            "prism.vtu",
            "<VTKFile type=\"UnstructuredGrid\" version=\"2.2\"><UnstructuredGrid><Piece NumberOfPoints=\"18\" "
            "NumberOfCells=\"1\"><PointData>" +
                array("Float64", "value", 1, values) + "</PointData><CellData HigherOrderDegrees=\"d\">" +
                array("Float64", "d", 3, "1 1 5") + "</CellData><Points>" + array("Float64", "Points", 3, points) +
                "</Points><Cells>" + array("Int64", "connectivity", 1, connectivity) +
                array("Int64", "offsets", 1, "18") + array("UInt8", "types", 1, "73") +
                "</Cells></Piece></UnstructuredGrid></VTKFile>\n");
        const auto list =
            folder_.write("prism.pvd", "<VTKFile type=\"Collection\" version=\"0.1\"><Collection><DataSet "
                                       "file=\"prism.vtu\"/></Collection></VTKFile>\n");
        const auto dataset = builtVtkReader().read(list, {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), std::uint64_t(6));
        QVERIFY(std::abs(volumeOf(*dataset) - 4) < 1e-12);
        QCOMPARE(takenOf(dataset->source.taken), QString("array: value"));
    }

    /// A prism over a pentagon or hexagon is a polyhedron: two bases and its sides.
    void prismsWithMoreSidesArePolyhedra()
    {
        for (const int sides : {5, 6}) {
            Places nodes;
            for (const double z : {0., 1.})
                for (int n = 0; n < sides; ++n)
                    nodes.push_back({std::cos(2 * M_PI * n / sides), std::sin(2 * M_PI * n / sides), z});
            const auto answer =
                foundByHelper(VtkFormat::Legacy, folder_.write("prism.vtk", oneCell(sides + 10, nodes)));
            QVERIFY2(answer.ok(), answer.ok() ? "" : answer.error().text().c_str());
            const FileFindings& found = *answer;
            QVERIFY(found.shapes == std::vector{CellShape::Polyhedron});
            QCOMPARE(found.corners.size(), std::size_t(2 * (sides + 1) + 5 * sides));
            std::vector<int> uses(nodes.size());
            for (std::size_t at = 0; at < found.corners.size(); at += found.corners[at] + 1)
                for (std::size_t corner = at + 1; corner <= at + found.corners[at]; ++corner)
                    ++uses.at(found.corners[corner]);
            QCOMPARE(uses, std::vector<int>(nodes.size(), 3)); // each corner belongs to three faces
        }
    }

    void otherShapesAreNamed()
    {
        const auto dataset = builtVtkReader().read(folder_.write("set.vtk", oneCell(41, boxCorners)), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find("does not support: ConvexPointSet.") != std::string::npos,
                 dataset.error().text().c_str());
    }

private:
    VtkFolder folder_;
};

QTEST_GUILESS_MAIN(VtkShapesTest)
#include "vtk_shapes_test.moc"
