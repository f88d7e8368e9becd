// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/edit_to_picture.h"
#include "tests/core/render/scene_parts.h"

#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QTemporaryDir>

#include <algorithm>

namespace tetra {
namespace {

constexpr QSize editedWindowSize(1366, 768);
constexpr int draggedEdits = 60;
constexpr int singleEdits = 15;
constexpr int ignoredEdits = 5; ///< until the window has learnt how long pictures take
constexpr double wantedSeconds = 0.1;
constexpr double mostSeconds = 300; ///< for a picture, before the benchmark gives up

/// Waits until `done`, at work meanwhile as the window is. Returns the seconds.
template <class Done> double secondsUntil(const Done& done)
{
    QElapsedTimer timer;
    timer.start();
    while (!done()) {
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 20);
        if (timer.elapsed() > 1000 * mostSeconds)
            qFatal("The picture that was waited for does not come.");
    }
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
}

/// The same opacities in one colour, so that a picture tells which function it shows.
TransferFunction inColour(TransferFunction function, bool red)
{
    for (ColourPoint& point : function.colours)
        point.colour = red ? std::array<float, 3>{1, 0, 0} : std::array<float, 3>{0, 0, 1};
    return function;
}

/// Whether the picture shows red on the whole, rather than blue.
bool looksRed(const QImage& picture)
{
    const QImage small = picture.scaled(32, 32).convertToFormat(QImage::Format_RGB32);
    long red = 0, blue = 0;
    for (int y = 0; y < small.height(); ++y)
        for (int x = 0; x < small.width(); ++x) {
            red += qRed(small.pixel(x, y));
            blue += qBlue(small.pixel(x, y));
        }
    return red > blue;
}

class EditedWindow {
public:
    EditedWindow(PluginHost& host, const std::filesystem::path& model)
        : workbench_(host, views_.path().toStdString()), window_(workbench_, BackendChoice::Cpu)
    {
        window_.resize(editedWindowSize);
        window_.show();
        window_.open(QString::fromStdString(model.string()));
        secondsUntil([this] { return session().model() != nullptr && settled(); });
        session().setMode("volume");
        secondsUntil([this] { return settled() && testing::partsOf(*window_.viewport().scene()).volume.has_value(); });
    }

    /// Seconds from each edit to the first picture that shows it.
    std::vector<double> edit(bool dragging)
    {
        const TransferFunction before = session().view().appearance.transfer;
        std::vector<double> seconds;
        if (dragging)
            session().beginGesture();
        const int count = dragging ? draggedEdits : singleEdits;
        for (int edit = 0; edit < count; ++edit) {
            const bool red = edit % 2 == 0;
            session().setTransfer(inColour(before, red));
            const double waited = secondsUntil([&] { return looksRed(window_.viewport().picture()) == red; });
            if (edit >= ignoredEdits)
                seconds.push_back(waited);
            if (!dragging)
                secondsUntil([this] { return settled(); });
        }
        session().endGesture();
        session().setTransfer(before);
        secondsUntil([this] { return settled(); });
        return seconds;
    }

    std::uint64_t tetrahedra() { return session().shown()->tetrahedra; }

private:
    Session& session() { return workbench_.session(); }
    bool settled()
    {
        return !workbench_.scenes().sceneBuilder().busy() && window_.viewport().scene() && window_.viewport().settled();
    }

    QTemporaryDir views_; ///< the model is seen as at first
    Workbench workbench_;
    MainWindow window_;
};

BenchCase caseOf(const QString& name, std::vector<double> seconds, std::uint64_t tetrahedra)
{
    BenchCase one;
    one.name = name;
    one.seconds = median(seconds);
    one.yardstick = "a tenth of a second";
    one.yardstickSeconds = wantedSeconds;
    std::ranges::sort(seconds);
    const auto late = std::ranges::count_if(seconds, [](double waited) { return waited > wantedSeconds; });
    one.more = {{"worst_seconds", seconds.back()},
                {"seconds_of_nine_in_ten", seconds[seconds.size() * 9 / 10]},
                {"share_in_time", 1 - static_cast<double>(late) / static_cast<double>(seconds.size())},
                {"tetrahedra", static_cast<qint64>(tetrahedra)}};
    return one;
}

} // namespace

std::vector<BenchCase> editToPicture(PluginHost& host, const std::filesystem::path& model, const QString& name)
{
    EditedWindow window(host, model);
    const std::vector<double> dragged = window.edit(true), single = window.edit(false);
    return {caseOf(name + ", edit to picture while dragging", dragged, window.tetrahedra()),
            caseOf(name + ", edit to first picture, one at a time", single, window.tetrahedra())};
}

} // namespace tetra
