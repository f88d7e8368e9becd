// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/value_statistics.h"
#include "core/view/accuracy_scale.h"
#include "plugins/host/file_saving.h"
#include "plugins/samples/samples.h"
#include "plugins/widgets/colour_button.h"
#include "plugins/widgets/value_box.h"
#include "tests/core/render/scene_parts.h"
#include "tests/ui/window_fixture.h"
#include "ui/panels/accuracy_curve.h"
#include "ui/panels/build_panel.h"
#include "ui/panels/parameter_form.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QRadioButton>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QUndoStack>
#include <QWheelEvent>

using namespace tetra;

/// Every control of the panels for accuracy (R26) and isovalues (R19), by object names.
class PanelsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void nothingCanBeChosenWithoutAModel();
    void allInputsOfTheAccuracyAgree_data();
    void allInputsOfTheAccuracyAgree();
    void aTypedErrorIsKept();
    void theCurveIsChosenByMouseKeyAndWheel();
    void theSliderLiesAlongTheCurve();
    void aHeldKeyIsOneStep();
    void numbersFollowTheAccuracyWithTheirShare();
    void aModelThatEndsEarlySaysSo();
    void oneNumberIsErrorAndWarping();
    void theWarpingIsSetApart();
    void isovaluesAreAddedEditedAndRemoved();
    void isovaluesOfMapsAreInDeviationsToo();
    void theColourMenuOffersThePalette();
    void aColourIsSeenOnAWindowOfTheSame();
    void deleteRemovesTheRow();
    void isovalueRowsFollowUndo();
    void everyControlHasANameForThoseWhoHearIt();
    void valueBoxesTakeAnyMagnitude();
    void theDetailOfAModelIsChosen_data();
    void theDetailOfAModelIsChosen();
    void theDetailStaysWithAnotherBuilder();
    void weightsAreCheckedWhileTheyAreTyped();
    void aStepFromZeroIsATenth();
    void formsKeepSignificantDigits();
    void lengthsOfATinyDomainAreEdited();

private:
    const Session& session() const { return window_->workbench.session(); }
    const Isovalue& isovalue(std::size_t index) const { return session().view().isovalues[index]; }
    void open(double finalErrorPercent = 0);

    std::unique_ptr<WindowFixture> window_;
};

void PanelsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("panels");
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
}

void PanelsTest::open(double finalErrorPercent)
{
    const auto path = buildSampleModel(*window_->host, sampleDataset(16), window_->folderPath(), finalErrorPercent);
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(session().model() && window_->settled());
}

