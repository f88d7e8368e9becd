// SPDX-License-Identifier: GPL-3.0-or-later
// Models that the window leaves at their server (R28; the paper's 5.1): the meshes are those of the model itself, the
// newest request wins, and whatever is wrong is told.
#include "core/history/whole_elsewhere.h"
#include "core/picture/text_file.h"
#include "tests/app/local_server.h"
#include "tests/core/packed/any_order.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/dialogs/address_dialog.h"
#include "ui/opening/model_cache.h"
#include "ui/opening/recent_files.h"
#include "ui/scenes/picture_image.h"

#include <tan/packed.h>

#include <QAction>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QDir>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

#include <atomic>

using namespace tetra;

class ServedModelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();
    void meshesAreThoseOfTheModel_data();
    void meshesAreThoseOfTheModel();
    void picturesAreThoseOfTheModel();
    void theDialogOffersIt();
    void theDialogProposesItWhereThereIsNoRoom();
    void theNewestRequestWins();
    void aServerThatGoesIsTold();
    void aTokenIsAskedForAndNotKept();
    void aTokenIsForItsServerAlone();
    void whatNeedsTheModelIsNotOffered();

private:
    std::string place(const LocalServer& server, const char* name = "sample.tan") const
    {
        return placeOf(server.address(name), true);
    }
    void openLeft(const LocalServer& server, const char* name = "sample.tan")
    {
        window_->window.open(QString::fromStdString(place(server, name)));
        QTRY_VERIFY(model() && !window_->workbench.opening().reading().running());
        QTRY_VERIFY(window_->settled());
        QVERIFY(model()->elsewhere() != nullptr);
    }
    Session& session() const { return window_->workbench.session(); }
    const std::shared_ptr<const Model>& model() const { return session().model(); }
    /// The mesh that the window shows.
    TetrahedralMesh shownMesh() const { return window_->workbench.scenes().sceneBuilder().mesh()->mesh; }
    QPushButton& openButton() const
    {
        return *window_->find<AddressDialog>("addressDialog")
                    .findChild<QDialogButtonBox*>()
                    ->button(QDialogButtonBox::Open);
    }
    QString offer() const { return window_->find<QLabel>("addressDialog.offer").text(); }

    QTemporaryDir cache_, folder_;
    std::shared_ptr<const Model> here_; ///< the model itself
    std::unique_ptr<WindowFixture> window_;
};

void ServedModelTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("served-model");
    QLocale::setDefault(QLocale::c());
    qputenv("XDG_CACHE_HOME", cache_.path().toUtf8());
    const auto host = hostOfThisBuild();
    const auto path = buildSampleModel(*host, sampleDataset(32), folder_.path().toStdString());
    const std::filesystem::path sample = folder_.filePath("sample.tan").toStdString();
    std::filesystem::rename(path, sample);
    here_ = *Model::open(sample);
    QVERIFY(here_->siteCount() > 10'000);
    QVERIFY(packModel(*here_, folder_.filePath("packed.tan").toStdString()).ok());
}

