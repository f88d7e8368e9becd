// SPDX-License-Identifier: GPL-3.0-or-later
// An hour of transfer-function editing (R18, R27), a few minutes of it in ./dev test: the memory stays as it is,
// pictures follow, how soon is for ./dev soak to judge, all can be undone, and what a killed program was at is there
// again. The hour is that of a clock that the test drives: nobody waits for it.
#include "core/picture/text_file.h"
#include "tests/soak.h"
#include "tests/ui/random_edits.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/session/files.h"
#include "ui/work/steady_heap.h"

#include <QElapsedTimer>
#include <QFile>
#include <QProcess>
#include <QPushButton>
#include <QTest>

#include <algorithm>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAN_HEAP_IS_COUNTED
extern "C" std::size_t __sanitizer_get_current_allocated_bytes(); // GCC has it, but not its header
#elif defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace tetra;

namespace {

/// Seconds.
double theHour()
{
    return timesOf(400., 3600.);
}
constexpr double betweenMoves = 0.05; ///< of a drag
constexpr int mostMoves = 20;
constexpr double leastPause = 5; ///< of somebody who looks at what came of it
constexpr int gesturesBetweenRests = 25;
constexpr int gesturesBetweenMeasured = 8; ///< the others take no more time than the window needs for them
constexpr int gesturesBetweenOthers = 10;  ///< that are about something else than the transfer function
constexpr double allowedMegabytes = 20;
/// From an edit to a picture that shows it, of all but the slowest hundredth. It takes a few hundredths of it on one
/// core of 2020: this is for machines that have other things to do.
constexpr double allowedSeconds = isInstrumented ? 10 : 1;
constexpr int editsBeforeTheKill = 300;
constexpr const char* killedModel = "TAN_TEST_KILLED_MODEL"; ///< of the program that is killed: the model it opens
constexpr const char* killedFolder = "TAN_TEST_KILLED_FOLDER";

/// VmRSS in MB; nothing where there is no /proc. A sanitizer keeps what is freed resident for a while, but counts the
/// bytes in use: then these.
std::optional<double> megabytesHeld()
{
#ifdef TAN_HEAP_IS_COUNTED
    return static_cast<double>(__sanitizer_get_current_allocated_bytes()) / (1 << 20);
#else
    QFile status("/proc/self/status");
    if (!status.open(QFile::ReadOnly))
        return std::nullopt;
    for (const QByteArray& line : status.readAll().split('\n'))
        if (line.startsWith("VmRSS:"))
            return line.mid(6).simplified().split(' ').front().toDouble() / 1024;
    return std::nullopt;
#endif
}

/// What was given back to the heap counts as free.
void trimHeap()
{
#if defined(__GLIBC__) && !defined(TAN_HEAP_IS_COUNTED)
    malloc_trim(0);
#endif
}

/// How long it takes from each edit to the first picture that shows the newest: an edit that is overtaken by the next
/// one waits with it.
class Latencies {
public:
    explicit Latencies(const WindowFixture& window) : window_(window)
    {
        clock_.start();
        QObject::connect(&window.viewport(), &Viewport::framePainted, &window.viewport(), [this] { painted(); });
    }
    void edited() { waiting_.push_back(clock_.nsecsElapsed()); }
    bool isShown() const { return waiting_.empty(); }
    /// No picture is to come any more: it is shown, or there was nothing else to be seen.
    bool isOver()
    {
        if (window_.settled())
            waiting_.clear();
        return isShown();
    }
    /// Seconds, ascending.
    std::vector<double> sorted()
    {
        std::ranges::sort(seconds_);
        return seconds_;
    }

private:
    void painted()
    {
        if (window_.workbench.scenes().sceneBuilder().busy())
            return; // the picture is of an older scene
        for (const qint64 start : waiting_)
            seconds_.push_back(static_cast<double>(clock_.nsecsElapsed() - start) * 1e-9);
        waiting_.clear();
    }

