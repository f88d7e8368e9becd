// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refine/insertion/sample_scan.h"

#include "core/base/simd.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#if defined(TETRA_SIMD_16)
#include <immintrin.h>
#endif

namespace tetra {

namespace {

/// One tetrahedron, with the planes of its faces and of its field; coordinates are relative to its first vertex.
struct ScanPlanes {
    std::array<double, 4> slopeX, slopeY, slopeZ, constant; ///< six volumes towards each face, at a point
    double fieldX, fieldY, fieldZ;                          ///< slopes of the field, times the determinant
    double determinant;
    double value; ///< at the first vertex
};

using ScanOffset = std::array<double, 3>;

TETRA_SIMD_INLINE ScanOffset scanCross(const ScanOffset& a, const ScanOffset& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

TETRA_SIMD_INLINE ScanPlanes scanPlanesOf(const std::array<ScanOffset, 3>& edges, const std::array<double, 4>& values,
                                          double determinant)
{
    const ScanOffset bc = scanCross(edges[1], edges[2]), ca = scanCross(edges[2], edges[0]),
                     ab = scanCross(edges[0], edges[1]);
    ScanPlanes planes{};
    planes.slopeX = {-bc[0] - ca[0] - ab[0], bc[0], ca[0], ab[0]};
    planes.slopeY = {-bc[1] - ca[1] - ab[1], bc[1], ca[1], ab[1]};
    planes.slopeZ = {-bc[2] - ca[2] - ab[2], bc[2], ca[2], ab[2]};
    planes.constant = {determinant, 0, 0, 0};
    const double a = values[1] - values[0], b = values[2] - values[0], c = values[3] - values[0];
    planes.fieldX = a * bc[0] + b * ca[0] + c * ab[0];
    planes.fieldY = a * bc[1] + b * ca[1] + c * ab[1];
    planes.fieldZ = a * bc[2] + b * ca[2] + c * ab[2];
    planes.determinant = determinant;
    planes.value = values[0];
    return planes;
}

/// Eight neighbouring samples as doubles.
template <class T> TETRA_SIMD_INLINE void loadRow(const T* samples, Double8& row)
{
    if constexpr (sizeof(T) == 1) {
        // The last bits of doubles of 2^52 and more are integers: quicker than what compilers make of bytes.
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, samples, sizeof bytes);
        constexpr std::uint64_t signs = std::is_signed_v<T> ? 0x8080808080808080 : 0;
        constexpr double shift = 0x1p52 + (std::is_signed_v<T> ? 128 : 0);
        typedef std::uint64_t Words __attribute__((vector_size(64)));
        const Words words = ((Words{} + (bytes ^ signs)) >> Words{0, 8, 16, 24, 32, 40, 48, 56}) & 255;
        row = reinterpret_cast<Double8>(words | 0x4330000000000000) - shift;
    } else {
        typedef T Samples __attribute__((vector_size(8 * sizeof(T))));
        Samples loaded;
        std::memcpy(&loaded, samples, sizeof loaded);
        if constexpr (std::is_integral_v<T> && sizeof(T) == 2)
            row = __builtin_convertvector(__builtin_convertvector(loaded, Int8), Double8);
        else
            row = __builtin_convertvector(loaded, Double8);
    }
}

constexpr std::int32_t scanLanes = 8;

/// From element 8 - n on: n lanes of ones, then zeros.
constexpr std::array<std::int64_t, 2 * scanLanes> laneOnes = {-1, -1, -1, -1, -1, -1, -1, -1};

using ScanPlace = std::array<std::int32_t, 3>;

/// The rows of a lattice's points in one tetrahedron, eight at a time. Inlined into loops that are compiled for several
/// instruction sets.
class TetrahedronRows {
protected:
    /// The rows that are looked at together.
    struct Rows {
        std::array<std::int32_t, scanLanes> first, last; ///< x, empty if the last comes first
        std::array<double, scanLanes> field;             ///< at x of the first corner, times the determinant
    };

    /// Bounds on x, counted from the first x looked at, where rows of y and z cross the planes of the faces: from
    /// below, or from above.
    struct RowPlanes {
        std::array<double, 4> atFirst, slopeY, slopeZ; ///< at the first y and z looked at
        std::array<bool, 4> fromBelow;
        double field; ///< at the first corner's x = 0, but for x
    };

