// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/accuracy_scale.h"
#include "tests/ui/sample_window.h"
#include "tests/waiting.h"

#include <tan/view.h>

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QSpinBox>
#include <QThread>
#include <QToolButton>
#include <QUndoStack>

using namespace tetra;

/// Focus, window, values and budget by the panels (R25, R26, S17): the mesh that is seen is the one that was asked for,
/// and is saved.
class QueryPanelsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void numbersMoveTheFocus();
    void numbersThatAreNoneAreNotTaken();
    void theFocusGoesToTheViewAndBack();
    void aBudgetKeepsTheCount();
    void theLineOfTheBudgetIsDragged();
    void aWindowCutsTheMesh();
    void cutCellsDoNotExceedTheirWhole();
    void twoBlendedMeshesAreNoShareOfOne();
    void aFocusIsNotCoarserThanItsSurroundings();
    void valuesChooseTetrahedra();
    void theMeshIsSaved();
    void theSurfacesAreSaved();
    void whatAFileSaysOtherwiseIsTold();
    void theSolidsAreSaved();
    void theStatisticsAreSaved();
    void noMeshOfAnotherPictureIsSaved();
    void aMeshThatCannotBeSavedIsTold();
    void savingIsCancelledAndLeavesNoFile();

private:
    Session& session() const { return window_->workbench.session(); }
    const QueryState& query() const { return session().view().query; }
    std::shared_ptr<const ExtractedMesh> mesh() const { return window_->workbench.scenes().sceneBuilder().mesh(); }
    bool upToDate() const { return window_->settled() && session().showsQuery(); }
    void trigger(const char* action) const { window_->find<QAction>(action).trigger(); }

    std::unique_ptr<WindowFixture> window_;
};

void QueryPanelsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("query_panels");
    QLocale::setDefault(QLocale::c());
}

void QueryPanelsTest::init()
{
    window_ = windowOnSample(24);
}

void QueryPanelsTest::cleanup()
{
    window_.reset();
}

void QueryPanelsTest::numbersMoveTheFocus()
{
    trigger("action.focusBox");
    window_->find<QDoubleSpinBox>("focus.centre.y").setValue(7);
    QCOMPARE(query().focus.centre.y(), 7.0);
    window_->find<QDoubleSpinBox>("focus.size.z").setValue(3);
    QCOMPARE(query().focus.size.z(), 3.0);
    trigger("action.focusSphere");
    window_->find<QDoubleSpinBox>("focus.radius.box").setValue(4);
    QCOMPARE(query().focus.radius, 4.0);
    window_->find<QDoubleSpinBox>("focus.error.box").setValue(0.1);
    QCOMPARE(query().focus.error, 0.1);
    window_->find<QDoubleSpinBox>("focus.falloff.box").setValue(0);
    QCOMPARE(query().focus.falloff, 0.0);
    QVERIFY(window_->find<QLabel>("focus.expectation").text().contains("Between"));
    QTRY_VERIFY(upToDate());
    QVERIFY(window_->find<QLabel>("status.errors").text().contains("error 0.1 % in the focus"));
    QVERIFY(window_->find<QLabel>("accuracy.outcome").text().contains("0.1 % in the focus"));
    QTest::mouseClick(&window_->find<QToolButton>("focus.none"), Qt::LeftButton);
    QVERIFY(!query().focus.isOn());
}

void QueryPanelsTest::numbersThatAreNoneAreNotTaken()
{
    trigger("action.focusSphere");
    const QueryState before = query();
    auto& box = window_->find<QDoubleSpinBox>("focus.centre.x");
    for (const char* text : {"abc", "", "1e99", "-", "nan"}) {
        box.setFocus();
        box.selectAll();
        QTest::keyClicks(&box, text);
        QTest::keyClick(&box, Qt::Key_Return);
        QCOMPARE(query(), before);
    }
    auto& budget = window_->find<QSpinBox>("accuracy.budget");
    budget.setValue(1);
    QVERIFY(query().budget > 1);
    QCOMPARE(budget.value(), static_cast<int>(query().budget));
}

