// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

using namespace tetra;

/// The editor of the transfer function as a plugin of the window (R18): single points, all of them, and what is seen
/// where the plugin is not there.
class TransferEditorTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-editor"); }
    void init() { startAnew(editor_, model_); }
    void aDragIsOneStepAndThePictureFollows();
    void pointsAreEditedByKeys();
    void doubleClickAddsAPoint();
    void doubleClickOnALineAddsAPoint();
    void isovaluesLinesTakeNoClicks();
    void linesAreOfModesWithIsovalues();
    void theFirstPointIsSeen();
    void doubleClickOnAPointAsksForItsColour();
    void pointsAreEditedInNumbers();
    void aPointIsMadeAStep();
    void allPointsAreChanged();
    void withoutThePluginTheDockSaysWhy();

private:
    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferEditorTest::aDragIsOneStepAndThePictureFollows()
{
    const JoinedFunction before = editor_->function();
    const int steps = editor_->undoSteps();
    const auto scene = editor_->viewport().scene();
    const QPoint from = editor_->placeOf(4);
    QTest::mousePress(&editor_->canvas(), Qt::LeftButton, {}, from);
    QCOMPARE(editor_->canvas().selected(), std::size_t{4});
    for (int i = 1; i <= 6; ++i) {
        const QPoint to = from + QPoint(i, -3 * i);
        QMouseEvent move(QEvent::MouseMove, to, editor_->canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&editor_->canvas(), &move);
    }
    QVERIFY(!editor_->viewport().settled()); // quick pictures while it is dragged
    QTRY_VERIFY(editor_->viewport().scene() != scene);
    QTest::mouseRelease(&editor_->canvas(), Qt::LeftButton, {}, from + QPoint(6, -18));
    QVERIFY(editor_->function().points[4].opacity > before.points[4].opacity);
    QVERIFY(editor_->function().points[4].value > before.points[4].value);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    QTRY_VERIFY(editor_->settled());
    editor_->undo();
    QCOMPARE(editor_->function(), before);
}

void TransferEditorTest::pointsAreEditedByKeys()
{
    editor_->canvas().setFocus();
    const std::size_t count = editor_->function().points.size();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab);
    QCOMPARE(editor_->canvas().selected(), std::size_t{1});
    QTest::keyClick(&editor_->canvas(), Qt::Key_Backtab);
    QCOMPARE(editor_->canvas().selected(), std::size_t{0});
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab);
    const TransferPoint before = editor_->function().points[1];
    QTest::keyClick(&editor_->canvas(), Qt::Key_Right);
    QTest::keyClick(&editor_->canvas(), Qt::Key_Up);
    QVERIFY(editor_->function().points[1].value > before.value);
    QVERIFY(editor_->function().points[1].opacity > before.opacity);
    QVERIFY(editor_->canvas().accessibleDescription().contains("Point 2 of 9"));
    QTest::keyClick(&editor_->canvas(), Qt::Key_Delete);
    QCOMPARE(editor_->function().points.size(), count - 1);
    editor_->state().setCurrent(editor_->state().items().back());
    QTest::keyClick(&editor_->canvas(), Qt::Key_Tab); // on to the next control
    QVERIFY(!editor_->canvas().hasFocus());
}

void TransferEditorTest::doubleClickAddsAPoint()
{
    const std::size_t count = editor_->function().points.size();
    const int steps = editor_->undoSteps();
    const QPoint place = editor_->canvas().plot().area.center().toPoint() + QPoint(13, -40);
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, place);
    QCOMPARE(editor_->function().points.size(), count + 1);
    QVERIFY(editor_->canvas().selected().has_value());
    QVERIFY((editor_->placeOf(*editor_->canvas().selected()) - place).manhattanLength() <= 2);
    QCOMPARE(editor_->undoSteps(), steps + 1);
}

