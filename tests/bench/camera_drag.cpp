// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/camera_drag.h"

#include "ui/viewport/camera_controls.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <vector>

namespace tetra {
namespace {

constexpr QSize windowSize(1366, 768);
constexpr int rounds = 15;
constexpr int moves = 500; ///< of a drag

class DraggedWindow {
public:
    DraggedWindow(PluginHost& host, const std::filesystem::path& model)
        : workbench_(host, views_.path().toStdString()), window_(workbench_, BackendChoice::Cpu)
    {
        window_.resize(windowSize);
        window_.show();
        window_.open(QString::fromStdString(model.string()));
        while (!workbench_.session().model() || !viewport().scene() || !viewport().settled())
            QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
    }

    /// Seconds for a move: all that the window does at once, which is everything but the picture.
    double secondsOfMove();
    int undoSteps() { return workbench_.session().undoStack().count(); }

private:
    Viewport& viewport() { return window_.viewport(); }

    QTemporaryDir views_; ///< the model is seen as at first
    Workbench workbench_;
    MainWindow window_;
};

double DraggedWindow::secondsOfMove()
{
    QElapsedTimer timer;
    timer.start();
    for (int move = 0; move < moves; ++move)
        viewport().setCamera(turnedByDrag(viewport().camera(), {}, {1, 0.1}, viewport().size()));
    const double seconds = static_cast<double>(timer.nsecsElapsed()) * 1e-9 / moves;
    QCoreApplication::processEvents();
    return seconds;
}

} // namespace

BenchCase cameraDrag(PluginHost& host, const std::filesystem::path& model, const QString& name)
{
    DraggedWindow window(host, model);
    std::vector<double> seconds;
    for (int round = 0; round < rounds; ++round)
        seconds.push_back(window.secondsOfMove());
    return {.name = name + ", a move of a camera drag with its undo step",
            .seconds = median(seconds),
            .yardstick = {},
            .more = {{"undo_steps", window.undoSteps()}}};
}

} // namespace tetra
