// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>
#include <tan/data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace tetra {

/// The corners of the cell with the lowest corner `point`, as a hexahedron's, which in a mirrored frame stands on its
/// head.
inline std::array<std::uint64_t, 8> cornersOfCell(const Lattice& lattice, bool isMirrored, std::uint64_t point)
{
    const std::uint64_t row = lattice.size[0], layer = row * lattice.size[1];
    std::uint64_t above = point + layer;
    if (isMirrored)
        std::swap(point, above);
    return {point, point + 1, point + row + 1, point + row, above, above + 1, above + row + 1, above + row};
}

inline bool areFinite(const ScalarField& values, std::span<const std::uint64_t> points)
{
    return isInteger(values.type()) ||
           std::ranges::all_of(points, [&](std::uint64_t point) { return std::isfinite(values.at(point)); });
}

/// Calls `visit(corners, what)` for each cell of a grid, the first index running fastest; `what` is a GridCell,
/// NotFinite where a corner has no finite value. Error: cancelled.
template <class Visit> Status forEachCell(const Dataset& grid, const Progress& progress, const Visit& visit)
{
    const auto& size = grid.lattice.size;
    const bool isMirrored = grid.lattice.isLeftHanded();
    std::uint64_t cell = 0;
    for (std::uint32_t k = 0; k + 1 < size[2]; ++k) {
        if (progress.cancelled())
            return cancelledError(Message::marked("Reading"));
        progress.report(double(k) / size[2], Message::marked("Reading"));
        for (std::uint32_t j = 0; j + 1 < size[1]; ++j)
            for (std::uint32_t i = 0; i + 1 < size[0]; ++i, ++cell) {
                const auto corners = cornersOfCell(grid.lattice, isMirrored, grid.lattice.index(i, j, k));
                GridCell what = grid.cells ? (*grid.cells)[cell] : GridCell::Kept;
                if (what == GridCell::Kept && !areFinite(grid.values, corners))
                    what = GridCell::NotFinite;
                visit(corners, what);
            }
    }
    return {};
}

/// What the mesh of a grid's hexahedra takes of memory, measured: 0.96 to 1.02 KB a cell, from 40^3 to 100^3 points.
inline constexpr std::uint64_t bytesOfGridTetrahedron = 170;
inline constexpr std::uint64_t tetrahedraOfGridCell = 6; ///< at most

} // namespace tetra
