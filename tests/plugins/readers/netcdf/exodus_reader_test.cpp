// SPDX-License-Identifier: GPL-3.0-or-later
// Exodus files hold for TAn what their convention says (S6): cells of each shape fill their volume, variables stand at
// their nodes and elements, and nothing moves the mesh that nobody asked for.
#include "tests/lacks.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/readers/netcdf/netcdf_test_files.h"
#include "tests/plugins/readers/world_function.h"

#include <QTest>

#include <map>

using namespace tetra;
namespace fs = std::filesystem;

namespace {

using Places = std::vector<Eigen::Vector3d>;

struct TestBlock {
    const char* type;
    std::vector<int> nodes; ///< from 1
    std::size_t nodesPerElement = 0;
    int id = 1;
};

/// What all Exodus files have; variables are for the test to add. Coordinates together or each alone.
struct ExodusTestFile {
    NetCdfTestFile file;
    int time, nodes, nodeVariables, elementVariables;
    std::vector<int> elements{};

    ExodusTestFile(const fs::path& path, const Places& places, const std::vector<TestBlock>& blocks,
                   const std::vector<std::string>& nodeNames, const std::vector<std::string>& elementNames = {},
                   bool together = false)
        : file(path), time(file.dimension("time_step", 0)), nodes(file.dimension("num_nodes", places.size())),
          nodeVariables(nodeNames.empty() ? -1 : file.dimension("num_nod_var", nodeNames.size())),
          elementVariables(elementNames.empty() ? -1 : file.dimension("num_elem_var", elementNames.size()))
    {
        file.numbers<float>(NC_GLOBAL, "api_version", {5.1F}); // and no file_size
        const int axes = file.dimension("num_dim", 3), length = file.dimension("len_name", 33);
        const int count = file.dimension("num_el_blk", blocks.size());
        std::vector<std::int32_t> ids;
        for (std::size_t at = 0; at < blocks.size(); ++at) {
            const TestBlock& block = blocks[at];
            const std::string number = std::to_string(at + 1);
            elements.push_back(
                file.dimension(("num_el_in_blk" + number).c_str(), block.nodes.size() / block.nodesPerElement));
            const int corners = file.dimension(("num_nod_per_el" + number).c_str(), block.nodesPerElement);
            const int connection = file.define(("connect" + number).c_str(), NC_INT, {elements.back(), corners});
            file.text(connection, "elem_type", block.type);
            file.put(connection, block.nodes);
            ids.push_back(block.id);
        }
        file.add("eb_prop1", {count}, ids);
        if (together)
            file.add("coord", {axes, nodes}, coordinates<float>(places));
        else
            for (int axis = 0; axis < 3; ++axis) {
                const auto all = coordinates<double>(places);
                const auto first = all.begin() + axis * std::ptrdiff_t(places.size());
                file.add((std::string("coord") + "xyz"[axis]).c_str(), {nodes},
                         std::vector<double>(first, first + std::ptrdiff_t(places.size())));
            }
        addNames("name_nod_var", nodeVariables, length, nodeNames);
        addNames("name_elem_var", elementVariables, length, elementNames);
    }

