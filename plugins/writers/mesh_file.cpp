// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/mesh_file.h"

#include "core/base/text.h"
#include "plugins/writers/mesh_formats.h"

#include <algorithm>
#include <new>
#include <string_view>

namespace tetra {

namespace {

struct MeshFormat {
    std::string_view ending;
    Status (*write)(const std::filesystem::path& path, const MeshContent& content, const Progress& progress);
};
constexpr std::array<MeshFormat, 7> meshFormats = {{{".vtu", writeVtu},
                                                    {".vtk", writeVtk},
                                                    {".ply", writePlyMesh},
                                                    {".vtp", writeBoundary},
                                                    {".stl", writeBoundary},
                                                    {".obj", writeBoundary},
                                                    {".glb", writeBoundary}}};

const MeshFormat* meshFormatOf(const std::filesystem::path& path)
{
    const auto found = std::ranges::find(meshFormats, fileEnding(path), &MeshFormat::ending);
    return found == meshFormats.end() ? nullptr : &*found;
}

Status checkArrays(const std::vector<NamedArray>& arrays, std::size_t count, MarkedText of)
{
    for (const NamedArray& array : arrays)
        if (array.name.empty() || valueCount(array) != count)
            return Error{
                ErrorKind::WrongUsage,
                Message::say("The array '%1' has %2 values for %3 %4: an array needs a name, and one value for each.",
                             array.name, valueCount(array), count, of)};
    return {};
}

} // namespace

std::uint64_t bytesOf(const MeshContent& content, std::size_t bytesOfCell)
{
    std::uint64_t bytes = content.positions.size_bytes() + content.tetrahedra.size() * bytesOfCell;
    for (const auto* arrays : {&content.pointArrays, &content.cellArrays})
        for (const NamedArray& array : *arrays)
            bytes += valueCount(array) * valueBytes(array);
    return bytes;
}

std::string factText(const MeshFacts::value_type::second_type& fact)
{
    const auto* number = std::get_if<double>(&fact);
    return number != nullptr ? formatNumber(*number) : std::get<std::string>(fact);
}

Status checkMeshFileName(const std::filesystem::path& path)
{
    if (meshFormatOf(path) != nullptr)
        return {};
    return Error{ErrorKind::WrongUsage,
                 Message::say("'%1' ends in none of .vtu, .vtk and .ply, the formats in which meshes are written, nor "
                              "of .vtp, .stl, .obj and .glb, for their boundary alone. Choose one of these endings.",
                              path.string())};
}

Status writeMeshFile(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    if (const Status known = checkMeshFileName(path); !known)
        return known;
    if (const Status fit = checkArrays(content.pointArrays, content.positions.size(), Message::marked("vertices"));
        !fit)
        return fit;
    if (const Status fit = checkArrays(content.cellArrays, content.tetrahedra.size(), Message::marked("tetrahedra"));
        !fit)
        return fit;
    try {
        return meshFormatOf(path)->write(path, content, progress);
    } catch (const std::bad_alloc&) {
        return Error{ErrorKind::OutOfResource, Message::say("Not enough memory to write '%1'.", path.string())};
    }
}

} // namespace tetra
