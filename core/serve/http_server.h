// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <tan/base.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tetra {

/// What a client may take of the server.
struct HttpLimits {
    std::size_t headBytes = 16384; ///< of a request: its line and headers
    std::size_t headers = 64;
    std::chrono::milliseconds headTime{5000};  ///< for a request to come whole, from its first byte on
    std::chrono::milliseconds idleTime{5000};  ///< for a connection to bring its first request
    std::chrono::milliseconds keptTime{60000}; ///< to bring the next one, if no other connection wants its place
    std::chrono::milliseconds sendTime{10000}; ///< for a piece of an answer (64 KiB) to be taken
    int connections = 64;                      ///< at once; more are told to come again
    int connectionsOfAddress = 48;             ///< of these, from one address of the network
    int requestsOfConnection = 1000;
};

enum class HttpMethod { Get, Head, Options };

/// A request whose head was found to be well-formed; it has no body.
struct ServedRequest {
    HttpMethod method = HttpMethod::Get;
    std::string target; ///< as it came: a path that begins with '/', perhaps '?' and a query; printable ASCII
    std::function<std::optional<std::string>(std::string_view name)> header; ///< its name in small letters
    std::stop_token gone; ///< the client has gone or the server stops: nobody waits for the answer
};

struct ServedAnswer {
    int status = 200;
    std::vector<std::pair<std::string, std::string>> headers;
    std::string type;
    std::uint64_t size = 0;
    /// Fills a piece of the body; false ends the connection before its end. Called from one thread at a time.
    std::function<bool(std::uint64_t offset, std::span<char> to)> read;
    std::string note; ///< for the log
};

/// An answer with this text for its body.
ServedAnswer textAnswer(int status, std::string type, std::string text);
/// {"error": text}, as JSON.
ServedAnswer errorAnswer(int status, std::string_view text);

/// What there is to log of a request.
struct HttpRecord {
    std::string peer;
    std::string request; ///< method and target, printable; empty for one that was refused unread
    int status = 0;
    std::uint64_t bytes = 0; ///< of the answer's body that the system took, whether or not all of them arrived
    std::chrono::duration<double> time{};
    std::string note;
};

/// A server of HTTP/1.1 for requests without a body. libmicrohttpd reads heads and writes answers, in a few threads for
/// all connections; here it is decided who has a place (http_places.h), what a head must be like, and what takes a
/// thread of its own.
class HttpServer {
public:
    /// What answers requests, from several threads; does not throw.
    struct Handler {
        /// Whether the answer takes more than a moment: it is then worked on in a thread of its own.
        std::function<bool(const ServedRequest& request)> takesLong;
        std::function<ServedAnswer(const ServedRequest& request)> answer;
    };
    /// From several threads, which wait for it: it only takes note.
    using Log = std::function<void(const HttpRecord& record)>;

    HttpServer(HttpLimits limits, Handler handler, Log log);
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// Takes a port of this machine's address, 0 for any that is free, and says which. Errors: WrongUsage for an
    /// address that is not one of this machine's, a port that is taken or not allowed.
    Result<int> bind(const std::string& address, int port);
    /// Answers requests until `progress` is cancelled, then ends all connections, within about a second. Errors: the
    /// system gives no thread or takes no more connections.
    Status run(const Progress& progress);

private:
    class Server;
    std::unique_ptr<Server> server_;
};

} // namespace tetra
