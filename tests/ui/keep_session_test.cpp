// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"

#include "ui/session/recovery.h"
#include "ui/session/session_document.h"
#include "ui/session/target_path.h"
#include "ui/session/text_file.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>

using namespace tetra;

/// Sessions as a user saves, opens and loses them, by object names.
class KeepSessionTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void aSessionIsSavedAndOpened();
    void aModelThatWasReplacedIsTold();
    void aModelThatIsGoneIsTold();
    void whatAProgramLeftBehindIsOffered();
    void theStartPageSaysWhatAndWhen();
    void whatIsDeclinedIsNotOfferedAgain();
    void whatIsIgnoredIsOfferedInTheBarAndStays();
    void whatCannotBeRestoredStays();
    void aKilledProgramLosesAtMostTenSeconds();

private:
    Session& session() const { return window_->workbench.session(); }
    void open(const QString& path) const;
    void edit() const;
    void choose(const QString& path) const;
    static SessionDocument ofModel(const QString& path);
    /// As a program that ended unexpectedly does. Returns the file.
    static std::filesystem::path leave(const SessionDocument& document);
    /// What the edits of edit() have made.
    bool showsEdits() const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void KeepSessionTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("TAn");
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(12), folder_.path().toStdString()).string());
}

void KeepSessionTest::init()
{
    QDir(pathText(recoveryFolder())).removeRecursively();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void KeepSessionTest::cleanup()
{
    window_.reset();
}

void KeepSessionTest::open(const QString& path) const
{
    window_->window.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(session().model() && window_->settled(), 30'000);
}

void KeepSessionTest::edit() const
{
    session().setError(3.5);
    session().addIsovalue(session().range().minimum + 0.25 * session().range().extent());
    window_->find<QAction>("action.mode.hybrid").trigger();
    session().setTransfer({{{session().range().minimum, {1, 0, 0}, 0.25F}}, 2});
    Camera camera = window_->viewport().camera();
    camera.azimuth = 123;
    window_->viewport().setCamera(camera);
    window_->viewport().setBackground(Colour{0, 0.5F, 0});
}

bool KeepSessionTest::showsEdits() const
{
    const ViewState& view = session().view();
    return session().model() && view.error() == 3.5 && view.isovalueCount() > 1 && view.look().mode == "hybrid" &&
           view.look().transfer.unitDistance == 2 && window_->viewport().camera().azimuth == 123 &&
           window_->viewport().background() == Colour{0, 0.5F, 0};
}

SessionDocument KeepSessionTest::ofModel(const QString& path)
{
    SessionDocument document;
    document.model = filePath(path);
    return document;
}

std::filesystem::path KeepSessionTest::leave(const SessionDocument& document)
{
    std::filesystem::create_directories(recoveryFolder());
    const std::filesystem::path left = recoveryFolder() / "left.tansession";
    if (!writeTextFile(left, sessionToText(document, recoveryFolder())))
        qFatal("the session could not be left");
    return left;
}

void KeepSessionTest::choose(const QString& path) const
{
    auto* found = window_->window.findChild<QFileDialog*>("sessionDialog");
    QVERIFY(found != nullptr);
    emit found->fileSelected(path);
    found->reject();
}

void KeepSessionTest::aSessionIsSavedAndOpened()
{
    QVERIFY(!window_->find<QAction>("action.saveSession").isEnabled());
    open(model_);
    edit();
    QVERIFY(showsEdits());
    const QString path = window_->folder.filePath("work.tansession");
    window_->find<QAction>("action.saveSession").trigger();
    choose(path);
    QTRY_VERIFY(QFile::exists(path));
    QTRY_COMPARE(window_->workbench.sessionFile(), filePath(path));
    const int isovalues = session().view().isovalueCount();

    // The next time there is nothing to ask.
    session().setError(7);
    const qint64 before = QFileInfo(path).size();
    window_->find<QAction>("action.saveSession").trigger();
    QVERIFY(window_->window.findChild<QFileDialog*>("sessionDialog") == nullptr ||
            !window_->window.findChild<QFileDialog*>("sessionDialog")->isVisible());
    QTRY_VERIFY(QFileInfo(path).size() != before);
    session().setError(3.5);
    window_->find<QAction>("action.saveSession").trigger();
    QTRY_COMPARE(QFileInfo(path).size(), before);

    window_->find<QAction>("action.close").trigger();
    QVERIFY(!showsEdits());
    open(path);
    QTRY_VERIFY(showsEdits());
    QCOMPARE(session().view().isovalueCount(), isovalues);
    QCOMPARE(session().undoStack().count(), 0);
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::aModelThatWasReplacedIsTold()
{
    open(model_);
    auto document = window_->workbench.sessionDocument();
    QVERIFY(document.has_value());
    document->identity ^= 1;
    const std::filesystem::path path = filePath(window_->folder.filePath("other.tansession"));
    QVERIFY(writeTextFile(path, sessionToText(*document, path.parent_path())));
    open(pathText(path));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("another one"));
}

void KeepSessionTest::aModelThatIsGoneIsTold()
{
    const std::filesystem::path path = filePath(window_->folder.filePath("gone.tansession"));
    SessionDocument document;
    document.model = path.parent_path() / "gone.tan";
    QVERIFY(writeTextFile(path, sessionToText(document, path.parent_path())));
    window_->window.open(pathText(path));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("gone.tan"));
    QVERIFY(!session().model());
}

void KeepSessionTest::whatAProgramLeftBehindIsOffered()
{
    open(model_);
    edit();
    auto document = window_->workbench.sessionDocument();
    QVERIFY(document.has_value());
    document->camera = window_->viewport().camera();
    document->background = window_->viewport().background();
    window_.reset();
    const std::filesystem::path left = leave(*document);

    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    QCOMPARE(window_->messages(), QStringList());
    auto& restore = window_->find<QPushButton>("lost.restore");
    QVERIFY(restore.isVisible());
    restore.setFocus();
    QTest::keyClick(&restore, Qt::Key_Space);
    QTRY_VERIFY(showsEdits());
    QVERIFY(!std::filesystem::exists(left));
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    QCoreApplication::processEvents();
    QVERIFY(window_->workbench.sessionFile().empty());
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::theStartPageSaysWhatAndWhen()
{
    window_.reset();
    leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    const QString text = window_->find<QLabel>("lost.text").text();
    QVERIFY2(text.contains("c60.tan"), qPrintable(text));
    QVERIFY2(text.contains(QLocale().toString(QDate::currentDate(), QLocale::ShortFormat)), qPrintable(text));
    QVERIFY2(text.contains(QDir::toNativeSeparators(QFileInfo(model_).absolutePath())), qPrintable(text));
    for (const char* name : {"lost.restore", "lost.discard"}) {
        auto& button = window_->find<QPushButton>(name);
        QVERIFY(button.isVisible() && button.focusPolicy() != Qt::NoFocus && !button.toolTip().isEmpty());
        QVERIFY(button.accessibleName().contains("c60.tan"));
        QVERIFY(!QKeySequence::mnemonic(button.text()).isEmpty());
    }
    QVERIFY(window_->find<QPushButton>("empty.open").isEnabled()); // nobody is stopped
}

void KeepSessionTest::whatIsDeclinedIsNotOfferedAgain()
{
    window_.reset();
    leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    QVERIFY(window_->find<QWidget>("lost").isVisible());
    window_->find<QPushButton>("lost.discard").click();
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    QCOMPARE(window_->messages(), QStringList());
    QVERIFY(lostSessions(recoveryFolder()).empty());
}

void KeepSessionTest::whatIsIgnoredIsOfferedInTheBarAndStays()
{
    window_.reset();
    const std::filesystem::path left = leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    open(model_);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    QVERIFY(std::filesystem::exists(left));
    window_ = std::make_unique<WindowFixture>(); // ignored again
    QVERIFY(std::filesystem::exists(left));
    window_->window.show();
    open(model_);
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->find<QPushButton>("message.answer").click();
    QTRY_VERIFY_WITH_TIMEOUT(!std::filesystem::exists(left), 30'000);
    window_ = std::make_unique<WindowFixture>();
    QVERIFY(lostSessions(recoveryFolder()).empty());
}

void KeepSessionTest::whatCannotBeRestoredStays()
{
    window_.reset();
    const std::filesystem::path left = leave(ofModel("/nowhere/gone.tan"));
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->find<QPushButton>("lost.restore").click();
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(std::filesystem::exists(left));
    QVERIFY(window_->find<QPushButton>("lost.restore").isVisible());
    // Another session is no proof that this one is not needed any more.
    const std::filesystem::path other = filePath(window_->folder.filePath("other.tansession"));
    QVERIFY(writeTextFile(other, sessionToText(ofModel(model_), other.parent_path())));
    open(pathText(other));
    QCoreApplication::processEvents();
    QVERIFY(std::filesystem::exists(left));
}

void KeepSessionTest::aKilledProgramLosesAtMostTenSeconds()
{
    window_.reset();
    QProcess program;
    program.start(TAN_BINARY_DIR "/bin/tan-desktop", {"--backend", "cpu", model_});
    QVERIFY(program.waitForStarted());
    const QDir folder(pathText(recoveryFolder()));
    const auto files = [&folder] { return folder.entryList({"*.tansession"}, QDir::Files); };
    QTRY_VERIFY_WITH_TIMEOUT(!files().isEmpty(), 60'000);
    program.kill();
    QVERIFY(program.waitForFinished());
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->find<QPushButton>("lost.restore").click();
    QTRY_VERIFY_WITH_TIMEOUT(session().model() != nullptr, 30'000);
    QCOMPARE(session().model()->path(), filePath(model_));
}

QTEST_MAIN(KeepSessionTest)
#include "keep_session_test.moc"
