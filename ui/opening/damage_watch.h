// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/session.h"

#include <QTimer>

namespace tetra {

/// Tells once of each model that is open when its file turns out to be damaged, which may be found by whatever reads
/// it, or by the thread that checks an old one.
class DamageWatch : public QObject {
    Q_OBJECT
public:
    /// `session` outlives it.
    explicit DamageWatch(Session& session);

signals:
    void damageFound(const tetra::Error& error);

private:
    void restart();
    void check();

    Session& session_;
    QTimer checking_;
};

} // namespace tetra