void PanelsTest::init()
{
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void PanelsTest::cleanup()
{
    window_.reset();
}

void PanelsTest::nothingCanBeChosenWithoutAModel()
{
    QVERIFY(!window_->find<QWidget>("accuracy").isEnabled());
    QVERIFY(!window_->find<QWidget>("isovalues").isEnabled());
    QVERIFY(!window_->find<QAction>("action.savePicture").isEnabled());
    QVERIFY(!window_->find<QAction>("action.undo").isEnabled());
    QVERIFY(window_->find<QWidget>("empty").isVisible());
}

void PanelsTest::allInputsOfTheAccuracyAgree_data()
{
    QTest::addColumn<double>("percent");
    for (const double percent : {4.0, 1.5, 0.37, 0.1, 0.0})
        QTest::addRow("%g", percent) << percent;
}

void PanelsTest::allInputsOfTheAccuracyAgree()
{
    QFETCH(double, percent);
    open();
    auto& box = window_->find<QDoubleSpinBox>("accuracy.box");
    box.setValue(percent);
    QCOMPARE(session().view().query.error, percent);
    const auto& slider = window_->find<QSlider>("accuracy.slider");
    QCOMPARE(slider.value(), static_cast<int>(std::lround(accuracyPosition(percent) * slider.maximum())));
    for (const double preset : accuracyPresets)
        QCOMPARE(window_->find<QToolButton>("accuracy.preset." + QString::number(preset)).isChecked(),
                 preset == percent);
}

/// However small it is: a value range of 10^6 has a sample's error of 0.00001 %.
void PanelsTest::aTypedErrorIsKept()
{
    open();
    auto& box = window_->find<QDoubleSpinBox>("accuracy.box");
    const auto type = [&box](const QString& text) {
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
    };
    type("0.00001");
    QCOMPARE(session().view().query.error, 1e-5);
    QVERIFY2(QLocale().toDouble(box.text().remove(box.suffix())) == 1e-5, qPrintable(box.text()));
    type("2.5e-7 %");
    QCOMPARE(session().view().query.error, 2.5e-7);
    type("0.123456");
    QCOMPARE(session().view().query.error, 0.123456);
    type("101"); // more than everything
    QCOMPARE(session().view().query.error, 0.123456);
}

void PanelsTest::theCurveIsChosenByMouseKeyAndWheel()
{
    open();
    auto& curve = window_->find<AccuracyCurve>("accuracy.curve");
    const int axis = curve.width() - curve.leftMargin() - curve.rightMargin();
    const QPoint at(curve.leftMargin() + static_cast<int>(accuracyPosition(0.2) * axis), curve.height() / 2);
    QTest::mouseClick(&curve, Qt::LeftButton, {}, at);
    QVERIFY(std::abs(session().view().query.error - 0.2) < 0.02);
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(1);
    QTest::keyClick(&curve, Qt::Key_Right);
    QCOMPARE(session().view().query.error, 0.8);
    QTest::keyClick(&curve, Qt::Key_End);
    QCOMPARE(session().view().query.error, 0.0);
    curve.setFocus();
    QWheelEvent down(at, curve.mapToGlobal(at), {}, {0, -120}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&curve, &down);
    QCOMPARE(session().view().query.error, finestOnScale);
}

void PanelsTest::theSliderLiesAlongTheCurve()
{
    const auto& curve = window_->find<AccuracyCurve>("accuracy.curve");
    const auto& slider = window_->find<QSlider>("accuracy.slider");
    const int inset = slider.style()->pixelMetric(QStyle::PM_SliderLength, nullptr, &slider) / 2;
    const int left = slider.mapTo(&window_->window, QPoint(inset, 0)).x();
    const int right = slider.mapTo(&window_->window, QPoint(slider.width() - inset, 0)).x();
    QVERIFY(std::abs(left - curve.mapTo(&window_->window, QPoint(curve.leftMargin(), 0)).x()) <= 1);
    QVERIFY(std::abs(right - curve.mapTo(&window_->window, QPoint(curve.width() - curve.rightMargin(), 0)).x()) <= 1);
}

void PanelsTest::aHeldKeyIsOneStep()
{
    open();
    auto& slider = window_->find<QSlider>("accuracy.slider");
    for (const bool repeated : {false, true, true, true}) {
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, {}, repeated);
        QCoreApplication::sendEvent(&slider, &press);
    }
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_Right, Qt::NoModifier);
    QCoreApplication::sendEvent(&slider, &release);
    QCOMPARE(session().view().query.error, 0.4);
    QCOMPARE(window_->workbench.session().undoStack().count(), 1);
    QTest::keyClick(&slider, Qt::Key_Right);
    QCOMPARE(window_->workbench.session().undoStack().count(), 2);
}

void PanelsTest::numbersFollowTheAccuracyWithTheirShare()
{
    open();
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(0);
    const auto model = session().model();
    QCOMPARE(window_->find<QLabel>("accuracy.sites").text(), QLocale().toString(model->siteCount()));
    QCOMPARE(window_->find<QLabel>("accuracy.siteShare").text(), QString("100 % of all"));
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(2);
    const MeshSize size = meshSizeAt(*model, {2});
    QCOMPARE(window_->find<QLabel>("accuracy.sites").text(), QLocale().toString(size.sites));
    QCOMPARE(window_->find<QLabel>("accuracy.tetrahedra").text(),
             QLocale().toString(static_cast<qulonglong>(size.tetrahedra)));
    QVERIFY(!window_->find<QLabel>("accuracy.limit").isVisible());
    const double inUnits = 0.02 * session().range().extent();
    QVERIFY(window_->find<QLabel>("accuracy.inUnits").text().contains(QLocale().toString(inUnits, 'g', 3)));
}

