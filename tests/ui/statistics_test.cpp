// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/session_document.h"
#include "core/render/volume/volume_mesh.h"
#include "core/verify/verify_mesh.h"
#include "core/view/accuracy_scale.h"
#include "core/view/appearance.h"
#include "plugins/samples/samples.h"
#include "plugins/widgets/number_text.h"
#include "tests/ui/folded_model.h"
#include "tests/ui/sample_window.h"
#include "ui/panels/model_statistics.h"

#include <tan/build.h>
#include <tan/model.h>
#include <tan/query.h>
#include <tan/render.h>
#include <tan/transfer.h>

#include <QCheckBox>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTreeWidget>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

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
    void cyclesOfTheOrderAreCounted();
    void whichErrorIsSaid();
    void theErrorInSpaceIsMeasured();
    void errorsOfLogarithmsAreFactors();
    void valuesOfLogarithmsAreThoseOfTheData();
    void faultyCellsAreShown();
    void withoutAModelThereIsNothing();

private:
    void openLogarithms();
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
    QCOMPARE(session().view().query.error, accuracyPresets[1]);
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_Down);
    QCOMPARE(session().view().query.error, accuracyPresets[2]);
    QCOMPARE(session().undoStack().count(), steps + 2);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(table().currentItem() == table().topLevelItem(1));
}

