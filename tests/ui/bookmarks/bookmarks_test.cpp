// SPDX-License-Identifier: GPL-3.0-or-later
// Bookmarks in the window: by the menu and in their dialog, undone, and kept by sessions.
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"

#include <QAbstractButton>
#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>

using namespace tetra;

class BookmarksTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void aBookmarkBringsItsViewBack();
    void eachEditIsOneStep();
    void bookmarksAreRenamed();
    void keysWorkInTheList();
    void theMenuFollows();
    void sessionsKeepThem();
    void resettingTheViewLeavesThem();

private:
    Session& session() const { return window_->workbench.session(); }
    const std::vector<Bookmark>& bookmarks() const { return session().view().bookmarks; }
    QStringList names() const;
    void trigger(const char* action) const { window_->find<QAction>(QString("action.") + action).trigger(); }
    /// Of views with the azimuths 1, 2 and so on.
    void addBookmarks(int count) const;
    QListWidget& openDialog() const;
    void click(const char* button) const { window_->find<QAbstractButton>(QString("bookmarks.") + button).click(); }
    void turnTo(double azimuth) const
    {
        Camera camera = session().view().camera;
        camera.azimuth = azimuth;
        session().setCamera(camera);
    }

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void BookmarksTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("bookmarks");
    QLocale::setDefault(QLocale::c());
    const auto host = hostOfThisBuild();
    model_ = QString::fromStdString(buildSampleModel(*host, sampleDataset(10), folder_.path().toStdString()).string());
}

void BookmarksTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
}

QStringList BookmarksTest::names() const
{
    QStringList all;
    for (const Bookmark& bookmark : bookmarks())
        all << QString::fromStdString(bookmark.name);
    return all;
}

void BookmarksTest::addBookmarks(int count) const
{
    for (int number = 1; number <= count; ++number) {
        turnTo(number);
        trigger("bookmark.add");
    }
}

QListWidget& BookmarksTest::openDialog() const
{
    trigger("bookmark.edit");
    return window_->find<QListWidget>("bookmarks.list");
}

/// All of it but the film, which is of all views.
void BookmarksTest::aBookmarkBringsItsViewBack()
{
    turnTo(77);
    session().setMode("volume");
    trigger("bookmark.add");
    const ViewValue kept = session().view();
    QCOMPARE(names(), QStringList{"View 1"});
    turnTo(10);
    session().setMode("isosurface");
    session().setError(3);
    session().addIsovalue();
    session().setBackground(Colour{1, 0, 0});
    Animation animation = session().view().animation;
    animation.framesPerSecond = 12;
    session().setAnimation(animation);
    const int steps = session().undoStack().index();
    trigger("bookmark.1");
    ViewValue expected = kept;
    expected.animation = animation;
    QVERIFY(session().view() == expected);
    QCOMPARE(session().undoStack().index(), steps + 1);
    session().undoStack().undo();
    QCOMPARE(session().view().camera.azimuth, 10.0);
    QCOMPARE(session().view().query.error, 3.0);
}

void BookmarksTest::eachEditIsOneStep()
{
    addBookmarks(3);
    QListWidget& list = openDialog();
    QCOMPARE(list.count(), 3);
    const auto isStep = [this](const char* button, const QStringList& after) {
        const QStringList before = names();
        const int steps = session().undoStack().index();
        click(button);
        QCOMPARE(names(), after);
        QCOMPARE(session().undoStack().index(), steps + 1);
        session().undoStack().undo();
        QCOMPARE(names(), before);
        session().undoStack().redo();
        QCOMPARE(names(), after);
    };
    list.setCurrentRow(1);
    isStep("up", {"View 2", "View 1", "View 3"});
    QCOMPARE(list.currentRow(), 0);
    list.setCurrentRow(1);
    isStep("down", {"View 2", "View 3", "View 1"});
    list.setCurrentRow(0);
    isStep("remove", {"View 3", "View 1"});
    isStep("add", {"View 3", "View 1", "View 4"}); // no name is given twice
    list.setCurrentRow(0);
    turnTo(200);
    isStep("replace", {"View 3", "View 1", "View 4"});
    QCOMPARE(bookmarks()[0].view.camera.azimuth, 200.0);
    QCOMPARE(bookmarks()[1].view.camera.azimuth, 1.0);
    list.setCurrentRow(1);
    click("show");
    QCOMPARE(session().view().camera.azimuth, 1.0);
}

