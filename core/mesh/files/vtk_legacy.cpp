// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/vtk_legacy.h"

#include "core/mesh/files/mesh_output.h"

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

} // namespace tetra
