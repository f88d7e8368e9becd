// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"

#include "app/command_line/plugin_options.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "plugins/host/dataset_opening.h"
#include "plugins/host/input_file.h"
#include "plugins/host/time_choice.h"

#include <algorithm>
#include <array>
#include <span>

namespace tetra {
namespace {

JsonArray toJson(const Eigen::Vector3d& vector)
{
    return {vector[0], vector[1], vector[2]};
}

std::string sizeText(const Lattice& lattice)
{
    return std::to_string(lattice.size[0]) + " x " + std::to_string(lattice.size[1]) + " x " +
           std::to_string(lattice.size[2]);
}

std::string vectorText(const Eigen::Vector3d& vector, int digits)
{
    return "(" + rounded(vector[0], digits) + ", " + rounded(vector[1], digits) + ", " + rounded(vector[2], digits) +
           ")";
}

/// To the millimetre also in metres from far away, as those of UTM.
std::string placeText(const Eigen::Vector3d& place)
{
    constexpr int digits = 10;
    return vectorText(place, digits);
}

/// ", first point (10, 20, 30), axes along (0, 1, 0), ..." of a lattice, as far as it is not at 0 and along x, y and z.
std::string frameText(const Lattice& lattice)
{
    std::string text;
    if (!lattice.isAlongAxes() || !lattice.origin.isZero(0))
        text += ", first point " + placeText(lattice.origin);
    constexpr int digits = 4;
    for (Eigen::Index axis = 0; axis < 3 && !lattice.isAlongAxes(); ++axis)
        text += (axis == 0 ? ", axes along " : ", ") + vectorText(lattice.directions.col(axis), digits);
    return text;
}

/// "LPS" as "left-posterior-superior".
std::string spaceText(const std::string& space)
{
    std::string text;
    for (const char letter : space)
        text += std::string(text.empty() ? "" : "-") + (letter == 'R'   ? "right"
                                                        : letter == 'L' ? "left"
                                                        : letter == 'A' ? "anterior"
                                                        : letter == 'P' ? "posterior"
                                                        : letter == 'S' ? "superior"
                                                        : letter == 'I' ? "inferior"
                                                                        : "unknown");
    return text;
}

std::optional<std::uint64_t> cellsOf(DomainClass domain, const Lattice& lattice,
                                     std::optional<std::uint64_t> tetrahedra)
{
    if (domain == DomainClass::Irregular)
        return tetrahedra;
    return isOnLattice(domain) ? lattice.cellCount() : 0;
}

/// The reader that is asked for, or that the model's dataset was opened by if that knows the file, or the best one.
Result<Provided<Reader>> readerOf(const Invocation& invocation, const std::filesystem::path& path,
                                  const ModelDescription* model)
{
    if (const auto id = invocation.arguments.value("reader"))
        return chooseReader(invocation.host, path, id);
    if (const auto id = model != nullptr ? importReaderOf(*model) : std::nullopt)
        if (const auto known = invocation.host.reader(*id))
            if (const auto bytes = firstBytesOf(path); bytes && known->plugin->score(path, *bytes) > 0)
                return known;
    return chooseReader(invocation.host, path);
}

constexpr const char* timeId = "time";

/// Without the one whose value is found in the file.
std::vector<Parameter> withoutTime(std::vector<Parameter> parameters)
{
    std::erase_if(parameters, [](const Parameter& parameter) { return parameter.id == timeId; });
    return parameters;
}

Status takePartOptions(const Arguments& arguments, ImportOptions& options)
{
    DatasetPart& part = options.part;
    if (const auto text = arguments.value("region")) {
        const auto region = parseRegion(*text);
        if (!region)
            return region.error();
        part.region = *region;
    }
    if (const auto text = arguments.value("stride")) {
        const auto stride = parseStride(*text);
        if (!stride)
            return stride.error();
        part.stride = *stride;
    }
    if (const auto text = arguments.value("scale")) {
        const auto scale = parseScale(*text);
        if (!scale)
            return scale.error();
        options.scale = *scale;
    }
    return {};
}

} // namespace

void addImportOptions(Syntax& syntax, PluginHost& host)
{
    syntax.options.push_back({.name = "reader",
                              .placeholder = idChoices(host.readers()),
                              .explanation = "The reader plugin to use.",
                              .byDefault = "the one that suits the file best"});
    syntax.options.push_back(
        {.name = "region",
         .placeholder = "X0,Y0,Z0,X1,Y1,Z1",
         .explanation =
             "The part of the dataset to take: for grids the first and the last point along each axis, counted from 0; "
             "for other data a box in space, and for irregular meshes the tetrahedra that lie in it.",
         .byDefault = "all of it"});
    syntax.options.push_back({.name = "stride",
                              .placeholder = "N[,N,N]",
                              .explanation = "For grids: takes every Nth point along each axis.",
                              .byDefault = "1"});
    syntax.options.push_back({.name = "scale",
                              .placeholder = "linear|log|log:SMALLEST",
                              .explanation = "With log the logarithms to base 10 of the values are used, for values "
                                             "spanning many powers of ten: errors are then factors. All values must be "
                                             "positive, unless SMALLEST is given, which replaces smaller ones.",
                              .byDefault = "linear"});
    addPluginOptions(syntax, allParameters(host.readers()));
    for (Option& option : syntax.options)
        if (option.ofPlugin && option.name == timeId) {
            option.placeholder = "NUMBER|first|last|t=TIME";
            option.explanation += " For any file: the first or the last one, or that of a time, as in t=0.25.";
        }
}

Result<ImportOptions> importOptions(const Invocation& invocation, const std::filesystem::path& path,
                                    const ModelDescription* model)
{
    const Arguments& arguments = invocation.arguments;
    const auto reader = readerOf(invocation, path, model);
    if (!reader)
        return reader.error();
    const auto parameters = reader->plugin->parameters();
    if (const Status known = checkPluginOptions(arguments, allParameters(invocation.host.readers()), parameters,
                                                "reader '" + reader->id + "' of '" + path.string() + "'");
        !known)
        return known.error();
    const auto timeInWords = arguments.value(timeId).value_or("");
    const bool hasTimeInWords = arguments.has(timeId) && isTimeInWords(timeInWords);
    auto values = pluginValues(arguments, hasTimeInWords ? withoutTime(parameters) : parameters);
    if (!values)
        return values.error();
    const bool isSameReader = model != nullptr && importReaderOf(*model).value_or(reader->id) == reader->id;
    auto options = model != nullptr ? importOf(*model, isSameReader ? parameters : std::vector<Parameter>())
                                    : Result<ImportOptions>(ImportOptions());
    if (!options)
        return options;
    values->merge(options->values); // those of the model
    options->values = *std::move(values);
    options->reader = reader->id;
    if (const Status known = takePartOptions(arguments, *options); !known)
        return known.error();
    if (hasTimeInWords) {
        const auto step = timeStepOf(invocation.host, path, *options, timeInWords, invocation.progress.part(0, 0));
        if (!step)
            return step.error();
        options->values[timeId] = *step;
    }
    return options;
}

DatasetSummary summaryOf(const Dataset& dataset)
{
    return {dataset.domain,
            dataset.lattice,
            dataset.bounds(),
            dataset.values.type(),
            dataset.values.range(),
            cellsOf(dataset.domain, dataset.lattice, dataset.tetrahedra ? dataset.tetrahedra->size() : 0),
            canWarp(dataset.domain) ? std::optional(dataset.convex) : std::nullopt,
            dataset.space,
            dataset.lengthUnit};
}

DatasetSummary summaryOf(const Model& model)
{
    const ModelDescription& description = model.description();
    model.check(model.meshSizes().back()); // what it finds is known to checkIntact()
    // The finest mesh of irregular data is the dataset's own.
    DatasetSummary summary = summaryOf(description);
    summary.cells = cellsOf(description.domain, description.lattice, model.meshSizes().back());
    return summary;
}

DatasetSummary summaryOf(const ModelDescription& description)
{
    return {.domain = description.domain,
            .lattice = description.lattice,
            .bounds = description.bounds,
            .type = description.sampleType,
            .range = description.range,
            .cells = cellsOf(description.domain, description.lattice, {}),
            .space = description.space,
            .lengthUnit = description.lengthUnit};
}

JsonObject datasetFigures(const DatasetSummary& summary)
{
    const Lattice& lattice = summary.lattice;
    JsonObject figures = {{"kind", domainClassName(summary.domain)},
                          {"points", lattice.pointCount()},
                          {"range", JsonArray{summary.range.minimum, summary.range.maximum}},
                          {"type", sampleTypeName(summary.type)},
                          {"bounds", JsonArray{toJson(summary.bounds.min()), toJson(summary.bounds.max())}}};
    if (summary.cells)
        figures["cells"] = *summary.cells;
    if (isOnLattice(summary.domain))
        figures["size"] = JsonArray{lattice.size[0], lattice.size[1], lattice.size[2]};
    if (summary.domain == DomainClass::RegularLattice) {
        figures["spacing"] = toJson(lattice.spacing);
        figures["origin"] = toJson(lattice.origin);
        if (!lattice.isAlongAxes())
            figures["directions"] = JsonArray{toJson(lattice.directions.col(0)), toJson(lattice.directions.col(1)),
                                              toJson(lattice.directions.col(2))};
    }
    if (!summary.space.empty())
        figures["space"] = spaceText(summary.space);
    if (!summary.lengthUnit.empty())
        figures["unit"] = summary.lengthUnit;
    if (summary.convex)
        figures["convex"] = *summary.convex;
    return figures;
}

std::string datasetText(const DatasetSummary& summary)
{
    const Lattice& lattice = summary.lattice;
    const std::string type = "(" + std::string(sampleTypeName(summary.type)) + ")";
    std::string text;
    if (summary.domain == DomainClass::Irregular)
        text = (summary.convex.value_or(false) ? "convex mesh of " : "mesh of ") +
               std::to_string(lattice.pointCount()) + " points " + type +
               (summary.cells ? " in " + std::to_string(*summary.cells) + " tetrahedra" : "");
    else if (summary.domain == DomainClass::Scattered)
        text = "set of " + std::to_string(lattice.pointCount()) + " scattered points " + type;
    else if (summary.domain == DomainClass::Curvilinear)
        text = (summary.convex.value_or(false) ? "rectilinear grid of " : "curvilinear grid of ") + sizeText(lattice) +
               " points " + type;
    else
        text = "lattice of " + sizeText(lattice) + " points " + type + ", spacing " + rounded(lattice.spacing[0]) +
               " x " + rounded(lattice.spacing[1]) + " x " + rounded(lattice.spacing[2]) +
               (summary.lengthUnit.empty() ? "" : " " + visibleText(summary.lengthUnit)) + frameText(lattice);
    if (summary.domain != DomainClass::RegularLattice)
        text += ", from " + placeText(summary.bounds.min()) + " to " + placeText(summary.bounds.max()) +
                (summary.lengthUnit.empty() ? "" : " " + visibleText(summary.lengthUnit));
    if (!summary.space.empty())
        text += ", coordinates " + spaceText(summary.space);
    return text + ", values " + rangeText(summary.range.minimum, summary.range.maximum);
}

void addProvenance(std::span<const Taken> taken, std::span<const Message> leftOut, Outcome& outcome)
{
    JsonObject parts;
    JsonArray guesses, unused;
    std::string line;
    for (const Taken& one : taken) {
        const std::string name(takenPartName(one.part));
        parts[name] = one.what.text();
        if (one.guessed)
            guesses.push_back(name);
        line += (line.empty() ? "taken: " : "; ") + visibleText(takenText(one).text());
    }
    if (!line.empty())
        outcome.text += line + "\n";
    for (const Message& one : leftOut) {
        unused.push_back(one.text());
        outcome.text += "not used: " + visibleText(one.text()) + "\n";
    }
    outcome.figures["taken"] = parts;
    outcome.figures["guesses"] = guesses;
    outcome.figures["unused"] = unused;
}

namespace {

JsonArray toJson(std::span<const std::string> names)
{
    JsonArray list;
    for (const std::string& name : names)
        list.push_back(name);
    return list;
}

constexpr std::size_t mostShown = 20; ///< of what there is to choose from

/// "blocks: a, b, c", the first of them; nothing where there is no choice.
std::string choiceText(std::string_view what, std::span<const std::string> names)
{
    if (names.size() < 2)
        return {};
    std::string text = std::string(what) + ": ";
    for (std::size_t number = 0; number < std::min(names.size(), mostShown); ++number)
        text += (number == 0 ? "" : ", ") + visibleText(names[number]);
    if (names.size() > mostShown)
        text += " ... (" + std::to_string(names.size()) + " in all)";
    return text + "\n";
}

/// Names with commas in them, by which one is chosen or by its number.
std::string seriesText(std::span<const std::string> names)
{
    if (names.size() < 2)
        return {};
    std::string text = "series:\n";
    for (std::size_t number = 0; number < std::min(names.size(), mostShown); ++number)
        text += "  " + std::to_string(number + 1) + ": " + visibleText(names[number]) + "\n";
    return names.size() > mostShown ? text + "  ... (" + std::to_string(names.size()) + " in all)\n" : text;
}

std::string arrayText(const FileArray& array)
{
    std::string text = visibleText(array.name);
    if (array.components > 1)
        text += ", " + std::to_string(array.components) + " components";
    if (array.perCell)
        text += ", on cells";
    if (array.range)
        text += ", " + rangeText(array.range->minimum, array.range->maximum);
    // Behind a bare name a unit would look like a part of it.
    return array.unit.empty() ? text : text + (array.range ? " " : ", in ") + visibleText(array.unit);
}

} // namespace

void addContents(const FileContents& contents, Outcome& outcome)
{
    constexpr int timeDigits = 12; // hours since 1900 and seconds since 1970 stay apart, and 0.1 + 0.2 is 0.3
    JsonArray arrays, steps;
    std::vector<std::string> lines, times;
    for (const FileArray& array : contents.arrays) {
        if (array.name.empty() && array.components == 1)
            continue; // the only one, of which there is nothing to tell
        JsonObject figures{
            {"name", array.name}, {"components", array.components}, {"on", array.perCell ? "cells" : "points"}};
        if (array.range)
            figures["range"] = JsonArray{array.range->minimum, array.range->maximum};
        if (!array.unit.empty())
            figures["unit"] = array.unit;
        arrays.push_back(figures);
        lines.push_back(arrayText(array));
    }
    for (const double time : contents.timeSteps) { // with the numbers that choose them, which times are not
        steps.push_back(time);
        times.push_back(std::to_string(times.size() + 1) + " (time " + rounded(time, timeDigits) + ")");
    }
    outcome.figures["arrays"] = arrays;
    outcome.figures["steps"] = steps;
    outcome.figures["blocks"] = toJson(contents.blocks);
    outcome.figures["series"] = toJson(contents.series);
    outcome.figures["channels"] = toJson(contents.channels);
    if (lines.size() > 1) {
        outcome.text += "arrays:\n";
        for (const std::string& line : lines)
            outcome.text += "  " + line + "\n";
    }
    outcome.text += choiceText("time steps", times) + choiceText("blocks", contents.blocks) +
                    seriesText(contents.series) + choiceText("channels", contents.channels);
}

void addRemarks(const Dataset& dataset, Outcome& outcome)
{
    addProvenance(dataset.source.taken, dataset.source.leftOut, outcome);
    outcome.figures["remarks"] = JsonArray();
    addRemarks(dataset.remarks, outcome);
    addFaultyCells(dataset, outcome);
}

void addFaultyCells(std::span<const FaultyCell> cells, std::string_view where, Outcome& outcome)
{
    if (cells.empty())
        return;
    constexpr std::array<const char*, 7> names = {"not-finite",   "no-volume", "warped", "duplicate",
                                                  "crowded-face", "inverted",  "overlap"};
    constexpr std::size_t mostListed = 10'000, mostLines = 5;
    JsonArray list;
    for (const FaultyCell& one : cells.first(std::min(cells.size(), mostListed))) {
        list.push_back(JsonObject{{"cell", one.cell}, {"fault", names.at(static_cast<std::size_t>(one.fault))}});
        if (static_cast<std::size_t>(list.size()) <= mostLines)
            outcome.text += "Cell " + std::to_string(one.cell) + std::string(where) + ": " +
                            std::string(cellFaultText(one.fault)) + ".\n";
    }
    if (cells.size() > mostLines)
        outcome.text += "... and " + std::to_string(cells.size() - mostLines) + " more; --json lists them.\n";
    outcome.figures["faulty_cells"] = list;
    outcome.figures["faulty_cell_count"] = cells.size();
}

void addFaultyCells(const Dataset& dataset, Outcome& outcome)
{
    if (dataset.faultyCells)
        addFaultyCells(*dataset.faultyCells, " was left out", outcome);
}

Status addFaultyCells(const Model& model, Outcome& outcome)
{
    if (faultyCellCount(model) == 0)
        return {};
    const auto cells = faultyCells(model);
    if (!cells)
        return cells.error();
    outcome.text += "\n";
    addFaultyCells(*cells, model.description().domain == DomainClass::Curvilinear ? " of the grid" : " was left out",
                   outcome);
    return {};
}

} // namespace tetra
