// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/error_statistics.h"
#include "app/command_line/extracted_content.h"
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/queried_mesh.h"
#include "app/command_line/query_options.h"
#include "app/command_line/result_output.h"
#include "app/command_line/server_mesh.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/history/error_meaning.h"
#include "core/picture/mesh_remarks.h"
#include "core/verify/verify_mesh.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/output_check.h"

#include <tan/query.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

namespace tetra {
namespace {

constexpr double extractionEnd = 0.6; ///< how far it is when the mesh is there
constexpr double measuringEnd = 0.9;  ///< and when it was compared with a dataset

/// What a run of the subcommand was told.
struct Task {
    const Invocation& invocation;
    const Arguments& arguments;
    const Destination& output;
    PluginHost& host;
    const ParameterValues& values; ///< of the writer
    const Model& model;
    const Progress& progress;
};

Outcome outcomeOf(const Destination& output, const TetrahedralMesh& mesh)
{
    return {.figures = {{"file", nameInFigures(output)},
                        {"sites", mesh.positions.size()},
                        {"tetrahedra", mesh.tetrahedra.size()}},
            .text = shownName(output) + ": " + std::to_string(mesh.positions.size()) + " vertices, " +
                    std::to_string(mesh.tetrahedra.size()) + " tetrahedra"};
}

/// What there is to tell of one mesh, by its figures.
void describeMesh(PluginHost& host, const Destination& output, Outcome& outcome)
{
    const auto figure = [&](const char* name) { return outcome.figures.numberAs<std::int64_t>(name).value_or(0); };
    if (figure("tetrahedra") != figure("kept_tetrahedra"))
        outcome.text += ", pieces of " + std::to_string(figure("kept_tetrahedra")) + " of the " +
                        std::to_string(figure("whole_tetrahedra")) + " of the whole mesh";
    else if (figure("kept_tetrahedra") != figure("whole_tetrahedra"))
        outcome.text += " of " + std::to_string(figure("whole_tetrahedra"));
    if (isSurfaceFileOnly(host, output.path))
        outcome.text += ", of which the file has the boundary";
    const bool isScaled = outcome.figures.numberAs<double>("scale").value_or(0) > 1;
    outcome.text += reachedText(outcome.figures);
    if (!outcome.figures.contains("reached_error") && isScaled)
        outcome.text += ", with " + errorsUpTo(outcome.figures.numberAs<double>("error").value_or(0), outcome.figures);
}

void addFigures(Outcome& outcome, const JsonObject& figures)
{
    for (const auto& [name, figure] : figures)
        outcome.figures[name] = figure;
}

Option againstOption()
{
    return {.name = "against",
            .placeholder = "IN",
            .explanation =
                "The dataset that the model was built from, opened in the same way: also measures the error of the "
                "mesh at every point of it, which takes about as long as 'tan verify' for one level."};
}

/// --against: what there is to measure of the mesh, compared with the dataset. Errors: also that the mesh is none of
/// it.
Result<ErrorStatistics> measured(const Task& task, const std::string& against, const MeshQuery& query,
                                 const ExtractedMesh& mesh)
{
    const auto options = importOptions(task.invocation, against, &task.model.description());
    if (!options)
        return options.error();
    const Progress progress = task.progress.part(extractionEnd, measuringEnd);
    const auto original = openDataset(task.host, against, *options, progress.part(0, 0.2));
    if (!original)
        return original.error();
    const auto verdict = verifyMesh(task.model, *original, query, mesh, progress.part(0.2, 1));
    if (!verdict)
        return verdict.error();
    if (!verdict->ok())
        return Error{ErrorKind::BadInput, "The mesh cannot be measured against '" + against +
                                              "': " + verdict->failures.front() + " Nothing was written."};
    return verdict->measured;
}

Error noBoundary()
{
    return {ErrorKind::WrongUsage, "'--range' gives tetrahedra that overlap, so they have no boundary to write. "
                                   "Write a .vtu or .vtk file."};
}

/// Before its time and its file's remarks are told.
struct Extraction {
    Outcome outcome;
    FileRemarks remarks;
};

Result<Extraction> extractMesh(const Task& task, const MeshQuery& query, std::shared_ptr<const Model> model)
{
    MeshExtractor extractor(std::move(model));
    const auto extracted =
        confirmed(task.model, extractor.extract(query, task.progress.part(0, extractionEnd)), task.progress);
    if (!extracted)
        return extracted.error();
    const ExtractedMesh& found = **extracted;
    if (const Status some = checkNotEmpty(query, task.model, found.mesh); !some)
        return some.error();
    if (found.overlaps && isSurfaceFileOnly(task.host, task.output.path))
        return noBoundary();
    std::optional<ErrorStatistics> statistics;
    std::optional<ErrorInSpace> inSpace;
    if (const auto against = task.arguments.value("against")) {
        const auto measurement = measured(task, *against, query, found);
        if (!measurement)
            return measurement.error();
        statistics = *measurement;
        if (errorMeaning(task.model.description()) != ErrorMeaning::Only)
            inSpace = statistics->errorInSpace;
    } else {
        const auto known = measureInSpace(task.model, query, found, task.progress.part(extractionEnd, measuringEnd));
        if (!known)
            return known.error();
        inSpace = *known;
    }
    const std::optional<double> largestInSpace = inSpace ? std::optional(inSpace->largest) : std::nullopt;
    const ExtractedContent file = contentOf(task.model, query, found, largestInSpace);
    const auto written =
        saveMesh(task.host, file.content, task.output, task.values, task.progress.part(measuringEnd, 1));
    if (!written)
        return written.error();
    Outcome outcome = outcomeOf(task.output, found.mesh);
    addFigures(outcome, meshFigures(task.model, query, found));
    const DomainClass domain = task.model.description().domain;
    if (statistics)
        addStatistics(outcome.figures, *statistics, domain);
    else if (inSpace)
        addErrorInSpace(outcome.figures, *inSpace);
    if (!query.range)
        describeMesh(task.host, task.output, outcome);
    if (statistics)
        outcome.text += "\n" + statisticsText({{"extracted", *statistics}}, domain);
    const ModelDescription& description = task.model.description();
    FileRemarks remarks =
        meshRemarks(description, query, found, statistics.has_value(), !isSurfaceFileOnly(task.host, task.output.path));
    std::ranges::copy(*written, std::back_inserter(remarks));
    return Extraction{std::move(outcome), std::move(remarks)};
}

/// --at-server: the mesh that a server finds.
Result<Extraction> extractAtServer(const Invocation& invocation, const MeshQuery& query, const Destination& output,
                                   const ParameterValues& values)
{
    const Arguments& arguments = invocation.arguments;
    if (arguments.has("against"))
        return Error{ErrorKind::WrongUsage,
                     "'--against' needs the model at hand, so '--at-server' cannot be combined with it."};
    const auto token = tokenOption(arguments, arguments.positionals[0]);
    if (!token)
        return token.error();
    const auto mesh = meshAtServer(arguments.positionals[0], queryWords(arguments), *token,
                                   invocation.progress.part(0, extractionEnd));
    if (!mesh)
        return mesh.error();
    const UnpackedMesh& found = mesh->content;
    if (mesh->overlaps && isSurfaceFileOnly(invocation.host, output.path))
        return noBoundary();
    if (const Status safe = checkMeshOutput(output.path, mesh->fact("source")); output.stream < 0 && !safe)
        return safe.error();
    MeshContent content;
    content.positions = found.mesh.positions;
    content.tetrahedra = found.mesh.tetrahedra;
    ValueArrays arrays = valueArrays(mesh->fact("array"), mesh->fact(scaleFact) == logarithmFact, found.mesh.values);
    content.pointArrays = std::move(arrays.arrays);
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(found.birthErrors)},
                              {"death_error", std::span<const float>(found.deathErrors)}};
    content.facts = mesh->facts;
    const auto written = saveMesh(invocation.host, content, output, values, invocation.progress.part(extractionEnd, 1));
    if (!written)
        return written.error();
    Outcome outcome = outcomeOf(output, found.mesh);
    addFigures(outcome, mesh->figures);
    if (!query.range)
        describeMesh(invocation.host, output, outcome);
    FileRemarks remarks = *written;
    if (!query.budget && !query.range && mesh->figures.numberAs<double>("scale").value_or(1) > 1)
        remarks.push_back(nothingFinerRemark());
    const bool isGrid = !mesh->fact("error_kind").empty();
    if (!isGrid && mesh->figures.numberAs<double>("reached_warping").value_or(0) > 0)
        remarks.push_back(movedBoundaryRemark());
    if (mesh->fact(scaleFact) == logarithmFact && !isSurfaceFileOnly(invocation.host, output.path))
        remarks.push_back(logarithmsRemark(mesh->fact("array")));
    return Extraction{std::move(outcome), std::move(remarks)};
}

