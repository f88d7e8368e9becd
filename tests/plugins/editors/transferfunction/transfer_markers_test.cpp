// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QDoubleSpinBox>
#include <QToolButton>

#include <cmath>

using namespace tetra;

/// Isovalues and the mask in the plot of the transfer function (R18, R19): dragged, moved by keys and in numbers.
class TransferMarkersTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-markers"); }
    void init()
    {
        startAnew(editor_, model_);
        while (!isovalues().empty())
            editor_->session().removeIsovalue(0);
        editor_->session().addIsovalue(atShare(0.33));
        editor_->session().addIsovalue(atShare(0.71));
    }
    void anIsovalueIsDragged();
    void anIsovalueIsMovedByKeysAndRemoved();
    void anIsovalueIsEditedInNumbers();
    void anIsovalueIsAddedFromTheMenu();
    void theMaskIsMadeDraggedAndRemoved();
    void theMaskIsMadeAroundTheSelectedPoints();

private:
    JoinedFunction function() const { return editor_->function(); }
    const std::vector<Isovalue>& isovalues() const { return editor_->session().view().isovalues; }
    double atShare(double share) const
    {
        return std::lerp(editor_->session().range().minimum, editor_->session().range().maximum, share);
    }
    /// Of the handle above the plot.
    QPoint handleAt(double value) const
    {
        const TransferPlot plot = editor_->canvas().plot();
        return {static_cast<int>(std::lround(plot.x(value))), static_cast<int>(plot.area.top()) - 4};
    }
    double pixel() const
    {
        const TransferPlot plot = editor_->canvas().plot();
        return (plot.limits.largest - plot.limits.least) / plot.area.width();
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferMarkersTest::anIsovalueIsDragged()
{
    const std::vector<Isovalue> before = isovalues();
    const JoinedFunction transfer = function();
    const int steps = editor_->undoSteps();
    const QPoint from = handleAt(before[0].value);
    QVERIFY(editor_->canvas().itemAt(from) == (EditorItem{EditorItem::Kind::Isovalue, 0}));
    editor_->drag(from, from + QPoint(30, 0));
    QVERIFY(std::abs(isovalues()[0].value - before[0].value - 30 * pixel()) <= pixel());
    QCOMPARE(isovalues()[1].value, before[1].value);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    QCOMPARE(function(), transfer);
    QVERIFY(editor_->canvas().accessibleDescription().startsWith("Isovalue 1 of 2"));
    editor_->undo();
    QCOMPARE(isovalues()[0].value, before[0].value);
}

void TransferMarkersTest::anIsovalueIsMovedByKeysAndRemoved()
{
    const std::vector<Isovalue> before = isovalues();
    editor_->canvas().setFocus();
    editor_->state().setCurrent({EditorItem::Kind::Point, function().points.size() - 1});
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab);
    QVERIFY(editor_->state().current() == (EditorItem{EditorItem::Kind::Isovalue, 0}));
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Left);
    QVERIFY(isovalues()[1].value < before[1].value);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Delete);
    QCOMPARE(isovalues().size(), std::size_t{1});
    editor_->undo();
    editor_->undo();
    QCOMPARE(isovalues(), before);
}

void TransferMarkersTest::anIsovalueIsEditedInNumbers()
{
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, handleAt(isovalues()[1].value));
    auto& value = editor_->find<QDoubleSpinBox>("transfer.value");
    value.setValue(atShare(0.5));
    QCOMPARE(isovalues()[1].value, value.value());
    editor_->find<QDoubleSpinBox>("transfer.opacity").setValue(25);
    QCOMPARE(isovalues()[1].opacity, 0.25F);
}

void TransferMarkersTest::anIsovalueIsAddedFromTheMenu()
{
    editor_->find<QAction>("transfer.change.addIsovalue").trigger();
    QCOMPARE(isovalues().size(), std::size_t{3});
    QVERIFY(std::abs(isovalues().back().value - atShare(0.5)) <= pixel());
}

void TransferMarkersTest::theMaskIsMadeDraggedAndRemoved()
{
    const JoinedFunction before = function();
    auto& button = editor_->find<QToolButton>("transfer.mask");
    button.click();
    QVERIFY(function().mask.has_value());
    const TransferMask made = *function().mask;
    const int steps = editor_->undoSteps();
    const QPoint from = handleAt(made.least);
    QVERIFY(editor_->canvas().itemAt(from).kind == EditorItem::Kind::MaskLeast);
    editor_->drag(from, from + QPoint(20, 0));
    QVERIFY(std::abs(function().mask->least - made.least - 20 * pixel()) <= pixel());
    QCOMPARE(function().mask->largest, made.largest);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->drag(handleAt(function().mask->least), handleAt(atShare(1)));
    QCOMPARE(function().mask->least, made.largest); // no farther than the other end
    editor_->undo();
    editor_->state().setCurrent({EditorItem::Kind::MaskLargest});
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Left);
    QVERIFY(function().mask->largest < made.largest);
    button.click();
    QCOMPARE(function(), before);
    editor_->undo();
    QVERIFY(function().mask.has_value() && button.isChecked());
    editor_->state().setCurrent({EditorItem::Kind::MaskLeast});
    QTest::keyClick(&editor_->canvas(), Qt::Key_Delete);
    QCOMPARE(function(), before);
}

void TransferMarkersTest::theMaskIsMadeAroundTheSelectedPoints()
{
    editor_->state().select({2, 3, 6});
    editor_->find<QAction>("transfer.change.mask").trigger();
    QCOMPARE(*function().mask, (TransferMask{function().points[2].value, function().points[6].value}));
    QTRY_VERIFY(editor_->settled());
    editor_->find<QAction>("transfer.change.mask").trigger();
    QVERIFY(!function().mask);
}

QTEST_MAIN(TransferMarkersTest)
#include "transfer_markers_test.moc"
