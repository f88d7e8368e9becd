// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh_output.h"
#include "plugins/writers/mesh_formats.h"
#include "plugins/writers/surface_file.h"

#include <cstddef>
#include <string_view>

namespace tetra {

/// One for each format of writeSurfaceFile(); the content's arrays have the right lengths.
Status writeVtp(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writeVtuSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writeVtkSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writePlySurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writeStl(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writeObj(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
Status writeGlb(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);

/// Of all parts together.
struct SurfaceSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;
};
SurfaceSize sizeOf(const SurfaceContent& content);
bool hasNormals(const SurfaceContent& content);

/// The error of a surface that is too large for its format, as `sentence` says.
Error tooLarge(const Message& sentence);

inline float valueAt(const SurfacePart& part, std::uint64_t vertex)
{
    const auto* each = std::get_if<std::span<const float>>(&part.values);
    return each != nullptr ? (*each)[vertex] : std::get<float>(part.values);
}

/// Records of all parts, one part after the other: fill(part, number of its first vertex, index, where).
template <class Count, class Fill>
Status partRecords(MeshOutput& out, const SurfaceContent& content, Count&& count, std::size_t recordBytes, Fill&& fill)
{
    std::uint64_t firstVertex = 0;
    for (const SurfacePart& part : content.parts) {
        const auto record = [&](std::uint64_t index, std::byte* where) { fill(part, firstVertex, index, where); };
        if (const Status written = out.records(count(part), recordBytes, record); !written)
            return written;
        firstVertex += part.positions.size();
    }
    return {};
}
inline std::uint64_t vertexCount(const SurfacePart& part)
{
    return part.positions.size();
}
inline std::uint64_t triangleCount(const SurfacePart& part)
{
    return part.triangles.size();
}

inline constexpr MarkedText writingSurfaces = Message::marked("Writing the surfaces");

} // namespace tetra
