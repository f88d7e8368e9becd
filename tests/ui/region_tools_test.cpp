// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/render/scene_parts.h"
#include "tests/ui/sample_window.h"
#include "ui/viewport/region_tools.h"
#include "ui/viewport/value_pick.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QToolButton>
#include <QUndoStack>

using namespace tetra;

/// Focus and window moved in the picture (R25, S17), by mouse and by keys; the mesh follows.
class RegionToolsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void actionsSwitchTheToolsAndShowTheirPanels();
    void draggingTheCentreMovesTheFocusAndTheMeshFollows();
    void draggingTheRadiusResizes();
    void escapeCancelsADrag();
    void aKeyHoldsTheDragToAnAxis();
    void keysMoveWhatIsSelected();
    void aDoubleClickBringsTheFocusToASurface();
    void theCameraStillTurnsBesideTheHandles();
    void theWindowHasHandlesToo();
    void outlinesDoNotBelongToThePicture();
    void handlesAreSeenOnAnyGround();

private:
    Session& session() const { return window_->workbench.session(); }
    const QueryState& query() const { return session().view().query; }
    RegionTools& tools() const { return window_->find<RegionTools>("viewport.tools"); }
    bool upToDate() const { return window_->settled() && session().showsQuery(); }
    void trigger(const char* action) const { window_->find<QAction>(action).trigger(); }
    QPoint pixelOf(std::size_t handle) const;
    void moveMouse(QPoint to, Qt::KeyboardModifiers modifiers = {}) const;

    std::unique_ptr<WindowFixture> window_;
};

void RegionToolsTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("region_tools");
    QLocale::setDefault(QLocale::c());
}

void RegionToolsTest::init()
{
    window_ = windowOnSample(24, {1280, 800}); // room for drags
}

void RegionToolsTest::cleanup()
{
    window_.reset();
}

QPoint RegionToolsTest::pixelOf(std::size_t handle) const
{
    const auto handles = tools().handles();
    return handle < handles.size() ? window_->viewport().projection().pixelOf(handles[handle].place)->toPoint()
                                   : QPoint();
}

void RegionToolsTest::moveMouse(QPoint to, Qt::KeyboardModifiers modifiers) const
{
    Viewport& viewport = window_->viewport();
    QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton, modifiers);
    QCoreApplication::sendEvent(&viewport, &move);
}

void RegionToolsTest::actionsSwitchTheToolsAndShowTheirPanels()
{
    QVERIFY(tools().handles().empty());
    trigger("action.focusSphere");
    QCOMPARE(query().focus.shape, FocusState::Shape::Sphere);
    QCOMPARE(tools().selected(), RegionKind::Focus);
    QVERIFY(window_->find<QToolButton>("focus.sphere").isChecked());
    QVERIFY(window_->find<QWidget>("focus.radius.box").isVisible());
    QVERIFY(!window_->find<QWidget>("focus.size.x").isVisible());
    trigger("action.focusBox");
    QCOMPARE(query().focus.shape, FocusState::Shape::Box);
    QVERIFY(!window_->find<QAction>("action.focusSphere").isChecked());
    QVERIFY(window_->find<QWidget>("focus.size.x").isVisible());
    trigger("action.window");
    QCOMPARE(tools().selected(), RegionKind::Window);
    QVERIFY(window_->find<QCheckBox>("region.window").isVisible() &&
            window_->find<QCheckBox>("region.window").isChecked());
    trigger("action.focusBox"); // again: off
    QVERIFY(!query().focus.isOn());
    for (int step = 0; step < 4; ++step)
        trigger("action.undo");
    QVERIFY(query().isUniform());
    QVERIFY(!window_->find<QAction>("action.focusBox").isChecked());
    QCOMPARE(tools().selected(), RegionKind::None);
}

void RegionToolsTest::draggingTheCentreMovesTheFocusAndTheMeshFollows()
{
    window_->find<QDoubleSpinBox>("accuracy.box").setValue(8);
    trigger("action.focusSphere");
    QTRY_VERIFY(upToDate());
    const int steps = session().undoStack().count();
    const Eigen::Vector3d before = query().focus.centre;
    const QueryState asked = query();
    const std::uint64_t tetrahedra = session().shown()->tetrahedra;
    QVERIFY(tetrahedra > session().meshSize().tetrahedra);

    const QPoint from = pixelOf(0);
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, from);
    QVERIFY(tools().dragging());
    for (int i = 1; i <= 8; ++i)
        moveMouse(from + QPoint(10 * i, -5 * i));
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, from + QPoint(80, -40));
    QVERIFY(!tools().dragging());
    QCOMPARE(pixelOf(0), from + QPoint(80, -40));
    QVERIFY((query().focus.centre - before).norm() > 1);
    QCOMPARE(session().undoStack().count(), steps + 1);
    QVERIFY(!session().showsQuery());
    QTRY_VERIFY(upToDate());
    const SpaceRamp* ramp = session().shown()->query.error.asSpaceRamp();
    QVERIFY(ramp != nullptr);
    QCOMPARE(std::get<Sphere>(ramp->region).centre, query().focus.centre);
    QCOMPARE(window_->find<QDoubleSpinBox>("focus.centre.x").value(), std::round(query().focus.centre.x() * 100) / 100);
    trigger("action.undo");
    QCOMPARE(query(), asked);
    QTRY_VERIFY(upToDate());
    QCOMPARE(std::get<Sphere>(session().shown()->query.error.asSpaceRamp()->region).centre, before);
}

