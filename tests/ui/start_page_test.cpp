// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/samples.h"
#include "tests/ui/window_fixture.h"
#include "ui/opening/recent_files.h"
#include "ui/opening/sample_models.h"
#include "ui/workbench/plugin_choice.h"

#include <QClipboard>
#include <QCommandLinkButton>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QToolButton>
#include <QTreeWidget>

#include <latch>

using namespace tetra;

/// What is seen before anything is open: recent files, samples; and the page of the plugins.
class StartPageTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void everySampleIsMade_data();
    void everySampleIsMade();
    void aSampleIsOpenedByItsButton();
    void aSampleIsOpenedByTheMenu();
    void samplesAreDescribedForPeople();
    void samplesHavePictures();
    void picturesWaitForTheFileThatIsRead();
    void makingASampleIsCancelled();
    void anUnknownSampleIsRefused();
    void recentFilesSayWhereTheyLie();
    void samplesLieWhereNobodyLooks();
    void aPluginThatFailsIsToldOnce();
    void pluginsAreSwitchedOffAndOn();
    void thePluginsAreCopied();

private:
    std::unique_ptr<WindowFixture> window_;
};

void StartPageTest::initTestCase()
{
    QStandardPaths::setTestModeEnabled(true);
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("startPage");
    QLocale::setDefault(QLocale::c());
}

