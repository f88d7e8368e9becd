// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/reproduction/reproduction.h"

#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/whole_file.h"
#include "app/reproduction/figures.h"
#include "app/reproduction/report.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>

#include <span>

namespace tetra {
namespace {

Result<std::set<int>> tablesOf(const Arguments& arguments)
{
    std::set<int> tables;
    const auto numbers = parseNumbers("tables", arguments.value("tables").value_or("1,2,3,4"), 1, 4);
    if (!numbers)
        return numbers.error();
    for (const double number : *numbers) {
        if (number != static_cast<int>(number))
            return Error{ErrorKind::WrongUsage, "--tables takes whole numbers from 1 to 4, as in '1,2,3'."};
        tables.insert(static_cast<int>(number));
    }
    return tables;
}

/// The report in each form, and the figures; gives the names of the files.
Result<std::vector<std::filesystem::path>> writeAll(const Reproduction& reproduction,
                                                    const std::filesystem::path& folder)
{
    auto files = drawFigures(reproduction, folder);
    if (!files)
        return files;
    const std::string json = QJsonDocument(jsonReport(reproduction)).toJson().toStdString();
    for (const auto& [name, text] : {std::pair<std::string, std::string>{"tables.txt", textReport(reproduction)},
                                     {"tables.md", markdownReport(reproduction)},
                                     {"tables.json", json}}) {
        if (const Status written = writeWholeFile(folder / name, std::as_bytes(std::span(text))); !written)
            return written.error();
        files->push_back(folder / name);
    }
    return files;
}

} // namespace

Syntax reproduceSyntax(PluginHost&)
{
    return {
        .purpose = "make the tables of the paper again",
        .explanation =
            "Builds the models of the paper (Cignoni and others, Multiresolution Representation and Visualization "
            "of Volume Data, 1997) from their datasets, and prints the sizes of their meshes beside the paper's. "
            "Tables 1 to 3: curvilinear grids, regular grids, regular grids in blocks. Table 4: isosurfaces, and how "
            "long pictures of surfaces, volumes and both take. Into "
            "the folder go the tables as text, Markdown and JSON, Figures 10 and 11 as PNG and SVG, and the "
            "models. What has no data is skipped, and said so.",
        .positionals = {},
        .options = {{.name = "tables",
                     .placeholder = "N[,N...]",
                     .explanation = "Which of the paper's tables.",
                     .byDefault = "1,2,3,4"},
                    {.name = "data",
                     .placeholder = "DIR",
                     .explanation = "The folder with the paper's figures (paper/table1.csv ...) and the datasets "
                                    "(bluntfin, post, sod, buckyball).",
                     .required = true},
                    outputOption("DIR", "The folder to write into; it is made if it does not exist.")},
        .examples = {{"tan reproduce --tables 1,2,3 --data data -o reproduction", "The sizes of all models."}}};
}

Result<Outcome> runReproduce(const Invocation& invocation)
{
    const auto tables = tablesOf(invocation.arguments);
    if (!tables)
        return tables.error();
    const std::filesystem::path folder = *invocation.arguments.value("output");
    const auto reproduction = reproduce(invocation.host, *invocation.arguments.value("data"), folder, *tables,
                                        invocation.progress.part(0, 0.98));
    if (!reproduction)
        return reproduction.error();
    const auto files = writeAll(*reproduction, folder);
    if (!files)
        return files.error();
    Outcome outcome{.figures = jsonReport(*reproduction), .text = textReport(*reproduction) + "\nWritten:\n"};
    QJsonArray names;
    for (const std::filesystem::path& file : *files) {
        names.append(QFile::decodeName(file.c_str()));
        outcome.text += "  " + file.string() + "\n";
    }
    outcome.figures["files"] = names;
    return outcome;
}

} // namespace tetra
