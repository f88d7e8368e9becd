// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/lattice_checks.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
        return Error{ErrorKind::BadInput, "it has " + sizeText(size) +
                                              " points. A volume needs at least 2 along each axis: put several slices "
                                              "together, or repeat the one there is."};
    constexpr std::uint64_t largestBytes = std::uint64_t(1) << 62;
    std::uint64_t room = largestBytes / sizeof(double);
    for (const std::uint64_t points : size) {
        room = points > std::numeric_limits<std::uint32_t>::max() ? 0 : room / points;
        if (room == 0)
            return Error{ErrorKind::BadInput, "it claims to have " + sizeText(size) +
                                                  " points, more than any machine can hold. Its description is "
                                                  "wrong: check the sizes."};
    }
    return {};
}

Status checkLatticePlacement(const Lattice& lattice)
{
    const auto text = [](const Eigen::Vector3d& vector) {
        return formatNumber(vector[0]) + ", " + formatNumber(vector[1]) + ", " + formatNumber(vector[2]);
    };
    for (int axis = 0; axis < 3; ++axis)
        if (!(lattice.spacing[axis] > 0) || !std::isfinite(lattice.spacing[axis]))
            return Error{ErrorKind::BadInput, "its spacing is " + text(lattice.spacing) +
                                                  ". The distance of neighbouring points must be a positive number "
                                                  "along each axis."};
    const Eigen::AlignedBox3d bounds = lattice.bounds();
    if (!lattice.origin.allFinite() || !bounds.max().allFinite())
        return Error{ErrorKind::BadInput, "its origin " + text(lattice.origin) + " and spacing " +
                                              text(lattice.spacing) +
                                              " give positions that are no finite numbers. Check both."};
    const Eigen::Vector3d beforeLast = lattice.position(lattice.size[0] - 2, lattice.size[1] - 2, lattice.size[2] - 2);
    if ((bounds.max().array() <= beforeLast.array()).any() ||
        (lattice.position(1, 1, 1).array() <= lattice.origin.array()).any())
        return Error{ErrorKind::BadInput, "its origin " + text(lattice.origin) + " is so far away for the spacing " +
                                              text(lattice.spacing) +
                                              " that neighbouring points fall together. Move the origin nearer to 0."};
    return {};
}

Status checkFinite(const Lattice& lattice, const ScalarField& values)
{
    if (values.notFiniteCount() == 0)
        return {};
    const auto [i, j, k] = lattice.coordinates(firstNotFinite(values));
    return Error{ErrorKind::BadInput,
                 std::to_string(values.notFiniteCount()) + " of its " + std::to_string(values.count()) +
                     " samples are NaN or infinite, the first at point (" + std::to_string(i) + ", " +
                     std::to_string(j) + ", " + std::to_string(k) + "). Replace them by numbers first."};
}

} // namespace tetra
