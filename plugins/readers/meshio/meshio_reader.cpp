// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/meshio/meshio_reader.h"

#include "plugins/api/cells_parameters.h"
#include "plugins/api/placement_parameters.h"
#include "plugins/process/found_dataset.h"
#include "plugins/process/process_limits.h"
#include "plugins/process/reading_process.h"
#include "plugins/readers/meshio/meshio_texts.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace tetra {
namespace {

namespace fs = std::filesystem;

/// What tan-read-meshio.py is asked for: its class Request, member by member.
struct MeshioRequest {
    bool contentsOnly = false;
    std::string path{};
    std::string format{};
    std::string array{};
    std::string component{};                  ///< empty: the user does not say it, and the magnitude is taken
    std::int64_t timeStep = 0;                ///< from 1; 0: the user does not say it, and the first is taken
    ErrorKind badInput = ErrorKind::BadInput; ///< the numbers of the kinds of its errors
    ErrorKind wrongUsage = ErrorKind::WrongUsage;
    WorkLimits limits{};
};

template <class Archive> void exchange(Archive& archive, MeshioRequest& request)
{
    exchangeAll(archive, request.contentsOnly, request.path, request.format, request.array, request.component,
                request.timeStep, request.badInput, request.wrongUsage, request.limits.memory,
                request.limits.isHalfOfMachine, request.limits.seconds);
}

/// How a file of a format begins, behind blanks; for those of HDF5, which has no other sign, its name counts.
struct Signature {
    std::string_view format;
    std::string_view endings; ///< with a blank behind each
    std::string_view begins;  ///< empty: what the endings say
};

constexpr std::array<Signature, 8> signatures = {{
    {"gmsh", ".msh ", "$MeshFormat"},
    {"gmsh", ".msh ", "$Comments"},
    {"med", ".med ", "\x89HDF"},
    {"xdmf", ".xdmf .xmf ", "<"},
    {"nastran", ".bdf .nas .fem ", ""},
    {"abaqus", ".inp ", "*"},
    {"medit", ".mesh ", "MeshVersionFormatted"},
    {"medit", ".meshb ", ""},
}};

std::string lowered(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

ReadingProgram programOf(const fs::path& script)
{
    return {
        .path = "/usr/bin/python3",
        .library = "meshio",
        .notInstalled =
            Message::say("Install Python and meshio with 'apt install python3-meshio', or write the mesh as .vtu."),
        .install = Message::say("Install Python and meshio with 'apt install python3-meshio'."),
        .otherwise = Message::say("Export it again, as .vtu if the program can."),
        .environment = {"OMP_NUM_THREADS=1", "OPENBLAS_NUM_THREADS=1"}, // each thread of numpy takes memory
        .arguments = {"-I", script.string()},
    };
}

Result<MeshioRequest> requestFor(const fs::path& path, const std::vector<Parameter>& parameters,
                                 const ParameterValues& values)
{
    constexpr std::size_t looked = 4096;
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    const auto bytes = (*file)->bytes();
    if (bytes.empty())
        return Error{ErrorKind::BadInput, Message::say("it is empty. Get or make the file again.")};
    const auto first = bytes.first(std::min(looked, bytes.size()));
    MeshioRequest request;
    request.path = fs::absolute(path).string();
    request.format = meshioFormat(path, {reinterpret_cast<const char*>(first.data()), first.size()});
    if (request.format.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("its format is not one that TAn leaves to meshio. Let TAn choose the reader.")};
    request.array = parameterValue<std::string>(parameters, values, "array");
    if (values.contains("component"))
        request.component = parameterValue<std::string>(parameters, values, "component");
    if (values.contains("time"))
        request.timeStep = parameterValue<std::int64_t>(parameters, values, "time");
    request.limits = limitsFor(bytes.size(), bytes.size(), physicalBytes());
    return request;
}

Result<Dataset> readMesh(const fs::path& script, const std::optional<Eigen::AlignedBox3d>& region, const fs::path& path,
                         const std::vector<Parameter>& parameters, const ParameterValues& values,
                         const Progress& progress)
{
    constexpr double untilFound = 0.7; // of the time, roughly; the rest makes the dataset out of it
    const auto request = requestFor(path, parameters, values);
    if (!request)
        return request.error();
    auto answer =
        askReadingProgram(programOf(script), requestText(*request), request->path, progress.part(0, untilFound));
    if (!answer)
        return answer.error();
    auto& found = std::get<FileFindings>(*answer);
    const Source source{path.filename().string() + ", " + printable(found.arrayName), path, 0, found.arrayName};
    auto dataset = datasetOf(std::move(found), source, region, progress.part(untilFound, 1), values);
    if (dataset)
        dataset->lengthUnit = placementText(values, "unit");
    return dataset;
}

fs::path besidePlugin()
{
    return programBesidePlugin(reinterpret_cast<const void*>(&besidePlugin), "tan-read-meshio.py");
}

Parameter textParameter(const char* id, MarkedText label, MarkedText explanation, const char* byDefault)
{
    Parameter parameter;
    parameter.id = id;
    parameter.label = label;
    parameter.explanation = explanation;
    parameter.defaultValue = std::string(byDefault);
    return parameter;
}

} // namespace

std::string meshioFormat(const fs::path& path, std::string_view firstBytes)
{
    const std::string ending = lowered(path.extension().string()) + " ";
    const auto start = firstBytes.find_first_not_of(" \t\r\n");
    const std::string_view text = start == std::string_view::npos ? std::string_view() : firstBytes.substr(start);
    for (const Signature& one : signatures)
        if (ending.size() > 1 && one.endings.find(ending) != std::string_view::npos && text.starts_with(one.begins))
            return std::string(one.format);
    return {};
}

MeshioReader::MeshioReader(fs::path script) : script_(script.empty() ? besidePlugin() : std::move(script)) {}

std::vector<std::string> MeshioReader::nameFilters() const
{
    return {Message::marked("Gmsh mesh (*.msh)"),        Message::marked("MED mesh (*.med)"),
            Message::marked("XDMF mesh (*.xdmf *.xmf)"), Message::marked("Nastran mesh (*.bdf *.nas *.fem)"),
            Message::marked("Abaqus mesh (*.inp)"),      Message::marked("Medit mesh (*.mesh *.meshb)")};
}

double MeshioReader::score(const fs::path& path, std::span<const std::byte> firstBytes) const
{
    constexpr double suits = 0.8;
    return meshioFormat(path, {reinterpret_cast<const char*>(firstBytes.data()), firstBytes.size()}).empty() ? 0
                                                                                                             : suits;
}

std::vector<Parameter> MeshioReader::parameters() const
{
    Parameter time;
    time.id = "time";
    time.label = Message::marked("Time step");
    time.explanation = Message::marked("Files with several time steps: which one, from 1.");
    time.defaultValue = std::int64_t(1);
    time.minimum = 1;
    time.maximum = 1e9;
    std::vector<Parameter> all = {
        textParameter("array", Message::marked("Values"),
                      Message::marked("The values to take, by name or number; 'automatic' takes the first."),
                      "automatic"),
        textParameter("component", Message::marked("Component"),
                      Message::marked("Arrays with several components: the number of one, from 0, or 'magnitude'."),
                      "magnitude"),
        time, unitParameter()};
    std::ranges::move(cellsParameters(), std::back_inserter(all));
    return all;
}

Result<Dataset> MeshioReader::read(const fs::path& path, const ParameterValues& values, const Progress& progress) const
{
    return readMesh(script_, std::nullopt, path, parameters(), values, progress);
}

Result<Dataset> MeshioReader::readAround(const Eigen::AlignedBox3d& region, const fs::path& path,
                                         const ParameterValues& values, const Progress& progress) const
{
    return readMesh(script_, region, path, parameters(), values, progress);
}

Result<FileContents> MeshioReader::probe(const fs::path& path, const ParameterValues& values,
                                         const Progress& progress) const
{
    auto request = requestFor(path, parameters(), values);
    if (!request)
        return request.error();
    request->contentsOnly = true;
    auto answer = askReadingProgram(programOf(script_), requestText(*request), request->path, progress);
    if (!answer)
        return answer.error();
    return std::get<FileContents>(*std::move(answer));
}

} // namespace tetra
