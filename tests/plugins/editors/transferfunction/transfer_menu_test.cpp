// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/widgets/curves/arranging.h"
#include "plugins/widgets/curves/copying.h"
#include "plugins/widgets/curves/reshaping.h"
#include "plugins/widgets/curves/whole_function.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QClipboard>
#include <QColorDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QPushButton>

#include <cmath>
#include <functional>

using namespace tetra;

/// What the editor's menu and keys do to selected points (R18): each one undo step, as the function of core says.
class TransferMenuTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-menu"); }
    void init() { startAnew(editor_, model_); }
    void everyActionIsOneStep_data();
    void everyActionIsOneStep();
    void actionsNeedASelection();
    void pointsAreCopiedAndPasted();
    void whatIsNoPointsIsTold();
    void aPeakIsAdded();
    void groupsAreMadeAndSelectedByKeys();
    void groupsAreWrittenBesideTheirPoints_data();
    void groupsAreWrittenBesideTheirPoints();
    void theMenuOpensInThePlot();
    void aRightClickSelectsWhatItIsOn();
    void aKeyAsksForTheColour();
    void theFunctionIsRescaled();
    void theFunctionIsRescaledToNumbers();

private:
    using Change = std::function<EditedSelection(const JoinedFunction&, const TransferSelection&, TransferLimits)>;

    JoinedFunction function() const { return editor_->function(); }
    TransferSelection selection() const { return editor_->state().selection(); }
    QAction& action(const QString& name) const { return editor_->find<QAction>("transfer.change." + name); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const
    {
        editor_->canvas().setFocus();
        QTest::keyClick(&editor_->canvas(), key, modifiers);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferMenuTest::everyActionIsOneStep_data()
{
    QTest::addColumn<TransferSelection>("selected");
    QTest::addColumn<Change>("change");
    const TransferSelection some{1, 2, 4, 6}, two{2, 3};
    const auto row = [](const char* name, const TransferSelection& selected, const Change& change) {
        QTest::newRow(name) << selected << change;
    };
    const auto align = [](Alignment kind) {
        return [kind](const auto& f, const auto& s, auto) { return alignOpacities(f, s, kind); };
    };
    row("align.first", some, align(Alignment::First));
    row("align.mean", some, align(Alignment::Mean));
    row("align.least", some, align(Alignment::Least));
    row("align.largest", some, align(Alignment::Largest));
    row("align.values", two, [](const auto& f, const auto& s, auto) { return alignValues(f, s, Alignment::Mean); });
    row("distribute", some, &distributeValues);
    row("flip", some, &flipValues);
    row("invert", some, [](const auto& f, const auto& s, auto) { return invertOpacities(f, s); });
    row("ramp", some, [](const auto& f, const auto& s, auto) { return rampOpacities(f, s); });
    row("delete", some, [](const auto& f, const auto& s, auto) { return withoutSelected(f, s); });
    row("group.assign.3", some, [](const auto& f, const auto& s, auto) { return withGroup(f, s, 3); });
    row("duplicate", some, [](const auto& f, const auto& s, TransferLimits limits) {
        return duplicated(f, s, 0.05 * (limits.largest - limits.least), limits);
    });
}

void TransferMenuTest::everyActionIsOneStep()
{
    QFETCH(TransferSelection, selected);
    QFETCH(Change, change);
    JoinedFunction uneven = function(); // so that each edit has something to do
    for (std::size_t i = 0; i < uneven.points.size(); ++i)
        uneven.points[i].opacity = 0.1F + 0.07F * static_cast<float>((i * 5) % 9);
    uneven.points[2].value += 0.01;
    uneven.points[2].opacity = 0.3F;
    editor_->session().setTransfer(separated(uneven));
    editor_->state().select(selected);
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    const EditedSelection expected = change(before, selected, editor_->state().limits());
    QVERIFY(expected.function != before);
    action(QTest::currentDataTag()).trigger();
    QCOMPARE(function(), expected.function);
    QCOMPARE(selection(), expected.selection);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferMenuTest::actionsNeedASelection()
{
    QVERIFY(!action("flip").isEnabled() && !action("invert").isEnabled() && !action("copy").isEnabled());
    editor_->state().select({1});
    QVERIFY(!action("flip").isEnabled() && action("invert").isEnabled());
    editor_->state().select({1, 2});
    QVERIFY(action("flip").isEnabled() && !action("distribute").isEnabled());
    action("selectAll").trigger();
    QCOMPARE(selection(), allPoints(function()));
    action("simplify").trigger();
    QVERIFY(function().points.size() <= 9);
}

void TransferMenuTest::pointsAreCopiedAndPasted()
{
    const JoinedFunction before = function();
    editor_->state().select({2, 3});
    press(Qt::Key_C, Qt::ControlModifier);
    const std::string text = QGuiApplication::clipboard()->text().toStdString();
    QCOMPARE(text, copyOfSelected(before, {2, 3}));
    press(Qt::Key_V, Qt::ControlModifier);
    const auto expected = pasted(before, text, std::nullopt, editor_->state().limits());
    QVERIFY(expected);
    QCOMPARE(function(), expected->function);
    QCOMPARE(selection(), expected->selection);
    QCOMPARE(selection().size(), std::size_t{2});
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferMenuTest::whatIsNoPointsIsTold()
{
    const JoinedFunction before = function();
    QGuiApplication::clipboard()->setText("a shopping list");
    action("paste").trigger();
    QCOMPARE(function(), before);
    QCOMPARE(editor_->messages().size(), 1);
}

void TransferMenuTest::aPeakIsAdded()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    action("peak").trigger();
    QCOMPARE(selection().size(), std::size_t{3});
    QVERIFY(function().points[selection()[1]].opacity >= 0.5F);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferMenuTest::groupsAreMadeAndSelectedByKeys()
{
    const int steps = editor_->undoSteps();
    editor_->state().select({1, 5});
    press(Qt::Key_7, Qt::ControlModifier);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    QCOMPARE(function().points[5].group, std::optional(7));
    press(Qt::Key_Escape);
    press(Qt::Key_7);
    QCOMPARE(selection(), (TransferSelection{1, 5}));
    action("group.none").trigger();
    action("group.select.7").trigger();
    QVERIFY(selection().empty());
}

void TransferMenuTest::groupsAreWrittenBesideTheirPoints_data()
{
    QTest::addColumn<QColor>("window");
    QTest::addColumn<int>("scale");
    for (const int scale : {1, 2}) {
        QTest::addRow("light, %d", scale) << QColor(239, 239, 239) << scale;
        QTest::addRow("dark, %d", scale) << QColor(50, 50, 50) << scale;
    }
}

void TransferMenuTest::groupsAreWrittenBesideTheirPoints()
{
    QFETCH(QColor, window);
    QFETCH(int, scale);
    TransferCanvas& canvas = editor_->canvas();
    canvas.setPalette(QPalette(window));
    const auto draw = [&] {
        QImage image(canvas.size() * scale, QImage::Format_ARGB32);
        image.setDevicePixelRatio(scale);
        image.fill(window); // as what lies below is not for the canvas to draw
        canvas.render(&image);
        return image;
    };
    // How much the label's place differs between light and dark pixels: text can be read where both are there.
    const auto contrastAt = [&](const QImage& image, std::size_t point) {
        const QFont bold = [&] {
            QFont font = canvas.font();
            font.setBold(true);
            return font;
        }();
        const QRectF label = groupLabel(canvas.plot(), function(), point, QFontMetrics(bold));
        int least = 255, largest = 0;
        const QRect pixels =
            QRectF(label.topLeft() * scale, label.size() * scale).adjusted(2, 2, -2, -2).toRect() & image.rect();
        for (int y = pixels.top(); y <= pixels.bottom(); ++y)
            for (int x = pixels.left(); x <= pixels.right(); ++x) {
                least = std::min(least, qGray(image.pixel(x, y)));
                largest = std::max(largest, qGray(image.pixel(x, y)));
            }
        return largest - least;
    };
    press(Qt::Key_Escape); // nothing is selected, and the canvas has the keys from here on: its frame says so
    editor_->state().setCurrent({});
    const QImage before = draw();
    editor_->state().select({1, 8}); // the last one at the edge
    press(Qt::Key_7, Qt::ControlModifier);
    QVERIFY(canvas.accessibleDescription().contains("group 7"));
    editor_->state().setCurrent({});
    const QImage after = draw();
    QVERIFY(after != before);
    for (const std::size_t point : {std::size_t{1}, std::size_t{8}})
        QVERIFY(contrastAt(after, point) > 100);
    QVERIFY(canvas.rect().contains(groupLabel(canvas.plot(), function(), 8, canvas.fontMetrics()).toRect()));
    action("group.none").trigger(); // nothing is selected: they stay
    QCOMPARE(draw(), after);
    press(Qt::Key_7);
    action("group.none").trigger();
    editor_->state().setCurrent({});
    QCOMPARE(draw(), before);
}

void TransferMenuTest::theMenuOpensInThePlot()
{
    auto& menu = editor_->find<QMenu>("transfer.editMenu");
    emit editor_->canvas().customContextMenuRequested(editor_->canvas().plot().area.center().toPoint());
    QTRY_VERIFY(menu.isVisible());
    menu.close();
}

/// A right click is of the point below it: as after a left one, its entries can be used.
void TransferMenuTest::aRightClickSelectsWhatItIsOn()
{
    TransferCanvas& canvas = editor_->canvas();
    const auto click = [&](QPoint place) { QTest::mouseClick(&canvas, Qt::RightButton, {}, place); };
    editor_->state().setCurrent({});
    QVERIFY(!action("copy").isEnabled());
    QVERIFY(!action("colour").isEnabled());
    click(editor_->placeOf(4));
    QCOMPARE(editor_->state().selection(), TransferSelection{4});
    for (const char* name : {"copy", "delete", "duplicate", "colour"})
        QVERIFY2(action(name).isEnabled(), name);
    editor_->state().select({2, 3, 4});
    click(editor_->placeOf(3)); // one of several: all stay
    QCOMPARE(editor_->state().selection(), (TransferSelection{2, 3, 4}));
    click(editor_->placeOf(6));
    QCOMPARE(editor_->state().selection(), TransferSelection{6});
    click(canvas.plot().area.center().toPoint() + QPoint(13, -40)); // on nothing: what is selected is still meant
    QCOMPARE(editor_->state().selection(), TransferSelection{6});
}

void TransferMenuTest::aKeyAsksForTheColour()
{
    press(Qt::Key_C); // of nothing
    QVERIFY(editor_->window.findChildren<QColorDialog*>().isEmpty());
    QCOMPARE(action("colour").shortcut(), QKeySequence(Qt::Key_C));
    editor_->state().select({2, 3});
    press(Qt::Key_C);
    auto& dialog = editor_->find<QColorDialog>("colourDialog");
    QVERIFY(dialog.isVisible());
    dialog.setCurrentColor(QColor(10, 200, 30));
    dialog.accept();
    QCOMPARE(function().points[2].colour, function().points[3].colour);
    QVERIFY(std::abs(function().points[2].colour[1] - 200 / 255.0F) < 1e-3F);
}

void TransferMenuTest::theFunctionIsRescaled()
{
    const TransferFunction before = editor_->transfer();
    const TransferLimits range = editor_->state().range();
    const auto at = [&](double share) { return std::lerp(range.least, range.largest, share); };
    EditorView view = editor_->state().view();
    view.values = TransferLimits{at(0.25), at(0.5)};
    editor_->state().setView(view);
    const int steps = editor_->undoSteps();
    const TransferLimits shown = editor_->state().shown();
    action("spread.shown").trigger();
    QCOMPARE(editor_->transfer(), spreadOver(before, shown));
    QVERIFY(std::abs(function().points.back().value - at(0.5)) < 1e-6 * (range.largest - range.least));
    QCOMPARE(editor_->undoSteps(), steps + 1);
    action("spread").trigger();
    QVERIFY(std::abs(function().points.back().value - range.largest) < 1e-9 * (range.largest - range.least));
    editor_->session().setTransfer({});
    QVERIFY(!editor_->find<QMenu>("transfer.rescaleMenu").isEnabled()); // there is nothing to be spread
}

void TransferMenuTest::theFunctionIsRescaledToNumbers()
{
    const TransferFunction before = editor_->transfer();
    const int steps = editor_->undoSteps();
    const auto ask = [this] {
        action("spread.numbers").trigger();
        return &editor_->find<QDialog>("transfer.rescale");
    };
    QDialog* dialog = ask();
    QVERIFY(dialog->isVisible());
    auto* least = dialog->findChild<QDoubleSpinBox*>("transfer.rescale.least");
    auto* largest = dialog->findChild<QDoubleSpinBox*>("transfer.rescale.largest");
    auto* buttons = dialog->findChild<QDialogButtonBox*>();
    least->setValue(-1024);
    QVERIFY(buttons->button(QDialogButtonBox::Ok)->isEnabled());
    largest->setValue(-2000);
    QVERIFY(!buttons->button(QDialogButtonBox::Ok)->isEnabled()); // no range
    largest->setValue(3071);
    dialog->accept();
    QCOMPARE(editor_->transfer(), spreadOver(before, {-1024, 3071}));
    QCOMPARE(editor_->undoSteps(), steps + 1);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    ask()->reject();
    QCOMPARE(editor_->undoSteps(), steps + 1);
}

QTEST_MAIN(TransferMenuTest)
#include "transfer_menu_test.moc"
