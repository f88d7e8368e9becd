// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cells/cell_complex.h"
#include "core/cells/mending.h"

#include <cstdint>
#include <span>
#include <vector>

namespace tetra {

/// Cells whose numbers are sound and few kinds: voxels are hexahedra, triquadratic cells eight of them, what has no
/// value, no volume or no place in the domain is gone.
struct PreparedCells {
    std::vector<CellShape> shapes;
    std::vector<std::uint64_t> offsets{0}; ///< the nodes of cell c are nodes[offsets[c]] up to nodes[offsets[c + 1]]
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint64_t> origins; ///< the cell of the complex that each comes from

    std::size_t count() const { return shapes.size(); }
    std::span<const std::uint32_t> nodesOf(std::size_t cell) const
    {
        return std::span(nodes).subspan(offsets[cell], offsets[cell + 1] - offsets[cell]);
    }
};

/// Sorts out what irregularDataset() cannot use and joins points on one place. `mending` is told. Errors: BadInput for
/// arrays that do not fit together, numbers of points out of range, polyhedra, points of cells at places that are not
/// finite; OutOfResource for more points than 32 bits number.
Result<PreparedCells> prepareCells(const CellComplex& complex, const ComplexValues& values, Mending& mending);

/// Leaves out the nodes in the middle of edges where cells do not agree on them: all of them, so that the mesh
/// conforms. Returns whether there were such cells.
bool dropMiddlesIfMixed(PreparedCells& cells, Mending& mending);
/// Makes all cells linear.
void dropMiddles(PreparedCells& cells, Mending& mending);

} // namespace tetra
