// SPDX-License-Identifier: GPL-3.0-or-later
// Undo over the whole view (R18, R27): whatever was edited, undoing all ends where it began, with every step in between
// as it was, and redoing all ends where it was left, while workers prepare what is seen; and what is left is what a
// session that is saved then shows when it is opened again.
#include "tests/soak.h"
#include "tests/ui/random_edits.h"
#include "tests/ui/sample_files.h"
#include "ui/workbench/workbench.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

namespace {

constexpr int edits = 10'000;
constexpr int between = 100; ///< edits from one look at the event loop to the next

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
    bool isAsRemembered() { return session().view() == states_[std::size_t(session().undoStack().index())]; }
    void waitForTheScene();
    void saveAndOpenAgain();

    QTemporaryDir folder_;
    std::unique_ptr<PluginHost> host_;
    QString model_;
    std::unique_ptr<Workbench> workbench_;
    std::vector<ViewValue> states_; ///< by the index of the undo stack
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
    QTRY_VERIFY_WITH_TIMEOUT(!workbench_->scenes().sceneBuilder().busy(), 60'000);
}

/// A mode that is not known is not opened again.
void UndoFuzzTest::saveAndOpenAgain()
{
    session().setMode(workbench_->scenes().modes().front().id);
    const ViewValue saved = session().view();
    const std::filesystem::path file = folder_.filePath("left.tansession").toStdString();
    bool isSaved = false;
    workbench_->opening().sessionFile().save(file, *workbench_->opening().sessions().document(),
                                             [&](bool worked) { isSaved = worked; });
    QTRY_VERIFY(isSaved);
    session().setView(states_.front());
    const QSignalSpy opened(&workbench_->opening().models(), &ModelOpening::viewRestored);
    workbench_->opening().sessions().open(file, SessionSource::File);
    QTRY_COMPARE(opened.count(), 1);
    QCOMPARE(session().undoStack().count(), 0);
    QVERIFY2(session().view() == saved, viewToText(session().view()).c_str());
}

void UndoFuzzTest::undoingAllEndsWhereItBegan()
{
    QFETCH(unsigned, seed);
    workbench_ = std::make_unique<Workbench>(*host_);
    workbench_->opening().open(model_);
    QTRY_VERIFY(session().model());
    std::vector<std::string> modes{"no such mode"};
    for (const auto& mode : workbench_->scenes().modes())
        modes.push_back(mode.id);
    QVERIFY(modes.size() > 2);

    std::mt19937 random(seedOf(seed));
    RandomEdits some(session(), modes, seedOf(seed));
    QUndoStack& stack = session().undoStack();
    states_ = {session().view()};
    for (int done = 0; done < edits; ++done) {
        const int before = stack.index();
        edit(some, random);
        const auto index = std::size_t(stack.index());
        // A step back, or a drag that came back to where it began, shows what was seen then.
        if (stack.index() < before)
            QVERIFY2(isAsRemembered(), qPrintable(QString("edit %1").arg(done)));
        states_.resize(std::max(states_.size(), index + 1));
        states_[index] = session().view();
        QVERIFY(states_[index] == states_[index]); // no numbers that are none
        if (done % between == 0)
            QCoreApplication::processEvents();
    }
    some.finish();
    waitForTheScene();
    const ViewValue last = session().view();
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
    QVERIFY(session().view() == states_.front());
    while (stack.canRedo()) {
        stack.redo();
        QVERIFY2(isAsRemembered(), qPrintable(QString("redone to %1").arg(stack.index())));
    }
    QCOMPARE(stack.count(), steps);
    QVERIFY(std::ranges::find(states_, last) != states_.end());
    waitForTheScene();
    saveAndOpenAgain();
    workbench_.reset();
}

QTEST_MAIN(UndoFuzzTest)
#include "undo_fuzz_test.moc"
