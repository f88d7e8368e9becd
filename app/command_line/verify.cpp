// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/datasets.h"
#include "app/command_line/error_statistics.h"
#include "app/command_line/model_input.h"
#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "app/command_line/query_options.h"
#include "app/command_line/subcommands.h"
#include "app/command_line/table.h"
#include "core/base/text.h"
#include "core/data/value_scale.h"
#include "core/history/error_meaning.h"
#include "core/history/query_words.h"
#include "core/verify/verify_mesh.h"
#include "plugins/host/dataset_opening.h"

#include <tan/query.h>
#include <tan/verify.h>

#include <algorithm>

namespace tetra {
namespace {

JsonArray toJson(const std::vector<std::string>& texts)
{
    JsonArray list;
    for (const std::string& text : texts)
        list.push_back(text);
    return list;
}

JsonObject levelFigures(const LevelReport& level, bool warps, const ModelDescription& description)
{
    JsonObject figures = {{"error", level.asked.error},
                          {"warping", warps ? level.asked.warping : 0},
                          {"ok", level.ok()},
                          {"conforming", level.conforming},
                          {"covers", level.covers},
                          {"inverted", level.inverted},
                          {"inverted_in_data", level.invertedInData},
                          {"degenerate", level.degenerate},
                          {"largest_error", level.measured.error.largest},
                          {"largest_warping", level.measured.warping.largest},
                          {"sites", level.sites},
                          {"tetrahedra", level.tetrahedra},
                          {"failures", toJson(level.failures)}};
    if (holdsLogarithms(description.parameters))
        figures["largest_factor"] = factorOf(level.measured.error.largest, description.range);
    addStatistics(figures, level.measured, description.domain);
    if (level.twoSidedWarping) {
        figures["two_sided_warping"] = *level.twoSidedWarping;
        figures["two_sided_bound"] = level.twoSidedBound;
    }
    return figures;
}

std::vector<std::string> levelRow(const LevelReport& level, bool warps, bool twoSided)
{
    const auto yes = [](bool answer) { return std::string(answer ? "yes" : "NO"); };
    std::vector<std::string> row = {warps ? levelText(level.asked) : rounded(level.asked.error),
                                    yes(level.ok()),
                                    std::to_string(level.sites),
                                    std::to_string(level.tetrahedra),
                                    yes(level.conforming),
                                    yes(level.covers),
                                    std::to_string(level.inverted),
                                    rounded(level.measured.error.largest)};
    if (warps) {
        row.push_back(rounded(level.measured.warping.largest));
        row.push_back(std::to_string(level.degenerate));
    }
    if (twoSided)
        row.push_back(level.twoSidedWarping ? rounded(*level.twoSidedWarping) : "-");
    return row;
}

/// Each failure once, with all levels that it is true of.
std::string failureText(const VerificationReport& verdict, bool warps)
{
    std::string text;
    for (const std::string& failure : verdict.failures)
        text += "\n" + visibleText(failure);
    std::vector<std::pair<std::string, std::string>> levelsOfFailures;
    for (const LevelReport& level : verdict.levels)
        for (const std::string& failure : level.failures) {
            const std::string name = warps ? levelText(level.asked) : rounded(level.asked.error);
            const auto known =
                std::ranges::find(levelsOfFailures, failure, [](const auto& entry) { return entry.first; });
            if (known == levelsOfFailures.end())
                levelsOfFailures.emplace_back(failure, name);
            else
                known->second += ", " + name;
        }
    for (const auto& [failure, levels] : levelsOfFailures)
        text += "\nat " + levels + " %: " + visibleText(failure);
    return text.empty() ? text : text + "\n";
}

/// On what looks like a failure and is none, since the data themselves are so.
std::string remarksOn(const VerificationReport& verdict)
{
    std::string text;
    if (std::ranges::any_of(verdict.levels, [](const auto& level) { return level.invertedInData > 0; }))
        text += "\nInverted tetrahedra are not a failure where the data's own cells are folded or bent too far (" +
                std::to_string(verdict.foldedCells) + " folded).\n";
    if (verdict.touchingPoints > 0)
        text +=
            "\nPoints of the data that lie in or on a cell without being a corner of it: " +
            std::to_string(verdict.touchingPoints) +
            ". Parts touch or overlap there, so the data have several values at one place; the closest one counts.\n";
    return text;
}

Outcome describe(const VerificationReport& verdict, const std::string& path, const ModelDescription& description)
{
    const bool warps = description.warpingWeight > 0;
    Outcome outcome;
    JsonArray levels;
    // Beside what is claimed stands the error that models have had from the start; that in space has rows of its own.
    const bool isGrid = description.domain == DomainClass::Curvilinear;
    const std::string name = textFor(errorNames, isGrid ? ErrorMeaning::InGrid : ErrorMeaning::Only);
    std::vector<std::vector<std::string>> rows = {
        {"error %", "ok", "sites", "tetrahedra", "conforming", "covers", "inverted", "largest " + name + " %"}};
    if (warps) {
        rows[0][0] = "level %";
        rows[0].insert(rows[0].end(), {"largest warping %", "degenerate"});
    }
    const bool twoSided =
        std::ranges::any_of(verdict.levels, [](const auto& level) { return level.twoSidedWarping.has_value(); });
    if (twoSided)
        rows[0].emplace_back("from both sides %");
    const bool logarithms = holdsLogarithms(description.parameters);
    if (logarithms)
        rows[0].emplace_back("largest factor");
    std::vector<NamedStatistics> measured;
    for (const LevelReport& level : verdict.levels) {
        levels.push_back(levelFigures(level, warps, description));
        rows.push_back(levelRow(level, warps, twoSided));
        if (logarithms)
            rows.back().push_back(factorText(factorOf(level.measured.error.largest, description.range)));
        measured.push_back({rounded(level.asked.error) + " %", level.measured});
    }
    // Of another dataset's model there is nothing to show.
    const bool isUnchecked = !verdict.failures.empty() && std::ranges::all_of(verdict.levels, [](const auto& level) {
        return level.tetrahedra == 0;
    });
    outcome.isYes = verdict.ok();
    outcome.figures = {{"ok", verdict.ok()},
                       {"error_kind", wordOf(errorKindWords, errorMeaning(description))},
                       {"failures", toJson(verdict.failures)},
                       {"folded_cells", verdict.foldedCells},
                       {"touching_points", verdict.touchingPoints},
                       {"levels", levels}};
    outcome.text = shownInput(path) + (verdict.ok() ? ": proved\n" : ": NOT what it claims to be\n");
    if (!isUnchecked)
        outcome.text += "\n" + table(rows) + "\n" + statisticsText(measured, description.domain) +
                        guaranteeText(description, true) + logarithmText(description) + remarksOn(verdict);
    outcome.text += failureText(verdict, warps);
    return outcome;
}

/// Extracts the mesh that the query asks for, and proves it. A model that gives none is no proof.
Result<LevelReport> verifyExtracted(const std::shared_ptr<const Model>& model, const Dataset& original,
                                    const MeshQuery& query, const Progress& progress)
{
    constexpr double extracted = 0.3;
    MeshExtractor extractor(model);
    const auto mesh = extractor.extract(query, progress.part(0, extracted));
    auto level = mesh ? verifyMesh(*model, original, query, **mesh, progress.part(extracted, 1))
                      : Result<LevelReport>(mesh.error());
    const bool ofTheModel = !mesh || !model->checkIntact().ok();
    if (level || level.error().kind != ErrorKind::BadInput || !ofTheModel)
        return level;
    LevelReport verdict;
    verdict.asked = keptEverywhere(query, 1);
    verdict.failures = {level.error().text()};
    return verdict;
}

/// What is proved is a mesh of the whole domain.
Status checkWhole(const Arguments& arguments)
{
    for (const char* option : {"range", "births", "deaths"})
        if (arguments.has(option))
            return Error{ErrorKind::WrongUsage, "'--" + std::string(option) +
                                                    "' gives tetrahedra of many meshes, and one mesh is verified at a "
                                                    "time. Give accuracies of the range with '--lod'."};
    for (const char* option : {"window", "border", "values"})
        if (arguments.has(option))
            return Error{ErrorKind::WrongUsage, "'--" + std::string(option) +
                                                    "' chooses from the tetrahedra of a mesh that is verified as a "
                                                    "whole, including them. Leave it out."};
    return {};
}

} // namespace

Syntax verifySyntax(PluginHost& host)
{
    Option levels = levelsOption();
    levels.byDefault += "; none if another mesh is requested";
    Syntax syntax{
        .purpose = "prove that a model is what it claims to be",
        .explanation =
            "Checks with independent code, for each level of detail: every face of the mesh belongs to two cells or to "
            "the hull, the cells fill the domain exactly, none is flat or inverted, and the error at every sample of "
            "the original data is at most the one claimed; for curvilinear data also the warping, and that no cell is "
            "inverted in physical space except where the grid's own cells are folded or bent too far (those are "
            "counted). For irregular data, whose boundary may lie elsewhere: that the boundary is a manifold that does "
            "not intersect itself, with the components, the surfaces and the holes of the data, and how far it is from "
            "theirs. It also reports the overall error and warping: mean, 99th percentile and root mean square; for "
            "curvilinear data also the error in space, at the place where each point lies, next to the error in the "
            "grid, which is judged as well for models built with '--error-in space'; and for irregular data also the "
            "error at the nearest place, where a point lies outside the mesh. The file itself is checked as well: its "
            "checksums, its structure, and its values against the original ones.\nA model of a part of a dataset, or "
            "of an array of a file that holds several, records how that was opened; the options for it are needed only "
            "to check against something else.\nWith an error, a focus, a field or a budget the corresponding mesh is "
            "extracted and verified in the same way: its error at every sample is at most the one requested at that "
            "place.",
        .positionals = {{"MODEL", modelExplanation()}},
        .options = {{.name = "against",
                     .placeholder = "IN",
                     .explanation = "The dataset that the model was built from.",
                     .required = true},
                    levels,
                    tokenFileOption()},
        .examples = {{"tan verify engine.tan --against engine.nrrd", "All usual levels."},
                     {"tan verify engine.tan --against engine.nrrd --lod 1 --json", "One level, for a program."},
                     {"tan verify engine.tan --against engine.nrrd --focus sphere:120,100,60,30 --focus-error 0.5",
                      "The mesh that 'tan extract' would write for the same options."}}};
    std::ranges::move(queryOptions(), std::back_inserter(syntax.options));
    addImportOptions(syntax, host);
    syntax.exitCodes = {0, 1, 2, 3, 4, 130};
    return syntax;
}

Result<Outcome> runVerify(const Invocation& invocation)
{
    const std::string& path = invocation.arguments.positionals[0];
    if (const Status whole = checkWhole(invocation.arguments); !whole)
        return whole.error();
    const bool asksMesh = asksForMesh(invocation.arguments);
    const auto query = asksMesh ? queryOf(invocation.arguments) : Result<MeshQuery>(MeshQuery());
    if (!query)
        return query.error();
    const bool noLevels = asksMesh && !invocation.arguments.has("lod");
    const auto levels = noLevels ? std::vector<Accuracy>() : levelsOf(invocation.arguments);
    if (!levels)
        return levels.error();
    const double opened = isAtHand(path) ? 0 : 0.3;
    const auto found = openWholeInput(invocation, path, invocation.progress.part(0, opened));
    if (!found)
        return found.error();
    const std::shared_ptr<const Model>& model = found->model;
    const Progress progress = invocation.progress.part(opened, 1);
    if (const Status warps = checkWarpingOption(invocation.arguments, *model); !warps)
        return warps.error();
    const std::string against = *invocation.arguments.value("against");
    const auto options = importOptions(invocation, against, &model->description());
    if (!options)
        return options.error();
    const auto original = openDataset(invocation.host, against, *options, progress.part(0, 0.05));
    if (!original)
        return original.error();
    const double levelsEnd = asksMesh ? 0.5 : 1;
    auto verdict = verify(*model, *original, *levels, progress.part(0.05, levelsEnd));
    if (!verdict)
        return verdict.error();
    if (asksMesh) {
        auto level = verifyExtracted(model, *original, *query, progress.part(levelsEnd, 1));
        if (!level)
            return level.error();
        verdict->levels.push_back(*std::move(level));
    }
    Outcome outcome = describe(*verdict, path, model->description());
    addFaultyCells(*original, outcome);
    return outcome;
}

} // namespace tetra
