// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/workbench.h"

#include "core/model/level_text.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "plugins/host/model_building.h"
#include "ui/session/accuracy_scale.h"
#include "ui/session/field_extent.h"
#include "ui/session/plugin_texts.h"
#include "ui/session/recent_files.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <optional>

namespace tetra {
namespace {

constexpr int timeBetweenLooks = 700; // milliseconds

std::vector<Parameter> readerParameters(PluginHost& host, const std::filesystem::path& path)
{
    const auto reader = chooseReader(host, path);
    return reader ? reader->plugin->parameters() : std::vector<Parameter>{};
}

} // namespace

Workbench::Workbench(PluginHost& host, QObject* parent) : QObject(parent), host_(host)
{
    const ViewState* view = &session_.view();
    connect(&session_, &Session::modelChanged, this, &Workbench::requestScene);
    connect(&session_, &Session::modelGrown, this, &Workbench::requestScene);
    connect(view, &ViewState::queryChanged, this, &Workbench::requestScene);
    connect(view, &ViewState::lookChanged, this, &Workbench::requestScene);
    connect(view, &ViewState::isovalueInserted, this, &Workbench::requestScene);
    connect(view, &ViewState::isovalueRemoved, this, &Workbench::requestScene);
    connect(view, &ViewState::isovalueChanged, this, &Workbench::requestScene);
    connect(&sceneBuilder_, &SceneBuilder::failed, this, &Workbench::tell);
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, &session_,
            [this](const BuiltScene& scene) { session_.setShown(scene.mesh); });
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, this, &Workbench::requestDrafts);
    connect(&sceneBuilder_, &SceneBuilder::sceneReady, this, &Workbench::saveMeshWhenShown);
    connect(&sceneBuilder_, &SceneBuilder::failed, this, [this] { meshTarget_.clear(); });
    looking_.setInterval(timeBetweenLooks);
    connect(&looking_, &QTimer::timeout, this, &Workbench::lookAtBuild);
    connect(&building_, &LongTask::finished, &looking_, &QTimer::stop);
}

Workbench::~Workbench() = default;

QStringList Workbench::nameFilters()
{
    QStringList filters{tr("Models (*.tan)")};
    for (const std::string& filter : readableFiles(host_))
        filters.append(pluginText(filter));
    static const QRegularExpression patterns(R"(\(([^)]*)\)$)");
    QStringList all;
    for (const QString& filter : std::as_const(filters))
        all.append(patterns.match(filter).captured(1));
    filters.prepend(tr("All that can be opened (%1)").arg(all.join(' ')));
    filters.append(tr("All files (*)"));
    return filters;
}

void Workbench::open(const QString& path)
{
    read(filePath(path), {});
}

void Workbench::read(const std::filesystem::path& path, const ParameterValues& values)
{
    reading_.start([this, path, values](const Progress& progress) -> std::function<void()> {
        if (isModelFile(path))
            return whenModelRead(Model::open(path));
        return [this, path, dataset = openDataset(host_, path, values, progress)] { datasetRead(path, dataset); };
    });
}

/// What is to be done in the GUI thread with a model that was opened in a worker.
std::function<void()> Workbench::whenModelRead(const Result<std::shared_ptr<const Model>>& model)
{
    if (!model)
        return [this, error = model.error()] { tell(error); };
    return [this, model = *model, field = extentOf(**model)] { showModel(model, field); };
}

void Workbench::showModel(const std::shared_ptr<const Model>& model, const FieldExtent& field)
{
    modes_ = renderingModes(host_);
    if (modes_.empty())
        return emit failed(tr("No renderer plugin could be loaded, so there is no way to show a model. %1")
                               .arg(QString::fromStdString(host_.explainMissing(PluginKind::Renderer))));
    field_ = field;
    Look look = startingLook(modes_, field);
    if (model != look_)
        addRecentFile(pathText(model->path()));
    sceneBuilder_.clear();
    draftBuilder_.clear();
    session_.open(model, startingIsovalues(modes_, field), std::move(look));
}

