// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/vtk_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/process/parts.h"
#include "plugins/process/reading_process.h"
#include "plugins/readers/vtk/unwritten_memory.h"
#include "plugins/readers/vtk/vtk_format.h"
#include "plugins/readers/vtk/vtk_parameters.h"

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Result<VtkRequest> requestFor(const fs::path& path, const ParameterValues& values)
{
    constexpr std::size_t looked = 4096;
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto bytes = (*file)->bytes();
    VtkRequest request = vtkRequest(values);
    request.format = guessVtkFormat(path, bytes.first(std::min(looked, bytes.size()))).format;
    if (bytes.empty() && request.format != VtkFormat::OpenFoam) // which is told by the name alone
        return Error{ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")};
    request.path = fs::absolute(path).string();
    if (request.format == VtkFormat::None)
        return Error{ErrorKind::BadInput,
                     Message::say("its format is not one that TAn leaves to VTK. Let TAn choose the reader.")};
    Lattice lattice;
    std::string lengthUnit;
    request.given = givenPlacement(values);
    if (const Status understood = placeByUser(values, request.given, lattice, lengthUnit); !understood)
        return understood.error();
    return request;
}

Result<Dataset> toDataset(VtkFindings findings, const fs::path& path, const std::optional<Eigen::AlignedBox3d>& region,
                          const ParameterValues& values, const Progress& progress)
{
    if (const Status placed = placeByUser(values, findings.untold, findings.lattice, findings.lengthUnit); !placed)
        return placed.error();
    if (findings.kind == VtkDataKind::Lattice)
        std::ranges::move(remarkOnSpacing(values, findings.untold, findings.lattice),
                          std::back_inserter(findings.remarks));
    const Source source{path.filename().string() + ", " + findings.arrayName, path, 0, findings.arrayName};
    auto dataset = datasetOf(std::move(findings), source, region, progress, values);
    if (!dataset)
        return dataset.error();
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

fs::path besidePlugin()
{
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-vtk");
}

Result<ReadAnswer> ask(const fs::path& helper, const VtkRequest& request, const Progress& progress)
{
    ReadingProgram program = vtkReadingProgram(helper);
    if (mayBeUnwritten(request.format))
        program.environment.emplace_back(unwrittenMemoryEnvironment);
    return askReadingProgram(program, requestText(request), request.path, progress);
}

} // namespace

ReadingProgram vtkReadingProgram(fs::path helper)
{
    return {
        .path = std::move(helper),
        .library = "VTK",
        .notInstalled =
            Message::say("Install the package tan-vtk-readers, which comes with TAn: 'apt install "
                         "./tan-vtk-readers_*.deb' in the folder of that file (if you built TAn yourself: rebuild it "
                         "after 'apt install libvtk9-dev'), or convert the file to NRRD or CSV."),
        .install = Message::say("Install VTK with 'apt install libvtk9.1' (other systems: VTK 9)."),
        .otherwise = Message::say("Export it again, or in another format (.vtu, .vti)."),
    };
}

VtkReader::VtkReader(fs::path helper) : helper_(helper.empty() ? besidePlugin() : std::move(helper)) {}

std::vector<std::string> VtkReader::nameFilters() const
{
    return vtkNameFilters();
}

double VtkReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double withoutVtk = 0.5; // to say what to install, unless another reader reads the file
    const VtkGuess guess = guessVtkFormat(path, firstBytes);
    if (firstBytes.empty() && guess.format == VtkFormat::OpenFoam)
        return 1; // no other format has empty files
    std::error_code ignored;
    if (guess.score > 0 && !fs::exists(helper_, ignored))
        return guess.score * withoutVtk;
    return guess.score;
}

std::vector<Parameter> VtkReader::parameters() const
{
    return vtkParameters();
}

Result<Dataset> VtkReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    return readAny(std::nullopt, path, values, progress);
}

Result<Dataset> VtkReader::readAround(const Eigen::AlignedBox3d& region, const fs::path& path,
                                      const ParameterValues& values, const Progress& progress) const
{
    return readAny(region, path, values, progress);
}

Result<Dataset> VtkReader::readAny(const std::optional<Eigen::AlignedBox3d>& region, const fs::path& path,
                                   const ParameterValues& values, const Progress& progress) const
{
    auto request = requestFor(path, values);
    if (!request)
        return request.error();
    bool isMesh = false;
    const auto readAsked = [&](const Progress& part) -> Result<Dataset> {
        constexpr double untilFound = 0.7; // of the time, roughly; the rest makes the dataset out of it
        auto answer = ask(helper_, *request, part.part(0, untilFound));
        if (!answer)
            return answer.error();
        auto& findings = std::get<VtkFindings>(*answer);
        isMesh = findings.kind == VtkDataKind::Cells;
        return toDataset(std::move(findings), path, region, values, part.part(untilFound, 1));
    };
    auto dataset = readAsked(progress);
    if (dataset || dataset.error().kind != ErrorKind::BadInput || !isMesh || !request->part.empty())
        return dataset;
    // All parts make no mesh: which there are, and whether they are grids, of which the first can be read alone.
    request->joinsGrids = false;
    const auto contents = contentsAsked(*request, progress);
    if (!contents || contents->blocks.size() < 2)
        return dataset;
    if (!contents->domain || !isOnLattice(*contents->domain))
        return errorOfParts(dataset.error(), contents->blocks);
    auto first = readAsked(progress);
    if (!first)
        return errorOfParts(dataset.error(), contents->blocks);
    first->source.leftOut.push_back(notJoinedText(dataset.error().message));
    return first;
}

Result<FileContents> VtkReader::contentsAsked(VtkRequest request, const Progress& progress) const
{
    request.contentsOnly = true;
    auto answer = ask(helper_, request, progress);
    if (!answer)
        return answer.error();
    return std::get<FileContents>(*std::move(answer));
}

Result<FileContents> VtkReader::probe(const fs::path& path, const ParameterValues& values,
                                      const Progress& progress) const
{
    const auto request = requestFor(path, values);
    if (!request)
        return request.error();
    auto contents = contentsAsked(*request, progress);
    if (!contents)
        return contents;
    std::string lengthUnit;
    if (const Status placed = placeByUser(values, contents->untold, contents->lattice, lengthUnit); !placed)
        return placed.error();
    return contents;
}

} // namespace tetra
