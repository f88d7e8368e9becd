// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/option_values.h"
#include "app/command_line/server_mesh.h"
#include "app/command_line/subcommands.h"
#include "core/serve/http_server.h"
#include "core/serve/line_log.h"
#include "core/serve/model_server.h"

#include <array>
#include <atomic>
#include <charconv>
#include <ctime>

#include <malloc.h>
#include <unistd.h>

namespace tetra {
namespace {

constexpr std::int64_t defaultPort = 8080;

} // namespace

Syntax serveSyntax(PluginHost&)
{
    return {
        .purpose = "serve models over HTTP",
        .explanation =
            "A server for the models of a folder and its subfolders: '/' lists them, '/NAME.tan' gives a file or "
            "ranges of it, and '/NAME.tan?error=1&window=...', with the options of 'tan extract' as the query, a "
            "packed mesh, as 'tan extract --at-server' requests it. It answers this machine only, unless it is given "
            "another address and a token; without a token every user of this machine can read the models. Each request "
            "is logged as a line on standard error; Ctrl+C ends it.",
        .positionals = {{"FOLDER", "The folder of the models."}},
        .options = {{.name = "port",
                     .placeholder = "N",
                     .explanation = "The port to listen on; 0 chooses any free one.",
                     .byDefault = std::to_string(defaultPort)},
                    {.name = "address",
                     .placeholder = "ADDRESS",
                     .explanation = "The address of this machine to listen on; 0.0.0.0 means all. Any but a loopback "
                                    "address needs a token.",
                     .byDefault = "127.0.0.1"},
                    {.name = "token-file",
                     .placeholder = "FILE",
                     .explanation = "Answer only clients that send the token in the first line of this file."},
                    {.name = "allow-origin",
                     .placeholder = "ORIGIN",
                     .explanation = "Lets web pages from this origin, such as https://viewer.example, read the models "
                                    "in the browser that shows them (CORS); no others can.",
                     .repeatable = true},
                    {.name = "limit",
                     .placeholder = "N",
                     .explanation = "Maximum number of tetrahedra in a mesh.",
                     .byDefault = std::to_string(ModelServerLimits().tetrahedra)},
                    {.name = "seconds",
                     .placeholder = "N",
                     .explanation = "The longest time that a mesh may take, at most 80.",
                     .byDefault = std::to_string(ModelServerLimits().time.count() / 1000)}},
        .examples = {{"tan serve models", "At http://127.0.0.1:8080/, for this machine."},
                     {"tan serve models --address 0.0.0.0 --token-file token",
                      "For everyone who can reach it and has the token. HTTP is not encrypted: over the Internet, use "
                      "SSH or a proxy with TLS."}}};
}

#ifndef TAN_SERVER

Result<Outcome> runServe(const Invocation&)
{
    return Error{ErrorKind::WrongUsage,
                 "This 'tan' was built without its server (CMake option TAN_SERVER). Any HTTP server that supports "
                 "ranges can offer models, too, but it extracts no meshes."};
}

#else

namespace {

/// "2026-11-26T09:05:00Z"
std::string timeNow()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 64> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

/// "0.125": to the millisecond.
std::string secondsText(double seconds)
{
    std::array<char, 512> text{}; // of the largest number 309 digits stand before the point
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), seconds, std::chars_format::fixed, 3);
    return {text.data(), end};
}

/// A line of the log. Tokens are in headers, which are not logged.
std::string logLine(const HttpRecord& record)
{
    return timeNow() + " " + record.peer + " \"" + record.request + "\" " + std::to_string(record.status) + " " +
           std::to_string(record.bytes) + " bytes " + secondsText(record.time.count()) + " s" +
           (record.note.empty() ? "" : ", " + record.note);
}

/// Lets the C library give memory that is freed back to the system. Otherwise large arrays that are freed teach it to
/// keep up to 64 MB at the end of the share of the heap of each thread that ever worked, which is also what
/// malloc_trim() leaves there.
void keepNoFreedMemory()
{
    constexpr int mostAtTheEnd = 128 << 10, leastMapped = 512 << 10;
    ::mallopt(M_TRIM_THRESHOLD, mostAtTheEnd);
    ::mallopt(M_MMAP_THRESHOLD, leastMapped);
}