void PanelsTest::aModelThatEndsEarlySaysSo()
{
    open(3);
    QVERIFY(window_->find<QLabel>("accuracy.limit").isVisible());
}

/// Of curvilinear data the number on the scale is both (R7).
void PanelsTest::oneNumberIsErrorAndWarping()
{
    const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    const auto path = buildSampleModel(*window_->host, *grid, window_->folderPath(), 0);
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(session().model() && window_->settled());
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(2);
    QCOMPARE(session().meshSize().sites, meshSizeAt(*session().model(), {2, 2}).sites);
    QVERIFY(session().meshSize().warping <= 2);
    const QString warping = QLocale().toString(0.02 * session().model()->diagonal(), 'g', 3);
    QVERIFY(window_->find<QLabel>("accuracy.inUnits").text().contains(warping));
}

/// C1: error and warping are set apart where a model has both; one step each, and the sizes follow.
void PanelsTest::theWarpingIsSetApart()
{
    open();
    auto& limit = window_->find<QComboBox>("accuracy.warpingLimit");
    auto& box = window_->find<QDoubleSpinBox>("accuracy.warping");
    QVERIFY(!limit.isVisibleTo(&window_->window) && !box.isVisibleTo(&window_->window)); // a lattice
    const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    const auto path = buildSampleModel(*window_->host, *grid, window_->folderPath(), 0);
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(session().model() && session().model()->description().warpingWeight > 0 && window_->settled());
    QVERIFY(limit.isVisibleTo(&window_->window) && !box.isVisibleTo(&window_->window)); // the same as the error
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(2);
    const std::uint32_t both = session().meshSize().sites;
    QTest::keyClick(&limit, Qt::Key_Down);
    QVERIFY((session().view().query.warping == WarpingChoice{WarpingLimit::Own, 2}));
    QVERIFY(box.isVisibleTo(&window_->window));
    QCOMPARE(box.value(), 2.0);
    box.setValue(20);
    QVERIFY((session().view().query.warping == WarpingChoice{WarpingLimit::Own, 20}));
    QCOMPARE(session().meshSize().sites, meshSizeAt(*session().model(), {2, 20}).sites);
    const QString warping = QLocale().toString(0.2 * session().model()->diagonal(), 'g', 3);
    QVERIFY(window_->find<QLabel>("accuracy.inUnits").text().contains(warping));
    QTRY_VERIFY(session().showsQuery() && session().shown()->wholeSites < both);
    QVERIFY(window_->find<QLabel>("accuracy.outcome").text().contains("warping 20 %"));
    QTest::keyClick(&limit, Qt::Key_Down);
    QCOMPARE(session().view().query.warping.limit, WarpingLimit::None);
    QVERIFY(!box.isVisibleTo(&window_->window));
    QVERIFY(window_->find<QLabel>("accuracy.inUnits").text().contains("any warping"));
    window_->workbench.session().undoStack().undo();
    window_->workbench.session().undoStack().undo();
    window_->workbench.session().undoStack().undo();
    QVERIFY(session().view().query.warping == WarpingChoice());
    QCOMPARE(limit.currentIndex(), 0);
    QCOMPARE(session().meshSize().sites, both);
}

void PanelsTest::isovaluesAreAddedEditedAndRemoved()
{
    open();
    QTest::mouseClick(&window_->find<QPushButton>("isovalues.add"), Qt::LeftButton);
    QCOMPARE(session().view().isovalues.size(), std::size_t(2));
    window_->find<QDoubleSpinBox>("isovalue.1.value.box").setValue(42);
    QCOMPARE(isovalue(1).value, 42.0);
    auto& slider = window_->find<QSlider>("isovalue.1.value.slider");
    QCOMPARE(slider.value(), static_cast<int>(std::lround(42 / session().range().maximum * slider.maximum())));
    slider.setValue(slider.maximum());
    QCOMPARE(isovalue(1).value, session().range().maximum);
    QCOMPARE(window_->find<QDoubleSpinBox>("isovalue.1.value.box").value(), session().range().maximum);
    window_->find<QSlider>("isovalue.1.opacity.slider").setValue(0);
    QCOMPARE(isovalue(1).opacity, 0.01F);
    window_->find<QCheckBox>("isovalue.1.visible").click();
    QVERIFY(!isovalue(1).visible);
    const Isovalue last = isovalue(1);
    QTest::mouseClick(&window_->find<QWidget>("isovalue.0.remove"), Qt::LeftButton);
    QCOMPARE(session().view().isovalues, std::vector{last});
    QTest::mouseClick(&window_->find<QWidget>("isovalue.0.remove"), Qt::LeftButton);
    QVERIFY(window_->find<QLabel>("isovalues.hint").isVisible());
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).surfaces.empty());
}

