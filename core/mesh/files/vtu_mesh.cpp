// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/mesh/files/mesh_formats.h"
#include "core/mesh/files/mesh_output.h"

#include <limits>
#include <type_traits>

namespace tetra {

namespace {

constexpr std::uint8_t vtkTetra = 10;

template <class T> constexpr std::string_view typeName()
{
    if constexpr (std::is_same_v<T, float>)
        return "Float32";
    else if constexpr (std::is_same_v<T, double>)
        return "Float64";
    else if constexpr (std::is_same_v<T, std::uint8_t>)
        return "UInt8";
    else if constexpr (std::is_same_v<T, std::uint16_t>)
        return "UInt16";
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return "UInt32";
    else if constexpr (std::is_same_v<T, std::int32_t>)
        return "Int32";
    else
        return "Int64";
}

/// Text as the value of an attribute. What XML cannot hold becomes a question mark.
std::string attribute(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
        switch (c) {
        case '&': escaped += "&amp;"; break;
        case '<': escaped += "&lt;"; break;
        case '>': escaped += "&gt;"; break;
        case '"': escaped += "&quot;"; break;
        default: escaped += static_cast<unsigned char>(c) < ' ' ? '?' : c;
        }
    return escaped;
}

/// The XML part, and where each array will lie behind it.
class Head {
public:
    explicit Head(const MeshContent& content) : content_(content) {}

    /// `Index` is the type of the numbers of vertices.
    template <class Index> std::string text()
    {
        const std::size_t cells = content_.tetrahedra.size();
        text_ = "<?xml version=\"1.0\"?>\n"
                "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
                "header_type=\"UInt64\">\n<UnstructuredGrid>\n";
        facts();
        text_ += "<Piece NumberOfPoints=\"" + std::to_string(content_.positions.size()) + "\" NumberOfCells=\"" +
                 std::to_string(cells) + "\">\n";
        arrays("PointData", content_.pointArrays);
        arrays("CellData", content_.cellArrays);
        text_ += "<Points>\n";
        array<float>("Points", 3 * content_.positions.size(), " NumberOfComponents=\"3\"");
        text_ += "</Points>\n<Cells>\n";
        array<Index>("connectivity", 4 * cells);
        array<Index>("offsets", cells);
        array<std::uint8_t>("types", cells);
        text_ += "</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";
        return std::move(text_);
    }

private:
    template <class T> void array(std::string_view name, std::uint64_t count, std::string_view more = {})
    {
        text_ += "<DataArray type=\"" + std::string(typeName<T>()) + "\" Name=\"" + attribute(name) + "\"" +
                 std::string(more) + " format=\"appended\" offset=\"" + std::to_string(offset_) + "\"/>\n";
        offset_ += sizeof(std::uint64_t) + count * sizeof(T);
    }

    void arrays(std::string_view element, const std::vector<NamedArray>& named)
    {
        const std::string active = named.empty() ? "" : " Scalars=\"" + attribute(named.front().name) + "\"";
        text_ += "<" + std::string(element) + active + ">\n";
        for (const NamedArray& one : named)
            std::visit([&]<class T>(std::span<const T> values) { array<T>(one.name, values.size()); }, one.values);
        text_ += "</" + std::string(element) + ">\n";
    }

    /// Numbers and texts of one tuple; texts as VTK writes them, by the codes of their bytes.
    void facts()
    {
        if (content_.facts.empty())
            return;
        text_ += "<FieldData>\n";
        for (const auto& [name, fact] : content_.facts) {
            const auto* number = std::get_if<double>(&fact);
            text_ += "<DataArray type=\"" + std::string(number != nullptr ? "Float64" : "String") + "\" Name=\"" +
                     attribute(name) + "\" NumberOfTuples=\"1\" format=\"ascii\">";
            if (number != nullptr)
                text_ += formatNumber(*number);
            else {
                for (const char c : std::get<std::string>(fact))
                    text_ += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
                text_ += "0";
            }
            text_ += "</DataArray>\n";
        }
        text_ += "</FieldData>\n";
    }

    const MeshContent& content_;
    std::string text_;
    std::uint64_t offset_ = 0;
};

Status writeArray(MeshOutput& out, std::span<const std::byte> values)
{
    const std::uint64_t size = values.size();
    if (const Status written = out.bytes(std::as_bytes(std::span(&size, 1))); !written)
        return written;
    return out.bytes(values);
}

/// An array whose values follow from their place.
template <class Value, class Make> Status writeMade(MeshOutput& out, std::uint64_t count, Make&& make)
{
    const std::uint64_t size = count * sizeof(Value);
    if (const Status written = out.bytes(std::as_bytes(std::span(&size, 1))); !written)
        return written;
    return out.records(count, sizeof(Value), [&](std::uint64_t index, std::byte* where) {
        putNumber(where, static_cast<Value>(make(index)));
    });
}

template <class Index> Status writeAs(MeshOutput& out, const MeshContent& content)
{
    if (const Status written = out.text(Head(content).text<Index>()); !written)
        return written;
    for (const auto* arrays : {&content.pointArrays, &content.cellArrays})
        for (const NamedArray& array : *arrays)
            if (const Status written = std::visit(
                    [&](const auto& values) { return writeArray(out, std::as_bytes(values)); }, array.values);
                !written)
                return written;
    if (const Status written = writeArray(out, std::as_bytes(content.positions)); !written)
        return written;
    const auto corner = [&](std::uint64_t index) { return content.tetrahedra[index / 4][index % 4]; };
    if (const Status written = writeMade<Index>(out, 4 * content.tetrahedra.size(), corner); !written)
        return written;
    const auto end = [](std::uint64_t cell) { return 4 * (cell + 1); };
    if (const Status written = writeMade<Index>(out, content.tetrahedra.size(), end); !written)
        return written;
    const auto type = [](std::uint64_t) { return vtkTetra; };
    if (const Status written = writeMade<std::uint8_t>(out, content.tetrahedra.size(), type); !written)
        return written;
    return out.text("\n</AppendedData>\n</VTKFile>\n");
}

} // namespace

Status writeVtu(const std::filesystem::path& path, const MeshContent& content, const Progress& progress)
{
    // Indices and offsets of one type, as VTK takes them without converting.
    const bool small = std::max(content.positions.size(), 4 * content.tetrahedra.size()) <=
                       static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    const std::size_t bytesOfCell = 1 + 5 * (small ? sizeof(std::int32_t) : sizeof(std::int64_t));
    auto out = MeshOutput::create(path, bytesOf(content, bytesOfCell), writingMesh, progress);
    if (!out)
        return out.error();
    if (const Status written = small ? writeAs<std::int32_t>(*out, content) : writeAs<std::int64_t>(*out, content);
        !written)
        return written;
    return out->commit();
}

} // namespace tetra
