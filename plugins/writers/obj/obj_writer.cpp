// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

namespace tetra {
namespace {

constexpr std::uint64_t vertexBytes = 30; ///< about, of "v 1.2345678 2.3456789 3.4567891"
constexpr std::uint64_t faceBytes = 24;

/// One line: what comes after a line break would be taken for a statement.
std::string lineOf(std::string_view text)
{
    std::string line(text);
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
    return line;
}

/// A name in one word, as groups are.
std::string word(std::string_view text)
{
    std::string name = lineOf(text);
    std::ranges::replace(name, ' ', '_');
    return name;
}

void addComments(std::string& text, const SurfaceContent& content)
{
    text += "# " + lineOf(content.title) + " by TAn\n";
    for (const auto& [name, fact] : content.facts)
        text += "# " + lineOf(name + ": " + factText(fact)) + "\n";
}

template <class Vector> void addVector(std::string& text, std::string_view keyword, const Vector& vector)
{
    text += keyword;
    for (const auto coordinate : vector)
        (text += ' ') += formatNumber(coordinate);
    text += '\n';
}

/// With its colour, if it has one, behind its coordinates: an extension that Blender and MeshLab read, and others skip.
void addPosition(std::string& text, const SurfacePart& part, bool floats, std::uint64_t index)
{
    if (floats) // in the fewest digits that tell it from other floats
        addVector(text, "v", part.positions[index].cast<float>().eval());
    else
        addVector(text, "v", part.positions[index]);
    if (part.colours.empty())
        return;
    text.pop_back();
    const Colour& colour = part.colours[index];
    addVector(text, "", std::array{colour.red, colour.green, colour.blue});
}

void addFace(std::string& text, const std::array<std::uint32_t, 3>& triangle, std::uint64_t first, bool normals)
{
    text += 'f';
    for (const std::uint32_t corner : triangle) {
        const std::string number = std::to_string(first + corner + 1); // counted from 1 through the whole file
        (text += ' ') += number;
        if (normals)
            (text += "//") += number;
    }
    text += '\n';
}

/// Lines that add(text, index) makes, handed on in pieces.
template <class Add> Status writeLines(OutputFile& file, std::uint64_t count, Add&& add)
{
    constexpr std::size_t pieceBytes = 1 << 18;
    std::string text;
    for (std::uint64_t index = 0; index < count; ++index) {
        add(text, index);
        if (text.size() < pieceBytes && index + 1 < count)
            continue;
        if (const Status written = file.text(text); !written)
            return written;
        text.clear();
    }
    return {};
}

Status writePart(OutputFile& file, const SurfaceContent& content, const SurfacePart& part, bool floats,
                 std::uint64_t first)
{
    const bool normals = !part.normals.empty();
    const auto* each = std::get_if<std::span<const float>>(&part.values);
    const std::string value =
        each == nullptr ? "# " + lineOf(content.valueName) + " " + formatNumber(std::get<float>(part.values)) + "\n"
                        : "";
    if (const Status written = file.text("g " + word(part.name) + "\n" + value); !written)
        return written;
    const auto position = [&](std::string& text, std::uint64_t index) { addPosition(text, part, floats, index); };
    if (const Status written = writeLines(file, part.positions.size(), position); !written)
        return written;
    const auto normal = [&](std::string& text, std::uint64_t index) { addVector(text, "vn", part.normals[index]); };
    if (const Status written = writeLines(file, part.normals.size(), normal); !written)
        return written;
    const auto face = [&](std::string& text, std::uint64_t index) {
        addFace(text, part.triangles[index], first, normals);
    };
    return writeLines(file, part.triangles.size(), face);
}

} // namespace

/// `.obj`, Wavefront text: a group for each part; colours as `v x y z r g b`.
class ObjWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Surface, Message::marked("Wavefront OBJ files"), {".obj"}}};
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        file.expect(content.vertexCount() * vertexBytes * (content.hasNormals() ? 2 : 1) +
                    content.triangleCount() * faceBytes);
        std::string comments;
        addComments(comments, content);
        if (const Status written = file.text(comments); !written)
            return written;
        const bool floats = content.positionsFitFloats();
        std::uint64_t first = 0;
        for (const SurfacePart& part : content.parts) {
            if (const Status written = writePart(file, content, part, floats, first); !written)
                return written;
            first += part.positions.size();
        }
        return {};
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::ObjWriter, tetra::Writer)
