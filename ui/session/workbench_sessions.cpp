// SPDX-License-Identifier: GPL-3.0-or-later
// How a model is seen: at first, as somebody left it, and as a session's file says.
#include "ui/session/field_extent.h"
#include "ui/session/message_text.h"
#include "ui/session/picture_texts.h"
#include "ui/session/recent_files.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"
#include "ui/session/view_picture.h"
#include "ui/session/workbench.h"

namespace tetra {
void Workbench::openSession(const std::filesystem::path& path, SessionSource source)
{
    read([this, path, source](const Progress&) -> std::function<void()> {
        const Result<OpenedModel> opened = openedBySession(path, source);
        if (!opened)
            return tellLater(opened.error());
        return [this, opened = *opened] { passGate(true, [this, opened] { showModel(opened); }); };
    });
}

/// For a worker.
Result<Workbench::OpenedModel> Workbench::openedBySession(const std::filesystem::path& path, SessionSource source) const
{
    const auto text =
        source == SessionSource::Picture ? Result<std::string>(sessionInPicture(path)) : readTextFile(path);
    if (!text)
        return text.error();
    const auto document = sessionFromText(*text, std::filesystem::absolute(path).parent_path());
    if (!document)
        return Error{document.error().kind, Message::say("%1: %2", path.string(), document.error().message)};
    const auto model = Model::open(document->model);
    if (!model)
        return Error{model.error().kind,
                     Message::say("The model of the session cannot be opened. %1", model.error().message)};
    return OpenedModel{*model, extentOf(**model), *document, path, source};
}

void Workbench::showModel(const OpenedModel& opened)
{
    if (!prepareToShow(opened))
        return;
    if (!opened.view) {
        const SessionDocument start = tetra::startingView(modes_, *opened.model, field_);
        return session_.open(opened.model, start.isovalues, start.look);
    }
    const SessionDocument view = restoredView(*opened.view, modes_, *opened.model, field_);
    session_.open(opened.model, view.isovalues, view.look, view.query);
    session_.restore(view.annotations, view.animation);
    if (!opened.from.empty())
        showSession(view, opened);
    emit viewRestored(view, opened.from);
}

/// What a session has beside the view of its model.
void Workbench::showSession(const SessionDocument& document, const OpenedModel& opened)
{
    const bool isLost = opened.source == SessionSource::Lost && !document.file.empty();
    if (opened.source == SessionSource::File || isLost) {
        sessionFound_ = document.found;
        setSessionFile(isLost ? document.file : opened.from);
        addRecentFile(pathText(sessionFile_));
    }
    if (isLost)
        session_.undoStack().resetClean(); // the file does not have what was lost
    if (document.identity != 0 && document.identity != modelIdentity(*opened.model))
        emit failed(tr("The model %1 is another one than when the session was saved: it was built anew, or replaced. "
                       "It is shown as the session says, as far as that fits.")
                        .arg(pathText(opened.model->path())));
}

/// Whether there is a way to show it.
bool Workbench::prepareToShow(const OpenedModel& opened)
{
    auto modes = renderingModes(host_);
    if (modes.empty()) {
        emit failed(tr("No renderer plugin could be loaded, so there is no way to show a model. %1")
                        .arg(translatedMessage(host_.explainMissing(PluginKind::Renderer))));
        return false;
    }
    emit leaving();
    modes_ = std::move(modes);
    field_ = opened.field;
    if (opened.model != look_)
        addRecentFile(pathText(opened.model->path()));
    sceneBuilder_.clear();
    draftBuilder_.clear();
    setSessionFile({});
    return true;
}

std::optional<SessionDocument> Workbench::sessionDocument() const
{
    if (!session_.model() || showsLook())
        return std::nullopt;
    const Model& model = *session_.model();
    SessionDocument document;
    document.model = std::filesystem::absolute(model.path());
    document.identity = modelIdentity(model);
    document.bounds = model.description().bounds;
    document.range = model.description().range;
    document.query = session_.view().query();
    document.look = session_.view().look();
    document.isovalues = session_.view().isovalues();
    document.annotations = session_.view().annotations();
    document.animation = session_.view().animation();
    document.found = sessionFound_;
    return document;
}

/// The changes count as saved from here on, so that those that come while the file is written do not.
void Workbench::saveSession(const std::filesystem::path& target, const SessionDocument& document,
                            const std::function<void(bool saved)>& then)
{
    session_.undoStack().setClean();
    const std::string text = sessionToText(document, std::filesystem::absolute(target).parent_path());
    savingText_.enqueue([this, target, text, then, model = session_.model()](const Progress&) -> std::function<void()> {
        return [this, target, then, model, saved = writeTextFile(target, text)] {
            const bool isOpen = session_.model() == model;
            if (!tellSave(saved)) {
                if (isOpen)
                    session_.undoStack().resetClean();
            } else {
                if (isOpen)
                    setSessionFile(target);
                addRecentFile(pathText(target));
                emit textSaved(pathText(target));
            }
            if (then)
                then(saved.ok());
        };
    });
}

} // namespace tetra
