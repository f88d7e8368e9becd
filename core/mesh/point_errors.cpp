// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/point_errors.h"

#include "core/mesh/rounding.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {

namespace {

/// One tetrahedron of the star with the values of its vertices.
struct ValuedFace {
    const Star::Face& geometry;
    std::array<PackedPoint, 4> vertices; ///< apex, a, b, c
    std::array<double, 4> values;
};

/// The error of a point at (x, y, z) from the apex, which depends only on the vertices of non-zero weight and on the
/// weights as reduced fractions, summed in the lattice's order: on a face of the tetrahedron, not on its fourth vertex.
double independentError(const ValuedFace& face, double value, double x, double y, double z)
{
    const auto weight = [&](const std::array<double, 4>& normal) {
        return static_cast<std::int64_t>(normal[0] * x + normal[1] * y + normal[2] * z);
    };
    const auto determinant = static_cast<std::int64_t>(face.geometry.determinant());
    std::array<std::int64_t, 4> weights{0, weight(face.geometry.normalBC), weight(face.geometry.normalCA),
                                        weight(face.geometry.normalAB)};
    weights[0] = determinant - weights[1] - weights[2] - weights[3];
    std::int64_t divisor = determinant;
    for (const std::int64_t one : weights)
        divisor = std::gcd(divisor, one);
    std::array<std::size_t, 4> order{0, 1, 2, 3};
    std::ranges::sort(order, {}, [&](std::size_t i) { return face.vertices[i]; });
    double sum = 0;
    for (const std::size_t i : order)
        if (weights[i] != 0)
            sum += static_cast<double>(weights[i] / divisor) * (value - face.values[i]);
    return std::abs(sum) / static_cast<double>(determinant / divisor);
}

/// |value - interpolation| * determinant, an exact integer for integer samples of up to 16 bits.
void computeNumerators(const ValuedFace& face, const PlacedPoints& placed, std::size_t first, std::size_t last,
                       const double* values, double* numerators)
{
    const Star::Face& geometry = face.geometry;
    const double apexValue = face.values[0];
    const double a = face.values[1] - apexValue;
    const double b = face.values[2] - apexValue;
    const double c = face.values[3] - apexValue;
    const double slopeX = a * geometry.normalBC[0] + b * geometry.normalCA[0] + c * geometry.normalAB[0];
    const double slopeY = a * geometry.normalBC[1] + b * geometry.normalCA[1] + c * geometry.normalAB[1];
    const double slopeZ = a * geometry.normalBC[2] + b * geometry.normalCA[2] + c * geometry.normalAB[2];
    for (std::size_t k = first; k < last; ++k)
        numerators[k] = std::abs(geometry.determinant() * (values[k] - apexValue) - slopeX * placed.x[k] -
                                 slopeY * placed.y[k] - slopeZ * placed.z[k]);
}

bool onBoundary(const PackedLattice& lattice, PackedPoint point)
{
    const auto& size = lattice.size();
    const auto outermost = [](std::int32_t coordinate, std::uint32_t count) {
        return coordinate == 0 || static_cast<std::uint32_t>(coordinate) == count - 1;
    };
    return outermost(lattice.x(point), size[0]) || outermost(lattice.y(point), size[1]) ||
           outermost(lattice.z(point), size[2]);
}

} // namespace

void computeErrors(const PackedLattice& lattice, const LatticeSamples& samples, const Star& star,
                   const PlacedPoints& placed, PointErrorRoom& room, std::span<double> scaledErrors,
                   std::span<double> divisors)
{
    const std::span<const PackedPoint> rim = star.rim();
    const PackedPoint apex = star.apex();
    double apexValue = 0;
    samples.gather(lattice, {&apex, 1}, &apexValue);
    room.rimValues.resize(rim.size());
    samples.gather(lattice, rim, room.rimValues.data());
    room.values.resize(placed.points.size());
    samples.gather(lattice, placed.points, room.values.data());

    // What is not exact, or multiplied by weights, must be divided first to be independent of the tetrahedron.
    const bool exact = samples.exact();
    const bool divided = !exact || samples.weighted();
    for (std::size_t i = 0; i < star.faceCount(); ++i) {
        const std::size_t first = placed.offsets[i], last = placed.offsets[i + 1];
        const double determinant = star.faces()[i].determinant();
        divisors[i] = divided ? 1 : determinant;
        if (first == last)
            continue;
        const std::array<std::uint32_t, 3>& corners = star.corners()[i];
        const ValuedFace face{
            star.faces()[i],
            {apex, rim[corners[0]], rim[corners[1]], rim[corners[2]]},
            {apexValue, room.rimValues[corners[0]], room.rimValues[corners[1]], room.rimValues[corners[2]]}};
        computeNumerators(face, placed, first, last, room.values.data(), scaledErrors.data());
        if (!divided)
            continue;
        for (std::size_t k = first; k < last; ++k)
            scaledErrors[k] = exact || !onBoundary(lattice, placed.points[k])
                                  ? scaledErrors[k] / determinant
                                  : independentError(face, room.values[k], placed.x[k], placed.y[k], placed.z[k]);
    }
    if (samples.weighted())
        for (std::size_t k = 0; k < placed.points.size(); ++k)
            scaledErrors[k] *= samples.weight(lattice, placed.points[k]);
}

PlacedError worstError(std::span<const PackedPoint> points, std::span<const double> scaledErrors, double divisor)
{
    double largest = 0;
    for (const double error : scaledErrors)
        largest = std::max(largest, error);
    PlacedError worst{0xffffffff, roundedUp(largest / divisor)};
    // What is smaller by more than half a float's precision cannot be rounded to the same.
    const double nearly = largest * (1 - 0x1p-22);
    for (std::size_t i = 0; i < points.size(); ++i)
        if (scaledErrors[i] >= nearly && points[i] < worst.point && roundedUp(scaledErrors[i] / divisor) == worst.error)
            worst.point = points[i];
    return worst;
}

} // namespace tetra
