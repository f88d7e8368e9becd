// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/http_server.h"

#include "core/base/json_writer.h"
#include "core/base/system_error.h"
#include "core/base/text.h"
#include "core/serve/http_places.h"

#include <microhttpd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>

#include <netdb.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace tetra {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t pieceBytes = 65536;
constexpr std::chrono::milliseconds lookUpEvery{50};

bool isNameCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
}

using Headers = std::map<std::string, std::string>; ///< names in small letters

/// What libmicrohttpd calls, and what is a thread's work, must not throw: without memory for a request its connection
/// ends, and the others go on.
template <class Value, class Work> Value withoutMemory(Value otherwise, const Work& work) noexcept
try {
    return work();
} catch (const std::exception&) {
    return otherwise;
}

/// What libmicrohttpd found in a head, and whether each of it is what it should be: it reads more than the standard
/// allows.
struct HeaderList {
    Headers headers{};
    bool isWrong = false, isWhole = true;
    std::size_t count = 0;

    void add(std::string_view name, std::string_view value)
    {
        ++count;
        const auto isControl = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == 0x7f; };
        // No header may come twice: whoever stands between might take the other one.
        isWrong = isWrong || name.empty() || !std::ranges::all_of(name, isNameCharacter) ||
                  std::ranges::any_of(value, isControl) || !headers.emplace(smallLetters(name), value).second;
    }
};

/// Nothing without memory for them.
std::optional<HeaderList> headersOf(MHD_Connection* connection)
{
    HeaderList list;
    ::MHD_get_connection_values_n(
        connection, MHD_HEADER_KIND,
        [](void* to, MHD_ValueKind, const char* name, std::size_t nameSize, const char* value, std::size_t valueSize) {
            HeaderList& found = *static_cast<HeaderList*>(to);
            found.isWhole = withoutMemory(false, [&] {
                found.add({name, nameSize}, value == nullptr ? std::string_view() : std::string_view(value, valueSize));
                return true;
            });
            return found.isWhole ? MHD_YES : MHD_NO;
        },
        &list);
    return list.isWhole ? std::optional(std::move(list)) : std::nullopt;
}

/// The status that refuses a head, or 0.
int refusalOf(const HeaderList& list, std::string_view method, std::string_view target, std::string_view version,
              std::size_t headBytes, const HttpLimits& limits)
{
    if (method.empty() || !std::ranges::all_of(method, isNameCharacter))
        return 400;
    if (version != "HTTP/1.1" && version != "HTTP/1.0")
        return version.starts_with("HTTP/") && version.size() == 8 ? 505 : 400;
    if (method != "GET" && method != "HEAD" && method != "OPTIONS")
        return 405;
    const auto isPrintable = [](char c) { return c > ' ' && c < 0x7f; };
    if (!target.starts_with('/') || !std::ranges::all_of(target, isPrintable) ||
        target.find('#') != std::string_view::npos)
        return 400;
    if (target.size() > limits.headBytes / 2)
        return 414;
    if (list.count > limits.headers || headBytes > limits.headBytes)
        return 431;
    if (list.isWrong)
        return 400;
    const auto host = list.headers.find("host");
    if (host == list.headers.end() ? version == "HTTP/1.1"
                                   : host->second.empty() || !std::ranges::all_of(host->second, isPrintable))
        return 400;
    const auto length = list.headers.find("content-length");
    if (list.headers.contains("transfer-encoding") || (length != list.headers.end() && length->second != "0"))
        return 413;
    return 0;
}

/// What a client sent, for the log: at most as much as printable() takes, and of ASCII what shows as itself.
std::string shownText(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '?');
    return printable(text);
}

struct Peer {
    std::string address = "?", port = "?";
};
Peer peerOf(const sockaddr_storage& address, socklen_t size)
{
    std::array<char, NI_MAXHOST> host{};
    std::array<char, NI_MAXSERV> port{};
    if (::getnameinfo(reinterpret_cast<const sockaddr*>(&address), size, host.data(), host.size(), port.data(),
                      port.size(), NI_NUMERICHOST | NI_NUMERICSERV) != 0)
        return {};
    return {host.data(), port.data()};
}