void ServedModelTest::init()
{
    QSettings().clear();
    QVERIFY(clearCache().ok());
    QGuiApplication::clipboard()->clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void ServedModelTest::cleanup()
{
    window_.reset();
}

void ServedModelTest::meshesAreThoseOfTheModel_data()
{
    QTest::addColumn<QString>("what");
    for (const char* what :
         {"error", "budget", "sphere", "viewer", "isovalues", "opacity", "window", "values", "range"})
        QTest::newRow(what) << what;
}

/// Each way of asking for a mesh that the window has: what is shown is what the model itself gives.
void ServedModelTest::meshesAreThoseOfTheModel()
{
    QFETCH(QString, what);
    const LocalServer server(folder_.path());
    openLeft(server, "packed.tan");
    QueryState query = session().view().query;
    query.error = 4;
    query.focus.error = 1;
    query.byBudget = what == "budget";
    query.budget = 5000;
    query.focus.shape = what == "sphere"      ? FocusState::Shape::Sphere
                        : what == "viewer"    ? FocusState::Shape::View
                        : what == "isovalues" ? FocusState::Shape::Isovalues
                        : what == "opacity"   ? FocusState::Shape::Opacity
                                              : FocusState::Shape::None;
    query.window.enabled = what == "window";
    query.values.enabled = what == "values";
    query.values.least = here_->description().range.minimum + 0.6 * here_->description().range.extent();
    query.range.enabled = what == "range";
    session().setQuery(query);
    QTRY_VERIFY(window_->settled() && session().showsQuery());
    QCOMPARE(window_->messages(), QStringList());
    const ShownMesh shown = *session().shown();
    const auto local = MeshExtractor(here_).extract(shown.query);
    QVERIFY(local.ok());
    QVERIFY((*local)->mesh.tetrahedra.size() > 100);
    QVERIFY(inAnyOrder(shownMesh(), {}, {}) == inAnyOrder((*local)->mesh, {}, {}));
    QCOMPARE(shown.wholeTetrahedra, (*local)->wholeTetrahedra);
    QCOMPARE(shown.keptTetrahedra, (*local)->keptTetrahedra);
    QCOMPARE(shown.scale, (*local)->scale);
}

/// And so is the picture, with the view that the model has at first; that a lens is over it changes nothing of that.
void ServedModelTest::picturesAreThoseOfTheModel()
{
    const LocalServer server(folder_.path());
    openLeft(server);
    LensState lens = session().view().lens;
    lens.shape = LensState::Shape::Circle;
    session().setLens(lens);
    QTRY_VERIFY(window_->settled());
    const auto drawn = [&](const std::shared_ptr<const Model>& model) {
        SceneRequest request = window_->workbench.scenes().sessionRequest();
        request.model = model;
        PictureOrder order;
        order.camera = session().view().camera;
        order.width = order.height = 300;
        order.lens = std::make_shared<const LensOrder>(LensOrder{session().view().lens, request});
        const auto picture = drawPicture(order, request, {});
        return picture ? imageOf(*picture) : QImage();
    };
    const QImage far = drawn(model()), near = drawn(here_);
    QVERIFY(!far.isNull() && far.size() == near.size());
    int differing = 0, coloured = 0;
    for (int y = 0; y < far.height(); ++y)
        for (int x = 0; x < far.width(); ++x) {
            const QColor one = far.pixelColor(x, y), other = near.pixelColor(x, y);
            const int most = std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                       std::abs(one.blue() - other.blue())});
            differing += most > 2 ? 1 : 0; // vertices in another order are summed in another order
            coloured += one != far.pixelColor(0, 0) ? 1 : 0;
        }
    QVERIFY2(coloured > 5000, qPrintable(QString::number(coloured)));
    QVERIFY2(differing < 50, qPrintable(QString::number(differing)));
    QCOMPARE(window_->messages(), QStringList());
}

void ServedModelTest::theDialogOffersIt()
{
    const LocalServer server(folder_.path());
    window_->find<QAction>("action.openAddress").trigger();
    auto& address = window_->find<QLineEdit>("addressDialog.address");
    auto& leave = window_->find<QRadioButton>("addressDialog.leave");
    auto& fetch = window_->find<QRadioButton>("addressDialog.fetch");
    QVERIFY(!leave.isEnabled() && fetch.isChecked());
    QVERIFY(!window_->find<QLineEdit>("addressDialog.token").isVisible());
    address.setText(QString::fromStdString(server.address("nothing.tan")));
    QTRY_VERIFY2(offer().contains("no such model"), qPrintable(offer()));
    QVERIFY(!leave.isEnabled());
    address.setText(QString::fromStdString(server.address("packed.tan")));
    QVERIFY(openButton().isEnabled()); // who knows what he wants need not wait for an answer
    QTRY_VERIFY2(offer().contains("vertices"), qPrintable(offer()));
    QVERIFY(leave.isEnabled() && fetch.isChecked());
    leave.click();
    openButton().click();
    QTRY_VERIFY(model() && !window_->workbench.opening().reading().running());
    QCOMPARE(model()->path().string(), place(server, "packed.tan"));
    QTRY_VERIFY(window_->settled());
    QVERIFY(window_->find<QLabel>("status.file").text().contains("at its server"));
    QVERIFY(window_->window.windowTitle().startsWith("packed.tan"));
    QCOMPARE(recentFiles().value(0).toStdString(), place(server, "packed.tan"));
    QCOMPARE(window_->messages(), QStringList());
    // The beginning alone is here, and of a packed model no more is unpacked than would be fetched of another one.
    QVERIFY(model()->siteCount() < here_->siteCount() / 2);
    // The beginning alone was fetched: no more than a megabyte of the file, and the meshes.
    QVERIFY(std::ranges::none_of(server.records(), [](const HttpRecord& record) { return record.bytes > 2 << 20; }));
}