/// How long it took, in figures and text, and what is to be known of the file.
Outcome outcomeOf(Extraction extraction, std::chrono::steady_clock::time_point start)
{
    Outcome& outcome = extraction.outcome;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    outcome.figures["seconds"] = elapsed.count();
    outcome.text.insert(std::min(outcome.text.find('\n'), outcome.text.size()),
                        ", in " + rounded(elapsed.count(), 3) + " s\n");
    outcome.text += guaranteeText(outcome.figures);
    addRemarks(extraction.remarks, outcome);
    return outcome;
}

} // namespace

Syntax extractSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "write a mesh of a model",
        .explanation = "The smallest mesh of the requested accuracy: the same error everywhere, or a smaller one in a "
                       "focus or near certain values, without cracks; or the best mesh with a given number of "
                       "tetrahedra; or a part of it. The file is a VTK XML unstructured grid (.vtu) or a legacy one "
                       "(.vtk), with the values of the vertices, named as in the data; or the boundary of the mesh "
                       "alone, as triangles: VTK polydata (.vtp), binary PLY (.ply), STL (.stl), Wavefront text (.obj) "
                       "or binary glTF (.glb). Isosurfaces are written by 'tan isosurface'.",
        .positionals = {{"MODEL", modelExplanation()}},
        .options = queryOptions(),
        .examples = {{"tan extract engine.tan --error 0.5 -o engine.vtu", "The mesh of an accuracy."},
                     {"tan extract engine.tan --error 4 --focus sphere:120,100,60,30 --focus-error 0.5 -o detail.vtu",
                      "Fine in a sphere, coarse elsewhere, conforming."},
                     {"tan extract engine.tan --budget 300000 -o engine.vtk", "As good as 300,000 tetrahedra allow."},
                     {"tan extract engine.tan --error 1 -o - --format vtu", "Into a pipe, to another program."},
                     {"tan extract engine.tan --budget 300000 --against engine.nrrd -o engine.vtk",
                      "Also reports how accurate it is overall."}}};
    syntax.options.push_back(againstOption());
    std::ranges::move(serverOptions(), std::back_inserter(syntax.options));
    std::ranges::move(resultOptions(host, WrittenContent::Mesh), std::back_inserter(syntax.options));
    syntax.resultMayBeOutput = true;
    addPluginOptions(syntax, writerParameters(host, WrittenContent::Mesh));
    return syntax;
}

