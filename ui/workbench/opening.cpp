// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/opening.h"

#include "core/opening/served_model.h"
#include "core/remote/remote_file.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/session/session_model.h"
#include "ui/workbench/import_question.h"
#include "ui/workbench/model_cache.h"
#include "ui/workbench/recent_files.h"
#include "ui/workbench/sample_models.h"
#include "ui/workbench/view_picture.h"

#include <tan/open.h>

#include <QFileInfo>
#include <QRegularExpression>
#include <QUrl>

#include <utility>

namespace tetra {
namespace {

constexpr int timeBetweenChecks = 700; // milliseconds
constexpr std::uint64_t fetchedUnasked = 32 << 20;

/// Those that make a difference.
ImportOptions withoutDefaults(ImportOptions options, const std::vector<Parameter>& parameters)
{
    for (const Parameter& parameter : parameters)
        if (const auto found = options.values.find(parameter.id);
            found != options.values.end() && found->second == parameter.defaultValue)
            options.values.erase(found);
    return options;
}

/// For the preview of a raw file, and the check of its size.
Status findSamples(ImportQuestion& question, const Progress& progress)
{
    question.samples = question.path;
    const auto bytes = firstBytesOf(question.path);
    if (!bytes || !isPackedByGzip(*bytes))
        return {};
    auto folder = UnpackedFiles::make(question.path);
    if (!folder)
        return folder.error();
    const auto unpacked = folder->unpack(question.path, unpackedName(question.path).filename(), progress);
    if (!unpacked)
        return unpacked.error();
    question.samples = *unpacked;
    question.unpacked = *std::move(folder);
    return {};
}

/// Whether a model cannot be opened for want of the right token: whether it is left at its server or not.
bool lacksToken(const std::filesystem::path& place, const std::string& token, const Error& error,
                const Progress& progress)
{
    if (wantsToken(error))
        return true;
    const auto offer = isUnauthorized(error) ? askServer(place.string(), token, progress) : error;
    return offer && offer->wantsToken;
}

/// A sentence after the other, each after a blank.
QString listOf(const std::vector<SessionDifference>& differences)
{
    QString list;
    for (const SessionDifference& difference : differences)
        list += ' ' + translatedMessage(difference.text);
    return list;
}

/// "http://host:8080" of an address.
QString serverOf(const QString& place)
{
    const QUrl address(QString::fromStdString(placeOf(place.toStdString(), false)));
    return address.scheme() + "://" + address.authority();
}

} // namespace

Opening::Opening(PluginHost& host, Session& session, SceneService& scenes, std::filesystem::path views)
    : host_(host), session_(session), scenes_(scenes), views_(std::move(views))
{
    connect(&session_, &Session::modelChanged, this, [this] { ++opened_; });
    connect(&session_, &Session::modelChanged, this, &Opening::watchForDamage);
    connect(&session_, &Session::modelGrown, this, &Opening::watchForDamage);
    connect(&watching_, &QTimer::timeout, this, &Opening::lookForDamage);
    watching_.setInterval(timeBetweenChecks);
}

Opening::~Opening() = default;

QStringList Opening::nameFilters()
{
    QStringList filters{tr("Models (*.tan)"), tr("Sessions (*.tansession)"),
                        tr("Pictures with their sessions (*.png)")};
    for (const std::string& filter : readableFiles(host_))
        filters.append(translatedText(filter));
    filters.append(tr("Datasets packed by gzip (*.gz)"));
    static const QRegularExpression patterns(R"(\(([^)]*)\)$)");
    QStringList all;
    for (const QString& filter : std::as_const(filters))
        all.append(patterns.match(filter).captured(1));
    filters.prepend(tr("All that can be opened (%1)").arg(all.join(' ')));
    filters.append(tr("All files (*)"));
    return filters;
}

void Opening::open(const QString& path)
{
    if (const std::filesystem::path file = filePath(path); isSessionFile(file))
        openSession(file, SessionSource::File);
    else
        look(file, false);
}

void Opening::setToken(const QString& place, const QString& token)
{
    const std::lock_guard lock(tokensMutex_);
    tokens_[serverOf(place)] = token;
}

QString Opening::tokenOf(const QString& place) const
{
    const std::lock_guard lock(tokensMutex_);
    const auto found = tokens_.find(serverOf(place));
    return found != tokens_.end() ? found->second : QString();
}

void Opening::openWithOptions(const QString& path)
{
    look(filePath(path), true);
}

void Opening::readDifferently()
{
    if (dataset_)
        look(dataset_->source.path, true);
}

/// How a model is to be seen that was seen before; none read yet.
OpenedModel Opening::asSeenLast(const std::filesystem::path& place) const
{
    OpenedModel as;
    as.view = views_.find(place);
    return as;
}

/// In a worker; what was being read before is not wanted any more.
void Opening::read(LongTask::Work work)
{
    emit aboutToRead();
    coming_.reset();
    reading_.start(std::move(work));
}

void Opening::readModel(const std::filesystem::path& place, const std::shared_ptr<Coming>& coming, bool whole)
{
    read([this, place, coming, whole](const Progress& progress) {
        return whenModelCame(place, asSeenLast(place), coming, whole, progress);
    });
    coming_ = coming;
}

void Opening::readWhole()
{
    if (!session_.model())
        return;
    const auto coming = std::make_shared<Coming>();
    coming->isAsked = coming->isAccepted = true;
    coming->shown = session_.model();
    readModel(session_.model()->path(), coming, true);
}

/// In a worker: what is to be done with a model when all of it has come. Parts are shown before. `as`: what else is
/// known of it.
std::function<void()> Opening::whenModelCame(const std::filesystem::path& place, const OpenedModel& as,
                                             const std::shared_ptr<Coming>& coming, bool whole,
                                             const Progress& progress)
{
    const auto openedOf = [&as, &progress](const FoundModel& found) {
        OpenedModel opened = as;
        opened.model = found.model;
        opened.field = knownExtentOf(found.model, progress.withCallback({}));
        opened.sitesOfWhole = found.isWhole ? 0 : found.sitesOfWhole;
        opened.bytesOfWhole = found.fileBytes;
        opened.bytesRead = found.readBytes;
        return opened;
    };
    OpenOptions options = cacheOptions();
    options.token = tokenOf(pathText(place)).toStdString();
    if (isAddress(place.string()) && !whole)
        options.mostBytes = fetchedUnasked;
    options.grown = [&](const FoundModel& found) {
        OpenedModel part = openedOf(found);
        part.becomes = place;
        QMetaObject::invokeMethod(
            this,
            [this, coming, part] {
                if (coming_ == coming)
                    showComing(coming, part);
            },
            Qt::QueuedConnection);
    };
    const auto found = tetra::openModel(place.string(), options, progress);
    if (!found && lacksToken(place, options.token, found.error(), progress))
        return [this, coming, as, place] {
            coming->newest.becomes.clear();
            endComing(*coming, false);
            emit tokenWanted(pathText(place), [this, as, place] {
                if (as.from.empty())
                    open(pathText(place));
                else
                    openSession(as.from, as.source);
            });
        };
    if (!found)
        return [this, coming, as, error = found.error()] {
            coming->newest.becomes.clear(); // it stays what it is
            endComing(*coming, false);
            tell(as.from.empty()
                     ? error
                     : Error{error.kind, Message::say("The model of the session cannot be opened. %1", error.message)});
        };
    return [this, coming, last = openedOf(*found)] { showComing(coming, last); };
}

/// Lets the first part pass the gate; what comes meanwhile waits with it.
void Opening::showComing(const std::shared_ptr<Coming>& coming, const OpenedModel& part)
{
    coming->newest = part;
    if (coming->isAccepted)
        return showNewest(*coming);
    if (std::exchange(coming->isAsked, true))
        return;
    passGate(
        true,
        [this, coming] {
            coming->isAccepted = true;
            showNewest(*coming);
        },
        [this, coming] {
            if (coming_ == coming)
                reading_.cancel();
        });
}

void Opening::showNewest(Coming& coming)
{
    const OpenedModel part = coming.newest;
    if (!coming.shown) {
        showModel(part);
        coming.shown = session_.model() == part.model ? part.model : nullptr;
        if (coming.shown && dataset_ && !datasetInUse_) // the user has turned to something else
            closeDataset();
    } else if (session_.model() != coming.shown) { // the user has turned to something else
        if (coming_.get() == &coming)
            reading_.cancel();
        return;
    } else if (part.model->siteCount() > coming.shown->siteCount()) {
        growTo(part);
        coming.shown = part.model;
    }
    coming.isInParts |= !part.becomes.empty();
    if (coming.shown)
        sitesOfWhole_ = part.sitesOfWhole;
    if (part.becomes.empty())
        endComing(coming, true);
    else
        emit shownPartChanged();
}

/// Nothing more of it comes; what is shown of it stays.
void Opening::endComing(Coming& coming, bool hasCome)
{
    if (coming_.get() == &coming)
        coming_.reset();
    if (!coming.shown || session_.model() != coming.shown)
        return;
    becomes_.clear();
    if (coming.isInParts && coming.newest.from.empty()) // else showModel() did that
        addRecentFile(pathText(coming.shown->path()));
    emit shownPartChanged();
    if (hasCome && sitesOfWhole_ > 0)
        emit partRead(coming.newest);
}

void Opening::look(const std::filesystem::path& path, bool ask)
{
    const auto coming = std::make_shared<Coming>();
    if (isAddress(path.string()))
        return readModel(path, coming, false);
    read([this, path, ask, coming](const Progress& progress) -> std::function<void()> {
        if (isPictureFile(path) && !ask)
            if (const auto session = sessionInPicture(path); session && !session->empty())
                return [this, path] { emit pictureOpened(pathText(path)); };
        if (!isModelFile(path) || ask)
            return whenLookedAt(path, ask, progress);
        return whenModelCame(path, asSeenLast(path), coming, false, progress);
    });
    coming_ = coming;
}

/// Lets what was read take the place of what is open, if that may be.
void Opening::passGate(bool isModel, const std::function<void()>& go, const std::function<void()>& stay)
{
    if (gate_)
        gate_(isModel, go, stay);
    else
        go();
}

std::function<void()> Opening::tellLater(const Error& error)
{
    return [this, error] { tell(error); };
}

/// What is to be done in the GUI thread with a file that may hold a dataset.
std::function<void()> Opening::whenLookedAt(const std::filesystem::path& path, bool ask, const Progress& progress)
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
        if (const Status found = findSamples(question, progress.part(0.1, 1)); !found)
            return tellLater(found.error());
        return [this, question] { emit choicesNeeded(question); };
    }
    return [this, path, read = readDataset(path, {}, progress.part(0.1, 1))] { datasetRead(path, read); };
}

