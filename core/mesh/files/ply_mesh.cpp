// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/mesh_output.h"
#include "core/mesh/files/ply_head.h"

#include <type_traits>

namespace tetra {

namespace {

template <class T> constexpr std::string_view typeName()
{
    if constexpr (std::is_same_v<T, float>)
        return "float";
    else if constexpr (std::is_same_v<T, double>)
        return "double";
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return "uchar";
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return "ushort";
    else
        return "uint";
}

void addProperties(PlyHead& head, std::span<const NamedArray> arrays)
{
    for (const NamedArray& array : arrays)
        std::visit([&]<class T>(std::span<const T>) { head.property(typeName<T>(), array.name); }, array.values);
}

PlyHead headOf(const MeshContent& content)
{
    PlyHead head;
    head.comment("tetrahedral mesh by TAn").facts(content.facts).element("vertex", content.positions.size());
    for (const std::string_view axis : {"x", "y", "z"})
        head.property("float", axis);
    addProperties(head, content.pointArrays);
    head.element("cell", content.tetrahedra.size()).vertexList();
    addProperties(head, content.cellArrays);
    return head;
}

std::size_t bytesOfValues(std::span<const NamedArray> arrays)
{
    std::size_t bytes = 0;
    for (const NamedArray& array : arrays)
        bytes += valueBytes(array);
    return bytes;
}

void putValues(std::byte*& where, std::span<const NamedArray> arrays, std::uint64_t index)
{
    for (const NamedArray& array : arrays)
        std::visit([&](const auto& values) { putNumber(where, values[index]); }, array.values);
}

} // namespace

Status writePlyMesh(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    if (content.positions.size() > mostPlyVertices)
        return Error{ErrorKind::OutOfResource,
                     "'" + path.string() + "' would hold more vertices than a PLY file can number. Write a .vtu file."};
    auto out = MeshOutput::create(path, bytesOf(content, 17), writingMesh, progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(headOf(content).text()); !written)
        return written;
    const auto vertex = [&](std::uint64_t index, std::byte* where) {
        for (const float coordinate : content.positions[index])
            putNumber(where, coordinate);
        putValues(where, content.pointArrays, index);
    };
    if (const Status written = out->records(content.positions.size(), 12 + bytesOfValues(content.pointArrays), vertex);
        !written)
        return written;
    const auto cell = [&](std::uint64_t index, std::byte* where) {
        putNumber(where, std::uint8_t(4));
        putNumber(where, content.tetrahedra[index]);
        putValues(where, content.cellArrays, index);
    };
    if (const Status written = out->records(content.tetrahedra.size(), 17 + bytesOfValues(content.cellArrays), cell);
        !written)
        return written;
    return out->commit();
}

} // namespace tetra
