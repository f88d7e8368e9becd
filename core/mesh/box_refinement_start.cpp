// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/box_refinement.h"

#include "core/mesh/rounding.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <limits>

namespace tetra {

Status BoxRefinement::distributeStart()
{
    std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount> inside;
    const auto& size = options_.box.size;
    const auto onSide = [this](PackedPoint p, const std::array<PackedPoint, 4>& v) {
        const auto offset = [&](PackedPoint q) -> std::array<std::int64_t, 3> {
            return {lattice_.x(q) - lattice_.x(p), lattice_.y(q) - lattice_.y(p), lattice_.z(q) - lattice_.z(p)};
        };
        const auto a = offset(v[1]), b = offset(v[2]), c = offset(v[3]);
        return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]) >=
               0;
    };
    for (std::uint32_t z = 0; z < size[2]; ++z)
        for (std::uint32_t y = 0; y < size[1]; ++y)
            for (std::uint32_t x = 0; x < size[0]; ++x) {
                const PackedPoint point = lattice_.pack(x, y, z);
                const bool corner =
                    (x == 0 || x == size[0] - 1) && (y == 0 || y == size[1] - 1) && (z == 0 || z == size[2] - 1);
                if (corner)
                    continue;
                std::uint32_t slot = 0;
                while (slot < LatticeDelaunay::startCount - 1 && !onSide(point, delaunay_[slot].vertices))
                    ++slot;
                inside[slot].push_back(point);
            }
    Star& star = startStar_;
    if (Status status = star.attach(lattice_); !status)
        return status;
    for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
        const auto& vertices = delaunay_[slot].vertices;
        star.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, {1, 1, 1});
        slots_[slot].bucket = none;
        startErrors_[slot] = 0;
        if (inside[slot].empty())
            continue;
        relocation_.run(lattice_, *samples_, star, inside[slot]);
        fillBuckets({&slot, 1});
        startErrors_[slot] = relocation_.worstError(0);
        std::vector<PackedPoint>().swap(inside[slot]);
    }
    return {};
}

/// Hands the eight corners and the five tetrahedra to the sink, each tetrahedron with the latest of its corners.
Status BoxRefinement::addCorners()
{
    const auto& size = options_.box.size;
    std::array<PackedPoint, 8> points{};
    for (std::uint32_t corner = 0; corner < points.size(); ++corner) {
        points[corner] = lattice_.pack((corner & 1) * (size[0] - 1), (corner >> 1 & 1) * (size[1] - 1),
                                       (corner >> 2 & 1) * (size[2] - 1));
        delaunay_.label(points[corner], corner);
    }
    for (const PackedPoint point : points) {
        starHistory_.clear();
        for (std::uint32_t slot = 0; slot < LatticeDelaunay::startCount; ++slot) {
            std::array<std::uint32_t, 4> sites{};
            for (std::size_t i = 0; i < 4; ++i)
                sites[i] =
                    static_cast<std::uint32_t>(std::ranges::find(points, delaunay_[slot].vertices[i]) - points.begin());
            const auto latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
            if (sites[latest] != siteCount_)
                continue;
            const auto& [a, b, c] = cornersOfFace[latest];
            starHistory_.push_back({{sites[a], sites[b], sites[c]}, startErrors_[slot]});
            slots_[slot].history = static_cast<std::uint32_t>(tetrahedronCount_++);
        }
        if (Status status = sink_->add({wholeIndex(point), std::numeric_limits<float>::infinity(), starHistory_, {}});
            !status)
            return status;
        ++siteCount_;
    }
    return {};
}

Status BoxRefinement::start()
{
    const auto& size = options_.box.size;
    if (Status status = delaunay_.start(size, options_.metric, options_.centreAtOrigin); !status)
        return status;
    lattice_ = delaunay_.lattice();
    queue_.start(roundedUp(options_.valueExtent));
    bucketCount_ = 0;
    freeBuckets_.clear();
    pointsAboveStop_ = 0;
    siteCount_ = 0;
    tetrahedronCount_ = 0;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    if (Status status = pool_.reserve(pointCount); !status)
        return status;
    if (Status status = buckets_.ensure(pointCount, "the lists of the refinement's points"); !status)
        return status;
    if (Status status = slots_.ensure(delaunay_.capacity(), "the state of the refinement's tetrahedra"); !status)
        return status;
    if (Status status = distributeStart(); !status)
        return status;
    return addCorners();
}

} // namespace tetra