/// That of an isovalue, which the mode may not even show.
void TransferEditorTest::doubleClickOnALineAddsAPoint()
{
    const std::size_t count = editor_->function().points.size();
    const TransferPlot plot = editor_->canvas().plot();
    const double value = editor_->workbench.session().view().isovalues.front().value;
    const QPoint place(static_cast<int>(std::lround(plot.x(value))), plot.area.center().toPoint().y() - 40);
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, place);
    QCOMPARE(editor_->function().points.size(), count + 1);
    QCOMPARE(editor_->workbench.session().view().isovalues.front().value, value);
    const QPoint handle(place.x(), static_cast<int>(plot.area.top()) - 3);
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, handle);
    QCOMPARE(editor_->function().points.size(), count + 1);
}

/// Only their handles do, above the plot.
void TransferEditorTest::isovaluesLinesTakeNoClicks()
{
    const TransferPlot plot = editor_->canvas().plot();
    const auto isovalues = editor_->session().view().isovalues;
    const int x = static_cast<int>(std::lround(plot.x(isovalues.front().value)));
    const QPoint onLine(x, plot.area.center().toPoint().y() - 40);
    QVERIFY(editor_->canvas().itemAt(onLine).kind == EditorItem::Kind::None);
    QVERIFY(editor_->canvas().itemAt(QPoint(x, static_cast<int>(plot.area.top()) - 4)).kind ==
            EditorItem::Kind::Isovalue);
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, onLine);
    QVERIFY(editor_->state().current().kind == EditorItem::Kind::None);
    editor_->drag(onLine, {static_cast<int>(plot.area.right()), static_cast<int>(plot.area.bottom())}); // a frame
    QVERIFY(!editor_->state().selection().empty());
    QCOMPARE(editor_->session().view().isovalues, isovalues);
    QCOMPARE(editor_->undoSteps(), 0);
}

void TransferEditorTest::linesAreOfModesWithIsovalues()
{
    Isovalue isovalue = editor_->session().view().isovalues.front();
    isovalue.red = 1;
    isovalue.green = 0;
    isovalue.blue = 1;
    editor_->session().setIsovalue(0, isovalue);
    const auto isLine = [&] {
        const TransferPlot plot = editor_->canvas().plot(); // the mode may take some of its place
        const QPoint place(static_cast<int>(std::lround(plot.x(isovalue.value))),
                           static_cast<int>(plot.area.top() + plot.area.height() / 8));
        const QImage image = editor_->canvas().grab().toImage();
        bool found = false;
        for (int x = place.x() - 2; x <= place.x() + 2; ++x) {
            const QColor colour = image.pixelColor(QPoint(x, place.y()) * image.devicePixelRatio());
            found = found || (colour.red() > colour.green() + 60 && colour.blue() > colour.green() + 60);
        }
        return found;
    };
    QVERIFY(!editor_->state().showsIsovalues());
    QVERIFY(!isLine());
    editor_->find<QAction>("action.mode.hybrid").trigger(); // a volume with surfaces in it
    QTRY_VERIFY(editor_->settled());
    QVERIFY(editor_->state().showsIsovalues());
    QTRY_VERIFY(isLine());
}

/// In an empty function nothing would be seen of a white, transparent one.
void TransferEditorTest::theFirstPointIsSeen()
{
    const auto isSeen = [](const TransferPoint& point) {
        const auto [least, largest] = std::minmax_element(point.colour.begin(), point.colour.end());
        return *largest - *least > 0.3F && *largest < 0.9F; // neither white nor black
    };
    editor_->session().setTransfer({});
    QTest::mouseClick(&editor_->find<QPushButton>("transfer.add"), Qt::LeftButton);
    QCOMPARE(editor_->function().points.size(), std::size_t{1});
    QVERIFY(isSeen(editor_->function().points.front()));
    QVERIFY(editor_->function().points.front().opacity >= 0.25F);
    editor_->session().setTransfer({});
    const QPoint place = editor_->canvas().plot().area.center().toPoint();
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, place);
    QCOMPARE(editor_->function().points.size(), std::size_t{1});
    QVERIFY(isSeen(editor_->function().points.front()));
    QVERIFY((editor_->placeOf(0) - place).manhattanLength() <= 2); // as opaque as was clicked
}

