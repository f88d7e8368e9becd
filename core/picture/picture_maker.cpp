// SPDX-License-Identifier: GPL-3.0-or-later
// The face of this folder (tan/picture.h): a model, its plugins and two pipelines, one of the picture and one of its
// lens, so that neither takes the mesh of the other away.
#include "core/picture/annotations/annotation_content.h"
#include "core/picture/kept_tools.h"
#include "core/picture/rendering_modes.h"
#include "core/picture/restored_view.h"
#include "core/picture/session_document.h"
#include "core/picture/shown_error.h"
#include "core/picture/text_file.h"
#include "core/picture/view_picture.h"
#include "core/view/appearance.h"
#include "core/view/view_value.h"

#include <tan/picture.h>

#include <algorithm>
#include <utility>

namespace tetra {

struct PictureMaker::Parts {
    std::shared_ptr<const Model> model;
    std::unique_ptr<PluginHost> host; ///< outlives what its plugins have made
    std::vector<Provided<Renderer>> modes;
    FieldExtent field;
    ScenePipeline picture;
    ScenePipeline lens;
    std::shared_ptr<const Fonts> fonts{}; ///< opened when a text is to be written

    Result<Provided<Renderer>> rendererOf(const ViewValue& view) const;
    std::vector<Parameter> parametersOf(const Renderer& renderer, const ViewValue& view) const;
    ViewValue fitting(ViewValue view) const;
    Result<BuiltScene> build(const SceneRequest& request, const Progress& progress);
    Result<Picture> draw(const ViewValue& view, const Provided<Renderer>& renderer,
                         const std::vector<Parameter>& parameters, const PictureRequest& request,
                         const Progress& progress);
};

namespace {

SceneRequest sceneRequest(PluginHost& host, const std::shared_ptr<const Model>& model, const Renderer& renderer,
                          const std::vector<Parameter>& parameters, const ViewValue& view,
                          const PictureRequest& request)
{
    SceneRequest scene = withSamples(sceneOf(model, &renderer, parameters, view), host);
    scene.width = request.width;
    scene.height = request.height;
    return scene;
}

} // namespace

Result<Provided<Renderer>> PictureMaker::Parts::rendererOf(const ViewValue& view) const
{
    return host->renderer(view.appearance.mode);
}

std::vector<Parameter> PictureMaker::Parts::parametersOf(const Renderer& renderer, const ViewValue& view) const
{
    return renderer.parameters(seenWith(field, view.query, *model));
}

/// Views are for any model.
ViewValue PictureMaker::Parts::fitting(ViewValue view) const
{
    view.query = corrected(view.query, startingQuery(*model, startingError(*model)), *model);
    return view;
}

Result<BuiltScene> PictureMaker::Parts::build(const SceneRequest& request, const Progress& progress)
{
    auto built = picture.make(request, progress);
    if (built)
        if (const Status right = model->confirm(progress.withCallback({})); !right)
            return right.error();
    return built;
}

Result<Picture> PictureMaker::Parts::draw(const ViewValue& view, const Provided<Renderer>& renderer,
                                          const std::vector<Parameter>& parameters, const PictureRequest& request,
                                          const Progress& progress)
{
    constexpr double built = 0.5, drawn = 0.8;
    const SceneRequest scene = sceneRequest(*host, model, *renderer.plugin, parameters, view, request);
    const auto made = build(scene, progress.part(0, built));
    if (!made)
        return made.error();
    ViewPicture wanted{.scene = made->scene,
                       .annotations =
                           annotationContent(*model, matteringParameters(parameters, view.appearance.settings), view,
                                             accuracyText(made->mesh), {}),
                       .size = {request.width, request.height},
                       .viewSize = {request.viewWidth, request.viewHeight},
                       .transparent = request.transparent};
    tellShown(wanted.annotations, made->mesh.shown);
    const bool isDark = hasDarkGround(*renderer.plugin, view.appearance.settings);
    wanted.annotations.background = view.background.value_or(usualBackground(isDark));
    wanted.tools = keptDrawings(keptTools(*host, view), model->description(),
                                matteringParameters(parameters, view.appearance.settings), view, view.camera,
                                sizeInUnits(wanted), {});
    const bool hasTexts =
        view.lens.isOn() || std::ranges::any_of(view.annotations.places, &AnnotationPlace::shown) ||
        std::ranges::any_of(wanted.tools, [](const ToolDrawing& drawing) { return !drawing.texts.empty(); });
    if (hasTexts && !fonts) {
        const auto opened = openFonts();
        if (!opened)
            return opened.error();
        fonts = *opened;
    }
    wanted.annotations.fonts = fonts;
    PictureOrder order = pictureOrder(wanted);
    order.samplesPerAxis = request.samplesPerAxis;
    order.threads = request.threads;
    if (view.lens.isOn())
        order.lens = std::make_shared<const LensOrder>(LensOrder{view.lens, scene});
    auto pixels = picture.draw(order, false, progress.part(built, order.lens ? drawn : 1));
    if (!pixels)
        return pixels.error();
    return lens.finish(order, *std::move(pixels), progress.part(drawn, 1));
}

PictureMaker::PictureMaker(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
PictureMaker::PictureMaker(PictureMaker&& other) noexcept = default;
PictureMaker& PictureMaker::operator=(PictureMaker&& other) noexcept = default;
PictureMaker::~PictureMaker() = default;

Result<PictureMaker> PictureMaker::of(std::shared_ptr<const Model> model, std::unique_ptr<RenderBackend> backend,
                                      const Progress& progress)
{
    auto host = PluginHost::ofLibrary();
    auto modes = renderingModes(*host);
    if (modes.empty())
        return Error{ErrorKind::OutOfResource,
                     Message::say("No renderer plugin could be loaded, so there is no way to show a model. %1",
                                  host->explainMissing(PluginKind::Renderer))};
    auto field = extentOf(model, progress);
    if (!field)
        return field.error();
    return PictureMaker(std::unique_ptr<Parts>(new Parts{.model = std::move(model),
                                                         .host = std::move(host),
                                                         .modes = std::move(modes),
                                                         .field = *std::move(field),
                                                         .picture = ScenePipeline(std::move(backend)),
                                                         .lens = ScenePipeline()}));
}

const std::shared_ptr<const Model>& PictureMaker::model() const noexcept
{
    return parts_->model;
}

std::vector<RenderingMode> PictureMaker::modes() const
{
    std::vector<RenderingMode> all;
    for (const Provided<Renderer>& mode : parts_->modes)
        all.push_back({mode.id, mode.name});
    return all;
}

Result<std::vector<Parameter>> PictureMaker::parameters(const ViewValue& view) const
{
    const auto renderer = parts_->rendererOf(view);
    if (!renderer)
        return renderer.error();
    return parts_->parametersOf(*renderer->plugin, parts_->fitting(view));
}

ViewValue PictureMaker::startingView(double aspectRatio) const
{
    return tetra::startingView(parts_->modes, *parts_->model, parts_->field, aspectRatio);
}

Camera PictureMaker::framed(const ViewValue& view, double aspectRatio) const
{
    const auto renderer = parts_->rendererOf(view);
    return tetra::framed(view, parts_->field.bounds,
                         framedObject(parts_->field, renderer ? renderer->plugin : nullptr, view), aspectRatio);
}

Result<KeptView> PictureMaker::keptView(const std::filesystem::path& file) const
{
    auto document = readSession(file);
    if (!document)
        return document.error();
    const RestoredView restored = restoredView(*std::move(document), parts_->modes, *parts_->model, parts_->field);
    KeptView kept{.view = restored.document.view};
    for (const SessionDifference& difference : restored.differences)
        kept.differences.push_back(difference.text);
    if (restored.document.viewSize[0] > 0) {
        kept.viewWidth = restored.document.viewSize[0];
        kept.viewHeight = restored.document.viewSize[1];
    }
    if (!restored.document.hasCamera)
        kept.view.camera = framed(kept.view, static_cast<double>(kept.viewWidth) / kept.viewHeight);
    return kept;
}

Status PictureMaker::writeSession(const ViewValue& view, const std::filesystem::path& file) const
{
    return writeTextFile(
        file, sessionToText(documentOf(*parts_->model, view), std::filesystem::absolute(file).parent_path()));
}

std::map<std::string, std::string> PictureMaker::pictureTexts(const ViewValue& view,
                                                              const std::filesystem::path& file) const
{
    return tetra::pictureTexts(documentOf(*parts_->model, view), {}, std::filesystem::absolute(file).parent_path());
}

Result<std::shared_ptr<const Scene>> PictureMaker::scene(const ViewValue& view, const PictureRequest& request,
                                                         const Progress& progress)
{
    const auto renderer = parts_->rendererOf(view);
    if (!renderer)
        return renderer.error();
    const ViewValue seen = parts_->fitting(view);
    const auto parameters = parts_->parametersOf(*renderer->plugin, seen);
    const auto built = parts_->build(
        sceneRequest(*parts_->host, parts_->model, *renderer->plugin, parameters, seen, request), progress);
    return built ? Result<std::shared_ptr<const Scene>>(built->scene) : built.error();
}

Result<Picture> PictureMaker::draw(const ViewValue& view, const PictureRequest& request, const Progress& progress)
{
    const auto renderer = parts_->rendererOf(view);
    if (!renderer)
        return renderer.error();
    const ViewValue seen = parts_->fitting(view);
    return parts_->draw(seen, *renderer, parts_->parametersOf(*renderer->plugin, seen), request, progress);
}

Result<Picture> PictureMaker::drawFrame(const ViewValue& film, int number, const PictureRequest& request,
                                        const Progress& progress)
{
    const int count = frameCount(film.animation);
    if (number < 0 || number >= count)
        return Error{ErrorKind::WrongUsage,
                     Message::say("There is no frame %1 in this film, which has %2 of them.", number, count)};
    const auto renderer = parts_->rendererOf(film);
    if (!renderer)
        return renderer.error();
    // As of the film's view, so that defaults do not change from frame to frame.
    const auto parameters = parts_->parametersOf(*renderer->plugin, parts_->fitting(film));
    return parts_->draw(parts_->fitting(viewAtFrame(film, number)), *renderer, parameters, request, progress);
}

} // namespace tetra
