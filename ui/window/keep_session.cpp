// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/keep_session.h"

#include "ui/session/sentences.h"
#include "ui/session/target_path.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/lost_offers.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <utility>

namespace tetra {
namespace {

/// From the first change that is not kept yet, so that no more than this is ever lost.
constexpr int keepAfter = 10'000; // milliseconds

/// The file of the model; empty if the text is none of a session.
QFileInfo modelOf(const LostSession& lost, const std::filesystem::path& folder)
{
    const auto document = sessionFromText(lost.text, folder);
    return document ? QFileInfo(pathText(document->model)) : QFileInfo();
}

} // namespace

KeepSession::KeepSession(Workbench& workbench, Viewport& viewport, MessageBar& messages, LostOffers& offers,
                         QWidget* window)
    : QObject(window), workbench_(workbench), viewport_(viewport), messages_(messages), offers_(offers),
      window_(window), recovery_(recoveryFolder())
{
    waiting_.setSingleShot(true);
    waiting_.setInterval(keepAfter);
    connect(&waiting_, &QTimer::timeout, this, &KeepSession::keep);
    const Session* session = &workbench.session();
    const ViewState* view = &session->view();
    connect(session, &Session::modelChanged, this, &KeepSession::changed);
    connect(view, &ViewState::queryChanged, this, &KeepSession::changed);
    connect(view, &ViewState::lookChanged, this, &KeepSession::changed);
    connect(view, &ViewState::isovalueInserted, this, &KeepSession::changed);
    connect(view, &ViewState::isovalueRemoved, this, &KeepSession::changed);
    connect(view, &ViewState::isovalueChanged, this, &KeepSession::changed);
    connect(view, &ViewState::annotationsChanged, this, &KeepSession::changed);
    connect(view, &ViewState::animationChanged, this, &KeepSession::changed);
    connect(&viewport, &Viewport::cameraChanged, this, &KeepSession::changed);
    connect(&viewport, &Viewport::backgroundChanged, this, &KeepSession::changed);
    connect(&workbench, &Workbench::sessionOpened, this, &KeepSession::restore);
    connect(&workbench, &Workbench::pictureOpened, this, &KeepSession::offerPicture);
    connect(&offers, &LostOffers::restoreClicked, this,
            [this](int offer) { restoreLost(lost_.at(static_cast<std::size_t>(offer))); });
    connect(&offers, &LostOffers::discardClicked, this, [this](int offer) {
        const std::filesystem::path path = lost_.at(static_cast<std::size_t>(offer)).path;
        removeLostSession(lost_.at(static_cast<std::size_t>(offer)));
        forgetLost(path);
    });
    // Not before the one that is being restored has been taken out.
    connect(session, &Session::modelChanged, this, &KeepSession::offerInBar, Qt::QueuedConnection);
    findLost();
}

std::optional<SessionDocument> KeepSession::document() const
{
    auto document = workbench_.sessionDocument();
    if (document) {
        document->camera = viewport_.camera();
        document->background = viewport_.chosenBackground();
    }
    return document;
}

void KeepSession::save()
{
    if (workbench_.sessionFile().empty())
        return saveAs();
    if (const auto now = document())
        workbench_.saveSession(workbench_.sessionFile(), *now);
}

void KeepSession::saveAs()
{
    if (!workbench_.session().model())
        return;
    const QString proposed = workbench_.sessionFile().empty() ? workbench_.proposedPath(QString(".") + sessionSuffix)
                                                              : pathText(workbench_.sessionFile());
    askForTextTarget(window_, "sessionDialog", tr("Save Session"), tr("Sessions (*.tansession)"), proposed,
                     [this](const QString& path) {
                         if (const auto now = document())
                             workbench_.saveSession(filePath(path), *now);
                     });
}

void KeepSession::end()
{
    waiting_.stop();
    if (!keeping_.running()) // else the file goes when that has ended
        recovery_.forget();
}

void KeepSession::restore(const SessionDocument& document)
{
    viewport_.startFrom(document.camera.value_or(viewport_.camera()), document.background);
    if (!restoring_)
        return;
    const LostSession lost = *std::exchange(restoring_, std::nullopt);
    const auto wanted = sessionFromText(lost.text, recovery_.folder());
    if (!wanted || wanted->found != document.found)
        return; // that could not be opened, and this is another one
    removeLostSession(lost);
    forgetLost(lost.path);
}

void KeepSession::findLost()
{
    lost_ = lostSessions(recovery_.folder());
    offerLost();
}

void KeepSession::offerLost()
{
    QList<LostOffer> offers;
    for (const LostSession& lost : lost_) {
        const QFileInfo model = modelOf(lost, recovery_.folder());
        const QString kept = QLocale().toString(QFileInfo(pathText(lost.path)).lastModified(), QLocale::ShortFormat);
        offers.append(
            {model.fileName(),
             tr("Kept on %1. The model lies in %2.").arg(kept, QDir::toNativeSeparators(model.absolutePath()))});
    }
    offers_.setOffers(offers);
}

/// The start page is gone: who has ignored its offers still finds them.
void KeepSession::offerInBar()
{
    if (!workbench_.session().model())
        return;
    for (const LostSession& lost : std::exchange(lost_, {}))
        messages_.ask(
            tr("TAn ended unexpectedly while %1 was open. How it was seen can be restored.")
                .arg(modelOf(lost, recovery_.folder()).fileName()),
            tr("&Restore"), [this, lost] { restoreLost(lost); }, [lost] { removeLostSession(lost); });
    offerLost();
}

void KeepSession::restoreLost(const LostSession& lost)
{
    restoring_ = lost;
    workbench_.openSession(lost.text, recovery_.folder());
}

void KeepSession::forgetLost(const std::filesystem::path& path)
{
    std::erase_if(lost_, [&](const LostSession& lost) { return lost.path == path; });
    offerLost();
}

void KeepSession::offerPicture(const QString& path, const std::string& session)
{
    messages_.ask(
        tr("%1 holds the view that it shows, which can be restored.").arg(QFileInfo(path).fileName()), tr("&Restore"),
        [this, path, session] {
            workbench_.openSession(session, std::filesystem::absolute(filePath(path)).parent_path());
        },
        [] {});
}

void KeepSession::changed()
{
    if (!waiting_.isActive())
        waiting_.start();
}

void KeepSession::keep()
{
    const auto now = document();
    if (keeping_.running())
        return waiting_.start();
    if (!now)
        return recovery_.forget();
    keeping_.start([this, text = sessionToText(*now, recovery_.folder())](const Progress&) -> std::function<void()> {
        return [this, kept = recovery_.keep(text)] {
            if (!kept && !told_)
                messages_.add(translatedSentence(kept.error().text));
            told_ = !kept;
        };
    });
}

} // namespace tetra
