// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/cut_cells.h"

#include "core/data/cells/cell_split.h"
#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tetra {

namespace {

/// New pieces of some cells.
struct ResplitCells {
    std::map<std::uint32_t, CellPieces> pieces; ///< by cell: those that the rule of splitCell() failed on that have a
                                                ///< cut after all, and neighbours that followed a turned diagonal
    std::vector<std::uint32_t> warped;          ///< those that have none
};

/// Of all searches together, a few seconds' worth. A warped cell takes some dozens of steps, so that meshes that can be
/// repaired are; a mesh of garbage is given up.
constexpr std::uint64_t mostResplittingSteps = 1'000'000;

using FaceKey = std::array<std::uint32_t, 4>;

FaceKey keyOf(const CellPolygon& quadrilateral)
{
    FaceKey key = quadrilateral.nodes;
    std::ranges::sort(key);
    return key;
}

class Resplitting {
public:
    Resplitting(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                const std::vector<std::uint32_t>& failing)
        : positions_(positions), cells_(cells), failing_(failing)
    {
    }

    ResplitCells run(const Progress& progress)
    {
        findNeighbours();
        // What a turned diagonal does to a neighbour may let that be repaired, too.
        for (bool progressed = true; progressed;) {
            progressed = false;
            for (const std::uint32_t cell : failing_) {
                if (progress.cancelled() || stepsLeft_ == 0)
                    break;
                if (!result_.pieces.contains(cell))
                    progressed = repair(cell) || progressed;
            }
        }
        for (const std::uint32_t cell : failing_)
            if (!result_.pieces.contains(cell))
                result_.warped.push_back(cell);
        return std::move(result_);
    }

private:
    void findNeighbours()
    {
        for (const std::uint32_t cell : failing_)
            for (const CellPolygon& face : quadrilateralsOf(cells_.shapes[cell], cells_.nodesOf(cell)))
                sides_[keyOf(face)];
        if (sides_.empty())
            return;
        std::set<std::uint32_t> corners;
        for (const auto& [key, cells] : sides_)
            corners.insert(key[0]);
        for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
            const auto nodes = cells_.nodesOf(cell);
            if (std::ranges::none_of(nodes, [&](std::uint32_t node) { return corners.contains(node); }))
                continue;
            for (const CellPolygon& face : quadrilateralsOf(cells_.shapes[cell], nodes))
                if (const auto found = sides_.find(keyOf(face)); found != sides_.end())
                    found->second.push_back(cell);
        }
    }

    /// A cut with the diagonals as they are turned now.
    std::optional<CellPieces> cut(std::uint32_t cell)
    {
        CellSurface surface;
        const auto turned = [&](const CellPolygon& face) { return turned_.contains(keyOf(face)); };
        cellSurface(cells_.shapes[cell], cells_.nodesOf(cell), turned, surface);
        double volume = 0;
        for (const auto& [a, b, c] : surface)
            volume +=
                (positions_[a] - positions_[surface[0][0]])
                    .dot((positions_[b] - positions_[surface[0][0]]).cross(positions_[c] - positions_[surface[0][0]]));
        if (volume < 0)
            for (auto& triangle : surface)
                std::swap(triangle[1], triangle[2]);
        return fillCavity(positions_, surface, stepsLeft_);
    }

    void turn(const std::vector<CellPolygon>& faces, std::uint32_t mask)
    {
        for (std::size_t face = 0; face < faces.size(); ++face)
            if ((mask >> face & 1) != 0) {
                const FaceKey key = keyOf(faces[face]);
                if (turned_.erase(key) == 0)
                    turned_.insert(key);
            }
    }

    bool repair(std::uint32_t cell)
    {
        const std::vector<CellPolygon> faces = quadrilateralsOf(cells_.shapes[cell], cells_.nodesOf(cell));
        std::vector<std::uint32_t> masks(std::size_t(1) << faces.size());
        for (std::uint32_t mask = 0; mask < masks.size(); ++mask)
            masks[mask] = mask;
        std::ranges::stable_sort(masks, {}, [](std::uint32_t mask) { return std::popcount(mask); });
        for (const std::uint32_t mask : masks) {
            turn(faces, mask);
            if (tryNow(cell, faces, mask))
                return true;
            turn(faces, mask);
        }
        return false;
    }

    bool tryNow(std::uint32_t cell, const std::vector<CellPolygon>& faces, std::uint32_t mask)
    {
        std::map<std::uint32_t, CellPieces> pieces;
        const auto take = [&](std::uint32_t which) {
            auto found = cut(which);
            if (found)
                pieces[which] = *std::move(found);
            return pieces.contains(which);
        };
        if (!take(cell))
            return false;
        for (std::size_t face = 0; face < faces.size(); ++face)
            if ((mask >> face & 1) != 0)
                for (const std::uint32_t neighbour : sides_[keyOf(faces[face])])
                    if (!pieces.contains(neighbour) && !take(neighbour) && !stillFailing(neighbour))
                        return false;
        for (auto& [which, found] : pieces)
            result_.pieces[which] = std::move(found);
        return true;
    }

    bool stillFailing(std::uint32_t cell) const
    {
        return std::ranges::binary_search(failing_, cell) && !result_.pieces.contains(cell);
    }

