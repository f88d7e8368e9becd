// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/query.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace tetra {

inline Eigen::Vector3d nearestInRegion(const Region& region, const Eigen::Vector3d& place)
{
    if (const Box* box = std::get_if<Box>(&region))
        return place.cwiseMax(box->least).cwiseMin(box->largest);
    if (const Sphere* sphere = std::get_if<Sphere>(&region)) {
        const Eigen::Vector3d away = place - sphere->centre;
        return away.norm() <= sphere->radius ? place
                                             : Eigen::Vector3d(sphere->centre + away * (sphere->radius / away.norm()));
    }
    const HalfSpace& half = std::get<HalfSpace>(region);
    return place - distanceTo(region, place) * half.normal;
}

/// The nearest of the points that are nearest in the planes, lines and corners through its corners and lie in it.
inline Eigen::Vector3d nearestInTetrahedron(const std::array<Eigen::Vector3d, 4>& corners, const Eigen::Vector3d& place)
{
    double least = std::numeric_limits<double>::infinity();
    Eigen::Vector3d nearest = corners[0];
    for (unsigned subset = 1; subset < 16; ++subset) {
        std::vector<Eigen::Vector3d> used;
        for (int corner = 0; corner < 4; ++corner)
            if ((subset >> corner & 1u) != 0)
                used.push_back(corners[corner]);
        Eigen::MatrixXd edges(3, static_cast<Eigen::Index>(used.size()) - 1);
        for (std::size_t i = 1; i < used.size(); ++i)
            edges.col(static_cast<Eigen::Index>(i) - 1) = used[i] - used[0];
        Eigen::Vector3d found = used[0];
        if (used.size() > 1) {
            const Eigen::VectorXd parts =
                Eigen::MatrixXd(edges.transpose() * edges).fullPivLu().solve(edges.transpose() * (place - used[0]));
            if (parts.minCoeff() < 0 || parts.sum() > 1)
                continue;
            found += edges * parts;
        }
        if ((found - place).norm() < least) {
            least = (found - place).norm();
            nearest = found;
        }
    }
    return nearest;
}

/// Whether a tetrahedron and a region have a common point: alternating projections find one, or a plane between the
/// two, or neither, if they all but touch.
inline std::optional<bool> whetherTheyMeet(const Region& region, const std::array<Eigen::Vector3d, 4>& corners)
{
    Eigen::Vector3d place = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    for (int step = 0; step < 1000; ++step) {
        const Eigen::Vector3d inRegion = nearestInRegion(region, place);
        if ((place - inRegion).norm() < 1e-9)
            return true;
        place = nearestInTetrahedron(corners, inRegion);
        // The region lies behind the plane through its nearest point, seen from where that is nearest to.
        const Eigen::Vector3d border = nearestInRegion(region, place);
        const Eigen::Vector3d outwards = place - border;
        double least = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector3d& corner : corners)
            least = std::min(least, outwards.dot(corner - border));
        if (least > 1e-9 * outwards.norm())
            return false;
    }
    return {};
}

} // namespace tetra
