// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/error_statistics.h"

#include "app/command_line/table.h"

#include <algorithm>

namespace tetra {

namespace {

QJsonObject toJson(const ResidualStatistics& statistics)
{
    return {{"largest", statistics.largest},
            {"mean", statistics.mean},
            {"percentile_99", statistics.percentile99},
            {"root_mean_square", statistics.rootMeanSquare}};
}

} // namespace

std::string guaranteeText(const ModelDescription& description)
{
    if (description.domain != DomainClass::Curvilinear)
        return {};
    const std::pair<std::string, std::string> inSpace("error-in", "space");
    return std::ranges::find(description.parameters, inSpace) != description.parameters.end()
               ? "\nThe error in the grid and the error in space, at the place where you look, are both guaranteed at "
                 "every accuracy; in a focus or a field, the error in the grid alone.\n"
               : "\nWhat is guaranteed is the error in the grid; the error in space, at the place where you look, may "
                 "be larger.\n";
}

void addStatistics(QJsonObject& figures, const ErrorStatistics& measured, DomainClass domain)
{
    figures["error_statistics"] = toJson(measured.error);
    QJsonObject inSpace = toJson(measured.errorInSpace);
    inSpace["outside"] = static_cast<qint64>(measured.errorInSpace.outside);
    figures["error_in_space"] = inSpace;
    if (canWarp(domain))
        figures["warping_statistics"] = toJson(measured.warping);
}

std::string statisticsText(const std::vector<NamedStatistics>& meshes, DomainClass domain)
{
    std::vector<std::vector<std::string>> rows = {
        {"mesh", "measured", "largest %", "mean %", "99th percentile %", "root mean square %"}};
    if (canWarp(domain))
        rows[0].emplace_back("points outside");
    const auto add = [&](const std::string& mesh, const char* what, const ResidualStatistics& statistics,
                         const std::string& outside) {
        rows.push_back({mesh, what, rounded(statistics.largest), rounded(statistics.mean),
                        rounded(statistics.percentile99), rounded(statistics.rootMeanSquare)});
        if (canWarp(domain))
            rows.back().push_back(outside);
    };
    for (const auto& [name, measured] : meshes) {
        const std::string outside = std::to_string(measured.errorInSpace.outside);
        if (domain == DomainClass::Curvilinear) {
            add(name, "error in the grid", measured.error, "-");
            add(name, "error in space", measured.errorInSpace, outside);
        } else {
            add(name, "error", measured.error, outside);
        }
        if (canWarp(domain))
            add(name, "warping", measured.warping, "-");
    }
    return table(rows);
}

} // namespace tetra
