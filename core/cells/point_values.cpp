// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cells/point_values.h"

#include "core/cells/point_welding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

/// Sums for each point, as means that do not overflow.
class Means {
public:
    explicit Means(std::size_t points) : means_(points), counts_(points) {}
    void add(std::size_t point, double value)
    {
        const double count = ++counts_[point];
        means_[point] = means_[point] * ((count - 1) / count) + value / count;
    }
    std::uint32_t count(std::size_t point) const { return counts_[point]; }
    double mean(std::size_t point) const { return means_[point]; }
    std::vector<double> take() { return std::move(means_); }

private:
    std::vector<double> means_;
    std::vector<std::uint32_t> counts_;
};

std::vector<double> valuesOfCells(const CellComplex& complex, const ComplexValues& values, const PreparedCells& cells,
                                  const CutCells& cut)
{
    constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
    std::vector<bool> kept(cells.count());
    for (const std::uint32_t cell : cut.cells)
        kept[cell] = true;
    Means means(complex.positions.size());
    std::vector<std::uint64_t> lastCell(complex.positions.size(), none); // a cell counts once, in however many parts
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        if (!kept[cell])
            continue;
        const std::uint64_t origin = cells.origins[cell];
        for (const std::uint32_t node : cells.nodesOf(cell))
            if (std::exchange(lastCell[node], origin) != origin)
                means.add(node, values.values[origin]);
    }
    return means.take();
}

std::vector<double> valuesOfPoints(const CellComplex& complex, const ComplexValues& values, const PreparedCells& cells,
                                   Mending& mending)
{
    if (mending.welded == 0)
        return values.values;
    std::vector<bool> used(complex.positions.size());
    for (const std::uint64_t origin : cells.origins)
        for (std::uint64_t i = complex.offsets[origin]; i < complex.offsets[origin + 1]; ++i)
            used[complex.corners[i]] = true;
    const std::vector<std::uint32_t> first = firstOnPlace(complex.positions, used);
    Means means(complex.positions.size());
    std::vector<bool> conflict(complex.positions.size());
    for (std::size_t point = 0; point < first.size(); ++point) {
        if (!used[point])
            continue;
        conflict[first[point]] = conflict[first[point]] || values.values[point] != values.values[first[point]];
        means.add(first[point], values.values[point]);
    }
    mending.conflicting = static_cast<std::uint64_t>(std::ranges::count(conflict, true));
    std::vector<double> result = values.values;
    for (std::size_t point = 0; point < result.size(); ++point)
        if (conflict[point])
            result[point] = means.mean(point);
    return result;
}

} // namespace

std::vector<double> pointValues(const CellComplex& complex, const ComplexValues& values, const PreparedCells& cells,
                                const CutCells& cut, Mending& mending)
{
    mending.cellValues = values.perCell;
    return values.perCell ? valuesOfCells(complex, values, cells, cut)
                          : valuesOfPoints(complex, values, cells, mending);
}

SampleType typeOfPointValues(const ComplexValues& values, const Mending& mending, const std::vector<double>& usedValues)
{
    const auto exceeds = [&](double largest) {
        return std::ranges::any_of(usedValues, [&](double value) { return std::abs(value) > largest; });
    };
    SampleType type = values.type;
    if (isInteger(type)) {
        const bool fits = visitSampleType(type, [&]<class T>() {
            return std::ranges::all_of(usedValues, [](double value) {
                return value >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                       value <= static_cast<double>(std::numeric_limits<T>::max());
            });
        });
        if (fits && !values.perCell && mending.conflicting == 0)
            return type;
        type = sampleSize(type) > sizeof(std::uint16_t) ? SampleType::Float64 : SampleType::Float32;
    }
    const bool tooLarge = type == SampleType::Float32 && exceeds(std::numeric_limits<float>::max());
    return tooLarge ? SampleType::Float64 : type;
}

} // namespace tetra
