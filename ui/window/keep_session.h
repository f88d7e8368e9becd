// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/recovery.h"
#include "ui/session/workbench.h"

#include <QTimer>

namespace tetra {

class LostOffers;
class MessageBar;
class Viewport;

/// Saves the session when the user says so, and keeps it in any case: a while after each change, so that it can be
/// restored if the program ends unexpectedly. What was lost is offered on the start page, and once something is open in
/// the bar of messages. Its file goes when it is restored or declined, so that ignoring it loses nothing.
class KeepSession : public QObject {
    Q_OBJECT
public:
    /// Everything outlives it.
    KeepSession(Workbench& workbench, Viewport& viewport, MessageBar& messages, LostOffers& offers, QWidget* window);

    /// Into its file, or one that is asked for if it has none.
    void save();
    void saveAs();
    /// The session as it would be saved now; nothing without a model.
    std::optional<SessionDocument> document() const;
    /// The program ends as it should: nothing is kept.
    void end();

private:
    void restore(const SessionDocument& document);
    void findLost();
    void offerLost();
    void offerInBar();
    void restoreLost(const LostSession& lost);
    void forgetLost(const std::filesystem::path& path);
    void offerPicture(const QString& path, const std::string& session);
    void changed();
    void keep();

    Workbench& workbench_;
    Viewport& viewport_;
    MessageBar& messages_;
    LostOffers& offers_;
    QWidget* window_;
    Recovery recovery_;
    std::vector<LostSession> lost_;        ///< that are offered on the start page
    std::optional<LostSession> restoring_; ///< the one that is being opened
    QTimer waiting_;                       ///< from a change until it is kept
    bool told_ = false;
    LongTask keeping_; ///< ends before the file goes
};

} // namespace tetra
