// SPDX-License-Identifier: GPL-3.0-or-later
/// Help finds the manual beside the program, and says what to do where it is not.
#include "tests/ui/window_fixture.h"
#include "ui/window/help_actions.h"

#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTemporaryDir>
#include <QTest>

namespace tetra {

/// In place of a web browser.
class Browser : public QObject {
    Q_OBJECT
public:
    Browser() { QDesktopServices::setUrlHandler("file", this, "open"); }
    ~Browser() override { QDesktopServices::unsetUrlHandler("file"); }
    QList<QUrl> opened;
public slots:
    void open(const QUrl& url) { opened.append(url); }
};

class ManualTest : public QObject {
    Q_OBJECT

    static void makeManual(const QString& prefix)
    {
        QVERIFY(QDir().mkpath(prefix + "/bin"));
        QVERIFY(QDir().mkpath(prefix + "/share/doc/tan/manual"));
        QFile page(prefix + "/share/doc/tan/manual/index.html");
        QVERIFY(page.open(QIODevice::WriteOnly));
    }

    /// Whether a line of a table begins with the cell, and its other cells hold a sentence.
    static bool isExplained(const QString& manual, const QString& cell)
    {
        constexpr int shortestSentence = 20;
        const qsizetype line = manual.indexOf("\n| " + cell + " |");
        if (line < 0)
            return false;
        QString rest = manual.mid(line + cell.size() + 5);
        rest.truncate(rest.indexOf('\n'));
        return rest.endsWith('|') && rest.chopped(1).trimmed().size() >= shortestSentence;
    }

private slots:
    void theManualBesideTheProgramIsOpened()
    {
        const QTemporaryDir folder;
        const QString prefix = folder.path() + "/a place";
        makeManual(prefix);
        Browser browser;
        QCOMPARE(openManual(prefix + "/bin"), QString());
        QCOMPARE(browser.opened, {QUrl::fromLocalFile(prefix + "/share/doc/tan/manual/index.html")});
    }

    void withoutAManualItSaysWhatToInstall()
    {
        const QTemporaryDir folder;
        Browser browser;
        const QString text = openManual(folder.path() + "/bin");
        QVERIFY2(text.contains("python3-sphinx"), qPrintable(text));
        QVERIFY(browser.opened.isEmpty());
    }

    /// From the menu: either the page of the build is opened, or the window says why not.
    void theMenuHasIt()
    {
        const WindowFixture fixture;
        Browser browser;
        fixture.find<QAction>("action.manual").trigger();
        const bool built = !manualPage(QCoreApplication::applicationDirPath()).isEmpty();
        QCOMPARE(browser.opened.size(), built ? 1 : 0);
        QCOMPARE(fixture.messages().join(' ').contains("python3-sphinx"), !built);
    }

    /// What a user meets stands in the manual's tables: each panel, each entry of the menus that opens a dialog.
    void everyPanelAndDialogIsExplained()
    {
        QFile file(TAN_SOURCE_DIR "/docs/manual.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString manual = QString::fromUtf8(file.readAll());
        const WindowFixture fixture;
        const auto docks = fixture.window.findChildren<QDockWidget*>();
        QVERIFY(docks.size() >= 8);
        QStringList without;
        const auto look = [&](const QString& cell) {
            if (!isExplained(manual, cell))
                without.append(cell);
        };
        for (const QDockWidget* dock : docks)
            look("**" + dock->windowTitle() + "**");
        for (const QMenu* menu : fixture.window.menuBar()->findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
            for (const QAction* action : menu->actions())
                if (action->text().endsWith(u'…')) {
                    QString path = menu->title() + " ▸ " + action->text();
                    path.remove('&').remove("…");
                    look("*" + path + "*");
                }
        QVERIFY2(without.isEmpty(), qPrintable(without.join(", ")));
    }
};

} // namespace tetra

QTEST_MAIN(tetra::ManualTest)
#include "manual_test.moc"
