// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/vtk/vtk_reader.h"

#include "plugins/readers/vtk/helper_process.h"
#include "plugins/readers/vtk/vtk_dataset.h"
#include "plugins/readers/vtk/vtk_format.h"
#include "plugins/readers/vtk/vtk_parameters.h"

#include <array>
#include <fstream>
#include <new>
#include <stdexcept>

namespace tetra {
namespace {

namespace fs = std::filesystem;

Error inFile(const fs::path& path, const Error& error)
{
    if (error.kind == ErrorKind::Cancelled)
        return error;
    return {error.kind, "Cannot read '" + path.string() + "': " + error.text};
}

Result<VtkRequest> requestFor(const fs::path& path, const ParameterValues& values)
{
    std::array<std::byte, 4096> bytes{};
    std::ifstream file(path, std::ios::binary);
    file.read(reinterpret_cast<char*>(bytes.data()), bytes.size());
    if (file.gcount() == 0)
        return Error{ErrorKind::BadInput, "it is empty, or may not be read."};
    VtkRequest request = vtkRequest(values);
    request.format = guessVtkFormat(path, std::span(bytes).first(static_cast<std::size_t>(file.gcount()))).format;
    request.path = fs::absolute(path).string();
    if (request.format == VtkFormat::None)
        return Error{ErrorKind::BadInput, "it is of no format that VTK reads."};
    return request;
}

Result<Dataset> toDataset(VtkFindings findings, const fs::path& path, const Progress& progress)
{
    const Source source{path.filename().string() + ", " + findings.arrayName, path, 0};
    auto dataset = datasetOf(std::move(findings), source, progress);
    if (!dataset)
        return inFile(path, dataset.error());
    progress.report(1, "Reading");
    return dataset;
}

} // namespace

VtkReader::VtkReader(fs::path helper) : helper_(helper.empty() ? vtkHelperBesidePlugin() : std::move(helper)) {}

std::vector<std::string> VtkReader::nameFilters() const
{
    return vtkNameFilters();
}

double VtkReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    return guessVtkFormat(path, firstBytes).score;
}

std::vector<Parameter> VtkReader::parameters() const
{
    return vtkParameters();
}

Result<Dataset> VtkReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
try {
    constexpr double untilFound = 0.7; // of the time, roughly; the rest makes the dataset out of it
    const auto request = requestFor(path, values);
    if (!request)
        return inFile(path, request.error());
    auto answer = askVtkHelper(helper_, *request, progress.part(0, untilFound));
    if (!answer)
        return answer.error();
    return toDataset(std::get<VtkFindings>(std::move(*answer)), path, progress.part(untilFound, 1));
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to read the file. Close other programs."};
} catch (const std::length_error&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to read the file. Close other programs."};
}

Result<FileContents> VtkReader::probe(const fs::path& path, const ParameterValues& values,
                                      const Progress& progress) const
try {
    auto request = requestFor(path, values);
    if (!request)
        return inFile(path, request.error());
    request->contentsOnly = true;
    auto answer = askVtkHelper(helper_, *request, progress);
    if (!answer)
        return answer.error();
    return std::get<FileContents>(std::move(*answer));
} catch (const std::bad_alloc&) {
    return Error{ErrorKind::OutOfResource, "Not enough memory to look into the file. Close other programs."};
}

} // namespace tetra
