// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/data/cells/random_cells.h"
#include "tests/core/data/cells/reference_cells.h"

#include <tan/data.h>

#include <QString>

#include <functional>
#include <numeric>

namespace tetra {

inline CellComplex singleCell(CellShape shape)
{
    auto nodes = referenceNodes(shape);
    std::vector<std::uint64_t> corners(nodes.size());
    std::iota(corners.begin(), corners.end(), 0);
    if (shape == CellShape::Voxel)
        for (std::uint32_t i = 0; i < 8; ++i)
            corners[i] = hexahedronCorner(i);
    return complexOf(std::move(nodes), shape, {corners});
}

/// x + 2 y + 4 z at every point.
inline ComplexValues linearValues(const CellComplex& complex)
{
    ComplexValues values{.values = {}, .perCell = false, .type = SampleType::Float64};
    for (const Eigen::Vector3d& place : complex.positions)
        values.values.push_back(place.dot(Eigen::Vector3d(1, 2, 4)));
    return values;
}

inline Result<Dataset> datasetOf(const CellComplex& complex, const ComplexValues& values)
{
    return irregularDataset(complex, values, {.name = "cells", .path = {}, .hash = 0});
}

inline QString remarksOf(const Dataset& dataset)
{
    QString text;
    for (const Message& remark : dataset.remarks)
        text += QString::fromStdString(remark.text()) + " ";
    return text;
}

/// Two unit cubes of which the second starts at `offset`, with points of its own.
inline CellComplex twoCubes(const Eigen::Vector3d& offset, double scale = 1)
{
    auto nodes = referenceNodes(CellShape::Hexahedron);
    for (std::size_t i = 0; i < 8; ++i)
        nodes.push_back(scale * nodes[i] + offset);
    return complexOf(std::move(nodes), CellShape::Hexahedron,
                     {{0, 1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14, 15}});
}

/// Hexahedra on a lattice, those kept that `inside` says.
inline CellComplex lattice(std::uint32_t n,
                           const std::function<bool(std::uint32_t, std::uint32_t, std::uint32_t)>& inside)
{
    std::vector<Eigen::Vector3d> positions;
    for (std::uint32_t p = 0; p < (n + 1) * (n + 1) * (n + 1); ++p)
        positions.emplace_back(p % (n + 1), p / (n + 1) % (n + 1), p / (n + 1) / (n + 1));
    std::vector<std::vector<std::uint64_t>> cells;
    const auto at = [n](std::uint64_t i, std::uint64_t j, std::uint64_t k) { return (k * (n + 1) + j) * (n + 1) + i; };
    for (std::uint32_t k = 0; k < n; ++k)
        for (std::uint32_t j = 0; j < n; ++j)
            for (std::uint32_t i = 0; i < n; ++i)
                if (inside(i, j, k))
                    cells.push_back({at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
                                     at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1),
                                     at(i, j + 1, k + 1)});
    return complexOf(std::move(positions), CellShape::Hexahedron, cells);
}

} // namespace tetra
