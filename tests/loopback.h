// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace tetra {

inline sockaddr_in loopback(std::uint16_t port)
{
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
}

/// Takes the connections to a free port of this machine and closes each when it is served. Ends with all of its
/// threads, so whoever serves looks at isStopped() often, and has this as the last of its members.
class LoopbackListener {
public:
    using Serve = std::function<void(int connection)>; ///< in a thread of its own

    explicit LoopbackListener(Serve serve) : serve_(std::move(serve)), listener_(::socket(AF_INET, SOCK_STREAM, 0))
    {
        sockaddr_in address = loopback(0);
        socklen_t size = sizeof address;
        isUp_ = ::bind(listener_, reinterpret_cast<sockaddr*>(&address), size) == 0 && ::listen(listener_, 128) == 0 &&
                ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size) == 0;
        port_ = ntohs(address.sin_port);
        acceptor_ = std::jthread([this] { acceptAll(); });
    }
    ~LoopbackListener()
    {
        isStopped_ = true;
        acceptor_ = {};
        connections_.clear();
        ::close(listener_);
    }
    LoopbackListener(const LoopbackListener&) = delete;
    LoopbackListener& operator=(const LoopbackListener&) = delete;

    bool isUp() const { return isUp_; }
    bool isStopped() const { return isStopped_; }
    std::uint16_t port() const { return port_; }

private:
    void acceptAll()
    {
        while (!isStopped_) {
            pollfd waiting{listener_, POLLIN, 0};
            if (::poll(&waiting, 1, 20) <= 0)
                continue;
            const int connection = ::accept(listener_, nullptr, nullptr);
            if (connection >= 0)
                connections_.emplace_back([this, connection] {
                    const int one = 1;
                    ::setsockopt(connection, IPPROTO_TCP, TCP_NODELAY, &one, sizeof one);
                    serve_(connection);
                    ::shutdown(connection, SHUT_RDWR);
                    ::close(connection);
                });
        }
    }

    Serve serve_;
    int listener_;
    bool isUp_ = false;
    std::uint16_t port_ = 0;
    std::atomic<bool> isStopped_ = false;
    std::vector<std::jthread> connections_; ///< of the acceptor, until that has ended
    std::jthread acceptor_;
};

} // namespace tetra
