// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/canvas_painting.h"
#include "plugins/editors/transferfunction/value_text.h"
#include "plugins/widgets/value_box.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <QAction>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include <cmath>
#include <numeric>

using namespace tetra;

/// Of a model of logarithms the editor shows and takes the values of the data (D7); the function is of logarithms.
class TransferLogarithmsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { editor_.reset(); }
    void theAxisTellsValues();
    void valuesAreTypedAsTheDataHaveThem();
    void whatIsLeftAsItIsKeepsAllItsDigits();
    void whatHasNoLogarithmIsNotTaken();
    void theTableHasValues();
    void theReadOutTellsValues();

private:
    TransferPlot plot() const { return editor_->canvas().plot(); }
    JoinedFunction function() const { return editor_->function(); }
    ValueBox& value() const { return static_cast<ValueBox&>(editor_->find<QDoubleSpinBox>("transfer.value")); }
    void type(const QString& text) const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

/// The logarithms of values from 1 on.
void TransferLogarithmsTest::initTestCase()
{
    model_ = editorModel(folder_, "transfer-logarithms");
    model_ = QString::fromStdString(buildLogarithmModel(*hostOfThisBuild(), 12, folder_.path().toStdString()).string());
}

void TransferLogarithmsTest::init()
{
    editor_ = std::make_unique<EditorFixture>(model_);
    QVERIFY(editor_->state().ofLogarithms());
}

void TransferLogarithmsTest::type(const QString& text) const
{
    value().setFocus();
    value().selectAll();
    QTest::keyClicks(value().findChild<QLineEdit*>(), text);
    QTest::keyClick(&value(), Qt::Key_Return);
}

void TransferLogarithmsTest::theAxisTellsValues()
{
    const TransferPlot there = plot();
    QVERIFY(there.ofLogarithms);
    QCOMPARE(there.limits.least, 0.0);
    const auto labels = valueLabels(there, editor_->canvas().fontMetrics());
    QVERIFY(labels.size() >= 2);
    QCOMPARE(labels.front().text, QString("1"));
    const double largest = std::pow(10, there.limits.largest);
    QVERIFY2(std::abs(labels[1].text.toDouble() / largest - 1) < 0.01, qPrintable(labels[1].text));
    // Equal steps are equal factors, and there is no other axis.
    QVERIFY(std::abs(there.x(2) - there.x(1) - (there.x(1) - there.x(0))) < 1e-9);
    QVERIFY(!editor_->find<QAction>("transfer.valueAxis.logarithmic").isEnabled());
    QVERIFY(!editor_->canvas().grab().isNull());
}

void TransferLogarithmsTest::valuesAreTypedAsTheDataHaveThem()
{
    editor_->state().setCurrent({EditorItem::Kind::Point, 3});
    const double before = function().points[3].value;
    QVERIFY(std::abs(value().text().toDouble() / std::pow(10, before) - 1) < 1e-4);
    const double wanted = std::pow(10, std::midpoint(before, function().points[4].value));
    type(QString::number(wanted, 'g', 15));
    QVERIFY(std::abs(function().points[3].value - std::log10(wanted)) < 1e-12);
    QCOMPARE(editor_->undoSteps(), 1);
    editor_->state().setCurrent({EditorItem::Kind::Isovalue, 0});
    type("100");
    QCOMPARE(editor_->session().view().isovalues.front().value, 2.0);
    QCOMPARE(value().text(), QString("100"));
    value().stepUp(); // a hundredth of the axis
    const double step = plot().limits.largest / 100;
    QVERIFY(std::abs(editor_->session().view().isovalues.front().value - 2 - step) < 1e-9);
}

void TransferLogarithmsTest::whatIsLeftAsItIsKeepsAllItsDigits()
{
    Isovalue isovalue = editor_->session().view().isovalues.front();
    isovalue.value = std::log10(2.0) / 3;
    editor_->session().setIsovalue(0, isovalue);
    const int steps = editor_->undoSteps();
    editor_->state().setCurrent({EditorItem::Kind::Isovalue, 0});
    type(value().text());
    QCOMPARE(editor_->session().view().isovalues.front().value, isovalue.value);
    QCOMPARE(editor_->undoSteps(), steps);
}

void TransferLogarithmsTest::whatHasNoLogarithmIsNotTaken()
{
    editor_->state().setCurrent({EditorItem::Kind::Isovalue, 0});
    const double before = editor_->session().view().isovalues.front().value;
    for (const char* text : {"0", "-3", "1e9"}) {
        type(text);
        QCOMPARE(editor_->session().view().isovalues.front().value, before);
    }
    type("1"); // the least one
    QCOMPARE(editor_->session().view().isovalues.front().value, 0.0);
}

void TransferLogarithmsTest::theTableHasValues()
{
    auto& model = *editor_->find<QTableView>("transfer.table").model();
    const auto& points = function().points;
    for (std::size_t row = 0; row < points.size(); ++row) {
        const double told = model.index(static_cast<int>(row), 0).data().toString().toDouble();
        QVERIFY(std::abs(told / std::pow(10, points[row].value) - 1) < 1e-6);
    }
    const QModelIndex cell = model.index(3, 0);
    QVERIFY(!model.setData(cell, cell.data(Qt::EditRole)));
    QVERIFY(!model.setData(cell, "0"));
    const double wanted = std::pow(10, std::midpoint(points[3].value, points[4].value));
    QVERIFY(model.setData(cell, QString::number(wanted, 'g', 15)));
    QVERIFY(std::abs(function().points[3].value - std::log10(wanted)) < 1e-12);
}

void TransferLogarithmsTest::theReadOutTellsValues()
{
    editor_->state().setCurrent({EditorItem::Kind::Isovalue, 0});
    type("10");
    QVERIFY2(plainReadOutOf(editor_->state(), 1).startsWith("10: "), qPrintable(plainReadOutOf(editor_->state(), 1)));
    QVERIFY2(editor_->find<QLabel>("transfer.readOut").accessibleName().startsWith("10: "),
             qPrintable(editor_->find<QLabel>("transfer.readOut").accessibleName()));
    QVERIFY2(editor_->canvas().accessibleDescription().endsWith(": 10"),
             qPrintable(editor_->canvas().accessibleDescription()));
}

QTEST_MAIN(TransferLogarithmsTest)
#include "transfer_logarithms_test.moc"
