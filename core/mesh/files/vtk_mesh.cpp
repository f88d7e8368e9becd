// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/mesh_output.h"
#include "core/mesh/files/vtk_legacy.h"

#include <type_traits>

namespace tetra {

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
        return Error{ErrorKind::OutOfResource,
                     "'" + path.string() + "' would hold more than a legacy VTK file can number. Write a .vtu file."};
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

} // namespace tetra
