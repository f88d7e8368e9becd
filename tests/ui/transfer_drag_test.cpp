// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/viewport/transfer_drag.h"

using namespace tetra;

/// The transfer function dragged in the picture (R18): sideways it is shifted, up and down widened.
class TransferDragTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void sidewaysShiftsAndUpwardsWidens();
    void aDragIsOneStepAndTurnsNothing();
    void withoutTheKeyTheCameraTurns();
    void isosurfacesHaveNoFunctionToDrag();

private:
    void open(WindowFixture& window, const char* mode) const;
    static void drag(Viewport& viewport, QPoint by, Qt::KeyboardModifiers modifiers);

    QTemporaryDir folder_;
    QString model_;
};

void TransferDragTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("transfer-drag");
    QSettings().clear();
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(12), folder_.path().toStdString()).string());
}

void TransferDragTest::open(WindowFixture& window, const char* mode) const
{
    window.window.resize(1280, 900);
    window.window.show();
    window.window.open(model_);
    QTRY_VERIFY(window.workbench.session().model() && window.settled());
    window.find<QAction>(QString("action.mode.") + mode).trigger();
    QTRY_VERIFY(window.settled());
}

void TransferDragTest::drag(Viewport& viewport, QPoint by, Qt::KeyboardModifiers modifiers)
{
    const QPoint from = viewport.rect().center();
    QTest::mousePress(&viewport, Qt::LeftButton, modifiers, from);
    for (const QPoint& to : {from + by / 2, from + by}) {
        QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&viewport, &move);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, modifiers, from + by);
}

void TransferDragTest::sidewaysShiftsAndUpwardsWidens()
{
    const TransferFunction before =
        transferFunctionFromPoints({{2, {1, 0, 0}, 0.1F}, {4, {0, 1, 0}, 0.7F}, {6, {0, 0, 1}, 0.2F}}, 1);
    const TransferFunction right = draggedTransfer(before, {50, 0}, {200, 100}, {0, 8});
    QCOMPARE(right.opacities[1].value, 6.0);
    QCOMPARE(right.opacities[2].value, 8.0);
    const TransferFunction up = draggedTransfer(before, {0, -25}, {200, 100}, {0, 8});
    QCOMPARE(up.opacities[0].value, 0.0);
    QCOMPARE(up.opacities[2].value, 8.0);
    QCOMPARE(up.opacities[1], before.opacities[1]);
    QCOMPARE(draggedTransfer(before, {5, 5}, {0, 0}, {0, 8}), before);
    QCOMPARE(draggedTransfer({}, {5, 5}, {200, 100}, {0, 8}), TransferFunction());
}

void TransferDragTest::aDragIsOneStepAndTurnsNothing()
{
    WindowFixture window;
    open(window, "volume");
    Session& session = window.workbench.session();
    const TransferFunction before = session.view().appearance.transfer;
    const Camera camera = window.viewport().camera();
    const int steps = session.undoStack().index();
    drag(window.viewport(), {60, -20}, Qt::ControlModifier);
    const TransferFunction& after = session.view().appearance.transfer;
    QCOMPARE(after, draggedTransfer(before, {60, -20}, window.viewport().size(), session.range()));
    QVERIFY(after != before);
    QCOMPARE(session.undoStack().index(), steps + 1);
    QCOMPARE(window.viewport().camera(), camera);
    QVERIFY(!session.inGesture());
    window.find<QAction>("action.undo").trigger();
    QCOMPARE(session.view().appearance.transfer, before);
}

void TransferDragTest::withoutTheKeyTheCameraTurns()
{
    WindowFixture window;
    open(window, "volume");
    const TransferFunction before = window.workbench.session().view().appearance.transfer;
    const Camera camera = window.viewport().camera();
    drag(window.viewport(), {60, -20}, {});
    QCOMPARE(window.workbench.session().view().appearance.transfer, before);
    QVERIFY(!(window.viewport().camera() == camera));
}

void TransferDragTest::isosurfacesHaveNoFunctionToDrag()
{
    WindowFixture window;
    open(window, "isosurface");
    const TransferFunction before = window.workbench.session().view().appearance.transfer;
    drag(window.viewport(), {60, -20}, Qt::ControlModifier);
    QCOMPARE(window.workbench.session().view().appearance.transfer, before);
}

QTEST_MAIN(TransferDragTest)
#include "transfer_drag_test.moc"
