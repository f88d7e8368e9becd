// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/images/images_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/readers/images/images_parameters.h"

#include <algorithm>
#include <iterator>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Result<ImagesRequest> requestFor(const fs::path& path, const ParameterValues& values)
{
    constexpr std::size_t looked = 4096;
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto bytes = (*file)->bytes();
    if (bytes.empty())
        return Error{ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")};
    ImagesRequest request = imagesRequest(values);
    request.format = guessImagesFormat(path, bytes.first(std::min(looked, bytes.size()))).format;
    request.path = fs::absolute(path).string();
    if (request.format == ImagesFormat::None)
        return Error{ErrorKind::BadInput, Message::say("it is neither DICOM nor TIFF. Let TAn choose the reader.")};
    Lattice lattice;
    std::string lengthUnit;
    request.given = givenPlacement(values);
    if (const Status understood = placeByUser(values, request.given, lattice, lengthUnit); !understood)
        return understood.error();
    return request;
}

/// Slices of which some are missing have positions, which follow the spacing and the origin that the user gives. Files
/// that leave these to the user are along the axes.
void movePositions(const Lattice& before, FileFindings& findings)
{
    const Lattice& after = findings.lattice;
    if (before.spacing == after.spacing && before.origin == after.origin)
        return;
    const Eigen::Vector3d scale = after.spacing.cwiseQuotient(before.spacing);
    for (Eigen::Vector3d& position : findings.positions)
        position = after.origin + (position - before.origin).cwiseProduct(scale);
}

fs::path besidePlugin()
{
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-images");
}

Result<ReadAnswer> ask(const fs::path& program, const ImagesRequest& request, const Progress& progress)
{
    return askReadingProgram(imagesReadingProgram(program, request.format), requestText(request), request.path,
                             progress);
}

} // namespace

ReadingProgram imagesReadingProgram(fs::path program, ImagesFormat format)
{
    return {
        .path = std::move(program),
        .library = format == ImagesFormat::Dicom ? "GDCM" : "libtiff",
        .notInstalled =
            Message::say("Install the package tan-vtk-readers, which comes with TAn: 'apt install "
                         "./tan-vtk-readers_*.deb' in the folder of that file (if you built TAn yourself: rebuild it "
                         "after 'apt install libgdcm-dev libtiff-dev'), or convert the file to NRRD."),
        .install = Message::say("Install GDCM and libtiff with 'apt install libgdcm3.0 libtiff6'."),
        .otherwise = Message::say("Export it again, or in another format (NRRD, NIfTI)."),
    };
}

ImagesReader::ImagesReader(fs::path program) : program_(program.empty() ? besidePlugin() : std::move(program)) {}

std::vector<std::string> ImagesReader::nameFilters() const
{
    return imagesNameFilters();
}

double ImagesReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double withoutProgram = 0.5; // to say what to install, unless another reader reads the file
    const ImagesGuess guess = guessImagesFormat(path, firstBytes);
    std::error_code ignored;
    return guess.score > 0 && !fs::exists(program_, ignored) ? guess.score * withoutProgram : guess.score;
}

std::vector<Parameter> ImagesReader::parameters() const
{
    return imagesParameters();
}

Result<Dataset> ImagesReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    constexpr double untilFound = 0.8; // of the time, roughly; the rest makes the dataset out of it
    const auto request = requestFor(path, values);
    if (!request)
        return request.error();
    auto answer = ask(program_, *request, progress.part(0, untilFound));
    if (!answer)
        return answer.error();
    auto& findings = std::get<FileFindings>(*answer);
    const Lattice found = findings.lattice;
    if (const Status placed = placeByUser(values, findings.untold, findings.lattice, findings.lengthUnit); !placed)
        return placed.error();
    movePositions(found, findings);
    std::ranges::move(remarkOnSpacing(values, findings.untold, findings.lattice), std::back_inserter(findings.remarks));
    const Source source{path.filename().string(), path};
    auto dataset = datasetOf(std::move(findings), source, std::nullopt, progress.part(untilFound, 1));
    if (!dataset)
        return dataset.error();
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> ImagesReader::probe(const fs::path& path, const ParameterValues& values,
                                         const Progress& progress) const
{
    auto request = requestFor(path, values);
    if (!request)
        return request.error();
    request->contentsOnly = true;
    auto answer = ask(program_, *request, progress);
    if (!answer)
        return answer.error();
    auto& contents = std::get<FileContents>(*answer);
    std::string lengthUnit;
    if (const Status placed = placeByUser(values, contents.untold, contents.lattice, lengthUnit); !placed)
        return placed.error();
    return std::move(contents);
}

} // namespace tetra
