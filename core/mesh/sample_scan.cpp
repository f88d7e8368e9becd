// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/sample_scan.h"

#include "core/base/simd.h"
#include "core/mesh/tetrahedron_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

namespace tetra {

namespace {

/// Errors a little below the limit are looked at closely: products with it are rounded.
constexpr double nearly = 1 - 1e-14;

template <class T> class Scan : private TetrahedronRows {
public:
    Scan(const LocalDelaunay& mesh, const T* samples, const ErrorLimits& limits, std::vector<WorstSample>& worst)
        : mesh_(mesh), lattice_(mesh.lattice()), samples_(samples), limits_(limits), worst_(worst)
    {
    }

    [[gnu::always_inline]] void run(std::span<const std::uint32_t> slots, ScannedPart part)
    {
        constexpr std::size_t ahead = 8;
        const bool wide = lattice_.size()[0] >= static_cast<std::uint32_t>(lanes);
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
    [[gnu::always_inline]] bool findBounds(const DelaunayTetrahedron& tetrahedron, ScannedPart part)
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

    [[gnu::always_inline]] static void bounds(const Int4& c, std::int32_t& least, std::int32_t& largest)
    {
        least = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
        largest = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
    }

    [[gnu::always_inline]] void makePlanes(const DelaunayTetrahedron& tetrahedron)
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
        planes_ = planesOf(edges_, values, tetrahedron.determinant());
    }

    /// For each of eight lanes, the largest distance of a sample from the field (times the determinant) and its number
    /// in the lattice, the first of equals.
    struct Farthest {
        Double8 distance;
        Double8 place;
    };

    /// The worst samples inside and outside the part of the lattice where the limits are smaller. For limits that are
    /// the same all over each, that is all; else a sample that may be beyond its limit.
    [[gnu::always_inline]] void look(std::uint32_t slot, const DelaunayTetrahedron& tetrahedron)
    {
        const double least = limits_.least * nearly * planes_.determinant;
        const double most = limits_.most * nearly * planes_.determinant;
        const RowPlanes planes = rowPlanes();
        Farthest inside{Double8{} + least, Double8{} - 1.0}, outside{Double8{} + most, Double8{} - 1.0};
        for (std::int32_t z = first_[2]; z <= last_[2]; ++z) {
            std::int32_t firstY = first_[1], lastY = last_[1];
            if (lastY - firstY >= lanes)
                sliceBounds(z, firstY, lastY);
            for (std::int32_t block = firstY; block <= lastY; block += lanes) {
                Rows rows;
                findRows(planes, block, z, rows);
                const std::int32_t end = std::min(lanes, lastY - block + 1);
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

    [[gnu::always_inline]] void lookAtRow(std::int32_t first, std::int32_t last, std::int32_t y, std::int32_t z,
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

    [[gnu::always_inline]] static double largestOf(const Double8& numbers)
    {
        double largest = numbers[0];
        for (std::int32_t i = 1; i < lanes; ++i)
            largest = std::max(largest, numbers[i]);
        return largest;
    }

    void keepWorse(const Farthest& farthest, double largest, double threshold, double limit, WorstSample& found) const
    {
        const double error = largest / planes_.determinant;
        if (!(largest > threshold) || !(error > limit))
            return;
        double place = std::numeric_limits<double>::infinity();
        for (std::int32_t i = 0; i < lanes; ++i)
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
    [[gnu::always_inline]] void lookAtRun(std::size_t row, std::int32_t first, std::int32_t last, double field,
                                          Farthest& farthest) const
    {
        const Double8 lane = {0, 1, 2, 3, 4, 5, 6, 7};
        const std::int32_t lastStart = static_cast<std::int32_t>(lattice_.size()[0]) - lanes;
        const double slope = planes_.fieldX;
        for (std::int32_t x = first; x <= last; x += lanes) {
            const std::int32_t from = std::min(x, lastStart);
            Double8 values;
            loadRow(samples_ + row + from, values);
            const Double8 numerator =
                planes_.determinant * values - slope * lane - (field + slope * static_cast<double>(from));
            // Lanes that are not in the run become 0.
            Long8 upToLast, beforeFirst;
            std::memcpy(&upToLast, &ones[lanes - std::min(lanes, last - from + 1)], sizeof upToLast);
            std::memcpy(&beforeFirst, &ones[lanes - (x - from)], sizeof beforeFirst);
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

    void compare(double error, const Place& place, const DelaunayTetrahedron& tetrahedron, WorstSample& found) const
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

template <class T> [[gnu::always_inline]] inline void scanAs(const LocalDelaunay& mesh, const T* samples,
                                                             const ErrorLimits& limits,
                                                             std::span<const std::uint32_t> slots, ScannedPart part,
                                                             std::vector<WorstSample>& worst)
{
    Scan<T>(mesh, samples, limits, worst).run(slots, part);
}

// Clones cannot be templates.
using Slots = std::span<const std::uint32_t>;
using Found = std::vector<WorstSample>;
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::uint8_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::int8_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::uint16_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::int16_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::uint32_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const std::int32_t* samples, const ErrorLimits& limits,
                            Slots slots, ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const float* samples, const ErrorLimits& limits, Slots slots,
                            ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}
TETRA_SIMD_CLONES void scan(const LocalDelaunay& mesh, const double* samples, const ErrorLimits& limits, Slots slots,
                            ScannedPart part, Found& worst)
{
    scanAs(mesh, samples, limits, slots, part, worst);
}

} // namespace

void scanSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                 const ErrorLimits& limits, ScannedPart part, std::vector<WorstSample>& worst)
{
    samples.visit([&](const auto* values) { scan(mesh, values, limits, slots, part, worst); });
}

} // namespace tetra
