// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/spatial_order.h"

#include "core/base/guarded.h"
#include "core/geometry/hilbert_order.h"
#include "core/mesh/topology.h"

#include <tan/mesh.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr MarkedText orderingMesh = Message::marked("Ordering the mesh");
constexpr std::size_t cellsOrderedAtOnce = std::size_t(1) << 14;

std::uint32_t smallestOf(const Tetrahedron& cell) noexcept
{
    return std::min(std::min(cell[0], cell[1]), std::min(cell[2], cell[3]));
}

/// Moves positions and values to their order; returns the new number of each old vertex.
Buffer<std::uint32_t> orderVertices(const TetrahedralMesh& mesh, TetrahedralMesh& ordered, const Progress& progress)
{
    const std::size_t count = mesh.positions.size();
    Buffer<KeyedIndex> keys = spatialKeys(mesh.positions);
    radixSort(keys, spatialKeyBits, progress);
    Buffer<std::uint32_t> numbers(count);
    ordered.positions.resize(count);
    ordered.values.resize(count);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, cellsOrderedAtOnce), [&](const auto& range) {
        for (std::size_t v = range.begin(); v != range.end(); ++v) {
            const std::uint32_t old = keys[v].index;
            numbers[old] = static_cast<std::uint32_t>(v);
            ordered.positions[v] = mesh.positions[old];
            ordered.values[v] = mesh.values[old];
        }
    });
    return numbers;
}

/// The tetrahedra by their smallest vertex: dealt to parts that each have a run of vertices and fit the cache, then
/// ordered inside each.
class CellDeal {
public:
    CellDeal(std::size_t vertexCount, std::size_t cellCount)
        : vertexCount_(vertexCount), blockSize_(std::max(smallestBlock, (cellCount + mostBlocks - 1) / mostBlocks)),
          cells_(cellCount)
    {
        constexpr int mostPartBits = 11;
        const int bits = static_cast<int>(std::bit_width(std::max<std::size_t>(vertexCount, 1) - 1));
        partShift_ = std::max(bits - mostPartBits, 4);
        partCount_ = (vertexCount >> partShift_) + 1;
        places_.resize((cellCount + blockSize_ - 1) / blockSize_);
    }

    /// Takes the renumbered tetrahedra; false if a corner does not exist.
    bool take(std::span<const Tetrahedron> old, const Buffer<std::uint32_t>& numbers, const Progress& progress)
    {
        std::atomic<bool> valid = true;
        tbb::parallel_for(std::size_t(0), places_.size(), [&](std::size_t block) {
            places_[block].assign(partCount_, 0);
            if (progress.cancelled())
                return;
            for (std::size_t i = block * blockSize_; i < endOf(block); ++i) {
                Tetrahedron& cell = cells_[i];
                for (std::size_t corner = 0; corner < 4; ++corner) {
                    const std::uint32_t vertex = old[i][corner];
                    if (vertex >= vertexCount_) {
                        valid = false;
                        return;
                    }
                    cell[corner] = numbers[vertex];
                }
                ++places_[block][smallestOf(cell) >> partShift_];
            }
        });
        return valid;
    }

    void deal(Buffer<Tetrahedron>& dealt, const Progress& progress)
    {
        dealt.resize(cells_.size());
        const std::vector<std::size_t> first = placesFromCounts();
        tbb::parallel_for(std::size_t(0), places_.size(), [&](std::size_t block) {
            if (progress.cancelled())
                return;
            for (std::size_t i = block * blockSize_; i < endOf(block); ++i)
                dealt[places_[block][smallestOf(cells_[i]) >> partShift_]++] = cells_[i];
        });
        tbb::parallel_for(tbb::blocked_range<std::size_t>(0, partCount_), [&](const auto& range) {
            std::vector<std::size_t> places;
            for (std::size_t part = range.begin(); part != range.end() && !progress.cancelled(); ++part)
                orderPart(std::span(dealt).subspan(first[part], first[part + 1] - first[part]), first[part], places);
        });
    }

private:
    static constexpr std::size_t smallestBlock = std::size_t(1) << 15;
    static constexpr std::size_t mostBlocks = 64;

    std::size_t endOf(std::size_t block) const { return std::min(cells_.size(), (block + 1) * blockSize_); }

