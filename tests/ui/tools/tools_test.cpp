// SPDX-License-Identifier: GPL-3.0-or-later
/// The tools of plugins in the window (D17): chosen, clicked, dragged and used by keys, undone, saved.
#include "tests/ui/window_fixture.h"
#include "tests/waiting.h"
#include "ui/dialogs/picture_orders.h"
#include "ui/scenes/picture_image.h"
#include "ui/tools/tool_desk.h"
#include "ui/viewport/value_pick.h"

#include <QClipboard>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFocusEvent>
#include <QGuiApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>

#include <cmath>
#include <numbers>

using namespace tetra;

class ToolsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup() { window_.reset(); }
    void oneToolAtATimeIsChosen();
    void clicksMeasureWhatIsSeen();
    void besideEverythingThePlaceLiesInThePlaneOfThePicture_data();
    void besideEverythingThePlaceLiesInThePlaneOfThePicture();
    void aDragIsOneStepAndEscapeIsNone();
    void aMereClickOnAHandleSelectsIt();
    void whatIsHeldIsLetGoWithKeysAndModel();
    void numbersAreTypedWhole();
    void allIsDoneByKeys();
    void whatWasMeasuredIsCopied();
    void savedPicturesHaveWhatToolsKeep();
    void aSessionKeepsWhatToolsKeepAndWhatToolsKeptThatAreNotThere();
    void thePlaneCutsThePictureOpen();
    void aToolThatThrowsIsToldAndChangesNothing();

private:
    Session& session() const { return window_->workbench.session(); }
    ToolDesk& desk() const { return window_->find<ToolDesk>("viewport.toolDesk"); }
    Viewport& viewport() const { return window_->viewport(); }
    QPoint middle() const { return viewport().rect().center(); }
    /// Its panel comes, and the picture has another size.
    void choose(const char* tool) const
    {
        window_->find<QAction>(QString("action.tool.") + tool).trigger();
        QCoreApplication::processEvents();
        if (!waitFor([this] { return window_->settled(); }))
            qFatal("the picture does not come");
    }
    std::string kept(const char* tool) const
    {
        const auto found = session().view().tools.find(tool);
        return found != session().view().tools.end() ? found->second : std::string();
    }
    /// The places of the handles that the chosen tool has.
    std::vector<Eigen::Vector3d> handles() const
    {
        std::vector<Eigen::Vector3d> places;
        for (const ToolHandle& handle : desk().drawings().back().handles)
            places.push_back(handle.place);
        return places;
    }
    QPoint pixelOf(const Eigen::Vector3d& place) const { return viewport().projection().pixelOf(place)->toPoint(); }
    void click(QPoint place) const
    {
        QTest::mouseClick(&viewport(), Qt::LeftButton, {}, place);
        if (!waitFor([this] { return !desk().seeking(); }))
            qFatal("nothing is found");
    }
    void moveMouse(QPoint to, Qt::KeyboardModifiers modifiers = {}) const
    {
        QMouseEvent move(QEvent::MouseMove, to, viewport().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, modifiers);
        QCoreApplication::sendEvent(&viewport(), &move);
    }
    void drag(QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) const
    {
        QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
        for (int step = 1; step <= 4; ++step)
            moveMouse(from + step * (to - from) / 4, modifiers);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, modifiers, to);
        if (!waitFor([this] { return !desk().dragging(); }))
            qFatal("the drag does not end");
    }
    void press(Qt::Key key) const { QTest::keyClick(&viewport(), key); }
    int steps() const { return session().undoStack().index(); }
    ClipPlane clip() const;

    QTemporaryDir folder_;
    QString model_;
    std::unique_ptr<WindowFixture> window_;
};

void ToolsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("tools");
    QLocale::setDefault(QLocale::c());
    model_ = QString::fromStdString(
        buildSampleModel(*hostOfThisBuild(), sampleDataset(8), folder_.path().toStdString()).string());
}

