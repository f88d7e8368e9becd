// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>

namespace tetra {

/// Width and height; empty unless both are positive.
struct Size {
    double width = 0;
    double height = 0;

    bool isEmpty() const noexcept { return !(width > 0 && height > 0); }
    bool operator==(const Size&) const = default;
};

/// A rectangle of a picture, x to the right and y down; empty without a positive width and height.
struct Rectangle {
    double left = 0;
    double top = 0;
    double width = 0;
    double height = 0;

    double right() const noexcept { return left + width; }
    double bottom() const noexcept { return top + height; }
    Size size() const noexcept { return {width, height}; }
    Eigen::Vector2d centre() const { return {left + width / 2, top + height / 2}; }
    bool isEmpty() const noexcept { return !(width > 0 && height > 0); }

    /// Larger by this on all four sides; smaller, if it is negative.
    Rectangle grown(double by) const noexcept { return {left - by, top - by, width + 2 * by, height + 2 * by}; }
    Rectangle centredAt(const Eigen::Vector2d& middle) const
    {
        return {middle.x() - width / 2, middle.y() - height / 2, width, height};
    }
    /// Whether a part of both is the same; those that only touch have none.
    bool intersects(const Rectangle& other) const noexcept
    {
        return !isEmpty() && !other.isEmpty() && left < other.right() && other.left < right() && top < other.bottom() &&
               other.top < bottom();
    }
    /// Whether all of the other lies in it.
    bool contains(const Rectangle& other) const noexcept
    {
        return other.left >= left && other.right() <= right() && other.top >= top && other.bottom() <= bottom();
    }
    bool operator==(const Rectangle&) const = default;
};

} // namespace tetra
