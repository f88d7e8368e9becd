// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/appearance.h"
#include "plugins/widgets/colour_button.h"
#include "tests/core/render/scene_parts.h"
#include "tests/ui/window_fixture.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

#include <filesystem>
#include <string>

using namespace tetra;

/// Rendering modes and the camera in numbers (R27), by object names.
class RenderingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theModeChangesWithoutAnotherMesh();
    void settingsStayWhenTheModeChanges();
    void litVolumesHaveADarkGround();
    void draftsFollowTheUsualFunction();
    void settingsFollowAModelThatGrows();
    void whereTheDataAreMissingTheMeshIsShown();
    void aCropBoxShowsTheMeshInPlaceOfTheData();
    void aDefaultThatIsConfirmedIsNoEdit();
    void whatCouldNotBeDrawnIsForgottenWithTheNextPicture();
    void aSettingOfAnotherTypeIsLeftOut();
    void theFrameRateIsKept();
    void whatIsDrawnWhileMovingIsKept();
    void theFullPictureComesAfterTheIdleTime();
    void theCameraIsEditedInNumbers();
    void theCameraIsSavedAndLoaded();
    void theBackgroundIsChosen();
    void theValuesOfTheMeshAreCounted();

private:
    Session& session() const { return window_->workbench.session(); }
    const TransferFunction& function() const { return session().view().appearance.transfer; }
    int undoSteps() const { return session().undoStack().index(); }
    void undo() const { window_->find<QAction>("action.undo").trigger(); }
    void showVolume() const;
    void choose(const char* dialog, const QString& path) const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void RenderingTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("rendering");
    QSettings().clear();
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(16), folder_.path().toStdString()).string());
}

void RenderingTest::init()
{
    window_ = std::make_unique<WindowFixture>();
    window_->window.resize(1280, 900);
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
    const TransferFunction plain =
        sequentialTransferFunction(session().range().minimum, session().range().maximum, function().unitDistance);
    QVERIFY(!(function() == plain)); // but fitted to how the values share the volume
    session().setTransfer(plain);
    QTRY_VERIFY(window_->settled());
}

void RenderingTest::cleanup()
{
    window_.reset();
}

void RenderingTest::showVolume() const
{
    window_->find<QAction>("action.mode.volume").trigger();
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).volume);
}

/// What the user does in a file dialog.
void RenderingTest::choose(const char* dialog, const QString& path) const
{
    auto* found = window_->window.findChild<QFileDialog*>(dialog);
    QVERIFY2(found != nullptr, dialog);
    emit found->fileSelected(path);
    found->reject();
}

void RenderingTest::theModeChangesWithoutAnotherMesh()
{
    QSignalSpy scenes(&window_->workbench.scenes().sceneBuilder(), &SceneBuilder::sceneReady);
    QCOMPARE(session().view().appearance.mode, std::string("isosurface"));
    window_->find<QAction>("action.mode.volume").trigger();
    QTRY_COMPARE(scenes.count(), 1);
    QVERIFY(testing::partsOf(*scenes.last()[0].value<BuiltScene>().scene).volume.has_value());
    QCOMPARE(scenes.last()[0].value<BuiltScene>().extractionSeconds, 0.0);
    QVERIFY(window_->find<QWidget>("transfer").isVisible());
    auto& mode = window_->find<QComboBox>("rendering.mode");
    QCOMPARE(mode.currentData().toString(), QString("volume"));
    mode.setCurrentIndex(mode.findData("hybrid"));
    emit mode.activated(mode.currentIndex());
    QTRY_VERIFY(testing::partsOf(*window_->viewport().scene()).volume &&
                !testing::partsOf(*window_->viewport().scene()).surfaces.empty());
    QVERIFY(window_->find<QAction>("action.mode.hybrid").isChecked());
    undo();
    undo();
    QTRY_VERIFY(window_->settled() && !testing::partsOf(*window_->viewport().scene()).volume);
    QVERIFY(window_->find<QAction>("action.mode.isosurface").isChecked());
}

