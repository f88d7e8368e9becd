// SPDX-License-Identifier: GPL-3.0-or-later
/// The plugins of examples/ in the window, as their users have them: modes are chosen, looked at, picked in, saved; a
/// dock edits a parameter; a file is read, built and written.
#include "tests/examples/example_plugins.h"
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/tools/tool_desk.h"
#include "ui/viewport/value_pick.h"

#include <tan/verify.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>

#include <Eigen/LU>

#include <algorithm>
#include <fstream>

using namespace tetra;

namespace {

/// What an OFF file holds.
struct OffFile {
    std::vector<Eigen::Vector3d> positions;
    std::size_t triangles = 0;
};

OffFile readOff(const std::string& path)
{
    std::ifstream file(path);
    std::string head;
    std::size_t vertices = 0, triangles = 0, edges = 0;
    if (!(file >> head >> vertices >> triangles >> edges) || head != "OFF")
        qFatal("%s is no OFF file", path.c_str());
    OffFile content;
    content.positions.resize(vertices);
    for (Eigen::Vector3d& position : content.positions)
        file >> position.x() >> position.y() >> position.z();
    std::size_t corners = 0, a = 0, b = 0, c = 0;
    while (file >> corners >> a >> b >> c && corners == 3 && std::max({a, b, c}) < vertices)
        ++content.triangles;
    if (content.triangles != triangles)
        qFatal("%s has other triangles than it says", path.c_str());
    return content;
}

/// Those that an OBJ file has behind the positions; none where a vertex lacks one.
std::vector<Colour> coloursOfObj(const std::string& path)
{
    std::ifstream file(path);
    std::vector<Colour> colours;
    for (std::string line; std::getline(file, line);) {
        const QStringList words = QString::fromStdString(line).split(' ');
        if (words[0] != "v")
            continue;
        if (words.size() != 7)
            return {};
        colours.push_back({words[4].toFloat(), words[5].toFloat(), words[6].toFloat()});
    }
    return colours;
}

/// What the mesh tells at a place; nothing outside of it.
std::optional<double> valueAt(const TetrahedralMesh& mesh, const Eigen::Vector3d& place)
{
    const auto corner = [&](std::uint32_t vertex) -> Eigen::Vector3d { return mesh.positions[vertex].cast<double>(); };
    for (const auto& cell : mesh.tetrahedra) {
        const Eigen::Vector3d origin = corner(cell[0]);
        Eigen::Matrix3d edges;
        for (int edge = 0; edge < 3; ++edge)
            edges.col(edge) = corner(cell[static_cast<std::size_t>(edge) + 1]) - origin;
        const Eigen::Vector3d shares = edges.inverse() * (place - origin);
        if (shares.minCoeff() < -1e-4 || shares.sum() > 1 + 1e-4)
            continue;
        double value = static_cast<double>(mesh.values[cell[0]]) * (1 - shares.sum());
        for (int edge = 0; edge < 3; ++edge)
            value += static_cast<double>(mesh.values[cell[static_cast<std::size_t>(edge) + 1]]) * shares[edge];
        return value;
    }
    return std::nullopt;
}

/// How many pixels have a colour that is meant.
template <class Predicate> int pixelsThat(const QImage& picture, const Predicate& isMeant)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += isMeant(picture.pixelColor(x, y)) ? 1 : 0;
    return count;
}

bool isBlue(const QColor& colour)
{
    return colour.blue() > colour.red() + 40;
}

} // namespace

class ExampleWindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void allOfThemAreLoaded();
    void theSliceIsSeenPickedAndSaved();
    void theProjectionShowsTheLargestValues();
    void theBandOfTheShellsIsEditedInItsDock();
    void valuesArePinnedByTheTool();
    void isosurfacesAreWrittenByTheWriter();
    void aGridIsReadAndBuiltWithinABudget();