Opening::ReadDataset Opening::readDataset(const std::filesystem::path& path, const ImportOptions& options,
                                          const Progress& progress)
{
    ReadDataset read{openDataset(host_, path, options, progress), {}, options};
    if (read.dataset) {
        read.size = buildSizeOf(*read.dataset, progress);
        for (const Provided<Builder>& builder : host_.builders())
            read.acceptances.push_back(builder.plugin->accepts(*read.dataset));
    }
    return read;
}

void Opening::importDataset(const std::filesystem::path& path, const ImportOptions& options)
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

void Opening::datasetRead(const std::filesystem::path& path, const ReadDataset& read)
{
    if (!read.dataset)
        return tell(read.dataset.error());
    passGate(false, [this, path, read] { takeDataset(path, read); });
}

void Opening::takeDataset(const std::filesystem::path& path, const ReadDataset& read)
{
    dataset_ = std::make_shared<const Dataset>(*read.dataset);
    buildSize_ = read.size;
    imported_ = read.options;
    acceptances_ = read.acceptances;
    addRecentFile(pathText(path));
    emit datasetOpened();
}

void Opening::closeDataset()
{
    dataset_.reset();
    buildSize_ = {.points = 0};
    emit datasetClosed();
}

/// For a worker.
Result<OpenedModel> Opening::openModel(const std::filesystem::path& path) const
{
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    return OpenedModel{.model = *model, .field = knownExtentOf(*model), .view = views_.find(path)};
}

