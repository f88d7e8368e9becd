// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/dataset_checks.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace tetra {

namespace {

std::uint64_t firstNotFinite(const ScalarField& values)
{
    return visitSampleType(values.type(), [&]<class T>() {
        const auto samples = values.as<T>();
        const auto found =
            std::ranges::find_if(samples, [](T sample) { return !std::isfinite(static_cast<double>(sample)); });
        return static_cast<std::uint64_t>(found - samples.begin());
    });
}

} // namespace

std::string sizeText(const std::array<std::uint64_t, 3>& size)
{
    return std::to_string(size[0]) + " x " + std::to_string(size[1]) + " x " + std::to_string(size[2]);
}

Status checkLatticeSize(const std::array<std::uint64_t, 3>& size)
{
    if (std::ranges::any_of(size, [](std::uint64_t points) { return points < 2; }))
        return Error{ErrorKind::BadInput, Message::say("it has %1 points. A volume needs at least 2 along each axis: "
                                                       "stack several slices, or repeat the only one.",
                                                       sizeText(size))};
    constexpr std::uint64_t largestBytes = std::uint64_t(1) << 62;
    std::uint64_t most = largestBytes / sizeof(double);
    for (const std::uint64_t points : size) {
        most = points > std::numeric_limits<std::uint32_t>::max() ? 0 : most / points;
        if (most == 0)
            return Error{ErrorKind::BadInput, Message::say("it claims to have %1 points, more than any machine can "
                                                           "hold. Its description is wrong: check the sizes.",
                                                           sizeText(size))};
    }
    return {};
}

bool areDirections(const Eigen::Matrix3d& directions)
{
    constexpr double rounding = 1e-6, leastVolume = 1e-6;
    return directions.allFinite() && ((directions.colwise().norm().array() - 1).abs() <= rounding).all() &&
           std::abs(directions.determinant()) >= leastVolume;
}

namespace {

/// Whether neighbours differ at the eight corners, where coordinates are the largest: a step along an index leads on,
/// in doubles, along the axis of the world that it runs along most.
bool staysApart(const Lattice& lattice)
{
    for (int axis = 0; axis < 3; ++axis) {
        Eigen::Index along = 0;
        lattice.directions.col(axis).cwiseAbs().maxCoeff(&along);
        for (unsigned corner = 0; corner < 8; ++corner) {
            std::array<std::uint32_t, 3> point{};
            for (std::size_t index = 0; index < 3; ++index)
                point[index] = (corner >> index & 1) != 0 ? lattice.size[index] - 1 : 0;
            std::array<std::uint32_t, 3> next = point;
            std::uint32_t& number = next[static_cast<std::size_t>(axis)];
            number = number == 0 ? 1 : number - 1;
            if (lattice.position(point[0], point[1], point[2])[along] ==
                lattice.position(next[0], next[1], next[2])[along])
                return false;
        }
    }
    return true;
}

} // namespace

Status checkLatticePlacement(const Lattice& lattice)
{
    const auto text = [](const Eigen::Vector3d& vector) {
        return formatNumber(vector[0]) + ", " + formatNumber(vector[1]) + ", " + formatNumber(vector[2]);
    };
    for (int axis = 0; axis < 3; ++axis)
        if (!(lattice.spacing[axis] > 0) || !std::isfinite(lattice.spacing[axis]))
            return Error{ErrorKind::BadInput, Message::say("its spacing is %1. The distance between neighbouring "
                                                           "points must be a positive number along each axis.",
                                                           text(lattice.spacing))};
    if (!areDirections(lattice.directions))
        return Error{ErrorKind::BadInput,
                     Message::say("its three directions %1; %2; %3 lie in a plane, or are not of unit length, so that "
                                  "it has no volume. Give three that span one.",
                                  text(lattice.directions.col(0)), text(lattice.directions.col(1)),
                                  text(lattice.directions.col(2)))};
    const Eigen::AlignedBox3d bounds = lattice.bounds();
    const Eigen::Vector3d extents = lattice.spacing.cwiseProduct(
        Eigen::Vector3d(lattice.size[0] - 1.0, lattice.size[1] - 1.0, lattice.size[2] - 1.0));
    if (!isUsablePlace(lattice.origin) || !isUsablePlace(extents) || !isUsablePlace(bounds.min()) ||
        !isUsablePlace(bounds.max()) || lattice.spacing.minCoeff() * farthestCoordinate < 1)
        return Error{ErrorKind::BadInput,
                     Message::say("its origin %1 and spacing %2 are not finite, or too large or small to compute with. "
                                  "Check both.",
                                  text(lattice.origin), text(lattice.spacing))};
    if (!staysApart(lattice))
        return Error{ErrorKind::BadInput, Message::say("its origin %1 is so far away for the spacing %2 that "
                                                       "neighbouring points coincide. Move the origin nearer to 0.",
                                                       text(lattice.origin), text(lattice.spacing))};
    return {};
}

Status checkFinite(const Lattice& lattice, const ScalarField& values)
{
    if (values.notFiniteCount() == 0)
        return {};
    const auto [i, j, k] = lattice.coordinates(firstNotFinite(values));
    return Error{ErrorKind::BadInput, Message::say("%1 of its %2 samples are NaN or infinite, the first at point (%3, "
                                                   "%4, %5). Replace them with numbers first.",
                                                   values.notFiniteCount(), values.count(), i, j, k)};
}

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

namespace {

std::string pointText(const Lattice& lattice, std::uint64_t point)
{
    const auto c = lattice.coordinates(point);
    return "(" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " + std::to_string(c[2]) + ")";
}

} // namespace

Status checkGrid(const Dataset& dataset)
{
    for (std::uint64_t point = 0; point < dataset.pointCount(); ++point)
        if (!isUsablePlace((*dataset.positions)[point]))
            return Error{ErrorKind::BadInput,
                         Message::say("point %1 has an invalid or extremely large position. Repair the file.",
                                      pointText(dataset.lattice, point))};
    if (dataset.values.notFiniteCount() > 0)
        return Error{ErrorKind::BadInput,
                     Message::say("%1 values are too large for single precision, or not numbers. Choose another array.",
                                  dataset.values.notFiniteCount())};
    const CellCornerSigns signs = cellCornerSigns(dataset);
    if (signs.positive == 0 && signs.negative == 0)
        return Error{
            ErrorKind::BadInput,
            Message::say(
                "all its points lie in a plane, or so close to one that no cell has a volume. TAn needs volumes.")};
    return {};
}

} // namespace tetra
