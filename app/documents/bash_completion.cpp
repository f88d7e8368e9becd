// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents/completions.h"

namespace tetra {
namespace {

std::string optionWords(const Syntax& syntax)
{
    std::vector<std::string> words;
    for (const Option& option : syntax.options)
        words.push_back("--" + option.name);
    return joined(words, " ");
}

/// The cases of what stands behind an option that takes a value: words to choose from, or a file.
std::string valueCases(const DocumentedSubcommand& subcommand)
{
    std::string text;
    for (const Option& option : subcommand.syntax.options) {
        if (option.placeholder.empty())
            continue;
        std::vector<std::string> patterns;
        for (const std::string& spelling : spellings(option))
            patterns.push_back(subcommand.name + "," + spelling);
        text += "        " + joined(patterns, "|") + ") words='" + joined(choices(option), " ") + "' ;;\n";
    }
    return text;
}

} // namespace

std::string bashCompletion(std::span<const DocumentedSubcommand> subcommands)
{
    std::vector<std::string> names;
    for (const DocumentedSubcommand& subcommand : subcommands)
        names.push_back(subcommand.name);
    std::string text = "# Completion of tan for bash; written by its build.\n_tan()\n{\n"
                       "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} words=\n"
                       "    case ${COMP_WORDS[1]},$previous in\n";
    if (!names.empty())
        text += "        *,tan|*,*/tan) [ \"$COMP_CWORD\" != 1 ] || words='" + joined(names, " ") +
                " --help --version' ;;\n";
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += valueCases(subcommand);
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += "        " + subcommand.name + ",*) [[ $current != -* ]] || words='" + optionWords(subcommand.syntax) +
                "' ;;\n";
    return text + "    esac\n    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n}\n"
                  "complete -o default -F _tan tan\n";
}

} // namespace tetra