void ServedModelTest::theDialogProposesItWhereThereIsNoRoom()
{
    const LocalServer server(folder_.path());
    qputenv("TAN_CACHE_MB", "1");
    const auto end = qScopeGuard([] { qunsetenv("TAN_CACHE_MB"); });
    window_->find<QAction>("action.openAddress").trigger();
    window_->find<QLineEdit>("addressDialog.address").setText(QString::fromStdString(server.address("sample.tan")));
    QTRY_VERIFY2(offer().contains("more than this computer has room for"), qPrintable(offer()));
    QVERIFY(window_->find<QRadioButton>("addressDialog.leave").isChecked());
}

/// A request that is not wanted any more is given up, on both sides.
void ServedModelTest::theNewestRequestWins()
{
    std::atomic<int> waiting = 0, gone = 0;
    const LocalServer server(folder_.path(), {}, {}, {}, [&](const ServedRequest& request) {
        if (request.target.find("error=0.125") == std::string::npos)
            return;
        ++waiting;
        for (int i = 0; i < 6000 && !request.gone.stop_requested(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        gone += request.gone.stop_requested() ? 1 : 0;
    });
    openLeft(server);
    session().setError(0.125);
    QTRY_VERIFY(waiting > 0);
    QVERIFY(window_->workbench.scenes().sceneBuilder().busy());
    QTRY_VERIFY(window_->find<QWidget>("status.busy").isVisible());
    QVERIFY(window_->find<QWidget>("status.busy").toolTip().contains("server"));
    session().setError(8);
    QElapsedTimer clock;
    clock.start();
    QTRY_VERIFY(window_->settled() && session().showsQuery());
    QVERIFY2(clock.elapsed() < patiently(5000), qPrintable(QString::number(clock.elapsed())));
    QTRY_COMPARE(gone.load(), waiting.load());
    QCOMPARE(session().shown()->query.error, ErrorField(8));
    QCOMPARE(window_->messages(), QStringList());
}

void ServedModelTest::aServerThatGoesIsTold()
{
    std::optional<LocalServer> server(std::in_place, folder_.path());
    const int port = server->port;
    openLeft(*server);
    server.reset();
    session().setError(7);
    QTRY_VERIFY(!window_->messages().isEmpty());
    QVERIFY2(window_->messages().first().contains("does not answer"), qPrintable(window_->messages().first()));
    QVERIFY(model() && window_->viewport().scene()); // the picture before stays
    const LocalServer again(
        folder_.path(), {}, {}, {}, [](const ServedRequest&) {}, port);
    QCOMPARE(again.port, port);
    session().setError(6);
    QTRY_VERIFY(window_->settled() && session().showsQuery());
    QCOMPARE(window_->messages(), QStringList()); // it is there again
}

/// A token is in no file: who opens the session is asked for it again.
void ServedModelTest::aTokenIsAskedForAndNotKept()
{
    const QString token = "0123456789abcdef-token";
    const LocalServer server(folder_.path(), token.toStdString());
    window_->find<QAction>("action.openAddress").trigger();
    window_->find<QLineEdit>("addressDialog.address").setText(QString::fromStdString(server.address("sample.tan")));
    auto& field = window_->find<QLineEdit>("addressDialog.token");
    QTRY_VERIFY(field.isVisible());
    QCOMPARE(field.echoMode(), QLineEdit::Password);
    field.setText("0123456789abcdef-tokex");
    QTRY_VERIFY2(offer().contains("Wrong token"), qPrintable(offer()));
    field.setText(token);
    QTRY_VERIFY2(offer().contains("vertices"), qPrintable(offer()));
    window_->find<QRadioButton>("addressDialog.leave").click();
    openButton().click();
    QTRY_VERIFY(model() && !window_->workbench.opening().reading().running());
    QTRY_VERIFY(window_->settled());
    const auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document);
    const std::filesystem::path file = folder_.filePath("far.tansession").toStdString();
    window_->workbench.opening().sessionFile().save(file, *document);
    QTRY_VERIFY(std::filesystem::exists(file) && !window_->workbench.opening().sessionFile().saving().running());
    QVERIFY(readTextFile(file)->find("0123456789abcdef") == std::string::npos);
    QSettings().sync();
    for (const QString& key : QSettings().allKeys())
        QVERIFY(!QSettings().value(key).toString().contains(token));

    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->workbench.opening().sessions().open(file, SessionSource::File);
    QTRY_VERIFY(window_->window.findChild<QDialog*>("tokenDialog") != nullptr);
    window_->find<QLineEdit>("tokenDialog.token").setText(token);
    window_->find<QDialog>("tokenDialog").accept();
    QTRY_VERIFY(model() && !window_->workbench.opening().reading().running());
    QTRY_VERIFY(window_->settled());
    QCOMPARE(model()->path().string(), place(server));
    QVERIFY(model()->elsewhere() != nullptr);
    QCOMPARE(window_->workbench.opening().sessionFile().path(), file);
    QCOMPARE(window_->messages(), QStringList());
    // Fetched, it is asked for, too.
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->window.open(QString::fromStdString(server.address("sample.tan")));
    QTRY_VERIFY(window_->window.findChild<QDialog*>("tokenDialog") != nullptr);
    window_->find<QLineEdit>("tokenDialog.token").setText(token);
    window_->find<QDialog>("tokenDialog").accept();
    QTRY_VERIFY(model() && model()->siteCount() == here_->siteCount());
    QVERIFY(model()->elsewhere() == nullptr);
}

/// R28: what was typed for one server goes to no other, whose address is typed over it.
void ServedModelTest::aTokenIsForItsServerAlone()
{
    const QString token = "0123456789abcdef-token";
    const LocalServer server(folder_.path(), token.toStdString());
    std::atomic<int> asked = 0, told = 0;
    const LocalServer other(folder_.path(), {}, {}, {}, [&](const ServedRequest& request) {
        ++asked;
        told += request.header("Authorization") ? 1 : 0;
    });
    window_->find<QAction>("action.openAddress").trigger();
    auto& address = window_->find<QLineEdit>("addressDialog.address");
    auto& field = window_->find<QLineEdit>("addressDialog.token");
    address.setText(QString::fromStdString(server.address("sample.tan")));
    QTRY_VERIFY(field.isVisible());
    field.setText(token);
    QTRY_VERIFY2(offer().contains("vertices"), qPrintable(offer()));
    address.setText(QString::fromStdString(server.address("packed.tan"))); // the same server
    QTRY_VERIFY2(offer().contains("packed"), qPrintable(offer()));
    QVERIFY(field.isVisible() && field.text() == token);
    address.setText(QString::fromStdString(other.address("sample.tan")));
    QVERIFY(!field.isVisible());
    QTRY_VERIFY2(offer().contains("vertices"), qPrintable(offer()));
    QVERIFY(asked > 0 && told == 0);
    address.setText(QString::fromStdString(server.address("sample.tan")));
    QTRY_VERIFY(field.isVisible());
    QCOMPARE(field.text(), QString());
    for (const char* notYet : {"", "h", "http:/", "https://", "tan+"}) {
        address.setText(notYet);
        QCOMPARE(offer(), QString());
    }
    address.setText("localhost:8080/sample.tan");
    QVERIFY2(offer().contains("begins with http://"), qPrintable(offer()));
    QVERIFY(!openButton().isEnabled());
}

void ServedModelTest::whatNeedsTheModelIsNotOffered()
{
    const LocalServer server(folder_.path());
    openLeft(server);
    QVERIFY(!window_->find<QAction>("action.savePacked").isEnabled());
    QVERIFY(window_->find<QAction>("action.saveMesh").isEnabled());
    window_->window.open(QString::fromStdString(server.address("sample.tan")));
    QTRY_VERIFY(model() && model()->elsewhere() == nullptr && model()->siteCount() == here_->siteCount());
    QTRY_VERIFY(window_->find<QAction>("action.savePacked").isEnabled());
}

QTEST_MAIN(ServedModelTest)
#include "served_model_test.moc"
