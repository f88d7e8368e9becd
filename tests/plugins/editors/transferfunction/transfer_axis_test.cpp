// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/value_text.h"
#include "plugins/widgets/curves/reshaping.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <tan/data.h>

#include <QAbstractItemModel>
#include <QTableView>
#include <QWheelEvent>

#include <cmath>

using namespace tetra;

/// The axis of values by factors (R18): plot, histogram, zoom, drags, keys and table agree on it.
class TransferAxisTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { editor_.reset(); }
    void equalFactorsAreEqualSteps();
    void theHistogramHasEqualPartsOfTheAxis();
    void dragsAndKeysGoByFactors();
    void theWheelZoomsAtThePointer();
    void newPointsLieInTheMiddleOfTheAxis();
    void dataWithoutPlacesKeepALinearAxis();
    void theFunctionFollowsTheLogarithm();
    void theTableSaysWhatThePlotShows();

private:
    TransferPlot plot() const { return editor_->canvas().plot(); }
    JoinedFunction function() const { return editor_->function(); }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

/// The values of the sample and 3 more, so that all are positive.
void TransferAxisTest::initTestCase()
{
    model_ = editorModel(folder_, "transfer-axis");
    Dataset dataset = sampleDataset(12);
    const std::uint64_t count = dataset.values.count();
    const auto samples = allocateSamples(SampleType::Float32, count);
    QVERIFY(samples);
    for (std::uint64_t i = 0; i < count; ++i)
        reinterpret_cast<float*>(samples->get())[i] = static_cast<float>(dataset.values.at(i)) + 3;
    dataset.values = ScalarField(SampleType::Float32, count, *samples);
    dataset.source.hash = contentHash(dataset.values, nullptr);
    model_ =
        QString::fromStdString(buildSampleModel(*hostOfThisBuild(), dataset, folder_.path().toStdString()).string());
}

void TransferAxisTest::init()
{
    editor_ = std::make_unique<EditorFixture>(model_);
    editor_->find<QAction>("transfer.valueAxis.logarithmic").trigger();
    QCOMPARE(editor_->state().valueAxis(), ValueAxis::Logarithmic);
    QVERIFY(editor_->find<QAction>("transfer.valueAxis.logarithmic").isChecked());
}

void TransferAxisTest::equalFactorsAreEqualSteps()
{
    const TransferPlot there = plot();
    QVERIFY(there.limits.least > 0);
    const double step = there.x(20) - there.x(10);
    QVERIFY(step > 5);
    QVERIFY(std::abs(there.x(40) - there.x(20) - step) < 1e-9);
    QVERIFY(std::abs(there.x(there.limits.least) - there.area.left()) < 1e-9);
    QVERIFY(std::abs(there.x(there.limits.largest) - there.area.right()) < 1e-9);
    for (const double value : {there.limits.least, 7.0, 100.0, there.limits.largest})
        QVERIFY(std::abs(there.valueAt(there.x(value)) / value - 1) < 1e-12);
    QVERIFY(!editor_->canvas().grab().isNull());
    editor_->find<QAction>("transfer.valueAxis.linear").trigger();
    QVERIFY(std::abs(plot().x(40) - plot().x(20) - 2 * (plot().x(20) - plot().x(10))) < 1e-9);
}

void TransferAxisTest::theHistogramHasEqualPartsOfTheAxis()
{
    const auto histogram = editor_->state().host().logarithmicHistogram();
    QVERIFY(histogram && !histogram->counts.empty());
    const double width = (histogram->largest - histogram->least) / static_cast<double>(histogram->counts.size());
    for (std::size_t part = 0; part <= histogram->counts.size(); part += 64) {
        const double x = plot().xOfPlace(histogram->least + width * static_cast<double>(part));
        const double share = static_cast<double>(part) / static_cast<double>(histogram->counts.size());
        QVERIFY(std::abs(x - (plot().area.left() + share * plot().area.width())) < 0.5);
    }
    std::uint64_t all = 0;
    for (std::size_t part = 0; part < histogram->counts.size(); ++part) {
        all += histogram->counts[part];
        const double middle = histogram->least + width * (static_cast<double>(part) + 0.5);
        QCOMPARE(plainReadOutOf(editor_->state(), std::exp(middle)).endsWith(", 1 vertex"),
                 histogram->counts[part] == 1);
    }
    QCOMPARE(all, editor_->session().shown()->vertices);
    const QImage logarithmic = editor_->canvas().grab().toImage();
    QVERIFY(plainReadOutOf(editor_->state(), std::exp(histogram->least)).contains("vertices"));
    editor_->find<QAction>("transfer.valueAxis.linear").trigger();
    QVERIFY(editor_->canvas().grab().toImage() != logarithmic);
}

