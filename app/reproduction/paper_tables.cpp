// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/paper_tables.h"

#include "core/base/mapped_file.h"
#include "core/base/text.h"

#include <algorithm>
#include <span>
#include <sstream>

namespace tetra {

namespace {

std::vector<std::string> fieldsOf(const std::string& line)
{
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',')
            fields.emplace_back();
        else if (c != '\r')
            fields.back() += c;
    }
    return fields;
}

/// One of the paper's tables as a file of numbers under named columns. After the first thing that is wrong every
/// look-up gives nothing, and problem() says what it was.
class TableFile {
public:
    static Result<TableFile> read(const std::filesystem::path& path)
    {
        constexpr std::size_t mostBytes = 16 << 20;
        const auto text = wholeText(path, mostBytes);
        std::istringstream stream(text ? *text : std::string());
        TableFile file;
        file.path_ = path;
        std::string line;
        if (!text || !std::getline(stream, line))
            return Error{ErrorKind::BadInput, "Cannot read '" + path.string() +
                                                  "', which should hold the paper's figures. Does --data name the "
                                                  "folder that has 'paper' in it?"};
        file.columns_ = fieldsOf(line);
        while (std::getline(stream, line))
            if (!line.empty())
                file.rows_.push_back(fieldsOf(line));
        return file;
    }

    std::size_t rowCount() const { return rows_.size(); }

    std::string text(std::size_t row, const std::string& column)
    {
        const auto found = std::ranges::find(columns_, column);
        const auto index = static_cast<std::size_t>(found - columns_.begin());
        if (found != columns_.end() && index < rows_[row].size())
            return rows_[row][index];
        note(row, column);
        return {};
    }
    template <class Number> Number number(std::size_t row, const std::string& column)
    {
        const auto parsed = parseNumber<Number>(text(row, column));
        if (!parsed)
            note(row, column);
        return parsed.value_or(Number{});
    }
    bool has(const std::string& column) const { return std::ranges::find(columns_, column) != columns_.end(); }

    const std::optional<Error>& problem() const { return problem_; }

private:
    void note(std::size_t row, const std::string& column)
    {
        if (!problem_)
            problem_ = Error{ErrorKind::BadInput, "'" + path_.string() + "', line " + std::to_string(row + 2) +
                                                      ": there is no number under '" + column + "'."};
    }

    std::filesystem::path path_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
    std::optional<Error> problem_;
};

std::filesystem::path tablePath(const std::filesystem::path& folder, int table)
{
    return folder / ("table" + std::to_string(table) + ".csv");
}

PaperModel modelOf(TableFile& file, std::size_t row)
{
    PaperModel model;
    model.dataset = file.text(row, "dataset");
    for (std::size_t axis = 0; axis < 3; ++axis)
        model.size[axis] = file.number<std::uint32_t>(row, std::array{"dim_i", "dim_j", "dim_k"}[axis]);
    if (file.has("block_edge_as_printed"))
        model.blockEdge = file.number<std::uint64_t>(row, "block_edge_as_printed");
    model.tetrahedra = file.number<std::uint64_t>(row, "model_total_tetrahedra");
    model.bytes = 1024 * file.number<std::uint64_t>(row, "construction_peak_ram_kb");
    model.seconds = file.number<double>(row, "construction_time_cpu_seconds");
    return model;
}

PaperLevel levelOf(TableFile& file, std::size_t row)
{
    PaperLevel level;
    level.error = file.number<double>(row, "max_error_epsilon_percent_of_value_range");
    if (file.has("max_warping_delta_percent_of_bbox_diagonal"))
        level.warping = file.number<double>(row, "max_warping_delta_percent_of_bbox_diagonal");
    level.tetrahedra = file.number<std::uint64_t>(row, "lod_tetrahedra");
    level.sites = file.number<std::uint64_t>(row, "lod_sites");
    level.sitesPercent = file.number<double>(row, "lod_sites_percent_as_printed");
    return level;
}

} // namespace

Result<std::vector<PaperModel>> readPaperModels(const std::filesystem::path& folder, int table)
{
    auto file = TableFile::read(tablePath(folder, table));
    if (!file)
        return file.error();
    std::vector<PaperModel> models;
    for (std::size_t row = 0; row < file->rowCount(); ++row) {
        const PaperModel model = modelOf(*file, row);
        if (models.empty() || models.back().dataset != model.dataset || models.back().size != model.size)
            models.push_back(model);
        models.back().levels.push_back(levelOf(*file, row));
    }
    if (file->problem())
        return *file->problem();
    return models;
}

Result<std::vector<PaperSurface>> readPaperSurfaces(const std::filesystem::path& folder)
{
    auto file = TableFile::read(tablePath(folder, 4));
    if (!file)
        return file.error();
    std::vector<PaperSurface> surfaces;
    for (std::size_t row = 0; row < file->rowCount(); ++row)
        surfaces.push_back({file->text(row, "dataset"), file->number<double>(row, "isosurface_threshold"),
                            file->number<double>(row, "max_error_epsilon_percent_of_value_range"),
                            file->number<double>(row, "max_warping_delta_percent_of_bbox_diagonal"),
                            file->number<std::uint64_t>(row, "vertices"),
                            file->number<std::uint64_t>(row, "tetrahedra"),
                            file->number<std::uint64_t>(row, "isosurface_triangles"),
                            file->number<double>(row, "direct_volume_rendering_seconds")});
    if (file->problem())
        return *file->problem();
    return surfaces;
}

} // namespace tetra
