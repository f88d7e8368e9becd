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
    QVERIFY(seen(turnedByDrag(camera, {20, 0}), nearPoint).x() > 0);
    QVERIFY(seen(turnedByDrag(camera, {0, 20}), nearPoint).y() < 0);
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
    QVERIFY(!afterKey(camera, Qt::Key_A).has_value());
}

QTEST_GUILESS_MAIN(CameraControlsTest)
#include "camera_controls_test.moc"
