// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/photographer.h"

#include "ui/session/sample_models.h"
#include "ui/session/target_path.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/message_bar.h"
#include "ui/window/leaving.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>

namespace tetra {
namespace {

constexpr QSize windowSize(1366, 768);
constexpr int photographerPatience = 60'000; // milliseconds

/// Works on until `done`; false if that takes too long.
template <class Condition> bool waitFor(const Condition& done)
{
    QElapsedTimer clock;
    clock.start();
    while (!done() && clock.elapsed() < photographerPatience)
        QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 50);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QCoreApplication::processEvents();
    return done();
}

/// A file that says nothing of itself: the samples at the end of `described`, of so many bytes.
bool writeBare(const QString& described, const QString& bare, qint64 bytes)
{
    QFile source(described);
    QFile target(bare);
    if (!source.open(QIODevice::ReadOnly) || !source.seek(source.size() - bytes) || !target.open(QIODevice::WriteOnly))
        return false;
    return target.write(source.readAll()) == bytes;
}

/// Two views of a path.
Animation keyFrames(const FilmFrame& present)
{
    Animation animation;
    animation.kind = Animation::Kind::KeyFrames;
    FilmFrame next = present;
    next.camera.azimuth += 60;
    return withKey(withKey(animation, present), next);
}

} // namespace

Photographer::Photographer(PluginHost& host, QDir folder, QString prefix)
    : folder_(std::move(folder)), prefix_(std::move(prefix)), workbench_(host, filePath(views_.path())),
      window_(workbench_, BackendChoice::Cpu)
{
    window_.resize(windowSize);
    window_.show();
}

bool Photographer::takeAll()
{
    waitFor([this] { return !workbench_.opening().thumbnails().running(); });
    take("start", window_);
    workbench_.opening().openSample("c60");
    if (!waitFor([this] { return settled(); }))
        return false;
    take("window", window_);
    takeMessages();
    takePanels();
    takePanelsAtWork();
    takeDialogs();
    takeQuestions();
    takeImports();
    return isWhole_;
}

bool Photographer::settled() const
{
    const auto* viewport = window_.findChild<Viewport*>();
    return workbench_.session().model() && !workbench_.scenes().sceneBuilder().busy() && viewport->scene() &&
           viewport->settled();
}

void Photographer::trigger(const QString& action) const
{
    if (auto* found = qobject_cast<QAction*>(find(action)))
        found->trigger();
}

/// An error, and the question after the program has ended unexpectedly.
void Photographer::takeMessages()
{
    auto& messages = *window_.findChild<MessageBar*>("messages");
    window_.open(folder_.filePath("missing.nrrd"));
    waitFor([&messages] { return !messages.texts().isEmpty(); });
    messages.ask(
        KeepSession::tr("TAn ended unexpectedly while %1 was open. How it was seen can be restored.").arg("c60.tan"),
        KeepSession::tr("&Restore"), [] {}, [] {});
    QCoreApplication::processEvents();
    take("messages", messages);
    messages.clear();
}

void Photographer::takePanels()
{
    for (const QDockWidget* dock : window_.findChildren<QDockWidget*>())
        takePanel(dock->objectName(), dock->objectName().section('.', 1));
    takeWholePanel("dock.statistics", "statistics-whole", {440, 690});
}

void Photographer::takePanel(const QString& dock, const QString& name)
{
    auto& panel = *window_.findChild<QDockWidget*>(dock);
    panel.show();
    panel.raise();
    waitFor([this] { return settled(); });
    take("panel-" + name, panel);
}

/// A panel that is taller than its place, as a window of its own.
void Photographer::takeWholePanel(const QString& dock, const QString& name, const QSize& size)
{
    auto& panel = *window_.findChild<QDockWidget*>(dock);
    panel.setFloating(true);
    panel.resize(size);
    takePanel(dock, name);
    panel.setFloating(false);
}

