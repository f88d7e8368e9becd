// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.h"

#include <tan/base.h>
#include <tan/build.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// What a decimation did, fine to coarse, and its reading backwards as a history of vertex splits. Some 28 bytes a
/// tetrahedron that ever lived.
class CollapseLog {
public:
    static constexpr std::uint32_t none = 0xffffffff;

    struct Tetrahedron {
        std::array<std::uint32_t, 3> others{}; ///< (vertex, others) is positive
        float error = 0;
        float warping = 0;
        std::uint32_t madeBy = none; ///< the collapse, by number, that made it; none: it is of the input
    };

    /// For about so many tetrahedra, so that nothing is copied while they come in. May throw std::bad_alloc.
    void reserve(std::uint64_t collapses, std::uint64_t tetrahedra);

    /// A collapse that takes `vertex` out with the tetrahedra around it and makes `madeCount`, in a mesh of `keyAfter`
    /// then. May throw std::bad_alloc.
    void add(std::uint32_t vertex, float keyAfter, std::span<const Tetrahedron> star, std::uint32_t madeCount);

    std::uint32_t collapseCount() const noexcept { return static_cast<std::uint32_t>(collapses_.size()); }
    std::uint64_t tetrahedronCount() const noexcept { return tetrahedra_.size(); }

    /// A tetrahedron of the coarsest mesh.
    struct Coarsest {
        std::array<std::uint32_t, 4> vertices{}; ///< positive
        float error = 0;
        float warping = 0;
        std::uint32_t madeBy = none;
    };

    /// Hands all to `sink`, coarse first. `points`: for each vertex the number that the sink knows it by. `finalKey` is
    /// that of the input. Errors: more tetrahedra than can be numbered, the sink's, cancelled.
    Status replay(std::span<const std::uint32_t> points, std::span<const Coarsest> coarsest, float finalKey,
                  HistorySink& sink, const Progress& progress) const;

    /// Hands over the coarsest mesh alone, of the key `key`, with sink.finish().
    Status handCoarsest(std::span<const std::uint32_t> points, std::vector<Coarsest> coarsest, float key,
                        HistorySink& sink) const;

    void archive(StateArchive& archive)
    {
        archive.grown(collapses_);
        archive.grown(tetrahedra_);
    }

private:
    std::vector<std::uint8_t> removed(std::size_t points) const;

    struct Collapse {
        std::uint32_t vertex;
        float keyAfter;
        std::uint32_t starSize;  ///< of tetrahedra_, how many are its own
        std::uint32_t madeCount; ///< how many it made
    };
    std::vector<Collapse> collapses_;
    std::vector<Tetrahedron> tetrahedra_;
};

} // namespace tetra