    void addTimes(const std::vector<double>& times) { file.add("time_whole", {time}, times); }

private:
    template <class T> static std::vector<T> coordinates(const Places& places)
    {
        std::vector<T> all;
        for (int axis = 0; axis < 3; ++axis)
            for (const Eigen::Vector3d& place : places)
                all.push_back(static_cast<T>(place[axis]));
        return all;
    }
    void addNames(const char* name, int dimension, int length, const std::vector<std::string>& names)
    {
        if (names.empty())
            return;
        std::vector<char> text;
        for (std::string one : names) {
            one.resize(33, '\0');
            text.insert(text.end(), one.begin(), one.end());
        }
        file.add(name, {dimension, length}, text);
    }
};

double linear(const Eigen::Vector3d& place)
{
    return place[0] + 2 * place[1] + 4 * place[2];
}

template <class T = double> std::vector<T> linearAt(const Places& places, double more = 0)
{
    std::vector<T> values;
    for (const Eigen::Vector3d& place : places)
        values.push_back(static_cast<T>(linear(place) + more));
    return values;
}

std::vector<int> countedFromOne(std::size_t count)
{
    return steps<int>(count, 1, 1);
}

/// Places of a cell's nodes in the order of Exodus: corners, middles of the edges, of the volume, of the faces.
Places nodesOf(const Places& corners, const std::vector<std::array<int, 2>>& edges,
               const std::vector<std::vector<int>>& faces = {})
{
    Places places = corners;
    for (const auto& [a, b] : edges)
        places.push_back((corners[std::size_t(a)] + corners[std::size_t(b)]) / 2);
    if (!faces.empty())
        places.push_back(Eigen::Vector3d(0.5, 0.5, 0.5));
    for (const auto& face : faces) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const int corner : face)
            sum += corners[std::size_t(corner)];
        places.push_back(sum / double(face.size()));
    }
    return places;
}

const Places cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::array<int, 2>> cubeEdges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 5},
                                                {2, 6}, {3, 7}, {4, 5}, {5, 6}, {6, 7}, {7, 4}};
/// Below, above, left, right, in front, behind.
const std::vector<std::vector<int>> cubeFaces{{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 7, 4},
                                              {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}};
const Places wedge{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
const std::vector<std::array<int, 2>> wedgeEdges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 4},
                                                 {2, 5}, {3, 4}, {4, 5}, {5, 3}};
const Places pyramid{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}};
const std::vector<std::array<int, 2>> pyramidEdges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4}, {1, 4}, {2, 4}, {3, 4}};
const Places tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::array<int, 2>> tetrahedronEdges{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

double volumeOf(const Dataset& dataset)
{
    double sum = 0;
    for (const auto& [a, b, c, d] : *dataset.tetrahedra) {
        const Eigen::Vector3d first = dataset.position(a);
        sum += (dataset.position(b) - first).dot((dataset.position(c) - first).cross(dataset.position(d) - first)) / 6;
    }
    return sum;
}

double distanceFromLinear(const Dataset& dataset, double more = 0)
{
    double largest = 0;
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        largest = std::max(largest, std::abs(dataset.values.at(point) - linear(dataset.position(point)) - more));
    return largest;
}

/// Two cubes side by side along x, of a block each.
const Places twoCubes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1},
                      {1, 1, 1}, {0, 1, 1}, {2, 0, 0}, {2, 1, 0}, {2, 0, 1}, {2, 1, 1}};
const std::vector<TestBlock> twoBlocks{{"HEX8", {1, 2, 3, 4, 5, 6, 7, 8}, 8, 10},
                                       {"hex", {2, 9, 10, 3, 6, 11, 12, 7}, 8, 20}};

} // namespace

