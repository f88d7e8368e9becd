// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/workbench/building.h"

#include "core/picture/view_picture.h"
#include "plugins/host/interrupted_build.h"
#include "plugins/host/model_building.h"
#include "ui/opening/recent_files.h"
#include "ui/session/files.h"
#include "ui/session/message_text.h"

namespace tetra {
namespace {

constexpr int timeBetweenLooks = 700; // milliseconds

} // namespace

Building::Building(PluginHost& host, Session& session, Opening& opening)
    : host_(host), session_(session), opening_(opening)
{
    looking_.setInterval(timeBetweenLooks);
    connect(&looking_, &QTimer::timeout, this, &Building::lookAtBuild);
    connect(&task_, &LongTask::started, this, [this] { opening_.datasets().setInUse(true); });
    connect(&task_, &LongTask::finished, this, [this] {
        looking_.stop();
        opening_.datasets().setInUse(false);
    });
    const auto turnAway = [this] { turnedAway_ = running(); };
    connect(&opening.models(), &ModelOpening::leaving, this, turnAway);
    connect(&opening.datasets(), &DatasetOpening::datasetOpened, this, turnAway);
}

Building::~Building() = default;

void Building::build(const BuildOrder& order)
{
    const auto& dataset = opening_.datasets().dataset();
    if (!dataset || running())
        return;
    live_ = std::make_shared<LiveBuild>();
    wish_ = std::make_shared<Wish>();
    resumes_ = order.resume;
    look_.reset();
    turnedAway_ = false;
    buildName_ = shownText(dataset->source.name);
    buildTarget_ = order.target;
    lookPath_ = filePath(looks_.filePath(pathText(order.target.filename())));
    task_.start([this, order, dataset, imported = opening_.datasets().importOptions(), live = live_,
                 wish = wish_](const Progress& progress) -> std::function<void()> {
        wish->keepsBeside = tetra::keepsBeside(order.target);
        const auto built = tetra::buildModel(
            host_, *dataset, order.builder, order.values, order.target, progress,
            {.live = live.get(), .keepWhenCancelled = &wish->keep, .resume = order.resume, .imported = imported});
        const bool isLost = !built && wish->keep; // not what the user asked for
        if (order.resume && wish->leaveNothing && !isLost)
            (void)discardInterruptedBuild(order.target);
        return [this, order, dataset, model = built ? opening_.models().readNow(built->model) : built.error()] {
            if (model)
                opening_.datasets().setBuilt(dataset);
            showBuilt(order.target, model);
        };
    });
    if (order.watch && !session_.model() && looks_.isValid())
        looking_.start();
}

void Building::stopBuild(BuildEnd end)
{
    if (wish_) {
        wish_->keep = end == BuildEnd::Keep;
        wish_->leaveNothing = end != BuildEnd::Pause;
    }
    task_.cancel();
    emit buildStopping(end);
}

void Building::discardInterrupted(const std::filesystem::path& target)
{
    discarding_.enqueue([this, target](const Progress&) -> std::function<void()> {
        return [this, discarded = discardInterruptedBuild(target)] {
            if (!discarded)
                emit saveFailed(translatedMessage(discarded.error().message));
            emit interruptedDiscarded();
        };
    });
}

void Building::lookAtBuild()
{
    if (looker_.running())
        return;
    if (look_ != nullptr && !showsLook())
        return looking_.stop(); // the user has turned to something else
    looker_.start([this, live = live_, path = lookPath_, target = buildTarget_,
                   isFirst = look_ == nullptr](const Progress&) -> std::function<void()> {
        const auto model = live->look(path);
        OpenedModel opened;
        opened.becomes = target;
        if (model && *model) {
            opened.model = *model;
            opened.field = knownExtentOf(*model);
            opened.view = isFirst ? opening_.views().find(target) : std::nullopt;
        }
        const Result<OpenedModel> look = model ? Result<OpenedModel>(std::move(opened)) : model.error();
        return [this, live, look] {
            if (running() && live == live_)
                showLook(look);
        };
    });
}

void Building::showLook(const Result<OpenedModel>& look)
{
    if (!look)
        return looking_.stop(); // a picture of the build is not worth a message: no room for it, say
    if (look->model == nullptr)
        return;
    const bool isFirst = look_ == nullptr;
    if (isFirst && session_.model())
        return looking_.stop();
    if (!isFirst && !showsLook())
        return;
    look_ = look->model;
    if (isFirst)
        opening_.models().show(*look);
    else
        opening_.models().growTo(*look);
}

/// What was watched has not become a model.
void Building::closeLook()
{
    if (showsLook())
        opening_.models().close();
    look_.reset();
}

/// A model that was watched goes on being shown as it is seen. Another one is shown unless the user has turned to
/// something else or would lose changes by that, or it is a worse one than what is open may be.
void Building::showBuilt(const std::filesystem::path& target, const Result<OpenedModel>& built)
{
    if (!built) {
        closeLook();
        const bool nothingKept = built.error().kind == ErrorKind::Cancelled && wish_->keep;
        const Error error = nothingKept ? Error{ErrorKind::CannotWrite,
                                                Message::say("The build was stopped before there was a mesh of known "
                                                             "error, so there is nothing to keep.")}
                                        : built.error();
        if (error.kind != ErrorKind::Cancelled)
            emit saveFailed(translatedMessage(error.message));
        return emit buildEnded(false);
    }
    const bool isWatched = showsLook();
    const QString path = pathText(built->model->path());
    const bool isBeside = built->model->path() != target;
    const bool isShown =
        isWatched || (!turnedAway_ && !opening_.reading().running() && !opening_.sessionFile().isModified() &&
                      !opening_.sessionFile().saving().running() && !(isBeside && session_.model() != nullptr));
    look_.reset();
    addRecentFile(path);
    emit modelBuilt(path, isShown, isBeside ? pathText(target) : QString());
    if (isWatched)
        opening_.models().growTo(*built);
    else if (isShown)
        opening_.models().show(*built);
    emit buildEnded(true);
}

} // namespace tetra
