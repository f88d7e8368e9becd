// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/file_saving.h"
#include "plugins/readers/cells/cells_reader.h"
#include "tests/plugins/as_loaded.h"
#include "tests/plugins/plugins_of_this_build.h"
#include "tests/plugins/readers/cells/vtu_text.h"

#include <QByteArray>
#include <QTemporaryDir>
#include <QTest>

#include <zlib.h>

#include <cstring>
#include <random>

using namespace tetra;

namespace {

template <class Number> std::string bytesOf(const std::vector<Number>& numbers)
{
    return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)};
}
std::string base64(const std::string& bytes)
{
    return QByteArray::fromStdString(bytes).toBase64().toStdString();
}
std::string packed(const std::string& bytes)
{
    uLongf size = compressBound(bytes.size());
    std::string result(size, '\0');
    compress(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
             bytes.size());
    result.resize(size);
    return result;
}

const std::vector<float> heat = {1, 2, 3, 4, 5, 6};
const std::vector<double> places = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, .5, .5, 1, 2, .5, .5};
const std::vector<std::int64_t> corners = {0, 1, 2, 3, 4, 1, 5, 2, 4};
const std::vector<std::int64_t> ends = {5, 9};
const std::vector<std::uint8_t> types = {14, 10};

/// A way to write the numbers of arrays.
struct Encoding {
    bool zip, appended, encoded, bigEndian, wideHeaders;

    template <class Number> std::string bytes(const std::vector<Number>& numbers) const
    {
        std::string result = bytesOf(numbers);
        if (bigEndian)
            for (auto at = result.begin(); at != result.end(); at += std::ptrdiff_t(sizeof(Number)))
                std::reverse(at, at + std::ptrdiff_t(sizeof(Number)));
        return result;
    }
    std::string header(const std::vector<std::uint64_t>& numbers) const
    {
        return wideHeaders ? bytes(numbers) : bytes(std::vector<std::uint32_t>(numbers.begin(), numbers.end()));
    }
    /// A block of an array with its header.
    std::string block(const std::string& content) const
    {
        if (!zip) {
            const std::string whole = header({content.size()}) + content;
            return encoded ? base64(whole) : whole;
        }
        // In two blocks, the second one shorter.
        const std::size_t first = content.size() * 2 / 3;
        const std::string a = packed(content.substr(0, first)), b = packed(content.substr(first));
        const std::string head = header({2, first, content.size() - first, a.size(), b.size()});
        return encoded ? base64(head) + base64(a + b) : head + a + b;
    }
};

/// The same mesh with its arrays in another way.
std::string encodedText(const Encoding& way)
{
    VtuText file;
    file.fileAttributes = R"(type="UnstructuredGrid" version="1.0")";
    file.fileAttributes += way.bigEndian ? R"( byte_order="BigEndian")" : R"( byte_order="LittleEndian")";
    if (way.wideHeaders)
        file.fileAttributes += R"( header_type="UInt64")";
    if (way.zip)
        file.fileAttributes += " compressor=\"vtkZLibDataCompressor\"";
    std::string data;
    const auto array = [&](const std::string& attributes, const std::string& bytes) {
        const std::string content = way.block(bytes);
        if (!way.appended)
            return "<DataArray " + attributes + " format=\"binary\">\n  " + content + "\n</DataArray>";
        const std::string tag =
            "<DataArray " + attributes + " format=\"appended\" offset=\"" + std::to_string(data.size()) + "\"/>";
        data += content;
        return tag;
    };
    file.pointData = array("type=\"Float32\" Name=\"heat\"", way.bytes(heat));
    file.positions = array("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", way.bytes(places));
    file.connectivity = array("type=\"Int64\" Name=\"connectivity\"", way.bytes(corners));
    file.offsets = array("type=\"Int64\" Name=\"offsets\"", way.bytes(ends));
    file.types = array("type=\"UInt8\" Name=\"types\"", way.bytes(types));
    if (way.appended)
        file.after = std::string("<AppendedData encoding=\"") + (way.encoded ? "base64" : "raw") + "\">\n_" + data +
                     "</AppendedData>\n";
    return file.text();
}

} // namespace

class CellsReaderTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    const Reader& reader_ = asLoaded<CellsReader>();

    std::filesystem::path file(const char* name, const std::string& text) const
    {
        return writtenFile(std::filesystem::path(folder_.path().toStdString()) / name, text);
    }
    void expectMesh(const Result<Dataset>& dataset) const
    {
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), 6);
        QCOMPARE(dataset->tetrahedra->size(), 3);
        for (std::size_t point = 0; point < 6; ++point) {
            QCOMPARE(dataset->values.at(point), static_cast<double>(heat[point]));
            for (int k = 0; k < 3; ++k)
                QCOMPARE((*dataset->positions)[point][k], places[3 * point + std::size_t(k)]);
        }
    }

private slots:
    /// As other readers do it: what shows the values can say which they are.
    void theNameSaysWhichArray()
    {
        const auto dataset = reader_.read(file("named.vtu", VtuText().text()), {}, {});
        QVERIFY(dataset.ok());
        QCOMPARE(QString::fromStdString(dataset->source.name), QString("named.vtu, heat"));
    }

    void text() { expectMesh(reader_.read(file("text.vtu", VtuText().text()), {}, {})); }

    /// R1: each way in which VTK writes arrays, on machines of either byte order, with headers of either width.
    void encodings()
    {
        for (int way = 0; way < 32; ++way) {
            const Encoding encoding{.zip = (way & 1) != 0,
                                    .appended = (way & 2) != 0,
                                    .encoded = (way & 4) != 0,
                                    .bigEndian = (way & 8) != 0,
                                    .wideHeaders = (way & 16) != 0};
            if (encoding.appended || encoding.encoded)
                expectMesh(reader_.read(file("encoded.vtu", encodedText(encoding)), {}, {}));
            QVERIFY2(!QTest::currentTestFailed(), qPrintable(QString("way %1").arg(way)));
        }
    }

    /// A prism has two orders, of which neither is turned over.
    void prismsOfEitherOrder()
    {
        VtuText text;
        text.counts = R"(NumberOfPoints="6" NumberOfCells="1")";
        text.positions = R"(<DataArray type="Float32" NumberOfComponents="3" format="ascii">
            0 0 0 1 0 0 0 1 0 0 0 1 1 0 1 0 1 1</DataArray>)";
        text.offsets = R"(<DataArray type="Int32" Name="offsets" format="ascii">6</DataArray>)";
        text.types = R"(<DataArray type="UInt8" Name="types" format="ascii">13</DataArray>)";
        for (const char* corners : {"0 1 2 3 4 5", "0 2 1 3 5 4"}) {
            text.connectivity = std::string(R"(<DataArray type="Int32" Name="connectivity" format="ascii">)") +
                                corners + "</DataArray>";
            const auto dataset = reader_.read(file("prism.vtu", text.text()), {}, {});
            QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
            QCOMPARE(dataset->tetrahedra->size(), 3);
            for (const Message& remark : dataset->remarks)
                QVERIFY2(remark.text().find("orientation") == std::string::npos, remark.text().c_str());
        }
        // Of other cells it is told.
        text.connectivity = R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 2 1 3</DataArray>)";
        text.offsets = R"(<DataArray type="Int32" Name="offsets" format="ascii">4</DataArray>)";
        text.types = R"(<DataArray type="UInt8" Name="types" format="ascii">10</DataArray>)";
        const auto turned = reader_.read(file("turned.vtu", text.text()), {}, {});
        QVERIFY2(turned.ok(), turned ? "" : turned.error().text().c_str());
        QVERIFY(std::ranges::any_of(turned->remarks, [](const Message& remark) {
            return remark.text().find("orientation") != std::string::npos;
        }));
    }

    void arraysAndComponents()
    {
        VtuText text;
        text.pointData = R"(<DataArray type="Int32" Name="v" NumberOfComponents="2" format="ascii">
            3 4 3 4 3 4 3 4 3 4 6 8</DataArray>)" +
                         text.pointData;
        text.cellData =
            R"(<DataArray type="Float64" Name="c" RangeMin="7" RangeMax="9" format="ascii">7 9</DataArray>)";
        const auto path = file("arrays.vtu", text.text());
        const auto range = [&](const std::string& array, const std::string& component) {
            const auto dataset = reader_.read(path, {{"array", array}, {"component", component}}, {});
            return dataset ? dataset->values.range() : ValueRange{-1, -1};
        };
        QCOMPARE(range("", "magnitude").maximum, 6.0); // of one component before several
        QCOMPARE(range("v", "magnitude").maximum, 10.0);
        QCOMPARE(range("1", "magnitude").maximum, 10.0);
        QCOMPARE(range("3", "magnitude").maximum, 9.0);
        QCOMPARE(range("v", "0").maximum, 6.0);
        QCOMPARE(range("v", "1").minimum, 4.0);
        QCOMPARE(range("heat", "magnitude").maximum, 6.0);
        QCOMPARE(range("c", "magnitude").maximum, 9.0);
        QCOMPARE(range("c", "magnitude").minimum, 7.0);
        const auto name = [&](const std::string& array, const std::string& component) {
            const auto dataset = reader_.read(path, {{"array", array}, {"component", component}}, {});
            return dataset ? dataset->source.name : dataset.error().text();
        };
        QCOMPARE(name("heat", "magnitude"), std::string("arrays.vtu, heat"));
        QCOMPARE(name("v", "magnitude"), std::string("arrays.vtu, v (magnitude)"));
        QCOMPARE(name("1", "0"), std::string("arrays.vtu, v (component 0)"));
        const auto unknown = reader_.read(path, {{"array", std::string("x")}}, {});
        QCOMPARE(unknown.error().kind, ErrorKind::WrongUsage);
        QVERIFY(unknown.error().text().find("v, heat, c") != std::string::npos);
        QCOMPARE(reader_.read(path, {{"array", std::string("v")}, {"component", std::string("2")}}, {}).error().kind,
                 ErrorKind::WrongUsage);

        const auto contents = reader_.probe(path, {}, {});
        QVERIFY(contents.ok());
        QCOMPARE(contents->points, 6);
        QCOMPARE(contents->cells, 2);
        QCOMPARE(contents->arrays.size(), 3);
        QCOMPARE(contents->arrays[0].components, 2);
        QVERIFY(contents->arrays[2].perCell);
        QCOMPARE(contents->arrays[2].range->maximum, 9.0);
    }

    void hiddenCells()
    {
        VtuText text;
        text.cellData = R"(<DataArray type="UInt8" Name="vtkGhostType" format="ascii">0 32</DataArray>)";
        const auto dataset = reader_.read(file("ghost.vtu", text.text()), {}, {});
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->tetrahedra->size(), 2);
    }

    /// As VTK blanks grids out; cells at a hidden point go with it.
    void hiddenPoints()
    {
        VtuText text;
        text.pointData += R"(<DataArray type="UInt8" Name="vtkGhostType" format="ascii">0 0 0 0 0 2</DataArray>)";
        const auto dataset = reader_.read(file("hidden.vtu", text.text()), {}, {});
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->tetrahedra->size(), 2);
        QCOMPARE(dataset->pointCount(), 5);
    }

    void ghostLevelsOfOldFiles()
    {
        VtuText text;
        text.cellData = R"(<DataArray type="UInt8" Name="vtkGhostLevels" format="ascii">0 1</DataArray>)";
        const auto dataset = reader_.read(file("levels.vtu", text.text()), {}, {});
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->tetrahedra->size(), 2);
        QCOMPARE(QString::fromStdString(dataset->source.name), QString("levels.vtu, heat"));
    }

    /// Without a choice: what the file calls active, but for arrays that do not vary.
    void theArrayThatSuitsBestIsTaken()
    {
        const auto nameOf = [&](const VtuText& text) {
            const auto dataset = reader_.read(file("best.vtu", text.text()), {}, {});
            return dataset ? QString::fromStdString(dataset->source.name).section(", ", 1) : QString();
        };
        VtuText text;
        const std::string numbers =
            R"(<DataArray type="Int32" Name="GlobalNodeId" format="ascii">1 2 3 4 5 6</DataArray>)";
        const std::string constant = R"(<DataArray type="Float32" Name="one" format="ascii">1 1 1 1 1 1</DataArray>)";
        const std::string second = R"(<DataArray type="Float32" Name="cold" format="ascii">6 5 4 3 2 1</DataArray>)";
        text.pointData = numbers + constant + text.pointData + second;
        QCOMPARE(nameOf(text), QString("heat"));
        text.pointDataAttributes = R"( Scalars="cold")";
        QCOMPARE(nameOf(text), QString("cold"));
        text.pointDataAttributes = R"( Scalars="one")";
        QCOMPARE(nameOf(text), QString("heat"));
        text.pointData = numbers + constant;
        QCOMPARE(nameOf(text), QString("one"));
        text.pointData = numbers;
        QCOMPARE(nameOf(text), QString("GlobalNodeId"));
    }

    /// Some programs call quadratic cells linear; the number of their corners tells.
    void mislabelledQuadraticCells()
    {
        VtuText text;
        text.counts = R"(NumberOfPoints="10" NumberOfCells="1")";
        text.pointData = R"(<DataArray type="Float32" Name="heat" format="ascii">0 1 2 3 4 5 6 7 8 9</DataArray>)";
        text.positions = R"(<DataArray type="Float32" NumberOfComponents="3" format="ascii">
            0 0 0 2 0 0 0 2 0 0 0 2 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 0 1 1</DataArray>)";
        text.connectivity =
            R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4 5 6 7 8 9</DataArray>)";
        text.offsets = R"(<DataArray type="Int32" Name="offsets" format="ascii">10</DataArray>)";
        const auto typed = [&](const char* type) {
            text.types = std::string(R"(<DataArray type="UInt8" Name="types" format="ascii">)") + type + "</DataArray>";
            return reader_.read(file("quadratic.vtu", text.text()), {}, {});
        };
        const auto linear = typed("10"), quadratic = typed("24");
        QVERIFY2(linear.ok(), linear ? "" : linear.error().text().c_str());
        QVERIFY2(quadratic.ok(), quadratic ? "" : quadratic.error().text().c_str());
        QCOMPARE(*linear->tetrahedra, *quadratic->tetrahedra);
        QCOMPARE(linear->remarks.size(), quadratic->remarks.size() + 1);
        QVERIFY(linear->remarks[0].text().starts_with("1 cell is declared linear"));
    }

    void longIntegers()
    {
        const auto readWith = [&](const char* last) {
            VtuText text;
            text.pointData =
                std::string(R"(<DataArray type="Int64" Name="n" format="ascii">-1 2 3 4 5 )") + last + "</DataArray>";
            return reader_.read(file("long.vtu", text.text()), {}, {});
        };
        const auto fitting = readWith("6"), tooLong = readWith("6000000000");
        QVERIFY2(fitting.ok(), fitting ? "" : fitting.error().text().c_str());
        QVERIFY2(tooLong.ok(), tooLong ? "" : tooLong.error().text().c_str());
        QCOMPARE(fitting->values.type(), SampleType::Int32);
        QCOMPARE(tooLong->values.type(), SampleType::Float64);
        QCOMPARE(tooLong->remarks.size(), fitting->remarks.size() + 1);
    }

    /// Files of points alone, and of what has no volume, are scattered points.
    void pointsWithoutCells()
    {
        VtuText text;
        text.connectivity = R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 4 5</DataArray>)";
        text.offsets = R"(<DataArray type="Int32" Name="offsets" format="ascii">1 6</DataArray>)";
        text.types = R"(<DataArray type="UInt8" Name="types" format="ascii">1 2</DataArray>)";
        const auto points = reader_.read(file("points.vtu", text.text()), {}, {});
        QVERIFY2(points.ok(), points ? "" : points.error().text().c_str());
        QCOMPARE(points->domain, DomainClass::Scattered);
        QCOMPARE(points->pointCount(), 6);
        QCOMPARE(points->values.range().maximum, 6.0);
        QVERIFY(points->remarks.empty());
        QCOMPARE(QString::fromStdString(points->source.name), QString("points.vtu, heat"));

        text.types = R"(<DataArray type="UInt8" Name="types" format="ascii">1 7</DataArray>)";
        text.pointData = R"(<DataArray type="Float32" Name="heat" format="ascii">1 nan 3 4 5 6</DataArray>)";
        const auto polygon = reader_.read(file("polygon.vtu", text.text()), {}, {});
        QVERIFY2(polygon.ok(), polygon ? "" : polygon.error().text().c_str());
        QCOMPARE(polygon->pointCount(), 5);
        QCOMPARE(polygon->remarks.size(), 2);

        text.cellData = R"(<DataArray type="Float32" Name="c" format="ascii">1 2</DataArray>)";
        const auto perCell = reader_.read(file("polygon.vtu", text.text()), {{"array", std::string("c")}}, {});
        QVERIFY(!perCell.ok());
        QVERIFY2(perCell.error().text().find("Choose an array of points") != std::string::npos,
                 perCell.error().text().c_str());
    }

    /// What is written is read again as the same.
    void roundTrip()
    {
        const auto first = reader_.read(file("first.vtu", VtuText().text()), {}, {});
        QVERIFY(first.ok());
        for (const bool doubles : {false, true}) {
            Dataset dataset = *first;
            auto positions = *first->positions;
            if (doubles)
                positions[5][1] += 0x1p-40;
            dataset.positions = std::make_shared<const std::vector<Eigen::Vector3d>>(positions);
            const auto path = std::filesystem::path(folder_.path().toStdString()) / "again.vtu";
            QVERIFY(saveDataset(pluginsOfThisBuild(), dataset, path).ok());
            const auto again = reader_.read(path, {}, {});
            QVERIFY2(again.ok(), again ? "" : again.error().text().c_str());
            QVERIFY(*again->positions == positions);
            QVERIFY(*again->tetrahedra == *first->tetrahedra);
            QCOMPARE(again->values.type(), SampleType::Float32);
            QVERIFY(std::ranges::equal(again->values.bytes(), first->values.bytes()));
        }
        Dataset points = *first;
        points.tetrahedra = nullptr;
        QCOMPARE(saveDataset(pluginsOfThisBuild(), points, "x.vtu").error().kind, ErrorKind::WrongUsage);
    }

    void ucd()
    {
        const std::string text = "# a comment\n6 3 3 1 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n15 .5 .5 1\n6 2 .5 .5\n"
                                 "1 1 pyr 15 1 2 3 4\n2 1 tet 2 6 3 15\n3 line 1 2\n"
                                 "2 1 2\nheat, K\nwind, m/s\n1 1 3 4\n2 2 3 4\n3 3 3 4\n4 4 3 4\n15 5 3 4\n6 6 3 4\n"
                                 "1 1\nmaterial,\n1 1\n2 2\n3 3\n";
        const auto path = file("mesh.inp", text);
        expectMesh(reader_.read(path, {}, {}));
        const auto wind = reader_.read(path, {{"array", std::string("wind")}}, {});
        QCOMPARE(wind->values.range().maximum, 5.0);
        const auto material = reader_.read(path, {{"array", std::string("material")}}, {});
        QVERIFY(material.ok());
        QCOMPARE(material->values.range().maximum, 2.0);
        const auto contents = reader_.probe(path, {}, {});
        QCOMPARE(contents->points, 6);
        QCOMPARE(contents->arrays.size(), 3);
        QCOMPARE(contents->arrays[1].name, "wind");
        QVERIFY(contents->arrays[2].perCell);
    }

    /// As of a .vtu: what has no volume gives its points.
    void ucdOfSurfaces()
    {
        const std::string text = "5 2 1 1 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n"
                                 "1 1 tri 1 2 3\n2 1 quad 1 2 5 4\n1 1\nheat, K\n1 1\n2 2\n3 3\n4 4\n5 5\n"
                                 "1 1\nmaterial,\n1 1\n2 2\n";
        const auto path = file("surface.inp", text);
        const auto points = reader_.read(path, {}, {});
        QVERIFY2(points.ok(), points ? "" : points.error().text().c_str());
        QCOMPARE(points->domain, DomainClass::Scattered);
        QCOMPARE(points->pointCount(), std::uint64_t(5));
        QCOMPARE(points->position(4), Eigen::Vector3d(1, 1, 1));
        QCOMPARE(points->values.range().maximum, 5.0);
        QVERIFY(points->remarks[0].text().find("scattered points") != std::string::npos);
        const auto ofCells = reader_.read(path, {{"array", std::string("material")}}, {});
        QVERIFY(!ofCells.ok());
        QVERIFY(ofCells.error().text().find("Choose an array of points") != std::string::npos);
    }

    /// Only the part that is taken has to be sound: two cells that overlap, and one far from them.
    void whatLiesBeyondARegionMayOverlap()
    {
        const auto path = file("overlap.inp", "9 3 1 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 2\n"
                                              "6 10 0 0\n7 11 0 0\n8 10 1 0\n9 10 0 1\n"
                                              "1 1 tet 1 2 3 4\n2 1 tet 1 2 3 5\n3 1 tet 6 7 8 9\n"
                                              "1 1\nheat, K\n1 1\n2 2\n3 3\n4 4\n5 5\n6 6\n7 7\n8 8\n9 9\n");
        QVERIFY(!reader_.read(path, {}, {}).ok());
        const Eigen::AlignedBox3d beside(Eigen::Vector3d(9, -1, -1), Eigen::Vector3d(12, 2, 2));
        const auto dataset = reader_.readAround(beside, path, {}, {});
        QVERIFY2(dataset.ok(), dataset ? "" : dataset.error().text().c_str());
        QCOMPARE(dataset->pointCount(), std::uint64_t(9));
        const Eigen::AlignedBox3d around(Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(2, 2, 2));
        const auto refused = reader_.readAround(around, path, {}, {});
        QVERIFY(!refused.ok());
        QVERIFY2(refused.error().text().find("At least 1 of the mesh's 2 cells are faulty") != std::string::npos,
                 refused.error().text().c_str());
        QCOMPARE(refused.error().file, path);
    }

    void scores()
    {
        const auto score = [&](const char* name, std::string_view text) {
            return reader_.score(name, std::as_bytes(std::span(text)));
        };
        QCOMPARE(score("a.vtu", "<VTKFile type=\"UnstructuredGrid\">"), 0.95);
        QCOMPARE(score("mesh.xml", "<?xml version='1.0'?>\n<VTKFile version='1.0' type='UnstructuredGrid'>"), 0.95);
        QCOMPARE(score("a.vtu", "whatever"), 0.95);
        QCOMPARE(score("a.pvtu", "<VTKFile type=\"PUnstructuredGrid\">"), 0.0);
        QVERIFY(score("a.vtu", "<VTKFile type=\"ImageData\">") < 0.5);
        QCOMPARE(score("a.inp", "#\n 4 1 1 0 0\n"), 0.95);
        QCOMPARE(score("a.inp", "*HEADING\n"), 0.0);
        QCOMPARE(score("a.vti", "<VTKFile type=\"ImageData\">"), 0.0);
    }
};

QTEST_GUILESS_MAIN(CellsReaderTest)
#include "cells_reader_test.moc"
