// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/annotation_options.h"
#include "app/command_line/camera_option.h"
#include "app/command_line/depth_file.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/png_file.h"
#include "app/command_line/queried_mesh.h"
#include "app/command_line/query_options.h"
#include "app/command_line/render_request.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/model/queries/mesh_extractor.h"
#include "core/model/queries/two_resolutions.h"
#include "plugins/host/field_extent.h"
#include "ui/annotations/field_name.h"

#include <QFile>

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>

namespace tetra {
namespace {

constexpr std::string_view defaultMode = "isosurface";

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Result<std::unique_ptr<RenderBackend>> makeBackend(const std::string& id)
{
    if (id == "gl" || id == "gl33")
        return makeGlBackend(id == "gl" ? GlLevel::Gl43 : GlLevel::Gl33);
    return makeCpuBackend();
}

std::vector<Parameter> rendererParameters(PluginHost& host)
{
    std::vector<Parameter> all;
    for (const auto& renderer : host.renderers())
        for (Parameter& parameter : renderer.plugin->parameters({}))
            all.push_back(std::move(parameter));
    return all;
}

/// What is drawn, and what there is to tell of how it was made.
struct PreparedScene {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    AnnotationContent annotations;
    QJsonObject figures;
    std::size_t tetrahedra = 0;
};

Result<Camera> cameraOf(const Arguments& arguments, const Eigen::AlignedBox3d& bounds, const PictureOptions& picture)
{
    const double aspectRatio = static_cast<double>(picture.width) / picture.height;
    const auto given = arguments.value("camera");
    return given ? cameraFor(*given, bounds, aspectRatio) : Result<Camera>(fitted(Camera(), bounds, aspectRatio));
}

/// With the defaults that fit the model where the arguments say nothing: the window's, whatever mesh is drawn.
ParameterValues completed(ParameterValues values, const Renderer& renderer, const Model& model)
{
    for (const Parameter& parameter : renderer.parameters(extentOf(model)))
        values.try_emplace(parameter.id, parameter.defaultValue);
    return values;
}

/// What is written over the picture: of the values that it is drawn with.
AnnotationContent annotationsFor(const Arguments& arguments, const ModelDescription& data,
                                 const std::vector<Parameter>& parameters, const ParameterValues& values,
                                 const Camera& camera)
{
    AnnotationContent content = annotationsOf(arguments);
    content.range = data.range;
    content.field = fieldName(data);
    content.camera = camera;
    for (const Parameter& parameter : parameters) {
        if (!matters(parameter, parameters, values))
            continue;
        const ParameterValue& value = values.at(parameter.id);
        if (const auto* transfer = std::get_if<TransferFunction>(&value))
            content.transfer = *transfer;
        if (const auto* isovalues = std::get_if<std::vector<Isovalue>>(&value))
            content.isovalues = *isovalues;
    }
    return content;
}

/// The mesh that was asked for, and with a renderer that blends a focus (R24) the one inside it.
struct ShownMeshes {
    std::shared_ptr<const ExtractedMesh> mesh;
    std::optional<FocusMesh> focus;

