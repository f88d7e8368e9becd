// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serve/http_places.h"

#include <algorithm>
#include <tuple>

#include <linux/tcp.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

namespace tetra {
namespace {

/// The bytes that have come on a connection, read or not.
std::uint64_t bytesReceived(int socket)
{
    tcp_info told{};
    socklen_t size = sizeof told;
    return ::getsockopt(socket, IPPROTO_TCP, TCP_INFO, &told, &size) == 0 ? told.tcpi_bytes_received : 0;
}

bool clientHasGone(int socket)
{
    pollfd place{.fd = socket, .events = POLLRDHUP, .revents = 0};
    return ::poll(&place, 1, 0) > 0 && (place.revents & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
}

} // namespace

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

void sendRefusal(int socket, int status)
{
    const std::string reason(reasonOf(status)), body = "{\"error\": \"" + reason + "\"}\n";
    const std::string text = "HTTP/1.1 " + std::to_string(status) + " " + reason +
                             (status == 503 ? "\r\nRetry-After: 1" : "") +
                             "\r\nContent-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) +
                             "\r\nConnection: close\r\n\r\n" + body;
    (void)::send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

HttpPlaces::HttpPlaces(const HttpLimits& limits, HttpServer::Log log) : limits_(limits), log_(std::move(log)) {}

/// With mutex_ held, as all that is private.
HttpPlace* HttpPlaces::mostDispensable(const std::string* ofAddress)
{
    // Who has just come may be about to ask; who has been silent for longer than a network takes is not.
    constexpr std::chrono::milliseconds aWhile{200};
    const auto now = HttpPlace::Clock::now();
    const auto rank = [&](const HttpPlace& one) {
        const auto ofItsAddress = std::ranges::count(places_, one.address, &HttpPlace::address);
        const bool hasBegun = one.headSince.has_value() || bytesReceived(one.socket) > one.receivedBefore;
        const bool isRecent = now - one.since < aWhile;
        const int worth = hasBegun ? 3 : one.answers == 0 ? (isRecent ? 2 : 0) : 1;
        return std::tuple(-ofItsAddress, worth, one.since);
    };
    HttpPlace* found = nullptr;
    for (HttpPlace& one : places_)
        if (one.phase == PlacePhase::Waiting && (ofAddress == nullptr || one.address == *ofAddress) &&
            (found == nullptr || rank(one) < rank(*found)))
            found = &one;
    return found;
}

void HttpPlaces::end(HttpPlace& place)
{
    place.phase = PlacePhase::Ended;
    place.gone.request_stop();
    ::shutdown(place.socket, SHUT_RDWR);
}

HttpPlace* HttpPlaces::take(int socket, std::string address, std::string peer)
{
    const std::lock_guard lock(mutex_);
    if (stopping_)
        return nullptr;
    // Those that were ended go in a moment, when libmicrohttpd finds out.
    const auto isThere = [](const HttpPlace& one) { return one.phase != PlacePhase::Ended; };
    const auto all = std::ranges::count_if(places_, isThere);
    const auto ofAddress =
        std::ranges::count_if(places_, [&](const HttpPlace& one) { return isThere(one) && one.address == address; });
    const bool addressIsFull = ofAddress >= limits_.connectionsOfAddress;
    if (addressIsFull || all >= limits_.connections) {
        HttpPlace* const goes = mostDispensable(addressIsFull ? &address : nullptr);
        if (goes == nullptr)
            return nullptr;
        end(*goes);
    }
    HttpPlace& place = places_.emplace_back();
    place.socket = socket;
    place.address = std::move(address);
    place.peer = std::move(peer);
    return &place;
}

void HttpPlaces::leave(HttpPlace* place)
{
    const std::lock_guard lock(mutex_);
    places_.remove_if([place](const HttpPlace& one) { return &one == place; });
}

bool HttpPlaces::beginAnswer(HttpPlace& place, const std::stop_source& gone)
{
    const std::lock_guard lock(mutex_);
    if (place.phase == PlacePhase::Ended)
        return false;
    place.phase = PlacePhase::Answering;
    place.gone = gone;
    return true;
}

void HttpPlaces::beginSending(HttpPlace& place)
{
    const std::lock_guard lock(mutex_);
    if (place.phase != PlacePhase::Ended)
        place.phase = PlacePhase::Sending;
    ++place.answers;
    place.since = HttpPlace::Clock::now();
    place.gone = std::stop_source(std::nostopstate);
}

void HttpPlaces::tookPiece(HttpPlace& place)
{
    const std::lock_guard lock(mutex_);
    place.since = HttpPlace::Clock::now();
}

void HttpPlaces::beginWaiting(HttpPlace& place)
{
    const std::lock_guard lock(mutex_);
    if (place.phase != PlacePhase::Ended)
        place.phase = PlacePhase::Waiting;
    place.since = HttpPlace::Clock::now();
    place.headSince.reset();
    place.receivedBefore = bytesReceived(place.socket);
    place.gone = std::stop_source(std::nostopstate);
}

bool HttpPlaces::hasBegunHead(const HttpPlace& place)
{
    const std::lock_guard lock(mutex_);
    constexpr std::uint64_t itsEnd = 1; // that a client closes its side counts as a byte
    return place.phase == PlacePhase::Waiting && bytesReceived(place.socket) > place.receivedBefore + itsEnd;
}

bool HttpPlaces::isEnded(const HttpPlace& place)
{
    const std::lock_guard lock(mutex_);
    return place.phase == PlacePhase::Ended;
}

/// One whose head does not come: silent, half or dripping.
void HttpPlaces::endLate(HttpPlace& place, HttpPlace::Clock::time_point now)
{
    if (!place.headSince && bytesReceived(place.socket) > place.receivedBefore)
        place.headSince = now;
    if (!place.headSince) {
        if (now - place.since > (place.answers == 0 ? limits_.idleTime : limits_.keptTime))
            end(place); // nobody has begun to ask: nothing to answer
        return;
    }
    if (now - *place.headSince <= limits_.headTime)
        return;
    constexpr int late = 408;
    sendRefusal(place.socket, late); // nothing else is being sent while it waits
    HttpRecord record;
    record.peer = place.peer;
    record.status = late;
    record.time = now - *place.headSince;
    end(place);
    log_(record);
}

void HttpPlaces::lookAfter()
{
    const std::lock_guard lock(mutex_);
    const auto now = HttpPlace::Clock::now();
    for (HttpPlace& place : places_) {
        if (place.phase == PlacePhase::Waiting)
            endLate(place, now);
        else if (place.phase == PlacePhase::Answering && clientHasGone(place.socket))
            place.gone.request_stop();
        else if (place.phase == PlacePhase::Sending && now - place.since > limits_.sendTime)
            end(place);
    }
}

void HttpPlaces::endOneThatWaits()
{
    const std::lock_guard lock(mutex_);
    if (HttpPlace* const goes = mostDispensable(nullptr))
        end(*goes);
}

void HttpPlaces::endAll()
{
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (HttpPlace& place : places_) {
        place.gone.request_stop();
        if (place.phase != PlacePhase::Answering)
            end(place); // an answer that is worked on is over in a moment, and finds its client gone
        else
            ::shutdown(place.socket, SHUT_RDWR);
    }
}

bool HttpPlaces::isAnswering()
{
    const std::lock_guard lock(mutex_);
    return std::ranges::any_of(places_, [](const HttpPlace& one) { return one.phase == PlacePhase::Answering; });
}

} // namespace tetra
