// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/loopback.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace tetra {

/// A long way to an HTTP server of this machine: all bytes arrive after a delay, either way, and a connection costs a
/// round trip before the first. Counts what passes.
class DelayingProxy {
public:
    struct Counts {
        std::uint64_t connections = 0;
        std::uint64_t requests = 0;
        std::uint64_t roundTrips = 0; ///< requests that were sent after an answer to the last ones had begun to arrive
        std::uint64_t bytes = 0;      ///< of answers, heads and all
    };

    DelayingProxy(std::uint16_t serverPort, std::chrono::milliseconds delay) : serverPort_(serverPort), delay_(delay) {}

    bool isUp() const { return listener_.isUp(); }
    std::string address(const std::string& path) const
    {
        return "http://127.0.0.1:" + std::to_string(listener_.port()) + "/" + path;
    }
    Counts counts() const
    {
        const std::lock_guard lock(mutex_);
        return counts_;
    }
    void reset()
    {
        const std::lock_guard lock(mutex_);
        counts_ = {};
        isAnswered_ = true;
    }

private:
    using Clock = std::chrono::steady_clock;

    /// One way of a connection.
    struct Way {
        int from = -1, to = -1;
        std::deque<std::pair<Clock::time_point, std::string>> bytes{}; ///< when they arrive
        std::size_t size = 0;
        bool isOpen = true;
    };
    static constexpr std::size_t mostOnTheWay = 8 << 20;

    void serve(int client)
    {
        const int server = ::socket(AF_INET, SOCK_STREAM, 0), one = 1;
        ::setsockopt(server, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
        const sockaddr_in address = loopback(serverPort_);
        if (::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) {
            {
                const std::lock_guard lock(mutex_);
                ++counts_.connections;
            }
            std::array<Way, 2> ways = {Way{client, server}, Way{server, client}};
            const Clock::time_point connected = Clock::now() + 2 * delay_;
            while (!listener_.isStopped() && (ways[0].isOpen || !ways[0].bytes.empty()) &&
                   (ways[1].isOpen || !ways[1].bytes.empty()))
                pass(ways, connected);
        }
        ::close(server);
    }

    void pass(std::array<Way, 2>& ways, Clock::time_point connected)
    {
        std::array<pollfd, 2> ready{};
        auto next = std::chrono::milliseconds(20);
        for (std::size_t way = 0; way < 2; ++way) {
            const bool reads = ways[way].isOpen && ways[way].size < mostOnTheWay;
            ready[way] = {reads ? ways[way].from : -1, POLLIN, 0};
            if (!ways[way].bytes.empty())
                next = std::min(next, std::chrono::ceil<std::chrono::milliseconds>(
                                          std::max(ways[way].bytes.front().first - Clock::now(), Clock::duration())));
        }
        ::poll(ready.data(), ready.size(), static_cast<int>(next.count()));
        for (std::size_t number = 0; number < 2; ++number) {
            Way& way = ways[number];
            if (ready[number].revents != 0)
                take(way, number == 0, number == 0 ? std::max(connected, Clock::now()) : Clock::now());
            while (!way.bytes.empty() && way.bytes.front().first <= Clock::now()) {
                give(way, number == 1);
                way.bytes.pop_front();
            }
        }
    }

    void take(Way& way, bool isRequest, Clock::time_point sent)
    {
        char bytes[64 << 10];
        const ssize_t got = ::recv(way.from, bytes, sizeof bytes, 0);
        if (got <= 0) {
            way.isOpen = false;
            return;
        }
        way.bytes.emplace_back(sent + delay_, std::string(bytes, static_cast<std::size_t>(got)));
        way.size += static_cast<std::size_t>(got);
        if (isRequest && std::string_view(bytes, static_cast<std::size_t>(got)).starts_with("GET ")) {
            const std::lock_guard lock(mutex_);
            ++counts_.requests;
            counts_.roundTrips += isAnswered_ ? 1 : 0;
            isAnswered_ = false;
        }
    }

    void give(Way& way, bool isAnswer)
    {
        const std::string& bytes = way.bytes.front().second;
        way.size -= bytes.size();
        if (isAnswer) {
            const std::lock_guard lock(mutex_);
            counts_.bytes += bytes.size();
            isAnswered_ = true;
        }
        for (std::size_t sent = 0; sent < bytes.size();) {
            const ssize_t went = ::send(way.to, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
            if (went <= 0) {
                way.isOpen = false;
                return;
            }
            sent += static_cast<std::size_t>(went);
        }
    }

    const std::uint16_t serverPort_;
    const std::chrono::milliseconds delay_;
    mutable std::mutex mutex_;
    Counts counts_;
    bool isAnswered_ = true;
    LoopbackListener listener_{[this](int client) { serve(client); }};
};

} // namespace tetra
