// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/writers/vtk_legacy.h"

#include "core/mesh/mesh_output.h"
#include "plugins/writers/mesh_formats.h"
#include "plugins/writers/surface_formats.h"

#include <type_traits>

namespace tetra {

namespace {

/// How VTK tells the length of a text in a binary file: in 1, 2, 4 or 8 bytes, of which the first two bits say which.
std::string withLength(const std::string& text)
{
    const std::uint64_t length = text.size();
    const int bytes = length < 1U << 6 ? 1 : length < 1U << 14 ? 2 : length < 1U << 30 ? 4 : 8;
    const std::uint64_t kind = bytes == 1 ? 3 : bytes == 2 ? 2 : bytes == 4 ? 1 : 0;
    const std::uint64_t code = length | kind << (8 * bytes - 2);
    std::string encoded;
    for (int byte = bytes - 1; byte >= 0; --byte)
        encoded += static_cast<char>(code >> (8 * byte) & 255);
    return encoded + text;
}

std::string titleText(const MeshFacts& facts)
{
    if (facts.empty())
        return "";
    std::string text = "FIELD FieldData " + std::to_string(facts.size()) + "\n";
    for (const auto& [name, fact] : facts) {
        if (const auto* number = std::get_if<double>(&fact)) {
            std::byte bytes[sizeof *number];
            std::byte* where = bytes;
            putTurned(where, *number);
            text += vtkLegacyWord(name) + " 1 1 double\n";
            text.append(reinterpret_cast<const char*>(bytes), sizeof bytes);
        } else {
            text += vtkLegacyWord(name) + " 1 1 string\n" + withLength(std::get<std::string>(fact));
        }
        text += "\n";
    }
    return text;
}

} // namespace

std::string vtkLegacyWord(std::string_view name)
{
    constexpr std::string_view digits = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : name) {
        const auto code = static_cast<unsigned char>(c);
        if (code > ' ' && code < 127 && c != '%' && c != '"')
            encoded += c;
        else
            encoded += {'%', digits[code >> 4], digits[code & 15]};
    }
    return encoded;
}

std::string vtkLegacyHead(std::string_view title, std::string_view dataset, const MeshFacts& facts)
{
    return "# vtk DataFile Version 4.2\n" + std::string(title) + "\nBINARY\nDATASET " + std::string(dataset) + "\n" +
           titleText(facts);
}

namespace {

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

Status writeGeometry(MeshOutput& out, const MeshContent& content)
{
    const std::uint64_t cells = content.tetrahedra.size();
    if (const Status written = out.text("POINTS " + std::to_string(content.positions.size()) + " float\n"); !written)
        return written;
    if (const Status written = out.records(content.positions.size(), 12,
                                           [&](std::uint64_t index, std::byte* where) {
                                               for (const float coordinate : content.positions[index])
                                                   putTurned(where, coordinate);
                                           });
        !written)
        return written;
    if (const Status written = out.text("\nCELLS " + std::to_string(cells) + " " + std::to_string(5 * cells) + "\n");
        !written)
        return written;
    if (const Status written = out.records(cells, 20,
                                           [&](std::uint64_t index, std::byte* where) {
                                               putTurned(where, std::int32_t(4));
                                               for (const std::uint32_t vertex : content.tetrahedra[index])
                                                   putTurned(where, vertex);
                                           });
        !written)
        return written;
    if (const Status written = out.text("\nCELL_TYPES " + std::to_string(cells) + "\n"); !written)
        return written;
    if (const Status written =
            out.records(cells, 4, [](std::uint64_t, std::byte* where) { putTurned(where, legacyTetra); });
        !written)
        return written;
    return out.text("\n");
}

/// The first array is the one that viewers show at once, the others are fields.
Status writeArrays(MeshOutput& out, std::string_view keyword, std::uint64_t count, std::span<const NamedArray> arrays)
{
    if (arrays.empty())
        return {};
    if (const Status written = out.text(std::string(keyword) + " " + std::to_string(count) + "\n"); !written)
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
                if (const Status begun = out.text(head); !begun)
                    return begun;
                if (const Status put =
                        out.records(count, sizeof(T),
                                    [&](std::uint64_t index, std::byte* where) { putTurned(where, values[index]); });
                    !put)
                    return put;
                return out.text("\n");
            },
            arrays[number].values);
        if (!written)
            return written;
    }
    return {};
}

} // namespace

