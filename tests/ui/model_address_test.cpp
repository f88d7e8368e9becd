// SPDX-License-Identifier: GPL-3.0-or-later
// Models by URL in the window (R28, B5): shown while they come, cancelled, found again, dropped, saved with a session;
// packed models (R16) opened and saved; and the settings of the cache.
#include "tests/core/remote/http_server.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/dialogs/cache_dialog.h"
#include "ui/opening/model_cache.h"
#include "ui/opening/recent_files.h"

#include <tan/packed.h>

#include <QAction>
#include <QDialogButtonBox>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

#include <fstream>
#include <sstream>

using namespace tetra;

class ModelAddressTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aModelIsShownWhileItComes();
    void aPackedModelIsShownWhileItIsUnpacked();
    void aModelIsPacked();
    void whatHasComeStaysWhenTheRestIsCancelled();
    void whatCannotBeFetchedIsTold();
    void anAddressIsAskedForAndDropped();
    void aSessionKeepsTheAddress();
    void theCacheHasSettings();
    void aLongNameKeepsItsEnd();

private:
    QString addressOf(const FaultyHttpServer& server) const
    {
        return QString::fromStdString(server.address("/far/sample.tan"));
    }
    std::unique_ptr<FaultyHttpServer> server() const { return std::make_unique<FaultyHttpServer>(model_); }
    const std::shared_ptr<const Model>& model() const { return window_->workbench.session().model(); }
    Opening& opening() const { return window_->workbench.opening(); }

    QTemporaryDir cache_;
    std::string model_; ///< the file's bytes
    std::uint32_t sites_ = 0;
    std::unique_ptr<WindowFixture> window_;
};

void ModelAddressTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("model-address");
    QLocale::setDefault(QLocale::c());
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
    const QTemporaryDir folder;
    const auto host = hostOfThisBuild();
    const auto path = buildSampleModel(*host, sampleDataset(32), folder.path().toStdString());
    std::ostringstream bytes;
    bytes << std::ifstream(path, std::ios::binary).rdbuf();
    model_ = bytes.str();
    sites_ = (*Model::open(path))->siteCount();
    QVERIFY(sites_ > 10'000);
}

void ModelAddressTest::init()
{
    QSettings().clear();
    QVERIFY(clearCache().ok());
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void ModelAddressTest::cleanup()
{
    window_.reset();
}

void ModelAddressTest::aModelIsShownWhileItComes()
{
    const auto server = this->server();
    std::vector<std::uint32_t> shown;
    QStringList told;
    connect(&opening().models(), &ModelOpening::shownPartChanged, &window_->window, [&] {
        shown.push_back(model()->siteCount());
        if (opening().models().isComing())
            told += window_->find<QLabel>("status.reading.activity").text();
    });
    const QSignalSpy opened(&window_->workbench.session(), &Session::modelChanged);
    const QSignalSpy grown(&window_->workbench.session(), &Session::modelGrown);
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model() && model()->siteCount() == sites_ && !opening().models().isComing());
    QCOMPARE(opened.size(), 1);
    QVERIFY(!grown.isEmpty());
    QVERIFY(shown.front() < 5'000 && std::ranges::is_sorted(shown));
    QVERIFY2(!told.isEmpty() && told.first().contains("on the way"), qPrintable(told.value(0)));
    QCOMPARE(opening().models().sitesOfWhole(), 0u);
    QCOMPARE(model()->path().string(), addressOf(*server).toStdString());
    QVERIFY(opening().proposedPath(".packed.tan").endsWith("/sample.packed.tan"));
    QCOMPARE(recentFiles().value(0), addressOf(*server));
    QVERIFY(window_->window.windowTitle().startsWith("sample.tan"));
    QTRY_VERIFY(window_->settled());
    QCOMPARE(window_->messages(), QStringList());

    // The second time it is there at once.
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!model());
    shown.clear();
    window_->window.open(recentFiles().value(0));
    QTRY_VERIFY(model() && model()->siteCount() == sites_);
    QCOMPARE(shown.front(), sites_);
}

