// SPDX-License-Identifier: GPL-3.0-or-later
// Of two kernels the checker takes the other one: builders have their own predicates (geometry/orientation.h), here it
// is CGAL's. Compiled with -frounding-math, as scattered_delaunay.cpp is.
#include "core/verify/exact_cell.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace tetra {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

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
    const auto point = [](const Eigen::Vector3d& place) { return Kernel::Point_3(place.x(), place.y(), place.z()); };
    return CGAL::orientation(point(a), point(b), point(c), point(d));
}

} // namespace tetra
