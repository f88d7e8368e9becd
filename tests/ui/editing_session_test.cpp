// SPDX-License-Identifier: GPL-3.0-or-later
// A long session at work: thousands of edits with pictures do not fill the memory (R27).
#include "tests/ui/random_edits.h"
#include "tests/ui/sample_files.h"
#include "ui/session/workbench.h"
#include "ui/viewport/canvas.h"
#include "ui/work/steady_heap.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define TAN_HEAP_IS_COUNTED
extern "C" std::size_t __sanitizer_get_current_allocated_bytes(); // GCC has it, but not its header
#elif defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace tetra;

namespace {

constexpr int edits = 10'000;
constexpr int warmUp = 2500;
constexpr int betweenPictures = 20;
constexpr double allowedMegabytes = 20;

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

} // namespace

class EditingSessionTest : public QObject {
    Q_OBJECT
private slots:
    void memoryDoesNotGrow();

private:
    void openModel();
    void lookAtIt();
    double megabytesAtRest();

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<Canvas> canvas_;
    View view_;
    int pictures_ = 0;
};

/// A workbench with a canvas that shows its scenes, and drafts of them while somebody drags, as the window has them.
void EditingSessionTest::openModel()
{
    host_ = hostOfThisBuild();
    workbench_ = std::make_unique<Workbench>(*host_);
    canvas_ = std::make_unique<Canvas>();
    connect(canvas_.get(), &Canvas::failed, this, [](const QString& text) { QFAIL(qPrintable(text)); });
    connect(canvas_.get(), &Canvas::framePainted, this, [this] { ++pictures_; });
    canvas_->resize(320, 240);
    canvas_->setView(view_);
    canvas_->show();
    connect(&workbench_->scenes().sceneBuilder(), &SceneBuilder::sceneReady, this, [this](const BuiltScene& scene) {
        view_.levels = {{scene.scene, scene.mesh.tetrahedra}};
        canvas_->setView(view_);
    });
    connect(&workbench_->scenes().draftBuilder(), &DraftBuilder::draftsReady, this,
            [this](const std::vector<DraftScene>& drafts) {
                view_.levels.resize(std::min<std::size_t>(view_.levels.size(), 1));
                for (const DraftScene& draft : drafts)
                    if (!view_.levels.empty())
                        view_.levels.push_back({draft.scene, draft.tetrahedra});
                canvas_->setView(view_);
            });
    connect(&workbench_->session(), &Session::gestureChanged, this, [this](bool on) {
        view_.moving = on;
        canvas_->setView(view_);
    });
    workbench_->opening().open(
        QString::fromStdString(buildSampleModel(*host_, sampleDataset(16), folder_.path().toStdString()).string()));
    QTRY_VERIFY(workbench_->session().model());
    view_.camera = fitted(Camera(), workbench_->session().model()->description().bounds);
}

void EditingSessionTest::lookAtIt()
{
    QTRY_VERIFY_WITH_TIMEOUT(!workbench_->scenes().sceneBuilder().busy(), 60'000);
    QTRY_VERIFY_WITH_TIMEOUT(view_.moving || canvas_->settled(), 60'000);
}

/// Of the same mesh each time, whatever was edited.
double EditingSessionTest::megabytesAtRest()
{
    Session& session = workbench_->session();
    session.endGesture();
    session.setQuery(startingQuery(*session.model(), 1));
    session.setMode("volume");
    lookAtIt();
    trimHeap();
    return *megabytesHeld();
}

void EditingSessionTest::memoryDoesNotGrow()
{
    if (!megabytesHeld())
        QSKIP("skipped: no /proc/self/status");
    keepHeapSteady(); // as the program does
    openModel();
    std::vector<std::string> modes;
    for (const auto& mode : workbench_->scenes().modes())
        modes.push_back(mode.id);
    RandomEdits some(workbench_->session(), modes, 7);
    double warm = 0;
    for (int done = 0; done < edits; ++done) {
        some.editOnce();
        if (done % betweenPictures == 0)
            lookAtIt();
        if (done == warmUp)
            warm = megabytesAtRest();
    }
    const double grown = megabytesAtRest() - warm;
    workbench_->session().undoStack().clear();
    const double history = warm + grown - megabytesAtRest();
    qInfo("%.1f MB after %d edits, %.1f MB more after %d, of which %.1f MB are the history", warm, warmUp, grown, edits,
          history);
    QVERIFY(pictures_ > edits / betweenPictures / 2);
    QVERIFY2(grown <= allowedMegabytes, qPrintable(QString("%1 MB more").arg(grown)));
    canvas_.reset();
    workbench_.reset();
}

QTEST_MAIN(EditingSessionTest)
#include "editing_session_test.moc"
