// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/plugins/writers/vtk_reader.h"

#include <array>
#include <cstdint>
#include <vector>

namespace tetra {

/// A mesh as VTK reads it.
struct ReadMesh {
    explicit ReadMesh(const VtkReader& reader)
        : points(reader.places()), values(reader.array<float>("point.value")),
          cells(reader.array<std::uint32_t>("cells"))
    {
    }
    std::size_t cellCount() const { return cells.size() / 4; }
    double coordinate(std::size_t cell, std::size_t corner, std::size_t axis) const
    {
        return points[3 * cells[4 * cell + corner] + axis];
    }
    double value(std::size_t cell, std::size_t corner) const
    {
        return static_cast<double>(values[cells[4 * cell + corner]]);
    }
    double volume(std::size_t cell) const
    {
        std::array<std::array<double, 3>, 3> e{};
        for (std::size_t edge = 0; edge < 3; ++edge)
            for (std::size_t axis = 0; axis < 3; ++axis)
                e[edge][axis] = coordinate(cell, edge + 1, axis) - coordinate(cell, 0, axis);
        return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) + e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
               6;
    }
    double volume() const
    {
        double sum = 0;
        for (std::size_t cell = 0; cell < cellCount(); ++cell)
            sum += volume(cell);
        return sum;
    }

    std::vector<double> points;
    std::vector<float> values;
    std::vector<std::uint32_t> cells;
};

} // namespace tetra
