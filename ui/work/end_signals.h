// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSocketNotifier>

namespace tetra {

/// Tells the event loop of a signal that asks the program to end: SIGTERM, SIGINT or SIGHUP, unless whoever started it
/// has it ignore that one, as nohup does. A second one ends the process at once. One in a process.
class EndSignals : public QObject {
    Q_OBJECT
public:
    explicit EndSignals(QObject* parent = nullptr);
    /// The signals do again what they did before.
    ~EndSignals() override;

signals:
    void endWanted();

private:
    QSocketNotifier notifier_;
};

} // namespace tetra
