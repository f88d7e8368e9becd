// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/leaving.h"

#include "plugins/widgets/number_text.h"
#include "ui/session/files.h"

#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace tetra {
namespace {

constexpr int savingPatience = 300; // milliseconds

class Question {
public:
    Question(QWidget* window, const char* name, const QString& title, const QString& text, const QString& more)
        : box_(new QMessageBox(QMessageBox::Question, title, text, QMessageBox::NoButton, window))
    {
        box_->setObjectName(QString("leaving.") + name);
        box_->setAttribute(Qt::WA_DeleteOnClose);
        box_->setTextFormat(Qt::PlainText);
        box_->setInformativeText(more);
    }
    Question& add(const char* name, const QString& text, QMessageBox::ButtonRole role)
    {
        QPushButton* button = box_->addButton(text, role);
        button->setObjectName(QString("leaving.") + name);
        if (box_->defaultButton() == nullptr)
            box_->setDefaultButton(button);
        if (role == QMessageBox::RejectRole)
            box_->setEscapeButton(button);
        return *this;
    }
    QMessageBox* show()
    {
        box_->open();
        return box_;
    }

private:
    QMessageBox* box_;
};

QString progressText(const TaskProgress& progress)
{
    const int percent = static_cast<int>(100 * progress.fraction);
    return progress.remainingSeconds
               ? Leaving::tr("%1 % done, about %2 left.").arg(percent).arg(durationText(*progress.remainingSeconds))
               : Leaving::tr("%1 % done.").arg(percent);
}

/// What can be kept, and where.
QString keptText(const LeavingFacts& facts)
{
    if (!facts.keepsBeside)
        return Leaving::tr("If you stop now, you can keep what is finished as %1, a model of lower accuracy.")
            .arg(facts.target);
    return Leaving::tr("If you stop now, you can keep what is finished as a separate model, named after its error. The "
                       "finished model %1 is not changed.")
        .arg(facts.target);
}

} // namespace

QString buildDetails(const LeavingFacts& facts)
{
    QStringList more{facts.progress};
    const bool quits = facts.way == LeavingWay::Quit;
    const bool pauses = quits && facts.canPause;
    if (!quits)
        more << Leaving::tr("It can continue in the background.");
    if (pauses)
        more << Leaving::tr("You can resume it when you open these data again.");
    if (facts.canKeep)
        more << keptText(facts);
    else if (!pauses)
        more << Leaving::tr("Nothing can be kept yet.");
    return more.join(' ');
}

QMessageBox* askAboutBuild(const LeavingFacts& facts, QWidget* window)
{
    const bool quits = facts.way == LeavingWay::Quit;
    const bool pauses = quits && facts.canPause;
    Question question(window, "build", Leaving::tr("Build in Progress"),
                      Leaving::tr("The model of %1 is still being built.").arg(facts.name), buildDetails(facts));
    question.add("goOn", Leaving::tr("&Continue Building"), quits ? QMessageBox::RejectRole : QMessageBox::AcceptRole);
    if (pauses)
        question.add("pause", Leaving::tr("Quit and &Resume Later"), QMessageBox::AcceptRole);
    if (facts.canKeep)
        question.add("keep", Leaving::tr("Stop and &Keep"), QMessageBox::AcceptRole);
    question.add("discard", Leaving::tr("&Discard Build"), QMessageBox::DestructiveRole);
    if (!quits)
        question.add("cancel", Leaving::tr("Cancel"), QMessageBox::RejectRole);
    return question.show();
}

QMessageBox* askAboutKeeping(const LeavingFacts& facts, QWidget* window)
{
    return Question(window, "keeping", Leaving::tr("Stop and Keep"),
                    Leaving::tr("Stop the build of %1 and keep what is finished?").arg(facts.target),
                    facts.progress + ' ' + keptText(facts))
        .add("cancel", Leaving::tr("&Continue Building"), QMessageBox::RejectRole)
        .add("keep", Leaving::tr("Stop and &Keep"), QMessageBox::AcceptRole)
        .show();
}

QMessageBox* askAboutFilm(const LeavingFacts& facts, QWidget* window)
{
    const bool quits = facts.way == LeavingWay::Quit;
    QStringList more{facts.progress};
    if (!quits)
        more << Leaving::tr("It can continue in the background.");
    more << Leaving::tr("If you stop it, nothing is kept.");
    Question question(window, "film", Leaving::tr("Film in Progress"),
                      Leaving::tr("The film %1 is still being written.").arg(facts.name), more.join(' '));
    question.add("goOn", Leaving::tr("&Continue Writing"), quits ? QMessageBox::RejectRole : QMessageBox::AcceptRole);
    question.add("discard", Leaving::tr("&Discard Film"), QMessageBox::DestructiveRole);
    if (!quits)
        question.add("cancel", Leaving::tr("Cancel"), QMessageBox::RejectRole);
    return question.show();
}

