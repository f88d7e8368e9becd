// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/animation/camera_path.h"

#include "core/graphics/animation/smooth_curve.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace tetra {
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
    if (last.camera.azimuth != next->camera.azimuth)
        camera.azimuth = smoothAzimuth(keys, times, time);
    camera.elevation = at([](const Camera& key) { return key.elevation; });
    camera.fieldOfView = at([](const Camera& key) { return key.fieldOfView; });
    return camera;
}

} // namespace tetra
