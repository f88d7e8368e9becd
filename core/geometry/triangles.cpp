// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/triangles.h"

#include "core/geometry/orientation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tetra {

namespace {

using TrianglePoint = std::array<double, 3>;
using ExactCorners = std::array<TrianglePoint, 3>;

ExactCorners cornersOf(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle)
{
    ExactCorners corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d& p = positions[triangle[i]];
        corners[i] = {p.x(), p.y(), p.z()};
    }
    return corners;
}

/// The side of r of the line from p to q, seen along an axis.
int sideAlong(std::size_t axis, const TrianglePoint& p, const TrianglePoint& q, const TrianglePoint& r)
{
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    return orientationSign({p[x], p[y], 0}, {q[x], q[y], 0}, {r[x], r[y], 0}, {p[x], p[y], 1});
}

/// An axis along which the triangle is seen with an area; 3 if it has none.
std::size_t viewingAxis(const ExactCorners& t)
{
    std::array<double, 3> area{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
        area[axis] = std::abs((t[1][x] - t[0][x]) * (t[2][y] - t[0][y]) - (t[1][y] - t[0][y]) * (t[2][x] - t[0][x]));
    }
    const auto widest = static_cast<std::size_t>(std::ranges::max_element(area) - area.begin());
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t axis = (widest + i) % 3;
        if (sideAlong(axis, t[0], t[1], t[2]) != 0)
            return axis;
    }
    return 3;
}

/// Whether r, on the line through p and q, is between them or one of them.
bool isBetween(const TrianglePoint& p, const TrianglePoint& q, const TrianglePoint& r)
{
    for (std::size_t k = 0; k < 3; ++k) {
        if (r[k] < std::min(p[k], q[k]) || r[k] > std::max(p[k], q[k]))
            return false;
    }
    return true;
}

/// In one plane that is not seen edge-on along the axis; ends count.
bool segmentsMeetInPlane(std::size_t axis, const TrianglePoint& p, const TrianglePoint& q, const TrianglePoint& r,
                         const TrianglePoint& s)
{
    const int rSide = sideAlong(axis, p, q, r), sSide = sideAlong(axis, p, q, s);
    if (rSide * sSide > 0)
        return false;
    const int pSide = sideAlong(axis, r, s, p), qSide = sideAlong(axis, r, s, q);
    if (pSide * qSide > 0)
        return false;
    if (rSide != 0 || sSide != 0)
        return true;
    return isBetween(p, q, r) || isBetween(p, q, s) || isBetween(r, s, p);
}

bool segmentMeetsInPlane(const TrianglePoint& p, const TrianglePoint& q, const ExactCorners& t)
{
    const std::size_t axis = viewingAxis(t);
    if (axis == 3)
        return true; // not a triangle: nothing good is said of it
    const int turn = sideAlong(axis, t[0], t[1], t[2]);
    bool inside = true;
    for (std::size_t i = 0; i < 3; ++i)
        inside = inside && sideAlong(axis, t[i], t[(i + 1) % 3], p) * turn >= 0;
    if (inside)
        return true;
    for (std::size_t i = 0; i < 3; ++i) {
        if (segmentsMeetInPlane(axis, p, q, t[i], t[(i + 1) % 3]))
            return true;
    }
    return false;
}

int sideOf(const ExactCorners& t, const TrianglePoint& p)
{
    return orientationSign(t[0], t[1], t[2], p);
}

/// Of a segment whose ends are on the given sides of the triangle's plane; ends and edges count.
bool segmentMeets(const TrianglePoint& p, const TrianglePoint& q, int pSide, int qSide, const ExactCorners& t)
{
    if (pSide * qSide > 0)
        return false;
    if (pSide == 0 && qSide == 0)
        return segmentMeetsInPlane(p, q, t);
    int least = 1, largest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const int turn = orientationSign(p, q, t[i], t[(i + 1) % 3]);
        least = std::min(least, turn);
        largest = std::max(largest, turn);
        if (least * largest < 0)
            return false;
    }
    return true;
}

bool anyEdgeMeets(const ExactCorners& edges, const std::array<int, 3>& sides, const ExactCorners& t)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (i + 1) % 3;
        if (segmentMeets(edges[i], edges[next], sides[i], sides[next], t))
            return true;
    }
    return false;
}

bool allOnOneSide(const std::array<int, 3>& sides)
{
    return sides[0] != 0 && sides[0] == sides[1] && sides[0] == sides[2];
}