QMessageBox* askAboutSession(const LeavingFacts& facts, QWidget* window)
{
    return Question(window, "session", Leaving::tr("Unsaved Changes"),
                    Leaving::tr("The session %1 has unsaved changes.").arg(facts.name),
                    Leaving::tr("Your changes will be lost if you do not save them."))
        .add("save", Leaving::tr("&Save"), QMessageBox::AcceptRole)
        .add("discard", Leaving::tr("&Discard"), QMessageBox::DestructiveRole)
        .add("cancel", Leaving::tr("Cancel"), QMessageBox::RejectRole)
        .show();
}

QMessageBox* askAboutSaving(LeavingWay way, QWidget* window)
{
    const bool quits = way == LeavingWay::Quit;
    return Question(window, "saving", Leaving::tr("Saving"), Leaving::tr("A file is still being saved."),
                    quits ? Leaving::tr("TAn will quit when this is done.")
                          : Leaving::tr("TAn will continue when this is done."))
        .add("cancel", quits ? Leaving::tr("&Do Not Quit") : Leaving::tr("Cancel"), QMessageBox::RejectRole)
        .add("discard", quits ? Leaving::tr("&Quit Without Saving") : Leaving::tr("&Continue Without Saving"),
             QMessageBox::DestructiveRole)
        .show();
}

Leaving::Leaving(Workbench& workbench, KeepSession& session, QWidget* window)
    : QObject(window), workbench_(workbench), session_(session), window_(window)
{
    connect(&workbench.building().task(), &LongTask::started, this, [this] {
        built_ = {};
        buildGoesOn_ = false;
    });
    connect(&workbench.exporting().savingFilm(), &LongTask::started, this, [this] {
        filmed_ = {};
        filmGoesOn_ = false;
    });
    connect(&workbench.building().task(), &LongTask::progressed, this, &Leaving::showProgress);
    connect(&workbench.building().task(), &LongTask::finished, this, [this] {
        if (keeping_)
            keeping_->reject(); // there is nothing to decide
    });
    connect(&workbench.exporting().savingFilm(), &LongTask::progressed, this,
            [this](const TaskProgress& now) { filmed_ = now; });
    connect(&workbench.building(), &Building::buildEnded, this, &Leaving::next);
    // Not before their outcome is told.
    Exporting& files = workbench.exporting();
    for (LongTask* task : {&files.savingFilm(), &files.savingPicture(), &files.savingMesh(), &files.savingPacked(),
                           &files.savingText(), &workbench.opening().sessionFile().saving()})
        connect(task, &LongTask::finished, this, &Leaving::next, Qt::QueuedConnection);
    connect(&workbench, &Workbench::saveFailed, this, &Leaving::stay);
    patience_.setSingleShot(true);
    patience_.setInterval(savingPatience);
    connect(&patience_, &QTimer::timeout, this, [this] { show(Obstacle::Saving); });
}

Leaving::Obstacle Leaving::obstacle(LeavingWay way) const
{
    const bool quits = way == LeavingWay::Quit;
    const bool endsBuild = way != LeavingWay::Close || workbench_.building().showsBuild();
    if (workbench_.building().running() && endsBuild && (quits || !buildGoesOn_))
        return Obstacle::Build;
    if (workbench_.exporting().savingFilm().running() && (quits || !filmGoesOn_))
        return Obstacle::Film;
    if (savesSession_ ||
        (workbench_.opening().sessionFile().isModified() && way != LeavingWay::OpenDataset && !discards_))
        return Obstacle::Session;
    // Until it is written the session counts as saved, and is not.
    const LongTask& session = workbench_.opening().sessionFile().saving();
    const bool savesSession = session.running() || session.waiting() > 0; // none runs between two
    const bool savesFile = quits ? workbench_.saving() : way != LeavingWay::OpenDataset && savesSession;
    return savesFile ? Obstacle::Saving : Obstacle::None;
}

void Leaving::ask(LeavingWay way, const std::function<void()>& go, const std::function<void()>& stays)
{
    stay(); // of what was asked before
    wish_ = Wish{way, go, stays};
    next();
}

/// Asks about what is in the way now, unless it is asked already or is about to go.
void Leaving::next()
{
    if (!wish_)
        return;
    const Obstacle now = obstacle(wish_->way);
    if (now == asked_ && now != Obstacle::None)
        return;
    closeBox();
    asked_ = now;
    if (now == Obstacle::Saving)
        return patience_.start();
    if (now != Obstacle::None)
        return show(now);
    discards_ = false;
    std::exchange(wish_, std::nullopt)->go();
}

void Leaving::closeBox()
{
    patience_.stop();
    if (!box_)
        return;
    box_->disconnect(this);
    box_->close(); // and goes
    box_ = nullptr;
}

