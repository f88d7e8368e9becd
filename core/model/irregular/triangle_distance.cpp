// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/irregular/triangle_distance.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

using SpacePlace = Eigen::Vector3d;

/// How far along the segment, from 0 to 1, its place next to `from` is.
double alongSegment(const SpacePlace& a, const SpacePlace& b, const SpacePlace& from)
{
    const SpacePlace edge = b - a;
    const double length = edge.squaredNorm();
    return length > 0 ? std::clamp(edge.dot(from - a) / length, 0.0, 1.0) : 0;
}

/// Weights of the place where the triangle's plane is next to `from`; negative ones lie outside.
std::array<double, 3> weightsInPlane(const TriangleCorners& t, const SpacePlace& from)
{
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double area = normal.squaredNorm();
    const double second = normal.dot((from - t[0]).cross(t[2] - t[0])) / area;
    const double third = normal.dot((t[1] - t[0]).cross(from - t[0])) / area;
    return {1 - second - third, second, third};
}

SpacePlace at(const TriangleCorners& t, const std::array<double, 3>& weights)
{
    return t[0] + weights[1] * (t[1] - t[0]) + weights[2] * (t[2] - t[0]);
}

bool areInside(const std::array<double, 3>& weights)
{
    return weights[0] >= 0 && weights[1] >= 0 && weights[2] >= 0;
}

/// The values at places that were found to be within the radius.
struct DistanceRange {
    const std::array<double, 3>& values;
    std::optional<std::array<double, 2>> range;

    void add(const std::array<double, 3>& weights)
    {
        const double value = values[0] + weights[1] * (values[1] - values[0]) + weights[2] * (values[2] - values[0]);
        if (!range)
            range = {value, value};
        (*range)[0] = std::min((*range)[0], value);
        (*range)[1] = std::max((*range)[1], value);
    }
};

/// Where an edge goes into and out of the ball, or its ends inside.
void addEdge(const TriangleCorners& t, std::size_t from, const SpacePlace& centre, double radius,
             DistanceRange& extremes)
{
    const std::size_t to = (from + 1) % 3;
    const SpacePlace edge = t[to] - t[from];
    const double length = edge.squaredNorm();
    if (!(length > 0))
        return;
    const double middle = edge.dot(centre - t[from]) / length;
    const double off = (t[from] + middle * edge - centre).squaredNorm();
    const double half = std::sqrt(std::max(0.0, radius * radius - off) / length);
    if (off > radius * radius || middle + half < 0 || middle - half > 1)
        return;
    for (const double along : {std::max(0.0, middle - half), std::min(1.0, middle + half)}) {
        std::array<double, 3> weights{};
        weights[from] = 1 - along;
        weights[to] = along;
        extremes.add(weights);
    }
}

/// Where the function is least and largest on the disc that the ball cuts out of the plane.
void addDisc(const TriangleCorners& t, const std::array<double, 3>& values, const SpacePlace& centre, double radius,
             DistanceRange& extremes)
{
    const std::array<double, 3> foot = weightsInPlane(t, centre);
    const double off = (at(t, foot) - centre).squaredNorm();
    if (!(off <= radius * radius))
        return;
    const SpacePlace normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const SpacePlace gradient =
        ((values[1] - values[0]) * (t[2] - t[0]).cross(normal) + (values[2] - values[0]) * normal.cross(t[1] - t[0])) /
        normal.squaredNorm();
    const double steepness = gradient.norm();
    if (!(steepness > 0)) {
        if (areInside(foot))
            extremes.add(foot);
        return;
    }
    const double reach = std::sqrt(radius * radius - off) / steepness;
    for (const double sign : {-1.0, 1.0}) {
        const auto weights = weightsInPlane(t, at(t, foot) + sign * reach * gradient);
        if (areInside(weights))
            extremes.add(weights);
    }
}

} // namespace

TrianglePlace nearestPlace(const TriangleCorners& t, const SpacePlace& from)
{
    const std::array<double, 3> inPlane = weightsInPlane(t, from);
    if (areInside(inPlane))
        return {inPlane, (at(t, inPlane) - from).norm()};
    TrianglePlace best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < 3; ++i) {
        const double along = alongSegment(t[i], t[(i + 1) % 3], from);
        const double distance = (t[i] + along * (t[(i + 1) % 3] - t[i]) - from).norm();
        if (!(distance < best.distance))
            continue;
        best.weights = {};
        best.weights[i] = 1 - along;
        best.weights[(i + 1) % 3] = along;
        best.distance = distance;
    }
    return best;
}

std::optional<std::array<double, 2>> valuesWithin(const TriangleCorners& triangle, const std::array<double, 3>& values,
                                                  const SpacePlace& centre, double radius)
{
    DistanceRange extremes{values, {}};
    for (std::size_t corner = 0; corner < 3; ++corner)
        addEdge(triangle, corner, centre, radius, extremes);
    addDisc(triangle, values, centre, radius, extremes);
    return extremes.range;
}

} // namespace tetra
