// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/netcdf/netcdf_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/process/parts.h"
#include "plugins/readers/netcdf/classic_check.h"
#include "plugins/readers/netcdf/netcdf_parameters.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 10> endings = {".nc",  ".nc4", ".netcdf", ".cdf", ".ncdf",
                                                      ".ex2", ".exo", ".exii",   ".e",   ".g"};

std::string loweredName(const fs::path& path)
{
    std::string name = path.filename().string();
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return name;
}

Result<NetCdfRequest> requestFor(const fs::path& path, const ParameterValues& values)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    if ((*file)->bytes().empty())
        return Error{ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")};
    NetCdfRequest request = netCdfRequest(values);
    request.path = fs::absolute(path).string();
    Lattice lattice;
    std::string lengthUnit;
    request.given = givenPlacement(values);
    if (const Status understood = placeByUser(values, request.given, lattice, lengthUnit); !understood)
        return understood.error();
    return request;
}

fs::path besidePlugin()
{
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-netcdf");
}

Result<ReadAnswer> ask(const fs::path& helper, const NetCdfRequest& request, const Progress& progress)
{
    return askReadingProgram(netCdfReadingProgram(helper), requestText(request), request.path, progress);
}

} // namespace

ReadingProgram netCdfReadingProgram(fs::path helper)
{
    return {
        .path = std::move(helper),
        .library = "NetCDF",
        .notInstalled =
            Message::say("Install the package tan-vtk-readers, which comes with TAn: 'apt install "
                         "./tan-vtk-readers_*.deb' in the folder of that file (if you built TAn yourself: rebuild it "
                         "after 'apt install libnetcdf-dev'), or convert the file to NRRD or VTU."),
        .install = Message::say("Install the NetCDF library with 'apt install libnetcdf19' (other systems: netcdf-c)."),
        .otherwise = Message::say("Copy or export it again; 'ncdump -h' shows its content."),
    };
}

NetCdfReader::NetCdfReader(fs::path helper) : helper_(helper.empty() ? besidePlugin() : std::move(helper)) {}

std::vector<std::string> NetCdfReader::nameFilters() const
{
    return {Message::marked("NetCDF (*.nc *.nc4 *.netcdf *.cdf *.ncdf)"),
            Message::marked("Exodus II (*.ex2 *.exo *.exii *.e *.g)")};
}

double NetCdfReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double bySignature = 0.9, byBoth = 0.7, byName = 0.15;
    constexpr double withoutLibrary = 0.5; // to say what to install, unless another reader reads the file
    const std::string name = loweredName(path);
    const std::string_view bytes(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    const bool isNamed = std::ranges::any_of(
        endings, [&](std::string_view ending) { return name.size() > ending.size() && name.ends_with(ending); });
    if (name.ends_with(".mnc"))
        return 0; // MINC, which is no grid by the conventions
    double score = isNamed ? byName : 0;
    if (isClassicNetCdf(firstBytes))
        score = bySignature;
    else if (bytes.starts_with("\x89HDF") && // also of other formats
             (isNamed || name.starts_with("wrfout") || bytes.find("_NCProperties") != std::string_view::npos))
        score = byBoth;
    std::error_code ignored;
    return score > 0 && !fs::exists(helper_, ignored) ? score * withoutLibrary : score;
}

std::vector<Parameter> NetCdfReader::parameters() const
{
    return netCdfParameters();
}

Result<Dataset> NetCdfReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    return readAny(std::nullopt, path, values, progress);
}

Result<Dataset> NetCdfReader::readAround(const Eigen::AlignedBox3d& region, const fs::path& path,
                                         const ParameterValues& values, const Progress& progress) const
{
    return readAny(region, path, values, progress);
}

Result<Dataset> NetCdfReader::readAny(const std::optional<Eigen::AlignedBox3d>& region, const fs::path& path,
                                      const ParameterValues& values, const Progress& progress) const
{
    constexpr double untilFound = 0.7; // of the time, roughly; the rest makes the dataset out of it
    const auto request = requestFor(path, values);
    if (!request)
        return request.error();
    auto answer = ask(helper_, *request, progress.part(0, untilFound));
    if (!answer)
        return answer.error();
    auto& findings = std::get<FileFindings>(*answer);
    if (const Status placed = placeByUser(values, findings.untold, findings.lattice, findings.lengthUnit); !placed)
        return placed.error();
    if (findings.kind == FoundKind::Lattice)
        std::ranges::move(remarkOnSpacing(values, findings.untold, findings.lattice),
                          std::back_inserter(findings.remarks));
    const bool isMesh = findings.kind == FoundKind::Cells;
    const Source source{path.filename().string() + ", " + findings.arrayName, path, 0, findings.arrayName};
    auto dataset = datasetOf(std::move(findings), source, region, progress.part(untilFound, 1), values);
    if (!dataset && isMesh && dataset.error().kind == ErrorKind::BadInput && request->part.empty())
        if (const auto contents = probe(path, values, progress))
            return errorOfParts(dataset.error(), contents->blocks);
    if (!dataset)
        return dataset.error();
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> NetCdfReader::probe(const fs::path& path, const ParameterValues& values,
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
