// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/http_server.h"

#include "core/base/system_error.h"
#include "core/base/text.h"

#include <httplib.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace tetra {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t pieceBytes = 65536;
constexpr std::chrono::milliseconds lookUpEvery{50};
/// Headers that this program and the library between them use for themselves; a client's of these names are dropped.
constexpr const char* connectionHeader = "Tan-Connection";
constexpr const char* rangeHeader = "Tan-Range"; ///< what came as Range: the library must not act on it

/// Waits until the socket can be read or written; false when the time is over or it is broken.
bool waitFor(int socket, short what, Clock::time_point until)
{
    for (;;) {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
        if (left.count() <= 0)
            return false;
        pollfd place{.fd = socket, .events = what, .revents = 0};
        const int ready = ::poll(&place, 1, static_cast<int>(std::min<std::int64_t>(left.count(), 10'000)));
        if (ready > 0)
            return (place.revents & (what | POLLHUP)) != 0;
        if (ready < 0 && errno != EINTR)
            return false;
    }
}

/// Sends all of it within the time.
bool sendAll(int socket, const char* bytes, std::size_t size, Clock::time_point until)
{
    while (size > 0) {
        const ssize_t sent = ::send(socket, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) {
            bytes += sent;
            size -= static_cast<std::size_t>(sent);
        } else if (sent == 0 || (errno != EAGAIN && errno != EINTR) || !waitFor(socket, POLLOUT, until)) {
            return false;
        }
    }
    return true;
}

/// A client and what it sent.
struct Connection {
    int socket;
    std::string peer{};
    std::string received{}; ///< not yet answered
    std::uint64_t sent = 0;
    std::optional<std::stop_source> answering{};  ///< while an answer is worked on
    std::optional<Clock::time_point> idleSince{}; ///< between an answer and the next request
    HttpRecord record{};
};

std::string peerOf(int socket)
{
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    std::array<char, NI_MAXHOST> host{};
    std::array<char, NI_MAXSERV> port{};
    if (::getpeername(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
        ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, host.data(), host.size(), port.data(), port.size(),
                      NI_NUMERICHOST | NI_NUMERICSERV) != 0)
        return "?";
    return std::string(host.data()) + ":" + port.data();
}

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

/// A request's line and headers, checked: as they are handed to the library, or the status that refuses them.
struct CheckedHead {
    int refused = 0;
    std::string text{};
};

/// Takes "name: value"; names in small letters. Nothing if it is none.
std::optional<std::pair<std::string, std::string>> headerOf(std::string_view line)
{
    const std::size_t colon = line.find(':');
    if (colon == 0 || colon == std::string_view::npos || !std::ranges::all_of(line.substr(0, colon), isNameCharacter))
        return {};
    std::string_view value = line.substr(colon + 1);
    while (!value.empty() && (value.front() == ' ' || value.front() == '\t'))
        value.remove_prefix(1);
    while (!value.empty() && (value.back() == ' ' || value.back() == '\t'))
        value.remove_suffix(1);
    const auto isControl = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == 0x7f; };
    if (std::ranges::any_of(value, isControl))
        return {};
    return std::pair(smallLetters(line.substr(0, colon)), std::string(value));
}

/// What a status says, of those that refuse a request unread.
std::string_view reasonOf(int status)
{
    switch (status) {
    case 405: return "Method Not Allowed";
    case 408: return "Request Timeout";
    case 413: return "Content Too Large";
    case 414: return "URI Too Long";
    case 431: return "Request Header Fields Too Large";
    case 503: return "Service Unavailable";
    case 505: return "HTTP Version Not Supported";
    default: return "Bad Request";
    }
}

/// Takes the headers from lines that end with CR LF. 0, or the status that refuses them.
int takeHeaders(std::string_view lines, std::size_t most, std::map<std::string, std::string>& headers)
{
    while (!lines.empty()) {
        const std::size_t end = std::min(lines.find("\r\n"), lines.size());
        const auto header = headerOf(lines.substr(0, end));
        // No header may come twice: whoever stands between might take the other one.
        if (!header || !headers.insert(*header).second)
            return 400;
        if (headers.size() > most)
            return 431;
        lines.remove_prefix(std::min(end + 2, lines.size()));
    }
    return 0;
}

/// `head`: lines that end with CR LF, the empty one at the end not among them.
CheckedHead checkedHead(std::string_view head, const HttpLimits& limits)
{
    const std::size_t end = std::min(head.find("\r\n"), head.size());
    const std::string_view line = head.substr(0, end);
    const std::size_t first = line.find(' '), second = line.find(' ', first + 1);
    if (first == std::string_view::npos || second == std::string_view::npos ||
        line.find(' ', second + 1) != std::string_view::npos)
        return {.refused = 400};
    const std::string_view method = line.substr(0, first), target = line.substr(first + 1, second - first - 1),
                           version = line.substr(second + 1);
    if (method.empty() || !std::ranges::all_of(method, isNameCharacter) ||
        (version != "HTTP/1.1" && version != "HTTP/1.0"))
        return {.refused = version.starts_with("HTTP/") && version.size() == 8 ? 505 : 400};
    if (method != "GET" && method != "HEAD")
        return {.refused = 405};
    const auto isPrintable = [](char c) { return c > ' ' && c < 0x7f; };
    if (!target.starts_with('/') || !std::ranges::all_of(target, isPrintable) ||
        target.find('#') != std::string_view::npos)
        return {.refused = 400};
    if (target.size() > limits.headBytes / 2)
        return {.refused = 414};

    std::map<std::string, std::string> headers;
    if (const int refused = takeHeaders(head.substr(std::min(end + 2, head.size())), limits.headers, headers);
        refused != 0)
        return {.refused = refused};
    if (version == "HTTP/1.1" && !headers.contains("host"))
        return {.refused = 400};
    if (headers.contains("transfer-encoding") ||
        (headers.contains("content-length") && headers["content-length"] != "0"))
        return {.refused = 413};

    CheckedHead checked;
    checked.text = std::string(method) + " " + std::string(target) + " " + std::string(version) + "\r\n";
    const auto pass = [&](const char* name, const char* as) {
        if (const auto found = headers.find(name); found != headers.end())
            checked.text += std::string(as) + ": " + found->second + "\r\n";
    };
    pass("range", rangeHeader);
    for (const char* name : {"host", "if-range", "if-none-match", "authorization"})
        pass(name, name);
    const std::string wish = smallLetters(headers.contains("connection") ? headers["connection"] : "");
    if (wish == "close" || (version == "HTTP/1.0" && wish != "keep-alive"))
        checked.text += "Connection: close\r\n";
    else if (version == "HTTP/1.0")
        checked.text += "Connection: Keep-Alive\r\n";
    checked.text += "\r\n";
    return checked;
}

/// A checked head and a socket, as the library reads and writes them.
class CheckedStream final : public httplib::Stream {
public:
    CheckedStream(Connection& connection, std::string head, std::chrono::milliseconds sendTime)
        : connection_(connection), head_(std::move(head)), sendTime_(sendTime)
    {
    }

    bool is_readable() const override { return read_ < head_.size(); }
    bool is_writable() const override { return !broken_; }
    ssize_t read(char* to, size_t size) override
    {
        const std::size_t count = std::min(size, head_.size() - read_);
        std::copy_n(head_.data() + read_, count, to);
        read_ += count;
        return static_cast<ssize_t>(count);
    }
    ssize_t write(const char* bytes, size_t size) override
    {
        for (std::size_t done = 0; done < size && !broken_;) {
            const std::size_t piece = std::min(size - done, pieceBytes);
            broken_ = !sendAll(connection_.socket, bytes + done, piece, Clock::now() + sendTime_);
            done += piece;
            connection_.sent += broken_ ? 0 : piece;
        }
        return broken_ ? -1 : static_cast<ssize_t>(size);
    }
    void get_remote_ip_and_port(std::string& ip, int& port) const override
    {
        ip.clear();
        port = 0;
    }
    void get_local_ip_and_port(std::string& ip, int& port) const override
    {
        ip.clear();
        port = 0;
    }
    socket_t socket() const override { return connection_.socket; }

private:
    Connection& connection_;
    std::string head_;
    std::chrono::milliseconds sendTime_;
    std::size_t read_ = 0;
    bool broken_ = false;
};

} // namespace

ServedAnswer textAnswer(int status, std::string type, std::string text)
{
    ServedAnswer answer;
    answer.status = status;
    answer.type = std::move(type);
    answer.size = text.size();
    answer.read = [text = std::move(text)](std::uint64_t offset, std::span<char> to) {
        text.copy(to.data(), to.size(), offset);
        return true;
    };
    return answer;
}

ServedAnswer errorAnswer(int status, std::string_view text)
{
    std::string json = "{\"error\": \"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            json += '\\';
        json += c >= 0 && c < ' ' ? ' ' : c;
    }
    return textAnswer(status, "application/json", json + "\"}\n");
}