/// R16: of this disk, in parts, and the second time at once.
void ModelAddressTest::aPackedModelIsShownWhileItIsUnpacked()
{
    const std::filesystem::path file = window_->folderPath() + "/sample.tan",
                                packed = window_->folderPath() + "/p.packed.tan";
    std::ofstream(file, std::ios::binary) << model_;
    const auto report = packModel(**Model::open(file), packed);
    QVERIFY2(report.ok(), report ? "" : report.error().text().c_str());
    std::vector<std::uint32_t> shown;
    connect(&opening().models(), &ModelOpening::shownPartChanged, &window_->window,
            [&] { shown.push_back(model()->siteCount()); });
    for (const bool isFirst : {true, false}) {
        shown.clear();
        window_->window.open(pathText(packed));
        QTRY_VERIFY(model() && model()->siteCount() == sites_ && !opening().reading().running());
        QVERIFY(isFirst ? shown.front() < sites_ : shown.front() == sites_);
        QVERIFY(std::ranges::is_sorted(shown));
        QCOMPARE(model()->path(), packed);
        QCOMPARE(recentFiles().value(0), pathText(packed));
        QVERIFY(opening().proposedPath(".packed.tan").endsWith("/p.packed.tan")); // not p.packed.packed.tan
        QVERIFY(opening().sessions().document());
        QTRY_VERIFY(window_->settled());
        QCOMPARE(window_->messages(), QStringList());
        window_->find<QAction>("action.close").trigger();
        QVERIFY(!model());
    }
}

/// C16: the file that the window packs gives the model back; it never takes the model's own place, and a part of a
/// model is not packed as if it were the whole.
void ModelAddressTest::aModelIsPacked()
{
    const QAction& save = window_->find<QAction>("action.savePacked");
    QVERIFY(!save.isEnabled());
    const std::filesystem::path file = window_->folderPath() + "/sample.tan", again = window_->folderPath() + "/a.tan";
    std::ofstream(file, std::ios::binary) << model_;
    window_->window.open(pathText(file));
    QTRY_VERIFY(model() && save.isEnabled());
    window_->find<QAction>("action.savePacked").trigger();
    auto& dialog = window_->find<QFileDialog>("packedDialog");
    const QString target = dialog.selectedFiles().value(0);
    QCOMPARE(target, window_->folder.filePath("sample.packed.tan"));
    const QSignalSpy saved(&window_->workbench.exporting(), &Exporting::packedSaved);
    emit dialog.fileSelected(target);
    dialog.reject();
    QTRY_COMPARE(saved.size(), 1);
    QCOMPARE(saved.at(0).at(1).toULongLong(), quint64(std::filesystem::file_size(filePath(target))));
    QCOMPARE(saved.at(0).at(2).toULongLong(), quint64(model_.size()));
    const auto packed = PackedModel::open(filePath(target));
    QVERIFY(packed.ok() && unpackModel(**packed, again).ok());
    std::ostringstream bytes;
    bytes << std::ifstream(again, std::ios::binary).rdbuf();
    QVERIFY(bytes.str() == model_);

    const QSignalSpy refused(&window_->workbench.exporting(), &Exporting::saveFailed);
    window_->workbench.exporting().savePacked(file);
    QTRY_COMPARE(refused.size(), 1);
    QCOMPARE(std::filesystem::file_size(file), model_.size());

    const auto server = this->server();
    bool waits = false;
    connect(&opening().models(), &ModelOpening::shownPartChanged, &window_->window,
            [&] { waits |= opening().models().isComing() && !save.isEnabled(); });
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model()->path() == addressOf(*server).toStdString() && model()->siteCount() == sites_);
    QTRY_VERIFY(save.isEnabled());
    QVERIFY(waits);
}

