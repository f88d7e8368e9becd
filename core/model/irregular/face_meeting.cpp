// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/face_meeting.h"

#include "core/model/exact_volume.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace tetra {

namespace {

using SpacePlace = Eigen::Vector3d;
using MeetingTriangle = std::array<SpacePlace, 3>;

/// The side of a line in the plane without the axis `out`: of c beside the line from a to b.
int sideInPlane(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, int out)
{
    SpacePlace p = a, q = b, r = c;
    p[out] = q[out] = r[out] = 0;
    SpacePlace above = p;
    above[out] = 1;
    return volumeSign(p, q, r, above);
}

/// An axis along which the triangle, which is not flat, has a projection that is not flat.
int axisToLeaveOut(const MeetingTriangle& t)
{
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]).cwiseAbs();
    int best = 0;
    normal.maxCoeff(&best);
    for (const int axis : {best, (best + 1) % 3, (best + 2) % 3})
        if (sideInPlane(t[0], t[1], t[2], axis) != 0)
            return axis;
    return best;
}

bool holdsInPlane(const MeetingTriangle& t, const SpacePlace& place, int out)
{
    const int sides[] = {sideInPlane(t[0], t[1], place, out), sideInPlane(t[1], t[2], place, out),
                         sideInPlane(t[2], t[0], place, out)};
    return std::ranges::all_of(sides, [](int side) { return side >= 0; }) ||
           std::ranges::all_of(sides, [](int side) { return side <= 0; });
}

/// Of segments on one line at most: whether their boxes overlap.
bool boxesMeet(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, const SpacePlace& d)
{
    return (a.cwiseMin(b).array() <= c.cwiseMax(d).array()).all() &&
           (c.cwiseMin(d).array() <= a.cwiseMax(b).array()).all();
}

bool segmentsMeetInPlane(const SpacePlace& a, const SpacePlace& b, const SpacePlace& c, const SpacePlace& d, int out)
{
    if (!boxesMeet(a, b, c, d))
        return false;
    return sideInPlane(a, b, c, out) * sideInPlane(a, b, d, out) <= 0 &&
           sideInPlane(c, d, a, out) * sideInPlane(c, d, b, out) <= 0;
}

/// All in one plane.
bool segmentMeetsInPlane(const SpacePlace& from, const SpacePlace& to, const MeetingTriangle& t)
{
    const int out = axisToLeaveOut(t);
    return holdsInPlane(t, from, out) || holdsInPlane(t, to, out) || segmentsMeetInPlane(from, to, t[0], t[1], out) ||
           segmentsMeetInPlane(from, to, t[1], t[2], out) || segmentsMeetInPlane(from, to, t[2], t[0], out);
}

bool segmentMeets(const SpacePlace& from, const SpacePlace& to, const MeetingTriangle& t)
{
    const int first = volumeSign(t[0], t[1], t[2], from);
    const int second = volumeSign(t[0], t[1], t[2], to);
    if (first * second > 0)
        return false;
    if (first == 0 && second == 0)
        return segmentMeetsInPlane(from, to, t);
    const int sides[] = {volumeSign(from, to, t[0], t[1]), volumeSign(from, to, t[1], t[2]),
                         volumeSign(from, to, t[2], t[0])};
    return std::ranges::all_of(sides, [](int side) { return side >= 0; }) ||
           std::ranges::all_of(sides, [](int side) { return side <= 0; });
}

/// Two triangles with the points that they share in front, in the same order.
struct Pair {
    MeetingTriangle first;
    MeetingTriangle second;
    std::size_t shared = 0;
};

Pair pairOf(std::span<const SpacePlace> positions, PointTriangle first, PointTriangle second)
{
    Pair pair;
    for (std::size_t i = pair.shared; i < 3; ++i) {
        const auto same = std::find(second.begin() + static_cast<std::ptrdiff_t>(pair.shared), second.end(), first[i]);
        if (same == second.end())
            continue;
        std::swap(second[pair.shared], *same);
        std::swap(first[pair.shared], first[i]);
        ++pair.shared;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        pair.first[i] = positions[first[i]];
        pair.second[i] = positions[second[i]];
    }
    return pair;
}