void StartPageTest::init()
{
    QSettings().clear();
    std::filesystem::remove_all(sampleFolder());
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void StartPageTest::cleanup()
{
    window_.reset();
    std::filesystem::remove_all(sampleFolder());
}

void StartPageTest::everySampleIsMade_data()
{
    QTest::addColumn<QString>("name");
    for (const SampleKind& kind : sampleKinds())
        QTest::newRow(std::string(kind.name).c_str()) << QString::fromStdString(std::string(kind.name));
}

void StartPageTest::everySampleIsMade()
{
    QFETCH(QString, name);
    const std::filesystem::path folder = window_->folderPath();
    const auto model = sampleModel(*window_->host, name.toStdString(), folder);
    QVERIFY2(model, model ? "" : model.error().text().c_str());
    QVERIFY(Model::open(*model));
    const auto written = std::filesystem::last_write_time(*model);
    QVERIFY(sampleModel(*window_->host, name.toStdString(), folder));
    QVERIFY(std::filesystem::last_write_time(*model) == written); // not made again
}

void StartPageTest::aSampleIsOpenedByItsButton()
{
    auto& button = window_->find<QToolButton>("empty.sample.part");
    QVERIFY(button.isVisible() && button.focusPolicy() != Qt::NoFocus && !button.toolTip().isEmpty());
    button.setFocus();
    QTest::keyClick(&button, Qt::Key_Space);
    QVERIFY(!button.isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(window_->workbench.session().model() && window_->settled(), 60'000);
    QVERIFY(!window_->find<QWidget>("empty").isVisible());
    QVERIFY(window_->messages().isEmpty());
}

/// Also while something else is open.
void StartPageTest::aSampleIsOpenedByTheMenu()
{
    window_->window.open(QString::fromStdString(
        buildSampleModel(*window_->host, sampleDataset(8), std::filesystem::path(window_->folderPath())).string()));
    QTRY_VERIFY(window_->workbench.session().model());
    window_->find<QAction>("action.sample.scattered").trigger();
    QVERIFY(!window_->find<QMenu>("menu.samples").isEnabled());
    QTRY_VERIFY_WITH_TIMEOUT(window_->workbench.session().model()->path().filename() == "scattered.tan", 60'000);
    QVERIFY(window_->find<QMenu>("menu.samples").isEnabled());
}

/// A name for people, and what it is, its size, where it is from and what to look at; below the samples, too, while one
/// is pointed at.
void StartPageTest::samplesAreDescribedForPeople()
{
    auto& description = window_->find<QLabel>("empty.sample.description");
    const QString usual = description.text();
    QVERIFY(!usual.isEmpty());
    window_->window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window_->window, patiently(5000)));
    for (const SampleKind& kind : sampleKinds()) {
        const QString name = QString::fromStdString(std::string(kind.name));
        auto& button = window_->find<QToolButton>("empty.sample." + name);
        const auto& action = window_->find<QAction>("action.sample." + name);
        QVERIFY2(button.text() != name && button.text().at(0).isUpper(), qPrintable(button.text()));
        QCOMPARE(button.accessibleName(), button.text());
        QCOMPARE(QString(action.text()).remove('&'), button.text());
        QCOMPARE(action.toolTip(), button.toolTip());
        const QString text = button.toolTip();
        for (const QString& part : {QString("computed by TAn"), QString("See ")})
            QVERIFY2(text.contains(part), qPrintable(text));
        QVERIFY2(kind.domain == DomainClass::Irregular || text.contains(" points"), qPrintable(text));
        button.setFocus(Qt::TabFocusReason);
        QCOMPARE(description.text(), text);
        button.clearFocus();
        QCOMPARE(description.text(), usual);
    }
}

/// Drawn at first use, in a worker, and kept: they show something, each something else.
void StartPageTest::samplesHavePictures()
{
    const auto isBlank = [](const QToolButton& button) {
        const QImage shown = button.icon().pixmap(button.iconSize()).toImage().convertToFormat(QImage::Format_ARGB32);
        QImage blank(shown.size(), QImage::Format_ARGB32);
        blank.fill(Qt::transparent);
        return shown == blank;
    };
    for (const SampleKind& kind : sampleKinds())
        QVERIFY(isBlank(window_->find<QToolButton>("empty.sample." + QString::fromStdString(std::string(kind.name)))));
    std::map<std::string, QImage> drawn;
    connect(&window_->workbench.opening().samples(), &Samples::thumbnailDrawn, this,
            [&](const std::string& sample, const QImage& picture) { drawn[sample] = picture; });
    QTRY_COMPARE_WITH_TIMEOUT(drawn.size(), sampleKinds().size(), 60'000);
    for (const auto& [sample, picture] : drawn) {
        const auto& button = window_->find<QToolButton>("empty.sample." + QString::fromStdString(sample));
        QCOMPARE(picture.size(), QSize(thumbnailWidth, thumbnailHeight));
        QVERIFY(picture.hasAlphaChannel());
        int opaque = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                opaque += qAlpha(picture.pixel(x, y)) > 40 ? 1 : 0;
        QVERIFY2(opaque > picture.width() * picture.height() / 20, sample.c_str());
        QVERIFY2(!isBlank(button), sample.c_str());
        QVERIFY(!window_->find<QAction>("action.sample." + QString::fromStdString(sample)).icon().isNull());
        for (const auto& [other, otherPicture] : drawn)
            QVERIFY2(other == sample || otherPicture != picture, sample.c_str());
        const auto kept = sampleThumbnail(*window_->host, sample, sampleFolder());
        QVERIFY(kept);
        QVERIFY2(kept->convertToFormat(QImage::Format_ARGB32) == picture.convertToFormat(QImage::Format_ARGB32),
                 sample.c_str());
    }
    QVERIFY(!sampleThumbnail(*window_->host, "nothing", sampleFolder()));
}

/// As with "tan-desktop FILE": its file is read before the window is seen.
void StartPageTest::picturesWaitForTheFileThatIsRead()
{
    window_ = std::make_unique<WindowFixture>();
    std::latch goOn(1);
    window_->workbench.opening().reading().task().start([&goOn](const Progress&) {
        goOn.wait();
        return [] {};
    });
    const QSignalSpy drawing(&window_->workbench.opening().samples().drawing(), &LongTask::started);
    window_->window.show();
    QCoreApplication::processEvents();
    const auto begunEarly = drawing.count();
    goOn.count_down();
    QCOMPARE(begunEarly, 0);
    QTRY_COMPARE(drawing.count(), 1);
    window_->window.hide();
    window_->window.show();
    QCOMPARE(drawing.count(), 1);
}

void StartPageTest::makingASampleIsCancelled()
{
    window_->workbench.opening().samples().open("hydrogen");
    QTRY_VERIFY_WITH_TIMEOUT(window_->find<QWidget>("status.sampling").isVisible(), 20'000);
    window_->find<QToolButton>("status.sampling.cancel").click();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.opening().samples().making().running(), 20'000);
    QTRY_VERIFY(window_->find<QToolButton>("empty.sample.hydrogen").isEnabled());
    QVERIFY(!window_->workbench.session().model());
    QVERIFY(window_->messages().isEmpty());
    QVERIFY(!std::filesystem::exists(sampleFolder() / "hydrogen.tan"));
}

void StartPageTest::anUnknownSampleIsRefused()
{
    window_->workbench.opening().samples().open("nothing");
    QTRY_COMPARE(window_->messages().size(), 1);
}

void StartPageTest::recentFilesSayWhereTheyLie()
{
    const auto path = writeNrrd(sampleDataset(4), window_->folderPath());
    addRecentFile(QString::fromStdString(path.string()));
    window_.reset(); // its folder goes, and the file with it
    window_ = std::make_unique<WindowFixture>();
    QVERIFY(window_->window.findChild<QCommandLinkButton*>("empty.recent") == nullptr);
    addRecentFile(QString::fromStdString(writeNrrd(sampleDataset(4), window_->folderPath()).string()));
    const QString folder = window_->folder.path();
    const WindowFixture next;
    auto& button = next.find<QCommandLinkButton>("empty.recent");
    QCOMPARE(button.text(), QString("c60.nrrd"));
    QVERIFY(folder.endsWith(button.description().section('/', -1)));
    QVERIFY(button.focusPolicy() != Qt::NoFocus);
}

/// Their folder may be emptied at any time: it is none to save in, nor to look for files in.
void StartPageTest::samplesLieWhereNobodyLooks()
{
    window_->workbench.opening().samples().open("c60");
    QTRY_VERIFY_WITH_TIMEOUT(window_->workbench.session().model() != nullptr, 60'000);
    QCOMPARE(recentFiles(), QStringList());
    const auto isOutside = [](const QString& folder) {
        return !folder.startsWith(QString::fromStdString(sampleFolder().string()));
    };
    const QString proposed = window_->workbench.opening().proposedPath(".png");
    QVERIFY2(isOutside(proposed) && QFileInfo(proposed).dir().exists(), qPrintable(proposed));
    window_->find<QAction>("action.open").trigger();
    auto& dialog = window_->find<QFileDialog>("openDialog");
    QVERIFY2(isOutside(dialog.directory().absolutePath()), qPrintable(dialog.directory().absolutePath()));
    dialog.reject();
}

void StartPageTest::aPluginThatFailsIsToldOnce()
{
    const QTemporaryDir folder;
    QVERIFY(QFile::copy(TAN_FIXTURES "/throwing.so", folder.filePath("throwing.so")));
    PluginHostOptions options{.folders = window_->host->folders()};
    options.folders.push_back(folder.path().toStdString());
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, std::make_unique<PluginHost>(options));
    window_->window.show();
    QCOMPARE(window_->messages(), QStringList()); // it was not needed yet
    for (int time = 0; time < 2; ++time) {
        window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
        QTRY_VERIFY(!window_->workbench.opening().reading().running() &&
                    window_->workbench.opening().datasets().dataset());
        QTRY_COMPARE(window_->messages().size(), 1);
        QVERIFY2(window_->messages().first().contains("no luck"), qPrintable(window_->messages().first()));
        QVERIFY(window_->find<QLabel>("message.count").text().isEmpty());
    }
}

void StartPageTest::pluginsAreSwitchedOffAndOn()
{
    window_->find<QAction>("action.plugins").trigger();
    auto& list = window_->find<QTreeWidget>("plugins.list");
    QVERIFY(list.topLevelItemCount() > 5);
    QTreeWidgetItem* item = list.topLevelItem(0);
    QVERIFY(item->checkState(0) == Qt::Checked);
    QVERIFY(!item->text(2).isEmpty() && QFile::exists(item->text(5)));
    item->setCheckState(0, Qt::Unchecked);
    QVERIFY(window_->find<QLabel>("plugins.atNextStart").isVisible());
    QCOMPARE(unwantedPlugins().size(), std::size_t(1));
    PluginHostOptions options{.folders = window_->host->folders(), .disabled = unwantedPlugins()};
    const PluginHost next(options);
    int disabled = 0;
    for (const PluginStatus& plugin : next.plugins())
        disabled += plugin.state == PluginState::Disabled ? 1 : 0;
    QVERIFY(disabled >= 1);
    item->setCheckState(0, Qt::Checked);
    QVERIFY(unwantedPlugins().empty());
}

void StartPageTest::thePluginsAreCopied()
{
    window_->find<QAction>("action.plugins").trigger();
    window_->find<QPushButton>("plugins.copy").click();
    const QString text = QGuiApplication::clipboard()->text();
    for (const PluginStatus& plugin : window_->host->plugins())
        QVERIFY2(text.contains('\t' + QString::fromStdString(plugin.metadata.id) + '\t'), plugin.metadata.id.c_str());
    QVERIFY(text.contains(QString::fromStdString(window_->host->folders().front().string())));
}

QTEST_MAIN(StartPageTest)
#include "start_page_test.moc"