void PanelsTest::isovaluesOfMapsAreInDeviationsToo()
{
    QVERIFY(window_->window.findChild<QDoubleSpinBox*>("isovalue.0.deviations") == nullptr); // of no map
    const auto path = buildMapModel(*window_->host, 12, window_->folderPath());
    window_->window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(window_->window.findChild<QDoubleSpinBox*>("isovalue.0.deviations") != nullptr && window_->settled());
    const auto kept = keptStatistics(session().model()->description().parameters);
    QVERIFY(kept);
    const auto near = [](double one, double other) { return std::abs(one - other) < 0.01; };
    const auto asShown = [](double one, double other) { return std::abs(one - other) < 0.06; }; // with one decimal
    auto& deviations = window_->find<QDoubleSpinBox>("isovalue.0.deviations");
    auto& value = window_->find<QDoubleSpinBox>("isovalue.0.value.box");
    QVERIFY(near(deviations.value(), kept->deviationsAt(isovalue(0).value)));
    const double before = isovalue(0).value;
    deviations.setValue(1.5);
    QVERIFY(near(isovalue(0).value, kept->valueAt(1.5)));
    QVERIFY(asShown(value.value(), kept->valueAt(1.5)));
    QVERIFY2(deviations.toolTip().contains(QLocale().toString(kept->mean, 'g', 6)), qPrintable(deviations.toolTip()));
    window_->workbench.session().undoStack().undo();
    QCOMPARE(isovalue(0).value, before);
    for (const auto& [text, number] : {std::pair("2.25sd", 2.25), std::pair("-0.5 \u03c3", -0.5)}) {
        value.selectAll();
        for (const QChar letter : QString::fromUtf8(text)) // keyClicks() knows ASCII alone
            QTest::sendKeyEvent(QTest::Click, &value, Qt::Key_unknown, QString(letter), Qt::NoModifier);
        QTest::keyClick(&value, Qt::Key_Return);
        QVERIFY2(asShown(isovalue(0).value, kept->valueAt(number)), text);
        QVERIFY(near(deviations.value(), number));
    }
}

void PanelsTest::theColourMenuOffersThePalette()
{
    open();
    auto& button = window_->find<ColourButton>("isovalue.0.colour");
    emit button.menu()->aboutToShow();
    auto* green = button.menu()->findChild<QAction*>("isovalue.0.colour.2");
    QVERIFY(green != nullptr);
    green->trigger();
    QVERIFY(isovalue(0).green > isovalue(0).red);
    QCOMPARE(button.colour(), QColor::fromRgbF(isovalue(0).red, isovalue(0).green, isovalue(0).blue));
}

void PanelsTest::aColourIsSeenOnAWindowOfTheSame()
{
    const QColor window(42, 43, 46);
    ColourButton button;
    QPalette dark(window);
    dark.setColor(QPalette::WindowText, Qt::white);
    button.setPalette(dark);
    button.setColour(window);
    QImage image(16, 16, QImage::Format_RGB32);
    image.fill(window);
    QPainter(&image).drawPixmap(0, 0, button.icon().pixmap(QSize(16, 16), 1.0));
    QVERIFY(qGray(image.pixel(8, 0)) > qGray(window.rgb()) + 60); // its rim
    QCOMPARE(image.pixelColor(8, 8), window);
}

