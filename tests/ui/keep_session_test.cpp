// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/text_file.h"
#include "tests/soak.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include "ui/opening/kept_views.h"
#include "ui/session/files.h"

#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>

#include <cstdio>

using namespace tetra;

namespace {

constexpr double errorBeforeTheKill = 5.5;
constexpr const char* killedModel = "TAN_TEST_KILLED_MODEL"; ///< of the program that is killed: the model it opens
constexpr const char* killedSaysWhenEdited = "It is edited.";

} // namespace

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
    void theOffersFitIntoTheirPage();
    void whatIsDeclinedIsNotOfferedAgain();
    void whatIsIgnoredIsOfferedInTheBarAndStays();
    void whatCannotBeRestoredStays();
    void aKilledProgramLosesAtMostTenSeconds();
    void theProgramThatIsKilled();
    void aKilledSessionIsModified();
    void whatIsNotAllRestoredIsOfferedAgain();
    void anEndedProgramHasNotCrashed();
    void anEndedProgramOffersWhatItsSessionLacks();
    void aViewIsBackAfterAQuit();
    void aViewIsBackWhenAnotherModelWasOpen();
    void aViewIsBackWhenItIsOpenedAnew();
    void whatWasNeverChangedIsSeenAsAtFirst();
    void aRebuiltModelIsSeenAsBefore();
    void anotherModelOfThatNameIsSeenAsFarAsItFits();
    void aSessionLeavesTheViewOfItsModelAlone();
    void aLongFilmIsSavedAndOpened();
    void theViewIsResetByOneStep();
    void aPictureWhoseSessionIsDamagedIsNamed();

private:
    Session& session() const { return window_->workbench.session(); }
    void open(const QString& path) const;
    /// Another window, after this one has been closed as a user closes it.
    void startAnew();
    /// A model of its own in the folder of that name.
    QString modelIn(const char* folder, std::uint32_t size, double error = 0) const;
    void edit() const;
    void choose(const QString& path) const;
    static SessionDocument ofModel(const QString& path);
    /// As a program that ended unexpectedly does. Returns the file.
    static std::filesystem::path leave(const SessionDocument& document, const std::string& name = "left");
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
    QLocale::setDefault(QLocale::c());
    if (qEnvironmentVariableIsSet(killedModel))
        return;
    QSettings().clear();
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(12), folder_.path().toStdString()).string());
}

void KeepSessionTest::init()
{
    if (!qEnvironmentVariableIsSet(killedModel))
        QDir(pathText(viewFolder())).removeRecursively();
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
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
    session().setTransfer(transferFunctionFromPoints({{session().range().minimum, {1, 0, 0}, 0.25F}}, 2));
    Camera camera = window_->viewport().camera();
    camera.azimuth = 123;
    window_->viewport().setCamera(camera);
    session().setBackground(Colour{0, 0.5F, 0});
}

bool KeepSessionTest::showsEdits() const
{
    const ViewValue& view = session().view();
    return session().model() && view.query.error == 3.5 && view.isovalues.size() > 1 &&
           view.appearance.mode == "hybrid" && view.appearance.transfer.unitDistance == 2 &&
           view.camera.azimuth == 123 && view.background == Colour{0, 0.5F, 0};
}

SessionDocument KeepSessionTest::ofModel(const QString& path)
{
    SessionDocument document;
    document.model = filePath(path);
    return document;
}

