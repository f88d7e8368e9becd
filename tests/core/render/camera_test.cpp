// SPDX-License-Identifier: GPL-3.0-or-later
// The camera of the picture window (R27).
#include <tan/render.h>

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace tetra;
using Eigen::Vector3d;

namespace {

const Eigen::AlignedBox3d box(Vector3d(-1, 2, 3), Vector3d(4, 6, 5));

Vector3d projected(const Camera& camera, double aspectRatio, const Eigen::AlignedBox3d& bounds, const Vector3d& point)
{
    const Eigen::Vector4d clip =
        projectionMatrix(camera, aspectRatio, bounds) * viewMatrix(camera) * point.homogeneous();
    return clip.hnormalized();
}

constexpr std::array upAxes{UpAxis::X, UpAxis::MinusX, UpAxis::Y, UpAxis::MinusY, UpAxis::Z, UpAxis::MinusZ};

Vector3d directionOf(UpAxis up)
{
    const auto index = static_cast<int>(up);
    return (index % 2 == 0 ? 1 : -1) * Vector3d::Unit(index / 2);
}

Camera anyCamera(std::mt19937& random)
{
    std::uniform_real_distribution<double> turn(-180, 180), height(-90, 90), place(-3, 3);
    return {.target = {place(random), place(random), place(random)},
            .distance = 2 + place(random) / 2,
            .azimuth = turn(random),
            .elevation = height(random),
            .roll = turn(random),
            .up = upAxes[random() % upAxes.size()],
            .perspective = random() % 2 == 0};
}

Vector3d cornerOf(const Eigen::AlignedBox3d& bounds, int index)
{
    return bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(index));
}

} // namespace

class CameraTest : public QObject {
    Q_OBJECT

private slots:
    void looksWhereTheHeaderSays()
    {
        Camera camera{.target = {1, 2, 3}, .distance = 5, .azimuth = 0, .elevation = 0};
        QVERIFY(eyePosition(camera).isApprox(Vector3d(1, -3, 3)));
        const Eigen::Matrix4d view = viewMatrix(camera);
        QVERIFY((view * Vector3d(2, 2, 3).homogeneous()).head<3>().isApprox(Vector3d(1, 0, -5))); // x to the right
        QVERIFY((view * Vector3d(1, 2, 4).homogeneous()).head<3>().isApprox(Vector3d(0, 1, -5))); // z up
        camera.elevation = 90;
        QVERIFY(eyePosition(camera).isApprox(Vector3d(1, 2, 8)));
    }

    void viewIsRigid_data()
    {
        QTest::addColumn<double>("azimuth");
        QTest::addColumn<double>("elevation");
        for (const double azimuth : {-170.0, 0.0, 33.0, 91.0})
            for (const double elevation : {-90.0, -35.0, 0.0, 90.0})
                QTest::addRow("%g %g", azimuth, elevation) << azimuth << elevation;
    }
    void viewIsRigid()
    {
        QFETCH(double, azimuth);
        QFETCH(double, elevation);
        const Camera camera{.target = {1, 2, 3}, .distance = 7, .azimuth = azimuth, .elevation = elevation};
        const Eigen::Matrix3d rotation = viewMatrix(camera).topLeftCorner<3, 3>();
        QVERIFY((rotation * rotation.transpose()).isIdentity(1e-12));
        QVERIFY(std::abs(rotation.determinant() - 1) < 1e-12);
        QVERIFY((viewMatrix(camera) * camera.target.homogeneous()).head<3>().isApprox(Vector3d(0, 0, -7)));
        QVERIFY(rotation.row(0).z() == 0); // the horizon stays level
        QVERIFY(rotation.row(1).z() >= -1e-12);
    }

