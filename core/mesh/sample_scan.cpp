// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/sample_scan.h"

#include "core/base/simd.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace tetra {

namespace {

/// From so many samples of a row on, the part of it that is in the tetrahedron is found first.
constexpr int manySamples = 4;
/// Errors a little below the limit are looked at closely: products with it are rounded.
constexpr double nearly = 1 - 1e-14;

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

template <class T> class Scan {
public:
    Scan(const LocalDelaunay& mesh, const T* samples, const ErrorLimits& limits, std::vector<WorstSample>& worst)
        : mesh_(mesh), lattice_(mesh.lattice()), samples_(samples), limits_(limits), worst_(worst)
    {
    }

    [[gnu::always_inline]] void run(std::span<const std::uint32_t> slots, ScannedPart part)
    {
        constexpr std::size_t ahead = 8;
        for (std::size_t i = 0; i < slots.size(); ++i) {
            if (i + ahead < slots.size())
                mesh_.mesh().prefetch(slots[i + ahead]);
            const DelaunayTetrahedron& tetrahedron = mesh_.mesh()[slots[i]];
            if (tetrahedron.determinant() > 0)
                look(slots[i], tetrahedron, part);
        }
    }

private:
    [[gnu::always_inline]] void look(std::uint32_t slot, const DelaunayTetrahedron& tetrahedron, ScannedPart part)
    {
        Int4 packed, x, y, z;
        std::memcpy(&packed, &tetrahedron.vertices, sizeof packed);
        lattice_.unpack(packed, x, y, z);
        std::array<std::int32_t, 3> first{}, last{};
        bounds(x, first[0], last[0]);
        bounds(y, first[1], last[1]);
        bounds(z, first[2], last[2]);
        bool meets = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            meets &= first[axis] <= limits_.last[axis] && last[axis] >= limits_.first[axis];
        if (part == ScannedPart::Limited) {
            bool settled = true;
            for (std::size_t axis = 0; axis < 3; ++axis)
                settled &= first[axis] >= limits_.settledFirst[axis] && last[axis] <= limits_.settledLast[axis];
            if (!meets || settled)
                return;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                first[axis] = std::max(first[axis], limits_.first[axis]);
                last[axis] = std::min(last[axis], limits_.last[axis]);
            }
        }
        tetrahedron_ = &tetrahedron;
        slot_ = slot;
        ready_ = false;
        found_ = {};
        threshold_ = (meets ? limits_.least : limits_.most) * nearly * tetrahedron.determinant();
        for (std::int32_t row = first[2]; row <= last[2]; ++row)
            for (std::int32_t line = first[1]; line <= last[1]; ++line)
                lookAtRow(line, row, first[0], last[0]);
        if (found_.excess > 0)
            worst_.push_back(found_);
    }

    [[gnu::always_inline]] static void bounds(const Int4& c, std::int32_t& least, std::int32_t& largest)
    {
        least = std::min(std::min(c[0], c[1]), std::min(c[2], c[3]));
        largest = std::max(std::max(c[0], c[1]), std::max(c[2], c[3]));
    }

