// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include "ui/dialogs/picture_orders.h"
#include "ui/opening/recent_files.h"
#include "ui/panels/build_panel.h"
#include "ui/session/files.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QStandardPaths>

#include <set>

using namespace tetra;

/// What is asked before work is lost: a build, a film, a session with changes that are not saved, files that are still
/// being written; and that nothing is asked where nothing is lost. By the window's own way of closing and opening.
class LeavingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void nothingToLoseIsNotAskedAbout();
    void quittingDuringABuildAsks();
    void aBuildIsKeptAndTheProgramQuits();
    void aFinishedModelIsNotReplacedByWhatIsKept_data();
    void aFinishedModelIsNotReplacedByWhatIsKept();
    void aBuildIsPausedAndTheProgramQuits_data();
    void aBuildIsPausedAndTheProgramQuits();
    void aBuildThatCannotBeKeptKeepsTheWindow();
    void aBuildThatEndsMeanwhileNeedsNoAnswer();
    void openingDuringABuildAsksOnce();
    void openingInstead_data();
    void openingInstead();
    void anOpeningCanBeTakenBack();
    void closingAWatchedBuildAsks();
    void quittingDuringAFilmAsks();
    void openingDuringAFilmAsks();
    void aSessionIsMarkedAsModified();
    void aModifiedSessionIsAskedAbout_data();
    void aModifiedSessionIsAskedAbout();
    void whatCannotBeOpenedTakesNothingAway();
    void aSessionThatCannotBeSavedKeepsTheWindow();
    void aSessionBeingSavedIsWaitedFor();
    void aSessionSavedJustNowIsWaitedFor();
    void quittingWaitsForFilesBeingWritten();
    void everyFailedSaveIsTold();
    void whatIsOfAModelIsNotSavedWithoutOne();
    void savesDoNotStopEachOther();

private:
    Session& session() const { return window_->workbench.session(); }
    QMessageBox* box(const char* name) const;
    bool isAsked(const char* name) const { return box(name) != nullptr && box(name)->isVisible(); }
    void answer(const char* question, const char* button) const;
    /// A model beside the dataset that is built; its own file.
    QString otherModel() const;
    void open(const QString& path) const;
    void startBuild(std::uint32_t size = 96);
    /// A film that takes long.
    void startFilm() const;
    QString saveSession() const;
    void editWhatCannotBeSaved();
    void edit() const { session().setError(session().view().query.error == 3.5 ? 4.5 : 3.5); }

    std::unique_ptr<WindowFixture> window_;
    QString target_; ///< of the build
};

void LeavingTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("leaving");
    QLocale::setDefault(QLocale::c());
}

void LeavingTest::init()
{
    QSettings().clear();
    QDir(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)).removeRecursively();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void LeavingTest::cleanup()
{
    window_.reset();
}

QMessageBox* LeavingTest::box(const char* name) const
{
    for (auto* found : window_->window.findChildren<QMessageBox*>(name))
        if (found->isVisible())
            return found;
    return nullptr;
}

void LeavingTest::answer(const char* question, const char* button) const
{
    QTRY_VERIFY2(isAsked(question), question);
    auto* found = box(question)->findChild<QAbstractButton*>(button);
    QVERIFY2(found != nullptr && found->isEnabled(), button);
    found->click();
    QTRY_VERIFY(!isAsked(question));
}

QString LeavingTest::otherModel() const
{
    const std::filesystem::path folder = window_->folderPath() + "/other";
    std::filesystem::create_directories(folder);
    return pathText(buildSampleModel(*window_->host, sampleDataset(12), folder));
}