void Opening::openSession(const std::filesystem::path& path, SessionSource source, const std::filesystem::path& located)
{
    const auto coming = std::make_shared<Coming>();
    read([this, path, source, located, coming](const Progress& progress) -> std::function<void()> {
        auto document = readSession(path);
        if (!document)
            return tellLater(document.error());
        const auto model =
            located.empty() ? sessionModel(*document, document->file.empty() ? path : document->file) : located;
        if (!model)
            return [this, path, source, missing = document->model] { emit modelMissing(path, source, missing); };
        document->model = *model;
        OpenedModel as;
        as.view = *document;
        as.from = path;
        as.source = source;
        as.isLocated = !located.empty();
        return whenModelCame(*model, as, coming, false, progress);
    });
    coming_ = coming;
}

void Opening::applyLook(const std::filesystem::path& path)
{
    if (!session_.model())
        return;
    applying_.start([this, path, opened = opened_](const Progress&) -> std::function<void()> {
        const auto document = readSession(path);
        if (!document)
            return tellLater(document.error());
        return [this, path, opened, look = *document] {
            if (opened_ != opened) // the user has turned to something else
                return;
            const std::shared_ptr<const Model> model = session_.model(); // which may have grown meanwhile
            const RestoredView restored = restoredView(look, scenes_.modes(), *model, scenes_.extent());
            ViewValue view = restored.document.view;
            if (!look.hasCamera)
                view.camera = session_.view().camera;
            else if (!restored.document.hasCamera)
                view.camera = fitted(view.camera, model->description().bounds, session_.shape());
            session_.setView(view, tr("Apply Look"));
            if (!restored.differences.empty())
                emit failed(tr("Not all of the look of %1 could be applied.").arg(shownName(path)) +
                            listOf(restored.differences));
        };
    });
}

