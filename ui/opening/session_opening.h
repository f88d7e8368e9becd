// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/opening/model_opening.h"

namespace tetra {

/// Opens sessions, and shows one model as another was seen.
class SessionOpening : public QObject {
    Q_OBJECT
public:
    /// All outlive it; `reading` need not be there before something is read.
    SessionOpening(Session& session, SceneService& scenes, SessionFile& file, ModelOpening& models, Reading& reading);

    /// Opens what a session says that the file holds; with the model `located`, if the user has said where it is.
    void open(const std::filesystem::path& path, SessionSource source, const std::filesystem::path& located = {});
    /// Shows the model that is open as a session or a picture that holds one was seen, in one edit.
    void applyLook(const std::filesystem::path& path);
    /// What is open and how it is seen; nothing without a model, or while a build is watched. The size of the view is
    /// the window's.
    std::optional<SessionDocument> document() const;

signals:
    /// The model of a session is not to be found; open() can be told where it is.
    void modelMissing(const std::filesystem::path& session, tetra::SessionSource source,
                      const std::filesystem::path& model);
    /// Not all of a look could be applied.
    void failed(const QString& text);

private:
    void apply(const std::filesystem::path& path, const SessionDocument& look);

    Session& session_;
    SceneService& scenes_;
    SessionFile& file_;
    ModelOpening& models_;
    Reading& reading_;
    quint64 opened_ = 0; ///< how many models were opened or closed; one that grows stays the same
    LongTask applying_;  ///< last: ends before what it uses
};

} // namespace tetra
