// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents/completions.h"

namespace tetra {
namespace {

std::string singleQuoted(std::string_view text)
{
    return "'" + withBackslashes(text, "'\\") + "'";
}

std::string lineFor(const std::string& subcommand, const Option& option)
{
    std::string line = "complete -c tan -n '__fish_seen_subcommand_from " + subcommand + "'";
    if (option.letter != 0)
        line += std::string(" -s ") + option.letter;
    line += " -l " + option.name;
    const auto words = choices(option);
    if (!words.empty())
        line += " -x -a " + singleQuoted(joined(words, " "));
    else if (!option.placeholder.empty())
        line += " -r";
    return line + " -d " + singleQuoted(firstSentence(option.explanation)) + "\n";
}

} // namespace

std::string fishCompletion(std::span<const DocumentedSubcommand> subcommands)
{
    std::string text = "# Completion of tan for fish; written by its build.\n";
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += "complete -c tan -n __fish_use_subcommand -a " + subcommand.name + " -d " +
                singleQuoted(subcommand.syntax.purpose) + "\n";
    for (const DocumentedSubcommand& subcommand : subcommands)
        for (const Option& option : subcommand.syntax.options)
            text += lineFor(subcommand.name, option);
    return text;
}

} // namespace tetra