    TETRA_SIMD_INLINE RowPlanes rowPlanes() const
    {
        // Of a face that no row crosses: no bound for rows on its inner side, and none is left for others.
        constexpr double steep = 1e12, farAway = 1e6;
        RowPlanes planes{};
        const double offsetY = first_[1] - corners_[0][1], offsetZ = first_[2] - corners_[0][2];
        Double4 slopeX, slopeY, slopeZ, constant;
        std::memcpy(&slopeX, &planes_.slopeX, sizeof slopeX);
        std::memcpy(&slopeY, &planes_.slopeY, sizeof slopeY);
        std::memcpy(&slopeZ, &planes_.slopeZ, sizeof slopeZ);
        std::memcpy(&constant, &planes_.constant, sizeof constant);
        const Double4 scale = slopeX == 0.0 ? Double4{} + steep : -1.0 / slopeX;
        const Double4 shift = slopeX == 0.0 ? Double4{} + farAway : Double4{} + double(corners_[0][0] - first_[0]);
        const Double4 atFirst = (constant + slopeY * offsetY + slopeZ * offsetZ) * scale + shift;
        slopeY *= scale;
        slopeZ *= scale;
        std::memcpy(&planes.atFirst, &atFirst, sizeof atFirst);
        std::memcpy(&planes.slopeY, &slopeY, sizeof slopeY);
        std::memcpy(&planes.slopeZ, &slopeZ, sizeof slopeZ);
        for (std::size_t face = 0; face < 4; ++face)
            planes.fromBelow[face] = planes_.slopeX[face] > 0;
        planes.field = planes_.determinant * planes_.value - planes_.fieldX * static_cast<double>(corners_[0][0]);
        return planes;
    }

    /// Which x the tetrahedron has in each of eight rows. Exact: where a row crosses a face is an integer or further
    /// from one than rounding takes it.
    TETRA_SIMD_INLINE void findRows(const RowPlanes& planes, std::int32_t y, std::int32_t z, Rows& rows) const
    {
        const Double8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
        const double stepY = y - first_[1], stepZ = z - first_[2];
        // None is negative, so that cutting off is rounding down.
        Double8 least = Double8{}, largest = Double8{} + static_cast<double>(last_[0] - first_[0]);
        for (std::size_t face = 0; face < 4; ++face) {
            const double atY = planes.atFirst[face] + planes.slopeZ[face] * stepZ + planes.slopeY[face] * stepY;
            const Double8 bound = planes.slopeY[face] * lane + atY;
            if (planes.fromBelow[face])
                least = bound > least ? bound : least;
            else
                largest = bound < largest ? bound : largest;
        }
        largest = largest < -1.0 ? Double8{} - 1.0 : largest;
        const double tooFar = last_[0] - first_[0] + 2.0;
        least = least > tooFar ? Double8{} + tooFar : least;
        const Int8 first = __builtin_convertvector(least + (1 - roundingTolerance), Int8) + first_[0];
        const Int8 last = __builtin_convertvector(largest + (1 + roundingTolerance), Int8) + (first_[0] - 1);
        const double offsetY = y - corners_[0][1], offsetZ = z - corners_[0][2];
        const Double8 field =
            planes_.fieldY * lane + (planes.field + planes_.fieldZ * offsetZ + planes_.fieldY * offsetY);
        std::memcpy(&rows.first, &first, sizeof first);
        std::memcpy(&rows.last, &last, sizeof last);
        std::memcpy(&rows.field, &field, sizeof field);
    }

    /// Which y the tetrahedron has in a plane across z, never too few.
    void sliceBounds(std::int32_t z, std::int32_t& first, std::int32_t& last) const
    {
        double least = last + 1, largest = first - 1;
        for (std::size_t i = 0; i < 4; ++i) {
            const double height = z - corners_[i][2];
            if (height == 0) {
                least = std::min(least, double(corners_[i][1]));
                largest = std::max(largest, double(corners_[i][1]));
            }
            for (std::size_t k = 0; k < i; ++k) {
                const double other = z - corners_[k][2];
                if (!(height * other < 0))
                    continue;
                const double y = corners_[i][1] + (corners_[k][1] - corners_[i][1]) * (height / (height - other));
                least = std::min(least, y);
                largest = std::max(largest, y);
            }
        }
        first = std::max(first, static_cast<std::int32_t>(std::ceil(least - roundingTolerance)));
        last = std::min(last, static_cast<std::int32_t>(std::floor(largest + roundingTolerance)));
    }