void ToolsTest::init()
{
    QSettings().clear();
    window_ = std::make_unique<WindowFixture>(
        BackendChoice::Cpu,
        std::make_unique<PluginHost>(PluginHostOptions{
            .folders = {TAN_BINARY_DIR "/lib/tan/plugins", TAN_BINARY_DIR "/tests/ui-fixtures/tools"}}));
    for (QDockWidget* dock : window_->window.findChildren<QDockWidget*>())
        dock->hide();
    window_->window.resize(800, 500);
    window_->window.show();
    window_->window.open(model_);
    QTRY_VERIFY(session().model() && window_->settled());
}

void ToolsTest::oneToolAtATimeIsChosen()
{
    auto& ruler = window_->find<QAction>("action.tool.ruler");
    auto& plane = window_->find<QAction>("action.tool.plane");
    QVERIFY(!ruler.icon().isNull() && !plane.icon().isNull());
    QCOMPARE(ruler.text().remove('&'), QString("Ruler"));
    QVERIFY(ruler.toolTip().endsWith("(" + ruler.shortcut().toString() + ")"));
    QVERIFY(!window_->find<QDockWidget>("dock.tools").isVisible());
    ruler.trigger();
    QCOMPARE(desk().chosen(), std::string("ruler"));
    QVERIFY(window_->find<QDockWidget>("dock.tools").isVisible());
    QVERIFY(window_->find<QPushButton>("tool.ruler.command.new").isVisible());
    plane.trigger();
    QCOMPARE(desk().chosen(), std::string("plane"));
    QVERIFY(!ruler.isChecked() && plane.isChecked());
    QCOMPARE(window_->window.findChild<QPushButton*>("tool.ruler.command.new"), nullptr);
    plane.trigger();
    QVERIFY(desk().chosen().empty());
    QCOMPARE(steps(), 0); // choosing is no edit
    ruler.trigger();
    window_->workbench.opening().close();
    QVERIFY(desk().chosen().empty() && !ruler.isEnabled() && !ruler.isChecked());
}

void ToolsTest::clicksMeasureWhatIsSeen()
{
    choose("ruler");
    click(middle());
    click(middle() + QPoint(15, 10));
    QCOMPARE(steps(), 2);
    const auto places = handles();
    QCOMPARE(places.size(), std::size_t(2));
    // On the surface: at the pixels that were clicked, and not in the plane of the picture.
    QVERIFY((pixelOf(places[0]) - middle()).manhattanLength() <= 1);
    QVERIFY((pixelOf(places[1]) - middle() - QPoint(15, 10)).manhattanLength() <= 1);
    const auto& camera = viewport().camera();
    QVERIFY(std::abs((places[0] - camera.target).dot(viewport().projection().towardsViewer())) > 1e-3);
    QVERIFY(!window_->find<ValuePick>("viewport.pick").picked());
    QVERIFY(!window_->find<ValuePick>("viewport.pick").busy());
    const Camera before = camera;
    drag(QPoint(20, 20), QPoint(60, 40)); // beside the handles the camera turns
    QVERIFY(viewport().camera() != before);
    QCOMPARE(handles().size(), std::size_t(2));
    for (int step = 0; step < 3; ++step)
        session().undoStack().undo();
    QVERIFY(kept("ruler").empty());
    QVERIFY(!session().view().tools.contains("ruler"));
}

void ToolsTest::besideEverythingThePlaceLiesInThePlaneOfThePicture_data()
{
    QTest::addColumn<bool>("perspective");
    QTest::newRow("perspective") << true;
    QTest::newRow("parallel") << false;
}

void ToolsTest::besideEverythingThePlaceLiesInThePlaneOfThePicture()
{
    QFETCH(bool, perspective);
    Camera camera = session().view().camera;
    camera.perspective = perspective;
    camera.roll = 25;
    camera.target += Eigen::Vector3d(0.5, -0.25, 1);
    viewport().setCamera(camera);
    QTRY_VERIFY(window_->settled());
    choose("ruler");
    const std::array pixels{QPoint(3, 4), QPoint(viewport().width() - 5, viewport().height() - 3)};
    for (const QPoint pixel : pixels)
        click(pixel);
    const auto places = handles();
    QCOMPARE(places.size(), std::size_t(2));
    const Eigen::Vector3d towards = (eyePosition(camera) - camera.target).normalized();
    for (std::size_t i = 0; i < 2; ++i) {
        QVERIFY(std::abs((places[i] - camera.target).dot(towards)) < 1e-9 * camera.distance);
        const QPointF seen = *viewport().projection().pixelOf(places[i]);
        QVERIFY((seen - pixels[i]).manhattanLength() < 1e-6);
    }
    // By the field of view, which spans the shorter side: the length of a pixel at the target.
    const double pixel = 2 * camera.distance * std::tan(camera.fieldOfView * std::numbers::pi / 360) /
                         std::min(viewport().width(), viewport().height());
    const QPoint between = pixels[1] - pixels[0];
    QVERIFY(std::abs((places[1] - places[0]).norm() - pixel * std::hypot(between.x(), between.y())) <
            1e-9 * camera.distance);
}