namespace {

/// Threads that serve connections: as many as are asked for, or as the system gives. The library's own pool ends the
/// program, or waits for ever, where the system does not give all.
class Workers final : public httplib::TaskQueue {
public:
    /// Throws if it gives none.
    explicit Workers(std::size_t most)
    {
        threads_.reserve(most);
        try {
            while (threads_.size() < most)
                threads_.emplace_back([this] { work(); });
        } catch (const std::exception&) {
            if (threads_.empty())
                throw;
        }
    }

    ~Workers() override { Workers::shutdown(); }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t count() const noexcept { return threads_.size(); }
    void enqueue(std::function<void()> task) override
    {
        const std::lock_guard lock(mutex_);
        tasks_.push_back(std::move(task));
        changed_.notify_one();
    }
    /// Ends when all is done.
    void shutdown() override
    {
        {
            const std::lock_guard lock(mutex_);
            ends_ = true;
            changed_.notify_all();
        }
        threads_.clear();
    }

private:
    void work()
    {
        for (;;) {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [&] { return ends_ || !tasks_.empty(); });
            if (tasks_.empty())
                return;
            const std::function<void()> task = std::move(tasks_.front());
            tasks_.pop_front();
            lock.unlock();
            task();
        }
    }

    std::mutex mutex_; ///< of what follows
    std::condition_variable changed_;
    std::deque<std::function<void()>> tasks_;
    bool ends_ = false;
    std::vector<std::jthread> threads_;
};

} // namespace

