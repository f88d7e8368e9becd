// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/ply_head.h"
#include "core/mesh/files/surface_formats.h"

namespace tetra {

namespace {

std::string plyHead(const SurfaceContent& content, const SurfaceSize& size, bool normals)
{
    PlyHead head;
    head.comment(content.title + " by TAn").facts(content.facts).element("vertex", size.vertices);
    for (const std::string_view axis : {"x", "y", "z"})
        head.property("float", axis);
    if (normals)
        for (const std::string_view axis : {"nx", "ny", "nz"})
            head.property("float", axis);
    head.property("float", content.valueName);
    return head.element("face", size.triangles).vertexList().text();
}

} // namespace

Status writePlySurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    const SurfaceSize size = sizeOf(content);
    if (size.vertices > mostPlyVertices)
        return tooLarge(path, "the 2147483647 vertices that a PLY file can number");
    const bool normals = hasNormals(content);
    const std::size_t vertexBytes = (normals ? 7 : 4) * sizeof(float);
    constexpr std::size_t faceBytes = 1 + 3 * sizeof(std::int32_t);
    auto out =
        MeshOutput::create(path, size.vertices * vertexBytes + size.triangles * faceBytes, writingSurfaces, progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(plyHead(content, size, normals)); !written)
        return written;
    const auto vertex = [&](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        for (const float coordinate : part.positions[index])
            putNumber(where, coordinate);
        if (normals)
            for (const float coordinate : part.normals[index])
                putNumber(where, coordinate);
        putNumber(where, valueAt(part, index));
    };
    if (const Status written = partRecords(*out, content, vertexCount, vertexBytes, vertex); !written)
        return written;
    const auto face = [](const SurfacePart& part, std::uint64_t first, std::uint64_t index, std::byte* where) {
        putNumber(where, std::uint8_t(3));
        for (const std::uint32_t corner : part.triangles[index])
            putNumber(where, static_cast<std::int32_t>(first + corner));
    };
    if (const Status written = partRecords(*out, content, triangleCount, faceBytes, face); !written)
        return written;
    return out->commit();
}

} // namespace tetra
