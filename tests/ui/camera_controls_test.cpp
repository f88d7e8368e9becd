// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/camera_controls.h"

#include <QKeyEvent>
#include <QTest>

using namespace tetra;

/// What mouse and keyboard do to the camera.
class CameraControlsTest : public QObject {
    Q_OBJECT
private slots:
    void namedViewsLookAlongTheAxes_data();
    void namedViewsLookAlongTheAxes();
    void theObjectFollowsAPanningPointer();
    void theObjectFollowsATurningPointer();
    void theObjectFollowsThePointerHoweverItIsRolled();
    void aTrackballIsTurnedAnyWay();
    void camerasBetweenKeepTheirOrientation();
    void theWheelZooms();
    void keys();
};

namespace {

/// Where a point of the dataset is seen: x to the right, y up.
Eigen::Vector3d seen(const Camera& camera, const Eigen::Vector3d& point)
{
    return (viewMatrix(camera) * point.homogeneous()).head<3>();
}

std::optional<Camera> afterKey(const Camera& camera, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
{
    return movedByKey(camera, QKeyEvent(QEvent::KeyPress, key, modifiers));
}

} // namespace

void CameraControlsTest::namedViewsLookAlongTheAxes_data()
{
    QTest::addColumn<int>("view");
    QTest::addColumn<int>("axis");
    QTest::addColumn<double>("sign");
    QTest::newRow("front") << static_cast<int>(NamedView::Front) << 1 << -1.0;
    QTest::newRow("back") << static_cast<int>(NamedView::Back) << 1 << 1.0;
    QTest::newRow("left") << static_cast<int>(NamedView::Left) << 0 << -1.0;
    QTest::newRow("right") << static_cast<int>(NamedView::Right) << 0 << 1.0;
    QTest::newRow("top") << static_cast<int>(NamedView::Top) << 2 << 1.0;
    QTest::newRow("bottom") << static_cast<int>(NamedView::Bottom) << 2 << -1.0;
}

void CameraControlsTest::namedViewsLookAlongTheAxes()
{
    QFETCH(int, view);
    QFETCH(int, axis);
    QFETCH(double, sign);
    const Camera camera = seenFrom(Camera{}, static_cast<NamedView>(view));
    Eigen::Vector3d eye = Eigen::Vector3d::Zero();
    eye[axis] = sign * camera.distance;
    QVERIFY((eyePosition(camera) - eye).norm() < 1e-9);
}

void CameraControlsTest::theObjectFollowsAPanningPointer()
{
    const Camera camera;
    const Camera after = pannedByDrag(camera, {100, 50}, {800, 400});
    const Eigen::Vector3d moved = seen(after, camera.target) - seen(camera, camera.target);
    QVERIFY(moved.x() > 0);
    QVERIFY(moved.y() < 0); // down on the screen
    QVERIFY(std::abs(moved.x() + 2 * moved.y()) < 1e-9);
}

void CameraControlsTest::theObjectFollowsATurningPointer()
{
    const Camera camera = seenFrom(Camera{}, NamedView::Front);
    const Eigen::Vector3d nearPoint(0, -0.1, 0); // between the target and the eye
    const QSizeF size(800, 400);
    QVERIFY(seen(turnedByDrag(camera, {9, 9}, {29, 9}, size), nearPoint).x() > 0);
    QVERIFY(seen(turnedByDrag(camera, {9, 9}, {9, 29}, size), nearPoint).y() < 0);
}

/// Whatever the roll and the axis that is up, on a turntable or as a ball: by mouse and by keys.
void CameraControlsTest::theObjectFollowsThePointerHoweverItIsRolled()
{
    const QSizeF size(800, 400);
    const QPointF middle(400, 200);
    for (int axis = 0; axis < 6; ++axis)
        for (const bool trackball : {false, true})
            for (const double roll : {0.0, 30.0, 90.0, -135.0}) {
                Camera camera = seenFrom(Camera{}, NamedView::Front);
                camera.up = static_cast<UpAxis>(axis);
                camera.roll = roll;
                camera.trackball = trackball;
                const Eigen::Vector3d nearPoint = camera.target + 0.1 * eyeAxes(camera).col(2);
                for (const QPointF drag : {QPointF(12, 0), QPointF(0, -12), QPointF(7, 9)}) {
                    const Eigen::Vector3d moved = seen(turnedByDrag(camera, middle, middle + drag, size), nearPoint);
                    const Eigen::Vector2d way = Eigen::Vector2d(drag.x(), -drag.y()).normalized();
                    QVERIFY(moved.head<2>().norm() > 1e-3);
                    QVERIFY(moved.head<2>().normalized().dot(way) > 0.999);
                }
                QVERIFY(seen(*afterKey(camera, Qt::Key_Right), nearPoint).x() < -1e-3);
                QVERIFY(std::abs(seen(*afterKey(camera, Qt::Key_Right), nearPoint).y()) < 1e-3);
                QVERIFY(seen(*afterKey(camera, Qt::Key_Up), nearPoint).y() < -1e-3);
            }
}

/// Over the pole, where a turntable stops; and beside the ball, around the line of sight.
void CameraControlsTest::aTrackballIsTurnedAnyWay()
{
    const QSizeF size(600, 600);
    Camera camera = seenFrom(Camera{}, NamedView::Front);
    camera.trackball = true;
    for (int drag = 0; drag < 40; ++drag)
        camera = turnedByDrag(camera, {300, 300}, {300, 320}, size);
    QVERIFY(std::abs(camera.roll) > 90); // upside down by now
    QVERIFY(camera.elevation > -90 && camera.elevation < 90);
    camera = seenFrom(Camera{.trackball = true}, NamedView::Front);
    const Camera aside = turnedByDrag(camera, {300, 5}, {330, 5}, size);
    QVERIFY(aside.roll > 1);
    QVERIFY(seen(aside, Eigen::Vector3d::UnitZ()).x() > 0); // what was above goes with the pointer
    const Camera same = turnedByDrag(camera, {100, 5}, {100, 5}, size);
    QVERIFY((eyeAxes(same) - eyeAxes(camera)).cwiseAbs().maxCoeff() < 1e-12);
}

void CameraControlsTest::camerasBetweenKeepTheirOrientation()
{
    const Camera from{.azimuth = 20, .elevation = 10};
    for (const Camera& to :
         {upright(from, UpAxis::MinusZ), upright(from, UpAxis::X), rolled(from, 90), rolled(from, 180)}) {
        QVERIFY(between(from, to, 1) == to);
        QVERIFY((eyeAxes(between(from, to, 0)) - eyeAxes(from)).cwiseAbs().maxCoeff() < 1e-9);
        Eigen::Quaterniond last(eyeAxes(from));
        for (int step = 1; step <= 100; ++step) {
            const Eigen::Quaterniond next(eyeAxes(between(from, to, step / 100.0)));
            QVERIFY(last.angularDistance(next) < 0.04);
            last = next;
        }
    }
}

void CameraControlsTest::theWheelZooms()
{
    const Camera camera;
    QVERIFY(zoomedByWheel(camera, 120).distance < camera.distance);
    QVERIFY(std::abs(zoomedByWheel(zoomedByWheel(camera, 120), -120).distance - camera.distance) < 1e-12);
}

void CameraControlsTest::keys()
{
    const Camera camera;
    QVERIFY(afterKey(camera, Qt::Key_Right)->azimuth != camera.azimuth);
    QVERIFY(afterKey(camera, Qt::Key_Up)->elevation > camera.elevation);
    QVERIFY(afterKey(camera, Qt::Key_Plus)->distance < camera.distance);
    QVERIFY(afterKey(camera, Qt::Key_Minus)->distance > camera.distance);
    QVERIFY(afterKey(camera, Qt::Key_Left, Qt::ShiftModifier)->target != camera.target);
    QCOMPARE(afterKey(camera, Qt::Key_Left, Qt::ShiftModifier)->azimuth, camera.azimuth);
    const double fine = afterKey(camera, Qt::Key_Right, Qt::ControlModifier)->azimuth - camera.azimuth;
    const double whole = afterKey(camera, Qt::Key_Right)->azimuth - camera.azimuth;
    QVERIFY(std::abs(fine) < std::abs(whole));
    QVERIFY(afterKey(camera, Qt::Key_Right, Qt::AltModifier)->roll > 0);
    QCOMPARE(afterKey(camera, Qt::Key_Left, Qt::AltModifier)->azimuth, camera.azimuth);
    QVERIFY(!afterKey(camera, Qt::Key_Up, Qt::AltModifier).has_value());
    QVERIFY(!afterKey(camera, Qt::Key_A).has_value());
}

QTEST_GUILESS_MAIN(CameraControlsTest)
#include "camera_controls_test.moc"
