// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/annotations/annotation_content.h"
#include "core/picture/session_document.h"
#include "core/picture/text_file.h"
#include "plugins/host/model_building.h"
#include "plugins/samples/samples.h"
#include "tests/core/render/scene_parts.h"
#include "tests/ui/languages.h"
#include "tests/ui/window_fixture.h"
#include "ui/opening/import_texts.h"
#include "ui/panels/parameter_form.h"
#include "ui/session/files.h"
#include "ui/viewport/value_pick.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLineEdit>

using namespace tetra;

/// The boundary of the mesh in the picture: its settings, how irregular models open, what sessions and clicks make of
/// it; and what else of forms depends on the data or the language.
class BoundaryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void irregularModelsOpenWithIt();
    void itsSettingsAreThoseThatMatter();
    void itIsAnEdit();
    void itFollowsTheMeshAndTheMode();
    void valuesHaveTheColoursOfTheTransferFunction();
    void sessionsKeepIt();
    void olderSessionsOpenAsTheyWere();
    void aClickOnItTellsItsValue();
    void itHidesNothingFromDoubleClicks();
    void buildOptionsAreThoseThatMatter();
    void wordsAreThoseOfTheUser();
    void theEstimateSaysHowSureItIs();

private:
    Session& session() const { return window_->workbench.session(); }
    testing::SceneParts scene() const { return testing::partsOf(*window_->viewport().scene()); }
    Surface boundary() const { return scene().surfaces.back(); }
    void open(const std::filesystem::path& file) const
    {
        window_->window.open(QString::fromStdString(file));
        QTRY_VERIFY_WITH_TIMEOUT(session().model() && session().model()->path() == file && window_->settled(), 30'000);
    }
    void choose(const char* shown) const
    {
        auto& box = window_->find<QComboBox>("rendering.setting.boundary");
        box.setCurrentIndex(box.findData(shown));
        emit box.activated(box.currentIndex());
        QTRY_VERIFY(window_->settled());
    }
    std::string savedSession() const
    {
        const auto document = window_->workbench.opening().sessions().document();
        return document ? sessionToText(*document, window_->folderPath()) : std::string();
    }
    void openSession(const std::string& text) const
    {
        window_->workbench.opening().models().close();
        const std::filesystem::path file = window_->folderPath() + "/opened.tansession";
        QVERIFY(writeTextFile(file, text));
        window_->workbench.opening().sessions().open(file, SessionSource::File);
        QTRY_VERIFY_WITH_TIMEOUT(session().model() && window_->settled(), 30'000);
    }

    QTemporaryDir folder_;
    std::filesystem::path part_;
    std::filesystem::path lattice_;
    std::unique_ptr<WindowFixture> window_;
};

void BoundaryTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("boundary");
    QLocale::setDefault(QLocale::c());
    const auto host = hostOfThisBuild();
    part_ = folder_.filePath("part.tan").toStdString();
    SampleRequest request;
    request.name = "part";
    request.size = 16;
    const auto part = makeSample(request);
    QVERIFY(part.ok());
    const auto built = buildModel(*host, *part, std::nullopt, {}, part_);
    QVERIFY2(built.ok(), built ? "" : built.error().text().c_str());
    lattice_ = buildSampleModel(*host, sampleDataset(10), folder_.path().toStdString());
}

void BoundaryTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(1280, 900);
    window_->window.show();
    open(part_);
}

void BoundaryTest::irregularModelsOpenWithIt()
{
    QCOMPARE(scene().surfaces.size(), std::size_t(2));
    QVERIFY(boundary().opacity < 0.5f && boundary().mesh->colours.empty() && !boundary().mesh->values.empty());
    QVERIFY(!session().undoStack().canUndo());
    open(lattice_);
    QVERIFY(session().view().appearance.settings.empty());
    QCOMPARE(scene().surfaces.size(), std::size_t(1));
    choose("translucent");
    QCOMPARE(scene().surfaces.size(), std::size_t(2));
    for (const Eigen::Vector3f& normal : boundary().mesh->normals)
        QCOMPARE(normal.cwiseAbs().maxCoeff(), 1.0f); // a box
}

void BoundaryTest::itsSettingsAreThoseThatMatter()
{
    const auto isShown = [&](const QString& id) {
        return !window_->find<QWidget>("rendering.setting." + id).isHidden();
    };
    QVERIFY(isShown("boundary-opacity") && isShown("boundary-far-side"));
    choose("values");
    QVERIFY(!isShown("boundary-opacity") && isShown("boundary-far-side") && isShown("lit"));
    choose("off");
    QVERIFY(!isShown("boundary-opacity") && !isShown("boundary-far-side") && !isShown("lit"));
    QCOMPARE(scene().surfaces.size(), std::size_t(1));
}

