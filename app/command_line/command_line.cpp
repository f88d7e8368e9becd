// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.h"

#include "app/command_line/help.h"
#include "app/command_line/nearest.h"
#include "app/command_line/progress_line.h"
#include "app/command_line/result_output.h"
#include "app/command_line/subcommand.h"
#include "core/base/json_writer.h"
#include "core/base/system_error.h"
#include "core/base/text.h"

#include <tan/open.h>
#include <tan/version.h>

#include <algorithm>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <utility>
#include <vector>

namespace tetra {

int exitCode(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::WrongUsage: return 2;
    case ErrorKind::BadInput: return 3;
    case ErrorKind::CannotWrite:
    case ErrorKind::OutOfResource: return 4;
    case ErrorKind::NotYet: return 5;
    case ErrorKind::Cancelled: break;
    }
    return 130;
}

namespace {

const Subcommand* findSubcommand(std::string_view name)
{
    const auto found = std::ranges::find(subcommands(), name, &Subcommand::name);
    return found == subcommands().end() ? nullptr : &*found;
}

bool asksForHelp(std::span<const std::string> words)
{
    return std::ranges::any_of(words, [](const std::string& word) { return word == "--help" || word == "-h"; });
}

int fail(const Streams& streams, const Error& error)
{
    streams.messages << "tan: " << visibleText(error.message) << std::endl;
    return exitCode(error.kind);
}

/// What a command that fails has to say. An option or a renderer that is not known may be one of a plugin that could
/// not be loaded for a lack of memory or open files.
Error trueReason(const Error& error, const PluginHost& host)
{
    const bool mayBeOfPlugin = error.kind == ErrorKind::WrongUsage || error.kind == ErrorKind::BadInput;
    const Status complete = host.complete();
    return mayBeOfPlugin && !complete ? complete.error() : error;
}

/// Standard output may be a file on a full disk: then nothing was said, and that is an error. If it is a pipe whose
/// reader has enough, as in 'tan info | head -1', nobody wants to hear of it.
int print(const Streams& streams, const std::string& text, int code)
{
    errno = 0;
    streams.output << visibleLines(text) << std::flush; // whatever plugins and files say in it
    const int systemError = errno;
    if (streams.output)
        return code;
    if (systemError == EPIPE)
        return exitCode(ErrorKind::CannotWrite);
    const std::string reason = systemError != 0 ? ": " + systemErrorText(systemError).text() : "";
    return fail(streams, {ErrorKind::CannotWrite, "Standard output cannot be written" + reason + "."});
}

/// The figures of a subcommand, where they belong.
int tell(const Streams& streams, const std::string& text, int code)
{
    if (!streams.resultIsOutput)
        return print(streams, text, code);
    streams.messages << visibleLines(text) << std::flush;
    return code;
}

/// The same for programs, and nothing in it that a terminal obeys.
std::string jsonText(const JsonObject& figures)
{
    return visibleJson(indentedJson(byName(figures)));
}

std::string wholeHelp(PluginHost& host)
{
    std::vector<std::pair<std::string, std::string>> purposes;
    for (const Subcommand& subcommand : subcommands())
        purposes.emplace_back(subcommand.name, subcommand.syntax(host).purpose);
    return programHelp(purposes);
}

Error unknownSubcommand(const std::string& word)
{
    std::vector<std::string> names;
    std::ranges::transform(subcommands(), std::back_inserter(names),
                           [](const Subcommand& subcommand) { return std::string(subcommand.name); });
    const auto meant = nearest(word, names);
    return {ErrorKind::WrongUsage, "'" + word + "' is neither a subcommand nor a file." +
                                       (meant ? " Did you mean '" + *meant + "'?" : "") + " 'tan --help' lists them."};
}

Result<Outcome> runGuarded(const Subcommand& subcommand, const Invocation& invocation)
{
    try {
        return subcommand.run(invocation);
    } catch (const std::exception& problem) {
        if (const auto lack = lackOfResources(problem))
            return *lack;
        return Error{ErrorKind::BadInput, std::string("This failed unexpectedly: ") + problem.what()};
    }
}

/// The name that programs read, which stays.
std::string_view kindName(ErrorKind kind)
{
    switch (kind) {
    case ErrorKind::WrongUsage: return "wrong-usage";
    case ErrorKind::BadInput: return "bad-input";
    case ErrorKind::CannotWrite: return "cannot-write";
    case ErrorKind::OutOfResource: return "out-of-resource";
    case ErrorKind::NotYet: return "not-yet";
    case ErrorKind::Cancelled: break;
    }
    return "cancelled";
}

bool wantsJson(std::span<const std::string> words)
{
    return std::ranges::find(words, "--json") != words.end();
}

/// With --json the error is an object, too.
int failFor(std::span<const std::string> words, const Streams& streams, const Error& error,
            std::span<const Message> remarks = {})
{
    const int code = wantsJson(words) && streams.resultIsOutput ? exitCode(error.kind) : fail(streams, error);
    if (!wantsJson(words))
        return code;
    Outcome told{.figures = {{"error", error.text()}, {"kind", kindName(error.kind)}, {"exit_code", code}}, .text = {}};
    addRemarks(remarks, told);
    return tell(streams, jsonText(told.figures), code);
}

/// What the plugins that fail meanwhile say. It goes to the messages at once, but not where those may be one object,
/// which has them for itself: then it is kept for that, or told in the end.
class PluginFailures {
public:
    PluginFailures(PluginHost& host, std::ostream& messages, bool areKept) : host_(host), messages_(messages)
    {
        host_.whenFailing([this, areKept](const Error& error) {
            if (areKept)
                kept_.push_back(error.message);
            else
                print(error.message);
        });
    }
    PluginFailures(const PluginFailures&) = delete;
    PluginFailures& operator=(const PluginFailures&) = delete;
    ~PluginFailures()
    {
        for (const Message& message : take())
            print(message);
    }

