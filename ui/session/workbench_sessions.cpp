// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions in files: what the workbench has open, and how it is seen.
#include "ui/session/field_extent.h"
#include "ui/session/recent_files.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"
#include "ui/session/workbench.h"

#include <algorithm>

namespace tetra {
namespace {

/// The look of the session, where it says one that is known here; else how the model is looked at first. What settings
/// the session does not have are the renderers' own defaults: how it was seen when it was saved.
Look lookOf(const SessionDocument& document, const std::vector<Provided<Renderer>>& modes, Look look)
{
    if (std::ranges::find(modes, document.look.mode, &Provided<Renderer>::id) != modes.end())
        look.mode = document.look.mode;
    if (!document.look.transfer.points.empty())
        look.transfer = document.look.transfer;
    look.settings = document.look.settings;
    return look;
}

} // namespace

void Workbench::openSession(const std::string& text, const std::filesystem::path& folder,
                            const std::filesystem::path& file)
{
    auto document = sessionFromText(text, folder);
    if (!document)
        return tell({document.error().kind, file.string() + ": " + document.error().text});
    reading_.start([this, file, document = *std::move(document)](const Progress&) -> std::function<void()> {
        const auto model = Model::open(document.model);
        if (!model)
            return [this, error = model.error()] {
                tell({error.kind, "The model of the session cannot be opened. " + error.text});
            };
        return [this, file, document, model = *model, field = extentOf(**model)] {
            showSession(model, field, document);
            if (session_.model() != model)
                return;
            sessionFile_ = file;
            if (!file.empty())
                addRecentFile(pathText(file));
            sessionFound_ = document.found;
        };
    });
}

void Workbench::showSession(const std::shared_ptr<const Model>& model, const FieldExtent& field,
                            const SessionDocument& document)
{
    if (!prepareToShow(model, field))
        return;
    session_.open(model, document.isovalues,
                  lookOf(document, modes_, startingLook(modes_, field, model->description().domain)), document.query);
    session_.restore(document.annotations, document.animation);
    emit sessionOpened(document);
    if (document.identity != 0 && document.identity != modelIdentity(*model))
        emit failed(tr("The model %1 is another one than when the session was saved: it was built anew, or replaced. "
                       "It is shown as the session says, as far as that fits.")
                        .arg(pathText(model->path())));
}

std::optional<SessionDocument> Workbench::sessionDocument() const
{
    if (!session_.model() || showsLook())
        return std::nullopt;
    SessionDocument document;
    document.model = std::filesystem::absolute(session_.model()->path());
    document.identity = modelIdentity(*session_.model());
    document.query = session_.view().query();
    document.look = session_.view().look();
    document.isovalues = session_.view().isovalues();
    document.annotations = session_.view().annotations();
    document.animation = session_.view().animation();
    document.found = sessionFound_;
    return document;
}

void Workbench::saveSession(const std::filesystem::path& target, const SessionDocument& document)
{
    const std::string text = sessionToText(document, std::filesystem::absolute(target).parent_path());
    textFiles_.start([this, target, text](const Progress&) -> std::function<void()> {
        return [this, target, saved = writeTextFile(target, text)] {
            if (!saved)
                return tell(saved.error());
            sessionFile_ = target;
            addRecentFile(pathText(target));
            emit textSaved(pathText(target));
        };
    });
}

} // namespace tetra
