// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/opening/session_opening.h"

#include "core/picture/session_model.h"
#include "core/view/view_value.h"
#include "ui/session/files.h"

#include <tan/open.h>

#include <utility>

namespace tetra {

SessionOpening::SessionOpening(Session& session, SceneService& scenes, SessionFile& file, ModelOpening& models,
                               Reading& reading)
    : session_(session), scenes_(scenes), file_(file), models_(models), reading_(reading)
{
    connect(&session_, &Session::modelChanged, this, [this] { ++opened_; });
}

void SessionOpening::open(const std::filesystem::path& path, SessionSource source, const std::filesystem::path& located)
{
    models_.read([this, path, source, located](const ModelOpening::ComingModel& coming,
                                               const Progress& progress) -> std::function<void()> {
        auto document = readSession(path);
        if (!document)
            return reading_.tellLater(document.error());
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
        return models_.whenRead({.place = *model, .as = as, .again = [this, path, source] { open(path, source); }},
                                coming, progress);
    });
}

void SessionOpening::applyLook(const std::filesystem::path& path)
{
    if (!session_.model())
        return;
    applying_.start([this, path, opened = opened_](const Progress&) -> std::function<void()> {
        const auto document = readSession(path);
        if (!document)
            return [this, error = document.error()] { reading_.tell(error); };
        return [this, path, opened, look = *document] {
            if (opened_ == opened) // else the user has turned to something else
                apply(path, look);
        };
    });
}

void SessionOpening::apply(const std::filesystem::path& path, const SessionDocument& look)
{
    const std::shared_ptr<const Model> model = session_.model(); // which may have grown meanwhile
    SessionDocument taken = look;
    taken.view.bookmarks.clear(); // this model has its own
    const RestoredView restored = restoredView(std::move(taken), scenes_.modes(), *model, scenes_.extent());
    ViewValue view = restored.document.view;
    if (!look.hasCamera)
        view.camera = session_.view().camera;
    else if (!restored.document.hasCamera)
        view.camera = framed(view, model->description().bounds, scenes_.framedObject(view), session_.shape());
    view.tools = session_.view().tools; // what was measured in these data is no look
    view.bookmarks = session_.view().bookmarks;
    session_.setView(view, tr("Apply Look"));
    if (!restored.differences.empty())
        emit failed(tr("Not all of the look of %1 could be applied.").arg(shownName(path)) +
                    sentencesOf(restored.differences));
}

std::optional<SessionDocument> SessionOpening::document() const
{
    if (!session_.model() || !models_.becomes().empty())
        return std::nullopt;
    const Model& model = *session_.model();
    SessionDocument document = documentOf(model, session_.view());
    if (models_.sitesOfWhole() != 0)
        document.identity = 0;
    document.found = file_.found();
    return document;
}

} // namespace tetra
