// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/split_mix.h"

#include <tan/build.h>

#include <Eigen/QR>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

namespace {

constexpr std::uint64_t latticeSampleCount = 4096;
constexpr int fittedPoints = 8; ///< by a plane: four unknowns

/// The `index`th of points that are spread evenly over all.
std::uint64_t spreadPoint(std::uint64_t index, std::uint64_t count)
{
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15; // odd: the golden ratio, which spreads evenly
    const auto fraction = static_cast<double>((index + 1) * golden >> 11) / static_cast<double>(std::uint64_t(1) << 53);
    return std::min(static_cast<std::uint64_t>(fraction * static_cast<double>(count)), count - 1);
}

double valueExtent(const ScalarField& values)
{
    const double extent = values.range().extent();
    return extent > 0 ? extent : 1;
}

/// The nearest points to one, in order.
class NearestPoints {
public:
    void offer(double squaredDistance, std::uint32_t point)
    {
        if (count_ == fittedPoints && squaredDistance >= distances_.back())
            return;
        int place = count_ < fittedPoints ? count_++ : fittedPoints - 1;
        for (; place > 0 && distances_[place - 1] > squaredDistance; --place) {
            distances_[place] = distances_[place - 1];
            points_[place] = points_[place - 1];
        }
        distances_[place] = squaredDistance;
        points_[place] = point;
    }
    bool complete() const { return count_ == fittedPoints; }
    const std::array<std::uint32_t, fittedPoints>& points() const { return points_; }

private:
    std::array<double, fittedPoints> distances_{};
    std::array<std::uint32_t, fittedPoints> points_{};
    int count_ = 0;
};

/// The value at `point` by the linear function that fits the others best.
double fittedValue(const Dataset& dataset, std::uint64_t point, const NearestPoints& nearest)
{
    const Eigen::Vector3d& centre = (*dataset.positions)[point];
    Eigen::Matrix<double, fittedPoints, 4> places;
    Eigen::Matrix<double, fittedPoints, 1> values;
    for (int i = 0; i < fittedPoints; ++i) {
        const std::uint32_t other = nearest.points()[i];
        places.row(i) << ((*dataset.positions)[other] - centre).transpose(), 1;
        values[i] = dataset.values.at(other);
    }
    return places.colPivHouseholderQr().solve(values)[3];
}

} // namespace

SiteDensity::Deviations SiteDensity::onLattice(const Dataset& dataset, std::uint64_t point, double diagonal)
{
    const auto place = dataset.lattice.coordinates(point);
    const double extent = valueExtent(dataset.values);
    Deviations deviations{};
    double largest = 0;
    for (int level = 0; level < levels; ++level) {
        const std::uint64_t distance = std::uint64_t(1) << level;
        std::uint64_t step = 1;
        for (std::size_t axis = 0; axis < 3; step *= dataset.lattice.size[axis], ++axis) {
            const std::uint64_t size = dataset.lattice.size[axis];
            if (size <= 2 * distance)
                continue;
            // Near the border the next point that has both neighbours stands for it.
            const std::uint64_t inside = std::clamp<std::uint64_t>(place[axis], distance, size - 1 - distance);
            const std::uint64_t middle = point + inside * step - place[axis] * step;
            const std::uint64_t before = middle - distance * step;
            const std::uint64_t behind = middle + distance * step;
            const double mean = (dataset.values.at(before) + dataset.values.at(behind)) / 2;
            largest = std::max(largest, std::abs(dataset.values.at(middle) - mean) / extent);
            if (dataset.positions) {
                const auto& positions = *dataset.positions;
                const double off = (positions[middle] - (positions[before] + positions[behind]) / 2).norm();
                largest = std::max(largest, off / diagonal);
            }
        }
        deviations[level] = static_cast<float>(largest);
    }
    return deviations;
}

/// Neighbours at twice the distance are the nearest of an eighth of the points, chosen by chance.
SiteDensity::Deviations SiteDensity::amongPoints(const Dataset& dataset, std::uint64_t point)
{
    const auto& positions = *dataset.positions;
    std::array<NearestPoints, levels> nearest;
    for (std::uint32_t other = 0; other < positions.size(); ++other) {
        if (other == point)
            continue;
        const double distance = (positions[other] - positions[point]).squaredNorm();
        std::uint64_t chance = splitMix(other * splitMixStep);
        for (int level = 0; level < levels; ++level, chance >>= 3) {
            nearest[level].offer(distance, other);
            if ((chance & 7) != 0)
                break;
        }
    }
    Deviations deviations;
    deviations.fill(std::numeric_limits<float>::infinity());
    const double extent = valueExtent(dataset.values);
    const double value = dataset.values.at(point);
    double largest = 0;
    for (int level = 0; level < levels && nearest[level].complete(); ++level) {
        largest = std::max(largest, std::abs(fittedValue(dataset, point, nearest[level]) - value) / extent);
        deviations[level] = static_cast<float>(largest);
    }
    return deviations;
}

SiteDensity SiteDensity::of(const Dataset& dataset, const Progress& progress)
{
    SiteDensity density;
    const std::uint64_t count = dataset.pointCount();
    if (count == 0)
        return density;
    const bool isGrid = isOnLattice(dataset.domain);
    constexpr std::uint64_t mostDistances = 100'000'000; // computed in a fraction of a second
    const std::uint64_t samples =
        std::min(count, isGrid ? latticeSampleCount : std::clamp<std::uint64_t>(mostDistances / count, 16, 512));
    const double diagonal = isGrid && dataset.positions ? dataset.bounds().diagonal().norm() : 1;
    if (isGrid)
        for (std::size_t axis = 0; axis < 3; ++axis)
            density.longest_[axis] = std::max<double>(1, static_cast<double>(dataset.lattice.size[axis]) - 1);
    density.deviations_.resize(samples);
    tbb::parallel_for(std::uint64_t(0), samples, [&](std::uint64_t i) {
        if (progress.cancelled())
            return;
        const std::uint64_t point = spreadPoint(i, count);
        density.deviations_[i] =
            isGrid ? onLattice(dataset, point, diagonal > 0 ? diagonal : 1) : amongPoints(dataset, point);
    });
    return progress.cancelled() ? SiteDensity() : density;
}

/// Edges of twice a distance are in order where the middle is off by no more than the error. The deviation grows with
/// the square of the distance; between the distances that were looked at lies the mean of the two bounds.
double SiteDensity::share(double error) const
{
    if (!known())
        return 1;
    double sum = 0;
    for (const Deviations& deviations : deviations_) {
        const auto* first = std::ranges::find_if(deviations, [&](float deviation) { return deviation > error; });
        const auto level = static_cast<int>(first - deviations.begin());
        double spacing = std::ldexp(1.0, level);
        if (level < levels && error > 0)
            spacing *= std::sqrt(std::max(1.0, 2 * std::sqrt(error / static_cast<double>(*first))));
        double cell = 1;
        for (const double longest : longest_)
            cell *= std::min(spacing, longest);
        sum += 1 / cell;
    }
    return sum / static_cast<double>(deviations_.size());
}

} // namespace tetra