void RenderingTest::settingsStayWhenTheModeChanges()
{
    showVolume();
    window_->find<QCheckBox>("rendering.setting.shaded").click();
    QTRY_VERIFY(!testing::partsOf(*window_->viewport().scene()).volume->shaded);
    window_->find<QCheckBox>("rendering.setting.outline").click();
    window_->find<QAction>("action.mode.isosurface").trigger();
    QVERIFY(window_->window.findChild<QCheckBox*>("rendering.setting.shaded") == nullptr);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).lines.empty());
    window_->find<QAction>("action.mode.hybrid").trigger();
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).volume);
    QVERIFY(!testing::partsOf(*window_->viewport().scene()).volume->shaded);
    QVERIFY(!window_->find<QCheckBox>("rendering.setting.shaded").isChecked());
    auto& order = window_->find<QComboBox>("rendering.setting.order");
    order.setCurrentIndex(1);
    emit order.activated(1);
    QTRY_VERIFY(testing::partsOf(*window_->viewport().scene()).wholeCells);
    undo();
    QTRY_VERIFY(!testing::partsOf(*window_->viewport().scene()).wholeCells);
    QCOMPARE(order.currentIndex(), 0);
}

/// It is said once, and the data are seen when they are there.
void RenderingTest::whereTheDataAreMissingTheMeshIsShown()
{
    const Dataset data = sampleDataset(16);
    const auto file = folder_.path().toStdString() + "/" + data.source.name;
    std::filesystem::remove(file);
    showVolume();
    QSignalSpy missed(&window_->workbench.scenes().sceneBuilder(), &SceneBuilder::samplesMissed);
    session().setSetting("show", std::string("data"));
    QTRY_COMPARE(missed.count(), 1);
    QTRY_VERIFY(window_->settled() && testing::partsOf(*window_->viewport().scene()).volume);
    session().setSetting("shaded", false);
    QTRY_VERIFY(window_->settled() && !testing::partsOf(*window_->viewport().scene()).volume->shaded);
    QCOMPARE(missed.count(), 1);
    QCOMPARE(session().shown()->shown, ShownField::Mesh);
    writeNrrd(data, folder_.path().toStdString(), data.source.name);
    session().setSetting("show", std::string("mesh"));
    session().setSetting("show", std::string("data"));
    QTRY_VERIFY(window_->settled() && !shapesOf<SampledVolume>(*window_->viewport().scene()).empty());
    QCOMPARE(session().shown()->shown, ShownField::Data);
    QCOMPARE(missed.count(), 1);
}

/// The status bar says why.
void RenderingTest::aCropBoxShowsTheMeshInPlaceOfTheData()
{
    const Dataset data = sampleDataset(16);
    writeNrrd(data, folder_.path().toStdString(), data.source.name);
    showVolume();
    session().setSetting("show", std::string("data"));
    QTRY_COMPARE(session().shown()->shown, ShownField::Data);
    const auto says = [this](const QString& words) {
        const auto labels = window_->window.findChildren<QLabel*>();
        return std::ranges::any_of(labels, [&](const QLabel* label) { return label->text().contains(words); });
    };
    WindowState window = session().view().query.window;
    window.enabled = true;
    session().setWindow(window);
    QTRY_COMPARE(session().shown()->instead, MeshInstead::OfWindow);
    QTRY_VERIFY(says("; data are not shown with a crop box"));
    undo();
    QTRY_COMPARE(session().shown()->shown, ShownField::Data);
    QVERIFY(!says("; data are not shown with"));
}

/// Behind a lit volume the ground is dark, unless another one was chosen; behind all else it fits the window.
void RenderingTest::litVolumesHaveADarkGround()
{
    const auto ground = [this] { return window_->viewport().background(); };
    const Colour light = ground();
    QVERIFY(light.red > 0.8F);
    showVolume();
    QVERIFY(testing::partsOf(*window_->viewport().scene()).volume->shaded);
    QVERIFY(ground().red < 0.2F && !session().view().background);
    auto& shaded = window_->find<QCheckBox>("rendering.setting.shaded");
    shaded.click();
    QCOMPARE(ground(), light);
    shaded.click();
    QVERIFY(ground().red < 0.2F);
    session().setBackground(Colour{0, 0.5F, 0});
    QCOMPARE(ground(), (Colour{0, 0.5F, 0}));
    undo();
    QVERIFY(ground().red < 0.2F);
    window_->find<QAction>("action.mode.isosurface").trigger();
    QCOMPARE(ground(), light);
}

