// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/guarded.h"
#include "core/render/view_transform.h"

#include <tan/base.h>

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <vector>

namespace tetra {

inline constexpr MarkedText noMemoryForPicture = Message::marked(
    "Not enough memory for a picture of this size and scene. Make the picture smaller or lower the accuracy of the "
    "mesh.");

/// What `work`, which draws a scene, returns: a Result or a Status. What a custom drawable or an optical model throws,
/// and a lack of memory, become errors; the former names the `maker` (Scene::maker).
template <class Work> auto guardedDrawing(const std::string& maker, const Work& work) -> decltype(work())
try {
    return guarded(noMemoryForPicture, work);
} catch (const std::exception& problem) {
    if (!maker.empty())
        return Error{ErrorKind::BadInput,
                     Message::say("The plugin '%1' failed: %2. This is a fault of the plugin; tell its author.", maker,
                                  problem.what())};
    return Error{
        ErrorKind::BadInput,
        Message::say("Drawing the scene failed: %1. This is a fault of the plugin that made it; tell its author.",
                     problem.what())};
}

/// Runs `work`, which returns a Result, on as many threads as are wanted; 0 or too many means all of the machine.
/// std::bad_alloc becomes an error.
template <class Work> auto onThreads(int threads, Work&& work) -> decltype(work())
{
    return guarded(noMemoryForPicture, [&] {
        const int all = tbb::info::default_concurrency();
        tbb::task_arena arena(threads > 0 ? std::min(threads, all) : all);
        return arena.execute(work);
    });
}

/// A picture of samples cut into square tiles, row by row from the top.
struct TileGrid {
    int width = 0; ///< in samples, like height and side
    int height = 0;
    int side = 64;

    int columns() const noexcept { return (width + side - 1) / side; }
    int rows() const noexcept { return (height + side - 1) / side; }
    std::size_t count() const noexcept
    {
        return static_cast<std::size_t>(columns()) * static_cast<std::size_t>(rows());
    }
    SampleRectangle tile(std::size_t index) const noexcept
    {
        const int left = static_cast<int>(index % static_cast<std::size_t>(columns())) * side;
        const int top = static_cast<int>(index / static_cast<std::size_t>(columns())) * side;
        return {left, top, std::min(left + side, width), std::min(top + side, height)};
    }
};

/// Pictures with more samples a side than this are drawn in parts, so that what is kept for their samples at one time,
/// and the coordinates in them, stay bounded. Twice what the largest screens have.
inline constexpr int largestPartSide = 8192;

/// `all` in parts, row by row, whose sides but the last are the largest multiples of `step` within `longest` samples.
inline std::vector<SampleRectangle> partsOf(const SampleRectangle& all, int step, int longest = largestPartSide)
{
    const int side = longest / step * step;
    std::vector<SampleRectangle> parts;
    for (int top = all.top; top < all.bottom; top += side)
        for (int left = all.left; left < all.right; left += side)
            parts.push_back({left, top, std::min(left + side, all.right), std::min(top + side, all.bottom)});
    return parts;
}

/// Colour times opacity, and opacity.
using PremultipliedColour = std::array<float, 4>;

/// Where a ray meets a surface or a line.
struct SurfaceFragment {
    float nearness; ///< q of ViewTransform
    PremultipliedColour colour;
};

/// What surfaces the rays of a tile meet.
struct SurfaceFragments {
    /// Of each sample front to back, no further than to what lets no light through, and then one that is farther than
    /// everything and shows nothing.
    std::vector<SurfaceFragment> fragments;
    std::vector<std::uint32_t> first; ///< for each sample, row by row, the place of its first fragment
    bool empty = true;                ///< no sample meets any
};

} // namespace tetra
