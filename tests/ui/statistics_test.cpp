// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/extraction.h"
#include "tests/ui/sample_window.h"
#include "ui/session/accuracy_scale.h"
#include "ui/session/model_statistics.h"

#include <QClipboard>
#include <QFileDialog>
#include <QPushButton>
#include <QTreeWidget>

using namespace tetra;

/// The statistics of a model in numbers, and the panel that shows them.
class StatisticsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void levelsAreThoseOfTheModel();
    void choosingALineChoosesItsAccuracy();
    void theTableFollowsTheSession();
    void allOfItIsCopied();
    void theTableIsSaved();
    void withoutAModelThereIsNothing();

private:
    Session& session() const { return window_->workbench.session(); }
    QTreeWidget& table() const { return window_->find<QTreeWidget>("statistics.table"); }

    std::unique_ptr<WindowFixture> window_;
};

void StatisticsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("statistics");
    QLocale::setDefault(QLocale::c());
}

void StatisticsTest::init()
{
    window_ = windowOnSample();
}

void StatisticsTest::cleanup()
{
    window_.reset();
}

void StatisticsTest::levelsAreThoseOfTheModel()
{
    const Model& model = *session().model();
    const auto levels = levelStatistics(model, 1e-6);
    QCOMPARE(levels.size(), accuracyPresets.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const MeshSize size = meshSizeAt(model, bothWithin(accuracyPresets[i]));
        QCOMPARE(levels[i].sites, size.sites);
        QCOMPARE(levels[i].tetrahedra, size.tetrahedra);
        QCOMPARE(levels[i].inUnits, accuracyPresets[i] / 100 * model.description().range.extent());
        QCOMPARE(levels[i].seconds.value(), 1e-6 * static_cast<double>(size.tetrahedra));
        QVERIFY(levels[i].bytes >= 16 * size.tetrahedra);
        QVERIFY(i == 0 || levels[i].tetrahedra >= levels[i - 1].tetrahedra);
    }
    QCOMPARE(levels.back().share, 100.0);
    QVERIFY(!levelStatistics(model, std::nullopt).front().seconds);
}

void StatisticsTest::choosingALineChoosesItsAccuracy()
{
    const int steps = session().undoStack().count();
    table().setCurrentItem(table().topLevelItem(1));
    QCOMPARE(session().view().error(), accuracyPresets[1]);
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_Down);
    QCOMPARE(session().view().error(), accuracyPresets[2]);
    QCOMPARE(session().undoStack().count(), steps + 2);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(table().currentItem() == table().topLevelItem(1));
}

void StatisticsTest::theTableFollowsTheSession()
{
    session().setError(accuracyPresets[4]);
    QVERIFY(table().currentItem() == table().topLevelItem(4));
    session().setError(7.5);
    QVERIFY(table().currentItem() == nullptr);
    QCOMPARE(session().view().error(), 7.5);
    session().setBudget(100);
    QVERIFY(table().currentItem() == nullptr);
}

void StatisticsTest::allOfItIsCopied()
{
    window_->find<QPushButton>("statistics.copy").click();
    const QString text = QGuiApplication::clipboard()->text();
    QVERIFY(text.contains("c60.tan"));
    const auto& last = levelStatistics(*session().model(), std::nullopt).back();
    QVERIFY2(text.contains('\t' + QLocale().toString(static_cast<qulonglong>(last.tetrahedra)) + '\t'),
             qPrintable(text));
    QVERIFY(text.contains("Triangles\t"));
    QVERIFY(text.contains("A frame\t"));
    QCOMPARE(text.count('\n', Qt::CaseSensitive) > 12, true);
}

void StatisticsTest::theTableIsSaved()
{
    window_->find<QPushButton>("statistics.save").click();
    auto& dialog = window_->find<QFileDialog>("statisticsDialog");
    const QString path = window_->folder.filePath("levels.csv");
    emit dialog.fileSelected(path);
    dialog.reject();
    QTRY_VERIFY(QFile::exists(path));
}

void StatisticsTest::withoutAModelThereIsNothing()
{
    window_->find<QAction>("action.close").trigger();
    QCOMPARE(table().topLevelItemCount(), 0);
    QVERIFY(!window_->find<QWidget>("statistics").isEnabled());
}

QTEST_MAIN(StatisticsTest)
#include "statistics_test.moc"
