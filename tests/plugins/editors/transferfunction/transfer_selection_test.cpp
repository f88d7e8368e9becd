// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/moving.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <cmath>

using namespace tetra;

/// Several points at once in the editor of the transfer function (R18): selected by frame, click and key, moved
/// together, with a rule for the points in the way; points added on the curve, and the two sides of a step.
class TransferSelectionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-selection"); }
    void init() { startAnew(editor_, model_); }
    void aFrameSelects();
    void clicksSelect();
    void keysSelect();
    void aClickOnOneOfManySelectsIt();
    void manyAreDraggedInOneStep();
    void manyAreMovedByKeys();
    void neighboursStopArePushedOrPassed_data();
    void neighboursStopArePushedOrPassed();
    void aClickOnTheCurveAddsAPoint();
    void sidesOfAStepAreGrabbedBesideEachOther();
    void shiftKeepsADragStraight();
    void undoKeepsTheSelectionThatFits();

private:
    JoinedFunction function() const { return editor_->function(); }
    TransferSelection selection() const { return editor_->state().selection(); }
    void click(std::size_t point, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, modifiers, editor_->placeOf(point));
    }
    /// A frame around some points that follow each other.
    void frame(std::size_t first, std::size_t last, Qt::KeyboardModifiers modifiers = {}) const
    {
        const QRect around = QRect(editor_->placeOf(first), editor_->placeOf(last)).normalized();
        const QRectF area = editor_->canvas().plot().area;
        editor_->drag({around.left() - 6, static_cast<int>(area.top()) + 1},
                      {around.right() + 6, static_cast<int>(area.bottom()) + 12}, modifiers);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferSelectionTest::aFrameSelects()
{
    const int steps = editor_->undoSteps();
    frame(2, 4);
    QCOMPARE(selection(), (TransferSelection{2, 3, 4}));
    frame(6, 7, Qt::ShiftModifier);
    QCOMPARE(selection(), (TransferSelection{2, 3, 4, 6, 7}));
    frame(1, 1);
    QCOMPARE(selection(), TransferSelection{1});
    QCOMPARE(editor_->undoSteps(), steps); // selecting is no edit
}

void TransferSelectionTest::clicksSelect()
{
    click(1);
    QCOMPARE(selection(), TransferSelection{1});
    click(4, Qt::ControlModifier);
    QCOMPARE(selection(), (TransferSelection{1, 4}));
    click(1, Qt::ControlModifier);
    QCOMPARE(selection(), TransferSelection{4});
    click(7, Qt::ShiftModifier);
    QCOMPARE(selection(), (TransferSelection{4, 5, 6, 7}));
    const QRectF area = editor_->canvas().plot().area;
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, (area.topLeft() + QPointF(20, 4)).toPoint());
    QVERIFY(selection().empty());
}

void TransferSelectionTest::keysSelect()
{
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(selection(), allPoints(function()));
    QVERIFY(editor_->canvas().accessibleDescription().contains("9 points are selected"));
    QTest::keyClick(&editor_->canvas(), Qt::Key_Escape);
    QVERIFY(selection().empty());
}

void TransferSelectionTest::aClickOnOneOfManySelectsIt()
{
    frame(2, 4);
    click(3);
    QCOMPARE(selection(), TransferSelection{3});
}

void TransferSelectionTest::manyAreDraggedInOneStep()
{
    frame(3, 4);
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    const QPoint from = editor_->placeOf(3);
    editor_->drag(from, from + QPoint(3, -9));
    QCOMPARE(editor_->undoSteps(), steps + 1);
    const double by = function().points[3].value - before.points[3].value;
    QVERIFY(by > 0);
    QVERIFY(std::abs(function().points[4].value - before.points[4].value - by) < 1e-9);
    for (const std::size_t point : {std::size_t{3}, std::size_t{4}})
        QVERIFY(function().points[point].opacity > before.points[point].opacity);
    QCOMPARE(function().points[2], before.points[2]);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferSelectionTest::manyAreMovedByKeys()
{
    frame(3, 4);
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Up, Qt::ShiftModifier);
    const float far = function().points[3].opacity - before.points[3].opacity;
    editor_->undo();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Up);
    const float usual = function().points[3].opacity - before.points[3].opacity;
    editor_->undo();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Up, Qt::ControlModifier);
    const float fine = function().points[3].opacity - before.points[3].opacity;
    QVERIFY(0 < fine && fine < usual && usual < far);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Delete);
    QCOMPARE(function().points.size(), before.points.size() - 2);
}

