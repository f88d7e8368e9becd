// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/model_opening.h"

#include "core/opening/served_model.h"
#include "core/picture/restored_view.h"
#include "core/picture/view_picture.h"
#include "core/remote/remote_file.h"
#include "ui/opening/model_cache.h"
#include "ui/opening/recent_files.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

#include <tan/open.h>

#include <utility>

namespace tetra {

/// A model that is read, bit by bit if it is packed or on a server.
struct ModelOpening::Coming {
    bool isAsked = false;    ///< whether it may take the place of what is open
    bool isAccepted = false; ///< and it may
    bool isInParts = false;  ///< the first was not the last
    std::shared_ptr<const Model> shown{};
    OpenedModel newest{};
};

namespace {

constexpr std::uint64_t fetchedUnasked = 32 << 20;

/// Whether a model cannot be opened for want of the right token: whether it is left at its server or not.
bool lacksToken(const std::filesystem::path& place, const std::string& token, const Error& error,
                const Progress& progress)
{
    if (wantsToken(error))
        return true;
    const auto offer = isUnauthorized(error) ? askServer(place.string(), token, progress) : error;
    return offer && offer->wantsToken;
}

/// What was found, to be shown as the request says.
OpenedModel openedAs(const OpenedModel& as, const FoundModel& found, const Progress& progress)
{
    OpenedModel opened = as;
    opened.model = found.model;
    opened.field = knownExtentOf(found.model, progress.withCallback({}));
    opened.sitesOfWhole = found.isWhole ? 0 : found.sitesOfWhole;
    opened.bytesOfWhole = found.fileBytes;
    opened.bytesRead = found.readBytes;
    return opened;
}

} // namespace

ModelOpening::ModelOpening(Session& session, SceneService& scenes, SessionFile& sessionFile, const KeptViews& views,
                           Reading& reading)
    : session_(session), scenes_(scenes), sessionFile_(sessionFile), views_(views), reading_(reading)
{
}

ModelOpening::~ModelOpening() = default;

bool ModelOpening::showsWhole() const
{
    return session_.model() && session_.model()->elsewhere() == nullptr && becomes_.empty() && sitesOfWhole_ == 0;
}

bool ModelOpening::isComing() const
{
    return coming_ && coming_->shown && coming_->shown == session_.model();
}

void ModelOpening::read(const Work& work)
{
    const auto coming = std::make_shared<Coming>();
    reading_.start([work, coming](const Progress& progress) { return work(coming, progress); });
    coming_ = coming;
}

/// As the model was seen last.
void ModelOpening::start(const ModelRequest& request, const ComingModel& coming)
{
    reading_.start([this, request, coming](const Progress& progress) {
        ModelRequest asSeenLast = request;
        asSeenLast.as.view = views_.find(request.place);
        return whenRead(asSeenLast, coming, progress);
    });
    coming_ = coming;
}

void ModelOpening::open(const std::filesystem::path& place)
{
    start({.place = place}, std::make_shared<Coming>());
}

void ModelOpening::readWhole()
{
    if (!session_.model())
        return;
    const auto coming = std::make_shared<Coming>();
    coming->isAsked = coming->isAccepted = true;
    coming->shown = session_.model();
    start({.place = session_.model()->path(), .isWhole = true}, coming);
}

OpenOptions ModelOpening::optionsFor(const ModelRequest& request) const
{
    OpenOptions options = cacheOptions();
    options.token = tokens_.of(pathText(request.place)).toStdString();
    if (isAddress(request.place.string()) && !request.isWhole)
        options.mostBytes = fetchedUnasked;
    return options;
}

std::function<void()> ModelOpening::whenRead(const ModelRequest& request, const ComingModel& coming,
                                             const Progress& progress)
{
    OpenOptions options = optionsFor(request);
    options.grown = [&](const FoundModel& found) {
        OpenedModel part = openedAs(request.as, found, progress);
        part.becomes = request.place;
        QMetaObject::invokeMethod(
            this,
            [this, coming, part] {
                if (coming_ == coming)
                    showComing(coming, part);
            },
            Qt::QueuedConnection);
    };
    const auto found = openModel(request.place.string(), options, progress);
    if (!found)
        return whenRefused(request, coming, found.error(),
                           lacksToken(request.place, options.token, found.error(), progress));
    return [this, coming, last = openedAs(request.as, *found, progress)] { showComing(coming, last); };
}

std::function<void()> ModelOpening::whenRefused(const ModelRequest& request, const ComingModel& coming,
                                                const Error& error, bool needsToken)
{
    return [this, request, coming, error, needsToken] {
        coming->newest.becomes.clear(); // it stays what it is
        endComing(*coming, false);
        if (needsToken)
            return emit tokenWanted(
                pathText(request.place), request.again ? request.again : [this, request] { open(request.place); });
        reading_.tell(
            request.as.from.empty()
                ? error
                : Error{error.kind, Message::say("The model of the session cannot be opened. %1", error.message)});
    };
}

/// Lets the first part pass the gate; what comes meanwhile waits with it.
void ModelOpening::showComing(const ComingModel& coming, const OpenedModel& part)
{
    coming->newest = part;
    if (coming->isAccepted)
        return showNewest(*coming);
    if (std::exchange(coming->isAsked, true))
        return;
    reading_.passGate(
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

void ModelOpening::showNewest(Coming& coming)
{
    const OpenedModel part = coming.newest;
    if (!coming.shown) {
        show(part);
        coming.shown = session_.model() == part.model ? part.model : nullptr;
        if (coming.shown)
            emit modelTaken();
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
void ModelOpening::endComing(Coming& coming, bool hasCome)
{
    if (coming_.get() == &coming)
        coming_.reset();
    if (!coming.shown || session_.model() != coming.shown)
        return;
    becomes_.clear();
    if (coming.isInParts && coming.newest.from.empty()) // else show() did that
        addRecentFile(pathText(coming.shown->path()));
    emit shownPartChanged();
    if (hasCome && sitesOfWhole_ > 0)
        emit partRead(coming.newest);
}

Result<OpenedModel> ModelOpening::readNow(const std::filesystem::path& path) const
{
    const auto model = Model::open(path);
    if (!model)
        return model.error();
    return OpenedModel{.model = *model, .field = knownExtentOf(*model), .view = views_.find(path)};
}

void ModelOpening::show(const OpenedModel& opened)
{
    if (!scenes_.prepare(opened.field))
        return;
    emit leaving();
    sessionFile_.clear();
    becomes_ = opened.becomes;
    sitesOfWhole_ = opened.sitesOfWhole;
    if (becomes_.empty())
        addRecentFile(pathText(opened.model->path()));
    if (!opened.view) {
        const ViewValue start = scenes_.startingView(*opened.model);
        return session_.open(opened.model, start.isovalues, start.appearance, opened.field.object);
    }
    const RestoredView restored = opened.from.empty()
                                      ? lastView(*opened.view, scenes_.modes(), *opened.model, opened.field)
                                      : restoredView(*opened.view, scenes_.modes(), *opened.model, opened.field);
    session_.restore(opened.model, restored.document.view, restored.document.hasCamera, opened.field.object);
    if (!opened.from.empty())
        sessionFile_.take(restored, opened);
    else if (!restored.differences.empty())
        emit failed(translatedMessage(restored.differences.front().text));
    emit viewRestored(opened.from, opened.from.empty() || restored.differences.empty());
}

void ModelOpening::growTo(const OpenedModel& opened)
{
    scenes_.setExtent(opened.field);
    becomes_ = opened.becomes;
    const ViewValue start = scenes_.startingView(*opened.model);
    session_.grow(opened.model, start.isovalues, start.appearance, opened.field.object);
}

void ModelOpening::close()
{
    emit leaving();
    sessionFile_.clear();
    becomes_.clear();
    sitesOfWhole_ = 0;
    scenes_.clear();
    session_.close();
}

} // namespace tetra
