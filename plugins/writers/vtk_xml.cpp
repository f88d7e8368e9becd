// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/vtk_xml.h"

#include "core/base/text.h"
#include "core/mesh/mesh_output.h"
#include "plugins/writers/mesh_formats.h"
#include "plugins/writers/surface_formats.h"

#include <limits>

// Surfaces as VTK XML files: polydata (.vtp), and the same triangles as cells of an unstructured grid (.vtu).

namespace tetra {

namespace {

/// Numbers and texts of one tuple; texts as VTK writes them, by the codes of their bytes.
std::string xmlFacts(const MeshFacts& facts)
{
    if (facts.empty())
        return "";
    std::string text = "<FieldData>\n";
    for (const auto& [name, fact] : facts) {
        const auto* number = std::get_if<double>(&fact);
        text += "<DataArray type=\"" + std::string(number != nullptr ? "Float64" : "String") + "\" Name=\"" +
                xmlAttribute(name) + "\" NumberOfTuples=\"1\" format=\"ascii\">";
        if (number != nullptr)
            text += formatNumber(*number);
        else {
            for (const char c : std::get<std::string>(fact))
                text += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
            text += "0";
        }
        text += "</DataArray>\n";
    }
    return text + "</FieldData>\n";
}

std::string headOf(const XmlGrid& grid)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + grid.type +
                       "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + grid.type + ">\n" +
                       xmlFacts(grid.facts) + "<Piece" + grid.numbers + ">\n";
    std::uint64_t offset = 0;
    for (const XmlElement& element : grid.elements) {
        text += "<" + element.name + element.attributes + ">\n";
        for (const XmlArray& array : element.arrays) {
            text += "<DataArray type=\"" + std::string(array.type) + "\" Name=\"" + xmlAttribute(array.name) + "\"" +
                    (array.components > 1 ? " NumberOfComponents=\"" + std::to_string(array.components) + "\"" : "") +
                    " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
            offset += sizeof(std::uint64_t) + array.bytes;
        }
        text += "</" + element.name + ">\n";
    }
    return text + "</Piece>\n</" + grid.type + ">\n<AppendedData encoding=\"raw\">\n_";
}

} // namespace

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

std::uint64_t bytesOf(const XmlGrid& grid)
{
    std::uint64_t bytes = 0;
    for (const XmlElement& element : grid.elements)
        for (const XmlArray& array : element.arrays)
            bytes += array.bytes;
    return bytes;
}

Status writeVtkXml(MeshOutput& out, const XmlGrid& grid)
{
    if (const Status written = out.text(headOf(grid)); !written)
        return written;
    for (const XmlElement& element : grid.elements)
        for (const XmlArray& array : element.arrays) {
            if (const Status written = out.bytes(std::as_bytes(std::span(&array.bytes, 1))); !written)
                return written;
            if (const Status written = array.write(out); !written)
                return written;
        }
    return out.text("\n</AppendedData>\n</VTKFile>\n");
}

