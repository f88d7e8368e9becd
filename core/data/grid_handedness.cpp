// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/grid_handedness.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>

namespace tetra {

namespace {

/// Counts the corners of the cell whose first corner is (i, j, k).
void countCell(const Dataset& dataset, std::uint32_t i, std::uint32_t j, std::uint32_t k, CellCornerSigns& signs)
{
    const auto at = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) -> const Eigen::Vector3d& {
        return (*dataset.positions)[dataset.lattice.index(i + x, j + y, k + z)];
    };
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const std::uint32_t x = corner & 1;
        const std::uint32_t y = corner >> 1 & 1;
        const std::uint32_t z = corner >> 2;
        // Edges along the axes, whichever end the corner is at.
        const Eigen::Vector3d alongX = at(1, y, z) - at(0, y, z);
        const Eigen::Vector3d alongY = at(x, 1, z) - at(x, 0, z);
        const Eigen::Vector3d alongZ = at(x, y, 1) - at(x, y, 0);
        const double volume = alongX.dot(alongY.cross(alongZ));
        signs.positive += volume > 0 ? 1 : 0;
        signs.negative += volume < 0 ? 1 : 0;
    }
}

} // namespace

CellCornerSigns cellCornerSigns(const Dataset& dataset)
{
    const auto& size = dataset.lattice.size;
    return tbb::parallel_reduce(
        tbb::blocked_range<std::uint32_t>(0, size[2] - 1), CellCornerSigns(),
        [&](const auto& layers, CellCornerSigns signs) {
            for (std::uint32_t k = layers.begin(); k != layers.end(); ++k)
                for (std::uint32_t j = 0; j + 1 < size[1]; ++j)
                    for (std::uint32_t i = 0; i + 1 < size[0]; ++i)
                        countCell(dataset, i, j, k, signs);
            return signs;
        },
        [](const CellCornerSigns& a, const CellCornerSigns& b) {
            return CellCornerSigns{a.positive + b.positive, a.negative + b.negative};
        });
}

bool isLeftHanded(const Dataset& dataset)
{
    const CellCornerSigns signs = cellCornerSigns(dataset);
    return signs.negative > signs.positive;
}

bool fitFloats(const std::vector<Eigen::Vector3d>& positions)
{
    return std::ranges::all_of(
        positions, [](const Eigen::Vector3d& position) { return position.cast<float>().cast<double>() == position; });
}

} // namespace tetra
