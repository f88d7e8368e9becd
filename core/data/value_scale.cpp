// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data/value_scale.h"

#include "core/base/guarded.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tetra {

double portableLogarithm(double x) noexcept
{
    // x = m 2^k with m in [sqrt(1/2), sqrt(2)), and ln m = 2 artanh((m - 1) / (m + 1)), whose series ends soon.
    constexpr double log10Of2High = 0x1.34413509f78p-2; // its products with exponents are exact
    constexpr double log10Of2Low = 0x1.fef311f12b358p-46;
    constexpr double twiceLog10OfE = 0x1.bcb7b1526e50ep-1;
    constexpr int terms = 12; // the next one is below 2^-56 of the first
    int exponent = 0;
    double part = std::frexp(x, &exponent);
    if (part < 0x1.6a09e667f3bcdp-1) {
        part *= 2;
        --exponent;
    }
    const double ratio = (part - 1) / (part + 1);
    const double square = ratio * ratio;
    double sum = 0;
    for (int term = terms; term > 0; --term)
        sum = (sum + 1.0 / (2 * term + 1)) * square;
    const double ofPart = twiceLog10OfE * (ratio + ratio * sum);
    return exponent * log10Of2High + (exponent * log10Of2Low + ofPart);
}

std::string scaleText(const ValueScale& scale)
{
    if (!scale.logarithmic)
        return {};
    return scale.from ? "log:" + formatNumber(*scale.from) : "log";
}

Result<ValueScale> parseScale(std::string_view text)
{
    constexpr std::string_view withSmallest = "log:";
    if (text.empty() || text == "linear")
        return ValueScale{};
    if (text == "log")
        return ValueScale{.logarithmic = true};
    if (text.starts_with(withSmallest))
        if (const auto from = parseNumber<double>(text.substr(withSmallest.size()));
            from && *from > 0 && std::isfinite(*from))
            return ValueScale{.logarithmic = true, .from = *from};
    return Error{ErrorKind::WrongUsage,
                 Message::say("The scale '%1' is not understood. Give 'linear', 'log', or 'log:' and the positive "
                              "number that replaces smaller values, as in log:1e-6.",
                              text)};
}

std::string logarithmName(std::string_view valueName)
{
    return "log10(" + std::string(valueName.empty() ? "value" : valueName) + ")";
}

std::string nameOfLogarithms(std::string_view logarithmName)
{
    constexpr std::string_view front = "log10(";
    if (!logarithmName.starts_with(front) || !logarithmName.ends_with(')'))
        return std::string(logarithmName);
    return std::string(logarithmName.substr(front.size(), logarithmName.size() - front.size() - 1));
}

bool holdsLogarithms(std::span<const std::pair<std::string, std::string>> parameters)
{
    return std::ranges::any_of(parameters, [](const auto& parameter) {
        return parameter.first == scaleParameter && parameter.second.starts_with("log");
    });
}

Buffer<float> valuesOfLogarithms(std::span<const float> logarithms)
{
    Buffer<float> values(logarithms.size());
    std::ranges::transform(logarithms, values.begin(), [](float logarithm) {
        return static_cast<float>(std::pow(10.0, static_cast<double>(logarithm)));
    });
    return values;
}

std::optional<double> parseFieldValue(std::string_view text)
{
    const std::string inside = nameOfLogarithms(text);
    const bool isLogarithm = inside.size() < text.size();
    const auto number = parseNumber<double>(inside);
    if (!number || !std::isfinite(*number) || (isLogarithm && !(*number > 0)))
        return std::nullopt;
    return isLogarithm ? portableLogarithm(*number) : *number;
}

double factorOf(double percent, const ValueRange& range)
{
    return std::pow(10.0, percent / 100 * range.extent());
}

