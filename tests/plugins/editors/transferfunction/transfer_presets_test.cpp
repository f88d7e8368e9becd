// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/editors/transferfunction/own_presets.h"
#include "plugins/widgets/curves/whole_function.h"
#include "tests/plugins/editors/transferfunction/editor_fixture.h"

#include <tan/transfer.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFrame>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSet>
#include <QStandardPaths>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <map>

using namespace tetra;

/// Presets of the transfer function (R18): searched for, taken whole or in part, saved and deleted.
class TransferPresetsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase()
    {
        model_ = editorModel(folder_, "transfer-presets");
        QDir(presetFolder()).removeRecursively();
    }
    void init() { editor_ = std::make_unique<EditorFixture>(model_); }
    void cleanup()
    {
        editor_.reset();
        QDir(presetFolder()).removeRecursively();
    }
    void thereAreManyAndAllAreValid();
    void theListIsSearched();
    void wordsOfEveryLanguageFindPresets();
    void thatNothingIsFoundIsTold();
    void hounsfieldUnitsAreTheDatasOrAreAssumed();
    void presetsInHounsfieldUnitsKeepTheirValues();
    void aStretchedPresetIsTold();
    void coloursAreTakenAlone();
    void opacitiesAreTakenAlone();
    void anOwnPresetIsSavedTakenAndDeleted();
    void anyNameCanBeAFile();
    void presetsOfEarlierProgramsAreOpened();
    void filesThatAreNoPresetsArePassedOver();
    void aSlowFolderStopsNobody();

private:
    static QString presetFolder()
    {
        return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/transfer-functions";
    }
    JoinedFunction function() const { return editor_->function(); }
    QListWidget& list() const { return editor_->find<QListWidget>("transfer.presetPopup.list"); }
    QStringList shownNames() const
    {
        QStringList names;
        for (int row = 0; row < list().count(); ++row)
            if (!list().item(row)->isHidden())
                names.append(list().item(row)->text());
        return names;
    }
    void open() const
    {
        QTest::mouseClick(&editor_->find<QToolButton>("transfer.presets"), Qt::LeftButton);
        QTRY_VERIFY(editor_->find<QFrame>("transfer.presetPopup").isVisible());
    }
    /// As typed into the search, and taken by the Enter key.
    void take(const QString& text, int part) const
    {
        open();
        editor_->find<QComboBox>("transfer.presetPopup.part").setCurrentIndex(part);
        auto& search = editor_->find<QLineEdit>("transfer.presetPopup.search");
        QTest::keyClicks(&search, text);
        QTRY_VERIFY(!shownNames().isEmpty());
        QTest::keyClick(&search, Qt::Key_Return);
        QVERIFY(!editor_->find<QFrame>("transfer.presetPopup").isVisible());
    }
    void save(const QString& name) const
    {
        open();
        editor_->find<QPushButton>("transfer.presetPopup.save").click();
        auto& dialog = editor_->find<QInputDialog>("transfer.presetName");
        dialog.setTextValue(name);
        dialog.accept();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<EditorFixture> editor_;
};

void TransferPresetsTest::thereAreManyAndAllAreValid()
{
    const std::vector<Preset> presets = suppliedPresets();
    QVERIFY(presets.size() >= 30);
    QSet<QString> ids, names;
    for (const Preset& preset : presets) {
        ids.insert(preset.id);
        names.insert(preset.name);
        for (const TransferLimits& range : {TransferLimits{0, 1}, hounsfieldRange, TransferLimits{-3e5, 7e5}}) {
            const TransferFunction function = preset.make(range, 0.5);
            QVERIFY2(checkTransferFunction(function), qPrintable(preset.id));
            QCOMPARE(function.unitDistance, 0.5);
            const auto [least, largest] = *extentOf(function);
            const double room = 1e-9 * (range.largest - range.least);
            QVERIFY2(least >= range.least - room && largest <= range.largest + room, qPrintable(preset.id));
        }
    }
    QCOMPARE(ids.size(), static_cast<qsizetype>(presets.size()));
    QCOMPARE(names.size(), static_cast<qsizetype>(presets.size()));
}

