// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/tetrahedron_meets.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

using Eigen::Vector3d;

/// Each face, and the corner that it leaves out last.
constexpr std::array<std::array<int, 4>, 4> faces = {{{1, 2, 3, 0}, {0, 2, 3, 1}, {0, 1, 3, 2}, {0, 1, 2, 3}}};
constexpr std::array<std::array<int, 2>, 6> edges = {{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}}};

/// A place is taken for one over a triangle if it is outside by less than this part of it: the distance from its plane
/// is then as good as that from its edge.
constexpr double overTriangle = 1e-9;

double largestCoordinate(const Corners& corners, const Box& box)
{
    double largest = std::max(box.least.cwiseAbs().maxCoeff(), box.largest.cwiseAbs().maxCoeff());
    for (const Vector3d& corner : corners)
        largest = std::max(largest, corner.cwiseAbs().maxCoeff());
    return largest;
}

/// The least and the largest of axis . x in the box.
std::array<double, 2> extentOf(const Box& box, const Vector3d& axis)
{
    const Vector3d some = axis.cwiseProduct(box.least);
    const Vector3d others = axis.cwiseProduct(box.largest);
    return {some.cwiseMin(others).sum(), some.cwiseMax(others).sum()};
}

std::array<double, 2> extentOf(const Corners& corners, const Vector3d& axis)
{
    const auto [least, largest] =
        std::minmax({axis.dot(corners[0]), axis.dot(corners[1]), axis.dot(corners[2]), axis.dot(corners[3])});
    return {least, largest};
}

bool apart(const std::array<double, 2>& one, const std::array<double, 2>& other, double tolerance)
{
    return one[0] > other[1] + tolerance || other[0] > one[1] + tolerance;
}

bool apartAlong(const Vector3d& axis, const Corners& corners, const Box& box, double tolerance)
{
    return apart(extentOf(corners, axis), extentOf(box, axis), tolerance * axis.lpNorm<1>());
}

bool apartAlongBoxAxes(const Corners& corners, const Box& box, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis)
        if (apartAlong(Vector3d::Unit(axis), corners, box, tolerance))
            return true;
    return false;
}

bool apartAlongFaces(const Corners& corners, const Box& box, double tolerance)
{
    for (const auto& [a, b, c, opposite] : faces) {
        const Vector3d normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        if (apartAlong(normal, corners, box, tolerance))
            return true;
    }
    return false;
}

bool apartAlongEdges(const Corners& corners, const Box& box, double tolerance)
{
    for (const auto& [from, to] : edges) {
        const Vector3d edge = corners[to] - corners[from];
        for (const Vector3d& axis :
             {Vector3d(0, -edge.z(), edge.y()), Vector3d(edge.z(), 0, -edge.x()), Vector3d(-edge.y(), edge.x(), 0)})
            if (apartAlong(axis, corners, box, tolerance))
                return true;
    }
    return false;
}

double squaredDistanceFromEdge(const Vector3d& from, const Vector3d& to, const Vector3d& place)
{
    const Vector3d edge = to - from;
    const double squaredLength = edge.squaredNorm();
    const double along = squaredLength > 0 ? std::clamp((place - from).dot(edge) / squaredLength, 0.0, 1.0) : 0;
    return (from + along * edge - place).squaredNorm();
}

/// Whether the place is over the triangle a, b, c of that normal, and not over the plane around it.
bool isOver(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& normal, const Vector3d& place)
{
    const double least = -overTriangle * normal.squaredNorm();
    const auto beyond = [&](const Vector3d& from, const Vector3d& to) {
        return (to - from).cross(place - from).dot(normal) < least;
    };
    return !beyond(a, b) && !beyond(b, c) && !beyond(c, a);
}

} // namespace

bool tetrahedronMeetsBox(const Corners& corners, const Box& box, double tolerance)
{
    const double room = tolerance > 0 ? tolerance * largestCoordinate(corners, box) : 0;
    // Seen from a corner the numbers are small, and differences of nearby floats are exact.
    const Vector3d& origin = corners[0];
    const Corners moved = {Vector3d(0, 0, 0), corners[1] - origin, corners[2] - origin, corners[3] - origin};
    const Box movedBox{box.least - origin, box.largest - origin};
    return !apartAlongBoxAxes(corners, box, room) && !apartAlongFaces(moved, movedBox, room) &&
           !apartAlongEdges(moved, movedBox, room);
}

double squaredDistance(const Corners& corners, const Eigen::Vector3d& place)
{
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, to] : edges) {
        const double fromEdge = squaredDistanceFromEdge(corners[from], corners[to], place);
        if (!(fromEdge >= least)) // also what is not a number, which stays
            least = fromEdge;
    }
    bool within = true;
    for (const auto& [a, b, c, opposite] : faces) {
        const Vector3d normal = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
        const double height = normal.dot(place - corners[a]);
        within &= height * normal.dot(corners[opposite] - corners[a]) > 0;
        // The edges see to triangles that are none.
        if (normal.squaredNorm() > 0 && isOver(corners[a], corners[b], corners[c], normal, place))
            least = std::min(least, height * height / normal.squaredNorm());
    }
    return within ? 0 : least;
}

} // namespace tetra
