// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/animation/camera_path.h"

#include <tan/render.h>
#include <tan/transfer.h>

#include <cstdint>
#include <vector>

namespace tetra {

/// What of a view can move in a film.
struct FilmFrame {
    Camera camera;
    TransferFunction transfer;
    std::vector<Isovalue> isovalues;
    double error = 1; ///< as in QueryState, with the next two
    bool byBudget = false;
    std::uint64_t budget = 300'000;
    bool operator==(const FilmFrame&) const = default;
};

struct KeyFrame {
    double time = 0; ///< seconds
    FilmFrame frame;
    bool operator==(const KeyFrame&) const = default;
};

/// A film of the model: a value. Frames are numbered from 0.
struct Animation {
    enum class Kind { Turntable, KeyFrames };
    Kind kind = Kind::Turntable;
    double framesPerSecond = 30;
    Turntable turntable;
    std::vector<KeyFrame> keys; ///< in the order of their times, which differ by leastKeyDistance or more
    bool operator==(const Animation&) const = default;
};

inline constexpr int mostFrames = 100'000;
inline constexpr double leastKeyDistance = 0.01; ///< seconds
inline constexpr double longestFilm = 3600;      ///< seconds

/// None for fewer than two keys.
int frameCount(const Animation& animation);
/// Seconds.
double durationOf(const Animation& animation);
/// What the frame shows; `start` is the present view, from which a turntable starts. Cameras go a smooth path, values
/// are linear between their keys.
FilmFrame frameOf(const Animation& animation, const FilmFrame& start, int frame);

/// With numbers in their ranges, keys in order and apart.
Animation corrected(Animation animation);
/// With a key after the last one, a usual time later; the first is at zero.
Animation withKey(Animation animation, const FilmFrame& frame);
Animation withoutKey(Animation animation, int index);
/// With the key at another time; it stands where that belongs. The time moves to the nearest that is free.
Animation withKeyAt(Animation animation, int index, double time);
/// With the contents of two neighbours exchanged, their times left: the key moves by one (steps -1 or 1).
Animation withKeyMoved(Animation animation, int index, int steps);

} // namespace tetra
