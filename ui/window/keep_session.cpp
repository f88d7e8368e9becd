// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keep_session.h"

#include "ui/session/files.h"
#include "ui/session/message_text.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/lost_offers.h"

#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace tetra {
namespace {

/// From the first change that is not kept yet, so that no more than this is ever lost.
constexpr int keepAfter = 10'000; // milliseconds

/// What was open: the session, or the model.
QString openedName(const SessionDocument& document)
{
    return shownName(document.file.empty() ? document.model : document.file);
}

QString endText(const LostView& lost)
{
    const QString name = openedName(lost.document);
    return lost.wasEnded ? KeepSession::tr("%1 had unsaved changes when TAn was ended.").arg(name)
                         : KeepSession::tr("TAn ended unexpectedly while %1 was open.").arg(name);
}

} // namespace

KeepSession::KeepSession(Workbench& workbench, Viewport& viewport, MessageBar& messages, LostOffers& offers,
                         QWidget* window)
    : QObject(window), workbench_(workbench), viewport_(viewport), messages_(messages), offers_(offers),
      window_(window), lost_(workbench.opening().views().lost())
{
    waiting_.setSingleShot(true);
    waiting_.setInterval(keepAfter);
    connect(&waiting_, &QTimer::timeout, this, &KeepSession::keep);
    const Session* session = &workbench.session();
    connect(session, &Session::modelChanged, this, [this] {
        wasKept_ = false;
        changed();
    });
    connect(session, &Session::modelGrown, this, &KeepSession::changed);
    connect(session, &Session::viewChanged, this, &KeepSession::changed);
    connect(&workbench.opening().reading(), &Reading::aboutToRead, this, [this] {
        if (waiting_.isActive())
            keep(); // it may be opened anew
    });
    connect(&workbench.opening().models(), &ModelOpening::leaving, this, [this] {
        hasEnded_ = false; // the program has gone on, and what was set aside for its end is not wanted
        leave();
    });
    connect(&workbench.opening().models(), &ModelOpening::viewRestored, this, &KeepSession::restored);
    connect(&workbench.opening(), &Opening::pictureOpened, this, &KeepSession::offerPicture);
    connect(&workbench.opening().sessions(), &SessionOpening::modelMissing, this, &KeepSession::offerLocating);
    connect(&workbench.opening().views(), &KeptViews::failed, &messages,
            [&messages](const QString& text) { messages.add(text, MessageSubject::Program); });
    connect(&offers, &LostOffers::restoreClicked, this, [this](int offer) {
        workbench_.opening().sessions().open(lost_.at(static_cast<std::size_t>(offer)).path, SessionSource::Lost);
    });
    connect(&offers, &LostOffers::discardClicked, this, [this](int offer) {
        const std::filesystem::path path = lost_.at(static_cast<std::size_t>(offer)).path;
        removeLost(path);
    });
    // Not before the one that is being restored has been taken out.
    connect(session, &Session::modelChanged, this, &KeepSession::offerInBar, Qt::QueuedConnection);
    offerLost();
}

std::optional<SessionDocument> KeepSession::document() const
{
    auto document = workbench_.opening().sessions().document();
    if (document)
        document->viewSize = {viewport_.width(), viewport_.height()};
    return document;
}

void KeepSession::save(const std::function<void(bool saved)>& then)
{
    hasEnded_ = false;
    if (workbench_.opening().sessionFile().path().empty())
        return saveAs(then);
    if (const auto now = document())
        workbench_.opening().sessionFile().save(workbench_.opening().sessionFile().path(), *now, then);
}

void KeepSession::saveAs(const std::function<void(bool saved)>& then)
{
    if (!workbench_.session().model())
        return;
    const QString proposed = workbench_.opening().sessionFile().path().empty()
                                 ? workbench_.opening().proposedPath(QString(".") + sessionSuffix)
                                 : pathText(workbench_.opening().sessionFile().path());
    askForTextTarget(window_, "sessionDialog", tr("Save Session"), tr("Sessions (*.tansession)"), proposed,
                     [this, then](const QString& path) {
                         if (const auto now = document())
                             workbench_.opening().sessionFile().save(filePath(path), *now, then);
                     });
}

