// SPDX-License-Identifier: GPL-3.0-or-later
/// Help finds the manual beside the program, and says what to do where it is not.
#include "tests/ui/window_fixture.h"
#include "ui/window/help_actions.h"
#include "ui/window/help_texts.h"

#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace tetra;

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

    /// What stands in the line of a table that begins with the cell.
    static QString explanationOf(const QString& manual, const QString& cell)
    {
        const qsizetype line = manual.indexOf("\n| " + cell + " |");
        if (line < 0)
            return {};
        const QString rest = manual.mid(line + cell.size() + 5);
        return rest.left(rest.indexOf('\n')).section('|', 0, 0).trimmed();
    }
    /// The sections of the manual that a text links to.
    static QStringList sectionsOf(const QString& manual, const QString& text)
    {
        static const QRegularExpression link(R"(\]\(#([^)]*)\))");
        QStringList sections;
        for (auto links = link.globalMatch(text); links.hasNext();)
            sections.append(sectionOf(manual, links.next().captured(1)));
        return sections;
    }
    /// With those below its heading.
    static QString sectionOf(const QString& manual, const QString& anchor)
    {
        static const QRegularExpression heading("^(#+) (.*)$", QRegularExpression::MultilineOption);
        static const QRegularExpression mark(R"([^\w\- ])");
        QString section;
        qsizetype start = -1, level = 0;
        for (auto headings = heading.globalMatch(manual); headings.hasNext();) {
            const auto found = headings.next();
            if (start >= 0 && found.captured(1).size() <= level)
                return manual.mid(start, found.capturedStart() - start);
            if (start < 0 && found.captured(2).toLower().remove(mark).replace(' ', '-') == anchor) {
                start = found.capturedStart();
                level = found.captured(1).size();
            }
        }
        return start < 0 ? QString() : manual.mid(start);
    }