void BoundaryTest::itIsAnEdit()
{
    window_->find<QDoubleSpinBox>("rendering.setting.boundary-opacity").setValue(0.65);
    QTRY_VERIFY(window_->settled() && boundary().opacity == 0.65f);
    window_->find<QCheckBox>("rendering.setting.boundary-far-side").click();
    QTRY_VERIFY(window_->settled() && boundary().backFacesOnly);
    QCOMPARE(session().undoStack().index(), 2);
    auto& undo = window_->find<QAction>("action.undo");
    undo.trigger();
    QTRY_VERIFY(window_->settled() && !boundary().backFacesOnly);
    undo.trigger();
    QTRY_VERIFY(window_->settled() && boundary().opacity < 0.5f);
    QVERIFY(!window_->find<QCheckBox>("rendering.setting.boundary-far-side").isChecked());
}

void BoundaryTest::itFollowsTheMeshAndTheMode()
{
    const std::size_t fine = boundary().mesh->triangles.size();
    session().setError(20);
    QTRY_VERIFY(window_->settled() && boundary().mesh->triangles.size() < fine);
    for (const char* mode : {"volume", "hybrid", "focus", "isosurface"}) {
        window_->find<QAction>(QString("action.mode.") + mode).trigger();
        QTRY_VERIFY(window_->settled());
        QVERIFY2(!scene().surfaces.empty() && !boundary().mesh->values.empty(), mode);
    }
}

void BoundaryTest::valuesHaveTheColoursOfTheTransferFunction()
{
    const auto bar = [&] { return window_->workbench.scenes().annotations({}, {}).transfer; };
    QVERIFY(!bar());
    choose("values");
    QVERIFY(bar() && *bar() == session().view().appearance.transfer);
    QVERIFY(!boundary().mesh->colours.empty() && boundary().opacity == 1 && boundary().lit == false);
    TransferFunction green = session().view().appearance.transfer;
    for (ColourPoint& point : green.colours)
        point.colour = {0, 1, 0};
    session().setTransfer(green);
    QTRY_VERIFY(window_->settled() && boundary().mesh->colours.front() == (Colour{0, 1, 0}));
    window_->find<QCheckBox>("rendering.setting.lit").click();
    QTRY_VERIFY(window_->settled() && boundary().lit == true);
    window_->find<QAction>("action.undo").trigger();
    QTRY_VERIFY(window_->settled() && boundary().lit == false);
}

void BoundaryTest::sessionsKeepIt()
{
    choose("translucent");
    session().setSetting("boundary-opacity", 0.75);
    session().setSetting("boundary-far-side", true);
    QTRY_VERIFY(window_->settled());
    const ParameterValues settings = session().view().appearance.settings;
    openSession(savedSession());
    QVERIFY(session().view().appearance.settings == settings);
    QVERIFY(boundary().opacity == 0.75f && boundary().backFacesOnly);
    QCOMPARE(window_->find<QDoubleSpinBox>("rendering.setting.boundary-opacity").value(), 0.75);
}

/// Of when there was no boundary to show.
void BoundaryTest::olderSessionsOpenAsTheyWere()
{
    QJsonObject document = QJsonDocument::fromJson(QByteArray::fromStdString(savedSession())).object();
    QJsonObject look = document["look"].toObject();
    QVERIFY(look["settings"].toObject().contains("boundary"));
    look.remove("settings");
    document["look"] = look;
    openSession(QJsonDocument(document).toJson().toStdString());
    QCOMPARE(scene().surfaces.size(), std::size_t(1));
    QCOMPARE(window_->find<QComboBox>("rendering.setting.boundary").currentData().toString(), QString("off"));
}

void BoundaryTest::aClickOnItTellsItsValue()
{
    Isovalue hidden = session().view().isovalues.front();
    hidden.visible = false;
    session().setIsovalue(0, hidden);
    choose("values");
    const auto& pick = window_->find<ValuePick>("viewport.pick");
    QTest::mouseClick(&window_->viewport(), Qt::LeftButton, {}, window_->viewport().rect().center() + QPoint(40, 10));
    QTRY_VERIFY(!pick.busy());
    QVERIFY(pick.picked() && !pick.picked()->onSurface);
    // The value of the vertex there is near by.
    const auto kept = boundary().mesh;
    const TriangleMesh& mesh = *kept;
    const auto distance = [&](std::size_t v) {
        return (mesh.positions[v].cast<double>() - pick.picked()->place).norm();
    };
    std::size_t nearest = 0;
    for (std::size_t v = 1; v < mesh.positions.size(); ++v)
        nearest = distance(v) < distance(nearest) ? v : nearest;
    QVERIFY(distance(nearest) < 0.5);
    QVERIFY(std::abs(mesh.values[nearest] - pick.picked()->value) < 0.15 * session().range().extent());
}

