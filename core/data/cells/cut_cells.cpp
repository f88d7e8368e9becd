// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/cut_cells.h"

#include "core/data/cells/cell_split.h"
#include "core/data/cells/polyhedron.h"
#include "core/data/cells/resplit_cells.h"
#include "core/geometry/orientation.h"
#include "core/mesh/face_adjacency.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace tetra {

namespace {

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
    Cutting(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, bool addsCentres, Repairs& repairs)
        : positions_(positions), cells_(cells), addsCentres_(addsCentres), repairs_(repairs)
    {
        result_.tetrahedra.reserve(cells.count());
        result_.cells.reserve(cells.count());
    }

    Status cutAll(const Progress& progress)
    {
        constexpr std::size_t cellsBetweenReports = 1 << 16;
        findTurned();
        for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
            if (cell % cellsBetweenReports == 0) {
                if (progress.cancelled())
                    return cancelledError(cuttingCells);
                progress.report(static_cast<double>(cell) / static_cast<double>(cells_.count()), cuttingCells);
            }
            // A polyhedron has fewer triangles than its faces have points.
            if (result_.tetrahedra.size() + cells_.facesOf(cell).size() > largestAdjacentCellCount - mostPieces ||
                positions_.size() + centres_.places.size() >= std::numeric_limits<std::uint32_t>::max() - 1)
                return Error{ErrorKind::OutOfResource,
                             Message::say("The cells yield more than %1 tetrahedra. Take a part of the mesh.",
                                          largestAdjacentCellCount - mostPieces)};
            if (cells_.shapes[cell] == CellShape::Polyhedron)
                cutPolyhedron(cell);
            else
                cut(cell);
        }
        return {};
    }

    Status resplit(const Progress& progress)
    {
        if (failing_.empty())
            return {};
        ResplitCells resplit = resplitCells(positions_, cells_, failing_, turned_, centres_, progress);
        if (progress.cancelled())
            return cancelledError(cuttingCells);
        for (const auto& [cell, pieces] : resplit.pieces)
            repairs_.resplit += cells_.shapes[cell] != CellShape::Polyhedron;
        removeOf(resplit.pieces);
        for (const auto& [cell, pieces] : resplit.pieces)
            for (const auto& piece : pieces)
                add(cell, piece);
        result_.warped = std::move(resplit.warped);
        return {};
    }
    CutCells take()
    {
        result_.centres = std::move(centres_.places);
        for (const auto& [cell, point] : centres_.numbers)
            result_.centreCells.push_back(cell); // polyhedra come in order
        for (const std::uint32_t cell : result_.warped)
            repairs_.polyhedra -= cells_.shapes[cell] == CellShape::Polyhedron;
        return std::move(result_);
    }

private:
    static constexpr std::size_t mostPieces = 32; // of one cell that is no polyhedron
    /// Of searches in polyhedra together, a few seconds' worth.
    static constexpr std::uint64_t mostPolyhedronSteps = 2'000'000;

    /// The quadrilaterals of polyhedra, which others may share, for which the diagonal of the rule is not good.
    void findTurned()
    {
        for (std::uint32_t cell = 0; cell < cells_.count(); ++cell)
            for (const CellPolygon& face : quadrilateralsOf(cells_.facesOf(cell)))
                if (needsOtherDiagonal(positions_, face))
                    turned_.insert(faceKey(face));
    }

    bool isTurned(const CellPolygon& face) const { return turned_.contains(faceKey(face)); }

    bool hasTurnedFace(CellShape shape, std::span<const std::uint32_t> nodes) const
    {
        return !turned_.empty() && std::ranges::any_of(quadrilateralsOf(shape, nodes),
                                                       [this](const CellPolygon& face) { return isTurned(face); });
    }

    void cutPolyhedron(std::uint32_t cell)
    {
        const auto turned = [this](const CellPolygon& face) { return isTurned(face); };
        const PolyhedronSurface surface =
            polyhedronSurface(positions_, cells_.facesOf(cell), turned_.empty() ? OtherDiagonal() : turned);
        if (surface.kind == PolyhedronSurface::Kind::Open) {
            result_.open.push_back(cell);
            return;
        }
        if (surface.kind == PolyhedronSurface::Kind::Flat) {
            ++repairs_.flat;
            repairs_.faulty.push_back({cells_.origins[cell], CellFault::NoVolume});
            return;
        }
        ++repairs_.cells;
        ++repairs_.polyhedra;
        const auto corners = cells_.nodesOf(cell);
        auto pieces = addsCentres_ ? cutFromCorner(positions_, corners, surface.triangles)
                                   : cutAlone(positions_, corners, surface.triangles, stepsLeft_);
        if (!pieces && addsCentres_)
            if (const auto centre = pointInside(positions_, corners, surface.triangles)) {
                const auto number = static_cast<std::uint32_t>(positions_.size() + centres_.places.size());
                centres_.places.push_back(*centre);
                centres_.numbers.emplace(cell, number);
                pieces = cutFromPoint(surface.triangles, number);
            }
        if (!pieces) {
            failing_.push_back(cell);
            return;
        }
        for (const auto& piece : *pieces)
            add(cell, piece);
    }

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
        if (std::max(positive, negative) < pieces_.size() || hasTurnedFace(shape, nodes)) {
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
    bool addsCentres_;
    Repairs& repairs_;
    CellPieces pieces_;
    std::set<FaceKey> turned_;
    CellCentres centres_;
    std::uint64_t stepsLeft_ = mostPolyhedronSteps;
    std::vector<std::uint32_t> failing_;
    CutCells result_;
};

} // namespace

Result<CutCells> cutCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells, bool addsCentres,
                          Repairs& repairs, const Progress& progress)
{
    Cutting cutting(positions, cells, addsCentres, repairs);
    if (const Status cut = cutting.cutAll(progress); !cut)
        return cut.error();
    if (const Status resplit = cutting.resplit(progress); !resplit)
        return resplit.error();
    return cutting.take();
}

} // namespace tetra