Result<Outcome> runExtract(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const std::filesystem::path input = arguments.positionals[0];
    const auto output = resultDestination(arguments);
    if (!output)
        return output.error();
    const auto query = queryOf(arguments);
    if (!query)
        return query.error();
    if (arguments.has("against") && (query->window || query->range || !query->values.empty()))
        return Error{ErrorKind::WrongUsage, "'--against' measures one mesh of the whole domain, so '--window', "
                                            "'--values' and '--range' cannot be combined with it."};
    const auto values = pluginValues(arguments, writerParameters(invocation.host, WrittenContent::Mesh));
    if (!values)
        return values.error();
    if (const Status writable = checkWritable(invocation.host, WrittenContent::Mesh, output->path, *values); !writable)
        return writable.error();
    if (const Status safe = checkOutput(output->path, std::array{input}); output->stream < 0 && !safe)
        return safe.error();

    const auto start = std::chrono::steady_clock::now();
    if (arguments.has("at-server")) {
        auto extraction = extractAtServer(invocation, *query, *output, *values);
        if (!extraction)
            return extraction.error();
        return outcomeOf(*std::move(extraction), start);
    }
    const double opened = isAtHand(input) ? 0 : 0.5;
    const auto found = openInput(invocation, input, *query, invocation.progress.part(0, opened));
    if (!found)
        return found.error();
    const std::shared_ptr<const Model>& model = found->model;
    if (const Status warps = checkWarpingOption(arguments, *model); !warps)
        return warps.error();
    if (const Status safe = checkMeshOutput(output->path, *model); output->stream < 0 && !safe)
        return safe.error();
    const Progress progress = invocation.progress.part(opened, 1);
    const Task task{invocation, arguments, *output, invocation.host, *values, *model, progress};
    auto extraction = extractMesh(task, *query, model);
    if (!extraction)
        return extraction.error();
    Outcome outcome = outcomeOf(*std::move(extraction), start);
    tellPart(*found, outcome);
    return outcome;
}

} // namespace tetra
