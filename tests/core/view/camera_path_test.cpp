// SPDX-License-Identifier: GPL-3.0-or-later
// What moves in a film goes through its keys, smoothly, and stays where its keys are equal.
#include "core/view/camera_path.h"

#include <tan/view.h>

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace tetra;

namespace {

constexpr int rounds = 200;

std::vector<double> randomTimes(std::mt19937& random)
{
    std::uniform_real_distribution<double> step(0.05, 3);
    std::vector<double> times{step(random)};
    for (unsigned count = 1 + random() % 6; count > 0; --count)
        times.push_back(times.back() + step(random));
    return times;
}

Camera randomCamera(std::mt19937& random)
{
    std::uniform_real_distribution<double> place(-10, 10), turn(-180, 180), height(-90, 90), field(10, 90);
    std::uniform_real_distribution<double> power(-3, 3);
    return {.target = {place(random), place(random), place(random)},
            .distance = std::pow(10, power(random)),
            .azimuth = turn(random),
            .elevation = height(random),
            .fieldOfView = field(random),
            .perspective = random() % 2 == 0};
}

std::vector<CameraKey> randomKeys(std::mt19937& random)
{
    std::vector<CameraKey> keys;
    for (const double time : randomTimes(random))
        keys.push_back({time, randomCamera(random)});
    return keys;
}

Eigen::Vector3d sight(const Camera& camera)
{
    return (camera.target - eyePosition(camera)) / camera.distance;
}

Eigen::Quaterniond orientation(const Camera& camera)
{
    return Eigen::Quaterniond(Eigen::Matrix3d(viewMatrix(camera).topLeftCorner<3, 3>()));
}

} // namespace

class CameraPathTest : public QObject {
    Q_OBJECT
private slots:
    void curvesGoThroughTheirKeysAndStayBetweenThem();
    void curvesAreSmooth();
    void pathsGoThroughTheirKeys();
    void pathsAreContinuous();
    void orientationsAreUnitQuaternionsWithoutRoll();
    void rolledKeysAreGoneThroughSmoothly();
    void rolledKeysTakeTheShorterWay();
    void equalKeysAreOnePlace();
    void azimuthsTakeTheShorterWay();
    void pathsRestBeforeAndAfter();
    void aTurntableClosesItsRound();
    void upAndDownStopsAtThePoles();
};

void CameraPathTest::curvesGoThroughTheirKeysAndStayBetweenThem()
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-5, 5), unit(0, 1);
    for (int round = 0; round < rounds; ++round) {
        const auto times = randomTimes(random);
        std::vector<double> values(times.size());
        for (double& value : values)
            value = any(random);
        for (std::size_t i = 0; i < times.size(); ++i)
            QCOMPARE(smoothCurveAt(times, values, times[i]), values[i]);
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double value = smoothCurveAt(times, values, std::lerp(times[i], times[i + 1], unit(random)));
            QVERIFY(value >= std::min(values[i], values[i + 1]) && value <= std::max(values[i], values[i + 1]));
        }
    }
}

/// The slopes on both sides of a key agree.
void CameraPathTest::curvesAreSmooth()
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> any(-5, 5);
    constexpr double step = 1e-6;
    for (int round = 0; round < rounds; ++round) {
        const auto times = randomTimes(random);
        std::vector<double> values(times.size());
        for (double& value : values)
            value = any(random);
        for (const double time : times) {
            const double here = smoothCurveAt(times, values, time);
            const double before = (here - smoothCurveAt(times, values, time - step)) / step;
            const double after = (smoothCurveAt(times, values, time + step) - here) / step;
            QVERIFY2(std::abs(before - after) < 0.1, qPrintable(QString::number(before - after)));
        }
    }
}

void CameraPathTest::pathsGoThroughTheirKeys()
{
    std::mt19937 random(3);
    for (int round = 0; round < rounds; ++round) {
        const auto keys = randomKeys(random);
        for (const CameraKey& key : keys)
            QVERIFY(cameraAt(keys, key.time) == key.camera);
    }
}