    void fittedShowsTheWholeBox_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<double>("aspectRatio");
        QTest::addColumn<double>("field");
        for (const bool perspective : {true, false})
            for (const double aspectRatio : {0.1, 1.0, 1.6, 12.0})
                for (const double field : {10.0, 30.0, 120.0})
                    QTest::addRow("%d %g %g", perspective, aspectRatio, field) << perspective << aspectRatio << field;
    }
    void fittedShowsTheWholeBox()
    {
        QFETCH(bool, perspective);
        QFETCH(double, aspectRatio);
        QFETCH(double, field);
        Camera start{.fieldOfView = field, .perspective = perspective};
        for (int turn = 0; turn < 24; ++turn) {
            const Camera camera = fitted(turned(start, turn * 37, turn * 7 - 80), box);
            double largest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const Vector3d place = projected(camera, aspectRatio, box, cornerOf(box, corner));
                QVERIFY(place.cwiseAbs().maxCoeff() <= 1); // also between near and far
                largest = std::max(largest, place.head<2>().cwiseAbs().maxCoeff());
            }
            QVERIFY2(largest > 0.2 || field > 90, "the box is needlessly small");
        }
    }

    /// The projected box touches the frame but for a narrow margin, from wherever and in whatever shape of picture.
    void fittedFillsTheFrame_data() { fittedShowsTheWholeBox_data(); }
    void fittedFillsTheFrame()
    {
        QFETCH(bool, perspective);
        QFETCH(double, aspectRatio);
        QFETCH(double, field);
        std::mt19937 random(11);
        for (int round = 0; round < 100; ++round) {
            Camera camera = anyCamera(random);
            camera.fieldOfView = field;
            camera.perspective = perspective;
            camera = fitted(camera, box, aspectRatio);
            QCOMPARE(camera.target, Vector3d(box.center()));
            double largest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const Vector3d place = projected(camera, aspectRatio, box, cornerOf(box, corner));
                QVERIFY(place.cwiseAbs().maxCoeff() <= 1);
                largest = std::max(largest, place.head<2>().cwiseAbs().maxCoeff());
            }
            const bool isBeforeTheEye = field > 90 && aspectRatio > 2; // hardly: more of it would be beside the eye
            QVERIFY2((largest > 0.94 || isBeforeTheEye) && largest < 0.98, qPrintable(QString::number(largest)));
        }
    }

    /// A line that is looked along is before the eye, too.
    void fittedShowsFlatBoxes()
    {
        for (const Vector3d& size : {Vector3d(0, 5, 0), Vector3d(3, 0, 0), Vector3d(2, 2, 0)})
            for (const bool perspective : {true, false}) {
                const Eigen::AlignedBox3d flat(Vector3d(1, 1, 1), Vector3d(Vector3d(1, 1, 1) + size));
                const Camera start{.azimuth = 0, .elevation = 0, .perspective = perspective};
                const Camera camera = fitted(start, flat, 1.5);
                for (int corner = 0; corner < 8; ++corner)
                    QVERIFY(projected(camera, 1.5, flat, cornerOf(flat, corner)).cwiseAbs().maxCoeff() <= 1);
            }
    }

    void eachUpAxisIsUpright()
    {
        std::mt19937 random(2);
        for (const UpAxis up : upAxes) {
            QVERIFY(directionOf(opposite(up)) == -directionOf(up));
            const Camera camera = upright(anyCamera(random), up);
            const Vector3d seen = eyeAxes(camera).transpose() * directionOf(up);
            QVERIFY(std::abs(seen.x()) < 1e-12 && seen.y() >= -1e-12);
            QVERIFY(std::abs(seen.z() - std::sin(camera.elevation * std::numbers::pi / 180)) < 1e-12);
            QVERIFY((eyeAxes(camera).transpose() * eyeAxes(camera)).isIdentity(1e-12));
            QVERIFY(eyeAxes(camera).determinant() > 0);
        }
        QVERIFY((eyeAxes({.azimuth = 0, .elevation = 0, .up = UpAxis::Y}).col(2)).isApprox(Vector3d(0, 0, 1)));
    }

    void rollTurnsThePictureClockwise()
    {
        const Camera camera{.azimuth = 0, .elevation = 0};
        const auto seen = [](const Camera& by, const Vector3d& direction) {
            return Vector3d(eyeAxes(by).transpose() * direction);
        };
        QVERIFY(seen(rolled(camera, 90), Vector3d::UnitZ()).isApprox(Vector3d(1, 0, 0))); // what was up is right
        QVERIFY(seen(rolled(camera, -90), Vector3d::UnitZ()).isApprox(Vector3d(-1, 0, 0)));
        QCOMPARE(rolled(rolled(camera, 100), 100).roll, -160.0);
        QVERIFY(eyePosition(rolled(camera, 33)).isApprox(eyePosition(camera)));
    }

    /// Any orientation is found again, also straight from above, whatever axis is up.
    void orientationsComeBack()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 1000; ++round) {
            Camera camera = anyCamera(random);
            if (round % 5 == 0)
                camera.elevation = round % 2 == 0 ? 90 : -90;
            Camera other = anyCamera(random);
            other.target = camera.target;
            other.distance = camera.distance;
            const Camera back = withEyeAxes(other, eyeAxes(camera));
            QVERIFY(back.up == other.up);
            QVERIFY(back.elevation >= -90 && back.elevation <= 90);
            QVERIFY((eyeAxes(back) - eyeAxes(camera)).cwiseAbs().maxCoeff() < 1e-8);
            const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();
            const Vector3d point(0.3, -0.2, 0.9);
            const Vector3d moved = eyeAxes(rotated(camera, turn)).transpose() * point;
            QVERIFY((moved - turn * (eyeAxes(camera).transpose() * point)).norm() < 1e-8);
        }
    }

    void fittedTakesAnyBox()
    {
        const Camera camera{.target = {9, 9, 9}, .distance = 3};
        QCOMPARE(fitted(camera, Eigen::AlignedBox3d()).distance, 3.0);
        const Camera onPoint = fitted(camera, {Vector3d(1, 1, 1), Vector3d(1, 1, 1)});
        QVERIFY(onPoint.distance > 0 && std::isfinite(onPoint.distance));
        QVERIFY(onPoint.target == Vector3d(1, 1, 1));
    }

    void turningStopsAtThePoles()
    {
        Camera camera{.azimuth = 170, .elevation = 20};
        camera = turned(camera, 30, 100);
        QCOMPARE(camera.azimuth, -160.0);
        QCOMPARE(camera.elevation, 90.0);
        QCOMPARE(turned(camera, 0, -500).elevation, -90.0);
        const Camera there = turned(turned(camera, 25, -30), -25, 30);
        QVERIFY(eyePosition(there).isApprox(eyePosition(camera)));
    }

    void zoomKeepsTheTarget()
    {
        const Camera camera{.target = {1, 2, 3}, .distance = 10};
        QCOMPARE(zoomed(camera, 0.5).distance, 5.0);
        QVERIFY(zoomed(camera, 0.5).target == camera.target);
        for (const double factor : {0.0, -1.0, std::nan("")})
            QCOMPARE(zoomed(camera, factor).distance, 10.0);
        Camera near = camera;
        for (int i = 0; i < 3000; ++i)
            near = zoomed(near, 0.5);
        QVERIFY(near.distance > 0);
    }

    /// Panning by a fraction of the shorter side moves the target's place in the picture by just that.
    void panMovesThePicture_data()
    {
        QTest::addColumn<bool>("perspective");
        QTest::addColumn<double>("aspectRatio");
        for (const bool perspective : {true, false})
            for (const double aspectRatio : {0.5, 1.0, 2.0})
                QTest::addRow("%d %g", perspective, aspectRatio) << perspective << aspectRatio;
    }
    void panMovesThePicture()
    {
        QFETCH(bool, perspective);
        QFETCH(double, aspectRatio);
        const Camera camera{
            .target = {1, 2, 3}, .distance = 20, .azimuth = 50, .elevation = -30, .perspective = perspective};
        const Vector3d place = projected(panned(camera, 0.25, -0.1), aspectRatio, box, camera.target);
        const double width = std::max(1.0, aspectRatio); // of the picture, in units of its shorter side
        const double height = std::max(1.0, 1 / aspectRatio);
        QVERIFY(std::abs(place.x() * width / 2 - -0.25) < 1e-12);
        QVERIFY(std::abs(place.y() * height / 2 - 0.1) < 1e-12);
    }

    /// The part of the target's plane that is seen is the same in both projections.
    void projectionsAgreeAtTheTarget()
    {
        Camera camera{.target = {1, 4, 4}, .distance = 15, .azimuth = 10, .elevation = 5};
        const Vector3d beside = panned(camera, 0.2, 0.3).target;
        const Vector3d perspective = projected(camera, 1.5, box, beside);
        camera.perspective = false;
        QVERIFY(projected(camera, 1.5, box, beside).head<2>().isApprox(perspective.head<2>()));
    }

    void eyeInsideTheBoxKeepsAPositiveNearPlane()
    {
        const Camera camera{.target = box.center(), .distance = 0.01};
        const Eigen::Matrix4d matrix = projectionMatrix(camera, 1, box);
        QVERIFY(matrix.allFinite());
        const Vector3d before = eyePosition(camera) - (eyePosition(camera) - camera.target).normalized() * 0.5;
        const Vector3d place = projected(camera, 1, box, before);
        QVERIFY(place.z() > -1 && place.z() < 1);
        Camera away = camera; // looking away from everything
        away.target += Vector3d(0, 100, 0);
        away.azimuth = 0;
        QVERIFY(projectionMatrix(away, 1, box).allFinite());
        QVERIFY(projectionMatrix(camera, 1, {}).allFinite());
    }
};

QTEST_GUILESS_MAIN(CameraTest)
#include "camera_test.moc"