void RegionToolsTest::draggingTheRadiusResizes()
{
    trigger("action.focusSphere");
    const double before = query().focus.radius;
    const QPoint centre = pixelOf(0);
    const QPoint from = pixelOf(2);
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, from);
    moveMouse(centre + 2 * (from - centre));
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, centre + 2 * (from - centre));
    QVERIFY(std::abs(query().focus.radius / before - 2) < 0.05);
}

void RegionToolsTest::escapeCancelsADrag()
{
    trigger("action.focusSphere");
    const QueryState before = query();
    const int steps = session().undoStack().count();
    const QPoint from = pixelOf(0);
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, from);
    moveMouse(from + QPoint(50, 20));
    QVERIFY(query() != before);
    QTest::keyClick(&window_->viewport(), Qt::Key_Escape);
    QVERIFY(!tools().dragging());
    QCOMPARE(query(), before);
    QCOMPARE(session().undoStack().count(), steps);
    const Camera camera = window_->viewport().camera();
    moveMouse(from + QPoint(70, 20)); // the button is still down: what is left of the drag moves nothing
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, from + QPoint(70, 20));
    QCOMPARE(query(), before);
    QCOMPARE(window_->viewport().camera().azimuth, camera.azimuth);
}

void RegionToolsTest::aKeyHoldsTheDragToAnAxis()
{
    trigger("action.focusSphere");
    const Eigen::Vector3d before = query().focus.centre;
    const QPoint from = pixelOf(0);
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, from);
    QTest::keyClick(&window_->viewport(), Qt::Key_Y); // which is up
    moveMouse(from + QPoint(20, -30));
    QCOMPARE(query().focus.centre.x(), before.x());
    QCOMPARE(query().focus.centre.z(), before.z());
    QVERIFY(query().focus.centre.y() > before.y());
    QTest::keyClick(&window_->viewport(), Qt::Key_Y);
    QVERIFY(query().focus.centre.x() != before.x());
    moveMouse(from + QPoint(3, -30), Qt::ShiftModifier);
    QCOMPARE(query().focus.centre.x(), before.x());
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, from);
}

void RegionToolsTest::keysMoveWhatIsSelected()
{
    Viewport& viewport = window_->viewport();
    trigger("action.focusBox");
    const int steps = session().undoStack().count();
    const double azimuth = viewport.camera().azimuth;
    const Eigen::Vector3d before = query().focus.centre;
    for (const bool repeated : {false, true, true}) {
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Up, Qt::NoModifier, {}, repeated);
        QCoreApplication::sendEvent(&viewport, &press);
    }
    QKeyEvent release(QEvent::KeyRelease, Qt::Key_Up, Qt::NoModifier);
    QCoreApplication::sendEvent(&viewport, &release);
    QVERIFY(query().focus.centre.y() > before.y());
    QCOMPARE(viewport.camera().azimuth, azimuth);
    QCOMPARE(session().undoStack().count(), steps + 1);
    const double whole = (query().focus.centre - before).norm() / 3;
    const Eigen::Vector3d there = query().focus.centre;
    QTest::keyClick(&viewport, Qt::Key_PageUp, Qt::ControlModifier);
    QVERIFY((query().focus.centre - there).norm() < whole / 2);
    QVERIFY((query().focus.centre - there).norm() > 0);
    QTest::keyClick(&viewport, Qt::Key_Escape);
    QCOMPARE(tools().selected(), RegionKind::None);
    QTest::keyClick(&viewport, Qt::Key_Left);
    QVERIFY(viewport.camera().azimuth != azimuth);
    trigger("action.window");
    for (const RegionKind next :
         {RegionKind::None, RegionKind::Focus, RegionKind::Window, RegionKind::None, RegionKind::Focus}) {
        QTest::keyClick(&viewport, Qt::Key_Return);
        QCOMPARE(tools().selected(), next);
    }
    QTest::keyClick(&viewport, Qt::Key_Delete);
    QVERIFY(!query().focus.isOn());
}

