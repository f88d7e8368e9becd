// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/guarded.h"
#include "core/data/cells/clean_cells.h"
#include "core/data/cells/grid_cells.h"
#include "core/data/dataset_checks.h"

#include <tan/data.h>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace tetra {

namespace {

constexpr std::uint32_t notUsed = std::numeric_limits<std::uint32_t>::max();

/// What is left of a grid: how many cells, and the numbers that its points have in the mesh.
struct Left {
    std::uint64_t cells = 0;
    std::uint32_t points = 0;
    std::vector<std::uint32_t> numbers; ///< notUsed for points that are left out
    Repairs holes;
};

Error tooLarge(std::uint64_t tetrahedra, std::uint64_t bytes)
{
    return {ErrorKind::OutOfResource,
            Message::say("It has holes, points that are blanked out or without a finite value, which make it an "
                         "irregular mesh: up to %1 tetrahedra, which take %2 of memory, of %3. Take a region or every "
                         "n-th point of it, or replace those values with numbers.",
                         tetrahedra, neededBytesText(bytes), neededBytesText(usableBytes()))};
}

/// Refuses what cannot fit before much memory is taken.
Result<Left> findLeft(const Dataset& grid, const Progress& progress)
{
    Left left;
    left.holes.ofGrid = true;
    const Status counted = forEachCell(grid, progress.part(0, 0.5), [&](const auto& /*corners*/, GridCell what) {
        left.cells += what == GridCell::Kept;
        left.holes.blanked += what == GridCell::Blanked;
        left.holes.notFinite += what == GridCell::NotFinite;
    });
    if (!counted)
        return counted.error();
    if (left.cells == 0)
        return Error{ErrorKind::BadInput, Message::say("No cell of the grid has a finite value at each of its corners, "
                                                       "or all are blanked out: nothing is left.")};
    const std::uint64_t tetrahedra = tetrahedraOfGridCell * left.cells;
    const std::uint64_t bytes = bytesOfGridTetrahedron * tetrahedra + sizeof(std::uint32_t) * grid.pointCount();
    if (const std::uint64_t usable = usableBytes(); usable > 0 && bytes > usable)
        return tooLarge(tetrahedra, bytes);
    left.numbers.assign(grid.pointCount(), notUsed);
    const Status marked = forEachCell(grid, progress.part(0.5, 1), [&](const auto& corners, GridCell what) {
        if (what == GridCell::Kept)
            for (const std::uint64_t corner : corners)
                left.numbers[corner] = 0;
    });
    for (std::uint32_t& number : left.numbers)
        if (number == 0)
            number = left.points++;
    return marked ? Result<Left>(std::move(left)) : marked.error();
}

CellComplex hexahedraOf(const Dataset& grid, const Left& left, std::vector<double>& values)
{
    CellComplex complex;
    complex.positions.reserve(left.points);
    values.reserve(left.points);
    for (std::uint64_t point = 0; point < left.numbers.size(); ++point)
        if (left.numbers[point] != notUsed) {
            complex.positions.push_back(grid.position(point));
            values.push_back(grid.values.at(point));
        }
    complex.shapes.assign(left.cells, CellShape::Hexahedron);
    complex.offsets.reserve(left.cells + 1);
    complex.offsets.push_back(0);
    complex.corners.reserve(8 * left.cells);
    (void)forEachCell(grid, {}, [&](const auto& corners, GridCell what) {
        if (what != GridCell::Kept)
            return;
        for (const std::uint64_t corner : corners)
            complex.corners.push_back(left.numbers[corner]);
        complex.offsets.push_back(complex.corners.size());
    });
    return complex;
}

/// The same by the grid's numbers of cells in place of those of the cells that are left.
std::shared_ptr<const std::vector<FaultyCell>> byCellsOfGrid(const Dataset& grid, std::vector<FaultyCell> faulty)
{
    std::uint64_t cell = 0, kept = 0;
    auto next = faulty.begin();
    (void)forEachCell(grid, {}, [&](const auto& /*corners*/, GridCell what) {
        if (what == GridCell::Kept && next != faulty.end() && next->cell == kept++)
            (next++)->cell = cell;
        ++cell;
    });
    return std::make_shared<const std::vector<FaultyCell>>(std::move(faulty));
}

Message remarkOn(const Dataset& grid, const Left& left)
{
    const Message irregular = Message::say("The grid has become an irregular mesh with holes.");
    const std::uint64_t lost = grid.pointCount() - left.points;
    return lost == 0
               ? irregular
               : Message::say("%1 Left out with the cells around them: %2 of its %3 points, blanked out or without "
                              "a finite value.",
                              irregular, lost, grid.pointCount());
}

Result<Dataset> makeHoles(const Dataset& grid, const Progress& progress)
{
    if (grid.cells && grid.cells->size() != grid.lattice.cellCount())
        return Error{ErrorKind::BadInput,
                     Message::say("It has blanking flags for %1 cells, but %2 cells. It is damaged.",
                                  grid.cells->size(), grid.lattice.cellCount())};
    constexpr double searched = 0.2;
    const auto left = findLeft(grid, progress.part(0, searched));
    if (!left)
        return left.error();
    std::vector<double> values;
    const CellComplex complex = hexahedraOf(grid, *left, values);
    if (const Status intact = grid.checkIntact(); !intact)
        return intact.error();
    auto dataset = irregularDatasetBeside(left->holes, complex, {std::move(values), false, grid.values.type()},
                                          grid.source, progress.part(searched, 1));
    if (!dataset)
        return dataset.error();
    dataset->space = grid.space;
    dataset->lengthUnit = grid.lengthUnit;
    if (dataset->faultyCells)
        dataset->faultyCells = byCellsOfGrid(grid, *dataset->faultyCells);
    std::vector<Message> remarks = grid.remarks;
    remarks.push_back(remarkOn(grid, *left));
    dataset->remarks.insert(dataset->remarks.begin(), remarks.begin(), remarks.end());
    return dataset;
}

} // namespace

bool hasHoles(const Dataset& grid) noexcept
{
    return isOnLattice(grid.domain) && (grid.cells || grid.values.notFiniteCount() > 0);
}

Result<Dataset> withHoles(const Dataset& grid, const Progress& progress)
{
    if (!hasHoles(grid))
        return grid;
    return guarded(Message::marked("Not enough memory for the mesh. Take a part of it."),
                   [&] { return makeHoles(grid, progress); });
}

} // namespace tetra
