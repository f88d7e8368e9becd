// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/samples/portable_math.h"

#include <algorithm>
#include <cmath>

namespace tetra {

namespace {

/// sum of x^k / k! over k = 0, step, 2 step ..., signs alternating if `alternating`; Horner from the smallest term.
template <int First, int Step, int Terms, bool Alternating> double taylor(double x) noexcept
{
    double sum = 1;
    for (int term = Terms; term > 0; --term) {
        double divisor = 1;
        for (int factor = First + Step * (term - 1) + 1; factor <= First + Step * term; ++factor)
            divisor *= factor;
        const double next = sum * x / divisor;
        sum = Alternating ? 1 - next : 1 + next;
    }
    return sum;
}

} // namespace

double portableExponential(double x) noexcept
{
    constexpr double log2OfE = 0x1.71547652b82fep+0;
    constexpr double ln2High = 0x1.62e42feep-1; // its products with whole numbers to 1024 are exact
    constexpr double ln2Low = 0x1.a39ef35793c76p-33;
    const double bounded = std::clamp(x, -700.0, 700.0);
    const double exponent = std::floor(bounded * log2OfE + 0.5);
    const double rest = (bounded - exponent * ln2High) - exponent * ln2Low;
    return std::ldexp(taylor<0, 1, 14, false>(rest), static_cast<int>(exponent));
}

double portableCosineOfTurns(double turns) noexcept
{
    constexpr double twoPi = 0x1.921fb54442d18p+2;
    const double fraction = std::abs(turns - std::floor(turns + 0.5)); // [0, 1/2]
    const bool mirrored = fraction > 0.25;
    const double quarter = mirrored ? 0.5 - fraction : fraction; // [0, 1/4], exact
    double cosine = 0;
    if (quarter <= 0.125) {
        const double angle = twoPi * quarter;
        cosine = taylor<0, 2, 9, true>(angle * angle);
    } else {
        const double angle = twoPi * (0.25 - quarter);
        cosine = angle * taylor<1, 2, 9, true>(angle * angle);
    }
    return mirrored ? -cosine : cosine;
}

} // namespace tetra