void CameraPathTest::pathsAreContinuous()
{
    std::mt19937 random(4);
    constexpr double step = 1e-7;
    for (int round = 0; round < rounds; ++round) {
        auto keys = randomKeys(random);
        for (CameraKey& key : keys)
            key.camera.perspective = true;
        std::uniform_real_distribution<double> within(keys.front().time - 0.1, keys.back().time + 0.1);
        std::vector<double> places{within(random), within(random), within(random)};
        for (const CameraKey& key : keys)
            places.push_back(key.time);
        for (const double time : places) {
            const Camera before = cameraAt(keys, time - step);
            const Camera after = cameraAt(keys, time + step);
            QVERIFY((before.target - after.target).norm() < 1e-3);
            QVERIFY(std::abs(std::log(before.distance / after.distance)) < 1e-3);
            QVERIFY((sight(before) - sight(after)).norm() < 1e-3);
            QVERIFY(std::abs(before.fieldOfView - after.fieldOfView) < 1e-2);
        }
    }
}

void CameraPathTest::orientationsAreUnitQuaternionsWithoutRoll()
{
    std::mt19937 random(5);
    for (int round = 0; round < rounds; ++round) {
        const auto keys = randomKeys(random);
        std::uniform_real_distribution<double> within(keys.front().time, keys.back().time);
        const Camera camera = cameraAt(keys, within(random));
        QVERIFY(std::abs(orientation(camera).norm() - 1) < 1e-12);
        QVERIFY(std::abs(sight(camera).norm() - 1) < 1e-9);
        const Eigen::Vector3d right = orientation(camera).conjugate() * Eigen::Vector3d::UnitX();
        QVERIFY(std::abs(right.z()) < 1e-12);
        QVERIFY(std::abs(camera.elevation) <= 90 && std::abs(camera.azimuth) <= 180 && camera.distance > 0);
    }
}

/// Cameras that a trackball has turned, with different axes up: no jump between keys and none at them.
void CameraPathTest::rolledKeysAreGoneThroughSmoothly()
{
    std::mt19937 random(8);
    std::uniform_real_distribution<double> turn(-180, 180);
    for (int round = 0; round < rounds; ++round) {
        std::vector<CameraKey> keys = randomKeys(random);
        for (CameraKey& key : keys) {
            key.camera.roll = turn(random);
            key.camera.up = static_cast<UpAxis>(random() % 6);
        }
        for (const CameraKey& key : keys)
            QVERIFY(orientation(cameraAt(keys, key.time)).angularDistance(orientation(key.camera)) < 1e-6);
        std::uniform_real_distribution<double> any(keys.front().time, keys.back().time);
        for (int sample = 0; sample < 50; ++sample) {
            const double time = any(random);
            const Camera camera = cameraAt(keys, time);
            QVERIFY((eyeAxes(camera).transpose() * eyeAxes(camera)).isIdentity(1e-9));
            QVERIFY(orientation(camera).angularDistance(orientation(cameraAt(keys, time + 1e-7))) < 1e-4);
        }
    }
}

