// SPDX-License-Identifier: GPL-3.0-or-later
/// manual-pictures FOLDER MODELS DATA: the pictures of the window in the manual, taken of the window itself. MODELS has
/// bluntfin.tan and engine.tan, DATA the datasets that are asked about. Each picture is of a window of its own; one
/// that cannot be taken is named, and the exit code is 1.
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/dark_palette.h"
#include "ui/window/docks.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QStyle>
#include <QStyleFactory>
#include <QTextStream>

#include <cmath>

namespace tetra {
namespace {

constexpr QSize windowSize(1366, 768);
constexpr int patience = 120'000; // milliseconds

/// Where everything is and goes to.
struct Places {
    QDir pictures;
    QDir models;
    QDir data;
};

/// A window that is asked for one picture.
class Sitting {
public:
    explicit Sitting(const Places& places) : places_(places)
    {
        QSettings().clear();
        fixture_.window.resize(windowSize);
        fixture_.window.show();
    }

    MainWindow& window() { return fixture_.window; }
    Session& session() { return fixture_.workbench.session(); }
    Viewport& viewport() { return fixture_.viewport(); }
    Workbench& workbench() { return fixture_.workbench; }

    void openModel(const char* name)
    {
        fixture_.window.open(places_.models.filePath(name));
        settle();
    }
    void openSample()
    {
        fixture_.workbench.openSample("c60");
        settle();
    }
    QString dataset(const char* name) const { return places_.data.filePath(name); }
    template <class Condition> void await(const Condition& done)
    {
        if (!QTest::qWaitFor(done, patience))
            fail("it did not become what was waited for");
    }
    void settle()
    {
        await([this] { return session().model() && session().showsQuery() && fixture_.settled(); });
        QTest::qWait(200); // panels that follow a little later: histograms, curves
    }
    void trigger(const char* action) { fixture_.find<QAction>(QString("action.") + action).trigger(); }
    QDockWidget& dock(const char* name)
    {
        auto& found = fixture_.find<QDockWidget>(QString("dock.") + name);
        raiseDock(found);
        return found;
    }
    /// More room for the lower panels.
    void raiseBorder()
    {
        fixture_.window.resizeDocks({&dock("accuracy"), &dock("transfer")}, {330, 430}, Qt::Vertical);
        settle();
    }
    /// The dialog that the action opens.
    QWidget& dialog(const char* action, const char* name)
    {
        trigger(action);
        QTest::qWait(100);
        return fixture_.find<QWidget>(name);
    }
    void nearer(double factor)
    {
        viewport().setCamera(zoomed(viewport().camera(), factor));
        settle();
    }
    void take(const char* name) { take(name, fixture_.window); }
    void take(const char* name, QWidget& widget)
    {
        const QString path = places_.pictures.filePath(QString(name) + ".png");
        QImage picture = widget.grab().toImage().convertToFormat(QImage::Format_RGB32);
        if (!picture.save(path, "PNG", 0))
            fail("cannot write " + path);
    }
    void takeDialog(const char* name, const char* dialog)
    {
        if (auto* widget = fixture_.window.findChild<QWidget*>(dialog))
            take(name, *widget);
        else
            fail(QString("there is no ") + dialog);
    }
    const QStringList& failures() const { return failures_; }

private:
    void fail(const QString& text) { failures_ += text; }