private:
    template <class Object> Object& find(const QString& name) const { return window_->find<Object>(name); }
    Session& session() const { return window_->workbench.session(); }
    QImage picture() const { return window_->viewport().picture(); }
    std::string pathOf(const QString& name) const { return window_->folder.filePath(name).toStdString(); }
    void waitForPicture() const
    {
        if (!waitFor([this] { return window_->settled(); }))
            qFatal("the picture does not come");
    }
    void choose(const QString& mode) const
    {
        find<QAction>("action.mode." + mode).trigger();
        waitForPicture();
    }
    void set(const QString& parameter, double value) const
    {
        find<QDoubleSpinBox>("rendering.setting." + parameter).setValue(value);
        waitForPicture();
    }
    PickedValue pickedInTheMiddle() const;
    OffFile savedSurfaces(const QString& name) const;
    const TriangleMesh& meshOf(const std::string& drawable) const;
    std::vector<double> isovaluesSeen() const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void ExampleWindowTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("examples");
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(13), folder_.path().toStdString()).string());
}

/// With the model in full.
void ExampleWindowTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>(BackendChoice::Cpu, hostWithExamples());
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
    session().setError(0);
    QTRY_VERIFY(window_->settled());
}

/// A click in the middle of the picture, which finds a value.
PickedValue ExampleWindowTest::pickedInTheMiddle() const
{
    auto& pick = find<ValuePick>("viewport.pick");
    pick.forget();
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, window_->viewport().rect().center());
    if (!waitFor([&] { return pick.picked().has_value(); }))
        qFatal("nothing is picked");
    return *pick.picked();
}

/// By the dialog of the window, which offers the writer's files.
OffFile ExampleWindowTest::savedSurfaces(const QString& name) const
{
    const QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    find<QAction>("action.saveSurfaces").trigger();
    auto& dialog = find<QFileDialog>("surfaceDialog");
    if (dialog.nameFilters().filter("*.off").isEmpty())
        qFatal("OFF files are not offered: %s", qPrintable(dialog.nameFilters().join(", ")));
    dialog.selectFile(window_->folder.filePath(name));
    QMetaObject::invokeMethod(&dialog, "accept");
    if (!waitFor([&] { return saved.count() == 1; }))
        qFatal("nothing is saved: %s", qPrintable(window_->messages().join(", ")));
    return readOff(pathOf(name));
}

/// Of a surface of the scene.
const TriangleMesh& ExampleWindowTest::meshOf(const std::string& drawable) const
{
    const Drawable* found = drawableOf(*window_->viewport().scene(), drawable);
    const auto* surface = found != nullptr ? std::get_if<Surface>(&found->shape) : nullptr;
    if (surface == nullptr)
        qFatal("there is no surface %s", drawable.c_str());
    return *surface->mesh;
}

std::vector<double> ExampleWindowTest::isovaluesSeen() const
{
    std::vector<double> values;
    for (const Drawable& drawable : window_->viewport().scene()->drawables)
        if (drawable.value)
            values.push_back(*drawable.value);
    return values;
}

void ExampleWindowTest::allOfThemAreLoaded()
{
    window_->host->writers(); // and readers, which are loaded when they are asked for
    window_->host->readers();
    window_->host->builders();
    QStringList loaded;
    for (const PluginStatus& status : window_->host->plugins())
        if (status.metadata.id.starts_with("example.") && status.state == PluginState::Loaded)
            loaded << QString::fromStdString(status.metadata.id);
    loaded.sort();
    QCOMPARE(loaded, QStringList({"example.band-editor", "example.budget", "example.grid-text", "example.notes",
                                  "example.off", "example.projection", "example.shells", "example.slice"}));
}

