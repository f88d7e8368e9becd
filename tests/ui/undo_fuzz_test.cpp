// SPDX-License-Identifier: GPL-3.0-or-later
// Undo over the whole view (R18, R27), query, look, isovalues, annotations, film, camera and background: whatever was
// edited, undoing all ends where it began, with every step in between as it was, and redoing all ends where it was
// left, while workers prepare what is seen. Saved and opened again it is the same, too.
#include "tests/ui/random_edits.h"
#include "tests/ui/sample_files.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"
#include "ui/session/workbench.h"
#include "ui/viewport/view_history.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

constexpr int edits = 5000;
constexpr int editsBetweenEvents = 100; ///< edits from one look at the event loop to the next

} // namespace

class UndoFuzzTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void undoingAllEndsWhereItBegan_data();
    void undoingAllEndsWhereItBegan();

private:
    Session& session() { return workbench_->session(); }
    void edit(RandomEdits& some, std::mt19937& random);
    Moment now() { return momentOf(session(), *viewport_); }
    bool isAsRemembered() { return now() == states_[std::size_t(session().undoStack().index())]; }
    void waitForTheScene();
    void savedAndOpenedItIsTheSame();

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    QString model_;
    std::unique_ptr<Workbench> workbench_;
    std::unique_ptr<Viewport> viewport_;
    std::vector<Moment> states_; ///< by the index of the undo stack
};

void UndoFuzzTest::initTestCase()
{
    host_ = hostOfThisBuild();
    model_ = QString::fromStdString(buildSampleModel(*host_, sampleDataset(12), folder_.path().toStdString()).string());
}

void UndoFuzzTest::undoingAllEndsWhereItBegan_data()
{
    QTest::addColumn<unsigned>("seed");
    QTest::newRow("first") << 1u;
    QTest::newRow("second") << 2u;
}

/// Mostly an edit, sometimes some steps back or forth.
void UndoFuzzTest::edit(RandomEdits& some, std::mt19937& random)
{
    QUndoStack& stack = session().undoStack();
    if (random() % 20 != 0)
        return some.editOnce();
    const bool back = random() % 2 == 0;
    for (auto steps = random() % 6; steps > 0; --steps)
        back ? stack.undo() : stack.redo();
}

void UndoFuzzTest::waitForTheScene()
{
    QTRY_VERIFY_WITH_TIMEOUT(!workbench_->sceneBuilder().busy(), 60'000);
}

void UndoFuzzTest::savedAndOpenedItIsTheSame()
{
    auto document = workbench_->sessionDocument();
    QVERIFY(document.has_value());
    document->camera = viewport_->camera();
    document->background = viewport_->chosenBackground();
    const std::filesystem::path file = filePath(folder_.filePath("kept.tansession"));
    QVERIFY(writeTextFile(file, sessionToText(*document, file.parent_path())));

    Workbench other(*host_, filePath(folder_.filePath("views")));
    Viewport viewport(BackendChoice::Cpu);
    connect(&other, &Workbench::viewRestored, &viewport, [&viewport](const SessionDocument& restored) {
        viewport.startFrom(restored.camera.value_or(Camera{}), restored.background);
    });
    other.open(pathText(file));
    QTRY_VERIFY(other.session().model());
    QVERIFY(momentOf(other.session(), viewport) == now());
}

void UndoFuzzTest::undoingAllEndsWhereItBegan()
{
    QFETCH(unsigned, seed);
    workbench_ = std::make_unique<Workbench>(*host_);
    viewport_ = std::make_unique<Viewport>(BackendChoice::Cpu);
    const ViewHistory history(*viewport_, session().undoStack(), nullptr);
    workbench_->open(model_);
    QTRY_VERIFY(session().model());
    viewport_->startFitted(Camera(), session().model()->description().bounds);
    std::vector<std::string> modes{"no such mode"};
    for (const auto& mode : workbench_->modes())
        modes.push_back(mode.id);
    QVERIFY(modes.size() > 2);

    std::mt19937 random(seed);
    RandomEdits some(session(), *viewport_, modes, seed);
    QUndoStack& stack = session().undoStack();
    states_ = {now()};
    for (int done = 0; done < edits; ++done) {
        const int before = stack.index();
        edit(some, random);
        const auto index = std::size_t(stack.index());
        // A step back, or a drag that came back to where it began, shows what was seen then.
        if (stack.index() < before)
            QVERIFY2(isAsRemembered(), qPrintable(QString("edit %1").arg(done)));
        states_.resize(std::max(states_.size(), index + 1));
        states_[index] = now();
        QVERIFY(states_[index] == states_[index]); // no numbers that are none
        if (done % editsBetweenEvents == 0)
            QCoreApplication::processEvents();
    }
    some.finish();
    waitForTheScene();
    const Moment last = now();
    const int steps = stack.count();
    QVERIFY(steps > edits / 4);

    while (stack.canRedo()) { // steps that were taken back at the end
        stack.redo();
        QVERIFY(isAsRemembered());
    }
    while (stack.canUndo()) {
        stack.undo();
        QVERIFY2(isAsRemembered(), qPrintable(QString("undone to %1").arg(stack.index())));
    }
    QVERIFY(now() == states_.front());
    while (stack.canRedo()) {
        stack.redo();
        QVERIFY2(isAsRemembered(), qPrintable(QString("redone to %1").arg(stack.index())));
    }
    QCOMPARE(stack.count(), steps);
    QVERIFY(std::ranges::find(states_, last) != states_.end());
    waitForTheScene();
    savedAndOpenedItIsTheSame();
    session().undoStack().clear(); // its steps are about the viewport, which goes first
    viewport_.reset();
    workbench_.reset();
}

QTEST_MAIN(UndoFuzzTest)
#include "undo_fuzz_test.moc"