/// A faint wall stands before the surface in it; what is seen most counts.
void BoundaryTest::itHidesNothingFromDoubleClicks()
{
    auto mesh = [](float y) {
        TriangleMesh wall;
        wall.positions = {{-9, y, -9}, {9, y, -9}, {0, y, 9}};
        wall.normals.assign(3, Eigen::Vector3f(0, -1, 0));
        wall.triangles = {{0, 1, 2}};
        return std::make_shared<const TriangleMesh>(std::move(wall));
    };
    testing::SceneParts seen;
    seen.bounds = {Eigen::Vector3d(-1, -1, -1), Eigen::Vector3d(1, 1, 1)};
    seen.surfaces = {{mesh(0.5f), {}, 1}, {mesh(-0.5f), {}, 0.2f}};
    Camera camera = fitted({}, seen.bounds);
    camera.azimuth = camera.elevation = 0;
    const ViewProjection projection(camera, QSizeF(100, 100));
    const auto depth = [&] {
        const auto place = seenPlace(seen, projection.pickingRay(QPointF(50, 50)));
        return place ? place->place.y() : 99.0;
    };
    QVERIFY(std::abs(depth() - 0.5) < 1e-6);
    seen.surfaces[1].opacity = 0.8f;
    QVERIFY(std::abs(depth() + 0.5) < 1e-6);
    seen.surfaces[1].backFacesOnly = true;
    QVERIFY(std::abs(depth() - 0.5) < 1e-6);
}

/// A lattice has no warping; its block sizes are words, too, in the language of the user.
void BoundaryTest::buildOptionsAreThoseThatMatter()
{
    window_->window.open(QString::fromStdString(writeNrrd(sampleDataset(8), window_->folderPath())));
    QTRY_VERIFY(window_->workbench.opening().datasets().dataset());
    auto& builder = window_->find<QComboBox>("build.builder");
    builder.setCurrentIndex(builder.findData("refinement"));
    const auto isShown = [&](const QString& id) { return !window_->find<QWidget>("build.option." + id).isHidden(); };
    QVERIFY(isShown("error") && isShown("block") && isShown("weights"));
    QVERIFY(!isShown("warping") && !isShown("selection"));
    builder.setCurrentIndex(builder.findData("decimation"));
    QVERIFY(!isShown("warping") && isShown("order"));
}

/// Also what is typed; the builder gets its own words.
void BoundaryTest::wordsAreThoseOfTheUser()
{
    const Speaking german("de");
    Parameter block;
    block.id = "block";
    block.defaultValue = std::string("automatic");
    block.words = {"automatic", "none"};
    ParameterForm form("form");
    form.setParameters({block});
    auto& line = *form.findChild<QLineEdit*>("form.block");
    QCOMPARE(line.text(), QString("automatisch"));
    QCOMPARE(std::get<std::string>(form.value("block")), std::string("automatic"));
    for (const auto& [typed, meant] :
         {std::pair("Keine", "none"), {"none", "none"}, {"automatic", "automatic"}, {"12", "12"}}) {
        line.setText(typed);
        QCOMPARE(std::get<std::string>(form.value("block")), std::string(meant));
    }
}

/// Where little is known of the data it is a limit; a field that takes few vertices takes less.
void BoundaryTest::theEstimateSaysHowSureItIs()
{
    const auto host = hostOfThisBuild();
    const Dataset sample = *makeSample({.name = "c60", .size = 32, .type = std::nullopt, .seed = 1});
    const BuildSize unknown{.domain = DomainClass::RegularLattice, .points = sample.pointCount()};
    BuildSize known = unknown;
    known.density = SiteDensity::of(sample);
    const auto estimate = [&](const BuildSize& size) {
        return *host->builder("refinement")->plugin->estimate(size, {}, 1);
    };
    QVERIFY(estimateText(unknown, estimate(unknown)).startsWith("The build takes up to"));
    QVERIFY(estimateText(known, estimate(known)).startsWith("The build takes about"));
    QVERIFY(estimate(known).modelBytes < estimate(unknown).modelBytes);
}

QTEST_MAIN(BoundaryTest)
#include "boundary_test.moc"