void ModelAddressTest::whatHasComeStaysWhenTheRestIsCancelled()
{
    std::atomic<bool> isSilent = false;
    const auto server = std::make_unique<FaultyHttpServer>(
        model_, [&isSilent](const auto&, std::size_t, FaultyHttpServer::Reply& reply) {
            reply.isSilent = isSilent;
            reply.before = std::chrono::seconds(1);
        });
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model() && opening().models().isComing());
    isSilent = true;
    QVERIFY(!opening().sessions().document()); // of a model under way
    QTRY_VERIFY(window_->find<QToolButton>("status.reading.cancel").isVisible());
    window_->find<QToolButton>("status.reading.cancel").click();
    QTRY_VERIFY(!opening().reading().running());
    QVERIFY(model() && model()->siteCount() < sites_);
    QCOMPARE(opening().models().sitesOfWhole(), sites_);
    QVERIFY(!opening().models().isComing() && opening().sessions().document());
    QTRY_VERIFY(window_->settled());
    QCOMPARE(window_->messages(), QStringList());
}

void ModelAddressTest::whatCannotBeFetchedIsTold()
{
    FaultyHttpServer server("<html>Please log in</html>");
    window_->window.open(QString::fromStdString(server.address("/login.tan")));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(!model() && recentFiles().isEmpty());
}

void ModelAddressTest::anAddressIsAskedForAndDropped()
{
    const auto server = this->server();
    window_->find<QAction>("action.openAddress").trigger();
    auto& address = window_->find<QLineEdit>("addressDialog.address");
    auto* open = window_->find<QDialog>("addressDialog").findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    address.setText("sample.tan");
    QVERIFY(!open->isEnabled());
    address.setText(" " + addressOf(*server) + " ");
    QVERIFY(open->isEnabled());
    open->click();
    QTRY_VERIFY(model() && !opening().reading().running());

    window_->find<QAction>("action.close").trigger();
    QMimeData data;
    data.setUrls({QUrl(addressOf(*server))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_->window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_->window, &drop);
    QTRY_VERIFY(model() && !opening().reading().running());
    QCOMPARE(model()->path().string(), addressOf(*server).toStdString());
}

void ModelAddressTest::aSessionKeepsTheAddress()
{
    const auto server = this->server();
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model() && !opening().reading().running());
    const auto document = opening().sessions().document();
    QVERIFY(document);
    const std::filesystem::path file = window_->folderPath() + "/far.tansession";
    opening().sessionFile().save(file, *document);
    QTRY_VERIFY(std::filesystem::exists(file) && !opening().sessionFile().saving().running());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!model());
    opening().sessions().open(file, SessionSource::File);
    QTRY_VERIFY(model() && !opening().reading().running());
    QCOMPARE(model()->path().string(), addressOf(*server).toStdString());
    QCOMPARE(window_->messages(), QStringList());
}

void ModelAddressTest::theCacheHasSettings()
{
    const auto server = this->server();
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model() && !opening().reading().running());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(*cachedBytes() > 1'000'000);
    window_->find<QAction>("action.modelCache").trigger();
    auto& dialog = window_->find<CacheDialog>("cacheDialog");
    QVERIFY(window_->find<QLabel>("cache.used").text().contains("MB"));
    QTRY_VERIFY((window_->find<QPushButton>("cache.clear").click(), *cachedBytes() == 0));
    QVERIFY(!window_->find<QLabel>("cache.used").text().contains("MB"));
    const QTemporaryDir other;
    window_->find<QLineEdit>("cache.folder").setText(other.path());
    window_->find<QSpinBox>("cache.limit").setValue(3);
    dialog.accept();
    QCOMPARE(cacheChoice().folder, std::filesystem::path(other.path().toStdString()));
    QCOMPARE(cacheOptions().cacheBytes, 3'000'000'000u);
    window_->window.open(addressOf(*server));
    QTRY_VERIFY(model() && !opening().reading().running());
    QVERIFY(!std::filesystem::is_empty(other.path().toStdString()));
    window_.reset();
}

void ModelAddressTest::aLongNameKeepsItsEnd()
{
    auto& label = window_->find<QLabel>("status.file");
    label.setFixedWidth(100);
    const auto shown = [&](const QString& name) {
        label.setText(name);
        return label.grab().toImage();
    };
    const QString name = "a-long-name-that-does-not-fit-its-place.packed";
    QVERIFY(shown(name + ".tan") != shown(name + ".vtu"));
    QCOMPARE(shown(name + ".tan"), shown(name + ".tan"));
}

QTEST_MAIN(ModelAddressTest)
#include "model_address_test.moc"
