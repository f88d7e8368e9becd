// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/mesh_output.h"

#include <limits>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::int32_t vtkTetra = 10;

template <class T> constexpr std::string_view typeName()
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

/// A name in one word: blanks and whatever else could mislead a reader as %XX, which VTK turns back.
std::string word(std::string_view name)
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

Status writeFacts(MeshOutput& out, const MeshContent& content)
{
    if (content.facts.empty())
        return {};
    std::string text = "FIELD FieldData " + std::to_string(content.facts.size()) + "\n";
    for (const auto& [name, fact] : content.facts) {
        if (const auto* number = std::get_if<double>(&fact)) {
            std::byte bytes[sizeof *number];
            std::byte* where = bytes;
            putTurned(where, *number);
            text += word(name) + " 1 1 double\n";
            text.append(reinterpret_cast<const char*>(bytes), sizeof bytes);
        } else {
            text += word(name) + " 1 1 string\n" + withLength(std::get<std::string>(fact));
        }
        text += "\n";
    }
    return out.text(text);
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
            out.records(cells, 4, [](std::uint64_t, std::byte* where) { putTurned(where, vtkTetra); });
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
                const std::string type(typeName<T>());
                std::string head = number == 1 ? "FIELD FieldData " + std::to_string(arrays.size() - 1) + "\n" : "";
                head += number == 0 ? "SCALARS " + word(arrays[number].name) + " " + type + " 1\nLOOKUP_TABLE default\n"
                                    : word(arrays[number].name) + " 1 " + std::to_string(count) + " " + type + "\n";
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
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (content.positions.size() > most || 5 * content.tetrahedra.size() > most)
        return Error{ErrorKind::OutOfResource,
                     "'" + path.string() + "' would hold more than a legacy VTK file can number. Write a .vtu file."};
    auto out = MeshOutput::create(path, bytesOf(content, 24), writingMesh, progress);
    if (!out)
        return out.error();
    if (const Status written = out->text("# vtk DataFile Version 4.2\ntetrahedral mesh by TAn\nBINARY\n"
                                         "DATASET UNSTRUCTURED_GRID\n");
        !written)
        return written;
    if (const Status written = writeFacts(*out, content); !written)
        return written;
    if (const Status written = writeGeometry(*out, content); !written)
        return written;
    if (const Status written = writeArrays(*out, "CELL_DATA", content.tetrahedra.size(), content.cellArrays); !written)
        return written;
    if (const Status written = writeArrays(*out, "POINT_DATA", content.positions.size(), content.pointArrays); !written)
        return written;
    return out->commit();
}

} // namespace tetra
