// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces as VTK XML files: polydata (.vtp), and the same triangles as cells of an unstructured grid (.vtu).
#include "core/mesh/files/surface_formats.h"
#include "core/mesh/files/vtk_xml.h"

namespace tetra {

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

} // namespace tetra