void TransferEditorTest::doubleClickOnAPointAsksForItsColour()
{
    const std::size_t count = editor_->function().points.size();
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, editor_->placeOf(4));
    QTest::mouseDClick(&editor_->canvas(), Qt::LeftButton, {}, editor_->placeOf(4));
    QCOMPARE(editor_->function().points.size(), count);
    auto& dialog = editor_->find<QColorDialog>("colourDialog");
    QVERIFY(dialog.isVisible());
    dialog.setCurrentColor(QColor(10, 200, 30));
    dialog.accept();
    const auto& colour = editor_->function().points[4].colour;
    QVERIFY(std::abs(colour[0] - 10 / 255.0F) < 1e-3F && std::abs(colour[1] - 200 / 255.0F) < 1e-3F);
}

void TransferEditorTest::pointsAreEditedInNumbers()
{
    QVERIFY(!editor_->find<QDoubleSpinBox>("transfer.value").isEnabled());
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, editor_->placeOf(4));
    auto& value = editor_->find<QDoubleSpinBox>("transfer.value");
    value.setValue(value.value() + 3);
    QCOMPARE(editor_->function().points[4].value, value.value());
    editor_->find<QDoubleSpinBox>("transfer.opacity").setValue(62.5);
    QCOMPARE(editor_->function().points[4].opacity, 0.625F);
    editor_->find<QDoubleSpinBox>("transfer.unitDistance").setValue(2);
    QCOMPARE(editor_->function().unitDistance, 2.0);
    QTest::mouseClick(&editor_->find<QPushButton>("transfer.add"), Qt::LeftButton);
    QCOMPARE(editor_->canvas().selected(), std::size_t{5});
    QTest::mouseClick(&editor_->find<QPushButton>("transfer.remove"), Qt::LeftButton);
    QCOMPARE(editor_->function().points.size(), std::size_t{9});
}

void TransferEditorTest::aPointIsMadeAStep()
{
    QTest::mouseClick(&editor_->canvas(), Qt::LeftButton, {}, editor_->placeOf(4));
    auto& step = editor_->find<QCheckBox>("transfer.step");
    step.click();
    QVERIFY(isOnStep(editor_->function(), 4));
    editor_->find<QDoubleSpinBox>("transfer.opacity").setValue(0);
    QVERIFY(editor_->function().points[4].opacity != editor_->function().points[5].opacity);
    QCOMPARE(editor_->function().points[4].value, editor_->function().points[5].value);
    QTRY_VERIFY(editor_->settled());
    step.click();
    QCOMPARE(editor_->function().points.size(), std::size_t{9});
    QCOMPARE(editor_->function().points[4].opacity, 0.0F);
}

void TransferEditorTest::allPointsAreChanged()
{
    const JoinedFunction before = editor_->function();
    const ValueRange range = editor_->workbench.session().range();
    editor_->find<QAction>("transfer.preset.diverging").trigger();
    QCOMPARE(editor_->transfer(), divergingTransferFunction(range.minimum, range.maximum, before.unitDistance));
    editor_->undo();
    editor_->find<QAction>("transfer.change.mirror").trigger();
    QCOMPARE(editor_->function().points.front().opacity, before.points.back().opacity);
    editor_->find<QAction>("transfer.change.thinner").trigger();
    QVERIFY(editor_->function().points.front().opacity < before.points.back().opacity);
}

void TransferEditorTest::withoutThePluginTheDockSaysWhy()
{
    const QTemporaryDir empty;
    WindowFixture window(BackendChoice::Cpu,
                         std::make_unique<PluginHost>(PluginHostOptions{.folders = {empty.path().toStdString()}}));
    window.window.show();
    window.find<QAction>("action.dock.transfer").trigger();
    QVERIFY(window.find<QLabel>("transfer.missing").text().contains("\"transfer\""));
}

QTEST_MAIN(TransferEditorTest)
#include "transfer_editor_test.moc"
