// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/apex_fan.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace tetra {

namespace {

constexpr std::size_t lanes = StarPoints::lanes;
using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector combined(const ApexFan::Weights& weights, const Vector& steps)
{
    Vector gradient{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        gradient[axis] = weights[0][axis] * steps[0] + weights[1][axis] * steps[1] + weights[2][axis] * steps[2];
    return gradient;
}

/// Which tetrahedron has each of eight places: the one whose smallest weight is largest, so that rounding leaves no
/// place without one.
TETRA_SIMD_CLONES void locateEight(const ApexFan::Weights* weights, std::size_t count, const double* from,
                                   double* owners)
{
    Double8 x, y, z;
    std::memcpy(&x, from, sizeof x);
    std::memcpy(&y, from + lanes, sizeof y);
    std::memcpy(&z, from + 2 * lanes, sizeof z);
    Double8 deepest = x * 0 - 1e300;
    Double8 owner = x * 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto& [a, b, c] = weights[i];
        const Double8 first = a[0] * x + a[1] * y + a[2] * z;
        const Double8 second = b[0] * x + b[1] * y + b[2] * z;
        const Double8 third = c[0] * x + c[1] * y + c[2] * z;
        const Double8 lower = first < second ? first : second;
        const Double8 depth = lower < third ? lower : third;
        owner = depth > deepest ? Double8{} + static_cast<double>(i) : owner;
        deepest = depth > deepest ? depth : deepest;
    }
    std::memcpy(owners, &owner, sizeof owner);
}

double withoutRounding(double measured, double least)
{
    return measured > least ? measured : 0;
}

} // namespace

void ApexFan::clear()
{
    weights.clear();
    gradients.clear();
    liftedGradients.clear();
}

void ApexFan::add(const std::array<Vector, 3>& corners, const Vector& steps)
{
    const auto& [a, b, c] = corners;
    Weights rows{cross(b, c), cross(c, a), cross(a, b)};
    const double scale = 1 / dot(a, rows[0]);
    for (Vector& row : rows)
        for (double& component : row)
            component *= scale;
    weights.push_back(rows);
    gradients.push_back(combined(rows, steps));
}

void ApexFan::addLifted(const std::array<Vector, 3>& liftedCorners)
{
    Weights& rows = liftedGradients.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
        rows[axis] = combined(weights.back(), {liftedCorners[0][axis], liftedCorners[1][axis], liftedCorners[2][axis]});
}

double evaluateFan(const ApexFan& fan, const FanMeasure& measure, double bound, StarPoints& points)
{
    double largest = 0;
    double from[3 * lanes];
    double owners[lanes];
    for (std::size_t first = 0; first < points.count() && largest <= bound; first += lanes) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                from[axis * lanes + lane] = points.place[axis][first + lane] - fan.apex[axis];
        locateEight(fan.weights.data(), fan.weights.size(), from, owners);
        const std::size_t end = std::min(points.count() - first, lanes);
        for (std::size_t lane = 0; lane < end; ++lane) {
            const std::size_t point = first + lane;
            const auto owner = static_cast<std::size_t>(owners[lane]);
            const Vector place{from[lane], from[lanes + lane], from[2 * lanes + lane]};
            points.owner[point] = static_cast<std::uint32_t>(owner);
            const double weight = points.weight.empty() ? 1 : points.weight[point];
            const double residual = points.value[point] - fan.apexValue - dot(fan.gradients[owner], place);
            points.error[point] = weight * withoutRounding(std::abs(residual), measure.leastError);
            largest = std::max(largest, points.error[point]);
            if (fan.liftedGradients.empty())
                continue;
            Vector away{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                away[axis] =
                    points.lifted[axis][point] - fan.lifted[axis] - dot(fan.liftedGradients[owner][axis], place);
            points.warping[point] = weight * withoutRounding(std::sqrt(dot(away, away)), measure.leastWarping);
            largest = std::max(largest, measure.warpingWeight * points.warping[point]);
        }
    }
    return largest;
}

} // namespace tetra
