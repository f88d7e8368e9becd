// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/hdf5/hdf5_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/readers/hdf5/hdf5_parameters.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 8> endings = {".h5", ".hdf5", ".hdf", ".he5", ".nxs", ".nx5", ".mat", ".ims"};

std::string loweredName(const fs::path& path)
{
    std::string name = path.filename().string();
    std::ranges::transform(name, name.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return name;
}

/// The signature stands at the beginning, or behind a block of the user's own.
bool isHdf5(std::string_view bytes)
{
    constexpr std::array<std::size_t, 4> places = {0, 512, 1024, 2048};
    return std::ranges::any_of(places, [&](std::size_t place) {
        return place < bytes.size() && bytes.substr(place).starts_with("\x89HDF\r\n\x1a\n");
    });
}

Result<Hdf5Request> requestFor(const fs::path& path, const ParameterValues& values)
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    if ((*file)->bytes().empty())
        return Error{ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")};
    Hdf5Request request = hdf5Request(values);
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
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-hdf5");
}

Result<ReadAnswer> ask(const fs::path& helper, const Hdf5Request& request, const Progress& progress)
{
    return askReadingProgram(hdf5ReadingProgram(helper), requestText(request), request.path, progress);
}

} // namespace

ReadingProgram hdf5ReadingProgram(fs::path helper)
{
    return {
        .path = std::move(helper),
        .library = "HDF5",
        .notInstalled = Message::say(
            "Install the package tan-vtk-readers, which comes with TAn: 'apt install ./tan-vtk-readers_*.deb' in the "
            "folder of that file (if you built TAn yourself: rebuild it after 'apt install libhdf5-dev'), or save the "
            "array as .npy, for instance with h5py and NumPy."),
        .install = Message::say("Install the HDF5 library with 'apt install libhdf5-103-1' (other systems: hdf5)."),
        .otherwise = Message::say("Copy or export it again; 'h5dump -H' shows its content."),
    };
}

Hdf5Reader::Hdf5Reader(fs::path helper) : helper_(helper.empty() ? besidePlugin() : std::move(helper)) {}

std::vector<std::string> Hdf5Reader::nameFilters() const
{
    return {Message::marked("HDF5 (*.h5 *.hdf5 *.hdf *.he5 *.nxs *.nx5 *.mat *.ims)")};
}

double Hdf5Reader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    // Less than those who know a format inside HDF5 by its name, more than VTK's for .hdf.
    constexpr double byBoth = 0.65, bySignature = 0.4, byName = 0.1;
    constexpr double withoutLibrary = 0.5; // to say what to install, unless another reader reads the file
    const std::string name = loweredName(path);
    const std::string_view bytes(reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size());
    const bool isNamed = std::ranges::any_of(
        endings, [&](std::string_view ending) { return name.size() > ending.size() && name.ends_with(ending); });
    double score = isNamed && !name.ends_with(".mat") ? byName : 0; // older files of MATLAB are none
    if (isHdf5(bytes) && bytes.find("VTKHDF") == std::string_view::npos)
        score = isNamed ? byBoth : bySignature;
    std::error_code ignored;
    return score > 0 && !fs::exists(helper_, ignored) ? score * withoutLibrary : score;
}

std::vector<Parameter> Hdf5Reader::parameters() const
{
    return hdf5Parameters();
}

Result<Dataset> Hdf5Reader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
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
    const Source source{path.filename().string() + ", " + findings.arrayName, path, 0, findings.arrayName};
    auto dataset = datasetOf(std::move(findings), source, std::nullopt, progress.part(untilFound, 1), values);
    if (!dataset)
        return dataset.error();
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> Hdf5Reader::probe(const fs::path& path, const ParameterValues& values,
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
