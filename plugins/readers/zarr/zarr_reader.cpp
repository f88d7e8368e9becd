// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/zarr/zarr_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/readers/zarr/zarr_parameters.h"
#include "plugins/readers/zarr/zarr_root.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Result<ZarrRequest> requestFor(const fs::path& path, const ParameterValues& values)
{
    ZarrRequest request = zarrRequest(values);
    request.folder = zarrRootOf(path).string();
    if (request.folder.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("it is neither a Zarr folder nor a file that describes one (zarr.json, .zarray, "
                                  ".zattrs, .zgroup). Let TAn choose the reader.")};
    Lattice lattice;
    std::string lengthUnit;
    request.given = givenPlacement(values);
    if (const Status understood = placeByUser(values, request.given, lattice, lengthUnit); !understood)
        return understood.error();
    return request;
}

fs::path besidePlugin()
{
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-zarr");
}

Result<ReadAnswer> ask(const fs::path& helper, const ZarrRequest& request, const Progress& progress)
{
    return askReadingProgram(zarrReadingProgram(helper), requestText(request), request.folder, progress);
}

} // namespace

ReadingProgram zarrReadingProgram(fs::path helper)
{
    return {
        .path = std::move(helper),
        .library = "Zarr",
        .notInstalled =
            Message::say("Install the package tan-vtk-readers, which comes with TAn: 'apt install "
                         "./tan-vtk-readers_*.deb' in the folder of that file (if you built TAn yourself: rebuild it "
                         "after 'apt install libblosc-dev libzstd-dev'), or save the array as NumPy's (.npy)."),
        .install = Message::say("Install Blosc and Zstandard with 'apt install libblosc1 libzstd1'."),
        .otherwise = Message::say("Copy or export it again, or save the array as NumPy's (.npy)."),
    };
}

ZarrReader::ZarrReader(fs::path helper) : helper_(helper.empty() ? besidePlugin() : std::move(helper)) {}

std::vector<std::string> ZarrReader::nameFilters() const
{
    return {Message::marked("Zarr, OME-Zarr (*.zarr zarr.json .zattrs .zgroup .zarray)")};
}

double ZarrReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double certain = 1, byBoth = 0.9, byName = 0.2;
    if (firstBytes.empty())
        return isZarrFolder(path) ? certain : 0;
    if (!isZarrMetadataName(path))
        return 0;
    const std::string_view text(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    const auto start = text.find_first_not_of(" \t\r\n");
    return start != std::string_view::npos && text[start] == '{' ? byBoth : byName;
}

std::vector<Parameter> ZarrReader::parameters() const
{
    return zarrParameters();
}

Result<Dataset> ZarrReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    constexpr double untilFound = 0.9; // of the time, roughly; the rest makes the dataset out of it
    const auto request = requestFor(path, values);
    if (!request)
        return request.error();
    auto answer = ask(helper_, *request, progress.part(0, untilFound));
    if (!answer)
        return answer.error();
    auto& findings = std::get<FileFindings>(*answer);
    if (const Status placed = placeByUser(values, findings.untold, findings.lattice, findings.lengthUnit); !placed)
        return placed.error();
    std::ranges::move(remarkOnSpacing(values, findings.untold, findings.lattice), std::back_inserter(findings.remarks));
    const std::string folder = fs::path(request->folder).filename().string();
    const std::string array = findings.arrayName;
    const Source source{array.empty() ? folder : folder + ", " + array, path, 0, array};
    auto dataset = datasetOf(std::move(findings), source, std::nullopt, progress.part(untilFound, 1));
    if (!dataset)
        return dataset.error();
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> ZarrReader::probe(const fs::path& path, const ParameterValues& values,
                                       const Progress& progress) const
{
    auto request = requestFor(path, values);
    if (!request)
        return request.error();
    request->contentsOnly = true;
    auto answer = ask(helper_, *request, progress);
    if (!answer)
        return answer.error();
    auto& contents = std::get<FileContents>(*answer);
    std::string lengthUnit;
    if (const Status placed = placeByUser(values, contents.untold, contents.lattice, lengthUnit); !placed)
        return placed.error();
    return std::move(contents);
}

} // namespace tetra