void PanelsTest::deleteRemovesTheRow()
{
    open();
    QTest::keyClick(&window_->find<QCheckBox>("isovalue.0.visible"), Qt::Key_Delete);
    QCOMPARE(session().view().isovalues.size(), std::size_t(0));
}

void PanelsTest::isovalueRowsFollowUndo()
{
    open();
    window_->find<QAction>("action.addIsovalue").trigger();
    window_->find<QDoubleSpinBox>("isovalue.1.value.box").setValue(42);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(window_->find<QDoubleSpinBox>("isovalue.1.value.box").value() != 42);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(window_->window.findChild<QWidget*>("isovalue.1") == nullptr);
    window_->find<QAction>("action.redo").trigger();
    window_->find<QAction>("action.redo").trigger();
    QCOMPARE(window_->find<QDoubleSpinBox>("isovalue.1.value.box").value(), 42.0);
}

void PanelsTest::everyControlHasANameForThoseWhoHearIt()
{
    open();
    QStringList nameless;
    for (const QWidget* widget : window_->window.findChildren<QWidget*>()) {
        const bool isControl = qobject_cast<const QAbstractSlider*>(widget) ||
                               qobject_cast<const QAbstractSpinBox*>(widget) ||
                               qobject_cast<const QAbstractButton*>(widget);
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool hasText = button != nullptr && !button->text().isEmpty();
        if (isControl && !widget->objectName().startsWith("qt_") && widget->objectName().contains('.') && !hasText &&
            widget->accessibleName().isEmpty())
            nameless.append(widget->objectName());
    }
    QCOMPARE(nameless, QStringList());
}

void PanelsTest::valueBoxesTakeAnyMagnitude()
{
    ValueBox box;
    box.setLocale(QLocale::c());
    box.setValueRange(-1e-12, 3e-12);
    box.setValue(2e-12);
    QCOMPARE(box.value(), 2e-12);
    QCOMPARE(box.text(), QString("2e-12"));
    box.setValueRange(0, 65535);
    box.setValue(1234);
    QCOMPARE(box.text(), QString("1234"));
}

void PanelsTest::theDetailOfAModelIsChosen_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<QString>("builder");
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("first");
    QTest::newRow("small data") << 40 << "refinement"
                                << "error"
                                << "everything";
    QTest::newRow("more than a million points") << 101 << "refinement"
                                                << "error"
                                                << "good";
    QTest::newRow("decimated") << 40 << "decimation"
                               << "finest"
                               << "everything";
}

/// What is kept, with what it takes: a good choice for the size of the data first, by mouse or keys, and the same as
/// the builder's options say.
void PanelsTest::theDetailOfAModelIsChosen()
{
    QFETCH(int, size);
    QFETCH(QString, builder);
    QFETCH(QString, option);
    QFETCH(QString, first);
    window_->window.open(
        QString::fromStdString(writeNrrd(sampleDataset(static_cast<std::uint32_t>(size)), window_->folderPath())));
    QTRY_VERIFY(window_->find<QPushButton>("build.start").isVisible());
    auto& builders = window_->find<QComboBox>("build.builder");
    builders.setCurrentIndex(builders.findData(builder));
    auto& error = window_->find<QDoubleSpinBox>("build.option." + option);
    const std::map<QString, double> errors{{"quick", 1}, {"good", 0.1}, {"everything", 0}};
    const auto button = [&](const QString& name) -> QRadioButton& {
        return window_->find<QRadioButton>("build.detail." + name);
    };
    QVERIFY(button(first).isChecked());
    QCOMPARE(error.value(), errors.at(first));
    std::map<QString, QString> needs;
    for (const auto& [name, percent] : errors) {
        auto& choice = button(name);
        QVERIFY(choice.isVisible() && choice.focusPolicy() != Qt::NoFocus && !choice.toolTip().isEmpty());
        choice.click();
        QCOMPARE(error.value(), percent);
        QVERIFY(choice.isChecked());
        QTRY_VERIFY(!window_->find<BuildPanel>("build").looking());
        const QString needed = window_->find<QLabel>("build.detail." + name + ".size").text();
        QVERIFY2(needed.contains("MiB, ") && needed.endsWith(" s"), qPrintable(needed));
        QVERIFY(choice.accessibleDescription().contains(needed)); // for those who hear it
        needs[name] = window_->find<QLabel>("build.estimate").text();
    }
    QVERIFY2(needs["quick"] != needs["everything"], qPrintable(needs["quick"]));
    button("everything").click();
    button("everything").setFocus();
    QTest::keyClick(&button("everything"), Qt::Key_Up);
    QVERIFY(button("good").isChecked());
    QCOMPARE(error.value(), 0.1);
    error.setValue(0.5); // none of the three
    for (const auto& [name, percent] : errors)
        QVERIFY2(!button(name).isChecked(), qPrintable(name));
    error.setValue(1);
    QVERIFY(button("quick").isChecked());
}

