// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/decimate/collapse_star.h"

#include "core/base/simd.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

constexpr std::size_t fanLanes = 8;

/// Adds a column's numbers of eight faces, times the factors.
TETRA_SIMD_INLINE void addTaken(const double* column, const std::uint32_t* faces, const Double8& factors, Double8& sum)
{
    sum += factors * Double8{column[faces[0]], column[faces[1]], column[faces[2]], column[faces[3]],
                             column[faces[4]], column[faces[5]], column[faces[6]], column[faces[7]]};
}

/// From which face each of the places gets its tetrahedron, by its place in the list of faces, to its number, and how
/// far the values are from the apex's.
TETRA_SIMD_INLINE void takeOwners(const StarTetrahedra& tetrahedra, const Double8* from, const Double8& owner,
                                  std::uint32_t* owners, double* steps)
{
    for (std::size_t lane = 0; lane < fanLanes; ++lane)
        owners[lane] = tetrahedra.faces[static_cast<std::size_t>(owner[lane])];
    Double8 step{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        addTaken(tetrahedra.columns.data() + (9 + axis) * tetrahedra.columnLength, owners, from[axis], step);
    std::memcpy(steps, &step, sizeof step);
}

TETRA_SIMD_INLINE void placesFromApex(const StarTetrahedra& tetrahedra, const std::array<const double*, 3>& places,
                                      Double8* from)
{
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::memcpy(&from[axis], places[axis], sizeof from[axis]);
        from[axis] = from[axis] - tetrahedra.apex[axis];
    }
}

/// Goes through all weights of all tetrahedra.
TETRA_SIMD_INLINE void locateThroughout(const StarTetrahedra& tetrahedra, const std::array<const double*, 3>& places,
                                        std::uint32_t* owners, double* steps)
{
    Double8 from[3];
    placesFromApex(tetrahedra, places, from);
    const Double8 x = from[0], y = from[1], z = from[2];
    const std::size_t count = tetrahedra.columnLength;
    Double8 deepest = x * 0 - 1e300;
    Double8 number = x * 0;
    Double8 owner = number;
    for (const std::uint32_t face : tetrahedra.faces) {
        const double* row = tetrahedra.columns.data() + face;
        const Double8 a = row[0] * x + row[count] * y + row[2 * count] * z;
        const Double8 b = row[3 * count] * x + row[4 * count] * y + row[5 * count] * z;
        const Double8 c = row[6 * count] * x + row[7 * count] * y + row[8 * count] * z;
        const Double8 lower = a < b ? a : b;
        const Double8 depth = lower < c ? lower : c;
        owner = depth > deepest ? number : owner;
        deepest = depth > deepest ? depth : deepest;
        number = number + 1;
    }
    takeOwners(tetrahedra, from, owner, owners, steps);
}

#if defined(TETRA_SIMD_16)

/// The weights of one corner of a face's tetrahedron at eight places.
TETRA_SIMD_INLINE TETRA_SIMD_16 Double8 barycentricRow(const double* row, std::size_t count, const Double8* from)
{
    return row[0] * from[0] + row[count] * from[1] + row[2 * count] * from[2];
}

TETRA_SIMD_INLINE TETRA_SIMD_16 bool anyGreater(const Double8& one, const Double8& other)
{
    return _mm512_cmp_pd_mask(reinterpret_cast<const __m512d&>(one), reinterpret_cast<const __m512d&>(other),
                              _CMP_GT_OQ) != 0;
}

