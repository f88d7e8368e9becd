// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/weighting.h"
#include "core/base/guarded.h"
#include "core/data/value_scale.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace tetra {

namespace {

double fallenTo(double distance, double reach, double floor)
{
    if (distance >= reach)
        return distance > 0 ? floor : 1;
    return 1 - (1 - floor) * (distance / reach);
}

} // namespace

double Weighting::weight(const Eigen::Vector3d& position, double value) const
{
    if (empty())
        return 1;
    double largest = 0;
    for (const SpaceWeight& place : places)
        largest = std::max(largest, fallenTo(place.box.exteriorDistance(position), place.reach, place.floor));
    for (const ValueWeight& term : values)
        largest = std::max(largest, fallenTo(std::abs(value - term.value), term.reach, term.floor));
    return largest;
}

Status weighPoints(const Weighting& weighting, const Dataset& dataset, std::span<float> weights,
                   const Progress& progress)
{
    constexpr std::uint64_t pointsAtOnce = 16384;
    visitSampleType(dataset.values.type(), [&]<class T>() {
        const std::span<const T> values = dataset.values.as<T>();
        tbb::parallel_for(tbb::blocked_range<std::uint64_t>(0, weights.size(), pointsAtOnce), [&](const auto& range) {
            if (progress.cancelled())
                return;
            for (std::uint64_t point = range.begin(); point != range.end(); ++point)
                weights[point] =
                    static_cast<float>(weighting.weight(dataset.position(point), static_cast<double>(values[point])));
        });
    });
    return progress.cancelled() ? Status(cancelledError(Message::marked("Weighting the points"))) : Status();
}

Result<std::vector<float>> pointWeights(const Weighting& weighting, const Dataset& dataset, const Progress& progress)
{
    if (weighting.empty())
        return std::vector<float>();
    return guarded(
        Message::marked(
            "Not enough memory for the weights of %1 points. Build without weights, or close other programs."),
        [&]() -> Result<std::vector<float>> {
            std::vector<float> weights(dataset.pointCount());
            if (const Status weighed = weighPoints(weighting, dataset, weights, progress); !weighed)
                return weighed.error();
            return weights;
        },
        dataset.pointCount());
}

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// What stands between the separators, trimmed.
std::vector<std::string_view> parts(std::string_view text, char separator)
{
    std::vector<std::string_view> found;
    for (;;) {
        const auto end = text.find(separator);
        found.push_back(trimmed(text.substr(0, end)));
        if (end == std::string_view::npos)
            return found;
        text.remove_prefix(end + 1);
    }
}

/// One kind of term: its name, its numbers, and how many of them come before the reach.
struct TermKind {
    std::string_view name;
    std::string_view form;
    std::size_t coordinates;
    bool mayEndSharply; ///< its reach may be 0
};
constexpr TermKind pointKind{"point", "point:x,y,z,reach[,floor]", 3, false};
constexpr TermKind boxKind{"box", "box:x0,y0,z0,x1,y1,z1,reach[,floor]", 6, true};
constexpr TermKind valueKind{"value", "value:q,reach[,floor]", 1, false};

const TermKind* kindOf(std::string_view name)
{
    for (const TermKind* kind : {&pointKind, &boxKind, &valueKind})
        if (kind->name == name)
            return kind;
    return nullptr;
}

Error wrong(std::string_view term, const Message& why)
{
    return {ErrorKind::WrongUsage, Message::say("The weight '%1' cannot be used: %2.", printable(term), why)};
}

/// The numbers of a term, the floor always among them.
Result<std::vector<double>> numbersOf(std::string_view term, std::string_view list, const TermKind& kind)
{
    std::vector<double> numbers;
    for (const std::string_view part : parts(list, ',')) {
        const bool isValue = &kind == &valueKind && numbers.empty();
        const std::optional<double> number = isValue ? parseFieldValue(part) : parseNumber<double>(part);
        if (!number || !std::isfinite(*number))
            return wrong(term, Message::say("'%1' is not a number", printable(part)));
        numbers.push_back(*number);
    }
    const std::size_t least = kind.coordinates + 1;
    if (numbers.size() != least && numbers.size() != least + 1)
        return wrong(term, Message::say("it has %1 numbers, and the form is %2", numbers.size(), kind.form));
    if (numbers.size() == least)
        numbers.push_back(defaultWeightFloor);
    const double reach = numbers[kind.coordinates];
    if (reach < 0 || (reach == 0 && !kind.mayEndSharply))
        return wrong(term, kind.mayEndSharply
                               ? Message::say("its reach is %1 and must be at least 0", formatNumber(reach))
                               : Message::say("its reach is %1 and must be above 0", formatNumber(reach)));
    if (numbers.back() < smallestWeightFloor || numbers.back() > 1)
        return wrong(term, Message::say("its floor is %1 and must be from %2 to 1", formatNumber(numbers.back()),
                                        formatNumber(smallestWeightFloor)));
    return numbers;
}

Status addTerm(std::string_view term, Weighting& weighting)
{
    const auto colon = term.find(':');
    const TermKind* kind = kindOf(trimmed(term.substr(0, colon)));
    if (kind == nullptr || colon == std::string_view::npos)
        return wrong(term, Message::say("a weight begins with 'point:', 'box:' or 'value:'"));
    const Result<std::vector<double>> numbers = numbersOf(term, term.substr(colon + 1), *kind);
    if (!numbers)
        return numbers.error();
    const std::vector<double>& n = *numbers;
    const double reach = n[kind->coordinates];
    if (kind == &valueKind) {
        weighting.values.push_back({n[0], reach, n.back()});
        return {};
    }
    const Eigen::Vector3d low(n[0], n[1], n[2]);
    const Eigen::Vector3d high = kind == &boxKind ? Eigen::Vector3d(n[3], n[4], n[5]) : low;
    if ((low.array() > high.array()).any())
        return wrong(term, Message::say("its first corner must be the smaller one along every axis"));
    weighting.places.push_back({{low, high}, reach, n.back()});
    return {};
}

std::string listOf(std::span<const double> numbers)
{
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "" : ",") + formatNumber(number);
    return text;
}

std::string weightText(const SpaceWeight& place)
{
    const Eigen::Vector3d& low = place.box.min();
    const Eigen::Vector3d& high = place.box.max();
    if (low == high && place.reach > 0)
        return "point:" + listOf(std::array{low[0], low[1], low[2], place.reach, place.floor});
    return "box:" + listOf(std::array{low[0], low[1], low[2], high[0], high[1], high[2], place.reach, place.floor});
}

} // namespace

Result<Weighting> parseWeighting(std::string_view text)
{
    Weighting weighting;
    if (trimmed(text).empty())
        return weighting;
    for (const std::string_view term : parts(text, ';'))
        if (const Status added = addTerm(term, weighting); !added)
            return added.error();
    return weighting;
}

std::string weightingText(const Weighting& weighting)
{
    std::string text;
    const auto add = [&text](const std::string& term) { text += (text.empty() ? "" : ";") + term; };
    for (const SpaceWeight& place : weighting.places)
        add(weightText(place));
    for (const ValueWeight& term : weighting.values)
        add("value:" + listOf(std::array{term.value, term.reach, term.floor}));
    return text;
}

} // namespace tetra
