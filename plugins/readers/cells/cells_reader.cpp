// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/cells/cells_reader.h"

#include "plugins/api/cells_parameters.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/readers/cells/cells_file.h"

#include <algorithm>
#include <iterator>

namespace tetra {

namespace {

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool isVtu(const std::filesystem::path& path, std::string_view firstBytes)
{
    return !vtkXmlType(firstBytes).empty() || fileEnding(path) == ".vtu";
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
    Result<Value> result = isVtu(path, bytes.substr(0, headBytes)) ? vtu(bytes) : ucd(bytes);
    if ((*file)->damaged())
        return Error{ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")};
    return result;
}

/// The points of a file whose cells have no volume, if it has values for them.
Result<Dataset> pointsOf(CellsFile file, const Source& source)
{
    if (file.values.perCell)
        return Error{
            ErrorKind::BadInput,
            Message::say("its array '%1' has values for its polygons, not its points. Choose an array of points.",
                         printable(file.arrayName))};
    if (file.joinsPoints)
        file.remarks.push_back(
            Message::say("The lines and polygons that join its points were left out: they are scattered points."));
    auto dataset = scatteredDataset(std::move(file.complex.positions), std::move(file.values.values), source.name);
    if (!dataset)
        return dataset.error();
    dataset->source = source;
    dataset->remarks.insert(dataset->remarks.begin(), file.remarks.begin(), file.remarks.end());
    return dataset;
}

Result<Dataset> meshOf(const CellsFile& file, const Source& source, const Progress& progress)
{
    auto dataset = irregularDataset(file.complex, file.values, source, progress);
    if (dataset)
        dataset->remarks.insert(dataset->remarks.begin(), file.remarks.begin(), file.remarks.end());
    return dataset;
}

bool isFlat(const CellsFile& file)
{
    return std::ranges::all_of(file.complex.shapes, [](CellShape shape) { return shape == CellShape::Flat; });
}

CellsRequest requestOf(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    CellsRequest request{parameterValue<std::string>(parameters, values, "array"),
                         values.contains("component") ? parameterValue<std::string>(parameters, values, "component")
                                                      : std::string()};
    if (request.array == "automatic") // what other readers say
        request.array.clear();
    return request;
}

/// `region`: CellComplex's.
Result<Dataset> readMesh(const std::filesystem::path& path, const CellsRequest& request, const ParameterValues& values,
                         const std::optional<Eigen::AlignedBox3d>& region, const Progress& progress)
{
    constexpr double readingShare = 0.4;
    const auto reading = progress.part(0, readingShare);
    const auto made = [&](Result<CellsFile> file) -> Result<Dataset> {
        if (!file)
            return file.error();
        file->complex.region = region;
        if (const Status understood = applyCellsParameters(values, file->complex); !understood)
            return understood.error();
        const std::string array = file->arrayName.empty() ? "" : ", " + printable(file->arrayName);
        const Source source{.name = path.filename().string() + array,
                            .path = path,
                            .hash = 0,
                            .valueName = file->arrayName,
                            .taken = file->taken,
                            .leftOut = file->leftOut};
        return isFlat(*file) ? pointsOf(*std::move(file), source)
                             : meshOf(*file, source, progress.part(readingShare, 1));
    };
    return withFile<Dataset>(
        path, [&](std::string_view bytes) { return made(readVtu(bytes, request, reading)); },
        [&](std::string_view bytes) { return made(readUcd(bytes, request, reading)); });
}

Result<Dataset> withUnit(Result<Dataset> dataset, const ParameterValues& values)
{
    if (dataset)
        dataset->lengthUnit = placementText(values, "unit");
    return dataset;
}

} // namespace

std::vector<std::string> CellsReader::nameFilters() const
{
    return {Message::marked("VTK unstructured grid (*.vtu)"), Message::marked("AVS UCD mesh (*.inp)")};
}

double CellsReader::score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double sure = 0.95, toSayWhatIsWrong = 0.2;
    const std::string type = vtkXmlType(asText(firstBytes));
    if (type == "UnstructuredGrid") // packed otherwise, VTK reads them
        return isPackedOtherwise(asText(firstBytes)) ? toSayWhatIsWrong : sure;
    if (fileEnding(path) == ".vtu")
        return type.empty() ? sure : toSayWhatIsWrong;
    return fileEnding(path) == ".inp" && looksLikeUcd(asText(firstBytes)) ? sure : 0;
}

std::vector<Parameter> CellsReader::parameters() const
{
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Array");
    array.explanation = Message::marked("The array whose values to take, of points or of cells; by default the one the "
                                        "file calls active, else the first.");
    array.defaultValue = std::string();
    Parameter component;
    component.id = "component";
    component.label = Message::marked("Component");
    component.explanation =
        Message::marked("Arrays with several components: the number of one, from 0, or 'magnitude'.");
    component.defaultValue = std::string("magnitude");
    std::vector<Parameter> all = {array, component};
    std::ranges::copy(cellsParameters(), std::back_inserter(all));
    all.push_back(unitParameter());
    return all;
}

Result<Dataset> CellsReader::read(const std::filesystem::path& path, const ParameterValues& values,
                                  const Progress& progress) const
{
    return withUnit(readMesh(path, requestOf(parameters(), values), values, std::nullopt, progress), values);
}

Result<Dataset> CellsReader::readAround(const Eigen::AlignedBox3d& region, const std::filesystem::path& path,
                                        const ParameterValues& values, const Progress& progress) const
{
    return withUnit(readMesh(path, requestOf(parameters(), values), values, region, progress), values);
}

Result<FileContents> CellsReader::probe(const std::filesystem::path& path, const ParameterValues& values,
                                        const Progress& /*progress*/) const
{
    const CellsRequest request = requestOf(parameters(), values);
    auto contents = withFile<FileContents>(
        path, [&](std::string_view bytes) { return probeVtu(bytes, request); },
        [&](std::string_view bytes) { return probeUcd(bytes, request); });
    if (contents)
        contents->untold = {"unit"};
    return contents;
}

} // namespace tetra
