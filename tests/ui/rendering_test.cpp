// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/panels/transfer_canvas.h"
#include "ui/widgets/colour_button.h"

#include "core/graphics/camera_text.h"
#include "core/transfer/default_transfer_functions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>

using namespace tetra;

/// Rendering modes, the editor of the transfer function and the camera in numbers (R18, R27), by object names.
class RenderingTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void theModeChangesWithoutAnotherMesh();
    void settingsStayWhenTheModeChanges();
    void aDefaultThatIsConfirmedIsNoEdit();
    void aSettingOfAnotherTypeIsLeftOut();
    void theFrameRateIsKept();
    void aDragIsOneStepAndThePictureFollows();
    void pointsAreEditedByKeys();
    void doubleClickAddsAPoint();
    void pointsAreEditedInNumbers();
    void aPointIsMadeAStep();
    void allPointsAreChanged();
    void theCameraIsEditedInNumbers();
    void theCameraIsSavedAndLoaded();
    void theBackgroundIsChosen();
    void theValuesOfTheMeshAreCounted();

private:
    Session& session() const { return window_->workbench.session(); }
    const TransferFunction& function() const { return session().view().look().transfer; }
    TransferCanvas& canvas() const { return window_->find<TransferCanvas>("transfer.canvas"); }
    QPoint placeOf(std::size_t point) const { return canvas().plot().place(function().points[point]).toPoint(); }
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
    QTRY_VERIFY(window_->settled() && window_->viewport().scene()->volume);
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
    QSignalSpy scenes(&window_->workbench.sceneBuilder(), &SceneBuilder::sceneReady);
    QCOMPARE(session().view().look().mode, std::string("isosurface"));
    window_->find<QAction>("action.mode.volume").trigger();
    QTRY_COMPARE(scenes.count(), 1);
    QVERIFY(scenes.last()[0].value<BuiltScene>().scene->volume.has_value());
    QCOMPARE(scenes.last()[0].value<BuiltScene>().extractionSeconds, 0.0);
    QVERIFY(window_->find<QWidget>("transfer").isVisible());
    auto& mode = window_->find<QComboBox>("rendering.mode");
    QCOMPARE(mode.currentData().toString(), QString("volume"));
    mode.setCurrentIndex(mode.findData("hybrid"));
    emit mode.activated(mode.currentIndex());
    QTRY_VERIFY(window_->viewport().scene()->volume && !window_->viewport().scene()->surfaces.empty());
    QVERIFY(window_->find<QAction>("action.mode.hybrid").isChecked());
    undo();
    undo();
    QTRY_VERIFY(window_->settled() && !window_->viewport().scene()->volume);
    QVERIFY(window_->find<QAction>("action.mode.isosurface").isChecked());
}