std::filesystem::path KeepSessionTest::leave(const SessionDocument& document, const std::string& name)
{
    std::filesystem::create_directories(viewFolder());
    const std::filesystem::path left = viewFolder() / (name + ".lost.tansession");
    if (!writeTextFile(left, sessionToText(document, viewFolder())))
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
    QTRY_COMPARE(window_->workbench.opening().sessionFile().path(), filePath(path));
    const auto isovalues = session().view().isovalues.size();

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
    QTRY_VERIFY(!window_->workbench.opening().sessionFile().saving().running()); // closing would wait for it

    window_->find<QAction>("action.close").trigger();
    QVERIFY(!showsEdits());
    open(path);
    QTRY_VERIFY(showsEdits());
    QCOMPARE(session().view().isovalues.size(), isovalues);
    QCOMPARE(session().undoStack().count(), 0);
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::aModelThatWasReplacedIsTold()
{
    open(model_);
    auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document.has_value());
    document->identity ^= 1;
    const std::filesystem::path path = filePath(window_->folder.filePath("other.tansession"));
    QVERIFY(writeTextFile(path, sessionToText(*document, path.parent_path())));
    open(pathText(path));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("has changed since"));
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
    auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document.has_value());
    window_.reset();
    const std::filesystem::path left = leave(*document);

    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
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
    QVERIFY(window_->workbench.opening().sessionFile().path().empty());
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::theStartPageSaysWhatAndWhen()
{
    window_.reset();
    leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
    const QString text = window_->find<QLabel>("lost.text").text().remove(QChar(0x2060)).remove(QChar(0x200b));
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

/// Also beside the panels, on a small screen: with long names, and while data wait to be built.
void KeepSessionTest::theOffersFitIntoTheirPage()
{
    window_.reset();
    for (const char* name : {"lobster_120x120x34_uint8_threshold.tan", "engine_256x256x128_uint8.tan"}) {
        const std::filesystem::path model = filePath(folder_.filePath(name));
        std::filesystem::copy_file(filePath(model_), model);
        leave(ofModel(pathText(model)), name);
    }
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.resize(1280, 720);
    window_->window.show();
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QTRY_VERIFY(window_->find<QWidget>("dock.build").isVisible());
    const auto buttons = window_->window.findChildren<QPushButton*>("lost.discard");
    QCOMPARE(buttons.size(), 2);
    const auto& page = window_->find<QWidget>("empty");
    const auto* scrolled = page.findChild<QScrollArea*>();
    QVERIFY(scrolled != nullptr);
    QTRY_COMPARE(scrolled->horizontalScrollBar()->maximum(), 0);
    for (const QPushButton* button : buttons) {
        QVERIFY(button->isVisible());
        QVERIFY(page.rect().contains(QRect(button->mapTo(&page, QPoint()), button->size())));
    }
}

void KeepSessionTest::whatIsDeclinedIsNotOfferedAgain()
{
    window_.reset();
    leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
    QVERIFY(window_->find<QWidget>("lost").isVisible());
    window_->find<QPushButton>("lost.discard").click();
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    QCOMPARE(window_->messages(), QStringList());
    QVERIFY(KeptViews(viewFolder()).lost().empty());
}

void KeepSessionTest::whatIsIgnoredIsOfferedInTheBarAndStays()
{
    window_.reset();
    const std::filesystem::path left = leave(ofModel(model_));
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
    open(model_);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    QVERIFY(std::filesystem::exists(left));
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder()); // ignored again
    QVERIFY(std::filesystem::exists(left));
    window_->window.show();
    open(model_);
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->find<QPushButton>("message.answer").click();
    QTRY_VERIFY_WITH_TIMEOUT(!std::filesystem::exists(left), 30'000);
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    QVERIFY(KeptViews(viewFolder()).lost().empty());
}

void KeepSessionTest::whatCannotBeRestoredStays()
{
    window_.reset();
    const std::filesystem::path left = leave(ofModel("/nowhere/gone.tan"));
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
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

/// The program shows the view that was kept before, and edits it once more. Ten seconds later at most that is kept, and
/// when the program is killed then it is offered; it does not come back by itself: it may have been what ended the
/// program.
void KeepSessionTest::aKilledProgramLosesAtMostTenSeconds()
{
    open(model_);
    edit();
    window_.reset();
    QProcess program;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(killedModel, model_);
    program.setProcessEnvironment(environment);
    program.start(QCoreApplication::applicationFilePath(), {"keep_session", "theProgramThatIsKilled"});
    QVERIFY(program.waitForStarted());
    QByteArray said;
    QTRY_VERIFY_WITH_TIMEOUT((said += program.readAllStandardOutput()).contains(killedSaysWhenEdited), 60'000);
    QElapsedTimer clock;
    clock.start();
    const KeptViews kept(viewFolder());
    const auto keptError = [&] {
        const auto view = kept.find(filePath(model_));
        return view ? view->view.query.error : -1;
    };
    QTRY_COMPARE_WITH_TIMEOUT(keptError(), errorBeforeTheKill, 60'000);
    const qint64 slack =
        timesOf(isInstrumented ? 60'000 : 30'000, 4000); // milliseconds: two programs on a busy machine
    QVERIFY2(clock.elapsed() <= 10'000 + slack, qPrintable(QString("kept after %1 ms").arg(clock.elapsed())));
    program.kill();
    QVERIFY(program.waitForFinished());
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
    QVERIFY(window_->find<QWidget>("lost").isVisible());
    open(model_);
    QVERIFY(session().view().query.error != errorBeforeTheKill && session().view().appearance.mode != "hybrid");
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->find<QPushButton>("message.answer").click();
    QTRY_COMPARE_WITH_TIMEOUT(session().view().query.error, errorBeforeTheKill, 30'000);
    session().setError(3.5);
    QVERIFY(showsEdits()); // all the rest
    QCOMPARE(session().model()->path(), filePath(model_));
    startAnew();
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
}

void KeepSessionTest::theProgramThatIsKilled()
{
    if (!qEnvironmentVariableIsSet(killedModel))
        QSKIP("only as the program that another test kills");
    open(qEnvironmentVariable(killedModel));
    QVERIFY(showsEdits());
    session().setError(errorBeforeTheKill);
    std::puts(killedSaysWhenEdited);
    std::fflush(stdout);
    QTest::qWait(patiently(120'000)); // until it is killed
    QFAIL("nobody has killed it");
}

/// Its changes were in no file yet: they are there again, and still in none.
void KeepSessionTest::aKilledSessionIsModified()
{
    open(model_);
    auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document.has_value());
    const std::filesystem::path file = filePath(window_->folder.filePath("work.tansession"));
    QVERIFY(writeTextFile(file, sessionToText(*document, file.parent_path())));
    document->file = file;
    document->view.query.error = 3.5;
    leave(*document);
    auto next = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    next->window.show();
    QVERIFY2(next->find<QLabel>("lost.text").text().contains("work.tansession"),
             qPrintable(next->find<QLabel>("lost.text").text()));
    next->find<QPushButton>("lost.restore").click();
    QTRY_VERIFY_WITH_TIMEOUT(next->workbench.session().model() != nullptr, 30'000);
    QCOMPARE(next->workbench.session().view().query.error, 3.5);
    QCOMPARE(next->workbench.opening().sessionFile().path(), file);
    QVERIFY(next->window.isWindowModified());
}

/// Its file is all that there is of what could not be shown.
void KeepSessionTest::whatIsNotAllRestoredIsOfferedAgain()
{
    open(model_);
    auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document.has_value());
    document->view.appearance.mode = "of a plugin that is not there";
    leave(*document);
    auto next = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    next->window.show();
    next->find<QPushButton>("lost.restore").click();
    QTRY_VERIFY_WITH_TIMEOUT(next->workbench.session().model() != nullptr, 30'000);
    QTRY_VERIFY(!next->messages().isEmpty());
    next.reset();
    QCOMPARE(KeptViews(viewFolder()).lost().size(), std::size_t(1));
}

/// By a signal or with the desktop's session: without the questions that closing asks.
void KeepSessionTest::anEndedProgramHasNotCrashed()
{
    open(model_);
    edit();
    window_->window.keepAll();
    QTRY_VERIFY(window_->workbench.opening().views().idle());
    QVERIFY(KeptViews(viewFolder()).lost().empty()); // if it is killed now
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
    QVERIFY(!window_->find<QWidget>("lost").isVisible());
    open(model_);
    QVERIFY(showsEdits());
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::anEndedProgramOffersWhatItsSessionLacks()
{
    open(model_);
    const auto document = window_->workbench.opening().sessions().document();
    const std::filesystem::path file = filePath(window_->folder.filePath("work.tansession"));
    QVERIFY(document && writeTextFile(file, sessionToText(*document, file.parent_path())));
    const auto before = readTextFile(file);
    open(pathText(file));
    QTRY_COMPARE(window_->workbench.opening().sessionFile().path(), file);
    session().setError(3.5);
    window_->window.keepAll();
    session().setError(4.5); // it was not ended after all
    window_->window.keepAll();
    QTRY_VERIFY(window_->workbench.opening().views().idle());
    QVERIFY(window_->window.close()); // as the desktop then does, and nobody is asked
    auto next = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    next->window.show();
    const QString text = next->find<QLabel>("lost.text").text();
    QVERIFY2(text.contains("work.tansession") && text.contains("unsaved") && !text.contains("unexpectedly"),
             qPrintable(text));
    QCOMPARE(*readTextFile(file), *before); // nobody has saved it
    next->find<QPushButton>("lost.restore").click();
    QTRY_VERIFY(next->workbench.session().model() != nullptr);
    QCOMPARE(next->workbench.session().view().query.error, 4.5);
    QCOMPARE(next->workbench.opening().sessionFile().path(), file);
    QVERIFY(next->window.isWindowModified());
    QTRY_VERIFY(KeptViews(viewFolder()).lost().empty());
    next.reset();
    window_.reset();
}

void KeepSessionTest::startAnew()
{
    QVERIFY(window_->window.close());
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostOfThisBuild(), viewFolder());
    window_->window.show();
}

QString KeepSessionTest::modelIn(const char* folder, std::uint32_t size, double error) const
{
    const QString path = folder_.filePath(folder);
    QDir().mkpath(path);
    return pathText(buildSampleModel(*window_->host, sampleDataset(size), filePath(path), error));
}

void KeepSessionTest::aViewIsBackAfterAQuit()
{
    open(model_);
    edit();
    const auto isovalues = session().view().isovalues;
    startAnew();
    QVERIFY(!window_->find<QWidget>("lost").isVisible()); // it has ended as it should
    open(model_);
    QVERIFY(showsEdits());
    QCOMPARE(session().view().isovalues, isovalues);
    QCOMPARE(session().undoStack().count(), 0);
    QVERIFY(window_->workbench.opening().sessionFile().path().empty());
    QVERIFY(!window_->window.isWindowModified());
    QCOMPARE(window_->messages(), QStringList());
    startAnew(); // without a change
    open(model_);
    QVERIFY(showsEdits());
}

void KeepSessionTest::aViewIsBackWhenAnotherModelWasOpen()
{
    const QString other = modelIn("other", 10);
    open(model_);
    edit();
    open(other);
    QTRY_COMPARE(pathText(session().model()->path()), other);
    QVERIFY(!showsEdits());
    window_->window.open(QFileInfo(model_).path() + "/../" + QFileInfo(model_).dir().dirName() + "/c60.tan");
    QTRY_COMPARE(QFileInfo(pathText(session().model()->path())).canonicalFilePath(),
                 QFileInfo(model_).canonicalFilePath());
    QVERIFY(showsEdits()); // by whatever name
}

void KeepSessionTest::aViewIsBackWhenItIsOpenedAnew()
{
    open(model_);
    edit();
    const auto before = session().model();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() != before);
    QVERIFY(showsEdits());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!session().model());
    open(model_);
    QVERIFY(showsEdits());
}

/// So that better defaults of a later version are seen.
void KeepSessionTest::whatWasNeverChangedIsSeenAsAtFirst()
{
    open(model_);
    startAnew();
    QVERIFY(QDir(pathText(viewFolder())).entryList(QDir::Files).isEmpty());
}

/// The same data, another accuracy.
void KeepSessionTest::aRebuiltModelIsSeenAsBefore()
{
    const QString path = modelIn("rebuilt", 12);
    open(path);
    edit();
    startAnew();
    const std::uint64_t before = modelIdentity(**Model::open(filePath(path)));
    modelIn("rebuilt", 12, 1);
    QVERIFY(modelIdentity(**Model::open(filePath(path))) != before);
    open(path);
    QVERIFY(showsEdits());
    QCOMPARE(window_->messages(), QStringList());
}

/// Mode and background are; colours, values and places of other data are not.
void KeepSessionTest::anotherModelOfThatNameIsSeenAsFarAsItFits()
{
    const QString fresh = modelIn("fresh", 20);
    open(fresh);
    const std::vector<Isovalue> isovalues = session().view().isovalues;
    session().setError(3.5); // as edit() does, and what is kept of it
    const TransferFunction transfer = session().view().appearance.transfer;
    const Camera camera = window_->viewport().camera();
    startAnew();
    const QString path = modelIn("replaced", 12);
    open(path);
    edit();
    QueryState query = session().view().query;
    query.window.enabled = true;
    session().setQuery(query);
    startAnew();
    modelIn("replaced", 20);
    open(path);
    QCOMPARE(session().view().appearance.mode, std::string("hybrid"));
    QVERIFY(window_->viewport().background() == (Colour{0, 0.5F, 0}));
    QCOMPARE(session().view().isovalues, isovalues);
    QVERIFY(session().view().appearance.transfer == transfer);
    QVERIFY(!session().view().query.window.enabled);
    QCOMPARE(window_->viewport().camera().distance, camera.distance);
    QCOMPARE(window_->messages(), QStringList());
}

void KeepSessionTest::aSessionLeavesTheViewOfItsModelAlone()
{
    open(model_);
    edit();
    auto document = window_->workbench.opening().sessions().document();
    QVERIFY(document.has_value());
    document->view.query.error = 8;
    const std::filesystem::path file = filePath(window_->folder.filePath("other.tansession"));
    QVERIFY(writeTextFile(file, sessionToText(*document, file.parent_path())));
    open(pathText(file));
    QTRY_COMPARE(session().view().query.error, 8.0);
    window_->find<QAction>("action.mode.volume").trigger();
    session().undoStack().undo(); // nothing to be asked about
    startAnew();
    open(model_);
    QVERIFY(showsEdits());
}

/// Whatever can be saved can be opened again.
void KeepSessionTest::aLongFilmIsSavedAndOpened()
{
    open(model_);
    Animation animation;
    animation.kind = Animation::Kind::KeyFrames;
    FilmFrame frame = frameOf(session().view());
    std::vector<TransferPoint> points;
    for (int point = 0; point < 64; ++point)
        points.push_back({session().range().minimum + point * session().range().extent() / 63, {1, 0, 0}, 0.5F});
    frame.transfer = transferFunctionFromPoints(points, frame.transfer.unitDistance);
    for (int key = 0; key < 300; ++key) {
        frame.camera.azimuth = key;
        animation = withKey(animation, frame);
    }
    session().setAnimation(animation);
    const std::filesystem::path file = filePath(folder_.filePath("long.tansession"));
    bool isSaved = false;
    window_->workbench.opening().sessionFile().save(file, *window_->workbench.opening().sessions().document(),
                                                    [&](bool saved) { isSaved = saved; });
    QTRY_VERIFY(isSaved);
    QVERIFY(std::filesystem::file_size(file) > 1 << 20);
    startAnew();
    window_->window.open(pathText(file));
    QTRY_VERIFY_WITH_TIMEOUT(session().model() || !window_->messages().isEmpty(), 30'000);
    QVERIFY2(window_->messages().isEmpty(), qPrintable(window_->messages().join('\n')));
    QCOMPARE(session().view().animation.keys.size(), std::size_t(300));
}

void KeepSessionTest::theViewIsResetByOneStep()
{
    open(model_);
    const ViewValue start = session().view();
    auto& reset = window_->find<QAction>("action.resetView");
    reset.trigger();
    QCOMPARE(session().undoStack().count(), 0); // it is so already
    edit();
    AnnotationState annotations;
    annotations[AnnotationKind::Title].shown = true;
    session().setAnnotations(annotations);
    startAnew();
    open(model_);
    QVERIFY(showsEdits());
    auto& resetNow = window_->find<QAction>("action.resetView");
    resetNow.trigger();
    QCOMPARE(session().undoStack().count(), 1);
    QVERIFY(session().view() == start);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(showsEdits() && session().view().annotations == annotations);
    window_->find<QAction>("action.redo").trigger();
    QVERIFY(session().view() == start);
    startAnew();
    open(model_);
    QVERIFY(session().view().appearance == start.appearance);
}

void KeepSessionTest::aPictureWhoseSessionIsDamagedIsNamed()
{
    QImage picture(8, 8, QImage::Format_RGB32);
    picture.fill(Qt::red);
    picture.setText("TAn-session", "{}");
    const QString path = window_->folder.filePath("old.png");
    QVERIFY(picture.save(path));
    window_->window.open(path);
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->find<QPushButton>("message.answer").click();
    QTRY_VERIFY(!window_->workbench.opening().reading().running() && window_->messages().size() == 1);
    QVERIFY2(window_->messages().first().contains("old.png: The session cannot be read"),
             qPrintable(window_->messages().first()));
}

QTEST_MAIN(KeepSessionTest)
#include "keep_session_test.moc"
