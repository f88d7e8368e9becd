// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/cut_cells.h"

#include "core/cells/cell_orientation.h"
#include "core/cells/recutting.h"
#include "core/mesh/face_adjacency.h"

#include <algorithm>
#include <utility>

namespace tetra {

namespace {

constexpr std::string_view cuttingCells = "Cutting the cells";

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
    Cutting(std::span<const Eigen::Vector3d> positions, const PreparedCells& cells, Mending& mending)
        : positions_(positions), cells_(cells), mending_(mending)
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
                return Error{ErrorKind::OutOfResource, "The cells make more than " +
                                                           std::to_string(largestAdjacentCellCount - mostPieces) +
                                                           " tetrahedra. Take a part of the mesh."};
            cut(cell);
        }
        return {};
    }

    Status recut(const Progress& progress)
    {
        if (failing_.empty())
            return {};
        RecutCells recut = recutCells(positions_, cells_, failing_, progress);
        if (progress.cancelled())
            return cancelledError(cuttingCells);
        mending_.recut += recut.pieces.size();
        removeOf(recut.pieces);
        for (const auto& [cell, pieces] : recut.pieces)
            for (const auto& piece : pieces)
                add(cell, piece);
        result_.warped = std::move(recut.warped);
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
            ++(repeatsCorner(shape, nodes) ? mending_.repeated : mending_.flat);
            return;
        }
        if (countsAsTurned(shape))
            mending_.turned += negative > positive;
        ++mending_.cells;
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

    void removeOf(const std::map<std::uint32_t, CellPieces>& recut)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < result_.cells.size(); ++i)
            if (!recut.contains(result_.cells[i])) {
                result_.cells[kept] = result_.cells[i];
                result_.tetrahedra[kept++] = result_.tetrahedra[i];
            }
        result_.cells.resize(kept);
        result_.tetrahedra.resize(kept);
    }

    std::span<const Eigen::Vector3d> positions_;
    const PreparedCells& cells_;
    Mending& mending_;
    CellPieces pieces_;
    std::vector<std::uint32_t> failing_;
    CutCells result_;
};

} // namespace

Result<CutCells> cutCells(std::span<const Eigen::Vector3d> positions, const PreparedCells& cells, Mending& mending,
                          const Progress& progress)
{
    Cutting cutting(positions, cells, mending);
    if (const Status cut = cutting.cutAll(progress); !cut)
        return cut.error();
    if (const Status recut = cutting.recut(progress); !recut)
        return recut.error();
    return cutting.take();
}

} // namespace tetra
