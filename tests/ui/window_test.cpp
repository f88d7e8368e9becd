// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/host/model_building.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/opening/recent_files.h"
#include "ui/panels/build_panel.h"
#include "ui/widgets/mnemonics.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QProgressBar>
#include <QPushButton>
#include <QScopeGuard>
#include <QSet>
#include <QSignalSpy>
#include <QThread>
#include <QToolButton>
#include <QUrl>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <semaphore>

using namespace tetra;

namespace {

QByteArray contentOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

/// The window around the panels (R27): opening in every way, what goes wrong and how it is told, building with cancel,
/// the camera by mouse and keyboard, pictures, layout.
class WindowTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void emptyInvites();
    void droppedFilesAreOpened();
    void filesThatADesktopNamesAreOpened();
    void whatCannotBeOpenedIsToldAndStays_data();
    void whatCannotBeOpenedIsToldAndStays();
    void messagesAreNeverLost();
    void messagesOfAnotherFileGo();
    void allMessagesAreShownAndClosed();
    void aBuildIsCancelledAndLeavesNoFile();
    void aBuildIsWatchedWhileItGrows();
    void aBuildIsStoppedAndKept_data();
    void aBuildIsStoppedAndKept();
    void aBuildWithNothingToKeepSaysSo();
    void anInterruptedBuildGoesOn_data();
    void anInterruptedBuildGoesOn();
    void whatIsLeftIsGoneOnWithOrDeleted();
    void whatIsLeftOfOtherDataStays();
    void aBuildIsPaused();
    void aBuildThatCannotWriteSaysSo();
    void anExistingModelIsReplacedOnlyWithAWord();
    void aFolderThatDoesNotAnswerStopsNobody();
    void aBuilderThatThinksLongStopsNobody();
    void aMaximisedWindowIsOneTheNextTime();
    void anExistingModelIsOfferedFirst();
    void aFinishedModelIsNotReplacedByWhatIsKept();
    void theMouseMovesTheCamera();
    void theKeyboardMovesTheCamera();
    void namedViewsAndFit();
    void aPictureIsSaved();
    void recentFilesAreOffered();
    void closingTheModelLeavesTheInvitation();
    void closingLeadsToTheStartPage();
    void aDatasetBesideAModelStaysWhenThatIsClosed();
    void aModelTakesThePlaceOfADataset();
    void thePictureGoesWithItsTitle();
    void aDatasetThatIsNotBuiltIsSaid();
    void aPictureOfAnotherStateIsMarked();
    void theViewportFollowsThePalette();
    void theLayoutIsKept();
    void thePluginsAreListed();

private:
    void openSample();
    void setBlock(const QString& cells);
    /// Opens a dataset. Returns where its model goes.
    QString openDataset(const std::filesystem::path& path);
    /// What a program leaves that is stopped in the middle of such a build of the dataset that is open.
    void leaveBuild(const QString& builder, const ParameterValues& values, const QString& target);

    std::unique_ptr<WindowFixture> window_;
};

void WindowTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("window");
    QLocale::setDefault(QLocale::c());
}

void WindowTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
}

void WindowTest::cleanup()
{
    window_.reset();
}

void WindowTest::openSample()
{
    const auto path = buildSampleModel(*window_->host, sampleDataset(16), window_->folderPath());
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(window_->workbench.session().model() && window_->settled());
}

void WindowTest::setBlock(const QString& cells)
{
    auto& block = window_->find<QLineEdit>("build.option.block");
    block.setText(cells);
    emit block.editingFinished();
}

QString WindowTest::openDataset(const std::filesystem::path& path)
{
    window_->window.open(QString::fromStdString(path));
    if (!waitFor([&] {
            const auto& dataset = window_->workbench.opening().datasets().dataset();
            return dataset && dataset->source.path == path && window_->find<QWidget>("build.start").isVisible();
        }))
        qFatal("the dataset did not open");
    return window_->find<QLineEdit>("build.target").text();
}

void WindowTest::leaveBuild(const QString& builder, const ParameterValues& values, const QString& target)
{
    std::stop_source stop;
    const Progress progress(stop.get_token(), [&](double fraction, const Message&) {
        if (fraction > 0.25)
            stop.request_stop();
    });
    const auto built = buildModel(*window_->host, *window_->workbench.opening().datasets().dataset(),
                                  builder.toStdString(), values, filePath(target), progress, {.resume = true});
    QVERIFY(!built && built.error().kind == ErrorKind::Cancelled);
    QVERIFY(QDir(target + ".work").exists());
    // As it is found by a program that starts.
    auto& line = window_->find<QLineEdit>("build.target");
    line.clear();
    line.setText(target);
}

void WindowTest::emptyInvites()
{
    QVERIFY(window_->find<QWidget>("empty").isVisible());
    QVERIFY(window_->find<QPushButton>("empty.open").isVisible());
    QVERIFY(!window_->find<QWidget>("dock.build").isVisible());
    QVERIFY(!window_->find<QWidget>("messages").isVisible());
    QCOMPARE(window_->find<QLabel>("status.backend").text(), QString("CPU"));
}

