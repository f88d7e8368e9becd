// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/animation.h"

#include "core/view/blending.h"
#include "core/view/camera_path.h"

#include <tan/view.h>

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

constexpr double usualKeyDistance = 2; ///< seconds
constexpr double mostDegrees = 36'000;

FilmFrame frameAt(const std::vector<KeyFrame>& keys, double time)
{
    std::vector<CameraKey> cameras;
    for (const KeyFrame& key : keys)
        cameras.push_back({key.time, key.frame.camera});
    const auto next = std::ranges::upper_bound(keys, time, {}, &KeyFrame::time);
    if (next == keys.begin())
        return keys.front().frame;
    const KeyFrame& last = *(next - 1);
    FilmFrame frame = last.frame;
    frame.camera = cameraAt(cameras, time);
    if (next == keys.end())
        return frame;
    const double part = (time - last.time) / (next->time - last.time);
    frame.transfer = blended(last.frame.transfer, next->frame.transfer, part);
    frame.isovalues = blended(last.frame.isovalues, next->frame.isovalues, part);
    frame.error = std::lerp(last.frame.error, next->frame.error, part);
    frame.budget = static_cast<std::uint64_t>(
        std::llround(std::lerp(static_cast<double>(last.frame.budget), static_cast<double>(next->frame.budget), part)));
    return frame;
}

double finite(double value, double otherwise)
{
    return std::isfinite(value) ? value : otherwise;
}

/// In order, and each apart from the one before.
void separate(std::vector<KeyFrame>& keys)
{
    for (KeyFrame& key : keys)
        key.time = std::clamp(finite(key.time, 0), 0.0, longestFilm);
    std::ranges::stable_sort(keys, {}, &KeyFrame::time);
    for (std::size_t i = 1; i < keys.size(); ++i)
        keys[i].time = std::max(keys[i].time, keys[i - 1].time + leastKeyDistance);
}

bool isIndex(const std::vector<KeyFrame>& keys, int index)
{
    return index >= 0 && index < static_cast<int>(keys.size());
}

} // namespace

double durationOf(const Animation& animation)
{
    return frameCount(animation) / animation.framesPerSecond;
}

int frameCount(const Animation& animation)
{
    if (animation.kind == Animation::Kind::Turntable)
        return animation.turntable.frames;
    if (animation.keys.size() < 2)
        return 0;
    const double seconds = animation.keys.back().time - animation.keys.front().time;
    return static_cast<int>(std::clamp(std::round(seconds * animation.framesPerSecond) + 1, 2.0, double(mostFrames)));
}

FilmFrame frameOf(const Animation& animation, const FilmFrame& start, int frame)
{
    if (animation.kind == Animation::Kind::KeyFrames && animation.keys.size() > 1) {
        const double first = animation.keys.front().time;
        const double last = animation.keys.back().time;
        return frameAt(animation.keys, std::lerp(first, last, frame / (frameCount(animation) - 1.0)));
    }
    FilmFrame turned = start;
    turned.camera = turntableCamera(start.camera, animation.turntable, frame);
    return turned;
}

Animation corrected(Animation animation)
{
    const Animation usual;
    animation.framesPerSecond = std::clamp(finite(animation.framesPerSecond, usual.framesPerSecond), 1.0, 120.0);
    Turntable& turntable = animation.turntable;
    turntable.degrees = std::clamp(finite(turntable.degrees, usual.turntable.degrees), -mostDegrees, mostDegrees);
    turntable.frames = std::clamp(turntable.frames, 1, mostFrames);
    separate(animation.keys);
    return animation;
}

Animation withKey(Animation animation, const FilmFrame& frame)
{
    const double time = animation.keys.empty() ? 0 : animation.keys.back().time + usualKeyDistance;
    animation.keys.push_back({time, frame});
    return corrected(animation);
}

Animation withoutKey(Animation animation, int index)
{
    if (isIndex(animation.keys, index))
        animation.keys.erase(animation.keys.begin() + index);
    return animation;
}

Animation withKeyAt(Animation animation, int index, double time)
{
    if (!isIndex(animation.keys, index))
        return animation;
    animation.keys[static_cast<std::size_t>(index)].time = time;
    return corrected(animation);
}

Animation withKeyMoved(Animation animation, int index, int steps)
{
    if (isIndex(animation.keys, index) && isIndex(animation.keys, index + steps))
        std::swap(animation.keys[static_cast<std::size_t>(index)].frame,
                  animation.keys[static_cast<std::size_t>(index + steps)].frame);
    return animation;
}

} // namespace tetra