/// A lost view of which not all is shown is offered again the next time: its file is all that there is of it.
void KeepSession::restored(const std::filesystem::path& from, bool isAll)
{
    wasKept_ = true;
    if (isAll)
        removeLost(from);
}

void KeepSession::offerLost()
{
    QList<LostOffer> offers;
    for (const LostView& lost : lost_) {
        const QString model = shownText(QFileInfo(pathText(lost.document.model)).absolutePath().toStdString());
        const QString kept = QLocale().toString(QFileInfo(pathText(lost.path)).lastModified(), QLocale::ShortFormat);
        offers.append(
            {endText(lost), openedName(lost.document), tr("Saved automatically on %1. Model: %2").arg(kept, model)});
    }
    offers_.setOffers(offers);
}

/// The start page is gone: who has ignored its offers still finds them.
void KeepSession::offerInBar()
{
    if (!workbench_.session().model())
        return;
    for (const LostView& lost : std::exchange(lost_, {}))
        messages_.ask(
            endText(lost) + ' ' + tr("Its view can be restored."), tr("&Restore"),
            [this, lost] { workbench_.opening().sessions().open(lost.path, SessionSource::Lost); },
            [this, lost] { removeLost(lost.path); }, MessageSubject::Program);
    offerLost();
}

void KeepSession::removeLost(const std::filesystem::path& path)
{
    workbench_.opening().views().removeLost(path);
    if (std::erase_if(lost_, [&](const LostView& lost) { return lost.path == path; }) > 0)
        offerLost();
}

void KeepSession::offerPicture(const QString& path)
{
    messages_.ask(
        tr("%1 contains the session it was made with, which can be restored.").arg(shownName(filePath(path))),
        tr("&Restore"), [this, path] { workbench_.opening().sessions().open(filePath(path), SessionSource::Picture); },
        [] {});
}

void KeepSession::offerLocating(const std::filesystem::path& session, SessionSource source,
                                const std::filesystem::path& model)
{
    const QString name = shownName(model);
    const QString place = shownText(model.parent_path().string());
    const bool isKept = source == SessionSource::Lost; // by the program, in a file that nobody knows
    const QString folder = isKept ? QString() : QFileInfo(pathText(session)).absolutePath();
    messages_.ask(
        isKept ? tr("The model %1 was not found where it was, in %2.").arg(name, place)
               : tr("The model %1 of %2 was not found where it was, in %3, nor near the session.")
                     .arg(name, shownName(session), place),
        tr("&Locate Model…"),
        [this, session, source, name, folder] {
            askForTextFile(
                window_, "locateDialog", tr("Locate %1").arg(name), tr("Models (*.tan)"),
                [this, session, source](const QString& path) {
                    workbench_.opening().sessions().open(session, source, filePath(path));
                },
                folder);
        },
        [] {}, MessageSubject::File, MessageKind::Problem);
}

void KeepSession::changed()
{
    hasEnded_ = false;
    if (!waiting_.isActive())
        waiting_.start();
}

void KeepSession::keep()
{
    waiting_.stop();
    if (auto now = document()) {
        now->file = workbench_.opening().sessionFile().path();
        workbench_.opening().views().keep(now->file.empty() ? now->model : now->file, *now);
    }
}

void KeepSession::end()
{
    const std::filesystem::path session = workbench_.opening().sessionFile().path();
    auto now = document();
    if (!now || !workbench_.opening().sessionFile().isModified()) {
        leave();
    } else {
        waiting_.stop();
        now->file = session;
        workbench_.opening().views().setAside(session, *now);
    }
    hasEnded_ = true;
}

void KeepSession::leave()
{
    if (hasEnded_)
        return;
    waiting_.stop();
    const bool isTouched = wasKept_ || workbench_.session().undoStack().index() > 0;
    const auto now = document();
    if (!now)
        return;
    const std::filesystem::path& session = workbench_.opening().sessionFile().path();
    KeptViews& views = workbench_.opening().views();
    if (!session.empty() || !isTouched)
        return views.forget(session.empty() ? now->model : session);
    views.keep(now->model, *now);
    views.release();
}

} // namespace tetra
