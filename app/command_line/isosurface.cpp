// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/error_statistics.h"
#include "app/command_line/extracted_content.h"
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/queried_mesh.h"
#include "app/command_line/query_options.h"
#include "app/command_line/result_output.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/memory.h"
#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "core/history/error_meaning.h"
#include "core/history/value_statistics.h"
#include "core/picture/surface_making.h"
#include "core/verify/verify_mesh.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/output_check.h"

#include <tan/query.h>
#include <tan/render.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>

namespace tetra {
namespace {

/// Numbers of standard deviations count as such, until a model tells what they are (withValuesOfData()).
Result<std::vector<double>> isovaluesOf(const Arguments& arguments)
{
    std::vector<double> isovalues;
    for (const std::string& list : arguments.values("value")) {
        std::string_view rest = list;
        for (std::size_t end = 0; end != std::string_view::npos;) {
            end = rest.find(',');
            const std::string_view given = rest.substr(0, end);
            const auto deviations = parseDeviations(given);
            const auto value = deviations ? deviations : parseFieldValue(given);
            if (!value)
                return Error{ErrorKind::WrongUsage, "'" + std::string(given) +
                                                        "' does not fit '--value': it takes finite numbers, separated "
                                                        "by commas, standard deviations above the mean like 2.5sd, "
                                                        "and for a model of logarithms log10(V)."};
            isovalues.push_back(*value);
            rest.remove_prefix(std::min(rest.size(), end == std::string_view::npos ? end : end + 1));
        }
    }
    return isovalues;
}

/// Isovalues in standard deviations become those of the data, and the query that which they are part of.
Status toValuesOfData(const Invocation& invocation, const Model& model, std::vector<double>& isovalues,
                      MeshQuery& query, std::vector<Message>& told)
{
    const auto arguments =
        withValuesOfData(invocation.arguments, "value", model, invocation.progress.withCallback({}), told);
    if (!arguments)
        return arguments.error();
    const auto values = isovaluesOf(*arguments);
    if (!values)
        return values.error();
    isovalues = *values;
    auto asked = queryOf(*arguments, {.isovalues = isovalues});
    if (!asked)
        return asked.error();
    query = *std::move(asked);
    return {};
}

/// How often a tetrahedron is crossed by a surface, which makes one triangle there or two.
std::uint64_t crossingsOf(const TetrahedralMesh& mesh, std::vector<double> isovalues)
{
    std::ranges::sort(isovalues);
    const auto below = [&](float value) { return std::ranges::upper_bound(isovalues, value) - isovalues.begin(); };
    std::uint64_t crossings = 0;
    for (const auto& corners : mesh.tetrahedra) {
        const auto [least, most] = std::minmax(
            {mesh.values[corners[0]], mesh.values[corners[1]], mesh.values[corners[2]], mesh.values[corners[3]]});
        if (least < most)
            crossings += static_cast<std::uint64_t>(below(most) - below(least));
    }
    return crossings;
}

/// All surfaces are in memory until they are written. A long list of values is easily made by a script, and a system
/// without memory ends whichever program it likes.
Status checkMemoryForSurfaces(const TetrahedralMesh& mesh, const std::vector<double>& isovalues)
{
    constexpr std::uint64_t bytesPerCrossing = 43; // four thirds of a triangle, two thirds of a vertex
    const std::uint64_t bytes = crossingsOf(mesh, isovalues) * bytesPerCrossing;
    const std::uint64_t usable = usableBytes();
    if (usable == 0 || bytes <= usable / 2)
        return {};
    return Error{ErrorKind::OutOfResource,
                 "These isosurfaces, " + std::to_string(isovalues.size()) + " of them, would take about " +
                     neededBytesText(bytes) +
                     " of memory, more than half of what there is. Use fewer values, or a larger error."};
}

/// How the surfaces are made of a mesh, and what is asked about them.
struct SurfaceWishes {
    SurfaceMaking making;
    bool deviation = false;
};

/// Options that make a surface one for a printer, and tell how far it is from what the model has.
std::vector<Option> printingOptions()
{
    return {{.name = "close",
             .placeholder = "above|below",
             .explanation =
                 "Close the surfaces where they meet the boundary of the mesh, with the part of it that has values "
                 "above or below the isovalue: each is then the surface of a solid, watertight and without normals."},
            {.name = "largest-part",
             .placeholder = "",
             .explanation = "Only the part of each surface with the largest area; of a closed one its outer skin, so "
                            "hollows are filled."},
            {.name = "deviation",
             .placeholder = "",
             .explanation = "Also measure how far the surfaces are from those of the finest mesh of the model, made in "
                            "the same way: the largest and the mean distance, in both directions, in the unit of "
                            "length of the data. Takes as long as '--error 0'."}};
}

Result<SurfaceWishes> wishesOf(const Arguments& arguments, const MeshQuery& query)
{
    const auto wrong = [](std::string text) { return Error{ErrorKind::WrongUsage, std::move(text)}; };
    for (const char* option : {"close", "largest-part", "deviation"})
        if (arguments.has(option) && query.range)
            return wrong("'--range' gives many overlapping surfaces, so '--" + std::string(option) +
                         "' cannot be combined with it.");
    SurfaceWishes wishes{{.largestPart = arguments.has("largest-part")}, arguments.has("deviation")};
    if (const auto side = arguments.value("close")) {
        if (*side != "above" && *side != "below")
            return wrong("'--close " + *side + "': the solid is 'above' or 'below' the isovalue.");
        wishes.making.solid = *side == "above" ? SolidSide::Above : SolidSide::Below;
    }
    if (!wishes.deviation)
        return wishes;
    if (arguments.has("at-server"))
        return wrong("'--deviation' needs the model at hand, so '--at-server' cannot be combined with it.");
    if (!query.values.empty())
        return wrong("'--deviation' measures whole surfaces, so '--values' cannot be combined with it.");
    if (query.window && query.window->border != WindowBorder::Clipped)
        return wrong("'--deviation' needs surfaces that end at the same place: with '--window', give '--border "
                     "clipped'.");
    return wishes;
}

/// Isosurfaces, and of a range of accuracies the lives of the tetrahedra that their triangles lie in.
struct ValuedSurfaces {
    std::vector<MadeSurface> all;
    std::vector<float> births;
    std::vector<float> deaths;
};

Result<ValuedSurfaces> extractAll(const ExtractedMesh& extracted, const std::vector<double>& isovalues,
                                  const SurfaceMaking& making, const Progress& progress)
{
    const bool haveLives = !extracted.birthErrors.empty();
    Buffer<std::uint32_t> cells;
    auto made = makeSurfaces(extracted.mesh, isovalues, making, progress, haveLives ? &cells : nullptr);
    if (!made)
        return made.error();
    ValuedSurfaces surfaces{*std::move(made), {}, {}};
    for (const std::uint32_t cell : cells) {
        surfaces.births.push_back(extracted.birthErrors[cell]);
        surfaces.deaths.push_back(extracted.deathErrors[cell]);
    }
    return surfaces;
}

/// Of values that the data have and the mesh does not reach, or whose surface is no more than some of its vertices.
void tellLostSurfaces(std::span<const MadeSurface> surfaces, const Model& model, const TetrahedralMesh& mesh,
                      Outcome& outcome)
{
    const ValueRange& ofData = model.description().range;
    std::vector<Message> remarks;
    for (const MadeSurface& surface : surfaces) {
        if (surface.mesh.triangles.empty() && ofData.minimum <= surface.value && surface.value <= ofData.maximum) {
            const auto [least, most] = std::ranges::minmax(mesh.values);
            remarks.emplace_back("The surface of " + formatNumber(surface.value) +
                                 " is empty in this mesh, whose values lie between " + formatNumber(least) + " and " +
                                 formatNumber(most) + ".");
        }
        if (surface.hasNoCounterpart)
            remarks.push_back(missingDeviationText(surface));
    }
    addRemarks(remarks, outcome);
}

/// What a deviation from the finest mesh does not count.
void tellFinestError(const Model& model, Outcome& outcome)
{
    if (const double error = meshSizeAt(model, Accuracy{}).error; error > 0)
        addRemarks(std::vector<Message>{Message("The finest mesh of this model has " +
                                                std::string(textFor(errorsNames, errorMeaning(model.description()))) +
                                                " of up to " + rounded(error) +
                                                " % itself, which the deviation does not count.")},
                   outcome);
}

/// Points into the surfaces.
SurfaceContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                         const ValuedSurfaces& surfaces, const std::optional<double>& errorInSpace)
{
    SurfaceContent content{.title = "isosurfaces", .valueName = "isovalue", .parts = {}, .facts = {}};
    for (const MadeSurface& surface : surfaces.all) {
        const Colour colour = surfaceColour(content.parts.size());
        content.parts.push_back({.name = "isovalue " + formatNumber(surface.value),
                                 .positions = surface.mesh.positions,
                                 .normals = surface.mesh.normals,
                                 .triangles = surface.mesh.triangles,
                                 .values = static_cast<float>(surface.value),
                                 .colour = {colour.red, colour.green, colour.blue, 1}});
    }
    content.facts = meshFacts(model, query, mesh, errorInSpace);
    addDeviation(surfaces.all, content.facts);
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(surfaces.births)},
                              {"death_error", std::span<const float>(surfaces.deaths)}};
    return content;
}

