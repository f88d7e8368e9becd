// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/keep_session.h"

#include <QPointer>

class QMessageBox;

namespace tetra {

/// Why somebody may lose work.
enum class LeavingWay {
    OpenDataset, ///< beside the model that is seen
    OpenModel,   ///< in its place
    Close,
    Quit,
};

/// What a question names.
struct LeavingFacts {
    LeavingWay way = LeavingWay::Quit;
    QString name;             ///< of the dataset, the film, the session
    QString progress;         ///< a sentence: how far it is
    QString target;           ///< of a build
    bool keepsBeside = false; ///< what is kept of it does not take the target's place
    bool canKeep = false;
    bool canPause = false;
};

/// The questions, with buttons named leaving.goOn, .pause, .keep, .save, .discard and .cancel as far as they have them.
/// Owned by the window; they go when they are answered.
QMessageBox* askAboutBuild(const LeavingFacts& facts, QWidget* window);
/// Whether the build is to be stopped for what is finished of it, beside a finished model. For one that somebody means
/// to replace, that is a surprise.
QMessageBox* askAboutKeeping(const LeavingFacts& facts, QWidget* window);
QMessageBox* askAboutFilm(const LeavingFacts& facts, QWidget* window);
QMessageBox* askAboutSession(const LeavingFacts& facts, QWidget* window);
QMessageBox* askAboutSaving(LeavingWay way, QWidget* window);

/// What the question about a build says beside its title: how far it is, and what can become of it.
QString buildDetails(const LeavingFacts& facts);

/// Asks before work is lost, one thing after the other: a build and a film that run, changes of a session that are not
/// saved, and files that are still being written, which it waits for: the session's before its model goes, all of them
/// when the program is to end. A build and a film can
/// go on behind something else that is opened; that is asked once for each of them. How a model is seen is no matter of
/// a question, as it is kept by itself.
class Leaving : public QObject {
    Q_OBJECT
public:
    /// Everything outlives it.
    Leaving(Workbench& workbench, KeepSession& session, QWidget* window);

    /// Whether nothing would be lost.
    bool isFree(LeavingWay way) const { return obstacle(way) == Obstacle::None; }
    /// Calls `go` when nothing would be lost any more, or is to be lost: at once if it is free. Calls `stay` if the
    /// user wants that, if something was to be saved and could not be, or if something else is asked meanwhile.
    void ask(
        LeavingWay way, const std::function<void()>& go, const std::function<void()>& stay = [] {});

    /// Stops the build that runs and keeps what is finished. Asks first if there is a finished model in its place.
    void keepBuild();

private:
    enum class Obstacle { None, Build, Film, Session, Saving };
    struct Wish {
        LeavingWay way;
        std::function<void()> go;
        std::function<void()> stay;
    };

    Obstacle obstacle(LeavingWay way) const;
    void next();
    void stay();
    void closeBox();
    void show(Obstacle obstacle);
    LeavingFacts facts(Obstacle obstacle) const;
    LeavingFacts buildFacts(LeavingWay way) const;
    void showProgress(const TaskProgress& now);
    void answer(const QString& button);
    void answerBuild(const QString& button);
    void answerFilm(const QString& button);
    void answerSession(const QString& button);

    Workbench& workbench_;
    KeepSession& session_;
    QWidget* window_;
    std::optional<Wish> wish_;
    Obstacle asked_ = Obstacle::None;
    QPointer<QMessageBox> box_;
    QPointer<QMessageBox> keeping_; ///< the question of keepBuild()
    bool buildGoesOn_ = false;      ///< the user said so
    bool filmGoesOn_ = false;
    bool discards_ = false;     ///< the changes of the session
    bool savesSession_ = false; ///< the user said so; its changes can be lost until the file is written
    TaskProgress built_;
    TaskProgress filmed_;
    QTimer patience_; ///< with files being written, before a word about them
};

} // namespace tetra