Status writeVtk(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    if (content.positions.size() > mostVtkLegacyNumbers || 5 * content.tetrahedra.size() > mostVtkLegacyNumbers)
        return Error{
            ErrorKind::OutOfResource,
            Message::say("'%1' would hold more than a legacy VTK file can number. Write a .vtu file.", path.string())};
    auto out = MeshOutput::create(path, bytesOf(content, 24), writingMesh, progress);
    if (!out)
        return out.error();
    if (const Status written = out->text(vtkLegacyHead("tetrahedral mesh by TAn", "UNSTRUCTURED_GRID", content.facts));
        !written)
        return written;
    if (const Status written = writeGeometry(*out, content); !written)
        return written;
    if (const Status written = writeArrays(*out, "CELL_DATA", content.tetrahedra.size(), content.cellArrays); !written)
        return written;
    if (const Status written = writeArrays(*out, "POINT_DATA", content.positions.size(), content.pointArrays); !written)
        return written;
    return out->commit();
}

namespace {

constexpr std::size_t vectorBytes = 3 * sizeof(float);
constexpr std::size_t legacyTriangleBytes = 4 * sizeof(std::int32_t);

Status writeVectors(MeshOutput& out, const SurfaceContent& content,
                    std::span<const Eigen::Vector3f> SurfacePart::*which)
{
    const auto vector = [which](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        for (const float coordinate : (part.*which)[index])
            putTurned(where, coordinate);
    };
    return partRecords(out, content, vertexCount, vectorBytes, vector);
}

Status writeTriangles(MeshOutput& out, const SurfaceContent& content)
{
    const auto triangle = [](const SurfacePart& part, std::uint64_t first, std::uint64_t index, std::byte* where) {
        putTurned(where, std::int32_t(3));
        for (const std::uint32_t corner : part.triangles[index])
            putTurned(where, static_cast<std::int32_t>(first + corner));
    };
    return partRecords(out, content, triangleCount, legacyTriangleBytes, triangle);
}

Status writeValues(MeshOutput& out, const SurfaceContent& content)
{
    const auto value = [](const SurfacePart& part, std::uint64_t, std::uint64_t index, std::byte* where) {
        putTurned(where, valueAt(part, index));
    };
    return partRecords(out, content, vertexCount, sizeof(float), value);
}

Status writeAll(MeshOutput& out, const SurfaceContent& content, const SurfaceSize& size)
{
    const std::string vertices = std::to_string(size.vertices);
    if (const Status written = out.text(vtkLegacyHead(content.title + " by TAn", "POLYDATA", content.facts) +
                                        "POINTS " + vertices + " float\n");
        !written)
        return written;
    if (const Status written = writeVectors(out, content, &SurfacePart::positions); !written)
        return written;
    if (const Status written =
            out.text("\nPOLYGONS " + std::to_string(size.triangles) + " " + std::to_string(4 * size.triangles) + "\n");
        !written)
        return written;
    if (const Status written = writeTriangles(out, content); !written)
        return written;
    if (const Status written = out.text("\nPOINT_DATA " + vertices + "\nSCALARS " + vtkLegacyWord(content.valueName) +
                                        " float 1\nLOOKUP_TABLE default\n");
        !written)
        return written;
    if (const Status written = writeValues(out, content); !written || !hasNormals(content))
        return written;
    if (const Status written = out.text("\nNORMALS Normals float\n"); !written)
        return written;
    return writeVectors(out, content, &SurfacePart::normals);
}

} // namespace

Status writeVtkSurface(const std::filesystem::path& path, const SurfaceContent& content, const Progress& progress)
{
    const SurfaceSize size = sizeOf(content);
    if (size.vertices > mostVtkLegacyNumbers || 4 * size.triangles > mostVtkLegacyNumbers)
        return tooLarge(Message::say("'%1' would hold more than a legacy VTK file can number.", path.string()));
    auto out =
        MeshOutput::create(path, size.vertices * 28 + size.triangles * legacyTriangleBytes, writingSurfaces, progress);
    if (!out)
        return out.error();
    if (const Status written = writeAll(*out, content, size); !written)
        return written;
    if (const Status written = out->text("\n"); !written)
        return written;
    return out->commit();
}

} // namespace tetra