/// An open descriptor, closed at the end.
class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept
    {
        std::swap(number_, other.number_);
        return *this;
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (number_ >= 0)
            ::close(number_);
    }
    int number() const noexcept { return number_; }
    int release() noexcept { return std::exchange(number_, -1); }

private:
    int number_;
};

/// A connection that was refused. Its client is left a moment to read that, since a socket that is closed with bytes
/// unread takes back what was sent.
struct Leaving {
    Descriptor socket;
    Clock::time_point until;
};

bool isStillLeaving(const Leaving& one)
{
    std::array<char, 4096> unread{};
    for (int pieces = 0; pieces < 16; ++pieces) {
        const ssize_t count = ::recv(one.socket.number(), unread.data(), unread.size(), MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR))
            return false;
        if (count < 0)
            break;
    }
    return Clock::now() < one.until;
}

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
    return textAnswer(status, "application/json", "{\"error\": " + jsonString(text) + "}\n");
}

class HttpServer::Server {
public:
    Server(HttpLimits limits, Handler handler, const Log& log)
        : limits_(limits), handler_(std::move(handler)), log_(log), places_(limits, log)
    {
    }

    Result<int> bind(const std::string& address, int port);
    Status run(const Progress& progress);

private:
    struct Request;

    Result<std::vector<MHD_Daemon*>> startDaemons();
    Status look(std::span<MHD_Daemon* const> daemons);
    void acceptAll(std::span<MHD_Daemon* const> daemons);
    void refuse(Descriptor socket, const std::string& peer);
    void endAll(std::span<MHD_Daemon* const> daemons);
    MHD_Result handle(MHD_Connection* connection, Request& request, std::string_view method, std::string_view version);
    MHD_Result check(MHD_Connection* connection, Request& request, std::string_view method, std::string_view version);
    MHD_Result answerSoon(MHD_Connection* connection, Request& request);
    MHD_Result send(MHD_Connection* connection, Request& request);
    MHD_Response* responseOf(Request& request);
    void complete(MHD_Connection* connection, Request& request, MHD_RequestTerminationCode how);
    void noteConnection(MHD_Connection* connection, void** context, MHD_ConnectionNotificationCode what);

    const HttpLimits limits_;
    const Handler handler_;
    const Log log_;
    HttpPlaces places_;
    Descriptor listening_;
    std::vector<Leaving> leaving_;
    std::mutex mutex_;                   ///< of what follows
    std::map<int, HttpPlace*> arriving_; ///< by their sockets, until libmicrohttpd tells of them
};

/// What belongs to a request, from its first line to the end of its answer.
struct HttpServer::Server::Request {
    Server& server;
    HttpPlace& place;
    std::string target;
    Clock::time_point begun = Clock::now();
    HttpRecord record{};
    bool isChecked = false, isBegun = false, isLast = false;
    Headers headers{};
    ServedRequest asked{};
    std::stop_source gone{};
    std::optional<ServedAnswer> answer{};
    std::uint64_t sent = 0;
    std::jthread worker{}; ///< while `answer` takes long
};

Result<int> HttpServer::Server::bind(const std::string& address, int port)
{
    const auto cannot = [&](const Message& why) {
        return Error{ErrorKind::WrongUsage,
                     Message::say("Cannot listen on port %1 of '%2': %3. Choose another port with '--port', or "
                                  "an address of this machine.",
                                  port, printable(address), why)};
    };
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    wanted.ai_flags = AI_PASSIVE;
    addrinfo* found = nullptr;
    if (::getaddrinfo(address.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0)
        return cannot(systemErrorText(EADDRNOTAVAIL));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> owner(found, &::freeaddrinfo);
    int problem = EADDRNOTAVAIL;
    for (const addrinfo* place = found; place != nullptr; place = place->ai_next) {
        Descriptor socket(
            ::socket(place->ai_family, place->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, place->ai_protocol));
        const int yes = 1;
        constexpr int backlog = 128;
        sockaddr_storage taken{};
        socklen_t size = sizeof taken;
        if (socket.number() < 0 || ::setsockopt(socket.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0 ||
            ::bind(socket.number(), place->ai_addr, place->ai_addrlen) != 0 ||
            ::listen(socket.number(), backlog) != 0 ||
            ::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&taken), &size) != 0) {
            problem = errno;
            continue;
        }
        listening_ = std::move(socket);
        return parseNumber<int>(peerOf(taken, size).port).value_or(port);
    }
    return cannot(systemErrorText(problem));
}