void LeavingTest::open(const QString& path) const
{
    window_->window.open(path);
    QTRY_VERIFY_WITH_TIMEOUT(session().model() && pathText(session().model()->path()) == path && window_->settled(),
                             30'000);
}

void LeavingTest::startBuild(std::uint32_t size)
{
    window_->window.open(pathText(writeNrrd(sampleDataset(size), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    auto& target = window_->find<QLineEdit>("build.target");
    target_ = window_->folder.filePath("into/built.tan");
    QVERIFY(QDir().mkpath(window_->folder.filePath("into")));
    target.setText(target_);
    QTRY_VERIFY(!window_->find<BuildPanel>("build").looking());
    window_->find<QPushButton>("build.start").click();
    QTRY_VERIFY(window_->find<QProgressBar>("build.progress").value() > 0);
    QVERIFY(window_->workbench.building().running());
}

void LeavingTest::startFilm() const
{
    Animation animation;
    animation.turntable.frames = 5000;
    session().setAnimation(animation);
    FilmOrder order =
        filmOrder(window_->workbench, window_->viewport(), {QSize(320, 240), 0, false, AnnotationState()});
    order.target = filePath(window_->folder.filePath("film.png"));
    window_->workbench.exporting().saveFilm(order);
    QVERIFY(window_->workbench.exporting().savingFilm().running());
}

QString LeavingTest::saveSession() const
{
    QString path = window_->folder.filePath("work.tansession");
    window_->find<QAction>("action.saveSession").trigger();
    auto& dialog = window_->find<QFileDialog>("sessionDialog");
    emit dialog.fileSelected(path);
    dialog.reject();
    if (!waitFor(
            [&] { return window_->workbench.opening().sessionFile().path() == filePath(path) && QFile::exists(path); }))
        qFatal("the session is not saved");
    return path;
}

void LeavingTest::nothingToLoseIsNotAskedAbout()
{
    open(otherModel());
    edit();
    QVERIFY(!window_->window.isWindowModified()); // a model's view is kept by itself
    QVERIFY(window_->window.close());
    QVERIFY(!window_->window.isVisible());
}

void LeavingTest::quittingDuringABuildAsks()
{
    startBuild();
    QTRY_VERIFY(window_->workbench.building().canKeepBuild());
    window_->window.close();
    QVERIFY(window_->window.isVisible());
    QVERIFY(isAsked("leaving.build"));
    QMessageBox& question = *box("leaving.build");
    QVERIFY2(question.text().contains("c60.nrrd"), qPrintable(question.text()));
    QVERIFY2(question.informativeText().contains("built.tan"), qPrintable(question.informativeText()));
    QCOMPARE(question.defaultButton()->objectName(), QString("leaving.goOn"));
    QTest::keyClick(&question, Qt::Key_Escape);
    QVERIFY(!isAsked("leaving.build"));
    QVERIFY(window_->window.isVisible() && window_->workbench.building().running());

    window_->find<QAction>("action.quit").trigger(); // asked again
    answer("leaving.build", "leaving.discard");
    QTRY_VERIFY(!window_->window.isVisible());
    QVERIFY(!QFile::exists(target_));
    QCOMPARE(window_->messages(), QStringList());
}

void LeavingTest::aBuildIsKeptAndTheProgramQuits()
{
    startBuild();
    QTRY_VERIFY(session().model() != nullptr); // there is something to keep
    window_->window.close();
    answer("leaving.build", "leaving.keep");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->window.isVisible(), 30'000);
    const auto kept = Model::open(filePath(target_));
    QVERIFY2(kept, kept ? "" : kept.error().text().c_str());
    QVERIFY((*kept)->finalKey() > 0);
}

/// Quitting, closing and opening keep beside a finished model, and name both.
void LeavingTest::aFinishedModelIsNotReplacedByWhatIsKept_data()
{
    QTest::addColumn<QString>("way");
    for (const char* way : {"quit", "close", "open"})
        QTest::newRow(way) << QString(way);
}

void LeavingTest::aFinishedModelIsNotReplacedByWhatIsKept()
{
    QFETCH(QString, way);
    const QString other = otherModel();
    const QString finished = window_->folder.filePath("into/built.tan");
    QVERIFY(QDir().mkpath(window_->folder.filePath("into")) && QFile::copy(other, finished));
    const auto content = [](const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    startBuild();
    QTRY_VERIFY(session().model() != nullptr);
    if (way == "quit")
        window_->window.close();
    else if (way == "close")
        window_->find<QAction>("action.close").trigger();
    else
        window_->window.open(other);
    QTRY_VERIFY(isAsked("leaving.build"));
    const QMessageBox& question = *box("leaving.build");
    QCOMPARE(question.defaultButton()->objectName(), QString("leaving.goOn"));
    const QString text = question.informativeText();
    QVERIFY2(text.contains("built.tan") && text.contains("named after its error"), qPrintable(text));
    answer("leaving.build", "leaving.keep");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 30'000);
    const QDir folder(window_->folder.filePath("into"));
    QTRY_COMPARE(folder.entryList({"built*percent.tan"}).size(), 1);
    QVERIFY(Model::open(filePath(folder.filePath(folder.entryList({"built*percent.tan"}).first()))));
    QVERIFY(content(finished) == content(other));
}

void LeavingTest::aBuildIsPausedAndTheProgramQuits_data()
{
    QTest::addColumn<QString>("button");
    QTest::addColumn<bool>("left");
    QTest::newRow("resumed later, B6") << "leaving.pause" << true;
    QTest::newRow("discarded") << "leaving.discard" << false;
}

void LeavingTest::aBuildIsPausedAndTheProgramQuits()
{
    QFETCH(QString, button);
    QFETCH(bool, left);
    window_->find<QCheckBox>("build.resume").click(); // and remembered, for the data that come
    startBuild();
    QVERIFY(window_->workbench.building().canPauseBuild());
    QTRY_VERIFY_WITH_TIMEOUT(window_->workbench.building().canKeepBuild(), 30'000); // it has begun to refine
    window_->window.close();
    answer("leaving.build", qPrintable(button));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->window.isVisible(), 30'000);
    QVERIFY(!QFile::exists(target_));
    QCOMPARE(QFile::exists(target_ + ".work/state"), left);
    QCOMPARE(QFile::exists(target_ + ".work"), left);
    QCOMPARE(window_->messages(), QStringList());
}

void LeavingTest::aBuildThatCannotBeKeptKeepsTheWindow()
{
    startBuild();
    QTRY_VERIFY(session().model() != nullptr);
    QVERIFY(QDir(window_->folder.filePath("into")).removeRecursively());
    window_->window.close();
    answer("leaving.build", "leaving.keep");
    QTRY_COMPARE_WITH_TIMEOUT(window_->messages().size(), 1, 30'000);
    QVERIFY2(window_->messages().first().contains("built.tan"), qPrintable(window_->messages().first()));
    QVERIFY(window_->window.isVisible());
}

void LeavingTest::aBuildThatEndsMeanwhileNeedsNoAnswer()
{
    startBuild(64);
    window_->window.close();
    QVERIFY(isAsked("leaving.build"));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->window.isVisible(), 60'000);
    QVERIFY(Model::open(filePath(target_)));
}

/// The build goes on behind another model; its own does not push that away when it is done.
void LeavingTest::openingDuringABuildAsksOnce()
{
    const QString other = otherModel();
    startBuild(64);
    window_->window.open(other);
    QTRY_VERIFY(isAsked("leaving.build"));
    QVERIFY(!session().model() || pathText(session().model()->path()) != other);
    answer("leaving.build", "leaving.goOn");
    QTRY_COMPARE(pathText(session().model()->path()), other);
    QVERIFY(window_->workbench.building().running());
    window_->window.open(other);
    QTRY_VERIFY(!window_->workbench.opening().reading().running());
    QVERIFY(!isAsked("leaving.build"));

    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("built.tan"), qPrintable(window_->messages().first()));
    QCOMPARE(pathText(session().model()->path()), other);
    window_->find<QPushButton>("message.answer").click();
    QTRY_COMPARE(pathText(session().model()->path()), target_);
}

void LeavingTest::openingInstead_data()
{
    QTest::addColumn<QString>("button");
    QTest::addColumn<bool>("kept");
    QTest::newRow("keep") << "leaving.keep" << true;
    QTest::newRow("discard") << "leaving.discard" << false;
}

void LeavingTest::openingInstead()
{
    QFETCH(QString, button);
    QFETCH(bool, kept);
    const QString other = otherModel();
    startBuild();
    QTRY_VERIFY(session().model() != nullptr);
    window_->window.open(other);
    answer("leaving.build", qPrintable(button));
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 30'000);
    QTRY_COMPARE(pathText(session().model()->path()), other);
    QCOMPARE(QFile::exists(target_), kept);
    QCOMPARE(recentFiles().contains(target_), kept);
    QCOMPARE(window_->messages(), QStringList());
}

void LeavingTest::anOpeningCanBeTakenBack()
{
    const QString other = otherModel();
    startBuild();
    QTRY_VERIFY(session().model() != nullptr);
    window_->window.open(other);
    answer("leaving.build", "leaving.cancel");
    QVERIFY(window_->workbench.building().running());
    QVERIFY(pathText(session().model()->path()) != other);
    window_->workbench.building().stopBuild(BuildEnd::Keep);
    QTRY_COMPARE_WITH_TIMEOUT(pathText(session().model()->path()), target_, 30'000); // it is watched to its end
}

void LeavingTest::closingAWatchedBuildAsks()
{
    startBuild();
    QTRY_VERIFY(session().model() != nullptr);
    window_->find<QAction>("action.close").trigger();
    QVERIFY(session().model() != nullptr);
    answer("leaving.build", "leaving.goOn");
    QTRY_VERIFY(!session().model());
    QVERIFY(window_->workbench.building().running());
    QVERIFY(window_->find<QWidget>("dock.build").isVisible()); // where it can be stopped
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!isAsked("leaving.build")); // there is nothing to close
    window_->find<QPushButton>("build.cancel").click();
    QTRY_VERIFY(!window_->workbench.building().running());
}

void LeavingTest::quittingDuringAFilmAsks()
{
    open(otherModel());
    startFilm();
    window_->window.close();
    QVERIFY(window_->window.isVisible());
    QVERIFY2(isAsked("leaving.film"), "it is not asked about");
    QCOMPARE(box("leaving.film")->defaultButton()->objectName(), QString("leaving.goOn"));
    answer("leaving.film", "leaving.goOn");
    QVERIFY(window_->window.isVisible() && window_->workbench.exporting().savingFilm().running());
    window_->window.close();
    answer("leaving.film", "leaving.discard");
    QTRY_VERIFY(!window_->window.isVisible());
    QVERIFY(QDir(window_->folder.path()).entryList({"film*"}, QDir::AllEntries | QDir::Hidden).isEmpty());
}

void LeavingTest::openingDuringAFilmAsks()
{
    open(otherModel());
    startFilm();
    const auto before = session().model();
    window_->window.open(pathText(before->path()));
    QTRY_VERIFY(isAsked("leaving.film"));
    QVERIFY(session().model() == before);
    answer("leaving.film", "leaving.goOn");
    QTRY_VERIFY(session().model() != before);
    QVERIFY(window_->workbench.exporting().savingFilm().running());
    window_->workbench.exporting().savingFilm().cancel();
}

void LeavingTest::aSessionIsMarkedAsModified()
{
    open(otherModel());
    edit();
    saveSession();
    QVERIFY(window_->window.windowTitle().contains("[*]"));
    QVERIFY2(window_->window.windowTitle().contains("work.tansession"), qPrintable(window_->window.windowTitle()));
    QVERIFY(!window_->window.isWindowModified());
    edit();
    QVERIFY(window_->window.isWindowModified());
    session().undoStack().undo();
    QVERIFY(!window_->window.isWindowModified());
    Camera camera = window_->viewport().camera();
    camera.azimuth += 10;
    window_->viewport().setCamera(camera);
    QVERIFY(window_->window.isWindowModified());
    window_->find<QAction>("action.saveSession").trigger();
    QTRY_VERIFY(!window_->window.isWindowModified());
    QTRY_VERIFY(window_->find<QLabel>("status.file").text().contains("c60.tan"));
    window_->find<QAction>("action.close").trigger();
    QTRY_VERIFY(!window_->window.windowTitle().contains("work"));
}

void LeavingTest::aModifiedSessionIsAskedAbout_data()
{
    QTest::addColumn<QString>("way");
    QTest::addColumn<QString>("button");
    for (const char* way : {"quit", "close", "open"})
        for (const char* button : {"save", "discard", "cancel"})
            QTest::addRow("%s, %s", way, button) << QString(way) << QString(button);
}

void LeavingTest::aModifiedSessionIsAskedAbout()
{
    QFETCH(QString, way);
    QFETCH(QString, button);
    const QString model = otherModel();
    open(model);
    const QString file = saveSession();
    const auto contentOf = [](const QString& path) {
        QFile read(path);
        return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
    };
    const QByteArray before = contentOf(file);
    edit();
    const auto edited = session().model();
    if (way == "quit")
        window_->window.close();
    else if (way == "close")
        window_->find<QAction>("action.close").trigger();
    else
        window_->window.open(model);
    QTRY_VERIFY(isAsked("leaving.session"));
    QVERIFY(box("leaving.session")->text().contains("work.tansession"));
    QCOMPARE(box("leaving.session")->defaultButton()->objectName(), QString("leaving.save"));
    QVERIFY(session().model() == edited && window_->window.isVisible());
    if (button == "cancel")
        QTest::keyClick(box("leaving.session"), Qt::Key_Escape);
    else
        answer("leaving.session", qPrintable("leaving." + button));
    if (button == "cancel") {
        QTRY_VERIFY(!isAsked("leaving.session"));
        QVERIFY(session().model() == edited && window_->window.isVisible() && window_->window.isWindowModified());
    } else if (way == "quit") {
        QTRY_VERIFY(!window_->window.isVisible());
    } else {
        QTRY_VERIFY(session().model() != edited);
        QVERIFY(window_->workbench.opening().sessionFile().path().empty());
    }
    QCOMPARE(contentOf(file) != before, button == "save");
    QCOMPARE(window_->messages(), QStringList());
}

void LeavingTest::whatCannotBeOpenedTakesNothingAway()
{
    open(otherModel());
    saveSession();
    edit();
    window_->window.open(window_->folder.filePath("missing.tan"));
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(!isAsked("leaving.session"));
    QVERIFY(window_->window.isWindowModified());
}

/// A session with changes, saved to a folder that is there no more.
void LeavingTest::editWhatCannotBeSaved()
{
    open(otherModel());
    QVERIFY(QDir().mkpath(window_->folder.filePath("gone")));
    saveSession();
    const QString path = window_->folder.filePath("gone/work.tansession");
    window_->find<QAction>("action.saveSessionAs").trigger();
    auto& dialog = window_->find<QFileDialog>("sessionDialog");
    emit dialog.fileSelected(path);
    dialog.reject();
    QTRY_COMPARE(window_->workbench.opening().sessionFile().path(), filePath(path));
    edit();
    QVERIFY(QDir(window_->folder.filePath("gone")).removeRecursively());
}

void LeavingTest::aSessionThatCannotBeSavedKeepsTheWindow()
{
    editWhatCannotBeSaved();
    window_->window.close();
    answer("leaving.session", "leaving.save");
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->window.isVisible() && window_->window.isWindowModified());
}

void LeavingTest::aSessionBeingSavedIsWaitedFor()
{
    editWhatCannotBeSaved();
    const auto edited = session().model();
    window_->find<QAction>("action.close").trigger();
    QTRY_VERIFY(isAsked("leaving.session"));
    emit window_->workbench.exporting().savingPicture().finished(); // told while the session is being written
    answer("leaving.session", "leaving.save");
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(session().model() == edited && window_->window.isWindowModified());
}

/// It counts as saved from the order on, and is lost if it cannot be written.
void LeavingTest::aSessionSavedJustNowIsWaitedFor()
{
    editWhatCannotBeSaved();
    const auto edited = session().model();
    window_->find<QAction>("action.saveSession").trigger();
    QVERIFY(window_->workbench.opening().sessionFile().saving().running() && !window_->window.isWindowModified());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(session().model() == edited);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(session().model() == edited && window_->window.isWindowModified());
    QVERIFY(!isAsked("leaving.saving"));
}

void LeavingTest::quittingWaitsForFilesBeingWritten()
{
    open(otherModel());
    const Viewport& viewport = window_->viewport();
    const std::filesystem::path picture = window_->folderPath() + "/large.png";
    for (int i = 0; i < 2; ++i)
        window_->workbench.exporting().savePicture(
            {.scene = viewport.scene(),
             .camera = viewport.camera(),
             .background = viewport.background(),
             .width = 1600,
             .height = 1200,
             .target = i == 0 ? picture : std::filesystem::path("/no/such/folder/a.png")});
    window_->window.close();
    QTRY_COMPARE_WITH_TIMEOUT(window_->messages().size(), 1, 60'000); // it failed, so that it has to be told
    QVERIFY(window_->window.isVisible());
    QCOMPARE(QImage(pathText(picture)).size(), QSize(1600, 1200));
    QVERIFY(window_->window.close());

    window_->window.show();
    const std::filesystem::path second = window_->folderPath() + "/second.png";
    window_->workbench.exporting().savePicture({.scene = viewport.scene(),
                                                .camera = viewport.camera(),
                                                .background = viewport.background(),
                                                .width = 1600,
                                                .height = 1200,
                                                .target = second});
    window_->window.close();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->window.isVisible(), 60'000);
    QCOMPARE(QImage(pathText(second)).size(), QSize(1600, 1200));
}

/// Of whatever was ordered at the same time (D5).
void LeavingTest::everyFailedSaveIsTold()
{
    open(otherModel());
    std::set<QString> files;
    const auto bad = [&files](const char* name) {
        files.insert(QString("/no/such/folder/") + name);
        return std::filesystem::path("/no/such/folder") / name;
    };
    Workbench& workbench = window_->workbench;
    workbench.exporting().saveText(bad("a.json"), "{}");
    workbench.opening().sessionFile().save(bad("b.tansession"), *workbench.opening().sessions().document());
    workbench.exporting().saveStatistics(bad("c.csv"));
    workbench.exporting().saveMesh(bad("d.vtu"));
    workbench.exporting().saveMesh(bad("e.vtu"));
    workbench.exporting().saveSurfaces(bad("f.stl"));
    workbench.exporting().loadText(bad("g.json"), [](const std::string&) { return Status(); });
    window_->window.open(window_->folder.filePath("missing.png"));
    session().setError(7); // another mesh is on its way
    workbench.exporting().saveMesh(bad("h.vtu"));
    workbench.opening().models().close();
    QVERIFY(!files.empty());
    for (const QString& file : files)
        QTRY_VERIFY2_WITH_TIMEOUT(window_->messages().join('\n').contains(file), qPrintable(file), 30'000);
}

/// It was closed while a dialog for the file was open.
void LeavingTest::whatIsOfAModelIsNotSavedWithoutOne()
{
    Exporting& exporting = window_->workbench.exporting();
    const QSignalSpy failed(&exporting, &Exporting::saveFailed);
    exporting.saveMesh(filePath(window_->folder.filePath("a.vtu")));
    exporting.saveSurfaces(filePath(window_->folder.filePath("b.stl")));
    exporting.saveStatistics(filePath(window_->folder.filePath("c.csv")));
    QCOMPARE(failed.count(), 3);
    QVERIFY(!exporting.saving());
}

void LeavingTest::savesDoNotStopEachOther()
{
    open(otherModel());
    const QSignalSpy meshes(&window_->workbench.exporting(), &Exporting::meshSaved);
    const QSignalSpy texts(&window_->workbench.exporting(), &Exporting::textSaved);
    QStringList files;
    const auto file = [&](const QString& name) {
        files.append(window_->folder.filePath(name));
        return filePath(files.last());
    };
    session().setError(6);
    for (const char* name : {"1.vtu", "2.vtu", "3.vtk"})
        window_->workbench.exporting().saveMesh(file(name));
    window_->workbench.exporting().saveSurfaces(file("4.stl"));
    for (const char* name : {"5.json", "6.json", "7.json"})
        window_->workbench.exporting().saveText(file(name), name);
    session().setError(2);
    QTRY_COMPARE_WITH_TIMEOUT(meshes.count(), 4, 30'000);
    QTRY_COMPARE(texts.count(), 3);
    for (const QString& each : files)
        QVERIFY2(QFileInfo(each).size() > 0, qPrintable(each));
    QCOMPARE(window_->messages(), QStringList());
}

QTEST_MAIN(LeavingTest)
#include "leaving_test.moc"