void ToolsTest::aDragIsOneStepAndEscapeIsNone()
{
    choose("ruler");
    click(QPoint(5, 5));
    click(QPoint(5, 60));
    const int before = steps();
    const auto places = handles();
    drag(pixelOf(places[1]) + QPoint(2, 1), middle() + QPoint(2, 1)); // grabbed beside its middle
    QCOMPARE(steps(), before + 1);
    QVERIFY((pixelOf(handles()[1]) - middle()).manhattanLength() <= 1);
    QVERIFY(handles()[0] == places[0]);
    const std::string value = kept("ruler");
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, pixelOf(handles()[0]));
    moveMouse(pixelOf(handles()[0]) + QPoint(40, 40));
    QTRY_VERIFY(kept("ruler") != value);
    press(Qt::Key_Escape);
    QVERIFY(!desk().dragging());
    QCOMPARE(kept("ruler"), value);
    QCOMPARE(steps(), before + 1);
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, QPoint(50, 50));
    QCOMPARE(kept("ruler"), value);
    session().undoStack().undo();
    QVERIFY(handles()[1] == places[1]);
}

void ToolsTest::aMereClickOnAHandleSelectsIt()
{
    choose("ruler");
    click(QPoint(5, 5));
    click(QPoint(5, 60));
    const std::string value = kept("ruler");
    const int before = steps();
    const QPoint place = pixelOf(handles()[1]) + QPoint(2, 1);
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, place);
    moveMouse(place + QPoint(1, 0)); // as a hand does that clicks
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, place + QPoint(1, 0));
    QTRY_VERIFY(!desk().dragging() && !desk().seeking());
    QCOMPARE(kept("ruler"), value);
    QCOMPARE(steps(), before);
    QCOMPARE(desk().selected(), std::string("0.1"));
    QVERIFY(!viewport().accessibleDescription().isEmpty());
    press(Qt::Key_Escape);
    QVERIFY(viewport().accessibleDescription().isEmpty());
}

/// The button is still down when a dialog takes the keys, or when a model that was loading comes.
void ToolsTest::whatIsHeldIsLetGoWithKeysAndModel()
{
    choose("ruler");
    click(QPoint(5, 5));
    const Camera camera = viewport().camera();
    std::string value = kept("ruler");
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, pixelOf(handles()[0]));
    moveMouse(QPoint(45, 45));
    QTRY_VERIFY(kept("ruler") != value && !desk().seeking());
    QFocusEvent away(QEvent::FocusOut);
    QCoreApplication::sendEvent(&viewport(), &away);
    QVERIFY(!desk().dragging());
    value = kept("ruler");
    moveMouse(QPoint(90, 20));
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, QPoint(90, 20));
    QTRY_VERIFY(!desk().seeking());
    QCOMPARE(kept("ruler"), value);
    QVERIFY(viewport().camera() == camera);
    const QString other = folder_.filePath("other.tan");
    QVERIFY(QFile::exists(other) || QFile::copy(model_, other));
    QTest::mousePress(&viewport(), Qt::LeftButton, {}, pixelOf(handles()[0]));
    moveMouse(QPoint(60, 60));
    const auto model = session().model();
    window_->window.open(other);
    QTRY_VERIFY(session().model() && session().model() != model && window_->settled());
    QVERIFY(!desk().dragging() && !session().inGesture());
    const ViewValue view = session().view();
    moveMouse(QPoint(90, 90));
    QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, QPoint(90, 90));
    QTRY_VERIFY(!desk().seeking());
    QVERIFY(session().view() == view);
}

