// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents/completions.h"

namespace tetra {
namespace {

/// For the inside of single quotes, where zsh's _arguments gives brackets and colons a meaning.
std::string insideQuotes(std::string_view text)
{
    std::string inside;
    for (const char character : withBackslashes(text, "[]:\\"))
        inside += character == '\'' ? std::string("'\\''") : std::string(1, character);
    return inside;
}

std::string specification(const Option& option)
{
    const auto names = spellings(option);
    const std::string exclusion = option.repeatable ? "*" : "(" + joined(names, " ") + ")";
    std::string value;
    if (!option.placeholder.empty()) {
        const auto words = choices(option);
        value = ":" + insideQuotes(words.empty() ? option.placeholder : "choice") + ":" +
                (words.empty() ? "_files" : "(" + joined(words, " ") + ")");
    }
    std::string text;
    for (const std::string& name : names)
        text += " \\\n            '" + exclusion + name + "[" + insideQuotes(firstSentence(option.explanation)) + "]" +
                value + "'";
    return text;
}

} // namespace

std::string zshCompletion(std::span<const DocumentedSubcommand> subcommands)
{
    std::string text = "#compdef tan\n# Completion of tan for zsh; written by its build.\nlocal -a subcommands\n"
                       "subcommands=(\n";
    for (const DocumentedSubcommand& subcommand : subcommands)
        text += "    '" + subcommand.name + ":" + insideQuotes(subcommand.syntax.purpose) + "'\n";
    text += ")\nif (( CURRENT == 2 )); then\n    _describe -t subcommands subcommand subcommands\n    _files\n"
            "    return\nfi\nshift words\n(( CURRENT-- ))\ncase $words[1] in\n";
    for (const DocumentedSubcommand& subcommand : subcommands) {
        text += "    " + subcommand.name + ")\n        _arguments";
        for (const Option& option : subcommand.syntax.options)
            text += specification(option);
        text += " \\\n            '*:file:_files' ;;\n";
    }
    return text + "esac\n";
}

} // namespace tetra