/// Who is answered, by the options.
Result<ServedTo> servedTo(const Arguments& arguments, const std::string& address)
{
    ServedTo whom;
    if (const auto file = arguments.value("token-file")) {
        auto read = tokenIn(*file);
        if (!read)
            return read.error();
        whom.token = *std::move(read);
    } else if (!isLoopback(address)) {
        return Error{ErrorKind::WrongUsage,
                     Message::say("At '%1' others can reach the server, so it requires a token: '--token-file FILE'.",
                                  printable(address))};
    }
    whom.origins = arguments.values("allow-origin");
    for (const std::string& origin : whom.origins)
        if (!isOrigin(origin))
            return Error{ErrorKind::WrongUsage,
                         Message::say("'%1' does not fit '--allow-origin': it takes the origin of pages as a browser "
                                      "states it, http:// or https:// and a host in lower-case letters, perhaps with a "
                                      "port, and nothing after it: https://viewer.example.",
                                      printable(origin))};
    return whom;
}

Result<ModelServerLimits> limitsOf(const Arguments& arguments)
{
    constexpr std::int64_t mostTetrahedra = 1'000'000'000;
    constexpr std::int64_t mostSeconds = 80; // and half a minute for its turn: TAn waits two minutes for an answer
    ModelServerLimits limits;
    const auto tetrahedra =
        wholeNumberOption(arguments, "limit", static_cast<std::int64_t>(limits.tetrahedra), 1, mostTetrahedra);
    const auto seconds = wholeNumberOption(arguments, "seconds", limits.time.count() / 1000, 1, mostSeconds);
    for (const auto* number : {&tetrahedra, &seconds})
        if (!*number)
            return number->error();
    limits.tetrahedra = static_cast<std::uint64_t>(*tetrahedra);
    limits.time = std::chrono::seconds(*seconds);
    return limits;
}

/// Where the server is, and who else can read there.
std::string greeting(const std::string& folder, const std::string& address, int port, bool hasToken)
{
    const std::string host = address.find(':') == std::string::npos ? address : "[" + address + "]";
    return "Serving '" + printable(folder) + "' at http://" + host + ":" + std::to_string(port) + "/ until Ctrl+C.\n" +
           (hasToken ? ""
                     : "Every user of this machine can read these models there; '--token-file' lets only those "
                       "who have the token.\n");
}

} // namespace

Result<Outcome> runServe(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const std::string address = arguments.value("address").value_or("127.0.0.1");
    auto whom = servedTo(arguments, address);
    if (!whom)
        return whom.error();
    const bool hasToken = !whom->token.empty();
    constexpr std::int64_t lastPort = 65535;
    const auto port = wholeNumberOption(arguments, "port", defaultPort, 0, lastPort);
    if (!port)
        return port.error();
    const auto limits = limitsOf(arguments);
    if (!limits)
        return limits.error();
    auto folder = ServedFolder::open(arguments.positionals[0]);
    if (!folder)
        return folder.error();

    keepNoFreedMemory();
    ModelServer models(std::move(*folder), *std::move(whom), *limits);
    std::atomic<std::uint64_t> requests = 0, bytes = 0;
    std::optional<LineLog> log;
    HttpServer server({}, models.handler(), [&](const HttpRecord& record) {
        ++requests;
        bytes += record.bytes;
        log->add(logLine(record));
    });
    const auto bound = server.bind(address, static_cast<int>(*port));
    if (!bound)
        return bound.error();
    invocation.messages << greeting(arguments.positionals[0], address, *bound, hasToken) << std::flush;
    log.emplace(STDERR_FILENO);
    if (const Status ran = server.run(invocation.progress); !ran)
        return ran.error();
    log.reset();
    return Outcome{.figures = {{"requests", requests.load()}, {"bytes", bytes.load()}},
                   .text = std::to_string(requests) + " requests, " + std::to_string(bytes) + " bytes\n",
                   .isHeard = takesText(STDOUT_FILENO)};
}

#endif

} // namespace tetra