/// The same result. Passes over a tetrahedron as soon as a weight says for all places that it is not as deep as
/// `latest`, which they may well lie in.
TETRA_SIMD_16 std::size_t locateBeside(const StarTetrahedra& tetrahedra, std::size_t latest,
                                       const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps)
{
    Double8 from[3];
    placesFromApex(tetrahedra, places, from);
    const std::size_t count = tetrahedra.columnLength;
    const Double8 zero{};
    Double8 deepest = zero + 1e300;
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const double* row = tetrahedra.columns.data() + 3 * corner * count + tetrahedra.faces[latest];
        const Double8 weight = barycentricRow(row, count, from);
        deepest = weight < deepest ? weight : deepest;
    }
    // A little less, so that the search meets it again in its turn.
    constexpr double less = 1e-6;
    deepest = deepest - less * ((deepest < zero ? -deepest : deepest) + 1);
    Double8 owner = zero;
    for (std::size_t i = 0; i < tetrahedra.faces.size(); ++i) {
        const double* row = tetrahedra.columns.data() + tetrahedra.faces[i];
        const Double8 a = barycentricRow(row, count, from);
        if (!anyGreater(a, deepest))
            continue;
        const Double8 b = barycentricRow(row + 3 * count, count, from);
        const Double8 lower = a < b ? a : b;
        if (!anyGreater(lower, deepest))
            continue;
        const Double8 c = barycentricRow(row + 6 * count, count, from);
        const Double8 depth = lower < c ? lower : c;
        owner = depth > deepest ? zero + static_cast<double>(i) : owner;
        deepest = depth > deepest ? depth : deepest;
    }
    takeOwners(tetrahedra, from, owner, owners, steps);
    return static_cast<std::size_t>(owner[fanLanes - 1]);
}

#endif

} // namespace

StarLocator::StarLocator(const StarTetrahedra& tetrahedra, std::size_t placeCount)
    : tetrahedra_(tetrahedra), many_(false)
{
#if defined(TETRA_SIMD_16)
    constexpr std::size_t few = 128; // whose branches are not foreseen
    many_ = simdLevel() == SimdLevel::Sixteen && placeCount > few;
#else
    static_cast<void>(placeCount);
#endif
}

void StarLocator::locateEight(const std::array<const double*, 3>& places, std::uint32_t* owners, double* steps)
{
#if defined(TETRA_SIMD_16)
    if (many_) {
        latest_ = locateBeside(tetrahedra_, latest_, places, owners, steps);
        return;
    }
#endif
    dispatch<locateThroughout>(tetrahedra_, places, owners, steps);
}

namespace {

constexpr std::size_t apexLanes = StarPoints::lanes;
using FanVector = std::array<double, 3>;

double dot(const FanVector& a, const FanVector& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The rows of the inverses of the matrices whose columns are the corners from the apex, and the gradients of the
/// values.
TETRA_SIMD_INLINE void computeColumns(const double* corners, const double* values, std::size_t count,
                                      const double* apex, double apexValue, double* columns)
{
    for (std::size_t first = 0; first < count; first += apexLanes) {
        Double8 from[3][3], rows[3][3];
        for (std::size_t corner = 0; corner < 3; ++corner)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                Double8 coordinate;
                std::memcpy(&coordinate, corners + (3 * corner + axis) * count + first, sizeof coordinate);
                from[corner][axis] = coordinate - apex[axis];
            }
        for (std::size_t row = 0; row < 3; ++row) {
            const Double8* u = from[(row + 1) % 3];
            const Double8* v = from[(row + 2) % 3];
            rows[row][0] = u[1] * v[2] - u[2] * v[1];
            rows[row][1] = u[2] * v[0] - u[0] * v[2];
            rows[row][2] = u[0] * v[1] - u[1] * v[0];
        }
        const Double8 scale = 1 / (from[0][0] * rows[0][0] + from[0][1] * rows[0][1] + from[0][2] * rows[0][2]);
        Double8 gradient[3] = {};
        for (std::size_t row = 0; row < 3; ++row) {
            Double8 value;
            std::memcpy(&value, values + row * count + first, sizeof value);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Double8 weight = scale * rows[row][axis];
                gradient[axis] += weight * (value - apexValue);
                std::memcpy(columns + (3 * row + axis) * count + first, &weight, sizeof weight);
            }
        }
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::memcpy(columns + (9 + axis) * count + first, gradient + axis, sizeof gradient[axis]);
    }
}

