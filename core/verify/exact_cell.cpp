// SPDX-License-Identifier: GPL-3.0-or-later
// Of two kernels the checker takes the other one: builders have their own predicates (geometry/orientation.h), here it
// is CGAL's. Compiled with -frounding-math, as scattered_delaunay.cpp is. Where the option TAN_CGAL is off there is one
// kernel only, as exact.
#include "core/verify/exact_cell.h"

#if defined(TAN_CGAL)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#else
#include "core/geometry/orientation.h"
#endif

#include <algorithm>
#include <charconv>

namespace tetra {

namespace {

#if defined(TAN_CGAL)
int signByKernel(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto point = [](const Eigen::Vector3d& place) { return Kernel::Point_3(place.x(), place.y(), place.z()); };
    return CGAL::orientation(point(a), point(b), point(c), point(d));
}
#else
int signByKernel(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
    return orientation(a, b, c, d);
}
#endif

/// Whether two of the points are one, or all lie in one plane along the axes: most flat cells are of this kind, and
/// filters cannot decide them.
bool isPlainlyFlat(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                   const Eigen::Vector3d& d)
{
    for (int axis = 0; axis < 3; ++axis)
        if (a[axis] == b[axis] && a[axis] == c[axis] && a[axis] == d[axis])
            return true;
    return a == b || a == c || a == d || b == c || b == d || c == d;
}

} // namespace

int volumeSign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, const Eigen::Vector3d& d)
{
    if (isPlainlyFlat(a, b, c, d))
        return 0;
    return signByKernel(a, b, c, d);
}

int volumeSign(const PlacedCell& cell)
{
    return volumeSign(cell[0], cell[1], cell[2], cell[3]);
}

namespace {

/// Signs of the volumes of the place with each face; all are positive inside a positive cell.
std::array<int, 4> signsAt(const PlacedCell& c, const Eigen::Vector3d& place)
{
    return {volumeSign(place, c[1], c[2], c[3]), volumeSign(c[0], place, c[2], c[3]),
            volumeSign(c[0], c[1], place, c[3]), volumeSign(c[0], c[1], c[2], place)};
}

} // namespace

bool holds(const PlacedCell& cell, const Eigen::Vector3d& place)
{
    return std::ranges::all_of(signsAt(cell, place), [](int sign) { return sign >= 0; });
}

bool holdsInside(const PlacedCell& cell, const Eigen::Vector3d& place)
{
    return std::ranges::all_of(signsAt(cell, place), [](int sign) { return sign > 0; });
}

std::string textOf(double number)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, number, std::chars_format::general, 6).ptr};
}

std::string textOf(const LatticePoint& point)
{
    return "(" + std::to_string(point[0]) + ", " + std::to_string(point[1]) + ", " + std::to_string(point[2]) + ")";
}

std::string textOf(const Eigen::Vector3d& place)
{
    return "(" + textOf(place[0]) + ", " + textOf(place[1]) + ", " + textOf(place[2]) + ")";
}

} // namespace tetra