void TransferPresetsTest::theListIsSearched()
{
    open();
    const auto all = static_cast<qsizetype>(suppliedPresets().size());
    QCOMPARE(shownNames().size(), all);
    auto& search = editor_->find<QLineEdit>("transfer.presetPopup.search");
    QTest::keyClicks(&search, "VID");
    QCOMPARE(shownNames(), QStringList{"cividis"});
    const QListWidgetItem& found = *list().currentItem();
    QVERIFY(found.toolTip().contains("CC0") && !found.icon().isNull());
    search.clear();
    editor_->find<QComboBox>("transfer.presetPopup.part").setCurrentIndex(2);
    QCOMPARE(shownNames().size(), all - static_cast<qsizetype>(colourMaps().size())); // maps have no opacities
    QVERIFY(!editor_->find<QPushButton>("transfer.presetPopup.delete").isEnabled());
}

/// One window for all of them: it takes longer to come up than they do.
void TransferPresetsTest::wordsOfEveryLanguageFindPresets()
{
    const std::pair<const char*, QStringList> cases[] = {
        {"CT: bone", {"bone", "Knochen", "osso", "CT bone", "Skelett ct"}},
        {"CT: skin and bone", {"skin bone", "bone skin", "Haut", "pelle"}},
        {"CT: lung", {"lung", "Lunge", "polmone"}},
        {"CT: teeth", {"teeth", "Zähne", "denti"}},
        {"Metal and pores", {"pores", "poren metall", "porosità"}},
        {"turbo", {"rainbow"}},
        {"MR: brain", {"mri"}},
    };
    open();
    for (const auto& [name, texts] : cases)
        for (const QString& words : texts) {
            editor_->find<QLineEdit>("transfer.presetPopup.search").setText(words);
            QVERIFY2(shownNames().contains(name), qPrintable(words));
            QVERIFY2(shownNames().size() < list().count() / 2, qPrintable(words));
            QVERIFY(!editor_->find<QLabel>("transfer.presetPopup.nothing").isVisible());
        }
}

void TransferPresetsTest::thatNothingIsFoundIsTold()
{
    open();
    auto& search = editor_->find<QLineEdit>("transfer.presetPopup.search");
    auto& nothing = editor_->find<QLabel>("transfer.presetPopup.nothing");
    const int steps = editor_->undoSteps();
    search.setText("zebra");
    QVERIFY(shownNames().isEmpty());
    QVERIFY(nothing.isVisible());
    QVERIFY(nothing.text().contains("zebra"));
    QCOMPARE(list().accessibleDescription(), nothing.text());
    QTest::keyClick(&search, Qt::Key_Return);
    QCOMPARE(editor_->undoSteps(), steps);
    search.setText("viridis");
    QVERIFY(!nothing.isVisible());
}

void TransferPresetsTest::hounsfieldUnitsAreTheDatasOrAreAssumed()
{
    const auto unitsOf = [](const char* unit, SampleType type, double least) {
        return hounsfieldUnits({unit, type}, {least, 2000});
    };
    QVERIFY(unitsOf("HU", SampleType::Float32, -20) == HounsfieldUnits::Told);
    QVERIFY(unitsOf("Hounsfield units", SampleType::UInt16, 0) == HounsfieldUnits::Told);
    for (const double least : {-1024.0, -1031.0, -1000.0, -2048.0, -3024.0})
        QVERIFY(unitsOf("", SampleType::Int16, least) == HounsfieldUnits::Likely);
    QVERIFY(unitsOf("", SampleType::Int32, -1024) == HounsfieldUnits::Likely);
    QVERIFY(unitsOf("", SampleType::Int16, -5) == HounsfieldUnits::None);
    QVERIFY(unitsOf("", SampleType::UInt16, 0) == HounsfieldUnits::None);
    QVERIFY(unitsOf("", SampleType::Float32, -1024) == HounsfieldUnits::None); // not whole
    QVERIFY(unitsOf("Pa", SampleType::Int16, -1024) == HounsfieldUnits::None);
}

