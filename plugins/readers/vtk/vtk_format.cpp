// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/vtk_format.h"

#include "plugins/readers/vtk/tecplot_text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace tetra {
namespace {

struct FormatEntry {
    VtkFormat format;
    std::string_view filter;
    double byName; ///< the score of a file with one of these names, if it has no signature
};

/// Names that other readers claim too have a score that leaves those the first choice.
constexpr std::array<FormatEntry, 10> formats = {{
    {VtkFormat::Xml,
     Message::marked("VTK XML (*.vti *.vtr *.vts *.vtp *.vtm *.vtmb *.pvti *.pvtr *.pvts *.pvtu *.pvtp)"), 0.6},
    {VtkFormat::Legacy, Message::marked("VTK legacy (*.vtk)"), 0.6},
    {VtkFormat::Hdf, Message::marked("VTK HDF (*.vtkhdf *.hdf)"), 0.6},
    {VtkFormat::Series, Message::marked("Lists of VTK files (*.pvd *.series)"), 0.8},
    {VtkFormat::EnSight, Message::marked("EnSight (*.case *.encas)"), 0.8},
    {VtkFormat::Cgns, Message::marked("CGNS (*.cgns)"), 0.8},
    {VtkFormat::Gambit, Message::marked("GAMBIT (*.neu)"), 0.8},
    {VtkFormat::Fluent, Message::marked("Fluent (*.cas)"), 0.8},
    {VtkFormat::OpenFoam, Message::marked("OpenFOAM (*.foam controlDict)"), 0.8},
    {VtkFormat::Tecplot, Message::marked("Tecplot text (*.tec *.tp)"), 0.5},
}};

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

/// Whether the name ends as one of the patterns of "Text (*.one *.two)" says.
bool fitsFilter(const std::string& name, std::string_view filter)
{
    filter.remove_prefix(filter.rfind('(') + 1);
    filter.remove_suffix(1);
    while (!filter.empty()) {
        const auto end = std::min(filter.find(' '), filter.size());
        const std::string pattern = lowered(std::string(filter.substr(0, end)));
        if (pattern.starts_with('*') ? name.size() > pattern.size() - 1 && name.ends_with(pattern.substr(1))
                                     : name == pattern)
            return true;
        filter.remove_prefix(std::min(end + 1, filter.size()));
    }
    return false;
}

bool hasAt(std::string_view bytes, std::size_t place, std::string_view wanted)
{
    return bytes.size() >= place + wanted.size() && bytes.substr(place, wanted.size()) == wanted;
}

/// The format of a text that begins with the element VTKFile, by its type; meshes are left to the reader of these,
/// unless they are packed by what that does not know.
VtkFormat ofXml(std::string_view text)
{
    text = text.substr(0, text.find('>'));
    const auto says = [&](const std::string& name, const std::string& value) {
        return text.find(name + "=\"" + value + "\"") != std::string_view::npos ||
               text.find(name + "='" + value + "'") != std::string_view::npos;
    };
    const bool isPackedForVtk =
        says("compressor", "vtkLZ4DataCompressor") || says("compressor", "vtkLZMADataCompressor");
    if (says("type", "UnstructuredGrid"))
        return isPackedForVtk ? VtkFormat::Xml : VtkFormat::None;
    return says("type", "Collection") ? VtkFormat::Series : VtkFormat::Xml;
}

bool isSeriesJson(std::string_view bytes)
{
    const auto first = bytes.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && bytes[first] == '{' &&
           bytes.find("\"file-series-version\"") != std::string_view::npos;
}

/// The format whose signature a file begins with; None for those without.
VtkFormat bySignature(std::string_view bytes)
{
    if (hasAt(bytes, 0, "# vtk DataFile"))
        return VtkFormat::Legacy;
    if (const auto element = bytes.find("<VTKFile"); element != std::string_view::npos)
        return ofXml(bytes.substr(element));
    if (isSeriesJson(bytes))
        return VtkFormat::Series;
    if (hasAt(bytes, 0, "\x89HDF") && bytes.find("VTKHDF") != std::string_view::npos)
        return VtkFormat::Hdf;
    return looksLikeTecplot(bytes) ? VtkFormat::Tecplot : VtkFormat::None;
}

/// Whether the name alone would send a file to a reader for which its beginning is nothing.
bool isOutOfQuestion(VtkFormat format, std::string_view bytes)
{
    return format == VtkFormat::Hdf && !hasAt(bytes, 0, "\x89HDF");
}

} // namespace

VtkGuess guessVtkFormat(const std::filesystem::path& path, std::span<const std::byte> firstBytes)
{
    const std::string_view bytes(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    if (const VtkFormat format = bySignature(bytes); format != VtkFormat::None)
        return {format, 0.9};
    const std::string name = lowered(path.filename().string());
    const auto entry = std::ranges::find_if(formats, [&](const FormatEntry& e) { return fitsFilter(name, e.filter); });
    if (entry == formats.end())
        return {};
    return {entry->format, isOutOfQuestion(entry->format, bytes) ? entry->byName / 4 : entry->byName};
}

std::vector<std::string> vtkNameFilters()
{
    std::vector<std::string> filters;
    for (const FormatEntry& entry : formats)
        filters.emplace_back(entry.filter);
    return filters;
}

} // namespace tetra
