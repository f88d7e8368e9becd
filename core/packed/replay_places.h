// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/packed/free_points.h"
#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace tetra {

class BlockRecorder;
class PlacedBlock;

/// What the sites that enter a block do to its mesh. Tetrahedra are numbered in the block: first those of its start,
/// then as they are made.
struct BlockHistory {
    static constexpr std::uint32_t never = 0xffffffff;

    struct Site {
        std::uint32_t place = 0;        ///< among all sites
        std::uint32_t destroyedEnd = 0; ///< of what it destroys, in `destroyed`
        std::uint32_t madeEnd = 0;      ///< of what it makes, in `otherSites`
    };
    std::vector<Site> sites; ///< that enter
    std::vector<std::uint32_t> destroyed;
    std::vector<std::array<std::uint32_t, 3>> otherSites; ///< of what is made: positive with its site in front
    std::vector<std::uint32_t> destroyers;                ///< of each tetrahedron the place of a site, or never
};

/// Of the sites behind the blocks' corners, the history that they make in each block.
struct BlockHistories {
    std::vector<std::uint32_t> corners; ///< of all blocks, as points of the lattice, by rising numbers: the first sites
    std::vector<BlockHistory> blocks;
};

/// Where the points of a replayed model lie: a site in the mesh of the steps before its own, any other point in that of
/// all sites. No sample is asked for, so each block goes through all steps by itself, on any thread, in memory that the
/// next one takes over.
class ReplayPlaces {
public:
    using Vertices = std::array<PackedPoint, 4>; ///< of a tetrahedron, as points of the whole lattice

    /// `sites`: those behind the blocks' corners, in their order; `stepEnds`: behind the last site of each step, by
    /// their places in `sites`; `others`: all points that are no sites. Two to three microseconds a site and thread,
    /// 20 bytes a site and 4 a point besides the mesh of the blocks at work. With `histories`, which have the corners,
    /// these are found on the way, in some 350 bytes a site. On all threads; may throw std::bad_alloc. Errors: too
    /// large a lattice, refused memory, cancelled.
    Status find(const BlockDivision& division, const LatticeMetric& metric, std::span<const std::uint32_t> sites,
                std::span<const std::uint32_t> stepEnds, const FreePoints& others, BlockHistories* histories,
                const Progress& progress);

    /// Of the sites, tetrahedra that have them.
    std::span<const Vertices> ofSites() const noexcept { return ofSites_; }
    /// Of one of the other points.
    const Vertices& ofOther(std::uint32_t point) const { return tetrahedra_[numbers_[point]]; }

private:
    /// The sites that enter a block, in their steps.
    Status placeSites(PlacedBlock& block, std::span<const std::uint32_t> enter, std::span<const std::uint32_t> sites,
                      std::span<const std::uint32_t> stepEnds, BlockRecorder* recorder, const Progress& progress);
    /// A block's own points of the others, when all its sites are there.
    Status placeOthers(PlacedBlock& block, const FreePoints& others, const Progress& progress);

    std::mutex gathering_; ///< of tetrahedra
    std::vector<Vertices> ofSites_;
    std::vector<Vertices> tetrahedra_; ///< of the last mesh, those that have other points ...
    Buffer<std::uint32_t> numbers_;    ///< ... and for each of these which
};

} // namespace tetra
