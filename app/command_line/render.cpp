// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/annotation_options.h"
#include "app/command_line/camera_option.h"
#include "app/command_line/depth_file.h"
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/queried_mesh.h"
#include "app/command_line/query_options.h"
#include "app/command_line/render_request.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/picture/kept_tools.h"
#include "core/picture/mesh_saving.h"
#include "core/picture/rendering_modes.h"
#include "core/picture/restored_view.h"
#include "core/picture/session_document.h"
#include "core/picture/session_model.h"
#include "core/picture/shown_error.h"
#include "core/picture/view_picture.h"
#include "core/view/appearance.h"
#include "core/view/view_value.h"
#include "plugins/api/boundary_parameters.h"
#include "plugins/api/scene_parameters.h"
#include "plugins/host/file_saving.h"
#include "plugins/host/output_check.h"
#include "plugins/host/parameter_values.h"

#include <tan/query.h>

#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace tetra {
namespace {

constexpr std::string_view defaultMode = "isosurface";
constexpr std::string_view sliceMode = "slice";
// How far all is when the model is open, if it was packed or far away, and when its scene is made.
constexpr double openingEnd = 0.4;
constexpr double sceneEnd = 0.6;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

Result<std::unique_ptr<RenderBackend>> makeBackend(const std::string& id)
{
    if (id == "gl")
        return makeGlBackend();
    return makeCpuBackend();
}

constexpr std::string_view isovalueOption = "isovalue"; ///< of isovaluesId

/// What the options ask to show: planes show themselves.
std::string modeOf(const Arguments& arguments)
{
    return arguments.value("mode").value_or(std::string(arguments.has("slice") ? sliceMode : defaultMode));
}

std::vector<Parameter> rendererParameters(PluginHost& host, const FieldExtent& field = {})
{
    std::vector<Parameter> all;
    for (const auto& renderer : host.renderers())
        for (Parameter& parameter : renderer.plugin->parameters(field))
            all.push_back(std::move(parameter));
    return all;
}

/// A model and how it is to be seen, by the options or by a session.
struct ModelView {
    FoundModel found{};
    double opened = 0; ///< how far all is by then
    std::shared_ptr<const Model> model{};
    Provided<Renderer> renderer{};
    SceneRequest scene{};
    ViewPicture picture{}; ///< all but the scene
    LensState lens{};
    FieldExtent field{};
    bool isOfSession = false;
    std::vector<SessionDifference> differences{}; ///< from the session
    std::vector<Message> remarks{};               ///< on files that the options name
};

/// What is drawn, and what there is to tell of how it was made.
struct PreparedScene {
    FoundModel found;
    ViewPicture picture;
    JsonObject figures;
    std::size_t tetrahedra = 0;
    SceneRequest request;
    BuiltScene built; ///< of the request
    LensState lens;
    std::vector<Message> remarks;
};

double aspectRatioOf(const PictureOptions& picture)
{
    return static_cast<double>(picture.width) / picture.height;
}

/// The camera that is asked for, or else `usual`.
Result<Camera> cameraOf(const Arguments& arguments, const Camera& usual, const Framing& framing,
                        const Eigen::AlignedBox3d& bounds, const PictureOptions& picture)
{
    const auto given = arguments.value("camera");
    return given ? cameraFor(*given, framing, bounds, aspectRatioOf(picture)) : Result<Camera>(usual);
}

/// The values by which the renderer makes its scene: what the options leave open is as the window shows it at first.
ParameterValues completed(const ParameterValues& given, const std::vector<Parameter>& parameters,
                          const ViewValue& start)
{
    ParameterValues values =
        rendererValues(parameters, {start.appearance.mode, start.appearance.transfer, {}}, start.isovalues);
    for (const auto& [id, value] : given)
        values[id] = value;
    return values;
}

/// What of a view these values are.
ViewValue viewOf(const ParameterValues& values)
{
    ViewValue view;
    view.appearance.settings = values;
    if (const auto found = values.find(transferId); found != values.end())
        if (const auto* transfer = std::get_if<TransferFunction>(&found->second))
            view.appearance.transfer = *transfer;
    if (const auto found = values.find(isovaluesId); found != values.end())
        if (const auto* isovalues = std::get_if<std::vector<Isovalue>>(&found->second))
            view.isovalues = *isovalues;
    return view;
}

std::vector<double> isovaluesIn(const ParameterValues& values)
{
    std::vector<double> all;
    for (const Isovalue& isovalue : viewOf(values).isovalues)
        all.push_back(isovalue.value);
    return all;
}

/// What fields can be taken from.
PresentView presentView(const Camera& camera, const ParameterValues& values)
{
    ViewValue view = viewOf(values);
    view.camera = camera;
    return presentView(view);
}

AnnotationContent contentOf(const Model& model, const std::vector<Parameter>& parameters, const ParameterValues& values,
                            const ShownMesh& mesh)
{
    return annotationContent(model, matteringParameters(parameters, values), viewOf(values), accuracyText(mesh), {});
}

/// Options that this mode would not look at, as the others are.
Status checkAppearance(const Arguments& arguments, const Model& model, const Provided<Renderer>& renderer,
                       const ParameterValues& values)
{
    if (const Status warps = checkWarpingOption(arguments, model); !warps)
        return warps;
    const std::vector<Parameter> parameters = renderer.plugin->parameters({});
    if (const Status used = checkOfUse(parameters, values, optionNames(arguments)); !used)
        return used;
    if (arguments.has(shownId) && !roughExtentOf(model).hasSamples)
        return Error{ErrorKind::WrongUsage,
                     "Only the samples of a lattice can be shown beside the mesh, and these data are " +
                         std::string(domainClassText(model.description().domain).text) +
                         ". Leave '--show' out, or give the model of a lattice."};
    const bool hasColours = std::ranges::any_of(matteringParameters(parameters, values), [](const Parameter& one) {
        return std::holds_alternative<TransferFunction>(one.defaultValue) ||
               std::holds_alternative<std::vector<Isovalue>>(one.defaultValue);
    });
    if (arguments.has("colour-bar") && !hasColours)
        return Error{ErrorKind::WrongUsage, "The mode '" + renderer.id +
                                                "' draws nothing that '--colour-bar' could explain: no transfer "
                                                "function and no isosurfaces. Leave it out."};
    return {};
}

/// What the model is read for: the lens may ask for more than the picture.
MeshQuery finestQuery(const RenderRequest& request)
{
    MeshQuery query = request.query;
    if (!request.lens.isOn() || query.range)
        return query;
    const bool warpsAlike = query.warping == query.error;
    query.error = smallerOf(query.error, request.lens.error);
    if (warpsAlike)
        query.warping = query.error;
    return query;
}

/// What fills the picture if no camera is given: what there is to see of the data; a window alone, unless the outline
/// of the domain is drawn around it. `field` outlives it.
Framing framingOf(const FieldExtent& field, const Renderer& renderer, const MeshQuery& query,
                  const ParameterValues& given, const AnnotationState& annotations, double aspectRatio)
{
    const bool hasOutline = parameterValue<bool>(renderer.parameters(field), given, outlineId);
    const auto object =
        query.window ? std::span<const Eigen::Vector3d>() : framedObject(field, &renderer, viewOf(given));
    Eigen::AlignedBox3d part = field.bounds;
    if (query.window && !hasOutline)
        part = part.intersection({query.window->box.least, query.window->box.largest});
    if (part.isEmpty())
        part = field.bounds;
    return [=](const Camera& camera) {
        return framed({.annotations = annotations, .camera = camera}, part, object, aspectRatio);
    };
}

/// Whether values on the boundary are asked for, and neither a mode nor isovalues.
bool wantsBoundaryAlone(const Arguments& arguments, const ParameterValues& given)
{
    const auto boundary = given.find(boundaryId);
    return boundary != given.end() && boundary->second == ParameterValue(std::string(boundaryValues)) &&
           !arguments.has("mode") && !given.contains(isovaluesId);
}

Result<ModelView> viewByOptions(const Invocation& invocation, const RenderRequest& request,
                                const Provided<Renderer>& renderer)
{
    ModelView view{.opened = isAtHand(request.input) ? 0 : openingEnd, .renderer = renderer};
    const bool faulty = invocation.arguments.has("faulty-cells");
    // The beginning of a packed model does not list them.
    const MeshQuery needed =
        faulty && !isAddress(request.input.string()) ? MeshQuery{.error = 0.0, .warping = 0.0} : finestQuery(request);
    const auto found = openInput(invocation, request.input, needed, invocation.progress.part(0, view.opened));
    if (!found)
        return found.error();
    view.found = *found;
    view.model = found->model;
    const ModelDescription& data = view.model->description();
    const auto withValues = withValuesOfData(invocation.arguments, isovalueOption, *view.model,
                                             invocation.progress.withCallback({}), view.remarks);
    if (!withValues)
        return withValues.error();
    const Arguments& arguments = *withValues;
    // What does not fit is told before the work begins.
    std::vector<Parameter> parameters = renderer.plugin->parameters(roughExtentOf(*view.model));
    for (Parameter& parameter : parameters)
        if (parameter.id == isovaluesId) // one that these data do not have gives an empty surface
            parameter.minimum = parameter.maximum = 0;
    auto values = pluginValues(arguments, parameters, data.range);
    if (!values)
        return values.error();
    if (const Status used = checkAppearance(arguments, *view.model, renderer, *values); !used)
        return used.error();
    if (request.query.range && arguments.has(boundaryId))
        return Error{ErrorKind::WrongUsage, "'--range' gives tetrahedra that overlap, so they have no boundary for "
                                            "'--boundary'. Leave one of the two out."};
    if (faulty && faultyCellCount(*view.model) == 0)
        return Error{ErrorKind::WrongUsage,
                     "The model lists no faulty cells for '--faulty-cells' to outline: its data have none, or an "
                     "earlier version of TAn built it. Leave it out, or build the model again."};
    if (renderer.plugin->needs().focusMesh && !twoResolutions(request.query))
        return Error{ErrorKind::WrongUsage, "This mode draws one mesh inside a focus and another outside: give "
                                            "'--focus', '--focus-error' and '--error', and no '--budget'."};
    const auto annotations = annotationsOf(arguments);
    if (!annotations)
        return annotations.error();
    const auto field = extentOf(view.model);
    if (!field)
        return field.error();
    if (values->contains(fullGradientId)) // it is of light that there must be
        values->try_emplace(shadedId, true);
    const Framing framing =
        framingOf(*field, *renderer.plugin, request.query, *values, *annotations, aspectRatioOf(request.picture));
    const auto camera = cameraOf(arguments, framing(usualCamera(data)), framing, data.bounds, request.picture);
    if (!camera)
        return camera.error();
    const auto modes = renderingModes(invocation.host);
    ViewValue start = startingView(modes, *view.model, *field);
    if (wantsBoundaryAlone(arguments, *values))
        start.isovalues.clear();
    // How large the error is may depend on what is shown, and the opacities to begin with depend on the error.
    const auto asked =
        queryOf(arguments, presentView(*camera, completed(*values, renderer.plugin->parameters(*field), start)));
    if (!asked)
        return asked.error();
    view.field = seenWith(*field, *asked, *view.model);
    start.appearance.transfer = startingAppearance(modes, view.field, data.domain).transfer;
    if (arguments.has(std::string(transferId))) {
        // A file of colours alone takes the opacities that the window shows at first; which they are, the mesh tells.
        std::erase_if(parameters, [](const Parameter& one) { return one.id != transferId; });
        for (Parameter& parameter : parameters)
            parameter.defaultValue = start.appearance.transfer;
        const auto completing = pluginValues(arguments, parameters, data.range, &view.remarks);
        if (!completing)
            return completing.error();
        for (const auto& [id, value] : *completing)
            (*values)[id] = value;
    }
    ParameterValues shown = completed(*values, renderer.plugin->parameters(view.field), start);
    const auto query = queryOf(arguments, presentView(*camera, shown));
    if (!query)
        return query.error();
    view.scene = {
        view.model, renderer.plugin, *query, std::move(shown), *camera, request.picture.width, request.picture.height};
    view.scene.faultyCells = faulty;
    view.lens = request.lens;
    view.picture.annotations.state = *annotations;
    view.picture.annotations.camera = *camera;
    const bool isDark = !arguments.has("background") && hasDarkGround(*renderer.plugin, *values);
    view.picture.annotations.background = isDark ? usualBackground(true) : request.picture.background;
    return view;
}

/// All else is what a session says.
Status checkBesideSession(const Arguments& arguments, const std::filesystem::path& session)
{
    constexpr std::array<std::string_view, 15> ofPictures{"camera",  "size",    "dpi",    "samples",    "background",
                                                          "backend", "threads", "depth",  "surfaces",   "output",
                                                          "json",    "model",   "strict", "token-file", "bookmark"};
    for (const auto& [name, value] : arguments.options)
        if (std::ranges::find(ofPictures, name) == ofPictures.end())
            return Error{ErrorKind::WrongUsage, "'--" + name + "' cannot be combined with '" + session.string() +
                                                    "', which determines how its model is shown. Leave it out, or give "
                                                    "the model instead of the session."};
    return {};
}

/// What says something of sessions alone.
Status checkWithoutSession(const Arguments& arguments, const std::filesystem::path& model)
{
    for (const std::string_view name : {"model", "strict", "bookmark"})
        if (arguments.has(name))
            return Error{ErrorKind::WrongUsage, "'--" + std::string(name) +
                                                    "' is for sessions and pictures that contain one, and '" +
                                                    model.string() + "' is a model. Leave it out."};
    return {};
}

/// The session as it is seen at the bookmark that is asked for, if one is; without the others, which no picture shows.
Result<SessionDocument> atBookmark(const Arguments& arguments, SessionDocument document,
                                   const std::filesystem::path& session)
{
    const std::vector<Bookmark> all = std::exchange(document.view.bookmarks, {});
    const auto name = arguments.value("bookmark");
    if (!name)
        return document;
    if (const auto wanted = std::ranges::find(all, *name, &Bookmark::name); wanted != all.end()) {
        document.view = atBookmark(document.view, *wanted);
        document.hasCamera = true;
        return document;
    }
    std::string names;
    for (const Bookmark& bookmark : all)
        names += (names.empty() ? "'" : ", '") + visibleText(bookmark.name) + "'";
    return Error{ErrorKind::WrongUsage,
                 names.empty() ? "'" + session.string() + "' has no bookmarks, so '--bookmark' cannot choose one."
                               : "'" + session.string() + "' has no bookmark '" + *name + "'. It has " + names + "."};
}

/// The one that is asked for, or where the session's own is.
Result<std::filesystem::path> modelOf(const Arguments& arguments, const SessionDocument& document,
                                      const std::filesystem::path& session)
{
    if (const auto other = arguments.value("model"))
        return std::filesystem::path(*other);
    if (const auto found = sessionModel(document, session))
        return *found;
    return Error{ErrorKind::BadInput,
                 "The model of the session was not found: '" + document.model.string() +
                     "', nor one with that name near the session. Give its path with '--model FILE'."};
}

/// Tools that keep something in the picture and are not there; nothing if all are.
std::optional<SessionDifference> missingTools(PluginHost& host, const ViewValue& view)
{
    std::string names;
    for (const auto& [id, value] : view.tools)
        if (!host.tool(id))
            names += (names.empty() ? "'" : ", '") + id + "'";
    if (names.empty())
        return std::nullopt;
    return SessionDifference{"tools", "The plugins of these tools are missing, so what they show is not drawn: " +
                                          names + ". Install the plugins."};
}

/// What of the session the picture will not show; an error if that is not to be.
Result<std::vector<SessionDifference>> differencesOf(const Invocation& invocation, const SessionDocument& document,
                                                     RestoredView restored, const FoundModel& found)
{
    std::vector<SessionDifference> differences = std::move(restored.differences);
    if (const auto other = differentModel(document, *found.model);
        other && found.isWhole && !invocation.arguments.has("model"))
        differences.insert(differences.begin(), *other);
    if (auto tools = missingTools(invocation.host, restored.document.view))
        differences.push_back(*std::move(tools));
    std::string texts; // with what the session's file says, so that a terminal must not see them as they are
    for (const SessionDifference& difference : differences)
        texts += (texts.empty() ? "" : " ") + difference.text.text();
    if (!texts.empty() && invocation.arguments.has("strict"))
        return Error{ErrorKind::BadInput, "The picture would not be what the session says. " + texts +
                                              " Leave '--strict' out to draw it anyway."};
    if (!texts.empty())
        invocation.messages << "The picture is not quite what the session says. " << visibleText(texts) << "\n"
                            << std::flush;
    return differences;
}

/// As the window shows it when it opens the session.
Result<ModelView> viewBySession(const Invocation& invocation, const RenderRequest& request)
{
    ModelView view{.isOfSession = true};
    const auto saved = readSession(request.input);
    if (!saved)
        return saved.error();
    const auto document = atBookmark(invocation.arguments, *saved, request.input);
    if (!document)
        return document.error();
    const auto place = modelOf(invocation.arguments, *document, request.input);
    if (!place)
        return place.error();
    if (const Status safe = checkOutput(request.output, std::array{*place}); !safe)
        return safe.error();
    view.opened = isAtHand(*place) ? 0 : openingEnd;
    const auto found = openSessionInput(invocation, *place, invocation.progress.part(0, view.opened));
    if (!found)
        return Error{found.error().kind, "The model of the session cannot be opened. " + found.error().text()};
    view.found = *found;
    view.model = found->model;
    const auto modes = renderingModes(invocation.host);
    const auto field = extentOf(view.model);
    if (!field)
        return field.error();
    RestoredView restored = restoredView(*document, modes, *view.model, *field);
    auto differences = differencesOf(invocation, *document, restored, *found);
    if (!differences)
        return differences.error();
    view.differences = *std::move(differences);
    SessionDocument& kept = restored.document;
    ViewValue& seen = kept.view;
    const auto renderer = invocation.host.renderer(seen.appearance.mode);
    if (!renderer)
        return renderer.error();
    view.renderer = *renderer;
    const Eigen::AlignedBox3d& bounds = view.model->description().bounds;
    const Framing framing = [&](const Camera& camera) {
        return framed({.annotations = seen.annotations, .camera = camera}, bounds,
                      framedObject(*field, renderer->plugin, seen), aspectRatioOf(request.picture));
    };
    if (!kept.hasCamera)
        seen.camera = framing(seen.camera);
    const auto camera = cameraOf(invocation.arguments, seen.camera, framing, bounds, request.picture);
    if (!camera)
        return camera.error();
    seen.camera = *camera;
    view.field = seenWith(*field, seen.query, *view.model);
    view.scene = sceneOf(view.model, renderer->plugin, renderer->plugin->parameters(view.field), seen);
    view.lens = seen.lens;
    view.scene.width = request.picture.width;
    view.scene.height = request.picture.height;
    AnnotationContent& content = view.picture.annotations;
    content.state = seen.annotations;
    content.camera = *camera;
    const bool isDark = hasDarkGround(*renderer->plugin, seen.appearance.settings);
    content.background = invocation.arguments.has("background") ? request.picture.background
                                                                : seen.background.value_or(usualBackground(isDark));
    if (kept.viewSize[0] > 0)
        view.picture.viewSize = {kept.viewSize[0], kept.viewSize[1]};
    view.picture.size = {request.picture.width, request.picture.height};
    view.picture.tools =
        keptDrawings(keptTools(invocation.host, seen), view.model->description(),
                     matteringParameters(renderer->plugin->parameters(view.field), seen.appearance.settings), seen,
                     seen.camera, sizeInUnits(view.picture), {});
    return view;
}

/// Where something else than the mesh is shown, or was asked for.
void tellWhatIsShown(const Invocation& invocation, const SceneRequest& request, const BuiltScene& built,
                     JsonObject& figures)
{
    constexpr std::array<const char*, 3> names{shownMesh, shownData, shownDifference};
    const auto asked = request.values.find(shownId);
    if (asked == request.values.end() || asked->second == ParameterValue(std::string(shownMesh)))
        return;
    figures["shown"] = std::string(names[static_cast<std::size_t>(built.mesh.shown)]);
    if (built.mesh.shown == ShownField::Mesh)
        invocation.messages << "tan: The mesh is shown, not the data: with a focus, a window, '--values' or '--range' "
                               "there are no samples to compare it with.\n"
                            << std::flush;
}

/// With the scene, and with what can be said of it.
Result<PreparedScene> prepareScene(const Invocation& invocation, ModelView view, ScenePipeline& pipeline)
{
    view.scene = withSamples(std::move(view.scene), invocation.host);
    const auto built = confirmed(
        *view.model, pipeline.make(view.scene, invocation.progress.part(view.opened, sceneEnd)), invocation.progress);
    if (!built)
        return built.error();
    const ExtractedMesh& mesh = *pipeline.mesh();
    if (const Status some = checkNotEmpty(view.scene.query, *view.model, mesh.mesh); !some && !view.isOfSession)
        return some.error();
    JsonObject figures = meshFigures(*view.model, view.scene.query, mesh);
    figures["extraction_seconds"] = built->extractionSeconds;
    figures["scene_seconds"] = built->sceneSeconds;
    figures["tetrahedra"] = built->mesh.tetrahedra;
    if (view.isOfSession) {
        JsonArray parts;
        for (const SessionDifference& difference : view.differences)
            parts.push_back(difference.part);
        figures["session_differs"] = parts;
    }
    warnOfErrors(errorRemarksOf(view.field, built->mesh, view.scene.values, *built->scene), view.model->description(),
                 invocation.messages, figures);
    tellWhatIsShown(invocation, view.scene, *built, figures);
    if (built->faultyCells)
        figures["faulty_cells_outlined"] = *built->faultyCells;
    if (built->mesh.isBlended)
        figures["focus_tetrahedra"] = built->mesh.tetrahedra - mesh.mesh.tetrahedra.size();
    AnnotationContent& asked = view.picture.annotations;
    AnnotationContent content =
        contentOf(*view.model, view.renderer.plugin->parameters({}), view.scene.values, built->mesh);
    content.state = asked.state;
    content.camera = asked.camera;
    content.background = asked.background;
    tellShown(content, built->mesh.shown);
    asked = content;
    view.picture.scene = built->scene;
    return PreparedScene{view.found, view.picture, figures,   built->mesh.tetrahedra,
                         view.scene, *built,       view.lens, view.remarks};
}

void addStatistics(JsonObject& figures, const RenderStatistics& statistics)
{
    figures["cells_drawn"] = statistics.cells;
    figures["fragments"] = statistics.fragments;
    figures["cut_cells"] = statistics.cutCells;
    figures["broken_cycles"] = statistics.brokenCycles;
    figures["order_seconds"] = statistics.orderSeconds;
    figures["set_up_seconds"] = statistics.setUpSeconds;
    figures["fill_seconds"] = statistics.fillSeconds;
    figures["sent_bytes"] = statistics.sentBytes;
}

/// "19752 triangles and a volume of 222642 tetrahedra".
std::string contentText(const Scene& scene, std::size_t tetrahedra)
{
    const std::string cells = std::to_string(tetrahedra) + " tetrahedra";
    const std::string triangles = std::to_string(triangleCount(scene)) + " triangles";
    if (!shapesOf<SampledVolume>(scene).empty())
        return (shapesOf<Surface>(scene).empty() ? "" : triangles + " and ") + std::string("the samples of the data");
    if (!hasVolume(scene))
        return triangles + " from " + cells;
    return (shapesOf<Surface>(scene).empty() ? "" : triangles + " and ") + std::string("a volume of ") + cells;
}

Status writeFiles(const RenderRequest& request, const PictureOrder& order, Picture picture,
                  const std::optional<DrawnLens>& lens, JsonObject& figures)
{
    if (request.depth) {
        const auto scale = writeDepth(*request.depth, picture);
        if (!scale)
            return scale.error();
        figures["depth_file"] = request.depth->string();
        figures["nearest"] = scale->nearest;
        figures["farthest"] = scale->farthest;
    }
    const auto finished = finishedPicture(order, std::move(picture), lens);
    return finished ? writeOrdered(order, *finished) : Status(finished.error());
}

/// Before the picture is drawn, which may take long.
Status checkSurfaces(const RenderRequest& request, const BuiltScene& built, const std::string& mode)
{
    if (!request.surfaces)
        return {};
    if (const Status safe = checkMeshOutput(*request.surfaces, *built.model); !safe)
        return safe;
    if (hasSurfaceToSave(*built.scene))
        return {};
    return Error{ErrorKind::WrongUsage,
                 "'--surfaces' has nothing to write: the mode '" + mode +
                     "' has no surface here. Choose one that does, such as isosurface, or leave '--surfaces' out."};
}

Result<FileRemarks> writeSurfaceFile(const Invocation& invocation, const RenderRequest& request,
                                     const PreparedScene& prepared, JsonObject& figures)
{
    if (!request.surfaces)
        return FileRemarks();
    figures["surfaces_file"] = request.surfaces->string();
    return writeSurfaces(invocation.host, SurfaceOrder{prepared.request, prepared.built, *request.surfaces},
                         invocation.progress.withCallback({}));
}

PictureOrder orderOf(const RenderRequest& request, const PreparedScene& prepared, bool isOfSession,
                     const Arguments& arguments)
{
    ViewPicture picture = prepared.picture;
    picture.size = {request.picture.width, request.picture.height};
    picture.transparent = request.picture.transparentBackground;
    picture.dotsPerInch = request.dotsPerInch;
    PictureOrder order = pictureOrder(picture);
    order.target = request.output;
    order.threads = request.picture.threads;
    if (prepared.lens.isOn())
        order.lens = std::make_shared<const LensOrder>(LensOrder{prepared.lens, prepared.request});
    if (!isOfSession || arguments.has("samples"))
        order.samplesPerAxis = request.picture.samplesPerAxis;
    return order;
}

} // namespace