private slots:
    void theManualBesideTheProgramIsOpened()
    {
        const QTemporaryDir folder;
        const QString prefix = folder.path() + "/a place";
        makeManual(prefix);
        Browser browser;
        QCOMPARE(openManual(prefix + "/bin", "index.html"), QString());
        QUrl page = QUrl::fromLocalFile(prefix + "/share/doc/tan/manual/index.html");
        QCOMPARE(browser.opened, {page});
        QCOMPARE(openManual(prefix + "/bin", "manual.html#focus"), QString());
        page = QUrl::fromLocalFile(prefix + "/share/doc/tan/manual/manual.html");
        page.setFragment("focus");
        QCOMPARE(browser.opened.last(), page);
    }

    void withoutAManualItSaysWhatToInstall()
    {
        const QTemporaryDir folder;
        Browser browser;
        const QString text = openManual(folder.path() + "/bin", "index.html");
        QVERIFY2(text.contains("python3-sphinx"), qPrintable(text));
        QVERIFY(browser.opened.isEmpty());
    }

    /// From the menu: the page of the build is opened where there is Sphinx to make it, or else the window says why
    /// not.
    void theMenuHasIt()
    {
        const WindowFixture fixture;
        Browser browser;
        fixture.find<QAction>("action.manual").trigger();
        constexpr bool built = TAN_MANUAL_IS_BUILT;
        if (built)
            QCOMPARE(browser.opened, {QUrl::fromLocalFile(TAN_BINARY_DIR "/share/doc/tan/manual/index.html")});
        else
            QVERIFY(browser.opened.isEmpty());
        QCOMPARE(fixture.messages().join(' ').contains("python3-sphinx"), !built);
    }

    /// F1 explains a control, and F1 once more opens the manual where it tells of its panel; in dialogs, too.
    void helpLeadsToTheParagraph()
    {
        WindowFixture fixture;
        QStringList wanted;
        connect(fixture.window.findChild<HelpTexts*>(), &HelpTexts::manualWanted, this,
                [&](const QString& place) { wanted.append(place); });
        Browser browser;
        const auto press = [](QWidget& widget) { QTest::keyClick(&widget, Qt::Key_F1); };
        auto& budget = fixture.find<QWidget>("accuracy.byBudget");
        const auto model = buildSampleModel(*fixture.host, sampleDataset(6), fixture.folderPath());
        fixture.window.open(QString::fromStdString(model));
        fixture.window.show();
        QTRY_VERIFY(fixture.settled() && budget.isEnabled());
        fixture.window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&fixture.window));
        budget.setFocus();
        fixture.find<QAction>("action.help").trigger();
        QCOMPARE(fixture.find<QLabel>("help.text").text(), budget.toolTip());
        QCOMPARE(fixture.find<QLabel>("help.manual").textFormat(), Qt::RichText);
        press(fixture.find<QWidget>("help"));
        QCOMPARE(wanted, {"manual.html#accuracy"});
        fixture.find<QAction>("action.plugins").trigger();
        auto& plugins = fixture.find<QWidget>("pluginWindow");
        plugins.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&plugins));
        auto& list = fixture.find<QWidget>("plugins.list");
        list.setFocus();
        QTRY_VERIFY(list.hasFocus());
        press(list);
        if (wanted.size() < 2) // it has a text of its own
            press(fixture.find<QWidget>("help"));
        QCOMPARE(wanted.last(), QString("manual.html#plugins"));
    }

    /// Each panel and dialog leads to a heading that the page has.
    void everyPlaceIsInTheManual()
    {
        const WindowFixture fixture;
        QStringList without;
        const auto look = [&](const QWidget& widget) {
            const QString place = HelpTexts::manualPlaceOf(&widget), heading = place.section('#', 1);
            QFile file(TAN_SOURCE_DIR "/docs/user/" + place.section(".html", 0, 0) + ".md");
            const bool opens = file.open(QIODevice::ReadOnly);
            const bool isThere = heading.isEmpty() || !sectionOf(QString::fromUtf8(file.readAll()), heading).isEmpty();
            if (!opens || !isThere)
                without.append(place);
        };
        const auto docks = fixture.window.findChildren<QDockWidget*>();
        for (const QDockWidget* dock : docks) {
            look(*dock->widget());
            if (HelpTexts::manualPlaceOf(dock->widget()) == "manual.html")
                without.append(dock->objectName());
        }
        QWidget dialog;
        for (const char* name : {"importDialog", "pictureOptions", "filmOptions", "solidOptions", "pluginWindow",
                                 "cacheDialog", "addressDialog", "palette", "viewport.canvas"}) {
            dialog.setObjectName(name);
            look(dialog);
            if (HelpTexts::manualPlaceOf(&dialog) == "manual.html")
                without.append(name);
        }
        QVERIFY2(without.isEmpty(), qPrintable(without.join(", ")));
    }

    /// What a user meets stands in the manual's tables, each panel and each entry of the menus that opens a dialog, in
    /// words of its own; and where that leads to is about it.
    void everyPanelAndDialogIsExplained()
    {
        QFile file(TAN_SOURCE_DIR "/docs/user/manual.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString manual = QString::fromUtf8(file.readAll());
        const WindowFixture fixture;
        const auto docks = fixture.window.findChildren<QDockWidget*>();
        QVERIFY(docks.size() >= 8);
        QStringList without, explanations;
        const auto look = [&](const QString& cell, const QString& name, bool isPanel) {
            const QString text = explanationOf(manual, cell);
            const QStringList sections = sectionsOf(manual, text);
            constexpr qsizetype fewestWords = 3;
            const bool isOwn = text.split(' ').size() >= fewestWords && !explanations.contains(text);
            const bool leads = std::ranges::all_of(sections, [](const QString& one) { return !one.isEmpty(); }) &&
                               (sections.isEmpty() ? !isPanel : sections[0].contains(name, Qt::CaseInsensitive));
            if (!isOwn || !leads)
                without.append(cell);
            explanations.append(text);
        };
        for (const QDockWidget* dock : docks)
            look("**" + dock->windowTitle() + "**", dock->windowTitle(), true);
        for (const QMenu* menu : fixture.window.menuBar()->findChildren<QMenu*>(Qt::FindDirectChildrenOnly))
            for (const QAction* action : menu->actions())
                if (action->text().endsWith(u'…')) {
                    QString path = menu->title() + " ▸ " + action->text();
                    path.remove('&').remove("…");
                    look("*" + path + "*", path.section(" ▸ ", 1), false);
                }
        QVERIFY(explanations.size() > docks.size());
        QVERIFY2(without.isEmpty(), qPrintable(without.join(", ")));
    }
};

QTEST_MAIN(ManualTest)
#include "manual_test.moc"
