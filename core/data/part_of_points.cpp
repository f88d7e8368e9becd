// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/part_of_points.h"

#include "core/data/manifold_part.h"
#include "core/data/sample_buffer.h"

#include <algorithm>
#include <limits>

namespace tetra {

namespace {

constexpr std::uint32_t notTaken = std::numeric_limits<std::uint32_t>::max();

Error nothingInside(const std::string& what)
{
    return {ErrorKind::WrongUsage, "The region holds " + what +
                                       ". Take a larger one; 'bounds' of 'tan info' says where "
                                       "the points lie."};
}

/// The points that are taken, in their order, and the number that each point has there.
struct Chosen {
    std::vector<std::uint32_t> points;
    std::vector<std::uint32_t> numbers;
};

template <class IsTaken> Chosen choose(std::uint64_t points, const IsTaken& isTaken)
{
    Chosen chosen;
    chosen.numbers.resize(points, notTaken);
    for (std::uint32_t point = 0; point < points; ++point)
        if (isTaken(point)) {
            chosen.numbers[point] = static_cast<std::uint32_t>(chosen.points.size());
            chosen.points.push_back(point);
        }
    return chosen;
}

Result<Dataset> ofPoints(const Dataset& dataset, const std::vector<std::uint32_t>& points)
{
    const SampleType type = dataset.values.type();
    auto samples = allocateSamples(type, points.size());
    if (!samples)
        return samples.error();
    auto positions = std::make_shared<std::vector<Eigen::Vector3d>>();
    positions->reserve(points.size());
    visitSampleType(type, [&]<class T>() {
        T* to = reinterpret_cast<T*>(samples->get());
        for (const std::uint32_t point : points) {
            *to++ = dataset.values.as<T>()[point];
            positions->push_back((*dataset.positions)[point]);
        }
    });
    Dataset result = dataset;
    result.values = ScalarField(type, points.size(), *std::move(samples));
    result.positions = std::move(positions);
    result.lattice.size = {static_cast<std::uint32_t>(points.size()), 1, 1};
    result.mappedFile = nullptr;
    result.remarks.push_back("A part of " + std::to_string(points.size()) + " of the " +
                             std::to_string(dataset.pointCount()) + " points.");
    return result;
}

Result<Dataset> partOfIrregular(const Dataset& dataset, const Eigen::AlignedBox3d& box, const Progress& progress)
{
    const auto& all = *dataset.tetrahedra;
    std::vector<std::uint8_t> taken(all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        taken[i] =
            std::ranges::all_of(all[i], [&](std::uint32_t point) { return box.contains((*dataset.positions)[point]); });
    if (progress.cancelled())
        return cancelledError("Reading");
    const std::uint64_t removed = restrictToManifold(all, static_cast<std::uint32_t>(dataset.positions->size()), taken);
    std::vector<std::uint8_t> isUsed(dataset.positions->size());
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const std::uint32_t point : all[i])
            isUsed[point] |= taken[i];
    const Chosen chosen = choose(isUsed.size(), [&](std::uint32_t point) { return isUsed[point] != 0; });
    if (chosen.points.empty())
        return nothingInside("no whole tetrahedron");
    auto result = ofPoints(dataset, chosen.points);
    if (!result)
        return result;
    auto tetrahedra = std::make_shared<std::vector<std::array<std::uint32_t, 4>>>();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (taken[i] != 0)
            tetrahedra->push_back({chosen.numbers[all[i][0]], chosen.numbers[all[i][1]], chosen.numbers[all[i][2]],
                                   chosen.numbers[all[i][3]]});
    result->tetrahedra = std::move(tetrahedra);
    if (removed > 0)
        result->remarks.push_back(std::to_string(removed) +
                                  (removed == 1
                                       ? " tetrahedron inside the region was left out: it touches the others"
                                       : " tetrahedra inside the region were left out: they touch the others") +
                                  " only at a vertex or an edge.");
    return result;
}

} // namespace

Result<Dataset> partOfPoints(const Dataset& dataset, const Eigen::AlignedBox3d& box, const Progress& progress)
{
    if (dataset.tetrahedra)
        return partOfIrregular(dataset, box, progress);
    constexpr std::size_t leastPoints = 4;
    const Chosen chosen =
        choose(dataset.pointCount(), [&](std::uint32_t point) { return box.contains((*dataset.positions)[point]); });
    if (chosen.points.size() < leastPoints)
        return nothingInside(std::to_string(chosen.points.size()) + " points, and a volume needs four");
    return ofPoints(dataset, chosen.points);
}

} // namespace tetra
