// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/bench/gui_events.h"
#include "tests/ui/random_edits.h"

#include "ui/viewport/viewport.h"
#include "ui/window/docks.h"
#include "ui/window/main_window.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMetaEnum>
#include <QMouseEvent>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>
#include <array>
#include <functional>
#include <random>
#include <utility>

#include <time.h>

namespace tetra {
namespace {

constexpr QSize usedWindowSize(1366, 768);
constexpr double allowedEventSeconds = 0.05;
constexpr std::size_t toldEvents = 5; ///< the slowest
constexpr unsigned mostDragSteps = 10;
constexpr unsigned longestDragStep = 20; ///< pixels
constexpr qint64 betweenActs = 5;        ///< milliseconds, in which the window works on
constexpr int actsBetweenRests = 40;     ///< after which fine pictures come
constexpr qint64 longestRest = 2'000;    ///< milliseconds
constexpr qint64 longestOpening = 300'000;

double secondsOfThisThread()
{
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Lets the window work until `done`, but not longer; no event is added by the waiting.
template <class Done> bool workUntil(const Done& done, qint64 milliseconds)
{
    QElapsedTimer timer;
    timer.start();
    while (!done() && timer.elapsed() < milliseconds) {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QThread::msleep(1); // the workers have the processor
    }
    return done();
}

/// A control that keys change and that opens nothing.
bool canBeStepped(const QWidget& widget)
{
    return widget.isEnabled() &&
           (qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
            qobject_cast<const QAbstractSlider*>(&widget) != nullptr ||
            qobject_cast<const QComboBox*>(&widget) != nullptr || qobject_cast<const QCheckBox*>(&widget) != nullptr);
}

class UsedWindow {
public:
    UsedWindow(PluginHost& host, BackendChoice canvas)
        : workbench_(host, views_.path().toStdString()), window_(workbench_, canvas)
    {
        window_.resize(usedWindowSize);
        edits_.setObjectName("of an edit");
    }

    bool hasGl() { return viewport().backendName() == "OpenGL"; }
    void open(const std::filesystem::path& model);
    void use(int acts);

private:
    Viewport& viewport() { return window_.viewport(); }
    Session& session() { return workbench_.session(); }
    bool settled() { return !workbench_.scenes().sceneBuilder().busy() && viewport().scene() && viewport().settled(); }
    void edit(RandomEdits& some);
    void dragInPicture();
    void stepControl();
    unsigned below(unsigned count) { return static_cast<unsigned>(random_()) % count; }

    QTemporaryDir views_; ///< the model is seen as at first
    Workbench workbench_;
    MainWindow window_;
    QObject edits_; ///< gets an event for each
    std::mt19937 random_{1};
};

void UsedWindow::open(const std::filesystem::path& model)
{
    window_.show();
    window_.open(QString::fromStdString(model.string()));
    if (!workUntil([this] { return session().model() != nullptr && settled(); }, longestOpening))
        qFatal("The first picture does not come.");
}

void UsedWindow::use(int acts)
{
    std::vector<std::string> modes;
    for (const auto& mode : workbench_.scenes().modes())
        modes.push_back(mode.id);
    RandomEdits some(session(), modes, 1);
    for (int act = 1; act <= acts; ++act) {
        switch (below(3)) {
        case 0: edit(some); break;
        case 1: dragInPicture(); break;
        default: stepControl(); break;
        }
        workUntil([] { return false; }, betweenActs);
        if (act % actsBetweenRests == 0)
            workUntil([this] { return settled(); }, longestRest);
    }
    some.finish();
}

/// As an event, so that it is timed with all that follows at once.
void UsedWindow::edit(RandomEdits& some)
{
    QMetaObject::invokeMethod(
        &edits_, [&some] { some.editOnce(); }, Qt::QueuedConnection);
    QCoreApplication::processEvents();
}

void UsedWindow::dragInPicture()
{
    constexpr std::array<Qt::KeyboardModifier, 3> modifiers{Qt::NoModifier, Qt::ShiftModifier, Qt::ControlModifier};
    const Qt::KeyboardModifiers held = modifiers.at(below(3)); // turns, moves, or drags the transfer function
    QPointF place(viewport().rect().center());
    const auto send = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons) {
        QMouseEvent event(type, place, viewport().mapToGlobal(place), button, buttons, held);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    send(QEvent::MouseButtonPress, Qt::LeftButton, Qt::LeftButton);
    for (unsigned left = below(mostDragSteps); left > 0; --left) {
        place +=
            QPointF(below(longestDragStep), below(longestDragStep)) - QPointF(longestDragStep, longestDragStep) / 2;
        send(QEvent::MouseMove, Qt::NoButton, Qt::LeftButton);
        workUntil([] { return false; }, betweenActs);
    }
    send(QEvent::MouseButtonRelease, Qt::LeftButton, Qt::NoButton);
}

void UsedWindow::stepControl()
{
    const QList<QDockWidget*> docks = window_.findChildren<QDockWidget*>();
    QDockWidget& dock = *docks[below(static_cast<unsigned>(docks.size()))];
    raiseDock(dock);
    QList<QWidget*> controls = dock.findChildren<QWidget*>();
    controls.removeIf([](const QWidget* widget) { return !canBeStepped(*widget); });
    if (controls.isEmpty())
        return;
    QWidget* control = controls[below(static_cast<unsigned>(controls.size()))];
    const bool isBox = qobject_cast<QCheckBox*>(control) != nullptr;
    const Qt::Key key = isBox ? Qt::Key_Space : below(2) == 0 ? Qt::Key_Up : Qt::Key_Down;
    QKeyEvent press(QEvent::KeyPress, key, Qt::NoModifier);
    QKeyEvent release(QEvent::KeyRelease, key, Qt::NoModifier);
    QCoreApplication::sendEvent(control, &press);
    QCoreApplication::sendEvent(control, &release);
}

QString toldOf(const HandledEvent& event)
{
    const char* type = QMetaEnum::fromType<QEvent::Type>().valueToKey(event.type);
    return QString("%1 s, %2 of %3")
        .arg(event.seconds, 0, 'f', 4)
        .arg(type != nullptr ? QString(type) : QString::number(static_cast<int>(event.type)), event.receiver);
}

} // namespace

bool TimedApplication::notify(QObject* receiver, QEvent* event)
{
    if (QThread::currentThread() != thread() || isInside_ || !timed_)
        return QApplication::notify(receiver, event);
    HandledEvent handled{.type = event->type(), .receiver = receiver->metaObject()->className()}; // it may go
    if (!receiver->objectName().isEmpty())
        handled.receiver += " " + receiver->objectName();
    isInside_ = true;
    const double start = secondsOfThisThread();
    const bool isTaken = QApplication::notify(receiver, event);
    handled.seconds = secondsOfThisThread() - start;
    isInside_ = false;
    timed_->push_back(std::move(handled));
    return isTaken;
}

std::vector<HandledEvent> TimedApplication::endTiming()
{
    std::vector<HandledEvent> events = std::move(timed_).value_or(std::vector<HandledEvent>());
    timed_.reset();
    return events;
}

std::optional<BenchCase> eventsOfTheWindow(TimedApplication& application, PluginHost& host,
                                           const std::filesystem::path& model, const QString& name,
                                           BackendChoice canvas, int acts)
{
    UsedWindow window(host, canvas);
    if (window.hasGl() != (canvas == BackendChoice::Gl))
        return std::nullopt;
    application.beginTiming();
    window.open(model);
    window.use(acts);
    std::vector<HandledEvent> events = application.endTiming();
    if (window.hasGl() != (canvas == BackendChoice::Gl))
        qFatal("The window has given up OpenGL on its way.");
    std::ranges::sort(events, std::ranges::greater(), &HandledEvent::seconds);
    const auto late =
        std::ranges::count_if(events, [](const HandledEvent& event) { return event.seconds >= allowedEventSeconds; });

    BenchCase one;
    one.name = name + (canvas == BackendChoice::Gl ? ", slowest event of a thousand, OpenGL canvas"
                                                   : ", slowest event of a thousand, CPU canvas");
    one.seconds = events.at(events.size() / 1000).seconds;
    one.yardstick = "a twentieth of a second";
    one.yardstickSeconds = allowedEventSeconds;
    one.more = {{"events", static_cast<qint64>(events.size())},
                {"worst_seconds", events.front().seconds},
                {"share_in_time", 1 - static_cast<double>(late) / static_cast<double>(events.size())}};
    for (std::size_t place = 0; place < std::min(toldEvents, events.size()); ++place)
        one.more[QString("slowest_%1").arg(place + 1)] = toldOf(events[place]);
    return one;
}

} // namespace tetra
