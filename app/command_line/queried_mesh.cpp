// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/queried_mesh.h"

#include "app/command_line/error_statistics.h"
#include "app/command_line/table.h"
#include "core/data/value_scale.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace tetra {

void tellEmptySurfaces(std::span<const double> isovalues, const ValueRange& range, Outcome& outcome)
{
    std::vector<Message> remarks;
    for (const double isovalue : isovalues)
        if (isovalue < range.minimum || isovalue > range.maximum)
            remarks.emplace_back("The surface of " + formatNumber(isovalue) + " is empty: the data lie between " +
                                 formatNumber(range.minimum) + " and " + formatNumber(range.maximum) + ".");
    addRemarks(remarks, outcome);
}

namespace {

/// Values go over powers of ten where the largest is at least so many times the least.
constexpr double manyTimes = 1000;

/// A field of errors that is small near the value that may be mistaken, and elsewhere as large as it is now. It grows
/// by a quarter of what the values differ, so that nothing farther off comes as near.
std::string curingField(const ErrorRemark& remark, const TransferLimits& limits)
{
    constexpr double steepness = 0.25;
    const double outer = 100 * remark.error / (limits.largest - limits.least);
    const double inner = enoughPercent(remark, limits);
    const double falloff = std::max(outer - inner, 0.0) / 100 * (limits.largest - limits.least) / steepness;
    return "isovalues(" + formatNumber(remark.other) + "; " + formatNumber(inner) + ", " + rounded(outer, 3) + ", " +
           rounded(falloff, 3) + ")";
}

} // namespace

void warnOfErrors(std::span<const ErrorRemark> remarks, const ModelDescription& model, std::ostream& messages,
                  JsonObject& figures)
{
    const bool ofLogarithms = holdsLogarithms(model.parameters);
    const ValueRange& range = model.range;
    const TransferLimits limits{range.minimum, range.maximum};
    JsonValue& told = figures["remarks"]; // null where there is nothing to say
    JsonArray all = told.array() != nullptr ? *told.array() : JsonArray();
    for (const ErrorRemark& remark : remarks) {
        std::string text =
            errorRemarkText(remark, ofLogarithms).text() + " " + errorCureText(remark, limits, ofLogarithms).text();
        if (const double percent = enoughPercent(remark, limits); percent > 0)
            text += " Choose it with '--error " + formatNumber(percent) + "', or with '--field \"" +
                    curingField(remark, limits) + "\"'.";
        if (range.minimum > 0 && range.maximum >= manyTimes * range.minimum)
            text += " For values over powers of ten a model of their logarithms tells more: 'tan build --scale log'.";
        all.push_back(text);
        messages << text << "\n" << std::flush;
    }
    if (!remarks.empty())
        told = std::move(all);
}

std::string reachedText(const JsonObject& figures)
{
    if (!figures.contains("reached_error"))
        return "";
    const std::string errors = errorsUpTo(figures.numberAs<double>("reached_error").value_or(0), figures);
    std::string text = ", with " + errors;
    if (figures.contains("reached_factor"))
        text += " (a factor of " + factorText(figures.numberAs<double>("reached_factor").value_or(0)) + ")";
    if (const double warping = figures.numberAs<double>("reached_warping").value_or(0); warping > 0)
        text += (errors.find(',') != std::string::npos ? ", and a warping of up to " : " and a warping of up to ") +
                rounded(warping) + " %";
    return text;
}

} // namespace tetra