/// C12: of a curvilinear grid, whether the model keeps the error in space or that in the grid alone.
void StatisticsTest::whichErrorIsSaid()
{
    auto grid = makeSample({.name = "bent-duct", .size = 6, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    grid->source.taken = {{TakenPart::TimeStep, std::string("2 of 5"), true}}; // D3
    const auto said = [&](bool inSpace) {
        const std::filesystem::path path = window_->folderPath() + "/grid.tan";
        if (!tetra::buildModel(*grid, path, Refinement{.inSpace = inSpace}))
            return QString("no model");
        const auto facts = modelFacts(*Model::open(path).value());
        const auto taken = std::ranges::find(facts, QString("Used from the file"), &StatisticsFact::name);
        if (taken == facts.end() || taken->value != "Time step: 2 of 5 (a guess)")
            return QString("taken of nothing");
        const auto fact = std::ranges::find(facts, QString("Error"), &StatisticsFact::name);
        return fact == facts.end() ? QString() : fact->value;
    };
    QCOMPARE(said(true), QString("in the grid and in space"));
    QCOMPARE(said(false), QString("in the grid; in space it may be larger"));
    const auto facts = modelFacts(*session().model()); // a lattice has one
    QVERIFY(std::ranges::none_of(facts, [](const auto& one) { return one.name == "Error"; }));
}

void StatisticsTest::openLogarithms()
{
    const auto path = buildLogarithmModel(*window_->host, 12, window_->folderPath());
    window_->find<QAction>("action.close").trigger();
    window_->window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(session().model() && window_->settled());
}

/// D7: whatever box has a value of such a model shows and takes what the value is the logarithm of.
void StatisticsTest::valuesOfLogarithmsAreThoseOfTheData()
{
    auto& linear = window_->find<QDoubleSpinBox>("isovalue.0.value.box");
    QCOMPARE(linear.text().toDouble(), linear.value());
    openLogarithms();
    QVERIFY(session().model());
    Isovalue ten = session().view().isovalues.front();
    ten.value = 1;
    session().setIsovalue(0, ten);
    auto& box = window_->find<QDoubleSpinBox>("isovalue.0.value.box");
    QCOMPARE(box.text(), QString("10"));
    const QString toolTip = window_->find<QWidget>("isovalue.0.value").toolTip();
    QVERIFY2(toolTip.contains("of the data: 1 to "), qPrintable(toolTip));
    box.selectAll();
    QTest::keyClicks(&box, "20");
    QTest::keyClick(&box, Qt::Key_Return);
    QVERIFY(std::abs(session().view().isovalues.front().value - std::log10(20.0)) < 1e-12);
    const QString largest = QString::number(std::pow(10, session().range().maximum), 'g', 6);
    for (const char* name : {"region.least.box", "view.barEnds.least"})
        QCOMPARE(window_->find<QDoubleSpinBox>(name).text(), QString("1"));
    for (const char* name : {"region.largest.box", "view.barEnds.largest"})
        QCOMPARE(window_->find<QDoubleSpinBox>(name).text(), largest);
}

/// D7: a model of logarithms tells errors as factors, and values as the data have them.
void StatisticsTest::errorsOfLogarithmsAreFactors()
{
    QCOMPARE(table().headerItem()->text(6), QString("± value"));
    openLogarithms();
    QVERIFY(session().model());
    const double extent = session().range().extent();
    QVERIFY(extent > 1);
    QCOMPARE(table().headerItem()->text(6), QString("Factor"));
    const auto factorOfPercent = [&](double percent) { return std::pow(10, percent / 100 * extent); };
    const auto levels = levelStatistics(*session().model(), std::nullopt);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double told = table().topLevelItem(static_cast<int>(i))->text(6).toDouble();
        const double factor = factorOfPercent(levels[i].error);
        QVERIFY2(std::abs(told - factor) <= 0.05 * (factor - 1) + 1e-12, qPrintable(QString::number(told)));
    }
    const auto facts = modelFacts(*session().model());
    const auto valueOf = [&](const char* name) {
        const auto fact = std::ranges::find(facts, QString(name), &StatisticsFact::name);
        return fact == facts.end() ? QString() : fact->value;
    };
    QVERIFY2(valueOf("Values").startsWith("1 to "), qPrintable(valueOf("Values")));
    QVERIFY2(valueOf("Scale").startsWith("logarithmic; an error of 1 % is a factor of 1.0"),
             qPrintable(valueOf("Scale")));
    session().setError(10);
    QTRY_VERIFY(window_->settled());
    const QString factor = QString("a factor of %1").arg(factorOfPercent(10), 0, 'g', 3);
    QTRY_COMPARE(window_->find<QLabel>("status.errors").text(), "error 10 % (" + factor + ")");
    QCOMPARE(window_->find<QLabel>("accuracy.inUnits").text(), "of the range\n" + factor);
    Isovalue least = session().view().isovalues.front();
    least.value = session().range().minimum;
    session().setIsovalue(0, least);
    QTRY_VERIFY(window_->find<QLabel>("status.remarks").toolTip().contains("The isovalue log10(1) is within"));
    window_->find<QPushButton>("statistics.copy").click();
    QVERIFY(QGuiApplication::clipboard()->text().contains("\tFactor\n"));
    QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    for (const char* name : {"/logarithms.vtu", "/logarithms.ply"})
        window_->workbench.exporting().saveMesh(window_->folderPath() + name);
    QTRY_COMPARE(saved.count(), 2);
    const auto told = [&](qsizetype file) { return saved[file][1].toStringList().join('\n'); };
    QVERIFY2(told(0).contains("interpolate 'log10("), qPrintable(told(0)));
    QVERIFY2(!told(1).contains("interpolate"), qPrintable(told(1)));
}

/// C12: of a grid whose model keeps the error in the grid, the error in space of the mesh that is shown is measured and
/// stands beside it, wherever the one does.
void StatisticsTest::theErrorInSpaceIsMeasured()
{
    auto grid = makeSample({.name = "bent-duct", .size = 8, .type = std::nullopt, .seed = 1});
    QVERIFY(grid);
    auto places = std::make_shared<std::vector<Eigen::Vector3d>>(*grid->positions);
    for (Eigen::Vector3d& place : *places) // in floats the model holds them all
        place = place.cast<float>().cast<double>();
    grid->positions = places;
    grid->source.hash = contentHash(grid->values, grid->positions);
    const std::filesystem::path path = window_->folderPath() + "/grid.tan";
    QVERIFY(tetra::buildModel(*grid, path, Refinement{.inSpace = false}).ok());
    const auto& place = window_->find<QLabel>("accuracy.errorPlace");
    QVERIFY(place.isHidden()); // a lattice has one error
    QCOMPARE(table().headerItem()->text(0), QString("Error"));
    window_->find<QAction>("action.close").trigger();
    window_->window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(session().model() && window_->settled());
    QVERIFY(!session().model()->samples().empty());
    QCOMPARE(table().headerItem()->text(0), QString("Error in the grid"));
    session().setError(10);
    QTRY_VERIFY(window_->settled() && session().shown()->errorInSpace);

    MeshExtractor extractor(session().model());
    const auto mesh = extractor.extract(session().shown()->query);
    QVERIFY(mesh.ok());
    const auto judged = verifyMesh(*session().model(), *grid, session().shown()->query, **mesh);
    QVERIFY(judged.ok());
    const double inSpace = judged->measured.errorInSpace.largest;
    QCOMPARE(*session().shown()->errorInSpace, inSpace);
    const QString text = "in the grid; in space up to " + percentText(inSpace);
    QVERIFY2(place.text().startsWith(text + ", ± ") && !place.isHidden(), qPrintable(place.text()));
    const QString kept = "error in the grid 10 % (in space up to " + percentText(inSpace) + ")";
    QCOMPARE(window_->find<QLabel>("status.errors").text(), kept);
    window_->find<QPushButton>("statistics.copy").click();
    QVERIFY(QGuiApplication::clipboard()->text().contains("Guaranteed\t" + kept + "\n"));
    // Another look at the same mesh is told the same, and another mesh is measured anew.
    session().setMode("volume");
    QTRY_VERIFY(window_->settled() && session().shown()->errorInSpace == inSpace);
    session().setError(0);
    QTRY_VERIFY(window_->settled() && session().shown()->errorInSpace.value_or(1) < 1e-6);
}

/// C10: the cells at fault are counted, and outlined on request: a step to undo, which the session keeps. Where there
/// are none the check box says so.
void StatisticsTest::faultyCellsAreShown()
{
    auto& box = window_->find<QCheckBox>("statistics.faultyCells");
    QVERIFY(!box.isEnabled() && !box.isChecked());
    QVERIFY2(box.toolTip().contains("no faulty cells"), qPrintable(box.toolTip()));

    const std::filesystem::path path = window_->folderPath() + "/folded.tan";
    QVERIFY(buildFoldedModel(path).ok());
    window_->find<QAction>("action.close").trigger();
    window_->window.open(QString::fromStdString(path.string()));
    QTRY_VERIFY(session().model() && window_->settled());
    const std::uint64_t count = faultyCellCount(*session().model());
    QVERIFY(count > 0);
    const auto factOf = [this](const char* name) {
        window_->find<QPushButton>("statistics.copy").click();
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        const auto line = std::ranges::find_if(lines, [&](const QString& one) { return one.startsWith(name); });
        return line == lines.end() ? QString() : line->section('\t', 1);
    };
    QCOMPARE(factOf("Faulty cells\t"), QString::number(count));
    const auto isOutlined = [this] { return drawableOf(*window_->viewport().scene(), "faulty-cells") != nullptr; };
    QVERIFY(box.isEnabled() && !box.isChecked() && !isOutlined());
    const QImage before = window_->viewport().grab().toImage();
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Space);
    QTRY_VERIFY(window_->settled() && isOutlined());
    QCOMPARE(factOf("Faulty cells outlined"), QString::number(count));
    QTRY_VERIFY(window_->viewport().grab().toImage() != before);
    const std::filesystem::path folder = window_->folderPath();
    const auto kept = sessionFromText(sessionToText({.model = path, .view = session().view()}, folder), folder);
    QVERIFY(kept.ok() && showsFaultyCells(kept->view.appearance));
    session().setMode("volume"); // whatever the mode
    QTRY_VERIFY(window_->settled() && isOutlined() && hasVolume(*window_->viewport().scene()));
    window_->find<QAction>("action.undo").trigger();
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(!box.isChecked());
    QTRY_VERIFY(window_->settled() && !isOutlined());
}