/// Loops of libmicrohttpd, a thread each: as many as are of use, or as the system gives.
Result<std::vector<MHD_Daemon*>> HttpServer::Server::startDaemons()
{
    constexpr unsigned most = 4, displaced = 256;
    const unsigned wanted = std::clamp(std::thread::hardware_concurrency(), 1U, most);
    const auto uriOf = [](void* server, const char* uri, MHD_Connection* connection) -> void* {
        const MHD_ConnectionInfo* const info =
            ::MHD_get_connection_info(connection, MHD_CONNECTION_INFO_SOCKET_CONTEXT);
        return withoutMemory<Request*>(nullptr, [&] {
            return new Request{*static_cast<Server*>(server), *static_cast<HttpPlace*>(info->socket_context), uri};
        });
    };
    const auto completed = [](void* server, MHD_Connection* connection, void** context,
                              MHD_RequestTerminationCode how) {
        const std::unique_ptr<Request> request(static_cast<Request*>(std::exchange(*context, nullptr)));
        if (request)
            withoutMemory(0, [&] {
                static_cast<Server*>(server)->complete(connection, *request, how);
                return 0;
            });
    };
    const auto notified = [](void* server, MHD_Connection* connection, void** context,
                             MHD_ConnectionNotificationCode what) {
        withoutMemory(0, [&] {
            static_cast<Server*>(server)->noteConnection(connection, context, what);
            return 0;
        });
    };
    const auto asked = [](void* server, MHD_Connection* connection, const char*, const char* method,
                          const char* version, const char*, std::size_t*, void** context) -> MHD_Result {
        return withoutMemory(MHD_NO, [&] {
            return *context == nullptr ? MHD_NO
                                       : static_cast<Server*>(server)->handle(
                                             connection, *static_cast<Request*>(*context), method, version);
        });
    };
    const auto unescape = [](void*, MHD_Connection*, char* text) { return std::strlen(text); };
    std::vector<MHD_Daemon*> daemons;
    int problem = 0;
    for (unsigned i = 0; i < wanted; ++i) {
        errno = 0;
        MHD_Daemon* const daemon = ::MHD_start_daemon(
            MHD_USE_EPOLL_INTERNAL_THREAD | MHD_USE_ITC | MHD_USE_NO_LISTEN_SOCKET | MHD_ALLOW_SUSPEND_RESUME, 0,
            nullptr, nullptr, static_cast<MHD_AccessHandlerCallback>(asked), this, MHD_OPTION_CONNECTION_LIMIT,
            static_cast<unsigned>(limits_.connections) + displaced, MHD_OPTION_CONNECTION_MEMORY_LIMIT,
            2 * limits_.headBytes, MHD_OPTION_STRICT_FOR_CLIENT, 1, MHD_OPTION_URI_LOG_CALLBACK,
            static_cast<void* (*)(void*, const char*, MHD_Connection*)>(uriOf), this, MHD_OPTION_UNESCAPE_CALLBACK,
            static_cast<std::size_t (*)(void*, MHD_Connection*, char*)>(unescape), nullptr, MHD_OPTION_NOTIFY_COMPLETED,
            static_cast<MHD_RequestCompletedCallback>(completed), this, MHD_OPTION_NOTIFY_CONNECTION,
            static_cast<MHD_NotifyConnectionCallback>(notified), this, MHD_OPTION_END);
        if (daemon == nullptr) {
            problem = errno == 0 ? EAGAIN : errno;
            break;
        }
        daemons.push_back(daemon);
    }
    if (daemons.empty())
        return Error{ErrorKind::OutOfResource, Message::say("The system cannot start a thread for the server: %1. %2",
                                                            systemErrorText(problem), resourceRemedy)};
    return daemons;
}

