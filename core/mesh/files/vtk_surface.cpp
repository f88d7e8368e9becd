// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/surface_formats.h"
#include "core/mesh/files/vtk_legacy.h"

namespace tetra {

namespace {

constexpr std::size_t vectorBytes = 3 * sizeof(float);
constexpr std::size_t legacyTriangleBytes = 4 * sizeof(std::int32_t);

Status writeVectors(MeshOutput& out, const SurfaceContent& content,
                    std::span<const Eigen::Vector3f> SurfacePart::*which)
{
    const auto vector = [which](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        for (const float coordinate : (part.*which)[index])
            putTurned(where, coordinate);
    };
    return partRecords(out, content, vertexCount, vectorBytes, vector);
}

Status writeTriangles(MeshOutput& out, const SurfaceContent& content)
{
    const auto triangle = [](const SurfacePart& part, std::uint64_t first, std::uint64_t index, std::byte* where) {
        putTurned(where, std::int32_t(3));
        for (const std::uint32_t corner : part.triangles[index])
            putTurned(where, static_cast<std::int32_t>(first + corner));
    };
    return partRecords(out, content, triangleCount, legacyTriangleBytes, triangle);
}

Status writeValues(MeshOutput& out, const SurfaceContent& content)
{
    const auto value = [](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        putTurned(where, valueAt(part, index));
    };
    return partRecords(out, content, vertexCount, sizeof(float), value);
}

Status writeAll(MeshOutput& out, const SurfaceContent& content, const SurfaceSize& size)
{
    const std::string vertices = std::to_string(size.vertices);
    if (const Status written = out.text(vtkLegacyHead(content.title + " by TAn", "POLYDATA", content.facts) +
                                        "POINTS " + vertices + " float\n");
        !written)
        return written;
    if (const Status written = writeVectors(out, content, &SurfacePart::positions); !written)
        return written;
    if (const Status written =
            out.text("\nPOLYGONS " + std::to_string(size.triangles) + " " + std::to_string(4 * size.triangles) + "\n");
        !written)
        return written;
    if (const Status written = writeTriangles(out, content); !written)
        return written;
    if (const Status written = out.text("\nPOINT_DATA " + vertices + "\nSCALARS " + vtkLegacyWord(content.valueName) +
                                        " float 1\nLOOKUP_TABLE default\n");
        !written)
        return written;
    if (const Status written = writeValues(out, content); !written || !hasNormals(content))
        return written;
    if (const Status written = out.text("\nNORMALS Normals float\n"); !written)
        return written;
    return writeVectors(out, content, &SurfacePart::normals);
}

} // namespace

Status writeVtkSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    const SurfaceSize size = sizeOf(content);
    if (size.vertices > mostVtkLegacyNumbers || 4 * size.triangles > mostVtkLegacyNumbers)
        return tooLarge(path, "a legacy VTK file can number");
    auto out =
        MeshOutput::create(path, size.vertices * 28 + size.triangles * legacyTriangleBytes, writingSurfaces, progress);
    if (!out)
        return out.error();
    if (const Status written = writeAll(*out, content, size); !written)
        return written;
    if (const Status written = out->text("\n"); !written)
        return written;
    return out->commit();
}

} // namespace tetra