/// What panels show once something is switched on.
void Photographer::takePanelsAtWork()
{
    Session& session = workbench_.session();
    trigger("action.focusSphere");
    takePanel("dock.focus", "focus-sphere");
    trigger("action.focusBox");
    takePanel("dock.focus", "focus-box");
    trigger("action.focusBox"); // off again
    QueryState query = session.view().query;
    query.window.enabled = true;
    query.values.enabled = true;
    session.setQuery(query);
    takePanel("dock.region", "region-on");
    session.undoStack().undo();
    session.setAnimation(keyFrames(frameOf(session.view())));
    takePanel("dock.animation", "animation-keys");
    trigger("action.mode.volume");
    takePanel("dock.rendering", "rendering-volume");
    for (const char* dock : {"dock.build", "dock.animation"}) // as where a model was opened
        window_.findChild<QDockWidget*>(dock)->hide();
    takePanel("dock.transfer", "transfer-volume");
    waitFor([this] { return settled(); });
    take("window-volume", window_);
    if (auto* table = qobject_cast<QAbstractButton*>(find("transfer.table.show")))
        table->click();
    takePanel("dock.transfer", "transfer-table");
}

void Photographer::takeDialogs()
{
    struct Dialog {
        const char* action;
        const char* dialog;
        const char* name;
    };
    for (const auto& [action, dialog, name] :
         {Dialog{"plugins", "pluginWindow", "plugins"}, Dialog{"about", "aboutBox", "about"},
          Dialog{"palette", "palette", "palette"}, Dialog{"savePicture", "pictureOptions", "picture"},
          Dialog{"saveFilm", "filmOptions", "film"}}) {
        trigger(QString("action.") + action);
        takeDialog(dialog, name);
    }
    if (auto* presets = qobject_cast<QAbstractButton*>(find("transfer.presets")))
        presets->click();
    takeDialog("transfer.presetPopup", "presets");
}

/// What is asked before work is lost.
void Photographer::takeQuestions()
{
    const LeavingFacts quit{LeavingWay::Quit, "bonsai.nhdr",
                            Leaving::tr("%1 % is done, about %2 are left.").arg(7).arg("59 s"), "bonsai.tan", true};
    LeavingFacts open = quit;
    open.way = LeavingWay::OpenModel;
    askAboutBuild(quit, &window_);
    takeDialog("leaving.build", "leaving-build");
    askAboutBuild(open, &window_);
    takeDialog("leaving.build", "leaving-build-behind");
    open.name = "bonsai-film.png";
    askAboutFilm(open, &window_);
    takeDialog("leaving.film", "leaving-film");
    open.name = "bonsai.tansession";
    askAboutSession(open, &window_);
    takeDialog("leaving.session", "leaving-session");
    askAboutSaving(&window_);
    takeDialog("leaving.saving", "leaving-saving");
}

void Photographer::takeDialog(const QString& dialog, const QString& name)
{
    QCoreApplication::processEvents();
    auto* widget = qobject_cast<QWidget*>(find(dialog));
    isWhole_ &= widget != nullptr;
    if (widget == nullptr)
        return;
    take(name, *widget);
    widget->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
}

/// Of a file that says what it is, and of one that does not; and the panel that builds a model of it.
void Photographer::takeImports()
{
    const QString described = pathText(sampleFolder() / "c60.nrrd");
    const QString bare = folder_.filePath("c60.raw");
    const auto points = static_cast<qint64>(workbench_.session().model()->description().lattice.pointCount());
    isWhole_ &= writeBare(described, bare, points);
    for (const auto& [path, name] : {std::pair(described, "import"), std::pair(bare, "import-bare")}) {
        workbench_.opening().openWithOptions(path);
        waitFor([this] {
            const auto* dialog = qobject_cast<QWidget*>(find("importDialog"));
            return dialog != nullptr && dialog->isVisible();
        });
        takeDialog("importDialog", name);
    }
    QFile::remove(bare);
    window_.open(described);
    waitFor([this] { return workbench_.opening().dataset() != nullptr; });
    takePanel("dock.build", "build-dataset");
    take("window-build", window_);
}

void Photographer::take(const QString& name, QWidget& widget)
{
    QCoreApplication::processEvents();
    isWhole_ &= widget.grab().save(folder_.filePath(prefix_ + "-" + name + ".png"));
}

} // namespace tetra