/// For each lane the deepest of every eighth tetrahedron around a place, by its smallest weight, and its face. Faces
/// without a tetrahedron, whose weights are no numbers, never are.
TETRA_SIMD_INLINE void findDeepest(const double* columns, std::size_t count, const double* place, double tolerance,
                                   double* depths, double* owners)
{
    Double8 deepest = Double8{} - tolerance, owner = Double8{} - 1;
    Double8 number = {0, 1, 2, 3, 4, 5, 6, 7};
    for (std::size_t first = 0; first < count; first += apexLanes) {
        Double8 weights[3];
        for (std::size_t row = 0; row < 3; ++row) {
            Double8 factors[3];
            for (std::size_t axis = 0; axis < 3; ++axis)
                std::memcpy(&factors[axis], columns + (3 * row + axis) * count + first, sizeof factors[axis]);
            weights[row] = factors[0] * place[0] + factors[1] * place[1] + factors[2] * place[2];
        }
        const Double8 ofApex = 1 - weights[0] - weights[1] - weights[2];
        // Whatever compares with what is no number gives that in the end: that of the apex never is a number then.
        Double8 least = weights[0] < weights[1] ? weights[0] : weights[1];
        least = weights[2] < least ? weights[2] : least;
        least = least < ofApex ? least : ofApex;
        owner = least > deepest ? number : owner;
        deepest = least > deepest ? least : deepest;
        number = number + 8;
    }
    std::memcpy(depths, &deepest, sizeof deepest);
    std::memcpy(owners, &owner, sizeof owner);
}

double withoutRounding(double measured, double least)
{
    return measured > least ? measured : 0;
}

StarTetrahedra tetrahedraOf(const CollapseStar& fan)
{
    return {fan.columns(), fan.columnLength(), fan.faces(), fan.apex()};
}

} // namespace

void LinkSamples::set(const VertexStar& star, std::span<const Eigen::Vector3d> physical)
{
    physical_ = !physical.empty();
    columnLength_ = star.paddedFaceCount();
    ofLink_.clear();
    for (std::uint32_t place = 0; place < star.link().size(); ++place) {
        ofLink_.push_back(star.value(place));
        if (physical_) {
            const Eigen::Vector3d& at = physical[star.link()[place]];
            ofLink_.insert(ofLink_.end(), at.begin(), at.end());
        }
    }
    ofCorners_.resize(3 * numberCount() * columnLength_);
    for (std::size_t face = 0; face < star.faces().size(); ++face)
        for (std::size_t number = 0; number < numberCount(); ++number)
            for (std::size_t corner = 0; corner < 3; ++corner)
                ofCorners_[(3 * number + corner) * columnLength_ + face] = at(star.faces()[face][corner], number);
}

void CollapseStar::set(const VertexStar& star, std::uint32_t linkPlace, const LinkSamples& samples)
{
    samples_ = &samples;
    apex_ = star.place(linkPlace);
    for (std::size_t number = 0; number < (physical() ? 4 : 1); ++number)
        apexSamples_[number] = samples.at(linkPlace, number);
    compute(star);
    faces_.resize(star.faces().size());
    std::size_t count = 0;
    for (std::uint32_t face = 0; face < star.faces().size(); ++face) {
        faces_[count] = face;
        count += star.holds(face, linkPlace) ? 0 : 1;
    }
    faces_.resize(count);
}

void CollapseStar::setStar(const VertexStar& star, double value, const LinkSamples& samples)
{
    samples_ = &samples;
    apex_ = {};
    apexSamples_ = {value};
    compute(star);
    faces_.resize(star.faces().size());
    std::iota(faces_.begin(), faces_.end(), 0U);
}

void CollapseStar::compute(const VertexStar& star)
{
    columnLength_ = star.paddedFaceCount();
    columns_.resize(12 * columnLength_);
    dispatch<computeColumns>(star.corners().data(), samples_->ofCorners(0).data(), columnLength_, apex_.data(),
                             apexValue(), columns_.data());
}

std::array<double, 3> CollapseStar::weightsAt(std::size_t face, const FanVector& place) const
{
    const double* column = columns_.data() + face;
    const std::size_t n = columnLength_;
    return {column[0] * place[0] + column[n] * place[1] + column[2 * n] * place[2],
            column[3 * n] * place[0] + column[4 * n] * place[1] + column[5 * n] * place[2],
            column[6 * n] * place[0] + column[7 * n] * place[1] + column[8 * n] * place[2]};
}

