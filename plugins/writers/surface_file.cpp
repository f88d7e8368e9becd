// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/surface_file.h"

#include "core/base/text.h"
#include "core/mesh/boundary.h"
#include "core/mesh/face_adjacency.h"
#include "plugins/writers/mesh_formats.h"
#include "plugins/writers/surface_formats.h"

#include <algorithm>
#include <new>

// Meshes in the formats for surfaces: the boundary is written.

namespace tetra {

namespace {

struct SurfaceFormat {
    std::string_view ending;
    bool surfacesOnly;
    Status (*write)(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress);
};
constexpr std::array<SurfaceFormat, 7> surfaceFormats = {{{".vtp", true, writeVtp},
                                                          {".vtk", false, writeVtkSurface},
                                                          {".vtu", false, writeVtuSurface},
                                                          {".ply", false, writePlySurface},
                                                          {".stl", true, writeStl},
                                                          {".obj", true, writeObj},
                                                          {".glb", true, writeGlb}}};

const SurfaceFormat* surfaceFormatOf(const std::filesystem::path& path)
{
    const auto found = std::ranges::find(surfaceFormats, fileEnding(path), &SurfaceFormat::ending);
    return found == surfaceFormats.end() ? nullptr : &*found;
}

Status misfit(const SurfacePart& part, const Message& what)
{
    return Error{ErrorKind::WrongUsage,
                 Message::say("The surface '%1' has %2, so it cannot be written.", part.name, what)};
}

Status checkPart(const SurfacePart& part, bool normals)
{
    const std::size_t count = part.positions.size();
    const auto* each = std::get_if<std::span<const float>>(&part.values);
    if (part.normals.size() != (normals ? count : 0))
        return misfit(part, Message::say("not one normal for each vertex"));
    if (each != nullptr && each->size() != count)
        return misfit(part, Message::say("not one value for each vertex"));
    const auto outside = [count](const auto& triangle) { return *std::ranges::max_element(triangle) >= count; };
    if (std::ranges::any_of(part.triangles, outside))
        return misfit(part, Message::say("triangles of vertices that it does not have"));
    return {};
}

} // namespace

SurfaceSize sizeOf(const SurfaceContent& content)
{
    SurfaceSize size;
    for (const SurfacePart& part : content.parts) {
        size.vertices += part.positions.size();
        size.triangles += part.triangles.size();
    }
    return size;
}

bool hasNormals(const SurfaceContent& content)
{
    return std::ranges::any_of(content.parts, [](const SurfacePart& part) { return !part.normals.empty(); });
}

Error tooLarge(const Message& sentence)
{
    return {ErrorKind::OutOfResource, Message::say("%1 Write a .vtp file, or a surface of a larger error.", sentence)};
}

Status checkSurfaceFileName(const std::filesystem::path& path)
{
    if (surfaceFormatOf(path) != nullptr)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' ends in none of .vtp, .vtk, .vtu, .ply, .stl, .obj and .glb, the formats in which "
                              "surfaces are written. Choose one of these endings.",
                              path.string())};
}

bool isSurfaceFileOnly(const std::filesystem::path& path)
{
    const SurfaceFormat* format = surfaceFormatOf(path);
    return format != nullptr && format->surfacesOnly;
}

Status writeSurfaceFile(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    if (const Status known = checkSurfaceFileName(path); !known)
        return known;
    const bool normals = hasNormals(content);
    for (const SurfacePart& part : content.parts)
        if (const Status fits = checkPart(part, normals); !fits)
            return fits;
    try {
        return surfaceFormatOf(path)->write(path, content, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write '%1'.", path.string())};
    }
}

namespace {

/// The vertices' first array of floats.
const NamedArray* valuesOf(const MeshContent& content)
{
    for (const NamedArray& array : content.pointArrays)
        if (std::holds_alternative<std::span<const float>>(array.values))
            return &array;
    return nullptr;
}

} // namespace

Status writeBoundary(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    constexpr double found = 0.4;
    if (content.tetrahedra.size() > largestAdjacentCellCount)
        return Error{ErrorKind::OutOfResource,
                     Message::say("'%1' would be the boundary of more than 1073741824 tetrahedra, which is too many to "
                                  "find it. Write a .vtu file.",
                                  path.string())};
    progress.report(0, writingMesh);
    const BoundaryFaces boundary = boundaryFaces(content.positions.size(), content.tetrahedra);
    if (progress.cancelled())
        return cancelledError(writingMesh);
    std::vector<Eigen::Vector3f> positions;
    std::vector<float> values;
    const NamedArray* const array = valuesOf(content);
    for (const std::uint32_t vertex : boundary.vertices) {
        positions.push_back(content.positions[vertex]);
        if (array != nullptr)
            values.push_back(std::get<std::span<const float>>(array->values)[vertex]);
    }
    SurfacePart part{.name = "boundary", .positions = positions, .normals = {}, .triangles = boundary.triangles};
    if (array != nullptr)
        part.values = std::span<const float>(values);
    return writeSurfaceFile(
        path, {"boundary of a tetrahedral mesh", array != nullptr ? array->name : "value", {part}, content.facts},
        progress.part(found, 1));
}

} // namespace tetra