void Opening::showModel(const OpenedModel& opened)
{
    if (!scenes_.prepare(opened.field))
        return;
    emit leaving();
    setSessionFile({});
    becomes_ = opened.becomes;
    sitesOfWhole_ = opened.sitesOfWhole;
    if (becomes_.empty())
        addRecentFile(pathText(opened.model->path()));
    if (!opened.view) {
        const ViewValue start = scenes_.startingView(*opened.model);
        return session_.open(opened.model, start.isovalues, start.appearance);
    }
    const RestoredView restored = opened.from.empty()
                                      ? lastView(*opened.view, scenes_.modes(), *opened.model, opened.field)
                                      : restoredView(*opened.view, scenes_.modes(), *opened.model, opened.field);
    session_.restore(opened.model, restored.document.view, restored.document.hasCamera);
    if (!opened.from.empty())
        showSession(restored, opened);
    else if (!restored.differences.empty())
        emit failed(translatedMessage(restored.differences.front().text));
    emit viewRestored(opened.from, opened.from.empty() || restored.differences.empty());
}

/// What a session has beside the view of its model. One of which not all could be shown stays as it is: saving asks for
/// another file.
void Opening::showSession(const RestoredView& restored, const OpenedModel& opened)
{
    const SessionDocument& document = restored.document;
    const bool isLost = opened.source == SessionSource::Lost && !document.file.empty();
    const bool isAll = restored.differences.empty();
    if (opened.source == SessionSource::File || isLost) {
        const std::filesystem::path& file = isLost ? document.file : opened.from;
        addRecentFile(pathText(file));
        if (isAll) {
            sessionFound_ = document.found;
            setSessionFile(file);
        }
    }
    if (isLost || opened.isLocated)
        session_.undoStack().resetClean(); // the file does not have what was lost, or says another place
    QStringList told;
    const bool isWhole = opened.sitesOfWhole == 0;
    if (const auto other = differentModel(document, *opened.model); other && isWhole)
        told << translatedMessage(other->text);
    if (!isAll)
        told << tr("Not all of the session could be kept.") + listOf(restored.differences)
             << (opened.source == SessionSource::Lost
                     ? tr("It will be offered again the next time.")
                     : tr("The session %1 stays as it is; saving will ask for another file name.")
                           .arg(shownName(opened.from)));
    else if (!told.isEmpty())
        told << tr("It is shown as the session says.");
    if (!told.isEmpty())
        emit failed(told.join(' '));
}

void Opening::growTo(const OpenedModel& opened)
{
    scenes_.setExtent(opened.field);
    becomes_ = opened.becomes;
    const ViewValue start = scenes_.startingView(*opened.model);
    session_.grow(opened.model, start.isovalues, start.appearance);
}

std::optional<SessionDocument> Opening::sessionDocument() const
{
    if (!session_.model() || !becomes_.empty())
        return std::nullopt;
    const Model& model = *session_.model();
    SessionDocument document;
    document.model = isAddress(model.path().string()) ? model.path() : std::filesystem::absolute(model.path());
    document.identity = sitesOfWhole_ == 0 ? modelIdentity(model) : 0;
    document.bounds = model.description().bounds;
    document.withDirections = !model.description().lattice.isAlongAxes();
    document.range = model.description().range;
    document.view = session_.view();
    document.hasCamera = true;
    document.found = sessionFound_;
    return document;
}