void WindowTest::filesThatADesktopNamesAreOpened()
{
    const auto path = writeNrrd(sampleDataset(8), window_->folderPath());
    const auto place = path.parent_path() / "100 % of Ü.nrrd";
    std::filesystem::rename(path, place);
    window_->window.open(QString::fromLatin1(QUrl::fromLocalFile(QString::fromStdString(place)).toEncoded()));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->workbench.opening().datasets().dataset()->source.path, place);
}

void WindowTest::droppedFilesAreOpened()
{
    const auto path = writeNrrd(sampleDataset(8), window_->folderPath());
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path))});
    QDragEnterEvent enter({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_->window, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop({100, 100}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&window_->window, &drop);
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QVERIFY(window_->find<QWidget>("dock.build").isVisible());
    QCOMPARE(window_->find<QLabel>("build.facts").text(),
             QString("8 × 8 × 8 samples, spacing 1 × 1 × 1, uint8, values 0 to 192"));

    QMimeData text;
    text.setText("no file");
    QDragEnterEvent other({100, 100}, Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
    other.ignore();
    QCoreApplication::sendEvent(&window_->window, &other);
    QVERIFY(!other.isAccepted());
}

void WindowTest::whatCannotBeOpenedIsToldAndStays_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("content");
    QTest::newRow("missing") << "missing.nrrd" << QByteArray();
    QTest::newRow("empty model") << "empty.tan" << QByteArray("");
    QTest::newRow("no model") << "broken.tan" << QByteArray("this is no model at all");
    QTest::newRow("truncated volume") << "short.nrrd"
                                      << QByteArray("NRRD0004\ntype: uint8\ndimension: 3\nsizes: 9 9 9\n"
                                                    "encoding: raw\n\nabc");
    QTest::newRow("unknown") << "letter.txt" << QByteArray("Dear reader");
}

void WindowTest::whatCannotBeOpenedIsToldAndStays()
{
    QFETCH(QString, name);
    QFETCH(QByteArray, content);
    const QString path = window_->folder.filePath(name);
    if (!content.isNull()) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(content);
    }
    window_->window.open(path);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains(name), qPrintable(window_->messages().first()));
    QVERIFY(window_->find<QWidget>("messages").isVisible());
    QVERIFY(window_->find<QLabel>("message.text").textInteractionFlags().testFlag(Qt::TextSelectableByMouse));
    QVERIFY(window_->find<QWidget>("empty").isVisible());
    QTest::mouseClick(&window_->find<QToolButton>("message.close"), Qt::LeftButton);
    QVERIFY(!window_->find<QWidget>("messages").isVisible());
}

void WindowTest::messagesAreNeverLost()
{
    auto& bar = window_->find<MessageBar>("messages");
    for (const char* text : {"a", "b", "c", "d", "d"})
        bar.add(text);
    QCOMPARE(bar.texts(), (QStringList{"d", "c", "b", "a"}));
    QVERIFY(window_->find<QWidget>("messages.more").isVisible());
    for (int left = 4; left > 0; --left) {
        QCOMPARE(bar.texts().size(), left);
        QTest::mouseClick(&window_->find<QToolButton>("message.close"), Qt::LeftButton);
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
    QVERIFY(!bar.isVisible());
}

void WindowTest::messagesOfAnotherFileGo()
{
    const QString missing = window_->folder.filePath("missing.nrrd");
    window_->window.open(missing);
    QTRY_COMPARE(window_->messages().size(), 1);
    openSample();
    QCOMPARE(window_->messages(), QStringList());
    window_->window.open(missing);
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->window.open(window_->folder.filePath("missing, too.nrrd"));
    QTRY_COMPARE(window_->messages().size(), 2); // nothing else was opened
    const auto rows = window_->window.findChildren<MessageRow*>();
    QCOMPARE(std::ranges::count_if(rows, [](const MessageRow* row) { return row->isVisible(); }), 1); // of the last
    QVERIFY(window_->find<QWidget>("messages.more").isVisible());
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->messages(), QStringList());
    window_->window.open(missing);
    QTRY_COMPARE(window_->messages().size(), 1);
    window_->find<QAction>("action.close").trigger();
    QCOMPARE(window_->messages(), QStringList());
    // What is lost unless somebody does something stays.
    openSample();
    window_->workbench.exporting().saveText("/no/such/folder/text.json", "{}");
    QTRY_COMPARE(window_->messages().size(), 1);
    openSample();
    QTRY_VERIFY(!window_->workbench.opening().reading().running());
    QCOMPARE(window_->messages().size(), 1);
}

