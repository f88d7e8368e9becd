// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/window/palette_commands.h"

#include <QDockWidget>
#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>

#include <algorithm>

using namespace tetra;

/// The command palette, by keys alone.
class PaletteTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void everyActionOfTheMenusIsThere();
    void whatCannotBeDoneSaysWhy();
    void aCommandIsFoundAndDone();
    void explanationsAreSearchedLast();
    void panelsAndAccuraciesAreFound();
    void escapeGivesTheKeysBack();
    void whatHadTheKeysMayBeGone();
    void settingsAreFoundAndGoneTo_data();
    void settingsAreFoundAndGoneTo();
    void whatSomebodyTypesGivesWhatTheyExpect_data();
    void whatSomebodyTypesGivesWhatTheyExpect();
    void settingsOfOtherModesSayWhereTheyAre();
    void whatFitsLessIsNotDoneByEnter();
    void nothingIsCutOff_data() { addLanguageRows(); }
    void nothingIsCutOff();

private:
    void openPalette() const;
    QTreeWidget& list() const { return window_->find<QTreeWidget>("palette.list"); }
    QLineEdit& search() const { return window_->find<QLineEdit>("palette.search"); }
    void openSample() const;

    std::unique_ptr<WindowFixture> window_;
};

void PaletteTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("palette");
    QLocale::setDefault(QLocale::c());
}

void PaletteTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->window.activateWindow();
}

void PaletteTest::cleanup()
{
    window_.reset();
}

void PaletteTest::openPalette() const
{
    QTest::keyClick(&window_->window, Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    if (!window_->find<QWidget>("palette").isVisible()) // without a window manager no window may have the keys
        window_->find<QAction>("action.palette").trigger();
    QVERIFY(window_->find<QWidget>("palette").isVisible());
}

void PaletteTest::openSample() const
{
    const auto path = buildSampleModel(*window_->host, sampleDataset(10), window_->folderPath());
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(window_->workbench.session().model() && window_->settled());
}

void PaletteTest::everyActionOfTheMenusIsThere()
{
    openSample();
    const auto commands = paletteCommands(window_->window, window_->workbench);
    const auto has = [&commands](const QString& name) {
        return std::ranges::any_of(commands, [&name](const PaletteCommand& command) { return command.name == name; });
    };
    int actions = 0;
    for (const QAction* action : window_->window.findChildren<QAction*>())
        if (action->objectName().startsWith("action.") && action->menu() == nullptr) {
            QVERIFY2(has(action->objectName()), qPrintable(action->objectName()));
            ++actions;
        }
    QVERIFY(actions > 40);
    for (const PaletteCommand& command : commands)
        QVERIFY2(!command.text.isEmpty() && !command.text.contains('&'), qPrintable(command.text));
}

void PaletteTest::whatCannotBeDoneSaysWhy()
{
    openPalette();
    search().setText("save mesh");
    QVERIFY(list().topLevelItemCount() > 0);
    QVERIFY(list().topLevelItem(0)->isDisabled());
    QCOMPARE(list().topLevelItem(0)->text(1), QString("Open a model first"));
    search().setText("undo");
    QCOMPARE(list().topLevelItem(0)->text(1), QString("There is nothing to undo"));
    QTest::keyClick(&search(), Qt::Key_Return); // nothing happens
    QVERIFY(search().isVisible());
}

void PaletteTest::aCommandIsFoundAndDone()
{
    openSample();
    openPalette();
    QTest::keyClicks(&search(), "look top");
    QCOMPARE(list().currentItem()->text(1), QString("Ctrl+5"));
    QTest::keyClick(&search(), Qt::Key_Return);
    QCOMPARE(window_->viewport().camera().elevation, 90.0);
    QVERIFY(!window_->find<QWidget>("palette").isVisible());

    openPalette();
    QVERIFY(search().text().isEmpty());
    const auto* first = list().currentItem();
    QTest::keyClick(&search(), Qt::Key_Down);
    QVERIFY(list().currentItem() != first);
    QTest::keyClick(&search(), Qt::Key_Up);
    QVERIFY(list().currentItem() == first);
    search().setText("zzzz");
    QCOMPARE(list().topLevelItemCount(), 1);
    QCOMPARE(list().topLevelItem(0)->text(0), QString("Nothing found"));
    QVERIFY(list().topLevelItem(0)->isDisabled());
    QTest::keyClick(&search(), Qt::Key_Return);
    QVERIFY(search().isVisible());
}

/// What no name has may be in an explanation; that is listed, and not done by Enter.
void PaletteTest::explanationsAreSearchedLast()
{
    openSample();
    openPalette();
    search().setText("restore default colours"); // of Reset View
    QCOMPARE(list().topLevelItemCount(), 1);
    QCOMPARE(list().topLevelItem(0)->text(0), QString("View: Reset View"));
    QVERIFY(!list().topLevelItem(0)->isDisabled() && list().currentItem() == nullptr);
    const int steps = window_->workbench.session().undoStack().index();
    window_->workbench.session().setError(3);
    QTest::keyClick(&search(), Qt::Key_Return);
    QVERIFY(search().isVisible());
    QCOMPARE(window_->workbench.session().undoStack().index(), steps + 1);
    QTest::keyClick(&search(), Qt::Key_Down);
    QTest::keyClick(&search(), Qt::Key_Return);
    QCOMPARE(window_->workbench.session().undoStack().index(), steps + 2);
}

void PaletteTest::panelsAndAccuraciesAreFound()
{
    openSample();
    openPalette();
    search().setText("panel transfer");
    QTest::keyClick(&search(), Qt::Key_Return);
    auto& dock = window_->find<QDockWidget>("dock.transfer");
    QVERIFY(!dock.visibleRegion().isEmpty());
    QVERIFY(dock.isAncestorOf(QApplication::focusWidget()) || QApplication::focusWidget() == nullptr);
    openPalette();
    search().setText("accuracy 0.2 %");
    QTest::keyClick(&search(), Qt::Key_Return);
    QCOMPARE(window_->workbench.session().view().query.error, 0.2);
    openPalette();
    search().setText("accuracy 0 %"); // not 0.5 %
    QTest::keyClick(&search(), Qt::Key_Return);
    QCOMPARE(window_->workbench.session().view().query.error, 0.0);
}

void PaletteTest::escapeGivesTheKeysBack()
{
    openSample();
    window_->viewport().setFocus();
    openPalette();
    QTest::keyClick(&search(), Qt::Key_Escape);
    QVERIFY(!window_->find<QWidget>("palette").isVisible());
    QVERIFY(window_->window.focusWidget() == &window_->viewport());
}

/// A form may make its rows anew while the palette is open.
void PaletteTest::whatHadTheKeysMayBeGone()
{
    openSample();
    auto* line = new QLineEdit(&window_->window);
    line->show();
    line->setFocus();
    openPalette();
    delete line;
    QTest::keyClick(&search(), Qt::Key_Escape);
    QVERIFY(!window_->find<QWidget>("palette").isVisible());
}

void PaletteTest::settingsAreFoundAndGoneTo_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("control");
    QTest::newRow("a parameter of the mode") << "clip planes"
                                             << "rendering.setting.clip";
    QTest::newRow("far down in a panel") << "background"
                                         << "view.background";
    QTest::newRow("a box to check") << "shaded"
                                    << "rendering.setting.shaded";
    QTest::newRow("of a panel that was closed") << "rate"
                                                << "animation.rate";
    QTest::newRow("by what is read out of it") << "frames per"
                                               << "animation.rate";
}

