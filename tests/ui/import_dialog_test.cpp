// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/dataset_opening.h"
#include "plugins/host/file_saving.h"
#include "plugins/samples/samples.h"
#include "tests/plugins/host/gzipped.h"
#include "tests/ui/window_fixture.h"
#include "ui/dialogs/import_dialog.h"
#include "ui/panels/slice_preview.h"

#include <tan/verify.h>

#include <QAbstractButton>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>

#include <cmath>

using namespace tetra;

/// Opening datasets with choices: layouts of raw files with their preview, arrays and the like, parts, what is refused,
/// what is remembered, all by object names.
class ImportDialogTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void logarithmsAreTaken();
    void valuesOverPowersOfTenAreTold();
    void aRawFileIsDescribed();
    void aPackedRawFileIsDescribed();
    void aWrongLayoutIsSeenAtOnce();
    void thePreviewShowsTheSamples();
    void choicesAreThoseOfTheFile();
    void aPartIsReadBuiltAndVerified();
    void whatIsRefusedIsAskedAgain();
    void lastChoicesAreRemembered();
    void readingIsCancelled();
    void filesWithoutChoicesAreOpenedAtOnce();
    void theMenuAsksForAnyFile();
    void everythingHasANameAndFits();

private:
    QString writeRaw(const QString& name, std::uint32_t size = 8);
    QString writeChoices();
    void click(const char* name) { QTest::mouseClick(&window_->find<QPushButton>(name), Qt::LeftButton); }
    QDialog* dialog() const { return window_->window.findChild<QDialog*>("importDialog"); }
    void openAndAsk(const QString& path);
    void choose(const char* name, const QString& text);

    std::unique_ptr<WindowFixture> window_;
};

void ImportDialogTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("import");
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
}

void ImportDialogTest::init()
{
    QSettings().clear();
    PluginHostOptions options;
    options.folders = {TAN_BINARY_DIR "/lib/tan/plugins", TAN_CHOICES};
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, std::make_unique<PluginHost>(options));
    window_->window.show();
}

void ImportDialogTest::cleanup()
{
    window_.reset();
}

/// Sample n of 8^3 is its x + 16 y + 3 z.
QString ImportDialogTest::writeRaw(const QString& name, std::uint32_t size)
{
    QByteArray samples;
    for (std::uint32_t n = 0; n < size * size * size; ++n)
        samples += static_cast<char>(n % size + 16 * (n / size % size) + 3 * (n / size / size));
    QFile file(window_->folder.filePath(name));
    if (!file.open(QIODevice::WriteOnly) || file.write(samples) != samples.size())
        qFatal("cannot write");
    return file.fileName();
}

QString ImportDialogTest::writeChoices()
{
    QFile file(window_->folder.filePath("file.choices"));
    if (!file.open(QIODevice::WriteOnly) || file.write("x") != 1)
        qFatal("cannot write");
    return file.fileName();
}

void ImportDialogTest::openAndAsk(const QString& path)
{
    window_->workbench.opening().openWithOptions(path);
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
}

/// As a user does: programs that set an index are not heard.
void ImportDialogTest::choose(const char* name, const QString& text)
{
    auto& box = window_->find<QComboBox>(name);
    QVERIFY2(box.findText(text) >= 0, qPrintable(text));
    box.setCurrentIndex(box.findText(text));
    emit box.activated(box.currentIndex());
}

/// Zeros have none: how many there are is said where it is chosen, and a smallest value is the way out.
void ImportDialogTest::logarithmsAreTaken()
{
    openAndAsk(writeRaw("zeros.raw"));
    auto& from = window_->find<QLineEdit>("import.scale.from");
    QVERIFY(!from.isEnabled());
    choose("import.scale", "Logarithmic");
    QVERIFY(from.isEnabled());
    click("import.read");
    QTRY_VERIFY(window_->find<QLabel>("import.reason").text().contains("1 of 512 values"));
    from.setText("-1");
    QVERIFY(!window_->find<QPushButton>("import.read").isEnabled());
    from.setText("0.5");
    QTRY_VERIFY(window_->find<QPushButton>("import.read").isEnabled());
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    const Dataset& dataset = *window_->workbench.opening().datasets().dataset();
    QCOMPARE(dataset.source.valueName, std::string("log10(value)"));
    QCOMPARE(dataset.values.range().minimum, static_cast<double>(static_cast<float>(std::log10(0.5))));
    QVERIFY(window_->workbench.opening().datasets().importOptions().scale ==
            (ValueScale{.logarithmic = true, .from = 0.5}));
    const QString facts = window_->find<QLabel>("build.facts").text();
    QVERIFY2(facts.contains("values 0.5 to ") &&
                 facts.contains("Scale: logarithmic; an error of 1 % is a factor of 1."),
             qPrintable(facts));
    openAndAsk(window_->folder.filePath("zeros.raw")); // as it was chosen last
    QCOMPARE(window_->find<QComboBox>("import.scale").currentText(), QString("Logarithmic"));
    QCOMPARE(from.text(), QString("0.5"));
}

