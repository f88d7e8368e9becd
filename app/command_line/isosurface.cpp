// SPDX-License-Identifier: GPL-3.0-or-later
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
#include "plugins/host/file_saving.h"
#include "plugins/host/output_check.h"

#include <tan/query.h>
#include <tan/render.h>

#include <QFile>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <memory>

namespace tetra {
namespace {

Result<std::vector<double>> isovaluesOf(const Arguments& arguments)
{
    std::vector<double> isovalues;
    for (const std::string& list : arguments.values("value")) {
        constexpr double most = std::numeric_limits<double>::max();
        const auto some = parseNumbers("value", list, -most, most);
        if (!some)
            return some.error();
        isovalues.insert(isovalues.end(), some->begin(), some->end());
    }
    return isovalues;
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
                     " of memory, more than half of what there is. Ask for fewer values, or a larger error."};
}

/// The surface where the field has one value.
struct ValuedSurface {
    double value = 0;
    TriangleMesh mesh;
};

/// Isosurfaces, and of a range of accuracies the lives of the tetrahedra that their triangles lie in.
struct ValuedSurfaces {
    std::vector<ValuedSurface> all;
    std::vector<float> births;
    std::vector<float> deaths;
};

Result<ValuedSurfaces> extractAll(const ExtractedMesh& extracted, const std::vector<double>& isovalues,
                                  const Progress& progress)
{
    const TetrahedralMesh& mesh = extracted.mesh;
    const bool haveLives = !extracted.birthErrors.empty();
    const auto gradients = vertexGradients(mesh);
    ValuedSurfaces surfaces;
    for (std::size_t index = 0; index < isovalues.size(); ++index) {
        const double share = 1.0 / static_cast<double>(isovalues.size());
        const double begin = share * static_cast<double>(index);
        Buffer<std::uint32_t> cells;
        auto surface = extractIsosurface(mesh, gradients, isovalues[index], progress.part(begin, begin + share),
                                         haveLives ? &cells : nullptr);
        if (!surface)
            return surface.error();
        surfaces.all.push_back({isovalues[index], *std::move(surface)});
        for (const std::uint32_t cell : cells) {
            surfaces.births.push_back(extracted.birthErrors[cell]);
            surfaces.deaths.push_back(extracted.deathErrors[cell]);
        }
    }
    return surfaces;
}

/// Points into the surfaces.
SurfaceContent contentOf(const Model& model, const MeshQuery& query, const ExtractedMesh& mesh,
                         const ValuedSurfaces& surfaces)
{
    SurfaceContent content{.title = "isosurfaces", .valueName = "isovalue", .parts = {}, .facts = {}};
    for (const ValuedSurface& surface : surfaces.all) {
        const Colour colour = distinctColour(content.parts.size());
        content.parts.push_back({.name = "isovalue " + formatNumber(surface.value),
                                 .positions = surface.mesh.positions,
                                 .normals = surface.mesh.normals,
                                 .triangles = surface.mesh.triangles,
                                 .values = static_cast<float>(surface.value),
                                 .colour = {colour.red, colour.green, colour.blue, 1}});
    }
    content.facts = meshFacts(model, query, mesh);
    if (query.range)
        content.cellArrays = {{"birth_error", std::span<const float>(surfaces.births)},
                              {"death_error", std::span<const float>(surfaces.deaths)}};
    return content;
}

} // namespace

Syntax isosurfaceSyntax(PluginHost& host)
{
    Syntax syntax{.purpose = "write isosurfaces of a model as a triangle mesh",
                  .explanation =
                      "Marching tetrahedra over a mesh as 'tan extract' takes it from the model: closed but for the "
                      "boundary of the domain, or of the part of it that is asked for, with shared vertices and smooth "
                      "normals. The file is VTK polydata (.vtp, .vtk), a VTK "
                      "unstructured grid (.vtu), binary PLY (.ply) or STL (.stl), Wavefront text (.obj) or binary glTF "
                      "(.glb). Each vertex has a position, a normal and the isovalue that it belongs to, as far as the "
                      "format can hold them.",
                  .positionals = {{"MODEL", modelExplanation()}},
                  .options = {{.name = "value",
                               .placeholder = "V[,V2...]",
                               .explanation = "The isovalues, in units of the data.",
                               .repeatable = true,
                               .required = true}},
                  .examples = {{"tan isosurface engine.tan --error 0.5 --value 100,180 -o engine.ply",
                                "Two surfaces in one file."},
                               {"tan isosurface engine.tan --value 100 -o engine.stl", "A surface for a 3D printer."},
                               {"tan isosurface engine.tan --value 100 --field 'isovalues(;0.2,4,30)' -o sharp.vtp",
                                "From a mesh that is fine near the surface."}}};
    for (auto options : {queryOptions(), serverOptions()})
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
    const auto isovalues = isovaluesOf(arguments);
    if (!isovalues)
        return isovalues.error();
    const auto query = queryOf(arguments, {.isovalues = *isovalues});
    if (!query)
        return query.error();
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
    if (const Status safe = checkMeshOutput(output->path, *model); output->stream < 0 && !safe)
        return safe.error();
    MeshExtractor extractor(model);
    const auto extracted =
        confirmed(*model, extractor.extract(*query, invocation.progress.part(opened, 0.3)), invocation.progress);
    if (!extracted)
        return extracted.error();
    const ExtractedMesh& mesh = **extracted;
    if (const Status some = checkNotEmpty(*query, *model, mesh.mesh); !some)
        return some.error();
    if (const Status fits = checkMemoryForSurfaces(mesh.mesh, *isovalues); !fits)
        return fits.error();
    const auto surfaces = extractAll(mesh, *isovalues, invocation.progress.part(0.3, 0.8));
    if (!surfaces)
        return surfaces.error();
    const auto written = saveSurface(invocation.host, contentOf(*model, *query, mesh, *surfaces), *output, *values,
                                     invocation.progress.part(0.8, 1));
    if (!written)
        return written.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    std::size_t vertices = 0;
    std::size_t triangles = 0;
    for (const ValuedSurface& surface : surfaces->all) {
        vertices += surface.mesh.positions.size();
        triangles += surface.mesh.triangles.size();
    }
    QJsonObject figures = figuresOf(*model, *query, mesh);
    figures["file"] = QFile::decodeName(nameInFigures(*output).c_str());
    figures["vertices"] = static_cast<qint64>(vertices);
    figures["triangles"] = static_cast<qint64>(triangles);
    figures["seconds"] = elapsed.count();
    Outcome outcome{.figures = figures,
                    .text = shownName(*output) + ": " + std::to_string(vertices) + " vertices, " +
                            std::to_string(triangles) + " triangles from " +
                            std::to_string(mesh.mesh.tetrahedra.size()) + " tetrahedra" + reachedText(figures) +
                            ", in " + rounded(elapsed.count(), 3) + " s\n"};
    tellEmptySurfaces(*isovalues, model->description().range, outcome);
    addRemarks(*written, outcome);
    tellPart(*found, outcome);
    return outcome;
}

} // namespace tetra