JsonObject figuresOf(const SurfaceDistance& distance)
{
    return {{"largest", distance.largest}, {"mean", distance.mean}};
}

JsonObject figuresOf(const MadeSurface& surface)
{
    const SurfaceShape& shape = surface.shape;
    JsonObject figures{{"value", surface.value},
                       {"vertices", surface.mesh.positions.size()},
                       {"triangles", surface.mesh.triangles.size()},
                       {"parts", shape.parts},
                       {"openings", shape.openings},
                       {"open_edges", shape.openEdges},
                       {"crowded_edges", shape.crowdedEdges},
                       {"area", shape.area}};
    if (shape.isClosed())
        figures["volume"] = shape.volume;
    if (surface.deviation)
        figures["deviation"] = JsonObject{{"to_finest", figuresOf(surface.deviation->toFinest)},
                                          {"from_finest", figuresOf(surface.deviation->fromFinest)}};
    return figures;
}

} // namespace

Syntax isosurfaceSyntax(PluginHost& host)
{
    Syntax syntax{.purpose = "write isosurfaces of a model as a triangle mesh",
                  .explanation =
                      "Marching tetrahedra over a mesh that is extracted as by 'tan extract': closed except at the "
                      "boundary of the domain, or of the requested part of it, with shared vertices and smooth "
                      "normals. The file is VTK polydata (.vtp, .vtk), a VTK unstructured grid (.vtu), binary PLY "
                      "(.ply) or STL (.stl), Wavefront text (.obj) or binary glTF (.glb). Each vertex has a position, "
                      "a normal and the isovalue that it belongs to, where the format supports them.",
                  .positionals = {{"MODEL", modelExplanation()}},
                  .options = {{.name = "value",
                               .placeholder = "V[,V2...]",
                               .explanation = "The isovalues, in data units; 2.5sd is 2.5 standard deviations above "
                                              "the mean; for a model of logarithms (--scale log) the logarithms, or "
                                              "log10(V) with the values.",
                               .repeatable = true,
                               .required = true}},
                  .examples = {{"tan isosurface engine.tan --error 0.5 --value 100,180 -o engine.ply",
                                "Two surfaces in one file."},
                               {"tan isosurface engine.tan --value 100 --close above --largest-part --deviation -o "
                                "engine.stl",
                                "A solid for a 3D printer, and how accurate it is."},
                               {"tan isosurface engine.tan --value 100 --field 'isovalues(;0.2,4,30)' -o sharp.vtp",
                                "From a mesh that is fine near the surface."}}};
    for (auto options : {printingOptions(), queryOptions(), serverOptions()})
        std::ranges::move(options, std::back_inserter(syntax.options));
    std::ranges::move(resultOptions(host, WrittenContent::Surface), std::back_inserter(syntax.options));
    syntax.resultMayBeOutput = true;
    addPluginOptions(syntax, writerParameters(host, WrittenContent::Surface));
    return syntax;
}

