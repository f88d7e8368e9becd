// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refine/lattice/block_division.h"
#include "core/refine/lattice/packed_lattice.h"

#include <tan/base.h>

#include <array>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <vector>

namespace tetra {

/// Lattices in blocks are replayed region by region: boxes of whole blocks, of which each is done by one thread from
/// its first level to its last, and whose meshes share nothing but the sites on their common faces. A point that
/// several regions have belongs to the first of them; the others take it over, at the level at which it became a site
/// there, before they add sites of their own. Where the first one has taken all sites that a level asks for, no other
/// finds one more, as the meshes of a common face are the same.

/// A box of the lattice. Points are numbered in the box and in the lattice, x running fastest.
struct ReplayRegion {
    std::uint32_t number = 0;
    LatticeBox box;
    std::array<std::uint32_t, 3> latticeSize{2, 2, 2};
    bool firstBlockIsOdd = false; ///< BlockDivision::odd()

    bool isWhole() const noexcept { return box.size == latticeSize; }
    bool has(std::uint32_t latticePoint) const noexcept;
    std::uint32_t inBox(std::uint32_t latticePoint) const noexcept;
    std::uint32_t inLattice(std::uint32_t boxPoint) const noexcept;
    /// Whether no region before this one has a point of the box.
    bool owns(std::uint32_t boxPoint) const noexcept
    {
        const auto [x, y, z] = placeInBox(boxPoint);
        return x >= firstOwn(y, z);
    }
    /// The first point of a row of the box that it owns, as all behind it; box.size[0] if there is none.
    std::uint32_t firstOwn(std::uint32_t y, std::uint32_t z) const noexcept
    {
        if ((y == 0 && box.origin[1] > 0) || (z == 0 && box.origin[2] > 0))
            return box.size[0];
        return box.origin[0] > 0 ? 1 : 0;
    }
    /// Whether a region after this one has it.
    bool shares(std::uint32_t boxPoint) const noexcept;
    /// Calls visit(in the box, in the lattice, count) for the rows of points that it owns.
    void forEachOwnRow(const std::function<void(std::uint32_t, std::uint32_t, std::uint32_t)>& visit) const;

private:
    std::array<std::uint32_t, 3> placeInBox(std::uint32_t boxPoint) const noexcept
    {
        const std::uint32_t row = boxPoint / box.size[0];
        return {boxPoint - row * box.size[0], row % box.size[1], row / box.size[1]};
    }
    std::array<std::uint32_t, 3> placeInLattice(std::uint32_t latticePoint) const noexcept
    {
        const std::uint32_t row = latticePoint / latticeSize[0];
        return {latticePoint - row * latticeSize[0], row % latticeSize[1], row / latticeSize[1]};
    }
};

class ReplayRegions {
public:
    /// `blockCells`: along an edge of a block; 0 for one block, which is one region.
    ReplayRegions(const std::array<std::uint32_t, 3>& latticeSize, std::uint32_t blockCells);

    std::uint32_t count() const noexcept { return division_.count(); }
    ReplayRegion operator[](std::uint32_t number) const;
    /// Those before a region that touch it, in order.
    std::vector<std::uint32_t> touching(std::uint32_t number) const;
    /// The regions that have a point of the lattice, in order.
    void withPoint(std::uint32_t latticePoint, std::vector<std::uint32_t>& regions) const;

    /// Calls work(region, its progress) for all, in order, on as many threads as there are. A region may wait for those
    /// before it: they have been begun. The progress is cancelled when one has failed, too. Errors: the first one's.
    Status forEach(const Progress& progress, const Message& activity,
                   const std::function<Status(const ReplayRegion&, const Progress&)>& work) const;

private:
    std::array<std::uint32_t, 3> latticeSize_;
    std::uint32_t blocksAlong_; ///< an edge of a region
    BlockDivision division_;
};

/// What regions tell each other of the sites on their faces, level by level, as points of the lattice. From any thread.
class SharedSites {
public:
    explicit SharedSites(const ReplayRegions& regions);

    /// The points that the regions before this one told of at this level and that it has, once all have told. Errors:
    /// cancelled.
    Status await(const ReplayRegion& region, std::uint32_t level, std::vector<std::uint32_t>& sites,
                 const Progress& progress);
    /// The sites of the region's next level that others have, too, in the order in which they were added.
    void tell(const ReplayRegion& region, std::span<const std::uint32_t> sites);

private:
    struct Told {
        std::vector<std::uint32_t> sites;
        std::vector<std::size_t> ends; ///< of each level
    };

    std::vector<std::vector<std::uint32_t>> touching_;
    std::vector<Told> told_;
    std::mutex mutex_;
    std::condition_variable changed_;
};

} // namespace tetra