/// The changes count as saved from here on, so that those that come while the file is written do not.
void Opening::saveSession(const std::filesystem::path& target, const SessionDocument& document,
                          const std::function<void(bool saved)>& then)
{
    session_.undoStack().setClean();
    const std::string text = sessionToText(document, std::filesystem::absolute(target).parent_path());
    savingSession_.enqueue(
        [this, target, text, then, model = session_.model()](const Progress&) -> std::function<void()> {
            return [this, target, then, model, saved = writeTextFile(target, text)] {
                const bool isOpen = session_.model() == model;
                if (!saved) {
                    if (isOpen)
                        session_.undoStack().resetClean();
                    emit saveFailed(translatedMessage(saved.error().message));
                } else {
                    if (isOpen)
                        setSessionFile(target);
                    addRecentFile(pathText(target));
                    emit sessionSaved(pathText(target));
                }
                if (then)
                    then(saved.ok());
            };
        });
}

QString Opening::proposedPath(const QString& ending) const
{
    const std::filesystem::path& path = session_.model()->path();
    const QFileInfo model(pathText(becomes_.empty() ? path : becomes_)); // looks at a build go with the program
    // What lies beside a sample may be gone tomorrow.
    const bool hasFolder = !isOfSample(path) && !isAddress(path.string());
    const QString folder = hasFolder ? model.absolutePath() : documentFolder();
    QString name = model.completeBaseName();
    if (ending.contains('.' + QFileInfo(name).suffix() + '.')) // x.packed.tan is not packed into x.packed.packed.tan
        name = QFileInfo(name).completeBaseName();
    return folder + "/" + name + ending;
}

void Opening::openSample(const std::string& name)
{
    sampling_.start([this, name](const Progress& progress) -> std::function<void()> {
        return [this, model = sampleModel(host_, name, sampleFolder(), progress)] {
            if (model)
                open(pathText(*model));
            else
                tell(model.error());
        };
    });
}

void Opening::drawThumbnails()
{
    if (std::exchange(thumbnailsWanted_, true))
        return;
    if (reading_.running()) // what the user waits for comes first
        connect(&reading_, &LongTask::finished, this, &Opening::startThumbnails, Qt::SingleShotConnection);
    else
        startThumbnails();
}

void Opening::startThumbnails()
{
    thumbnails_.start([this](const Progress& progress) -> std::function<void()> {
        for (const SampleCard& card : sampleCards()) {
            // A sample without a picture still has its name; what is wrong is told by whoever opens it.
            const auto picture = sampleThumbnail(host_, card.name, sampleFolder(), progress.withCallback({}));
            if (progress.cancelled())
                break;
            if (picture)
                QMetaObject::invokeMethod(
                    this, [this, name = card.name, image = *picture] { emit thumbnailDrawn(name, image); },
                    Qt::QueuedConnection);
        }
        return [] {};
    });
}

void Opening::close()
{
    const bool isOfDataset = !session_.model() || datasetIsBuilt();
    if (session_.model())
        closeModel();
    if (dataset_ && isOfDataset && !datasetInUse_)
        closeDataset();
}

void Opening::closeModel()
{
    emit leaving();
    setSessionFile({});
    becomes_.clear();
    sitesOfWhole_ = 0;
    scenes_.clear();
    session_.close();
}

void Opening::setSessionFile(const std::filesystem::path& file)
{
    sessionFile_ = file;
    if (file.empty())
        sessionFound_ = {};
    emit sessionFileChanged();
}

/// Damage of the model's file may be found by whatever reads it, or by the thread that checks an old one.
void Opening::watchForDamage()
{
    if (session_.model())
        watching_.start();
    else
        watching_.stop();
}

void Opening::lookForDamage()
{
    const Status found = session_.model()->foundDamage();
    if (found)
        return;
    watching_.stop();
    tell(found.error());
}

void Opening::tell(const Error& error)
{
    if (error.kind != ErrorKind::Cancelled)
        emit failed(translatedMessage(error.message));
}

} // namespace tetra