namespace {

constexpr std::uint8_t vtkTriangle = 5;

/// An array of vectors that lie in memory as in the file, part by part.
XmlArray vectors(std::string name, const SurfaceContent& content, std::span<const Eigen::Vector3f> SurfacePart::*which)
{
    std::uint64_t bytes = 0;
    for (const SurfacePart& part : content.parts)
        bytes += (part.*which).size_bytes();
    return {std::move(name), vtkXmlType<float>(), bytes, 3, [&content, which](MeshOutput& out) -> Status {
                for (const SurfacePart& part : content.parts)
                    if (const Status written = out.bytes(std::as_bytes(part.*which)); !written)
                        return written;
                return {};
            }};
}

XmlArray values(const SurfaceContent& content, std::uint64_t count)
{
    return {content.valueName, vtkXmlType<float>(), count * sizeof(float), 1, [&content](MeshOutput& out) {
                const auto value = [](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
                    putNumber(where, valueAt(part, index));
                };
                return partRecords(out, content, vertexCount, sizeof(float), value);
            }};
}

/// Signed and of 64 bits, as VTK keeps them.
XmlArray connectivity(const SurfaceContent& content, std::uint64_t triangles)
{
    return {"connectivity", vtkXmlType<std::int64_t>(), 3 * triangles * sizeof(std::int64_t), 1,
            [&content](MeshOutput& out) {
                const auto triangle = [](const SurfacePart& part, std::uint64_t first, std::uint64_t index,
                                         std::byte* where) {
                    for (const std::uint32_t corner : part.triangles[index])
                        putNumber(where, static_cast<std::int64_t>(first + corner));
                };
                return partRecords(out, content, triangleCount, 3 * sizeof(std::int64_t), triangle);
            }};
}

XmlGrid gridOf(const SurfaceContent& content, bool polydata)
{
    const SurfaceSize size = sizeOf(content);
    const std::string triangles = std::to_string(size.triangles);
    XmlElement pointData{
        "PointData", " Scalars=\"" + xmlAttribute(content.valueName) + "\"", {values(content, size.vertices)}};
    if (hasNormals(content)) {
        pointData.attributes += " Normals=\"Normals\"";
        pointData.arrays.push_back(vectors("Normals", content, &SurfacePart::normals));
    }
    XmlElement cells{polydata ? "Polys" : "Cells", {}, {connectivity(content, size.triangles)}};
    cells.arrays.push_back(madeXmlArray<std::int64_t>("offsets", size.triangles,
                                                      [](std::uint64_t triangle) { return 3 * (triangle + 1); }));
    if (!polydata)
        cells.arrays.push_back(
            madeXmlArray<std::uint8_t>("types", size.triangles, [](std::uint64_t) { return vtkTriangle; }));
    const std::string numbers = " NumberOfPoints=\"" + std::to_string(size.vertices) + "\" ";
    return {polydata ? "PolyData" : "UnstructuredGrid",
            numbers +
                (polydata ? "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
                          : "NumberOfCells=\"") +
                triangles + "\"",
            content.facts,
            {std::move(pointData),
             {"Points", {}, {vectors("Points", content, &SurfacePart::positions)}},
             std::move(cells)}};
}

Status write(const std::filesystem::path& path, const XmlGrid& grid, const Progress& progress)
{
    auto out = MeshOutput::create(path, bytesOf(grid), writingSurfaces, progress);
    if (!out)
        return out.error();
    if (const Status written = writeVtkXml(*out, grid); !written)
        return written;
    return out->commit();
}

} // namespace

Status writeVtp(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    return write(path, gridOf(content, true), progress);
}

Status writeVtuSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    return write(path, gridOf(content, false), progress);
}

namespace {

constexpr std::uint8_t xmlTetra = 10;

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

/// `Index` is the type of the numbers of vertices. Points into the content.
template <class Index> XmlGrid gridOf(const MeshContent& content)
{
    const std::span tetrahedra = content.tetrahedra;
    XmlArray points = xmlArray("Points", std::span<const float>());
    points.components = 3;
    points.bytes = content.positions.size_bytes();
    points.write = [&content](MeshOutput& out) { return out.bytes(std::as_bytes(content.positions)); };
    XmlElement cells{"Cells", {}, {}};
    cells.arrays.push_back(
        madeXmlArray<Index>("connectivity", 4 * tetrahedra.size(),
                            [tetrahedra](std::uint64_t index) { return tetrahedra[index / 4][index % 4]; }));
    cells.arrays.push_back(
        madeXmlArray<Index>("offsets", tetrahedra.size(), [](std::uint64_t cell) { return 4 * (cell + 1); }));
    cells.arrays.push_back(
        madeXmlArray<std::uint8_t>("types", tetrahedra.size(), [](std::uint64_t) { return xmlTetra; }));
    return {"UnstructuredGrid",
            " NumberOfPoints=\"" + std::to_string(content.positions.size()) + "\" NumberOfCells=\"" +
                std::to_string(tetrahedra.size()) + "\"",
            content.facts,
            {elementOf("PointData", content.pointArrays),
             elementOf("CellData", content.cellArrays),
             {"Points", {}, {std::move(points)}},
             std::move(cells)}};
}

} // namespace

Status writeVtu(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    // Indices and offsets of one type, as VTK takes them without converting.
    const bool small = std::max(content.positions.size(), 4 * content.tetrahedra.size()) <=
                       static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    const XmlGrid grid = small ? gridOf<std::int32_t>(content) : gridOf<std::int64_t>(content);
    auto out = MeshOutput::create(path, bytesOf(grid), writingMesh, progress);
    if (!out)
        return out.error();
    if (const Status written = writeVtkXml(*out, grid); !written)
        return written;
    return out->commit();
}

} // namespace tetra