void TransferSelectionTest::neighboursStopArePushedOrPassed_data()
{
    QTest::addColumn<QString>("rule");
    QTest::addColumn<NeighbourRule>("kind");
    QTest::newRow("stop") << "stop" << NeighbourRule::Stop;
    QTest::newRow("push") << "push" << NeighbourRule::Push;
    QTest::newRow("pass") << "pass" << NeighbourRule::Pass;
}

void TransferSelectionTest::neighboursStopArePushedOrPassed()
{
    QFETCH(QString, rule);
    QFETCH(NeighbourRule, kind);
    editor_->find<QAction>("transfer.change.rule." + rule).trigger();
    const JoinedFunction before = function();
    const TransferPlot plot = editor_->canvas().plot();
    const QPoint from = editor_->placeOf(3), to(editor_->placeOf(5).x() + 5, from.y());
    editor_->drag(from, to);
    const double by = (to.x() - from.x()) / plot.area.width() * (plot.limits.largest - plot.limits.least);
    QCOMPARE(function(), moveSelected(before, {3}, {by, 0, plot.axis}, kind, editor_->state().limits()).function);
    QCOMPARE(selection(), TransferSelection{kind == NeighbourRule::Pass ? std::size_t{5} : std::size_t{3}});
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferSelectionTest::aClickOnTheCurveAddsAPoint()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    const TransferPlot plot = editor_->canvas().plot();
    const double value = std::lerp(before.points[5].value, before.points[6].value, 0.5);
    const QPoint place = QPointF(plot.x(value), plot.y(opacityOf(separated(before), value))).toPoint();
    editor_->drag(place, place + QPoint(0, -20));
    QCOMPARE(function().points.size(), before.points.size() + 1);
    QCOMPARE(selection(), TransferSelection{6});
    QVERIFY(function().points[6].opacity > opacityOf(separated(before), value));
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferSelectionTest::sidesOfAStepAreGrabbedBesideEachOther()
{
    editor_->session().setTransfer(separated(withStep(function(), 4).function));
    const JoinedFunction before = function();
    QVERIFY(editor_->placeOf(4).x() < editor_->placeOf(5).x());
    editor_->drag(editor_->placeOf(5), editor_->placeOf(5) + QPoint(0, -25));
    QVERIFY(function().points[5].opacity > before.points[5].opacity);
    QCOMPARE(function().points[4], before.points[4]);
    editor_->drag(editor_->placeOf(4), editor_->placeOf(4) + QPoint(5, 20));
    QVERIFY(function().points[4].opacity < before.points[4].opacity);
    QVERIFY(function().points[4].value > before.points[4].value);
    QCOMPARE(function().points[4].value, function().points[5].value);
}

void TransferSelectionTest::shiftKeepsADragStraight()
{
    const JoinedFunction before = function();
    const QPoint from = editor_->placeOf(4);
    QTest::mousePress(&editor_->canvas(), Qt::LeftButton, {}, from);
    editor_->dragTo(from + QPoint(3, -20), Qt::ShiftModifier);
    QTest::mouseRelease(&editor_->canvas(), Qt::LeftButton, {}, from + QPoint(3, -20));
    QCOMPARE(function().points[4].value, before.points[4].value);
    QVERIFY(function().points[4].opacity > before.points[4].opacity);
}

void TransferSelectionTest::undoKeepsTheSelectionThatFits()
{
    const QPoint place = editor_->canvas().plot().area.center().toPoint() + QPoint(13, -40);
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, place);
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(selection().size(), std::size_t{10});
    editor_->undo();
    QCOMPARE(selection(), allPoints(function()));
}

QTEST_MAIN(TransferSelectionTest)
#include "transfer_selection_test.moc"
