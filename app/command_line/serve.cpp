// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/option_values.h"
#include "app/command_line/subcommands.h"
#include "app/server/http_server.h"
#include "app/server/model_server.h"
#include "app/server/server_mesh.h"

#include <QDateTime>

#include <mutex>

#include <malloc.h>

namespace tetra {
namespace {

constexpr std::int64_t defaultPort = 8080;

/// A line of the log. Tokens are in headers, which are not logged.
std::string logLine(const HttpRecord& record)
{
    return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString() + " " + record.peer + " \"" +
           record.request + "\" " + std::to_string(record.status) + " " + std::to_string(record.bytes) + " bytes " +
           QString::number(record.time.count(), 'f', 3).toStdString() + " s" +
           (record.note.empty() ? "" : ", " + record.note) + "\n";
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

} // namespace

Syntax serveSyntax(PluginHost&)
{
    return {
        .purpose = "let others read models over HTTP",
        .explanation =
            "A server for the models of a folder and of those within it: '/' lists them, '/NAME.tan' gives a file or "
            "ranges of it, and '/NAME.tan?error=1&window=...', with the options of 'tan extract' as the query, a "
            "mesh, packed, for which 'tan extract --at-server' asks. It answers this machine only, "
            "unless it is given another address and a token. Each request is a line on standard error; Ctrl+C ends "
            "it.",
        .positionals = {{"FOLDER", "Where the models are."}},
        .options = {{.name = "port",
                     .placeholder = "N",
                     .explanation = "The port to listen at; 0 is any that is free.",
                     .byDefault = std::to_string(defaultPort)},
                    {.name = "address",
                     .placeholder = "ADDRESS",
                     .explanation = "The machine's address to listen at; 0.0.0.0 is all. Any but a loopback address "
                                    "needs a token.",
                     .byDefault = "127.0.0.1"},
                    {.name = "token-file",
                     .placeholder = "FILE",
                     .explanation = "Answer only clients that send the token in the first line of this file."},
                    {.name = "limit",
                     .placeholder = "N",
                     .explanation = "The most tetrahedra that a mesh may have.",
                     .byDefault = std::to_string(ModelServerLimits().tetrahedra)},
                    {.name = "seconds",
                     .placeholder = "N",
                     .explanation = "The longest time that a mesh may take.",
                     .byDefault = std::to_string(ModelServerLimits().time.count() / 1000)}},
        .examples = {{"tan serve models", "At http://127.0.0.1:8080/, for this machine."},
                     {"tan serve models --address 0.0.0.0 --token-file token",
                      "For all who can reach it and have the token. HTTP is not encrypted: over the Internet, use "
                      "SSH or a proxy with TLS."}}};
}

Result<Outcome> runServe(const Invocation& invocation)
{
    const Arguments& arguments = invocation.arguments;
    const std::string address = arguments.value("address").value_or("127.0.0.1");
    std::string token;
    if (const auto file = arguments.value("token-file")) {
        const auto read = tokenIn(*file);
        if (!read)
            return read.error();
        token = *read;
    } else if (!isLoopback(address)) {
        return Error{ErrorKind::WrongUsage, Message::say("At '%1' others can reach the server, so it needs a token: "
                                                         "'--token-file FILE'.",
                                                         printable(address))};
    }
    constexpr std::int64_t lastPort = 65535, mostTetrahedra = 1'000'000'000, mostSeconds = 86400;
    ModelServerLimits limits;
    const auto port = wholeNumberOption(arguments, "port", defaultPort, 0, lastPort);
    const auto tetrahedra =
        wholeNumberOption(arguments, "limit", static_cast<std::int64_t>(limits.tetrahedra), 1, mostTetrahedra);
    const auto seconds = wholeNumberOption(arguments, "seconds", limits.time.count() / 1000, 1, mostSeconds);
    for (const auto* number : {&port, &tetrahedra, &seconds})
        if (!*number)
            return number->error();
    limits.tetrahedra = static_cast<std::uint64_t>(*tetrahedra);
    limits.time = std::chrono::seconds(*seconds);
    auto folder = ServedFolder::open(arguments.positionals[0]);
    if (!folder)
        return folder.error();

    keepNoFreedMemory();
    ModelServer models(std::move(*folder), token, limits);
    std::mutex mutex; // of what follows
    std::uint64_t requests = 0, bytes = 0;
    HttpServer server(
        {}, [&](const ServedRequest& request) { return models.answer(request); },
        [&](const HttpRecord& record) {
            const std::lock_guard lock(mutex);
            ++requests;
            bytes += record.bytes;
            invocation.messages << logLine(record) << std::flush;
        });
    const auto bound = server.bind(address, static_cast<int>(*port));
    if (!bound)
        return bound.error();
    const std::string host = address.find(':') == std::string::npos ? address : "[" + address + "]";
    invocation.messages << "Serving '" + arguments.positionals[0] + "' at http://" + host + ":" +
                               std::to_string(*bound) + "/ until Ctrl+C.\n"
                        << std::flush;
    if (const Status ran = server.run(invocation.progress); !ran)
        return ran.error();
    const std::lock_guard lock(mutex);
    return Outcome{.figures = {{"requests", static_cast<qint64>(requests)}, {"bytes", static_cast<qint64>(bytes)}},
                   .text = std::to_string(requests) + " requests, " + std::to_string(bytes) + " bytes\n"};
}

} // namespace tetra
