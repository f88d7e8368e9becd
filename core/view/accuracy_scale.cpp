// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/view/accuracy_scale.h"

#include <algorithm>
#include <cmath>

namespace tetra {
namespace {

/// The round numbers of a decade, close enough together that a step is a small change.
constexpr std::array<double, 10> roundNumbers{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8};

/// Those of budgets.
constexpr std::array<double, 6> roundAccuracies{1, 1.5, 2, 3, 5, 7};

double roundedToThreeDigits(double value)
{
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - 2);
    // Dividing by a whole number keeps the result the double nearest to the decimal number.
    return unit < 1 ? std::round(value / unit) / std::round(1 / unit) : std::round(value / unit) * unit;
}

/// All round numbers of the scale, coarse first, then zero.
std::vector<double> ladder()
{
    std::vector<double> steps;
    for (int exponent = 2; exponent >= -2; --exponent)
        for (auto number = roundNumbers.rbegin(); number != roundNumbers.rend(); ++number) {
            const double percent = roundedToThreeDigits(*number * std::pow(10.0, exponent));
            if (percent <= coarsestOnScale && percent >= finestOnScale)
                steps.push_back(percent);
        }
    steps.push_back(0);
    return steps;
}

} // namespace

Accuracy WarpingChoice::with(double error) const
{
    switch (limit) {
    case WarpingLimit::Own: return {.error = error, .warping = percent};
    case WarpingLimit::None: return {.error = error, .warping = anyWarping};
    case WarpingLimit::AsError: break;
    }
    return {.error = error, .warping = error};
}

Accuracy bothWithin(double percent)
{
    return WarpingChoice().with(percent);
}

double accuracyPosition(double percent)
{
    if (percent <= 0)
        return 1;
    const double fraction = std::log(coarsestOnScale / percent) / std::log(coarsestOnScale / finestOnScale);
    return std::clamp(fraction, 0.0, 1.0) * logarithmicPart;
}

double accuracyAt(double position)
{
    if (position > (1 + logarithmicPart) / 2)
        return 0;
    const double fraction = std::clamp(position / logarithmicPart, 0.0, 1.0);
    return roundedToThreeDigits(coarsestOnScale * std::pow(finestOnScale / coarsestOnScale, fraction));
}

double steppedAccuracy(double percent, int steps)
{
    const std::vector<double> all = ladder();
    const auto last = static_cast<std::ptrdiff_t>(all.size()) - 1;
    const auto notCoarser = std::ranges::find_if(all, [&](double step) { return step <= percent; });
    std::ptrdiff_t index = std::min<std::ptrdiff_t>(notCoarser - all.begin(), last);
    // Between two round numbers the first step towards finer goes to the finer of the two, not past it.
    if (all[static_cast<std::size_t>(index)] < percent && steps > 0)
        --steps;
    index = std::clamp<std::ptrdiff_t>(index + steps, 0, last);
    return all[static_cast<std::size_t>(index)];
}

std::uint64_t steppedBudget(std::uint64_t budget, int steps)
{
    std::vector<double> ladder;
    for (double decade = 1000; decade < 1e10; decade *= 10)
        for (const double number : roundAccuracies)
            ladder.push_back(number * decade);
    const auto count = static_cast<double>(budget);
    auto index = std::ranges::lower_bound(ladder, count) - ladder.begin();
    // Between two round numbers the first step up goes to the next one, not past it.
    if (steps > 0 && index < std::ssize(ladder) && ladder[static_cast<std::size_t>(index)] > count)
        --steps;
    index = std::clamp<std::ptrdiff_t>(index + steps, 0, std::ssize(ladder) - 1);
    return static_cast<std::uint64_t>(ladder[static_cast<std::size_t>(index)]);
}

std::vector<CurvePoint> sizeAgainstError(const Model& model, const WarpingChoice& warping, int points)
{
    std::vector<CurvePoint> curve;
    const auto add = [&](double error) {
        const MeshSize size = meshSizeAt(model, warping.with(error));
        curve.push_back({error, size.sites, size.tetrahedra});
    };
    curve.reserve(static_cast<std::size_t>(points) + 1);
    for (int point = 0; point < points; ++point) {
        const double fraction = static_cast<double>(point) / (points - 1);
        add(coarsestOnScale * std::pow(finestOnScale / coarsestOnScale, fraction));
    }
    add(0);
    return curve;
}

double startingError(const Model& model)
{
    return startingError([&](double percent) { return meshSizeAt(model, bothWithin(percent)).tetrahedra; },
                         model.description().domain != DomainClass::RegularLattice);
}

double startingError(const std::function<std::uint64_t(double percent)>& tetrahedraAt, bool hasOwnShape)
{
    constexpr std::uint64_t small = 250'000, quick = 1'000'000, workable = 3'000'000;
    if (hasOwnShape)
        for (const double percent : {0.1, 0.2, 0.5})
            if (tetrahedraAt(percent) <= small)
                return percent;
    if (tetrahedraAt(1) <= quick)
        return 1;
    for (const double percent : {2.0, 3.0, 4.0})
        if (tetrahedraAt(percent) <= workable)
            return percent;
    double percent = 5;
    while (percent < coarsestOnScale && tetrahedraAt(percent) > workable)
        percent = steppedAccuracy(percent, -1);
    return percent;
}

} // namespace tetra