bool strangersMeet(const ExactCorners& one, const ExactCorners& other)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax({one[0][k], one[1][k], one[2][k]});
        const auto [otherLow, otherHigh] = std::minmax({other[0][k], other[1][k], other[2][k]});
        if (high < otherLow || otherHigh < low)
            return false;
    }
    const std::array<int, 3> sides{sideOf(one, other[0]), sideOf(one, other[1]), sideOf(one, other[2])};
    if (allOnOneSide(sides))
        return false;
    const std::array<int, 3> otherSides{sideOf(other, one[0]), sideOf(other, one[1]), sideOf(other, one[2])};
    if (allOnOneSide(otherSides))
        return false;
    return anyEdgeMeets(other, sides, one) || anyEdgeMeets(one, otherSides, other);
}

/// Their first corner is the same: whoever leaves it inside both comes to the opposite edge of one.
bool meetBesideCorner(const ExactCorners& one, const ExactCorners& other)
{
    const int side1 = sideOf(one, other[1]), side2 = sideOf(one, other[2]);
    if (side1 * side2 > 0)
        return false;
    const int otherSide1 = sideOf(other, one[1]), otherSide2 = sideOf(other, one[2]);
    if (otherSide1 * otherSide2 > 0)
        return false;
    return segmentMeets(other[1], other[2], side1, side2, one) ||
           segmentMeets(one[1], one[2], otherSide1, otherSide2, other);
}

/// Their first two corners are the same.
bool meetBesideEdge(const ExactCorners& one, const ExactCorners& other)
{
    if (sideOf(one, other[2]) != 0)
        return false;
    const std::size_t axis = viewingAxis(one);
    return axis == 3 || sideAlong(axis, one[0], one[1], one[2]) * sideAlong(axis, one[0], one[1], other[2]) >= 0;
}

} // namespace

bool surfaceTrianglesMeet(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& one,
                          const SurfaceTriangle& other)
{
    // What they share comes first, in the same order in both.
    SurfaceTriangle left = one, right = other;
    std::size_t shared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = shared; j < 3; ++j) {
            if (left[i] != right[j])
                continue;
            std::swap(left[i], left[shared]);
            std::swap(right[j], right[shared]);
            ++shared;
            break;
        }
    }
    const ExactCorners leftCorners = cornersOf(positions, left), rightCorners = cornersOf(positions, right);
    switch (shared) {
    case 0: return strangersMeet(leftCorners, rightCorners);
    case 1: return meetBesideCorner(leftCorners, rightCorners);
    case 2: return meetBesideEdge(leftCorners, rightCorners);
    default: return true;
    }
}

bool withoutArea(std::span<const Eigen::Vector3d> positions, const SurfaceTriangle& triangle)
{
    return viewingAxis(cornersOf(positions, triangle)) == 3;
}

using Eigen::Vector3d;

Crossing crossingOf(const Vector3d& from, const Vector3d& to, const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    const int atFrom = orientation(a, b, c, from), atTo = orientation(a, b, c, to);
    if (atTo == 0)
        return Crossing::Unclear;
    if (atFrom == atTo || atFrom == 0)
        return Crossing::None;
    const int ab = orientation(from, to, a, b), bc = orientation(from, to, b, c), ca = orientation(from, to, c, a);
    const bool negative = ab < 0 || bc < 0 || ca<0, positive = ab> 0 || bc > 0 || ca > 0;
    if (negative && positive)
        return Crossing::None;
    if (ab == 0 || bc == 0 || ca == 0)
        return Crossing::Unclear;
    return atTo > 0 ? Crossing::Leaving : Crossing::Entering;
}

std::array<double, 3> nearestWeights(const std::array<std::array<double, 3>, 3>& corners)
{
    const Eigen::Map<const Eigen::Vector3d> a(corners[0].data()), b(corners[1].data()), c(corners[2].data());
    const Eigen::Vector3d ab = b - a, ac = c - a;
    const double abA = -ab.dot(a), acA = -ac.dot(a);
    if (abA <= 0 && acA <= 0)
        return {1, 0, 0};
    const double abB = -ab.dot(b), acB = -ac.dot(b);
    if (abB >= 0 && acB <= abB)
        return {0, 1, 0};
    const double besideC = abA * acB - abB * acA;
    if (besideC <= 0 && abA >= 0 && abB <= 0) {
        const double t = abA / (abA - abB);
        return {1 - t, t, 0};
    }
    const double abC = -ab.dot(c), acC = -ac.dot(c);
    if (acC >= 0 && abC <= acC)
        return {0, 0, 1};
    const double besideB = abC * acA - abA * acC;
    if (besideB <= 0 && acA >= 0 && acC <= 0) {
        const double t = acA / (acA - acC);
        return {1 - t, 0, t};
    }
    const double besideA = abB * acC - abC * acB;
    if (besideA <= 0 && acB - abB >= 0 && abC - acC >= 0) {
        const double t = (acB - abB) / ((acB - abB) + (abC - acC));
        return {0, 1 - t, t};
    }
    const double all = besideA + besideB + besideC;
    return {1 - besideB / all - besideC / all, besideB / all, besideC / all};
}

} // namespace tetra
