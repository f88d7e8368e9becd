// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/recovery.h"
#include "ui/session/workbench.h"

#include <QTimer>

namespace tetra {

class MessageBar;
class Viewport;

/// Saves the session when the user says so, and keeps it in any case: a while after each change, so that it can be
/// restored if the program ends unexpectedly. Offers at the start what was lost.
class KeepSession : public QObject {
    Q_OBJECT
public:
    /// Everything outlives it.
    KeepSession(Workbench& workbench, Viewport& viewport, MessageBar& messages, QWidget* window);

    /// Into its file, or one that is asked for if it has none.
    void save();
    void saveAs();
    /// The session as it would be saved now; nothing without a model.
    std::optional<SessionDocument> document() const;
    /// The program ends as it should: nothing is kept.
    void end();

private:
    void restore(const SessionDocument& document);
    void offerLost();
    void offerPicture(const QString& path, const std::string& session);
    void changed();
    void keep();

    Workbench& workbench_;
    Viewport& viewport_;
    MessageBar& messages_;
    QWidget* window_;
    Recovery recovery_;
    QTimer waiting_; ///< from a change until it is kept
    bool told_ = false;
    LongTask keeping_; ///< ends before the file goes
};

} // namespace tetra
