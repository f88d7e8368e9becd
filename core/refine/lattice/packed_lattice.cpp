// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/lattice/packed_lattice.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

namespace tetra {

namespace {

TETRA_SIMD_INLINE void findIndices(const PackedLattice& lattice, std::span<const PackedPoint> points,
                                   std::uint32_t* indices)
{
    const PackedLattice local = lattice;
    const int sizeX = static_cast<int>(local.size()[0]), sizeY = static_cast<int>(local.size()[1]);
    std::size_t i = 0;
    for (; i + 8 <= points.size(); i += 8) {
        Int8 packed, x, y, z;
        std::memcpy(&packed, points.data() + i, sizeof packed);
        local.unpack(packed, x, y, z);
        const Int8 index = (z * sizeY + y) * sizeX + x;
        std::memcpy(indices + i, &index, sizeof index);
    }
    for (; i < points.size(); ++i)
        indices[i] = local.index(points[i]);
}

} // namespace

void latticeIndices(const PackedLattice& lattice, std::span<const PackedPoint> points, std::uint32_t* indices)
{
    dispatch<findIndices>(lattice, points, indices);
}

namespace {

/// A bound on every partial sum of D |q|^2 - c . q: a determinant is at most twice the box, c . q at most 18 times the
/// box times |q|^2.
double largestInSphereTerm(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric)
{
    double box = 1;
    double diagonal = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double extent = size[axis] - 1.0;
        box *= extent;
        diagonal += metric[axis] * extent * extent;
    }
    return 20 * box * diagonal;
}

constexpr double exactInDouble = 9007199254740992.0; // 2^53

} // namespace

bool exactWithMetric(const std::array<std::uint32_t, 3>& size, const LatticeMetric& metric)
{
    return largestInSphereTerm(size, metric) < exactInDouble;
}

Result<LatticeMetric> latticeMetric(const std::array<std::uint32_t, 3>& size, const Eigen::Vector3d& spacing)
{
    if (!exactWithMetric(size, {1, 1, 1}))
        return Error{ErrorKind::OutOfResource,
                     Message::say("A lattice of %1 x %2 x %3 points is too large to be refined as a whole with exact "
                                  "arithmetic (512 x 512 x 512 is about the limit). Crop or subsample it.",
                                  size[0], size[1], size[2])};
    // Scaled by a power of two, which rounds nothing, lest the squares of tiny or huge lengths are 0 or infinite.
    int exponent = 0;
    static_cast<void>(std::frexp(spacing.minCoeff(), &exponent));
    const Eigen::Vector3d lengths = spacing.unaryExpr([&](double length) { return std::ldexp(length, -exponent); });
    const Eigen::Vector3d squares = lengths.cwiseProduct(lengths) / lengths.cwiseProduct(lengths).minCoeff();
    LatticeMetric best{1, 1, 1};
    double bestDeviation = std::numeric_limits<double>::infinity();
    for (std::uint32_t unit = 1; unit <= 4096; ++unit) {
        LatticeMetric metric{};
        double deviation = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double exact = squares[axis] * unit;
            if (exact > 1e9)
                return best;
            metric[axis] = static_cast<std::uint32_t>(std::lround(exact));
            deviation = std::max(deviation, std::abs(metric[axis] / exact - 1));
        }
        if (!exactWithMetric(size, metric))
            break;
        if (deviation < bestDeviation * 0.999) {
            best = metric;
            bestDeviation = deviation;
        }
        if (deviation < 1e-9)
            break;
    }
    return best;
}

} // namespace tetra
