// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/result_output.h"

#include "app/command_line/option_values.h"
#include "app/command_line/plugin_options.h"
#include "core/base/text.h"

#include <unistd.h>

namespace tetra {

namespace {

constexpr std::string_view standardOutput = "-";
constexpr std::string_view standardOutputName = "standard output";

} // namespace

std::vector<Option> resultOptions(PluginHost& host, WrittenContent content)
{
    std::string formats;
    for (const std::string& ending : writableEndings(host, content))
        formats += (formats.empty() ? "" : "|") + ending.substr(1);
    return {outputOption(fileChoices(host, content),
                         "The file to write; '-' is standard output, in the format given by '--format'."),
            {.name = "format",
             .placeholder = formats.empty() ? "ENDING" : formats,
             .explanation =
                 "With '-o -': the format, given by the ending that a file's name would have. What is otherwise "
                 "printed on standard output, and with '--json' the object, goes to standard error."}};
}

Result<Destination> resultDestination(const Arguments& arguments)
{
    const std::string output = *arguments.value("output");
    const auto format = arguments.value("format");
    if (output != standardOutput && format)
        return Error{ErrorKind::WrongUsage, "'--format' can only be used with '-o -': the ending of a file's name "
                                            "determines its format. Leave it out, or name the file '" +
                                                std::filesystem::path(output).stem().string() + "." + *format + "'."};
    if (output != standardOutput)
        return Destination(output);
    if (!format)
        return Error{ErrorKind::WrongUsage,
                     "'-o -' needs to know the format: give it with '--format', as in '--format vtu'."};
    if (::isatty(STDOUT_FILENO) != 0)
        return Error{ErrorKind::WrongUsage, "Standard output is a terminal, which would take the file for commands. "
                                            "Redirect it ('> FILE', '| PROGRAM'), or name a file."};
    const std::string ending = smallLetters(format->starts_with('.') ? format->substr(1) : *format);
    return Destination(std::string(standardOutputName) + "." + ending, STDOUT_FILENO);
}

std::string shownName(const Destination& to)
{
    return to.stream >= 0 ? std::string(standardOutputName) : visibleText(to.path.string());
}

std::string nameInFigures(const Destination& to)
{
    return to.stream >= 0 ? std::string(standardOutput) : to.path.string();
}

bool asksForStandardOutput(std::span<const std::string> words)
{
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == "--output=-" ||
            ((words[i] == "-o" || words[i] == "--output") && i + 1 < words.size() && words[i + 1] == standardOutput))
            return true;
    return false;
}

} // namespace tetra
