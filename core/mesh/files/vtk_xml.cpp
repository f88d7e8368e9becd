// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/files/vtk_xml.h"

#include "core/base/number_text.h"

namespace tetra {

namespace {

/// Numbers and texts of one tuple; texts as VTK writes them, by the codes of their bytes.
std::string xmlFacts(const MeshFacts& facts)
{
    if (facts.empty())
        return "";
    std::string text = "<FieldData>\n";
    for (const auto& [name, fact] : facts) {
        const auto* number = std::get_if<double>(&fact);
        text += "<DataArray type=\"" + std::string(number != nullptr ? "Float64" : "String") + "\" Name=\"" +
                xmlAttribute(name) + "\" NumberOfTuples=\"1\" format=\"ascii\">";
        if (number != nullptr)
            text += formatNumber(*number);
        else {
            for (const char c : std::get<std::string>(fact))
                text += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
            text += "0";
        }
        text += "</DataArray>\n";
    }
    return text + "</FieldData>\n";
}

std::string headOf(const XmlGrid& grid)
{
    std::string text = "<?xml version=\"1.0\"?>\n<VTKFile type=\"" + grid.type +
                       "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<" + grid.type + ">\n" +
                       xmlFacts(grid.facts) + "<Piece" + grid.numbers + ">\n";
    std::uint64_t offset = 0;
    for (const XmlElement& element : grid.elements) {
        text += "<" + element.name + element.attributes + ">\n";
        for (const XmlArray& array : element.arrays) {
            text += "<DataArray type=\"" + std::string(array.type) + "\" Name=\"" + xmlAttribute(array.name) + "\"" +
                    (array.components > 1 ? " NumberOfComponents=\"" + std::to_string(array.components) + "\"" : "") +
                    " format=\"appended\" offset=\"" + std::to_string(offset) + "\"/>\n";
            offset += sizeof(std::uint64_t) + array.bytes;
        }
        text += "</" + element.name + ">\n";
    }
    return text + "</Piece>\n</" + grid.type + ">\n<AppendedData encoding=\"raw\">\n_";
}

} // namespace

std::string xmlAttribute(std::string_view text)
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

std::uint64_t bytesOf(const XmlGrid& grid)
{
    std::uint64_t bytes = 0;
    for (const XmlElement& element : grid.elements)
        for (const XmlArray& array : element.arrays)
            bytes += array.bytes;
    return bytes;
}

Status writeVtkXml(MeshOutput& out, const XmlGrid& grid)
{
    if (const Status written = out.text(headOf(grid)); !written)
        return written;
    for (const XmlElement& element : grid.elements)
        for (const XmlArray& array : element.arrays) {
            if (const Status written = out.bytes(std::as_bytes(std::span(&array.bytes, 1))); !written)
                return written;
            if (const Status written = array.write(out); !written)
                return written;
        }
    return out.text("\n</AppendedData>\n</VTKFile>\n");
}

} // namespace tetra