    std::vector<std::size_t> placesFromCounts()
    {
        std::vector<std::size_t> first(partCount_ + 1, 0);
        for (std::size_t part = 0; part < partCount_; ++part) {
            std::size_t place = first[part];
            for (auto& block : places_)
                place += std::exchange(block[part], place);
            first[part + 1] = place;
        }
        return first;
    }

    /// What was taken is not needed any more: its memory, from `first` on, takes the copy.
    void orderPart(std::span<Tetrahedron> part, std::size_t first, std::vector<std::size_t>& places)
    {
        const std::span copy = std::span(cells_).subspan(first, part.size());
        std::ranges::copy(part, copy.begin());
        const std::uint32_t mask = (1u << partShift_) - 1;
        places.assign(std::size_t(mask) + 1, 0);
        for (const Tetrahedron& cell : copy)
            ++places[smallestOf(cell) & mask];
        std::size_t place = 0;
        for (std::size_t& of : places)
            place += std::exchange(of, place);
        for (const Tetrahedron& cell : copy)
            part[places[smallestOf(cell) & mask]++] = cell;
    }

    std::size_t vertexCount_;
    std::size_t blockSize_;
    int partShift_ = 0;
    std::size_t partCount_ = 0;
    Buffer<Tetrahedron> cells_;
    std::vector<std::vector<std::size_t>> places_; ///< for each block and part
};

Result<TetrahedralMesh> order(const TetrahedralMesh& mesh, const Progress& progress)
{
    progress.report(0, orderingMesh);
    TetrahedralMesh ordered;
    const Buffer<std::uint32_t> numbers = orderVertices(mesh, ordered, progress);
    if (progress.cancelled())
        return cancelledError(orderingMesh);
    progress.report(0.3, orderingMesh);
    CellDeal deal(mesh.positions.size(), mesh.tetrahedra.size());
    if (!deal.take(mesh.tetrahedra, numbers, progress))
        return Error{ErrorKind::WrongUsage, Message::say("A tetrahedron has a corner that does not exist.")};
    progress.report(0.6, orderingMesh);
    deal.deal(ordered.tetrahedra, progress);
    if (progress.cancelled())
        return cancelledError(orderingMesh);
    progress.report(1, orderingMesh);
    return ordered;
}

ChunkRange rangeOf(const TetrahedralMesh& mesh, std::size_t first, std::size_t end)
{
    constexpr float none = -std::numeric_limits<float>::infinity();
    // One for each corner: they need not wait for one another.
    std::array<ChunkRange, 4> ranges;
    ranges.fill({-none, none});
    for (std::size_t t = first; t < end; ++t)
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const float value = mesh.values[mesh.tetrahedra[t][corner]];
            const float known = value >= none ? value : none; // not if NaN
            ranges[corner].smallest = std::min(ranges[corner].smallest, known);
            ranges[corner].largest = std::max(ranges[corner].largest, known);
        }
    ChunkRange all = ranges[0];
    for (const ChunkRange& range : ranges)
        all = {std::min(all.smallest, range.smallest), std::max(all.largest, range.largest)};
    return all;
}

} // namespace

Result<TetrahedralMesh> inSpatialOrder(const TetrahedralMesh& mesh, const Progress& progress)
{
    if (mesh.values.size() != mesh.positions.size())
        return Error{ErrorKind::WrongUsage, Message::say("The mesh and its values do not belong together.")};
    return guarded(
        Message::marked(
            "Not enough memory to put the mesh in spatial order. Close other programs or lower the accuracy of "
            "the mesh."),
        [&] { return order(mesh, progress); });
}

Buffer<ChunkRange> chunkRanges(const TetrahedralMesh& mesh)
{
    const std::size_t total = mesh.tetrahedra.size();
    Buffer<ChunkRange> ranges((total + rangedChunkSize - 1) / rangedChunkSize);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, ranges.size(), 16), [&](const auto& chunks) {
        for (std::size_t c = chunks.begin(); c != chunks.end(); ++c)
            ranges[c] = rangeOf(mesh, c * rangedChunkSize, std::min(total, (c + 1) * rangedChunkSize));
    });
    return ranges;
}

Result<std::shared_ptr<const TetrahedralMesh>> OrderedMesh::ordered(const Progress& progress)
{
    if (!ordered_) {
        auto made = inSpatialOrder(*original_, progress);
        if (!made)
            return made.error();
        ordered_ = std::make_shared<const TetrahedralMesh>(*std::move(made));
    }
    return ordered_;
}

} // namespace tetra
