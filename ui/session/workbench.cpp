// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/workbench.h"

#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "plugins/host/model_building.h"
#include "ui/session/field_extent.h"
#include "ui/session/import_memory.h"
#include "ui/session/picture_texts.h"
#include "ui/session/plugin_texts.h"
#include "ui/session/recent_files.h"
#include "ui/session/sentences.h"
#include "ui/session/target_path.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <optional>

namespace tetra {
namespace {

constexpr int timeBetweenLooks = 700; // milliseconds

/// Those that make a difference.
ImportOptions withoutDefaults(ImportOptions options, const std::vector<Parameter>& parameters)
{
    for (const Parameter& parameter : parameters)
        if (const auto found = options.values.find(parameter.id);
            found != options.values.end() && found->second == parameter.defaultValue)
            options.values.erase(found);
    return options;
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
    connect(&session_, &Session::modelChanged, this, &Workbench::watchForDamage);
    connect(&session_, &Session::modelGrown, this, &Workbench::watchForDamage);
    connect(&watching_, &QTimer::timeout, this, &Workbench::lookForDamage);
    watching_.setInterval(timeBetweenLooks);
    looking_.setInterval(timeBetweenLooks);
    connect(&looking_, &QTimer::timeout, this, &Workbench::lookAtBuild);
    connect(&building_, &LongTask::finished, &looking_, &QTimer::stop);
}

Workbench::~Workbench() = default;

QStringList Workbench::nameFilters()
{
    QStringList filters{tr("Models (*.tan)"), tr("Sessions (*.tansession)"),
                        tr("Pictures with their sessions (*.png)")};
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
    if (const std::filesystem::path file = filePath(path); isSessionFile(file))
        loadText(file, [this, file](const std::string& text) -> Status {
            openSession(text, std::filesystem::absolute(file).parent_path(), file);
            return {};
        });
    else if (isPictureFile(file))
        openPicture(file);
    else
        look(file, false);
}

void Workbench::openWithOptions(const QString& path)
{
    look(filePath(path), true);
}

void Workbench::readDifferently()
{
    if (dataset_)
        look(dataset_->source.path, true);
}

void Workbench::look(const std::filesystem::path& path, bool ask)
{
    reading_.start([this, path, ask](const Progress& progress) -> std::function<void()> {
        if (isModelFile(path) && !ask)
            return whenModelRead(Model::open(path));
        return whenLookedAt(path, ask, progress);
    });
}

/// What is to be done in the GUI thread with a file that may hold a dataset.
std::function<void()> Workbench::whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress)
{
    const auto tellLater = [this](const Error& error) { return [this, error] { tell(error); }; };
    ImportQuestion question;
    question.path = path;
    question.options = rememberedImport(path, host_);
    const auto reader = chooseReader(host_, path);
    if (!reader)
        return tellLater(reader.error());
    const auto contents = probeDataset(host_, path, {}, progress.part(0, 0.1));
    const bool isIncomplete = !contents && contents.error().kind == ErrorKind::WrongUsage;
    if (!contents && !isIncomplete)
        return tellLater(contents.error());
    if (ask || isIncomplete || offersChoice(*contents)) {
        const auto lastReader = chooseReader(host_, path, question.options.reader);
        question.reader = lastReader ? *lastReader : *reader;
        question.contents = contents ? *contents : FileContents();
        question.reason = isIncomplete ? translatedSentence(contents.error().text) : QString();
        return [this, question] { emit choicesNeeded(question); };
    }
    return [this, path, read = readDataset(path, {}, progress.part(0.1, 1))] { datasetRead(path, read); };
}

Workbench::ReadDataset Workbench::readDataset(const std::filesystem::path& path, const ImportOptions& options,
                                              const Progress& progress)
{
    ReadDataset read{openDataset(host_, path, options, progress), {}, options};
    if (read.dataset)
        read.size = buildSizeOf(*read.dataset);
    return read;
}

void Workbench::importDataset(const std::filesystem::path& path, const ImportOptions& options)
{
    reading_.start([this, path, options](const Progress& progress) -> std::function<void()> {
        const auto reader = chooseReader(host_, path, options.reader);
        const auto parameters = reader ? reader->plugin->parameters() : std::vector<Parameter>();
        return [this, path, options, read = readDataset(path, withoutDefaults(options, parameters), progress)] {
            if (read.dataset) {
                rememberImport(path, read.options);
                return datasetRead(path, read);
            }
            const Error& error = read.dataset.error();
            emit importFailed(error.kind == ErrorKind::Cancelled ? QString() : translatedSentence(error.text));
        };
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
    if (prepareToShow(model, field))
        session_.open(model, startingIsovalues(modes_, field),
                      startingLook(modes_, field, model->description().domain));
}

/// Whether there is a way to show it.
bool Workbench::prepareToShow(const std::shared_ptr<const Model>& model, const FieldExtent& field)
{
    modes_ = renderingModes(host_);
    if (modes_.empty()) {
        emit failed(tr("No renderer plugin could be loaded, so there is no way to show a model. %1")
                        .arg(translatedSentence(host_.explainMissing(PluginKind::Renderer))));
        return false;
    }
    field_ = field;
    if (model != look_)
        addRecentFile(pathText(model->path()));
    sceneBuilder_.clear();
    draftBuilder_.clear();
    sessionFile_.clear();
    sessionFound_ = {};
    return true;
}

void Workbench::datasetRead(const std::filesystem::path& path, const ReadDataset& read)
{
    if (!read.dataset)
        return tell(read.dataset.error());
    dataset_ = std::make_shared<const Dataset>(*read.dataset);
    buildSize_ = read.size;
    imported_ = read.options;
    addRecentFile(pathText(path));
    emit datasetOpened();
}

void Workbench::build(const BuildOrder& order)
{
    if (!dataset_ || building_.running())
        return;
    live_ = std::make_shared<LiveBuild>();
    keep_ = std::make_shared<std::atomic<bool>>(false);
    look_.reset();
    building_.start([this, order, dataset = dataset_, imported = imported_, live = live_,
                     keep = keep_](const Progress& progress) -> std::function<void()> {
        return
            [this, order,
             built = tetra::buildModel(host_, *dataset, order.builder, order.values, order.target, progress,
                                       {.live = live.get(), .keepWhenCancelled = keep.get(), .imported = imported})] {
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
        return look(target, false);
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
    sessionFile_.clear();
    sessionFound_ = {};
    meshTarget_.clear();
    sceneBuilder_.clear();
    draftBuilder_.clear();
    session_.close();
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

std::vector<Parameter> Workbench::matteringParameters() const
{
    return tetra::matteringParameters(renderingParameters(), session_.view().look().settings);
}

SceneRequest Workbench::sceneRequest() const
{
    const ViewState& view = session_.view();
    if (preview_)
        return sceneOf(filmOrder(preview_->camera), *preview_);
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

/// Damage of the model's file may be found by whatever reads it, or by the thread that checks an old one.
void Workbench::watchForDamage()
{
    if (session_.model())
        watching_.start();
    else
        watching_.stop();
}

void Workbench::lookForDamage()
{
    const Status found = session_.model()->foundDamage();
    if (found)
        return;
    watching_.stop();
    tell(found.error());
}

void Workbench::tell(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled)
        emit failed(translatedSentence(error.text));
}

} // namespace tetra
