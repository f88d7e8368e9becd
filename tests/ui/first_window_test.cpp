// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_files.h"
#include "ui/session/files.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QScreen>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

using namespace tetra;

/// The window, as it comes up for the first time, lies on its screen: of the usual sizes, with letters and lines of
/// once, one and a half times and twice their size. The screen is 1920 x 1080 pixels, or as the environment says:
/// TAN_TEST_SCREEN=1366x768, and Qt's QT_SCALE_FACTOR.
class FirstWindowTest : public QObject {
    Q_OBJECT
public:
    static void initMain();
private slots:
    void initTestCase();
    void theWindowLiesOnTheScreen();

private:
    void lookAt(const QString& when, const MainWindow& window);

    QTemporaryDir folder_;
    QString model_;
    QString volume_;
};

namespace {

constexpr QSize frame(8, 40); ///< that a window manager adds

QString text(QSize size)
{
    return QString("%1 x %2").arg(size.width()).arg(size.height());
}

} // namespace

/// Before the application, which reads it.
void FirstWindowTest::initMain()
{
    const QByteArray screen = qgetenv("TAN_TEST_SCREEN");
    const QList<QByteArray> sides = (screen.isEmpty() ? "1920x1080" : screen).split('x');
    const QString config = QDir::tempPath() + QString("/tan-screen-%1.json").arg(QCoreApplication::applicationPid());
    QFile file(config);
    if (!file.open(QIODevice::WriteOnly))
        qFatal("the screen cannot be described");
    file.write("{\"screens\": [{\"name\": \"the screen\", \"x\": 0, \"y\": 0, \"width\": " + sides[0] +
               ", \"height\": " + sides[1] + ", \"logicalDpi\": 96, \"logicalBaseDpi\": 96, \"dpr\": 1}]}");
    qputenv("QT_QPA_PLATFORM", "offscreen:configfile=" + config.toUtf8());
}

void FirstWindowTest::initTestCase()
{
    QFile::remove(QDir::tempPath() + QString("/tan-screen-%1.json").arg(QCoreApplication::applicationPid()));
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("first_window");
    const auto host = hostOfThisBuild();
    const std::filesystem::path folder = folder_.path().toStdString();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(10), folder).string());
    volume_ = QString::fromStdString(writeNrrd(sampleDataset(8), folder).string());
}

void FirstWindowTest::lookAt(const QString& when, const MainWindow& window)
{
    QCoreApplication::processEvents();
    const QSize room = window.screen()->availableSize() - frame;
    QStringList needed;
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>())
        needed << dock->objectName() + " " + text(dock->minimumSizeHint());
    QVERIFY2(
        window.width() <= room.width() && window.height() <= room.height(),
        qPrintable(QString("%1 it has %2 of %3; %4").arg(when, text(window.size()), text(room), needed.join(", "))));
}

void FirstWindowTest::theWindowLiesOnTheScreen()
{
    QSettings().clear();
    const auto host = hostOfThisBuild();
    Workbench workbench(*host, filePath(folder_.filePath("views")));
    MainWindow window(workbench, BackendChoice::Cpu);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    lookAt("at first", window);
    window.open(model_);
    QTRY_VERIFY(workbench.session().model());
    lookAt("with a model", window);
    for (QDockWidget* dock : window.findChildren<QDockWidget*>())
        if (dock->isVisible()) {
            dock->raise();
            lookAt(dock->objectName(), window);
        }
    window.open(volume_);
    QTRY_VERIFY(workbench.opening().datasets().dataset());
    lookAt("with a dataset", window);
    window.findChild<QAction*>("action.resetLayout")->trigger();
    lookAt("laid out anew", window);
}

QTEST_MAIN(FirstWindowTest)
#include "first_window_test.moc"
