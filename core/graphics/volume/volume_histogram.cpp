// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/graphics/volume/volume_histogram.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tetra {
namespace {

/// Adds up intervals of constant density: whole parts by where the density begins and ends, the two at the ends
/// directly.
class Accumulator {
public:
    explicit Accumulator(std::size_t parts) : amounts_(parts), steps_(parts + 1) {}

    /// `amount`, spread over [begin, end] in parts from 0; what lies outside is left out.
    void add(double begin, double end, double amount)
    {
        const auto count = static_cast<double>(amounts_.size());
        if (!(end >= 0 && begin <= count))
            return;
        if (end - begin < leastExtent) {
            amounts_[partOf(begin)] += amount;
            return;
        }
        const double density = amount / (end - begin);
        begin = std::max(begin, 0.0);
        end = std::min(end, count);
        const std::size_t first = partOf(begin), last = partOf(end);
        if (first == last) {
            amounts_[first] += density * (end - begin);
            return;
        }
        amounts_[first] += density * (static_cast<double>(first + 1) - begin);
        amounts_[last] += density * (end - static_cast<double>(last));
        steps_[first + 1] += density;
        steps_[last] -= density;
    }

    std::vector<double> amounts() const
    {
        std::vector<double> result = amounts_;
        double density = 0;
        for (std::size_t part = 0; part < result.size(); ++part)
            result[part] = std::max(0.0, result[part] + (density += steps_[part]));
        return result;
    }

private:
    static constexpr double leastExtent = 1e-6;

    std::size_t partOf(double place) const
    {
        return std::min(static_cast<std::size_t>(std::max(place, 0.0)), amounts_.size() - 1);
    }

    std::vector<double> amounts_;
    std::vector<double> steps_;
};

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
    Accumulator sums(static_cast<std::size_t>(parts));
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