void Workbench::datasetRead(const std::filesystem::path& path, const Result<Dataset>& dataset)
{
    if (dataset) {
        undescribedFile_.clear();
        dataset_ = std::make_shared<const Dataset>(*dataset);
        addRecentFile(pathText(path));
        emit datasetOpened();
        return;
    }
    const bool undescribed = dataset.error().kind == ErrorKind::WrongUsage;
    const auto parameters = undescribed ? readerParameters(host_, path) : std::vector<Parameter>{};
    if (parameters.empty())
        return tell(dataset.error());
    undescribedFile_ = path;
    emit descriptionNeeded(parameters, pluginText(dataset.error().text));
}

bool Workbench::canReadDifferently() const
{
    // Lattices are described in full, by their file or by the user.
    return dataset_ && dataset_->domain != DomainClass::RegularLattice &&
           !readerParameters(host_, dataset_->source.path).empty();
}

void Workbench::readDifferently()
{
    if (!canReadDifferently())
        return;
    undescribedFile_ = dataset_->source.path;
    emit descriptionNeeded(readerParameters(host_, undescribedFile_),
                           tr("It was read as %1.").arg(QString::fromStdString(dataset_->source.name)));
}

void Workbench::describe(const ParameterValues& values)
{
    read(undescribedFile_, values);
}

void Workbench::build(const BuildOrder& order)
{
    if (!dataset_ || building_.running())
        return;
    live_ = std::make_shared<LiveBuild>();
    keep_ = std::make_shared<std::atomic<bool>>(false);
    look_.reset();
    building_.start([this, order, dataset = dataset_, live = live_,
                     keep = keep_](const Progress& progress) -> std::function<void()> {
        return [this, order,
                built = tetra::buildModel(host_, *dataset, order.builder, order.values, order.target, progress,
                                          {.live = live.get(), .keepWhenCancelled = keep.get()})] {
            if (built) {
                emit modelBuilt();
                showBuilt(order.target);
            } else {
                closeLook();
                tell(built.error());
            }
        };
    });
    buildTarget_ = order.target;
    lookPath_ = filePath(looks_.filePath(pathText(order.target.filename())));
    if (order.watch && !session_.model() && looks_.isValid())
        looking_.start();
}

void Workbench::stopBuild(bool keep)
{
    if (keep_)
        *keep_ = keep;
    building_.cancel();
}

void Workbench::lookAtBuild()
{
    if (looker_.running())
        return;
    if (look_ != nullptr && !showsLook())
        return looking_.stop(); // the user has turned to something else
    looker_.start([this, live = live_, path = lookPath_](const Progress&) -> std::function<void()> {
        return [this, live, look = live->look(path)] {
            if (building_.running() && live == live_)
                showLook(look);
        };
    });
}

void Workbench::showLook(const Result<std::shared_ptr<const Model>>& look)
{
    if (!look)
        return looking_.stop(); // a picture of the build is not worth a message: no room for it, say
    if (*look == nullptr)
        return;
    const bool isFirst = look_ == nullptr;
    if (isFirst && session_.model())
        return looking_.stop();
    if (!isFirst && !showsLook())
        return;
    look_ = *look;
    if (isFirst)
        showModel(look_, roughExtentOf(*look_));
    else
        session_.grow(look_);
}

/// What was watched has not become a model.
void Workbench::closeLook()
{
    if (showsLook())
        closeModel();
    look_.reset();
}

/// The model that was watched goes on being shown as it is; any other is opened.
void Workbench::showBuilt(const std::filesystem::path& target)
{
    if (!showsLook())
        return read(target, {});
    look_.reset();
    reading_.start([this, target](const Progress&) -> std::function<void()> {
        return [this, target, model = Model::open(target)] {
            if (!model)
                return tell(model.error());
            addRecentFile(pathText(target));
            session_.grow(*model);
        };
    });
}

void Workbench::closeModel()
{
    meshTarget_.clear();
    sceneBuilder_.clear();
    draftBuilder_.clear();
    session_.close();
}

QString Workbench::proposedPath(const QString& ending) const
{
    const std::filesystem::path& path = session_.model()->path();
    const QFileInfo model(pathText(path == lookPath_ ? buildTarget_ : path)); // looks go with the program
    return model.absolutePath() + "/" + model.completeBaseName() + ending;
}

