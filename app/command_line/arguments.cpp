// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/arguments.h"

#include "app/command_line/nearest.h"

#include <algorithm>

namespace tetra {
namespace {

Error wrong(std::string text)
{
    return {ErrorKind::WrongUsage, std::move(text)};
}

/// What the user wrote, taken apart: "--name=value" or "-o".
struct OptionWord {
    std::string_view name;
    std::optional<std::string_view> value;
    bool isLetter = false;
};

std::optional<OptionWord> asOption(std::string_view word)
{
    if (word.starts_with("--") && word.size() > 2) {
        const auto equals = word.find('=');
        if (equals == std::string_view::npos)
            return OptionWord{word.substr(2), std::nullopt};
        return OptionWord{word.substr(2, equals - 2), word.substr(equals + 1)};
    }
    const bool isLetter = word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9') && word[1] != '.';
    if (isLetter)
        return OptionWord{word.substr(1), std::nullopt, true};
    return std::nullopt;
}

class Parser {
public:
    Parser(const Syntax& syntax, std::span<const std::string> words) : syntax_(syntax), words_(words) {}

    Result<Arguments> run()
    {
        arguments_.ownOptions = ownOptionNames(syntax_);
        bool optionsMayCome = true;
        while (next_ < words_.size()) {
            const std::string& word = words_[next_++];
            if (optionsMayCome && word == "--") {
                optionsMayCome = false;
                continue;
            }
            const auto option = optionsMayCome ? asOption(word) : std::nullopt;
            if (const Status taken = option ? takeOption(word, *option) : takePositional(word); !taken)
                return taken.error();
        }
        if (const Status complete = checkComplete(); !complete)
            return complete.error();
        return std::move(arguments_);
    }

private:
    Status takePositional(const std::string& word)
    {
        if (arguments_.positionals.size() == syntax_.positionals.size())
            return wrong("There is no place for '" + word + "'.");
        arguments_.positionals.push_back(word);
        return {};
    }

    Status takeOption(const std::string& word, const OptionWord& given)
    {
        const auto option = std::ranges::find_if(syntax_.options, [&](const Option& known) {
            return given.isLetter ? known.letter != 0 && given.name == std::string_view(&known.letter, 1)
                                  : known.name == given.name;
        });
        if (option == syntax_.options.end())
            return takeUsualSwitch(word, given);
        if (!option->repeatable && arguments_.has(option->name))
            return wrong("'" + word + "' is given twice.");
        if (option->name.starts_with("no-") && arguments_.has(option->name.substr(3)))
            return contradiction(option->name.substr(3));
        const auto value = takeValue(*option, given, word);
        if (!value)
            return value.error();
        arguments_.options.emplace_back(option->name, *value);
        return {};
    }

    /// "--shaded" beside "--no-shaded".
    Status takeUsualSwitch(const std::string& word, const OptionWord& given)
    {
        const std::string name(given.name);
        if (given.isLetter || std::ranges::find(syntax_.usualSwitches, name) == syntax_.usualSwitches.end())
            return unknown(given, word);
        if (given.value)
            return wrong("'--" + name + "' takes no value.");
        if (arguments_.has(name))
            return wrong("'" + word + "' is given twice.");
        if (arguments_.has("no-" + name))
            return contradiction(name);
        arguments_.options.emplace_back(name, "");
        return {};
    }

    Error contradiction(const std::string& name) const
    {
        return wrong("'--" + name + "' and '--no-" + name + "' contradict each other. Leave one of the two out.");
    }

    Result<std::string> takeValue(const Option& option, const OptionWord& given, const std::string& word)
    {
        if (option.placeholder.empty())
            return given.value ? Result<std::string>(wrong("'--" + option.name + "' takes no value."))
                               : Result<std::string>(std::string());
        if (given.value)
            return std::string(*given.value);
        if (next_ == words_.size() || words_[next_].starts_with("--"))
            return wrong("'" + word + "' needs a value: " + option.placeholder + ".");
        return words_[next_++];
    }

    Error unknown(const OptionWord& given, const std::string& word) const
    {
        std::vector<std::string> names;
        for (const Option& option : syntax_.options)
            names.push_back(option.name);
        const auto meant = nearest(given.name, names);
        return wrong("There is no option '" + word.substr(0, word.find('=')) + "'." +
                     (meant ? " Did you mean '--" + *meant + "'?" : ""));
    }

    Status checkComplete() const
    {
        for (std::size_t index = arguments_.positionals.size(); index < syntax_.positionals.size(); ++index)
            if (syntax_.positionals[index].required)
                return wrong(syntax_.positionals[index].name +
                             " is missing: " + syntax_.positionals[index].explanation);
        for (const Option& option : syntax_.options)
            if (option.required && !arguments_.has(option.name))
                return wrong("'--" + option.name + " " + option.placeholder + "' is missing: " + option.explanation);
        return {};
    }

    const Syntax& syntax_;
    std::span<const std::string> words_;
    std::size_t next_ = 0;
    Arguments arguments_;
};

} // namespace

bool Arguments::has(std::string_view name) const
{
    return std::ranges::any_of(options, [&](const auto& option) { return option.first == name; });
}

std::optional<std::string> Arguments::value(std::string_view name) const
{
    const auto found = std::ranges::find_if(options, [&](const auto& option) { return option.first == name; });
    return found == options.end() ? std::nullopt : std::optional(found->second);
}

std::vector<std::string> Arguments::values(std::string_view name) const
{
    std::vector<std::string> all;
    for (const auto& [option, value] : options)
        if (option == name)
            all.push_back(value);
    return all;
}

std::set<std::string, std::less<>> ownOptionNames(const Syntax& syntax)
{
    std::set<std::string, std::less<>> names;
    for (const Option& option : syntax.options)
        if (!option.ofPlugin)
            names.insert(option.name);
    return names;
}

Result<Arguments> parseArguments(const Syntax& syntax, std::span<const std::string> words)
{
    return Parser(syntax, words).run();
}

} // namespace tetra