    /// Which x it has in a row, never too few.
    TETRA_SIMD_INLINE void rowBounds(const std::array<double, 4>& row, const std::array<double, 4>& perSlope,
                                     std::int32_t& first, std::int32_t& last) const
    {
        double least = first - corners_[0][0], largest = last - corners_[0][0];
        for (std::size_t face = 0; face < 4; ++face) {
            const double bound = -row[face] * perSlope[face];
            if (planes_.slopeX[face] > 0)
                least = std::max(least, bound);
            else if (planes_.slopeX[face] < 0)
                largest = std::min(largest, bound);
            else if (row[face] < 0)
                largest = least - 1;
        }
        first = corners_[0][0] + static_cast<std::int32_t>(std::ceil(least - roundingTolerance));
        last = corners_[0][0] + static_cast<std::int32_t>(std::floor(largest + roundingTolerance));
    }

    /// What bounds are off by at most.
    static constexpr double roundingTolerance = 1e-9;

    std::array<std::int32_t, 3> first_{}, last_{}; ///< the points to look at
    std::array<ScanPlace, 4> corners_{};
    std::array<ScanOffset, 3> edges_{};
    ScanPlanes planes_{};
};

/// Errors a little below the limit are looked at closely: products with it are rounded.
constexpr double nearly = 1 - 1e-14;

template <class T> class Scan : private TetrahedronRows {
public:
    Scan(const LocalDelaunay& mesh, const T* samples, const ErrorLimits& limits, std::vector<WorstSample>& worst)
        : mesh_(mesh), lattice_(mesh.lattice()), samples_(samples), limits_(limits), worst_(worst)
    {
    }

    TETRA_SIMD_INLINE void run(std::span<const std::uint32_t> slots, ScannedPart part)
    {
        constexpr std::size_t ahead = 8;
        const bool wide = lattice_.size()[0] >= static_cast<std::uint32_t>(scanLanes);
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (i + ahead < slots.size())
                mesh_.mesh().prefetch(slots[i + ahead]);
            const DelaunayTetrahedron& tetrahedron = mesh_.mesh()[slots[i]];
            if (!(tetrahedron.determinant() > 0) || !findBounds(tetrahedron, part))
                continue;
            makePlanes(tetrahedron);
            if (wide)
                look(slots[i], tetrahedron);
            else
                findWorst(slots[i], tetrahedron);
        }
    }

private:
    /// The points to look at; false if there are none.
    TETRA_SIMD_INLINE bool findBounds(const DelaunayTetrahedron& tetrahedron, ScannedPart part)
    {
        Int4 packed, x, y, z;
        std::memcpy(&packed, &tetrahedron.vertices, sizeof packed);
        lattice_.unpack(packed, x, y, z);
        bounds(x, first_[0], last_[0]);
        bounds(y, first_[1], last_[1]);
        bounds(z, first_[2], last_[2]);
        meets_ = true;
        bool settled = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            meets_ &= first_[axis] <= limits_.last[axis] && last_[axis] >= limits_.first[axis];
            settled &= first_[axis] >= limits_.settledFirst[axis] && last_[axis] <= limits_.settledLast[axis];
        }
        if (part == ScannedPart::All)
            return true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first_[axis] = std::max(first_[axis], limits_.first[axis]);
            last_[axis] = std::min(last_[axis], limits_.last[axis]);
        }
        return meets_ && !settled;
    }

    TETRA_SIMD_INLINE static void bounds(const Int4& c, std::int32_t& least, std::int32_t& largest)
    {
        least = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
        largest = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
    }

    TETRA_SIMD_INLINE void makePlanes(const DelaunayTetrahedron& tetrahedron)
    {
        const std::array<PackedPoint, 4>& vertices = tetrahedron.vertices;
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < 4; ++i) {
            corners_[i] = {lattice_.x(vertices[i]), lattice_.y(vertices[i]), lattice_.z(vertices[i])};
            values[i] = static_cast<double>(samples_[lattice_.index(vertices[i])]);
            if (i > 0)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    edges_[i - 1][axis] = static_cast<double>(corners_[i][axis] - corners_[0][axis]);
        }
        planes_ = scanPlanesOf(edges_, values, tetrahedron.determinant());
    }

    /// For each of eight lanes, the largest distance of a sample from the field (times the determinant) and its number
    /// in the lattice, the first of equals.
    struct Farthest {
        Double8 distance;
        Double8 place;
    };

    /// The worst samples inside and outside the part of the lattice where the limits are smaller. For limits that are
    /// the same all over each, that is all; else a sample that may be beyond its limit.
    TETRA_SIMD_INLINE void look(std::uint32_t slot, const DelaunayTetrahedron& tetrahedron)
    {
        const double least = limits_.least * nearly * planes_.determinant;
        const double most = limits_.most * nearly * planes_.determinant;
        const RowPlanes planes = rowPlanes();
        Farthest inside{Double8{} + least, Double8{} - 1.0}, outside{Double8{} + most, Double8{} - 1.0};
        for (std::int32_t z = first_[2]; z <= last_[2]; ++z) {
            std::int32_t firstY = first_[1], lastY = last_[1];
            if (lastY - firstY >= scanLanes)
                sliceBounds(z, firstY, lastY);
            for (std::int32_t block = firstY; block <= lastY; block += scanLanes) {
                Rows rows;
                findRows(planes, block, z, rows);
                const std::int32_t end = std::min(scanLanes, lastY - block + 1);
                for (std::int32_t i = 0; i < end; ++i)
                    if (rows.first[i] <= rows.last[i])
                        lookAtRow(rows.first[i], rows.last[i], block + i, z, rows.field[i], inside, outside);
            }
        }
        // Places stay negative where nothing was found.
        const Long8 none = reinterpret_cast<Long8>(inside.place) & reinterpret_cast<Long8>(outside.place);
        const Long4 half =
            __builtin_shufflevector(none, none, 0, 1, 2, 3) & __builtin_shufflevector(none, none, 4, 5, 6, 7);
        if ((half[0] & half[1] & half[2] & half[3]) < 0)
            return;
        const double largestInside = largestOf(inside.distance), largestOutside = largestOf(outside.distance);
        if (meets_ && !limits_.twoValued)
            return findWorst(slot, tetrahedron);
        WorstSample found;
        keepWorse(inside, largestInside, least, limits_.least, found);
        keepWorse(outside, largestOutside, most, limits_.most, found);
        if (found.error > 0 && isCorner(found.point, tetrahedron)) // by rounding
            return findWorst(slot, tetrahedron);
        append(found, slot, tetrahedron);
    }

    TETRA_SIMD_INLINE void lookAtRow(std::int32_t first, std::int32_t last, std::int32_t y, std::int32_t z,
                                     double field, Farthest& inside, Farthest& outside) const
    {
        const std::size_t row = (std::size_t(z) * lattice_.size()[1] + std::size_t(y)) * lattice_.size()[0];
        const std::int32_t from = limits_.first[0], to = limits_.last[0];
        const bool within =
            meets_ && y >= limits_.first[1] && y <= limits_.last[1] && z >= limits_.first[2] && z <= limits_.last[2];
        if (!within || last < from || first > to)
            return lookAtRun(row, first, last, field, outside);
        if (first < from)
            lookAtRun(row, first, from - 1, field, outside);
        lookAtRun(row, std::max(first, from), std::min(last, to), field, inside);
        if (last > to)
            lookAtRun(row, to + 1, last, field, outside);
    }

    TETRA_SIMD_INLINE static double largestOf(const Double8& numbers)
    {
        double largest = numbers[0];
        for (std::int32_t i = 1; i < scanLanes; ++i)
            largest = std::max(largest, numbers[i]);
        return largest;
    }

    void keepWorse(const Farthest& farthest, double largest, double threshold, double limit, WorstSample& found) const
    {
        const double error = largest / planes_.determinant;
        if (!(largest > threshold) || !(error > limit))
            return;
        double place = std::numeric_limits<double>::infinity();
        for (std::int32_t i = 0; i < scanLanes; ++i)
            if (farthest.distance[i] == largest)
                place = std::min(place, farthest.place[i]);
        const WorstSample sample{error / limit, error, lattice_.pointAt(static_cast<std::uint32_t>(place)), 0, {}};
        if (!(found.error > 0) || isWorse(sample, found))
            found = sample;
    }

    static bool isCorner(PackedPoint point, const DelaunayTetrahedron& tetrahedron)
    {
        return std::ranges::find(tetrahedron.vertices, point) != tetrahedron.vertices.end();
    }

    void append(WorstSample& found, std::uint32_t slot, const DelaunayTetrahedron& tetrahedron)
    {
        if (!(found.error > 0))
            return;
        found.slot = slot;
        found.tetrahedron = tetrahedron.vertices;
        worst_.push_back(found);
    }

    /// Takes in part of a row, whose first sample is number `row`.
    TETRA_SIMD_INLINE void lookAtRun(std::size_t row, std::int32_t first, std::int32_t last, double field,
                                     Farthest& farthest) const
    {
        const Double8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
        const std::int32_t lastStart = static_cast<std::int32_t>(lattice_.size()[0]) - scanLanes;
        const double slope = planes_.fieldX;
        for (std::int32_t x = first; x <= last; x += scanLanes) {
            const std::int32_t from = std::min(x, lastStart);
            Double8 values;
            loadRow(samples_ + row + from, values);
            const Double8 numerator =
                planes_.determinant * values - slope * lane - (field + slope * static_cast<double>(from));
            // Lanes that are not in the run become 0.
            Long8 upToLast, beforeFirst;
            std::memcpy(&upToLast, &laneOnes[scanLanes - std::min(scanLanes, last - from + 1)], sizeof upToLast);
            std::memcpy(&beforeFirst, &laneOnes[scanLanes - (x - from)], sizeof beforeFirst);
            const Double8 distance = reinterpret_cast<Double8>(
                reinterpret_cast<Long8>(numerator) & (Long8{} + 0x7fffffffffffffff) & upToLast & ~beforeFirst);
            const Double8 place = static_cast<double>(row + static_cast<std::size_t>(from)) + lane;
            farthest.place = distance > farthest.distance ? place : farthest.place;
            farthest.distance = distance > farthest.distance ? distance : farthest.distance;
        }
    }

    /// One sample after the other; few tetrahedra come to this.
    [[gnu::noinline]] void findWorst(std::uint32_t slot, const DelaunayTetrahedron& tetrahedron)
    {
        WorstSample found;
        std::array<double, 4> perSlope{};
        for (std::size_t face = 0; face < 4; ++face)
            perSlope[face] = 1 / planes_.slopeX[face];
        for (std::int32_t z = first_[2]; z <= last_[2]; ++z) {
            std::int32_t firstY = first_[1], lastY = last_[1];
            sliceBounds(z, firstY, lastY);
            for (std::int32_t y = firstY; y <= lastY; ++y) {
                const double offsetY = y - corners_[0][1], offsetZ = z - corners_[0][2];
                std::array<double, 4> row{};
                for (std::size_t face = 0; face < 4; ++face)
                    row[face] =
                        planes_.constant[face] + planes_.slopeY[face] * offsetY + planes_.slopeZ[face] * offsetZ;
                const double field = planes_.fieldY * offsetY + planes_.fieldZ * offsetZ;
                const T* const samples =
                    samples_ + (std::size_t(z) * lattice_.size()[1] + std::size_t(y)) * lattice_.size()[0];
                std::int32_t firstX = first_[0], lastX = last_[0];
                rowBounds(row, perSlope, firstX, lastX);
                for (std::int32_t x = firstX; x <= lastX; ++x) {
                    const double offsetX = x - corners_[0][0];
                    bool inside = true;
                    for (std::size_t face = 0; face < 4; ++face)
                        inside &= row[face] + planes_.slopeX[face] * offsetX >= 0;
                    if (!inside)
                        continue;
                    const double numerator = planes_.determinant * (static_cast<double>(samples[x]) - planes_.value) -
                                             planes_.fieldX * offsetX - field;
                    compare(std::abs(numerator) / planes_.determinant, {x, y, z}, tetrahedron, found);
                }
            }
        }
        append(found, slot, tetrahedron);
    }

    void compare(double error, const ScanPlace& place, const DelaunayTetrahedron& tetrahedron, WorstSample& found) const
    {
        if (!(error > limits_.least))
            return;
        const std::array<std::uint32_t, 3> point = {static_cast<std::uint32_t>(place[0]),
                                                    static_cast<std::uint32_t>(place[1]),
                                                    static_cast<std::uint32_t>(place[2])};
        const double limit = limits_.at(point);
        const WorstSample sample{error / limit, error, lattice_.pack(point[0], point[1], point[2]), 0, {}};
        if (error > limit && !isCorner(sample.point, tetrahedron) && (!(found.error > 0) || isWorse(sample, found)))
            found = sample;
    }

    const LocalDelaunay& mesh_;
    const PackedLattice lattice_;
    const T* const samples_;
    const ErrorLimits& limits_;
    std::vector<WorstSample>& worst_;

    bool meets_ = false; ///< the part of the lattice where limits are not the largest
};

