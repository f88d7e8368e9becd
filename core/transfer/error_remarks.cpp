// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh of error e shows anything between v - e and v + e where the data have the value v. So where most of the domain
// has one value, whatever is made visible within e of that value may appear anywhere in it; and where the data come
// nearer than e to their least or their largest value, a surface beside that value may come and go.

#include "core/base/text.h"

#include <tan/transfer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace tetra {

namespace {

constexpr double seenOpacity = 0.01; ///< of a unit distance; less is not worth a remark
constexpr double contrast = 4;       ///< between what is seen and the background, in which it would not be noticed else
constexpr double share = 0.5;        ///< of the distance, for an error that is small enough

using Interval = std::array<double, 2>;

double extinctionIn(const TransferSegment& segment, double value)
{
    return segment.atOrigin.extinction + (value - segment.origin) * segment.perValue.extinction;
}

/// Calls `part(segment, begin, end)` for what of the function lies in an interval.
template <class Part> void eachPart(const TransferFunction& function, const Interval& interval, Part part)
{
    for (const TransferSegment& segment : transferSegments(function)) {
        const double begin = std::max(segment.begin, interval[0]);
        const double end = std::min(segment.end, interval[1]);
        if (begin < end)
            part(segment, begin, end);
    }
}

double largestExtinction(const TransferFunction& function, const Interval& interval)
{
    double most = 0;
    eachPart(function, interval, [&](const TransferSegment& segment, double begin, double end) {
        most = std::max({most, extinctionIn(segment, begin), extinctionIn(segment, end)});
    });
    return most;
}

/// Where the extinction reaches `least`: intervals in ascending order that do not touch.
std::vector<Interval> visibleIntervals(const TransferFunction& function, const Interval& range, double least)
{
    std::vector<Interval> intervals;
    const auto add = [&](double begin, double end) {
        if (!intervals.empty() && intervals.back()[1] >= begin)
            intervals.back()[1] = std::max(intervals.back()[1], end);
        else
            intervals.push_back({begin, end});
    };
    eachPart(function, range, [&](const TransferSegment& segment, double begin, double end) {
        const double atBegin = extinctionIn(segment, begin), atEnd = extinctionIn(segment, end);
        if (std::max(atBegin, atEnd) < least)
            return;
        const double crossing = begin + (end - begin) * (least - atBegin) / (atEnd - atBegin);
        add(atBegin >= least ? begin : std::min(crossing, end), atEnd >= least ? end : std::max(crossing, begin));
    });
    return intervals;
}

std::optional<ErrorRemark> isovalueRemark(double isovalue, const ErrorRemarkInput& input)
{
    if (!(isovalue >= input.range.least && isovalue <= input.range.largest))
        return std::nullopt;
    const auto near = [&](ErrorRemark::Kind kind, double other) -> std::optional<ErrorRemark> {
        const double distance = std::abs(isovalue - other);
        const double error = input.errorAt(other);
        if (!(error > 0) || distance > error)
            return std::nullopt;
        return ErrorRemark{kind, isovalue, other, error, share * distance};
    };
    for (const double end : {input.range.least, input.range.largest})
        if (const auto remark = near(ErrorRemark::Kind::IsovalueAtEnd, end))
            return remark;
    return input.background ? near(ErrorRemark::Kind::IsovalueAtBackground, input.background->commonest) : std::nullopt;
}

std::optional<ErrorRemark> backgroundRemark(const TransferFunction& transfer, const std::vector<Interval>& visible,
                                            const ErrorRemarkInput& input)
{
    const double background = input.background->commonest;
    const double error = input.errorAt(background);
    const double most = largestExtinction(
        transfer, {std::max(background - error, input.range.least), std::min(background + error, input.range.largest)});
    if (most < contrast * evaluate(transfer, background).extinction)
        return std::nullopt;
    std::optional<ErrorRemark> nearest;
    for (const Interval& interval : visible) {
        const double value = std::clamp(background, interval[0], interval[1]);
        const double distance = std::abs(value - background);
        if (distance > 0 && distance <= error && (!nearest || distance < std::abs(nearest->value - background)))
            nearest = {ErrorRemark::Kind::OpacityAtBackground, value, background, error, share * distance};
    }
    return nearest;
}

std::optional<ErrorRemark> opacityRemark(const TransferFunction& transfer, const ErrorRemarkInput& input)
{
    const std::vector<Interval> visible = visibleIntervals(transfer, {input.range.least, input.range.largest},
                                                           extinctionOf(seenOpacity, transfer.unitDistance));
    if (input.background)
        if (const auto remark = backgroundRemark(transfer, visible, input))
            return remark;
    for (const Interval& interval : visible) {
        const double middle = std::midpoint(interval[0], interval[1]);
        const double width = interval[1] - interval[0];
        if (const double error = input.errorAt(middle); width < error)
            return ErrorRemark{ErrorRemark::Kind::NarrowOpacity, middle, middle, error, share * width};
    }
    return std::nullopt;
}

/// In three digits: more of an error, or of where a curve crosses a limit, nobody needs.
std::string roundedNumber(double number, double significant = 3)
{
    if (number == 0 || !std::isfinite(number))
        return formatNumber(number);
    const double digits = significant - 1 - std::floor(std::log10(std::abs(number)));
    const double scale = std::pow(10, std::abs(digits));
    return formatNumber(digits > 0 ? std::round(number * scale) / scale : std::round(number / scale) * scale);
}

/// The numbers of a remark, of values or of logarithms.
struct RemarkWords {
    std::string value{}; ///< rounded
    std::string other{};
    std::string exactValue{}; ///< as it was given
    std::string exactOther{};
    Message error{};
};

/// As such a value is typed.
std::string valueOfLogarithm(double logarithm, double significant)
{
    return "log10(" + roundedNumber(std::pow(10, logarithm), significant) + ")";
}

Message factorOfError(double error)
{
    const double factor = std::pow(10, error);
    return Message::say("a factor of %1", roundedNumber(factor, factorDigits(factor)));
}

RemarkWords wordsOf(const ErrorRemark& remark, bool ofLogarithms)
{
    constexpr double coarse = 3, fine = 6, precise = 7; // that of floats
    if (!ofLogarithms)
        return {roundedNumber(remark.value), roundedNumber(remark.other), formatNumber(remark.value),
                roundedNumber(remark.other, precise), roundedNumber(remark.error)};
    return {valueOfLogarithm(remark.value, coarse), valueOfLogarithm(remark.other, coarse),
            valueOfLogarithm(remark.value, fine), valueOfLogarithm(remark.other, fine), factorOfError(remark.error)};
}

} // namespace

