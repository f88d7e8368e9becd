// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/ply_file.h"

#include "core/mesh/files/mesh_output.h"
#include "core/mesh/files/ply_head.h"

#include <string>

namespace tetra {
namespace {

constexpr std::size_t vertexBytes = 7 * sizeof(float);
constexpr std::size_t faceBytes = 1 + 3 * sizeof(std::int32_t);

struct Counts {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
};

Counts countAll(std::span<const ValuedSurface> surfaces)
{
    Counts counts;
    for (const ValuedSurface& surface : surfaces) {
        counts.vertices += surface.mesh.positions.size();
        counts.triangles += surface.mesh.triangles.size();
    }
    return counts;
}

std::string header(const Counts& counts)
{
    PlyHead head;
    head.comment("isosurfaces by TAn").element("vertex", counts.vertices);
    for (const std::string_view name : {"x", "y", "z", "nx", "ny", "nz", "value"})
        head.property("float", name);
    return head.element("face", counts.triangles).vertexList().text();
}

Status writeVertices(MeshOutput& out, const ValuedSurface& surface)
{
    return out.records(surface.mesh.positions.size(), vertexBytes, [&](std::uint64_t index, std::byte* where) {
        for (const float coordinate : surface.mesh.positions[index])
            putNumber(where, coordinate);
        for (const float coordinate : surface.mesh.normals[index])
            putNumber(where, coordinate);
        putNumber(where, static_cast<float>(surface.value));
    });
}

Status writeFaces(MeshOutput& out, const TriangleMesh& mesh, std::uint32_t firstVertex)
{
    return out.records(mesh.triangles.size(), faceBytes, [&](std::uint64_t index, std::byte* where) {
        putNumber(where, std::uint8_t(3));
        for (const std::uint32_t vertex : mesh.triangles[index])
            putNumber(where, vertex + firstVertex);
    });
}

} // namespace

Status writePly(const std::filesystem::path& path, std::span<const ValuedSurface> surfaces, const Progress& progress)
{
    const Counts counts = countAll(surfaces);
    if (counts.vertices > mostPlyVertices)
        return Error{ErrorKind::OutOfResource, "The surfaces have more vertices than a PLY file can number. Ask for a "
                                               "larger error, or for one isovalue at a time."};
    auto out = MeshOutput::create(path, counts.vertices * vertexBytes + counts.triangles * faceBytes,
                                  "Writing the surfaces", progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(header(counts)); !written)
        return written;
    for (const ValuedSurface& surface : surfaces)
        if (const Status written = writeVertices(*out, surface); !written)
            return written;
    std::uint32_t firstVertex = 0;
    for (const ValuedSurface& surface : surfaces) {
        if (const Status written = writeFaces(*out, surface.mesh, firstVertex); !written)
            return written;
        firstVertex += static_cast<std::uint32_t>(surface.mesh.positions.size());
    }
    return out->commit();
}

} // namespace tetra