void TransferAxisTest::dragsAndKeysGoByFactors()
{
    const double first = function().points[3].value, second = function().points[4].value;
    const int steps = editor_->undoSteps();
    editor_->state().select({3, 4});
    const QPoint from = editor_->placeOf(3);
    editor_->drag(from, from + QPoint(8, 0));
    const double factor = function().points[3].value / first;
    QVERIFY(factor > 1.01);
    QVERIFY(std::abs(function().points[4].value / second / factor - 1) < 1e-9);
    QVERIFY((editor_->placeOf(3) - from - QPoint(8, 0)).manhattanLength() <= 1);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function().points[3].value, first);
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Right);
    const double byKey = function().points[3].value / first;
    QVERIFY(std::abs(std::log(byKey) - 0.01 * plot().extent()) < 1e-9);
    QVERIFY(std::abs(function().points[4].value / second / byKey - 1) < 1e-9);
}

void TransferAxisTest::theWheelZoomsAtThePointer()
{
    const TransferPlot all = plot();
    const QPoint place(static_cast<int>(all.area.left() + 0.3 * all.area.width()), 60);
    const double value = all.valueAt(place.x());
    const auto turn = [&](int notches) {
        editor_->canvas().setFocus();
        QWheelEvent event(place, editor_->canvas().mapToGlobal(place), {}, QPoint(0, 120 * notches), Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&editor_->canvas(), &event);
    };
    turn(3);
    QVERIFY(plot().extent() < 0.6 * all.extent());
    QVERIFY(std::abs(plot().valueAt(place.x()) / value - 1) < 1e-9);
    editor_->canvas().setFocus();
    QTest::keyClick(&editor_->canvas(), Qt::Key_Right, Qt::AltModifier);
    QVERIFY(plot().limits.least > all.limits.least);
    turn(-20);
    QCOMPARE(plot().limits.least, all.limits.least);
    QCOMPARE(plot().limits.largest, all.limits.largest);
}

void TransferAxisTest::newPointsLieInTheMiddleOfTheAxis()
{
    editor_->state().setCurrent({EditorItem::Kind::Point, 2});
    const double low = function().points[2].value, high = function().points[3].value;
    addPoint(editor_->state(), std::nullopt);
    QVERIFY(std::abs(function().points[3].value - std::sqrt(low * high)) < 1e-9 * high);
}

void TransferAxisTest::dataWithoutPlacesKeepALinearAxis()
{
    JoinedFunction below = function();
    below.points.front().value = -1;
    editor_->session().setTransfer(separated(below));
    QCOMPARE(editor_->state().valueAxis(), ValueAxis::Linear);
    QVERIFY(editor_->find<QAction>("transfer.valueAxis.linear").isChecked());
    QVERIFY(!editor_->canvas().grab().isNull());
    editor_->find<QAction>("transfer.valueAxis.logarithmic").trigger();
    QCOMPARE(editor_->messages().size(), 1);
    QVERIFY(editor_->messages().first().contains("-1"));
    QVERIFY(editor_->find<QAction>("transfer.valueAxis.linear").isChecked());
    editor_->undo();
    editor_->find<QAction>("transfer.valueAxis.logarithmic").trigger();
    QCOMPARE(editor_->state().valueAxis(), ValueAxis::Logarithmic);
}

void TransferAxisTest::theFunctionFollowsTheLogarithm()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    QVERIFY(!editor_->find<QAction>("transfer.change.logarithm").isEnabled());
    editor_->state().select({1, 2, 3});
    editor_->find<QAction>("transfer.change.logarithm").trigger();
    QCOMPARE(function(), withLogarithmicCourse(before, {1, 2, 3}, {}).function);
    QVERIFY(function() != before);
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferAxisTest::theTableSaysWhatThePlotShows()
{
    const auto& table = editor_->find<QTableView>("transfer.table");
    QAbstractItemModel& rows = *table.model();
    const double between = std::round(0.75 * function().points[1].value + 0.25 * function().points[2].value);
    QVERIFY(rows.setData(rows.index(2, 0), QString::number(between)));
    QCOMPARE(function().points[2].value, between);
    QVERIFY(std::abs(plot().place(function(), 2).x() - plot().x(between)) < 1e-9);
    QCOMPARE(rows.index(2, 0).data().toString(), QString::number(between));
}

QTEST_MAIN(TransferAxisTest)
#include "transfer_axis_test.moc"