    const WindowFixture& window_;
    QElapsedTimer clock_;
    std::vector<qint64> waiting_;
    std::vector<double> seconds_;
};

/// The window at work until the next edit comes; if the newest is shown before, nobody waits.
void followFor(double seconds, const Latencies& latencies)
{
    QElapsedTimer clock;
    clock.start();
    QCoreApplication::processEvents();
    while (!latencies.isShown() && static_cast<double>(clock.nsecsElapsed()) * 1e-9 < seconds) {
        QTest::qSleep(1); // the workers have the processor
        QCoreApplication::processEvents();
    }
}

std::vector<std::string> modesOf(const WindowFixture& window)
{
    std::vector<std::string> modes;
    for (const auto& mode : window.workbench.scenes().modes())
        modes.push_back(mode.id);
    return modes;
}

} // namespace

class EditingSessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void anHourOfEditing();
    void whatAKilledProgramWasAtIsThereAgain();
    void theProgramThatIsKilled();

private:
    static std::unique_ptr<WindowFixture> windowOn(const QString& model, const std::filesystem::path& views = {});
    static void waitForRest(const WindowFixture& window) { QTRY_VERIFY_WITH_TIMEOUT(window.settled(), 60'000); }
    static double megabytesAtRest(const WindowFixture& window);

    QTemporaryDir folder_;
    QString model_;
};

void EditingSessionTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("editing_session");
    QLocale::setDefault(QLocale::c());
    keepHeapSteady(); // as the program does
    if (qEnvironmentVariableIsSet(killedModel))
        return;
    QSettings().clear();
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(16), folder_.path().toStdString()).string());
}

std::unique_ptr<WindowFixture> EditingSessionTest::windowOn(const QString& model, const std::filesystem::path& views)
{
    auto window = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), views);
    window->window.show();
    window->window.open(model);
    if (!waitFor([&] { return window->workbench.session().model() && window->settled(); }))
        qFatal("the model did not open");
    return window;
}

/// Of the same mesh and look each time, whatever was edited.
double EditingSessionTest::megabytesAtRest(const WindowFixture& window)
{
    Session& session = window.workbench.session();
    session.endGesture();
    session.setQuery(startingQuery(*session.model(), 1));
    session.setMode("volume");
    waitForRest(window);
    trimHeap();
    return megabytesHeld().value_or(0);
}

void EditingSessionTest::anHourOfEditing()
{
    const auto window = windowOn(model_);
    Session& session = window->workbench.session();
    QUndoStack& stack = session.undoStack();
    // A camera that nobody has moved follows the picture's shape, which docks change.
    session.setCamera(turned(session.view().camera, 10, 5));
    const ViewValue start = session.view();
    const int first = stack.index();
    session.setMode("volume");
    RandomEdits some(session, modesOf(*window), seedOf(7));
    Latencies latencies(*window);
    std::mt19937 random(seedOf(7));
    int edits = 0;
    int gestures = 0;
    std::optional<double> warm;
    for (double now = 0; now < theHour(); now += leastPause + static_cast<double>(random() % 10)) {
        const bool isMeasured = gestures % gesturesBetweenMeasured == 0;
        if (isMeasured)
            QVERIFY(waitFor([&] { return !window->workbench.scenes().sceneBuilder().busy(); }));
        session.beginGesture();
        for (auto moves = random() % mostMoves + 1; moves > 0; --moves, ++edits, now += betweenMoves) {
            const TransferFunction before = session.view().appearance.transfer;
            some.editTransfer();
            if (isMeasured && session.view().appearance.transfer != before)
                latencies.edited();
            followFor(isMeasured ? betweenMoves : 0, latencies);
        }
        session.endGesture();
        QVERIFY(waitFor([&] { return latencies.isOver(); }));
        if (++gestures % gesturesBetweenOthers == 0)
            some.editOnce();
        some.finish();
        session.setMode("volume");
        if (gestures % gesturesBetweenRests == 0)
            waitForRest(*window);
        if (!warm && now >= theHour() / 4)
            warm = megabytesAtRest(*window);
    }
    const double grown = megabytesAtRest(*window) - warm.value_or(0);
    const std::vector<double> seconds = latencies.sorted();
    QVERIFY(seconds.size() > std::size_t(edits / gesturesBetweenMeasured) / 2);
    const double slow = seconds[seconds.size() * 99 / 100];
    qInfo("%d edits in %g s, %d steps: %.1f MB more than after a quarter of it; from edit to picture %.3f s in the "
          "middle, %.3f s for the slowest hundredth, %.3f s at most",
          edits, theHour(), stack.count(), grown, seconds[seconds.size() / 2], slow, seconds.back());
    if (megabytesHeld())
        QVERIFY2(grown <= allowedMegabytes, qPrintable(QString("%1 MB more").arg(grown)));
    if (isSoak()) // which leaves the machine to this test
        QVERIFY2(slow <= allowedSeconds, qPrintable(QString("%1 s from edit to picture").arg(slow)));

    const ViewValue end = session.view();
    const int steps = stack.count();
    while (stack.index() > first)
        stack.undo();
    QVERIFY(session.view() == start);
    while (stack.canRedo())
        stack.redo();
    QVERIFY(session.view() == end);
    QCOMPARE(stack.count(), steps);
    waitForRest(*window);
}

