// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/ply_file.h"

#include "core/base/file_writer.h"

#include <bit>
#include <cstring>
#include <limits>
#include <string>

namespace tetra {
namespace {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

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
    return "ply\nformat binary_little_endian 1.0\ncomment isosurfaces by TAn\nelement vertex " +
           std::to_string(counts.vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\n"
           "property float nx\nproperty float ny\nproperty float nz\nproperty float value\nelement face " +
           std::to_string(counts.triangles) + "\nproperty list uchar int vertex_indices\nend_header\n";
}

Status writeVertices(FileWriter& file, const ValuedSurface& surface)
{
    for (std::size_t index = 0; index < surface.mesh.positions.size(); ++index) {
        const Eigen::Vector3f& position = surface.mesh.positions[index];
        const Eigen::Vector3f& normal = surface.mesh.normals[index];
        const float record[7] = {position.x(),
                                 position.y(),
                                 position.z(),
                                 normal.x(),
                                 normal.y(),
                                 normal.z(),
                                 static_cast<float>(surface.value)};
        if (const Status written = file.write(std::as_bytes(std::span(record))); !written)
            return written;
    }
    return {};
}

Status writeFaces(FileWriter& file, const TriangleMesh& mesh, std::uint32_t firstVertex)
{
    for (const auto& triangle : mesh.triangles) {
        std::byte record[13] = {std::byte{3}};
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = triangle[corner] + firstVertex;
            std::memcpy(record + 1 + 4 * corner, &vertex, 4);
        }
        if (const Status written = file.write(record); !written)
            return written;
    }
    return {};
}

} // namespace

Status writePly(const std::filesystem::path& path, std::span<const ValuedSurface> surfaces, const Progress& progress)
{
    constexpr std::string_view activity = "Writing the surfaces";
    const Counts counts = countAll(surfaces);
    if (counts.vertices > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
        return Error{ErrorKind::OutOfResource, "The surfaces have more vertices than a PLY file can number. Ask for a "
                                               "larger error, or for one isovalue at a time."};
    auto file = FileWriter::create(path);
    if (!file)
        return file.error();
    const std::string head = header(counts);
    if (const Status written = file->write(std::as_bytes(std::span(head))); !written)
        return written;
    for (const ValuedSurface& surface : surfaces) {
        if (progress.cancelled())
            return cancelledError(activity);
        if (const Status written = writeVertices(*file, surface); !written)
            return written;
    }
    std::uint32_t firstVertex = 0;
    for (const ValuedSurface& surface : surfaces) {
        if (progress.cancelled())
            return cancelledError(activity);
        if (const Status written = writeFaces(*file, surface.mesh, firstVertex); !written)
            return written;
        firstVertex += static_cast<std::uint32_t>(surface.mesh.positions.size());
    }
    progress.report(1, activity);
    return file->commit();
}

} // namespace tetra
