// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/workbench.h"

#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "plugins/host/model_building.h"
#include "ui/session/field_extent.h"
#include "ui/session/import_memory.h"
#include "ui/session/message_text.h"
#include "ui/session/picture_texts.h"
#include "ui/session/recent_files.h"
#include "ui/session/target_path.h"
#include "ui/session/view_picture.h"

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

Workbench::Workbench(PluginHost& host, std::filesystem::path views) : host_(host), views_(std::move(views))
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
        filters.append(translatedText(filter));
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
        openSession(file, SessionSource::File);
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

/// In a worker; what was being read before is not wanted any more.
void Workbench::read(LongTask::Work work)
{
    emit opening();
    reading_.start(std::move(work));
}

void Workbench::look(const std::filesystem::path& path, bool ask)
{
    read([this, path, ask](const Progress& progress) -> std::function<void()> {
        if (isPictureFile(path) && !ask && !sessionInPicture(path).empty())
            return [this, path] { emit pictureOpened(pathText(path)); };
        if (!isModelFile(path) || ask)
            return whenLookedAt(path, ask, progress);
        const auto opened = openModel(path);
        if (!opened)
            return tellLater(opened.error());
        return [this, opened = *opened] { passGate(true, [this, opened] { showModel(opened); }); };
    });
}

/// Lets what was read take the place of what is open, if that may be.
void Workbench::passGate(bool isModel, const std::function<void()>& go, const std::function<void()>& stay)
{
    const auto goOn = [this, go] {
        turnedAway_ = building_.running();
        go();
    };
    if (gate_)
        gate_(isModel, goOn, stay);
    else
        goOn();
}

std::function<void()> Workbench::tellLater(const Error& error)
{
    return [this, error] { tell(error); };
}

/// What is to be done in the GUI thread with a file that may hold a dataset.
std::function<void()> Workbench::whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress)
{
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
        question.reason = isIncomplete ? translatedMessage(contents.error().message) : QString();
        return [this, question] { emit choicesNeeded(question); };
    }
    return [this, path, read = readDataset(path, {}, progress.part(0.1, 1))] { datasetRead(path, read); };
}

Workbench::ReadDataset Workbench::readDataset(const std::filesystem::path& path, const ImportOptions& options,
                                              const Progress& progress)
{
    ReadDataset read{openDataset(host_, path, options, progress), {}, options};
    if (read.dataset)
        read.size = buildSizeOf(*read.dataset, progress);
    return read;
}

void Workbench::importDataset(const std::filesystem::path& path, const ImportOptions& options)
{
    read([this, path, options](const Progress& progress) -> std::function<void()> {
        const auto reader = chooseReader(host_, path, options.reader);
        const auto parameters = reader ? reader->plugin->parameters() : std::vector<Parameter>();
        return [this, path, options, read = readDataset(path, withoutDefaults(options, parameters), progress)] {
            if (read.dataset) {
                rememberImport(path, read.options);
                return passGate(
                    false, [this, path, read] { takeDataset(path, read); }, [this] { emit importFailed({}); });
            }
            const Error& error = read.dataset.error();
            emit importFailed(error.kind == ErrorKind::Cancelled ? QString() : translatedMessage(error.message));
        };
    });
}

/// For a worker.
Result<Workbench::OpenedModel> Workbench::openModel(const std::filesystem::path& path) const
{
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    return OpenedModel{*model, extentOf(**model), views_.find(path)};
}

void Workbench::datasetRead(const std::filesystem::path& path, const ReadDataset& read)
{
    if (!read.dataset)
        return tell(read.dataset.error());
    passGate(false, [this, path, read] { takeDataset(path, read); });
}

void Workbench::takeDataset(const std::filesystem::path& path, const ReadDataset& read)
{
    dataset_ = std::make_shared<const Dataset>(*read.dataset);
    buildSize_ = read.size;
    imported_ = read.options;
    addRecentFile(pathText(path));
    emit datasetOpened();
}

void Workbench::closeDataset()
{
    dataset_.reset();
    buildSize_ = {.points = 0};
    emit datasetClosed();
}