void ToolsTest::numbersAreTypedWhole()
{
    choose("plane");
    click(middle());
    QTRY_VERIFY(window_->settled());
    auto& box = window_->find<QDoubleSpinBox>("tool.plane.offset");
    const int before = steps();
    const double typed = std::copysign(2.75, box.value());
    QVERIFY(box.value() != typed);
    box.setFocus();
    box.selectAll();
    QTest::keyClicks(&box, QString::number(typed));
    QCOMPARE(steps(), before);
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(steps(), before + 1);
    QCOMPARE(clip().offset, typed);
}

void ToolsTest::allIsDoneByKeys()
{
    choose("ruler");
    press(Qt::Key_Space);
    QTRY_COMPARE(handles().size(), std::size_t(1));
    QVERIFY(desk().selected().empty());
    press(Qt::Key_Return);
    QCOMPARE(desk().selected(), std::string("0.0"));
    const Eigen::Vector3d place = handles()[0];
    const Camera camera = viewport().camera();
    const int before = steps();
    for (const bool repeated : {false, true, true}) {
        QKeyEvent pressed(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, {}, repeated);
        QCoreApplication::sendEvent(&viewport(), &pressed);
    }
    QKeyEvent released(QEvent::KeyRelease, Qt::Key_Right, Qt::NoModifier);
    QCoreApplication::sendEvent(&viewport(), &released);
    QCOMPARE(steps(), before + 1);
    QVERIFY(viewport().camera() == camera);
    const Eigen::Vector3d moved = handles()[0] - place;
    QVERIFY((moved - 0.03 * session().model()->diagonal() * viewport().projection().right()).norm() < 1e-9);
    press(Qt::Key_Escape);
    QVERIFY(desk().selected().empty());
    press(Qt::Key_Left); // nothing is selected: the camera gets it
    QVERIFY(viewport().camera() != camera);
    press(Qt::Key_Delete);
    QVERIFY(kept("ruler").empty());
    press(Qt::Key_Escape);
    QVERIFY(desk().chosen().empty());
    press(Qt::Key_Space);
    QVERIFY(!desk().seeking());
}

void ToolsTest::whatWasMeasuredIsCopied()
{
    choose("ruler");
    auto& readings = window_->find<QLabel>("tool.readings");
    QVERIFY(readings.text().isEmpty());
    ViewValue view = session().view();
    view.tools["ruler"] = "0,0,0 3,4,0";
    session().setView(view);
    QCOMPARE(readings.text(), QString("Ruler 1\t5 units of the file"));
    window_->find<QPushButton>("tool.copy").click();
    QCOMPARE(QGuiApplication::clipboard()->text(), readings.text());
    QVERIFY(window_->find<QPushButton>("tool.ruler.command.new").isEnabled());
    window_->find<QPushButton>("tool.ruler.command.clear").click();
    QVERIFY(readings.text().isEmpty() && kept("ruler").empty());
    QVERIFY(!window_->find<QPushButton>("tool.ruler.command.new").isEnabled());
    session().undoStack().undo();
    QCOMPARE(readings.text(), QString("Ruler 1\t5 units of the file"));
}

void ToolsTest::savedPicturesHaveWhatToolsKeep()
{
    AnnotationState none;
    for (AnnotationPlace& place : none.places)
        place.shown = false;
    const auto picture = [&] {
        Picture drawn{200, 150, std::vector<std::array<std::uint8_t, 4>>(200 * 150, {255, 255, 255, 255})};
        const auto finished = finishedPicture(
            pictureOrder(window_->workbench, viewport(), {{200, 150}, 0, false, none}), std::move(drawn));
        if (!finished)
            qFatal("not painted");
        return imageOf(*finished);
    };
    session().setCamera(zoomed(session().view().camera, 1.01)); // which no longer follows the window's shape
    const QImage before = picture();
    ViewValue view = session().view();
    const Eigen::Vector3d target = view.camera.target;
    const auto number = [](double value) { return formatNumber(value); };
    view.tools["ruler"] = number(target.x()) + "," + number(target.y()) + "," + number(target.z()) + " 0,0,0";
    view.tools["example.gone"] = "text";
    session().setView(view);
    const QImage after = picture();
    QVERIFY(after != before);
    QVERIFY(after.pixelColor(100, 75) != QColor(Qt::white)); // where the camera looks at
    choose("ruler");                                         // handles are no part of it
    QCOMPARE(picture(), after);
}

