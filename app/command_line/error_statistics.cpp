// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/error_statistics.h"

#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"

#include <cmath>

namespace tetra {

namespace {

JsonObject toJson(const ResidualStatistics& statistics)
{
    return {{"largest", statistics.largest},
            {"mean", statistics.mean},
            {"percentile_99", statistics.percentile99},
            {"root_mean_square", statistics.rootMeanSquare}};
}

/// Of figures that do not say it, such as those of an older server, there is one error.
ErrorMeaning meaningOf(const JsonObject& figures)
{
    const JsonValue* const kind = figures.find("error_kind");
    const std::string* const word = kind != nullptr ? kind->string() : nullptr;
    const auto meaning = word != nullptr ? choiceOf<ErrorMeaning>(errorKindWords, *word) : std::nullopt;
    return meaning.value_or(ErrorMeaning::Only);
}

std::string paragraph(ErrorMeaning meaning, bool isMeasured)
{
    if (meaning == ErrorMeaning::Only)
        return {};
    const bool isAdvised = meaning == ErrorMeaning::InGrid && !isMeasured;
    return "\n" + std::string(textFor(errorPromises, meaning)) +
           (isAdvised ? " " + std::string(errorInSpaceAdvice) : "") + "\n";
}

} // namespace

std::string guaranteeText(const ModelDescription& description, bool isMeasured)
{
    return paragraph(errorMeaning(description), isMeasured);
}

std::string guaranteeText(const JsonObject& figures)
{
    const bool isOneMesh = figures.contains("error");
    const bool isKnown = meaningOf(figures) != ErrorMeaning::InGrid || figures.contains("error_in_space");
    return isOneMesh && !isKnown ? paragraph(ErrorMeaning::InGrid, false) : std::string();
}

std::string errorsUpTo(double percent, const JsonObject& figures)
{
    const ErrorMeaning meaning = meaningOf(figures);
    std::string text = std::string(textFor(errorsNames, meaning)) + " of up to " + rounded(percent) + " %";
    const JsonValue* const inSpace = figures.find("error_in_space");
    if (meaning == ErrorMeaning::InGrid && inSpace != nullptr && inSpace->object() != nullptr)
        text += ", in space of up to " + rounded(inSpace->object()->numberAs<double>("largest").value_or(0)) + " %";
    return text;
}

void addErrorInSpace(JsonObject& figures, const ErrorInSpace& measured)
{
    JsonObject inSpace = toJson(measured);
    inSpace["outside"] = measured.outside;
    figures["error_in_space"] = inSpace;
}

std::string logarithmText(const std::string& valueName, const ValueRange& range)
{
    return "\nThe values are logarithms to base 10: " + visibleText(nameOfLogarithms(valueName)) + " goes from " +
           rounded(std::pow(10.0, range.minimum)) + " to " + rounded(std::pow(10.0, range.maximum)) +
           ", and an error of 1 % of the logarithms' range is a factor of " + factorText(factorOf(1, range)) + ".\n";
}

std::string logarithmText(const ModelDescription& description)
{
    return holdsLogarithms(description.parameters) ? logarithmText(description.valueName, description.range)
                                                   : std::string();
}

void addStatistics(JsonObject& figures, const ErrorStatistics& measured, DomainClass domain)
{
    figures["error_statistics"] = toJson(measured.error);
    addErrorInSpace(figures, measured.errorInSpace);
    if (measured.errorAtNearest)
        figures["error_at_nearest"] = toJson(*measured.errorAtNearest);
    if (canWarp(domain))
        figures["warping_statistics"] = toJson(measured.warping);
}

std::string statisticsText(const std::vector<NamedStatistics>& meshes, DomainClass domain)
{
    std::vector<std::vector<std::string>> rows = {
        {"mesh", "measured", "largest %", "mean %", "99th percentile %", "root mean square %"}};
    if (canWarp(domain))
        rows[0].emplace_back("points outside");
    const auto add = [&](const std::string& mesh, const std::string& what, const ResidualStatistics& statistics,
                         const std::string& outside) {
        rows.push_back({mesh, what, rounded(statistics.largest), rounded(statistics.mean),
                        rounded(statistics.percentile99), rounded(statistics.rootMeanSquare)});
        if (canWarp(domain))
            rows.back().push_back(outside);
    };
    for (const auto& [name, measured] : meshes) {
        const std::string outside = std::to_string(measured.errorInSpace.outside);
        if (domain == DomainClass::Curvilinear) {
            add(name, textFor(errorNames, ErrorMeaning::InGrid), measured.error, "-");
            add(name, textFor(errorNames, ErrorMeaning::InSpace), measured.errorInSpace, outside);
        } else {
            add(name, textFor(errorNames, ErrorMeaning::Only), measured.error, outside);
        }
        if (measured.errorAtNearest)
            add(name, "error at the nearest place", *measured.errorAtNearest, outside);
        if (canWarp(domain))
            add(name, "warping", measured.warping, "-");
    }
    return table(rows);
}

} // namespace tetra
