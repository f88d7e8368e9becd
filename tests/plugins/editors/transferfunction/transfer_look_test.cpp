// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/editors/transferfunction/value_text.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QCheckBox>
#include <QLabel>
#include <QWheelEvent>

#include <cmath>

using namespace tetra;

/// How the plot of the transfer function is looked at (R18): zoomed, moved, with other axes; and what it says of the
/// value at the pointer. None of it is an edit.
class TransferLookTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-look"); }
    void init()
    {
        startAnew(editor_, model_);
        before_ = editor_->function();
        steps_ = editor_->undoSteps();
    }
    void cleanup()
    {
        QCOMPARE(editor_->function(), before_);
        QCOMPARE(editor_->undoSteps(), steps_);
    }
    void theWheelZoomsAtThePointer();
    void theWheelWithControlZoomsOpacities();
    void keysZoomAndShowAll();
    void valuesBelowThePlotDoNotTouch();
    void theMiddleButtonMovesTheView();
    void whatIsOutsideIsMarked();
    void theAxisOfOpacitiesChanges_data();
    void theAxisOfOpacitiesChanges();
    void theReadOutFollowsThePointer();
    void theHistogramChangesItsScale();
    void thePlotIsPaintedInEveryState();

private:
    TransferPlot plot() const { return editor_->canvas().plot(); }
    void turnWheel(QPoint place, int notches, Qt::KeyboardModifiers modifiers = {}) const
    {
        editor_->canvas().setFocus();
        QWheelEvent event(place, editor_->canvas().mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton,
                          modifiers, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&editor_->canvas(), &event);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
    JoinedFunction before_;
    int steps_ = 0;
};

void TransferLookTest::valuesBelowThePlotDoNotTouch()
{
    const QFontMetrics font = editor_->canvas().fontMetrics();
    for (const TransferLimits limits : {TransferLimits{0, 1}, {101325.0, 101325.4}, {-1.23456e-7, 3.33333e37}})
        for (double width = 40; width < 700; width += 20) {
            TransferPlot plot{{30, 10, width, 80}, limits};
            const auto labels = valueLabels(plot, font);
            QCOMPARE(labels.front().text, textOfValue(limits.least, limits, false));
            for (std::size_t i = 0; i < labels.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    QVERIFY2(!labels[i].place.adjusted(-2, 0, 2, 0).intersects(labels[j].place),
                             qPrintable(labels[i].text));
            if (width > 500)
                QCOMPARE(labels.size(), std::size_t(3));
        }
}

void TransferLookTest::theWheelZoomsAtThePointer()
{
    const TransferPlot all = plot();
    const QPoint place(static_cast<int>(all.area.left() + 0.3 * all.area.width()), 60);
    const double value = all.valueAt(place.x());
    turnWheel(place, 3);
    QVERIFY(plot().limits.largest - plot().limits.least < 0.6 * (all.limits.largest - all.limits.least));
    QVERIFY(std::abs(plot().valueAt(place.x()) - value) < 1e-6 * (all.limits.largest - all.limits.least));
    turnWheel(place, -20);
    QCOMPARE(plot().limits.least, all.limits.least);
    QCOMPARE(plot().limits.largest, all.limits.largest);
}

void TransferLookTest::theWheelWithControlZoomsOpacities()
{
    const QPoint place(150, static_cast<int>(plot().area.bottom()) - 20);
    const double height = plot().heightAt(place.y());
    turnWheel(place, 4, Qt::ControlModifier);
    QVERIFY(plot().heights.largest - plot().heights.least < 0.5);
    QVERIFY(std::abs(plot().heightAt(place.y()) - height) < 1e-9);
    turnWheel(place, -20, Qt::ControlModifier);
    QCOMPARE(plot().heights.least, 0.0);
    QCOMPARE(plot().heights.largest, 1.0);
}

void TransferLookTest::keysZoomAndShowAll()
{
    const TransferPlot all = plot();
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Plus);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Plus, Qt::ControlModifier);
    const TransferPlot zoomed = plot();
    QVERIFY(zoomed.limits.least > all.limits.least && zoomed.limits.largest < all.limits.largest);
    QVERIFY(zoomed.heights.least > 0 && zoomed.heights.largest < 1);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Right, Qt::AltModifier);
    QVERIFY(plot().limits.least > zoomed.limits.least);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Home);
    QCOMPARE(plot().limits.least, all.limits.least);
    QCOMPARE(plot().heights.largest, 1.0);
    editor_->state().select({2, 5});
    editor_->find<QAction>("transfer.zoom.selection").trigger();
    QCOMPARE(plot().limits.least, before_.points[2].value);
    editor_->find<QAction>("transfer.zoom.all").trigger();
    QCOMPARE(plot().limits.least, all.limits.least);
}