template <class T> TETRA_SIMD_INLINE void scan(const LocalDelaunay& mesh, const T* samples, const ErrorLimits& limits,
                                               std::span<const std::uint32_t> slots, ScannedPart part,
                                               std::vector<WorstSample>& worst)
{
    Scan<T>(mesh, samples, limits, worst).run(slots, part);
}

} // namespace

void scanSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                 const ErrorLimits& limits, ScannedPart part, std::vector<WorstSample>& worst)
{
    samples.visit([&]<class T>(const T* values) { dispatch<scan<T>>(mesh, values, limits, slots, part, worst); });
}

#if defined(TETRA_SIMD_16)

namespace {

/// Sums of a few products in floats are off by less than this, in parts of the largest of these.
constexpr double sampleRounding = 2e-6;
/// Beyond this floats cannot be relied on.
constexpr double largestNumber = 1e30;
constexpr std::int32_t rowsAtOnce = 16;
/// Rows are numbered in floats, which are divided.
constexpr double mostRows = 1 << 21;

/// Looks at the rows of points along x that meet a tetrahedron's box, one in each lane, from where they enter it to
/// where they leave it.
template <class T> class Filter {
public:
    Filter(const LocalDelaunay& mesh, const T* samples, double reach, const ErrorLimits& limits, ScannedPart part)
        : mesh_(mesh), lattice_(mesh.lattice()), samples_(samples), reach_(reach), limits_(limits), part_(part)
    {
    }

    TETRA_SIMD_INLINE TETRA_SIMD_16 void run(std::span<const std::uint32_t> slots, FilteredTetrahedra& filtered)
    {
        constexpr std::size_t ahead = 8;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (i + ahead < slots.size())
                mesh_.mesh().prefetch(slots[i + ahead]);
            const DelaunayTetrahedron& tetrahedron = mesh_.mesh()[slots[i]];
            if (!(tetrahedron.determinant() > 0) || !findBounds(tetrahedron))
                continue;
            if (!prepare(tetrahedron) || isSuspect())
                filtered.suspects.push_back(slots[i]);
            else if (isFine_ && part_ == ScannedPart::All)
                filtered.fine.push_back(slots[i]);
        }
    }

private:
    /// Where to look; false if nowhere.
    TETRA_SIMD_INLINE TETRA_SIMD_16 bool findBounds(const DelaunayTetrahedron& tetrahedron)
    {
        Int4 packed, x, y, z;
        std::memcpy(&packed, &tetrahedron.vertices, sizeof packed);
        lattice_.unpack(packed, x, y, z);
        for (std::size_t i = 0; i < 4; ++i)
            corners_[i] = {x[i], y[i], z[i]};
        bool meets = true, settled = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [least, largest] =
                std::minmax({corners_[0][axis], corners_[1][axis], corners_[2][axis], corners_[3][axis]});
            first_[axis] = least;
            last_[axis] = largest;
            meets &= least <= limits_.last[axis] && largest >= limits_.first[axis];
            settled &= least >= limits_.settledFirst[axis] && largest <= limits_.settledLast[axis];
        }
        if (part_ == ScannedPart::All)
            return true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            first_[axis] = std::max(first_[axis], limits_.first[axis]);
            last_[axis] = std::min(last_[axis], limits_.last[axis]);
        }
        return meets && !settled;
    }

    std::size_t indexOf(const ScanPlace& place) const
    {
        const auto& size = lattice_.size();
        return (std::size_t(place[2]) * size[1] + std::size_t(place[1])) * size[0] + std::size_t(place[0]);
    }

    /// Where rows cross the planes of the faces, and the field, counted from the first point. False if floats will not
    /// do, or if more than the samples would be read.
    TETRA_SIMD_INLINE TETRA_SIMD_16 bool prepare(const DelaunayTetrahedron& tetrahedron)
    {
        std::array<ScanOffset, 3> edges{};
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < 4; ++i) {
            values[i] = static_cast<double>(samples_[indexOf(corners_[i])]);
            if (i > 0)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    edges[i - 1][axis] = static_cast<double>(corners_[i][axis] - corners_[0][axis]);
        }
        const ScanPlanes planes = scanPlanesOf(edges, values, tetrahedron.determinant());
        ScanOffset start{}, extent{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            start[axis] = first_[axis] - corners_[0][axis];
            extent[axis] = last_[axis] - first_[axis];
        }
        Double4 slopeX, slopeY, slopeZ, constant;
        std::memcpy(&slopeX, &planes.slopeX, sizeof slopeX);
        std::memcpy(&slopeY, &planes.slopeY, sizeof slopeY);
        std::memcpy(&slopeZ, &planes.slopeZ, sizeof slopeZ);
        std::memcpy(&constant, &planes.constant, sizeof constant);
        // Of a face that no row crosses: no bound for rows on its inner side, and none is left for others.
        constexpr double steep = 1e9, farAway = 1e6;
        const Double4 scale = slopeX == 0.0 ? Double4{} + steep : -1.0 / slopeX;
        Double4 at = (constant + slopeX * start[0] + slopeY * start[1] + slopeZ * start[2]) * scale;
        at = slopeX == 0.0 ? at + farAway : at;
        const Double4 perY = slopeY * scale, perZ = slopeZ * scale;
        const Double4 sizeAt = at < 0.0 ? -at : at, sizeY = perY < 0.0 ? -perY : perY,
                      sizeZ = perZ < 0.0 ? -perZ : perZ;
        const Double4 tolerance = sampleRounding * (1.0 + extent[0] + sizeAt + sizeY * extent[1] + sizeZ * extent[2]);
        const Double4 widened = slopeX > 0.0 ? at - tolerance : at + tolerance;
        fromBelow_ = {planes.slopeX[0] > 0, planes.slopeX[1] > 0, planes.slopeX[2] > 0, planes.slopeX[3] > 0};
        bound_ = __builtin_convertvector(widened, Float4);
        boundY_ = __builtin_convertvector(perY, Float4);
        boundZ_ = __builtin_convertvector(perZ, Float4);
        const double perDeterminant = 1 / planes.determinant;
        const double fieldX = planes.fieldX * perDeterminant, fieldY = planes.fieldY * perDeterminant,
                     fieldZ = planes.fieldZ * perDeterminant;
        const double field = values[0] + fieldX * start[0] + fieldY * start[1] + fieldZ * start[2];
        field_ = static_cast<float>(field);
        fieldX_ = static_cast<float>(fieldX);
        fieldY_ = static_cast<float>(fieldY);
        fieldZ_ = static_cast<float>(fieldZ);
        const double magnitude = reach_ + std::abs(field) + std::abs(fieldX) * extent[0] +
                                 std::abs(fieldY) * extent[1] + std::abs(fieldZ) * extent[2];
        least_ = static_cast<float>(limits_.least - sampleRounding * magnitude);
        most_ = static_cast<float>(limits_.most - sampleRounding * magnitude);
        const auto& size = lattice_.size();
        const std::size_t count = std::size_t(size[0]) * size[1] * size[2];
        const bool isNumbered = (extent[1] + 1) * (extent[2] + 1) <= mostRows &&
                                indexOf(last_) - indexOf(first_) <= std::numeric_limits<std::int32_t>::max();
        return magnitude < largestNumber && least_ > 0 && isNumbered &&
               (count - indexOf(last_)) * sizeof(T) >= sizeof(std::int32_t);
    }

    /// Whether a sample may lie in the tetrahedron and be beyond its limit; if not, isFine_ says if all keep the least.
    TETRA_SIMD_INLINE TETRA_SIMD_16 bool isSuspect()
    {
        constexpr Float16 lane = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
        constexpr float most = 0.9999f; // of a row of integers, to round up
        const T* const from = samples_ + indexOf(first_);
        const std::int32_t countY = last_[1] - first_[1] + 1, rows = countY * (last_[2] - first_[2] + 1);
        const auto perPlane = static_cast<float>(countY), planesPer = 1 / perPlane;
        const auto strideY = static_cast<std::int32_t>(lattice_.size()[0]);
        const std::int32_t strideZ = strideY * static_cast<std::int32_t>(lattice_.size()[1]);
        const auto lastX = static_cast<float>(last_[0] - first_[0]);
        const std::array<std::int32_t, 3> limitedFirst = {limits_.first[0] - first_[0], limits_.first[1] - first_[1],
                                                          limits_.first[2] - first_[2]};
        const std::array<std::int32_t, 3> limitedLast = {limits_.last[0] - first_[0], limits_.last[1] - first_[1],
                                                         limits_.last[2] - first_[2]};
        __mmask16 beyondLeast = 0;
        for (std::int32_t row = 0; row < rows; row += rowsAtOnce) {
            const Float16 number = lane + static_cast<float>(row);
            const Int16 planeNumber = __builtin_convertvector((number + 0.5f) * planesPer, Int16);
            const Float16 z = __builtin_convertvector(planeNumber, Float16);
            const Float16 y = number - z * perPlane;
            Float16 least = Float16{}, largest = Float16{} + lastX;
            for (std::size_t face = 0; face < 4; ++face) {
                const Float16 bound = bound_[face] + boundY_[face] * y + boundZ_[face] * z;
                if (fromBelow_[face])
                    least = bound > least ? bound : least;
                else
                    largest = bound < largest ? bound : largest;
            }
            largest = largest < -1.0f ? Float16{} - 1.0f : largest;
            least = least > lastX + 1.0f ? Float16{} + (lastX + 1.0f) : least;
            Int16 x = __builtin_convertvector(least + most, Int16);
            const Int16 last = __builtin_convertvector(largest + 1.0f, Int16) - 1;
            __mmask16 left = _mm512_cmple_epi32_mask(reinterpret_cast<__m512i>(x), reinterpret_cast<__m512i>(last));
            if (rows - row < rowsAtOnce)
                left &= static_cast<__mmask16>((1u << (rows - row)) - 1);
            if (left == 0)
                continue;
            const Int16 rowY = __builtin_convertvector(y, Int16);
            const Int16 start = rowY * strideY + planeNumber * strideZ;
            const Float16 field = field_ + fieldY_ * y + fieldZ_ * z;
            const __mmask16 limited =
                between(rowY, limitedFirst[1], limitedLast[1]) & between(planeNumber, limitedFirst[2], limitedLast[2]);
            do {
                const Float16 above =
                    gather(from, start + x, left) - (field + fieldX_ * __builtin_convertvector(x, Float16));
                const __mmask16 inside = limited & between(x, limitedFirst[0], limitedLast[0]);
                const __m512 error = _mm512_abs_ps(reinterpret_cast<__m512>(above));
                const __mmask16 notFine = _mm512_mask_cmp_ps_mask(left, error, _mm512_set1_ps(least_), _CMP_NLE_UQ);
                if ((notFine & inside) != 0 ||
                    _mm512_mask_cmp_ps_mask(notFine, error, _mm512_set1_ps(most_), _CMP_NLE_UQ) != 0)
                    return true;
                beyondLeast |= notFine;
                x += 1;
                left &= _mm512_cmple_epi32_mask(reinterpret_cast<__m512i>(x), reinterpret_cast<__m512i>(last));
            } while (left != 0);
        }
        isFine_ = beyondLeast == 0;
        return false;
    }

    TETRA_SIMD_INLINE TETRA_SIMD_16 static __mmask16 between(const Int16& numbers, std::int32_t first,
                                                             std::int32_t last)
    {
        const auto vector = reinterpret_cast<__m512i>(numbers);
        return _mm512_mask_cmple_epi32_mask(_mm512_cmpge_epi32_mask(vector, _mm512_set1_epi32(first)), vector,
                                            _mm512_set1_epi32(last));
    }

    /// The samples of those numbers, as floats.
    TETRA_SIMD_INLINE TETRA_SIMD_16 static Float16 gather(const T* from, const Int16& numbers, __mmask16 wanted)
    {
        const __m512i read = _mm512_mask_i32gather_epi32(_mm512_setzero_si512(), wanted,
                                                         reinterpret_cast<__m512i>(numbers), from, sizeof(T));
        if constexpr (std::is_same_v<T, float>)
            return reinterpret_cast<Float16>(read);
        constexpr int unread = 8 * (sizeof(std::int32_t) - sizeof(T)); // bits of those behind
        typedef std::conditional_t<std::is_signed_v<T>, std::int32_t, std::uint32_t> Numbers
            __attribute__((vector_size(64)));
        return __builtin_convertvector(reinterpret_cast<Numbers>(read) << unread >> unread, Float16);
    }

    const LocalDelaunay& mesh_;
    const PackedLattice lattice_;
    const T* const samples_;
    const double reach_;
    const ErrorLimits& limits_;
    const ScannedPart part_;

    std::array<ScanPlace, 4> corners_{};
    ScanPlace first_{}, last_{}; ///< the points to look at
    std::array<bool, 4> fromBelow_{};
    Float4 bound_{}, boundY_{}, boundZ_{}; ///< on x, from each face
    float field_ = 0, fieldX_ = 0, fieldY_ = 0, fieldZ_ = 0;
    float least_ = 0, most_ = 0; ///< limits
    bool isFine_ = false;
};

template <class T> TETRA_SIMD_16 void filter(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots,
                                             const T* samples, double reach, const ErrorLimits& limits,
                                             ScannedPart part, FilteredTetrahedra& filtered)
{
    Filter<T>(mesh, samples, reach, limits, part).run(slots, filtered);
}

} // namespace

#endif

void filterTetrahedra([[maybe_unused]] const LocalDelaunay& mesh, std::span<const std::uint32_t> slots,
                      const LatticeSamples& samples, [[maybe_unused]] double reach,
                      [[maybe_unused]] const ErrorLimits& limits, [[maybe_unused]] ScannedPart part,
                      FilteredTetrahedra& filtered)
{
    samples.visit([&]<class T>([[maybe_unused]] const T* values) {
#if defined(TETRA_SIMD_16)
        if constexpr (sizeof(T) <= sizeof(std::int32_t))
            if (limits.least > 0 && simdLevel() == SimdLevel::Sixteen)
                return filter(mesh, slots, values, reach, limits, part, filtered);
#endif
        filtered.suspects.insert(filtered.suspects.end(), slots.begin(), slots.end());
    });
}

} // namespace tetra
