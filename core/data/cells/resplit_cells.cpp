// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/cells/resplit_cells.h"

#include "core/data/cells/polyhedron.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <utility>

namespace tetra {

FaceKey faceKey(const CellPolygon& quadrilateral)
{
    FaceKey key = quadrilateral.nodes;
    std::ranges::sort(key);
    return key;
}

std::vector<CellPolygon> quadrilateralsOf(const CleanCells& cells, std::uint32_t cell)
{
    return cells.shapes[cell] == CellShape::Polyhedron ? quadrilateralsOf(cells.facesOf(cell))
                                                       : quadrilateralsOf(cells.shapes[cell], cells.nodesOf(cell));
}

std::optional<CellPieces> cutAlone(std::span<const Eigen::Vector3d> positions, std::span<const std::uint32_t> corners,
                                   const CellSurface& surface, std::uint64_t& stepsLeft)
{
    constexpr std::size_t mostTriangles = 200; // a step takes as long as there are triangles
    stepsLeft -= std::min<std::uint64_t>(stepsLeft, corners.size());
    if (auto pieces = cutFromCorner(positions, corners, surface))
        return pieces;
    return surface.size() <= mostTriangles ? fillCavity(positions, surface, stepsLeft) : std::nullopt;
}

namespace {

/// Of all searches together, a few seconds' worth. A warped cell takes some dozens of steps, so that meshes that can be
/// repaired are; a mesh of garbage is given up.
constexpr std::uint64_t mostResplittingSteps = 1'000'000;

/// Which of so many quadrilaterals are turned at once, as bits, few of them first: all sets of a hexahedron's, of cells
/// with more none or one.
std::vector<std::uint64_t> masksOf(std::size_t quadrilaterals)
{
    constexpr std::size_t ofHexahedron = 6, mostBits = 63;
    std::vector<std::uint64_t> masks;
    if (quadrilaterals > ofHexahedron) {
        masks.push_back(0);
        for (std::size_t bit = 0; bit < std::min(quadrilaterals, mostBits); ++bit)
            masks.push_back(std::uint64_t(1) << bit);
        return masks;
    }
    for (std::uint64_t mask = 0; mask < std::uint64_t(1) << quadrilaterals; ++mask)
        masks.push_back(mask);
    std::ranges::stable_sort(masks, {}, [](std::uint64_t mask) { return std::popcount(mask); });
    return masks;
}

class Resplitting {
public:
    Resplitting(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                const std::vector<std::uint32_t>& failing, const std::set<FaceKey>& turned, const CellCentres& centres)
        : positions_(positions), cells_(cells), failing_(failing), turned_(turned), centres_(centres)
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
            for (const CellPolygon& face : quadrilateralsOf(cells_, cell))
                sides_[faceKey(face)];
        if (sides_.empty())
            return;
        std::set<std::uint32_t> corners;
        for (const auto& [key, cells] : sides_)
            corners.insert(key[0]);
        for (std::uint32_t cell = 0; cell < cells_.count(); ++cell) {
            const auto nodes = cells_.nodesOf(cell);
            if (std::ranges::none_of(nodes, [&](std::uint32_t node) { return corners.contains(node); }))
                continue;
            for (const CellPolygon& face : quadrilateralsOf(cells_, cell))
                if (const auto found = sides_.find(faceKey(face)); found != sides_.end())
                    found->second.push_back(cell);
        }
    }

    /// A cut with the diagonals as they are turned now.
    std::optional<CellPieces> cut(std::uint32_t cell)
    {
        const auto turned = [&](const CellPolygon& face) { return turned_.contains(faceKey(face)); };
        if (cells_.shapes[cell] == CellShape::Polyhedron) {
            const PolyhedronSurface faces = polyhedronSurface(positions_, cells_.facesOf(cell), turned);
            return faces.kind == PolyhedronSurface::Kind::Closed ? cutPolyhedron(cell, faces.triangles) : CellPieces();
        }
        CellSurface surface;
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

    /// One that has a point in its middle keeps it.
    std::optional<CellPieces> cutPolyhedron(std::uint32_t cell, const CellSurface& surface)
    {
        const auto centre = centres_.numbers.find(cell);
        if (centre == centres_.numbers.end())
            return cutAlone(positions_, cells_.nodesOf(cell), surface, stepsLeft_);
        const std::size_t point = centre->second - positions_.size();
        return seesAll(positions_, surface, centres_.places[point])
                   ? std::optional(cutFromPoint(surface, centre->second))
                   : std::nullopt;
    }

    void turn(const std::vector<CellPolygon>& faces, std::uint64_t mask)
    {
        for (std::size_t face = 0; face < std::min<std::size_t>(faces.size(), 64); ++face)
            if ((mask >> face & 1) != 0) {
                const FaceKey key = faceKey(faces[face]);
                if (turned_.erase(key) == 0)
                    turned_.insert(key);
            }
    }

    bool repair(std::uint32_t cell)
    {
        const std::vector<CellPolygon> faces = quadrilateralsOf(cells_, cell);
        for (const std::uint64_t mask : masksOf(faces.size())) {
            turn(faces, mask);
            if (tryNow(cell, faces, mask))
                return true;
            turn(faces, mask);
        }
        return false;
    }

    bool tryNow(std::uint32_t cell, const std::vector<CellPolygon>& faces, std::uint64_t mask)
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
        for (std::size_t face = 0; face < std::min<std::size_t>(faces.size(), 64); ++face)
            if ((mask >> face & 1) != 0)
                for (const std::uint32_t neighbour : sides_[faceKey(faces[face])])
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
    const CellCentres& centres_;
    std::uint64_t stepsLeft_ = mostResplittingSteps;
    ResplitCells result_;
};

} // namespace

ResplitCells resplitCells(std::span<const Eigen::Vector3d> positions, const CleanCells& cells,
                          const std::vector<std::uint32_t>& failing, const std::set<FaceKey>& turned,
                          const CellCentres& centres, const Progress& progress)
{
    return Resplitting(positions, cells, failing, turned, centres).run(progress);
}

} // namespace tetra