std::vector<ErrorRemark> errorRemarks(const ErrorRemarkInput& input)
{
    std::vector<ErrorRemark> remarks;
    if (!(input.range.least < input.range.largest) || !input.errorAt)
        return remarks;
    for (const double isovalue : input.isovalues)
        if (const auto remark = isovalueRemark(isovalue, input))
            remarks.push_back(*remark);
    if (input.transfer != nullptr)
        if (const auto remark = opacityRemark(*input.transfer, input))
            remarks.push_back(*remark);
    return remarks;
}

Message errorRemarkText(const ErrorRemark& remark, bool ofLogarithms)
{
    const RemarkWords words = wordsOf(remark, ofLogarithms);
    switch (remark.kind) {
    case ErrorRemark::Kind::IsovalueAtEnd:
        return Message::say("The isovalue %1 is within the displayed error, %2, of the end of the data range, %3: what "
                            "you see of its surface may be error alone.",
                            words.exactValue, words.error, words.exactOther);
    case ErrorRemark::Kind::IsovalueAtBackground:
        return Message::say("The isovalue %1 is within the displayed error, %2, of %3, the value of most of the "
                            "domain: what you see of its surface may be error alone.",
                            words.exactValue, words.error, words.other);
    case ErrorRemark::Kind::OpacityAtBackground:
        return Message::say("The transfer function shows values from %1 on, which is within the displayed error, %2, "
                            "of %3, the value of most of the domain: what you see there may be error alone.",
                            words.value, words.error, words.other);
    case ErrorRemark::Kind::NarrowOpacity:
        return Message::say("The values that the transfer function shows around %1 span less than the displayed error, "
                            "%2: the mesh cannot distinguish them from others.",
                            words.value, words.error);
    }
    return {};
}

double enoughPercent(const ErrorRemark& remark, const TransferLimits& range)
{
    const double percent = 100 * remark.enough / (range.largest - range.least);
    if (!(percent > 0) || !std::isfinite(percent))
        return 0;
    // A power of ten below one is not exact, so that its reciprocal divides.
    const int decade = static_cast<int>(std::floor(std::log10(percent)));
    const double unit = std::pow(10, std::abs(decade));
    return decade < 0 ? std::floor(percent * unit) / unit : std::floor(percent / unit) * unit;
}

Message errorCureText(const ErrorRemark& remark, const TransferLimits& range, bool ofLogarithms)
{
    const double percent = enoughPercent(remark, range);
    if (!(percent > 0))
        return Message::say("Choose other values.");
    return Message::say("An error of at most %1 % would be enough, everywhere or for values near %2 alone.",
                        formatNumber(percent), wordsOf(remark, ofLogarithms).other);
}

} // namespace tetra
