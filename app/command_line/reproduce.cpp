// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/reproduction.h"

#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "app/reproduction/builder_comparison.h"
#include "app/reproduction/comparison_report.h"
#include "app/reproduction/figures.h"
#include "app/reproduction/report.h"
#include "app/reproduction/report_text.h"
#include "app/reproduction/surface_comparison.h"
#include "core/base/file_writer.h"
#include "core/base/json_writer.h"
#include "core/base/text.h"

#include <span>

namespace tetra {
namespace {

/// What one run makes.
struct Reproduced {
    Reproduction tables;
    std::vector<ComparedDataset> comparison; ///< empty if not asked for
};

Result<std::set<int>> tablesOf(const Arguments& arguments)
{
    std::set<int> tables;
    if (arguments.has("compare-builders") && !arguments.has("tables"))
        return tables;
    const auto numbers = parseNumbers("tables", arguments.value("tables").value_or("1,2,3,4"), 1, 4);
    if (!numbers)
        return numbers.error();
    for (const double number : *numbers) {
        if (number != static_cast<int>(number))
            return Error{ErrorKind::WrongUsage, "--tables takes whole numbers from 1 to 4, as in '1,2,3'."};
        tables.insert(static_cast<int>(number));
    }
    constexpr int ofSurfaces = 4;
    if (tables.contains(ofSurfaces) && !canCompareSurfaces)
        return Error{ErrorKind::WrongUsage,
                     "Table 4 compares with surfaces that CGAL simplifies, and this TAn was built without CGAL "
                     "(TAN_CGAL). Give --tables 1,2,3."};
    return tables;
}

Result<Reproduced> make(const Invocation& invocation, const std::set<int>& tables, const std::filesystem::path& folder)
{
    const std::filesystem::path data = *invocation.arguments.value("data");
    const bool compares = invocation.arguments.has("compare-builders");
    const double part = !compares ? 0.98 : tables.empty() ? 0 : 0.5;
    Reproduced made;
    auto reproduction = reproduce(invocation.host, data, folder, tables, invocation.progress.part(0, part));
    if (!reproduction)
        return reproduction.error();
    made.tables = *std::move(reproduction);
    if (!compares)
        return made;
    auto comparison = compareBuilders(invocation.host, data, folder, invocation.progress.part(part, 0.98));
    if (!comparison)
        return comparison.error();
    made.comparison = *std::move(comparison);
    return made;
}

JsonObject figuresOf(const Reproduced& made)
{
    JsonObject figures = jsonReport(made.tables);
    if (!made.comparison.empty())
        figures["comparison"] = comparisonFigures(made.comparison);
    return figures;
}

std::string textOf(const Reproduced& made)
{
    const std::string tables = textReport(made.tables);
    return tables + (tables.empty() || made.comparison.empty() ? "" : "\n") + textOf(comparisonTables(made.comparison));
}

/// A report in each form, as NAME.txt, .md and .json.
Status writeReport(const std::filesystem::path& file, const std::string& text, const std::string& markdown,
                   const JsonObject& figures, std::vector<std::filesystem::path>& files)
{
    const std::string json = indentedJson(byName(figures));
    for (const auto& [ending, content] :
         {std::pair<std::string, std::string>{".txt", text}, {".md", markdown}, {".json", json}}) {
        std::filesystem::path path = file;
        path += ending;
        if (const Status written = writeWholeFile(path, std::as_bytes(std::span(content))); !written)
            return written;
        files.push_back(path);
    }
    return {};
}

/// The reports in each form, and the figures; gives the names of the files.
Result<std::vector<std::filesystem::path>> writeAll(const Reproduced& made, const std::filesystem::path& folder)
{
    auto files = drawFigures(made.tables, folder);
    if (!files)
        return files;
    if (!made.tables.tables.empty())
        if (const Status written = writeReport(folder / "tables", textReport(made.tables), markdownReport(made.tables),
                                               jsonReport(made.tables), *files);
            !written)
            return written.error();
    if (made.comparison.empty())
        return files;
    const auto charts = drawComparison(made.comparison, folder);
    if (!charts)
        return charts;
    files->insert(files->end(), charts->begin(), charts->end());
    const std::vector<ReportTable> tables = comparisonTables(made.comparison);
    if (const Status written =
            writeReport(folder / "builders", textOf(tables), markdownOf("Refinement and decimation", tables),
                        JsonObject{{"comparison", comparisonFigures(made.comparison)}}, *files);
        !written)
        return written.error();
    return files;
}

} // namespace

Syntax reproduceSyntax(PluginHost&)
{
    return {
        .purpose = "recreate the tables of the paper",
        .explanation =
            "Builds the models of the paper (Cignoni and others, Multiresolution Representation and Visualization of "
            "Volume Data, 1997) from their datasets, and prints the sizes of their meshes next to the paper's. Tables "
            "1 to 3: curvilinear grids, regular grids, regular grids in blocks. Table 4: isosurfaces, and how long "
            "pictures of surfaces, volumes and both take. The tables are written into the folder as text, Markdown and "
            "JSON, Figures 10 and 11 as PNG and SVG, the pictures of Figures 13 to 15 as PNG, and the models. Anything "
            "without data is skipped, with a message. With --compare-builders, instead of the tables unless they are "
            "named: refinement against decimation on convex, curvilinear and irregular data, with charts.",
        .positionals = {},
        .options = {{.name = "tables",
                     .placeholder = "N[,N...]",
                     .explanation = "Which of the paper's tables.",
                     .byDefault = "1,2,3,4"},
                    {.name = "compare-builders",
                     .placeholder = {},
                     .explanation = "Build models by refinement and by decimation, and compare their sites, "
                                    "tetrahedra, time and memory at the paper's accuracies."},
                    {.name = "data",
                     .placeholder = "DIR",
                     .explanation = "The folder with the paper's figures (paper/table1.csv ...) and the datasets "
                                    "(bluntfin, post, sod, buckyball, regular, irregular).",
                     .required = true},
                    outputOption("DIR", "The folder to write into; it is made if it does not exist.")},
        .examples = {{"tan reproduce --tables 1,2,3 --data data -o reproduction", "The sizes of all models."},
                     {"tan reproduce --compare-builders --data data -o builders", "Which builder needs how much."}}};
}

Result<Outcome> runReproduce(const Invocation& invocation)
{
    const auto tables = tablesOf(invocation.arguments);
    if (!tables)
        return tables.error();
    const std::filesystem::path folder = *invocation.arguments.value("output");
    const auto made = make(invocation, *tables, folder);
    if (!made)
        return made.error();
    const auto files = writeAll(*made, folder);
    if (!files)
        return files.error();
    Outcome outcome{.figures = figuresOf(*made), .text = textOf(*made) + "\nWritten:\n"};
    JsonArray names;
    for (const std::filesystem::path& file : *files) {
        names.push_back(file.string());
        outcome.text += "  " + visibleText(file.string()) + "\n";
    }
    outcome.figures["files"] = names;
    return outcome;
}

} // namespace tetra
