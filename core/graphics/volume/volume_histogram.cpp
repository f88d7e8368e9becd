// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_histogram.h"

#include "core/graphics/interval_sums.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

double cellVolume(const TetrahedralMesh& mesh, const std::array<std::uint32_t, 4>& cell)
{
    const Eigen::Vector3f& origin = mesh.positions[cell[0]];
    const auto edge = [&](std::size_t corner) {
        return Eigen::Vector3d((mesh.positions[cell[corner]] - origin).cast<double>());
    };
    return std::abs(edge(1).dot(edge(2).cross(edge(3))));
}

} // namespace

ValueHistogram volumeHistogram(const TetrahedralMesh& mesh, double least, double largest, int parts)
{
    ValueHistogram histogram{least, largest, {}};
    const double extent = largest - least;
    if (!(extent > 0) || !std::isfinite(extent) || parts <= 0)
        return histogram;
    IntervalSums sums(static_cast<std::size_t>(parts));
    for (const auto& cell : mesh.tetrahedra) {
        const auto value = [&](std::size_t corner) { return double(mesh.values[cell[corner]]); };
        const auto [low, high] = std::minmax({value(0), value(1), value(2), value(3)});
        const double volume = cellVolume(mesh, cell);
        const double sum = value(0) + value(1) + value(2) + value(3);
        if (std::isfinite(sum) && std::isfinite(volume))
            sums.add((low - least) / extent * parts, (high - least) / extent * parts, volume);
    }
    const std::vector<double> amounts = sums.amounts();
    const double total = std::reduce(amounts.begin(), amounts.end());
    if (!(total > 0))
        return histogram;
    for (const double amount : amounts)
        histogram.counts.push_back(static_cast<std::uint64_t>(std::llround(amount / total * 0x1p32)));
    return histogram;
}

} // namespace tetra