void WindowTest::allMessagesAreShownAndClosed()
{
    auto& bar = window_->find<MessageBar>("messages");
    bar.add("a");
    QVERIFY(!window_->find<QAbstractButton>("messages.closeAll").isVisible());
    for (int message = 0; message < 40; ++message)
        bar.add(QString("message %1").arg(message));
    const auto shown = [&bar] {
        return std::ranges::count_if(bar.findChildren<MessageRow*>(),
                                     [](const MessageRow* row) { return row->isVisible(); });
    };
    QCOMPARE(shown(), 3);
    const auto& list = *bar.findChild<MessageList*>();
    QTRY_COMPARE(list.viewport()->height(), list.widget()->sizeHint().height()); // nothing is cut off
    const int before = bar.height();
    auto& more = window_->find<QAbstractButton>("messages.more");
    QVERIFY(more.text().contains("38") && more.focusPolicy() != Qt::NoFocus);
    more.click();
    QCOMPARE(shown(), 41);
    QTRY_VERIFY(bar.height() > before);
    QVERIFY2(bar.height() < 0.6 * window_->window.height(), qPrintable(QString::number(bar.height())));
    more.click();
    QCOMPARE(shown(), 3);
    QTRY_COMPARE(bar.height(), before);
    window_->find<QAbstractButton>("messages.closeAll").click();
    QCOMPARE(window_->messages(), QStringList());
    QVERIFY(!bar.isVisible());
}

void WindowTest::aBuildIsCancelledAndLeavesNoFile()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(96), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    const QString target = window_->find<QLineEdit>("build.target").text();
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_VERIFY(window_->find<QWidget>("build.progress").isVisible());
    QVERIFY(!window_->find<QWidget>("build.target").isEnabled());
    QTRY_VERIFY(window_->find<QProgressBar>("build.progress").value() > 0);
    QTest::mouseClick(&window_->find<QPushButton>("build.cancel"), Qt::LeftButton);
    QTRY_VERIFY(!window_->workbench.building().running());
    QVERIFY(!QFile::exists(target));
    QCOMPARE(window_->messages(), QStringList()); // who cancels knows
    QVERIFY(window_->find<QPushButton>("build.start").isVisible());
    QVERIFY(window_->find<QWidget>("build.target").isEnabled());
}

void WindowTest::aBuildIsWatchedWhileItGrows()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(96), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    const QString target = window_->find<QLineEdit>("build.target").text();
    std::vector<std::uint32_t> sites;
    const Session& session = window_->workbench.session();
    connect(&session, &Session::modelGrown, this, [&] { sites.push_back(session.model()->siteCount()); });
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_VERIFY(session.model() != nullptr);
    window_->find<QToolButton>("transfer.save").click();
    auto& dialog = window_->find<QFileDialog>("transferSaveDialog");
    QCOMPARE(dialog.directory().absolutePath(), QFileInfo(target).absolutePath()); // not where the looks go
    dialog.reject();
    QVERIFY(window_->workbench.building().running());
    QTRY_VERIFY(window_->settled());
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_COMPARE(QString::fromStdString(session.model()->path().string()), target);
    QVERIFY(!sites.empty() && std::ranges::is_sorted(sites));
    QCOMPARE(session.model()->siteCount(), sites.back());
    QCOMPARE(window_->messages(), QStringList());
}

void WindowTest::aBuildIsStoppedAndKept_data()
{
    QTest::addColumn<QString>("block");
    QTest::newRow("as a whole") << "none";
    QTest::newRow("in blocks, B8") << "16";
}