/// Opening something else, even in vain, keeps what was open first: so nobody has to wait until it is kept anyway. What
/// follows is lost, and nothing else is.
void EditingSessionTest::whatAKilledProgramWasAtIsThereAgain()
{
    const QString views = folder_.filePath("views");
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(killedModel, model_);
    environment.insert(killedFolder, folder_.path());
    program.setProcessEnvironment(environment);
    program.setProcessChannelMode(QProcess::ForwardedChannels);
    program.start(QCoreApplication::applicationFilePath(), {"editing_session", "theProgramThatIsKilled"});
    QVERIFY(program.waitForStarted());
    const std::filesystem::path expected = filePath(folder_.filePath("expected.tansession"));
    QTRY_VERIFY_WITH_TIMEOUT(std::filesystem::exists(expected) || program.state() == QProcess::NotRunning, 120'000);
    QCOMPARE(program.state(), QProcess::Running);
    program.kill();
    QVERIFY(program.waitForFinished());
    QCOMPARE(program.exitStatus(), QProcess::CrashExit);

    WindowFixture window(BackendChoice::Cpu, hostOfThisBuild(), filePath(views));
    window.window.show();
    window.find<QPushButton>("lost.restore").click();
    QTRY_VERIFY_WITH_TIMEOUT(window.workbench.session().model() && window.settled(), 60'000);
    const auto text = readTextFile(expected);
    QVERIFY(text.ok());
    const auto document = sessionFromText(*text, expected.parent_path());
    QVERIFY2(document.ok(), document.ok() ? "" : document.error().text().c_str());
    QVERIFY(window.workbench.session().view() == document->view);
}

void EditingSessionTest::theProgramThatIsKilled()
{
    if (!qEnvironmentVariableIsSet(killedModel))
        QSKIP("only as the program that another test kills");
    const QDir folder(qEnvironmentVariable(killedFolder));
    const auto window = windowOn(qEnvironmentVariable(killedModel), filePath(folder.filePath("views")));
    Session& session = window->workbench.session();
    RandomEdits some(session, modesOf(*window), 3);
    for (int done = 0; done < editsBeforeTheKill; ++done)
        some.editOnce();
    some.finish();
    const auto document = window->workbench.opening().sessions().document();
    window->window.open(folder.filePath("no such file.tan"));
    QTRY_VERIFY(!window->messages().isEmpty() && window->workbench.opening().views().idle());
    session.setError(19); // is not kept any more
    const std::filesystem::path expected = filePath(folder.filePath("expected.tansession"));
    QVERIFY(writeTextFile(expected, sessionToText(*document, expected.parent_path())));
    QTest::qWait(patiently(120'000)); // until it is killed
    QFAIL("nobody has killed it");
}

QTEST_MAIN(EditingSessionTest)
#include "editing_session_test.moc"