namespace {

/// How many values a scale has to do something about, and the smallest positive one.
struct Smallest {
    std::uint64_t below = 0; ///< smaller than ValueScale::from, or without one not positive
    double positive = std::numeric_limits<double>::infinity();
};

Smallest findSmallest(const ScalarField& field, const ValueScale& scale)
{
    return visitSampleType(field.type(), [&]<class T>() {
        const std::span<const T> samples = field.as<T>();
        using Part = tbb::blocked_range<std::size_t>;
        return tbb::parallel_reduce(
            Part(0, samples.size(), std::size_t(1) << 16), Smallest{},
            [&](const Part& part, Smallest found) {
                for (const T sample : samples.subspan(part.begin(), part.size())) {
                    const auto value = static_cast<double>(sample);
                    if (value > 0)
                        found.positive = std::min(found.positive, value);
                    if (scale.from ? value < *scale.from : !(value > 0))
                        ++found.below;
                }
                return found;
            },
            [](const Smallest& a, const Smallest& b) {
                return Smallest{a.below + b.below, std::min(a.positive, b.positive)};
            });
    });
}

/// Of values that no logarithm can be had of, and of a smallest value that leaves nothing.
Status checkPositive(const ScalarField& field, const ValueScale& scale, const Smallest& smallest)
{
    const auto wrong = [](const Message& text) { return Error{ErrorKind::WrongUsage, text}; };
    if (smallest.positive == std::numeric_limits<double>::infinity())
        return wrong(Message::say(
            "None of the %1 values is positive, so they have no logarithms. Choose the linear scale.", field.count()));
    if (scale.from && field.range().maximum <= *scale.from)
        return wrong(Message::say(
            "No value is larger than %1, which is to replace smaller ones: the largest is %2. Give a smaller number.",
            formatNumber(*scale.from), formatNumber(field.range().maximum)));
    if (scale.from || smallest.below == 0)
        return {};
    return wrong(Message::say("%1 of %2 values are not positive, so they have no logarithm. The smallest positive "
                              "value is %3: with the scale log:%3 smaller ones are replaced by that value.",
                              smallest.below, field.count(), formatNumber(smallest.positive)));
}

/// Nothing when cancelled.
Result<ScalarField> logarithmsOf(const ScalarField& field, const ValueScale& scale, const Progress& progress)
{
    constexpr std::size_t samplesInPiece = std::size_t(1) << 22; // from one look at cancellation to the next
    const double least = scale.from.value_or(0);
    auto memory = allocateSamples(SampleType::Float32, field.count());
    if (!memory)
        return memory.error();
    auto* const logarithms = reinterpret_cast<float*>(memory->get());
    const bool isDone = visitSampleType(field.type(), [&]<class T>() {
        const std::span<const T> samples = field.as<T>();
        for (std::size_t begin = 0; begin < samples.size(); begin += samplesInPiece) {
            if (progress.cancelled())
                return false;
            const std::size_t end = std::min(samples.size(), begin + samplesInPiece);
            tbb::parallel_for(begin, end, [&](std::size_t i) {
                logarithms[i] = static_cast<float>(portableLogarithm(std::max(static_cast<double>(samples[i]), least)));
            });
            progress.report(static_cast<double>(end) / static_cast<double>(samples.size()), Message::marked("Reading"));
        }
        return true;
    });
    if (!isDone)
        return cancelledError(Message::marked("Reading"));
    return ScalarField(SampleType::Float32, field.count(), *std::move(memory));
}

Result<Dataset> logarithmOf(const Dataset& dataset, const ValueScale& scale, const Progress& progress)
{
    const Smallest smallest = findSmallest(dataset.values, scale);
    if (const Status positive = checkPositive(dataset.values, scale, smallest); !positive)
        return positive.error();
    auto logarithms = logarithmsOf(dataset.values, scale, progress);
    if (!logarithms)
        return logarithms.error();
    if (const Status intact = dataset.checkIntact(); !intact)
        return intact.error();
    Dataset result = dataset;
    result.values = *std::move(logarithms);
    result.mappedFile = nullptr;
    result.source.valueName = logarithmName(dataset.source.valueName);
    result.source.hash = contentHash(result.values, result.positions, result.tetrahedra);
    if (smallest.below > 0)
        result.source.leftOut.push_back(Message::say("%1 of %2 values are smaller than %3, and were replaced by %3.",
                                                     smallest.below, dataset.values.count(),
                                                     formatNumber(*scale.from)));
    return result;
}

} // namespace

Result<Dataset> scaled(const Dataset& dataset, const ValueScale& scale, const Progress& progress)
{
    return guarded(
        Message::marked("Not enough memory for the logarithms of the values. Take a part of the data."),
        [&]() -> Result<Dataset> { return scale.logarithmic ? logarithmOf(dataset, scale, progress) : dataset; });
}

} // namespace tetra
