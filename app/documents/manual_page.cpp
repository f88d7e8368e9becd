// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents/manual_page.h"

#include "app/command_line/help.h"

#include <tan/version.h>

namespace tetra {
namespace {

/// Text as roff shows it as it is: dashes that can be copied, no line that looks like a request.
std::string escaped(std::string_view text)
{
    std::string roff;
    bool atLineStart = true;
    for (const char character : text) {
        if (atLineStart && (character == '.' || character == '\''))
            roff += "\\&";
        if (character == '\\')
            roff += "\\e";
        else if (character == '-')
            roff += "\\-";
        else if (character == '\'')
            roff += "\\(aq";
        else
            roff += character;
        atLineStart = character == '\n';
    }
    return roff;
}

std::string section(std::string_view name)
{
    return ".SH " + std::string(name) + "\n";
}

std::string entry(std::string_view what, std::string_view explanation)
{
    return ".TP\n" + std::string(what) + "\n" + escaped(explanation) + "\n";
}

std::string bold(std::string_view text)
{
    return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(std::string_view text)
{
    return "\\fI" + escaped(text) + "\\fR";
}

std::string entryOf(const Option& option)
{
    std::string what;
    for (const std::string& spelling : spellings(option))
        what += (what.empty() ? "" : ", ") + bold(spelling);
    if (!option.placeholder.empty())
        what += " " + italic(option.placeholder);
    std::string explanation = option.explanation;
    if (option.repeatable)
        explanation += " May be given several times.";
    if (!option.byDefault.empty())
        explanation += " Default: " + option.byDefault + ".";
    return entry(what, explanation);
}

std::string subsectionOf(const DocumentedSubcommand& subcommand)
{
    const Syntax& syntax = subcommand.syntax;
    std::string text = ".SS tan " + subcommand.name + "\n" + escaped(usage(subcommand.name, syntax)) + "\n.PP\n" +
                       escaped(syntax.explanation) + "\n";
    for (const Positional& positional : syntax.positionals)
        text += entry(italic(positional.name), positional.explanation);
    for (const Option& option : syntax.options)
        text += entryOf(option);
    if (!syntax.examples.empty())
        text += ".PP\nExamples:\n";
    for (const Example& example : syntax.examples)
        text += entry(bold(example.command), example.explanation);
    return text;
}

std::string entries(const std::vector<std::pair<std::string, std::string>>& rows)
{
    std::string text;
    for (const auto& [what, explanation] : rows)
        text += entry(bold(what), explanation);
    return text;
}

} // namespace

std::string manualPage(std::span<const DocumentedSubcommand> subcommands)
{
    std::string text = "'\\\" -*- coding: utf-8 -*-\n.TH TAN 1 \"\" \"TAn " TAN_VERSION "\" \"User Commands\"\n";
    text += section("NAME") + "tan \\- volume data as multiresolution models with a known error\n";
    text += section("SYNOPSIS") + "\\fBtan\\fR \\fISUBCOMMAND\\fR [\\fIARGUMENTS\\fR]\n.br\n\\fBtan\\fR "
                                  "[\\fIFILE\\fR]\n.br\n\\fBtan\\fR \\fB\\-\\-help\\fR | \\fB\\-\\-version\\fR\n";
    text += section("DESCRIPTION") +
            "With a subcommand, do something in the terminal; without, or with a file alone, "
            "open the window,\n.BR tan-desktop (1).\n.PP\n" +
            escaped(generalRemarks()) + "\n";
    text += section("SUBCOMMANDS");
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += entry(bold(subcommand.name), subcommand.syntax.purpose);
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += subsectionOf(subcommand);
    text += section("EXIT STATUS") + entries(exitCodes());
    text += section("ENVIRONMENT") + entries(environmentVariables());
    return text + section("SEE ALSO") + ".BR tan-desktop (1)\n";
}

} // namespace tetra