void Workbench::savePicture(const PictureOrder& order)
{
    savingPicture_.start([this, order](const Progress& progress) -> std::function<void()> {
        return [this, order, saved = writePicture(order, progress)] {
            if (saved)
                emit pictureSaved(pathText(order.target));
            else
                tell(saved.error());
        };
    });
}

void Workbench::saveText(const std::filesystem::path& target, const std::string& text)
{
    textFiles_.start([this, target, text](const Progress&) -> std::function<void()> {
        return [this, target, saved = writeTextFile(target, text)] {
            if (saved)
                emit textSaved(pathText(target));
            else
                tell(saved.error());
        };
    });
}

void Workbench::loadText(const std::filesystem::path& path, std::function<Status(const std::string& text)> use)
{
    textFiles_.start([this, path, use = std::move(use)](const Progress&) -> std::function<void()> {
        return [this, path, use, text = readTextFile(path)] {
            if (!text)
                return tell(text.error());
            if (const Status used = use(*text); !used)
                tell({used.error().kind, "In '" + path.string() + "': " + used.error().text});
        };
    });
}

void Workbench::saveMesh(const std::filesystem::path& target)
{
    meshTarget_ = target;
    savesSurfaces_ = false;
    saveMeshWhenShown();
}

void Workbench::saveSurfaces(const std::filesystem::path& target)
{
    meshTarget_ = target;
    savesSurfaces_ = true;
    saveMeshWhenShown();
}

void Workbench::saveStatistics(const std::filesystem::path& target)
{
    std::vector<Accuracy> levels;
    for (const double error : accuracyPresets)
        levels.push_back(bothWithin(error));
    if (const auto text = levelsFor(target, *session_.model(), levels))
        saveText(target, *text);
    else
        tell(text.error());
}

void Workbench::saveMeshWhenShown()
{
    MeshOrder order{session_.model(), sceneBuilder_.mesh(), session_.shown() ? session_.shown()->query : MeshQuery(),
                    meshTarget_};
    // While the worker is busy its mesh may be that of a picture to come.
    if (meshTarget_.empty() || sceneBuilder_.busy() || !session_.showsQuery() || !order.mesh)
        return;
    // Of two meshes that are blended neither is what was asked for.
    if (renderer() != nullptr && renderer()->blendsFocus())
        order.mesh = nullptr;
    meshTarget_.clear();
    const std::optional<std::vector<Isovalue>> isovalues =
        savesSurfaces_ ? std::optional(session_.view().isovalues()) : std::nullopt;
    savingMesh_.start([this, order, isovalues](const Progress& progress) -> std::function<void()> {
        const Status result = isovalues ? writeSurfaces({order, *isovalues}, progress) : writeMesh(order, progress);
        return [this, target = order.target, saved = result] {
            if (saved)
                emit meshSaved(pathText(target));
            else
                tell(saved.error());
        };
    });
}

const Renderer* Workbench::renderer() const
{
    const auto found = std::ranges::find(modes_, session_.view().look().mode, &Provided<Renderer>::id);
    return found != modes_.end() ? found->plugin : nullptr;
}

std::vector<Parameter> Workbench::renderingParameters() const
{
    const Renderer* mode = renderer();
    return mode != nullptr && session_.model() ? mode->parameters(field_) : std::vector<Parameter>{};
}

SceneRequest Workbench::sceneRequest() const
{
    const ViewState& view = session_.view();
    return {session_.model(),
            renderer(),
            meshQuery(view.query(), *session_.model()),
            rendererValues(renderingParameters(), view.look(), view.isovalues()),
            {}};
}

void Workbench::requestScene()
{
    if (!session_.model() || renderer() == nullptr)
        return;
    const SceneRequest request = sceneRequest();
    draftBuilder_.requestLook(request);
    sceneBuilder_.request(request);
}

/// Coarser ones of the scene, unless another one is on its way already.
void Workbench::requestDrafts(const BuiltScene& scene)
{
    if (session_.model() != scene.model || renderer() == nullptr)
        return;
    const SceneRequest request = sceneRequest();
    if (request.query == scene.mesh.query)
        draftBuilder_.request(request, scene.mesh);
}

void Workbench::tell(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled)
        emit failed(pluginText(error.text));
}

} // namespace tetra
