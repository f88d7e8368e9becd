// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ranges>
#include <type_traits>

// VTK XML files of one piece: appended raw, little endian, 64-bit headers.

namespace tetra {
namespace {

/// An array of a VTK XML file.
struct XmlArray {
    std::string name;
    std::string_view type; ///< vtkXmlType()
    std::uint64_t bytes = 0;
    int components = 1;
    std::function<Status(OutputFile& out)> write; ///< exactly `bytes` bytes, little endian
};

/// PointData, Points, Cells ..., with its arrays.
struct XmlElement {
    std::string name;
    std::string attributes; ///< with a blank before each
    std::vector<XmlArray> arrays;
};

/// A grid of one piece. `numbers` are the piece's attributes: how many points it has, and so on.
struct XmlGrid {
    std::string type; ///< UnstructuredGrid, PolyData
    std::string numbers;
    MeshFacts facts;
    std::vector<XmlElement> elements;
};

/// Text as the value of an attribute. What XML cannot hold becomes a question mark.
std::string xmlAttribute(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
        switch (c) {
        case '&': escaped += "&amp;"; break;
        case '<': escaped += "&lt;"; break;
        case '>': escaped += "&gt;"; break;
        case '"': escaped += "&quot;"; break;
        default: escaped += static_cast<unsigned char>(c) < ' ' ? '?' : c;
        }
    return escaped;
}

/// Text within a comment, which must not hold two hyphens in a row, nor end with one.
std::string xmlComment(std::string_view text)
{
    std::string written = xmlAttribute(text);
    for (std::size_t at = 0; (at = written.find("--", at)) != std::string::npos; at += 2)
        written.insert(at + 1, 1, ' ');
    return written;
}

/// A number that field data can hold: VTK reads none from "inf".
const double* finiteNumber(const MeshFacts::value_type::second_type& fact)
{
    const auto* number = std::get_if<double>(&fact);
    return number != nullptr && std::isfinite(*number) ? number : nullptr;
}

/// Texts as comments: as field data they would keep meshio from reading the file.
std::string textsOf(const MeshFacts& facts)
{
    std::string text;
    for (const auto& [name, fact] : facts)
        if (finiteNumber(fact) == nullptr)
            text += "<!-- " + xmlComment(name + ": " + factText(fact)) + " -->\n";
    return text;
}

/// Numbers as field data, a value each.
std::string numbersOf(const MeshFacts& facts)
{
    std::string text;
    for (const auto& [name, fact] : facts)
        if (const auto* number = finiteNumber(fact))
            text += "<DataArray type=\"Float64\" Name=\"" + xmlAttribute(name) +
                    "\" NumberOfTuples=\"1\" format=\"ascii\">" + formatNumber(*number) + "</DataArray>\n";
    return text.empty() ? text : "<FieldData>\n" + text + "</FieldData>\n";
}

/// With the number of bytes before them.
std::uint64_t blockBytesOf(const XmlArray& array)
{
    return sizeof array.bytes + array.bytes;
}

std::uint64_t blockBytesOf(const XmlGrid& grid)
{
    std::uint64_t bytes = 0;
    for (const XmlElement& element : grid.elements)
        for (const XmlArray& array : element.arrays)
            bytes += blockBytesOf(array);
    return bytes;
}

/// The block of the last array comes first, and that of the first array last: meshio 5 looks for the first array in the
/// text with the offset of a block, and gives those that it has read other offsets, which may be those of blocks still
/// to come. In this order it finds the right one before them.
std::string headOf(const XmlGrid& grid)
{
    std::string text = "<?xml version=\"1.0\"?>\n" + textsOf(grid.facts) + "<VTKFile type=\"" + grid.type +
                       "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + grid.type + ">\n" +
                       numbersOf(grid.facts) + "<Piece" + grid.numbers + ">\n";
    std::uint64_t offset = blockBytesOf(grid);
    for (const XmlElement& element : grid.elements) {
        text += "<" + element.name + element.attributes + ">\n";
        for (const XmlArray& array : element.arrays) {
            offset -= blockBytesOf(array);
            text += "<DataArray type=\"" + std::string(array.type) + "\" Name=\"" + xmlAttribute(array.name) + "\"" +
                    (array.components > 1 ? " NumberOfComponents=\"" + std::to_string(array.components) + "\"" : "") +
                    " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
        }
        text += "</" + element.name + ">\n";
    }
    return text + "</Piece>\n</" + grid.type + ">\n<AppendedData encoding=\"raw\">\n_";
}

/// Writes the whole file.
Status write(OutputFile& out, const XmlGrid& grid)
{
    out.expect(blockBytesOf(grid));
    if (const Status written = out.text(headOf(grid)); !written)
        return written;
    for (const XmlElement& element : grid.elements | std::views::reverse)
        for (const XmlArray& array : element.arrays | std::views::reverse) {
            if (const Status written = out.bytes(std::as_bytes(std::span(&array.bytes, 1))); !written)
                return written;
            if (const Status written = array.write(out); !written)
                return written;
        }
    return out.text("\n</AppendedData>\n</VTKFile>\n");
}

template <class T> constexpr std::string_view vtkXmlType()
{
    if constexpr (std::is_same_v<T, float>)
        return "Float32";
    else if constexpr (std::is_same_v<T, double>)
        return "Float64";
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return "UInt8";
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return "UInt16";
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return "UInt32";
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return "Int32";
    else
        return "Int64";
}

/// An array that lies in memory as in the file.
template <class T> XmlArray xmlArray(std::string name, std::span<const T> values)
{
    return {std::move(name), vtkXmlType<T>(), values.size_bytes(), 1,
            [values](OutputFile& out) { return out.bytes(std::as_bytes(values)); }};
}

/// An array whose values make(index) gives.
template <class Value, class Make> XmlArray madeXmlArray(std::string name, std::uint64_t count, Make make)
{
    return {std::move(name), vtkXmlType<Value>(), count * sizeof(Value), 1, [count, make](OutputFile& out) {
                return out.records(count, sizeof(Value), [&](std::uint64_t index, std::byte* where) {
                    putNumber(where, static_cast<Value>(make(index)));
                });
            }};
}

// Surfaces: polydata, and the same triangles as cells of an unstructured grid.

constexpr std::uint8_t vtkTriangle = 5;

/// An array of vectors, part by part, in numbers of one type.
template <class Value, class Vector>
XmlArray vectors(std::string name, const SurfaceContent& content, std::span<const Vector> SurfacePart::*which)
{
    std::uint64_t count = 0;
    for (const SurfacePart& part : content.parts)
        count += (part.*which).size();
    constexpr std::size_t bytes = 3 * sizeof(Value);
    return {std::move(name), vtkXmlType<Value>(), count * bytes, 3, [&content, which](OutputFile& out) {
                const auto vector = [which](const SurfacePart& part, std::uint64_t index, std::byte* where) {
                    for (const auto coordinate : (part.*which)[index])
                        putNumber(where, static_cast<Value>(coordinate));
                };
                return out.vertexRecords(content, bytes, vector);
            }};
}

/// The places of vertices, in doubles unless floats hold them.
XmlArray places(std::span<const Eigen::Vector3d> positions)
{
    const auto coordinate = [positions](std::uint64_t i) { return positions[i / 3][static_cast<int>(i % 3)]; };
    XmlArray array = fitFloats(positions) ? madeXmlArray<float>("Points", 3 * positions.size(), coordinate)
                                          : madeXmlArray<double>("Points", 3 * positions.size(), coordinate);
    array.components = 3;
    return array;
}

XmlArray places(const SurfaceContent& content)
{
    return content.positionsFitFloats() ? vectors<float>("Points", content, &SurfacePart::positions)
                                        : vectors<double>("Points", content, &SurfacePart::positions);
}

XmlArray values(const SurfaceContent& content, std::uint64_t count)
{
    return {content.valueName, vtkXmlType<float>(), count * sizeof(float), 1, [&content](OutputFile& out) {
                const auto value = [](const SurfacePart& part, std::uint64_t index, std::byte* where) {
                    putNumber(where, part.value(index));
                };
                return out.vertexRecords(content, sizeof(float), value);
            }};
}

XmlArray colours(const SurfaceContent& content, std::uint64_t count)
{
    constexpr std::size_t bytes = 3;
    return {"colour", vtkXmlType<std::uint8_t>(), count * bytes, 3, [&content](OutputFile& out) {
                const auto colour = [](const SurfacePart& part, std::uint64_t index, std::byte* where) {
                    putNumber(where, colourBytes(part.colourAt(index)));
                };
                return out.vertexRecords(content, bytes, colour);
            }};
}

/// Signed and of 64 bits, as VTK keeps them.
XmlArray connectivity(const SurfaceContent& content, std::uint64_t triangles)
{
    return {"connectivity", vtkXmlType<std::int64_t>(), 3 * triangles * sizeof(std::int64_t), 1,
            [&content](OutputFile& out) {
                const auto triangle = [](const std::array<std::uint64_t, 3>& corners, std::byte* where) {
                    for (const std::uint64_t corner : corners)
                        putNumber(where, static_cast<std::int64_t>(corner));
                };
                return out.triangleRecords(content, 3 * sizeof(std::int64_t), triangle);
            }};
}

XmlElement elementOf(std::string name, const std::vector<NamedArray>& arrays)
{
    XmlElement element{std::move(name), {}, {}};
    if (!arrays.empty())
        element.attributes = " Scalars=\"" + xmlAttribute(arrays.front().name) + "\"";
    for (const NamedArray& array : arrays)
        element.arrays.push_back(
            std::visit([&](const auto& values) { return xmlArray(array.name, values); }, array.values));
    return element;
}

XmlGrid gridOf(const SurfaceContent& content, bool polydata)
{
    const std::uint64_t vertexCount = content.vertexCount(), triangleCount = content.triangleCount();
    const std::string triangles = std::to_string(triangleCount);
    XmlElement pointData{
        "PointData", " Scalars=\"" + xmlAttribute(content.valueName) + "\"", {values(content, vertexCount)}};
    if (content.hasNormals()) {
        pointData.attributes += " Normals=\"Normals\"";
        pointData.arrays.push_back(vectors<float>("Normals", content, &SurfacePart::normals));
    }
    if (content.hasColours())
        pointData.arrays.push_back(colours(content, vertexCount));
    XmlElement cells{polydata ? "Polys" : "Cells", {}, {connectivity(content, triangleCount)}};
    cells.arrays.push_back(madeXmlArray<std::int64_t>("offsets", triangleCount,
                                                      [](std::uint64_t triangle) { return 3 * (triangle + 1); }));
    if (!polydata)
        cells.arrays.push_back(
            madeXmlArray<std::uint8_t>("types", triangleCount, [](std::uint64_t) { return vtkTriangle; }));
    const std::string numbers = " NumberOfPoints=\"" + std::to_string(vertexCount) + "\" ";
    return {polydata ? "PolyData" : "UnstructuredGrid",
            numbers +
                (polydata ? "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
                          : "NumberOfCells=\"") +
                triangles + "\"",
            content.facts,
            {std::move(pointData),
             elementOf("CellData", content.cellArrays),
             {"Points", {}, {places(content)}},
             std::move(cells)}};
}

// Meshes.

constexpr std::uint8_t vtkTetra = 10;

/// `Index` is the type of the numbers of vertices. Points into the content.
template <class Index> XmlGrid gridWith(const MeshContent& content)
{
    const std::span tetrahedra = content.tetrahedra;
    XmlElement cells{"Cells", {}, {}};
    cells.arrays.push_back(
        madeXmlArray<Index>("connectivity", 4 * tetrahedra.size(),
                            [tetrahedra](std::uint64_t index) { return tetrahedra[index / 4][index % 4]; }));
    cells.arrays.push_back(
        madeXmlArray<Index>("offsets", tetrahedra.size(), [](std::uint64_t cell) { return 4 * (cell + 1); }));
    cells.arrays.push_back(
        madeXmlArray<std::uint8_t>("types", tetrahedra.size(), [](std::uint64_t) { return vtkTetra; }));
    return {"UnstructuredGrid",
            " NumberOfPoints=\"" + std::to_string(content.positions.size()) + "\" NumberOfCells=\"" +
                std::to_string(tetrahedra.size()) + "\"",
            content.facts,
            {elementOf("PointData", content.pointArrays),
             elementOf("CellData", content.cellArrays),
             {"Points", {}, {places(content.positions)}},
             std::move(cells)}};
}

XmlGrid gridOf(const MeshContent& content)
{
    // Indices and offsets of one type, as VTK takes them without converting.
    const bool small = std::max(content.positions.size(), 4 * content.tetrahedra.size()) <=
                       static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    return small ? gridWith<std::int32_t>(content) : gridWith<std::int64_t>(content);
}

// Datasets: positions in doubles or, where they hold them exactly, in floats. Read again they are the same points,
// values and tetrahedra.

std::string_view vtkTypeName(SampleType type)
{
    constexpr std::string_view names[] = {"UInt8", "Int8", "UInt16", "Int16", "UInt32", "Int32", "Float32", "Float64"};
    return names[static_cast<std::size_t>(type)];
}

/// Points into the dataset.
XmlGrid gridOf(const Dataset& dataset)
{
    const std::vector<Eigen::Vector3d>& positions = *dataset.positions;
    const auto& tetrahedra = *dataset.tetrahedra;
    const std::uint64_t points = dataset.pointCount(), cells = tetrahedra.size();
    const std::span<const std::byte> samples = dataset.values.bytes();
    const std::string name = dataset.source.valueName.empty() ? "value" : dataset.source.valueName;
    XmlArray values{name, vtkTypeName(dataset.values.type()), samples.size(), 1,
                    [samples](OutputFile& out) { return out.bytes(samples); }};
    const auto corner = [&tetrahedra](std::uint64_t i) { return tetrahedra[i / 4][i % 4]; };
    return {"UnstructuredGrid",
            " NumberOfPoints=\"" + std::to_string(points) + "\" NumberOfCells=\"" + std::to_string(cells) + "\"",
            {},
            {{"PointData", " Scalars=\"" + xmlAttribute(name) + "\"", {std::move(values)}},
             {"Points", {}, {places(positions)}},
             {"Cells",
              {},
              {madeXmlArray<std::int64_t>("connectivity", 4 * cells, corner),
               madeXmlArray<std::int64_t>("offsets", cells, [](std::uint64_t cell) { return 4 * (cell + 1); }),
               madeXmlArray<std::uint8_t>("types", cells, [](std::uint64_t) { return vtkTetra; })}}}};
}

} // namespace

/// `.vtu`: unstructured grids of tetrahedra or of triangles. `.vtp`: polydata. Colours are the array
/// `colour` of the vertices, three bytes each.
class VtkXmlWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Dataset, Message::marked("VTK XML unstructured grids"), {".vtu"}},
                {WrittenContent::Mesh, Message::marked("VTK XML unstructured grids"), {".vtu"}},
                {WrittenContent::Surface, Message::marked("VTK XML polydata"), {".vtp"}},
                {WrittenContent::Surface, Message::marked("VTK XML unstructured grids"), {".vtu"}}};
    }

    Status writeDataset(const Dataset& dataset, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        if (!dataset.tetrahedra || !dataset.positions)
            return Error{ErrorKind::WrongUsage,
                         Message::say("A .vtu file holds a mesh of tetrahedra, and this dataset is not one. Write "
                                      "lattices as .nrrd, curvilinear grids as .xyz, points as .csv.")};
        return write(file, gridOf(dataset));
    }

    Status writeMesh(const MeshContent& content, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        return write(file, gridOf(content));
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        return write(file, gridOf(content, fileEnding(file.target()) == ".vtp"));
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::VtkXmlWriter, tetra::Writer)