void TransferPresetsTest::presetsInHounsfieldUnitsKeepTheirValues()
{
    const std::vector<Preset> presets = suppliedPresets();
    const auto bone = std::ranges::find(presets, "preset.ct-bone", &Preset::id);
    QVERIFY(bone->isHounsfield);
    const TransferLimits data{-1024, 1900};
    const auto firstPoint = [&](HounsfieldUnits units, const TransferLimits& range) {
        const TransferFunction made = withPreset({}, *bone, PresetPart::Both, rangeOf(*bone, units, range), 400);
        return made.opacities.front().value;
    };
    QVERIFY(std::abs(firstPoint(HounsfieldUnits::Told, data) - 150) < 1e-9);
    QVERIFY(std::abs(firstPoint(HounsfieldUnits::Likely, data) - 150) < 1e-9);
    QVERIFY(std::abs(firstPoint(HounsfieldUnits::None, {0, 4095}) - 1174) < 1e-9); // as if it began at -1024
    QVERIFY(!assumptionOf(*bone, HounsfieldUnits::Told, data));
    QVERIFY(assumptionOf(*bone, HounsfieldUnits::Likely, data)->text().find("-1024 to 1900") != std::string::npos);
    QVERIFY(assumptionOf(*bone, HounsfieldUnits::None, {0, 255})->text().find("0 to 255") != std::string::npos);
    const auto brain = std::ranges::find(presets, "preset.mr-brain", &Preset::id);
    QVERIFY(!assumptionOf(*brain, HounsfieldUnits::None, data));
    QCOMPARE(rangeOf(*brain, HounsfieldUnits::Told, data).largest, data.largest);
}

/// The sample has no Hounsfield units.
void TransferPresetsTest::aStretchedPresetIsTold()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    take("Knochen Skelett", 0);
    const ValueRange range = editor_->session().range();
    const double share = (150.0 + 1024) / 4095;
    QVERIFY(std::abs(function().points.front().value - std::lerp(range.minimum, range.maximum, share)) <
            1e-6 * range.extent());
    QCOMPARE(editor_->messages().size(), 1);
    QVERIFY(editor_->messages().front().contains("Hounsfield"));
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
    take("Knochen Skelett", 1); // colours alone
    for (std::size_t i = 0; i < before.points.size(); ++i)
        QVERIFY(std::abs(opacityOf(editor_->transfer(), before.points[i].value) - double(before.points[i].opacity)) <
                1e-5);
    QVERIFY(editor_->transfer().colours != separated(before).colours);
}

void TransferPresetsTest::coloursAreTakenAlone()
{
    const JoinedFunction before = function();
    const int steps = editor_->undoSteps();
    take("diverging", 1);
    const TransferFunction whole =
        divergingTransferFunction(before.points.front().value, before.points.back().value, before.unitDistance);
    for (int sample = 0; sample <= 64; ++sample) {
        const double value =
            std::lerp(editor_->session().range().minimum, editor_->session().range().maximum, sample / 64.0);
        QVERIFY(std::abs(evaluate(editor_->transfer(), value).extinction -
                         evaluate(separated(before), value).extinction) < 1e-5);
        for (std::size_t channel = 0; channel < 3; ++channel)
            QVERIFY(std::abs(evaluate(editor_->transfer(), value).colour[channel] -
                             evaluate(whole, value).colour[channel]) < 0.01);
    }
    QCOMPARE(editor_->undoSteps(), steps + 1);
    editor_->undo();
    QCOMPARE(function(), before);
}

void TransferPresetsTest::opacitiesAreTakenAlone()
{
    const JoinedFunction before = function();
    take("diverging", 2);
    QVERIFY(std::abs(function().points.front().opacity - divergingTransferFunction(0, 1, 1).opacities.front().opacity) <
            1e-6);
    QCOMPARE(function().points.front().colour, before.points.front().colour);
    QCOMPARE(function().points.back().colour, before.points.back().colour);
}

void TransferPresetsTest::anOwnPresetIsSavedTakenAndDeleted()
{
    JoinedFunction moved = function();
    moved.points[4].value += 0.5;
    moved.points[4].opacity = 0.77F;
    editor_->session().setTransfer(separated(moved));
    const JoinedFunction kept = function();
    save("My & clouds/1");
    editor_->find<QAction>("transfer.preset.diverging").trigger();
    QVERIFY(function() != kept);
    take("My & clouds", 0); // another preset is of clouds, too
    QCOMPARE(function().points.size(), kept.points.size());
    for (std::size_t i = 0; i < kept.points.size(); ++i) {
        QVERIFY(std::abs(function().points[i].value - kept.points[i].value) <
                1e-9 * std::abs(kept.points.back().value));
        QCOMPARE(function().points[i].opacity, kept.points[i].opacity);
        QCOMPARE(function().points[i].colour, kept.points[i].colour);
    }
    QVERIFY(std::abs(function().unitDistance - kept.unitDistance) < 1e-9 * kept.unitDistance);
    open();
    QTRY_VERIFY(shownNames().contains("My & clouds/1"));
    list().setCurrentRow(0);
    editor_->find<QPushButton>("transfer.presetPopup.delete").click();
    QTRY_VERIFY(!shownNames().contains("My & clouds/1"));
    QVERIFY(ownPresets().empty());
}

