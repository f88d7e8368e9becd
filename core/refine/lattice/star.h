// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/reserved_array.h"
#include "core/base/saved_state.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// The star of a new point: the tetrahedra (apex, a, b, c) over the faces of its cavity, with the geometry that
/// linking, spheres and relocation need, computed once in vectors. All coordinates are relative to the apex. An object
/// is reused from insertion to insertion; it holds eight bytes for each point of the lattice.
class Star {
public:
    /// The geometry of one tetrahedron; a, b, c are relative to the apex.
    struct alignas(32) Face {
        /// b x c, positive on the side of a, then c x a and a x b; the fourth number of each is 0.
        std::array<double, 12> normals;
        std::array<double, 4> sphere; ///< twice the determinant times the circumcentre, weighted; then the determinant
        double determinant() const noexcept { return sphere[3]; } ///< a . (b x c) > 0
    };

    /// `usedStamps` of the two thousand million that tell rims apart count as used already; the result is the same.
    explicit Star(std::uint32_t usedStamps = 0) : linkStart_(usedStamps) {}

    /// Must come first; `lattice` must outlive the star. Error: refused memory.
    Status attach(const PackedLattice& lattice);

    /// The star of `apex` over faces (a, b, c), where (apex, a, b, c) must be positive. `weights` is the metric.
    void set(PackedPoint apex, std::span<const std::array<PackedPoint, 3>> faces, const std::array<double, 3>& weights);

    std::size_t faceCount() const noexcept { return corners_.size(); }
    PackedPoint apex() const noexcept { return apex_; }
    /// The link: the distinct vertices of the faces.
    std::span<const PackedPoint> link() const noexcept { return {link_.data(), linkCount_}; }
    /// What label() was given for each link vertex.
    std::span<const std::uint32_t> labels() const noexcept { return {labels_.data(), linkCount_}; }
    /// Gives a point a number that labels() tells when it is on the link.
    void label(PackedPoint point, std::uint32_t number) { marks_[lattice_->index(point)].label = number; }
    /// Fetches what is kept for a point that will probably be on the next link.
    void prefetch(PackedPoint point) const { __builtin_prefetch(&marks_[lattice_->index(point)]); }

    /// The three link vertices a, b, c of each face, as positions in link().
    std::span<const std::array<std::uint32_t, 3>> corners() const noexcept { return corners_; }
    std::span<const Face> faces() const noexcept { return faces_; }
    /// A bound on the absolute coordinates of the link, relative to the apex: less than twice the largest, if more
    /// than 1.
    double reach() const noexcept { return reach_; }

    /// For each face and each corner the name of the face on the other side of the edge opposite to that corner, or
    /// `absent` if the star ends there (on the hull). `absent` must be the same in every call.
    std::span<const std::array<std::uint32_t, 3>> partners(std::span<const std::uint32_t> names, std::uint32_t absent);

    /// The labels, after attach().
    void archive(StateArchive& archive);

private:
    template <class Stride> void linkFaces(std::span<const std::uint32_t> names, Stride stride);
    void beginStampsAnew();
    // Called by dispatch().
    inline void numberLink(std::span<const std::array<PackedPoint, 3>> faces);
    inline void findPartners(std::span<const std::uint32_t> names, std::uint32_t absent);

    const PackedLattice* lattice_ = nullptr;
    PackedPoint apex_ = 0;
    double reach_ = 0;
    struct Mark {
        std::uint32_t stamp; ///< above linkStart_, by its position + 1, if the point is on the present link
        std::uint32_t label;
    };
    ReservedArray<Mark> marks_;
    std::uint32_t linkStart_;
    std::uint32_t linkCount_ = 0;
    Buffer<std::uint32_t> indices_;
    Buffer<PackedPoint> link_;
    Buffer<std::uint32_t> labels_;
    Buffer<std::array<std::uint32_t, 3>> corners_;
    Buffer<std::array<double, 4>> linkCoordinates_;
    Buffer<Face> faces_;
    Buffer<std::array<std::uint32_t, 3>> partners_;
    std::vector<std::uint32_t> edges_;
    std::size_t edgeStride_ = 0;
};

/// Points are searched for this many at a time; their arrays are padded to a multiple of it.
constexpr std::size_t coneSearchLanes = 8;

/// The coordinates of points relative to a star's apex.
struct LocatedPoints {
    std::span<const float> x, y, z;
};

/// owners[i] = the last face of the star whose cone, seen from the apex, contains point i. Exact: signs of integers, in
/// floats where the star is small enough, else in doubles. Branch free, O(points * faces). `planes` is room to work in.
void locateInStar(const Star& star, const LocatedPoints& points, Buffer<std::array<float, 12>>& planes,
                  std::span<std::int32_t> owners);

} // namespace tetra
