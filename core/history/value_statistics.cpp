// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/value_statistics.h"

#include "core/base/guarded.h"
#include "core/base/text.h"
#include "core/history/site_positions.h"

#include <tan/query.h>

#include <Eigen/Geometry>

#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace tetra {
namespace {

constexpr std::string_view meanName = "values.mean";
constexpr std::string_view deviationName = "values.deviation";

/// Some values, each with a weight: the sum of the squared distances is from their own mean, so that nothing cancels.
struct Moments {
    double weight = 0;
    double mean = 0;
    double squares = 0;

    static Moments together(const Moments& one, const Moments& other)
    {
        const double weight = one.weight + other.weight;
        if (!(weight > 0))
            return one;
        const double apart = other.mean - one.mean, share = other.weight / weight;
        return {weight, one.mean + apart * share, one.squares + other.squares + apart * apart * one.weight * share};
    }

    ValueStatistics statistics(ValueStatistics::Of of) const
    {
        return {mean, weight > 0 ? std::sqrt(squares / weight) : 0, of};
    }
};

/// Of a few values: the mean first, then the distances from it.
template <class T> Moments momentsOf(std::span<const T> values)
{
    Moments found{.weight = static_cast<double>(values.size())};
    for (const T value : values)
        found.mean += static_cast<double>(value);
    found.mean /= found.weight;
    for (const T value : values) {
        const double apart = static_cast<double>(value) - found.mean;
        found.squares += apart * apart;
    }
    return found;
}

/// Of a linear function in a tetrahedron with these values at its corners: with d their distances from the mean, the
/// integral of the squared distance is the volume times (d . d) / 20, as the distances have the sum 0.
Moments momentsOf(const std::array<double, 4>& values, double volume)
{
    const double mean = (values[0] + values[1] + values[2] + values[3]) / 4;
    double squares = 0;
    for (const double value : values)
        squares += (value - mean) * (value - mean);
    return {volume, mean, volume * squares / 20};
}

Result<Moments> finestMoments(const Model& model, const Progress& progress)
{
    const std::uint32_t sites = model.siteCount();
    Buffer<Eigen::Vector3d> positions;
    Buffer<float> values;
    if (const Status placed = placeSites(model, sites, positions); !placed)
        return placed.error();
    if (const Status copied = copyValues(model, sites, values); !copied)
        return copied.error();
    Moments all;
    const auto visit = [&](std::span<const std::array<std::uint32_t, 4>> tetrahedra) {
        Moments some;
        for (const auto& corners : tetrahedra) {
            const Eigen::Vector3d& first = positions[corners[0]];
            const Eigen::Vector3d a = positions[corners[1]] - first, b = positions[corners[2]] - first,
                                  c = positions[corners[3]] - first;
            const std::array<double, 4> at{values[corners[0]], values[corners[1]], values[corners[2]],
                                           values[corners[3]]};
            some = Moments::together(some, momentsOf(at, std::abs(a.dot(b.cross(c))) / 6));
        }
        all = Moments::together(all, some);
    };
    if (const Status visited = forEachTetrahedron(model, sites, visit, progress); !visited)
        return visited.error();
    return all;
}

Error sameValues()
{
    return {ErrorKind::WrongUsage,
            Message::say("All values are the same, so there are no standard deviations. Give a value of the data.")};
}

bool endsWithAnyCase(std::string_view text, std::string_view end)
{
    const auto small = [](char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); };
    return text.size() >= end.size() && std::ranges::equal(text.substr(text.size() - end.size()), end, {}, small);
}

} // namespace

bool isDensityMap(std::string_view sourceName)
{
    for (const std::string_view part : {", region ", ", stride "}) // as parts of datasets are called
        sourceName = sourceName.substr(0, sourceName.find(part));
    constexpr std::string_view packed = ".gz";
    if (endsWithAnyCase(sourceName, packed))
        sourceName.remove_suffix(packed.size());
    constexpr std::array<std::string_view, 3> endings{".mrc", ".ccp4", ".map"};
    return std::ranges::any_of(endings, [&](std::string_view ending) { return endsWithAnyCase(sourceName, ending); });
}

ValueStatistics statisticsOf(const ScalarField& values)
{
    constexpr std::size_t inPiece = std::size_t(1) << 14;
    const Moments all = visitSampleType(values.type(), [&]<class T>() {
        const std::span<const T> samples = values.as<T>();
        using Part = tbb::blocked_range<std::size_t>;
        return tbb::parallel_deterministic_reduce(
            Part(0, samples.size(), inPiece), Moments(),
            [&](const Part& part, const Moments& found) {
                return Moments::together(found, momentsOf(samples.subspan(part.begin(), part.size())));
            },
            &Moments::together);
    });
    return all.statistics(ValueStatistics::Of::Samples);
}

std::vector<std::pair<std::string, std::string>> statisticsTexts(const Dataset& dataset)
{
    if (!isDensityMap(dataset.source.name))
        return {};
    const ValueStatistics found = statisticsOf(dataset.values);
    return {{std::string(meanName), formatNumber(found.mean)},
            {std::string(deviationName), formatNumber(found.deviation)}};
}

std::optional<ValueStatistics> keptStatistics(std::span<const std::pair<std::string, std::string>> parameters)
{
    const auto numberOf = [&](std::string_view name) {
        const auto found = std::ranges::find(parameters, name, &std::pair<std::string, std::string>::first);
        return found == parameters.end() ? std::optional<double>() : parseNumber<double>(found->second);
    };
    const auto mean = numberOf(meanName), deviation = numberOf(deviationName);
    if (!mean || !deviation || !std::isfinite(*mean) || !std::isfinite(*deviation) || !(*deviation > 0))
        return std::nullopt;
    return ValueStatistics{*mean, *deviation, ValueStatistics::Of::Samples};
}

Result<ValueStatistics> statisticsOf(const Model& model, const Progress& progress)
{
    if (const auto kept = keptStatistics(model.description().parameters))
        return *kept;
    if (model.elsewhere() != nullptr)
        return Error{ErrorKind::WrongUsage,
                     Message::say("The model is at its server and keeps no mean and no standard deviation of its "
                                  "values, as those of density maps do. Give a value of the data.")};
    const auto moments =
        guarded(Message::marked("Not enough memory for the mean of the values. Give a value of the data."),
                [&] { return finestMoments(model, progress); });
    if (!moments)
        return moments.error();
    const ValueStatistics found = moments->statistics(ValueStatistics::Of::FinestMesh);
    return found.deviation > 0 ? Result(found) : sameValues();
}

std::optional<double> parseDeviations(std::string_view text)
{
    constexpr std::string_view unit = "sd";
    if (!text.ends_with(unit))
        return std::nullopt;
    const auto number = parseNumber<double>(text.substr(0, text.size() - unit.size()));
    return number && std::isfinite(*number) ? number : std::nullopt;
}

} // namespace tetra