void StatisticsTest::theTableFollowsTheSession()
{
    session().setError(accuracyPresets[4]);
    QVERIFY(table().currentItem() == table().topLevelItem(4));
    session().setError(7.5);
    QVERIFY(table().currentItem() == nullptr);
    QCOMPARE(session().view().query.error, 7.5);
    session().setBudget(100);
    QVERIFY(table().currentItem() == nullptr);
}

void StatisticsTest::allOfItIsCopied()
{
    window_->find<QPushButton>("statistics.copy").click();
    const QString text = QGuiApplication::clipboard()->text();
    // The facts, each once.
    const QStringList facts = text.section("\n\n", 0, 0).split('\n');
    QMap<QString, QString> values;
    for (const QString& fact : facts) {
        QVERIFY2(fact.count('\t') == 1, qPrintable(fact));
        values[fact.section('\t', 0, 0)] = fact.section('\t', 1);
    }
    QCOMPARE(values.size(), facts.size());
    const Model& model = *session().model();
    const auto count = [](std::uint64_t number) { return QLocale().toString(static_cast<qulonglong>(number)); };
    const MeshSize shown = meshSizeAt(model, bothWithin(session().view().query.error));
    QCOMPARE(values.value("Model"), QString("c60.tan"));
    QCOMPARE(values.value("Total vertices"), count(model.siteCount()));
    QCOMPARE(values.value("Shown"), count(shown.sites) + " vertices, " + count(shown.tetrahedra) + " tetrahedra");
    QCOMPARE(values.value("Guaranteed"), "error " + percentText(session().view().query.error));
    std::uint64_t triangles = 0;
    for (const Drawable& drawable : window_->viewport().scene()->drawables)
        if (const Surface* const surface = std::get_if<Surface>(&drawable.shape))
            triangles += surface->mesh->triangles.size();
    QVERIFY(triangles > 0);
    QCOMPARE(values.value("Triangles"), count(triangles));
    for (const char* name : {"Values", "File", "Preparation", "A frame"})
        QVERIFY2(!values.value(name).isEmpty(), name);
    // The table as it is shown, and each accuracy's mesh in it.
    const QStringList lines = text.section("\n\n", 1).split('\n', Qt::SkipEmptyParts);
    QCOMPARE(lines.size(), qsizetype(accuracyPresets.size()) + 1);
    for (int line = 0; line < int(lines.size()); ++line) {
        const QTreeWidgetItem& row = *(line == 0 ? table().headerItem() : table().topLevelItem(line - 1));
        QStringList cells;
        for (int column = 0; column < table().columnCount(); ++column)
            cells.append(row.text(column));
        QCOMPARE(lines[line].split('\t'), cells);
        if (line == 0)
            continue;
        const double error = accuracyPresets[std::size_t(line - 1)];
        const MeshSize size = meshSizeAt(model, bothWithin(error));
        QCOMPARE(cells.mid(0, 3), (QStringList{percentText(error), count(size.sites), count(size.tetrahedra)}));
    }
}