void TransferPresetsTest::anyNameCanBeAFile()
{
    for (const QString& name :
         {QString("../up"), QString("a\\b:c*?"), QString::fromUtf8("Überblick 50 %"), QString(".")}) {
        QVERIFY(saveOwnPreset(name, sequentialTransferFunction(0, 1, 0.1)));
        QCOMPARE(ownPresets().size(), std::size_t{1});
        QCOMPARE(ownPresets().front().name, name);
        QVERIFY(deleteOwnPreset(name));
    }
    QVERIFY(!deleteOwnPreset("never saved"));
}

/// The files in old_presets were written by 36ed1f8, the first that had presets, and `first` by c057bee, before masks
/// and groups; the names are those that they had there.
void TransferPresetsTest::presetsOfEarlierProgramsAreOpened()
{
    QVERIFY(QDir().mkpath(presetFolder()));
    const auto copy = [](const char* kept, const char* name) {
        return QFile::copy(TAN_SOURCE_DIR "/tests/plugins/editors/transferfunction/old_presets/" + QString(kept),
                           presetFolder() + "/" + name);
    };
    QVERIFY(copy("with_mask.json", "Bone and skin.json"));
    QVERIFY(copy("with_groups.json", "H%C3%B6he 50 %25%3A a%2Fb.json"));
    QVERIFY(copy("with_groups.json", "Scan 1.2.json"));
    QVERIFY(copy("first.json", "first.json"));
    const TransferFunction groups = transferFunctionFromPoints({{0, {0.25F, 0.5F, 1}, 0},
                                                                {0.25, {0.25F, 0.5F, 1}, 0.125F, 3},
                                                                {0.25, {1, 0.75F, 0}, 0.5F, 3},
                                                                {1, {1, 0, 0}, 0.875F}},
                                                               0.05);
    TransferFunction mask = groups;
    mask.mask = TransferMask{0.125, 0.9};
    const TransferFunction first = transferFunctionFromPoints({{40, {0.25F, 0.5F, 1}, 0},
                                                               {90, {0.25F, 0.5F, 1}, 0.125F},
                                                               {90, {1, 0.75F, 0}, 0.5F},
                                                               {190, {1, 0, 0}, 0.875F}},
                                                              0.4);
    const std::map<QString, TransferFunction> expected = {
        {"Bone and skin", mask}, {QString::fromUtf8("Höhe 50 %: a/b"), groups}, {"Scan 1.2", groups}, {"first", first}};
    QCOMPARE(ownPresets().size(), expected.size());
    for (const Preset& preset : ownPresets()) {
        QVERIFY2(expected.contains(preset.name), qPrintable(preset.name));
        QVERIFY(preset.unitDistance == expected.at(preset.name).unitDistance);
        QVERIFY(preset.make({0, 1}, *preset.unitDistance) == expected.at(preset.name));
    }
    // They are replaced and deleted as others are.
    for (const auto& [name, function] : expected) {
        QVERIFY(saveOwnPreset(name, sequentialTransferFunction(0, 1, 0.1)));
        QCOMPARE(ownPresets().size(), expected.size());
    }
    for (const auto& [name, function] : expected)
        QVERIFY(deleteOwnPreset(name));
    QVERIFY(QDir(presetFolder()).isEmpty());
}

void TransferPresetsTest::filesThatAreNoPresetsArePassedOver()
{
    QVERIFY(QDir().mkpath(presetFolder()));
    QFile file(presetFolder() + "/broken.json");
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("{\"points\": 3}") > 0);
    file.close();
    QVERIFY(ownPresets().empty());
    open();
    QCOMPARE(shownNames().size(), static_cast<qsizetype>(suppliedPresets().size()));
}

/// Presets are read by a worker: what it finds comes when the popup is there already.
void TransferPresetsTest::aSlowFolderStopsNobody()
{
    QVERIFY(saveOwnPreset("found later", sequentialTransferFunction(0, 1, 0.1)));
    QTest::mouseClick(&editor_->find<QToolButton>("transfer.presets"), Qt::LeftButton);
    QVERIFY(editor_->find<QFrame>("transfer.presetPopup").isVisible());
    QVERIFY(!shownNames().contains("found later"));
    QTest::keyClicks(&editor_->find<QLineEdit>("transfer.presetPopup.search"), "later");
    QTRY_COMPARE(shownNames(), QStringList{"found later"});
}

QTEST_MAIN(TransferPresetsTest)
#include "transfer_presets_test.moc"
