// SPDX-License-Identifier: GPL-3.0-or-later
/// R1, D3: cells of higher order and polyhedra of .vtu files, what is taken of a file of cells, and how many faulty
/// cells it may have.
#include "plugins/readers/cells/cells_file.h"
#include "plugins/readers/cells/cells_reader.h"
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/cells/vtu_text.h"
#include "tests/plugins/readers/world_function.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <map>
#include <span>

using namespace tetra;

namespace {

using Places = std::vector<Eigen::Vector3d>;

const Places cube = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const Places simplex = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const Places wedge = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
const Places pyramid = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}};

/// The corners, then the middles of these edges, then other places.
Places withMiddles(Places places, const std::vector<std::array<std::size_t, 2>>& edges, const Places& others = {})
{
    for (const auto& [from, to] : edges)
        places.push_back((places[from] + places[to]) / 2);
    places.insert(places.end(), others.begin(), others.end());
    return places;
}

const std::vector<std::array<std::size_t, 2>> cubeEdges = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                           {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
const Places cubeFaces = {{0, .5, .5}, {1, .5, .5}, {.5, 0, .5}, {.5, 1, .5}, {.5, .5, 0}, {.5, .5, 1}, {.5, .5, .5}};
const std::vector<std::array<std::size_t, 2>> wedgeEdges = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                                                            {5, 3}, {0, 3}, {1, 4}, {2, 5}};
const std::vector<std::array<std::size_t, 2>> simplexEdges = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

/// More nodes than the corners, anywhere in the cell.
Places withOthers(Places places, std::size_t count)
{
    const std::size_t corners = places.size();
    while (places.size() < count)
        places.push_back(places[0] * 0.5 + places[places.size() % corners] * 0.3 +
                         Eigen::Vector3d::Constant(0.001 * double(places.size())));
    return places;
}

std::string array(const std::string& name, const char* type, const std::string& numbers, const char* more = "")
{
    return "<DataArray type=\"" + std::string(type) + "\" Name=\"" + name + "\" " + more + " format=\"ascii\">" +
           numbers + "</DataArray>\n";
}

/// One cell of a VTK type, with the function of the place at its nodes; they may be numbered in another order.
VtuText cellText(int type, const Places& places, const char* version = "2.2", std::vector<std::size_t> order = {})
{
    VtuText file;
    file.fileAttributes = std::string("type=\"UnstructuredGrid\" version=\"") + version + "\"";
    file.counts = "NumberOfPoints=\"" + std::to_string(places.size()) + "\" NumberOfCells=\"1\"";
    std::string values, positions, nodes;
    for (std::size_t i = 0; i < places.size(); ++i) {
        values += formatNumber(worldFunction(places[i], 1)) + " ";
        for (const double coordinate : places[i])
            positions += formatNumber(coordinate) + " ";
        nodes += std::to_string(order.empty() ? i : order[i]) + " ";
    }
    file.pointData = array("u", "Float64", values);
    file.positions = array("Points", "Float64", positions, "NumberOfComponents=\"3\"");
    file.connectivity = array("connectivity", "Int64", nodes);
    file.offsets = array("offsets", "Int64", std::to_string(places.size()));
    file.types = array("types", "UInt8", std::to_string(type));
    return file;
}

double volumeOf(const Dataset& mesh)
{
    double volume = 0;
    for (const auto& t : *mesh.tetrahedra) {
        const auto at = [&](std::size_t corner) { return mesh.position(t[corner]); };
        volume += (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))) / 6;
    }
    return volume;
}

QString remarksOf(const Dataset& dataset)
{
    QStringList texts;
    for (const Message& remark : dataset.remarks)
        texts << QString::fromStdString(remark.text());
    return texts.join(" ");
}

QString textOf(const std::vector<Taken>& taken)
{
    QStringList texts;
    for (const Taken& part : taken)
        texts << QString::fromStdString(takenText(part).text());
    return texts.join("; ");
}

} // namespace

