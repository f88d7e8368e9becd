// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QLineEdit>
#include <QTableView>
#include <QToolButton>

using namespace tetra;

/// The points of the transfer function in a table (R18): edited in the user's locale, an undo step a cell, and with the
/// plot's selection.
class TransferTableTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { model_ = editorModel(folder_, "transfer-table"); }
    void init()
    {
        startAnew(editor_, model_);
        editor_->find<QToolButton>("transfer.table.show").click();
    }
    void cleanup() { QLocale::setDefault(QLocale::c()); }
    void theTableIsShownAndHidden();
    void theTableIsSeenInASmallPanel();
    void cellsAreEdited();
    void numbersAreInTheUsersLocale();
    void whatIsWrongChangesNothing_data();
    void whatIsWrongChangesNothing();
    void theSelectionIsShared();
    void rowsFollowTheFunction();

private:
    enum Column { Value, Opacity, Colour, Group };

    JoinedFunction function() const { return editor_->function(); }
    QTableView& table() const { return editor_->find<QTableView>("transfer.table"); }
    QString textAt(int row, int column) const { return table().model()->index(row, column).data().toString(); }
    /// As a user types it into a cell.
    void type(int row, int column, const QString& text) const
    {
        const QModelIndex cell = table().model()->index(row, column);
        table().setFocus();
        table().setCurrentIndex(cell);
        QTest::keyClick(&table(), Qt::Key_F2);
        auto* line = table().viewport()->findChild<QLineEdit*>();
        QVERIFY(line != nullptr);
        line->selectAll();
        QTest::keyClicks(line, text);
        if (text.isEmpty())
            QTest::keyClick(line, Qt::Key_Delete);
        QTest::keyClick(line, Qt::Key_Return);
        QTRY_VERIFY(table().viewport()->findChild<QLineEdit*>() == nullptr);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferTableTest::theTableIsShownAndHidden()
{
    QVERIFY(table().isVisible());
    editor_->find<QToolButton>("transfer.table.show").click();
    QVERIFY(!table().isVisible());
}

void TransferTableTest::theTableIsSeenInASmallPanel()
{
    auto& show = editor_->find<QToolButton>("transfer.table.show");
    show.click();
    table().window()->resize(372, 280);
    show.click();
    const QWidget* window = table().window();
    QTRY_VERIFY(window->rect().contains(table().mapTo(window, QPoint(0, 0))));
    QVERIFY(window->rect().contains(table().mapTo(window, table().rect().bottomLeft())));
}

void TransferTableTest::cellsAreEdited()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    const double value = (before.points[3].value + before.points[4].value) / 2;
    type(4, Value, QLocale().toString(value, 'g', 17));
    QVERIFY(std::abs(function().points[4].value - value) < 1e-9 * std::abs(value));
    type(4, Opacity, "62.5");
    QCOMPARE(function().points[4].opacity, 0.625F);
    type(4, Colour, "#ff0000");
    QCOMPARE(function().points[4].colour, (std::array<float, 3>{1, 0, 0}));
    type(4, Group, "7");
    QCOMPARE(function().points[4].group, std::optional(7));
    type(4, Group, "");
    QVERIFY(!function().points[4].group);
    QCOMPARE(editor_->undoSteps(), steps + 5);
    for (int step = 0; step < 5; ++step)
        editor_->undo();
    QCOMPARE(function(), before);
}

void TransferTableTest::numbersAreInTheUsersLocale()
{
    QLocale::setDefault(QLocale(QLocale::German));
    type(2, Opacity, "12,5");
    QCOMPARE(function().points[2].opacity, 0.125F);
    QCOMPARE(textAt(2, Opacity), QString("12,5"));
}

void TransferTableTest::whatIsWrongChangesNothing_data()
{
    QTest::addColumn<int>("column");
    QTest::addColumn<QString>("text");
    QTest::newRow("no number") << int{Value} << "ten";
    QTest::newRow("infinity") << int{Value} << "inf";
    QTest::newRow("no opacity") << int{Opacity} << "x";
    QTest::newRow("not a colour") << int{Colour} << "no such colour";
    QTest::newRow("group 10") << int{Group} << "10";
    QTest::newRow("group -1") << int{Group} << "-1";
    QTest::newRow("half a group") << int{Group} << "1.5";
    QTest::newRow("a huge group") << int{Group} << "1e300";
}

void TransferTableTest::whatIsWrongChangesNothing()
{
    QFETCH(int, column);
    QFETCH(QString, text);
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    type(3, column, text);
    QCOMPARE(function(), before);
    QCOMPARE(editor_->undoSteps(), steps);
}

void TransferTableTest::theSelectionIsShared()
{
    editor_->state().select({1, 4});
    QModelIndexList rows = table().selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 2);
    table().setFocus();
    table().selectRow(5);
    QCOMPARE(editor_->state().selection(), TransferSelection{5});
    QTest::keyClick(&table(), Qt::Key_A, Qt::ControlModifier);
    QCOMPARE(editor_->state().selection(), allPoints(function()));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {},
                      table().visualRect(table().model()->index(0, Value)).center());
    QCOMPARE(editor_->state().selection(), TransferSelection{0});
    const std::size_t count = function().points.size();
    QTest::keyClick(&table(), Qt::Key_Delete);
    QCOMPARE(function().points.size(), count - 1);
}

void TransferTableTest::rowsFollowTheFunction()
{
    QCOMPARE(table().model()->rowCount(), static_cast<int>(function().points.size()));
    editor_->state().select({1, 4});
    editor_->find<QAction>("transfer.change.delete").trigger();
    QCOMPARE(table().model()->rowCount(), static_cast<int>(function().points.size()));
    editor_->undo();
    QCOMPARE(table().model()->rowCount(), static_cast<int>(function().points.size()));
    QCOMPARE(textAt(0, Value), QLocale().toString(function().points[0].value, 'g', 7));
    editor_->workbench.opening().models().close();
    QCOMPARE(table().model()->rowCount(), 0);
}

QTEST_MAIN(TransferTableTest)
#include "transfer_table_test.moc"
