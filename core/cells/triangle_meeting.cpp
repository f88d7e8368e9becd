// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/triangle_meeting.h"

#include "core/cells/cell_orientation.h"

#include <algorithm>

namespace tetra {

namespace {

using Eigen::Vector3d;
using Triangle = std::array<std::uint32_t, 3>;

/// Some point outside the plane of a triangle.
Vector3d pointOffPlane(const Vector3d& a, const Vector3d& b, const Vector3d& c)
{
    for (int k = 0; k < 3; ++k) {
        Vector3d point = a;
        point[k] = 2 * point[k] + 1; // differs from a unless that is -1
        if (point[k] == a[k])
            point[k] = 0;
        if (orientation(a, b, c, point) != 0)
            return point;
    }
    return a;
}

/// The plane of a triangle, seen from a point off it.
class PlaneView {
public:
    PlaneView(const Vector3d& a, const Vector3d& b, const Vector3d& c) : eye_(pointOffPlane(a, b, c)) {}
    /// Which way p, q, r turn: 0 on a line.
    int turn(const Vector3d& p, const Vector3d& q, const Vector3d& r) const { return orientation(p, q, r, eye_); }

private:
    Vector3d eye_;
};

bool between(const Vector3d& p, const Vector3d& q, const Vector3d& onLine)
{
    return (p.cwiseMin(q).array() <= onLine.array()).all() && (onLine.array() <= p.cwiseMax(q).array()).all();
}

bool segmentsMeet(const PlaneView& view, const Vector3d& p, const Vector3d& q, const Vector3d& r, const Vector3d& s)
{
    const int pqr = view.turn(p, q, r), pqs = view.turn(p, q, s);
    const int rsp = view.turn(r, s, p), rsq = view.turn(r, s, q);
    if (pqr * pqs < 0 && rsp * rsq < 0)
        return true;
    return (pqr == 0 && between(p, q, r)) || (pqs == 0 && between(p, q, s)) || (rsp == 0 && between(r, s, p)) ||
           (rsq == 0 && between(r, s, q));
}

/// Of a segment in the triangle's plane.
bool meetsInPlane(const Vector3d& p, const Vector3d& q, const std::array<Vector3d, 3>& t)
{
    const PlaneView view(t[0], t[1], t[2]);
    const int side = view.turn(t[0], t[1], t[2]);
    const auto inside = [&](const Vector3d& point) {
        for (std::size_t i = 0; i < 3; ++i)
            if (view.turn(t[i], t[(i + 1) % 3], point) * side < 0)
                return false;
        return true;
    };
    if (inside(p))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (segmentsMeet(view, p, q, t[i], t[(i + 1) % 3]))
            return true;
    return false;
}

bool segmentMeetsTriangle(const Vector3d& p, const Vector3d& q, const std::array<Vector3d, 3>& t)
{
    const int atP = orientation(t[0], t[1], t[2], p), atQ = orientation(t[0], t[1], t[2], q);
    if (atP * atQ > 0)
        return false;
    if (atP == 0 && atQ == 0)
        return meetsInPlane(p, q, t);
    int lowest = 1, highest = -1;
    for (std::size_t i = 0; i < 3; ++i) {
        const int sign = orientation(p, q, t[i], t[(i + 1) % 3]);
        lowest = std::min(lowest, sign);
        highest = std::max(highest, sign);
    }
    return lowest >= 0 || highest <= 0;
}

/// Whether the edge from corner t[0] of the triangle to `end` runs into it or along one of its edges.
bool edgeRunsIntoTriangle(const Vector3d& end, const std::array<Vector3d, 3>& t)
{
    if (orientation(t[0], t[1], t[2], end) != 0)
        return false;
    const PlaneView view(t[0], t[1], t[2]);
    const int side = view.turn(t[0], t[1], t[2]);
    // In the plane a corner's angle is less than 180 degrees: on the inner side of both edges is in it.
    const int first = view.turn(t[0], t[1], end) * side, second = view.turn(t[0], end, t[2]) * side;
    if (first == 0 && second == 0)
        return false;
    if (first == 0)
        return second > 0;
    return first > 0 && second >= 0;
}

bool edgeMeets(std::span<const Vector3d> positions, std::uint32_t from, std::uint32_t to, const Triangle& triangle)
{
    const auto start = std::ranges::find(triangle, from), end = std::ranges::find(triangle, to);
    if (start != triangle.end() && end != triangle.end())
        return false;
    if (start == triangle.end() && end == triangle.end())
        return segmentMeetsTriangle(positions[from], positions[to],
                                    {positions[triangle[0]], positions[triangle[1]], positions[triangle[2]]});
    const auto shared = static_cast<std::size_t>((start != triangle.end() ? start : end) - triangle.begin());
    return edgeRunsIntoTriangle(
        positions[start != triangle.end() ? to : from],
        {positions[triangle[shared]], positions[triangle[(shared + 1) % 3]], positions[triangle[(shared + 2) % 3]]});
}

/// Whether the vertices that only `a` has are on one side of the plane of `b`: then no more of it is in that plane than
/// is shared. Most neighbours are told apart by this.
bool strictlyBeside(std::span<const Vector3d> positions, const Triangle& a, const Triangle& b)
{
    int side = 0;
    for (const std::uint32_t vertex : a) {
        if (std::ranges::find(b, vertex) != b.end())
            continue;
        const int sign = orientation(positions[b[0]], positions[b[1]], positions[b[2]], positions[vertex]);
        if (sign == 0 || sign == -side)
            return false;
        side = sign;
    }
    return true;
}

} // namespace

bool trianglesMeet(std::span<const Vector3d> positions, const Triangle& a, const Triangle& b)
{
    if (strictlyBeside(positions, a, b) || strictlyBeside(positions, b, a))
        return false;
    for (std::size_t i = 0; i < 3; ++i)
        if (edgeMeets(positions, a[i], a[(i + 1) % 3], b) || edgeMeets(positions, b[i], b[(i + 1) % 3], a))
            return true;
    return false;
}

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

} // namespace tetra
