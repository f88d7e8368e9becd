// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/ply.h"

#include "core/mesh/mesh_output.h"
#include "plugins/writers/mesh_formats.h"
#include "plugins/writers/surface_formats.h"

#include <algorithm>
#include <type_traits>

namespace tetra {

PlyHead& PlyHead::comment(std::string_view text)
{
    std::string line(text);
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\r'; }, ' ');
    text_ += "comment " + line + "\n";
    return *this;
}

PlyHead& PlyHead::facts(const MeshFacts& facts)
{
    for (const auto& [name, fact] : facts)
        comment(name + ": " + factText(fact));
    return *this;
}

PlyHead& PlyHead::element(std::string_view name, std::uint64_t count)
{
    text_ += "element " + std::string(name) + " " + std::to_string(count) + "\n";
    return *this;
}

PlyHead& PlyHead::property(std::string_view type, std::string_view name)
{
    std::string word(name);
    std::ranges::replace_if(
        word, [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
    text_ += "property " + std::string(type) + " " + word + "\n";
    return *this;
}

PlyHead& PlyHead::vertexList()
{
    text_ += "property list uchar int vertex_indices\n";
    return *this;
}

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
                     Message::say("'%1' would hold more vertices than a PLY file can number. Write a .vtu file.",
                                  path.string())};
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
        return tooLarge(Message::say("'%1' would hold more than the 2147483647 vertices that a PLY file can number.",
                                     path.string()));
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