void QueryPanelsTest::theFocusGoesToTheViewAndBack()
{
    trigger("action.focusSphere");
    const FocusState first = query().focus;
    session().setCamera(fitted(session().view().camera, {session().model()->description().bounds.min(), first.centre}));
    QTest::mouseClick(&window_->find<QPushButton>("focus.toView"), Qt::LeftButton);
    QCOMPARE(query().focus.centre, window_->viewport().camera().target);
    QTest::mouseClick(&window_->find<QPushButton>("focus.reset"), Qt::LeftButton);
    QCOMPARE(query().focus.centre, first.centre);
}

void QueryPanelsTest::aBudgetKeepsTheCount()
{
    auto& box = window_->find<QSpinBox>("accuracy.budget");
    box.setValue(10'000);
    QVERIFY(window_->find<QRadioButton>("accuracy.byBudget").isChecked());
    const std::uint32_t planned = session().meshSize().sites;
    QTRY_VERIFY(upToDate());
    QCOMPARE(session().shown()->wholeSites, planned); // known before it was extracted
    QVERIFY(session().shown()->tetrahedra <= 10'000);
    QVERIFY(session().shown()->tetrahedra > 8'000);
    trigger("action.focusSphere");
    QTRY_VERIFY(upToDate());
    QVERIFY(session().shown()->tetrahedra <= 10'000);
    QVERIFY(session().shown()->tetrahedra > 6'000);
    QVERIFY(window_->find<QLabel>("accuracy.outcome").text().contains("in the focus"));
    QVERIFY(window_->find<QLabel>("accuracy.outcome").text().contains("10000"));
    QTest::mouseClick(&window_->find<QWidget>("accuracy.preset.2"), Qt::LeftButton);
    QVERIFY(!query().byBudget && window_->find<QRadioButton>("accuracy.byError").isChecked());
    trigger("action.undo");
    QVERIFY(window_->find<QRadioButton>("accuracy.byBudget").isChecked());
    QTest::keyClick(&box, Qt::Key_Up);
    QCOMPARE(query().budget, std::uint64_t{15'000});
    window_->find<QRadioButton>("accuracy.byError").click();
    QVERIFY(!query().byBudget);
    QTest::keyClick(&box, Qt::Key_Return); // the number that stands there
    QVERIFY(query().byBudget);
}

void QueryPanelsTest::theLineOfTheBudgetIsDragged()
{
    window_->find<QSpinBox>("accuracy.budget").setValue(10'000);
    auto& curve = window_->find<QWidget>("accuracy.curve");
    const int steps = session().undoStack().count();
    int y = 0; // where the line is: where the pointer says so
    while (y < curve.height() && curve.cursor().shape() != Qt::SplitVCursor)
        QTest::mouseMove(&curve, {curve.width() / 2, ++y});
    QVERIFY(y < curve.height());
    QTest::mousePress(&curve, Qt::LeftButton, {}, {curve.width() / 2, y});
    QTest::mouseMove(&curve, {curve.width() / 2, y + 30});
    QTest::mouseRelease(&curve, Qt::LeftButton, {}, {curve.width() / 2, y + 30});
    QVERIFY(query().byBudget && query().budget < 10'000);
    QCOMPARE(session().undoStack().count(), steps + 1);
}

void QueryPanelsTest::aWindowCutsTheMesh()
{
    trigger("action.window");
    window_->find<QDoubleSpinBox>("region.from.x").setValue(4.5);
    window_->find<QDoubleSpinBox>("region.to.x").setValue(11.25);
    QTRY_VERIFY(upToDate());
    const auto extent = [this] {
        Eigen::AlignedBox3d box;
        for (const auto& tetrahedron : mesh()->mesh.tetrahedra)
            for (const std::uint32_t vertex : tetrahedron)
                box.extend(mesh()->mesh.positions[vertex]);
        return box;
    };
    QVERIFY(std::abs(extent().min().x() - 4.5F) < 1e-4F && std::abs(extent().max().x() - 11.25F) < 1e-4F);
    auto& border = window_->find<QComboBox>("region.border");
    border.setCurrentIndex(1);
    emit border.activated(1);
    QCOMPARE(query().window.window.border, WindowBorder::Intersecting);
    QTRY_VERIFY(upToDate());
    QVERIFY(extent().min().x() < 4.5F && extent().max().x() > 11.25F);
    QVERIFY(window_->find<QLabel>("accuracy.outcome").text().contains("tetrahedra are shown"));
    QTest::mouseClick(&window_->find<QPushButton>("region.reset"), Qt::LeftButton);
    QTRY_VERIFY(upToDate());
    QCOMPARE(session().shown()->tetrahedra, session().shown()->wholeTetrahedra);
}

/// A coarse mesh whose cells are nearly all cut into several pieces each.
void QueryPanelsTest::cutCellsDoNotExceedTheirWhole()
{
    session().setError(10);
    trigger("action.window");
    for (const char* axis : {"x", "y", "z"}) {
        window_->find<QDoubleSpinBox>(QString("region.from.") + axis).setValue(0.75);
        window_->find<QDoubleSpinBox>(QString("region.to.") + axis).setValue(22.25);
    }
    QTRY_VERIFY(upToDate());
    const auto whole = meshSizeAt(*session().model(), bothWithin(10));
    QVERIFY(mesh()->mesh.tetrahedra.size() > whole.tetrahedra); // pieces
    static const QRegularExpression sentence("([\\d,]+) of its ([\\d,]+) tetrahedra are shown");
    const QString outcome = window_->find<QLabel>("accuracy.outcome").text();
    const auto told = sentence.match(outcome);
    QVERIFY2(told.hasMatch(), qPrintable(outcome));
    const QLocale c = QLocale::c();
    QCOMPARE(c.toULongLong(told.captured(2)), qulonglong(whole.tetrahedra));
    QVERIFY2(c.toULongLong(told.captured(1)) <= whole.tetrahedra, qPrintable(outcome));
    const auto number = [&](const char* label) { return c.toULongLong(window_->find<QLabel>(label).text()); };
    QCOMPARE(number("accuracy.tetrahedra"), c.toULongLong(told.captured(1)));
    QVERIFY2(number("accuracy.sites") > 0 && number("accuracy.sites") <= whole.sites,
             qPrintable(window_->find<QLabel>("accuracy.sites").text()));
    const auto first = [&](const char* label) {
        return c.toULongLong(window_->find<QLabel>(label).text().section(' ', 0, 0));
    };
    QCOMPARE(first("status.tetrahedra"), number("accuracy.tetrahedra"));
    QCOMPARE(first("status.sites"), number("accuracy.sites"));
    QVERIFY(window_->find<QLabel>("status.tetrahedra").toolTip().contains("pieces"));
    window_->find<QPushButton>("statistics.copy").click();
    const QString facts = QGuiApplication::clipboard()->text();
    QVERIFY2(facts.contains("tetrahedra in " + c.toString(qulonglong(mesh()->mesh.tetrahedra.size())) + " pieces"),
             qPrintable(facts));
}

/// Both are of the whole domain, so their sum may be more than all of the finest one.
void QueryPanelsTest::twoBlendedMeshesAreNoShareOfOne()
{
    session().setError(0.1);
    trigger("action.focusSphere");
    window_->find<QDoubleSpinBox>("focus.error.box").setValue(0);
    trigger("action.mode.focus");
    QTRY_VERIFY(upToDate());
    QVERIFY(window_->find<QLabel>("accuracy.tetrahedronShare").text().isEmpty());
    QVERIFY(!window_->find<QLabel>("accuracy.outcome").text().contains("of its"));
    trigger("action.mode.volume");
    QTRY_VERIFY(upToDate());
    QVERIFY(window_->find<QLabel>("accuracy.tetrahedronShare").text().contains("of all"));
}

/// What was chosen comes back when the surroundings are coarser again.
void QueryPanelsTest::aFocusIsNotCoarserThanItsSurroundings()
{
    trigger("action.focusSphere");
    session().setError(1);
    window_->find<QDoubleSpinBox>("focus.error.box").setValue(0.2);
    const auto& word = window_->find<QLabel>("focus.clamped");
    QVERIFY(!word.isVisibleTo(word.parentWidget()));
    session().setError(0.05);
    QTRY_VERIFY(upToDate());
    QVERIFY2(word.isVisibleTo(word.parentWidget()) && word.text().contains("0.05 %"), qPrintable(word.text()));
    const SpaceRamp* ramp = session().shown()->query.error.asSpaceRamp();
    QVERIFY(ramp == nullptr || ramp->inner <= ramp->outer);
    const QString errors = window_->find<QLabel>("status.errors").text();
    QVERIFY2(errors.contains("0.05 % in the focus, 0.05 % outside"), qPrintable(errors));
    session().setBudget(3000);
    QTRY_VERIFY(upToDate());
    ramp = session().shown()->query.error.asSpaceRamp();
    QVERIFY(ramp == nullptr || ramp->inner <= ramp->outer);
    QVERIFY(word.isVisibleTo(word.parentWidget()));
    session().setError(1);
    QTRY_VERIFY(upToDate());
    QVERIFY(!word.isVisibleTo(word.parentWidget()));
    QVERIFY(window_->find<QLabel>("status.errors").text().contains("0.2 % in the focus, 1 % outside"));
}

void QueryPanelsTest::valuesChooseTetrahedra()
{
    window_->find<QCheckBox>("region.values").click();
    window_->find<QDoubleSpinBox>("region.least.box").setValue(120);
    window_->find<QDoubleSpinBox>("region.largest.box").setValue(130);
    QTRY_VERIFY(upToDate());
    QVERIFY(session().shown()->tetrahedra < session().shown()->wholeTetrahedra);
    QVERIFY(!mesh()->mesh.tetrahedra.empty());
    for (const auto& corners : mesh()->mesh.tetrahedra) {
        const auto value = [&](std::size_t i) { return mesh()->mesh.values[corners[i]]; };
        QVERIFY(std::max({value(0), value(1), value(2), value(3)}) >= 120);
        QVERIFY(std::min({value(0), value(1), value(2), value(3)}) <= 130);
    }
}

void QueryPanelsTest::theMeshIsSaved()
{
    trigger("action.focusSphere");
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    for (const char* name : {"mesh.vtu", "mesh.vtk"}) {
        const QString path = window_->folder.filePath(name);
        window_->workbench.exporting().saveMesh(path.toStdString()); // the first while the picture is still on its way
        QTRY_COMPARE(saved.count(), 1);
        QCOMPARE(saved.takeFirst()[0].toString(), path);
        QTRY_VERIFY(mesh());
        QVERIFY(static_cast<std::size_t>(QFile(path).size()) >
                mesh()->mesh.tetrahedra.size() * 16 + mesh()->mesh.positions.size() * 16);
    }
    QFile file(window_->folder.filePath("mesh.vtu"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray head = file.read(2000);
    QVERIFY(head.contains(QString("NumberOfCells=\"%1\"").arg(mesh()->mesh.tetrahedra.size()).toUtf8()));
    QCOMPARE(window_->messages(), QStringList());
}

/// The visible surfaces of the mesh that is seen, with their colours.
void QueryPanelsTest::theSurfacesAreSaved()
{
    session().addIsovalue();
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    const auto groups = [&](const char* name) {
        const QString path = window_->folder.filePath(name);
        window_->workbench.exporting().saveSurfaces(path.toStdString());
        if (!waitFor([&] { return saved.count() == 1; }))
            return qsizetype(-1);
        saved.clear();
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll().count("\ng isovalue_") : qsizetype(-1);
    };
    const auto visible = [&] { return std::ranges::count_if(session().view().isovalues, &Isovalue::visible); };
    QVERIFY(visible() > 1);
    QCOMPARE(groups("surfaces.obj"), visible());
    Isovalue hidden = session().view().isovalues.front();
    hidden.visible = false;
    session().setIsovalue(0, hidden);
    QCOMPARE(groups("fewer.obj"), visible());
    QVERIFY(groups("surfaces.glb") >= 0);
    QCOMPARE(window_->messages(), QStringList());
}

/// Until the user takes it away: the numbers are needed when the file is used.
void QueryPanelsTest::whatAFileSaysOtherwiseIsTold()
{
    const QTemporaryDir folder;
    Dataset far = sampleDataset(6);
    far.lattice.origin = {339385, 4264212, 1680};
    far.lattice.spacing = {0.05, 0.05, 0.05};
    far.lengthUnit = "m";
    const auto model = buildSampleModel(*window_->host, far, folder.path().toStdString());
    window_->window.open(QString::fromStdString(model));
    QTRY_VERIFY(session().model() && session().model()->path() == model && window_->settled());
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    for (const char* name : {"far.ply", "far.stl", "far.glb"}) {
        window_->workbench.exporting().saveMesh(folder.filePath(name).toStdString());
        QTRY_COMPARE(saved.count(), 1);
        saved.clear();
    }
    const QStringList told = window_->messages();
    QCOMPARE(told.size(), 2);
    const QString text = "In '%1' x, y and z are smaller than in the data by 339385, 4264212 and 1680, because";
    QVERIFY2(told[0].startsWith(text.arg(folder.filePath("far.glb"))), qPrintable(told[0]));
    QVERIFY2(told[1].startsWith(text.arg(folder.filePath("far.stl"))), qPrintable(told[1]));
    QFile ply(folder.filePath("far.ply"));
    QVERIFY(ply.open(QIODevice::ReadOnly));
    const QByteArray head = ply.read(2000);
    QVERIFY2(head.contains("comment unit: m\n"), head.constData());
}

/// By the dialog: closed, and what they are is told, with the deviation if that was asked for.
void QueryPanelsTest::theSolidsAreSaved()
{
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::solidsSaved);
    const auto report = [&](int side, const QString& name) {
        window_->find<QAction>("action.saveSolids").trigger();
        auto& options = window_->find<QDialog>("solidOptions");
        window_->find<QComboBox>("solid.side").setCurrentIndex(side);
        window_->find<QCheckBox>("solid.largestPart").setChecked(true);
        window_->find<QCheckBox>("solid.deviation").setChecked(side == 0);
        options.accept();
        auto& dialog = window_->find<QFileDialog>("solidDialog");
        dialog.selectFile(window_->folder.filePath(name));
        QMetaObject::invokeMethod(&dialog, "accept");
        return waitFor([&] { return saved.count() == 1; }) ? saved.takeFirst()[1].toString()
                                                           : window_->messages().join(", ");
    };
    const QString above = report(0, "above.stl"), below = report(1, "below.stl"), open = report(2, "open.stl");
    QVERIFY2(above.contains(": closed; parts: 1, ") &&
                 above.contains("Deviation from the finest mesh, measured at many places: largest "),
             qPrintable(above));
    QVERIFY2(below.contains(": closed; parts: 1, ") && !below.contains("Deviation"), qPrintable(below));
    QVERIFY2(open.contains("parts: 1, "), qPrintable(open));
    QVERIFY(above != below);
    QFile file(window_->folder.filePath("above.stl"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(80).startsWith("binary STL, deviation "));
    QCOMPARE(window_->messages().size(), 3);
    Isovalue hidden = session().view().isovalues.front();
    hidden.visible = false;
    for (std::size_t i = 0; i < session().view().isovalues.size(); ++i)
        session().setIsovalue(i, hidden);
    window_->workbench.exporting().saveSolids(window_->folder.filePath("none.stl").toStdString(), {}, false);
    QTRY_COMPARE(window_->messages().size(), 4);
    QVERIFY(!QFile::exists(window_->folder.filePath("none.stl")));
}

void QueryPanelsTest::theStatisticsAreSaved()
{
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::textSaved);
    const QString path = window_->folder.filePath("levels.csv");
    window_->workbench.exporting().saveStatistics(path.toStdString());
    QTRY_COMPARE(saved.count(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = file.readAll().split('\n');
    QVERIFY(lines.size() > 5);
    const MeshSize size = meshSizeAt(*session().model(), {lines[1].split(',')[0].toDouble()});
    QCOMPARE(lines[1].split(',')[3].toULongLong(), qulonglong(size.tetrahedra));
}

/// What was undone may have its mesh already, while the picture is still the one from before.
void QueryPanelsTest::noMeshOfAnotherPictureIsSaved()
{
    const auto wanted = mesh();
    session().setError(40);
    // The worker lets go of one mesh before it makes the next: what is asked and what is read must be one answer.
    std::shared_ptr<const ExtractedMesh> other = mesh();
    for (; !other || other == wanted; other = mesh())
        QThread::yieldCurrentThread();
    QVERIFY(other->mesh.tetrahedra.size() != wanted->mesh.tetrahedra.size());
    session().undoStack().undo();
    QVERIFY(session().showsQuery());
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    const QString path = window_->folder.filePath("mesh.vtu");
    window_->workbench.exporting().saveMesh(path.toStdString());
    QTRY_COMPARE(saved.count(), 1);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.read(2000).contains(QString("NumberOfCells=\"%1\"").arg(wanted->mesh.tetrahedra.size()).toUtf8()));
}

void QueryPanelsTest::aMeshThatCannotBeSavedIsTold()
{
    window_->workbench.exporting().saveMesh("/no/such/folder/mesh.vtu");
    QTRY_COMPARE(window_->messages().size(), 1);
    QVERIFY(window_->messages().first().contains("/no/such/folder"));
    window_->workbench.exporting().saveMesh(window_->folder.filePath("mesh.off").toStdString());
    QTRY_COMPARE(window_->messages().size(), 2);
    window_->workbench.exporting().saveSurfaces(window_->folder.filePath("surface.off").toStdString());
    QTRY_COMPARE(window_->messages().size(), 3);
    window_->workbench.exporting().saveStatistics(window_->folder.filePath("levels.xls").toStdString());
    QTRY_COMPARE(window_->messages().size(), 4);
    QVERIFY(!window_->find<QWidget>("status.saving").isVisible());
}

void QueryPanelsTest::savingIsCancelledAndLeavesNoFile()
{
    const QString path = window_->folder.filePath("mesh.vtu");
    const QStringList files = QDir(window_->folderPath().c_str()).entryList(QDir::Files);
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    LongTask& saving = window_->workbench.exporting().savingMesh();
    window_->workbench.exporting().saveMesh(path.toStdString());
    QVERIFY(saving.running());
    saving.cancel();
    QTRY_VERIFY(!saving.running());
    // Either it was cancelled in time, and nothing is left, or it was finished before it heard of that.
    QCOMPARE(QFile::exists(path), saved.count() == 1);
    if (saved.empty())
        QCOMPARE(QDir(window_->folderPath().c_str()).entryList(QDir::Files), files);
    QCOMPARE(window_->messages(), QStringList()); // who cancels knows
}

QTEST_MAIN(QueryPanelsTest)
#include "query_panels_test.moc"
