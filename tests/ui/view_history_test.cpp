// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/widgets/motion.h"

#include <QNativeGestureEvent>
#include <QPointingDevice>
#include <QPushButton>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTabletEvent>
#include <QToolButton>
#include <QWheelEvent>

using namespace tetra;

/// Camera and background are undone as all else: one step for each gesture, in the order of what was done.
class ViewHistoryTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void init();
    void cleanup();
    void openingIsNoStep();
    void aFirstLookTellsHowToTurnTheModel();
    void aDragIsOneStep();
    void aLongDragCostsNothingButThePictures();
    void aSeriesIsOneStepAndAPauseEndsIt();
    void jumpsAreStepsOfTheirOwn();
    void theBackgroundIsUndone();
    void editsBetweenStayInOrder();
    void manyStepsEndWhereTheyBegan();
    void undoGlidesUnlessMotionIsReduced();
    void camerasBetweenTurnTheShorterWay();
    void fingersPinchAndPan();
    void aPenIsLeftToBeAMouse();

private:
    Session& session() const { return window_->workbench.session(); }
    QUndoStack& stack() const { return session().undoStack(); }
    void drag(QPoint by) const;
    void turnWheel(int angle) const;

    std::unique_ptr<WindowFixture> window_;
};

void ViewHistoryTest::initTestCase()
{
    QCoreApplication::setOrganizationName("TAn");
    QCoreApplication::setApplicationName("viewHistory");
    QLocale::setDefault(QLocale::c());
}

void ViewHistoryTest::init()
{
    QSettings().clear();
    setMotionReduced(true);
    window_ = std::make_unique<WindowFixture>();
    window_->window.show();
    const auto path = buildSampleModel(*window_->host, sampleDataset(10), window_->folderPath());
    window_->window.open(QString::fromStdString(path));
    QTRY_VERIFY(window_->workbench.session().model() && window_->settled());
}

void ViewHistoryTest::cleanup()
{
    window_.reset();
}

void ViewHistoryTest::drag(QPoint by) const
{
    Viewport& viewport = window_->viewport();
    QTest::mousePress(&viewport, Qt::LeftButton, {}, {100, 100});
    for (int part = 1; part <= 4; ++part) {
        const QPointF place = QPointF(100, 100) + QPointF(by) * part / 4;
        QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport, &move);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, QPoint(100, 100) + by);
}

void ViewHistoryTest::turnWheel(int angle) const
{
    Viewport& viewport = window_->viewport();
    QWheelEvent event({50, 50}, viewport.mapToGlobal(QPointF(50, 50)), {}, {0, angle}, {}, {}, Qt::NoScrollPhase,
                      false);
    QCoreApplication::sendEvent(&viewport, &event);
}

void ViewHistoryTest::openingIsNoStep()
{
    QCOMPARE(stack().count(), 0);
    window_->find<QAction>("action.view.top").trigger();
    session().setBackground(Colour{1, 0, 0});
    QCOMPARE(stack().count(), 2);
    const auto path = window_->workbench.session().model()->path();
    window_->window.open(QString::fromStdString(path));
    QTRY_COMPARE(stack().count(), 0);
    QVERIFY(session().view().background == (Colour{1, 0, 0})); // as it was seen last
}

/// Of data that do not say which way is up, when nobody has seen them before.
void ViewHistoryTest::aFirstLookTellsHowToTurnTheModel()
{
    window_->window.statusBar()->clearMessage(); // of the model that is open
    const QSignalSpy told(window_->window.statusBar(), &QStatusBar::messageChanged);
    const auto hints = [&] {
        return std::ranges::count_if(
            told, [](const QList<QVariant>& message) { return message[0].toString().contains("Ctrl+U"); });
    };
    const QString seen = QString::fromStdString(window_->workbench.session().model()->path());
    const QString other = window_->folder.filePath("other.tan");
    QVERIFY(QFile::copy(seen, other));
    window_->window.open(other);
    QTRY_COMPARE(window_->workbench.session().model()->path().filename().string(), std::string("other.tan"));
    QCOMPARE(hints(), 1);
    window_->window.open(seen);
    QTRY_VERIFY(window_->workbench.session().model()->path().filename().string() != "other.tan");
    QCOMPARE(hints(), 1);
}

void ViewHistoryTest::aDragIsOneStep()
{
    const Camera before = window_->viewport().camera();
    drag({40, 20});
    const Camera after = window_->viewport().camera();
    QVERIFY(after != before);
    QCOMPARE(stack().count(), 1);
    QCOMPARE(stack().undoText(), QString("Move Camera"));
    drag({-30, 5});
    QCOMPARE(stack().count(), 2);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(window_->viewport().camera() == after);
    window_->find<QAction>("action.undo").trigger();
    QVERIFY(window_->viewport().camera() == before);
    window_->find<QAction>("action.redo").trigger();
    QVERIFY(window_->viewport().camera() == after);
    QCOMPARE(stack().count(), 2);
}