void Leaving::stay()
{
    closeBox();
    asked_ = Obstacle::None;
    discards_ = false;
    savesSession_ = false;
    if (const auto wish = std::exchange(wish_, std::nullopt))
        wish->stay();
}

LeavingFacts Leaving::buildFacts(LeavingWay way) const
{
    const Building& building = workbench_.building();
    LeavingFacts facts;
    facts.way = way;
    facts.name = building.buildName();
    facts.progress = progressText(built_);
    facts.target = shownName(building.buildTarget());
    facts.keepsBeside = building.keepsBeside();
    facts.canKeep = building.canKeepBuild();
    facts.canPause = building.canPauseBuild();
    return facts;
}

/// A question about the build that is being asked goes on telling how far it is.
void Leaving::showProgress(const TaskProgress& now)
{
    built_ = now;
    if (box_ && asked_ == Obstacle::Build) {
        LeavingFacts facts = buildFacts(wish_->way);
        facts.canKeep = box_->findChild<QAbstractButton*>("leaving.keep") != nullptr; // what can be chosen
        box_->setInformativeText(buildDetails(facts));
    }
    if (keeping_) {
        const LeavingFacts facts = buildFacts(LeavingWay::Close);
        keeping_->setInformativeText(facts.progress + ' ' + keptText(facts));
    }
}

void Leaving::keepBuild()
{
    Building& building = workbench_.building();
    if (keeping_ || !building.running())
        return;
    if (!building.canKeepBuild() || !building.keepsBeside())
        return building.stopBuild(BuildEnd::Keep);
    keeping_ = askAboutKeeping(buildFacts(LeavingWay::Close), window_);
    connect(keeping_, &QMessageBox::finished, this, [this, box = keeping_.data()] {
        keeping_ = nullptr;
        if (box->clickedButton() != nullptr && box->clickedButton()->objectName() == "leaving.keep")
            workbench_.building().stopBuild(BuildEnd::Keep);
    });
}

LeavingFacts Leaving::facts(Obstacle obstacle) const
{
    const auto nameOf = [](const std::filesystem::path& path) { return pathText(path.filename()); };
    LeavingFacts facts;
    facts.way = wish_->way;
    if (obstacle == Obstacle::Build) {
        facts = buildFacts(wish_->way);
    } else if (obstacle == Obstacle::Film) {
        facts.name = nameOf(workbench_.exporting().filmTarget());
        facts.progress = progressText(filmed_);
    } else {
        facts.name = nameOf(workbench_.opening().sessionFile().path());
    }
    return facts;
}

void Leaving::show(Obstacle obstacle)
{
    const LeavingFacts named = facts(obstacle);
    switch (obstacle) {
    case Obstacle::Build: box_ = askAboutBuild(named, window_); break;
    case Obstacle::Film: box_ = askAboutFilm(named, window_); break;
    case Obstacle::Session: box_ = askAboutSession(named, window_); break;
    case Obstacle::Saving: box_ = askAboutSaving(named.way, window_); break;
    case Obstacle::None: return;
    }
    connect(box_, &QMessageBox::finished, this, [this, box = box_.data()] {
        box_ = nullptr;
        const QAbstractButton* button = box->clickedButton();
        answer(button != nullptr ? button->objectName() : QString("leaving.cancel"));
    });
}

void Leaving::answer(const QString& button)
{
    const bool quits = wish_->way == LeavingWay::Quit;
    if (button == "leaving.cancel" || (button == "leaving.goOn" && quits))
        return stay();
    switch (asked_) {
    case Obstacle::Build: return answerBuild(button);
    case Obstacle::Film: return answerFilm(button);
    case Obstacle::Session: return answerSession(button);
    case Obstacle::Saving: return std::exchange(wish_, std::nullopt)->go();
    case Obstacle::None: break;
    }
}

/// What is stopped is waited for.
void Leaving::answerBuild(const QString& button)
{
    if (button != "leaving.goOn")
        return workbench_.building().stopBuild(button == "leaving.keep"    ? BuildEnd::Keep
                                               : button == "leaving.pause" ? BuildEnd::Pause
                                                                           : BuildEnd::Discard);
    buildGoesOn_ = true;
    next();
}

void Leaving::answerFilm(const QString& button)
{
    if (button != "leaving.goOn")
        return workbench_.exporting().savingFilm().cancel();
    filmGoesOn_ = true;
    next();
}

void Leaving::answerSession(const QString& button)
{
    discards_ = button == "leaving.discard";
    if (discards_)
        return next();
    savesSession_ = true;
    session_.save([this](bool) {
        savesSession_ = false;
        asked_ = Obstacle::None; // there may be changes again
        next();
    });
}

} // namespace tetra