void ExampleWindowTest::theSliceIsSeenPickedAndSaved()
{
    const ValueRange range = session().range();
    session().setTransfer({{{range.minimum, {1, 0, 0}}, {range.maximum, {0, 0, 1}}},
                           {{range.minimum, 1}, {range.maximum, 1}},
                           session().model()->diagonal()});
    choose("example.slice");
    const QImage withArrows = picture();
    const auto isColoured = [](const QColor& colour) { return std::abs(colour.red() - colour.blue()) > 60; };
    QVERIFY(pixelsThat(withArrows, isColoured) > withArrows.width() * withArrows.height() / 20);
    find<QCheckBox>("rendering.setting.arrows").click();
    waitForPicture();
    QVERIFY(picture() != withArrows);

    const Eigen::AlignedBox3d bounds = session().model()->description().bounds;
    const double heightOfAll = bounds.sizes().z();
    const auto mesh = window_->workbench.scenes().sceneBuilder().mesh();
    for (const double percent : {50.0, 40.0}) {
        set("height", percent);
        const PickedValue picked = pickedInTheMiddle();
        QVERIFY(!picked.onSurface); // it is no isosurface: each place tells its own
        QVERIFY(std::abs(picked.place.z() - (bounds.min().z() + heightOfAll * percent / 100)) < 1e-4 * heightOfAll);
        const auto expected = valueAt(mesh->mesh, picked.place);
        QVERIFY(expected && std::abs(picked.value - *expected) < 1e-3 * range.extent());
    }

    const std::string coloured = pathOf("slice.obj"); // with the colours that are seen
    const QSignalSpy saved(&window_->workbench.exporting(), &Exporting::meshSaved);
    window_->workbench.exporting().saveSurfaces(coloured);
    QTRY_COMPARE(saved.count(), 1);
    QVERIFY(coloursOfObj(coloured) ==
            std::vector<Colour>(meshOf("slice").colours.begin(), meshOf("slice").colours.end()));
    const auto [red, blue] = std::ranges::minmax(meshOf("slice").colours, {}, &Colour::blue);
    QVERIFY(blue.blue - red.blue > 0.1f && red.red > blue.red);

    const OffFile file = savedSurfaces("slice.off");
    QCOMPARE(file.positions.size(), meshOf("slice").positions.size());
    QCOMPARE(file.triangles, meshOf("slice").triangles.size());
    QVERIFY(file.triangles > 100);
    const double height = bounds.min().z() + heightOfAll * 0.4;
    QVERIFY(std::ranges::all_of(file.positions, [&](const Eigen::Vector3d& position) {
        return std::abs(static_cast<double>(position.z()) - height) < 1e-4 * heightOfAll;
    }));
}

void ExampleWindowTest::theProjectionShowsTheLargestValues()
{
    choose("example.projection");
    const int all = pixelsThat(picture(), isBlue);
    QVERIFY(all > picture().width() * picture().height() / 50);
    set("threshold", 100);
    const int largest = pixelsThat(picture(), isBlue); // the cells that have the largest value of all
    QVERIFY(largest < all / 2);
    set("threshold", 0);
    QCOMPARE(pixelsThat(picture(), isBlue), all);
}

void ExampleWindowTest::theBandOfTheShellsIsEditedInItsDock()
{
    auto& dock = find<QDockWidget>("dock.example.band-editor");
    auto& low = find<QDoubleSpinBox>("example.band.low");
    QCOMPARE(dock.windowTitle(), QString("Band"));
    QVERIFY(!low.isEnabled()); // this mode has no band
    choose("example.shells");
    QVERIFY(low.isEnabled());
    const std::vector<double> wholeRange = isovaluesSeen();
    QCOMPARE(wholeRange.size(), std::size_t(4));
    set("shells", 6);
    QCOMPARE(isovaluesSeen().size(), std::size_t(6));
    set("shells", 4);

    const int steps = session().undoStack().index();
    const double middle = (low.minimum() + low.maximum()) / 2;
    low.setValue(middle);
    QCOMPARE(session().undoStack().index(), steps + 1);
    waitForPicture();
    const std::vector<double> upperHalf = isovaluesSeen();
    QCOMPARE(upperHalf.size(), std::size_t(4));
    QVERIFY(std::ranges::min(upperHalf) > low.value() && std::ranges::max(upperHalf) < session().range().maximum);
    QVERIFY(std::ranges::min(wholeRange) < low.value());
    session().undoStack().undo();
    waitForPicture();
    QVERIFY(isovaluesSeen() == wholeRange);
    QCOMPARE(low.value(), low.minimum());
}