class ExodusReaderTest : public QObject {
    Q_OBJECT

private slots:
    void shapesFillTheirVolume_data()
    {
        QTest::addColumn<QString>("type");
        QTest::addColumn<double>("volume");
        places_.clear();
        const auto row = [&](const char* name, const char* type, const Places& places, double volume) {
            QTest::newRow(name) << QString(type) << volume;
            places_[name] = places;
        };
        row("hexahedron", "HEX8", cube, 1);
        row("hexahedron, in small letters", "hexahedron", cube, 1);
        row("hexahedron of 20", "HEX20", nodesOf(cube, cubeEdges), 1);
        row("hexahedron of 27", "HEX27", nodesOf(cube, cubeEdges, cubeFaces), 1);
        row("tetrahedron", "TETRA", tetrahedron, 1. / 6);
        row("tetrahedron of 10", "TETRA10", nodesOf(tetrahedron, tetrahedronEdges), 1. / 6);
        row("wedge", "WEDGE", wedge, 0.5);
        row("wedge of 15", "WEDGE15", nodesOf(wedge, wedgeEdges), 0.5);
        row("pyramid", "PYRAMID5", pyramid, 1. / 3);
        row("pyramid of 13", "PYRAMID13", nodesOf(pyramid, pyramidEdges), 1. / 3);
    }
    void shapesFillTheirVolume()
    {
        QFETCH(QString, type);
        QFETCH(double, volume);
        const Places& places = places_.at(QTest::currentDataTag());
        const std::string name = type.toStdString();
        {
            ExodusTestFile exodus(path(), places, {{name.c_str(), countedFromOne(places.size()), places.size()}}, {"q"},
                                  {}, true);
            exodus.file.add("vals_nod_var1", {exodus.time, exodus.nodes}, linearAt<float>(places));
        }
        const auto dataset = builtNetCdfReader().read(path(), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QVERIFY(dataset->domain == DomainClass::Irregular);
        QCOMPARE(dataset->pointCount(), std::uint64_t(places.size()));
        QVERIFY(dataset->values.type() == SampleType::Float32);
        QCOMPARE(volumeOf(*dataset), volume);
        QVERIFY(distanceFromLinear(*dataset) < 1e-6);
        QVERIFY(dataset->remarks.empty());
        const std::size_t least = places.size() > 8 ? 6 : 1; // quadratic cells are cut through all their nodes
        QVERIFY(dataset->tetrahedra->size() >= least);
    }

    void polyhedra()
    {
        {
            ExodusTestFile exodus(path(), cube, {{"nfaced", {1}, 1}}, {"q"});
            NetCdfTestFile& file = exodus.file;
            const int faces = file.dimension("num_fa_in_blk1", 6);
            file.dimension("num_fa_blk", 1);
            const int faceNodes = file.dimension("num_nod_per_fa1", 24), list = file.dimension("num_fac_per_el1", 6);
            std::vector<int> nodes;
            for (const auto& face : cubeFaces)
                for (const int corner : face)
                    nodes.push_back(corner + 1);
            file.add("fbconn1", {faceNodes}, nodes);
            file.add("fbepecnt1", {faces}, std::vector<int>(6, 4));
            file.text(file.add("facconn1", {list}, countedFromOne(6)), "elem_type", "NFACED");
            file.text(file.add("ebepecnt1", {exodus.elements[0]}, std::vector<int>{6}), "entity_type1", "FACE");
            file.add("vals_nod_var1", {exodus.time, exodus.nodes}, linearAt(cube));
        }
        const auto dataset = builtNetCdfReader().read(path(), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(volumeOf(*dataset), 1.);
        QVERIFY(distanceFromLinear(*dataset) < 1e-12);
    }

    /// All variables in one array, as old files have them.
    void variablesTogether()
    {
        {
            ExodusTestFile exodus(path(), twoCubes, twoBlocks, {"first", "second"});
            std::vector<float> values;
            for (const double more : {0., 100., 1000., 1100.}) {
                const auto part = linearAt<float>(twoCubes, more);
                values.insert(values.end(), part.begin(), part.end());
            }
            exodus.file.add("vals_nod_var", {exodus.time, exodus.nodeVariables, exodus.nodes}, values);
            exodus.addTimes({0.5, 1.5});
        }
        for (std::int64_t time = 1; time <= 2; ++time) {
            const auto dataset =
                builtNetCdfReader().read(path(), {{"array", std::string("second")}, {"time", time}}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QVERIFY(distanceFromLinear(*dataset, 100. + 1000. * double(time - 1)) < 1e-4);
            QCOMPARE(dataset->pointCount(), std::uint64_t(12));
            QCOMPARE(volumeOf(*dataset), 2.);
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Array), std::string("second"));
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::TimeStep),
                     std::string(time == 1 ? "1 of 2, time 0.5" : "2 of 2, time 1.5"));
        }
        const auto contents = builtNetCdfReader().probe(path(), {}, {});
        QVERIFY2(contents.ok(), contents.ok() ? "" : contents.error().text().c_str());
        QCOMPARE(contents->timeSteps, (std::vector<double>{0.5, 1.5}));
        QCOMPARE(contents->blocks, (std::vector<std::string>{"block 10", "block 20"}));
        QCOMPARE(contents->arrays.size(), std::size_t(2));
        QCOMPARE(takenOf(contents->taken, TakenPart::Array), std::string("first ?"));
    }

    /// A program that was stopped leaves what the library fills files with: no values.
    void whatNobodyWrote()
    {
        for (const bool isNamed : {false, true}) {
            {
                ExodusTestFile exodus(path(), twoCubes, twoBlocks, {"step", "half"});
                std::vector<double> values = linearAt<double>(twoCubes);
                for (const char* name : {"vals_nod_var1", "vals_nod_var2"}) {
                    const int variable = exodus.file.define(name, NC_DOUBLE, {exodus.time, exodus.nodes});
                    if (isNamed)
                        exodus.file.numbers<double>(variable, "_FillValue", {-1});
                    exodus.file.put(variable, std::vector<double>(12, isNamed ? -1 : NC_FILL_DOUBLE));
                    for (std::size_t node = 0; node < 12; ++node)
                        if (twoCubes[node][0] > 1.5)
                            values[node] = isNamed ? -1 : NC_FILL_DOUBLE;
                    if (std::string(name) == "vals_nod_var2")
                        exodus.file.put(variable, values);
                }
            }
            const auto dataset = builtNetCdfReader().read(path(), {}, {});
            QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Array), std::string("half ?"));
            QCOMPARE(dataset->bounds().max(), Eigen::Vector3d(1, 1, 1)); // the other cube is a hole
            QVERIFY(distanceFromLinear(*dataset, 0) < 1e-12);
            QCOMPARE(takenOf(dataset->source.taken, TakenPart::Fill),
                     isNamed ? std::string("-1")
                             : "9.96921e+36, with which the NetCDF library fills what was never written ?");
            const auto nothing = builtNetCdfReader().read(path(), {{"array", std::string("step")}}, {});
            QVERIFY(!nothing.ok());
            QVERIFY2(nothing.error().text().find("finite") != std::string::npos, nothing.error().text().c_str());
        }
    }

    void valuesOfElementsAndParts()
    {
        {
            ExodusTestFile exodus(path(), twoCubes, twoBlocks, {}, {"both", "one"});
            exodus.file.add("vals_elem_var1eb1", {exodus.time, exodus.elements[0]}, std::vector<double>{3});
            exodus.file.add("vals_elem_var1eb2", {exodus.time, exodus.elements[1]}, std::vector<double>{5});
            exodus.file.add("vals_elem_var2eb2", {exodus.time, exodus.elements[1]}, std::vector<double>{7});
        }
        const auto both = builtNetCdfReader().read(path(), {}, {});
        QVERIFY2(both.ok(), both.ok() ? "" : both.error().text().c_str());
        std::map<double, double> byX; // the mean of the cells around
        for (std::uint64_t point = 0; point < both->pointCount(); ++point)
            byX[both->position(point)[0]] = both->values.at(point);
        QCOMPARE(byX, (std::map<double, double>{{0, 3}, {1, 4}, {2, 5}}));
        const auto one = builtNetCdfReader().read(path(), {{"array", std::string("one")}}, {});
        QVERIFY2(one.ok(), one.ok() ? "" : one.error().text().c_str());
        QCOMPARE(one->pointCount(), std::uint64_t(8));
        QVERIFY(std::ranges::any_of(one->remarks, [](const Message& remark) {
            return remark.text() == "1 of its blocks has no 'one' and was left out.";
        }));
        for (const char* part : {"1", "block 10", "10", "Unnamed block ID: 10"}) {
            const auto alone = builtNetCdfReader().read(path(), {{"part", std::string(part)}}, {});
            QVERIFY2(alone.ok(), alone.ok() ? "" : alone.error().text().c_str());
            QCOMPARE(alone->bounds().max(), Eigen::Vector3d(1, 1, 1));
            QCOMPARE(takenOf(alone->source.taken, TakenPart::Block), std::string("block 10"));
        }
        const auto none = builtNetCdfReader().read(path(), {{"part", std::string("30")}}, {});
        QVERIFY(!none.ok() && none.error().kind == ErrorKind::WrongUsage);
        QVERIFY2(none.error().text().find("block 10, block 20") != std::string::npos, none.error().text().c_str());
    }

    /// Names in x, y, z are one array, which has several names.
    void vectors()
    {
        {
            ExodusTestFile exodus(path(), cube, {{"HEX8", countedFromOne(8), 8}}, {"vel_x", "vel_y", "vel_z", "T"});
            const char* const names[] = {"vals_nod_var1", "vals_nod_var2", "vals_nod_var3", "vals_nod_var4"};
            for (std::size_t part = 0; part < 3; ++part)
                exodus.file.add(names[part], {exodus.time, exodus.nodes},
                                std::vector<double>(8, std::array{2., 3., 6.}[part]));
            exodus.file.add(names[3], {exodus.time, exodus.nodes}, linearAt(cube));
        }
        const auto value = [&](const char* array, const char* component) {
            const auto dataset = builtNetCdfReader().read(
                path(), {{"array", std::string(array)}, {"component", std::string(component)}}, {});
            return dataset ? dataset->values.at(3) : -1;
        };
        QCOMPARE(value("vel", "magnitude"), 7.);
        QCOMPARE(value("vel_", "magnitude"), 7.); // as ParaView calls it
        QCOMPARE(value("vel", "1"), 3.);
        QCOMPARE(value("vel_z", "magnitude"), 6.);
        QCOMPARE(value("1", "0"), 2.);
        QCOMPARE(value("vel", "3"), -1.);
        const auto automatic = builtNetCdfReader().read(path(), {}, {});
        QVERIFY(automatic.ok());
        QCOMPARE(takenOf(automatic->source.taken, TakenPart::Array), std::string("T ?"));
        const auto componentOf = [&](const ParameterValues& values) {
            const auto dataset = builtNetCdfReader().read(path(), values, {});
            return dataset ? takenOf(dataset->source.taken, TakenPart::Component) : dataset.error().text();
        };
        const std::pair<const std::string, ParameterValue> velocity("array", std::string("vel"));
        QCOMPARE(componentOf({velocity}), std::string("magnitude ?"));
        QCOMPARE(componentOf({velocity, {"component", std::string("magnitude")}}), std::string("magnitude"));
        QCOMPARE(componentOf({velocity, {"component", std::string("1")}}), std::string("vel_y"));
    }

    void displacementsAreForTheUser()
    {
        {
            ExodusTestFile exodus(path(), cube, {{"HEX8", countedFromOne(8), 8}}, {"dispx", "dispy", "dispz", "T"});
            const char* const names[] = {"vals_nod_var1", "vals_nod_var2", "vals_nod_var3"};
            for (std::size_t axis = 0; axis < 3; ++axis)
                exodus.file.add(names[axis], {exodus.time, exodus.nodes},
                                std::vector<double>(8, 10. * double(axis + 1)));
            exodus.file.add("vals_nod_var4", {exodus.time, exodus.nodes}, linearAt(cube));
        }
        const auto still = builtNetCdfReader().read(path(), {}, {});
        QVERIFY2(still.ok(), still.ok() ? "" : still.error().text().c_str());
        QCOMPARE(still->bounds().max(), Eigen::Vector3d(1, 1, 1));
        QCOMPARE(still->source.leftOut.size(), std::size_t(1));
        QVERIFY(still->source.leftOut[0].text().find("displacements ('disp')") != std::string::npos);
        const auto moved = builtNetCdfReader().read(path(), {{"displace", true}}, {});
        QVERIFY2(moved.ok(), moved.ok() ? "" : moved.error().text().c_str());
        QCOMPARE(moved->bounds().max(), Eigen::Vector3d(11, 21, 31));
        QVERIFY(moved->source.leftOut.empty());
        QCOMPARE(takenOf(moved->source.taken, TakenPart::Places), std::string("moved by 'disp'"));
    }

    void flatBlocksAreLeftOut()
    {
        std::vector<TestBlock> blocks = twoBlocks;
        blocks.push_back({"SHELL4", {1, 2, 3, 4}, 4, 30});
        {
            ExodusTestFile exodus(path(), twoCubes, blocks, {"q"});
            exodus.file.add("vals_nod_var1", {exodus.time, exodus.nodes}, linearAt(twoCubes));
        }
        const auto dataset = builtNetCdfReader().read(path(), {}, {});
        QVERIFY2(dataset.ok(), dataset.ok() ? "" : dataset.error().text().c_str());
        QCOMPARE(volumeOf(*dataset), 2.);
        QCOMPARE(dataset->source.leftOut.size(), std::size_t(1));
        const auto surface = builtNetCdfReader().read(path(), {{"part", std::string("30")}}, {});
        QVERIFY2(surface.ok(), surface.ok() ? "" : surface.error().text().c_str());
        QVERIFY(surface->domain == DomainClass::Scattered);
        QCOMPARE(distanceFromLinear(*surface), 0.);
    }

    void refusals_data()
    {
        QTest::addColumn<int>("which");
        QTest::addColumn<QString>("words");
        QTest::newRow("no values") << 0 << "it is a mesh without results";
        QTest::newRow("a node that is not there") << 1 << "contains number 9, and there are 8";
        QTest::newRow("a shape that is not known") << 2 << "of a shape that TAn does not support: FOO";
        QTest::newRow("values that are not there") << 3 << "has no values of it";
    }
    void refusals()
    {
        QFETCH(int, which);
        QFETCH(QString, words);
        {
            std::vector<int> nodes = countedFromOne(8);
            if (which == 1)
                nodes[7] = 9;
            ExodusTestFile exodus(path(), cube, {{which == 2 ? "foo" : "HEX8", nodes, 8}},
                                  which == 0 ? std::vector<std::string>{} : std::vector<std::string>{"q"});
            if (which != 3)
                exodus.file.add("vals_nod_var1", {exodus.time, exodus.nodes}, linearAt(cube));
        }
        const auto dataset = builtNetCdfReader().read(path(), {}, {});
        QVERIFY(!dataset.ok());
        QVERIFY2(dataset.error().text().find(words.toStdString()) != std::string::npos, dataset.error().text().c_str());
    }

    void sharedCases_()
    {
        const fs::path folder = sharedCases() / "exodus";
        if (!fs::exists(folder))
            QSKIP_WITHOUT("../shared/cases");
        const auto plain = builtNetCdfReader().read(folder / "a3_0.e", {}, {});
        QVERIFY2(plain.ok(), plain.ok() ? "" : plain.error().text().c_str());
        QCOMPARE(plain->pointCount(), std::uint64_t(8));
        QCOMPARE(plain->values.range().minimum, 100.);
        QCOMPARE(plain->values.range().maximum, 107.);
        const auto still = builtNetCdfReader().read(folder / "displaced.e", {{"time", std::int64_t(2)}}, {});
        QVERIFY2(still.ok(), still.ok() ? "" : still.error().text().c_str());
        QCOMPARE(still->bounds().max()[0], 3.);
        const auto moved =
            builtNetCdfReader().read(folder / "displaced.e", {{"time", std::int64_t(2)}, {"displace", true}}, {});
        QVERIFY2(moved.ok(), moved.ok() ? "" : moved.error().text().c_str());
        QCOMPARE(moved->bounds().max()[0], 4.5);
    }

private:
    fs::path path() const { return folder_.path("mesh.e"); }

    NetCdfFolder folder_;
    std::map<std::string, Places> places_;
};

QTEST_GUILESS_MAIN(ExodusReaderTest)
#include "exodus_reader_test.moc"
