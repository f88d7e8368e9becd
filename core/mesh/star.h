// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/buffer.h"
#include "core/base/reserved_array.h"
#include "core/base/result.h"
#include "core/mesh/packed_lattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The star of a new point: the tetrahedra (apex, a, b, c) over the faces of its cavity, with the geometry that
/// linking, spheres and relocation need, computed once in vectors. All coordinates are relative to the apex. An object
/// is reused from insertion to insertion; it holds four bytes for each point of the lattice.
class Star {
public:
    /// The geometry of one tetrahedron; a, b, c are relative to the apex.
    struct alignas(32) Face {
        std::array<double, 4> normalBC; ///< b x c, positive on the side of a; the fourth number is 0, as of the others
        std::array<double, 4> normalCA; ///< c x a
        std::array<double, 4> normalAB; ///< a x b
        std::array<double, 4> sphere; ///< twice the determinant times the circumcentre, weighted; then the determinant
        double determinant() const noexcept { return sphere[3]; } ///< a . (b x c) > 0
    };

    /// Must come first; `lattice` must outlive the star. Error: refused memory.
    Status attach(const PackedLattice& lattice);

    void clear(PackedPoint apex);
    /// Adds a face; (apex, a, b, c) must be positive.
    void addFace(PackedPoint a, PackedPoint b, PackedPoint c)
    {
        corners_.push_back({rimPosition(a), rimPosition(b), rimPosition(c)});
    }
    /// Computes faces(). `weights` is the metric.
    void finish(const std::array<double, 3>& weights);

    std::size_t faceCount() const noexcept { return corners_.size(); }
    PackedPoint apex() const noexcept { return apex_; }
    /// The rim: the distinct vertices of the faces.
    std::span<const PackedPoint> rim() const noexcept { return {rim_.data(), rimCount_}; }
    /// The three rim vertices a, b, c of each face, as positions in rim().
    std::span<const std::array<std::uint32_t, 3>> corners() const noexcept { return corners_; }
    std::span<const Face> faces() const noexcept { return faces_; }
    /// The largest absolute coordinate of the rim, relative to the apex.
    double reach() const noexcept { return reach_; }

    /// For each face and each corner the face on the other side of the edge opposite to that corner, or noPartner if
    /// the star ends there (on the hull).
    static constexpr std::uint32_t noPartner = 0xffffffff;
    std::span<const std::array<std::uint32_t, 3>> partners();

private:
    std::uint32_t rimPosition(PackedPoint point);

    const PackedLattice* lattice_ = nullptr;
    PackedPoint apex_ = 0;
    double reach_ = 0;
    /// A point is on the present rim if its stamp is above rimStart_, by its position + 1.
    ReservedArray<std::uint32_t> stamps_;
    std::uint32_t rimStart_ = 0;
    std::uint32_t rimCount_ = 0;
    Buffer<PackedPoint> rim_;
    std::vector<std::array<std::uint32_t, 3>> corners_;
    Buffer<std::array<double, 4>> rimCoordinates_;
    Buffer<Face> faces_;
    Buffer<std::array<std::uint32_t, 3>> partners_;
    std::vector<std::uint32_t> edges_;
    std::size_t edgeStride_ = 0;
};

/// The position of a point on the rim, which it joins if it is new. Without a branch on that, which nobody could
/// predict.
inline std::uint32_t Star::rimPosition(PackedPoint point)
{
    if (rimCount_ == rim_.size())
        rim_.resize(2 * rim_.size());
    std::uint32_t& stamp = stamps_[lattice_->index(point)];
    const bool isNew = stamp <= rimStart_;
    rim_[rimCount_] = point;
    stamp = isNew ? rimStart_ + rimCount_ + 1 : stamp;
    rimCount_ += isNew;
    return stamp - rimStart_ - 1;
}

} // namespace tetra
