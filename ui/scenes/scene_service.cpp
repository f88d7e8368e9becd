// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scenes/scene_service.h"

#include "core/picture/rendering_modes.h"
#include "core/picture/shown_error.h"
#include "core/picture/view_picture.h"
#include "core/view/appearance.h"
#include "ui/session/annotation_language.h"
#include "ui/session/message_text.h"

#include <chrono>

namespace tetra {
namespace {

constexpr std::chrono::milliseconds settlingTime(300);

} // namespace

SceneService::SceneService(PluginHost& host, Session& session)
    : host_(host), session_(session), errors_(sceneBuilder_, session), fonts_(windowFonts())
{
    session_.setUsualTransfer(
        [this](const QueryState& query) { return usualTransfer(modes_, *session_.model(), field_, query); });
    session_.setFramedObject([this](const ViewValue& view) { return framedObject(view); });
    connect(&session_, &Session::modelChanged, this, &SceneService::requestScene);
    connect(&session_, &Session::modelGrown, this, &SceneService::requestScene);
    session_.whenChanged(ViewPart::Scene, this, &SceneService::requestScene);
    session_.whenChanged(ViewPart::Camera, this, &SceneService::followCamera);
    settling_.setSingleShot(true);
    settling_.setInterval(settlingTime);
    connect(&settling_, &QTimer::timeout, this, &SceneService::requestScene);
    connect(&sceneBuilder_, &SceneBuilder::failed, this,
            [this](const Error& error) { emit failed(translatedMessage(error.message)); });
    connect(&sceneBuilder_, &SceneBuilder::samplesMissed, this,
            [this](const Error& error) { emit failed(translatedMessage(error.message)); });
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, &session_,
            [this](const BuiltScene& scene) { session_.setShown(scene.mesh); });
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, &errors_, &ErrorMeasuring::look);
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, this, &SceneService::requestDrafts);
}

SceneService::~SceneService()
{
    session_.setUsualTransfer({});
    session_.setFramedObject({});
}

bool SceneService::prepare(const FieldExtent& field)
{
    auto modes = renderingModes(host_);
    if (modes.empty()) {
        emit failed(tr("No renderer plugin could be loaded, so models cannot be shown. %1")
                        .arg(translatedMessage(host_.explainMissing(PluginKind::Renderer))));
        return false;
    }
    modes_ = std::move(modes);
    field_ = field;
    clear();
    return true;
}

void SceneService::clear()
{
    preview_.reset();
    sceneBuilder_.clear();
    draftBuilder_.clear();
}

const Renderer* SceneService::renderer() const
{
    return rendererOf(modes_, session_.view().appearance.mode);
}

std::vector<Parameter> SceneService::renderingParameters() const
{
    const Renderer* mode = renderer();
    if (mode == nullptr || !session_.model())
        return {};
    return mode->parameters(seenWith(field_, session_.view().query, *session_.model()));
}

std::vector<Parameter> SceneService::matteringParameters() const
{
    return tetra::matteringParameters(renderingParameters(), session_.view().appearance.settings);
}

std::optional<EditedTransfer> SceneService::editedTransfer() const
{
    const auto parameters = matteringParameters();
    const Parameter* edited = tetra::editedTransfer(parameters, wantedTransfer_);
    if (edited == nullptr)
        return std::nullopt;
    const TransferFunction* chosen = chosenTransfer(edited->id, session_.view().appearance);
    return EditedTransfer{edited->id, chosen != nullptr ? *chosen : std::get<TransferFunction>(edited->defaultValue)};
}

ViewValue SceneService::startingView(const Model& model) const
{
    return tetra::startingView(modes_, model, field_, session_.shape());
}

std::vector<Eigen::Vector3d> SceneService::framedObject(const ViewValue& view) const
{
    const auto object = tetra::framedObject(field_, rendererOf(modes_, view.appearance.mode), view);
    return {object.begin(), object.end()};
}

std::vector<ErrorRemark> SceneService::errorRemarks(const BuiltScene& scene) const
{
    return errorRemarksOf(field_, scene.mesh, sceneRequest().values, *scene.scene);
}

AnnotationContent SceneService::annotations(const Camera& camera, const Colour& background) const
{
    ViewValue view = preview_.value_or(session_.view());
    view.annotations = session_.view().annotations;
    view.camera = camera;
    view.background = background;
    const auto& model = session_.model();
    const auto& shown = session_.shown();
    if (!model)
        return {.state = view.annotations, .camera = camera, .background = background, .fonts = fonts_};
    const AnnotationLanguage language = annotationLanguage();
    AnnotationContent content = annotationContent(*model, matteringParameters(), view,
                                                  shown ? accuracyText(*shown, language) : std::string(), language);
    if (shown)
        tellShown(content, shown->shown);
    content.fonts = fonts_;
    return content;
}

void SceneService::previewView(const std::optional<ViewValue>& view)
{
    std::optional<ViewValue> next = session_.model() ? view : std::nullopt;
    if (next) {
        next->query = corrected(next->query, session_.view().query, *session_.model());
        next->camera = {}; // not the model's matter
    }
    if (next == preview_)
        return;
    preview_ = next;
    requestScene();
}

/// Seen as the viewport has it, which may be on its way to the camera of the view.
SceneRequest SceneService::requestOf(ViewValue view) const
{
    view.camera = settled_;
    SceneRequest request = withSamples(sceneOf(session_.model(), renderer(), renderingParameters(), view), host_);
    if (view.appearance.transfer == usualTransfer(modes_, *session_.model(), field_, view.query))
        request.usualTransfer = [modes = modes_, field = field_, model = session_.model()](const MeshQuery& query) {
            return tetra::usualTransfer(modes, *model, field, query);
        };
    request.camera = camera_;
    request.width = pixels_.width();
    request.height = pixels_.height();
    return request;
}

SceneRequest SceneService::sessionRequest() const
{
    return requestOf(session_.view());
}

SceneRequest SceneService::sceneRequest() const
{
    return requestOf(preview_.value_or(session_.view()));
}

void SceneService::setSeenFrom(const Camera& camera, QSize pixels)
{
    if (camera == camera_ && pixels == pixels_)
        return;
    camera_ = camera;
    pixels_ = pixels;
    if (const Renderer* mode = renderer(); mode != nullptr && mode->needs().view)
        requestScene();
}

void SceneService::requestScene()
{
    if (!session_.model() || renderer() == nullptr)
        return;
    if (!settling_.isActive())
        settled_ = session_.view().camera;
    const SceneRequest request = sceneRequest();
    draftBuilder_.requestAppearance(request);
    sceneBuilder_.request(request);
}

/// A mesh that is finer near the viewer is extracted again when the camera has come to rest, not for each picture.
void SceneService::followCamera()
{
    if (session_.view().query.focus.shape == FocusState::Shape::View)
        settling_.start();
}

/// Coarser ones of the scene, unless another one is on its way already.
void SceneService::requestDrafts(const BuiltScene& scene)
{
    if (session_.model() != scene.model || renderer() == nullptr)
        return;
    const SceneRequest request = sceneRequest();
    if (request.query == scene.mesh.query)
        draftBuilder_.request(request, scene.mesh);
}

} // namespace tetra