    std::size_t tetrahedra() const
    {
        return mesh->mesh.tetrahedra.size() + (focus ? focus->mesh->tetrahedra.size() : 0);
    }
};

Result<ShownMeshes> extractMeshes(const std::shared_ptr<const Model>& model, const MeshQuery& query, bool blendsFocus,
                                  const Progress& progress)
{
    MeshExtractor extractor(model);
    const auto two = blendsFocus ? twoResolutions(query) : std::nullopt;
    if (blendsFocus && !two)
        return Error{ErrorKind::WrongUsage, "This mode draws one mesh inside a focus and another outside: give "
                                            "'--focus', '--focus-error' and '--error', and no '--budget'."};
    const auto mesh = extractor.extract(two ? two->outside : query, progress.part(0, two ? 0.5 : 1));
    if (!mesh)
        return mesh.error();
    ShownMeshes shown{*mesh, {}};
    if (two) {
        const auto fine = extractor.extract(two->inside, progress.part(0.5, 1));
        if (!fine)
            return fine.error();
        shown.focus = FocusMesh{{*fine, &(*fine)->mesh}, two->region, two->border};
    }
    return shown;
}

Result<PreparedScene> prepareScene(const Invocation& invocation, const RenderRequest& request,
                                   const Provided<Renderer>& renderer)
{
    const auto start = Clock::now();
    const auto model = Model::open(request.input);
    if (!model)
        return model.error();
    const ModelDescription& data = (*model)->description();
    // What does not fit is told before the work begins.
    const auto values = pluginValues(invocation.arguments, renderer.plugin->parameters({data.range, data.bounds}));
    if (!values)
        return values.error();
    const auto camera = cameraOf(invocation.arguments, data.bounds, request.picture);
    if (!camera)
        return camera.error();
    const auto shown = confirmed(
        **model, extractMeshes(*model, request.query, renderer.plugin->blendsFocus(), invocation.progress.part(0, 0.3)),
        invocation.progress);
    if (!shown)
        return shown.error();
    const ExtractedMesh& found = *shown->mesh;
    if (const Status some = checkNotEmpty(invocation.arguments, **model, found.mesh); !some)
        return some.error();
    QJsonObject figures = figuresOf(**model, request.query, found);
    figures["extraction_seconds"] = secondsSince(start);

    const auto sceneStart = Clock::now();
    const std::shared_ptr<const TetrahedralMesh> mesh(shown->mesh, &found.mesh);
    const auto session = shown->focus ? renderer.plugin->openWithFocus(mesh, *shown->focus, data.bounds)
                                      : renderer.plugin->open(mesh, data.bounds);
    const ParameterValues look = completed(*values, *renderer.plugin, **model);
    const auto scene = session->prepare(look, *camera, invocation.progress.part(0.3, 0.6));
    if (!scene)
        return scene.error();
    figures["scene_seconds"] = secondsSince(sceneStart);
    figures["tetrahedra"] = static_cast<qint64>(shown->tetrahedra());
    if (shown->focus)
        figures["focus_tetrahedra"] = static_cast<qint64>(shown->focus->mesh->tetrahedra.size());
    return PreparedScene{*scene, *camera,
                         annotationsFor(invocation.arguments, data, renderer.plugin->parameters({}), look, *camera),
                         figures, shown->tetrahedra()};
}

std::size_t triangleCount(const Scene& scene)
{
    std::size_t count = 0;
    for (const Surface& surface : scene.surfaces)
        count += surface.mesh->triangles.size();
    return count;
}

void addStatistics(QJsonObject& figures, const RenderBackend& backend)
{
    const RenderStatistics statistics = backend.statistics();
    figures["cells_drawn"] = static_cast<qint64>(statistics.cells);
    figures["fragments"] = static_cast<qint64>(statistics.fragments);
    figures["broken_cycles"] = static_cast<qint64>(statistics.brokenCycles);
    figures["order_seconds"] = statistics.orderSeconds;
    figures["set_up_seconds"] = statistics.setUpSeconds;
    figures["fill_seconds"] = statistics.fillSeconds;
    figures["cells_on_card"] = statistics.cellsOnCard;
    figures["order_on_card"] = statistics.orderOnCard;
    figures["sent_bytes"] = static_cast<qint64>(statistics.sentBytes);
    if (const std::string note = backend.note(); !note.empty())
        figures["backend_note"] = QString::fromStdString(note);
}

/// "19752 triangles and a volume of 222642 tetrahedra".
std::string contentText(const Scene& scene, std::size_t tetrahedra)
{
    const std::string cells = std::to_string(tetrahedra) + " tetrahedra";
    const std::string triangles = std::to_string(triangleCount(scene)) + " triangles";
    if (!scene.volume)
        return triangles + " from " + cells;
    return (scene.surfaces.empty() ? "" : triangles + " and ") + std::string("a volume of ") + cells;
}

Status writeFiles(const RenderRequest& request, const Picture& picture, AnnotationContent annotations,
                  QJsonObject& figures)
{
    if (request.depth) {
        const auto scale = writeDepth(*request.depth, picture);
        if (!scale)
            return scale.error();
        figures["depth_file"] = QFile::decodeName(request.depth->c_str());
        figures["nearest"] = scale->nearest;
        figures["farthest"] = scale->farthest;
    }
    annotations.background = request.picture.background;
    return writePng(request.output, annotated(picture, annotations));
}

} // namespace

Syntax renderSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "draw a model into a PNG picture",
        .explanation =
            "Works without a display, with the processor alone or with OpenGL. What is drawn is a mesh as "
            "'tan extract' takes it from the model: of one accuracy, with a focus, of so many tetrahedra, or "
            "a part of it.",
        .positionals = {{"MODEL", "The model."}},
        .options = {{.name = "mode",
                     .placeholder = idChoices(host.renderers()),
                     .explanation = "What to show.",
                     .byDefault = std::string(defaultMode)}},
        .examples = {
            {"tan render engine.tan --error 0.5 --isovalue 100:silver:0.4 --isovalue 180:#ff8000 -o engine.png",
             "A translucent surface around a solid one."},
            {"tan render engine.tan --mode volume --transfer bones.json --shaded -o engine.png",
             "A volume through a transfer function of your own, with light."},
            {"tan render engine.tan --mode hybrid --isovalue 180:gold --clip 0,-1,0,-128 -o engine.png",
             "A surface in a volume, cut open at the plane y = 128."},
            {"tan render part.tan --isovalue 0.5:gold --boundary translucent -o part.png",
             "A surface within the walls of an irregular mesh."},
            {"tan render engine.tan --mode focus --error 4 --focus sphere:90,60,60,40 --focus-error 0.5 --falloff 10 "
             "-o engine.png",
             "A volume that is fine inside a ball and coarse outside, blended over a length of 10."},
            {"tan render engine.tan --mode volume --colour-bar --axes --title Engine -o engine.png",
             "With what the colours mean, the directions of the axes and a title."},
            {"tan render engine.tan --camera top --size 1920x1080 --background black -o engine.png", "From above."}}};
    addPluginOptions(syntax, rendererParameters(host));
    for (auto options : {pictureOptions(), annotationOptions(), fieldOptions(), partOptions()})
        std::ranges::move(options, std::back_inserter(syntax.options));
    return syntax;
}