/// It is the user's, until another dataset is opened.
void PanelsTest::theDetailStaysWithAnotherBuilder()
{
    const auto read = [this](const Dataset& dataset) {
        window_->window.open(QString::fromStdString(writeNrrd(dataset, window_->folderPath())));
        QTRY_VERIFY(!window_->workbench.opening().reading().running() &&
                    window_->workbench.opening().datasets().dataset());
        QTRY_COMPARE(window_->workbench.opening().datasets().dataset()->pointCount(), dataset.pointCount());
    };
    const auto chosen = [this] {
        QStringList names;
        for (const auto* button : window_->window.findChildren<QRadioButton*>())
            if (button->objectName().startsWith("build.detail.") && button->isChecked())
                names.append(button->objectName().section('.', -1));
        return names;
    };
    auto& builders = window_->find<QComboBox>("build.builder");
    const auto choose = [&builders](const char* builder) { builders.setCurrentIndex(builders.findData(builder)); };
    read(sampleDataset(12));
    QCOMPARE(chosen(), QStringList{"everything"});
    window_->find<QRadioButton>("build.detail.quick").click();
    choose("decimation");
    QCOMPARE(chosen(), QStringList{"quick"});
    QCOMPARE(window_->find<QDoubleSpinBox>("build.option.finest").value(), 1.0);
    choose("refinement");
    QCOMPARE(chosen(), QStringList{"quick"});
    QCOMPARE(window_->find<QDoubleSpinBox>("build.option.error").value(), 1.0);
    window_->find<QDoubleSpinBox>("build.option.error").setValue(0.5); // none of the three
    QCOMPARE(chosen(), QStringList());
    choose("decimation");
    QCOMPARE(chosen(), QStringList{"everything"});
    window_->find<QRadioButton>("build.detail.good").click();
    read(sampleDataset(10));
    QCOMPARE(chosen(), QStringList{"everything"});
}

/// R6
void PanelsTest::weightsAreCheckedWhileTheyAreTyped()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(12), window_->folderPath())));
    QTRY_VERIFY(window_->find<QPushButton>("build.start").isVisible());
    auto& weights = window_->find<QLineEdit>("build.option.weights");
    auto& mistake = window_->find<QLabel>("build.option.weights.mistake");
    QVERIFY(weights.toolTip().contains("point:16,16,8,10"));
    QVERIFY(!mistake.isVisible());
    QTest::keyClicks(&weights, "point:1,2,3");
    QVERIFY(mistake.isVisible());
    QVERIFY2(mistake.text().contains("it has 3 numbers"), qPrintable(mistake.text()));
    QTest::keyClicks(&weights, ",4");
    QVERIFY(!mistake.isVisible());
}

