// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace tetra {
namespace {

/// More vertices cannot be numbered by an int.
constexpr std::size_t mostVertices = std::numeric_limits<std::int32_t>::max();

/// A name without blanks and letters that are not ASCII.
std::string wordOf(std::string_view name)
{
    std::string word(name);
    std::ranges::replace_if(
        word, [](char c) { return static_cast<unsigned char>(c) <= ' ' || static_cast<unsigned char>(c) > '~'; }, '_');
    return word;
}

/// The head of a binary little-endian PLY file. Line breaks in texts, and what names cannot hold, are repaired.
class PlyHead {
public:
    PlyHead& comment(std::string_view text);
    /// A comment each.
    PlyHead& facts(const MeshFacts& facts);
    PlyHead& element(std::string_view name, std::uint64_t count);
    /// Of the element before; `type` is PLY's word for it.
    PlyHead& property(std::string_view type, std::string_view name);
    /// The list of vertices of a face: a uchar, and as many ints.
    PlyHead& vertexList();

    std::string text() const { return text_ + "end_header\n"; }

private:
    std::string text_ = "ply\nformat binary_little_endian 1.0\n";
};

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
    text_ += "property " + std::string(type) + " " + wordOf(name) + "\n";
    return *this;
}

PlyHead& PlyHead::vertexList()
{
    text_ += "property list uchar int vertex_indices\n";
    return *this;
}

/// What readers take for something else than a value, by the lists of VTK, MeshLab, meshio and Assimp; and the names of
/// the colours of materials, which begin with one of `shades`.
constexpr std::string_view takenWords =
    " x y z nx ny nz red green blue alpha r g b a opacity quality s t u v tx ty texture_u texture_v texcoord "
    "texture_index material_index vertex_index vertex_indices specular_power ";
constexpr std::array<std::string_view, 3> shades = {"ambient_", "diffuse_", "specular_"};
constexpr std::array<std::string_view, 4> channels = {"red", "green", "blue", "alpha"};

bool isTaken(const std::string& word)
{
    if (takenWords.find(" " + word + " ") != std::string_view::npos)
        return true;
    return std::ranges::any_of(shades, [&word](std::string_view shade) {
        return word.starts_with(shade) && std::ranges::find(channels, word.substr(shade.size())) != channels.end();
    });
}

/// A name in the word that the file has for it, with "value_" in front if that is taken.
std::string freeName(const std::string& name)
{
    const std::string word = wordOf(name);
    return (isTaken(word) ? "value_" : "") + word;
}

std::string headOf(const SurfaceContent& content, bool floats)
{
    PlyHead head;
    head.comment(content.title + " by TAn").facts(content.facts).element("vertex", content.vertexCount());
    for (const std::string_view axis : {"x", "y", "z"})
        head.property(floats ? "float" : "double", axis);
    if (content.hasNormals())
        for (const std::string_view axis : {"nx", "ny", "nz"})
            head.property("float", axis);
    head.property("float", freeName(content.valueName));
    if (content.hasColours())
        for (const std::string_view channel : {"red", "green", "blue"})
            head.property("uchar", channel);
    head.element("face", content.triangleCount()).vertexList();
    return head.text();
}

/// What is said of arrays that are left out.
Message lackOf(const std::vector<NamedArray>& arrays, const std::string& file)
{
    std::string names;
    for (const NamedArray& array : arrays)
        names += (names.empty() ? "" : ", ") + array.name;
    return Message::say("'%1' does not contain the triangles' values (%2), because many programs cannot read a PLY "
                        "file with such values. To keep them, write a .vtp file.",
                        file, names);
}

} // namespace

/// `.ply`, binary little endian: elements `vertex` and `face`. Colours are the bytes `red green blue` of the vertices.
/// Values of triangles are left out: meshio reads no file where something stands behind the list of a face.
class PlyWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Surface, Message::marked("PLY files"), {".ply"}}};
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        if (content.vertexCount() > mostVertices)
            return Error{ErrorKind::OutOfResource,
                         Message::say("'%1' would hold more than the 2147483647 vertices that a PLY file can number. "
                                      "Write a .vtp file, or a surface of a larger error.",
                                      file.target().string())};
        const bool normals = content.hasNormals();
        const bool colours = content.hasColours();
        const bool floats = content.positionsFitFloats();
        const std::size_t vertexBytes =
            3 * (floats ? sizeof(float) : sizeof(double)) + (normals ? 4 : 1) * sizeof(float) + (colours ? 3 : 0);
        constexpr std::size_t faceBytes = 1 + 3 * sizeof(std::int32_t);
        file.expect(content.vertexCount() * vertexBytes + content.triangleCount() * faceBytes);
        if (const Status written = file.text(headOf(content, floats)); !written)
            return written;
        const auto vertex = [normals, colours, floats](const SurfacePart& part, std::uint64_t index, std::byte* where) {
            for (const double coordinate : part.positions[index])
                if (floats)
                    putNumber(where, static_cast<float>(coordinate));
                else
                    putNumber(where, coordinate);
            if (normals)
                for (const float coordinate : part.normals[index])
                    putNumber(where, coordinate);
            putNumber(where, part.value(index));
            if (colours)
                putNumber(where, colourBytes(part.colourAt(index)));
        };
        if (const Status written = file.vertexRecords(content, vertexBytes, vertex); !written)
            return written;
        const auto face = [](const std::array<std::uint64_t, 3>& corners, std::byte* where) {
            putNumber(where, std::uint8_t(3));
            for (const std::uint64_t corner : corners)
                putNumber(where, static_cast<std::int32_t>(corner));
        };
        if (const Status written = file.triangleRecords(content, faceBytes, face); !written)
            return written;
        if (!content.cellArrays.empty())
            file.remark(lackOf(content.cellArrays, file.target().string()));
        return {};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::PlyWriter, tetra::Writer)