void Workbench::build(const BuildOrder& order)
{
    if (!dataset_ || building_.running())
        return;
    live_ = std::make_shared<LiveBuild>();
    keep_ = std::make_shared<std::atomic<bool>>(false);
    look_.reset();
    turnedAway_ = false;
    buildName_ = QString::fromStdString(dataset_->source.name);
    buildTarget_ = order.target;
    lookPath_ = filePath(looks_.filePath(pathText(order.target.filename())));
    building_.start([this, order, dataset = dataset_, imported = imported_, live = live_,
                     keep = keep_](const Progress& progress) -> std::function<void()> {
        const auto built =
            tetra::buildModel(host_, *dataset, order.builder, order.values, order.target, progress,
                              {.live = live.get(), .keepWhenCancelled = keep.get(), .imported = imported});
        return [this, order, dataset, model = built ? openModel(order.target) : built.error()] {
            if (model)
                built_ = dataset;
            showBuilt(order, model);
        };
    });
    if (order.watch && !session_.model() && looks_.isValid())
        looking_.start();
}

void Workbench::stopBuild(bool keep)
{
    if (keep_)
        *keep_ = keep;
    building_.cancel();
    emit buildStopping(keep);
}

void Workbench::lookAtBuild()
{
    if (looker_.running())
        return;
    if (look_ != nullptr && !showsLook())
        return looking_.stop(); // the user has turned to something else
    looker_.start([this, live = live_, path = lookPath_, target = buildTarget_,
                   isFirst = look_ == nullptr](const Progress&) -> std::function<void()> {
        const auto look = live->look(path);
        const FieldExtent field = look && *look ? extentOf(**look) : FieldExtent();
        return [this, live, look, field, view = isFirst ? views_.find(target) : std::nullopt] {
            if (building_.running() && live == live_)
                showLook(look, field, view);
        };
    });
}

void Workbench::showLook(const Result<std::shared_ptr<const Model>>& look, const FieldExtent& field,
                         const std::optional<SessionDocument>& view)
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
        showModel({look_, field, view});
    else
        growTo(look_, field);
}

/// What nobody has chosen follows the model: what a draft of it has led to is no choice.
void Workbench::growTo(const std::shared_ptr<const Model>& model, const FieldExtent& field)
{
    field_ = field;
    const SessionDocument start = tetra::startingView(modes_, *model, field_);
    session_.grow(model, start.isovalues, start.look);
}

/// What was watched has not become a model.
void Workbench::closeLook()
{
    if (showsLook())
        closeModel();
    look_.reset();
}

/// A model that was watched goes on being shown as it is seen. Another one is shown unless the user has turned to
/// something else or would lose changes by that.
void Workbench::showBuilt(const BuildOrder& order, const Result<OpenedModel>& built)
{
    if (!built) {
        closeLook();
        const bool nothingKept = built.error().kind == ErrorKind::Cancelled && *keep_;
        tellSave(nothingKept ? Error{ErrorKind::CannotWrite,
                                     Message::say("The build was stopped before there was a mesh of known error, so "
                                                  "there is nothing to keep.")}
                             : built.error());
        return emit buildEnded(false);
    }
    const bool isWatched = showsLook();
    const bool isShown = isWatched || (!turnedAway_ && !reading_.running() && !sessionModified());
    look_.reset();
    addRecentFile(pathText(order.target));
    emit modelBuilt(pathText(order.target), isShown);
    if (isWatched) {
        growTo(built->model, built->field);
    } else if (isShown) {
        showModel(*built);
    }
    emit buildEnded(true);
}

bool Workbench::hasSomethingOpen() const
{
    return session_.model() || (dataset_ && !building_.running());
}

void Workbench::close()
{
    const bool isOfDataset = !session_.model() || datasetIsBuilt();
    if (session_.model())
        closeModel();
    if (dataset_ && isOfDataset && !building_.running())
        closeDataset();
}

void Workbench::closeModel()
{
    emit leaving();
    turnedAway_ = building_.running();
    setSessionFile({});
    sceneBuilder_.clear();
    draftBuilder_.clear();
    session_.close();
}

void Workbench::setSessionFile(const std::filesystem::path& file)
{
    sessionFile_ = file;
    if (file.empty())
        sessionFound_ = {};
    emit sessionFileChanged();
}

const Renderer* Workbench::renderer() const
{
    return rendererOf(modes_, session_.view().look().mode);
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
    return sceneOf(session_.model(), renderer(), renderingParameters(), view.query(), view.look(), view.isovalues());
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
        emit failed(translatedMessage(error.message));
}

bool Workbench::tellSave(const Status& saved)
{
    if (!saved && saved.error().kind != ErrorKind::Cancelled)
        emit saveFailed(translatedMessage(saved.error().message));
    return saved.ok();
}

} // namespace tetra