void ToolsTest::aSessionKeepsWhatToolsKeepAndWhatToolsKeptThatAreNotThere()
{
    ViewValue view = session().view();
    view.tools = {{"ruler", "0,0,0 3,4,0"}, {"example.gone", "what only it knows, ü"}};
    session().setView(view);
    const std::filesystem::path file = window_->folder.filePath("kept.tansession").toStdString();
    bool isSaved = false;
    Opening& opening = window_->workbench.opening();
    opening.sessionFile().save(file, *opening.sessions().document(), [&](bool worked) { isSaved = worked; });
    QTRY_VERIFY(isSaved);
    opening.close();
    QTRY_VERIFY(!session().model());
    window_->window.open(QString::fromStdString(file));
    QTRY_VERIFY(session().model() && session().view().tools == view.tools);
    choose("ruler");
    QCOMPARE(handles().size(), std::size_t(2));
}

ClipPlane ToolsTest::clip() const
{
    const auto setting = session().view().appearance.settings.find("clip");
    if (setting == session().view().appearance.settings.end())
        return {Eigen::Vector3d::Zero(), 0};
    const auto planes = parseClipPlanes(std::get<std::string>(setting->second));
    return planes && !planes->empty() ? planes->front() : ClipPlane{Eigen::Vector3d::Zero(), 0};
}

/// Three actions: choose the tool, click, drag.
void ToolsTest::thePlaneCutsThePictureOpen()
{
    choose("plane");
    QVERIFY(desk().drawings().back().handles.empty());
    click(middle());
    QTRY_VERIFY(window_->settled());
    QCOMPARE(viewport().scene()->clipPlanes.size(), std::size_t(1));
    const ClipPlane first = clip();
    QVERIFY(first.normal.dot(eyePosition(viewport().camera())) < first.offset); // the eye is where nothing is shown
    QCOMPARE(steps(), 1);
    const QPoint centre = pixelOf(handles()[0]), tip = pixelOf(handles()[1]);
    drag(centre, centre + (tip - centre) / 2);
    QCOMPARE(steps(), 2);
    QCOMPARE(clip().normal, first.normal);
    const double moved = clip().offset - first.offset;
    QVERIFY(moved > 0.02 * session().model()->diagonal());
    drag(pixelOf(handles()[1]), pixelOf(handles()[1]) + QPoint(12, 9));
    QCOMPARE(steps(), 3);
    QVERIFY((clip().normal - first.normal).norm() > 0.05);
    QVERIFY(std::abs(clip().normal.norm() - 1) < 1e-12);
    drag(pixelOf(handles()[1]), pixelOf(handles()[1]) + QPoint(2, 2), Qt::ShiftModifier);
    QCOMPARE(clip().normal, first.normal); // back to the axis
    press(Qt::Key_R);
    QCOMPARE(clip().normal, Eigen::Vector3d(-first.normal));
    QTRY_VERIFY(window_->settled());
    QCOMPARE(viewport().scene()->clipPlanes.front().normal, Eigen::Vector3d(-first.normal));
    press(Qt::Key_Delete);
    QCOMPARE(clip().normal, Eigen::Vector3d(0, 0, 0));
    while (session().undoStack().canUndo())
        session().undoStack().undo();
    QVERIFY(!session().view().appearance.settings.contains("clip") && session().view().tools.empty());
}

void ToolsTest::aToolThatThrowsIsToldAndChangesNothing()
{
    const ViewValue before = session().view();
    choose("example.failing-tool");
    QCOMPARE(desk().chosen(), std::string("example.failing-tool"));
    click(middle());
    QTRY_VERIFY(window_->messages().join(' ').contains("no ink left"));
    QVERIFY(window_->messages().join(' ').contains("example.failing-tool"));
    QVERIFY(session().view() == before);
    choose("ruler"); // and all goes on
    click(middle());
    QCOMPARE(handles().size(), std::size_t(1));
}

QTEST_MAIN(ToolsTest)
#include "tools_test.moc"