/// However many moves a drag has, they make one step of two views, and nothing is made anew but pictures.
void ViewHistoryTest::aLongDragCostsNothingButThePictures()
{
    Viewport& viewport = window_->viewport();
    const Camera before = viewport.camera();
    const QSignalSpy scenes(&window_->workbench.scenes().sceneBuilder(), &SceneBuilder::busyChanged);
    QTest::mousePress(&viewport, Qt::LeftButton, {}, {100, 100});
    constexpr int moves = 300;
    for (int part = 1; part <= moves; ++part) {
        const QPointF place(100 + part % 120, 100 + part / 3.0);
        QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(&viewport, &move);
        QCOMPARE(stack().count(), 1);
    }
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, {150, 150});
    QCOMPARE(stack().count(), 1);
    QCOMPARE(stack().command(0)->childCount(), 0);
    QCOMPARE(scenes.count(), 0);
    stack().undo();
    QVERIFY(viewport.camera() == before);
}

void ViewHistoryTest::aSeriesIsOneStepAndAPauseEndsIt()
{
    Viewport& viewport = window_->viewport();
    const Camera before = viewport.camera();
    for (int turn = 0; turn < 5; ++turn)
        turnWheel(120);
    QCOMPARE(stack().count(), 1);
    const auto gesture = viewport.gesture();
    QTRY_VERIFY(viewport.gesture() != gesture);
    for (int press = 0; press < 3; ++press)
        QTest::keyClick(&viewport, Qt::Key_Left);
    QCOMPARE(stack().count(), 2);
    stack().undo();
    stack().undo();
    QVERIFY(viewport.camera() == before);
}

void ViewHistoryTest::jumpsAreStepsOfTheirOwn()
{
    for (const char* name : {"view.top", "view.left", "perspective", "view.corner", "fit"})
        window_->find<QAction>(QString("action.") + name).trigger();
    // Fitting changes nothing: the model was fitted from the start.
    QVERIFY(stack().count() == 4 || stack().count() == 5);
    turnWheel(-120);
    const int steps = stack().count();
    window_->find<QPushButton>("view.from.back").click();
    QCOMPARE(stack().count(), steps + 1);
    stack().undo();
    stack().undo();
    QVERIFY(!window_->viewport().camera().perspective);
    QVERIFY(!window_->find<QAction>("action.perspective").isChecked());
    stack().setIndex(0);
    QVERIFY(window_->find<QAction>("action.perspective").isChecked());
}

void ViewHistoryTest::theBackgroundIsUndone()
{
    Viewport& viewport = window_->viewport();
    const Colour usual = viewport.background();
    session().setBackground(Colour{0, 0.5F, 0});
    QVERIFY(window_->find<QToolButton>("view.usualBackground").isEnabled());
    QCOMPARE(stack().undoText(), QString("Change Background"));
    window_->find<QToolButton>("view.usualBackground").click();
    QCOMPARE(stack().count(), 2);
    stack().undo();
    QVERIFY((viewport.background() == Colour{0, 0.5F, 0}));
    stack().undo();
    QVERIFY(viewport.background() == usual);
    QVERIFY(!window_->find<QToolButton>("view.usualBackground").isEnabled());
}

void ViewHistoryTest::editsBetweenStayInOrder()
{
    const double error = session().view().query.error;
    turnWheel(120);
    const Camera camera = window_->viewport().camera();
    session().setError(7);
    turnWheel(120); // the same series, but something was done between
    QCOMPARE(stack().count(), 3);
    stack().undo();
    QVERIFY(window_->viewport().camera() == camera);
    QCOMPARE(session().view().query.error, 7.0);
    stack().undo();
    QCOMPARE(session().view().query.error, error);
    QVERIFY(window_->viewport().camera() == camera);
}

void ViewHistoryTest::manyStepsEndWhereTheyBegan()
{
    Viewport& viewport = window_->viewport();
    const Camera first = viewport.camera();
    const QueryState query = session().view().query;
    QRandomGenerator random(20);
    for (int step = 0; step < 1000; ++step) {
        switch (random.bounded(6)) {
        case 0:
            viewport.setCamera(turned(viewport.camera(), random.bounded(90.0) - 45, random.bounded(40.0) - 20));
            break;
        case 1: session().setCamera(seenFrom(viewport.camera(), static_cast<NamedView>(random.bounded(7)))); break;
        case 2: turnWheel(random.bounded(2) == 0 ? 120 : -120); break;
        case 3: session().setError(random.bounded(10.0)); break;
        case 4: session().setBackground(Colour{static_cast<float>(random.bounded(1.0)), 0, 0}); break;
        case 5: stack().canUndo() ? stack().undo() : stack().redo(); break;
        }
    }
    const Camera last = viewport.camera();
    const auto background = session().view().background;
    const int end = stack().index();
    stack().setIndex(0);
    QVERIFY(viewport.camera() == first);
    QVERIFY(session().view().query == query);
    QVERIFY(!session().view().background);
    stack().setIndex(end);
    QVERIFY(viewport.camera() == last);
    QVERIFY(session().view().background == background);
}

