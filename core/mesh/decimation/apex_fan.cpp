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

double dot(const Vector& a, const Vector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The rows of the inverses of the matrices whose columns are the corners from the apex.
TETRA_SIMD_CLONES void computeWeights(const double* corners, std::size_t count, const double* apex, double* weights)
{
    for (std::size_t first = 0; first < count; first += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t face = first + lane;
            double from[3][3];
            for (std::size_t corner = 0; corner < 3; ++corner)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    from[corner][axis] = corners[(3 * corner + axis) * count + face] - apex[axis];
            double rows[3][3];
            for (std::size_t row = 0; row < 3; ++row) {
                const double* u = from[(row + 1) % 3];
                const double* v = from[(row + 2) % 3];
                rows[row][0] = u[1] * v[2] - u[2] * v[1];
                rows[row][1] = u[2] * v[0] - u[0] * v[2];
                rows[row][2] = u[0] * v[1] - u[1] * v[0];
            }
            const double scale = 1 / (from[0][0] * rows[0][0] + from[0][1] * rows[0][1] + from[0][2] * rows[0][2]);
            for (std::size_t row = 0; row < 3; ++row)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    weights[(3 * row + axis) * count + face] = scale * rows[row][axis];
        }
}

/// Which face's tetrahedron has each of eight places: the one whose smallest weight is largest, so that rounding leaves
/// no place without one.
TETRA_SIMD_CLONES void locateEight(const double* weights, std::size_t count, const std::uint32_t* faces,
                                   std::size_t faceCount, const double* from, double* owners)
{
    Double8 x, y, z;
    std::memcpy(&x, from, sizeof x);
    std::memcpy(&y, from + lanes, sizeof y);
    std::memcpy(&z, from + 2 * lanes, sizeof z);
    Double8 deepest = x * 0 - 1e300;
    Double8 owner = x * 0;
    for (std::size_t i = 0; i < faceCount; ++i) {
        const double* row = weights + faces[i];
        const Double8 a = row[0] * x + row[count] * y + row[2 * count] * z;
        const Double8 b = row[3 * count] * x + row[4 * count] * y + row[5 * count] * z;
        const Double8 c = row[6 * count] * x + row[7 * count] * y + row[8 * count] * z;
        const Double8 lower = a < b ? a : b;
        const Double8 depth = lower < c ? lower : c;
        owner = depth > deepest ? Double8{} + static_cast<double>(faces[i]) : owner;
        deepest = depth > deepest ? depth : deepest;
    }
    std::memcpy(owners, &owner, sizeof owner);
}

double withoutRounding(double measured, double least)
{
    return measured > least ? measured : 0;
}

} // namespace

void ApexFan::set(const VertexStar& star, std::uint32_t linkPlace, std::span<const Samples> samples, bool lifted)
{
    apex_ = star.place(linkPlace);
    apexSamples_ = samples[linkPlace];
    lifted_ = lifted;
    columnLength_ = star.paddedFaceCount();
    weights_.resize(9 * columnLength_);
    computeWeights(star.corners().data(), columnLength_, apex_.data(), weights_.data());
    const std::size_t sampleCount = lifted ? 4 : 1;
    gradients_.resize(3 * sampleCount * columnLength_);
    faces_.clear();
    for (std::uint32_t face = 0; face < star.faces().size(); ++face) {
        if (star.holds(face, linkPlace))
            continue;
        faces_.push_back(face);
        for (std::size_t number = 0; number < sampleCount; ++number) {
            Vector steps{};
            for (std::size_t corner = 0; corner < 3; ++corner)
                steps[corner] = samples[star.faces()[face][corner]][number] - apexSamples_[number];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double* column = weights_.data() + axis * columnLength_ + face;
                gradients_[(face * sampleCount + number) * 3 + axis] =
                    column[0] * steps[0] + column[3 * columnLength_] * steps[1] + column[6 * columnLength_] * steps[2];
            }
        }
    }
}

std::array<double, 3> ApexFan::weightsAt(std::size_t face, const Vector& place) const
{
    const double* column = weights_.data() + face;
    const std::size_t n = columnLength_;
    return {column[0] * place[0] + column[n] * place[1] + column[2 * n] * place[2],
            column[3 * n] * place[0] + column[4 * n] * place[1] + column[5 * n] * place[2],
            column[6 * n] * place[0] + column[7 * n] * place[1] + column[8 * n] * place[2]};
}

std::array<double, 3> ApexFan::gradient(std::size_t face, std::size_t number) const
{
    const double* three = gradients_.data() + (face * (lifted_ ? 4 : 1) + number) * 3;
    return {three[0], three[1], three[2]};
}

double evaluateFan(const ApexFan& fan, const FanMeasure& measure, double bound, StarPoints& points)
{
    double largest = 0;
    double from[3 * lanes];
    double owners[lanes];
    for (std::size_t first = 0; first < points.count() && largest <= bound; first += lanes) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                from[axis * lanes + lane] = points.place[axis][first + lane] - fan.apex()[axis];
        locateEight(fan.weights().data(), fan.columnLength(), fan.faces().data(), fan.faces().size(), from, owners);
        const std::size_t end = std::min(points.count() - first, lanes);
        for (std::size_t lane = 0; lane < end; ++lane) {
            const std::size_t point = first + lane;
            const auto owner = static_cast<std::size_t>(owners[lane]);
            const Vector place{from[lane], from[lanes + lane], from[2 * lanes + lane]};
            points.owner[point] = static_cast<std::uint32_t>(owner);
            const double weight = points.weight.empty() ? 1 : points.weight[point];
            const double residual = points.value[point] - fan.apexSamples()[0] - dot(fan.gradient(owner, 0), place);
            points.error[point] = weight * withoutRounding(std::abs(residual), measure.leastError);
            largest = std::max(largest, points.error[point]);
            if (!fan.lifted())
                continue;
            Vector away{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                away[axis] = points.lifted[axis][point] - fan.apexSamples()[axis + 1] -
                             dot(fan.gradient(owner, axis + 1), place);
            points.warping[point] = weight * withoutRounding(std::sqrt(dot(away, away)), measure.leastWarping);
            largest = std::max(largest, measure.warpingWeight * points.warping[point]);
        }
    }
    return largest;
}

} // namespace tetra