/// Where the panel Build says so, too.
void ImportDialogTest::valuesOverPowersOfTenAreTold()
{
    Lattice lattice;
    lattice.size = {4, 4, 4};
    std::vector<float> values;
    for (int i = 0; i < 64; ++i)
        values.push_back(std::pow(10.0F, static_cast<float>(i) / 20));
    const auto dataset = latticeDataset(lattice, ScalarField::of(std::move(values)), "c60");
    QVERIFY(dataset);
    window_->window.open(QString::fromStdString(writeNrrd(*dataset, window_->folderPath())));
    QTRY_VERIFY(window_->find<QLabel>("build.facts").text().contains("Scale: linear. The values span"));
    openAndAsk(window_->folder.filePath("c60.nrrd"));
    choose("import.scale", "Logarithmic");
    click("import.read");
    QTRY_VERIFY(window_->find<QLabel>("build.facts").text().contains("Scale: logarithmic"));
}

void ImportDialogTest::aRawFileIsDescribed()
{
    window_->window.open(writeRaw("samples.raw"));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QVERIFY(!dialog()->isModal());
    QCOMPARE(window_->find<QLineEdit>("import.option.size").text(), QString("8x8x8")); // the likeliest
    QVERIFY(window_->find<QLabel>("import.sizeCheck").text().contains("8 × 8 × 8 × uint8 = 512 bytes"));
    QTRY_VERIFY(window_->find<QLabel>("import.estimate").isVisible());
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->workbench.opening().datasets().dataset()->lattice.size, (std::array<std::uint32_t, 3>{8, 8, 8}));
    QVERIFY(!dialog()->isVisible());
    QVERIFY(window_->find<QWidget>("dock.build").isVisible());
    QTRY_VERIFY(window_->find<QLabel>("build.estimate").text().contains("memory"));
    // Nobody has filled in where it lies, which is told as assumed.
    const QString facts = window_->find<QLabel>("build.facts").text();
    QVERIFY2(facts.contains("1 x 1 x 1 is assumed"), qPrintable(facts));
    openAndAsk(window_->folder.filePath("samples.raw"));
    window_->find<QLineEdit>("import.option.spacing").setText("0.5 0.5 2");
    window_->find<QLineEdit>("import.option.unit").setText("mm");
    click("import.read");
    QTRY_COMPARE(window_->workbench.opening().datasets().dataset()->lattice.spacing, Eigen::Vector3d(0.5, 0.5, 2));
    QTRY_VERIFY(window_->find<QLabel>("build.facts").text().contains("spacing 0.5 × 0.5 × 2 mm"));
    QVERIFY(!window_->find<QLabel>("build.facts").text().contains("assumed"));
}

/// C10: by the size of what is in it, which the preview shows.
void ImportDialogTest::aPackedRawFileIsDescribed()
{
    QFile plain(writeRaw("samples.raw"));
    QVERIFY(plain.open(QIODevice::ReadOnly));
    QFile packed(window_->folder.filePath("packed.raw.gz"));
    QVERIFY(packed.open(QIODevice::WriteOnly));
    packed.write(gzipped(plain.readAll()));
    packed.close();
    window_->window.open(packed.fileName());
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QCOMPARE(window_->find<QLineEdit>("import.option.size").text(), QString("8x8x8"));
    QVERIFY(window_->find<QLabel>("import.sizeCheck").text().contains("8 × 8 × 8 × uint8 = 512 bytes: exactly"));
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->workbench.opening().datasets().dataset()->lattice.size, (std::array<std::uint32_t, 3>{8, 8, 8}));
    QVERIFY(window_->workbench.opening().nameFilters().front().contains("*.gz"));
}