    std::span<const Eigen::Vector3d> positions_;
    const CleanCells& cells_;
    const std::vector<std::uint32_t>& failing_;
    std::map<FaceKey, std::vector<std::uint32_t>> sides_;
    std::set<FaceKey> turned_;
    std::uint64_t stepsLeft_ = mostResplittingSteps;
    ResplitCells result_;
};

/// Looks for other cuts of `failing` cells, sorted: first inside, then with diagonals of their quadrilateral faces
/// turned, as few as possible, as long as the cells beyond these faces still have a cut. Greedy: each cell that was
/// repaired stays repaired. O(cells) to find the neighbours; the search ends after a million steps, and what is not
/// repaired then counts as warped. So does what is left when it is cancelled.
ResplitCells resplitCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                          const std::vector<std::uint32_t>& failing, const Progress& progress)
{
    return Resplitting(positions, cells, failing).run(progress);
}

constexpr MarkedText cuttingCells = Message::marked("Cutting the cells");

bool repeatsCorner(CellShape shape, std::span<const std::uint32_t> nodes)
{
    std::vector<std::uint32_t> corners(nodes.begin(), nodes.begin() + cellTopology(shape).cornerCount);
    std::ranges::sort(corners);
    return std::ranges::adjacent_find(corners) != corners.end();
}

/// VTK numbers a prism with the first triangle's normal outwards, others inwards: neither order is turned over.
bool countsAsTurned(CellShape shape)
{
    return shape != CellShape::Prism && shape != CellShape::QuadraticPrism;
}

class Cutting {
public:
    Cutting(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, Repairs& repairs)
        : positions_(positions), cells_(cells), repairs_(repairs)
    {
        result_.tetrahedra.reserve(cells.count());
        result_.cells.reserve(cells.count());
    }

    Status cutAll(const Progress& progress)
    {
        constexpr std::size_t cellsBetweenReports = 1 << 16;
        for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
            if (cell % cellsBetweenReports == 0) {
                if (progress.cancelled())
                    return cancelledError(cuttingCells);
                progress.report(static_cast<double>(cell) / static_cast<double>(cells_.count()), cuttingCells);
            }
            if (result_.tetrahedra.size() > largestAdjacentCellCount - mostPieces)
                return Error{ErrorKind::OutOfResource,
                             Message::say("The cells make more than %1 tetrahedra. Take a part of the mesh.",
                                          largestAdjacentCellCount - mostPieces)};
            cut(cell);
        }
        return {};
    }

    Status resplit(const Progress& progress)
    {
        if (failing_.empty())
            return {};
        ResplitCells resplit = resplitCells(positions_, cells_, failing_, progress);
        if (progress.cancelled())
            return cancelledError(cuttingCells);
        repairs_.resplit += resplit.pieces.size();
        removeOf(resplit.pieces);
        for (const auto& [cell, pieces] : resplit.pieces)
            for (const auto& piece : pieces)
                add(cell, piece);
        result_.warped = std::move(resplit.warped);
        return {};
    }
    CutCells take() { return std::move(result_); }

private:
    static constexpr std::size_t mostPieces = 32; // of one cell

    void cut(std::uint32_t cell)
    {
        const CellShape shape = cells_.shapes[cell];
        const auto nodes = cells_.nodesOf(cell);
        pieces_.clear();
        splitCell(shape, nodes, pieces_);
        std::size_t positive = 0, negative = 0;
        for (auto& piece : pieces_) {
            const int sign = orientation(positions_, piece);
            positive += sign > 0;
            negative += sign < 0;
            if (sign < 0)
                std::swap(piece[0], piece[1]);
        }
        if (positive + negative == 0) {
            ++(repeatsCorner(shape, nodes) ? repairs_.repeated : repairs_.flat);
            repairs_.faulty.push_back({cells_.origins[cell], CellFault::NoVolume});
            return;
        }
        if (countsAsTurned(shape))
            repairs_.turned += negative > positive;
        ++repairs_.cells;
        if (std::max(positive, negative) < pieces_.size()) {
            failing_.push_back(cell);
            return;
        }
        for (const auto& piece : pieces_)
            add(cell, piece);
    }

    void add(std::uint32_t cell, const std::array<std::uint32_t, 4>& piece)
    {
        result_.tetrahedra.push_back(piece);
        result_.cells.push_back(cell);
    }

    void removeOf(const std::map<std::uint32_t, CellPieces>& resplit)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < result_.cells.size(); ++i)
            if (!resplit.contains(result_.cells[i])) {
                result_.cells[kept] = result_.cells[i];
                result_.tetrahedra[kept++] = result_.tetrahedra[i];
            }
        result_.cells.resize(kept);
        result_.tetrahedra.resize(kept);
    }

    std::span<const Eigen::Vector3d> positions_;
    const CleanCells& cells_;
    Repairs& repairs_;
    CellPieces pieces_;
    std::vector<std::uint32_t> failing_;
    CutCells result_;
};

} // namespace

Result<CutCells> cutCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, Repairs& repairs,
                          const Progress& progress)
{
    Cutting cutting(positions, cells, repairs);
    if (const Status cut = cutting.cutAll(progress); !cut)
        return cut.error();
    if (const Status resplit = cutting.resplit(progress); !resplit)
        return resplit.error();
    return cutting.take();
}

} // namespace tetra