class HttpServer::Server final : public httplib::Server {
public:
    Server(HttpLimits limits, Handle handle, Log log)
        : limits_(limits), handle_(std::move(handle)), log_(std::move(log))
    {
        // Others may not share the port, as the library would let them.
        set_socket_options([](int socket) {
            const int yes = 1;
            ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
        });
        // A few more than there are connections tell the rest to come again.
        constexpr int spare = 4;
        new_task_queue = [this] {
            auto workers = std::make_unique<Workers>(static_cast<std::size_t>(limits_.connections + spare));
            limits_.connections =
                std::min(limits_.connections, std::max(1, static_cast<int>(workers->count()) - spare));
            return workers.release(); // the library owns it
        };
        set_keep_alive_max_count(static_cast<std::size_t>(limits_.requestsOfConnection));
        set_keep_alive_timeout(std::chrono::duration_cast<std::chrono::seconds>(limits_.keptTime).count());
        set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
            answer(request, response);
            return HandlerResponse::Handled;
        });
        set_post_routing_handler([](const httplib::Request&, httplib::Response& response) {
            if (response.status == 304) // its length is that of what is not sent
                response.headers.erase("Content-Length");
        });
    }

    Result<int> bind(const std::string& address, int port)
    {
        errno = 0;
        const int bound = port == 0 ? bind_to_any_port(address) : bind_to_port(address, port) ? port : -1;
        if (bound < 0)
            return Error{ErrorKind::WrongUsage,
                         Message::say("No server can be at port %1 of '%2': %3. Choose another port with '--port', or "
                                      "an address of this machine.",
                                      port, printable(address), systemErrorText(errno == 0 ? EADDRNOTAVAIL : errno))};
        constexpr int backlog = 128; // the library's 5 makes clients that come at once wait a second
        ::listen(svr_sock_, backlog);
        return bound;
    }

    Status run(const Progress& progress)
    {
        int problem = 0;
        try {
            const std::jthread watcher([&](const std::stop_token& ended) { watch(ended, progress); });
            if (listen_after_bind() || progress.cancelled())
                return {};
            problem = errno;
        } catch (const std::system_error& noThread) {
            problem = noThread.code().value();
        }
        return Error{ErrorKind::OutOfResource, Message::say("The system takes no more connections: %1. %2",
                                                            systemErrorText(problem), resourceRemedy)};
    }

