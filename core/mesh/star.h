// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/packed_lattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The star of a new point: the tetrahedra (point, a, b, c) over the faces of its cavity, as arrays by face so that
/// the arithmetic runs in vectors. All coordinates are relative to the point. Reused from insertion to insertion.
class Star {
public:
    /// Arrays by face are padded to a multiple of this.
    static constexpr std::size_t lanes = 8;

    void clear(const PackedLattice& lattice, PackedPoint apex);
    /// Adds a face; (apex, a, b, c) must be positive.
    void addFace(PackedPoint a, PackedPoint b, PackedPoint c);
    /// Computes normals, determinants and spheres of all faces. `weights` is the metric.
    void finish(const std::array<double, 3>& weights);

    std::size_t faceCount() const noexcept { return faces_.size(); }
    std::size_t paddedFaceCount() const noexcept { return (faces_.size() + lanes - 1) / lanes * lanes; }
    PackedPoint apex() const noexcept { return apex_; }
    /// The rim: the distinct vertices of the faces.
    std::span<const PackedPoint> rim() const noexcept { return rim_; }
    /// The three rim vertices of each face, as positions in rim().
    std::span<const std::array<std::uint32_t, 3>> faces() const noexcept { return faces_; }

    /// What is computed for each face; `values` hold one array of paddedFaceCount() numbers after the other.
    enum Quantity {
        NormalBC,        ///< b x c: positive on the side of a; three arrays
        NormalCA = 3,    ///< c x a
        NormalAB = 6,    ///< a x b
        Determinant = 9, ///< a . (b x c) > 0
        Centre = 10,     ///< the sphere's centre as in DelaunayTetrahedron; three arrays
        QuantityCount = 13
    };
    const double* quantity(std::size_t number) const noexcept { return values_.data() + number * paddedFaceCount(); }

    /// For each face and each corner the face on the other side of the edge opposite to that corner, or noPartner if
    /// the star ends there (on the hull).
    static constexpr std::uint32_t noPartner = 0xffffffff;
    std::span<const std::array<std::uint32_t, 3>> partners();

    /// The largest absolute coordinate of the rim, relative to the apex.
    std::int32_t reach() const noexcept { return reach_; }

private:
    std::uint32_t rimPosition(PackedPoint point);
    void growHash();

    struct HashEntry {
        PackedPoint point;
        std::uint32_t position; ///< + 1; 0 is empty
    };

    const PackedLattice* lattice_ = nullptr;
    PackedPoint apex_ = 0;
    std::int32_t reach_ = 0;
    std::vector<PackedPoint> rim_;
    std::vector<std::array<std::uint32_t, 3>> faces_;
    std::vector<HashEntry> hash_ = std::vector<HashEntry>(256);
    std::vector<std::uint32_t> hashUsed_;
    std::vector<double> rimCoordinates_;
    std::vector<double> corners_;
    std::vector<double> values_;
    std::vector<std::array<std::uint32_t, 3>> partners_;
    std::vector<std::uint32_t> edges_;
    std::size_t edgeStride_ = 0;
};

} // namespace tetra
