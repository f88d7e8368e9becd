// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/serve/http_server.h"

#include <chrono>
#include <cstdint>
#include <list>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

namespace tetra {

/// What a connection is at.
enum class PlacePhase {
    Waiting,   ///< for a request, or for the rest of one's head
    Answering, ///< an answer is worked on
    Sending,   ///< an answer is on its way
    Ended      ///< it was shut down here
};

/// A connection's place. Its members belong to HttpPlaces.
struct HttpPlace {
    using Clock = std::chrono::steady_clock;

    int socket = -1;
    std::string address; ///< the client's, without its port
    std::string peer;    ///< and with it
    PlacePhase phase = PlacePhase::Waiting;
    int answers = 0;                              ///< that it was given, with the one that is on its way
    Clock::time_point since = Clock::now();       ///< it waits, or its last piece was taken
    std::optional<Clock::time_point> headSince{}; ///< it has sent the beginning of a head
    std::uint64_t receivedBefore = 0;             ///< of its bytes, what belongs to requests before
    std::stop_source gone{std::nostopstate};      ///< of what is worked on
};

/// Who has a place at a server, and for how long: the limits on connections and their times. All connections that wait
/// for a request can be displaced by a new one, whether they were answered before, have not said anything yet or have
/// sent half a head, so that nobody shuts others out by waiting. Safe from any number of threads.
class HttpPlaces {
public:
    /// `log` is told of connections that are ended because their head came too late.
    HttpPlaces(const HttpLimits& limits, HttpServer::Log log);

    /// A place for a new connection. Where all are taken, or all that one address may have, one that waits is shut
    /// down: of the address that has most, one that was silent from the beginning, else one that is idle after an
    /// answer, else one that has just come, else one whose head is not complete; the longest wait first. Null if none
    /// waits.
    HttpPlace* take(int socket, std::string address, std::string peer);
    void leave(HttpPlace* place);

    /// A request of it has come and is worked on; `gone` is stopped when its client goes. False if it was ended.
    bool beginAnswer(HttpPlace& place, const std::stop_source& gone);
    void beginSending(HttpPlace& place);
    void tookPiece(HttpPlace& place);
    /// Its answer is over; it waits for the next request.
    void beginWaiting(HttpPlace& place);
    /// Whether a head of it has begun to come since.
    bool hasBegunHead(const HttpPlace& place);
    bool isEnded(const HttpPlace& place);

    /// Ends what has taken too long, and work whose client has gone. To be called every few hundredths of a second.
    void lookAfter();
    /// Ends one that waits, whose descriptor is needed.
    void endOneThatWaits();
    /// Ends all, also those that come.
    void endAll();
    bool isAnswering();

private:
    HttpPlace* mostDispensable(const std::string* ofAddress);
    void end(HttpPlace& place);
    void endLate(HttpPlace& place, HttpPlace::Clock::time_point now);

    const HttpLimits limits_;
    const HttpServer::Log log_;
    std::mutex mutex_; ///< of what follows
    std::list<HttpPlace> places_;
    bool stopping_ = false;
};

/// Sends a refusal that closes the connection, as much of it as goes at once.
void sendRefusal(int socket, int status);
/// What a status says, of those that refuse a request unread.
std::string_view reasonOf(int status);

} // namespace tetra