Result<Outcome> runRender(const Invocation& invocation)
{
    const auto start = Clock::now();
    const Arguments& arguments = invocation.arguments;
    const auto request = renderRequestOf(arguments);
    if (!request)
        return request.error();
    const auto renderer = invocation.host.renderer(arguments.value("mode").value_or(std::string(defaultMode)));
    if (!renderer)
        return renderer.error();
    if (const Status known = checkPluginOptions(arguments, rendererParameters(invocation.host),
                                                renderer->plugin->parameters({}), "mode '" + renderer->id + "'");
        !known)
        return known.error();
    const auto backend = makeBackend(request->backend);
    if (!backend)
        return backend.error();
    std::optional<tbb::global_control> limit;
    if (request->picture.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request->picture.threads));

    const auto prepared = prepareScene(invocation, *request, *renderer);
    if (!prepared)
        return prepared.error();
    const auto pictureStart = Clock::now();
    const auto picture =
        (*backend)->render(*prepared->scene, prepared->camera, request->picture, invocation.progress.part(0.6, 1));
    if (!picture)
        return picture.error();
    QJsonObject figures = prepared->figures;
    figures["picture_seconds"] = secondsSince(pictureStart);
    addStatistics(figures, **backend);
    if (const Status written = writeFiles(*request, *picture, prepared->annotations, figures); !written)
        return written.error();

    const double seconds = secondsSince(start);
    figures["file"] = QFile::decodeName(request->output.c_str());
    figures["mode"] = QString::fromStdString(renderer->id);
    figures["width"] = picture->width;
    figures["height"] = picture->height;
    figures["triangles"] = static_cast<qint64>(triangleCount(*prepared->scene));
    figures["backend"] = QString::fromStdString(request->backend);
    figures["seconds"] = seconds;
    return Outcome{.figures = figures,
                   .text = request->output.string() + ": " + std::to_string(picture->width) + " x " +
                           std::to_string(picture->height) + " pixels, " +
                           contentText(*prepared->scene, prepared->tetrahedra) + ", in " + rounded(seconds, 3) +
                           " s\n"};
}

} // namespace tetra
