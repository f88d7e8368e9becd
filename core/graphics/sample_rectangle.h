// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace tetra {

/// The samples [left, right) x [top, bottom) of a picture.
struct SampleRectangle {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    int width() const noexcept { return right - left; }
    int height() const noexcept { return bottom - top; }
    bool operator==(const SampleRectangle&) const = default;
};

inline SampleRectangle intersection(const SampleRectangle& a, const SampleRectangle& b)
{
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

inline bool isEmpty(const SampleRectangle& box)
{
    return box.left >= box.right || box.top >= box.bottom;
}

/// Where a sample lies, from the upper left corner of its square. Not quite in the middle, so that the corners and
/// faces of lattices, which views along an axis would put there, do not fall on samples.
inline constexpr double sampleX = 0.5 + 0.00137;
inline constexpr double sampleY = 0.5 + 0.00211;

} // namespace tetra
