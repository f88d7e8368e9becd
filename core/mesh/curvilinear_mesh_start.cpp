// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/curvilinear_mesh.h"

#include "core/mesh/lattice_walk.h"
#include "core/mesh/topology.h"

#include <algorithm>
#include <limits>

namespace tetra {

Status CurvilinearMesh::reserve()
{
    const auto& size = grid_.lattice().size();
    std::uint64_t blockPoints = 0;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block)
        blockPoints += blocks_.box(block).pointCount();
    // Six to seven tetrahedra a vertex are alive at once; room to spare.
    const std::uint64_t slots =
        std::min<std::uint64_t>(10 * blockPoints + 64 * std::uint64_t(blocks_.count()) + 4096, 0xfffffff0);
    if (Status status = delaunay_.prepare(size, {1, 1, 1}, slots); !status)
        return status;
    if (Status status = pool_.reserve(blockPoints); !status)
        return status;
    if (Status status = slots_.reserve(delaunay_.capacity(), "the state of the refinement's tetrahedra"); !status)
        return status;
    if (Status status = startStar_.attach(grid_.lattice()); !status)
        return status;
    const std::uint64_t pointCount = std::uint64_t(size[0]) * size[1] * size[2];
    return siteOfPoint_.reserve(pointCount, "the numbers of the sites");
}

Status CurvilinearMesh::start(HistorySink& sink)
{
    if (Status status = reserve(); !status)
        return status;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block) {
        hints_.push_back(delaunay_.addBox(blocks_.box(block), !blocks_.odd(block)));
        distribute(block, hints_.back());
    }
    if (Status status = addCorners(sink); !status)
        return status;
    for (std::uint32_t slot = 0; slot < delaunay_.slotCount(); ++slot)
        noteOrientation(slot);
    return {};
}

/// Gives every point of the block but its corners to one of the five tetrahedra of its start.
void CurvilinearMesh::distribute(std::uint32_t block, std::uint32_t firstSlot)
{
    const PackedLattice& lattice = grid_.lattice();
    const LatticeBox box = blocks_.box(block);
    std::array<std::vector<PackedPoint>, LatticeDelaunay::startCount> inside;
    for (std::uint32_t z = box.origin[2]; z <= box.last(2); ++z)
        for (std::uint32_t y = box.origin[1]; y <= box.last(1); ++y)
            for (std::uint32_t x = box.origin[0]; x <= box.last(0); ++x) {
                const PackedPoint point = lattice.pack(x, y, z);
                const bool corner = (x == box.origin[0] || x == box.last(0)) &&
                                    (y == box.origin[1] || y == box.last(1)) &&
                                    (z == box.origin[2] || z == box.last(2));
                if (corner)
                    continue;
                std::uint32_t number = 0;
                while (number < LatticeDelaunay::startCount - 1 &&
                       !onInnerSide(lattice, point, delaunay_[firstSlot + number].vertices))
                    ++number;
                inside[number].push_back(point);
            }
    for (std::uint32_t number = 0; number < LatticeDelaunay::startCount; ++number) {
        const std::uint32_t slot = firstSlot + number;
        const auto& vertices = delaunay_[slot].vertices;
        startStar_.set(vertices[0], {{{vertices[1], vertices[2], vertices[3]}}}, {1, 1, 1});
        relocation_.run(grid_, startStar_, inside[number]);
        slots_[slot] = {none, none, block, 1};
        startAccuracies_.push_back(fillBucket(slot, 0, delaunay_[slot].determinant()));
        std::vector<PackedPoint>().swap(inside[number]);
    }
}

/// Hands the corners of all blocks and the tetrahedra of the start to the sink, each with the latest of its corners.
Status CurvilinearMesh::addCorners(HistorySink& sink)
{
    std::vector<std::uint32_t> corners;
    for (std::uint32_t block = 0; block < blocks_.count(); ++block)
        for (std::uint32_t number = 0; number < 8; ++number) {
            const auto corner = blocks_.box(block).corner(number);
            corners.push_back(index(grid_.lattice().pack(corner[0], corner[1], corner[2])));
        }
    std::ranges::sort(corners);
    corners.erase(std::ranges::unique(corners).begin(), corners.end());
    for (std::uint32_t site = 0; site < corners.size(); ++site)
        siteOfPoint_[corners[site]] = site + 1;

    struct Born {
        std::uint32_t creator;
        std::uint32_t slot;
        std::array<std::uint32_t, 3> sites;
    };
    std::vector<Born> tetrahedra;
    for (std::uint32_t slot = 0; slot < delaunay_.slotCount(); ++slot) {
        std::array<std::uint32_t, 4> sites{};
        for (std::size_t i = 0; i < 4; ++i)
            sites[i] = siteOfPoint_[index(delaunay_[slot].vertices[i])] - 1;
        const auto latest = static_cast<std::size_t>(std::ranges::max_element(sites) - sites.begin());
        const auto& [a, b, c] = cornersOfFace[latest];
        tetrahedra.push_back({sites[latest], slot, {sites[a], sites[b], sites[c]}});
    }
    std::ranges::stable_sort(tetrahedra, {}, &Born::creator);
    for (const std::uint32_t corner : corners) {
        starHistory_.clear();
        for (; tetrahedronCount_ < tetrahedra.size() && tetrahedra[tetrahedronCount_].creator == siteCount_;
             ++tetrahedronCount_) {
            const Born& born = tetrahedra[tetrahedronCount_];
            const Accuracy& accuracy = startAccuracies_[born.slot];
            slots_[born.slot].history = static_cast<std::uint32_t>(tetrahedronCount_);
            starHistory_.push_back({born.sites, accuracy.error, accuracy.warping});
        }
        if (Status status = sink.add({corner, std::numeric_limits<float>::infinity(), starHistory_, {}}); !status)
            return status;
        ++siteCount_;
    }
    return {};
}

} // namespace tetra
