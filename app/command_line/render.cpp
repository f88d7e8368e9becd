// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/camera_option.h"
#include "app/command_line/model_mesh.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/png_file.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/number_text.h"
#include "core/graphics/render_backend.h"
#include "plugins/host/colour_text.h"
#include "plugins/host/output_check.h"

#include <QFile>

#include <array>
#include <chrono>

namespace tetra {
namespace {

constexpr std::string_view defaultMode = "isosurface";
constexpr std::string_view defaultBackend = "cpu";
constexpr std::string_view defaultSize = "1024x768";
constexpr int largestSide = 16384;

/// What is asked for, as far as it can be known without the model.
struct RenderRequest {
    std::filesystem::path input;
    std::filesystem::path output;
    Accuracy accuracy;
    PictureOptions picture;
    std::string backend;
};

Status parseSize(const std::string& text, PictureOptions& picture)
{
    const auto cross = text.find('x');
    if (cross != std::string::npos) {
        const auto width = parseNumber<int>(std::string_view(text).substr(0, cross));
        const auto height = parseNumber<int>(std::string_view(text).substr(cross + 1));
        if (width && height && *width > 0 && *height > 0 && *width <= largestSide && *height <= largestSide) {
            picture.width = *width;
            picture.height = *height;
            return {};
        }
    }
    return Error{ErrorKind::WrongUsage, "'" + text +
                                            "' does not fit '--size': it takes WIDTHxHEIGHT in pixels, each from "
                                            "1 to " +
                                            std::to_string(largestSide) + ", like " + std::string(defaultSize) + "."};
}

Status parseBackground(const std::string& text, PictureOptions& picture)
{
    if (text == "transparent") {
        picture.transparentBackground = true;
        return {};
    }
    const auto colour = parseColour(text);
    if (!colour)
        return colour.error();
    picture.background = *colour;
    return {};
}

Status checkOutputName(const RenderRequest& request)
{
    if (request.output.extension() != ".png")
        return Error{ErrorKind::WrongUsage,
                     "'" + request.output.string() +
                         "' does not end in .png, the one format in which pictures are written."};
    return checkOutput(request.output, std::array{request.input});
}

Result<RenderRequest> requestOf(const Arguments& arguments)
{
    RenderRequest request;
    request.input = arguments.positionals[0];
    request.output = *arguments.value("output");
    const auto accuracy = accuracyOption(arguments);
    if (!accuracy)
        return accuracy.error();
    request.accuracy = *accuracy;
    if (const Status size = parseSize(arguments.value("size").value_or(std::string(defaultSize)), request.picture);
        !size)
        return size.error();
    if (const Status colour = parseBackground(arguments.value("background").value_or("white"), request.picture);
        !colour)
        return colour.error();
    request.backend = arguments.value("backend").value_or(std::string(defaultBackend));
    if (request.backend != "cpu" && request.backend != "gl")
        return Error{ErrorKind::WrongUsage, "'" + request.backend + "' does not fit '--backend': it takes cpu or gl."};
    if (const Status named = checkOutputName(request); !named)
        return named.error();
    return request;
}

Result<std::unique_ptr<RenderBackend>> makeBackend(const std::string& id)
{
    if (id == "gl")
        return makeGlBackend();
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

struct PreparedScene {
    std::shared_ptr<const Scene> scene;
    Camera camera;
    MeshSize size;
};

Result<PreparedScene> prepareScene(const Invocation& invocation, const RenderRequest& request,
                                   const Provided<Renderer>& renderer)
{
    const auto shown = openModelMesh(request.input, request.accuracy, invocation.progress.part(0, 0.3));
    if (!shown)
        return shown.error();
    const ModelDescription& description = shown->model->description();
    const auto values =
        pluginValues(invocation.arguments, renderer.plugin->parameters({description.range, description.bounds}));
    if (!values)
        return values.error();
    const Eigen::AlignedBox3d bounds = description.bounds;
    const auto cameraText = invocation.arguments.value("camera");
    const auto camera = cameraText ? cameraFor(*cameraText, bounds) : Result<Camera>(fitted(Camera(), bounds));
    if (!camera)
        return camera.error();
    const auto session = renderer.plugin->open(shown->mesh, bounds);
    const auto scene = session->prepare(*values, *camera, invocation.progress.part(0.3, 0.6));
    if (!scene)
        return scene.error();
    return PreparedScene{*scene, *camera, shown->size};
}

std::size_t triangleCount(const Scene& scene)
{
    std::size_t count = 0;
    for (const Surface& surface : scene.surfaces)
        count += surface.mesh->triangles.size();
    return count;
}

} // namespace

Syntax renderSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "draw a model into a PNG picture",
        .explanation = "Works without a display, with the processor alone or with OpenGL.",
        .positionals = {{"MODEL", "The model."}},
        .options = {{.name = "mode",
                     .placeholder = idChoices(host.renderers()),
                     .explanation = "What to show.",
                     .byDefault = std::string(defaultMode)},
                    errorOption(),
                    warpingOption(),
                    {.name = "camera",
                     .placeholder = "VIEW or FILE",
                     .explanation = "A view (" + cameraNames() +
                                    "), or a JSON file with any of azimuth, elevation, fieldOfView (in degrees), "
                                    "perspective (true or false), target ([x, y, z]) and distance.",
                     .byDefault = "from the front, right and above"},
                    {.name = "size",
                     .placeholder = "WxH",
                     .explanation = "Of the picture, in pixels.",
                     .byDefault = std::string(defaultSize)},
                    {.name = "backend",
                     .placeholder = "cpu|gl",
                     .explanation = "Who draws: the processor, or OpenGL 3.3.",
                     .byDefault = std::string(defaultBackend)},
                    {.name = "background",
                     .placeholder = "COLOUR",
                     .explanation = "transparent, #rrggbb, or one of " + colourNames() + ".",
                     .byDefault = "white"},
                    outputOption("FILE.png", "The picture to write.")},
        .examples = {
            {"tan render engine.tan --error 0.5 --isovalue 100:silver:0.4 --isovalue 180:#ff8000 -o engine.png",
             "A translucent surface around a solid one."},
            {"tan render engine.tan --camera top --size 1920x1080 --background black -o engine.png", "From above."}}};
    addPluginOptions(syntax, rendererParameters(host));
    return syntax;
}