    /// Those that were kept. None is heard of any more.
    std::vector<Message> take()
    {
        host_.whenFailing({});
        return std::exchange(kept_, {});
    }

private:
    void print(const Message& message) { messages_ << "tan: " << visibleText(message) << std::endl; }

    PluginHost& host_;
    std::ostream& messages_;
    std::vector<Message> kept_;
};

int runSubcommand(const Subcommand& subcommand, std::span<const std::string> words, PluginHost& host, Streams streams,
                  const std::stop_token& stop)
{
    PluginFailures failures(host, streams.messages, wantsJson(words) && asksForStandardOutput(words));
    const Syntax syntax = wholeSyntax(subcommand, host);
    if (asksForHelp(words))
        return print(streams, subcommandHelp(subcommand.name, syntax), 0);
    streams.resultIsOutput = syntax.resultMayBeOutput && asksForStandardOutput(words);
    const auto remarks = [&] { return streams.resultIsOutput ? failures.take() : std::vector<Message>(); };
    const auto arguments = parseArguments(syntax, words);
    if (!arguments)
        return failFor(words, streams,
                       trueReason({arguments.error().kind, arguments.error().text() + " 'tan " +
                                                               std::string(subcommand.name) + " --help' explains it."},
                                  host),
                       remarks());

    ProgressLine line(streams.messages, streams.messagesAreTerminal);
    // An object on standard error has it for itself.
    const bool isSilent = streams.resultIsOutput && arguments->has("json");
    const Progress progress = isSilent ? Progress(stop, {}) : line.progress(stop);
    auto outcome = runGuarded(subcommand, {*arguments, host, progress, streams.messages});
    line.clear();
    if (!outcome)
        return failFor(words, streams, trueReason(outcome.error(), host), remarks());
    if (!outcome->isHeard)
        return 0;
    addRemarks(remarks(), *outcome);
    const std::string text = arguments->has("json") ? jsonText(outcome->figures) : outcome->text;
    return tell(streams, text, outcome->isYes ? 0 : 1);
}

} // namespace

bool isForWindow(std::span<const std::string> words)
{
    if (words.empty())
        return true;
    std::error_code problem;
    return words.size() == 1 && !words[0].starts_with('-') && findSubcommand(words[0]) == nullptr &&
           (isAddress(words[0]) || std::filesystem::exists(words[0], problem));
}

int runCommandLine(std::span<const std::string> words, PluginHost& host, const Streams& streams,
                   const std::stop_token& stop)
{
    const std::string first = words.empty() ? "--help" : words[0];
    if (first == "help" && words.size() > 2)
        return fail(streams, Error{ErrorKind::WrongUsage, "'tan help' explains one subcommand at a time, so '" +
                                                              words[2] + "' cannot be combined with it."});
    if (first == "help" && words.size() == 2) {
        const Subcommand* const asked = findSubcommand(words[1]);
        if (asked == nullptr)
            return fail(streams, unknownSubcommand(words[1]));
        return print(streams, subcommandHelp(asked->name, wholeSyntax(*asked, host)), 0);
    }
    if (first == "--help" || first == "-h" || first == "help")
        return print(streams, wholeHelp(host), 0);
    if (first == "--version")
        return print(streams, "tan " TAN_VERSION "\n", 0);
    const Subcommand* subcommand = findSubcommand(first);
    if (subcommand == nullptr)
        return failFor(words, streams, unknownSubcommand(first));
    return runSubcommand(*subcommand, words.subspan(1), host, streams, stop);
}

} // namespace tetra