class CellsShapesTest : public QObject {
    Q_OBJECT

private:
    Result<Dataset> read(const std::string& text, const ParameterValues& values = {}, const char* name = "a.vtu")
    {
        return reader_.read(writtenFile(path(name), text), values, {});
    }
    Result<FileContents> probe(const std::string& text, const ParameterValues& values = {}, const char* name = "a.vtu")
    {
        return reader_.probe(writtenFile(path(name), text), values, {});
    }
    std::filesystem::path path(const char* name) const { return folder_.filePath(name).toStdString(); }

    QTemporaryDir folder_;
    const Reader& reader_ = asLoaded<CellsReader>();

private slots:
    /// VTK's numbers of nodes, in parametric coordinates, are those of its quadratic cells.
    void lagrangeCells_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("volume");
        QTest::addColumn<QString>("remark");
        const auto row = [](const char* name, const VtuText& text, int points, double volume, const char* remark = "") {
            QTest::newRow(name) << QByteArray::fromStdString(text.text()) << points << volume << QString(remark);
        };
        const Places cube27 = withMiddles(cube, cubeEdges, cubeFaces);
        row("tetrahedron, order 1", cellText(71, simplex), 4, 1.0 / 6);
        row("tetrahedron, order 2", cellText(71, withMiddles(simplex, simplexEdges)), 10, 1.0 / 6);
        row("tetrahedron, order 3", cellText(71, withOthers(simplex, 20)), 4, 1.0 / 6,
            "For the Lagrange cells of order 3 (1) only the corners were used");
        row("hexahedron, order 1", cellText(72, cube), 8, 1);
        row("hexahedron, order 2", cellText(72, cube27), 27, 1);
        std::vector<std::size_t> exchanged(27);
        for (std::size_t i = 0; i < 27; ++i)
            exchanged[i] = i == 18 ? 19 : i == 19 ? 18 : i;
        row("hexahedron, order 2, of an old file", cellText(72, cube27, "1.0", exchanged), 27, 1);
        row("hexahedron, order 4", cellText(72, withOthers(cube, 125)), 8, 1,
            "For the Lagrange cells of order 4 (1) only the corners were used");
        row("hexahedron of several orders", cellText(72, withOthers(cube, 12)), 8, 1,
            "For the Lagrange cells whose order differs by direction (1) only the corners were used");
        row("wedge, order 1", cellText(73, wedge), 6, 0.5);
        row("wedge, order 2, 15 nodes", cellText(73, withMiddles(wedge, wedgeEdges)), 15, 0.5);
        const Places wedge18 = withMiddles(wedge, wedgeEdges, {{.5, 0, .5}, {.5, .5, .5}, {0, .5, .5}});
        row("wedge, order 2, 18 nodes", cellText(73, wedge18), 15, 0.5,
            "Nodes in the faces of quadratic cells were not used: in 1 cells.");
        VtuText degrees = cellText(73, wedge18);
        degrees.cellData = array("HigherOrderDegrees", "Float64", "1 1 5", "NumberOfComponents=\"3\"");
        row("wedge of several orders", degrees, 6, 0.5, "whose order differs by direction (1)");
        row("pyramid, order 1", cellText(74, pyramid), 5, 1.0 / 3);
        row("pyramid, order 2", cellText(74, withOthers(pyramid, 14)), 5, 1.0 / 3,
            "For the Lagrange cells of order 2 (1) only the corners were used");
        row("biquadratic wedge", cellText(32, wedge18), 15, 0.5, "Nodes in the faces of quadratic cells");
        row("biquadratic hexahedron",
            cellText(33, withMiddles(cube, cubeEdges, {{.5, 0, .5}, {1, .5, .5}, {.5, 1, .5}, {0, .5, .5}})), 20, 1,
            "Nodes in the faces of quadratic cells");
    }
    void lagrangeCells()
    {
        QFETCH(QByteArray, text);
        QFETCH(int, points);
        QFETCH(double, volume);
        QFETCH(QString, remark);
        const auto mesh = read(text.toStdString());
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->pointCount(), std::uint64_t(points));
        QVERIFY(distanceFromWorld(*mesh, 1) < 1e-12);
        QVERIFY2(std::abs(volumeOf(*mesh) - volume) < 1e-12, qPrintable(QString::number(volumeOf(*mesh))));
        QVERIFY2(remarksOf(*mesh).contains(remark), qPrintable(remarksOf(*mesh)));
        QVERIFY(!remark.isEmpty() || mesh->remarks.empty());
        QCOMPARE(textOf(mesh->source.taken), "array: u");
    }

    /// A hexahedron whose middles were exchanged would have edges that cross it.
    void curvedLagrangeHexahedra()
    {
        Places places = withMiddles(cube, cubeEdges, cubeFaces);
        for (Eigen::Vector3d& place : places) // bent, each edge in its own way
            place += Eigen::Vector3d(0.1 * place[1] * place[2], 0.15 * place[0] * place[2], 0.05 * place[0] * place[1]);
        std::vector<std::array<std::uint32_t, 4>> first;
        for (const int type : {29, 72}) {
            const auto mesh = read(cellText(type, places).text());
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QVERIFY(first.empty() || first == *mesh->tetrahedra);
            first = *mesh->tetrahedra;
        }
    }

    void sharedLagrangeCells()
    {
        for (const auto& [name, points] : {std::pair("lagrange_p1.vtu", 64), std::pair("lagrange_p2.vtu", 316)}) {
            const auto file = sharedCases() / "vtu" / name;
            if (!std::filesystem::exists(file))
                QSKIP_WITHOUT("cases of .vtu");
            const auto mesh = reader_.read(file, {}, {});
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE(mesh->pointCount(), std::uint64_t(points));
            QVERIFY(distanceFromWorld(*mesh, 1) < 1e-9);
            QVERIFY(std::abs(volumeOf(*mesh) - 27) < 1e-9);
            QVERIFY2(mesh->remarks.empty(), qPrintable(remarksOf(*mesh)));
        }
    }

    void shapesAreRefusedByName()
    {
        const auto mistake = [&](const VtuText& text) {
            const auto mesh = read(text.text());
            return mesh ? QString() : QString::fromStdString(mesh.error().text());
        };
        QVERIFY(mistake(cellText(79, cube)).contains("does not support: Bezier hexahedra. Divide"));
        QVERIFY(mistake(cellText(78, simplex)).contains("does not support: Bezier tetrahedra. Divide"));
        QVERIFY(mistake(cellText(41, simplex)).contains("does not support: convex point sets. Divide"));
        QVERIFY(mistake(cellText(250, simplex)).contains("does not support: number 250. Divide"));
        QVERIFY(mistake(cellText(72, simplex)).contains("a cell has 4 points, and its shape needs 8"));
        QVERIFY(mistake(cellText(32, wedge)).contains("a cell has 6 points, and its shape needs 18"));
        QVERIFY(mistake(cellText(42, cube)).contains("it has polyhedra, but not their faces"));
        QVERIFY(mistake(cellText(16, cube)).contains("a cell has 8 points, and its shape needs 12"));
    }

    /// Their faces, each with its number of points before them, and numbered over all pieces.
    void polyhedra()
    {
        const auto complexOf = [](const VtuText& text) { return readVtu(text.text(), {}, {}); };
        VtuText file = cellText(42, simplex);
        const std::string faces = "4 3 0 2 1 3 0 1 3 3 1 2 3 3 0 3 2";
        const auto withFaces = [&](const std::string& numbers, const std::string& ends) {
            VtuText text = file;
            text.types += array("faces", "Int64", numbers) + array("faceoffsets", "Int64", ends);
            return text;
        };
        const auto read = complexOf(withFaces(faces, "17"));
        QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
        QCOMPARE(read->complex.shapes, std::vector{CellShape::Polyhedron});
        QCOMPARE(read->complex.corners, (std::vector<std::uint64_t>{3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2}));
        QCOMPARE(read->complex.offsets, (std::vector<std::uint64_t>{0, 16}));
        for (const auto& [numbers, ends] : {std::pair(faces, "16"),
                                            {faces, "18"},
                                            {faces, "0"},
                                            {faces, "-1"},
                                            {faces, "nan"},
                                            {faces, "1e300"},
                                            {std::string("4 3 0 2 1"), "5"},
                                            {std::string("1 4 0 2 1 9"), "6"},
                                            {std::string("9 3 0 2 1"), "5"},
                                            {std::string("1 18446744073709551615 0 2 1"), "5"}})
            QVERIFY2(!complexOf(withFaces(numbers, ends)), (numbers + " | " + ends).c_str());

        // Beside a tetrahedron, which has no faces.
        VtuText both = withFaces(faces, "-1 17");
        both.counts = R"(NumberOfPoints="4" NumberOfCells="2")";
        both.connectivity = array("connectivity", "Int64", "0 1 2 3 0 1 2 3");
        both.offsets = array("offsets", "Int64", "4 8");
        both.types =
            array("types", "UInt8", "10 42") + array("faces", "Int64", faces) + array("faceoffsets", "Int64", "-1 17");
        const auto mixed = complexOf(both);
        QVERIFY2(mixed.ok(), mixed.ok() ? "" : mixed.error().text().c_str());
        QCOMPARE(mixed->complex.offsets, (std::vector<std::uint64_t>{0, 4, 20}));
    }

    /// As VTK writes them from 9.4 on: a tetrahedron between two polyhedra of four sides that share a face.
    void polyhedraWithListedFaces()
    {
        const auto binary = [](const std::string& name, const std::vector<std::int64_t>& numbers) {
            const std::uint32_t bytes = static_cast<std::uint32_t>(8 * numbers.size());
            QByteArray all(reinterpret_cast<const char*>(&bytes), sizeof bytes);
            all.append(reinterpret_cast<const char*>(numbers.data()), static_cast<qsizetype>(bytes));
            return "<DataArray Name=\"" + name + "\" type=\"Int64\" format=\"binary\">" + all.toBase64().toStdString() +
                   "</DataArray>";
        };
        const auto inWords = [](const std::string& name, const std::vector<std::int64_t>& numbers) {
            std::string text;
            for (const std::int64_t number : numbers)
                text += std::to_string(number) + ' ';
            return array(name, "Int64", text);
        };
        struct Lists {
            std::vector<std::int64_t> points{0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 1, 4, 2, 1, 3, 4, 2, 4, 3};
            std::vector<std::int64_t> ends{3, 6, 9, 12, 15, 18, 21};
            std::vector<std::int64_t> cellFaces{0, 1, 2, 3, 2, 4, 5, 6};
            std::vector<std::int64_t> cellEnds{4, 4, 8};
        };
        const auto read = [&](const Lists& lists, bool isBinary) {
            const auto one = [&](const std::string& name, const std::vector<std::int64_t>& numbers) {
                return isBinary ? binary(name, numbers) : inWords(name, numbers);
            };
            VtuText text = cellText(42, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}});
            text.counts = R"(NumberOfPoints="5" NumberOfCells="3")";
            text.connectivity = array("connectivity", "Int64", "0 1 2 3 0 1 2 3 1 2 3 4");
            text.offsets = array("offsets", "Int64", "4 8 12");
            text.types = array("types", "UInt8", "42 10 42") + one("face_connectivity", lists.points) +
                         one("face_offsets", lists.ends) + one("polyhedron_to_faces", lists.cellFaces) +
                         one("polyhedron_offsets", lists.cellEnds);
            return readVtu(text.text(), {}, {});
        };
        for (const bool isBinary : {false, true}) {
            const auto file = read({}, isBinary);
            QVERIFY2(file.ok(), file.ok() ? "" : file.error().text().c_str());
            QCOMPARE(file->complex.offsets, (std::vector<std::uint64_t>{0, 16, 20, 36}));
            QCOMPARE(file->complex.corners,
                     (std::vector<std::uint64_t>{3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 0, 3, 2, 0, 1,
                                                 2, 3, 3, 1, 2, 3, 3, 1, 4, 2, 3, 1, 3, 4, 3, 2, 4, 3}));
        }
        for (const Lists& wrong :
             {Lists{.cellFaces = {0, 1, 2, 3, 2, 4, 5, 7}}, Lists{.cellFaces = {0, 1, 2, 3, 2, 4, 5}},
              Lists{.cellEnds = {4, 3, 8}}, Lists{.cellEnds = {4, 4}}, Lists{.ends = {3, 6, 9, 12, 15, 18, 22}},
              Lists{.ends = {3, 6, 9, 12, 18, 15, 21}},
              Lists{.points = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 1, 9, 2, 1, 3, 4, 2, 4, 3}},
              Lists{.ends = {3, 6, 9, 12, 15, 18, -1}}})
            for (const bool isBinary : {false, true})
                QVERIFY(!read(wrong, isBinary));
        // One face of many points, used again and again, would need memory by the square of the file.
        Lists bomb{.points = std::vector<std::int64_t>(1000, 1), .ends = {1000}, .cellFaces = {}, .cellEnds = {}};
        bomb.cellFaces.assign(1000, 0);
        bomb.cellEnds = {1000, 1000, 1000};
        const auto refused = read(bomb, true);
        QVERIFY(!refused.ok());
        QVERIFY(QString::fromStdString(refused.error().text()).contains("more often than cells of a mesh can"));
    }

    /// Prisms of more sides: every point of a face lies in its plane, each edge in two faces.
    void prismsOfMoreSides()
    {
        for (const int sides : {5, 6}) {
            Places places;
            for (const int level : {0, 1})
                for (int i = 0; i < sides; ++i)
                    places.emplace_back(std::cos(2 * M_PI * i / sides), std::sin(2 * M_PI * i / sides), level);
            const auto read = readVtu(cellText(sides == 5 ? 15 : 16, places).text(), {}, {});
            QVERIFY2(read.ok(), read.ok() ? "" : read.error().text().c_str());
            QCOMPARE(read->complex.shapes, std::vector{CellShape::Polyhedron});
            const auto& corners = read->complex.corners;
            std::map<std::pair<std::uint64_t, std::uint64_t>, int> edges;
            int faces = 0;
            for (std::size_t at = 0; at < corners.size(); at += corners[at] + 1, ++faces) {
                const std::span face = std::span(corners).subspan(at + 1, corners[at]);
                const Eigen::Vector3d normal =
                    (places[face[1]] - places[face[0]]).cross(places[face[2]] - places[face[0]]).normalized();
                for (std::size_t i = 0; i < face.size(); ++i) {
                    QVERIFY(std::abs(normal.dot(places[face[i]] - places[face[0]])) < 1e-12);
                    ++edges[std::minmax(face[i], face[(i + 1) % face.size()])];
                }
            }
            QCOMPARE(faces, sides + 2);
            QCOMPARE(edges.size(), std::size_t(3 * sides));
            QVERIFY(std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 2; }));
        }
    }

    void whatIsTakenIsTold()
    {
        VtuText file;
        QCOMPARE(textOf(read(file.text())->source.taken), "array: heat");
        file.pointData += array("cold", "Float32", "1 2 3 4 5 7");
        file.pointData +=
            array("U", "Float32", "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18", "NumberOfComponents=\"3\"");
        const auto same = [&](const ParameterValues& values, const QString& taken) {
            const auto mesh = read(file.text(), values);
            QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
            QCOMPARE(textOf(mesh->source.taken), taken);
            QCOMPARE(textOf(probe(file.text(), values)->taken), taken);
        };
        same({}, "array: heat (a guess)");
        same({{"array", std::string("cold")}}, "array: cold");
        same({{"array", std::string("U")}}, "array: U; component: magnitude (a guess)");
        same({{"array", std::string("U")}, {"component", std::string("2")}}, "array: U; component: 2");
        file.pointDataAttributes = " Scalars=\"cold\"";
        same({}, "array: cold");
        // A constant one is passed over, which headers show if they tell ranges.
        file.pointData = array("one", "Float32", "1 1 1 1 1 1", "RangeMin=\"1\" RangeMax=\"1\"") +
                         array("vtkOriginalPointIds", "Int64", "0 1 2 3 4 5") + array("T", "Float32", "1 2 3 4 5 6");
        same({}, "array: T (a guess)");
    }

    void theTimeOfAFileIsTold()
    {
        std::string text = VtuText().text();
        const std::string before = "<UnstructuredGrid>\n";
        text.insert(text.find(before) + before.size(),
                    "<FieldData>" + array("TimeValue", "Float64", "0.25", "NumberOfTuples=\"1\"") + "</FieldData>\n");
        const auto mesh = read(text);
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->source.leftOut.size(), std::size_t(1));
        QCOMPARE(mesh->source.leftOut[0].text(), std::string("It states the time 0.25."));
        QVERIFY(probe(text)->leftOut == mesh->source.leftOut);
    }

    void ucdFilesTellUnits()
    {
        const std::string mesh = "4 1 2 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n1 1 tet 1 2 3 4\n";
        const std::string values = "1 10 5\n2 20 6\n3 30 7\n4 40 8\n";
        const std::string two = mesh + "2 1 1\ntemperature, K\npressure, Pa\n" + values;
        const std::string one = mesh + "1 2\nu, m/s\n" + values;
        const auto check = [&](const std::string& text, const ParameterValues& parameters, const char* taken) {
            const auto dataset = read(text, parameters, "a.inp");
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(textOf(dataset->source.taken), QString(taken));
            QCOMPARE(textOf(probe(text, parameters, "a.inp")->taken), QString(taken));
        };
        check(two, {}, "array: temperature (a guess); unit of the values: K");
        check(two, {{"array", std::string("pressure")}}, "array: pressure; unit of the values: Pa");
        check(one, {}, "array: u; component: magnitude (a guess); unit of the values: m/s");
        QCOMPARE(probe(two, {}, "a.inp")->arrays[1].unit, std::string("Pa"));
        QVERIFY(!probe(two, {{"array", std::string("q")}}, "a.inp"));
    }

    /// Two tetrahedra that lie in one another, beside a hundred that do not.
    void theShareOfFaultyCellsIsSaid()
    {
        Places places;
        std::string nodes, ends, types, values, positions;
        for (int cell = 0; cell < 101; ++cell)
            for (std::size_t corner = 0; corner < 4; ++corner)
                places.push_back(simplex[corner] + Eigen::Vector3d(cell < 100 ? 2.0 * cell : 0.1, 0, 0));
        for (std::size_t i = 0; i < places.size(); ++i) {
            nodes += std::to_string(i) + " ";
            values += std::to_string(i) + " ";
            for (const double coordinate : places[i])
                positions += formatNumber(coordinate) + " ";
        }
        for (int cell = 1; cell <= 101; ++cell) {
            ends += std::to_string(4 * cell) + " ";
            types += "10 ";
        }
        VtuText file;
        file.counts = R"(NumberOfPoints="404" NumberOfCells="101")";
        file.pointData = array("u", "Float64", values);
        file.positions = array("Points", "Float64", positions, "NumberOfComponents=\"3\"");
        file.connectivity = array("connectivity", "Int64", nodes);
        file.offsets = array("offsets", "Int64", ends);
        file.types = array("types", "UInt8", types);
        QVERIFY(!read(file.text()));
        const auto mesh = read(file.text(), {{"faulty", std::string("5%")}});
        QVERIFY2(mesh.ok(), mesh.ok() ? "" : mesh.error().text().c_str());
        QCOMPARE(mesh->faultyCells->size(), std::size_t(1));
        QVERIFY(read(file.text(), {{"faulty", std::string("1")}}));
        QVERIFY(!read(file.text(), {{"faulty", std::string("0.5 %")}}));
        for (const char* text : {"", "few", "-1%", "101%", "nan"}) {
            const auto refused = read(file.text(), {{"faulty", std::string(text)}});
            QVERIFY2(!refused && refused.error().kind == ErrorKind::WrongUsage, text);
        }
        for (const Parameter& parameter : reader_.parameters())
            if (parameter.id == "faulty") {
                QVERIFY(parameter.mistake("5%").empty());
                QVERIFY(!parameter.mistake("half").empty());
            }
    }
};

QTEST_GUILESS_MAIN(CellsShapesTest)
#include "cells_shapes_test.moc"