Status HttpServer::Server::run(const Progress& progress)
{
    const auto daemons = startDaemons();
    if (!daemons)
        return daemons.error();
    Status ended;
    // Without memory for one look the next one does what is left: the loops of libmicrohttpd use this object until
    // endAll() is over.
    while (ended.ok() && !progress.cancelled())
        ended = withoutMemory(Status(), [&] { return look(*daemons); });
    endAll(*daemons);
    return ended;
}

/// Waits a moment for connections, takes those that come, and ends what has taken too long.
Status HttpServer::Server::look(std::span<MHD_Daemon* const> daemons)
{
    pollfd place{.fd = listening_.number(), .events = POLLIN, .revents = 0};
    const int ready = ::poll(&place, 1, static_cast<int>(lookUpEvery.count()));
    if (ready < 0 && errno != EINTR)
        return Error{ErrorKind::OutOfResource, Message::say("The system accepts no more connections: %1. %2",
                                                            systemErrorText(errno), resourceRemedy)};
    if (ready > 0)
        acceptAll(daemons);
    places_.lookAfter();
    std::erase_if(leaving_, [](const Leaving& one) { return !isStillLeaving(one); });
    return {};
}

/// All that have come, but for what the next look at the others waits for.
void HttpServer::Server::acceptAll(std::span<MHD_Daemon* const> daemons)
{
    constexpr int most = 64;
    for (int i = 0; i < most; ++i) {
        sockaddr_storage address{};
        socklen_t size = sizeof address;
        Descriptor socket(
            ::accept4(listening_.number(), reinterpret_cast<sockaddr*>(&address), &size, SOCK_CLOEXEC | SOCK_NONBLOCK));
        if (socket.number() < 0) {
            if (errno != EAGAIN &&
                isLackOfResources(errno)) { // it stays in the queue until there is a descriptor for it
                leaving_.clear();
                places_.endOneThatWaits();
                std::this_thread::sleep_for(lookUpEvery);
            }
            return;
        }
        const Peer peer = peerOf(address, size);
        const std::string shown = peer.address + ":" + peer.port;
        HttpPlace* const place = places_.take(socket.number(), peer.address, shown);
        if (place == nullptr) {
            refuse(std::move(socket), shown);
            continue;
        }
        try {
            const std::lock_guard lock(mutex_);
            arriving_[socket.number()] = place;
        } catch (const std::bad_alloc&) {
            places_.leave(place);
            return;
        }
        const int number = socket.release();
        // It closes the socket also if it has no room for it.
        if (::MHD_add_connection(daemons[static_cast<std::size_t>(number) % daemons.size()], number,
                                 reinterpret_cast<sockaddr*>(&address), size) != MHD_YES) {
            const std::lock_guard lock(mutex_);
            if (const auto unknown = arriving_.find(number); unknown != arriving_.end()) {
                places_.leave(unknown->second);
                arriving_.erase(unknown);
            }
        }
    }
}

void HttpServer::Server::refuse(Descriptor socket, const std::string& peer)
{
    constexpr int full = 503;
    constexpr std::size_t mostLeaving = 64;
    constexpr std::chrono::milliseconds moment{500};
    sendRefusal(socket.number(), full);
    ::shutdown(socket.number(), SHUT_WR);
    HttpRecord record;
    record.peer = peer;
    record.status = full;
    log_(record);
    if (leaving_.size() < mostLeaving)
        leaving_.push_back({std::move(socket), Clock::now() + moment});
}

