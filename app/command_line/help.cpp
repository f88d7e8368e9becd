// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/help.h"

#include <algorithm>

namespace tetra {
namespace {

constexpr std::size_t lineWidth = 100;

/// `text` in lines of at most lineWidth, all but the first one indented. Line ends in the text are kept.
std::string wrapped(std::string_view text, std::size_t firstColumn, std::size_t indent)
{
    std::string lines;
    std::size_t column = firstColumn;
    bool atStart = true;
    const auto breakLine = [&] {
        lines += "\n" + std::string(indent, ' ');
        column = indent;
        atStart = true;
    };
    while (!text.empty()) {
        if (text.front() == '\n') {
            breakLine();
            text.remove_prefix(1);
            continue;
        }
        const auto end = std::min(text.find_first_of(" \n"), text.size());
        if (!atStart && column + 1 + end > lineWidth)
            breakLine();
        if (!atStart) {
            lines += ' ';
            ++column;
        }
        lines += text.substr(0, end);
        column += end;
        atStart = false;
        text.remove_prefix(end);
        if (text.starts_with(' '))
            text.remove_prefix(1);
    }
    return lines;
}

/// Two columns: what, and its explanation beside it.
std::string listed(const std::vector<std::pair<std::string, std::string>>& rows)
{
    constexpr std::size_t widestLeft = 30;
    std::size_t width = 0;
    for (const auto& [left, right] : rows)
        if (left.size() <= widestLeft)
            width = std::max(width, left.size());
    std::string text;
    const std::size_t indent = 2 + width + 2;
    for (const auto& [left, right] : rows) {
        text += "  " + left;
        text += left.size() > width ? "\n" + std::string(indent, ' ') : std::string(width - left.size() + 2, ' ');
        text += wrapped(right, indent, indent) + "\n";
    }
    return text;
}

std::pair<std::string, std::string> row(const Option& option)
{
    std::string left = option.letter != 0 ? std::string("-") + option.letter + ", " : "";
    left += "--" + option.name;
    if (!option.placeholder.empty())
        left += " " + option.placeholder;
    std::string right = option.explanation;
    if (option.repeatable)
        right += " May be given several times.";
    if (!option.byDefault.empty())
        right += " [default: " + option.byDefault + "]";
    return {left, right};
}

} // namespace

std::string usage(std::string_view name, const Syntax& syntax)
{
    std::string text = "tan " + std::string(name);
    for (const Positional& positional : syntax.positionals)
        text += positional.required ? " " + positional.name : " [" + positional.name + "]";
    for (const Option& option : syntax.options)
        if (option.required)
            text += option.letter != 0 ? std::string(" -") + option.letter + " " + option.placeholder
                                       : " --" + option.name + " " + option.placeholder;
    return text + " [OPTIONS]";
}

std::vector<std::pair<std::string, std::string>> exitCodes()
{
    return {
        {"0", "done"},
        {"1", "verification failed: the model is not what it claims to be"},
        {"2", "wrong usage: an unknown option, an invalid value, an output that would replace its input"},
        {"3", "bad input: a file that is missing, damaged, or of an unknown format"},
        {"4", "the result could not be written, or memory or another resource ran out"},
        {"5", "not yet: parts of a shared build that others are still to make are missing"},
        {"130", "cancelled (Ctrl-C)"},
    };
}

std::vector<std::pair<std::string, std::string>> exitCodes(const std::vector<int>& codes)
{
    auto some = exitCodes();
    std::erase_if(some, [&](const auto& entry) { return std::ranges::count(codes, std::stoi(entry.first)) == 0; });
    return some;
}

std::vector<std::pair<std::string, std::string>> environmentVariables()
{
    return {
        {"TAN_PLUGIN_PATH", "more folders with plugins, separated by ':'"},
        {"TAN_PLUGIN_DISABLE", "ids of plugins not to be loaded, separated by ','"},
        {"TAN_CACHE_MB",
         "maximum size of the model cache in megabytes (of 1,000,000 bytes; default: 8590, which is 8 GiB)"},
    };
}

std::string generalRemarks()
{
    return "Figures go to standard output, progress and messages to standard error; with --json, standard output is "
           "one JSON object and nothing else. Accuracies are percentages of the data's range of values. Numbers are "
           "written with a decimal point in every locale.";
}

std::string programHelp(const std::vector<std::pair<std::string, std::string>>& subcommands)
{
    return "tan: Tetrahedra Analyzer. Volume data as multiresolution models with a known error.\n\n"
           "Usage: tan SUBCOMMAND [ARGUMENTS]     do something here; 'tan help SUBCOMMAND' explains each\n"
           "       tan [FILE]                     open the window, with a dataset or a model\n"
           "       tan --help | --version\n\n"
           "Subcommands:\n" +
           listed(subcommands) + "\n" + wrapped(generalRemarks(), 0, 0) +
           "\n\n"
           "Examples:\n"
           "  tan sample c60 --size 64 -o c60.nrrd\n"
           "  tan build c60.nrrd -o c60.tan\n"
           "  tan render c60.tan --error 1 --isovalue 140:orange -o c60.png\n\n"
           "Environment:\n" +
           listed(environmentVariables()) + "\nExit codes:\n" + listed(exitCodes());
}

std::string subcommandHelp(std::string_view name, const Syntax& syntax)
{
    std::string text = "tan " + std::string(name) + ": " + syntax.purpose + "\n\nUsage: " + usage(name, syntax) +
                       "\n\n" + wrapped(syntax.explanation, 0, 0) + "\n";
    std::vector<std::pair<std::string, std::string>> rows;
    for (const Positional& positional : syntax.positionals)
        rows.emplace_back(positional.name, positional.explanation);
    if (!rows.empty())
        text += "\nArguments:\n" + listed(rows);
    rows.clear();
    std::ranges::transform(syntax.options, std::back_inserter(rows), row);
    text += "\nOptions:\n" + listed(rows);
    if (!syntax.examples.empty())
        text += "\nExamples:\n";
    for (const Example& example : syntax.examples)
        text += "  " + example.command + "\n      " + wrapped(example.explanation, 6, 6) + "\n";
    return text + "\nExit codes:\n" + listed(exitCodes(syntax.exitCodes));
}

} // namespace tetra
