// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/model/queries/budget_search.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace tetra {

namespace {

constexpr double share = 0.9; ///< of the budget that is enough
constexpr int mostMeshes = 12;
constexpr double nearlyEqual = 1.005;
/// By which power of the error the tetrahedra of a smooth field are more, until two meshes say it: it is approximated
/// to second order, in three dimensions.
constexpr double firstPower = 1.5;
constexpr double leastPower = 0.2;
constexpr double mostPower = 6;

double powerBetween(double oneScale, double oneSize, double otherScale, double otherSize)
{
    const double power = std::log((oneSize + 1) / (otherSize + 1)) / std::log(otherScale / oneScale);
    return std::isfinite(power) ? std::clamp(power, leastPower, mostPower) : firstPower;
}

} // namespace

Result<double> scaleWithin(std::uint64_t budget, double first, double largest, const SizeAtScale& sizeAt)
{
    double tooFine = 0; // none known
    double fits = 0;    // none known
    double scale = std::clamp(first, 1.0, largest);
    double made = 0;
    double size = 0;
    double power = firstPower;
    const auto allowed = static_cast<double>(budget);
    for (int meshes = 0; meshes < mostMeshes || fits == 0; ++meshes) {
        const auto found = sizeAt(scale);
        if (!found)
            return found.error();
        if (meshes > 0)
            power = powerBetween(made, size, scale, static_cast<double>(*found));
        made = scale;
        size = static_cast<double>(*found);
        if (size > allowed) {
            if (scale >= largest)
                return Error{ErrorKind::WrongUsage, "The coarsest mesh has " + std::to_string(*found) +
                                                        " tetrahedra, more than the budget of " +
                                                        std::to_string(budget) + ". Allow at least as many."};
            tooFine = scale;
        } else {
            fits = scale;
            if (scale == 1 || size >= share * allowed)
                return scale;
        }
        if (tooFine > 0 && fits > 0 && fits <= nearlyEqual * tooFine)
            break;
        const double guess = scale * std::pow((size + 1) / (std::sqrt(share) * allowed), 1 / power);
        const double least = tooFine > 0 ? tooFine * std::sqrt(nearlyEqual) : 1;
        const double most = fits > 0 ? fits / std::sqrt(nearlyEqual) : largest;
        const bool bracketed = tooFine > 0 && fits > 0;
        scale = bracketed && (guess <= least || guess >= most) ? std::sqrt(tooFine * fits)
                                                               : std::clamp(guess, least, std::max(least, most));
    }
    if (made != fits)
        if (const auto again = sizeAt(fits); !again)
            return again.error();
    return fits;
}

} // namespace tetra