/// What is worked on finds that nobody waits for it. Only then may libmicrohttpd end: it must not do so while
/// connections are suspended.
void HttpServer::Server::endAll(std::span<MHD_Daemon* const> daemons)
{
    constexpr std::chrono::milliseconds aMoment{2};
    places_.endAll();
    while (places_.isAnswering())
        std::this_thread::sleep_for(aMoment);
    for (MHD_Daemon* const daemon : daemons)
        ::MHD_stop_daemon(daemon);
    leaving_.clear();
}

void HttpServer::Server::noteConnection(MHD_Connection* connection, void** context, MHD_ConnectionNotificationCode what)
{
    if (what == MHD_CONNECTION_NOTIFY_STARTED) {
        const int socket = ::MHD_get_connection_info(connection, MHD_CONNECTION_INFO_CONNECTION_FD)->connect_fd;
        const std::lock_guard lock(mutex_);
        const auto found = arriving_.find(socket);
        *context = found->second;
        arriving_.erase(found);
        return;
    }
    auto* const place = static_cast<HttpPlace*>(*context);
    const auto leave = [this](HttpPlace* gone) { places_.leave(gone); };
    const std::unique_ptr<HttpPlace, decltype(leave)> leaving(place, leave); // also without memory for the log
    if (places_.hasBegunHead(*place)) { // what has no first line that could be read, or not the whole of one
        HttpRecord record;
        record.peer = place->peer;
        record.status = 400;
        record.note = "unfinished";
        log_(record);
    }
}

MHD_Result HttpServer::Server::handle(MHD_Connection* connection, Request& request, std::string_view method,
                                      std::string_view version)
{
    if (request.answer)
        return send(connection, request); // the work on it is over
    if (!request.isChecked)
        return check(connection, request, method, version);
    if (request.isBegun)
        return MHD_NO; // there was no memory for an answer, nor to say so
    return answerSoon(connection, request);
}

/// The first look at a request, when its head has come whole.
MHD_Result HttpServer::Server::check(MHD_Connection* connection, Request& request, std::string_view method,
                                     std::string_view version)
{
    request.isChecked = true;
    std::optional<HeaderList> list = headersOf(connection);
    const std::size_t headBytes =
        ::MHD_get_connection_info(connection, MHD_CONNECTION_INFO_REQUEST_HEADER_SIZE)->header_size;
    request.record.peer = request.place.peer;
    request.record.request = shownText(std::string(method) + " " + request.target);
    if (!list || !places_.beginAnswer(request.place, request.gone))
        return MHD_NO;
    if (const int refused = refusalOf(*list, method, request.target, version, headBytes, limits_); refused != 0) {
        request.isLast = true;
        request.answer = errorAnswer(refused, reasonOf(refused));
        if (refused == 405)
            request.answer->headers.emplace_back("Allow", "GET, HEAD");
        return send(connection, request);
    }
    request.headers = std::move(list->headers);
    request.asked = {.method = method == "HEAD"  ? HttpMethod::Head
                               : method == "GET" ? HttpMethod::Get
                                                 : HttpMethod::Options,
                     .target = request.target,
                     .header = [&request](std::string_view name) -> std::optional<std::string> {
                         const auto found = request.headers.find(std::string(name));
                         return found == request.headers.end() ? std::nullopt : std::optional(found->second);
                     },
                     .gone = request.gone.get_token()};
    return MHD_YES;
}

/// Answers at once, or lets a thread of its own work on it.
MHD_Result HttpServer::Server::answerSoon(MHD_Connection* connection, Request& request)
{
    if (!handler_.takesLong(request.asked)) {
        request.answer = handler_.answer(request.asked);
        return send(connection, request);
    }
    using Answer = std::optional<ServedAnswer>;
    request.isBegun = true;
    ::MHD_suspend_connection(connection);
    try {
        request.worker = std::jthread([this, connection, &request] {
            request.answer = withoutMemory(Answer(), [&] { return Answer(handler_.answer(request.asked)); });
            ::MHD_resume_connection(connection);
        });
    } catch (const std::exception&) {
        request.answer = withoutMemory(Answer(), [] {
            ServedAnswer refused = errorAnswer(503, "The server has no thread for this answer now. Try again.");
            refused.headers.emplace_back("Retry-After", "1");
            return Answer(std::move(refused));
        });
        ::MHD_resume_connection(connection);
    }
    return MHD_YES;
}