Result<Outcome> runRender(const Invocation& invocation)
{
    const auto start = std::chrono::steady_clock::now();
    const Arguments& arguments = invocation.arguments;
    const auto request = requestOf(arguments);
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

    const auto prepared = prepareScene(invocation, *request, *renderer);
    if (!prepared)
        return prepared.error();
    const auto picture =
        (*backend)->render(*prepared->scene, prepared->camera, request->picture, invocation.progress.part(0.6, 1));
    if (!picture)
        return picture.error();
    if (const Status written = writePng(request->output, *picture); !written)
        return written.error();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;

    const std::size_t triangles = triangleCount(*prepared->scene);
    return Outcome{.figures = {{"file", QFile::decodeName(request->output.c_str())},
                               {"width", picture->width},
                               {"height", picture->height},
                               {"sites", static_cast<qint64>(prepared->size.sites)},
                               {"tetrahedra", static_cast<qint64>(prepared->size.tetrahedra)},
                               {"triangles", static_cast<qint64>(triangles)},
                               {"backend", QString::fromStdString(request->backend)},
                               {"seconds", elapsed.count()}},
                   .text = request->output.string() + ": " + std::to_string(picture->width) + " x " +
                           std::to_string(picture->height) + " pixels, " + std::to_string(triangles) +
                           " triangles from " + std::to_string(prepared->size.tetrahedra) + " tetrahedra, in " +
                           rounded(elapsed.count(), 3) + " s\n"};
}

} // namespace tetra
