// SPDX-License-Identifier: GPL-3.0-or-later
/// window-pictures FOLDER [MODELS]: takes pictures of the window, in the language and the scale of the environment.
/// Without MODELS: of the window with a sample, of each panel with what it can show, and of each dialog, in light and
/// in dark colours ("light-window.png" ...). With MODELS, a folder with bluntfin.tan and engine.tan: those in the
/// manual that need a dataset ("bluntfin.png" ...). What cannot be taken is named, and the exit code is 1.
#include "tests/ui/every_dialog.h"
#include "tests/ui/languages.h"
#include "ui/opening/sample_models.h"
#include "ui/widgets/legible_style.h"
#include "ui/window/docks.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QLibraryInfo>
#include <QStyle>
#include <QTextStream>

#include <cmath>
#include <map>

namespace tetra {
namespace {

constexpr QSize windowSize(1366, 768);
constexpr int patience = 120'000; // milliseconds

/// A window that is asked for pictures. It begins with no settings and no views of others.
class Sitting {
public:
    Sitting(const QDir& folder, const QString& prefix) : folder_(folder), prefix_(prefix)
    {
        QSettings().clear();
        fixture_.window.resize(windowSize);
        fixture_.window.show();
    }

    WindowFixture& fixture() { return fixture_; }
    MainWindow& window() { return fixture_.window; }
    Workbench& workbench() { return fixture_.workbench; }
    Session& session() { return fixture_.workbench.session(); }
    void expect(bool holds, const QString& failure)
    {
        if (!holds)
            failures_ += failure;
    }
    template <class Condition> void waitUntil(const Condition& holds, const char* failure)
    {
        expect(waitFor(holds, patience), failure);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    void settle()
    {
        QTest::qWait(200); // what is hidden or shown makes room for the picture, which is drawn anew
        waitUntil([this] { return session().model() && session().showsQuery() && fixture_.settled(); },
                  "it was not drawn in time");
        QTest::qWait(200); // panels that follow a little later: histograms, curves
    }
    void openModel(const QString& path)
    {
        window().open(path);
        settle();
    }
    void trigger(const char* action) { fixture_.find<QAction>(QString("action.") + action).trigger(); }
    QDockWidget& dock(const char* name)
    {
        auto& found = fixture_.find<QDockWidget>(QString("dock.") + name);
        raiseDock(found);
        return found;
    }
    void take(const QString& name, QWidget& widget)
    {
        QCoreApplication::processEvents();
        const QString path = folder_.filePath(prefix_ + name + ".png");
        expect(widget.grab().toImage().convertToFormat(QImage::Format_RGB32).save(path, "PNG", 0),
               "cannot write " + path);
    }
    void takePanel(const char* name, const QString& picture)
    {
        QDockWidget& panel = dock(name);
        settle();
        take("panel-" + picture, panel);
    }
    const QStringList& failures() const { return failures_; }

private:
    QDir folder_;
    QString prefix_;
    WindowFixture fixture_;
    QStringList failures_;
};

// With the sample.

/// An error, and the question after the program has ended unexpectedly.
void takeMessages(Sitting& sitting)
{
    auto& messages = sitting.fixture().find<MessageBar>("messages");
    sitting.window().open(sitting.fixture().folder.filePath("missing.nrrd"));
    sitting.waitUntil([&messages] { return !messages.texts().isEmpty(); }, "no message came");
    messages.ask(
        KeepSession::tr("TAn ended unexpectedly while %1 was open. Its view can be restored.").arg("c60.tan"),
        KeepSession::tr("&Restore"), [] {}, [] {});
    sitting.take("messages", messages);
    messages.clear();
}

/// Each as it is at first, and one that is taller than its place as a window of its own.
void takePanels(Sitting& sitting)
{
    for (const QDockWidget* dock : sitting.window().findChildren<QDockWidget*>()) {
        const QByteArray name = dock->objectName().section('.', 1).toUtf8();
        sitting.takePanel(name, name);
    }
    QDockWidget& statistics = sitting.dock("statistics");
    statistics.setFloating(true);
    statistics.resize(440, 750);
    sitting.takePanel("statistics", "statistics-whole");
    statistics.setFloating(false);
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

/// What panels show once something is switched on.
void takePanelsAtWork(Sitting& sitting)
{
    Session& session = sitting.session();
    sitting.trigger("focusSphere");
    sitting.takePanel("focus", "focus-sphere");
    sitting.trigger("focusBox");
    sitting.takePanel("focus", "focus-box");
    sitting.trigger("focusBox"); // off again
    QueryState query = session.view().query;
    query.window.enabled = true;
    query.values.enabled = true;
    session.setQuery(query);
    sitting.takePanel("region", "region-on");
    session.undoStack().undo();
    session.setAnimation(keyFrames(frameOf(session.view())));
    sitting.takePanel("animation", "animation-keys");
    sitting.trigger("mode.volume");
    sitting.takePanel("rendering", "rendering-volume");
    for (const char* dock : {"build", "animation"}) // as where a model was opened
        sitting.dock(dock).hide();
    sitting.takePanel("transfer", "transfer-volume");
    sitting.take("window-volume", sitting.window());
    sitting.fixture().find<QAbstractButton>("transfer.table.show").click();
    sitting.takePanel("transfer", "transfer-table");
}

/// A file that says nothing of itself: the samples of the sample's own file, which end it.
QString bareFile(Sitting& sitting, const QString& described)
{
    const auto points = static_cast<qint64>(sitting.session().model()->description().lattice.pointCount());
    const QString bare = sitting.fixture().folder.filePath("c60.raw");
    QFile source(described), target(bare);
    sitting.expect(source.open(QIODevice::ReadOnly) && source.seek(source.size() - points) &&
                       target.open(QIODevice::WriteOnly) && target.write(source.readAll()) == points,
                   "cannot write " + bare);
    return bare;
}

/// Under the names of their widgets, with a number where there are several of a name.
void takeDialogs(Sitting& sitting, const QString& described)
{
    std::map<QString, int> taken;
    for (const OpenableDialog& dialog : everyDialog(described, bareFile(sitting, described))) {
        dialog.open(sitting.fixture());
        auto& widget = sitting.fixture().find<QWidget>(dialog.name);
        sitting.waitUntil([&widget] { return widget.isVisible(); }, dialog.name);
        const int number = ++taken[dialog.name];
        sitting.take(dialog.name + (number > 1 ? QString("-%1").arg(number) : QString()), widget);
        widget.close();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

QPalette darkPalette()
{
    QPalette palette(QColor(53, 54, 58), QColor(42, 43, 46));
    palette.setColor(QPalette::Base, QColor(32, 33, 36));
    palette.setColor(QPalette::AlternateBase, QColor(42, 43, 46));
    palette.setColor(QPalette::Highlight, QColor(64, 120, 192));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::ToolTipBase, QColor(53, 54, 58));
    palette.setColor(QPalette::ToolTipText, Qt::white);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, QColor(128, 128, 128));
    return palette;
}

QStringList takeOfSample(const QDir& folder, bool dark)
{
    QPalette palette = dark ? darkPalette() : QApplication::style()->standardPalette();
    QApplication::style()->polish(palette);
    QApplication::setPalette(palette);
    Sitting sitting(folder, dark ? "dark-" : "light-");
    sitting.waitUntil([&] { return !sitting.workbench().opening().samples().drawing().running(); },
                      "the samples have no pictures");
    sitting.take("start", sitting.window());
    sitting.workbench().opening().samples().open("c60");
    sitting.settle();
    sitting.take("window", sitting.window());
    takeMessages(sitting);
    takePanels(sitting);
    takePanelsAtWork(sitting);
    const QString described = pathText(sampleFolder() / "c60.nrrd");
    takeDialogs(sitting, described);
    sitting.window().open(described);
    sitting.waitUntil([&] { return sitting.workbench().opening().datasets().dataset() != nullptr; },
                      "the dataset did not open");
    sitting.takePanel("build", "build-dataset");
    sitting.take("window-build", sitting.window());
    return sitting.failures();
}

// With datasets.

/// More room for the lower panels.
void raiseBorder(Sitting& sitting)
{
    sitting.window().resizeDocks({&sitting.dock("accuracy"), &sitting.dock("transfer")}, {330, 430}, Qt::Vertical);
    sitting.settle();
}

void bluntFin(Sitting& sitting)
{
    sitting.session().setIsovalue(0, {.value = 1.244, .red = 0.75F, .green = 0.75F, .blue = 0.78F});
    sitting.settle();
}

void transfer(Sitting& sitting)
{
    sitting.trigger("mode.hybrid");
    sitting.session().setIsovalue(0, {.value = 3.6, .red = 0.9F, .green = 0.3F, .blue = 0.1F, .opacity = 0.6F});
    raiseBorder(sitting);
}

void volume(Sitting& sitting)
{
    sitting.trigger("mode.volume");
    raiseBorder(sitting);
}

/// While a point of the transfer function goes to and fro, once the program knows how fast it draws.
void moving(Sitting& sitting)
{
    volume(sitting);
    const TransferFunction before = sitting.session().view().appearance.transfer;
    const std::size_t point = before.opacities.size() / 2;
    sitting.session().beginGesture();
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < 4000; QTest::qWait(15)) {
        TransferFunction dragged = before;
        dragged.opacities[point].opacity = 0.5F + 0.2F * static_cast<float>(std::sin(double(clock.elapsed()) / 300));
        sitting.session().setTransfer(dragged);
    }
}

void focus(Sitting& sitting)
{
    FocusState focus = sitting.session().view().query.focus;
    focus.shape = FocusState::Shape::Sphere;
    focus.centre = {110, 28, 60};
    focus.radius = 30;
    focus.error = 2;
    sitting.session().setFocus(focus);
    sitting.session().setBudget(300'000);
    sitting.dock("focus");
    sitting.settle();
}

struct Subject {
    const char* name;
    const char* model;
    void (*arrange)(Sitting&);
};

constexpr Subject subjects[] = {
    {"bluntfin", "bluntfin.tan", bluntFin}, {"transfer", "bluntfin.tan", transfer}, {"volume", "engine.tan", volume},
    {"moving", "engine.tan", moving},       {"focus", "engine.tan", focus},
};

QStringList takeOf(const Subject& subject, const QDir& folder, const QDir& models)
{
    Sitting sitting(folder, {});
    sitting.openModel(models.filePath(subject.model));
    subject.arrange(sitting);
    sitting.take(subject.name, sitting.window());
    return sitting.failures();
}

/// What could not be taken.
QStringList takeAll(const QStringList& folders)
{
    const QDir folder(folders[0]);
    if (!folder.mkpath("."))
        return {"cannot make " + folder.path()};
    if (folders.size() == 1)
        return takeOfSample(folder, false) + takeOfSample(folder, true);
    QStringList failures;
    for (const Subject& subject : subjects)
        for (const QString& failure : takeOf(subject, folder, QDir(folders[1])))
            failures += subject.name + (": " + failure);
    return failures;
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("window-pictures");
    QApplication::setStyle(new LegibleStyle);
    const QStringList folders = QCoreApplication::arguments().mid(1);
    QTextStream errors(stderr);
    if (folders.isEmpty() || folders.size() > 2) {
        errors << "usage: window-pictures FOLDER [MODELS]" << Qt::endl;
        return 2;
    }
    QTranslator ofQt;
    if (ofQt.load(textLocale(), "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&ofQt);
    const Speaking speaking(textLocale().name());
    const QStringList failures = takeAll(folders);
    for (const QString& failure : failures)
        errors << failure << Qt::endl;
    return failures.isEmpty() ? 0 : 1;
}