/// What libmicrohttpd takes the body from: a small one whole, so that it goes with its head, others piece by piece.
MHD_Response* HttpServer::Server::responseOf(Request& request)
{
    const ServedAnswer& answer = *request.answer;
    const bool hasBody = answer.size > 0 && request.asked.method != HttpMethod::Head;
    if (!hasBody && answer.size == 0)
        return ::MHD_create_response_from_buffer(0, nullptr, MHD_RESPMEM_PERSISTENT);
    if (hasBody && answer.size <= pieceBytes) {
        auto* const bytes = static_cast<char*>(std::malloc(answer.size)); // libmicrohttpd frees it
        if (bytes == nullptr)
            return nullptr;
        if (!withoutMemory(false, [&] { return answer.read(0, {bytes, answer.size}); })) {
            std::free(bytes);
            return nullptr;
        }
        request.sent = answer.size;
        return ::MHD_create_response_from_buffer(answer.size, bytes, MHD_RESPMEM_MUST_FREE);
    }
    return ::MHD_create_response_from_callback(
        answer.size, pieceBytes,
        [](void* context, std::uint64_t offset, char* to, std::size_t most) -> ssize_t {
            Request& from = *static_cast<Request*>(context);
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(most, from.answer->size - offset));
            from.server.places_.tookPiece(from.place);
            if (!withoutMemory(false, [&] { return from.answer->read(offset, {to, count}); }))
                return MHD_CONTENT_READER_END_WITH_ERROR;
            from.sent = offset + count;
            return static_cast<ssize_t>(count);
        },
        &request, nullptr);
}

MHD_Result HttpServer::Server::send(MHD_Connection* connection, Request& request)
{
    const ServedAnswer& answer = *request.answer;
    request.record.status = answer.status;
    request.record.note = answer.note;
    places_.beginSending(request.place);
    MHD_Response* const response = responseOf(request);
    if (response == nullptr)
        return MHD_NO;
    for (const auto& [name, value] : answer.headers)
        ::MHD_add_response_header(response, name.c_str(), value.c_str());
    if (answer.size > 0 || answer.status < 300)
        ::MHD_add_response_header(response, MHD_HTTP_HEADER_CONTENT_TYPE, answer.type.c_str());
    if (request.isLast || request.place.answers >= limits_.requestsOfConnection)
        ::MHD_add_response_header(response, MHD_HTTP_HEADER_CONNECTION, "close");
    const MHD_Result queued = ::MHD_queue_response(connection, static_cast<unsigned>(answer.status), response);
    ::MHD_destroy_response(response);
    return queued;
}

void HttpServer::Server::complete(MHD_Connection* connection, Request& request, MHD_RequestTerminationCode how)
{
    const bool isTold = request.isChecked || !places_.isEnded(request.place); // one that was late was logged
    if (!request.isChecked) { // its head did not come whole, or libmicrohttpd refused it
        const MHD_ConnectionInfo* const info = ::MHD_get_connection_info(connection, MHD_CONNECTION_INFO_HTTP_STATUS);
        request.record.peer = request.place.peer;
        request.record.request = shownText(request.target);
        request.record.status = info != nullptr && info->http_status != 0 ? static_cast<int>(info->http_status) : 400;
    }
    request.record.bytes = request.sent;
    request.record.time = Clock::now() - request.begun;
    if (how != MHD_REQUEST_TERMINATED_COMPLETED_OK && request.record.note.empty())
        request.record.note = "unfinished";
    places_.beginWaiting(request.place);
    if (isTold)
        log_(request.record);
}

HttpServer::HttpServer(HttpLimits limits, Handler handler, Log log)
    : server_(std::make_unique<Server>(limits, std::move(handler), log))
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