void PaletteTest::settingsAreFoundAndGoneTo()
{
    QFETCH(QString, typed);
    QFETCH(QString, control);
    openSample();
    window_->find<QAction>("action.mode.volume").trigger();
    auto& wanted = window_->find<QWidget>(control);
    openPalette();
    search().setText(typed);
    QVERIFY(list().currentItem() != nullptr);
    QTest::keyClick(&search(), Qt::Key_Return);
    QTRY_VERIFY(window_->window.focusWidget() == &wanted);
    QTRY_COMPARE(wanted.visibleRegion().boundingRect(), wanted.rect()); // all of it
}

void PaletteTest::whatSomebodyTypesGivesWhatTheyExpect_data()
{
    QTest::addColumn<QString>("typed");
    QTest::addColumn<QString>("found");
    QTest::newRow("shad") << "shad"
                          << "Rendering: Shaded";
    QTest::newRow("shaded") << "shaded"
                            << "Rendering: Shaded";
    QTest::newRow("clip") << "clip"
                          << "Rendering: Clip planes";
    QTest::newRow("clip planes") << "clip planes"
                                 << "Rendering: Clip planes";
    QTest::newRow("fit") << "fit"
                         << "View: Fit";
    QTest::newRow("save pic") << "save pic"
                              << "File: Save Picture";
    QTest::newRow("volume") << "volume"
                            << "View: Show: Volume";
}

void PaletteTest::whatSomebodyTypesGivesWhatTheyExpect()
{
    QFETCH(QString, typed);
    QFETCH(QString, found);
    openSample();
    window_->find<QAction>("action.mode.volume").trigger();
    openPalette();
    search().setText(typed);
    QCOMPARE(list().topLevelItem(0)->text(0), found);
}

void PaletteTest::settingsOfOtherModesSayWhereTheyAre()
{
    openSample();
    QCOMPARE(window_->workbench.session().view().appearance.mode, std::string("isosurface"));
    openPalette();
    search().setText("order");
    const auto found = list().findItems("Rendering: Order", Qt::MatchExactly);
    QCOMPARE(found.size(), 1);
    QVERIFY(found.front()->isDisabled());
    QVERIFY2(found.front()->text(1).startsWith("Only in "), qPrintable(found.front()->text(1)));
}

/// Without a model nothing can be saved. What fits less well and can be done is there, but Enter does nothing in the
/// place of what was meant.
void PaletteTest::whatFitsLessIsNotDoneByEnter()
{
    openPalette();
    const auto isMixed = [this](const QString& query) {
        search().setText(query);
        bool some = false;
        for (int row = 1; row < list().topLevelItemCount(); ++row)
            some = some || !list().topLevelItem(row)->isDisabled();
        return list().topLevelItem(0)->isDisabled() && some && list().currentItem() == nullptr;
    };
    bool found = false;
    for (char first = 'a'; first <= 'z' && !found; ++first)
        for (char second = 'a'; second <= 'z' && !found; ++second)
            found = isMixed(QString(QChar(first)) + QChar(second));
    QVERIFY2(found, "a query whose best match cannot be done, and another can");
    QTest::keyClick(&search(), Qt::Key_Return);
    QVERIFY(search().isVisible());
}

/// Neither names nor, of what cannot be done, the reasons.
void PaletteTest::nothingIsCutOff()
{
    QFETCH(QString, language);
    const Speaking speaking(language);
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(1366, 768);
    window_->window.show();
    openPalette();
    QVERIFY(list().topLevelItemCount() > 20);
    const QFontMetrics metrics = list().fontMetrics();
    for (int row = 0; row < list().topLevelItemCount(); ++row)
        for (const int column : {0, 1}) {
            const QString text = list().topLevelItem(row)->text(column);
            QVERIFY2(metrics.horizontalAdvance(text) <= list().columnWidth(column), qPrintable(text));
        }
}

QTEST_MAIN(PaletteTest)
#include "palette_test.moc"