    const Places& places_;
    WindowFixture fixture_;
    QStringList failures_;
};

void start(Sitting& sitting)
{
    sitting.take("start");
}

void window(Sitting& sitting)
{
    sitting.openSample();
    sitting.session().setError(0.5);
    sitting.settle();
    sitting.take("window");
}

void statistics(Sitting& sitting)
{
    sitting.openSample();
    QDockWidget& dock = sitting.dock("statistics");
    dock.setFloating(true);
    dock.resize(430, 640);
    sitting.settle();
    sitting.take("statistics", dock);
}

void palette(Sitting& sitting)
{
    sitting.openSample();
    QWidget& dialog = sitting.dialog("palette", "palette");
    dialog.findChild<QLineEdit*>("palette.search")->setText("save");
    QTest::qWait(100);
    sitting.take("palette", dialog);
}

void animation(Sitting& sitting)
{
    sitting.openSample();
    sitting.dock("animation");
    sitting.settle();
    sitting.take("animation");
}

void bluntFin(Sitting& sitting)
{
    sitting.openModel("bluntfin.tan");
    sitting.session().setIsovalue(0, {.value = 1.244, .red = 0.75F, .green = 0.75F, .blue = 0.78F});
    sitting.settle();
    sitting.nearer(0.75);
    sitting.take("bluntfin");
}

void transfer(Sitting& sitting)
{
    sitting.openModel("bluntfin.tan");
    sitting.trigger("mode.hybrid");
    sitting.session().setIsovalue(0, {.value = 3.6, .red = 0.9F, .green = 0.3F, .blue = 0.1F, .opacity = 0.6F});
    sitting.dock("transfer");
    sitting.raiseBorder();
    sitting.nearer(0.75);
    sitting.take("transfer");
}

void volume(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    sitting.trigger("mode.volume");
    sitting.dock("transfer");
    sitting.raiseBorder();
    sitting.nearer(0.75);
    sitting.take("volume");
}

/// Taken while a point of the transfer function goes to and fro, once the program knows how fast it draws.
void moving(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    sitting.trigger("mode.volume");
    sitting.dock("transfer");
    sitting.raiseBorder();
    sitting.nearer(0.75);
    const TransferFunction before = sitting.session().view().look().transfer;
    const std::size_t point = before.points.size() / 2;
    sitting.session().beginGesture();
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < 4000; QTest::qWait(15)) {
        TransferFunction dragged = before;
        dragged.points[point].opacity = 0.5F + 0.2F * static_cast<float>(std::sin(double(clock.elapsed()) / 300));
        sitting.session().setTransfer(dragged);
    }
    sitting.take("moving");
    sitting.session().endGesture();
}

void focus(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    FocusState focus = sitting.session().view().query().focus;
    focus.shape = FocusState::Shape::Sphere;
    focus.centre = {110, 28, 60};
    focus.radius = 30;
    focus.error = 2;
    sitting.session().setFocus(focus);
    sitting.session().setBudget(300'000);
    sitting.dock("focus");
    sitting.settle();
    sitting.nearer(0.75);
    sitting.take("focus");
}

void build(Sitting& sitting)
{
    sitting.window().open(sitting.dataset("regular/lobster_120x120x34_uint8.nrrd"));
    sitting.await([&] { return sitting.workbench().dataset() != nullptr; });
    QTest::qWait(1000); // the estimate is made beside
    sitting.take("build");
}

void import(Sitting& sitting)
{
    sitting.workbench().openWithOptions(sitting.dataset("sod/Molecule_U8_X100_Y100_Z120.binary"));
    sitting.await([&] { return sitting.window().findChild<QWidget*>("importDialog") != nullptr; });
    QTest::qWait(1500); // the layer is read beside
    sitting.takeDialog("import", "importDialog");
}

void savePicture(Sitting& sitting)
{
    sitting.openSample();
    sitting.take("picture", sitting.dialog("savePicture", "pictureOptions"));
}

void inGerman(Sitting& sitting)
{
    sitting.openSample();
    sitting.trigger("mode.hybrid");
    sitting.dock("transfer");
    sitting.settle();
    sitting.take("german-dark");
}

void inItalian(Sitting& sitting)
{
    sitting.openSample();
    sitting.dock("view");
    sitting.dock("transfer");
    sitting.trigger("mode.volume");
    sitting.settle();
    sitting.take("italian");
}

/// What is in a picture, in which language and colours.
struct Subject {
    const char* name;
    void (*take)(Sitting&);
    const char* language = "en";
    bool dark = false;
};

constexpr Subject subjects[] = {
    {"start", start},
    {"window", window},
    {"statistics", statistics},
    {"palette", palette},
    {"animation", animation},
    {"bluntfin", bluntFin},
    {"transfer", transfer},
    {"volume", volume},
    {"moving", moving},
    {"focus", focus},
    {"build", build},
    {"import", import},
    {"picture", savePicture},
    {"german-dark", inGerman, "de", true},
    {"italian", inItalian, "it"},
};

/// Whether it was taken.
bool takeOf(const Subject& subject, const Places& places)
{
    const Speaking language(subject.language);
    QApplication::setPalette(subject.dark ? darkPalette() : QApplication::style()->standardPalette());
    Sitting sitting(places);
    subject.take(sitting);
    for (const QString& failure : sitting.failures())
        QTextStream(stderr) << subject.name << ": " << failure << Qt::endl;
    return sitting.failures().isEmpty();
}

} // namespace
} // namespace tetra

int main(int argc, char** argv)
{
    using namespace tetra;
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("manual-pictures");
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() < 4) {
        QTextStream(stderr) << "usage: manual-pictures FOLDER MODELS DATA [NAME...]" << Qt::endl;
        return 2;
    }
    const Places places{QDir(arguments[1]), QDir(arguments[2]), QDir(arguments[3])};
    const QStringList wanted = arguments.mid(4);
    bool isWhole = true;
    for (const Subject& subject : subjects)
        if (wanted.isEmpty() || wanted.contains(subject.name))
            isWhole &= takeOf(subject, places);
    return isWhole ? 0 : 1;
}
