// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/api/plugin.h"
#include "plugins/api/writer.h"

#include <algorithm>
#include <limits>
#include <type_traits>

// Numbers are big endian.

namespace tetra {
namespace {

/// Numbers of vertices and lengths of lists are ints.
constexpr auto mostNumbers = static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());

/// A name in one word: blanks and whatever else could mislead a reader as %XX, which VTK turns back. Cut off where it
/// would be too long for the line that VTK reads.
std::string vtkLegacyWord(std::string_view name)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    constexpr std::size_t most = 200;
    std::string encoded;
    for (const char c : name) {
        if (encoded.size() + 3 > most)
            break;
        const auto code = static_cast<unsigned char>(c);
        if (code > ' ' && code < 127 && c != '%' && c != '"')
            encoded += c;
        else
            encoded += {'%', digits[code >> 4], digits[code & 15]};
    }
    return encoded;
}

/// What the file holds and the facts, as far as they fit into the one line that there is for a title: gmsh reads no
/// file with field data before its points, and meshio none with texts among them. Facts that do not fit are left out;
/// bytes that could end the line become question marks.
std::string titleLine(std::string_view title, const MeshFacts& facts)
{
    constexpr std::size_t most = 255; // and the line's end
    std::string line(title);
    for (const auto& [name, fact] : facts) {
        const std::string next = "; " + name + ": " + factText(fact);
        if (line.size() + next.size() <= most)
            line += next;
    }
    std::ranges::replace_if(
        line, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    return line;
}

/// The file up to its points: `dataset` is VTK's word for its kind.
std::string vtkLegacyHead(std::string_view title, std::string_view dataset, const MeshFacts& facts)
{
    return "# vtk DataFile Version 4.2\n" + titleLine(title, facts) + "\nBINARY\nDATASET " + std::string(dataset) +
           "\n";
}

constexpr std::int32_t legacyTetra = 10;

template <class T> constexpr std::string_view legacyTypeName()
{
    if constexpr (std::is_same_v<T, float>)
        return "float";
    else if constexpr (std::is_same_v<T, double>)
        return "double";
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return "unsigned_char";
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return "unsigned_short";
    else
        return "unsigned_int";
}

/// The line before the places of so many vertices.
std::string pointsLine(std::uint64_t count, bool floats)
{
    return "POINTS " + std::to_string(count) + (floats ? " float\n" : " double\n");
}

constexpr std::size_t placeBytes(bool floats)
{
    return 3 * (floats ? sizeof(float) : sizeof(double));
}

/// In doubles unless floats hold it.
void putPlace(std::byte*& where, const Eigen::Vector3d& place, bool floats)
{
    for (const double coordinate : place)
        if (floats)
            putTurned(where, static_cast<float>(coordinate));
        else
            putTurned(where, coordinate);
}

Status writeGeometry(OutputFile& file, const MeshContent& content)
{
    const std::uint64_t cells = content.tetrahedra.size();
    const bool floats = fitFloats(content.positions);
    if (const Status written = file.text(pointsLine(content.positions.size(), floats)); !written)
        return written;
    if (const Status written = file.records(
            content.positions.size(), placeBytes(floats),
            [&](std::uint64_t index, std::byte* where) { putPlace(where, content.positions[index], floats); });
        !written)
        return written;
    if (const Status written = file.text("\nCELLS " + std::to_string(cells) + " " + std::to_string(5 * cells) + "\n");
        !written)
        return written;
    if (const Status written = file.records(cells, 20,
                                            [&](std::uint64_t index, std::byte* where) {
                                                putTurned(where, std::int32_t(4));
                                                for (const std::uint32_t vertex : content.tetrahedra[index])
                                                    putTurned(where, vertex);
                                            });
        !written)
        return written;
    if (const Status written = file.text("\nCELL_TYPES " + std::to_string(cells) + "\n"); !written)
        return written;
    if (const Status written =
            file.records(cells, 4, [](std::uint64_t, std::byte* where) { putTurned(where, legacyTetra); });
        !written)
        return written;
    return file.text("\n");
}

/// The first array is the one that viewers show at once, the others are fields.
Status writeArrays(OutputFile& file, std::string_view keyword, std::uint64_t count, std::span<const NamedArray> arrays)
{
    if (arrays.empty())
        return {};
    if (const Status written = file.text(std::string(keyword) + " " + std::to_string(count) + "\n"); !written)
        return written;
    for (std::size_t number = 0; number < arrays.size(); ++number) {
        const Status written = std::visit(
            [&]<class T>(std::span<const T> values) -> Status {
                const std::string type(legacyTypeName<T>());
                std::string head = number == 1 ? "FIELD FieldData " + std::to_string(arrays.size() - 1) + "\n" : "";
                head +=
                    number == 0
                        ? "SCALARS " + vtkLegacyWord(arrays[number].name) + " " + type + " 1\nLOOKUP_TABLE default\n"
                        : vtkLegacyWord(arrays[number].name) + " 1 " + std::to_string(count) + " " + type + "\n";
                if (const Status begun = file.text(head); !begun)
                    return begun;
                if (const Status put =
                        file.records(count, sizeof(T),
                                     [&](std::uint64_t index, std::byte* where) { putTurned(where, values[index]); });
                    !put)
                    return put;
                return file.text("\n");
            },
            arrays[number].values);
        if (!written)
            return written;
    }
    return {};
}

constexpr std::size_t legacyTriangleBytes = 4 * sizeof(std::int32_t);

Status writePlaces(OutputFile& file, const SurfaceContent& content, bool floats)
{
    const auto place = [floats](const SurfacePart& part, std::uint64_t index, std::byte* where) {
        putPlace(where, part.positions[index], floats);
    };
    return file.vertexRecords(content, placeBytes(floats), place);
}

Status writeNormals(OutputFile& file, const SurfaceContent& content)
{
    const auto normal = [](const SurfacePart& part, std::uint64_t index, std::byte* where) {
        for (const float coordinate : part.normals[index])
            putTurned(where, coordinate);
    };
    return file.vertexRecords(content, 3 * sizeof(float), normal);
}

Status writeTriangles(OutputFile& file, const SurfaceContent& content)
{
    const auto triangle = [](const std::array<std::uint64_t, 3>& corners, std::byte* where) {
        putTurned(where, std::int32_t(3));
        for (const std::uint64_t corner : corners)
            putTurned(where, static_cast<std::int32_t>(corner));
    };
    return file.triangleRecords(content, legacyTriangleBytes, triangle);
}

Status writeValues(OutputFile& file, const SurfaceContent& content)
{
    const auto value = [](const SurfacePart& part, std::uint64_t index, std::byte* where) {
        putTurned(where, part.value(index));
    };
    return file.vertexRecords(content, sizeof(float), value);
}

/// As a field: of several scalars readers take the first alone, unless they are told otherwise.
Status writeColours(OutputFile& file, const SurfaceContent& content)
{
    if (const Status written =
            file.text("\nFIELD FieldData 1\ncolour 3 " + std::to_string(content.vertexCount()) + " unsigned_char\n");
        !written)
        return written;
    const auto colour = [](const SurfacePart& part, std::uint64_t index, std::byte* where) {
        putNumber(where, colourBytes(part.colourAt(index)));
    };
    return file.vertexRecords(content, 3, colour);
}

Status writeAll(OutputFile& file, const SurfaceContent& content)
{
    const std::string vertices = std::to_string(content.vertexCount());
    const bool floats = content.positionsFitFloats();
    const std::uint64_t triangles = content.triangleCount();
    if (const Status written = file.text(vtkLegacyHead(content.title + " by TAn", "POLYDATA", content.facts) +
                                         pointsLine(content.vertexCount(), floats));
        !written)
        return written;
    if (const Status written = writePlaces(file, content, floats); !written)
        return written;
    if (const Status written =
            file.text("\nPOLYGONS " + std::to_string(triangles) + " " + std::to_string(4 * triangles) + "\n");
        !written)
        return written;
    if (const Status written = writeTriangles(file, content); !written)
        return written;
    if (!content.cellArrays.empty()) {
        if (const Status written = file.text("\n"); !written)
            return written;
        if (const Status written = writeArrays(file, "CELL_DATA", triangles, content.cellArrays); !written)
            return written;
    }
    if (const Status written = file.text("\nPOINT_DATA " + vertices + "\nSCALARS " + vtkLegacyWord(content.valueName) +
                                         " float 1\nLOOKUP_TABLE default\n");
        !written)
        return written;
    if (const Status written = writeValues(file, content); !written)
        return written;
    if (content.hasNormals()) {
        if (const Status written = file.text("\nNORMALS Normals float\n"); !written)
            return written;
        if (const Status written = writeNormals(file, content); !written)
            return written;
    }
    return content.hasColours() ? writeColours(file, content) : Status();
}

std::uint64_t bytesOf(const std::vector<NamedArray>& arrays)
{
    std::uint64_t bytes = 0;
    for (const NamedArray& array : arrays)
        bytes += array.size() * array.bytesOfValue();
    return bytes;
}

} // namespace