    /// Samples that are vertices are passed over before anything is computed: in dense parts hardly any are left.
    [[gnu::always_inline]] void lookAtRow(std::int32_t y, std::int32_t z, std::int32_t first, std::int32_t last)
    {
        const std::uint64_t* const vertices =
            mesh_.vertices().row(static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z));
        for (std::int32_t word = first >> 6; word <= last >> 6; ++word) {
            const std::int32_t base = word * 64;
            std::uint64_t bits = ~vertices[word];
            if (first > base)
                bits &= ~0ull << (first - base);
            if (last < base + 63)
                bits &= ~0ull >> (63 - (last - base));
            if (bits != 0)
                lookAtSamples(bits, base, y, z);
        }
    }

    [[gnu::always_inline]] void lookAtSamples(std::uint64_t bits, std::int32_t base, std::int32_t y, std::int32_t z)
    {
        if (!ready_)
            makeReady();
        const double offsetY = y - originY_, offsetZ = z - originZ_;
        Double4 slope, slopeY, slopeZ, constant;
        std::memcpy(&slope, &planes_.slopeX, sizeof slope);
        std::memcpy(&slopeY, &planes_.slopeY, sizeof slopeY);
        std::memcpy(&slopeZ, &planes_.slopeZ, sizeof slopeZ);
        std::memcpy(&constant, &planes_.constant, sizeof constant);
        constant += slopeY * offsetY + slopeZ * offsetZ;
        const double field = planes_.fieldY * offsetY + planes_.fieldZ * offsetZ;
        const T* const row = samples_ + (std::size_t(z) * lattice_.size()[1] + std::size_t(y)) * lattice_.size()[0];
        if (std::popcount(bits) >= manySamples) {
            bits &= inside(slope, constant, base);
        }  else {
            for (std::uint64_t left = bits; left != 0; left &= left - 1) {
                const int bit = std::countr_zero(left);
                const Double4 volumes = slope * static_cast<double>(base + bit - originX_) + constant;
                const Long4 outside = volumes < 0.0;
                if ((outside[0] | outside[1] | outside[2] | outside[3]) != 0)
                    bits &= ~(1ull << bit);
            }
        }
        for (; bits != 0; bits &= bits - 1) {
            const std::int32_t x = base + std::countr_zero(bits);
            const double numerator = planes_.determinant * (static_cast<double>(row[x]) - planes_.value) -
                                     planes_.fieldX * static_cast<double>(x - originX_) - field;
            if (std::abs(numerator) > threshold_)
                compare(std::abs(numerator) / planes_.determinant, x, y, z);
        }
    }

    /// The samples of a word of a row that lie in the tetrahedron. Quotients of integers of less than 26 bits are on the
    /// right side of an integer however they are rounded.
    [[gnu::always_inline]] std::uint64_t inside(const Double4& slope, const Double4& constant, std::int32_t base) const
    {
        const Double4 bound = -constant / slope;
        double least = base - originX_, largest = least + 63;
        for (int face = 0; face < 4; ++face) {
            if (slope[face] > 0)
                least = std::max(least, std::ceil(bound[face]));
            else if (slope[face] < 0)
                largest = std::min(largest, std::floor(bound[face]));
            else if (constant[face] < 0)
                return 0;
        }
        if (least > largest)
            return 0;
        const int from = static_cast<int>(least) - (base - originX_), to = static_cast<int>(largest) - (base - originX_);
        return (~0ull << from) & (~0ull >> (63 - to));
    }

    [[gnu::noinline]] void compare(double error, std::int32_t x, std::int32_t y, std::int32_t z)
    {
        const std::array<std::uint32_t, 3> place = {static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                                                    static_cast<std::uint32_t>(z)};
        const double limit = limits_.at(place);
        if (!(error > limit))
            return;
        const WorstSample sample{error / limit, error, lattice_.pack(place[0], place[1], place[2]), slot_,
                                 tetrahedron_->vertices};
        if (!(found_.excess > 0) || isWorse(sample, found_))
            found_ = sample;
    }

    [[gnu::always_inline]] void makeReady()
    {
        const std::array<PackedPoint, 4>& vertices = tetrahedron_->vertices;
        originX_ = lattice_.x(vertices[0]);
        originY_ = lattice_.y(vertices[0]);
        originZ_ = lattice_.z(vertices[0]);
        std::array<Offset, 3> edges{};
        std::array<double, 4> values{};
        for (std::size_t i = 0; i < 4; ++i) {
            values[i] = static_cast<double>(samples_[lattice_.index(vertices[i])]);
            if (i > 0)
                edges[i - 1] = {static_cast<double>(lattice_.x(vertices[i]) - originX_),
                                static_cast<double>(lattice_.y(vertices[i]) - originY_),
                                static_cast<double>(lattice_.z(vertices[i]) - originZ_)};
        }
        planes_ = planesOf(edges, values, tetrahedron_->determinant());
        ready_ = true;
    }

    const LocalDelaunay& mesh_;
    const PackedLattice lattice_;
    const T* const samples_;
    const ErrorLimits& limits_;
    std::vector<WorstSample>& worst_;

    const DelaunayTetrahedron* tetrahedron_ = nullptr;
    std::uint32_t slot_ = 0;
    bool ready_ = false;
    Planes planes_{};
    std::int32_t originX_ = 0, originY_ = 0, originZ_ = 0;
    double threshold_ = 0;
    WorstSample found_;
};

template <class T>
[[gnu::always_inline]] inline void scanAs(const LocalDelaunay& mesh, const T* samples, const ErrorLimits& limits,
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

void scanUnchanged(const LocalDelaunay& mesh, const LatticeSamples& samples, const ErrorLimits& limits,
                   ScannedPart part, std::vector<WorstSample>& worst)
{
    std::vector<std::uint32_t> slots;
    for (std::uint32_t slot = 0; slot < mesh.mesh().slotCount(); ++slot)
        if (!mesh.hasChanged(slot))
            slots.push_back(slot);
    scanSamples(mesh, slots, samples, limits, part, worst);
}

void scanSamples(const LocalDelaunay& mesh, std::span<const std::uint32_t> slots, const LatticeSamples& samples,
                 const ErrorLimits& limits, ScannedPart part, std::vector<WorstSample>& worst)
{
    samples.visit([&](const auto* values) { scan(mesh, values, limits, slots, part, worst); });
}

} // namespace tetra