/// While nobody has chosen one, moving pictures have functions of their own.
void RenderingTest::draftsFollowTheUsualFunction()
{
    showVolume();
    const auto request = [this] { return window_->workbench.scenes().sceneRequest(); };
    QVERIFY(!request().usualTransfer); // the plain function was chosen
    session().setTransfer(window_->workbench.scenes().startingView().appearance.transfer);
    QVERIFY(request().usualTransfer);
    undo();
    QVERIFY(!request().usualTransfer);
}

/// A model that grows may have an object, around which no box is drawn, where a coarser one had none.
void RenderingTest::settingsFollowAModelThatGrows()
{
    const auto outline = [this] { return window_->find<QCheckBox>("rendering.setting.outline").isChecked(); };
    auto& scenes = window_->workbench.scenes();
    FieldExtent field = scenes.extent();
    const auto grow = [&](std::vector<Eigen::Vector3d> object) {
        field.object = std::move(object);
        scenes.setExtent(field);
        session().grow(session().model(), session().view().isovalues, session().view().appearance, field.object);
    };
    grow({});
    QVERIFY(outline());
    grow({{1, 1, 1}, {2, 2, 2}});
    QVERIFY(!outline());
}

void RenderingTest::aDefaultThatIsConfirmedIsNoEdit()
{
    showVolume();
    const int steps = undoSteps();
    auto& clip = window_->find<QLineEdit>("rendering.setting.clip");
    QTest::keyClick(&clip, Qt::Key_Return);
    QCOMPARE(undoSteps(), steps);
    clip.setText("1,0,0,2");
    QTest::keyClick(&clip, Qt::Key_Return);
    QCOMPARE(undoSteps(), steps + 1);
    clip.clear();
    QTest::keyClick(&clip, Qt::Key_Return);
    QCOMPARE(undoSteps(), steps + 2);
    QTRY_VERIFY(window_->settled() && window_->viewport().scene()->clipPlanes.empty());
}

/// What was told of something else stays.
void RenderingTest::whatCouldNotBeDrawnIsForgottenWithTheNextPicture()
{
    showVolume();
    window_->find<MessageBar>("messages").add("Something else");
    session().setSetting("clip", std::string("no plane"));
    QTRY_COMPARE(window_->messages().size(), 2);
    undo();
    QTRY_COMPARE(window_->messages(), QStringList{"Something else"});
}

void RenderingTest::aSettingOfAnotherTypeIsLeftOut()
{
    Parameter choice;
    choice.id = "order";
    choice.defaultValue = std::string("a");
    choice.choices = {"a", "b"};
    Appearance look;
    look.settings = {{"order", std::string("c")}};
    QVERIFY(rendererValues({choice}, look, {}).empty());
    look.settings["order"] = true;
    QVERIFY(rendererValues({choice}, look, {}).empty());
    look.settings["order"] = std::string("b");
    QCOMPARE(rendererValues({choice}, look, {}).size(), std::size_t{1});
}

void RenderingTest::theFrameRateIsKept()
{
    window_->find<QSpinBox>("rendering.frameRate").setValue(24);
    window_ = std::make_unique<WindowFixture>();
    QCOMPARE(window_->find<QSpinBox>("rendering.frameRate").value(), 24);
    window_->find<QSpinBox>("rendering.frameRate").setValue(0);
}

