// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/workbench/workbench.h"

#include <QTimer>

namespace tetra {

class LostOffers;
class MessageBar;
class Viewport;

/// Saves the session when the user says so, and keeps in any case how a model is seen: a while after each change, and
/// when something else is opened or the program ends. What a program that ended unexpectedly has left is offered on the
/// start page, and once something is open in the bar of messages; it goes when it is restored or declined, so that
/// ignoring it loses nothing.
class KeepSession : public QObject {
    Q_OBJECT
public:
    /// Everything outlives it.
    KeepSession(Workbench& workbench, Viewport& viewport, MessageBar& messages, LostOffers& offers, QWidget* window);

    /// Into its file, or one that is asked for if it has none. `then`: with whether it was saved; not called if no file
    /// is chosen.
    void save(const std::function<void(bool saved)>& then = {});
    void saveAs(const std::function<void(bool saved)>& then = {});
    /// The session as it would be saved now; nothing without a model.
    std::optional<SessionDocument> document() const;
    /// What is open gives way, or the program ends: its view is kept as it is. The changes of a session are in its
    /// file, or are not wanted.
    void leave();
    /// The program is being ended by somebody who cannot be asked: all is kept as it is, and what a session's file does
    /// not have is offered the next time.
    void end();
    /// Whether that has happened, and nothing has changed since.
    bool hasEnded() const noexcept { return hasEnded_; }

private:
    void restored(const std::filesystem::path& from, bool isAll);
    void offerLost();
    void offerInBar();
    void removeLost(const std::filesystem::path& path);
    void offerPicture(const QString& path);
    void offerLocating(const std::filesystem::path& session, SessionSource source, const std::filesystem::path& model);
    void changed();
    void keep();

    Workbench& workbench_;
    Viewport& viewport_;
    MessageBar& messages_;
    LostOffers& offers_;
    QWidget* window_;
    std::vector<LostView> lost_; ///< that are offered on the start page
    bool hasEnded_ = false;      ///< and nothing has changed since
    bool wasKept_ = false;       ///< how the model is seen that is open, before it was opened
    QTimer waiting_;             ///< from a change until it is kept
};

} // namespace tetra
