// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/camera_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace tetra {

namespace {

double slope(std::span<const double> times, std::span<const double> values, std::size_t i)
{
    return (values[i + 1] - values[i]) / (times[i + 1] - times[i]);
}

/// The weighted harmonic mean of the slopes on both sides, and none at an extremum: so the curve stays between its
/// keys. None at the ends, either: a film begins and ends at rest.
double tangentAt(std::span<const double> times, std::span<const double> values, std::size_t i)
{
    if (i == 0 || i + 1 == times.size())
        return 0;
    const double before = slope(times, values, i - 1);
    const double after = slope(times, values, i);
    if (!(before * after > 0))
        return 0;
    const double first = times[i] - times[i - 1];
    const double second = times[i + 1] - times[i];
    return 3 * (first + second) / ((2 * second + first) / before + (second + 2 * first) / after);
}

} // namespace

double smoothCurveAt(std::span<const double> times, std::span<const double> values, double time)
{
    if (!(time > times.front()))
        return values.front();
    if (time >= times.back())
        return values.back();
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, time) - times.begin());
    const std::size_t last = next - 1;
    const double length = times[next] - times[last];
    const double part = (time - times[last]) / length;
    const double rest = 1 - part;
    // Hermite's form.
    const double value =
        values[last] * (1 + 2 * part) * rest * rest + values[next] * (3 - 2 * part) * part * part +
        length * part * rest * (tangentAt(times, values, last) * rest - tangentAt(times, values, next) * part);
    const auto [least, largest] = std::minmax(values[last], values[next]);
    return std::clamp(value, least, largest); // rounding may leave them
}

namespace {

/// smoothCurveAt() of what `member` gives for each key.
template <class Member>
double smooth(std::span<const CameraKey> keys, std::span<const double> times, double time, Member member)
{
    std::vector<double> values;
    for (const CameraKey& key : keys)
        values.push_back(member(key.camera));
    return smoothCurveAt(times, values, time);
}

/// Each angle within half a turn of the last one.
double smoothAzimuth(std::span<const CameraKey> keys, std::span<const double> times, double time)
{
    std::vector<double> angles{keys.front().camera.azimuth};
    for (const CameraKey& key : keys.subspan(1))
        angles.push_back(angles.back() + std::remainder(key.camera.azimuth - angles.back(), 360.0));
    return std::remainder(smoothCurveAt(times, angles, time), 360.0);
}

bool differInHorizon(std::span<const CameraKey> keys)
{
    const Camera& first = keys.front().camera;
    return std::ranges::any_of(
        keys, [&](const CameraKey& key) { return key.camera.up != first.up || key.camera.roll != first.roll; });
}

/// Each quaternion on the same side as the last one.
Eigen::Matrix3d smoothOrientation(std::span<const CameraKey> keys, std::span<const double> times, double time)
{
    std::vector<Eigen::Quaterniond> turns;
    for (const CameraKey& key : keys) {
        Eigen::Quaterniond turn(eyeAxes(key.camera));
        if (!turns.empty() && turn.dot(turns.back()) < 0)
            turn.coeffs() *= -1;
        turns.push_back(turn);
    }
    Eigen::Quaterniond result;
    for (int part = 0; part < 4; ++part) {
        std::vector<double> values;
        for (const Eigen::Quaterniond& turn : turns)
            values.push_back(turn.coeffs()[part]);
        result.coeffs()[part] = smoothCurveAt(times, values, time);
    }
    return result.normalized().toRotationMatrix();
}

} // namespace

Camera cameraAt(std::span<const CameraKey> keys, double time)
{
    const auto next = std::ranges::upper_bound(keys, time, {}, &CameraKey::time);
    if (next == keys.begin())
        return keys.front().camera;
    const CameraKey& last = *(next - 1);
    if (next == keys.end() || last.time == time)
        return last.camera;
    std::vector<double> times;
    for (const CameraKey& key : keys)
        times.push_back(key.time);
    const auto at = [&](auto member) { return smooth(keys, times, time, member); };
    Camera camera = last.camera;
    for (int axis = 0; axis < 3; ++axis)
        camera.target[axis] = at([axis](const Camera& key) { return key.target[axis]; });
    if (last.camera.distance != next->camera.distance)
        camera.distance = std::exp(at([](const Camera& key) { return std::log(key.distance); }));
    camera.fieldOfView = at([](const Camera& key) { return key.fieldOfView; });
    if (differInHorizon(keys))
        return withEyeAxes(camera, smoothOrientation(keys, times, time));
    if (last.camera.azimuth != next->camera.azimuth)
        camera.azimuth = smoothAzimuth(keys, times, time);
    camera.elevation = at([](const Camera& key) { return key.elevation; });
    return camera;
}

Camera turntableCamera(const Camera& start, const Turntable& turntable, int frame)
{
    if (frame == 0)
        return start;
    const double part = static_cast<double>(frame) / turntable.frames;
    if (turntable.axis == Turntable::Axis::Vertical)
        return turned(start, turntable.degrees * part, 0);
    return turned(start, 0, turntable.degrees / 2 * std::sin(2 * std::numbers::pi * part));
}

} // namespace tetra
