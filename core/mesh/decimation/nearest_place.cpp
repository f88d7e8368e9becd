// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/decimation/nearest_place.h"

#include <Eigen/Core>

namespace tetra {

std::array<double, 3> nearestWeights(const std::array<std::array<double, 3>, 3>& corners)
{
    const Eigen::Map<const Eigen::Vector3d> a(corners[0].data()), b(corners[1].data()), c(corners[2].data());
    const Eigen::Vector3d ab = b - a, ac = c - a;
    const double abA = -ab.dot(a), acA = -ac.dot(a);
    if (abA <= 0 && acA <= 0)
        return {1, 0, 0};
    const double abB = -ab.dot(b), acB = -ac.dot(b);
    if (abB >= 0 && acB <= abB)
        return {0, 1, 0};
    const double besideC = abA * acB - abB * acA;
    if (besideC <= 0 && abA >= 0 && abB <= 0) {
        const double t = abA / (abA - abB);
        return {1 - t, t, 0};
    }
    const double abC = -ab.dot(c), acC = -ac.dot(c);
    if (acC >= 0 && abC <= acC)
        return {0, 0, 1};
    const double besideB = abC * acA - abA * acC;
    if (besideB <= 0 && acA >= 0 && acC <= 0) {
        const double t = acA / (acA - acC);
        return {1 - t, 0, t};
    }
    const double besideA = abB * acC - abC * acB;
    if (besideA <= 0 && acB - abB >= 0 && abC - acC >= 0) {
        const double t = (acB - abB) / ((acB - abB) + (abC - acC));
        return {0, 1 - t, t};
    }
    const double all = besideA + besideB + besideC;
    return {1 - besideB / all - besideC / all, besideB / all, besideC / all};
}

} // namespace tetra
