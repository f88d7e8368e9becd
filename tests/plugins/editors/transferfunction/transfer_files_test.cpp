// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/scene_parts.h"
#include "tests/ui/window_fixture.h"

#include "core/transfer/colour_map.h"

#include <tan/transfer.h>

#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QToolButton>

#include <cmath>

using namespace tetra;

/// Transfer functions in files, as a user loads and saves them (R18): ours and ParaView's; and colours by name.
class TransferFilesTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theFunctionIsSavedAndLoaded();
    void aFileThatIsNoFunctionIsTold();
    void coloursOfParaviewKeepTheOpacities();
    void ofSeveralPresetsOneIsChosen();
    void aFileForParaviewLooksTheSame();
    void aColourMapChangesTheColoursAlone();

private:
    Session& session() const { return window_->workbench.session(); }
    const TransferFunction& function() const { return session().view().appearance.transfer; }
    int undoSteps() const { return session().undoStack().index(); }
    void choose(const char* dialog, const QString& path) const;
    QString written(const char* name, const QByteArray& text) const;
    void load(const QString& path) const;
    /// That two functions look the same over the data, within a step of 8 bits.
    void compareLooks(const TransferFunction& left, const TransferFunction& right, bool colours) const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void TransferFilesTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("transfer-files");
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(12), folder_.path().toStdString()).string());
}

void TransferFilesTest::init()
{
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(1280, 900);
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
    window_->find<QAction>("action.mode.volume").trigger();
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).volume);
}

void TransferFilesTest::cleanup()
{
    window_.reset();
}

/// What the user does in a file dialog.
void TransferFilesTest::choose(const char* dialog, const QString& path) const
{
    auto* found = window_->window.findChild<QFileDialog*>(dialog);
    QVERIFY2(found != nullptr, dialog);
    emit found->fileSelected(path);
    found->reject();
}

QString TransferFilesTest::written(const char* name, const QByteArray& text) const
{
    const QString path = window_->folder.filePath(name);
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? path : QString();
}

void TransferFilesTest::load(const QString& path) const
{
    QTest::mouseClick(&window_->find<QToolButton>("transfer.load"), Qt::LeftButton);
    choose("transferDialog", path);
}

void TransferFilesTest::compareLooks(const TransferFunction& left, const TransferFunction& right, bool colours) const
{
    const ValueRange range = session().range();
    for (int sample = 0; sample < 256; ++sample) {
        const double value = std::lerp(range.minimum, range.maximum, (sample + 0.5) / 256);
        const TransferSample a = evaluate(left, value), b = evaluate(right, value);
        QVERIFY(std::abs(std::exp(-a.extinction * left.unitDistance) - std::exp(-b.extinction * right.unitDistance)) <=
                1.0 / 255);
        for (std::size_t channel = 0; colours && channel < 3; ++channel)
            QVERIFY(std::abs(a.colour[channel] - b.colour[channel]) <= 1.0 / 255);
    }
}

void TransferFilesTest::theFunctionIsSavedAndLoaded()
{
    const TransferFunction before = function();
    const QString path = window_->folder.filePath("function.json");
    QTest::mouseClick(&window_->find<QToolButton>("transfer.save"), Qt::LeftButton);
    choose("transferSaveDialog", path);
    QTRY_VERIFY(QFile::exists(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(*transferFunctionFromText(file.readAll().toStdString()), before);
    window_->find<QAction>("transfer.change.mirror").trigger();
    const int steps = undoSteps();
    load(path);
    QTRY_COMPARE(function(), before);
    QCOMPARE(undoSteps(), steps + 1);
}

void TransferFilesTest::aFileThatIsNoFunctionIsTold()
{
    const TransferFunction before = function();
    load(written("wrong.json", "{\"points\": 3}"));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("wrong.json"));
    QCOMPARE(function(), before);
}

void TransferFilesTest::coloursOfParaviewKeepTheOpacities()
{
    const TransferFunction before = function();
    load(written("grey.xml", "<ColorMap name='grey' space='RGB'><Point x='0' o='1' r='0' g='0' b='0'/>"
                             "<Point x='1' o='1' r='1' g='1' b='1'/></ColorMap>"));
    QTRY_VERIFY(function() != before);
    const ValueRange range = session().range();
    const TransferSample middle = evaluate(function(), (range.minimum + range.maximum) / 2);
    for (const double channel : middle.colour)
        QVERIFY(std::abs(channel - 0.5) <= 1.0 / 255);
    compareLooks(before, function(), false);
    window_->find<QAction>("action.undo").trigger();
    QCOMPARE(function(), before);
}

void TransferFilesTest::ofSeveralPresetsOneIsChosen()
{
    const TransferFunction before = function();
    load(written("two.json", R"([{"Name": "red", "RGBPoints": [0, 1, 0, 0, 1, 1, 0, 0]},
                                 {"Name": "blue & white", "RGBPoints": [0, 0, 0, 1, 1, 1, 1, 1]}])"));
    QTRY_VERIFY(window_->window.findChild<QInputDialog*>("transfer.choice") != nullptr);
    auto& choice = window_->find<QInputDialog>("transfer.choice");
    QCOMPARE(function(), before);
    QCOMPARE(choice.comboBoxItems().size(), 2);
    QVERIFY(choice.comboBoxItems().last().endsWith("blue & white"));
    choice.setTextValue(choice.comboBoxItems().last());
    choice.accept();
    QCOMPARE(evaluate(function(), session().range().minimum).colour, (std::array<double, 3>{0, 0, 1}));
}

void TransferFilesTest::aFileForParaviewLooksTheSame()
{
    const TransferFunction before = function();
    window_->find<QAction>("transfer.save.paraview").trigger();
    const QString path = window_->folder.filePath("for-paraview.json");
    choose("transferParaviewDialog", path);
    QTRY_VERIFY(QFile::exists(path));
    window_->find<QAction>("transfer.change.mirror").trigger();
    const TransferFunction between = function();
    load(path);
    QTRY_VERIFY(function() != between);
    compareLooks(before, function(), true);
}

void TransferFilesTest::aColourMapChangesTheColoursAlone()
{
    const TransferFunction before = function();
    QVERIFY(!colourMaps().empty());
    for (const ColourMap& map : colourMaps()) {
        auto& action = window_->find<QAction>(("transfer.colours." + map.id).c_str());
        QVERIFY(!action.icon().isNull());
        action.trigger();
        compareLooks(before, function(), false);
        QCOMPARE(function().colours.front().colour, map.nodes.front().colour);
    }
}

QTEST_MAIN(TransferFilesTest)
#include "transfer_files_test.moc"
