// SPDX-License-Identifier: GPL-3.0-or-later
/// manual-pictures FOLDER MODELS: the pictures of the window in the manual that need a dataset, taken of the window
/// itself (those of the sample are among ./dev screenshots). MODELS has bluntfin.tan and engine.tan. Each picture is of
/// a window of its own; one that cannot be taken is named, and the exit code is 1.
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/legible_style.h"
#include "ui/window/docks.h"

#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
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

    Session& session() { return fixture_.workbench.session(); }
    Viewport& viewport() { return fixture_.viewport(); }

    void openModel(const char* name)
    {
        const QString path = places_.models.filePath(name);
        fixture_.workbench.opening().views().forget(path.toStdString()); // as at first, not as another sitting left it
        fixture_.window.open(path);
        settle();
    }
    void settle()
    {
        if (!waitFor([this] { return session().model() && session().showsQuery() && fixture_.settled(); }, patience))
            failures_ += "it was not drawn in time";
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
    void take(const char* name)
    {
        const QString path = places_.pictures.filePath(QString(name) + ".png");
        if (!fixture_.window.grab().toImage().convertToFormat(QImage::Format_RGB32).save(path, "PNG", 0))
            failures_ += "cannot write " + path;
    }
    const QStringList& failures() const { return failures_; }

private:
    const Places& places_;
    WindowFixture fixture_;
    QStringList failures_;
};

void bluntFin(Sitting& sitting)
{
    sitting.openModel("bluntfin.tan");
    sitting.session().setIsovalue(0, {.value = 1.244, .red = 0.75F, .green = 0.75F, .blue = 0.78F});
    sitting.settle();
    sitting.take("bluntfin");
}

void transfer(Sitting& sitting)
{
    sitting.openModel("bluntfin.tan");
    sitting.trigger("mode.hybrid");
    sitting.session().setIsovalue(0, {.value = 3.6, .red = 0.9F, .green = 0.3F, .blue = 0.1F, .opacity = 0.6F});
    sitting.dock("transfer");
    sitting.raiseBorder();
    sitting.take("transfer");
}

void volume(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    sitting.trigger("mode.volume");
    sitting.dock("transfer");
    sitting.raiseBorder();
    sitting.take("volume");
}

/// Taken while a point of the transfer function goes to and fro, once the program knows how fast it draws.
void moving(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    sitting.trigger("mode.volume");
    sitting.dock("transfer");
    sitting.raiseBorder();
    const TransferFunction before = sitting.session().view().appearance.transfer;
    const std::size_t point = before.opacities.size() / 2;
    sitting.session().beginGesture();
    QElapsedTimer clock;
    for (clock.start(); clock.elapsed() < 4000; QTest::qWait(15)) {
        TransferFunction dragged = before;
        dragged.opacities[point].opacity = 0.5F + 0.2F * static_cast<float>(std::sin(double(clock.elapsed()) / 300));
        sitting.session().setTransfer(dragged);
    }
    sitting.take("moving");
    sitting.session().endGesture();
}

void focus(Sitting& sitting)
{
    sitting.openModel("engine.tan");
    FocusState focus = sitting.session().view().query.focus;
    focus.shape = FocusState::Shape::Sphere;
    focus.centre = {110, 28, 60};
    focus.radius = 30;
    focus.error = 2;
    sitting.session().setFocus(focus);
    sitting.session().setBudget(300'000);
    sitting.dock("focus");
    sitting.settle();
    sitting.take("focus");
}

struct Subject {
    const char* name;
    void (*take)(Sitting&);
};

constexpr Subject subjects[] = {
    {"bluntfin", bluntFin}, {"transfer", transfer}, {"volume", volume}, {"moving", moving}, {"focus", focus},
};

/// Whether it was taken.
bool takeOf(const Subject& subject, const Places& places)
{
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
    QApplication::setStyle(new LegibleStyle);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.size() != 3) {
        QTextStream(stderr) << "usage: manual-pictures FOLDER MODELS" << Qt::endl;
        return 2;
    }
    const Places places{QDir(arguments[1]), QDir(arguments[2])};
    bool isWhole = true;
    for (const Subject& subject : subjects)
        isWhole &= takeOf(subject, places);
    return isWhole ? 0 : 1;
}
