// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/simd.h"
#include "core/refine/insertion/local_delaunay.h"
#include "core/refine/lattice/lattice_samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

namespace tetra {

/// One tetrahedron, with the planes of its faces and of its field; coordinates are relative to its first vertex.
struct Planes {
    std::array<double, 4> slopeX, slopeY, slopeZ, constant; ///< six volumes towards each face, at a point
    double fieldX, fieldY, fieldZ;                          ///< slopes of the field, times the determinant
    double determinant;
    double value; ///< at the first vertex
};

using Offset = std::array<double, 3>;

[[gnu::always_inline]] inline Offset cross(const Offset& a, const Offset& b)
{
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

[[gnu::always_inline]] inline Planes planesOf(const std::array<Offset, 3>& edges, const std::array<double, 4>& values,
                                              double determinant)
{
    const Offset bc = cross(edges[1], edges[2]), ca = cross(edges[2], edges[0]), ab = cross(edges[0], edges[1]);
    Planes planes{};
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
template <class T> [[gnu::always_inline]] inline void loadRow(const T* samples, Double8& row)
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

inline constexpr std::int32_t lanes = 8;
/// From element 8 - n on: n lanes of ones, then zeros.
inline constexpr std::array<std::int64_t, 2 * lanes> ones = {-1, -1, -1, -1, -1, -1, -1, -1};
using Place = std::array<std::int32_t, 3>;

/// The rows of a lattice's points in one tetrahedron, eight at a time. Inlined into loops that are compiled for several
/// instruction sets.
class TetrahedronRows {
protected:
    /// The rows that are looked at together.
    struct Rows {
        std::array<std::int32_t, lanes> first, last; ///< x, empty if the last comes first
        std::array<double, lanes> field;             ///< at x of the first corner, times the determinant
    };

    /// Bounds on x, counted from the first x looked at, where rows of y and z cross the planes of the faces: from
    /// below, or from above.
    struct RowPlanes {
        std::array<double, 4> atFirst, slopeY, slopeZ; ///< at the first y and z looked at
        std::array<bool, 4> fromBelow;
        double field; ///< at the first corner's x = 0, but for x
    };

    [[gnu::always_inline]] RowPlanes rowPlanes() const
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
    [[gnu::always_inline]] void findRows(const RowPlanes& planes, std::int32_t y, std::int32_t z, Rows& rows) const
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
        const Int8 first = __builtin_convertvector(least + (1 - roundingRoom), Int8) + first_[0];
        const Int8 last = __builtin_convertvector(largest + (1 + roundingRoom), Int8) + (first_[0] - 1);
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
        first = std::max(first, static_cast<std::int32_t>(std::ceil(least - roundingRoom)));
        last = std::min(last, static_cast<std::int32_t>(std::floor(largest + roundingRoom)));
    }

    /// Which x it has in a row, never too few.
    [[gnu::always_inline]] void rowBounds(const std::array<double, 4>& row, const std::array<double, 4>& perSlope,
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
        first = corners_[0][0] + static_cast<std::int32_t>(std::ceil(least - roundingRoom));
        last = corners_[0][0] + static_cast<std::int32_t>(std::floor(largest + roundingRoom));
    }

    /// What bounds are off by at most.
    static constexpr double roundingRoom = 1e-9;

    std::array<std::int32_t, 3> first_{}, last_{}; ///< the points to look at
    std::array<Place, 4> corners_{};
    std::array<Offset, 3> edges_{};
    Planes planes_{};
};

/// How large the error may be at each point of a lattice, in units of the values.
class ErrorLimits {
public:
    virtual ~ErrorLimits() = default;
    virtual double at(const std::array<std::uint32_t, 3>& point) const = 0;

    double least = 0; ///< nowhere less ...
    double most = 0;  ///< ... and this everywhere but from `first` to `last`
    std::array<std::int32_t, 3> first{0, 0, 0};
    std::array<std::int32_t, 3> last{-1, -1, -1};
    bool twoValued = false; ///< it is `least` everywhere between the two

    /// Where it is known already that no error is beyond its limit: a tetrahedron that did not change and lies between
    /// the two is not looked at.
    void settle(const std::array<std::int32_t, 3>& from, const std::array<std::int32_t, 3>& to)
    {
        settledFirst = from;
        settledLast = to;
    }
    std::array<std::int32_t, 3> settledFirst{0, 0, 0};
    std::array<std::int32_t, 3> settledLast{-1, -1, -1};
};

/// A sample that a mesh is too far from, the worst of its tetrahedron.
struct WorstSample {
    double excess = 0; ///< the error divided by its limit, more than 1
    double error = 0;
    PackedPoint point = 0;
    std::uint32_t slot = 0;
    std::array<PackedPoint, 4> tetrahedron{}; ///< what the slot held
};

/// The worse first, then the first in the lattice.
inline bool isWorse(const WorstSample& one, const WorstSample& other)
{
    if (one.excess != other.excess)
        return one.excess > other.excess;
    if (one.error != other.error)
        return one.error > other.error;
    return one.point < other.point;
}

/// The samples to look at in a tetrahedron.
enum class ScannedPart {
    All,
    Limited, ///< only where the limits are not the largest
};

/// Looks at the samples in tetrahedra (closed, so that those on faces are looked at more than once), but for vertices,
/// and appends the worst of each tetrahedron that has one beyond the limits. Exact about what lies where; errors are
/// one division of exact integers for samples of up to 16 bits (S8), and rounded in doubles else.
void scanSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                 const ErrorLimits& limits, ScannedPart part, std::vector<WorstSample>& worst);

/// The slots that scanSamples() has to look at: in floats, sixteen rows of samples at a time, so that what lies
/// close to a face or to its limit counts as in and beyond. None is left out that has a sample beyond its limit. No
/// sample is farther from 0 than `reach`. Where the machine has no vectors for that, all are suspects.
struct FilteredTetrahedra {
    std::vector<std::uint32_t> suspects;
    std::vector<std::uint32_t> fine; ///< some of the others: none of their samples is beyond the least limit
};
void filterTetrahedra(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                      double reach, const ErrorLimits& limits, ScannedPart part, FilteredTetrahedra& filtered);

} // namespace tetra