void RenderingTest::settingsStayWhenTheModeChanges()
{
    showVolume();
    window_->find<QCheckBox>("rendering.setting.shaded").click();
    QTRY_VERIFY(window_->viewport().scene()->volume->shaded);
    window_->find<QCheckBox>("rendering.setting.outline").click();
    window_->find<QAction>("action.mode.isosurface").trigger();
    QVERIFY(window_->window.findChild<QCheckBox*>("rendering.setting.shaded") == nullptr);
    QTRY_VERIFY(window_->settled() && window_->viewport().scene()->lines.empty());
    window_->find<QAction>("action.mode.hybrid").trigger();
    QTRY_VERIFY(window_->settled() && window_->viewport().scene()->volume);
    QVERIFY(window_->viewport().scene()->volume->shaded);
    QVERIFY(window_->find<QCheckBox>("rendering.setting.shaded").isChecked());
    auto& order = window_->find<QComboBox>("rendering.setting.order");
    order.setCurrentIndex(1);
    emit order.activated(1);
    QTRY_COMPARE(window_->viewport().scene()->hybridOrder, HybridOrder::WithCell);
    undo();
    QTRY_COMPARE(window_->viewport().scene()->hybridOrder, HybridOrder::Exact);
    QCOMPARE(order.currentIndex(), 0);
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

void RenderingTest::aSettingOfAnotherTypeIsLeftOut()
{
    Parameter choice;
    choice.id = "order";
    choice.defaultValue = std::string("a");
    choice.choices = {"a", "b"};
    Look look;
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

void RenderingTest::aDragIsOneStepAndThePictureFollows()
{
    showVolume();
    const TransferFunction before = function();
    const int steps = undoSteps();
    const auto scene = window_->viewport().scene();
    const QPoint from = placeOf(4);
    QTest::mousePress(&canvas(), Qt::LeftButton, {}, from);
    QCOMPARE(canvas().selected(), std::size_t{4});
    for (int i = 1; i <= 6; ++i) {
        const QPoint to = from + QPoint(i, -3 * i);
        QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&canvas(), &move);
    }
    QVERIFY(!window_->viewport().settled()); // quick pictures while it is dragged
    QTRY_VERIFY(window_->viewport().scene() != scene);
    QTest::mouseRelease(&canvas(), Qt::LeftButton, {}, from + QPoint(6, -18));
    QVERIFY(function().points[4].opacity > before.points[4].opacity);
    QVERIFY(function().points[4].value > before.points[4].value);
    QCOMPARE(undoSteps(), steps + 1);
    QTRY_VERIFY(window_->settled());
    undo();
    QCOMPARE(function(), before);
}

void RenderingTest::pointsAreEditedByKeys()
{
    showVolume();
    canvas().setFocus();
    const std::size_t count = function().points.size();
    QTest::keyClick(&canvas(), Qt::Key_Tab);
    QTest::keyClick(&canvas(), Qt::Key_Tab);
    QCOMPARE(canvas().selected(), std::size_t{1});
    QTest::keyClick(&canvas(), Qt::Key_Backtab);
    QCOMPARE(canvas().selected(), std::size_t{0});
    QTest::keyClick(&canvas(), Qt::Key_Tab);
    const TransferPoint before = function().points[1];
    QTest::keyClick(&canvas(), Qt::Key_Right);
    QTest::keyClick(&canvas(), Qt::Key_Up);
    QVERIFY(function().points[1].value > before.value);
    QVERIFY(function().points[1].opacity > before.opacity);
    QVERIFY(canvas().accessibleDescription().contains("Point 2 of 9"));
    QTest::keyClick(&canvas(), Qt::Key_Delete);
    QCOMPARE(function().points.size(), count - 1);
    canvas().select(function().points.size() - 1);
    QTest::keyClick(&canvas(), Qt::Key_Tab); // on to the next control
    QVERIFY(!canvas().hasFocus());
}

void RenderingTest::doubleClickAddsAPoint()
{
    showVolume();
    const std::size_t count = function().points.size();
    const int steps = undoSteps();
    const QPoint place = canvas().plot().area.center().toPoint() + QPoint(13, -40);
    QTest::mouseDClick(&canvas(), Qt::LeftButton, {}, place);
    QCOMPARE(function().points.size(), count + 1);
    QVERIFY(canvas().selected().has_value());
    QVERIFY((placeOf(*canvas().selected()) - place).manhattanLength() <= 2);
    QCOMPARE(undoSteps(), steps + 1);
}

void RenderingTest::pointsAreEditedInNumbers()
{
    showVolume();
    QVERIFY(!window_->find<QDoubleSpinBox>("transfer.value").isEnabled());
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, placeOf(4));
    auto& value = window_->find<QDoubleSpinBox>("transfer.value");
    value.setValue(value.value() + 3);
    QCOMPARE(function().points[4].value, value.value());
    window_->find<QDoubleSpinBox>("transfer.opacity").setValue(62.5);
    QCOMPARE(function().points[4].opacity, 0.625F);
    window_->find<QDoubleSpinBox>("transfer.unitDistance").setValue(2);
    QCOMPARE(function().unitDistance, 2.0);
    QTest::mouseClick(&window_->find<QPushButton>("transfer.add"), Qt::LeftButton);
    QCOMPARE(canvas().selected(), std::size_t{5});
    QTest::mouseClick(&window_->find<QPushButton>("transfer.remove"), Qt::LeftButton);
    QCOMPARE(function().points.size(), std::size_t{9});
}

void RenderingTest::aPointIsMadeAStep()
{
    showVolume();
    QTest::mouseClick(&canvas(), Qt::LeftButton, {}, placeOf(4));
    auto& step = window_->find<QCheckBox>("transfer.step");
    step.click();
    QVERIFY(isOnStep(function(), 4));
    window_->find<QDoubleSpinBox>("transfer.opacity").setValue(0);
    QVERIFY(function().points[4].opacity != function().points[5].opacity);
    QCOMPARE(function().points[4].value, function().points[5].value);
    QTRY_VERIFY(window_->settled());
    step.click();
    QCOMPARE(function().points.size(), std::size_t{9});
    QCOMPARE(function().points[4].opacity, 0.0F);
}

void RenderingTest::allPointsAreChanged()
{
    showVolume();
    const TransferFunction before = function();
    const ValueRange range = session().range();
    window_->find<QAction>("transfer.preset.diverging").trigger();
    QCOMPARE(function(), divergingTransferFunction(range.minimum, range.maximum, before.unitDistance));
    undo();
    window_->find<QAction>("transfer.change.mirror").trigger();
    QCOMPARE(function().points.front().opacity, before.points.back().opacity);
    window_->find<QAction>("transfer.change.thinner").trigger();
    QVERIFY(function().points.front().opacity < before.points.back().opacity);
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