void TransferLookTest::theMiddleButtonMovesTheView()
{
    turnWheel(plot().area.center().toPoint(), 4);
    const TransferPlot before = plot();
    const QPoint from = before.area.center().toPoint();
    QTest::mousePress(&editor_->canvas(), Qt::MiddleButton, {}, from);
    const QPoint to = from - QPoint(30, 0);
    QMouseEvent move(QEvent::MouseMove, to, editor_->canvas().mapToGlobal(to), Qt::NoButton, Qt::MiddleButton, {});
    QCoreApplication::sendEvent(&editor_->canvas(), &move);
    QTest::mouseRelease(&editor_->canvas(), Qt::MiddleButton, {}, to);
    QVERIFY(std::abs(plot().valueAt(to.x()) - before.valueAt(from.x())) < 1e-9 * std::abs(before.limits.largest));
}

void TransferLookTest::whatIsOutsideIsMarked()
{
    QCOMPARE(countOutside(editor_->state()).left + countOutside(editor_->state()).right, 0);
    const QImage whole = editor_->canvas().grab().toImage();
    editor_->state().setView({TransferLimits{before_.points[3].value, before_.points[6].value}, {}});
    QVERIFY(countOutside(editor_->state()).left >= 3);
    QVERIFY(countOutside(editor_->state()).right >= 2);
    const QColor highlight = editor_->canvas().palette().color(QPalette::Highlight);
    const QPointF mark = plot().area.center() - QPointF(plot().area.width() / 2 - 4, 6);
    const QImage zoomed = editor_->canvas().grab().toImage();
    const qreal ratio = zoomed.devicePixelRatio();
    QCOMPARE(zoomed.pixelColor((mark * ratio).toPoint()), highlight);
    QVERIFY(whole.pixelColor((mark * ratio).toPoint()) != highlight);
}

void TransferLookTest::theAxisOfOpacitiesChanges_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<OpacityAxis>("axis");
    QTest::newRow("linear") << "linear" << OpacityAxis::Linear;
    QTest::newRow("square root") << "squareRoot" << OpacityAxis::SquareRoot;
    QTest::newRow("logarithmic") << "logarithmic" << OpacityAxis::Logarithmic;
}

void TransferLookTest::theAxisOfOpacitiesChanges()
{
    QFETCH(QString, name);
    QFETCH(OpacityAxis, axis);
    editor_->find<QAction>("transfer.axis." + name).trigger();
    QVERIFY(editor_->find<QAction>("transfer.axis." + name).isChecked());
    const TransferPlot now = plot();
    for (const double opacity : {0.0, 0.01, 0.3, 1.0}) {
        QVERIFY(std::abs(now.area.bottom() - now.y(opacity) - heightOf(opacity, axis) * now.area.height()) < 1e-6);
        QVERIFY(std::abs(now.opacityAt(now.y(opacity)) - opacity) < 1e-9);
    }
}

void TransferLookTest::theReadOutFollowsThePointer()
{
    auto& readOut = editor_->find<QLabel>("transfer.readOut");
    const QPoint place = plot().area.center().toPoint();
    QTest::mouseMove(&editor_->canvas(), place);
    QMouseEvent move(QEvent::MouseMove, place, editor_->canvas().mapToGlobal(place), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&editor_->canvas(), &move);
    const double value = plot().valueAt(place.x());
    QCOMPARE(readOut.accessibleName(), plainReadOutOf(editor_->state(), value));
    QVERIFY(readOut.text().contains(textOfValue(value, plot().limits, false)));
    QVERIFY(readOut.text().contains("vertices"));
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&editor_->canvas(), &leave);
    QVERIFY(!readOut.text().contains("vertices"));
}

void TransferLookTest::theHistogramChangesItsScale()
{
    const QImage logarithmic = editor_->canvas().grab().toImage();
    editor_->find<QCheckBox>("transfer.logarithmic").click();
    QVERIFY(!editor_->state().view().logarithmicCounts);
    QVERIFY(editor_->canvas().grab().toImage() != logarithmic);
}

void TransferLookTest::thePlotIsPaintedInEveryState()
{
    // None of these has a middle, or an extent, or a place in the plot.
    for (const TransferLimits& values :
         {TransferLimits{0, 0}, TransferLimits{1e9, -1e9}, TransferLimits{-1e30, 1e30}}) {
        editor_->state().setView({values, TransferLimits{2, -3}});
        QVERIFY(!editor_->canvas().grab().isNull());
        QVERIFY(plot().heights.least < plot().heights.largest);
    }
    editor_->canvas().resize(3, 3);
    QVERIFY(!editor_->canvas().grab().isNull());
}

QTEST_MAIN(TransferLookTest)
#include "transfer_look_test.moc"
