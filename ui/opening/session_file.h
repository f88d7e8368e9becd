// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/restored_view.h"
#include "ui/opening/opened_model.h"
#include "ui/session/session.h"
#include "ui/work/long_task.h"

#include <QObject>

#include <filesystem>
#include <functional>
#include <span>

namespace tetra {

/// What could not be kept, one sentence after the other, each after a blank.
QString sentencesOf(std::span<const SessionDifference> differences);

/// The file of the session that is open, and saving it.
class SessionFile : public QObject {
    Q_OBJECT
public:
    /// `session` outlives it.
    explicit SessionFile(Session& session) : session_(session) {}

    /// Empty if the session has none.
    const std::filesystem::path& path() const noexcept { return path_; }
    /// Whether the session has changes which are not in its file. A model that is not part of a session has none: how
    /// it is seen is kept by itself.
    bool isModified() const { return !path_.empty() && !session_.undoStack().isClean(); }
    /// The text of that file: what is not known here stays in it.
    const JsonObject& found() const noexcept { return found_; }

    /// What is open has no file of a session any more.
    void clear() { set({}); }
    /// A session was shown: its file is this one's from now on, and what could not be kept of it is told. One of which
    /// not all could be shown stays as it is: saving asks for another file.
    void take(const RestoredView& restored, const OpenedModel& opened);

    /// `then`: with whether it worked. The changes count as saved from here on, so that those that come while the file
    /// is written do not.
    void save(const std::filesystem::path& target, const SessionDocument& document,
              const std::function<void(bool saved)>& then = {});
    LongTask& saving() noexcept { return saving_; }

signals:
    /// It is another one.
    void changed();
    void saved(const QString& path);
    void saveFailed(const QString& text);
    /// Not all of a session could be shown.
    void failed(const QString& text);

private:
    void set(const std::filesystem::path& path);

    Session& session_;
    std::filesystem::path path_;
    JsonObject found_;
    LongTask saving_; ///< last: ends before what it uses
};

} // namespace tetra
