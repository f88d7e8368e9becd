// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/data/cells/cell_split.h"
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/grid_cells.h"
#include "core/data/dataset_checks.h"

#include <tan/data.h>

#include <Eigen/Geometry>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

namespace tetra {

namespace {

Error noMesh(const Dataset& grid, Message why)
{
    return {ErrorKind::BadInput,
            Message::say("The grid '%1' cannot be used as a mesh: %2 Refine it instead.", grid.source.name, why)};
}

Status checkMemory(const Dataset& grid)
{
    const std::uint64_t bytes = bytesOfGridTetrahedron * tetrahedraOfGridCell * grid.lattice.cellCount();
    const std::uint64_t usable = usableBytes();
    if (usable == 0 || bytes <= usable)
        return {};
    return Error{
        ErrorKind::OutOfResource,
        Message::say("The grid has %1 cells, whose mesh takes up to %2 of memory, of %3. Refine it instead, or "
                     "take a region of it or fewer samples.",
                     grid.lattice.cellCount(), neededBytesText(bytes), neededBytesText(usable))};
}

/// For each point the first on its place; an error if two on one place have different values.
Result<std::vector<std::uint32_t>> firstOnPlaces(const Dataset& grid)
{
    std::vector<std::uint32_t> first = firstOnPlace(*grid.positions, std::vector<bool>(grid.positions->size(), true));
    std::uint64_t conflicting = 0;
    for (std::uint32_t point = 0; point < first.size(); ++point)
        conflicting += grid.values.at(point) != grid.values.at(first[point]) ? 1 : 0;
    if (conflicting > 0)
        return noMesh(grid, Message::say("%1 of its points lie at the same place as another and have another value.",
                                         conflicting));
    return first;
}

std::uint64_t countPlaces(const std::vector<std::uint32_t>& first)
{
    std::uint64_t places = 0;
    for (std::uint32_t point = 0; point < first.size(); ++point)
        places += first[point] == point ? 1 : 0;
    return places;
}

CellComplex hexahedraOf(const Dataset& grid)
{
    CellComplex complex;
    complex.mostFaulty = 0;
    complex.positions = *grid.positions;
    complex.shapes.assign(grid.lattice.cellCount(), CellShape::Hexahedron);
    complex.offsets.reserve(complex.shapes.size() + 1);
    complex.offsets.push_back(0);
    complex.corners.reserve(8 * complex.shapes.size());
    (void)forEachCell(grid, {}, [&](const auto& corners, GridCell) {
        complex.corners.insert(complex.corners.end(), corners.begin(), corners.end());
        complex.offsets.push_back(complex.corners.size());
    });
    return complex;
}

std::vector<double> valuesOf(const Dataset& grid)
{
    return visitSampleType(grid.values.type(), [&]<class T>() {
        const std::span<const T> samples = grid.values.as<T>();
        return std::vector<double>(samples.begin(), samples.end());
    });
}

Result<Dataset> meshOf(const Dataset& grid, const Progress& progress)
{
    const auto first = firstOnPlaces(grid);
    if (!first)
        return first.error();
    const std::uint64_t places = countPlaces(*first);
    Repairs repairs;
    repairs.ofGrid = true;
    auto mesh = irregularDatasetBeside(repairs, hexahedraOf(grid), {valuesOf(grid), false, grid.values.type()},
                                       grid.source, progress);
    if (!mesh && mesh.error().kind == ErrorKind::BadInput)
        return noMesh(grid, mesh.error().message);
    if (!mesh)
        return mesh;
    if (mesh->faultyCells)
        return noMesh(grid, Message::say("%1 of its cells are folded, overlap others, or are so warped that no "
                                         "tetrahedra fill them.",
                                         mesh->faultyCells->size()));
    if (mesh->pointCount() != places)
        return noMesh(
            grid, Message::say("%1 of its points belong only to cells without volume.", places - mesh->pointCount()));
    mesh->source = grid.source;
    mesh->space = grid.space;
    mesh->lengthUnit = grid.lengthUnit;
    mesh->remarks.insert(mesh->remarks.begin(), grid.remarks.begin(), grid.remarks.end());
    return mesh;
}

/// Whether the rule cuts each cell into tetrahedra that are certainly of the grid's hand. `first`: of each point on its
/// place.
bool isCutByTheRule(const Dataset& grid, const std::vector<std::uint32_t>& first, double hand)
{
    const auto& positions = *grid.positions;
    const auto isPositive = [&](const std::array<std::uint32_t, 4>& corners) {
        constexpr double rounding = 1e-12;
        const Eigen::Vector3d u = positions[corners[1]] - positions[corners[0]],
                              v = positions[corners[2]] - positions[corners[0]],
                              w = positions[corners[3]] - positions[corners[0]];
        return hand * u.dot(v.cross(w)) > rounding * u.norm() * v.norm() * w.norm();
    };
    const auto isCut = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k, CellPieces& pieces) {
        const auto corners = cornersOfCell(grid.lattice, false, grid.lattice.index(i, j, k));
        std::array<std::uint32_t, 8> nodes{};
        std::ranges::transform(corners, nodes.begin(), [&](std::uint64_t corner) { return first[corner]; });
        pieces.clear();
        splitCell(CellShape::Hexahedron, nodes, pieces);
        return std::ranges::all_of(pieces, isPositive);
    };
    const auto& size = grid.lattice.size;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, size[2] - 1), true,
        [&](const auto& layers, bool are) {
            CellPieces pieces;
            for (std::uint32_t k = layers.begin(); are && k != layers.end(); ++k)
                for (std::uint32_t j = 0; are && j + 1 < size[1]; ++j)
                    for (std::uint32_t i = 0; are && i + 1 < size[0]; ++i)
                        are = isCut(i, j, k, pieces);
            return are;
        },
        std::logical_and());
}

} // namespace

Result<Dataset> asMesh(const Dataset& grid, const Progress& progress)
{
    if (const Status fits = checkMemory(grid); !fits)
        return fits.error();
    return guarded(Message::marked("Not enough memory for the mesh. Take a part of it."),
                   [&] { return meshOf(grid, progress); });
}

Status checkAsMesh(const Dataset& grid)
{
    constexpr std::uint64_t mostPoints = 5'000'000; // for which decimation takes some ten minutes and 8 GB
    if (grid.pointCount() > mostPoints)
        return noMesh(grid, Message::say("it has %1 points, and the limit is %2.", grid.pointCount(), mostPoints));
    if (const Status fits = checkMemory(grid); !fits)
        return fits;
    const CellCornerSigns signs = cellCornerSigns(grid);
    if (const std::uint64_t folded = std::min(signs.positive, signs.negative); folded > 0)
        return noMesh(grid, Message::say("%1 corners of its cells are folded.", folded));
    const auto first = firstOnPlaces(grid);
    if (!first)
        return first.error();
    if (isCutByTheRule(grid, *first, signs.negative > 0 ? -1 : 1))
        return {};
    const auto mesh = asMesh(grid); // other cuts may do
    return mesh ? Status() : mesh.error();
}

} // namespace tetra