void StatisticsTest::theTableIsSaved()
{
    window_->find<QPushButton>("statistics.save").click();
    auto& dialog = window_->find<QFileDialog>("statisticsDialog");
    const QString path = window_->folder.filePath("levels.csv");
    emit dialog.fileSelected(path);
    dialog.reject();
    QTRY_VERIFY(QFile::exists(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QList<QByteArray> lines = file.readAll().trimmed().split('\n');
    QCOMPARE(lines.size(), qsizetype(accuracyPresets.size()) + 1);
    const QList<QByteArray> names = lines.takeFirst().split(',');
    const auto number = [&](qsizetype line, const char* name) {
        return lines[line].split(',').value(names.indexOf(name)).toDouble();
    };
    for (std::size_t i = 0; i < accuracyPresets.size(); ++i) {
        const MeshSize size = meshSizeAt(*session().model(), bothWithin(accuracyPresets[i]));
        QCOMPARE(number(qsizetype(i), "error_percent"), accuracyPresets[i]);
        QCOMPARE(number(qsizetype(i), "sites"), double(size.sites));
        QCOMPARE(number(qsizetype(i), "tetrahedra"), double(size.tetrahedra));
    }
}

namespace {

/// Three sticks, each with one end before the next: seen from the front none of them comes first.
std::shared_ptr<const Scene> cyclicScene()
{
    const auto mesh = std::make_shared<TetrahedralMesh>();
    const auto corner = [](int number) {
        const double angle = number * 2.0943951023931953;
        return Eigen::Vector3d(std::cos(angle), 0, std::sin(angle));
    };
    for (int stick = 0; stick < 3; ++stick) {
        const Eigen::Vector3d along = corner(stick + 1) - corner(stick);
        const Eigen::Vector3d back = corner(stick) - 0.3 * along + Eigen::Vector3d(0, 0.3, 0);
        const Eigen::Vector3d front = corner(stick + 1) + 0.3 * along - Eigen::Vector3d(0, 0.3, 0);
        const Eigen::Vector3d across = 0.1 * along.cross(Eigen::Vector3d::UnitY()).normalized();
        const Eigen::Vector3d deep(0, 0.1, 0);
        const auto first = static_cast<std::uint32_t>(mesh->positions.size());
        for (const Eigen::Vector3d& place : {Eigen::Vector3d(back - across), Eigen::Vector3d(back + across),
                                             Eigen::Vector3d(front - deep), Eigen::Vector3d(front + deep)})
            mesh->positions.push_back(place);
        const Eigen::Vector3d edge = 2 * across;
        const bool isPositive = edge.dot((front - deep - back + across).cross(front + deep - back + across)) > 0;
        mesh->tetrahedra.push_back({first, first + 1, first + (isPositive ? 2 : 3), first + (isPositive ? 3 : 2)});
    }
    mesh->values.assign(mesh->positions.size(), 0.5F);
    auto scene = std::make_shared<Scene>();
    for (const Eigen::Vector3d& place : mesh->positions)
        scene->bounds.extend(place.cast<double>());
    scene->drawables.push_back(
        {.id = "volume", .shape = *VolumeCache(mesh).update(sequentialTransferFunction(0, 1, 1), false)});
    return scene;
}

} // namespace

/// S14, C13: tetrahedra without an order, which few pictures have, are cut, and it is said.
void StatisticsTest::cyclesOfTheOrderAreCounted()
{
    const auto facts = [this] {
        window_->find<QPushButton>("statistics.copy").click();
        return QGuiApplication::clipboard()->text();
    };
    QVERIFY(!facts().contains("Visibility cycles")); // surfaces have none
    session().setMode("volume");
    QTRY_VERIFY(window_->settled());
    QTRY_VERIFY2(facts().contains("Visibility cycles\t0"), qPrintable(facts()));
    const std::shared_ptr<const Scene> scene = cyclicScene();
    Camera camera = fitted({}, scene->bounds);
    camera.azimuth = camera.elevation = 0;
    window_->viewport().setCamera(camera);
    window_->viewport().setScene(scene, 3);
    QTRY_VERIFY2(facts().contains("Visibility cycles\ttetrahedra cut: 2\n"), qPrintable(facts()));
}

void StatisticsTest::withoutAModelThereIsNothing()
{
    window_->find<QAction>("action.close").trigger();
    QCOMPARE(table().topLevelItemCount(), 0);
    QVERIFY(!window_->find<QWidget>("statistics").isEnabled());
}

QTEST_MAIN(StatisticsTest)
#include "statistics_test.moc"
