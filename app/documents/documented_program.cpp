// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/documents/documented_program.h"

#include "app/command_line/subcommand.h"

#include <algorithm>
#include <ranges>

namespace tetra {

std::vector<DocumentedSubcommand> documentedSubcommands(PluginHost& host)
{
    std::vector<DocumentedSubcommand> all;
    for (const Subcommand& subcommand : subcommands())
        all.push_back({std::string(subcommand.name), wholeSyntax(subcommand, host)});
    return all;
}

std::vector<std::string> spellings(const Option& option)
{
    std::vector<std::string> all;
    if (option.letter != 0)
        all.push_back(std::string("-") + option.letter);
    all.push_back("--" + option.name);
    return all;
}

std::vector<std::string> choices(const Option& option)
{
    std::vector<std::string> all;
    for (const auto part : option.placeholder | std::views::split('|'))
        all.emplace_back(part.begin(), part.end());
    // "VALUE" and "N|none" are no lists of words to choose from.
    const auto isWord = [](const std::string& word) {
        return !word.empty() && std::ranges::none_of(word, [](char c) { return c >= 'A' && c <= 'Z'; });
    };
    return all.size() > 1 && std::ranges::all_of(all, isWord) ? all : std::vector<std::string>();
}

std::string firstSentence(std::string_view text)
{
    const auto end = std::min(text.find(". "), text.find_first_of("\n"));
    text = text.substr(0, end);
    if (text.ends_with('.') || text.ends_with(':'))
        text.remove_suffix(1);
    return std::string(text);
}

std::string joined(const std::vector<std::string>& words, std::string_view separator)
{
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? std::string() : std::string(separator)) + word;
    return text;
}

std::string withBackslashes(std::string_view text, std::string_view special)
{
    std::string escaped;
    for (const char character : text) {
        if (special.find(character) != std::string_view::npos)
            escaped += '\\';
        escaped += character;
    }
    return escaped;
}

} // namespace tetra