void WindowTest::aBuildIsStoppedAndKept()
{
    QFETCH(QString, block);
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(96), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    setBlock(block);
    const QString target = window_->find<QLineEdit>("build.target").text();
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_VERIFY(window_->workbench.session().model() != nullptr);
    QVERIFY(window_->workbench.building().canKeepBuild());
    QTest::mouseClick(&window_->find<QPushButton>("build.keep"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_COMPARE(QString::fromStdString(window_->workbench.session().model()->path().string()), target);
    QVERIFY(window_->workbench.session().model()->finalKey() > 0);
    QVERIFY(window_->find<QLabel>("accuracy.limit").text().contains("nothing finer"));
    QCOMPARE(window_->messages(), QStringList());
}

/// Stopped at once, before there is a mesh.
void WindowTest::aBuildWithNothingToKeepSaysSo()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(64), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    setBlock("8");
    const QString target = window_->find<QLineEdit>("build.target").text();
    QTRY_VERIFY(!window_->find<BuildPanel>("build").looking());
    window_->find<QPushButton>("build.start").click();
    QVERIFY(!window_->workbench.building().canKeepBuild());
    window_->find<QPushButton>("build.keep").click();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 60'000);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("nothing to keep"), qPrintable(window_->messages().first()));
    QVERIFY(!QFile::exists(target));
}

void WindowTest::anInterruptedBuildGoesOn_data()
{
    QTest::addColumn<QString>("builder");
    QTest::addColumn<QString>("block");
    QTest::newRow("refinement, B6") << "refinement"
                                    << "none";
    QTest::newRow("in blocks, B6") << "refinement"
                                   << "11";
    QTest::newRow("decimation, B6") << "decimation"
                                    << "";
}

/// With its builder and its options, and to the same bytes.
void WindowTest::anInterruptedBuildGoesOn()
{
    QFETCH(QString, builder);
    QFETCH(QString, block);
    const bool refines = builder == "refinement";
    const ParameterValues values =
        refines ? ParameterValues{{"error", 0.25}, {"block", block.toStdString()}} : ParameterValues{{"finest", 0.25}};
    const QString target = openDataset(writeNrrd(sampleDataset(32), window_->folderPath()));
    const Opening& opening = window_->workbench.opening();
    const std::string reference = window_->folderPath() + "/reference.tan";
    QVERIFY(buildModel(*window_->host, *opening.datasets().dataset(), builder.toStdString(), values, reference, {},
                       {.imported = opening.datasets().importOptions()}));
    leaveBuild(builder, values, target);

    auto& start = window_->find<QPushButton>("build.start");
    QTRY_VERIFY(window_->find<QWidget>("build.interrupted").isVisible());
    QCOMPARE(window_->find<QComboBox>("build.builder").currentData().toString(), builder);
    QCOMPARE(window_->find<QDoubleSpinBox>(refines ? "build.option.error" : "build.option.finest").value(), 0.25);
    QVERIFY(start.accessibleDescription().contains("continue where it stopped"));
    QCOMPARE(start.text(), QString("Resume &Build"));
    const auto& resume = window_->find<QCheckBox>("build.resume");
    QVERIFY(resume.isChecked() && !resume.isEnabled());
    start.setFocus();
    QTest::keyClick(&start, Qt::Key_Space);
    const Session& session = window_->workbench.session();
    QTRY_VERIFY_WITH_TIMEOUT(session.model() && pathText(session.model()->path()) == target, 30'000);
    QTRY_VERIFY(!window_->workbench.building().running());
    QVERIFY(contentOf(target) == contentOf(QString::fromStdString(reference)));
    QVERIFY(!QDir(target + ".work").exists());
    QTRY_VERIFY(!window_->find<QWidget>("build.interrupted").isVisible());
    QCOMPARE(window_->messages(), QStringList());
}

/// B6: what does not fit is refused, and goes when the user says so.
void WindowTest::whatIsLeftIsGoneOnWithOrDeleted()
{
    const QString target = openDataset(writeNrrd(sampleDataset(32), window_->folderPath()));
    leaveBuild("refinement", {}, target);
    QTRY_VERIFY(window_->find<QWidget>("build.interrupted").isVisible());
    auto& start = window_->find<QPushButton>("build.start");
    auto& error = window_->find<QDoubleSpinBox>("build.option.error");
    error.setValue(5);
    QVERIFY(!start.isEnabled());
    QVERIFY(window_->find<QLabel>("build.interrupted.text").text().contains("different options"));
    error.setValue(0);
    QVERIFY(start.isEnabled());

    const QString state = target + ".work/state";
    QVERIFY(QFile::resize(state, QFileInfo(state).size() / 2));
    start.click();
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY2(window_->messages().first().contains("is damaged"), qPrintable(window_->messages().first()));
    QVERIFY(QFile::exists(state));
    QTRY_VERIFY(window_->find<QWidget>("build.interrupted").isVisible());

    auto& anew = window_->find<QPushButton>("build.beginAnew");
    QVERIFY(!anew.accessibleDescription().isEmpty());
    anew.setFocus();
    QTest::keyClick(&anew, Qt::Key_Space);
    QTRY_VERIFY(!window_->find<QWidget>("build.interrupted").isVisible());
    QVERIFY(!QDir(target + ".work").exists());
    QCOMPARE(start.text(), QString("&Build"));
    QTRY_VERIFY(start.isEnabled() && start.hasFocus());
    const auto& resume = window_->find<QCheckBox>("build.resume");
    QVERIFY(!resume.isChecked() && resume.isEnabled());
}

void WindowTest::whatIsLeftOfOtherDataStays()
{
    const std::filesystem::path data = writeNrrd(sampleDataset(32), window_->folderPath());
    const QString target = openDataset(data);
    leaveBuild("refinement", {{"error", 0.25}}, target);
    const std::filesystem::path other = window_->folderPath() + "/other";
    std::filesystem::create_directory(other);
    openDataset(writeNrrd(sampleDataset(23), other));
    QTRY_VERIFY(!window_->find<QWidget>("build.interrupted").isVisible());
    window_->find<QLineEdit>("build.target").setText(target);
    QTRY_VERIFY(window_->find<QWidget>("build.interrupted").isVisible());
    QVERIFY(!window_->find<QWidget>("build.start").isEnabled());
    openDataset(data);
    QTRY_VERIFY(window_->find<QWidget>("build.start").isEnabled());
    QCOMPARE(window_->find<QDoubleSpinBox>("build.option.error").value(), 0.25);
}

/// B6: it can be gone on with by another program; one that is cancelled leaves nothing.
void WindowTest::aBuildIsPaused()
{
    const std::filesystem::path data = writeNrrd(sampleDataset(96), window_->folderPath());
    const QString target = openDataset(data);
    window_->find<QCheckBox>("build.resume").click();
    window_->find<QPushButton>("build.start").click();
    QTRY_VERIFY_WITH_TIMEOUT(window_->workbench.building().canKeepBuild(), 30'000);
    QTest::mouseClick(&window_->find<QPushButton>("build.pause"), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 30'000);
    QVERIFY(!QFile::exists(target) && QFile::exists(target + ".work/state"));
    QTRY_VERIFY(window_->find<QWidget>("build.interrupted").isVisible());
    QCOMPARE(window_->messages(), QStringList());

    window_->window.close();
    WindowFixture again;
    again.window.show();
    again.window.open(QString::fromStdString(data));
    QTRY_VERIFY(again.find<QWidget>("build.interrupted").isVisible());
    QVERIFY(again.find<QCheckBox>("build.resume").isChecked());
    again.find<QPushButton>("build.start").click();
    QTRY_VERIFY_WITH_TIMEOUT(again.workbench.building().canKeepBuild(), 30'000);
    again.find<QPushButton>("build.cancel").click();
    QTRY_VERIFY_WITH_TIMEOUT(!again.workbench.building().running(), 30'000);
    QVERIFY(!QFile::exists(target) && !QDir(target + ".work").exists());
    QTRY_VERIFY(!again.find<QWidget>("build.interrupted").isVisible());
    QVERIFY(again.find<QCheckBox>("build.resume").isChecked()); // as the user has left it
}

void WindowTest::aBuildThatCannotWriteSaysSo()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    window_->find<QLineEdit>("build.target").setText(window_->folder.filePath("no/such/folder/model.tan"));
    QTest::mouseClick(&window_->find<QPushButton>("build.start"), Qt::LeftButton);
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("no/such/folder"));
    QVERIFY(window_->find<QPushButton>("build.start").isVisible());
}

void WindowTest::anExistingModelIsReplacedOnlyWithAWord()
{
    buildSampleModel(*window_->host, sampleDataset(8), window_->folderPath());
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QTRY_VERIFY(window_->find<QLabel>("build.targetHint").isVisible());
    QCOMPARE(window_->find<QPushButton>("build.start").text(), QString("&Build and Replace"));
    window_->find<QLineEdit>("build.target").setText(window_->folder.filePath("other.tan"));
    QTRY_VERIFY(!window_->find<QLabel>("build.targetHint").isVisible());
    QVERIFY(!window_->find<QPushButton>("build.openExisting").isVisible());
    QCOMPARE(window_->find<QWidget>("build").focusProxy()->objectName(), QString("build.start"));
}

/// At each letter of a file's name it is looked for, which may take as long as it likes. Nothing is built before it is
/// known what would be replaced, and not if that is more than what was agreed to.
void WindowTest::aFolderThatDoesNotAnswerStopsNobody()
{
    std::counting_semaphore<> answers(0);
    std::atomic<int> looks = 0;
    BuildPanel panel(window_->workbench, [&](const std::filesystem::path&) {
        ++looks;
        answers.acquire();
        return TargetFacts{.exists = true, .isModel = true};
    });
    const auto end = qScopeGuard([&] { answers.release(1000); });
    panel.show();
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_COMPARE(looks.load(), 1);
    auto& target = *panel.findChild<QLineEdit*>("build.target");
    auto& start = *panel.findChild<QPushButton*>("build.start");
    const auto& hint = *panel.findChild<QLabel*>("build.targetHint");
    target.clear();
    QTest::keyClicks(&target, window_->folder.filePath("model.tan"));
    QCOMPARE(target.text(), window_->folder.filePath("model.tan"));
    QCOMPARE(start.text(), QString("&Build"));
    start.click();
    QCoreApplication::processEvents();
    QVERIFY(!window_->workbench.building().running());
    QCOMPARE(looks.load(), 1);
    answers.release(2); // the first look, and of those at each letter only the last one
    QTRY_VERIFY(hint.isVisible());
    QCOMPARE(looks.load(), 2);
    QCOMPARE(start.text(), QString("&Build and Replace"));
    QVERIFY(!window_->workbench.building().running());
    start.click();
    QTRY_VERIFY(QFile::exists(target.text()) && !window_->workbench.building().running());
}

/// A builder that takes its time to say what a build takes holds up nobody; but nothing is built before it is known.
void WindowTest::aBuilderThatThinksLongStopsNobody()
{
    std::counting_semaphore<> answers(0);
    std::atomic<int> questions = 0;
    std::atomic<bool> isElsewhere = true;
    BuildPanel panel(window_->workbench, &lookAtTarget, [&](const BuildQuestion& question) {
        ++questions;
        isElsewhere = isElsewhere && QThread::currentThread() != QCoreApplication::instance()->thread();
        answers.acquire();
        return outlookOf(question);
    });
    const auto end = qScopeGuard([&] { answers.release(1000); });
    panel.show();
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_COMPARE(questions.load(), 1);
    auto& error = *panel.findChild<QDoubleSpinBox*>("build.option.error");
    const auto& size = *panel.findChild<QLabel*>("build.detail.good.size");
    const auto& estimate = *panel.findChild<QLabel*>("build.estimate");
    for (const double percent : {1.0, 2.0, 3.0})
        error.setValue(percent); // each asks anew
    panel.findChild<QPushButton*>("build.start")->click();
    QCoreApplication::processEvents();
    QVERIFY(!window_->workbench.building().running() && size.text().isEmpty() && estimate.text().isEmpty());
    QCOMPARE(questions.load(), 1);
    answers.release(2); // the first question, and of the others only the last one
    QTRY_VERIFY(!panel.looking());
    QCOMPARE(questions.load(), 2);
    QVERIFY(isElsewhere && size.text().contains(" s") && estimate.text().contains("memory"));
    QTRY_VERIFY(window_->workbench.session().model() && !window_->workbench.building().running());
}

/// Also after a program that could not end as it should.
void WindowTest::aMaximisedWindowIsOneTheNextTime()
{
    QSettings().remove("window");
    window_->window.showMaximized();
    QTRY_VERIFY(QSettings().contains("window/geometry"));
    WindowFixture next; // the first one is still there
    next.window.show();
    QVERIFY(next.window.isMaximized());
}

/// Data whose model lies beside them: Enter opens that, and nothing is built.
void WindowTest::anExistingModelIsOfferedFirst()
{
    const auto model = buildSampleModel(*window_->host, sampleDataset(8), window_->folderPath());
    const auto written = std::filesystem::last_write_time(model);
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    auto& existing = window_->find<QPushButton>("build.openExisting");
    QTRY_VERIFY(existing.isVisible());
    QTRY_VERIFY(existing.y() < window_->find<QWidget>("build.start").y());
    QCOMPARE(window_->find<QWidget>("build").focusProxy(), &existing);
    QCOMPARE(window_->window.focusWidget(), &existing);
    QTest::keyClick(window_->window.focusWidget(), Qt::Key_Return);
    QTRY_VERIFY(window_->workbench.session().model() != nullptr);
    QCOMPARE(window_->workbench.session().model()->path(), model);
    QVERIFY(std::filesystem::last_write_time(model) == written);
    QVERIFY(!window_->find<QWidget>("dock.build").isVisible());
    QCOMPARE(window_->messages(), QStringList());
}

/// The panel's own button asks before, and whatever is chosen the finished model is as it was.
void WindowTest::aFinishedModelIsNotReplacedByWhatIsKept()
{
    const auto dataset = writeNrrd(sampleDataset(96), window_->folderPath());
    std::filesystem::path finished = dataset;
    finished.replace_extension(".tan");
    std::filesystem::rename(buildSampleModel(*window_->host, sampleDataset(8), window_->folderPath()), finished);
    const QByteArray before = contentOf(pathText(finished));
    window_->window.open(pathText(dataset));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    QCOMPARE(window_->find<QLineEdit>("build.target").text(), pathText(finished));
    QTRY_VERIFY(!window_->find<BuildPanel>("build").looking());
    window_->find<QPushButton>("build.start").click();
    QTRY_VERIFY(window_->workbench.building().canKeepBuild());
    const auto question = [&]() -> QMessageBox* {
        const auto boxes = window_->window.findChildren<QMessageBox*>("leaving.keeping");
        return boxes.isEmpty() ? nullptr : boxes.last();
    };
    window_->find<QPushButton>("build.keep").click();
    QVERIFY(question() != nullptr && question()->isVisible());
    QCOMPARE(question()->defaultButton()->objectName(), QString("leaving.cancel"));
    const QString text = question()->text() + question()->informativeText();
    QVERIFY2(text.contains(pathText(finished.filename())) && text.contains("named after its error"), qPrintable(text));
    QTest::keyClick(question(), Qt::Key_Escape);
    QVERIFY(window_->workbench.building().running());
    QTRY_VERIFY(question() == nullptr);
    window_->find<QPushButton>("build.keep").click();
    QVERIFY(question() != nullptr);
    question()->findChild<QAbstractButton*>("leaving.keep")->click();
    QTRY_VERIFY_WITH_TIMEOUT(!window_->workbench.building().running(), 30'000);
    QTRY_COMPARE(window_->messages().size(), 1);
    const auto kept = window_->workbench.session().model()->path();
    QVERIFY2(window_->messages().first().contains(pathText(kept.filename())), qPrintable(window_->messages().first()));
    QVERIFY(kept != finished && kept.parent_path() == finished.parent_path());
    QVERIFY2(kept.filename().string().ends_with("-percent.tan"), kept.c_str());
    QVERIFY(contentOf(pathText(finished)) == before);
}

void WindowTest::theMouseMovesTheCamera()
{
    openSample();
    Viewport& viewport = window_->viewport();
    const auto drag = [&](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        QTest::mousePress(&viewport, button, modifiers, {100, 100});
        QMouseEvent move(QEvent::MouseMove, QPointF(140, 100), viewport.mapToGlobal(QPointF(140, 100)), Qt::NoButton,
                         button, modifiers);
        QCoreApplication::sendEvent(&viewport, &move);
        QTest::mouseRelease(&viewport, button, modifiers, {140, 100});
    };
    Camera before = viewport.camera();
    drag(Qt::LeftButton, {});
    QVERIFY(viewport.camera().azimuth != before.azimuth);
    QCOMPARE(viewport.camera().target, before.target);
    before = viewport.camera();
    drag(Qt::MiddleButton, {});
    QCOMPARE(viewport.camera().azimuth, before.azimuth);
    QVERIFY(viewport.camera().target != before.target);
    before = viewport.camera();
    drag(Qt::LeftButton, Qt::ShiftModifier);
    QVERIFY(viewport.camera().target != before.target);
    QVERIFY(!viewport.settled());
    QTRY_VERIFY(viewport.settled()); // the fine picture comes by itself
    QCOMPARE(viewport.picture().size(), viewport.size());
}

void WindowTest::theKeyboardMovesTheCamera()
{
    openSample();
    Viewport& viewport = window_->viewport();
    const Camera before = viewport.camera();
    const auto pressed = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&viewport, key, modifiers);
        return viewport.camera();
    };
    constexpr double step = 5, fine = 0.2 * step;
    // The camera goes where the arrow points, and nothing else changes.
    QCOMPARE(pressed(Qt::Key_Left), turned(before, -step, 0));
    QCOMPARE(pressed(Qt::Key_Up), turned(before, -step, step));
    QCOMPARE(pressed(Qt::Key_Right), turned(before, 0, step));
    QCOMPARE(pressed(Qt::Key_Down), before);
    QCOMPARE(pressed(Qt::Key_Right, Qt::ControlModifier), turned(before, fine, 0));
    viewport.setCamera(before);
    QCOMPARE(pressed(Qt::Key_Left, Qt::ShiftModifier), panned(before, -0.05, 0));
    viewport.setCamera(before);
    QCOMPARE(pressed(Qt::Key_Right, Qt::AltModifier), rolled(before, step));
    viewport.setCamera(before);
    QCOMPARE(pressed(Qt::Key_Plus), zoomed(before, std::pow(1.15, -1)));
    viewport.setCamera(before);
    QCOMPARE(pressed(Qt::Key_Minus), zoomed(before, 1.15));
}

void WindowTest::namedViewsAndFit()
{
    openSample();
    Viewport& viewport = window_->viewport();
    window_->find<QAction>("action.view.top").trigger();
    QCOMPARE(viewport.camera().elevation, 90.0);
    window_->find<QAction>("action.fit").trigger();
    const double distance = viewport.camera().distance;
    QTest::keyClick(&viewport, Qt::Key_Minus);
    window_->find<QAction>("action.fit").trigger();
    QVERIFY(std::abs(viewport.camera().distance - distance) < 1e-9 * distance);
    window_->find<QAction>("action.perspective").trigger();
    QVERIFY(!viewport.camera().perspective);
}

void WindowTest::aPictureIsSaved()
{
    openSample();
    const Viewport& viewport = window_->viewport();
    const QString path = window_->folder.filePath("picture.png");
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::pictureSaved);
    window_->workbench.exporting().savePicture({.scene = viewport.scene(),
                                                .camera = viewport.camera(),
                                                .background = viewport.background(),
                                                .width = 320,
                                                .height = 200,
                                                .target = path.toStdString()});
    QTRY_COMPARE(saved.count(), 1);
    QCOMPARE(QImage(path).size(), QSize(320, 200));
    window_->workbench.exporting().savePicture({.scene = viewport.scene(),
                                                .camera = viewport.camera(),
                                                .background = viewport.background(),
                                                .width = 320,
                                                .height = 200,
                                                .target = "/no/such/folder/picture.png"});
    QTRY_COMPARE(window_->messages().size(), 1);
}

void WindowTest::recentFilesAreOffered()
{
    openSample();
    auto& menu = window_->find<QMenu>("menu.recent");
    emit menu.aboutToShow();
    QCOMPARE(withoutMnemonic(menu.actions().first()->text()), QString("c60.tan"));
    QVERIFY(QFile::remove(recentFiles().first()));
    QVERIFY(recentFiles().isEmpty());
}

void WindowTest::closingTheModelLeavesTheInvitation()
{
    openSample();
    QVERIFY(!window_->find<QWidget>("empty").isVisible());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(window_->find<QWidget>("empty").isVisible());
    QVERIFY(!window_->find<QLabel>("status.sites").isVisible());
    QVERIFY(!window_->find<QWidget>("accuracy").isEnabled());
    QVERIFY(!window_->viewport().scene());
}

/// Model and dataset are one thing to who has built the one of the other.
void WindowTest::closingLeadsToTheStartPage()
{
    const auto& close = window_->find<QAction>("action.close");
    const auto isStart = [this] {
        return window_->find<QWidget>("empty.open").isVisible() && !window_->find<QWidget>("dock.build").isVisible();
    };
    QVERIFY(isStart() && !close.isEnabled());
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->find<QWidget>("dock.build").isVisible());
    QVERIFY(!isStart());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(isStart() && !close.isEnabled());

    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->find<QWidget>("dock.build").isVisible());
    window_->find<QPushButton>("build.start").click();
    QTRY_VERIFY(window_->workbench.session().model() && !window_->workbench.building().running());
    QTRY_VERIFY(!window_->find<QWidget>("dock.build").isVisible());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(isStart());
}

