// SPDX-License-Identifier: GPL-3.0-or-later
#include "plugins/readers/points/point_reader.h"

#include "plugins/api/placement_parameters.h"
#include "plugins/readers/points/point_columns.h"
#include "plugins/readers/points/point_table.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tetra {

namespace {

constexpr std::array<std::string_view, 4> ownNames = {".csv", ".tsv", ".xyz", ".pts"};
constexpr std::array<std::string_view, 3> textNames = {".txt", ".asc", ".dat"};

std::string_view asText(std::span<const std::byte> bytes)
{
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string extension(const std::filesystem::path& path)
{
    std::string text = path.extension().string();
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

Result<Dataset> datasetOf(PointTable table, const std::filesystem::path& path)
{
    auto dataset = scatteredDataset(std::move(table.positions), std::move(table.values), path.filename().string());
    if (!dataset)
        return dataset;
    dataset->source.path = path;
    dataset->source.valueName = table.head.valueName;
    dataset->source.taken = std::move(table.head.taken);
    dataset->source.leftOut = std::move(table.head.leftOut);
    dataset->lengthUnit = table.head.lengthUnit;
    if (table.parts > 1)
        dataset->remarks.insert(dataset->remarks.begin(),
                                Message::say("The points of its %1 parts were put together.", table.parts));
    if (table.skippedRows > 0)
        dataset->remarks.insert(dataset->remarks.begin(),
                                table.skippedRows == 1
                                    ? Message::say("1 incomplete row was skipped.")
                                    : Message::say("%1 incomplete rows were skipped.", table.skippedRows));
    return dataset;
}

PointTableRequest requestOf(const std::vector<Parameter>& parameters, const ParameterValues& values)
{
    return {parameterValue<std::string>(parameters, values, "positions"),
            parameterValue<std::string>(parameters, values, "array"),
            parameterValue<bool>(parameters, values, "skip-incomplete")};
}

/// Whether a column may be taken for the values: texts are not offered.
bool mayHold(const PointTableHead& head, std::size_t column)
{
    return head.columns[column].numbers > 0 || head.chosen.value == column;
}

} // namespace

std::vector<std::string> PointReader::nameFilters() const
{
    return {Message::marked("Table of points (*.csv *.tsv *.xyz *.pts *.txt *.asc)")};
}

double PointReader::score(const std::filesystem::path& path, std::span<const std::byte> firstBytes) const
{
    const std::string name = extension(path);
    if (asText(firstBytes).find('\0') != std::string_view::npos)
        return 0;
    const bool looksRight = looksLikePointTable(asText(firstBytes));
    if (std::ranges::find(ownNames, name) != ownNames.end())
        return looksRight ? 1 : 0.8; // to say what is wrong with it
    if (std::ranges::find(textNames, name) != textNames.end())
        return looksRight ? 0.7 : 0;
    return looksRight ? 0.1 : 0;
}

std::vector<Parameter> PointReader::parameters() const
{
    Parameter positions;
    positions.id = "positions";
    positions.label = Message::marked("Positions");
    positions.explanation =
        Message::marked("Tables of points: the columns of x, y and z, by name or number, as in a,b,c or 1,2,3; "
                        "'automatic' finds them by their names, or takes the first three if there are no names.");
    positions.defaultValue = std::string(automaticColumns);
    Parameter array;
    array.id = "array";
    array.label = Message::marked("Values");
    array.explanation =
        Message::marked("Tables of points: the column of the values, by its name or its number in the table, from 1; "
                        "'automatic' takes the first that is measured, not a counter or a constant.");
    array.defaultValue = std::string(automaticColumns);
    Parameter skip;
    skip.id = "skip-incomplete";
    skip.label = Message::marked("Skip incomplete rows");
    skip.explanation =
        Message::marked("Tables of points: leave out rows with a missing number, instead of refusing the file.");
    skip.defaultValue = false;
    return {positions, array, skip, unitParameter()};
}

Result<Dataset> PointReader::read(const std::filesystem::path& path, const ParameterValues& values,
                                  const Progress& progress) const
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    Result<PointTable> table =
        readPointTable(asText((*file)->bytes()), requestOf(parameters(), values), progress.part(0, 0.9));
    if ((*file)->damaged())
        return Error{ErrorKind::BadInput, Message::say("it changed while it was read. Read it again.")};
    if (!table)
        return table.error();
    if (table->values.size() > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorKind::OutOfResource,
                     Message::say("it has more than 4294967295 points. Take a part of them.")};
    auto dataset = datasetOf(std::move(*table), path);
    if (const std::string unit = placementText(values, "unit"); dataset && !unit.empty())
        dataset->lengthUnit = unit;
    progress.report(1, Message::marked("Reading"));
    return dataset;
}

Result<FileContents> PointReader::probe(const std::filesystem::path& path, const ParameterValues& values,
                                        const Progress& /*progress*/) const
{
    const auto file = MappedFile::open(path);
    if (!file)
        return file.error();
    auto head = readPointTableHead(asText((*file)->bytes()), requestOf(parameters(), values));
    if (!head)
        return head.error();
    FileContents contents{.domain = DomainClass::Scattered,
                          .type = SampleType::Float64,
                          .taken = std::move(head->taken),
                          .leftOut = std::move(head->leftOut)};
    if (head->lengthUnit.empty())
        contents.untold = {"unit"};
    const auto& position = head->chosen.position;
    const std::vector<std::string> labels = labelsOf(head->columns);
    for (std::size_t column = 0; column < head->columns.size(); ++column)
        if (std::ranges::find(position, column) == position.end() && mayHold(*head, column))
            contents.arrays.push_back({.name = labels[column], .unit = head->columns[column].name.unit});
    return contents;
}

} // namespace tetra