Syntax renderSyntax(PluginHost& host)
{
    Syntax syntax{
        .purpose = "draw a model into a picture",
        .explanation =
            "Works without a display, with the CPU alone or with OpenGL. What is drawn is a mesh extracted as by 'tan "
            "extract': of one accuracy, with a focus, within a budget of tetrahedra, or a part of it.",
        .positionals = {{"MODEL", modelExplanation() +
                                      " Or a session saved by the window, or a picture that contains one: it is drawn "
                                      "as the window would, and options cannot change what it specifies."}},
        .options = {{.name = "mode",
                     .placeholder = idChoices(host.renderers()),
                     .explanation = "What to show.",
                     .byDefault = std::string(defaultMode) + "; " + std::string(sliceMode) + " if --slice is given"}},
        .examples = {
            {"tan render engine.tan --error 0.5 --isovalue 100:silver:0.4 --isovalue 180:#ff8000 -o engine.png",
             "A translucent surface around a solid one."},
            {"tan render engine.tan --mode volume --transfer bones.json --no-shaded -o engine.png",
             "A volume through a transfer function of your own, without light."},
            {"tan render engine.tan --mode hybrid --isovalue 180:gold --clip 0,-1,0,-128 -o engine.png",
             "A surface in a volume, cut open at the plane y = 128."},
            {"tan render engine.tan --slice x=128 --slice z=64 --colour-bar -o engine.png",
             "Two planes through it, in the colours of the values."},
            {"tan render part.tan --isovalue 0.5:gold --boundary translucent -o part.png",
             "A surface within the walls of an irregular mesh."},
            {"tan render engine.tan --mode focus --error 4 --focus sphere:90,60,60,40 --focus-error 0.5 --falloff 10 "
             "-o engine.png",
             "A volume that is fine inside a ball and coarse outside, blended over a length of 10."},
            {"tan render engine.tan --mode volume --colour-bar --axes --title Engine -o engine.png",
             "With a legend of the colours, the directions of the axes and a title."},
            {"tan render step7.tan --mode volume --transfer heat.json --colour-bar --bar-range 20:95 -o step7.png",
             "One of a series, with the same colour bar for all: from 20 to 95."},
            {"tan render engine.tan --error 2 --isovalue 180:gold --lens 0.6,0.4,0.2,4,0.2 -o engine.png",
             "A part of it four times as large, from a mesh that is ten times as accurate."},
            {"tan render engine.tan --camera top --size 1920x1080 --background black -o engine.png", "From above."},
            {"tan render engine.tan --isovalue 180:gold --surfaces engine.glb -o engine.png",
             "A picture, and its surface as a file."},
            {"tan render engine.tansession --size 1920x1080 -o engine.png", "As the window shows it."},
            {"tan render step1.tansession --model step2.tan -o step2.png",
             "The next time step with the view of the first one, in the same colours."}}};
    const std::vector<Parameter> ofRenderers = rendererParameters(host);
    addPluginOptions(syntax, ofRenderers);
    const FieldExtent someField{{1, 3}, Eigen::AlignedBox3d(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(3, 6, 9)), {}};
    sayDefaultsFromData(syntax, ofRenderers, rendererParameters(host, someField));
    for (auto options : {pictureOptions(host), annotationOptions(), queryOptions(), serverOptions()})
        std::ranges::move(options, std::back_inserter(syntax.options));
    return syntax;
}