/// Of percent and of whole numbers: Qt's own step from 0 is the last of the decimals.
void PanelsTest::aStepFromZeroIsATenth()
{
    ParameterForm form("form");
    Parameter percent, count;
    percent.id = "error";
    percent.defaultValue = 0.0;
    percent.maximum = 100;
    count.id = "skip";
    count.defaultValue = std::int64_t(0);
    count.maximum = 1000;
    form.setParameters({percent, count});
    auto& error = *form.findChild<QDoubleSpinBox*>("form.error");
    const auto valueAfter = [](QDoubleSpinBox& box, int key) {
        QTest::keyClick(&box, static_cast<Qt::Key>(key));
        return box.value();
    };
    QCOMPARE(valueAfter(error, Qt::Key_Up), 0.1);
    QCOMPARE(valueAfter(error, Qt::Key_Up), 0.2);
    QCOMPARE(valueAfter(error, Qt::Key_Down), 0.1);
    QCOMPARE(valueAfter(error, Qt::Key_Down), 0.0);
    QCOMPARE(valueAfter(error, Qt::Key_Down), 0.0); // the least
    QCOMPARE(valueAfter(error, Qt::Key_PageUp), 1.0);
    QCOMPARE(valueAfter(error, Qt::Key_Up), 1.1);
    QCOMPARE(valueAfter(error, Qt::Key_PageDown), 0.1);
    error.setValue(20);
    QCOMPARE(valueAfter(error, Qt::Key_Up), 21.0);
    error.setValue(0.05); // what is finer than that was typed
    QCOMPARE(valueAfter(error, Qt::Key_Up), 0.051);
    auto& skip = *form.findChild<QDoubleSpinBox*>("form.skip");
    QCOMPARE(valueAfter(skip, Qt::Key_Up), 1.0);
    QCOMPARE(valueAfter(skip, Qt::Key_Up), 2.0);
    QCOMPARE(valueAfter(skip, Qt::Key_PageDown), 0.0);
}

/// Of defaults, of what is shown, and of what is typed: data in metres have places of some micrometres.
void PanelsTest::formsKeepSignificantDigits()
{
    ParameterForm form("form");
    Parameter tolerance, place;
    tolerance.id = "tolerance";
    tolerance.defaultValue = 2e-5;
    tolerance.maximum = 1e-3;
    place.id = "place";
    place.defaultValue = Eigen::Vector3d(1e-5, 2e-5, 1.0 / 3);
    form.setParameters({tolerance, place});
    const auto number = [&] { return std::get<double>(form.value("tolerance")); };
    QCOMPARE(number(), 2e-5);
    QCOMPARE(std::get<Eigen::Vector3d>(form.value("place")), Eigen::Vector3d(1e-5, 2e-5, 1.0 / 3));
    form.setValues({{"tolerance", 0.000123456789}, {"place", Eigen::Vector3d(0.123456789, -1e-12, 408201.5)}});
    QCOMPARE(number(), 0.000123456789);
    QCOMPARE(std::get<Eigen::Vector3d>(form.value("place")), Eigen::Vector3d(0.123456789, -1e-12, 408201.5));

    auto& box = *form.findChild<QDoubleSpinBox*>("form.tolerance");
    QCOMPARE(box.text(), QString("0.000123456789"));
    for (const auto& [typed, value] : {std::pair("3e-7", 3e-7), {"0.00004", 4e-5}}) {
        box.selectAll();
        QTest::keyClicks(&box, typed);
        QTest::keyClick(&box, Qt::Key_Return);
        QVERIFY2(number() == value, typed);
    }
    QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(number(), 4.1e-5);
    box.selectAll();
    QTest::keyClicks(&box, "1"); // too much
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(number(), 4.1e-5);
}

void PanelsTest::lengthsOfATinyDomainAreEdited()
{
    Dataset tiny = sampleDataset(8);
    tiny.lattice.spacing = {1e-14, 1e-14, 1e-14};
    window_->window.open(
        QString::fromStdString(buildSampleModel(*window_->host, tiny, window_->folderPath()).string()));
    QTRY_VERIFY(session().model() && window_->settled());
    const double unit = session().view().appearance.transfer.unitDistance;
    auto& unitDistance = window_->find<QDoubleSpinBox>("transfer.unitDistance");
    QCOMPARE(unitDistance.value() / unit, 1.0);
    unitDistance.setValue(2 * unit);
    QCOMPARE(session().view().appearance.transfer.unitDistance / unit, 2.0);
    auto& distance = window_->find<QDoubleSpinBox>("view.distance");
    QCOMPARE(distance.value() / window_->viewport().camera().distance, 1.0);
}

QTEST_MAIN(PanelsTest)
#include "panels_test.moc"