/// Whether a plane across the axis has the triangles on its sides, with nothing but what they share in it; `doubt` is
/// more than what rounding can do to a coordinate along an axis of length 1.
bool separates(const Pair& pair, const SpacePlace& axis, double doubt)
{
    const double margin = doubt * axis.lpNorm<1>();
    if (!(margin > 0))
        return false;
    // The origin is shared, or the mean of two corners: where the plane goes through is free unless points are shared.
    const SpacePlace& origin = pair.first[0];
    double low[2], high[2];
    for (int which = 0; which < 2; ++which) {
        const MeetingTriangle& t = which == 0 ? pair.first : pair.second;
        low[which] = std::numeric_limits<double>::infinity();
        high[which] = -low[which];
        for (std::size_t i = pair.shared; i < 3; ++i) {
            const double at = axis.dot(t[i] - origin);
            low[which] = std::min(low[which], at);
            high[which] = std::max(high[which], at);
        }
    }
    if (pair.shared == 0)
        return low[0] - margin > high[1] + margin || low[1] - margin > high[0] + margin;
    return (low[0] > margin && high[1] < -margin) || (low[1] > margin && high[0] < -margin);
}

/// True only if the triangles have nothing in common but one shared point, or nothing at all: what most pairs are.
bool arePlainlyApart(const Pair& pair)
{
    const auto edges = [](const MeetingTriangle& t) {
        return std::array<SpacePlace, 3>{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
    };
    const auto first = edges(pair.first), second = edges(pair.second);
    double size = 0;
    for (const MeetingTriangle* t : {&pair.first, &pair.second})
        for (const SpacePlace& corner : *t)
            size = std::max(size, corner.cwiseAbs().maxCoeff());
    const double doubt = 0x1p-48 * size;
    const SpacePlace firstNormal = first[0].cross(first[2]), secondNormal = second[0].cross(second[2]);
    if (separates(pair, firstNormal, doubt) || separates(pair, secondNormal, doubt))
        return true;
    const SpacePlace middles = (pair.second[1] + pair.second[2]) - (pair.first[1] + pair.first[2]);
    if (separates(pair, middles, doubt))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        if (separates(pair, firstNormal.cross(first[i]), doubt) ||
            separates(pair, secondNormal.cross(second[i]), doubt))
            return true;
    if (pair.shared == 1) { // between the sides of the two that are next to each other
        for (const SpacePlace& a :
             {SpacePlace(pair.first[1] - pair.first[0]), SpacePlace(pair.first[2] - pair.first[0])})
            for (const SpacePlace& b :
                 {SpacePlace(pair.second[1] - pair.first[0]), SpacePlace(pair.second[2] - pair.first[0])}) {
                const SpacePlace between = a.normalized() + b.normalized();
                if (separates(pair, firstNormal.cross(between), doubt) ||
                    separates(pair, secondNormal.cross(between), doubt))
                    return true;
            }
        return false;
    }
    for (const SpacePlace& a : first)
        for (const SpacePlace& b : second)
            if (separates(pair, a.cross(b), doubt))
                return true;
    return false;
}

/// Of two that share an edge: one lies on the other.
bool areFolded(const Pair& pair)
{
    const auto normal = [](const MeetingTriangle& t) -> SpacePlace { return (t[1] - t[0]).cross(t[2] - t[0]); };
    const SpacePlace first = normal(pair.first), second = normal(pair.second);
    // On opposite sides of the edge the normals, which both turn about it the same way, point apart. Far from rounding.
    if (first.dot(second) < -0x1p-10 * first.norm() * second.norm() &&
        std::min(first.norm(), second.norm()) >
            0x1p-30 * (pair.first[1] - pair.first[0]).norm() * (pair.first[0].cwiseAbs().maxCoeff()))
        return false;
    if (volumeSign(pair.first[0], pair.first[1], pair.first[2], pair.second[2]) != 0)
        return false;
    const int out = axisToLeaveOut(pair.first);
    return sideInPlane(pair.first[0], pair.first[1], pair.first[2], out) ==
           sideInPlane(pair.first[0], pair.first[1], pair.second[2], out);
}

} // namespace

bool segmentMeetsTriangle(const SpacePlace& from, const SpacePlace& to, const SpacePlace& a, const SpacePlace& b,
                          const SpacePlace& c)
{
    return segmentMeets(from, to, {a, b, c});
}

bool facesMeet(std::span<const SpacePlace> positions, const PointTriangle& first, const PointTriangle& second)
{
    const Pair pair = pairOf(positions, first, second);
    if (pair.shared == 2)
        return areFolded(pair);
    if (arePlainlyApart(pair))
        return false;
    const MeetingTriangle& a = pair.first;
    const MeetingTriangle& b = pair.second;
    // What two triangles with a common corner share besides it reaches to a side opposite to that corner.
    if (pair.shared == 1)
        return segmentMeets(a[1], a[2], b) || segmentMeets(b[1], b[2], a);
    for (std::size_t i = 0; i < 3; ++i)
        if (segmentMeets(a[i], a[(i + 1) % 3], b) || segmentMeets(b[i], b[(i + 1) % 3], a))
            return true;
    return false;
}

} // namespace tetra