/// `.vtk`, legacy 4.2, binary: unstructured grids of tetrahedra, and polydata. Colours are the field `colour` of the
/// vertices, three bytes each.
class VtkLegacyWriter : public Writer {
public:
    std::vector<FileFormat> formats() const override
    {
        return {{WrittenContent::Mesh, Message::marked("VTK legacy files"), {".vtk"}},
                {WrittenContent::Surface, Message::marked("VTK legacy files"), {".vtk"}}};
    }

    Status writeMesh(const MeshContent& content, OutputFile& file, const ParameterValues& /*values*/) const override
    {
        const std::uint64_t points = content.positions.size(), cells = content.tetrahedra.size();
        if (points > mostNumbers || 5 * cells > mostNumbers)
            return Error{ErrorKind::OutOfResource,
                         Message::say("'%1' would hold more than a legacy VTK file can number. Write a .vtu file.",
                                      file.target().string())};
        file.expect(placeBytes(fitFloats(content.positions)) * points + 24 * cells + bytesOf(content.pointArrays) +
                    bytesOf(content.cellArrays));
        if (const Status written =
                file.text(vtkLegacyHead("tetrahedral mesh by TAn", "UNSTRUCTURED_GRID", content.facts));
            !written)
            return written;
        if (const Status written = writeGeometry(file, content); !written)
            return written;
        if (const Status written = writeArrays(file, "CELL_DATA", cells, content.cellArrays); !written)
            return written;
        return writeArrays(file, "POINT_DATA", points, content.pointArrays);
    }

    Status writeSurface(const SurfaceContent& content, OutputFile& file,
                        const ParameterValues& /*values*/) const override
    {
        const std::uint64_t vertices = content.vertexCount(), triangles = content.triangleCount();
        if (vertices > mostNumbers || 4 * triangles > mostNumbers)
            return Error{ErrorKind::OutOfResource,
                         Message::say("'%1' would hold more than a legacy VTK file can number. Write a .vtp file, or a "
                                      "surface of a larger error.",
                                      file.target().string())};
        file.expect(vertices * (content.hasColours() ? 31 : 28) + triangles * legacyTriangleBytes +
                    bytesOf(content.cellArrays));
        if (const Status written = writeAll(file, content); !written)
            return written;
        return file.text("\n");
    }
};

} // namespace tetra

TAN_PLUGIN(tetra::VtkLegacyWriter, tetra::Writer)