void ViewHistoryTest::undoGlidesUnlessMotionIsReduced()
{
    Viewport& viewport = window_->viewport();
    QSignalSpy moved(&viewport, &Viewport::cameraChanged);
    window_->find<QAction>("action.view.top").trigger();
    QCOMPARE(moved.count(), 1);
    window_->find<QAction>("action.reducedMotion").trigger();
    QVERIFY(!motionReduced());
    if (!mayGlide(viewport))
        QSKIP("skipped: this desktop wants no motion");
    moved.clear();
    stack().undo();
    QVERIFY(moved.count() >= 1);
    const Camera camera = viewport.camera();
    QVERIFY(!viewport.settled());
    QTRY_VERIFY(viewport.settled());
    QVERIFY(moved.count() > 1);
    QVERIFY(viewport.camera() == camera);
}

void ViewHistoryTest::camerasBetweenTurnTheShorterWay()
{
    QRandomGenerator random(3);
    for (int round = 0; round < 200; ++round) {
        Camera from, to;
        from.azimuth = random.bounded(360.0) - 180;
        to.azimuth = random.bounded(360.0) - 180;
        from.elevation = random.bounded(180.0) - 90;
        to.elevation = random.bounded(180.0) - 90;
        from.distance = 0.1 + random.bounded(10.0);
        to.distance = 0.1 + random.bounded(10.0);
        QVERIFY(between(from, to, 1) == to);
        double turn = 0;
        Camera last = between(from, to, 0);
        QVERIFY((eyePosition(last) - eyePosition(from)).norm() < 1e-9 * from.distance);
        for (int step = 1; step <= 100; ++step) {
            const Camera next = between(from, to, step / 100.0);
            turn += std::abs(std::remainder(next.azimuth - last.azimuth, 360.0));
            QVERIFY(next.distance >= std::min(from.distance, to.distance) * (1 - 1e-12));
            QVERIFY(next.distance <= std::max(from.distance, to.distance) * (1 + 1e-12));
            last = next;
        }
        QVERIFY(turn <= 180 + 1e-6);
    }
}

void ViewHistoryTest::fingersPinchAndPan()
{
    Viewport& viewport = window_->viewport();
    const QPointingDevice pad("pad", 7, QInputDevice::DeviceType::TouchPad, QPointingDevice::PointerType::Finger,
                              QInputDevice::Capability::PixelScroll, 2, 0);
    const Camera before = viewport.camera();
    QNativeGestureEvent pinch(Qt::ZoomNativeGesture, &pad, 2, {50, 50}, {50, 50}, {50, 50}, 0.25, {});
    QCoreApplication::sendEvent(&viewport, &pinch);
    QVERIFY(viewport.camera().distance < before.distance);
    QVERIFY(viewport.camera().target == before.target);

    const Camera zoomed = viewport.camera();
    const auto scroll = [&](Qt::KeyboardModifiers modifiers) {
        QWheelEvent event({50, 50}, {50, 50}, {12, 30}, {24, 60}, Qt::NoButton, modifiers, Qt::ScrollUpdate, false,
                          Qt::MouseEventNotSynthesized, &pad);
        QCoreApplication::sendEvent(&viewport, &event);
    };
    scroll({});
    QVERIFY(viewport.camera().target != zoomed.target);
    QVERIFY(viewport.camera().distance == zoomed.distance);
    const Camera panned = viewport.camera();
    scroll(Qt::ControlModifier);
    QVERIFY(viewport.camera().target == panned.target);
    QVERIFY(viewport.camera().distance != panned.distance);
}

void ViewHistoryTest::aPenIsLeftToBeAMouse()
{
    QVERIFY(QCoreApplication::testAttribute(Qt::AA_SynthesizeMouseForUnhandledTabletEvents));
    const QPointingDevice pen("pen", 8, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
                              QInputDevice::Capability::Pressure, 1, 2);
    QTabletEvent press(QEvent::TabletPress, &pen, {50, 50}, {50, 50}, 0.5, 0, 0, 0, 0, 0, {}, Qt::LeftButton,
                       Qt::LeftButton);
    press.ignore();
    QCoreApplication::sendEvent(&window_->viewport(), &press);
    QVERIFY(!press.isAccepted());
}

QTEST_MAIN(ViewHistoryTest)
#include "view_history_test.moc"