private:
    /// Ends answers whose clients have gone, and everything when it is to stop.
    void watch(const std::stop_token& ended, const Progress& progress)
    {
        while (!ended.stop_requested()) {
            std::this_thread::sleep_for(lookUpEvery);
            const bool stop = progress.cancelled();
            {
                const std::lock_guard lock(mutex_);
                stopping_ = stopping_ || stop;
                for (auto& [number, connection] : connections_) {
                    if (stop)
                        ::shutdown(connection->socket, SHUT_RDWR);
                    pollfd place{.fd = connection->socket, .events = POLLRDHUP, .revents = 0};
                    const bool gone =
                        ::poll(&place, 1, 0) > 0 && (place.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
                    if (connection->answering && (stop || gone))
                        connection->answering->request_stop();
                }
            }
            if (stop && is_running())
                httplib::Server::stop();
        }
    }

    void answer(const httplib::Request& request, httplib::Response& response)
    {
        Connection* connection = nullptr;
        std::stop_source gone;
        {
            const std::lock_guard lock(mutex_);
            const auto number = parseNumber<std::uint64_t>(request.get_header_value(connectionHeader));
            connection = connections_.at(number.value_or(0));
            connection->answering = gone;
            if (stopping_)
                gone.request_stop();
        }
        const ServedRequest asked{.isHead = request.method == "HEAD",
                                  .target = request.target,
                                  .header = [&request](std::string_view name) -> std::optional<std::string> {
                                      const std::string key = name == "Range" ? rangeHeader : std::string(name);
                                      return request.has_header(key) ? std::optional(request.get_header_value(key))
                                                                     : std::nullopt;
                                  },
                                  .gone = gone.get_token()};
        ServedAnswer given = handle_(asked);
        {
            const std::lock_guard lock(mutex_);
            connection->answering.reset();
        }
        connection->record.status = response.status = given.status;
        connection->record.note = std::move(given.note);
        for (const auto& [name, value] : given.headers)
            response.set_header(name, value);
        if (given.size == 0) {
            if (given.status < 300)
                response.set_header("Content-Type", given.type);
            return;
        }
        response.set_content_provider(given.size, given.type,
                                      [size = given.size, read = std::move(given.read), piece = std::string()](
                                          std::size_t offset, std::size_t, httplib::DataSink& sink) mutable {
                                          piece.resize(std::min<std::uint64_t>(size - offset, pieceBytes));
                                          return read(offset, piece) && sink.write(piece.data(), piece.size());
                                      });
    }

    bool process_and_close_socket(socket_t socket) override
    {
        Connection connection{.socket = socket};
        std::uint64_t number = 0;
        try {
            bool full = false, stops = false;
            {
                const std::lock_guard lock(mutex_);
                full = countBusy() >= static_cast<std::size_t>(limits_.connections);
                while (!full && connections_.size() >= static_cast<std::size_t>(limits_.connections))
                    endLongestIdle();
                number = ++lastNumber_;
                stops = stopping_;
                if (!full && !stops)
                    connections_.emplace(number, &connection);
            }
            const int yes = 1;
            ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
            connection.peer = peerOf(socket);
            if (full)
                refuse(connection, 503, "", Clock::now());
            else if (!stops)
                converse(connection, number);
        } catch (const std::exception&) {
            // Not enough memory for a request: its connection ends, the others go on.
        }
        {
            const std::lock_guard lock(mutex_);
            connections_.erase(number);
        }
        ::shutdown(socket, SHUT_RDWR);
        ::close(socket);
        return true;
    }

    /// Request after request of a connection.
    void converse(Connection& connection, std::uint64_t number)
    {
        for (int count = 1; count <= limits_.requestsOfConnection; ++count) {
            Clock::time_point begun;
            std::string head;
            int refused = 0;
            if (!receiveHead(connection, number, head, refused, begun))
                return;
            CheckedHead checked{.refused = refused};
            if (refused == 0)
                checked = checkedHead(head, limits_);
            if (checked.refused != 0)
                return refuse(connection, checked.refused, head, begun);
            connection.record = HttpRecord();
            connection.record.peer = connection.peer;
            connection.record.request = firstLine(head);
            connection.sent = 0;
            CheckedStream stream(connection, std::move(checked.text), limits_.sendTime);
            bool closes = false;
            const bool done = process_request(
                stream, isFull() || count == limits_.requestsOfConnection, closes,
                [&](httplib::Request& request) { request.set_header(connectionHeader, std::to_string(number)); });
            tell(connection, begun, done ? "" : "unfinished");
            if (!done || closes || isFull())
                return;
            if (connection.received.empty())
                setIdle(connection, number, true);
        }
    }

    /// Whether no connection can be kept for a next request.
    bool isFull()
    {
        const std::lock_guard lock(mutex_);
        return stopping_ || countBusy() >= static_cast<std::size_t>(limits_.connections);
    }
    /// With mutex_ held, as the next one.
    std::size_t countBusy() const
    {
        return static_cast<std::size_t>(
            std::ranges::count_if(connections_, [](const auto& entry) { return !entry.second->idleSince; }));
    }

    /// There is an idle one. Its thread finds it at its end, and goes.
    void endLongestIdle()
    {
        const auto since = [](const auto& entry) { return entry.second->idleSince.value_or(Clock::time_point::max()); };
        const auto longest = std::ranges::min_element(connections_, {}, since);
        ::shutdown(longest->second->socket, SHUT_RDWR);
        connections_.erase(longest);
    }

    /// While it is idle another connection may take its place. False if one has.
    bool setIdle(Connection& connection, std::uint64_t number, bool isIdle)
    {
        const std::lock_guard lock(mutex_);
        connection.idleSince = isIdle ? std::optional(Clock::now()) : std::nullopt;
        return connections_.contains(number);
    }

    /// The next head. False if the connection ends without one.
    bool receiveHead(Connection& connection, std::uint64_t number, std::string& head, int& refused,
                     Clock::time_point& begun)
    {
        begun = Clock::now();
        auto until = begun + (connection.idleSince ? limits_.keptTime : limits_.idleTime);
        bool waiting = connection.received.empty();
        if (!waiting)
            until = begun + limits_.headTime;
        std::size_t searched = 0;
        for (;;) {
            const std::size_t end = connection.received.find("\r\n\r\n", searched);
            if (end != std::string::npos && end <= limits_.headBytes) {
                head = connection.received.substr(0, end + 2);
                connection.received.erase(0, end + 4);
                return true;
            }
            searched = connection.received.size() - std::min<std::size_t>(connection.received.size(), 3);
            if (connection.received.size() > limits_.headBytes) {
                head = connection.received;
                refused = 431;
                return true;
            }
            if (!waitFor(connection.socket, POLLIN, until)) {
                head = connection.received;
                refused = 408;
                return !waiting; // nobody has begun to ask: nothing to answer
            }
            std::array<char, 4096> piece{};
            const ssize_t count = ::recv(connection.socket, piece.data(), piece.size(), MSG_DONTWAIT);
            if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR))
                return false;
            if (count < 0)
                continue;
            connection.received.append(piece.data(), static_cast<std::size_t>(count));
            if (std::exchange(waiting, false)) {
                if (!setIdle(connection, number, false))
                    return false;
                begun = Clock::now();
                until = begun + limits_.headTime;
            }
        }
    }

    static std::string firstLine(const std::string& head)
    {
        return printable(std::string_view(head).substr(0, std::min(head.find("\r\n"), head.find(" HTTP/"))));
    }

    /// Says no, and waits a moment for the client to read it: a socket that is closed with bytes unread takes it back.
    void refuse(Connection& connection, int status, const std::string& head, Clock::time_point begun)
    {
        connection.record = HttpRecord();
        connection.record.peer = connection.peer;
        connection.record.request = firstLine(head);
        connection.record.status = status;
        const std::string body = "{\"error\": \"" + std::string(reasonOf(status)) + "\"}\n";
        const std::string text =
            "HTTP/1.1 " + std::to_string(status) + " " + std::string(reasonOf(status)) +
            (status == 503 ? "\r\nRetry-After: 1" : "") + (status == 405 ? "\r\nAllow: GET, HEAD" : "") +
            "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
            "\r\nConnection: close\r\n\r\n" + body;
        constexpr std::chrono::milliseconds moment{200};
        const auto until = Clock::now() + moment;
        if (sendAll(connection.socket, text.data(), text.size(), until)) {
            connection.sent = text.size();
            ::shutdown(connection.socket, SHUT_WR);
            std::array<char, 4096> unread{};
            while (waitFor(connection.socket, POLLIN, until) &&
                   ::recv(connection.socket, unread.data(), unread.size(), MSG_DONTWAIT) > 0) {
            }
        }
        tell(connection, begun, "");
    }

    void tell(Connection& connection, Clock::time_point begun, std::string_view otherwise)
    {
        connection.record.bytes = connection.sent;
        connection.record.time = Clock::now() - begun;
        if (connection.record.note.empty())
            connection.record.note = otherwise;
        log_(connection.record);
    }

    HttpLimits limits_;
    const Handle handle_;
    const Log log_;
    std::mutex mutex_; ///< of what follows
    std::map<std::uint64_t, Connection*> connections_;
    std::uint64_t lastNumber_ = 0;
    bool stopping_ = false;
};

HttpServer::HttpServer(HttpLimits limits, Handle handle, Log log)
    : server_(std::make_unique<Server>(limits, std::move(handle), std::move(log)))
{
}
HttpServer::~HttpServer() = default;

Result<int> HttpServer::bind(const std::string& address, int port)
{
    return server_->bind(address, port);
}

Status HttpServer::run(const Progress& progress)
{
    return server_->run(progress);
}

} // namespace tetra
