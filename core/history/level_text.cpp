// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/history/level_text.h"

#include "core/base/json.h"
#include "core/base/text.h"

namespace tetra {

namespace {

struct Level {
    Accuracy asked;
    MeshSize size;
};

/// Without warping its columns are 0.
Level levelAt(const Model& model, Accuracy asked)
{
    const MeshSize size = meshSizeAt(model, asked);
    if (model.description().warpingWeight <= 0)
        asked.warping = 0;
    return {asked, size};
}

std::string jsonOf(const Level& level)
{
    return "{\"error\": " + formatNumber(level.asked.error) + ", \"warping\": " + formatNumber(level.asked.warping) +
           ", \"sites\": " + std::to_string(level.size.sites) +
           ", \"tetrahedra\": " + std::to_string(level.size.tetrahedra) +
           ", \"reached\": " + formatNumber(level.size.error) +
           ", \"reached_warping\": " + formatNumber(level.size.warping) + "}";
}

} // namespace

std::string levelsAsCsv(const Model& model, std::span<const Accuracy> levels)
{
    std::string text = "error_percent,warping_percent,sites,tetrahedra,reached_error_percent,reached_warping_percent\n";
    for (const Accuracy& asked : levels) {
        const Level level = levelAt(model, asked);
        text += formatNumber(level.asked.error) + "," + formatNumber(level.asked.warping) + "," +
                std::to_string(level.size.sites) + "," + std::to_string(level.size.tetrahedra) + "," +
                formatNumber(level.size.error) + "," + formatNumber(level.size.warping) + "\n";
    }
    return text;
}

std::string levelsAsJson(const Model& model, std::span<const Accuracy> levels)
{
    std::string list;
    for (const Accuracy& asked : levels)
        list += (list.empty() ? "\n    " : ",\n    ") + jsonOf(levelAt(model, asked));
    return "{\n  \"model\": " + jsonString(model.path().filename().string()) +
           ",\n  \"source\": " + jsonString(model.description().sourceName) +
           ",\n  \"builder\": " + jsonString(model.description().builder) +
           ",\n  \"sites\": " + std::to_string(model.siteCount()) +
           ",\n  \"tetrahedra\": " + std::to_string(model.tetrahedronCount()) +
           ",\n  \"bytes\": " + std::to_string(model.fileSize()) + ",\n  \"levels\": [" + list + "\n  ]\n}\n";
}

Result<std::string> levelsFor(const std::filesystem::path& path, const Model& model, std::span<const Accuracy> levels)
{
    const std::string ending = fileEnding(path);
    if (ending == ".csv")
        return levelsAsCsv(model, levels);
    if (ending == ".json")
        return levelsAsJson(model, levels);
    return Error{ErrorKind::WrongUsage, "'" + path.string() +
                                            "' ends in neither .csv nor .json, the formats in which statistics are "
                                            "written. Choose one of these endings."};
}

} // namespace tetra