/// C4
void RenderingTest::whatIsDrawnWhileMovingIsKept()
{
    window_->find<QComboBox>("rendering.moving").setCurrentIndex(2);
    window_->find<QSpinBox>("rendering.movingShare").setValue(33);
    window_->find<QSpinBox>("rendering.idleTime").setValue(700);
    window_ = std::make_unique<WindowFixture>();
    QCOMPARE(window_->find<QComboBox>("rendering.moving").currentData().toString(), QString("share"));
    QCOMPARE(window_->find<QSpinBox>("rendering.movingShare").value(), 33);
    QCOMPARE(window_->find<QSpinBox>("rendering.idleTime").value(), 700);
    QCOMPARE(window_->viewport().idleTime(), std::chrono::milliseconds(700));
    window_->find<QComboBox>("rendering.moving").setCurrentIndex(0);
    window_->find<QSpinBox>("rendering.idleTime").setValue(150);
}

/// C4
void RenderingTest::theFullPictureComesAfterTheIdleTime()
{
    constexpr int idle = 900;
    window_->find<QSpinBox>("rendering.idleTime").setValue(idle);
    QElapsedTimer clock;
    clock.start();
    Viewport& viewport = window_->viewport();
    viewport.setCamera(turned(viewport.camera(), 10, 0));
    QVERIFY(!viewport.settled());
    QTRY_VERIFY_WITH_TIMEOUT(viewport.settled(), 60'000);
    QVERIFY(clock.elapsed() >= idle);
    window_->find<QSpinBox>("rendering.idleTime").setValue(150);
}

void RenderingTest::theCameraIsEditedInNumbers()
{
    Viewport& viewport = window_->viewport();
    window_->find<QDoubleSpinBox>("view.azimuth").setValue(75);
    window_->find<QDoubleSpinBox>("view.elevation").setValue(-12);
    window_->find<QDoubleSpinBox>("view.fieldOfView").setValue(50);
    window_->find<QDoubleSpinBox>("view.target.x").setValue(3);
    QCOMPARE(viewport.camera().azimuth, 75.0);
    QCOMPARE(viewport.camera().elevation, -12.0);
    QCOMPARE(viewport.camera().fieldOfView, 50.0);
    QCOMPARE(viewport.camera().target.x(), 3.0);
    auto& projection = window_->find<QComboBox>("view.projection");
    projection.setCurrentIndex(1);
    emit projection.activated(1);
    QVERIFY(!viewport.camera().perspective);
    QVERIFY(!window_->find<QAction>("action.perspective").isChecked());
    window_->find<QPushButton>("view.from.top").click();
    QCOMPARE(window_->find<QDoubleSpinBox>("view.elevation").value(), 90.0);
    window_->find<QPushButton>("view.fit").click();
    QTRY_VERIFY(window_->settled());
}

void RenderingTest::theCameraIsSavedAndLoaded()
{
    Viewport& viewport = window_->viewport();
    window_->find<QDoubleSpinBox>("view.azimuth").setValue(75);
    const Camera before = viewport.camera();
    const QString path = window_->folder.filePath("camera.json");
    QTest::mouseClick(&window_->find<QPushButton>("view.save"), Qt::LeftButton);
    choose("cameraSaveDialog", path);
    QTRY_VERIFY(QFile::exists(path));
    window_->find<QPushButton>("view.from.top").click();
    QTest::mouseClick(&window_->find<QPushButton>("view.load"), Qt::LeftButton);
    choose("cameraDialog", path);
    QTRY_COMPARE(viewport.camera(), before);
}

void RenderingTest::theBackgroundIsChosen()
{
    auto& colour = window_->find<ColourButton>("view.background");
    const Colour usual = window_->viewport().background();
    emit colour.colourChosen(QColor(10, 20, 30));
    QTRY_VERIFY(window_->settled());
    QCOMPARE(window_->viewport().picture().pixelColor(2, 2), QColor(10, 20, 30));
    window_->find<QToolButton>("view.usualBackground").click();
    QCOMPARE(window_->viewport().background(), usual);
}

void RenderingTest::theValuesOfTheMeshAreCounted()
{
    const auto histogram = session().shown()->histogram;
    QVERIFY(histogram);
    std::uint64_t sum = 0;
    for (const std::uint64_t count : histogram->counts)
        sum += count;
    QCOMPARE(sum, session().shown()->vertices);
}

QTEST_MAIN(RenderingTest)
#include "rendering_test.moc"