void ImportDialogTest::aWrongLayoutIsSeenAtOnce()
{
    window_->window.open(writeRaw("samples.raw"));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    auto& size = window_->find<QLineEdit>("import.option.size");
    const auto& check = window_->find<QLabel>("import.sizeCheck");
    const auto& read = window_->find<QPushButton>("import.read");
    size.setText("8x8x4");
    QVERIFY(check.text().startsWith("✗"));
    QVERIFY(check.text().contains("256 bytes; the file has 512 (256 too many)."));
    QVERIFY(!read.isEnabled());
    size.setText("8x8");
    QVERIFY(!read.isEnabled());
    QTRY_VERIFY(window_->find<SlicePreview>("import.preview").image().isNull());
    size.setText("16x8x8");
    QVERIFY(check.text().contains("missing"));
    size.setText("8x8x4");
    choose("import.option.type", "uint16");
    QVERIFY(check.text().startsWith("✓"));
    QVERIFY(read.isEnabled());
    window_->find<QComboBox>("import.suggestions").setCurrentIndex(0);
    emit window_->find<QComboBox>("import.suggestions").activated(0);
    QCOMPARE(size.text(), QString("8x8x8"));
    QCOMPARE(window_->find<QComboBox>("import.option.type").currentText(), QString("uint8"));
    QVERIFY(check.text().startsWith("✓"));
}

void ImportDialogTest::thePreviewShowsTheSamples()
{
    window_->window.open(writeRaw("samples.raw"));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    const auto& preview = window_->find<SlicePreview>("import.preview");
    QTRY_VERIFY(preview.upToDate() && !preview.image().isNull());
    QCOMPARE(preview.image().size(), QSize(8, 8));
    const auto grey = [&](int right, int up) { return qGray(preview.image().pixel(right, 7 - up)); };
    for (int right = 0; right < 7; ++right) { // x runs to the right, y goes up and counts more
        QVERIFY(grey(right, 3) <= grey(right + 1, 3));
        QVERIFY(grey(3, right) < grey(3, right + 1));
    }
    QCOMPARE(window_->find<QSpinBox>("import.preview.layer").value(), 4); // the middle
    const QString middle = window_->find<QLabel>("import.preview.legend").text();
    window_->find<QSlider>("import.preview.slider").setValue(7);
    QTRY_VERIFY(preview.upToDate());
    QVERIFY(window_->find<QLabel>("import.preview.legend").text() != middle); // other values, another window
    choose("import.preview.axis", "Across y");
    QTRY_VERIFY(preview.upToDate());
    QVERIFY(window_->find<QLabel>("import.preview.legend").text().startsWith("x to the right, z up"));
}

void ImportDialogTest::choicesAreThoseOfTheFile()
{
    window_->window.open(writeChoices());
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QTRY_COMPARE(window_->find<QComboBox>("import.option.array").count(), 5);
    QCOMPARE(window_->find<QComboBox>("import.option.array").itemText(2), QString("velocity, 3 components"));
    QCOMPARE(window_->find<QComboBox>("import.option.array").itemText(3), QString("heat (of the cells)"));
    QVERIFY(dialog()->findChild<QWidget*>("import.option.component") == nullptr); // density has one
    choose("import.option.array", "velocity, 3 components");
    QTRY_VERIFY(dialog()->findChild<QWidget*>("import.option.component") != nullptr);
    QCOMPARE(window_->find<QComboBox>("import.option.array").currentText(), QString("velocity, 3 components"));
    choose("import.option.component", "1 (y)");
    choose("import.option.time", "3: t = 1.25");
    choose("import.option.part", "stator");
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->workbench.opening().datasets().dataset()->source.name, std::string("velocity/1/3/stator"));
}

void ImportDialogTest::aPartIsReadBuiltAndVerified()
{
    const auto path = writeNrrd(sampleDataset(16), window_->folderPath());
    openAndAsk(QString::fromStdString(path));
    const auto& count = window_->find<QLabel>("import.region.count");
    QTRY_VERIFY(count.text().contains("All 16 × 16 × 16 = 4,096 points"));
    QVERIFY(!window_->find<QWidget>("import.preview").isVisible());
    window_->find<QSpinBox>("import.region.first.x").setValue(4);
    window_->find<QSpinBox>("import.region.last.y").setValue(11);
    window_->find<QSpinBox>("import.region.stride.z").setValue(3);
    QVERIFY2(count.text().contains("12 × 12 × 6 = 864 of 4,096 points"), qPrintable(count.text()));
    window_->find<QSpinBox>("import.region.last.x").setValue(4);
    QVERIFY(count.text().startsWith("✗"));
    QVERIFY(!window_->find<QPushButton>("import.read").isEnabled());
    window_->find<QSpinBox>("import.region.last.x").setValue(15);
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->workbench.opening().datasets().dataset()->lattice.size,
             (std::array<std::uint32_t, 3>{12, 12, 6}));

    window_->find<QLineEdit>("build.target").setText(window_->folder.filePath("part.tan"));
    click("build.start");
    QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(window_->folder.filePath("part.tan")), 60000);
    const auto model = Model::open(window_->folderPath() + "/part.tan");
    QVERIFY(model);
    const auto reader = chooseReader(*window_->host, path);
    const auto options = importOf((*model)->description(), reader->plugin->parameters());
    QVERIFY(options);
    const auto original = openDataset(*window_->host, path, *options);
    QVERIFY(original);
    const auto verdict = verify(**model, *original, {{1, 1}, {0, 0}});
    QVERIFY(verdict && verdict->ok());
}