Result<Outcome> runRender(const Invocation& invocation)
{
    const auto start = Clock::now();
    const Arguments& arguments = invocation.arguments;
    auto request = renderRequestOf(arguments);
    if (!request)
        return request.error();
    if (const Status followed = followWidth(*request); !followed)
        return followed.error();
    const bool isOfSession = isSessionFile(request->input) || isPictureFile(request->input);
    const auto renderer = invocation.host.renderer(modeOf(arguments));
    if (!renderer)
        return renderer.error();
    if (const Status beside = isOfSession ? checkBesideSession(arguments, request->input)
                                          : checkWithoutSession(arguments, request->input);
        !beside)
        return beside.error();
    if (const Status known = checkPluginOptions(arguments, rendererParameters(invocation.host),
                                                renderer->plugin->parameters({}), "mode '" + renderer->id + "'");
        !known)
        return known.error();
    if (const auto annotations = annotationsOf(arguments); !annotations)
        return annotations.error();
    if (request->surfaces)
        if (const Status writable = checkWritable(invocation.host, WrittenContent::Surface, *request->surfaces);
            !writable)
            return Error{writable.error().kind, "'--surfaces': " + writable.error().text()};
    auto backend = makeBackend(request->backend);
    if (!backend)
        return backend.error();
    ScenePipeline pipeline(*std::move(backend));
    std::optional<tbb::global_control> limit;
    if (request->picture.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(request->picture.threads));

    auto view = isOfSession ? viewBySession(invocation, *request) : viewByOptions(invocation, *request, *renderer);
    if (!view)
        return view.error();
    const std::string mode = view->renderer.id;
    const auto prepared = prepareScene(invocation, *std::move(view), pipeline);
    if (!prepared)
        return prepared.error();
    if (const Status some = checkSurfaces(*request, prepared->built, mode); !some)
        return some.error();
    const PictureOrder order = orderOf(*request, *prepared, isOfSession, arguments);
    const auto pictureStart = Clock::now();
    const double pictureEnd = order.lens ? (sceneEnd + 1) / 2 : 1;
    auto picture = pipeline.draw(order, request->picture.depth, invocation.progress.part(sceneEnd, pictureEnd));
    if (!picture)
        return picture.error();
    JsonObject figures = prepared->figures;
    figures["picture_seconds"] = secondsSince(pictureStart);
    addStatistics(figures, pipeline.statistics());
    if (order.scene->reference) {
        figures["largest_difference"] = pipeline.statistics().largestDifference;
        figures["mean_difference"] = pipeline.statistics().meanDifference;
    }
    std::optional<DrawnLens> lens;
    if (order.lens) {
        auto drawn = pipeline.drawLens(order, invocation.progress.part(pictureEnd, 1));
        if (!drawn)
            return drawn.error();
        lens = *std::move(drawn);
        figures["lens_tetrahedra"] = lens->tetrahedra;
    }
    const auto surfaces = writeSurfaceFile(invocation, *request, *prepared, figures);
    if (!surfaces)
        return surfaces.error();
    if (const Status written = writeFiles(*request, order, *std::move(picture), lens, figures); !written)
        return written.error();

    const double seconds = secondsSince(start);
    figures["file"] = request->output.string();
    figures["mode"] = mode;
    figures["width"] = order.width;
    figures["height"] = order.height;
    figures["triangles"] = triangleCount(*order.scene);
    figures["backend"] = request->backend;
    figures["seconds"] = seconds;
    Outcome outcome{.figures = figures,
                    .text = visibleText(request->output.string()) + ": " + std::to_string(order.width) + " x " +
                            std::to_string(order.height) + " pixels, " +
                            contentText(*order.scene, prepared->tetrahedra) + ", in " + rounded(seconds, 3) + " s\n"};
    const std::uint64_t faulty = faultyCellCount(*prepared->built.model);
    if (const auto outlined = prepared->built.faultyCells; outlined && *outlined < faulty)
        outcome.text += std::to_string(*outlined) + " of " + std::to_string(faulty) +
                        " faulty cells are outlined: the model does not have all corners of the others.\n";
    if (!isOfSession)
        tellEmptySurfaces(isovaluesIn(prepared->request.values), prepared->built.model->description().range, outcome);
    addRemarks(prepared->remarks, outcome);
    addRemarks(*surfaces, outcome);
    tellPart(prepared->found, outcome);
    return outcome;
}

} // namespace tetra