void RegionToolsTest::aDoubleClickBringsTheFocusToASurface()
{
    Viewport& viewport = window_->viewport();
    const QPoint middle = viewport.rect().center();
    trigger("action.focusSphere");
    FocusState aside = query().focus;
    aside.centre = session().model()->description().bounds.min();
    session().setFocus(aside);
    QTRY_VERIFY(upToDate());
    QTest::mouseDClick(&viewport, Qt::LeftButton, {}, {2, 2});
    QCOMPARE(query().focus.centre, aside.centre);
    QTest::mouseDClick(&viewport, Qt::LeftButton, {}, pixelOf(0)); // grabbed twice, and let go
    QVERIFY(tools().dragging());
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, pixelOf(0));
    QVERIFY(!tools().dragging());
    QCOMPARE(query().focus.centre, aside.centre);
    QTest::mouseDClick(&viewport, Qt::LeftButton, {}, middle + QPoint(40, 30));
    QCOMPARE(query().focus.centre, aside.centre); // the place is looked for in a worker (D4)
    QTRY_VERIFY(query().focus.centre != aside.centre);
    QVERIFY(
        (*viewport.projection().pixelOf(query().focus.centre) - QPointF(middle + QPoint(40, 30))).manhattanLength() <
        1);
    // The first click of the two has picked a value, which nobody wants in the middle of the handle.
    const auto& pick = window_->find<ValuePick>("viewport.pick");
    QTRY_VERIFY(!pick.busy());
    QVERIFY(!pick.picked());
}

void RegionToolsTest::theCameraStillTurnsBesideTheHandles()
{
    trigger("action.focusSphere");
    const QueryState before = query();
    const double azimuth = window_->viewport().camera().azimuth;
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, {20, 20});
    moveMouse({60, 20});
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, {60, 20});
    QVERIFY(window_->viewport().camera().azimuth != azimuth);
    QCOMPARE(query(), before);
}

void RegionToolsTest::theWindowHasHandlesToo()
{
    trigger("action.focusSphere");
    trigger("action.window");
    FocusState aside = query().focus;
    aside.centre = session().model()->description().bounds.min();
    session().setFocus(aside);
    const Box before = query().window.window.box;
    const auto handles = tools().handles();
    QCOMPARE(handles.size(), std::size_t{7});
    const QPointF outwards =
        window_->viewport().projection().pixelsPerUnit(handles[6].place, Eigen::Vector3d::Unit(2)) * 2;
    const QPoint from = pixelOf(6);
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, from);
    moveMouse(from + outwards.toPoint());
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, from + outwards.toPoint());
    QVERIFY(std::abs(query().window.window.box.largest.z() - before.largest.z() - 2) < 0.3);
    QCOMPARE(query().window.window.box.least, before.least);
    // The centre of what is not selected can be grabbed, which selects it.
    const QPoint focus = window_->viewport().projection().pixelOf(query().focus.centre)->toPoint();
    QTest::mousePress(&window_->viewport(), Qt::LeftButton, {}, focus);
    QCOMPARE(tools().selected(), RegionKind::Focus);
    QTest::mouseRelease(&window_->viewport(), Qt::LeftButton, {}, focus);
}

/// Whatever the colours of the window around it.
void RegionToolsTest::handlesAreSeenOnAnyGround()
{
    trigger("action.focusSphere");
    for (const float grey : {0.0F, 0.15F, 0.9F, 1.0F}) {
        session().setBackground(Colour{grey, grey, grey});
        const QColor ground = QColor::fromRgbF(grey, grey, grey);
        QImage picture(tools().size(), QImage::Format_ARGB32_Premultiplied);
        picture.fill(ground);
        tools().render(&picture, {}, {}, QWidget::DrawChildren);
        const QColor handle = picture.pixelColor(pixelOf(0) + QPoint(0, 4)); // beside the dot in the middle
        QVERIFY2(std::abs(handle.lightness() - ground.lightness()) > 80, qPrintable(handle.name() + ground.name()));
    }
}

void RegionToolsTest::outlinesDoNotBelongToThePicture()
{
    const std::size_t lines = testing::partsOf(*window_->viewport().scene()).lines.size();
    const QImage without = window_->viewport().picture();
    trigger("action.focusSphere");
    trigger("action.focusBox");
    QTRY_VERIFY(upToDate());
    QCOMPARE(testing::partsOf(*window_->viewport().scene()).lines.size(), lines);
    QVERIFY(window_->viewport().picture() != without);
    QTest::keyClick(&window_->viewport(), Qt::Key_Delete);
    QTRY_VERIFY(upToDate());
    QCOMPARE(window_->viewport().picture(), without);
}

QTEST_MAIN(RegionToolsTest)
#include "region_tools_test.moc"