void ImportDialogTest::whatIsRefusedIsAskedAgain()
{
    const auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    const std::string path = window_->folderPath() + "/duct.xyz";
    QVERIFY(grid && saveDataset(*window_->host, *grid, path).ok());
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QTRY_VERIFY(window_->find<QLabel>("import.region.count").text().contains("8 × 8 × 8"));
    choose("import.option.array", "energy"); // the same everywhere
    click("import.read");
    QTRY_VERIFY(window_->find<QLabel>("import.reason").text().contains("the same value everywhere"));
    QVERIFY(dialog()->isVisible());
    QCOMPARE(window_->find<QComboBox>("import.option.array").currentText(), QString("energy"));
    choose("import.option.array", "density");
    click("import.read");
    QTRY_COMPARE(window_->find<QLabel>("build.name").text(), QString("duct.xyz, density"));
    QVERIFY(window_->find<QLabel>("build.facts").text().contains("curvilinear grid of 8 × 8 × 8 points, 343 cells"));
    QCOMPARE(window_->messages(), QStringList());
}

void ImportDialogTest::lastChoicesAreRemembered()
{
    const QString path = writeChoices();
    window_->window.open(path);
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QTRY_VERIFY(window_->find<QWidget>("import.region.last.x").isVisible());
    choose("import.option.time", "2: t = 0.5");
    window_->find<QSpinBox>("import.region.last.x").setValue(3);
    click("import.read");
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    openAndAsk(path);
    QTRY_COMPARE(window_->find<QComboBox>("import.option.time").currentText(), QString("2: t = 0.5"));
    QCOMPARE(window_->find<QSpinBox>("import.region.last.x").value(), 3);
    click("import.region.reset");
    QCOMPARE(window_->find<QSpinBox>("import.region.last.x").value(), 4);
}

void ImportDialogTest::readingIsCancelled()
{
    window_->window.open(writeChoices());
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    choose("import.option.array", "slow");
    click("import.read");
    QVERIFY(window_->find<QProgressBar>("import.progress").isVisible());
    QVERIFY(!window_->find<QWidget>("import.option.array").isEnabled());
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QTRY_VERIFY(!window_->find<QProgressBar>("import.progress").isVisible());
    QVERIFY(dialog()->isVisible());
    QVERIFY(window_->find<QWidget>("import.option.array").isEnabled());
    QVERIFY(!window_->find<QLabel>("import.reason").isVisible()); // who cancels knows
    QTest::keyClick(dialog(), Qt::Key_Escape);
    QVERIFY(!dialog()->isVisible());
    QVERIFY(!window_->workbench.opening().datasets().dataset());
}

void ImportDialogTest::filesWithoutChoicesAreOpenedAtOnce()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QVERIFY(dialog() == nullptr);
    click("build.differently");
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
}

void ImportDialogTest::theMenuAsksForAnyFile()
{
    auto& action = window_->find<QAction>("action.openWithOptions");
    QCOMPARE(action.shortcut(), QKeySequence("Ctrl+Shift+O"));
    action.trigger();
    QTRY_VERIFY(window_->window.findChild<QFileDialog*>("importFileDialog"));
    auto& files = window_->find<QFileDialog>("importFileDialog");
    emit files.fileSelected(writeRaw("menu.raw"));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
}

void ImportDialogTest::everythingHasANameAndFits()
{
    constexpr QSize smallScreen(1366, 768 - 40); // with a panel and a title bar
    window_->window.open(writeRaw("samples.raw"));
    QTRY_VERIFY(dialog() != nullptr && dialog()->isVisible());
    QVERIFY(dialog()->width() <= smallScreen.width() && dialog()->height() <= smallScreen.height());
    QVERIFY(dialog()->minimumSizeHint().height() <= smallScreen.height());
    for (const QWidget* control : dialog()->findChildren<QWidget*>()) {
        const bool isControl = control->focusPolicy() != Qt::NoFocus && control->objectName().startsWith("import.") &&
                               qobject_cast<const QLabel*>(control) == nullptr;
        const auto* button = qobject_cast<const QAbstractButton*>(control); // read by its text
        const QString name = button != nullptr ? button->text() : control->accessibleName();
        QVERIFY2(!isControl || !name.isEmpty(), qPrintable(control->objectName()));
        QVERIFY2(!isControl || !control->toolTip().isEmpty(), qPrintable(control->objectName()));
    }
}

QTEST_MAIN(ImportDialogTest)
#include "import_dialog_test.moc"
