// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/mesh_output.h"
#include "core/mesh/files/vtk_xml.h"

#include <limits>

namespace tetra {

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