void WindowTest::aDatasetBesideAModelStaysWhenThatIsClosed()
{
    openSample();
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    window_->find<QAction>("action.dock.build").trigger(); // away, to see more of the model
    QVERIFY(!window_->find<QWidget>("dock.build").isVisible());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(!window_->workbench.session().model());
    QVERIFY(window_->find<QWidget>("build.start").isVisible());
    window_->find<QAction>("action.close").trigger();
    QVERIFY(window_->find<QWidget>("empty.open").isVisible());
    QVERIFY(!window_->find<QWidget>("dock.build").isVisible());
}

/// The panel for builds is not left with data that the user has turned away from.
void WindowTest::aModelTakesThePlaceOfADataset()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->find<QWidget>("dock.build").isVisible());
    openSample();
    QVERIFY(!window_->workbench.opening().datasets().dataset());
    QVERIFY(!window_->find<QWidget>("dock.build").isVisible());
}

/// From the moment that the title names another model, nothing of the old one is seen.
void WindowTest::thePictureGoesWithItsTitle()
{
    openSample();
    Dataset other = sampleDataset(8);
    other.source.name = "other";
    std::filesystem::create_directory(window_->folderPath() + "/other");
    const auto path = buildSampleModel(*window_->host, other, window_->folderPath() + "/other");
    std::filesystem::rename(path, window_->folderPath() + "/other.tan");
    const QImage before = window_->viewport().picture();
    const auto colours = [](const QImage& image) {
        QSet<QRgb> found;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                found.insert(image.pixel(x, y));
        return found.size();
    };
    QVERIFY(colours(before) > 10);
    bool isEmpty = false;
    bool isQuiet = false;
    // After the window has heard of it, and before a scene of the new model can be there.
    const auto changed = connect(&window_->workbench.session(), &Session::modelChanged, this, [&] {
        QVERIFY(window_->window.windowTitle().startsWith("other"));
        isEmpty = colours(window_->viewport().picture()) <= 1;
        isQuiet =
            !window_->find<QLabel>("status.sites").isVisible() && !window_->find<QLabel>("status.frame").isVisible();
    });
    window_->window.open(QString::fromStdString(window_->folderPath() + "/other.tan"));
    QTRY_VERIFY(window_->window.windowTitle().startsWith("other"));
    QTRY_VERIFY(window_->settled());
    QVERIFY(isEmpty);
    QVERIFY(isQuiet);
    disconnect(changed);
}