double CollapseStar::interpolated(std::size_t face, std::size_t number, const std::array<double, 3>& weights) const
{
    const double apex = apexSamples_[number];
    const double* column = samples_->ofCorners(number).data() + face;
    double value = apex;
    for (std::size_t corner = 0; corner < 3; ++corner)
        value += weights[corner] * (column[corner * columnLength_] - apex);
    return value;
}

std::uint32_t faceAt(const CollapseStar& fan, const FanVector& place, double tolerance)
{
    double depths[apexLanes], owners[apexLanes];
    dispatch<findDeepest>(fan.columns().data(), fan.columnLength(), place.data(), tolerance, depths, owners);
    const auto deepest = static_cast<std::size_t>(std::ranges::max_element(depths) - depths);
    return owners[deepest] < 0 ? 0xffffffff : static_cast<std::uint32_t>(owners[deepest]);
}

double evaluateFan(const CollapseStar& fan, const CollapseMeasure& measure, double bound, StarPoints& points)
{
    double largest = 0;
    StarLocator location(tetrahedraOf(fan), points.count());
    double steps[apexLanes];
    for (std::size_t first = 0; first < points.count() && largest <= bound; first += apexLanes) {
        location.locateEight(
            {points.place[0].data() + first, points.place[1].data() + first, points.place[2].data() + first},
            points.owner.data() + first, steps);
        // What is beyond the last point is a copy of the first.
        for (std::size_t lane = 0; lane < apexLanes; ++lane) {
            const std::size_t point = first + lane;
            const double weight = points.weight.empty() ? 1 : points.weight[point];
            const double residual = points.value[point] - fan.apexValue() - steps[lane];
            points.error[point] = weight * withoutRounding(std::abs(residual), measure.leastError);
            largest = std::max(largest, points.error[point]);
        }
        if (!fan.physical())
            continue;
        for (std::size_t lane = 0; lane < apexLanes; ++lane) {
            const std::size_t point = first + lane, owner = points.owner[point];
            FanVector from{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                from[axis] = points.place[axis][point] - fan.apex()[axis];
            const FanVector weights = fan.weightsAt(owner, from);
            FanVector away{};
            for (std::size_t axis = 0; axis < 3; ++axis)
                away[axis] = points.physical[axis][point] - fan.interpolated(owner, axis + 1, weights);
            const double weight = points.weight.empty() ? 1 : points.weight[point];
            points.warping[point] = weight * withoutRounding(std::sqrt(dot(away, away)), measure.leastWarping);
            largest = std::max(largest, measure.warpingWeight * points.warping[point]);
        }
    }
    return largest;
}

void vertexErrors(const VertexStar& star, const CollapseStar& fan, const CollapseMeasure& measure,
                  const LinkSamples& samples, std::span<const std::uint32_t> linkPlaces, std::vector<double>& errors)
{
    errors.clear();
    StarLocator location(tetrahedraOf(fan), linkPlaces.size());
    double places[3][apexLanes], steps[apexLanes];
    std::uint32_t owners[apexLanes];
    for (std::size_t first = 0; first < linkPlaces.size(); first += apexLanes) {
        const std::size_t count = std::min(apexLanes, linkPlaces.size() - first);
        for (std::size_t lane = 0; lane < apexLanes; ++lane)
            for (std::size_t axis = 0; axis < 3; ++axis)
                places[axis][lane] = -star.place(linkPlaces[first + (lane < count ? lane : 0)])[axis];
        location.locateEight({places[0], places[1], places[2]}, owners, steps);
        for (std::size_t lane = 0; lane < count; ++lane) {
            // Opposite to the target the corners have these weights, so the vertex is the mean of all with its own, 1.
            const auto [a, b, c] = fan.weightsAt(owners[lane], {places[0][lane], places[1][lane], places[2][lane]});
            const double step = samples.at(linkPlaces[first + lane], 0) - fan.apexValue() + steps[lane];
            errors.push_back(withoutRounding(std::abs(step / (1 + a + b + c)), measure.leastError));
        }
    }
}

} // namespace tetra
