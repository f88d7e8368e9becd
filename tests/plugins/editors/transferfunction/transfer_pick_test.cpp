// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/value_text.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"
#include "ui/viewport/value_pick.h"

#include <QLabel>

using namespace tetra;

/// The value that was picked in the picture, in the editor (R18): marked on the curve, and what can be made of it.
class TransferPickTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-pick"); }
    void init()
    {
        editor_ = std::make_unique<EditorFixture>(model_);
        editor_->canvas().window()->activateWindow();
    }
    void cleanup() { editor_.reset(); }
    void aClickInThePictureMarksTheCurve();
    void theMarkIsSeenInLightAndDark_data();
    void theMarkIsSeenInLightAndDark();
    void insertAddsAPointThere();
    void theMenuAddsPointAndIsovalue();
    void escapeTakesItAway();
    void whatLiesOutsideIsSaidAtTheEdge();

private:
    std::optional<PickedValue> picked() const { return editor_->state().host().picked(); }
    void pick() const
    {
        editor_->find<ValuePick>("viewport.pick").pickAt(editor_->viewport().rect().center());
        QTRY_VERIFY(picked().has_value());
    }
    QAction& action(const QString& name) const { return editor_->find<QAction>("transfer.change.picked." + name); }
    QImage image() const { return editor_->canvas().grab().toImage(); }
    int pixelsOf(const QColor& colour, const QRectF& part) const
    {
        const QImage seen = image();
        const qreal ratio = seen.devicePixelRatio();
        const QRect area = QRectF(part.topLeft() * ratio, part.size() * ratio).toRect() & seen.rect();
        int count = 0;
        for (int y = area.top(); y <= area.bottom(); ++y)
            for (int x = area.left(); x <= area.right(); ++x)
                count += seen.pixelColor(x, y) == colour;
        return count;
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferPickTest::aClickInThePictureMarksTheCurve()
{
    QVERIFY(!picked());
    const QImage before = image();
    QTest::mouseClick(&editor_->viewport(), Qt::LeftButton, {}, editor_->viewport().rect().center());
    QTRY_VERIFY(picked().has_value());
    QVERIFY(image() != before);
    auto& readOut = editor_->find<QLabel>("transfer.readOut");
    QCOMPARE(readOut.accessibleName(), plainReadOutOf(editor_->state(), picked()->value));
    editor_->find<QAction>("action.forgetPicked").trigger();
    QVERIFY(image() == before);
}

void TransferPickTest::theMarkIsSeenInLightAndDark_data()
{
    QTest::addColumn<QColor>("window");
    QTest::newRow("light") << QColor(239, 239, 239);
    QTest::newRow("dark") << QColor(50, 50, 50);
}

void TransferPickTest::theMarkIsSeenInLightAndDark()
{
    QFETCH(QColor, window);
    editor_->canvas().setPalette(QPalette(window));
    pick();
    const double x = editor_->canvas().plot().x(picked()->value);
    const QRectF& area = editor_->canvas().plot().area;
    const QColor highlight = editor_->canvas().palette().color(QPalette::Highlight);
    QVERIFY(pixelsOf(highlight, QRectF(x - 2, area.top(), 4, area.height())) > area.height() / 3);
}

void TransferPickTest::insertAddsAPointThere()
{
    pick();
    const JoinedFunction before = editor_->function();
    const int steps = editor_->undoSteps();
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Insert);
    QCOMPARE(editor_->function().points.size(), before.points.size() + 1);
    QCOMPARE(editor_->function().points.at(*editor_->state().currentPoint()).value, picked()->value);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(editor_->function(), before);
}

void TransferPickTest::theMenuAddsPointAndIsovalue()
{
    for (const char* name : {"point", "isovalue", "forget"})
        QVERIFY(!action(name).isEnabled());
    pick();
    const double value = picked()->value;
    const int steps = editor_->undoSteps();
    const auto isovalues = editor_->session().view().isovalues.size();
    const JoinedFunction before = editor_->function();
    action("point").trigger();
    QCOMPARE(editor_->function(), withPoint(before, value)->function);
    action("isovalue").trigger();
    QCOMPARE(editor_->session().view().isovalues.size(), isovalues + 1);
    QCOMPARE(editor_->session().view().isovalues.back().value, value);
    QCOMPARE(editor_->undoSteps(), steps + 2);
    action("forget").trigger();
    QVERIFY(!picked());
    QVERIFY(!action("point").isEnabled());
}

void TransferPickTest::escapeTakesItAway()
{
    pick();
    editor_->canvas().setFocus();
    editor_->state().select({2});
    QTest::keyClick(&editor_->canvas(), Qt::Key_Escape); // first of the selection
    QVERIFY(picked().has_value());
    QTest::keyClick(&editor_->canvas(), Qt::Key_Escape);
    QVERIFY(!picked());
}

void TransferPickTest::whatLiesOutsideIsSaidAtTheEdge()
{
    pick();
    const double value = picked()->value;
    const TransferLimits all = editor_->state().limits();
    const bool isLow = value < (all.least + all.largest) / 2;
    const TransferLimits elsewhere = isLow ? TransferLimits{std::lerp(value, all.largest, 0.5), all.largest}
                                           : TransferLimits{all.least, std::lerp(all.least, value, 0.5)};
    editor_->state().setView({elsewhere, {}});
    const QRectF area = editor_->canvas().plot().area;
    const QColor highlight = editor_->canvas().palette().color(QPalette::Highlight);
    const QRectF corner(isLow ? area.left() : area.right() - 30, area.top(), 30, 24);
    QVERIFY(pixelsOf(highlight, corner) > 50);
}

QTEST_MAIN(TransferPickTest)
#include "transfer_pick_test.moc"