/// Seen beside the pointer, kept where one clicks, dragged to another place.
void ExampleWindowTest::valuesArePinnedByTheTool()
{
    auto& desk = find<ToolDesk>("viewport.toolDesk");
    Viewport& viewport = window_->viewport();
    choose("volume");
    find<QAction>("action.tool.example.notes").trigger();
    waitForPicture();
    const QPoint middle = viewport.rect().center();
    QVERIFY(desk.drawings().back().texts.empty());
    QMouseEvent hover(QEvent::MouseMove, middle, viewport.mapToGlobal(middle), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&viewport, &hover);
    QTRY_COMPARE(desk.drawings().back().texts.size(), std::size_t(1));
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, middle);
    QTRY_VERIFY(session().view().tools.contains("example.notes"));
    const auto handles = [&] { return desk.drawings().back().handles; };
    QCOMPARE(handles().size(), std::size_t(1));
    const auto pixelOf = [&](const Eigen::Vector3d& place) { return viewport.projection().pixelOf(place)->toPoint(); };
    QVERIFY((pixelOf(handles().front().place) - middle).manhattanLength() <= 1);
    const std::string pinned = session().view().tools.at("example.notes");
    QTest::keyClick(&viewport, Qt::Key_Return); // to the pin, which is moved by keys only where a value is seen
    QCOMPARE(desk.selected(), std::string("0"));
    QTest::mousePress(&viewport, Qt::LeftButton, {}, middle);
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, middle + QPoint(20, 12));
    QTRY_VERIFY(!desk.dragging());
    QVERIFY(session().view().tools.at("example.notes") != pinned);
    QVERIFY((pixelOf(handles().front().place) - middle - QPoint(20, 12)).manhattanLength() <= 2);
    session().undoStack().undo();
    QCOMPARE(session().view().tools.at("example.notes"), pinned);
    session().undoStack().undo();
    QVERIFY(session().view().tools.empty());
}

void ExampleWindowTest::isosurfacesAreWrittenByTheWriter()
{
    choose("isosurface");
    const OffFile file = savedSurfaces("surface.off");
    const TriangleMesh& surface = meshOf("isosurface-1");
    QVERIFY(file.triangles > 0);
    QCOMPARE(file.triangles, surface.triangles.size());
    QCOMPARE(file.positions.size(), surface.positions.size());
    for (std::size_t vertex = 0; vertex < file.positions.size(); ++vertex)
        QVERIFY(file.positions[vertex].isApprox(surface.positions[vertex], 1e-6f));
}

void ExampleWindowTest::aGridIsReadAndBuiltWithinABudget()
{
    const Dataset sample = sampleDataset(12);
    const std::string path = pathOf("sample.grid"), target = pathOf("within.tan");
    {
        std::ofstream file(path);
        file << "12 12 12\n";
        for (std::uint64_t point = 0; point < sample.pointCount(); ++point)
            file << sample.values.at(point) << '\n';
    }
    window_->window.open(QString::fromStdString(path));
    const auto& dataset = window_->workbench.opening().datasets().dataset();
    QTRY_VERIFY(dataset && dataset->source.path == path);
    QCOMPARE(dataset->pointCount(), sample.pointCount());

    auto& builder = find<QComboBox>("build.builder");
    QVERIFY(builder.currentData().toString() != "example.budget"); // TAn's own is proposed
    const int index = builder.findData("example.budget");
    QVERIFY(index >= 0);
    builder.setCurrentIndex(index);
    find<QDoubleSpinBox>("build.option.points").setValue(300);
    find<QLineEdit>("build.target").setText(QString::fromStdString(target));
    find<QPushButton>("build.start").click();
    QTRY_VERIFY(!window_->workbench.building().running() && session().model() && session().model()->path() == target);
    const Model& model = *session().model();
    QCOMPARE(model.description().builder, std::string("example.budget"));
    QVERIFY(model.siteCount() > 100 && model.siteCount() <= 300);
    QVERIFY(meshSizeAt(model, {.error = 0}).error > 0); // the budget ended it
    const auto report = verify(model, *dataset, {{.error = 20}, {.error = 5}, {.error = 0}});
    QVERIFY(report && report->ok());
    QTRY_VERIFY(window_->settled());
}

QTEST_MAIN(ExampleWindowTest)
#include "window_test.moc"