/// The model that is open stays, and it is said that it is not that of the dataset.
void WindowTest::aDatasetThatIsNotBuiltIsSaid()
{
    const auto& notice = window_->find<QWidget>("viewport.notice");
    openSample();
    QVERIFY(!notice.isVisible());
    Dataset dataset = sampleDataset(8);
    const std::filesystem::path file = writeNrrd(dataset, window_->folderPath());
    std::filesystem::rename(file, window_->folderPath() + "/another.nrrd");
    window_->window.open(window_->folder.filePath("another.nrrd"));
    QTRY_VERIFY(notice.isVisible());
    const QString text = notice.accessibleName();
    QVERIFY2(text.contains("another.nrrd has not been built yet") && text.contains("c60.tan"), qPrintable(text));
    window_->find<QPushButton>("build.start").click();
    QTRY_VERIFY(window_->workbench.session().model() && !window_->workbench.building().running());
    QTRY_VERIFY(window_->window.windowTitle().startsWith("another.tan"));
    QVERIFY(!notice.isVisible());
}

/// A picture that stays because the next one could not be made does not pass for that.
void WindowTest::aPictureOfAnotherStateIsMarked()
{
    openSample();
    const auto& notice = window_->find<QWidget>("viewport.notice");
    emit window_->workbench.scenes().sceneBuilder().failed({ErrorKind::OutOfResource, "There is not enough memory."});
    QTRY_VERIFY(notice.isVisible());
    QVERIFY2(notice.accessibleName().contains("does not show the current settings"),
             qPrintable(notice.accessibleName()));
    window_->workbench.session().setError(5);
    QTRY_VERIFY(window_->settled() && window_->workbench.session().showsQuery());
    QVERIFY(!notice.isVisible());
}

void WindowTest::theViewportFollowsThePalette()
{
    const float light = window_->viewport().background().red;
    QPalette dark;
    dark.setColor(QPalette::Window, QColor(40, 40, 40));
    dark.setColor(QPalette::WindowText, Qt::white);
    const QPalette before = QApplication::palette();
    QApplication::setPalette(dark);
    QTRY_VERIFY(window_->viewport().background().red < 0.5F);
    QApplication::setPalette(before);
    QTRY_COMPARE(window_->viewport().background().red, light);
}

void WindowTest::theLayoutIsKept()
{
    window_->find<QAction>("action.dock.isovalues").trigger();
    window_->window.close();
    WindowFixture next;
    next.window.show();
    QVERIFY(!next.find<QWidget>("dock.isovalues").isVisible());
    QVERIFY(next.find<QWidget>("dock.accuracy").isVisible());
    next.find<QAction>("action.resetLayout").trigger();
    QVERIFY(next.find<QWidget>("dock.isovalues").isVisible());
}

void WindowTest::thePluginsAreListed()
{
    window_->find<QAction>("action.plugins").trigger();
    QVERIFY(window_->find<QWidget>("pluginWindow").isVisible());
}

QTEST_MAIN(WindowTest)
#include "window_test.moc"