Result<Outcome> runIsosurface(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const std::filesystem::path input = arguments.positionals[0];
    const auto output = resultDestination(arguments);
    if (!output)
        return output.error();
    auto isovalues = isovaluesOf(arguments);
    if (!isovalues)
        return isovalues.error();
    auto query = queryOf(arguments, {.isovalues = *isovalues});
    if (!query)
        return query.error();
    const auto wishes = wishesOf(arguments, *query);
    if (!wishes)
        return wishes.error();
    const auto values = pluginValues(arguments, writerParameters(invocation.host, WrittenContent::Surface));
    if (!values)
        return values.error();
    if (const Status writable = checkWritable(invocation.host, WrittenContent::Surface, output->path, *values);
        !writable)
        return writable.error();
    if (const Status safe = checkOutput(output->path, std::array{input}); output->stream < 0 && !safe)
        return safe.error();

    const auto start = std::chrono::steady_clock::now();
    const double opened = isAtHand(input) ? 0 : 0.2;
    const auto found = openInput(invocation, input, *query, invocation.progress.part(0, opened));
    if (!found)
        return found.error();
    const std::shared_ptr<const Model>& model = found->model;
    if (const Status warps = checkWarpingOption(arguments, *model); !warps)
        return warps.error();
    std::vector<Message> deviations;
    if (const Status known = toValuesOfData(invocation, *model, *isovalues, *query, deviations); !known)
        return known.error();
    if (const Status safe = checkMeshOutput(output->path, *model); output->stream < 0 && !safe)
        return safe.error();
    MeshExtractor extractor(model);
    const auto asked =
        confirmed(*model, extractor.extract(*query, invocation.progress.part(opened, 0.3)), invocation.progress);
    if (!asked)
        return asked.error();
    const ExtractedMesh& mesh = **asked;
    if (const Status some = checkNotEmpty(*query, *model, mesh.mesh); !some)
        return some.error();
    if (const Status fits = checkMemoryForSurfaces(mesh.mesh, *isovalues); !fits)
        return fits.error();
    const double extracted = wishes->deviation ? 0.5 : 0.8, measured = 0.9;
    auto surfaces = extractAll(mesh, *isovalues, wishes->making, invocation.progress.part(0.3, extracted));
    if (!surfaces)
        return surfaces.error();
    if (wishes->deviation)
        if (const Status held = measureDeviations(extractor, *query, wishes->making, surfaces->all,
                                                  invocation.progress.part(extracted, measured));
            !held)
            return held.error();
    const auto inSpace = measureInSpace(*model, *query, mesh, invocation.progress.withCallback({}));
    if (!inSpace)
        return inSpace.error();
    const std::optional<double> largest = *inSpace ? std::optional((*inSpace)->largest) : std::nullopt;
    const auto written = saveSurface(invocation.host, contentOf(*model, *query, mesh, *surfaces, largest), *output,
                                     *values, invocation.progress.part(wishes->deviation ? measured : extracted, 1));
    if (!written)
        return written.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::vector<double> empty;
    JsonArray each;
    std::string shapes;
    const bool logarithms = holdsLogarithms(model->description().parameters);
    for (const MadeSurface& surface : surfaces->all) {
        vertices += surface.mesh.positions.size();
        triangles += surface.mesh.triangles.size();
        if (surface.mesh.triangles.empty())
            empty.push_back(surface.value);
        else
            shapes += shapeText(surface, model->description().lengthUnit).text() + "\n";
        JsonObject ofSurface = figuresOf(surface);
        if (logarithms) {
            const double inData = std::pow(10.0, surface.value);
            ofSurface["value_in_data"] = inData;
            shapes += formatNumber(surface.value) + " is " + rounded(inData) + " in " +
                      visibleText(nameOfLogarithms(model->description().valueName)) + "\n";
        }
        each.push_back(ofSurface);
    }
    JsonObject figures = meshFigures(*model, *query, mesh);
    if (*inSpace)
        addErrorInSpace(figures, **inSpace);
    figures["file"] = nameInFigures(*output);
    figures["vertices"] = vertices;
    figures["triangles"] = triangles;
    figures["seconds"] = elapsed.count();
    if (!query->range)
        figures["surfaces"] = each;
    if (const std::string& unit = model->description().lengthUnit; !unit.empty())
        figures["unit"] = unit;
    Outcome outcome{.figures = figures,
                    .text = shownName(*output) + ": " + std::to_string(vertices) + " vertices, " +
                            std::to_string(triangles) + " triangles from " +
                            std::to_string(mesh.mesh.tetrahedra.size()) + " tetrahedra" + reachedText(figures) +
                            ", in " + rounded(elapsed.count(), 3) + " s\n" + (query->range ? "" : shapes) +
                            guaranteeText(figures)};
    addRemarks(deviations, outcome);
    tellEmptySurfaces(empty, model->description().range, outcome);
    tellLostSurfaces(surfaces->all, *model, mesh.mesh, outcome);
    if (wishes->deviation)
        tellFinestError(*model, outcome);
    addRemarks(*written, outcome);
    tellPart(*found, outcome);
    return outcome;
}

} // namespace tetra