void BookmarksTest::bookmarksAreRenamed()
{
    addBookmarks(2);
    QListWidget& list = openDialog();
    const auto rename = [&](const char* text) {
        list.setCurrentRow(0);
        click("rename");
        auto* editor = list.findChild<QLineEdit*>();
        if (editor == nullptr)
            qFatal("there is no editor");
        editor->setText(text);
        QTest::keyClick(editor, Qt::Key_Return);
        QCoreApplication::processEvents();
    };
    const int steps = session().undoStack().index();
    rename("Bone & skin ");
    QCOMPARE(session().view().camera.azimuth, 2.0); // the key that ends renaming does not show it
    QCOMPARE(names(), (QStringList{"Bone & skin", "View 2"}));
    QCOMPARE(session().undoStack().index(), steps + 1);
    QCOMPARE(window_->find<QAction>("action.bookmark.1").text().count("&&"), 1);
    rename("  ");
    rename("View 2");
    QCOMPARE(names(), (QStringList{"Bone & skin", "View 2"}));
    QCOMPARE(list.item(0)->text(), QString("Bone & skin"));
    QCOMPARE(session().undoStack().index(), steps + 1);
}

void BookmarksTest::keysWorkInTheList()
{
    addBookmarks(3);
    QListWidget& list = openDialog();
    list.setCurrentRow(0);
    QTest::keyClick(&list, Qt::Key_Return);
    QCOMPARE(session().view().camera.azimuth, 1.0);
    QVERIFY(list.isVisible()); // the dialog stays
    QTest::keyClick(&list, Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(names(), (QStringList{"View 2", "View 1", "View 3"}));
    QTest::keyClick(&list, Qt::Key_Up, Qt::AltModifier);
    QTest::keyClick(&list, Qt::Key_Up, Qt::AltModifier); // it is the first
    QCOMPARE(names(), (QStringList{"View 1", "View 2", "View 3"}));
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(names(), (QStringList{"View 2", "View 3"}));
}

void BookmarksTest::theMenuFollows()
{
    const auto entries = [this] { return window_->find<QMenu>("menu.bookmarks").actions().size(); };
    const qsizetype without = entries();
    addBookmarks(11);
    QCOMPARE(entries(), without + 11);
    QCOMPARE(window_->find<QAction>("action.bookmark.9").shortcut(), QKeySequence("Ctrl+Shift+9"));
    QStringList keys;
    for (const QAction* action : window_->window.findChildren<QAction*>())
        for (const QKeySequence& sequence : action->shortcuts())
            if (action->shortcutContext() != Qt::WidgetShortcut)
                keys << sequence.toString();
    QCOMPARE(keys.removeDuplicates(), 0); // nothing else has them
    QVERIFY(window_->find<QAction>("action.bookmark.10").shortcut().isEmpty());
    trigger("close");
    QCOMPARE(entries(), without);
    QVERIFY(!window_->find<QAction>("action.bookmark.add").isEnabled());
}

void BookmarksTest::sessionsKeepThem()
{
    addBookmarks(2);
    const auto kept = bookmarks();
    const std::filesystem::path file = window_->folderPath() + "/look.tansession";
    bool isSaved = false;
    window_->workbench.opening().sessionFile().save(file, *window_->workbench.opening().sessions().document(),
                                                    [&](bool saved) { isSaved = saved; });
    QTRY_VERIFY(isSaved);
    trigger("close");
    QVERIFY(bookmarks().empty());
    window_->window.open(QString::fromStdString(file.string()));
    QTRY_VERIFY(session().model() && window_->settled());
    QVERIFY(bookmarks() == kept);
    QVERIFY(window_->messages().isEmpty());
}

void BookmarksTest::resettingTheViewLeavesThem()
{
    addBookmarks(2);
    trigger("resetView");
    QCOMPARE(names(), (QStringList{"View 1", "View 2"}));
}

QTEST_MAIN(BookmarksTest)
#include "bookmarks_test.moc"
