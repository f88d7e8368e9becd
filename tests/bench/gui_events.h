// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "plugins/host/plugin_host.h"
#include "tests/bench/bench_report.h"
#include "ui/viewport/canvas.h"

#include <QApplication>
#include <QEvent>

#include <filesystem>
#include <optional>
#include <vector>

namespace tetra {

/// An event that the GUI thread has handled.
struct HandledEvent {
    double seconds = 0; ///< of the processor
    QEvent::Type type = QEvent::None;
    QString receiver; ///< its class, and its object name if it has one
};

/// An application that knows what its GUI thread takes for each event. What is sent while another event is handled
/// belongs to that one.
class TimedApplication : public QApplication {
public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
    /// Of all events from now on.
    void beginTiming() { timed_.emplace(); }
    /// Of the events since then, in their order.
    std::vector<HandledEvent> endTiming();

private:
    std::optional<std::vector<HandledEvent>> timed_; ///< the GUI thread's
    bool isInside_ = false;                          ///< an event is being handled
};

/// What the window takes for its events while somebody tries everything in it: `acts` random edits, drags in the
/// picture and keys on controls of docks. None if there is no such canvas here: OpenGL needs a display.
std::optional<BenchCase> eventsOfTheWindow(TimedApplication& application, PluginHost& host,
                                           const std::filesystem::path& model, const QString& name,
                                           BackendChoice canvas, int acts);

} // namespace tetra