/// Between two that are nearly turned alike nothing goes around, whichever of its two quaternions each one has.
void CameraPathTest::rolledKeysTakeTheShorterWay()
{
    std::mt19937 random(9);
    std::uniform_real_distribution<double> any(-1, 1);
    constexpr double between = 10 * std::numbers::pi / 180;
    int sides = 0;
    for (int round = 0; round < rounds; ++round) {
        const auto axis = [&] { return Eigen::Vector3d(any(random), any(random), any(random)).normalized(); };
        // About half a turn from the start, where the side changes that a quaternion is on.
        const Eigen::Matrix3d first(Eigen::AngleAxisd(std::numbers::pi * (1 + any(random) / 6), axis()));
        const Eigen::Matrix3d second = first * Eigen::AngleAxisd(between, axis()).toRotationMatrix();
        const std::vector<CameraKey> keys{{0, withEyeAxes({}, first)}, {1, withEyeAxes({}, second)}};
        sides += Eigen::Quaterniond(eyeAxes(keys[0].camera)).dot(Eigen::Quaterniond(eyeAxes(keys[1].camera))) < 0;
        for (int step = 0; step <= 16; ++step) {
            const Eigen::Quaterniond here = orientation(cameraAt(keys, step / 16.0));
            for (const CameraKey& key : keys)
                QVERIFY(here.angularDistance(orientation(key.camera)) < between + 1e-6);
        }
    }
    QVERIFY(sides > 3);
}

void CameraPathTest::equalKeysAreOnePlace()
{
    std::mt19937 random(6);
    for (int round = 0; round < rounds; ++round) {
        auto keys = randomKeys(random);
        for (CameraKey& key : keys)
            key.camera = keys.front().camera;
        std::uniform_real_distribution<double> within(keys.front().time - 1, keys.back().time + 1);
        QVERIFY(cameraAt(keys, within(random)) == keys.front().camera);
    }
}

void CameraPathTest::azimuthsTakeTheShorterWay()
{
    const std::vector<CameraKey> keys{{0, {.azimuth = 170}}, {1, {.azimuth = -170}}};
    QVERIFY(std::abs(std::abs(cameraAt(keys, 0.5).azimuth) - 180) < 1e-9);
    QVERIFY(cameraAt(keys, 0.25).azimuth > 170);
    QVERIFY(cameraAt(keys, 0.75).azimuth < -170);
}

void CameraPathTest::pathsRestBeforeAndAfter()
{
    std::mt19937 random(7);
    const auto keys = randomKeys(random);
    QVERIFY(cameraAt(keys, keys.front().time - 5) == keys.front().camera);
    QVERIFY(cameraAt(keys, keys.back().time + 5) == keys.back().camera);
    const std::vector<CameraKey> single{{2, keys.front().camera}};
    QVERIFY(cameraAt(single, 0) == single.front().camera && cameraAt(single, 9) == single.front().camera);
}

void CameraPathTest::aTurntableClosesItsRound()
{
    std::mt19937 random(8);
    for (int round = 0; round < rounds; ++round) {
        const Camera start = randomCamera(random);
        const Turntable turntable{Turntable::Axis::Vertical, random() % 2 == 0 ? 360.0 : -360.0,
                                  static_cast<int>(1 + random() % 200)};
        QVERIFY(turntableCamera(start, turntable, 0) == start);
        QVERIFY((sight(turntableCamera(start, turntable, turntable.frames)) - sight(start)).norm() < 1e-9);
        const double each = turntable.degrees / turntable.frames;
        for (int frame = 0; frame < turntable.frames; ++frame) {
            const double moved =
                turntableCamera(start, turntable, frame + 1).azimuth - turntableCamera(start, turntable, frame).azimuth;
            QVERIFY(std::abs(std::remainder(moved - each, 360.0)) < 1e-9);
        }
    }
}

void CameraPathTest::upAndDownStopsAtThePoles()
{
    const Camera start{.elevation = 60};
    const Turntable turntable{Turntable::Axis::Horizontal, 80, 40};
    double highest = -90, lowest = 90;
    for (int frame = 0; frame < 40; ++frame) {
        const Camera camera = turntableCamera(start, turntable, frame);
        QCOMPARE(camera.azimuth, start.azimuth);
        highest = std::max(highest, camera.elevation);
        lowest = std::min(lowest, camera.elevation);
    }
    QCOMPARE(highest, 90.0);
    QCOMPARE(lowest, 20.0);
}

QTEST_GUILESS_MAIN(CameraPathTest)
#include "camera_path_test.moc"
