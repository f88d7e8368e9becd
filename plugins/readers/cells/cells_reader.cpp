// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_reader.h"

#include "plugins/readers/cells/cells_file.h"

namespace tetra {

namespace {

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool isVtu(std::string_view firstBytes)
{
    return firstBytes.find("<VTKFile") != std::string_view::npos &&
           firstBytes.find("UnstructuredGrid") != std::string_view::npos;
}

/// Opens the file and calls one of two for what it holds.
template <class Value, class Vtu, class Ucd>
Result<Value> withFile(const std::filesystem::path& path, Vtu&& vtu, Ucd&& ucd)
{
    constexpr std::size_t headBytes = 4096;
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const std::string_view bytes = asText((*file)->bytes());
    const bool xml = isVtu(bytes.substr(0, headBytes)) || fileEnding(path) == ".vtu";
    Result<Value> result = xml ? vtu(bytes) : ucd(bytes);
    if ((*file)->damaged())
        return Error{ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")};
    return result;
}

} // namespace

std::vector<std::string> CellsReader::nameFilters() const
{
    return {Message::marked("VTK unstructured grid (*.vtu)"), Message::marked("AVS UCD mesh (*.inp)")};
}

double CellsReader::score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const
{
    // A reader by VTK itself, where there is one, knows more kinds of .vtu.
    constexpr double ofVtu = 0.8, ofUcd = 0.95;
    if (isVtu(asText(firstBytes)) || fileEnding(path) == ".vtu")
        return ofVtu;
    return fileEnding(path) == ".inp" && looksLikeUcd(asText(firstBytes)) ? ofUcd : 0;
}

std::vector<Parameter> CellsReader::parameters() const
{
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Array");
    array.explanation =
        Message::marked("The array whose values to take, of points or of cells; nothing takes the one the file calls "
                        "active, else the first.");
    array.defaultValue = std::string();
    Parameter component;
    component.id = "component";
    component.label = Message::marked("Component");
    component.explanation = Message::marked("Of arrays with several components: magnitude, or a number from 0.");
    component.defaultValue = std::string("magnitude");
    return {array, component};
}

Result<Dataset> CellsReader::read(const std::filesystem::path& path, const ParameterValues& values,
                                  const Progress& progress) const
{
    constexpr double readingShare = 0.4;
    CellsRequest request{parameterValue<std::string>(parameters(), values, "array"),
                         parameterValue<std::string>(parameters(), values, "component")};
    if (request.array == "automatic") // what other readers say
        request.array.clear();
    const auto reading = progress.part(0, readingShare);
    const auto made = [&](Result<CellsFile> file) -> Result<Dataset> {
        if (!file)
            return file.error();
        const std::string array = file->arrayName.empty() ? "" : ", " + printable(file->arrayName);
        return irregularDataset(file->complex, file->values,
                                {.name = path.filename().string() + array, .path = path, .hash = 0},
                                progress.part(readingShare, 1));
    };
    return withFile<Dataset>(
        path, [&](std::string_view bytes) { return made(readVtu(bytes, request, reading)); },
        [&](std::string_view bytes) { return made(readUcd(bytes, request, reading)); });
}

Result<FileContents> CellsReader::probe(const std::filesystem::path& path, const ParameterValues& /*values*/,
                                        const Progress& /*progress*/) const
{
    return withFile<FileContents>(path, probeVtu, probeUcd);
}

} // namespace tetra
